"""Parts into which an h-set is divided."""

from __future__ import annotations

from collections.abc import Sequence

from nonsmooth.runtime.proof.chaos.h_sets import Box, HSet
from nonsmooth.runtime.proof.sets.affine_sets import AffineSet

__all__ = ["coordinates", "divisible", "most_stretched", "slices"]

_FINEST = 2.0**-20  # of an h-set: narrower parts are not tried


def divisible(box: Box) -> bool:
    """Whether a part may be divided."""
    return max(b - a for a, b in box) > _FINEST


def slices(box: Box, k: int, count: int = 2) -> list[Box]:
    """Even slices of a part across its coordinate k, the upper slice first.

    The count is a power of 2.
    """
    low, high = box[k]
    ends = [low + (high - low) * place / count for place in range(count + 1)]
    parts = [(ends[place], ends[place + 1]) for place in reversed(range(count))]
    return [(*box[:k], part, *box[k + 1 :]) for part in parts]


def most_stretched(h_set: HSet, box: Box, image: AffineSet | None) -> int:
    """The coordinate whose halving makes an image smallest; without an image the longest one."""
    if image is None:
        widths = [b - a for a, b in box]
        weights = [
            width * float(sum(abs(x) for x in column))
            for width, column in zip(widths, h_set.near[1].T, strict=True)
        ]
        return max(range(len(box)), key=weights.__getitem__)
    columns = image.columns.tolist()
    sizes = [float(sum(abs(row[1 + k]) for row in columns)) for k in range(len(box))]
    moving = [k for k, (a, b) in enumerate(box) if b - a > _FINEST]
    return max(moving or range(len(box)), key=sizes.__getitem__)


def coordinates(states: AffineSet, free: Sequence[int]) -> AffineSet:
    """The section's coordinates and 1 of a set of states, with their derivatives: d + 1 rows.

    `free` are the numbers of the states that are coordinates.
    """
    from flint import arb_mat

    def kept(matrix: arb_mat) -> arb_mat:
        rows = matrix.tolist()
        return arb_mat([*(rows[k] for k in free), rows[-1]])

    columns, rest = kept(states.columns), kept(states.rest)
    return AffineSet(columns, rest, tuple(coordinates(t, free) for t in states.tangents))

"""Which h-sets an h-set covers under a power of the section's map, proved in balls.

N covers M (Zgliczynski and Gidea 2004, theorem 16, for one unstable direction) if the map is
continuous on N, the image of N meets no side of M but the two unstable ones, that is, where its
unstable coordinate is within -1 and 1 the stable ones are so strictly, and the images of the two
unstable sides of N lie beyond opposite unstable sides of M. N is divided until that is proved of
the image of each part, and the sides by themselves.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

from nonsmooth.runtime.events.leading_derivative import Undecided
from nonsmooth.runtime.proof.chaos.h_sets import Box, HSet, piece
from nonsmooth.runtime.proof.chaos.parts import coordinates, divisible, most_stretched, slices
from nonsmooth.runtime.proof.sets.affine_sets import AffineSet
from nonsmooth.runtime.proof.sets.images import PassedTransition, SectionMap

__all__ = ["Coverings", "coverings"]


class Coverings(NamedTuple):
    """The h-sets that are proved to be covered by the image of one h-set."""

    targets: tuple[int, ...]  # numbers of the sets that it covers
    # the transitions on the way, the same for all its states
    passages: tuple[PassedTransition, ...]
    # corners of what contains the image of each part
    parts: tuple[tuple[tuple[float, ...], ...], ...]
    reason: str  # why other sets are not proved to be covered


def coverings(
    mapped: SectionMap,
    h_set: HSet,
    others: Sequence[HSet],
    wanted: Sequence[int],
    most: int,
    progress: Callable[[], object] = lambda: None,
) -> Coverings:
    """Prove which of the wanted h-sets another one covers, at the working precision.

    At most `most` images are computed, and `progress` is called for each.
    """
    size = len(h_set.centre)
    whole: Box = ((-1.0, 1.0),) * size
    work = _SetImages(mapped, h_set, others, most, progress)
    left: dict[int, str] = {}
    try:
        signs = {}
        for end in (-1.0, 1.0):
            signs[end] = work.beyond([((end, end), *whole[1:])], set(wanted) - left.keys(), left)
        for k in wanted:
            if k not in left and signs[-1.0][k] * signs[1.0][k] != -1:
                left[k] = "both unstable sides are mapped to one side of it"
        work.between([whole], {k for k in wanted if k not in left}, left)
    except Undecided as trouble:
        left = dict.fromkeys(wanted, trouble.reason)
    targets = tuple(k for k in wanted if k not in left)
    return Coverings(targets, work.passages or (), tuple(work.parts), next(iter(left.values()), ""))


class _SetImages:
    """The images of one h-set's parts."""

    def __init__(
        self,
        mapped: SectionMap,
        h_set: HSet,
        others: Sequence[HSet],
        most: int,
        progress: Callable[[], object],
    ) -> None:
        self.mapped, self.h_set, self.others = mapped, h_set, others
        self.left, self.progress = most, progress
        self.passages: tuple[PassedTransition, ...] | None = None
        self.parts: list[tuple[tuple[float, ...], ...]] = []

    def image(self, box: Box) -> AffineSet | None:
        """Coordinates of the image of a part; None if it has to be divided."""
        if not self.left:
            raise Undecided("there are too many parts", digits=False)
        self.left -= 1
        self.progress()
        try:
            found = self.mapped.image(piece(self.h_set, self.mapped.section, box))
        except Undecided:
            if not divisible(box):
                raise
            return None
        if self.passages not in (None, found.passages):
            raise Undecided("states of one set go through different transitions", digits=False)
        self.passages = found.passages
        return coordinates(found.states, self.mapped.section.free)

    def beyond(self, boxes: list[Box], wanted: set[int], left: dict[int, str]) -> dict[int, int]:
        """The side, 1 or -1, of each h-set beyond which the images of all boxes lie.

        For a set without such a side the reason is put in `left`.
        """
        signs: dict[int, int] = {}
        while boxes:
            box = boxes.pop()
            image = self.image(box)
            if image is not None:
                undecided = False
                for k in wanted - left.keys():
                    unstable = self.others[k].seen(image)[0]
                    sign = 1 if unstable > 1 else -1 if unstable < -1 else 0
                    if sign and signs.setdefault(k, sign) != sign:
                        left[k] = "an unstable side is mapped to both sides of it"
                    elif not sign and not divisible(box):
                        left[k] = "an unstable side is not mapped beyond it"
                    undecided |= not sign and k not in left
                if not undecided:
                    continue
            boxes += slices(box, most_stretched(self.h_set, box, image))
        return signs

    def between(self, boxes: list[Box], wanted: set[int], left: dict[int, str]) -> None:
        """Prove that the images of all boxes meet no stable side of the wanted h-sets.

        For a set of which that is not proved the reason is put in `left`.
        """
        while boxes and wanted - left.keys():
            box = boxes.pop()
            image = self.image(box)
            if image is not None:
                undecided = False
                for k in wanted - left.keys():
                    unstable, *stable = self.others[k].seen(image)
                    if unstable > 1 or unstable < -1 or all(abs(x) < 1 for x in stable):
                        continue
                    if not divisible(box):
                        left[k] = "the image comes to a stable side of it"
                    undecided |= k not in left
                if not undecided:
                    self.parts.append(_outline(image))
                    continue
            boxes += slices(box, most_stretched(self.h_set, box, image))


def _outline(image: AffineSet) -> tuple[tuple[float, ...], ...]:
    """Corners of what contains an image, for pictures; none of more than two coordinates."""
    columns = [[float(x.mid()) for x in row] for row in image.columns.tolist()[:-1]]
    spread = [float(x.rad()) for x in image.rest.entries()[:-1]]
    if len(columns) == 1:
        (own,) = columns
        reach = sum(map(abs, own[1:])) + spread[0]
        return ((own[0] - reach,), (own[0] + reach,))
    if len(columns) > 2:
        return ()
    centre, *sides = np.array(columns).T
    sides.sort(key=lambda side: -float(np.linalg.norm(side)))
    around = np.abs(sides[2:]).sum(axis=0) + np.array(spread)
    every = np.array([*sides[:2], [around[0], 0.0], [0.0, around[1]]])
    every[(every[:, 1] < 0) | ((every[:, 1] == 0) & (every[:, 0] < 0))] *= -1
    every = every[np.argsort(np.arctan2(every[:, 1], every[:, 0]))]
    steps = 2 * np.concatenate([np.zeros((1, 2)), every, -every[:-1]])
    corners = centre - every.sum(axis=0) + np.cumsum(steps, axis=0)
    return tuple((float(x), float(y)) for x, y in corners)

"""Products of many matrices of balls or Taylor models, without the growth of plain ones.

Along an orbit directions are stretched, turned and shrunk again. Products of balls grow with the
products of the absolute values, which may be a million times larger than those of the matrices.
Here each matrix is seen from a frame before it to a frame behind it, in which it is nearly upper
triangular (R. Lohner, Einschließung der Lösung gewöhnlicher Anfangs- und Randwertaufgaben, 1988):
what is multiplied then are the stretchings themselves.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from nonsmooth.runtime.core.taylor_models import middle_of, unit_matrix

if TYPE_CHECKING:
    from flint import arb_mat

__all__ = ["FramedPhases", "along_chain", "framed_phases"]

_SHORT = 6  # matrices whose plain product is as sharp


class FramedPhases(NamedTuple):
    """Phases of a chain, seen from a frame at the start and one at the end of each.

    A frame times what is seen from it is a state.
    """

    fields: list[Any]  # affine fields, in the frames of the ends
    rows: list[Any]  # rows of the boundaries, in the frames of the ends
    resets: list[Any]  # from the frame of each end to that of the next start
    flows: list[Any]  # from the frame of each start to that of the end
    # frames of the starts; the first one, and one behind the last phase, are the unit matrix
    starts: list[arb_mat]
    ends: list[arb_mat]  # frames of the ends


def framed_phases(
    fields: list[Any], rows: list[Any], resets: list[Any], flows: list[Any]
) -> FramedPhases:
    """Phases of a chain in frames in which flows and resets are nearly triangular.

    Fields, resets and flows are matrices (N + 1, N + 1) that act on (y, 1), rows are
    (1, N + 1). In a short chain all frames are unit matrices.
    """
    unit = unit_matrix(fields[0].nrows())
    if len(fields) <= _SHORT:
        same = [unit] * len(fields)
        return FramedPhases(fields, rows, resets, flows, [*same, unit], same)
    framed = FramedPhases([], [], [], [], [unit], [])
    for field, row, reset, flow in zip(fields, rows, resets, flows, strict=True):
        moved = flow * framed.starts[-1]
        end, back = _frame(moved, affine=True)
        behind = reset * end
        last = len(framed.starts) == len(fields)
        start, before = (unit, unit) if last else _frame(behind, affine=True)
        framed.fields.append(back * field * end)
        framed.rows.append(row * end)
        framed.resets.append(before * behind)
        framed.flows.append(back * moved)
        framed.starts.append(start)
        framed.ends.append(end)
    return framed


def along_chain(steps: Sequence[Callable[[Any], Any]], start: Any) -> Any:
    """Enclosure (N, n) of what a chain of linear maps makes of a matrix (N, n).

    Each step multiplies a matrix (N, k) from the left by a matrix (N, N) of balls or
    models. The first step acts on `start`.
    """
    if len(steps) <= _SHORT:
        for step in steps:
            start = step(start)
        return start
    frame, within = unit_matrix(start.nrows()), start
    for step in steps:
        moved = step(frame)
        frame, back = _frame(moved)
        within = (back * moved) * within
    return frame * within


def _frame(moved: Any, *, affine: bool = False) -> tuple[arb_mat, arb_mat]:
    """An exact, about orthogonal Q such that Q^-1 M is nearly triangular, and Q^-1.

    The inverse is of balls. Of an affine map M only the linear part is turned.
    """
    from flint import arb_mat

    middle = middle_of(moved)
    size = middle.nrows()
    numbers = [[float(middle[i, j]) for j in range(size)] for i in range(size)]
    if not all(math.isfinite(x) for row in numbers for x in row):
        return unit_matrix(size), unit_matrix(size)
    turned = np.eye(size)
    part = slice(size - affine)
    turned[part, part] = np.linalg.qr(np.array(numbers)[part, part]).Q
    found = arb_mat(turned.tolist())
    return found, found.inv()

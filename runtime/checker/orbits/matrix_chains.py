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

from nonsmooth.runtime.core.taylor_models import middle_of, unit_matrix

if TYPE_CHECKING:
    from flint import arb_mat

_SHORT = 6  # matrices whose plain product is as sharp
_FLAT = 2.0**-50  # of a column: less of it than that is roundings


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
    middle = middle_of(moved)
    size = middle.nrows()
    turned = size - affine
    columns = [[float(middle[i, j]) for i in range(turned)] for j in range(turned)]
    frame = unit_matrix(size)
    if not all(math.isfinite(x) for column in columns for x in column):
        return frame, frame
    for j, column in enumerate(_orthogonal(columns)):
        for i, x in enumerate(column):
            frame[i, j] = x
    return frame, frame.inv()


def _orthogonal(columns: list[list[float]]) -> list[list[float]]:
    """About orthogonal columns, which span the same up to each place.

    Where a column depends on those before it the unit vector that does so least is taken. Only
    operations are used whose results IEEE 754 fixes.
    """
    size = len(columns)
    units = [[float(i == k) for i in range(size)] for k in range(size)]
    found: list[list[float]] = []
    for column in columns:
        share, part = _apart(column, found)
        found.append(part if share > _FLAT else max(_apart(each, found) for each in units)[1])
    return found


def _apart(column: list[float], others: list[list[float]]) -> tuple[float, list[float]]:
    """About the share of a column that is orthogonal to unit vectors, and that part with size 1."""
    share, largest = 1.0, max(map(abs, column))
    part = [x / largest for x in column] if largest else column
    for turn in range(3):  # Gram and Schmidt's sums are taken twice: one leaves roundings
        for other in others if turn else ():
            along = math.fsum(x * y for x, y in zip(part, other, strict=True))
            part = [x - along * y for x, y in zip(part, other, strict=True)]
        size = math.sqrt(math.fsum(x * x for x in part))
        if not size:
            return 0.0, part
        share, part = share * size if turn else share, [x / size for x in part]
    return share, part

"""A fold curve on a tile of two parameters: where it is looked for, to be proved by the checker.

Where two orbits meet the equations are singular by the parameters. One parameter p is exchanged
for an unknown s of the orbit: over s and the other parameter q the orbits are a graph, p = P(s, q).
They meet where P_s is zero, which is found in numbers.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

from flint import arb, fmpq

from nonsmooth.runtime.checker.ranges.branch_curve import CheckedCurve, with_entry, without_entry
from nonsmooth.runtime.checker.ranges.divided import curve_at
from nonsmooth.runtime.checker.ranges.folded import Sheets
from nonsmooth.runtime.checker.ranges.tiles import CheckedBox
from nonsmooth.runtime.checker.stated.exact import Failure
from nonsmooth.runtime.core.jets import part_of
from nonsmooth.runtime.core.taylor_models import matrix, range_of
from nonsmooth.runtime.proof.boxes.tile_event import chebyshev_nodes, through_nodes

_NODES = 9  # places at which the fold is sought
_FARTHEST = 3.0  # of a fold from the middle of a tile; half of the tile is 1
_STEPS = 12
_SETTLED = 2.0**-24  # of the tile: how much a step before the last moves the fold
_WIDER = 1.08  # times the width at which a parabola leaves the tile


class _FoldPoint(NamedTuple):
    """A point at which two orbits meet, about."""

    point: list[Any]  # the orbit's unknowns and the parameter across
    bend: float  # twice the parameter's second derivative by the unknown


class FoldSearch:
    """The search for a fold on a tile, from the map's own orbit at a point of it.

    `point` has the values of both parameters, `numbers` the unknowns of the orbit's equations.
    """

    def __init__(
        self, box: CheckedBox, place: Sequence[Any], point: Sequence[fmpq], numbers: Sequence[arb]
    ) -> None:
        self.box, self.where, self.point = box, box.where(place), point
        self.numbers = [x.mid() for x in numbers]

    def proposal(self) -> Sheets:
        """Return a curve and a tube that both orbits leave; `Failure` if orbits do not meet."""
        axis, coordinate = self._coordinates()
        near = [*self.numbers, arb(self.point[axis])]
        first = self._meeting(axis, coordinate, self.point[1 - axis], near)
        coordinate = self._straightest(axis, coordinate, first)
        meetings = self._meetings(axis, coordinate, first)
        low, high = (float(x) for x in self.where[axis])
        turned, places, widths = meetings[0].bend > 0, [], []
        for point, bend in meetings:
            at = float(point[-1])
            if (bend > 0) != turned:
                raise Failure("orbits meet in opposite directions")
            places.append((2 * at - low - high) / (high - low))
            widths.append(math.sqrt(max(2 * (high - at if turned else at - low) / abs(bend), 0.0)))
        middle = through_nodes([float(meeting.point[coordinate]) for meeting in meetings])
        along, (left, right) = self.point[1 - axis], self.where[1 - axis]
        away = self.numbers[coordinate] - curve_at(
            middle, arb((2 * along - left - right) / (right - left))
        )
        guess = without_entry(coordinate, [float(x) for x in meetings[_NODES // 2].point])
        half, sheet = _WIDER * max(widths), "below" if away < 0 else "above"
        name = self.box.declared.unknowns[coordinate]
        return Sheets(axis, through_nodes(places), name, middle, half, sheet, guess)

    def _curve(self, axis: int, other: fmpq) -> CheckedCurve:
        """Return the orbits along one parameter, at a value of the other one."""
        box = self.box
        return CheckedCurve(
            box.declared, box.energies, box.constants, box.names[axis], (), axis, [arb(other)]
        )

    def _coordinates(self) -> tuple[int, int]:
        """Return the parameter that changes orbits most, and the unknown that changes most."""
        sizes = [abs(float(x)) for x in self.numbers]
        sizes = [max(x, max(sizes) / 20) for x in sizes]
        best = []
        for axis, (low, high) in enumerate(self.where):
            curve = self._curve(axis, self.point[1 - axis])
            jets = curve.jets(curve.last, [*self.numbers, arb(self.point[axis])], 1)
            for place, size in enumerate(sizes):
                change = abs(float(_derivative(jets[place], 1))) * float(high - low) / size
                best.append((change, axis, place))
        return max(best)[1:]

    def _straightest(self, axis: int, coordinate: int, at: _FoldPoint) -> int:
        """Return the unknown in which the parameter is most nearly a parabola.

        Its cubic term is least: with p = c2 e^2 + c3 e^3 and an unknown a1 e + a2 e^2 that is
        c3 - 2 c2 a2 / a1 in the unknown's units.
        """
        curve = self._curve(axis, self.point[1 - axis])
        *jets, across = curve.jets(coordinate, at.point, 3)
        square, cube = (float(_derivative(across, k)) for k in (2, 3))

        def cubic(k: int) -> float:
            first, second = (float(_derivative(jets[k], order)) for order in (1, 2))
            return abs(cube - 2 * square * second / first) if first else math.inf

        return min(range(len(jets)), key=cubic)

    def _meetings(self, axis: int, coordinate: int, first: _FoldPoint) -> list[_FoldPoint]:
        """Return points where orbits meet, at the other parameter's Chebyshev nodes."""
        low, high = self.where[1 - axis]
        nodes = [fmpq(*x.as_integer_ratio()) for x in chebyshev_nodes(_NODES)]
        middle = _NODES // 2
        found: dict[int, _FoldPoint] = {}
        for order in (range(middle, -1, -1), range(middle + 1, _NODES)):
            before = found.get(middle, first)
            for k in order:
                other = (low + high) / 2 + nodes[k] * (high - low) / 2
                found[k] = before = self._meeting(axis, coordinate, other, before.point)
        return [found[k] for k in range(_NODES)]

    def _meeting(self, axis: int, coordinate: int, other: fmpq, near: Sequence[Any]) -> _FoldPoint:
        """Return a point where P_s is zero, by Newton's method in s; `Failure` if it finds none."""
        curve = self._curve(axis, other)
        low, high = (float(x) for x in self.where[axis])
        point = [x.mid() for x in near]
        for _ in range(_STEPS):
            jets = curve.jets(coordinate, point, 2)
            values, slopes = curve.slopes(point)
            square = matrix([without_entry(coordinate, row) for row in slopes])
            try:
                change = square.mid().solve(matrix([[v] for v in values]).mid()).entries()
            except ZeroDivisionError:
                raise Failure("the equations are singular") from None
            slope, half = (_derivative(jets[-1], k) for k in (1, 2))
            if float(half) == 0:
                raise Failure("the parameter is not bent")
            step = slope / (2 * half)
            moved = abs(float(slope * step / 2)) + abs(float(change[-1]))
            pairs = zip(
                without_entry(coordinate, point),
                change,
                without_entry(coordinate, jets),
                strict=True,
            )
            others = [(x - d - _derivative(jet, 1) * step).mid() for x, d, jet in pairs]
            point = with_entry(coordinate, (point[coordinate] - step).mid(), others)
            if not abs(2 * float(point[-1]) - low - high) <= _FARTHEST * (high - low):
                break
            if moved <= _SETTLED * (high - low):
                return _FoldPoint(point, 2 * float(half))
        raise Failure("orbits do not meet near the tile")


def _derivative(jet: Any, order: int) -> Any:
    """Return about a derivative that a jet holds, divided by the factorial of its order."""
    return range_of(part_of(jet, order)).mid()

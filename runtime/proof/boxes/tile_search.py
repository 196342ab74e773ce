"""What may happen on a tile of two parameters, looked for in numbers, to be proved by the checker.

One event divides a tile into two sides by a curve. The search says which number is zero at it, and
where it is zero about: a polynomial of one of the parameters. The checker proves that there is one
event, in a band, and what is beside it.

Where two orbits meet, on a fold curve, the equations are singular by the parameters. One parameter
p is exchanged for an unknown s of the orbit: over s and the other parameter q the orbits are a
graph, p = P(s, q). They meet where P_s is zero.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from flint import arb, fmpq

from nonsmooth.runtime.checker.orbits.motion import Border, time_of_touch
from nonsmooth.runtime.checker.orbits.orbit import CheckedOrbit
from nonsmooth.runtime.checker.orbits.stability import characteristic, passing, passings
from nonsmooth.runtime.checker.ranges.branch_curve import CheckedCurve, with_entry, without_entry
from nonsmooth.runtime.checker.ranges.divided import DividingCurve, curve_at
from nonsmooth.runtime.checker.ranges.folded import Sheets
from nonsmooth.runtime.checker.ranges.tiles import CheckedBox
from nonsmooth.runtime.checker.stated.exact import Failure, demand
from nonsmooth.runtime.core.float_sets import Floats
from nonsmooth.runtime.core.jets import part_of
from nonsmooth.runtime.core.taylor_models import TaylorModel, matrix, middle_of, range_of
from nonsmooth.runtime.proof.asking import asking
from nonsmooth.runtime.proof.boxes.tile import TileEvent
from nonsmooth.runtime.proof.orbit_to_prove import NotCovered
from nonsmooth.runtime.proof.statement import rational_of

if TYPE_CHECKING:
    from nonsmooth.runtime.checker.ranges.tiles import MapTile
    from nonsmooth.runtime.proof.boxes.certify_box import BoxRefusals


_FARTHEST = 3.0  # of a curve or fold from the middle of a tile; half of the tile is 1
_STEPS = 12
_TIMES = 256  # of a phase, at which a function is looked at


def event_on(judge: BoxRefusals, tile: MapTile, orbit: CheckedOrbit) -> TileEvent | None:
    """The event that divides a judged tile of two parameters; None where the checker proves none.

    `orbit` is the tile's, in Taylor models.
    """
    try:
        proposed = _proposed(tile, orbit)
        if proposed is None:
            return None
        curve, window = proposed
        with asking():
            found = tile.divide(orbit, curve)
            judge.box.check_divisors()
    except (Failure, NotCovered):
        return None
    assert found.band is not None
    first = curve.borders[0] if curve.borders else None
    return TileEvent(
        kind=curve.kind,
        phase=first.phase if first else None,
        configuration=found.phases(orbit),
        boundary=first.boundary if first else "",
        instant=first.instant if first else "",
        window=window,
        also=tuple(border[:] for border in curve.borders[1:]),
        band=found.band,
        below=found.beside[0],
        above=found.beside[1],
        fold=None,
    )


def _proposed(
    tile: MapTile, orbit: CheckedOrbit
) -> tuple[DividingCurve, tuple[Fraction, ...]] | None:
    """The event that its verdicts leave open, its curve, about, and the window of a grazing.

    None if there is no such one.
    `Failure` as from what the checker knows of the orbit.
    """
    admissible, stable = (tile.verdicts[name] for name in ("admissibility", "stability"))
    borders: tuple[Border, ...] = ()
    window: tuple[Fraction, ...] = ()
    times: Any = None
    if (admissible.claim, stable.claim) == ("proved", "undecided"):
        kind = _open_kind(orbit)
        number = passing(characteristic(orbit.section), kind) if kind else None
    elif admissible.claim == "undecided" != stable.claim and None not in admissible.found:
        # a phase that vanishes ends where the one before it does
        borders = tuple(sorted(admissible.found, key=lambda b: b.kind != "vanishing-phase"))
        for border in borders:
            if border.kind == "grazing":
                window = touching_window(orbit, border)
        kind = borders[0].kind
        times = window_balls(window)
        time = time_of_touch(orbit, borders[0], times) if kind == "grazing" else None
        number = borders[0].number(orbit, time)
    else:
        return None
    if not isinstance(number, TaylorModel):
        return None
    rates = [abs(_coefficient(number, axis)) for axis in (0, 1)]
    axis = int(rates[1] > rates[0])
    centre = _curve(number, axis)
    if centre is None:
        return None
    return DividingCurve(kind, borders, times, axis, centre), window


def _open_kind(orbit: CheckedOrbit) -> str:
    """The one way to pass the unit circle that is not excluded; "" where it is none, or a fold."""
    if orbit.declared.stability == "neutral":
        return "flip"
    numbers = passings(characteristic(orbit.section))
    left = [kind for kind, x in numbers if not (x > 0 or x < 0)]
    return left[0] if len(left) == 1 and left != ["fold"] else ""


def touching_window(orbit: CheckedOrbit, border: Border) -> tuple[Fraction, Fraction]:
    """Return times about the highest maximum of a boundary function inside its phase.

    Each is half as far from it as the times at which the function ceases to be concave, in the
    middle of the parameters. `Failure` is raised if there is no maximum.
    """
    field, state = (middle_of(x[border.phase]) for x in (orbit.chain.fields, orbit.now.starts))
    time = middle_of(orbit.dwell[border.phase]) / _TIMES
    row = middle_of(orbit.numbers([border.watched(orbit).row]))
    step, rates = (field * time).exp().mid(), (row * field * field).mid()
    values, bends = [], []
    for _ in range(_TIMES + 1):
        values.append(float((row * state)[0, 0].mid()))
        bends.append(float((rates * state)[0, 0].mid()))
        state = (step * state).mid()
    inside = range(1, _TIMES)
    tops = [k for k in inside if bends[k] < 0 and values[k] == max(values[k - 1 : k + 2])]
    demand(tops, "no maximum inside of the phase is found")
    top = first = last = max(tops, key=lambda k: values[k])
    while first > 0 and bends[first] < 0:
        first -= 1
    while last < _TIMES and bends[last] < 0:
        last += 1
    begin, end = (Fraction(f"{float(time) * (top + k) / 2:.6g}") for k in (first, last))
    return begin, end


def window_balls(window: Sequence[Fraction]) -> Any:
    """Return the window of a grazing as balls, None without one."""
    return tuple(arb(rational_of(time)) for time in window) or None


def _coefficient(number: TaylorModel, axis: int) -> float:
    place = number.space.exponents.index(tuple(int(k == axis) for k in range(2)))
    part = number.parts[place]
    return 0.0 if part is None else float(part.mid())


def _curve(number: TaylorModel, axis: int) -> tuple[float, ...] | None:
    """Approximate zeros of a number, as a polynomial of the other parameter; None if far away."""
    order = number.space.order
    table = np.zeros((order + 1, order + 1))  # by powers along the axis, and of the other
    for part, exponents in zip(number.parts, number.space.exponents, strict=True):
        if part is not None:
            table[exponents[axis], exponents[1 - axis]] = float(part.mid())
    slopes = np.arange(1, order + 1)[:, None] * table[1:]
    nodes = chebyshev_nodes(order + 1)
    found = np.zeros_like(nodes)
    for _ in range(_STEPS):
        with np.errstate(all="ignore"):
            value = np.polynomial.polynomial.polyval2d(found, nodes, table)
            found = found - value / np.polynomial.polynomial.polyval2d(found, nodes, slopes)
        if not (np.isfinite(found).all() and abs(found).max() < _FARTHEST):
            return None
    return through_nodes(found)


def chebyshev_nodes(count: int) -> Floats:
    """Return so many Chebyshev nodes between -1 and 1."""
    return np.cos(np.pi * (np.arange(count) + 0.5) / count)


def through_nodes(values: Sequence[float] | Floats) -> tuple[float, ...]:
    """Return coefficients of the polynomial through values at as many Chebyshev nodes."""
    powers = np.vander(chebyshev_nodes(len(values)), increasing=True)
    return tuple(np.linalg.solve(powers, values).tolist())


_NODES = 9  # places at which the fold is sought
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
        low, high = map(float, self.where[axis])
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
        name = self.box.family.declared.unknowns[coordinate]
        return Sheets(axis, through_nodes(places), name, middle, half, sheet, guess)

    def _curve(self, axis: int, other: fmpq) -> CheckedCurve:
        """Return the orbits along one parameter, at a value of the other one."""
        return self.box.family.along(axis, [arb(other)])

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
        low, high = map(float, self.where[axis])
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

"""One event of a branch: a number along it that passes zero once, with a speed that is not zero."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING, Any, NamedTuple

from nonsmooth.runtime.core.jets import part_of
from nonsmooth.runtime.core.taylor_models import range_of
from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.proof.admissibility import OpenInequality
from nonsmooth.runtime.proof.branch.curve import OrbitCurve, directions
from nonsmooth.runtime.proof.branch.passage import CyclePassage, border, multiplier, time_of_touch
from nonsmooth.runtime.proof.branch.tube import Piece, orbit_at
from nonsmooth.runtime.proof.exact_tables import rational_of

if TYPE_CHECKING:
    from flint import arb

__all__ = ["SHARP", "EventCrossing", "crossing_of"]

SHARP = 192  # bits of the numbers at which an event is enclosed
_CLOSE = 112  # bits to which it is enclosed
_STEPS = 12

Which = OpenInequality | str


class EventCrossing(NamedTuple):
    """A place where the number of an event changes its sign."""

    which: Which  # the inequality, or "flip", "fold" (the branch turns) or "neimark-sacker"
    lower: Fraction  # lower bound of the coordinate at the event
    upper: Fraction  # upper bound of the coordinate at the event
    rises: bool  # negative below and positive above
    enclosures: list[arb]  # all coordinates of the orbit there
    # times between which the boundary function of a grazing (perhaps in `also`) is concave
    window: tuple[Any, Any] | None = None
    # inequalities that cease to hold between the bounds too; "fold" where the branch turns
    also: tuple[OpenInequality, ...] = ()


@dataclass(frozen=True, eq=False)
class _Number:
    """The number of an event along a piece: its zero is the event."""

    curve: OrbitCurve
    piece: Piece
    which: Which
    window: tuple[Any, Any] | None = None

    def at(self, point: Sequence[Any], order: int) -> Any | None:
        """The number at enclosed points, with its derivative if the order is 1; None if unknown."""
        curve, coordinate = self.curve, self.piece.tube.coordinate
        if self.which == "fold":
            found = directions(curve, coordinate, point, 1 + order)
            if found is None:
                return None
            slope = part_of(found[-1], 1)
            return slope if not order else (slope, 2 * part_of(found[-1], 2))
        time: Any = None
        if isinstance(self.which, OpenInequality) and self.which.kind == "grazing":
            assert self.window is not None
            time = time_of_touch(CyclePassage(curve.region, point), self.which, self.window)
            if time is None:
                return None
        jets: Sequence[Any] | None = point
        if order:
            jets = directions(curve, coordinate, point, 1)
        if jets is None:
            return None
        passage = CyclePassage(curve.region, jets)
        if isinstance(self.which, str):
            found = multiplier(passage, self.which)
        else:
            found = border(passage, self.which, time)
        return (part_of(found, 0), part_of(found, 1)) if order else found


def crossing_of(
    curve: OrbitCurve, piece: Piece, which: Which, window: tuple[Any, Any] | None = None
) -> EventCrossing | None:
    """Prove that a number passes zero exactly once in a piece of a branch, and where.

    Its derivative along the branch is nowhere zero, by jets in Taylor models; at two points
    that are near each other it has opposite signs. The window of a grazing is the pair of times
    between which the boundary function is concave. None where it is not proved.
    """
    from flint import arb

    number = _Number(curve, piece, which, window)
    tube = piece.tube
    with flint_precision(curve.region.bits):
        found = number.at(piece.point, 1)
        if found is None:
            return None
        value, slope = found
        rate = range_of(slope)
        if not (rate > 0 or rate < 0):
            return None
        ends = [value.at([arb(-1)]), value.at([arb(1)])]
        if ends[0] * ends[1] > 0:
            return None
    with flint_precision(SHARP):

        def at(place: arb) -> Any:
            orbit = orbit_at(curve, tube, place, SHARP)
            return None if orbit is None else number.at(orbit, 0)

        place = _root(at, tube.lower, tube.upper, rate)
        if place is None:
            return None
        width = tube.upper - tube.lower
        lower, upper = _around(place, width)
        if not tube.lower < lower < upper < tube.upper:
            return None
        signs = [at(arb(rational_of(end))) for end in (lower, upper)]
        if signs[0] is None or signs[1] is None:
            return None
        rises = bool(rate > 0)
        below, above = signs if rises else signs[::-1]
        if not (below < 0 and above > 0):
            return None
        middle, half = (lower + upper) / 2, (upper - lower) / 2
        around = arb(rational_of(middle)) + arb(0, arb(rational_of(half)))
        orbit = orbit_at(curve, tube, around, SHARP)
        if orbit is None:
            return None
        return EventCrossing(which, lower, upper, rises, orbit, window)


def _root(at: Callable[[arb], Any], lower: Fraction, upper: Fraction, rate: arb) -> Any:
    """A point near the root, by the secant method; nothing is proved of it."""
    from flint import arb

    low, high = arb(rational_of(lower)), arb(rational_of(upper))
    places: list[Any] = [((low + high) / 2).mid()]
    values: list[Any] = []
    slope = rate.mid()
    unit = (high - low) * arb(2) ** -(_CLOSE + 8)
    for _ in range(_STEPS):
        value = at(places[-1])
        if value is None:
            return None
        values.append(value.mid())
        if len(values) > 1 and places[-1] != places[-2] and values[-1] != values[-2]:
            slope = ((values[-1] - values[-2]) / (places[-1] - places[-2])).mid()
        step = (values[-1] / slope).mid()
        moved = (places[-1] - step).mid()
        if not (moved > low and moved < high):
            return None
        if abs(step) < unit:
            return moved
        places.append(moved)
    return None


def _around(place: arb, width: Fraction) -> tuple[Fraction, Fraction]:
    """Two decimals near to each other, with a place between them."""
    digits = 33
    while width * 10**digits < 10**33:
        digits += 1
    middle = Fraction(round(_fraction(place) * 10**digits), 10**digits)
    half = Fraction(1, 10 ** (digits - 1))
    return middle - half, middle + half


def _fraction(number: arb) -> Fraction:
    mantissa, exponent = (int(x) for x in number.mid().man_exp())
    return Fraction(mantissa) * Fraction(2) ** exponent

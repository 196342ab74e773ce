"""From tile to tile along a branch: by steps that fit what can be proved."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import TYPE_CHECKING

from nonsmooth.runtime.core.jets import part_of
from nonsmooth.runtime.core.taylor_models import range_of
from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.proof.branch.curve import OrbitCurve, directions
from nonsmooth.runtime.proof.branch.look import UNDECIDED, Look, look
from nonsmooth.runtime.proof.branch.tube import Piece, orbit_at, proved_piece
from nonsmooth.runtime.proof.exact_tables import rational_of

if TYPE_CHECKING:
    from flint import arb

JOINT = 128  # bits of the orbits at which tiles are joined

__all__ = ["JOINT", "BranchStep", "MarchPlace", "march"]

_FIRST = Fraction(1, 8)  # of the interval, or of the size of an unknown
_GROWTH, _SHRINK = Fraction(2), Fraction(1, 3)
_LEAST = Fraction(1, 2**45)  # of these: what stays undecided at an event
_STEEP, _FLAT = 30.0, 8.0  # relative rates at which the coordinate is changed, and changed back
_OVERLAP = Fraction(1, 1000)  # of a step, where the coordinate changes
_SHORT = 0.05  # of the mean dwell time: those by which the equations are divided


@dataclass(frozen=True, eq=False)
class MarchPlace:
    """A point that a march along a branch has reached."""

    coordinate: int  # number of the coordinate over which the branch is followed
    value: Fraction  # of that coordinate
    forwards: bool  # it increases along the march
    point: list[arb]  # all coordinates
    slopes: list[float]  # approximate derivatives of all coordinates by that one


@dataclass(frozen=True, eq=False)
class BranchStep:
    """One tile of a march."""

    coordinate: int  # number of the coordinate over which the tile is
    lower: Fraction
    upper: Fraction
    forwards: bool  # the coordinate increases along the march
    piece: Piece | None  # None unless existence is proved
    found: Look
    place: MarchPlace  # the point behind the tile
    divided: int | None = None  # phase, from 0, by whose dwell time its condition is divided


def march(
    curve: OrbitCurve, place: MarchPlace, refused: Callable[[BranchStep], str]
) -> Iterator[BranchStep]:
    """Yield the tiles along a branch up to the end of the parameter's interval.

    `refused` gives the reason why a tile cannot be stated, "" if it can; instead of a refused
    tile a smaller one is tried. The last tile ends at the interval's end or where a phase
    vanishes, or it has no piece: nothing is proved behind it.
    """
    low, high = curve.region.box[0]
    sizes = _sizes(curve, place.point)
    step = sizes[place.coordinate] * _FIRST
    left = Fraction(0)  # what was left undecided right behind: more is left with it
    while True:
        sizes = [max(pair) for pair in zip(sizes, _sizes(curve, place.point), strict=True)]
        turned = _turned(curve, place, sizes)
        if turned.coordinate != place.coordinate:
            rate = rational(abs(place.slopes[turned.coordinate]) or 1.0)
            step, left = step * rate, left * rate
        size = sizes[turned.coordinate]
        smallest = size * _LEAST
        least = max(smallest, left * _GROWTH)
        step = max(min(step, size * _FIRST), least)
        reason = ""
        while True:
            taken = _tried(curve, place, turned, step, (low, high))
            if not isinstance(taken, str) and taken.found.decided:
                reason = refused(taken)
                if reason:
                    taken = replace(taken, found=Look(UNDECIDED, UNDECIDED, reason))
            if not isinstance(taken, str) and not taken.found.decided and step <= least:
                taken = refused(taken) or taken
            if isinstance(taken, str):
                reason = taken
                if step <= smallest:
                    break
                step = max(step * _SHRINK, smallest)
            elif taken.found.decided or step <= least:
                break
            else:
                step = max(step * _SHRINK, least)
        if isinstance(taken, str):
            yield _gap(curve, place, turned, step, reason)
            return
        yield taken
        place = taken.place
        if place.coordinate == curve.parameter and place.value in (low, high):
            return
        if taken.found.ends:
            return
        width = taken.upper - taken.lower
        left = Fraction(0) if taken.found.decided else width
        step = width * _GROWTH


def rational(number: float) -> Fraction:
    """A nearby rational number with three digits."""
    return Fraction(f"{number:.3g}")


def _gap(
    curve: OrbitCurve, place: MarchPlace, turned: MarchPlace, step: Fraction, reason: str
) -> BranchStep:
    lower = place.value if place.forwards else place.value - step
    return BranchStep(
        place.coordinate, lower, lower + step, place.forwards, None,
        Look(UNDECIDED, UNDECIDED, reason), place,
    )  # fmt: skip


def _sizes(curve: OrbitCurve, point: Sequence[arb]) -> list[Fraction]:
    """Typical sizes of the coordinates, as units of steps and rates."""
    low, high = curve.region.box[0]
    about = [abs(float(x.mid())) for x in point[:-1]]
    largest = max(about)
    return [*(rational(max(x, largest / 20)) for x in about), high - low]


def _turned(curve: OrbitCurve, place: MarchPlace, sizes: Sequence[Fraction]) -> MarchPlace:
    """The same place over the coordinate that leads on best."""
    rates = [abs(slope) / float(size) for slope, size in zip(place.slopes, sizes, strict=True)]
    largest = max(rates[:-1])
    bound = _STEEP if place.coordinate == curve.parameter else _FLAT
    if largest <= bound * rates[-1]:
        wanted = curve.parameter
    else:
        wanted = max(range(len(rates) - 1), key=lambda k: rates[k])
        if place.coordinate != curve.parameter and rates[place.coordinate] * 2 > largest:
            wanted = place.coordinate
    if wanted == place.coordinate:
        return place
    slope = place.slopes[wanted]
    slopes = [x / slope for x in place.slopes]
    return replace(
        place,
        coordinate=wanted,
        value=_exact(place.point[wanted]),
        forwards=place.forwards == (slope > 0),
        slopes=slopes,
    )


def _exact(number: arb) -> Fraction:
    mantissa, exponent = (int(x) for x in number.mid().man_exp())
    return Fraction(mantissa) * Fraction(2) ** exponent


def _decimal(value: Fraction, step: Fraction) -> Fraction:
    """A decimal near a value, as short as a step allows."""
    digits = max(0, 3 - math.floor(math.log10(float(step))))
    return Fraction(round(value * 10**digits), 10**digits)


def _tried(
    curve: OrbitCurve,
    place: MarchPlace,
    turned: MarchPlace,
    step: Fraction,
    ends: tuple[Fraction, Fraction],
) -> BranchStep | str:
    """A tile of this width, or the reason why its orbits are not proved."""
    from flint import arb

    coordinate, sign = turned.coordinate, 1 if turned.forwards else -1
    curve, divided = _equations_for(curve, turned.point)
    begin = turned.value
    if coordinate != place.coordinate:
        if not _leads_on(curve, place, turned):
            return "where the branch leads is not known"
        begin = _decimal(begin - sign * step * _OVERLAP, step * _OVERLAP)
    end = _decimal(turned.value + sign * step, step)
    if coordinate == curve.parameter:
        low, high = ends
        end = max(low, min(high, end))
        begin = max(low, min(high, begin))
        # what is left behind it would be too little for a tile
        if min(end - low, high - end) < step / 8:
            end = low if sign < 0 else high
    if (end - begin) * sign <= 0:
        return "the step is too small"
    middle = (begin + end) / 2
    with flint_precision(curve.region.bits):
        away = float(middle - turned.value)
        guess = [
            x.mid() + arb(slope * away)
            for x, slope in zip(turned.point, turned.slopes, strict=True)
        ]
        known = turned.point[coordinate], curve.others(coordinate, turned.point)
    lower, upper = sorted((begin, end))
    piece = proved_piece(curve, coordinate, (lower, upper), curve.others(coordinate, guess), known)
    if isinstance(piece, str):
        return piece
    with flint_precision(curve.region.bits):
        first, last = (arb(rational_of(x)) for x in ends)
        over = range_of(piece.point[-1])
        if coordinate != curve.parameter and not (over > first and over < last):
            return "the branch leaves the interval"
    with flint_precision(JOINT):
        point = orbit_at(curve, piece.tube, arb(rational_of(end)), JOINT)
    if point is None:
        return "the orbit at its end is not enclosed"
    found = look(curve, piece)
    if found.event is not None and not _behind(turned.point[coordinate], found, sign):
        found = Look(UNDECIDED, UNDECIDED, "an event lies where two tiles overlap")
    slopes = piece.tube.slopes(float(sign))
    every = [*slopes[:coordinate], 1.0, *slopes[coordinate:]]
    behind = MarchPlace(coordinate, end, turned.forwards, point, every)
    return BranchStep(coordinate, lower, upper, turned.forwards, piece, found, behind, divided)


def _equations_for(curve: OrbitCurve, point: Sequence[arb]) -> tuple[OrbitCurve, int | None]:
    """The curve with equations that are regular where a short phase vanishes, and that phase.

    The phase is None where no phase is short.
    """
    times = point[curve.first_time : -1]
    mean = sum(abs(float(time.mid())) for time in times) / len(times)
    for place, divided in curve.divided.items():
        time = times[place]
        # where it is zero other solutions of the conditions may be
        if abs(float(time.mid())) < _SHORT * mean and (time > 0 or time < 0):
            return divided, place
    return curve, None


def _leads_on(curve: OrbitCurve, place: MarchPlace, turned: MarchPlace) -> bool:
    """Whether the new coordinate is proved to go in its direction where the branch goes on."""
    with flint_precision(JOINT):
        found = directions(curve, place.coordinate, place.point, 1)
        if found is None:
            return False
        slope = part_of(found[turned.coordinate], 1)
        return bool(slope > 0 if place.forwards == turned.forwards else slope < 0)


def _behind(begin: arb, found: Look, sign: int) -> bool:
    """Whether an event lies behind the point at which a tile was entered."""
    from flint import arb

    assert found.event is not None
    lower, upper = (arb(rational_of(x)) for x in (found.event.lower, found.event.upper))
    return bool(lower > begin) if sign > 0 else bool(upper < begin)

"""From tile to tile along a branch: by steps that fit what can be proved."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import partial

from flint import arb

from nonsmooth.runtime.checker.ranges.branch import ending
from nonsmooth.runtime.checker.ranges.branch_curve import CheckedCurve, without_entry
from nonsmooth.runtime.checker.ranges.branch_tile import SHARP, CheckedTile
from nonsmooth.runtime.checker.stated.exact import demand
from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.proof.branch.tiles import (
    JudgedTile,
    judged_tile,
    middle_fraction,
    proposed_tile,
)
from nonsmooth.runtime.proof.refusals import REFUSED, holds

__all__ = ["BranchStep", "MarchPlace", "march", "place_behind"]

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
    """One tile of a march, with how it ends; or no tile, and why nothing is proved further."""

    tile: JudgedTile | None
    end: str
    place: MarchPlace  # the point behind the tile


def march(
    curve: CheckedCurve, place: MarchPlace, *, onwards: bool, join: Callable[[CheckedTile], None]
) -> Iterator[BranchStep]:
    """Yield the tiles along a branch up to the end of the parameter's interval.

    The march leads `onwards` along the branch, or back. `join` raises `Failure` where a tile is
    not proved to go on from the one before it; instead of such a tile a smaller one is tried. The
    last tile ends at the interval's end or where a phase vanishes, or there is none: nothing is
    proved behind the one before.
    """
    sizes = _sizes(curve, place.point)
    step = sizes[place.coordinate] * _FIRST
    left = Fraction(0)  # what was left undecided right behind: more is left with it
    while True:
        sizes = [max(pair) for pair in zip(sizes, _sizes(curve, place.point), strict=True)]
        turned = _turned(curve, place, sizes)
        if turned.coordinate != place.coordinate:
            rate = _rational(abs(place.slopes[turned.coordinate]) or 1.0)
            step, left = step * rate, left * rate
        size = sizes[turned.coordinate]
        smallest = size * _LEAST
        least = max(smallest, left * _GROWTH)
        step = max(min(step, size * _FIRST), least)
        while True:
            try:
                tile = _tried(curve, place, turned, step, onwards=onwards)
                if tile.decided or step <= least:
                    join(tile.checked)
                    behind = place_behind(tile.checked, onwards=onwards)
                    break
                step = max(step * _SHRINK, least)
            except REFUSED as reason:
                if step <= smallest:
                    yield BranchStep(None, f"nothing is proved further: {reason}", place)
                    return
                step = max(step * _SHRINK, smallest)
        place = behind
        end = ending(tile.checked, last=onwards)
        yield BranchStep(tile, end, place)
        if end:
            return
        width = tile.stated.upper - tile.stated.lower
        left = Fraction(0) if tile.decided else width
        step = width * _GROWTH


def place_behind(tile: CheckedTile, *, onwards: bool) -> MarchPlace:
    """Return the point behind a tile, as seen from a march that leads onwards or back."""
    end = tile.end if onwards else tile.begin
    forwards = end == tile.high
    half, side = float(tile.high - tile.low) / 2, 1.0 if forwards else -1.0
    slopes = [
        sum(k * c * side ** (k - 1) for k, c in enumerate(row) if k) / half
        for row in tile.tile["centre"]
    ]
    slopes.insert(tile.place, 1.0)
    return MarchPlace(tile.place, _as_fraction(end), forwards, tile.at_end(end), slopes)


def _as_fraction(value: object) -> Fraction:
    """Return an exact number of the checker as a fraction."""
    return Fraction(str(value))


def _rational(number: float) -> Fraction:
    """Return a nearby rational number with three digits."""
    return Fraction(f"{number:.3g}")


def _sizes(curve: CheckedCurve, point: Sequence[arb]) -> list[Fraction]:
    """Return typical sizes of the coordinates, as units of steps and rates."""
    low, high = map(_as_fraction, curve.interval)
    about = [abs(float(x.mid())) for x in point[:-1]]
    largest = max(about)
    return [*(_rational(max(x, largest / 20)) for x in about), high - low]


def _turned(curve: CheckedCurve, place: MarchPlace, sizes: Sequence[Fraction]) -> MarchPlace:
    """Return the same place over the coordinate that leads on best."""
    rates = [abs(slope) / float(size) for slope, size in zip(place.slopes, sizes, strict=True)]
    largest = max(rates[:-1])
    bound = _STEEP if place.coordinate == curve.last else _FLAT
    if largest <= bound * rates[-1]:
        wanted = curve.last
    else:
        wanted = max(range(len(rates) - 1), key=lambda k: rates[k])
        if place.coordinate != curve.last and rates[place.coordinate] * 2 > largest:
            wanted = place.coordinate
    if wanted == place.coordinate:
        return place
    slope = place.slopes[wanted]
    return replace(
        place,
        coordinate=wanted,
        value=middle_fraction(place.point[wanted]),
        forwards=place.forwards == (slope > 0),
        slopes=[x / slope for x in place.slopes],
    )


def _decimal(value: Fraction, step: Fraction) -> Fraction:
    """Return a decimal near a value, as short as a step allows."""
    digits = max(0, 3 - math.floor(math.log10(float(step))))
    return Fraction(round(value * 10**digits), 10**digits)


def _tried(
    curve: CheckedCurve, place: MarchPlace, turned: MarchPlace, step: Fraction, *, onwards: bool
) -> JudgedTile:
    """Return a tile of this width; `Failure` says why its orbits are not proved."""
    coordinate, sign = turned.coordinate, 1 if turned.forwards else -1
    begin = turned.value
    if coordinate != place.coordinate:
        begin = _decimal(begin - sign * step * _OVERLAP, step * _OVERLAP)
    end = _decimal(turned.value + sign * step, step)
    if coordinate == curve.last:
        low, high = map(_as_fraction, curve.interval)
        end = max(low, min(high, end))
        begin = max(low, min(high, begin))
        # what is left behind it would be too little for a tile
        if min(end - low, high - end) < step / 8:
            end = low if sign < 0 else high
    demand((end - begin) * sign > 0, "the step is too small")
    with flint_precision(SHARP):
        away = float((begin + end) / 2 - turned.value)
        others = zip(*(without_entry(coordinate, each) for each in (turned.point, turned.slopes)),
                     strict=True)  # fmt: skip
        guess = [x.mid() + arb(slope * away) for x, slope in others]
    lower, upper = sorted((begin, end))
    tile = proposed_tile(
        curve, coordinate, (lower, upper), guess,
        forwards=turned.forwards == onwards, divided=_short_phase(curve, turned.point),
    )  # fmt: skip
    with flint_precision(SHARP):
        entered = without_entry(coordinate, turned.point)
        holds = tile.checked.holds(turned.point[coordinate], entered)
        demand(holds, "another orbit may have been found")
    return judged_tile(tile)


def _short_phase(curve: CheckedCurve, point: Sequence[arb]) -> int | None:
    """Return the short phase by whose dwell time equations can be divided, or None.

    They are regular where the phase vanishes. Phases are counted from 0.
    """
    times = point[curve.last - len(curve.declared.dwell) : -1]
    mean = sum(abs(float(time.mid())) for time in times) / len(times)
    for place, time in enumerate(times):
        # where it is zero other solutions of the conditions may be
        short = abs(float(time.mid())) < _SHORT * mean and (time > 0 or time < 0)
        if short and holds(partial(curve.divided, place + 1)):
            return place
    return None

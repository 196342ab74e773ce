"""What begins where a branch meets a border: the other itineraries, their side and verdict.

Each that floating point finds is proved in one tile that holds the border: over the parameter, or
over the dwell time of a phase that vanishes there, by which its equations are regular where the
parameter turns. It begins at the branch's event, if both events are one motion. The scenarios are
those of M. di Bernardo, C. Budd, A. Champneys and P. Kowalczyk, Piecewise-smooth Dynamical Systems
(2008), sections 3.1 and 8: persistence, and nonsmooth folds.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from fractions import Fraction
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.jets import part_of
from nonsmooth.runtime.core.taylor_models import range_of, space_of
from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.explore.continuation.branch import Branch
from nonsmooth.runtime.explore.continuation.event import Event
from nonsmooth.runtime.explore.continuation.next_itineraries import (
    canonical_itinerary,
    orbits_beside,
)
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.proof.admissibility import OpenInequality
from nonsmooth.runtime.proof.boxes.orbit_over_box import BITS, region_of
from nonsmooth.runtime.proof.branch.certified_branch import BranchTile, OrbitBeyond
from nonsmooth.runtime.proof.branch.crossing import SHARP
from nonsmooth.runtime.proof.branch.curve import OrbitCurve, directions
from nonsmooth.runtime.proof.branch.look import NOT_ADMISSIBLE, UNDECIDED, look
from nonsmooth.runtime.proof.branch.passage import MULTIPLIERS
from nonsmooth.runtime.proof.branch.same_motion import MetBorder, is_same_motion
from nonsmooth.runtime.proof.branch.stating import stated_branch, stated_tile
from nonsmooth.runtime.proof.branch.tube import ORDER, BranchTube, Piece, proved_piece
from nonsmooth.runtime.proof.exact_tables import rational_of
from nonsmooth.runtime.proof.orbit_to_prove import NotCovered

if TYPE_CHECKING:
    from flint import arb

__all__ = ["with_beyond"]

_TRIES = 8
_LARGER = 16  # times the orbit's distance: what is tried first by the parameter
_WIDE = 1e-4  # of the interval: the first tile at least
_SMALLER = 4  # times, from try to try
_BACK = 32  # share of a tile over a dwell time that lies behind its border
_NEAR = 1e-4  # of the interval: where floating point has the same event
_SHORT = 0.1  # of the period: what may vanish


def with_beyond(
    curve: OrbitCurve, tile: BranchTile, branch: Branch, opened: Mapping[str, Any]
) -> BranchTile:
    """A tile with the proved orbits of other itineraries that begin at its event.

    `branch` is the same branch in floating point, `opened` has the parameters that the orbit
    leaves open. The tile comes back unchanged if its event is no border, or nothing is proved.
    """
    event = tile.event
    if event is None or event.kind in MULTIPLIERS or event.beyond:
        return tile
    value = float(event.enclosures[branch.parameter])
    other = _in_floating_point(branch, event.kind, event.phase, value)
    if other is None:
        return tile
    own_curve = curve if tile.divided is None else curve.divided[tile.divided]
    piece = _piece_of(own_curve, tile)
    own = _met(own_curve, tile, piece.tube)
    side = _side(own_curve, tile, piece)
    if not side:
        return tile
    found: dict[Any, OrbitBeyond] = {}
    for orbit in _candidates(branch, other, opened):
        name = canonical_itinerary(orbit.itinerary)
        proved = None if name in found else _proved(orbit, curve, own, value)
        if proved is not None:
            found[name] = replace(proved, own=side)
    return replace(tile, event=replace(event, beyond=tuple(found.values())))


def _in_floating_point(branch: Branch, kind: str, phase: int | None, value: float) -> Event | None:
    """The border collision near a value, of this kind and phase if there is one; else None."""
    width = float(np.ptp(branch.parameter_values)) or 1.0
    near = [
        event
        for event in branch.events
        if event.border_collision and abs(event.value - value) < _NEAR * width
    ]
    near.sort(key=lambda event: event.kind != kind or event.phase != phase)
    return near[0] if near else None


def _candidates(branch: Branch, event: Event, opened: Mapping[str, Any]) -> Iterator[Orbit]:
    """Orbits of other itineraries near a border, in floating point."""
    for looked_for in (branch.next_itineraries, partial(orbits_beside, branch)):
        try:
            yield from looked_for(event, opened)
        except InputError:  # none
            continue


def _piece_of(curve: OrbitCurve, tile: BranchTile) -> Piece:
    """The piece of a proved tile, with enclosures of its orbits."""
    from flint import arb

    coordinate = curve.parameter
    if tile.coordinate != curve.names[coordinate]:
        coordinate = curve.names.index(tile.coordinate)
    tube = BranchTube(coordinate, tile.lower, tile.upper, tile.centre, tile.radii)
    space = space_of(1, ORDER)
    with flint_precision(BITS):
        radii = zip(tube.models(space), tile.radii, strict=True)
        others = [model + arb(0, radius) for model, radius in radii]
        return Piece(tube, curve.point(coordinate, tube.value(space), others))


def _met(curve: OrbitCurve, tile: BranchTile, tube: BranchTube) -> MetBorder:
    """The border that a branch meets in a tile."""
    from flint import arb

    event = tile.event
    assert event is not None
    assert event.phase is not None
    first = OpenInequality(event.kind, event.phase, event.boundary, event.instant)
    with flint_precision(SHARP):
        return MetBorder(
            region=curve.region,
            tube=tube,
            borders=(first, *(OpenInequality(*each) for each in event.also)),
            window=tuple(arb(rational_of(time)) for time in event.window),
            point=[event.enclosures[name].ball for name in curve.names],
        )


def _side(curve: OrbitCurve, tile: BranchTile, piece: Piece) -> str:
    """The side of its event's parameter on which a tile's orbits are motions; "" if unknown."""
    begins = tile.before == NOT_ADMISSIBLE
    if tile.before == tile.after or not (begins or tile.after == NOT_ADMISSIBLE):
        return ""
    sign = 1 if begins == tile.forwards else -1
    coordinate = piece.tube.coordinate
    if coordinate != curve.parameter:
        assert tile.event is not None
        turns = any(kind == "fold" for kind, *_ in tile.event.also)
        with flint_precision(BITS):
            found = directions(curve, coordinate, piece.point, 2 if turns else 1)
            if found is None:
                return ""
            rate = range_of(part_of(found[-1], 2 if turns else 1))
        if not (rate > 0 or rate < 0):
            return ""
        sign = (1 if turns else sign) * (1 if rate > 0 else -1)
    return "above" if sign > 0 else "below"


def _proved(orbit: Orbit, own: OrbitCurve, met: MetBorder, value: float) -> OrbitBeyond | None:
    """Orbits of another itinerary that begin at a border; None if that is not proved."""
    region = own.region
    box = {region.names[0]: region.box[0]}
    try:
        curve = OrbitCurve(region_of(orbit, box))
    except (NotCovered, InputError):
        return None
    branch = stated_branch(orbit, box, (), curve)
    for place, coordinate, lower, upper in _tried(curve, value):
        by = curve if place is None else curve.divided[place]
        with flint_precision(BITS):
            guess = _guess(by, coordinate, (lower + upper) / 2, value)
            piece = proved_piece(by, coordinate, (lower, upper), by.others(coordinate, guess), None)
            if isinstance(piece, str) or not _inside(by, piece):
                continue
        found = look(by, piece)
        if found.event is None or isinstance(found.event.which, str) or not found.decided:
            continue
        tile = stated_tile(by, piece.tube, found, place, forwards=True)
        with flint_precision(SHARP):
            other = _met(by, tile, piece.tube)
            same = is_same_motion(*sorted([met, other], key=lambda each: (each.free, -each.count)))
        side = _side(by, tile, piece) if same else ""
        if side:
            verdict = tile.after if tile.before == NOT_ADMISSIBLE else tile.before
            assert verdict != UNDECIDED
            return OrbitBeyond(
                side=side, own="", verdict=verdict, branch=replace(branch, tiles=(tile,))
            )
    return None


def _tried(curve: OrbitCurve, value: float) -> Iterator[tuple[int | None, int, Fraction, Fraction]]:
    """Ever smaller tiles about a border, each over the parameter or over a short dwell time.

    Each is the divided phase or None, the number of the coordinate, and its lower and upper end.
    """
    region = curve.region
    low, high = map(float, region.box[0])
    away = max(abs(float(region.at[0]) - value), _WIDE * (high - low))
    times = [float(x.mid()) for x in region.guess[curve.first_time :]]
    for step in range(_TRIES):
        share = _SMALLER**-step
        half = Fraction(f"{away * _LARGER * share / 2:.2g}")
        middle = _decimal(value, half)
        lower, upper = max(region.box[0][0], middle - half), min(region.box[0][1], middle + half)
        yield None, curve.parameter, lower, upper
        for place in curve.divided:
            if times[place] < _SHORT * sum(times):
                upper = Fraction(f"{times[place] * share / 2:.2g}")
                yield place, curve.first_time + place, -upper / _BACK, upper


def _decimal(value: float, unit: Fraction) -> Fraction:
    """A short decimal near a value."""
    step = unit / 16
    return round(Fraction(value) / step) * step


def _guess(curve: OrbitCurve, coordinate: int, middle: Fraction, value: float) -> list[arb]:
    """Approximate coordinates of the orbit in the middle of a tile."""
    from flint import arb

    found = [x.mid() for x in curve.region.guess]
    found.append(arb(value))
    found[coordinate] = arb(rational_of(middle))
    return found


def _inside(curve: OrbitCurve, piece: Piece) -> bool:
    """Whether the parameter stays inside of the interval."""
    from flint import arb

    low, high = (arb(rational_of(end)) for end in curve.region.box[0])
    over = range_of(piece.point[-1])
    parameter = piece.tube.coordinate == curve.parameter
    return parameter or bool(over > low and over < high)

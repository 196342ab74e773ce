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
from typing import Any

import numpy as np
from flint import arb

from nonsmooth.runtime.checker.ranges.beyond import found_beyond
from nonsmooth.runtime.checker.ranges.branch_curve import CheckedCurve, without_entry
from nonsmooth.runtime.checker.ranges.branch_tile import BITS, CheckedTile
from nonsmooth.runtime.checker.stated.parameters import independent
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.explore.continuation.branch import Branch
from nonsmooth.runtime.explore.continuation.event import Event
from nonsmooth.runtime.explore.continuation.next_orbits import orbits_beside
from nonsmooth.runtime.explore.finding.solved import canonical_itinerary
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.proof.boxes.orbit_over_box import Region, region_of
from nonsmooth.runtime.proof.branch.certified_branch import BranchTile, OrbitBeyond
from nonsmooth.runtime.proof.branch.tiles import (
    checked_curve,
    checked_tile,
    judged_tile,
    precision_of,
    proposed_tile,
    stated_branch,
)
from nonsmooth.runtime.proof.orbit_to_prove import NotCovered
from nonsmooth.runtime.proof.refusals import REFUSED, holds

_TRIES = 8
_LARGER = 16  # times the orbit's distance: what is tried first by the parameter
_WIDE = 1e-4  # of the interval: the first tile at least
_SMALLER = 4  # times, from try to try
_BACK = 32  # share of a tile over a dwell time that lies behind its border
_NEAR = 1e-4  # of the interval: where floating point has the same event
_SHORT = 0.1  # of the period: what may vanish


class BordersOfBranch:
    """The borders that a branch meets, and what begins there.

    `content` and `curve` are the branch as the checker knows it, `branch` is the same one in
    floating point, and `orbit` the one from which it is followed.
    """

    def __init__(
        self, content: dict[str, Any], curve: CheckedCurve, branch: Branch, orbit: Orbit
    ) -> None:
        self.content, self.curve, self.branch, self.opened = content, curve, branch, orbit.opened

    def with_beyond(self, tile: BranchTile) -> BranchTile:
        """Return a tile with the proved orbits of other itineraries that begin at its event.

        The tile comes back unchanged if its event is no border, or nothing is proved.
        """
        event = tile.event
        if event is None or event.phase is None or event.beyond:
            return tile
        value = float(event.enclosures[self.branch.parameter])
        other = _in_floating_point(self.branch, event.kind, event.phase, value)
        if other is None:
            return tile
        checked = checked_tile(self.curve, tile)
        with flint_precision(precision_of(self.curve, tile.lower, tile.upper)):
            checked.locate()
        found: dict[Any, OrbitBeyond] = {}
        for orbit in _candidates(self.branch, other, self.opened):
            name = canonical_itinerary(orbit.itinerary)
            proved = None if name in found else self._proved(orbit, checked, value)
            if proved is not None:
                found[name] = proved
        return replace(tile, event=replace(event, beyond=tuple(found.values())))

    def _proved(self, orbit: Orbit, met: CheckedTile, value: float) -> OrbitBeyond | None:
        """Return orbits of another itinerary that begin at a border; None if that is not proved."""
        lower, upper = (Fraction(str(end)) for end in self.curve.interval)
        box = {self.branch.parameter: (lower, upper)}
        try:
            region = region_of(orbit, box)
            branch = stated_branch(orbit, box, (), region)
            content, curve = checked_curve(branch)
        except (NotCovered, InputError):
            return None
        for divided, place, *ends in _tried(region, curve, value):
            try:
                guess = without_entry(place, [*(x.mid() for x in region.guess), arb(value)])
                tile = judged_tile(
                    proposed_tile(
                        curve, place, (ends[0], ends[1]), guess, forwards=True, divided=divided
                    )
                )
                with flint_precision(BITS):
                    independent(curve.declared, curve.constants, [curve.interval])
                found = found_beyond(self.content, met, content, tile.checked)
            except REFUSED:
                continue
            return OrbitBeyond(**found._asdict(), branch=replace(branch, tiles=(tile.stated,)))
        return None


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


def _tried(
    region: Region, curve: CheckedCurve, value: float
) -> Iterator[tuple[int | None, int, Fraction, Fraction]]:
    """Yield ever smaller tiles about a border, each over the parameter or a short dwell time.

    Each is the divided phase or None, the number of the coordinate, and its lower and upper end.
    """
    (box,), first = region.box, curve.last - len(curve.declared.dwell)
    away = max(abs(float(region.at[0]) - value), _WIDE * float(box[1] - box[0]))
    times = [float(x.mid()) for x in region.guess[first:]]
    short = [
        place
        for place, time in enumerate(times)
        if time < _SHORT * sum(times) and holds(partial(curve.divided, place + 1))
    ]
    for step in range(_TRIES):
        share = _SMALLER**-step
        half = Fraction(f"{away * _LARGER * share / 2:.2g}")
        middle = _decimal(value, half)
        yield None, curve.last, max(box[0], middle - half), min(box[1], middle + half)
        for place in short:
            upper = Fraction(f"{times[place] * share / 2:.2g}")
            yield place, first + place, -upper / _BACK, upper


def _decimal(value: float, unit: Fraction) -> Fraction:
    """Return a short decimal near a value."""
    step = unit / 16
    return round(Fraction(value) / step) * step

"""Certify what is beyond flips: the side and verdict of the doubled orbits, flip after flip."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from nonsmooth.runtime.core.errors import InputError, Interrupted
from nonsmooth.runtime.core.taylor_models import range_of
from nonsmooth.runtime.core.values import as_value, flint_precision
from nonsmooth.runtime.explore.continuation.branch import Branch
from nonsmooth.runtime.explore.continuation.composed_family import composed_family
from nonsmooth.runtime.explore.continuation.continue_orbit import continue_orbit
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.orbits.table_solve import solve_itinerary
from nonsmooth.runtime.proof.boxes.orbit_over_box import Region, region_of
from nonsmooth.runtime.proof.boxes.tile_places import Interval
from nonsmooth.runtime.proof.branch.certified_branch import BranchTile, CertifiedBranch
from nonsmooth.runtime.proof.branch.certify_branch import MOST_TILES, STATED, certify_branch
from nonsmooth.runtime.proof.branch.curve import OrbitCurve
from nonsmooth.runtime.proof.branch.look import UNDECIDED
from nonsmooth.runtime.proof.branch.tube import BranchTube
from nonsmooth.runtime.proof.certificate import Stated
from nonsmooth.runtime.proof.doubling.beside_flip import (
    begin_of_branch,
    covered,
    doubled_guess,
    flip_with_direction,
    verdict_of,
)
from nonsmooth.runtime.proof.doubling.certified_cascade import (
    CertifiedCascade,
    CertifiedDoubling,
)
from nonsmooth.runtime.proof.doubling.doubling_tube import FLIP, ProvedTube, proved_tube
from nonsmooth.runtime.proof.exact_tables import rational_of
from nonsmooth.runtime.proof.orbit_to_prove import NotCovered

if TYPE_CHECKING:
    from flint import arb

__all__ = ["certify_cascade"]

_LARGEST, _LEAST = 1 / 8, 1 / 8192  # amplitudes, in the size of the orbit
_BEHIND = Fraction(1, 4)  # of the distance to the next flip: how far a branch goes behind it


class _Stopped(Exception):
    """Why a cascade goes no further."""


class _Doubled(NamedTuple):
    """One doubling, with the orbit of twice the period at which its branch begins."""

    doubling: CertifiedDoubling
    value: Fraction
    orbit: Orbit
    sharp: list[arb]


def certify_cascade(
    branch: Branch,
    *,
    doublings: int = 1,
    flip: int = 1,
    interval: tuple[object, object] | None = None,
    tiles: int = MOST_TILES,
    resume: CertifiedCascade | None = None,
    progress: Callable[[int, int], object] = lambda done, asked: None,
    keep: Callable[[CertifiedCascade], object] | None = None,
) -> CertifiedCascade:
    """Prove what is beyond a flip: the orbits of twice the period, their side and stability.

    Next to the flip, where the equations of the doubled orbit are singular, other equations are
    solved that are not, over an amplitude that begins at zero. From there on the doubled orbits
    are a branch like any other; its own next flip is gone beyond in its turn.

    Parameters
    ----------
    branch : Branch
        Its orbit and its parameter are taken, and where its flips are, about.
    doublings : int, default 1
        How many flips are gone beyond, one after the other.
    flip : int, default 1
        Which flip of the branch is the first, counted from 1.
    interval : tuple of (number or str, number or str), optional
        Ends of the parameter, rational numbers; those of the branch by default.
    tiles : int
        At most so many are proved of each doubled branch.
    resume : CertifiedCascade, optional
        What was proved before of the same branch.
    progress : function of two ints, optional
        Is told how many doublings are proved, and how many were asked for.
    keep : function of a CertifiedCascade, optional
        Is given the state after each doubling.

    Returns
    -------
    CertifiedCascade
        Its claim is "proved" if there are as many doublings as were asked for, all with a
        verdict; its `end` says why there are not so many.

    Raises
    ------
    InputError
        For what is no branch, or has no such flip, or a state of another branch.
    Interrupted
        By Ctrl-C; its `partial` is the state, which `resume` takes.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> orbit = ns.solve("dry-friction/symmetric", {"V": "1.05"})
    >>> branch = ns.continue_orbit(orbit, "V", (1, 1.2))
    >>> found = ns.certify_cascade(branch, tiles=2)
    >>> found.kind(0), found.doublings[0].side, found.doublings[0].verdict
    ('subcritical', 'above', 'unstable')
    """
    if not isinstance(branch, Branch):
        raise InputError(f"{branch!r} is no branch, such as continue_orbit gives")
    for name, count in (("doublings", doublings), ("flip", flip), ("tiles", tiles)):
        if isinstance(count, bool) or not isinstance(count, int) or count < 1:
            raise InputError(f"{name} = {count!r} is not a positive integer")
    if not isinstance(resume, CertifiedCascade | None):
        raise InputError(f"{resume!r} is no state to resume: load reads one")
    flips = [event for event in branch.events if event.kind == "flip"]
    if len(flips) < flip:
        raise InputError(f"the branch has {len(flips)} flips, and not a number {flip}")
    event = flips[flip - 1]
    base, _ = composed_family(branch, round(event.place), None)
    if branch.parameter not in base.parameters:
        raise InputError(f"{branch.parameter} is no parameter of {base.system.name}")
    if interval is None:
        values = branch.parameter_values
        interval = as_value(float(values.min())), as_value(float(values.max()))
    lower, upper = (as_value(end).exact for end in interval)
    if lower is None or upper is None or not lower < upper:
        raise InputError("the interval has no two rational ends, the lower one first")
    # by the tables an orbit has no name of its own; phases that take no time are left out
    name = branch.orbit.name if base.itinerary == branch.orbit.itinerary else base.name
    work = _Cascade(name, base, branch.parameter, (lower, upper), event.value, tiles)
    state = work.begun(doublings, resume)
    try:
        while len(state.doublings) < doublings and not state.end:
            progress(len(state.doublings), doublings)
            state = work.next(state)
            if keep is not None:
                keep(state)
    except KeyboardInterrupt:
        raise Interrupted(state) from None
    progress(len(state.doublings), doublings)
    return state


class _Cascade:
    """From one flip to the next."""

    def __init__(
        self,
        name: str,
        base: Orbit,
        parameter: str,
        interval: Interval,
        value: float,
        tiles: int,
    ) -> None:
        self.name, self.base, self.parameter, self.interval = name, base, parameter, interval
        self.value, self.tiles = value, tiles

    def begun(self, asked: int, resume: CertifiedCascade | None) -> CertifiedCascade:
        """The state from which it goes on."""
        first = continue_orbit(self.base, self.parameter, _floats(self.interval))
        if resume is not None:
            # refuses another orbit's branch, or another interval
            certify_branch(
                first, interval=self.interval, tiles=1,
                resume=replace(resume.branches[0], ends=("", "")),
            )  # fmt: skip
            return replace(resume, orbit=self.name, asked=asked, end="")
        found = certify_branch(first, interval=self.interval)
        return CertifiedCascade(
            orbit=self.name, asked=asked, doublings=(), branches=(found,), end=""
        )

    def next(self, state: CertifiedCascade) -> CertifiedCascade:
        """One doubling more, or the reason why there is none."""
        number, last = len(state.doublings) + 1, state.branches[-1]
        try:
            place = self._flip_in(last, number)
            before = state.doublings[-1].amplitude if state.doublings else None
            doubled = self._doubled(last, place, before)
            beyond = self._branch(doubled, goes_on=number < state.asked)
        except (_Stopped, NotCovered) as reason:
            return replace(state, end=f"doubling {number}: {reason}")
        return replace(
            state,
            doublings=(*state.doublings, doubled.doubling),
            branches=(*state.branches, beyond),
        )

    def _flip_in(self, branch: CertifiedBranch, number: int) -> int:
        """The tile with the flip that is next."""
        flips = [
            (place, tile.event)
            for place, tile in enumerate(branch.tiles)
            if tile.event is not None and tile.event.kind == "flip"
        ]
        if not flips:
            raise _Stopped("no flip is proved on the branch")
        if number == 1:
            near = [abs(float(e.enclosures[self.parameter]) - self.value) for _, e in flips]
            return flips[int(np.argmin(near))][0]
        return flips[0 if branch.start == 0 else -1][0]

    def _doubled(self, branch: CertifiedBranch, place: int, before: Fraction | None) -> _Doubled:
        """The orbits of twice the period next to a flip; along a cascade they come closer."""
        tile = branch.tiles[place]
        orbit = self._orbit(branch, tile)
        region = region_of(orbit, {self.parameter: branch.interval})
        if reason := covered(region):
            raise _Stopped(reason)
        assert tile.event is not None
        point = [x.ball for x in tile.event.enclosures.values()]
        found = flip_with_direction(region, point)
        if found is None:
            raise _Stopped("the flip is degenerate, or not proved to be regular")
        scaled, flip = found
        if not _in_tile(OrbitCurve(region), tile, flip):
            raise _Stopped("the flip is not proved to be that of the branch")
        size = max(abs(float(x.mid())) for x in flip[: len(region.guess)])
        kept: _Doubled | None = None
        reason, amplitude = "", size * _LARGEST
        if before is not None:
            amplitude = min(amplitude, float(before))
        while amplitude > size * _LEAST:
            proved = proved_tube(region, scaled, Fraction(f"{amplitude:.2g}"), flip)
            amplitude /= 2
            if isinstance(proved, str):
                reason = proved
                continue
            tried = self._judged(region, orbit, place, proved)
            kept = kept or tried
            if tried is not None and tried.doubling.verdict != UNDECIDED:
                return tried
        if kept is None:
            raise _Stopped(reason)
        return kept

    def _judged(
        self, region: Region, orbit: Orbit, place: int, proved: ProvedTube
    ) -> _Doubled | None:
        """The doubled orbits of a tube with their verdict; None where none is known."""
        value = begin_of_branch(proved)
        low, high = self.interval
        if not low < value < high or not self._inside(proved):
            return None
        guess = doubled_guess(proved, value)
        half = len(orbit.itinerary)
        start = _start(region, guess, value)
        other = solve_itinerary(
            orbit.system,
            {**orbit.parameters, self.parameter: as_value(value)},
            orbit.itinerary * 2,
            [float(x) for x in guess[-2 * half :]],
            start,
        )
        if not other.converged:
            return None
        doubled = region_of(other, {self.parameter: self.interval})
        verdict, reason, sharp = verdict_of(proved, doubled, value)
        if sharp is None:
            return None
        names = OrbitCurve(region).names
        doubling = CertifiedDoubling(
            tile=place,
            scaled=names[proved.tube.scaled],
            amplitude=proved.tube.amplitude,
            side="above" if proved.rate > 0 else "below",
            verdict=verdict,
            reason=reason,
            rate=Stated.around(proved.rate, STATED),
            centre=proved.tube.centre,
            radii=proved.tube.radii,
        )
        return _Doubled(doubling, value, other, sharp)

    def _inside(self, proved: ProvedTube) -> bool:
        """Whether a tube's parameters are those of the interval."""
        from flint import arb

        low, high = (arb(rational_of(end)) for end in self.interval)
        reached = range_of(proved.point[-1])
        return bool(reached > low and reached < high)

    def _branch(self, doubled: _Doubled, *, goes_on: bool) -> CertifiedBranch:
        """The branch of twice the period, from inside the tube on."""
        low, high = self.interval
        above = doubled.doubling.side == "above"
        ends = (doubled.value, high) if above else (low, doubled.value)
        followed = continue_orbit(doubled.orbit, self.parameter, _floats(ends))
        flips = [event.value for event in followed.events if event.kind == "flip"]
        if goes_on and flips:
            near = min(flips, key=lambda x: abs(x - float(doubled.value)))
            away = Fraction(f"{near - float(doubled.value):.3g}")
            far = doubled.value + away * (1 + _BEHIND)
            ends = (doubled.value, min(far, high)) if above else (max(far, low), doubled.value)
        found = certify_branch(followed, interval=ends, tiles=self.tiles)
        if not found.tiles:
            raise _Stopped("the doubled branch is not proved to go on")
        tile = found.tiles[0 if found.start == 0 else -1]
        names = (*found.unknown_names, self.parameter)
        begins = tile.coordinate == names[-1] and doubled.value in (tile.lower, tile.upper)
        with flint_precision(FLIP):
            if not begins or not _holds(tile, len(names) - 1, doubled.sharp):
                raise _Stopped("the doubled branch is not proved to begin at the flip")
        return found

    def _orbit(self, branch: CertifiedBranch, tile: BranchTile) -> Orbit:
        """An orbit of a branch near its flip, in floating point."""
        if branch.itinerary == self.base.itinerary:
            return self.base
        assert tile.event is not None
        value = (tile.event.enclosures[self.parameter].ball).mid()
        exact = Fraction(f"{float(value):.12g}")
        point = {name: float(x) for name, x in tile.event.enclosures.items()}
        dwell = [point[name] for name in branch.unknown_names[-len(branch.itinerary) :]]
        found = solve_itinerary(
            self.base.system,
            {**self.base.parameters, self.parameter: as_value(exact)},
            branch.itinerary,
            dwell,
        )
        if not found.converged:
            raise _Stopped("no orbit is found at the flip")
        return found


def _floats(interval: Interval) -> tuple[float, float]:
    return float(interval[0]), float(interval[1])


def _start(region: Region, guess: list[arb], value: Fraction) -> list[float]:
    """The state at which an orbit begins."""
    with flint_precision(64):
        from flint import arb

        equations = region.equations(region.tables.number_at([arb(rational_of(value))]))
        state, _ = equations.start(guess[: equations.count])
        return [float(x) for x in state.entries()[:-1]]


def _in_tile(curve: OrbitCurve, tile: BranchTile, flip: list[arb]) -> bool:
    """Whether a flip with its direction is the one of a branch's tile."""
    names = curve.names
    place = len(names) - 1 if tile.coordinate == names[-1] else names.index(tile.coordinate)
    point = [*flip[: len(names) - 1], flip[-1]]
    with flint_precision(FLIP):
        from flint import arb

        low, high = (arb(rational_of(end)) for end in (tile.lower, tile.upper))
        inside = bool(point[place] > low and point[place] < high)
        return inside and _holds(tile, place, point)


def _holds(tile: BranchTile, place: int, point: list[arb]) -> bool:
    """Whether a point between the ends is in the tube of a tile, at the working precision.

    Not where the tile's orbits are those of equations that are divided by a dwell time.
    """
    if tile.divided is not None:
        return False
    tube = BranchTube(place, tile.lower, tile.upper, tile.centre, tile.radii)
    return tube.holds(point[place], [*point[:place], *point[place + 1 :]])

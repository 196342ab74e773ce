"""Certify what is beyond a flip: the side and verdict of the orbits of twice the period."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING, NamedTuple, cast

from nonsmooth.runtime.checker.branch import curve_of
from nonsmooth.runtime.checker.branch_tile import CheckedTile
from nonsmooth.runtime.checker.doubling import check_doubled
from nonsmooth.runtime.core.errors import InputError, Interrupted
from nonsmooth.runtime.core.taylor_models import range_of
from nonsmooth.runtime.core.values import as_value
from nonsmooth.runtime.explore.continuation.branch import Branch
from nonsmooth.runtime.explore.continuation.composed_family import composed_family
from nonsmooth.runtime.explore.continuation.continue_orbit import continue_orbit
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.orbits.table_solve import solve_itinerary
from nonsmooth.runtime.proof.boxes.orbit_over_box import Region, region_of
from nonsmooth.runtime.proof.boxes.tile_places import Interval
from nonsmooth.runtime.proof.branch.certified_branch import STATED, UNDECIDED, CertifiedBranch
from nonsmooth.runtime.proof.branch.certify_branch import MOST_TILES, certify_branch
from nonsmooth.runtime.proof.branch.curve import OrbitCurve
from nonsmooth.runtime.proof.certificate import Stated, file_json
from nonsmooth.runtime.proof.doubling.beside_flip import (
    begin_of_branch,
    begins_with,
    covered,
    doubled_guess,
    flip_with_direction,
    in_tile,
    start_of,
    verdict_of,
)
from nonsmooth.runtime.proof.doubling.certified_doubling import (
    CertifiedDoubling,
    DoubledOrbits,
    Ended,
    doubled_json,
)
from nonsmooth.runtime.proof.doubling.doubling_tube import ProvedTube, proved_tube
from nonsmooth.runtime.proof.exact_tables import rational_of
from nonsmooth.runtime.proof.orbit_to_prove import NotCovered
from nonsmooth.runtime.proof.refusals import as_read, refusal

if TYPE_CHECKING:
    from flint import arb

__all__ = ["certify_doubling"]

_LARGEST, _LEAST = 1 / 8, 2.0**-24  # amplitudes, in the size of the orbit
_BEHIND = Fraction(1, 4)  # of the distance to the next flip: how far a branch goes behind it
_FLIP, _TUBE = 0.2, 0.6  # shares of the work: up to the flip, and to the tube beside it


def certify_doubling(
    branch: Branch,
    *,
    flip: int = 1,
    interval: tuple[object, object] | None = None,
    tiles: int = MOST_TILES,
    seconds: float = math.inf,
    resume: CertifiedDoubling | None = None,
    progress: Callable[[float, int], object] = lambda share, tiles: None,
    keep: Callable[[CertifiedDoubling], object] | None = None,
) -> CertifiedDoubling:
    """Prove what is beyond a flip: the orbits of twice the period, their side and stability.

    Next to the flip, where the equations of the doubled orbit are singular, other equations are
    solved that are not, over an amplitude that begins at zero. From there on the doubled orbits
    are a branch like any other, which is proved to a bit beyond its own next flip. To go beyond
    that one, follow `branch.switch(flip)` with `continue_orbit`, and ask again.

    Parameters
    ----------
    branch : Branch
        Its orbit and its parameter are taken, and where its flips are, about.
    flip : int, default 1
        Which flip of the branch is gone beyond, counted from 1.
    interval : tuple of (number or str, number or str), optional
        Ends of the parameter, rational numbers; those of the branch by default.
    tiles : int
        At most so many are proved of the doubled branch, those of `resume` among them.
    seconds : float
        Behind the first tile that ends after this time nothing is begun.
    resume : CertifiedDoubling, optional
        What was proved before of the same branch.
    progress : function of a float and an int, optional
        Is told about which share of the work is done, and how many tiles are proved of the branch
        that is under way.
    keep : function of a CertifiedDoubling, optional
        Is given the state at the end, and every ten seconds along a branch.

    Returns
    -------
    CertifiedDoubling
        Its claim is "proved" if the doubled orbits are there, with a verdict; its `ended` and
        `end` say why they are not.

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
    >>> found = ns.certify_doubling(branch, tiles=2)
    >>> found.kind, found.doubled.side, found.doubled.verdict
    ('subcritical', 'above', 'unstable')
    """
    if not isinstance(branch, Branch):
        raise InputError(f"{branch!r} is no branch, such as continue_orbit gives")
    for name, count in (("flip", flip), ("tiles", tiles)):
        if isinstance(count, bool) or not isinstance(count, int) or count < 1:
            raise InputError(f"{name} = {count!r} is not a positive integer")
    if not seconds > 0:
        raise InputError(f"seconds = {seconds!r} is not a positive number")
    if not isinstance(resume, CertifiedDoubling | None):
        raise InputError(f"{resume!r} is no state to resume: load reads one")
    flips = [event for event in branch.events if event.kind == "flip"]
    if len(flips) < flip:
        told = f"{len(flips) or 'no'} {'flip' if len(flips) == 1 else 'flips'}"
        raise InputError(f"the branch has {told}: there is no flip {flip} to go beyond")
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
    work = _DoublingWork(
        name,
        base,
        branch.parameter,
        (lower, upper),
        event.value,
        tiles=tiles,
        seconds=seconds,
        progress=progress,
        keep=keep,
    )
    state = work.begun(resume)
    try:
        if not work.over:
            state = work.ended(state)
    except KeyboardInterrupt:
        raise Interrupted(state) from None
    if work.stopped:
        raise Interrupted(state)
    if state.ended == "unfinished":
        state = replace(state, end=f"the {seconds:g} s that were given are over")
    progress(1.0, 0 if state.doubled is None else len(state.doubled.branch.tiles))
    return state


class _Stopped(Exception):
    """The proof goes no further: the reason, and the kind of its end."""

    def __init__(self, reason: str, ended: Ended = "not proved") -> None:
        super().__init__(reason)
        self.ended = ended


class _Beside(NamedTuple):
    """Proved orbits beside a flip, with the one at which their branch begins."""

    tile: int  # of the flip
    scaled: str
    proved: ProvedTube
    verdict: str
    reason: str
    value: Fraction  # parameter at which the branch begins
    orbit: Orbit
    sharp: list[arb]  # enclosures of the orbit's unknowns, and the parameter

    @property
    def above(self) -> bool:
        """Whether they are above the flip's parameter."""
        return bool(self.proved.rate > 0)

    def with_branch(self, branch: CertifiedBranch) -> DoubledOrbits:
        """Return what is stated of them, if they go on with this branch."""
        tube = self.proved.tube
        return DoubledOrbits(
            tile=self.tile,
            scaled=self.scaled,
            amplitude=tube.amplitude,
            side="above" if self.above else "below",
            verdict=self.verdict,
            reason=self.reason,
            rate=Stated.around(self.proved.rate, STATED),
            centre=tube.centre,
            radii=tube.radii,
            branch=branch,
        )


class _DoublingWork:
    """The work on a doubling: to the flip, to the tube beside it, and along the doubled branch."""

    def __init__(
        self,
        name: str,
        base: Orbit,
        parameter: str,
        interval: Interval,
        value: float,
        *,
        tiles: int,
        seconds: float,
        progress: Callable[[float, int], object],
        keep: Callable[[CertifiedDoubling], object] | None,
    ) -> None:
        self.name, self.base, self.parameter, self.interval = name, base, parameter, interval
        self.value, self.tiles, self.progress, self.keep = value, tiles, progress, keep
        self.until = time.monotonic() + seconds
        self.stopped = False  # by Ctrl-C, along a branch

    @cached_property
    def region(self) -> Region:
        """The region, over the parameter, of the orbit that has the flip."""
        return region_of(self.base, {self.parameter: self.interval})

    @property
    def over(self) -> bool:
        """Whether Ctrl-C or the time ends the work."""
        return self.stopped or time.monotonic() > self.until

    def begun(self, resume: CertifiedDoubling | None) -> CertifiedDoubling:
        """Return the state to go on from, with the branch of the flip proved to the end."""
        first = continue_orbit(self.base, self.parameter, _floats(self.interval))

        def with_first(found: CertifiedBranch) -> CertifiedDoubling:
            return CertifiedDoubling(
                orbit=self.name,
                ended="unfinished",
                branch=found,
                doubled=None if resume is None else resume.doubled,
                end="",
            )

        # refuses another orbit's branch, or another interval
        known = None if resume is None else resume.branch
        return with_first(self._certified(first, self.interval, (0, _FLIP), with_first, known))

    def ended(self, state: CertifiedDoubling) -> CertifiedDoubling:
        """Return the state with the doubled orbits, or with the reason why there are none."""
        try:
            if state.doubled is None:
                self.progress(_FLIP, 0)
                beside = self._beside(state.branch, self._tile_of_flip(state.branch))
                self.progress(_TUBE, 0)
                state = self._with_branch(state, beside)
            else:
                state = self._finished(state, state.doubled)
        except (_Stopped, NotCovered) as reason:
            why: Ended = getattr(reason, "ended", "not covered")
            return state if why == "unfinished" else replace(state, ended=why, end=str(reason))
        if self.keep is not None:
            self.keep(state)
        return state if self.over else replace(state, ended="complete")

    def _certified(
        self,
        branch: Branch,
        interval: Interval,
        shares: tuple[float, float],
        with_branch: Callable[[CertifiedBranch], CertifiedDoubling],
        known: CertifiedBranch | None = None,
    ) -> CertifiedBranch:
        """Return a branch, proved as far as the time allows, between two shares of the work."""
        keep = self.keep
        begin, end = shares
        try:
            return certify_branch(
                branch,
                interval=interval,
                tiles=self.tiles if begin else MOST_TILES,
                seconds=max(self.until - time.monotonic(), _LEAST),
                resume=known,
                progress=lambda share, count: self.progress(begin + share * (end - begin), count),
                keep=None if keep is None else lambda found: keep(with_branch(found)),
            )
        except Interrupted as stopped:
            self.stopped = True
            return cast(CertifiedBranch, stopped.partial)

    def _finished(self, state: CertifiedDoubling, doubled: DoubledOrbits) -> CertifiedDoubling:
        """Return the state with the doubled branch followed to its ends."""
        last = doubled.branch
        if all(last.ends):
            return state
        begin = last.interval[0 if doubled.side == "above" else 1]
        tile = last.tiles[0 if last.start == 0 else -1]
        place = -1 if begin == tile.lower else 1
        near = [sum(c * place**k for k, c in enumerate(row)) for row in tile.centre]
        followed = continue_orbit(
            self._doubled_orbit(near, begin), self.parameter, _floats(last.interval)
        )

        def with_last(found: CertifiedBranch) -> CertifiedDoubling:
            return replace(state, doubled=replace(doubled, branch=found))

        return with_last(self._certified(followed, last.interval, (_TUBE, 1), with_last, last))

    def _tile_of_flip(self, branch: CertifiedBranch) -> int:
        """Return the number of the tile that holds the flip that was asked for."""
        flips = [
            (abs(float(tile.event.enclosures[self.parameter]) - self.value), place)
            for place, tile in enumerate(branch.tiles)
            if tile.event is not None and tile.event.kind == "flip"
        ]
        if not flips:
            raise _Stopped("no flip is proved on the branch", "no flip")
        return min(flips)[1]

    def _beside(self, branch: CertifiedBranch, place: int) -> _Beside:
        """Return the doubled orbits at the flip in a branch's tile.

        The largest amplitude is halved until a tube is proved and has a verdict.
        """
        tile, region = branch.tiles[place], self.region
        if reason := covered(region):
            raise _Stopped(reason, "not covered")
        assert tile.event is not None
        point = [x.ball for x in tile.event.enclosures.values()]
        found = flip_with_direction(region, point)
        if found is None:
            raise _Stopped("the flip is degenerate, or not proved to be regular")
        scaled, flip = found
        if not in_tile(OrbitCurve(region), tile, flip):
            raise _Stopped("the flip is not proved to be that of the branch")
        size = max(abs(float(x.mid())) for x in flip[: len(region.guess)])
        kept: _Beside | None = None
        reason, amplitude = "", size * _LARGEST
        while amplitude > size * _LEAST:
            if self.over:
                raise _Stopped("the time is over", "unfinished")
            proved = proved_tube(region, scaled, Fraction(f"{amplitude:.2g}"), flip)
            amplitude /= 2
            if isinstance(proved, str):
                reason = proved
                continue
            tried = self._judged(place, proved)
            kept = kept or tried
            if tried is not None and tried.verdict != UNDECIDED:
                return tried
        if kept is None:
            raise _Stopped(reason)
        return kept

    def _judged(self, place: int, proved: ProvedTube) -> _Beside | None:
        """Return the doubled orbits of a tube with their verdict, or None if no orbit is known."""
        value = begin_of_branch(proved)
        low, high = self.interval
        if not low < value < high or not self._inside(proved):
            return None
        try:
            other = self._doubled_orbit([float(x) for x in doubled_guess(proved, value)], value)
        except _Stopped:
            return None
        doubled = region_of(other, {self.parameter: self.interval})
        verdict, reason, sharp = verdict_of(proved, doubled, value)
        if sharp is None:
            return None
        scaled = OrbitCurve(self.region).names[proved.tube.scaled]
        return _Beside(place, scaled, proved, verdict, reason, value, other, sharp)

    def _inside(self, proved: ProvedTube) -> bool:
        """Whether all parameters of a tube lie inside the interval."""
        from flint import arb

        low, high = (arb(rational_of(end)) for end in self.interval)
        reached = range_of(proved.point[-1])
        return bool(reached > low and reached < high)

    def _with_branch(self, state: CertifiedDoubling, beside: _Beside) -> CertifiedDoubling:
        """Return the state with doubled orbits and their branch, which begins inside the tube.

        The branch goes a bit beyond its own next flip, if the computed branch has one.
        """
        low, high = self.interval
        value, above = beside.value, beside.above
        ends = (value, high) if above else (low, value)
        followed = continue_orbit(beside.orbit, self.parameter, _floats(ends))
        flips = [abs(e.value - float(value)) for e in followed.events if e.kind == "flip"]
        if flips:
            away = Fraction(f"{min(flips):.3g}") * (1 + _BEHIND)
            ends = (value, min(value + away, high)) if above else (max(value - away, low), value)

        kept: list[DoubledOrbits] = []

        def with_doubled(found: CertifiedBranch) -> CertifiedDoubling:
            if not found.tiles:
                return state
            if not kept:  # it is the first tile of the branch that matters
                kept.append(_accepted(beside.with_branch(found), state.branch))
            return replace(state, doubled=replace(kept[0], branch=found))

        found = self._certified(followed, ends, (_TUBE, 1), with_doubled)
        if not found.tiles:
            why = found.ends[1 if above else 0]
            if not why:
                raise _Stopped("the time is over", "unfinished")
            raise _Stopped(f"the doubled branch is not proved to go on: {why}")
        if not begins_with(found, value, beside.sharp):
            raise _Stopped("the doubled branch is not proved to begin at the flip")
        return with_doubled(found)

    def _doubled_orbit(self, near: Sequence[float], value: Fraction) -> Orbit:
        """Return an orbit of twice the period in floating point, from about its unknowns."""
        from flint import arb

        itinerary = self.base.itinerary * 2
        found = solve_itinerary(
            self.base.system,
            {**self.base.parameters, self.parameter: as_value(value)},
            itinerary,
            near[-len(itinerary) :],
            start_of(self.region, [arb(x) for x in near], value),
        )
        if not found.converged:
            raise _Stopped("no orbit is found on the doubled branch")
        return found


def _accepted(doubled: DoubledOrbits, branch: CertifiedBranch) -> DoubledOrbits:
    """Return orbits beside a flip of a branch as far as the checker accepts them.

    If it refuses the verdict, that becomes undecided; if it refuses the orbits without a verdict
    too, `_Stopped` is raised.
    """

    def check(stated: DoubledOrbits) -> None:
        told = [as_read(file_json(each)) for each in (branch, doubled.branch)]
        tiles = [
            [CheckedTile(curve, tile) for tile in each["tiles"]]
            for each, curve in zip(told, map(curve_of, told), strict=True)
        ]
        check_doubled(as_read(doubled_json(stated)), told, tiles)

    reason = refusal(lambda: check(doubled))
    if not reason:
        return doubled
    stated = replace(doubled, verdict=UNDECIDED, reason=reason)
    if doubled.verdict == UNDECIDED or refusal(lambda: check(stated)):
        raise _Stopped(reason)
    return stated


def _floats(interval: Interval) -> tuple[float, float]:
    return float(interval[0]), float(interval[1])

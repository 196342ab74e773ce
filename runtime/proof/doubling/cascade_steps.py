"""The steps of a cascade: a flip, the doubled orbits beside it, the branch to the next one."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING, NamedTuple, cast

import numpy as np

from nonsmooth.runtime.checker.branch import curve_of
from nonsmooth.runtime.checker.branch_tile import CheckedTile
from nonsmooth.runtime.checker.doubling import check_doubling
from nonsmooth.runtime.core.errors import Interrupted
from nonsmooth.runtime.core.taylor_models import range_of
from nonsmooth.runtime.core.values import as_value
from nonsmooth.runtime.explore.continuation.branch import Branch
from nonsmooth.runtime.explore.continuation.continue_orbit import continue_orbit
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.orbits.table_solve import solve_itinerary
from nonsmooth.runtime.proof.boxes.orbit_over_box import Region, region_of
from nonsmooth.runtime.proof.boxes.tile_places import Interval
from nonsmooth.runtime.proof.branch.certified_branch import BranchTile, CertifiedBranch
from nonsmooth.runtime.proof.branch.certify_branch import MOST_TILES, STATED, certify_branch
from nonsmooth.runtime.proof.branch.curve import OrbitCurve
from nonsmooth.runtime.proof.branch.look import UNDECIDED
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
from nonsmooth.runtime.proof.doubling.certified_cascade import (
    CertifiedCascade,
    CertifiedDoubling,
    Ended,
    doubling_json,
)
from nonsmooth.runtime.proof.doubling.doubling_tube import ProvedTube, proved_tube
from nonsmooth.runtime.proof.exact_tables import rational_of
from nonsmooth.runtime.proof.orbit_to_prove import NotCovered
from nonsmooth.runtime.proof.refusals import as_read, refusal

if TYPE_CHECKING:
    from flint import arb

__all__ = ["CascadeSteps"]

_LARGEST, _LEAST = 1 / 8, 2.0**-24  # amplitudes, in the size of the orbit
_CLOSER = 4  # how much smaller amplitudes are from flip to flip, at least
_BEHIND = Fraction(1, 4)  # of the distance to the next flip: how far a branch goes behind it
_RATIO = 4  # of the distances between flips, at least: M. Feigenbaum, 1978, has 4.669 in the end
_LONGER = 4.0  # times as long takes each doubling as the one before


class _Stopped(Exception):
    """A cascade goes no further: the reason, and the kind of its end."""

    def __init__(self, reason: str, ended: Ended = "not proved") -> None:
        super().__init__(reason)
        self.ended = ended


class _Doubled(NamedTuple):
    """A proved doubling, with the orbit of twice the period at which its branch begins."""

    doubling: CertifiedDoubling
    value: Fraction  # parameter at which the branch begins
    orbit: Orbit
    sharp: list[arb]  # enclosures of the orbit's unknowns, and the parameter


class CascadeSteps:
    """The work on a cascade, from one flip to the next."""

    def __init__(
        self,
        name: str,
        base: Orbit,
        parameter: str,
        interval: Interval,
        value: float,
        *,
        asked: int,
        tiles: int,
        seconds: float,
        progress: Callable[[float, int], object],
        keep: Callable[[CertifiedCascade], object] | None,
    ) -> None:
        self.name, self.base, self.parameter, self.interval = name, base, parameter, interval
        self.value, self.asked, self.tiles = value, asked, tiles
        self.progress, self.keep = progress, keep
        self.until = time.monotonic() + seconds
        self.stopped = False  # by Ctrl-C, along a branch

    @cached_property
    def region(self) -> Region:
        """The region, over the parameter, of the orbit that has the first flip."""
        return region_of(self.base, {self.parameter: self.interval})

    @property
    def over(self) -> bool:
        """Whether Ctrl-C or the time ends the work."""
        return self.stopped or time.monotonic() > self.until

    def begun(self, resume: CertifiedCascade | None) -> CertifiedCascade:
        """Return the state to go on from, with its last branch proved to the end."""
        asked = self.asked if resume is None else max(self.asked, len(resume.doublings))
        first = continue_orbit(self.base, self.parameter, _floats(self.interval))

        def with_first(found: CertifiedBranch) -> CertifiedCascade:
            if resume is None:
                return CertifiedCascade(
                    orbit=self.name,
                    asked=asked,
                    ended="unfinished",
                    doublings=(),
                    branches=(found,),
                    end="",
                )
            behind = (found, *resume.branches[1:])
            return replace(
                resume, orbit=self.name, asked=asked, ended="unfinished", branches=behind, end=""
            )

        # refuses another orbit's branch, or another interval
        known = None if resume is None else resume.branches[0]
        state = with_first(self._certified(first, self.interval, 0, with_first, known))
        if resume is None or self.over:
            return state
        state = self._finished(state)
        complete = len(state.doublings) >= asked and not self.over
        return replace(state, ended="complete") if complete else state

    def next(self, state: CertifiedCascade) -> CertifiedCascade:
        """Return the state with one more doubling, or with the reason why there is none."""
        number, last = len(state.doublings) + 1, state.branches[-1]
        self._tell(number, 0.0)
        try:
            place = self._flip_in(last, number)
            before = state.doublings[-1].amplitude if state.doublings else None
            doubled = self._doubled(last, place, before)
            self._tell(number, 0.5)
            state = self._branch(state, doubled)
        except (_Stopped, NotCovered) as reason:
            ended: Ended = getattr(reason, "ended", "not covered")
            if ended == "unfinished":
                return state
            return replace(state, ended=ended, end=f"doubling {number}: {reason}")
        if self.keep is not None:
            self.keep(state)
        complete = len(state.doublings) >= state.asked and not self.over
        return replace(state, ended="complete") if complete else state

    def _tell(self, number: int, share: float) -> None:
        """Report about which share of all doublings is done, where long orbits take longest."""
        before, whole = ((_LONGER**k - 1) / (_LONGER - 1) for k in (number, self.asked + 1))
        self.progress((before + share * _LONGER**number) / whole, max(0, number - 1))

    def _certified(
        self,
        branch: Branch,
        interval: Interval,
        number: int,
        with_branch: Callable[[CertifiedBranch], CertifiedCascade],
        known: CertifiedBranch | None = None,
    ) -> CertifiedBranch:
        """Return a branch, proved as far as the time allows.

        Number 0 is the branch with the first flip, the others are those behind doublings.
        """
        keep = self.keep
        from_tube = 0.5 if number else 0.0
        try:
            return certify_branch(
                branch,
                interval=interval,
                tiles=self.tiles if number else MOST_TILES,
                seconds=max(self.until - time.monotonic(), _LEAST),
                resume=known,
                progress=lambda share, _: self._tell(number, from_tube + share * (1 - from_tube)),
                keep=None if keep is None else lambda found: keep(with_branch(found)),
            )
        except Interrupted as stopped:
            self.stopped = True
            return cast(CertifiedBranch, stopped.partial)

    def _finished(self, state: CertifiedCascade) -> CertifiedCascade:
        """Return the state with its last branch followed to its ends."""
        number, last = len(state.doublings), state.branches[-1]
        if not number or all(last.ends):
            return state
        above = state.doublings[-1].side == "above"
        begin = last.interval[0 if above else 1]
        tile = last.tiles[0 if last.start == 0 else -1]
        place = -1 if begin == tile.lower else 1
        near = [sum(c * place**k for k, c in enumerate(row)) for row in tile.centre]
        try:
            orbit = self._solved(last, begin, near)
        except (_Stopped, NotCovered):
            return state
        followed = continue_orbit(orbit, self.parameter, _floats(last.interval))

        def with_last(found: CertifiedBranch) -> CertifiedCascade:
            return replace(state, branches=(*state.branches[:-1], found))

        return with_last(self._certified(followed, last.interval, number, with_last, last))

    def _flip_in(self, branch: CertifiedBranch, number: int) -> int:
        """Return the number of the tile that holds the next flip of a branch.

        On the first branch it is the flip that was asked for, on the others the first one.
        """
        flips = [
            (place, tile.event)
            for place, tile in enumerate(branch.tiles)
            if tile.event is not None and tile.event.kind == "flip"
        ]
        if not flips:
            raise _Stopped("no flip is proved on the branch", "no flip")
        if number == 1:
            near = [abs(float(e.enclosures[self.parameter]) - self.value) for _, e in flips]
            return flips[int(np.argmin(near))][0]
        return flips[0 if branch.start == 0 else -1][0]

    def _doubled(self, branch: CertifiedBranch, place: int, before: Fraction | None) -> _Doubled:
        """Return the doubling at the flip in a branch's tile.

        The largest amplitude is halved until a tube is proved and has a verdict. It begins below
        `before`, that of the flip before: along a cascade doubled orbits come closer.
        """
        tile = branch.tiles[place]
        orbit = self._orbit(branch, tile)
        region = region_of(orbit, {self.parameter: branch.interval})
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
        kept: _Doubled | None = None
        reason, amplitude = "", size * _LARGEST
        if before is not None:
            amplitude = min(amplitude, float(before) / _CLOSER)
        while amplitude > size * _LEAST:
            if self.over:
                raise _Stopped("the time is over", "unfinished")
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
        """Return the doubled orbits of a tube with their verdict, or None if no orbit is known."""
        value = begin_of_branch(proved)
        low, high = self.interval
        if not low < value < high or not self._inside(proved):
            return None
        guess = doubled_guess(proved, value)
        half = len(orbit.itinerary)
        start = start_of(region, guess, value)
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
        """Whether all parameters of a tube lie inside the interval."""
        from flint import arb

        low, high = (arb(rational_of(end)) for end in self.interval)
        reached = range_of(proved.point[-1])
        return bool(reached > low and reached < high)

    def _branch(self, state: CertifiedCascade, doubled: _Doubled) -> CertifiedCascade:
        """Return the state with a doubling and its branch, which begins inside the tube.

        The branch goes a bit beyond its own next flip, if the computed branch has one.
        """
        low, high = self.interval
        number = len(state.doublings) + 1
        above = doubled.doubling.side == "above"
        ends = (doubled.value, high) if above else (low, doubled.value)
        followed = continue_orbit(doubled.orbit, self.parameter, _floats(ends))
        away = self._to_next(state, doubled.value, followed)
        if away is not None:
            far = doubled.value + away * (1 + _BEHIND) * (1 if above else -1)
            ends = (doubled.value, min(far, high)) if above else (max(far, low), doubled.value)

        kept: list[CertifiedDoubling] = []

        def with_doubled(found: CertifiedBranch) -> CertifiedCascade:
            if not found.tiles:
                return state
            if not kept:  # it is the first tile of the branch that matters
                kept.append(_accepted(doubled.doubling, state.branches[-1], found))
            return replace(
                state,
                doublings=(*state.doublings, kept[0]),
                branches=(*state.branches, found),
            )

        found = self._certified(followed, ends, number, with_doubled)
        if not found.tiles:
            why = found.ends[1 if above else 0]
            if not why:
                raise _Stopped("the time is over", "unfinished")
            raise _Stopped(f"the doubled branch is not proved to go on: {why}")
        if not begins_with(found, doubled.value, doubled.sharp):
            raise _Stopped("the doubled branch is not proved to begin at the flip")
        return with_doubled(found)

    def _to_next(
        self, state: CertifiedCascade, value: Fraction, followed: Branch
    ) -> Fraction | None:
        """Return about how far the next flip is, or None if nothing tells.

        If no flip is computed, the distance is extrapolated from the flip before.
        """
        flips = [abs(e.value - float(value)) for e in followed.events if e.kind == "flip"]
        if flips:
            return Fraction(f"{min(flips):.3g}")
        known = [float(event.enclosures[self.parameter]) for event in state.flips]
        if not known:
            return None
        return Fraction(f"{abs(float(value) - known[-1]) / _RATIO:.3g}")

    def _orbit(self, branch: CertifiedBranch, tile: BranchTile) -> Orbit:
        """Return an orbit of a branch near the flip in a tile, in floating point."""
        if branch.itinerary == self.base.itinerary:
            return self.base
        assert tile.event is not None
        at = [float(x) for x in tile.event.enclosures.values()]
        return self._solved(branch, Fraction(f"{at[-1]:.12g}"), at[:-1])

    def _solved(self, branch: CertifiedBranch, value: Fraction, near: Sequence[float]) -> Orbit:
        """Return an orbit of a branch in floating point, solved from about its unknowns."""
        from flint import arb

        found = solve_itinerary(
            self.base.system,
            {**self.base.parameters, self.parameter: as_value(value)},
            branch.itinerary,
            near[-len(branch.itinerary) :],
            start_of(self.region, [arb(x) for x in near], value),
        )
        if not found.converged:
            raise _Stopped("no orbit is found on the branch")
        return found


def _accepted(
    doubling: CertifiedDoubling, branch: CertifiedBranch, beyond: CertifiedBranch
) -> CertifiedDoubling:
    """Return a doubling as far as the checker accepts it.

    If it refuses the verdict, that becomes undecided; if it refuses the doubling without a verdict
    too, `_Stopped` is raised.
    """

    def check(stated: CertifiedDoubling) -> None:
        told = [as_read(file_json(each)) for each in (branch, beyond)]
        tiles = [
            [CheckedTile(curve, tile) for tile in each["tiles"]]
            for each, curve in zip(told, map(curve_of, told), strict=True)
        ]
        check_doubling(as_read(doubling_json(stated)), told, tiles)

    reason = refusal(lambda: check(doubling))
    if not reason:
        return doubling
    stated = replace(doubling, verdict=UNDECIDED, reason=reason)
    if doubling.verdict == UNDECIDED or refusal(lambda: check(stated)):
        raise _Stopped(reason)
    return stated


def _floats(interval: Interval) -> tuple[float, float]:
    return float(interval[0]), float(interval[1])

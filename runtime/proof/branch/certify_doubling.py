"""Certify what is beyond a flip: the side and verdict of the orbits of twice the period."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import Any, cast

import numpy as np
from flint import arb

from nonsmooth.runtime.checker.ranges.branch import ORDER, CheckedTile, curve_of
from nonsmooth.runtime.checker.ranges.branch_curve import CheckedCurve
from nonsmooth.runtime.checker.ranges.doubling import (
    DoubledEquations,
    JudgedDoubling,
    twofold,
)
from nonsmooth.runtime.checker.stated.exact import Entries, Failure
from nonsmooth.runtime.core.errors import InputError, Interrupted, check_integer
from nonsmooth.runtime.core.taylor_models import TaylorModel, matrix, range_of, space_of
from nonsmooth.runtime.core.values import as_value, flint_precision
from nonsmooth.runtime.explore.continuation.branch import Branch
from nonsmooth.runtime.explore.continuation.continue_orbit import continue_orbit
from nonsmooth.runtime.explore.continuation.next_orbits import composed_family
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.orbits.table_solve import solve_itinerary
from nonsmooth.runtime.proof.asking import Progress, Steps, as_read, proved_by_steps, refusal
from nonsmooth.runtime.proof.boxes.box_certificate import BITS
from nonsmooth.runtime.proof.boxes.tile import Interval
from nonsmooth.runtime.proof.branch.certified_branch import (
    STATED,
    UNDECIDED,
    CertifiedBranch,
    CertifiedDoubling,
    DoubledOrbits,
    Ended,
)
from nonsmooth.runtime.proof.branch.certify_branch import MOST_TILES, asked_interval, certify_branch
from nonsmooth.runtime.proof.certificate import file_json
from nonsmooth.runtime.proof.certify_orbit import stated
from nonsmooth.runtime.proof.orbit_to_prove import NotCovered
from nonsmooth.runtime.proof.statement import rational_of

_FLIP_BITS = 192  # bits of the numbers at the flip
_NEWTON_STEPS = 3  # of Newton's method: each doubles the powers of the amplitude that are right
_WIDER = (2, 8, 32)  # times what is missed: radii that are tried
_LEAST_RADIUS = 2.0**-50  # of a radius
_SHARE = 0.75  # of the largest amplitude: where the doubled branch begins


def flip_with_direction(curve: CheckedCurve, point: Sequence[arb]) -> tuple[int, list[arb]]:
    """Return the number of the entry of the direction that is 1, and a flip with its direction.

    `point` is about the cycle's unknowns and the parameter at the flip. The second result is the
    solution of the doubled equations at the amplitude zero. `Failure` if there is none.
    """
    with flint_precision(_FLIP_BITS):
        middles = [x.mid() for x in point]
        _, rows = curve.slopes(middles)
        slopes = matrix([row[:-1] for row in rows])
        turned = (slopes + 2 * DoubledEquations(curve, 0).start_rows()).mid()
        away = np.linalg.svd(np.array(turned.tolist(), dtype=float))[2][-1]
        scaled = int(np.argmax(abs(away)))
        others = [arb(float(x / away[scaled])) for k, x in enumerate(away) if k != scaled]
        guess = [*middles[:-1], *others, middles[-1]]
        return scaled, DoubledEquations(curve, scaled).flip_near(guess)


def tubes(
    curve: CheckedCurve, scaled: int, amplitude: Fraction, flip: Sequence[arb]
) -> Iterator[Entries]:
    """Yield tubes of doubled orbits up to an amplitude, narrow ones first, as a file states them.

    There is none where Newton's method fails.
    """
    equations, space = DoubledEquations(curve, scaled), space_of(1, ORDER)
    with flint_precision(BITS):
        a = space.variable(0, arb(0), arb(rational_of(amplitude)))
        centre = [space.constant(x.mid()) for x in flip]
        for step in range(_NEWTON_STEPS + 1):
            values, slopes = equations.at(a, centre)
            try:
                missed = (slopes.mid().inv().mid() * values).entries()
            except ZeroDivisionError:
                return
            if not all(range_of(d).is_finite() for d in missed):
                return
            if step < _NEWTON_STEPS:
                rows = [_coefficients(x - d) for x, d in zip(centre, missed, strict=True)]
                centre = [TaylorModel(space, tuple(map(arb, row))) for row in rows]
        sizes = [float(abs(range_of(d)).upper()) for d in missed]
    for factor in _WIDER:
        yield {
            "scaled": curve.declared.unknowns[scaled],
            "amplitude": str(amplitude),
            "centre": rows,
            "radii": [factor * size + _LEAST_RADIUS for size in sizes],
        }


def _coefficients(model: TaylorModel) -> list[float]:
    return [0.0 if part is None else float(part.mid()) for part in model.parts]


def begin_of_branch(found: JudgedDoubling) -> Fraction:
    """Return a short decimal: the parameter, inside a tube, at which the doubled branch begins."""
    value, rate = float(found.centre[-1].parts[0]), float(found.rate.mid())
    away = rate * (_SHARE * float(found.amplitude)) ** 2
    digits = max(0, 2 - math.floor(math.log10(abs(away))))
    return Fraction(round(Fraction(value + away) * 10**digits), 10**digits)


def doubled_guess(found: JudgedDoubling, value: Fraction) -> list[float]:
    """Return the unknowns of the doubled orbit, about, at a value of the parameter in a tube."""
    square = (float(value) - float(found.centre[-1].parts[0])) / float(found.rate.mid())
    amplitude = arb(math.sqrt(max(square, 0.0)))
    with flint_precision(BITS):
        point = [x.at([amplitude / found.amplitude]) for x in found.centre]
        first, second = found.equations.halves(amplitude, point)
        dwell = second[found.equations.size - len(found.curve.declared.dwell) :]
        return [float(x) for x in (*first, *dwell)]


def start_of(twice: CheckedCurve, near: Sequence[float], value: Fraction) -> list[float]:
    """Return the state at which a doubled orbit begins, about, from about its unknowns."""
    with flint_precision(BITS):
        orbit = twice.orbit([*map(arb, near), arb(rational_of(value))])
        return [float(x.mid()) for x in orbit.now.starts[0].entries()[:-1]]


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
    progress: Progress = lambda share, tiles: None,
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
    >>> found = ns.certify.doubling(branch, tiles=2)
    >>> found.kind, found.doubled.side, found.doubled.verdict
    ('subcritical', 'above', 'unstable')
    """
    for name, count in (("flip", flip), ("tiles", tiles)):
        check_integer(name, count, 1)
    ends = asked_interval(branch, interval, seconds)
    flips = [event for event in branch.events if event.kind == "flip"]
    if len(flips) < flip:
        told = f"{len(flips) or 'no'} {'flip' if len(flips) == 1 else 'flips'}"
        raise InputError(f"the branch has {told}: there is no flip {flip} to go beyond")
    event = flips[flip - 1]
    base, _ = composed_family(branch, round(event.place), None)
    if branch.parameter not in base.parameters:
        raise InputError(f"{branch.parameter} is no parameter of {base.system.name}")
    lower, upper = (as_value(end).exact for end in ends)
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
        until=time.monotonic() + seconds,
        progress=progress,
        keep=keep,
    )
    work.begin(resume)
    state = proved_by_steps(work.steps(), lambda: work.state, progress)
    if state.ended == "unfinished":
        state = replace(state, end=f"the {seconds:g} s that were given are over")
    progress(1.0, 0 if state.doubled is None else len(state.doubled.branch.tiles))
    return state


class _Stopped(Exception):
    """The proof goes no further: the reason, and the kind of its end."""

    def __init__(self, reason: str, ended: Ended = "not proved") -> None:
        super().__init__(reason)
        self.ended = ended


@dataclass
class _DoublingWork:
    """The work on a doubling: to the flip, to the tube beside it, and along the doubled branch."""

    name: str
    base: Orbit
    parameter: str
    interval: Interval
    value: float
    tiles: int
    until: float
    progress: Progress
    keep: Callable[[CertifiedDoubling], object] | None
    state: CertifiedDoubling = field(init=False)

    @property
    def over(self) -> bool:
        """Whether the time ends the work."""
        return time.monotonic() > self.until

    def begin(self, resume: CertifiedDoubling | None) -> None:
        """Set the state to go on from, with the branch of the flip proved to the end."""
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
        proved = self._certified(first, self.interval, (0, _FLIP), with_first, known)
        self.state = with_first(proved)

    def steps(self) -> Steps:
        """Prove the doubled orbits and follow them, or find the reason why there are none."""
        state = self.state
        if self.over:
            return
        try:
            if state.doubled is None:
                yield _FLIP, 0
                beside = self._beside(state.branch, self._tile_of_flip(state.branch))
                yield _TUBE, 0
                self.state = self._with_branch(state, beside)
            else:
                self.state = self._finished(state, state.doubled)
        except (_Stopped, NotCovered) as reason:
            why: Ended = getattr(reason, "ended", "not covered")
            if why != "unfinished":
                self.state = replace(state, ended=why, end=str(reason))
            return
        if self.keep is not None:
            self.keep(self.state)
        if not self.over:
            self.state = replace(self.state, ended="complete")

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
            raise Interrupted(with_branch(cast(CertifiedBranch, stopped.partial))) from None

    def _finished(self, state: CertifiedDoubling, doubled: DoubledOrbits) -> CertifiedDoubling:
        """Return the state with the doubled branch followed to its ends."""
        last = doubled.branch
        if all(last.ends):
            return state
        begin = last.interval[0 if doubled.side == "above" else 1]
        tile = last.tiles[0 if last.start == 0 else -1]
        place = -1 if begin == tile.lower else 1
        near = [sum(c * place**k for k, c in enumerate(row)) for row in tile.centre]
        twice = twofold(as_read(file_json(state.branch)))
        followed = continue_orbit(
            self._doubled_orbit(twice, near, begin), self.parameter, _floats(last.interval)
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
        content = as_read(file_json(branch))
        curve = curve_of(content)
        tile, event = CheckedTile(curve, content["tiles"][place]), branch.tiles[place].event
        if reason := refusal(lambda: twofold(content)):
            raise _Stopped(reason, "not covered")
        assert event is not None
        try:
            scaled, flip = flip_with_direction(curve, [x.ball for x in event.enclosures.values()])
        except Failure as problem:
            told = f"the flip is degenerate, or not proved to be regular: {problem}"
            raise _Stopped(told) from None
        size = max(abs(float(x.mid())) for x in flip[: curve.last])
        kept: _Beside | None = None
        reason, amplitude = "Newton's method finds no doubled orbit", size * _LARGEST
        while amplitude > size * _LEAST:
            for tube in tubes(curve, scaled, Fraction(f"{amplitude:.2g}"), flip):
                if self.over:
                    raise _Stopped("the time is over", "unfinished")
                found = JudgedDoubling(tube, content, tile)
                if reason := refusal(found.locate):
                    continue
                value = begin_of_branch(found)
                if not self.interval[0] < value < self.interval[1]:
                    break
                try:
                    orbit = self._doubled_orbit(found.twice, doubled_guess(found, value), value)
                except _Stopped as problem:
                    reason = str(problem)
                    break
                tried = _Beside(place, tube, found, refusal(found.decide), value, orbit)
                kept = kept or tried
                if not tried.undecided:
                    return tried
                break
            amplitude /= 2
        if kept is None:
            raise _Stopped(reason)
        return kept

    def _with_branch(self, state: CertifiedDoubling, beside: _Beside) -> CertifiedDoubling:
        """Return the state with doubled orbits and their branch, which begins inside the tube.

        The branch goes a bit beyond its own next flip, if the computed branch has one.
        """
        low, high = self.interval
        above = beside.found.side == "above"
        value = beside.value
        ends = (value, high) if above else (low, value)
        followed = continue_orbit(beside.orbit, self.parameter, _floats(ends))
        flips = [abs(e.value - float(value)) for e in followed.events if e.kind == "flip"]
        if flips:
            away = Fraction(f"{min(flips):.3g}") * (1 + _BEHIND)
            ends = (value, min(value + away, high)) if above else (max(value - away, low), value)

        def with_doubled(branch: CertifiedBranch) -> CertifiedDoubling:
            return replace(state, doubled=beside.with_branch(branch)) if branch.tiles else state

        branch = self._certified(followed, ends, (_TUBE, 1), with_doubled)
        if not branch.tiles:
            why = branch.ends[1 if above else 0]
            if not why:
                raise _Stopped("the time is over", "unfinished")
            raise _Stopped(f"the doubled branch is not proved to go on: {why}")
        return with_doubled(branch)

    def _doubled_orbit(self, twice: CheckedCurve, near: Sequence[float], value: Fraction) -> Orbit:
        """Return an orbit of twice the period in floating point, from about its unknowns."""
        itinerary = self.base.itinerary * 2
        found = solve_itinerary(
            self.base.system,
            {**self.base.parameters, self.parameter: as_value(value)},
            itinerary,
            near[-len(itinerary) :],
            start_of(twice, near, value),
        )
        if not found.converged:
            raise _Stopped("no orbit is found on the doubled branch")
        return found


@dataclass(eq=False)
class _Beside:
    """Proved orbits beside a flip, whose branch is to be found.

    `undecided` says why they have no verdict together; it is empty where they have. At `value`
    of the parameter the branch begins with about the `orbit`.
    """

    tile: int
    tube: Entries
    found: JudgedDoubling
    undecided: str
    value: Fraction
    orbit: Orbit
    judged: tuple[str, str] | None = None  # verdict and reason, which the first tile tells

    def with_branch(self, branch: CertifiedBranch) -> DoubledOrbits:
        """Return what is stated of them, if they go on with this branch.

        `_Stopped` if the branch is not proved to begin with one of them.
        """
        self.judged = self.judged or self._judged(branch)
        verdict, reason = self.judged
        with flint_precision(STATED):
            rate = stated(self.found.rate, STATED)
        tube, found = self.tube, self.found
        return DoubledOrbits(
            tile=self.tile,
            scaled=tube["scaled"],
            amplitude=Fraction(tube["amplitude"]),
            side=found.side,
            verdict=verdict,
            reason=reason,
            rate=rate,
            centre=tuple(map(tuple, tube["centre"])),
            radii=tuple(tube["radii"]),
            branch=branch,
        )

    def _judged(self, branch: CertifiedBranch) -> tuple[str, str]:
        """Return the verdict that all have as the one with which a branch begins, and a reason."""
        content, orbit = as_read(file_json(branch)), list[Any]()

        def begins() -> None:
            tile = content["tiles"][0 if branch.start == 0 else -1]
            orbit.extend(self.found.first_of(content, CheckedTile(curve_of(content), tile)))

        if reason := refusal(begins):
            raise _Stopped(reason)
        verdict: list[str] = []
        if reason := self.undecided or refusal(lambda: verdict.append(self.found.verdict(orbit))):
            return UNDECIDED, reason
        told = "the multipliers at one orbit are not told from the unit circle"
        return verdict[0], told if verdict[0] == UNDECIDED else ""


def _floats(interval: Interval) -> tuple[float, float]:
    return float(interval[0]), float(interval[1])

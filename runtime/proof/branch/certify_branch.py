"""Certify a branch: every orbit of it, every change of its verdict, and that there is no other.

Where it meets a border other itineraries begin; what these are, their side and verdict is proved
too. Each that floating point finds is proved in one tile that holds the border: over the parameter,
or over the dwell time of a phase that vanishes there, by which its equations are regular where the
parameter turns. It begins at the branch's event, if both events are one motion. The scenarios are
those of M. di Bernardo, C. Budd, A. Champneys and P. Kowalczyk, Piecewise-smooth Dynamical Systems
(2008), sections 3.1 and 8: persistence, and nonsmooth folds.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import partial
from typing import Any

import numpy as np
from flint import arb

from nonsmooth.runtime.checker.ranges.beyond import found_beyond
from nonsmooth.runtime.checker.ranges.branch import BITS, SHARP, CheckedTile, check_joint, ending
from nonsmooth.runtime.checker.ranges.branch_curve import CheckedCurve, without_entry
from nonsmooth.runtime.checker.stated.exact import Entries, demand
from nonsmooth.runtime.core.errors import InputError, check_integer
from nonsmooth.runtime.core.values import as_value, flint_precision
from nonsmooth.runtime.explore.continuation.branch import Branch
from nonsmooth.runtime.explore.continuation.event import Event
from nonsmooth.runtime.explore.continuation.next_orbits import orbits_beside
from nonsmooth.runtime.explore.finding.solved import canonical_itinerary
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.proof.asking import REFUSED, Progress, Steps, holds, proved_by_steps
from nonsmooth.runtime.proof.branch.certified_branch import BranchTile, CertifiedBranch, OrbitBeyond
from nonsmooth.runtime.proof.branch.tiles import (
    JudgedTile,
    checked_curve,
    checked_tile,
    judged_tile,
    middle_fraction,
    precision_of,
    proposed_tile,
    stated_branch,
)
from nonsmooth.runtime.proof.certificate import check_same_orbits
from nonsmooth.runtime.proof.orbit_to_prove import (
    NotCovered,
    Region,
    checked_box,
    region_of,
    with_open_ones,
)
from nonsmooth.runtime.proof.statement import rational_of

_TRIES = 8
_LARGER = 16  # times the orbit's distance: what is tried first by the parameter
_WIDE = 1e-4  # of the interval: the first tile at least
_SMALLER = 4  # times, from try to try
_BACK = 32  # share of a tile over a dwell time that lies behind its border
_SAME = 1e-4  # of the interval: where floating point has the same event
_SHORT_OF_PERIOD = 0.1  # of the period: what may vanish


class BordersOfBranch:
    """The borders that a branch meets, and what begins there.

    `content` and `curve` are the branch as the checker knows it, `branch` is the same one in
    floating point, and `orbit` the one from which it is followed.
    """

    def __init__(self, content: Entries, curve: CheckedCurve, branch: Branch, orbit: Orbit) -> None:
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
        for divided, place, *ends in _tiles_about(region, curve, value):
            try:
                guess = without_entry(place, [*(x.mid() for x in region.guess), arb(value)])
                tile = judged_tile(
                    proposed_tile(
                        curve, place, (ends[0], ends[1]), guess, forwards=True, divided=divided
                    )
                )
                with flint_precision(BITS):
                    curve.check_divisors()
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
        if event.border_collision and abs(event.value - value) < _SAME * width
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


def _tiles_about(
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
        if time < _SHORT_OF_PERIOD * sum(times) and holds(partial(curve.divided, place + 1))
    ]
    for step in range(_TRIES):
        share = _SMALLER**-step
        half = Fraction(f"{away * _LARGER * share / 2:.2g}")
        middle = _short_decimal(value, half)
        yield None, curve.last, max(box[0], middle - half), min(box[1], middle + half)
        for place in short:
            upper = Fraction(f"{times[place] * share / 2:.2g}")
            yield place, first + place, -upper / _BACK, upper


def _short_decimal(value: float, unit: Fraction) -> Fraction:
    """Return a short decimal near a value."""
    step = unit / 16
    return round(Fraction(value) / step) * step


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
    mean = sum(abs(float(dwell.mid())) for dwell in times) / len(times)
    for place, dwell in enumerate(times):
        # where it is zero other solutions of the conditions may be
        short = abs(float(dwell.mid())) < _SHORT * mean and (dwell > 0 or dwell < 0)
        if short and holds(partial(curve.divided, place + 1)):
            return place
    return None


MOST_TILES = 2000
_NO_STATE = "the state to resume is not one of this branch"
_NEAR = 1e-5  # how far the orbit may be from the numbers that were given, in their own size


def certify_branch(
    branch: Branch,
    *,
    interval: tuple[object, object] | None = None,
    tiles: int = MOST_TILES,
    beyond: bool = False,
    seconds: float = math.inf,
    resume: CertifiedBranch | None = None,
    progress: Progress = lambda share, tiles: None,
    keep: Callable[[CertifiedBranch], object] | None = None,
) -> CertifiedBranch:
    """Prove all of a branch: that it consists of exactly these intervals and events.

    From the orbit at which the branch was started it is followed both ways in Taylor models, up
    to the ends of the interval. At folds an unknown of the orbit takes the place of the
    parameter. Where the verdict changes there is one event, a zero of a number that passes it
    with a speed that is not zero.

    Parameters
    ----------
    branch : Branch
        Its orbit and its parameter are taken, nothing else.
    interval : tuple of (number or str, number or str), optional
        Ends of the parameter, rational numbers; those of the branch by default.
    tiles : int
        At most so many are proved, those of `resume` among them.
    beyond : bool, default False
        Whether to prove which other itineraries begin where the branch meets a border, and on
        which side.
    seconds : float
        Behind the first tile that ends after this time no other is begun.
    resume : CertifiedBranch, optional
        What was proved before of the same branch.
    progress : function of a float and an int, optional
        Is told about which share is done, and how many tiles there are.
    keep : function of a CertifiedBranch, optional
        Is given the state every ten seconds.

    Returns
    -------
    CertifiedBranch
        `complete` if all of it is proved; else it says what is not.

    Raises
    ------
    InputError
        For what is no branch, an interval that is none or does not hold its orbit, or a state
        that belongs to something else.
    Interrupted
        By Ctrl-C; its `partial` is the state, which `resume` takes.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> branch = ns.continue_orbit(ns.solve("dry-friction/symmetric"), "V", (0.6, 1.3))
    >>> found = ns.certify.branch(branch)
    >>> found.complete, [part.verdict for part in found.intervals]
    (True, ['not admissible', 'unstable', 'stable'])
    >>> [event.kind for event in found.events], found.events[1].enclosures["V"].mid[:20]
    (['grazing', 'flip'], '1.080588074177112019')
    """
    check_integer("tiles", tiles, 1)
    orbit: Orbit = branch.orbit
    box = checked_box(orbit, {branch.parameter: asked_interval(branch, interval, seconds)})
    try:
        orbit, chosen = with_open_ones(orbit, box)
        region = region_of(orbit, box)
        empty = stated_branch(orbit, box, chosen, region)
        content, curve = checked_curve(empty)
        begin = _begin(curve, region)
    except NotCovered as reason:
        found = stated_branch(orbit, box, (), None)
        found = replace(found, ends=(str(reason),) * 2)
        if resume is not None:
            check_same_orbits(found, resume, "parameter", "interval")
        return found
    if resume is not None:
        check_same_orbits(empty, resume, "parameter", "interval")
    work = _Following(curve, begin, resume or empty, branch)
    found = proved_by_steps(work.steps(tiles), lambda: work.state, progress, keep, seconds)
    if not beyond:
        return found
    borders = BordersOfBranch(content, curve, branch, orbit)
    return proved_by_steps(work.with_beyond(borders), lambda: work.state, keep=keep)


def asked_interval(
    branch: Branch, interval: tuple[object, object] | None, seconds: float
) -> tuple[object, object]:
    """Return the interval that is asked for, by default that of a branch; refuse no time for it."""
    if not seconds > 0:
        raise InputError(f"seconds = {seconds!r} is not a positive number")
    if interval is not None:
        return interval
    values = branch.parameter_values
    return as_value(float(values.min())), as_value(float(values.max()))


class _Following:
    """The state of a branch that is followed both ways, tile after tile."""

    def __init__(
        self, curve: CheckedCurve, begin: MarchPlace, state: CertifiedBranch, branch: Branch
    ) -> None:
        self.curve, self.begin, self.state, self.branch = curve, begin, state, branch
        self.share = 0.0
        self.pieces = [0, 0]  # between two points of the branch, on each side: where it has come
        self.outer: list[CheckedTile | None] = [None, None]
        if state.tiles:
            try:
                self.outer = [checked_tile(curve, state.tiles[place]) for place in (0, -1)]
            except REFUSED:
                raise InputError(_NO_STATE) from None

    def steps(self, most: int) -> Steps:
        """Prove at most so many tiles: first towards the beginning, then towards the end.

        The share of the branch that is done and their number are yielded.
        """
        for onwards in (False, True):
            full = len(self.state.tiles) >= most
            if full or self.state.ends[onwards] or self._outwards(onwards):
                continue
            place, join = self._place(onwards), partial(self._join, onwards)
            steps = march(self.curve, place, onwards=onwards, join=join)
            while len(self.state.tiles) < most and (step := next(steps, None)):
                self._take(step, onwards)
                yield self.share, len(self.state.tiles)

    def with_beyond(self, borders: BordersOfBranch) -> Steps:
        """Prove of one tile after another which other itineraries begin at its event."""
        for place, tile in enumerate(self.state.tiles):
            tiles = [*self.state.tiles]
            tiles[place] = borders.with_beyond(tile)
            self.state = replace(self.state, tiles=tuple(tiles))
            yield ()

    def _place(self, onwards: bool) -> MarchPlace:
        """Return the point at which the march goes on, on one side of the branch."""
        state, outer = self.state, self.outer[onwards]
        mine = state.tiles[state.start :] if onwards else state.tiles[: state.start]
        if not mine or outer is None:
            return replace(self.begin, forwards=onwards)
        try:
            return place_behind(outer, onwards=onwards)
        except REFUSED:
            raise InputError(_NO_STATE) from None

    def _outwards(self, onwards: bool) -> bool:
        """Return whether a way leads out of the interval, at an end of which the branch begins."""
        state, value = self.state, rational_of(self.begin.value)
        begun = state.start < len(state.tiles) if onwards else state.start > 0
        return not begun and bool(value == self.curve.interval[onwards])

    def _join(self, onwards: bool, tile: CheckedTile) -> None:
        """Raise `Failure` where a tile is not proved to go on from the one that it follows."""
        outer = self.outer[onwards]
        if outer is not None:
            check_joint(*((outer, tile) if onwards else (tile, outer)))
        with flint_precision(BITS):
            self.curve.check_divisors()

    def _take(self, step: BranchStep, onwards: bool) -> None:
        state = self.state
        if step.tile is not None:
            tile, checked = step.tile
            if onwards:
                state = replace(state, tiles=(*state.tiles, tile))
            else:
                state = replace(state, tiles=(tile, *state.tiles), start=state.start + 1)
            self.outer = [
                checked if own == onwards or self.outer[own] is None else self.outer[own]
                for own in (False, True)
            ]
        ends = [*state.ends]
        ends[onwards] = step.end
        other = self.outer[not onwards]
        if other is not None and self._outwards(not onwards):
            ends[not onwards] = ending(other, last=not onwards)
        self.state = replace(state, ends=(ends[0], ends[1]))
        self._tell(step, onwards)

    def _tell(self, step: BranchStep, onwards: bool) -> None:
        """Update the share of the branch that is done, by the branch in floating point."""
        values, own = self.branch.parameter_values, self.branch.start
        mine = values[own:] if onwards else values[own::-1]
        at, lengths = float(step.place.point[-1].mid()), abs(mine[1:] - mine[:-1])
        total = abs(values[1:] - values[:-1]).sum() or 1.0
        passed = abs(values[1 : own + 1] - values[:own]).sum() if onwards else 0.0
        for piece in range(self.pieces[onwards], len(lengths)):
            if min(mine[piece : piece + 2]) <= at <= max(mine[piece : piece + 2]):
                self.pieces[onwards] = piece
                done = passed + lengths[:piece].sum() + abs(at - mine[piece])
                self.share = max(self.share, min(1.0, float(done / total)))
                break
        if all(self.state.ends):
            self.share = 1.0


def _begin(curve: CheckedCurve, region: Region) -> MarchPlace:
    """Return the orbit from which the branch is followed, sharply enclosed.

    `NotCovered` if it is not proved to be there.
    """
    with flint_precision(SHARP):
        value = arb(rational_of(region.at[0]))
        try:
            found = curve.located(curve.last, value, region.guess)
        except REFUSED:
            reason = "no orbit is proved to exist where the branch was started"
            raise NotCovered(reason) from None
        sizes = [1 + abs(x) for x in region.guess]
        pairs = zip(found, region.guess, sizes, strict=False)
        if not all(abs(x - g) < _NEAR * size for x, g, size in pairs):
            raise NotCovered("Newton's method leaves the orbit that was given")
    slopes = [0.0] * curve.last + [1.0]
    return MarchPlace(curve.last, region.at[0], True, found, slopes)

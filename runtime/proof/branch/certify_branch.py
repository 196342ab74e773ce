"""Certify a branch: every orbit of it, every change of its verdict, and that there is no other."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Any

from nonsmooth.runtime.core.errors import InputError, Interrupted
from nonsmooth.runtime.core.result_files import check_same_question
from nonsmooth.runtime.core.values import Value, as_value, flint_precision
from nonsmooth.runtime.explore.continuation.branch import Branch
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.proof.boxes.orbit_over_box import (
    checked_box,
    region_of,
    with_open_ones,
)
from nonsmooth.runtime.proof.branch.beyond_border import with_beyond
from nonsmooth.runtime.proof.branch.certified_branch import (
    FINISHED,
    VANISHED,
    BranchTile,
    CertifiedBranch,
)
from nonsmooth.runtime.proof.branch.curve import OrbitCurve
from nonsmooth.runtime.proof.branch.march import JOINT, BranchStep, MarchPlace, march
from nonsmooth.runtime.proof.branch.refusals import Refusals
from nonsmooth.runtime.proof.branch.stating import STATED, stated_branch, stated_tile
from nonsmooth.runtime.proof.branch.tube import BranchTube, orbit_at, orbit_near
from nonsmooth.runtime.proof.exact_tables import rational_of
from nonsmooth.runtime.proof.orbit_to_prove import NotCovered

if TYPE_CHECKING:
    from flint import arb

__all__ = ["MOST_TILES", "STATED", "certify_branch"]

MOST_TILES = 2000
_EVERY = 10.0  # seconds between states that are kept
_NEAR = 1e-5  # how far the orbit may be from the numbers that were given, in their own size


def certify_branch(
    branch: Branch,
    *,
    interval: tuple[object, object] | None = None,
    tiles: int = MOST_TILES,
    beyond: bool = False,
    seconds: float = math.inf,
    resume: CertifiedBranch | None = None,
    progress: Callable[[float, int], object] = lambda share, tiles: None,
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
    >>> found = ns.certify_branch(branch)
    >>> found.complete, [part.verdict for part in found.intervals]
    (True, ['not admissible', 'unstable', 'stable'])
    >>> [event.kind for event in found.events], found.events[1].enclosures["V"].mid[:20]
    (['grazing', 'flip'], '1.080588074177112019')
    """
    if not isinstance(branch, Branch):
        raise InputError(f"{branch!r} is no branch, such as continue_orbit gives")
    if isinstance(tiles, bool) or not isinstance(tiles, int) or tiles < 1:
        raise InputError(f"tiles = {tiles!r} is not a positive integer")
    if not seconds > 0:
        raise InputError(f"seconds = {seconds!r} is not a positive number")
    if not isinstance(resume, CertifiedBranch | None):
        raise InputError(f"{resume!r} is no state to resume: load reads one")
    if interval is None:
        values = branch.parameter_values
        interval = as_value(float(values.min())), as_value(float(values.max()))
    orbit: Orbit = branch.orbit
    box = checked_box(orbit, {branch.parameter: interval})
    try:
        orbit, chosen = with_open_ones(orbit, box)
        curve = OrbitCurve(region_of(orbit, box))
        begin = _begin(curve)
        empty = stated_branch(orbit, box, chosen, curve)
        refusals = Refusals(empty)
    except NotCovered as reason:
        found = stated_branch(orbit, box, (), None)
        found = replace(found, ends=(str(reason),) * 2)
        if resume is not None:
            _check_same(found, resume)
        return found
    if resume is not None:
        _check_same(empty, resume)
    work = _Following(curve, begin, resume or empty, branch, refusals)
    kept = begun = time.monotonic()
    try:
        steps = work.steps()
        while len(work.state.tiles) < tiles and next(steps, None) is not None:
            progress(work.share, len(work.state.tiles))
            if keep is not None and time.monotonic() - kept > _EVERY:
                keep(work.state)
                kept = time.monotonic()
            if time.monotonic() - begun > seconds:
                break
        if beyond:
            work.go_beyond(orbit.opened)
    except KeyboardInterrupt:
        raise Interrupted(work.state) from None
    return work.state


class _Following:
    """The state of a branch that is followed both ways, tile after tile."""

    def __init__(
        self, curve: OrbitCurve, begin: list[arb], state: CertifiedBranch, branch: Branch,
        refusals: Refusals,
    ) -> None:  # fmt: skip
        self.curve, self.begin, self.state, self.branch = curve, begin, state, branch
        self.refusals = refusals
        self.share = 0.0
        self.pieces = [0, 0]  # between two points of the branch, on each side: where it has come

    def steps(self) -> Any:
        """Yield the tiles as they are proved: first towards the beginning, then towards the end."""
        for side in (0, 1):
            if self.state.ends[side]:
                continue
            place = self._place(side)
            if place.value in self.curve.region.box[0] and place.coordinate == self.curve.parameter:
                outwards = place.forwards == (place.value == self.curve.region.box[0][1])
                if outwards:
                    self._end(side, FINISHED)
                    if self.state.tiles:
                        self._settle()
                    continue
            for step in march(self.curve, place, partial(self._refused, side)):
                self._take(side, step)
                yield step

    def go_beyond(self, opened: Mapping[str, Value]) -> None:
        """Prove which orbits of other itineraries begin at the borders."""
        for place, tile in enumerate(self.state.tiles):
            found = with_beyond(self.curve, tile, self.branch, opened)
            if found is not tile:
                found = self.refusals.without_refused(found)
            before, behind = self.state.tiles[:place], self.state.tiles[place + 1 :]
            self.state = replace(self.state, tiles=(*before, found, *behind))

    def _place(self, side: int) -> MarchPlace:
        """The point at which the march goes on, on one side of the branch."""
        curve, state = self.curve, self.state
        mine = state.tiles[: state.start] if side == 0 else state.tiles[state.start :]
        if not mine:
            slopes = [0.0] * curve.parameter + [1.0]
            value = curve.region.at[0]
            return MarchPlace(curve.parameter, value, side == 1, self.begin, slopes)
        tile = mine[0] if side == 0 else mine[-1]
        coordinate = curve.names.index(tile.coordinate)
        tube = BranchTube(coordinate, tile.lower, tile.upper, tile.centre, tile.radii)
        forwards = tile.forwards == (side == 1)
        value = tile.upper if forwards else tile.lower
        with flint_precision(JOINT):
            from flint import arb

            equations = curve if tile.divided is None else curve.divided[tile.divided]
            point = orbit_at(equations, tube, arb(rational_of(value)), JOINT)
        if point is None:
            raise InputError("the state to resume is not one of this branch")
        others = tube.slopes(1.0 if forwards else -1.0)
        slopes = [*others[:coordinate], 1.0, *others[coordinate:]]
        return MarchPlace(coordinate, value, forwards, point, slopes)

    def _tile(self, side: int, step: BranchStep) -> BranchTile | None:
        """The tile that states a step; None where nothing is proved."""
        if step.piece is None:
            return None
        forwards = step.forwards == (side == 1)
        return stated_tile(self.curve, step.piece.tube, step.found, step.divided, forwards=forwards)

    def _refused(self, side: int, step: BranchStep) -> str:
        """Why the checker refuses a step behind those that were taken; "" if it does not."""
        tile, tiles = self._tile(side, step), self.state.tiles
        assert tile is not None
        before = tiles[-1] if side == 1 and tiles else None
        after = tiles[0] if side == 0 and tiles else None
        return self.refusals.of_tile(tile, before, after)

    def _take(self, side: int, step: BranchStep) -> None:
        state = self.state
        end = ""
        if step.piece is None:
            end = f"nothing is proved further: {step.found.reason}"
        elif step.place.coordinate == self.curve.parameter and (
            step.place.value in self.curve.region.box[0]
        ):
            end = FINISHED
        elif step.found.ends:
            end = VANISHED
        tile = self._tile(side, step)
        if tile is not None:
            if side == 0:
                state = replace(state, tiles=(tile, *state.tiles), start=state.start + 1)
            else:
                state = replace(state, tiles=(*state.tiles, tile))
        self.state = state
        if end:
            self._end(side, end)
        if tile is not None:
            self._settle()
        self._tell(side, step)

    def _settle(self) -> None:
        """State the ends as the checker proves them; it is asked of each where it refuses both."""
        reached, ends = {FINISHED, VANISHED}, self.state.ends
        if not reached & {*ends} or not self.refusals.of_ends(self.state):
            return
        alone = (ends[0], ""), ("", ends[1])
        first, last = (
            self.refusals.of_ends(replace(self.state, ends=each)) or why if why in reached else why
            for why, each in zip(ends, alone, strict=True)
        )
        self.state = replace(self.state, ends=(first, last))

    def _end(self, side: int, why: str) -> None:
        ends = [*self.state.ends]
        ends[side] = why
        self.state = replace(self.state, ends=(ends[0], ends[1]))

    def _tell(self, side: int, step: BranchStep) -> None:
        """Update the share of the branch that is done, by the branch in floating point."""
        values, own = self.branch.parameter_values, self.branch.start
        mine = values[own::-1] if side == 0 else values[own:]
        at, lengths = float(step.place.point[-1].mid()), abs(mine[1:] - mine[:-1])
        total = abs(values[1:] - values[:-1]).sum() or 1.0
        passed = 0.0 if side == 0 else abs(values[1 : own + 1] - values[:own]).sum()
        for piece in range(self.pieces[side], len(lengths)):
            if min(mine[piece : piece + 2]) <= at <= max(mine[piece : piece + 2]):
                self.pieces[side] = piece
                done = passed + lengths[:piece].sum() + abs(at - mine[piece])
                self.share = max(self.share, min(1.0, float(done / total)))
                break
        if all(self.state.ends):
            self.share = 1.0


def _begin(curve: OrbitCurve) -> list[arb]:
    """An enclosure of the orbit from which the branch is followed, at `JOINT` bits.

    `NotCovered` if it is not proved to be there.
    """
    from flint import arb

    region = curve.region
    with flint_precision(JOINT):
        value = arb(rational_of(region.at[0]))
        found = orbit_near(curve, curve.parameter, value, region.guess, JOINT)
        if found is None:
            raise NotCovered("no orbit is proved to exist where the branch was started")
        sizes = [1 + abs(x) for x in region.guess]
        pairs = zip(found, region.guess, sizes, strict=False)
        if not all(abs(x - g) < _NEAR * size for x, g, size in pairs):
            raise NotCovered("Newton's method leaves the orbit that was given")
    return found


def _check_same(wanted: CertifiedBranch, found: CertifiedBranch) -> None:
    """Refuse to go on with another orbit's branch, or over another interval."""
    names: Sequence[str] = (
        "orbit", "itinerary", "parameter", "interval", "chosen", *wanted.parameters,
        "declaration", "closing",
    )  # fmt: skip
    asked, known = (
        {**vars(each), **each.parameters, "orbit": each.orbit.removeprefix(each.system)}
        for each in (wanted, found)
    )
    check_same_question("state", {name: asked[name] for name in names}, known)

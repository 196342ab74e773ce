"""What is proved of a branch: tiles that follow each other, intervals and events."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import Annotated, Any, ClassVar

from nonsmooth.runtime.core.json_codec import Follows, FromOne, Told, named_as, one_of
from nonsmooth.runtime.core.registry import Certified, registered
from nonsmooth.runtime.proof.boxes.tile_event import Events, Side, WhatHappens
from nonsmooth.runtime.proof.certificate import (
    Decided,
    Stability,
    Stated,
    StatedOrbits,
    ball_of,
)

STATED = 112  # bits of the numbers at an event
NOT_ADMISSIBLE, UNDECIDED = "not admissible", "undecided"  # beside what stability is called
FINISHED = "end of the interval"
VANISHED = "a phase vanishes"
KeptBall = Annotated[Stated, ball_of(STATED)]
_STABILITY = ("stable", "neutral", "unstable")
Verdict = Annotated[str, one_of((*_STABILITY, NOT_ADMISSIBLE, UNDECIDED))]


@dataclass(frozen=True, eq=False, kw_only=True)
class OrbitBeyond:
    """Orbits of another itinerary that begin where a branch meets a border.

    At the event both itineraries have one motion. From there on, as far as its tile goes, there
    is one admissible orbit of the other one for each value of the tile's coordinate.

    Attributes
    ----------
    side : {"above", "below"}
        On which side of the event's parameter they are.
    own : {"above", "below"}
        On which side the branch's own orbits are.
    verdict : {"stable", "neutral", "unstable"}
        Of all of them.
    branch : CertifiedBranch
        One tile of the other itinerary, with the event at which it begins.
    """

    side: Side
    own: Side
    verdict: Annotated[str, one_of(_STABILITY)]
    branch: CertifiedBranch

    @Told
    def scenario(self) -> str:
        """Whether one itinerary follows the other, "persistence", or it is a "nonsmooth fold"."""
        return "nonsmooth fold" if self.side == self.own else "persistence"

    @property
    def itinerary(self) -> tuple[tuple[str, str], ...]:
        """Configurations and boundaries of the other orbits."""
        return self.branch.itinerary

    @Told
    def reach(self) -> float:
        """The parameter up to which they are proved, about."""
        tile = self.branch.tiles[0]
        end = 0 if tile.after == NOT_ADMISSIBLE else 1
        return self.branch.parameter_at(tile)[end]


@dataclass(frozen=True, eq=False, kw_only=True)
class BranchEvent(WhatHappens):
    """A point of a branch where its verdict changes, or where it turns.

    Attributes
    ----------
    kind : str
        "flip", "fold" or "neimark-sacker"; "grazing", "tangent", "entry", "simultaneous" or
        "vanishing-phase"; "condition", of a transition.
    phase : int or None
        Counted from 0, in files from 1.
    configuration, boundary : str
    instant : {"", "start", "inside", "end"}
    lower, upper : Fraction
        It lies between these values of its tile's coordinate.
    window : tuple of Fraction
        Of a grazing, be it one of `also`: between these times of its phase the boundary
        function is concave.
    also : tuple of (str, int, str, str)
        Kind, phase, boundary and instant of what happens within the same bounds; "fold" where
        the branch turns as a phase vanishes.
    enclosures : dict of str to Stated
        The orbit's unknowns and the parameter.
    beyond : tuple of OrbitBeyond
        At a border: other itineraries that begin there, as far as they were asked for and proved.
    """

    lower: Fraction
    upper: Fraction
    window: tuple[Fraction, ...]
    also: Events
    enclosures: Mapping[str, KeptBall]
    beyond: tuple[OrbitBeyond, ...] = field(default=(), repr=False)


@dataclass(frozen=True, eq=False, kw_only=True)
class BranchTile:
    """A piece of a branch, in the order in which it is passed.

    Attributes
    ----------
    coordinate : str
        The parameter, or an unknown, that tells its orbits from each other.
    lower, upper : Fraction
        Ends of the coordinate.
    forwards : bool
        Whether the coordinate increases along the branch.
    before, after : str
        Verdicts up to its event and behind it; the same without one. "stable" or "neutral",
        "unstable", "not admissible" or "undecided".
    reason : str
        Why it is undecided.
    centre : tuple of tuple of float
        Polynomials of the other coordinates: coefficients by e, which runs from -1 to 1 between
        the ends. Empty where no orbit is proved to exist.
    radii : tuple of float
        There is exactly one orbit as near to these as they tell.
    event : BranchEvent or None
    divided : int or None
        The phase whose switching condition is divided by its dwell time, as it may vanish;
        counted from 0, in files from 1.
    """

    coordinate: str
    lower: Fraction
    upper: Fraction
    forwards: bool
    before: Verdict
    after: Verdict
    reason: str
    centre: tuple[tuple[float, ...], ...] = field(repr=False)
    radii: tuple[float, ...] = field(repr=False)
    event: BranchEvent | None
    divided: FromOne


@dataclass(frozen=True, eq=False)
class BranchInterval:
    """A part of a branch with one verdict.

    Attributes
    ----------
    verdict : str
    begin, end : float
        Of the parameter, about: at an event, or at the end of what was followed.
    tiles : int
        On how many it is proved.
    reason : str
        Why it is undecided.
    """

    verdict: str
    begin: float
    end: float
    tiles: int
    reason: str = ""

    @Told
    def width(self) -> float:
        """How far the parameter changes."""
        return abs(self.end - self.begin)


class DrawnOverParameter(Certified):
    """A result that is drawn over a parameter; `_drawn_by` names the function that draws it."""

    _drawn_by: ClassVar[str]

    def plot(self, quantity: str | None = None, axes: Any = None) -> Any:
        """Draw an unknown over the parameter: intervals in colours, events marked.

        Parameters
        ----------
        quantity : str, optional
            By default the last dwell time of a branch; of a doubling the unknown by which the
            halves of the doubled orbits are told apart.
        axes : matplotlib Axes, optional
            Where to draw; a figure of its own by default.

        Returns
        -------
        matplotlib Figure or Axes
            The figure, or the Axes that were given.

        Raises
        ------
        InputError
            If the branch has no such unknown.
        MissingExtra
            Without matplotlib: ``pip install "nonsmooth[plot]"``.
        """
        return registered(self._drawn_by)(self, quantity, axes)


@dataclass(frozen=True, eq=False, kw_only=True, repr=False)
class CertifiedBranch(DrawnOverParameter, StatedOrbits):
    """What ball arithmetic proves of a branch over an interval of its parameter.

    The branch is the union of its tiles. In each there is exactly one orbit of the itinerary's
    equations, in a tube around polynomials, for each value of the tile's coordinate; where two
    tiles meet their orbits are the same. A verdict holds for all orbits of a tile. A tile with
    an event has a verdict on each side of it, and the event is one point between its bounds.

    Attributes
    ----------
    orbit, system : str
    parameters : dict of str to Value
        All that was given for the orbit, beside the branch's parameter.
    chosen : tuple of str
        Parameters that the orbit leaves open and that were chosen.
    itinerary : tuple of (configuration, boundary)
    parameter : str
    interval : tuple of (Fraction, Fraction)
    stability : {"stable", "neutral"}
        What an admissible orbit is called whose multipliers are where they should be.
    unknown_names : tuple of str
        Coordinates of the orbits: physical start, forcing's time, dwell times.
    tiles : tuple of BranchTile
        In the order of the branch.
    start : int
        How many of them lie before the orbit from which it was followed.
    ends : tuple of (str, str)
        Why it ends, at its beginning and at its end; empty where it was not followed further.
        "a phase vanishes": there its last orbit is, beyond it the phase would last less than
        no time and the parameter goes back.
    declaration, closing : dict
        As in a `BoxCertificate`, over the parameter and those that were given.
    """

    _drawn_by = "draw_certified_branch"

    parameter: str
    interval: tuple[Fraction, Fraction]
    stability: Stability
    unknown_names: tuple[str, ...]
    tiles: tuple[BranchTile, ...] = field(repr=False)
    start: int
    ends: tuple[str, str]

    @Told
    def events(self) -> tuple[BranchEvent, ...]:
        """What happens, in the order of the branch."""
        return tuple(tile.event for tile in self.tiles if tile.event is not None)

    @Told
    def intervals(self) -> tuple[BranchInterval, ...]:
        """Parts with one verdict: an event is between any two that are decided."""
        parts: list[BranchInterval] = []
        for tile in self.tiles:
            begin, end = self.parameter_at(tile)
            at = end if tile.event is None else float(tile.event.enclosures[self.parameter])
            if parts and parts[-1].verdict == tile.before:
                parts[-1] = replace(parts[-1], end=at, tiles=parts[-1].tiles + 1)
            else:
                reason = tile.reason if tile.event is None else ""
                parts.append(BranchInterval(tile.before, begin, at, 1, reason))
            if tile.event is not None:
                parts.append(BranchInterval(tile.after, at, end, 1))
        return tuple(parts)

    def parameter_at(self, tile: BranchTile) -> tuple[float, float]:
        """The parameter where a tile begins and ends, about.

        Parameters
        ----------
        tile : BranchTile
            One of `tiles`.

        Returns
        -------
        tuple of (float, float)
            In the order of the branch.
        """
        if tile.coordinate == self.parameter or not tile.centre:
            ends = [float(tile.lower), float(tile.upper)]
            if tile.coordinate != self.parameter:
                ends = [float("nan")] * 2
        else:
            row = tile.centre[-1]
            ends = [sum(c * e**k for k, c in enumerate(row)) for e in (-1.0, 1.0)]
        begin, end = ends if tile.forwards else ends[::-1]
        return begin, end

    @property
    def undecided(self) -> tuple[BranchInterval, ...]:
        """Parts of which nothing is decided, with their widths and reasons."""
        return tuple(part for part in self.intervals if part.verdict == UNDECIDED)

    @property
    def complete(self) -> bool:
        """Whether it consists of exactly these intervals and events, all proved."""
        there = all(end in (FINISHED, VANISHED) for end in self.ends)
        return bool(self.tiles) and there and not self.undecided

    @Follows
    def claims(self) -> Annotated[dict[str, str], named_as(("branch",), Decided)]:
        """What is claimed of all of it: "proved" where it is complete."""
        return {"branch": "proved" if self.complete else UNDECIDED}

    @Told
    def statement(self) -> str:
        """What is proved, in one sentence."""
        low, high = self.interval
        parts = []
        events = iter(self.events)
        for before, part in enumerate(self.intervals):
            if before and self.intervals[before - 1].verdict != UNDECIDED != part.verdict:
                event = next(events)
                parts.append(f"{event.kind} at {event.enclosures[self.parameter]}")
                parts += [_told_beyond(beyond) for beyond in event.beyond]
            told = f"{part.verdict} from {part.begin:.10g} to {part.end:.10g}"
            if part.verdict == UNDECIDED:
                told = f"undecided from {part.begin:.17g} on, {part.width:.3g} wide"
            parts.append(told)
        over = f"for {self.parameter} in [{float(low):.10g}, {float(high):.10g}]"
        if self.complete:
            return f"{over} the branch consists of exactly: {'; '.join(parts)}"
        return f"{over} it is not decided what the branch consists of; proved: {'; '.join(parts)}"


def _told_beyond(found: OrbitBeyond) -> str:
    """A phrase: which orbits begin at an event, on which side, and how far they are proved."""
    alone = len({configuration for configuration, _ in found.itinerary}) == 1
    way = " -> ".join(f"{c} ({b})" if alone else c for c, b in found.itinerary)
    return (
        f"there {way} begins, {found.verdict}, {found.side} it up to {found.reach:.10g}"
        f" ({found.scenario})"
    )

"""What is proved of a branch: tiles that follow each other, intervals and events, and flips.

An event may be enclosed by itself, and a flip have orbits of twice the period beyond it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import Annotated, Any, ClassVar, Literal

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.json_codec import (
    Follows,
    FromOne,
    Ordinal,
    Several,
    Told,
    named_as,
    one_of,
)
from nonsmooth.runtime.core.registry import Certified, registered
from nonsmooth.runtime.core.values import Value
from nonsmooth.runtime.model.kernels import known_system
from nonsmooth.runtime.model.saved_system import named
from nonsmooth.runtime.proof.boxes.tile import Events, Instant, Side, WhatHappens
from nonsmooth.runtime.proof.certificate import (
    Decided,
    Enclosures,
    Stability,
    Stated,
    StatedOrbits,
    Unknown,
    ball_of,
    precise,
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


Ended = Literal["complete", "unfinished", "no flip", "not covered", "not proved"]


@dataclass(frozen=True, eq=False, kw_only=True)
class DoubledOrbits:
    """The orbits of twice the period next to a flip of a branch.

    The unknowns of the orbit's two halves are m + a w and m - a w. For each amplitude a up to the
    largest there is exactly one such orbit in a tube around polynomials of a; where a is zero it
    is the flip. The parameter changes in one direction all along it.
    """

    tile: Ordinal  # number of the tile of the flip's branch that holds the flip, from 0
    scaled: str  # the unknown whose entry of w is 1: its halves are 2 a apart
    amplitude: Fraction  # the largest a
    side: Side  # of the flip's parameter, where the doubled orbits are
    # "stable", "unstable" or "undecided": all doubled orbits in the tube whose amplitude is not
    # zero
    verdict: Annotated[str, one_of(("stable", "unstable", UNDECIDED))]
    reason: str  # why it is undecided
    rate: KeptBall  # derivative of the parameter by the square of a, at the flip
    # coefficients by e = a / amplitude of m, of w without its entry 1, and of the parameter
    centre: tuple[tuple[float, ...], ...] = field(repr=False)
    radii: tuple[float, ...] = field(repr=False)
    branch: CertifiedBranch = field(repr=False)  # from inside the tube on


@dataclass(frozen=True, kw_only=True)
class DoublingEntries:
    """Entries for the branch with the flip, and what its orbit is called."""

    orbit: str
    branch: CertifiedBranch


def _entries(orbit: str, branch: CertifiedBranch) -> DoublingEntries:
    """The entries, where the orbit's system is called as the file calls that of the branch."""
    own = orbit.removeprefix(branch.system)
    label = branch.orbit.removeprefix(f"{branch.system}:")
    known = known_system(branch.system, None if label == branch.orbit else label)
    return DoublingEntries(
        orbit=orbit if own == orbit else named(known, branch.orbit)[0] + own, branch=branch
    )


@dataclass(frozen=True, eq=False, kw_only=True, repr=False)
class CertifiedDoubling(DrawnOverParameter):
    """What ball arithmetic proves beyond a flip: orbits of twice the period.

    Attributes
    ----------
    orbit : str
        The orbit whose branch has the flip.
    ended : {"complete", "unfinished", "no flip", "not covered", "not proved"}
        Whether it is all there, or why not: time or Ctrl-C ended the work, and `resume` goes
        on; the branch has no flip that is proved; such orbits are not covered; or a step is not
        proved.
    branch : CertifiedBranch
        The branch with the flip.
    doubled : DoubledOrbits or None
        The orbits beside the flip and, as its `branch`, how they go on.
    end : str
        Why it is not complete, in a sentence; empty where it is.
    """

    _drawn_by = "draw_doubling"

    orbit: Annotated[
        str,
        Several(
            DoublingEntries, _entries, lambda own: (own.orbit, own.branch), ("orbit", "branch")
        ),
    ]
    ended: Ended
    branch: CertifiedBranch = field(repr=False)
    doubled: DoubledOrbits | None
    end: str

    @Told
    def system(self) -> str:
        """Its system."""
        return self.branch.system

    @property
    def parameters(self) -> Mapping[str, Value]:
        """All that is given beside the branch's parameter."""
        return self.branch.parameters

    @Told
    def parameter(self) -> str:
        """The parameter along which the branches go."""
        return self.branch.parameter

    @property
    def flip(self) -> BranchEvent | None:
        """The flip, where the doubled orbits beside it are proved."""
        return None if self.doubled is None else self.branch.tiles[self.doubled.tile].event

    @Follows
    def claims(self) -> Annotated[dict[str, str], named_as(("doubling",), Decided)]:
        """Of the doubling: "proved" where it is there, with a verdict."""
        decided = self.doubled is not None and self.doubled.verdict != UNDECIDED
        return {"doubling": "proved" if decided else UNDECIDED}

    @Told
    def kind(self) -> str:
        """Whether the flip is "supercritical" or "subcritical"; empty where neither is told.

        It is supercritical where the doubled orbits are stable; subcritical where they are
        unstable and the orbit is stable on one side.
        """
        if self.doubled is None:
            return ""
        if self.doubled.verdict == "stable":
            return "supercritical"
        tile = self.branch.tiles[self.doubled.tile]
        beside = (tile.before, tile.after)
        return "subcritical" if self.doubled.verdict == "unstable" and "stable" in beside else ""

    @Told
    def statement(self) -> str:
        """What is proved, in one sentence, and why it is not complete."""
        doubled, flip = self.doubled, self.flip
        if doubled is None or flip is None:
            return self.end
        begin, end = _reach(doubled.branch)
        words = f" is {self.kind}:" if self.kind else ":"
        verdict = (
            f"orbits of twice the period ({doubled.reason})"
            if doubled.verdict == UNDECIDED
            else f"{doubled.verdict} orbits of twice the period"
        )
        told = (
            f"the flip at {self.parameter} = {flip.enclosures[self.parameter]}{words}"
            f" {doubled.side} it there are {verdict}, one for each value up to {begin:.10g}, and"
            f" they are followed to {end:.10g}"
        )
        return f"{told}; {self.end}" if self.end else told

    def to_json(self) -> dict[str, Any]:
        """Give the doubling as JSON, with the parameter at the flip.

        Returns
        -------
        dict
            Ready for `json.dumps`.
        """
        value = None if self.flip is None else self.flip.enclosures[self.parameter].to_json()
        return {**super().to_json(), "flip": value}


def _reach(branch: CertifiedBranch) -> tuple[float, float]:
    """Return the parameters, about, from which and up to which a doubled branch is proved."""
    if not branch.tiles:
        ends = [float(end) for end in branch.interval]
        return ends[0], ends[0]
    forwards = branch.start == 0
    first, last = branch.tiles[0], branch.tiles[-1]
    if forwards:
        return branch.parameter_at(first)[0], branch.parameter_at(last)[1]
    return branch.parameter_at(last)[1], branch.parameter_at(first)[0]


@dataclass(frozen=True, eq=False, kw_only=True, repr=False)
class EventCertificate(StatedOrbits):
    """An event of a branch, enclosed by ball arithmetic.

    Attributes
    ----------
    orbit, system : str
    parameters : dict of str to Value
        All that was given for an orbit near it, beside the branch's parameter.
    chosen : tuple of str
        Parameters that the orbit leaves open and that were chosen.
    itinerary : tuple of (configuration, boundary)
        Empty where the equations were not set up.
    kind, text : str
        Of the event, as in `Event`.
    parameter : str
    phase : int or None
        Counted from 0; in JSON from 1.
    configuration, boundary : str
    instant : {"", "start", "inside", "end"}
        Of that phase, where it happens at one.
    claim : {"proved", "undecided"}
        The box contains at least one such event, and all that it contains lie in the
        enclosures.
    reason : str
        Why it is undecided.
    enclosures : dict of str to Stated
        The parameter, and the unknowns of the orbit's equations: physical start and dwell times.
    box : tuple of Unknown
        The unknowns of the orbit's equations, the parameter, and for a grazing its time.
    bits : int
    declaration, closing : dict
        As in a `BoxCertificate`, over the parameter and those that were given.
    """

    kind: str
    text: str
    parameter: str
    phase: FromOne
    configuration: str
    boundary: str
    instant: Instant
    claim: Decided
    reason: str
    enclosures: Enclosures
    box: tuple[Unknown, ...]
    bits: int

    def __post_init__(self) -> None:
        object.__setattr__(self, "enclosures", precise(self.enclosures, self.bits))

    @property
    def proved(self) -> bool:
        """Whether there is such an event."""
        return self.claim == "proved"

    @property
    def value(self) -> Stated:
        """Enclosure of the parameter.

        Raises
        ------
        InputError
            If the event is undecided.
        """
        if not self.proved:
            raise InputError(f"the {self.kind} is undecided and has no value: {self.reason}")
        return self.enclosures[self.parameter]


@dataclass(frozen=True, kw_only=True)
class EventCertificates:
    """The certificates of one file, in its order."""

    events: tuple[EventCertificate, ...]


def events_claim(found: Sequence[EventCertificate]) -> dict[str, str]:
    """Return the claim of all events: "proved" if each of them is, else "undecided"."""
    proved = all(certificate.proved for certificate in found)
    return {"events": "proved" if proved else "undecided"}

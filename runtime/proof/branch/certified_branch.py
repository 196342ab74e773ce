"""What is proved of a branch: tiles that follow each other, intervals and events."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from fractions import Fraction
from functools import cached_property
from typing import Any, ClassVar

from nonsmooth.runtime.core.registry import Kept, registered
from nonsmooth.runtime.core.values import Value
from nonsmooth.runtime.proof.certificate import Stated, balls_json, orbit_json

__all__ = [
    "FINISHED",
    "NOT_ADMISSIBLE",
    "STATED",
    "UNDECIDED",
    "VANISHED",
    "BranchEvent",
    "BranchInterval",
    "BranchTile",
    "CertifiedBranch",
    "DrawnOverParameter",
    "OrbitBeyond",
    "event_json",
    "tile_json",
    "told_json",
]

STATED = 112  # bits of the numbers at an event
NOT_ADMISSIBLE, UNDECIDED = "not admissible", "undecided"  # beside what stability is called
FINISHED = "end of the interval"
VANISHED = "a phase vanishes"


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

    side: str
    own: str
    verdict: str
    branch: CertifiedBranch

    @property
    def scenario(self) -> str:
        """Whether one itinerary follows the other, "persistence", or it is a "nonsmooth fold"."""
        return "nonsmooth fold" if self.side == self.own else "persistence"

    @property
    def itinerary(self) -> tuple[tuple[str, str], ...]:
        """Configurations and boundaries of the other orbits."""
        return self.branch.itinerary

    @property
    def reach(self) -> float:
        """The parameter up to which they are proved, about."""
        tile = self.branch.tiles[0]
        end = 0 if tile.after == NOT_ADMISSIBLE else 1
        return self.branch.parameter_at(tile)[end]


@dataclass(frozen=True, eq=False, kw_only=True)
class BranchEvent:
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

    kind: str
    phase: int | None
    configuration: str
    boundary: str
    instant: str
    lower: Fraction
    upper: Fraction
    window: tuple[Fraction, ...]
    also: tuple[tuple[str, int, str, str], ...]
    enclosures: Mapping[str, Stated]
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
    before: str
    after: str
    reason: str
    centre: tuple[tuple[float, ...], ...] = field(repr=False)
    radii: tuple[float, ...] = field(repr=False)
    event: BranchEvent | None
    divided: int | None = None


@dataclass(frozen=True, eq=False, kw_only=True)
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

    @property
    def width(self) -> float:
        """How far the parameter changes."""
        return abs(self.end - self.begin)


class DrawnOverParameter(Kept):
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
class CertifiedBranch(DrawnOverParameter):
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

    _kept_by, _drawn_by = "save_certified_branch", "draw_certified_branch"

    orbit: str
    system: str
    parameters: Mapping[str, Value]
    chosen: tuple[str, ...]
    itinerary: tuple[tuple[str, str], ...]
    parameter: str
    interval: tuple[Fraction, Fraction]
    stability: str
    unknown_names: tuple[str, ...]
    tiles: tuple[BranchTile, ...] = field(repr=False)
    start: int
    ends: tuple[str, str]
    declaration: Mapping[str, Any] = field(repr=False)
    closing: Mapping[str, Any] = field(repr=False)

    @property
    def events(self) -> tuple[BranchEvent, ...]:
        """What happens, in the order of the branch."""
        return tuple(tile.event for tile in self.tiles if tile.event is not None)

    @cached_property
    def intervals(self) -> tuple[BranchInterval, ...]:
        """Parts with one verdict: an event is between any two that are decided."""
        runs: list[list[Any]] = []  # verdict, begin, end, tiles, reason
        for tile in self.tiles:
            begin, end = self.parameter_at(tile)
            if tile.event is None:
                if runs and runs[-1][0] == tile.before and not runs[-1][5]:
                    runs[-1][2] = end
                    runs[-1][3] += 1
                else:
                    runs.append([tile.before, begin, end, 1, tile.reason, False])
                continue
            at = float(tile.event.enclosures[self.parameter])
            if runs and runs[-1][0] == tile.before and not runs[-1][5]:
                runs[-1][2] = at
                runs[-1][3] += 1
            else:
                runs.append([tile.before, begin, at, 1, "", False])
            runs[-1][5] = True
            runs.append([tile.after, at, end, 1, "", False])
        return tuple(
            BranchInterval(verdict=v, begin=b, end=e, tiles=n, reason=r)
            for v, b, e, n, r, _ in runs
        )

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

    @property
    def claims(self) -> dict[str, str]:
        """What is claimed of all of it: "proved" where it is complete."""
        return {"branch": "proved" if self.complete else UNDECIDED}

    @property
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

    def to_json(self) -> dict[str, Any]:
        """Give the branch as JSON: numbers as decimal strings or fractions.

        Returns
        -------
        dict
            What is proved, ready for `json.dumps`.
        """
        return {
            **orbit_json(self),
            "chosen": list(self.chosen),
            "parameter": self.parameter,
            "interval": [str(end) for end in self.interval],
            "stability": self.stability,
            "unknown_names": list(self.unknown_names),
            "claims": self.claims,
            "start": self.start,
            "ends": list(self.ends),
            "tiles": [tile_json(tile) for tile in self.tiles],
        }


def _told_beyond(found: OrbitBeyond) -> str:
    """A phrase: which orbits begin at an event, on which side, and how far they are proved."""
    alone = len({configuration for configuration, _ in found.itinerary}) == 1
    way = " -> ".join(f"{c} ({b})" if alone else c for c, b in found.itinerary)
    return (
        f"there {way} begins, {found.verdict}, {found.side} it up to {found.reach:.10g}"
        f" ({found.scenario})"
    )


def event_json(event: BranchEvent) -> dict[str, Any]:
    """An event as JSON; phases are counted from 1."""
    return {
        "kind": event.kind,
        "phase": None if event.phase is None else event.phase + 1,
        "configuration": event.configuration,
        "boundary": event.boundary,
        "instant": event.instant,
        "lower": str(event.lower),
        "upper": str(event.upper),
        "window": [str(time) for time in event.window],
        "also": [[kind, phase + 1, *rest] for kind, phase, *rest in event.also],
        "enclosures": balls_json(event.enclosures),
        **({"beyond": [_beyond_json(beyond) for beyond in event.beyond]} if event.beyond else {}),
    }


def _beyond_json(found: OrbitBeyond) -> dict[str, Any]:
    return {
        "side": found.side,
        "own": found.own,
        "verdict": found.verdict,
        "scenario": found.scenario,
        "reach": found.reach,
        "branch": found.branch.to_json(),
    }


def told_json(found: CertifiedBranch) -> dict[str, Any]:
    """Statement, intervals and events of a branch as a dict ready for `json.dumps`."""
    return {
        "statement": found.statement,
        "intervals": [{**asdict(part), "width": part.width} for part in found.intervals],
        "events": [event_json(event) for event in found.events],
    }


def tile_json(tile: BranchTile) -> dict[str, Any]:
    """A tile as JSON; phases are counted from 1."""
    return {
        "coordinate": tile.coordinate,
        "lower": str(tile.lower),
        "upper": str(tile.upper),
        "forwards": tile.forwards,
        "before": tile.before,
        "after": tile.after,
        "reason": tile.reason,
        "centre": [list(row) for row in tile.centre],
        "radii": list(tile.radii),
        "event": None if tile.event is None else event_json(tile.event),
        "divided": None if tile.divided is None else tile.divided + 1,
    }

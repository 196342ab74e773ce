"""Events along a branch: what happens at a point, what each kind means, and what shows it.

A new kind is one entry of `KINDS`. Kinds that the multipliers and the tangent show have a test
function here; those of boundaries and conditions are watched phase by phase (`monitors_of`).
Functions of folds, flips and Neimark-Sacker bifurcations are the usual ones (Y. Kuznetsov, Elements
of Applied Bifurcation Theory, 1995).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from itertools import combinations
from typing import Annotated

import numpy as np

from nonsmooth.runtime.core.json_codec import FromOne, one_of
from nonsmooth.runtime.core.registry import Shown
from nonsmooth.runtime.events.boundary_functions import PhaseWaves, ends_of, interior_maxima
from nonsmooth.runtime.orbits.equations import OrbitEquations

_NEAR = 1e-6  # how near to the unit circle a pair of multipliers has to be at its event
_NEAR_ONE = 1e-3  # how near to -1 or 1 a multiplier has to be: there it may be double
_ZERO = 1e-9  # relative size below which a boundary function counts as zero at an end
_SAMPLES = 7  # points at which is looked for what is zero all along


@dataclass(frozen=True)
class EventKind:
    """One kind of event."""

    text: str  # what happens, in words
    # function of multipliers (k, r), slopes (k,) and the branch's equations whose values (k,)
    # change sign at the event; a slope is the parameter's part of the unit tangent; None where
    # boundaries and conditions show the event, and the itinerary changes
    test: Callable[[np.ndarray, np.ndarray, OrbitEquations], np.ndarray] | None = None
    # whether the event can happen on such a branch with so many multipliers
    watched: Callable[[int, OrbitEquations], bool] = lambda count, curve: count > 0
    # function of multipliers (r,): whether a sign change is the event, not a pole or a neutral
    # saddle
    holds: Callable[[np.ndarray], bool] = lambda multipliers: True
    switches: bool = False  # whether another branch meets this one there


def _at_minus_one(multipliers: np.ndarray, slopes: np.ndarray, curve: OrbitEquations) -> np.ndarray:
    found: np.ndarray = (1 + multipliers).prod(axis=-1).real
    return found


def _at_one(multipliers: np.ndarray, slopes: np.ndarray, curve: OrbitEquations) -> np.ndarray:
    """The product of 1 - multiplier, divided by the slope, with which it changes sign at a fold."""
    found: np.ndarray = (1 - multipliers).prod(axis=-1).real
    return found if curve.conservative else found / slopes


def _pairs(multipliers: np.ndarray, slopes: np.ndarray, curve: OrbitEquations) -> np.ndarray:
    """The product of 1 - m1 m2 over all pairs of multipliers m1, m2."""
    found: np.ndarray = 1 + 0 * multipliers[:, 0]
    for i, j in combinations(range(multipliers.shape[-1]), 2):
        found = found * (1 - multipliers[:, i] * multipliers[:, j])
    return found.real


def _near(target: float) -> Callable[[np.ndarray], bool]:
    return lambda multipliers: bool((abs(multipliers - target) < _NEAR_ONE).any())


def _on_unit_circle(multipliers: np.ndarray) -> bool:
    near = abs(abs(multipliers) - 1) < _NEAR
    return bool((near & (abs(multipliers.imag) > _NEAR)).any())


KINDS = {
    "fold": EventKind("the branch turns", lambda _, slopes, __: slopes, lambda *_: True),
    "flip": EventKind(
        "a multiplier is -1: an orbit of twice the period branches off",
        _at_minus_one,
        lambda count, curve: count > 0 and curve.order != 2,
        _near(-1),
        switches=True,
    ),
    "neimark-sacker": EventKind(
        "a pair of multipliers is on the unit circle: a torus branches off",
        _pairs,
        lambda count, curve: count > 1 and not curve.conservative,
        _on_unit_circle,
    ),
    "branch-point": EventKind(
        "a multiplier is 1: another branch crosses", _at_one, holds=_near(1), switches=True
    ),
    "symmetry-breaking": EventKind(
        "a pair of orbits without the symmetry branches off",
        _at_minus_one,
        lambda count, curve: count > 0 and curve.order == 2,
        _near(-1),
        switches=True,
    ),
    "grazing": EventKind("a boundary is touched inside a phase"),
    "tangent": EventKind("a phase leaves its boundary, or reaches it, without speed"),
    "entry": EventKind("a boundary is already reached where a phase begins"),
    "simultaneous": EventKind("another boundary is reached at the same instant"),
    "condition": EventKind("a condition of a transition just holds"),
    "vanishing-phase": EventKind("a dwell time shrinks to zero"),
    "admissibility": EventKind("the orbit ceases to be a motion of the real system"),
}


@dataclass(frozen=True, kw_only=True, repr=False)
class Event(Shown):
    """A point of a branch where something happens.

    Attributes
    ----------
    kind : str
        What happens: "fold", "flip", "neimark-sacker", "branch-point" or "symmetry-breaking",
        which multipliers show; "grazing", "tangent", "entry", "simultaneous", "condition",
        "vanishing-phase" or "admissibility", which boundaries show.
    parameter : str
    value : float
        Of the parameter.
    unknowns : dict of str to float
    phase : int or None
        Counted from 0, in files from 1, where it is a matter of one.
    configuration, boundary : str
        Of that phase; empty otherwise.
    time : float or None
        Since that phase began.
    place : float
        On the branch: between its points with the numbers before and behind it.
    text : str
        All of it in words.
    touching : bool
        Whether what happens is undone at once: a multiplier comes to the unit circle and turns
        back, a boundary is touched at this value alone.
    """

    kind: Annotated[str, one_of(tuple(KINDS))]
    parameter: str
    value: float
    unknowns: Mapping[str, float]
    phase: FromOne
    configuration: str
    boundary: str
    time: float | None
    place: float
    text: str
    touching: bool = False

    @property
    def border_collision(self) -> bool:
        """Whether the itinerary changes here."""
        return KINDS[self.kind].test is None

    @property
    def switches(self) -> bool:
        """Whether another branch meets this one here: `Branch.switch` leads to it."""
        return KINDS[self.kind].switches and not self.touching


def point_of(event: Event) -> np.ndarray:
    """The point z = (unknowns, parameter) of an event, (n + 1,)."""
    return np.array([*event.unknowns.values(), event.value])


@dataclass(frozen=True)
class Monitor:
    """A watched function: its event's kind, phase and boundary, and where its values are."""

    kind: str
    phase: int = -1
    boundary: str = ""
    source: str = ""
    column: int = 0


@dataclass(frozen=True)
class Monitors:
    """All functions that are watched along a branch."""

    curve: OrbitEquations
    smooth: tuple[Monitor, ...]  # functions of the multipliers and the tangent
    borders: tuple[Monitor, ...]  # functions of boundaries and conditions

    def smooth_values(self, z: np.ndarray, tangents: np.ndarray) -> np.ndarray:
        """Values (k, m) of the smooth functions at points (k, n + 1).

        The unit tangents (k, n + 1) are in the curve's units.
        """
        multipliers, slopes = self.curve.multipliers(z), tangents[:, -1]
        tests = [KINDS[monitor.kind].test for monitor in self.smooth]
        with np.errstate(all="ignore"):  # a slope may be zero
            values = [test(multipliers, slopes, self.curve) for test in tests if test is not None]
        return np.stack(values, axis=-1)

    def border_values(self, z: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Values and times since the start of the phase, both (k, m), at points (k, n + 1).

        They are NaN where the function does not exist.
        """
        values = np.full((len(z), len(self.borders)), np.nan)
        times = np.full((len(z), len(self.borders)), np.nan)
        conditions = self.curve.conditions(z)
        for places, phases in self.curve.waves(z):
            known = {waves.phase: _border(waves) for waves in phases}
            for column, monitor in enumerate(self.borders):
                found = known[monitor.phase]
                if monitor.source == "condition":
                    values[places, column] = conditions[places, monitor.column]
                    times[places, column] = found["leaving"][1][:, 0]
                    continue
                numbers, when = found[monitor.source]
                values[places, column] = numbers[:, monitor.column]
                times[places, column] = when[:, monitor.column]
        return values, times

    def value(self, monitor: Monitor, z: np.ndarray, tangent: np.ndarray) -> float:
        """Value of one function at a point (n + 1,) with a unit tangent (n + 1,)."""
        if monitor.source:
            return self.at_border(monitor, z)[0]
        values = self.smooth_values(z[None], tangent[None])
        return float(values[0, self.smooth.index(monitor)])

    def at_border(self, monitor: Monitor, z: np.ndarray) -> tuple[float, float]:
        """Value of one function of a boundary or condition at a point (n + 1,), and its time."""
        values, times = self.border_values(z[None])
        place = 0, self.borders.index(monitor)
        return float(values[place]), float(times[place])

    def confirmed(self, monitor: Monitor, z: np.ndarray) -> bool:
        """Whether a zero at z (n + 1,) is the event, and not a pole or a neutral saddle."""
        kind = KINDS[monitor.kind]
        return kind.test is None or kind.holds(self.curve.multipliers(z[None])[0])


def _border(waves: PhaseWaves) -> dict[str, tuple[np.ndarray, np.ndarray]]:
    """Values and times (k, b) by source."""
    ends, (highest, when) = ends_of(waves), interior_maxima(waves)
    begun = np.zeros_like(highest)
    over = np.broadcast_to(waves.durations[:, None], highest.shape)
    return {
        "highest": (highest, when),
        "start": (ends.starts[0], begun),
        "beginning": (ends.starts[1], begun),
        "stop": (ends.stops[0], over),
        "leaving": (ends.stops[1], over),
    }


def monitors_of(curve: OrbitEquations, points: np.ndarray) -> Monitors:
    """The functions to watch along a branch with points (k, n + 1).

    A boundary function that vanishes at an end of a phase along the whole branch is the
    boundary with which the phase begins or ends: its rate is watched instead.
    """
    some = points[np.unique(np.linspace(0, len(points) - 1, _SAMPLES).astype(int))]
    count = curve.multipliers(some).shape[-1]
    smooth = tuple(
        Monitor(name)
        for name, kind in KINDS.items()
        if kind.test is not None and kind.watched(count, curve)
    )
    groups = [phases for _, phases in curve.waves(some)]
    borders: list[Monitor] = []
    for number, waves in enumerate(groups[0]):
        ends = [ends_of(phases[number]) for phases in groups]
        begun = _always_zero([(end.starts, end.sizes) for end in ends])
        over = _always_zero([(end.stops, end.sizes) for end in ends])
        for place, name in enumerate(waves.names):
            watched = waves.phase, name
            borders.append(Monitor("grazing", *watched, "highest", place))
            if waves.leaving is None:
                continue  # the motion goes on: no end is one of its own
            if not begun[0, place]:
                borders.append(Monitor("entry", *watched, "start", place))
            elif not begun[1, place]:
                borders.append(Monitor("tangent", *watched, "beginning", place))
            if place == waves.leaving:
                borders.append(Monitor("tangent", *watched, "leaving", place))
            elif not over[0, place]:
                borders.append(Monitor("simultaneous", *watched, "stop", place))
    for column, phase in enumerate(curve.condition_places):
        watched = phase, curve.phases[phase][1]
        borders.append(Monitor("condition", *watched, "condition", column))
    return Monitors(curve, smooth, tuple(borders))


def _always_zero(groups: list[tuple[np.ndarray, np.ndarray]]) -> np.ndarray:
    """Mask (2, b) of the functions and rates that are zero at all points, by their sizes."""
    zero = [abs(values) <= _ZERO * sizes for values, sizes in groups]
    return np.asarray(np.concatenate(zero, axis=1).all(axis=1))

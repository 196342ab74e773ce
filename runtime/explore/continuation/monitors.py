"""Numbers along a branch whose sign changes where something happens."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from nonsmooth.runtime.events.boundary_functions import PhaseWaves, ends_of, interior_maxima
from nonsmooth.runtime.explore.continuation.event_kinds import KINDS, OrbitKind
from nonsmooth.runtime.explore.continuation.orbit_family import OrbitFamily

__all__ = ["Monitor", "Monitors", "monitors_of"]

_ZERO = 1e-9  # relative size below which a boundary function counts as zero at an end
_SAMPLES = 7  # points at which is looked for what is zero all along


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

    curve: OrbitFamily
    smooth: tuple[Monitor, ...]  # functions of the multipliers and the tangent
    borders: tuple[Monitor, ...]  # functions of boundaries and conditions

    def smooth_values(self, z: np.ndarray, tangents: np.ndarray) -> np.ndarray:
        """Values (k, m) of the smooth functions at points (k, n + 1).

        The unit tangents (k, n + 1) are in the curve's units.
        """
        multipliers, slopes = self.curve.multipliers(z), tangents[:, -1]
        here = _orbit_kind(self.curve, multipliers)
        tests = [KINDS[monitor.kind].test for monitor in self.smooth]
        with np.errstate(all="ignore"):  # a slope may be zero
            values = [test(multipliers, slopes, here) for test in tests if test is not None]
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

    def confirmed(self, monitor: Monitor, z: np.ndarray) -> bool:
        """Whether a zero at z (n + 1,) is the event, and not a pole or a neutral saddle."""
        kind = KINDS[monitor.kind]
        return kind.test is None or kind.holds(self.curve.multipliers(z[None])[0])


def _orbit_kind(curve: OrbitFamily, multipliers: np.ndarray) -> OrbitKind:
    return OrbitKind(multipliers.shape[-1], curve.order == 2, curve.conservative)


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


def monitors_of(curve: OrbitFamily, points: np.ndarray) -> Monitors:
    """The functions to watch along a branch with points (k, n + 1).

    A boundary function that vanishes at an end of a phase along the whole branch is the
    boundary with which the phase begins or ends: its rate is watched instead.
    """
    some = points[np.unique(np.linspace(0, len(points) - 1, _SAMPLES).astype(int))]
    here = _orbit_kind(curve, curve.multipliers(some))
    smooth = tuple(
        Monitor(name)
        for name, kind in KINDS.items()
        if kind.test is not None and kind.watched(here)
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

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
    """One of the numbers: the event's kind, phase and boundary, and where it is found."""

    kind: str
    phase: int = -1
    boundary: str = ""
    source: str = ""
    column: int = 0


@dataclass(frozen=True)
class Monitors:
    """All numbers that are watched along a branch.

    Attributes
    ----------
    curve : OrbitFamily
    smooth : tuple of Monitor
        Of multipliers and the tangent.
    borders : tuple of Monitor
        Of boundaries and conditions.
    """

    curve: OrbitFamily
    smooth: tuple[Monitor, ...]
    borders: tuple[Monitor, ...]

    def smooth_values(self, z: np.ndarray, tangents: np.ndarray) -> np.ndarray:
        """Values (k, m) at points (k, n + 1) with their tangents.

        Parameters
        ----------
        z : array (k, n + 1)
        tangents : array (k, n + 1)
            In the curve's units, of length 1.

        Returns
        -------
        array (k, m)
        """
        multipliers, slopes = self.curve.multipliers(z), tangents[:, -1]
        here = _orbit_kind(self.curve, multipliers)
        tests = [KINDS[monitor.kind].test for monitor in self.smooth]
        with np.errstate(all="ignore"):  # a slope may be zero
            values = [test(multipliers, slopes, here) for test in tests if test is not None]
        return np.stack(values, axis=-1)

    def border_values(self, z: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Values (k, m), and times since the start of the phase; NaN where there is none.

        Parameters
        ----------
        z : array (k, n + 1)

        Returns
        -------
        tuple of array (k, m), array (k, m)
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
        """Whether a change of sign is that of the event, and not a pole or a neutral saddle.

        Parameters
        ----------
        monitor : Monitor
        z : array (n + 1,)
            Where its number is zero.
        """
        kind = KINDS[monitor.kind]
        return kind.test is None or kind.holds(self.curve.multipliers(z[None])[0])


def _orbit_kind(curve: OrbitFamily, multipliers: np.ndarray) -> OrbitKind:
    return OrbitKind(multipliers.shape[-1], curve.order == 2, curve.conservative)


def _border(waves: PhaseWaves) -> dict[str, tuple[np.ndarray, np.ndarray]]:
    """Values and times (k, b) of each source."""
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
    """What is watched along a branch (k, n + 1).

    A boundary function that is zero at an end of a phase all along the branch is one that the
    phase begins or ends with: its rate is watched in its place.

    Parameters
    ----------
    curve : OrbitFamily
    points : array (k, n + 1)
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
    """Which of functions and rates (2, b) are zero in units of their sizes, all along."""
    zero = [abs(values) <= _ZERO * sizes for values, sizes in groups]
    return np.asarray(np.concatenate(zero, axis=1).all(axis=1))

"""An event of a branch, followed in two parameters: where in the plane folds, flips, grazings lie.

The orbit's equations are joined by one that holds at the event: for a fold and a branch point
that their Jacobian is singular (the last entry of the solution of a bordered system: A. Griewank
and G. Reddien, SIAM J. Numer. Anal. 21, 1984), else that the event's monitor is zero. Its gradient
and the derivatives by the second parameter are central differences, which slow Newton's method
down but do not limit what it converges to.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from operator import itemgetter
from typing import Annotated, Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError, Interrupted, unknown_name
from nonsmooth.runtime.core.json_codec import Table, one_of
from nonsmooth.runtime.core.registry import Kept, registered
from nonsmooth.runtime.explore.continuation.branch import Branch
from nonsmooth.runtime.explore.continuation.event import KINDS, Event, point_of
from nonsmooth.runtime.explore.continuation.monitors import Monitor, Monitors, monitors_of
from nonsmooth.runtime.explore.continuation.orbit_family import OrbitFamily, check_interval
from nonsmooth.runtime.explore.continuation.stepping import (
    INTERRUPTED,
    STEP,
    check_steps,
    trace_both_ways,
)
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.orbits.orbit_file import KeptOrbit

__all__ = ["MOST_POINTS", "Locus", "continue_event"]

_DIFFERENCE = 1e-5  # in units of the sizes
MOST_POINTS = 500


@dataclass(frozen=True, eq=False, kw_only=True, repr=False)
class Locus(Kept):
    """A curve in the plane of two parameters along which an event happens.

    Attributes
    ----------
    kind : str
        A key of `nonsmooth.runtime.explore.continuation.event.KINDS`.
    boundary : str
        Empty where the event is no matter of one.
    parameters : (str, str)
    values : array (k, 2)
        Of both parameters, in the order in which the points follow.
    unknown_names : tuple of str
    unknowns : array (k, n)
    ends : tuple of str
        Why it ends on either side.
    start : int
        Which of the points it was followed from.
    orbit : Orbit
        That the branch of the event was followed from.
    """

    kind: Annotated[str, one_of(tuple(KINDS))]
    boundary: str
    parameters: tuple[str, str]
    values: Table
    unknown_names: tuple[str, ...]
    unknowns: Table
    ends: tuple[str, str]
    start: int
    orbit: KeptOrbit

    def __len__(self) -> int:
        return len(self.values)

    @property
    def name(self) -> str:
        """Name of the orbit."""
        return self.orbit.name

    @property
    def title(self) -> str:
        """The event and the orbit in words."""
        kind = self.kind.replace("-", " ")
        return f"{kind}{' of ' * bool(self.boundary)}{self.boundary}: {self.name}"

    def orbit_at(self, place: int) -> Orbit:
        """Give the orbit at a point of the curve.

        Parameters
        ----------
        place : int
            Number of the point, counted from 0.

        Returns
        -------
        Orbit

        Raises
        ------
        InputError
            If the curve has no such point.
        """
        if not -len(self) <= place < len(self):
            raise InputError(f"the curve has {len(self)} points, no point {place}")
        z = np.append(self.unknowns[place], self.values[place])
        return OrbitFamily(self.orbit, *self.parameters).at(z)

    def plot(self, axes: Any = None) -> Any:
        """Draw the curve in the plane of its parameters.

        Parameters
        ----------
        axes : matplotlib Axes, optional
            Where to draw; a figure of its own when omitted.

        Returns
        -------
        matplotlib Axes
            What was drawn on.
        """
        return registered("draw_locus")(self, axes)


class _EventCurve:
    """The points z = (unknowns, first parameter, second parameter) at which an event happens."""

    def __init__(self, monitors: Monitors, event: Event) -> None:
        self._monitors, self._curve = monitors, monitors.curve
        self.dwell_names, self.sizes = self._curve.dwell_names, self._curve.sizes
        self.first = np.append(point_of(event), self._curve.first[-1])
        several = _monitors_of(monitors, event)
        self._monitor, self._unit = several[0], 1.0
        self._vanishing = event.phase if event.kind == "vanishing-phase" else None
        left, _, right = np.linalg.svd(self._scaled(self.first))
        self._left, self._right = left[:, -1], right[-1]
        told = [(monitor, *self._told(monitor)) for monitor in several]
        self._monitor, _, self._unit = min(told, key=itemgetter(1))

    def equations(self, z: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """See `Curve`."""
        residual, jacobian = self._curve.equations(z)
        return np.append(residual, self._value(z)), np.vstack([jacobian, self._slopes(z)])

    def _told(self, monitor: Monitor) -> tuple[float, float]:
        """Distance of a monitor from zero in units of its change nearby, and this unit."""
        self._monitor = monitor
        unit = float(np.abs(self._slopes(self.first) * self.sizes)[:-1].max()) or 1.0
        return abs(self._value(self.first)) / unit, unit

    def _slopes(self, z: np.ndarray) -> np.ndarray:
        """Derivatives (n + 2,) of the event's function."""
        step = _DIFFERENCE * self.sizes
        rises = [self._value(z + s) - self._value(z - s) for s in np.diag(step)]
        return np.array(rises) / (2 * step)

    def leaps(self, z: np.ndarray, following: np.ndarray) -> bool:
        """False: no other branch is watched for (see `Curve`)."""
        return False

    def dwell(self, z: np.ndarray) -> np.ndarray:
        """See `Curve`; the dwell time that vanishes along the whole locus is replaced by 1."""
        found = np.array(self._curve.dwell(z))
        if self._vanishing is not None:
            found[:, self._vanishing] = 1.0
        return found

    def _scaled(self, z: np.ndarray) -> np.ndarray:
        jacobian = self._curve.equations(z, by=1)[1] * self.sizes[:-1]
        units = np.abs(jacobian).max(axis=1, keepdims=True)
        return np.asarray(jacobian[:, :-1] / units)

    def _value(self, z: np.ndarray) -> float:
        """Value of the function that is zero at the event, in units of its change nearby."""
        if self._vanishing is not None:
            wait = self._curve.dwell(z[None])[0, self._vanishing]
            return float(wait / self.sizes[self._vanishing])
        if self._monitor.kind in ("fold", "branch-point"):
            jacobian = self._scaled(z)
            bordered = np.block(
                [[jacobian, self._left[:, None]], [self._right[None], np.zeros((1, 1))]]
            )
            right = np.zeros(len(bordered))
            right[-1] = 1
            return float(np.linalg.solve(bordered, right)[-1])
        monitors = self._monitors
        if self._monitor in monitors.smooth:
            values = monitors.smooth_values(z[None], np.zeros((1, len(z))))[0]
            return float(values[monitors.smooth.index(self._monitor)] / self._unit)
        values, _ = monitors.border_values(z[None])
        return float(values[0, monitors.borders.index(self._monitor)] / self._unit)


def continue_event(
    branch: Branch,
    event: Event,
    parameter: str,
    interval: tuple[float, float],
    *,
    step: float = 2 * STEP,
    points: int = MOST_POINTS,
    progress: Callable[[int], object] | None = None,
) -> Locus:
    """Follow an event of a branch in the plane of two parameters, as `continue_orbit` does."""
    if event.kind == "admissibility":
        raise InputError("an event that no boundary explains cannot be followed")
    if parameter == branch.parameter:
        raise unknown_name(
            "second parameter", parameter, [n for n in branch.orbit.given if n != parameter]
        )
    limits = check_interval(branch.orbit, parameter, interval)
    check_steps(step, points)
    lengths = np.ptp(branch.parameter_values) or 1.0, limits[1] - limits[0]
    curve = OrbitFamily(branch.orbit, branch.parameter, parameter, lengths=lengths)
    if len(curve.equations(curve.first)[0]) != len(curve.names):
        raise InputError(f"{branch.name} is one of a family: its events are not followed")
    second = np.full(len(branch), curve.first[-1])
    known = np.column_stack([branch.unknowns, branch.parameter_values, second])
    locus = _EventCurve(monitors_of(curve, known), event)
    told = 0

    def go_on(*_: np.ndarray) -> None:
        nonlocal told
        told += 1
        if progress is not None:
            progress(told)

    path = trace_both_ways(locus, limits, step, points, go_on)
    found = Locus(
        kind=event.kind,
        boundary=event.boundary,
        parameters=(branch.parameter, parameter),
        values=path.points[:, -2:],
        unknown_names=branch.unknown_names,
        unknowns=path.points[:, :-2],
        ends=path.ends,
        start=path.start,
        orbit=branch.orbit,
    )
    if INTERRUPTED in path.ends:
        raise Interrupted(found)
    return found


def _monitors_of(monitors: Monitors, event: Event) -> list[Monitor]:
    """Monitors that may have a zero at an event: a transition may have several conditions."""
    if event.kind == "vanishing-phase":
        return [Monitor(event.kind)]
    place = event.kind, -1 if event.phase is None else event.phase, event.boundary
    found = [
        monitor
        for monitor in (*monitors.smooth, *monitors.borders)
        if (monitor.kind, monitor.phase, monitor.boundary) == place
    ]
    if not found:
        raise InputError(f"the branch does not watch this event: {event.text}")
    return found

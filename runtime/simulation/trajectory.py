"""A simulated motion: its transitions, and its state at any time in closed form."""

from __future__ import annotations

import os
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError, check_integer, missing_extra
from nonsmooth.runtime.core.registry import Kept, registered
from nonsmooth.runtime.core.values import Value, real_array
from nonsmooth.runtime.model.boundary_sets import members_of, names_of
from nonsmooth.runtime.model.engine_run import Grazing, Run, Status
from nonsmooth.runtime.model.flows import flow_states
from nonsmooth.runtime.model.piecewise import PiecewiseLinear
from nonsmooth.runtime.model.structure import Structure
from nonsmooth.runtime.simulation.phase_functions import phase_states

if TYPE_CHECKING:
    from nonsmooth.runtime.simulation.derivatives import MotionDerivatives
    from nonsmooth.runtime.simulation.recurrence import Recurrence

_ROUNDING = 1e-14  # of the end of a motion


@dataclass(frozen=True, eq=False, repr=False)
class Trajectory(Kept):
    """A motion from event to event, in physical coordinates.

    Calling it gives the state at any times between its start and its end, from the flows in
    closed form; at a transition that is the state behind it.

    Attributes
    ----------
    system : PiecewiseLinear
        The system at the motion's parameters.
    run : Run
        What the engine gave.

    Examples
    --------
    >>> from nonsmooth.runtime.simulation.simulate import simulate
    >>> data = {"m1": 1, "m2": 2, "k1": 1, "k2": 5, "r": 1}
    >>> motion = simulate("rigid-stop", data, {"x1": 1, "x2": 0, "v1": -1, "v2": 0}, transitions=3)
    >>> motion.configurations
    ('free', 'free', 'free', 'free')
    >>> motion([0.0, 0.5]).shape
    (2, 4)
    """

    system: PiecewiseLinear
    run: Run

    @property
    def structure(self) -> Structure:
        """The system apart from its parameters."""
        return self.system.structure

    @property
    def name(self) -> str:
        """Name of the system."""
        return self.structure.name

    @property
    def parameters(self) -> dict[str, Value]:
        """Parameters as they were given."""
        return self.system.parameters

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the states: positions, then velocities."""
        return self.structure.states

    @property
    def times(self) -> np.ndarray:
        """Times of the start and of each transition, (n,)."""
        return self.run.times

    @cached_property
    def configurations(self) -> tuple[str, ...]:
        """Configurations from each of the times on."""
        return tuple(self.structure.configurations[c] for c in self.run.configurations)

    @cached_property
    def boundaries(self) -> tuple[tuple[str, ...], ...]:
        """Boundaries that were reached together at each of the times; none at the start."""
        phases = zip(self.run.configurations, self.run.sets[1:], strict=False)
        return ((), *(names_of(self.structure, *phase) for phase in phases))

    @property
    def states(self) -> np.ndarray:
        """States behind each transition, (n, N)."""
        return self.run.states

    @property
    def before(self) -> np.ndarray:
        """States in front of each transition, (n, N); the start itself in the first row."""
        return self.run.before

    @property
    def transitions(self) -> int:
        """Number of transitions."""
        return len(self.times) - 1

    @property
    def end(self) -> float:
        """Time at which the simulation ended."""
        return self.run.end

    @property
    def status(self) -> Status:
        """Why it ended."""
        return self.run.status

    @property
    def options(self) -> tuple[str, ...]:
        """Configurations that may follow, where the laws of contact leave it open."""
        return tuple(self.structure.configurations[c] for c in self.run.options)

    @property
    def open_at(self) -> tuple[str, ...]:
        """Boundaries that are reached together where the laws of contact leave it open."""
        return names_of(self.structure, self.run.configurations[-1], self.run.open_at)

    @property
    def message(self) -> str:
        """Why it ended, in words."""
        found = self.run.status.message
        if not self.options:
            return found
        here, reached = int(self.run.configurations[-1]), members_of(self.run.open_at)
        if self.structure.orders(here, reached):
            return f"{found}: the orders in which {' and '.join(self.open_at)} act do not agree"
        return f"{found}: {' or '.join(self.options)}"

    @property
    def grazings(self) -> tuple[Grazing, ...]:
        """Boundaries that were touched within rounding and not crossed."""
        return self.run.grazings

    def __call__(self, times: Any) -> np.ndarray:
        """States (..., N) at times (...).

        `InputError` is raised for a time that is not a number between 0 and `end`.
        """
        array = self._checked(times)
        flat = array.ravel()
        phases = self._phases(flat)
        where, since = self.run.configurations[phases], flat - self.times[phases]
        states = phase_states(self.system, where, since, self.states[phases])
        return states.reshape(*array.shape, len(self.names))

    def configuration(self, times: Any) -> Any:
        """Give the configuration at each of the times.

        Parameters
        ----------
        times : float or array (m,)
            Times between the start and the end of the motion, in the units of the system.

        Returns
        -------
        str or array (m,)
        """
        array = self._checked(times)
        indices = self.run.configurations[self._phases(array.ravel())].reshape(array.shape)
        names = np.array(self.structure.configurations)[indices]
        return str(names) if names.ndim == 0 else names

    def sample(self, points: int = 2000) -> tuple[np.ndarray, np.ndarray]:
        """Give points for a drawing, every transition among them.

        Each transition occurs twice: in front of it and behind it.

        Parameters
        ----------
        points : int
            About how many.

        Returns
        -------
        tuple of array (m,) and array (m, N)
            Times and states.

        Raises
        ------
        InputError
            For a count that is no positive integer, or far too large.
        """
        check_integer("points", points, 1)
        times, states = [], []
        breaks = [*self.times.tolist(), max(self.end, float(self.times[-1]))]
        share = points / (breaks[-1] or 1.0)
        for phase, (begin, end) in enumerate(pairwise(breaks)):
            inside = np.linspace(begin, end, max(2, round(share * (end - begin)) + 1))
            where = int(self.run.configurations[phase])
            found = flow_states(self.system, where, inside - begin, self.states[phase])
            if phase + 1 < len(self.before):
                found[-1] = self.before[phase + 1]
            times.append(inside)
            states.append(found)
        return np.concatenate(times), np.concatenate(states)

    def to_xarray(self) -> Any:
        """Give the transitions as an xarray Dataset.

        Returns
        -------
        xarray.Dataset
            With the dimensions ``transition`` and ``state``.

        Raises
        ------
        MissingExtra
            If xarray is not installed.
        """
        try:
            import xarray
        except ImportError:
            raise missing_extra("chart", "xarray") from None
        return xarray.Dataset(
            {
                "before": (("transition", "state"), self.before),
                "after": (("transition", "state"), self.states),
            },
            coords={
                "time": ("transition", self.times),
                "configuration": ("transition", list(self.configurations)),
                "boundaries": ("transition", ["+".join(names) for names in self.boundaries]),
                "state": list(self.names),
            },
            attrs={
                "system": self.name,
                "parameters": {name: value.text for name, value in self.parameters.items()},
                "end": self.end,
                "status": self.status.name.lower(),
            },
        )

    def plot(
        self,
        kind: str = "time",
        axes: Any = None,
        *,
        masses: Iterable[int] | None = None,
        points: int = 2000,
    ) -> Any:
        """Draw the motion.

        Parameters
        ----------
        kind : str
            What to draw: "time", "phase" or another of the plots that the command offers.
        axes : matplotlib Axes, optional
            Where to draw; a figure of its own when omitted.
        masses : iterable of int, optional
            Masses that are drawn, counted from 0; all when omitted.
        points : int
            About how many points a curve has.

        Returns
        -------
        matplotlib Axes
            What was drawn on.
        """
        return registered("plot_motion")(self, kind, axes, masses=masses, points=points)

    def recurrence(self, since: float = 0.0, period: float | None = None) -> Recurrence:
        """Find the cycle that the motion repeats at its end; see `nonsmooth.itinerary_of`.

        Parameters
        ----------
        since : float
            What the motion did before is not looked at.
        period : float, optional
            About how long the cycle lasts.

        Returns
        -------
        Recurrence
        """
        found: Recurrence = registered("itinerary_of")(self, since, period)
        return found

    def derivatives(
        self,
        by: Iterable[str] | None = None,
        *,
        times: Any = None,
        one_sided: str | None = None,
    ) -> MotionDerivatives:
        """Differentiate the motion by parameters and by its start, exact up to rounding.

        Parameters
        ----------
        by : iterable of str, optional
            Parameters, and states at the start: ``x10`` is that of ``x1``. All when omitted,
            but for the phases of forcings, which are part of the system.
        times : array (m,), optional
            Times that are held fixed, at which the states are differentiated.
        one_sided : {"+", "-"}, optional
            Where the motion has no derivative: that by numbers which grow, or which fall. Of
            boundaries that are reached together each number has its own order.

        Returns
        -------
        MotionDerivatives

        Raises
        ------
        InputError
            For an unknown name or time, or where the motion has no derivative; the message
            names the event and its time.

        Examples
        --------
        >>> from nonsmooth.runtime.simulation.simulate import simulate
        >>> data = {"m1": 1, "m2": 2, "k1": 1, "k2": 5, "r": "0.5"}
        >>> motion = simulate("rigid-stop", data, [0, 0, 1.5, 0], until=5)
        >>> motion.derivatives(["r", "v10"], times=[5]).states.shape
        (1, 4, 2)
        """
        found: MotionDerivatives = registered("motion_derivatives")(self, by, times, one_sided)
        return found

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the motion to a file that `nonsmooth.load` reads: .npz or .csv.

        Parameters
        ----------
        path : str or path
            File to write, ending in .npz or .csv.

        Raises
        ------
        InputError
            For another ending, or a file that cannot be written.
        """
        registered("save_trajectory")(self, path)

    def _checked(self, times: Any) -> np.ndarray:
        """The times as an array; what is beyond the end by rounding alone is the end."""
        array = real_array("times", times)
        if not ((array >= 0) & (array <= self.end * (1 + _ROUNDING))).all():
            raise InputError(f"a time is not between 0 and the end of the motion, {self.end!r}")
        return np.asarray(np.minimum(array, self.end))

    def _phases(self, times: np.ndarray) -> np.ndarray:
        return np.searchsorted(self.times, times, side="right") - 1

"""Branches of periodic orbits over one parameter, and curves of their events over two."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Annotated, Any, Literal

import numpy as np

from nonsmooth.runtime.core.errors import InputError, missing_extra, unknown_name
from nonsmooth.runtime.core.json_codec import AnyComplexTable, AnyRow, Flags, Row, Table, one_of
from nonsmooth.runtime.core.registry import Kept, registered
from nonsmooth.runtime.explore.continuation.energy import energy_of
from nonsmooth.runtime.explore.continuation.event import KINDS, Event, point_of
from nonsmooth.runtime.explore.continuation.next_orbits import (
    composed_family,
    next_itineraries,
    other_branch,
)
from nonsmooth.runtime.model.piecewise import piecewise
from nonsmooth.runtime.model.structure import structure_of
from nonsmooth.runtime.orbits.equations import equations_of
from nonsmooth.runtime.orbits.motion import Motion
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.orbits.orbit_file import KeptOrbit
from nonsmooth.runtime.simulation.observables import observe
from nonsmooth.runtime.simulation.trajectory import Trajectory

StabilityOfPoint = Literal["stable", "neutral", "unstable", "undecided"]
_POINTS = 4000  # in a period of a Motion: an error of 1e-6 of the amplitude


@dataclass(frozen=True, eq=False, kw_only=True, repr=False)
class Branch(Kept):
    """Orbits of one itinerary along one parameter, in the order in which they follow.

    Attributes
    ----------
    parameter : str
    parameter_values : array (k,)
        They turn at folds.
    unknown_names : tuple of str
    unknowns : array (k, n)
    period : array (k,)
    multipliers : array (k, r), complex
        Those that may differ from zero, without the 1 that a first integral enforces.
    trace : array (k,)
        Of the Poincare map.
    stability : tuple of str
        "stable", "neutral", "unstable" or "undecided" of each point.
    admissible : array (k,) of bool
        Whether it is a motion of the real system.
    events : tuple of Event
        In their order; `Event.place` says between which points.
    ends : tuple of str
        Why the branch ends, at its beginning and at its end.
    start : int
        Which of the points it was followed from.
    orbit : Orbit
        That point.
    """

    parameter: str
    parameter_values: Row
    unknown_names: tuple[str, ...]
    unknowns: Table
    period: Row
    multipliers: AnyComplexTable
    trace: AnyRow
    stability: tuple[StabilityOfPoint, ...]
    admissible: Flags
    events: tuple[Event, ...]
    ends: tuple[str, str]
    start: int
    orbit: KeptOrbit

    def __len__(self) -> int:
        return len(self.parameter_values)

    @property
    def name(self) -> str:
        """Name of the orbit."""
        return self.orbit.name

    def orbit_at(self, place: int | Event) -> Orbit:
        """Give the orbit at a point of the branch, or at an event.

        Parameters
        ----------
        place : int or Event
            Number of the point, counted from 0, or one of `events`.

        Returns
        -------
        Orbit

        Raises
        ------
        InputError
            If the branch has no such point.
        """
        if isinstance(place, Event):
            z = point_of(place)
        elif isinstance(place, int | np.integer) and -len(self) <= place < len(self):
            z = np.append(self.unknowns[place], self.parameter_values[place])
        else:
            raise InputError(f"the branch has {len(self)} points, no point {place!r}")
        return equations_of(self.orbit, self.parameter).at(z)

    def next_itineraries(
        self, event: Event, parameters: Mapping[str, Any] | None = None
    ) -> tuple[Orbit, ...]:
        """Find admissible orbits of other itineraries just beyond a border collision.

        Parameters of the system that the orbit leaves open may be given; else they are chosen.

        Parameters
        ----------
        event : Event
            A border collision of this branch.
        parameters : mapping of str to number or text, optional
            Parameters of the system that the orbit does not determine.

        Returns
        -------
        tuple of Orbit
            None where no itinerary that was tried has an admissible orbit there.

        Raises
        ------
        InputError
            If the event is no border collision.
        """
        return next_itineraries(self, event, parameters)

    def switch(self, event: Event, parameters: Mapping[str, Any] | None = None) -> Orbit:
        """Find an orbit on the branch that meets this one at an event.

        At a flip the one of twice the period, at a symmetry-breaking one without the symmetry,
        at a branch point one on the branch that crosses. Parameters of the system that the
        orbit leaves open may be given; else they are chosen.

        Parameters
        ----------
        event : Event
            A flip, a symmetry breaking or a branch point of this branch.
        parameters : mapping of str to number or text, optional
            Parameters of the system that the orbit does not determine.

        Returns
        -------
        Orbit
            `continue_orbit` follows it.

        Raises
        ------
        InputError
            If no branch meets this one at the event, or the parameter is none of the system's.
        NoConvergence
            If no such orbit is found.
        """
        return other_branch(self, event, parameters)

    def quantity(self, name: str) -> np.ndarray:
        """Give the values of a quantity over the branch.

        Parameters
        ----------
        name : str
            "period", "frequency" (2 pi over the period), "trace", an unknown, the parameter, or
            "amplitude_x" of a state x: half of what it sweeps in a period. Over the frequency of
            a forcing that is the frequency response; of a conservative family over its period,
            beside "frequency", the backbone. "energy" is that of a conservative family, in the
            unit in which the first coordinate has the mass 1.

        Returns
        -------
        array (k,)
            One value for each point.

        Raises
        ------
        InputError
            For another name, or the energy where none is kept.
        """
        points = np.column_stack([self.unknowns, self.parameter_values])
        known = {"period": self.period, "trace": self.trace}
        known |= dict(zip((*self.unknown_names, self.parameter), points.T, strict=True))
        if name in known:
            return np.asarray(known[name])
        if name == "frequency":
            return np.asarray(2 * np.pi / self.period)
        if name == "energy":
            places = range(len(self))
            return np.array([energy_of(composed_family(self, place)[0]) for place in places])
        if not name.startswith("amplitude_"):
            raise unknown_name("quantity", name, [*known, "frequency", "energy"])
        state, family = name.removeprefix("amplitude_"), equations_of(self.orbit, self.parameter)
        # at a point a phase may take no time
        return np.array([_amplitude_of(family.motion(z), state) for z in points])

    def to_xarray(self) -> Any:
        """Give the branch as an xarray Dataset over its points.

        Returns
        -------
        xarray.Dataset
            With the dimension ``point``.

        Raises
        ------
        MissingExtra
            If xarray is not installed.
        """
        try:
            import xarray
        except ImportError:
            raise missing_extra("chart", "xarray") from None
        columns = {name: ("point", self.quantity(name)) for name in self.unknown_names}
        return xarray.Dataset(
            {
                **columns,
                "period": ("point", self.period),
                "trace": ("point", self.trace),
                "multiplier": (("point", "which"), self.multipliers),
                "stability": ("point", np.array(self.stability)),
                "admissible": ("point", self.admissible),
            },
            coords={self.parameter: ("point", self.parameter_values)},
            attrs={"orbit": self.name, "events": [event.text for event in self.events]},
        )

    def plot(
        self,
        quantity: str | Sequence[str] | None = None,
        axes: Any = None,
        *,
        over: str | None = None,
        frequency: str = "angular",
    ) -> Any:
        """Draw quantities over the parameter, or over another quantity.

        Parameters
        ----------
        quantity : str or several, optional
            What `quantity` takes, one below the other; chosen for the branch when omitted.
        axes : matplotlib Axes, optional
            Where to draw; a figure of its own when omitted.
        over : str, optional
            Another quantity in place of the parameter.
        frequency : {"angular", "cycles"}
            Unit of a frequency that is drawn.

        Returns
        -------
        matplotlib Axes or Figure
            The Axes that were given, with the first quantity, or the new figure.
        """
        return registered("draw_branch")(self, quantity, axes, over=over, frequency=frequency)


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
        return equations_of(self.orbit, *self.parameters).at(z)

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


def _amplitude_of(motion: Motion | Trajectory, state: str) -> float:
    """Half of the difference between the largest and the smallest value of a state, in its unit.

    The extremes of a `Trajectory` (of one period) are guaranteed, those of a `Motion` are
    sampled. `state` names a coordinate of the orbit; an unknown one is refused.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> motion = ns.solve("dry-friction/global-stick").motion()
    >>> round(_amplitude_of(motion, "z1"), 4)
    2.3313
    """
    if isinstance(motion, Motion):
        names, samples = motion.names, motion.sample(_POINTS).states
        if state not in names:
            raise unknown_name("state", state, names)
        return float(np.ptp(samples[:, names.index(state)])) / 2
    found = observe(motion)
    if state not in found.maxima:
        raise unknown_name("state", state, found.maxima)
    return (found.maxima[state].value - found.minima[state].value) / 2


def forcing_frequencies(branch: Branch) -> np.ndarray | None:
    """Angular frequency (k,) of the first forcing, in radians over the unit of time, or None.

    It is None unless the frequency is proportional to the branch's parameter.
    """
    orbit, name, values = branch.orbit, branch.parameter, branch.parameter_values
    if not structure_of(orbit.system).forcing:
        return None
    speeds = []
    for value in (values.min(), values.max()):
        try:
            system = piecewise(orbit.system, {**orbit.parameters, name: float(value)})
        except InputError:  # an orbit that leaves parameters of its system open
            return None
        (cosine, sine), *_ = system.structure.forcing
        speeds.append(float(system.fields[0, sine, cosine]))
    low, high = values.min(), values.max()
    if low == high or low == 0 or not math.isclose(speeds[0] / low, speeds[1] / high):
        return None
    return np.asarray(values * (speeds[1] / high))


def usual_quantities(branch: Branch) -> tuple[str, ...]:
    """Names of the quantities that a picture of the branch draws by default.

    They are the amplitudes of all coordinates of a forced system, which over the frequency of
    the forcing are the frequency response, and the period of any other system.
    """
    structure = structure_of(branch.orbit.system)
    if not structure.forcing:
        return ("period",)
    return tuple(f"amplitude_{structure.states[place]}" for place, _ in structure.coordinates)

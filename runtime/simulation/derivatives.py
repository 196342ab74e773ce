"""Derivatives of a simulated motion by parameters and by its start.

Phase by phase a perturbation at a fixed time is carried by the flow, and grows by what the
field's change adds (`moved_phases`). The boundary's condition, linearised, gives the change
of the transition's time; the reset, its own change and the jump of velocities give the
perturbation behind it (I. A. Hiskens and M. A. Pai, IEEE Trans. Circuits Syst. I 47, 2000). The
reverse pass carries one combination of the results backwards; its cost does not depend on the
number of parameters.
"""

from __future__ import annotations

import operator
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np

from nonsmooth.runtime.core.arguments import checked_methods
from nonsmooth.runtime.core.complex_steps import imaginary_parts, stepped
from nonsmooth.runtime.core.errors import InputError, chosen_names, unknown_name
from nonsmooth.runtime.core.values import real_array
from nonsmooth.runtime.model.engine_run import Status
from nonsmooth.runtime.model.naming import start_names
from nonsmooth.runtime.shooting.shooting_map import Numbers
from nonsmooth.runtime.simulation.motion_linearisation import (
    MotionChanges,
    input_names,
)
from nonsmooth.runtime.simulation.moved_phases import MovedPhases
from nonsmooth.runtime.simulation.observables import observe, observed_rows, told_of
from nonsmooth.runtime.simulation.one_sided import (
    CUT,
    DirectedMotion,
    check_times,
    directed_motions,
    gathered,
    scattered,
)
from nonsmooth.runtime.simulation.phase_functions import phases_of
from nonsmooth.runtime.simulation.trajectory import Trajectory


@checked_methods
@dataclass(frozen=True, eq=False)
class MotionDerivatives:
    """Derivatives of a motion by q numbers: parameters, and states at the start.

    By a state at the start that constraints or a forcing's phase bind, the derivative is that
    along the nearest direction in which the configuration lets the start move: zero for a
    velocity that a contact holds. While a parameter moves a constraint, the start stays on it.

    Attributes
    ----------
    trajectory : Trajectory
    by : tuple of str
    times : array (m,)
    one_sided : {"+", "-"} or None
        By numbers that grow, or that fall, or both.
    parts : tuple of DirectedMotion
        One for all numbers; several where boundaries that are reached together come apart in
        an order that depends on the number.

    Examples
    --------
    >>> from nonsmooth.runtime.simulation.simulate import simulate
    >>> data = {"m1": 1, "m2": 2, "k1": 1, "k2": 5, "r": "0.5"}
    >>> motion = simulate("rigid-stop", data, [0, 0, 1.5, 0], transitions=3)
    >>> found = motion.derivatives(["k1", "r"])
    >>> found.event_times.shape, found.behind.shape
    ((3, 2), (4, 4, 2))
    >>> bool(found.event_times[0, 1] == 0)  # restitution acts from the first impact on
    True
    """

    trajectory: Trajectory
    by: tuple[str, ...]
    times: np.ndarray
    one_sided: str | None
    parts: tuple[DirectedMotion, ...]

    @cached_property
    def _forward(self) -> MotionChanges:
        return gathered(self.parts, len(self.by))

    @property
    def states(self) -> np.ndarray:
        """Derivatives (m, N, q) of the states at the times, which stay."""
        return self._forward.states

    @property
    def event_times(self) -> np.ndarray:
        """Derivatives (n - 1, q) of the transitions' times.

        Of boundaries that come apart that of the first. NaN where the boundary is reached
        tangentially and nothing changes behind it, or both sides differ.
        """
        return self._forward.event_times

    @property
    def before(self) -> np.ndarray:
        """Derivatives (n, N, q) of the states in front of the transitions, which move.

        In front of the first of boundaries that come apart; NaN where both sides differ.
        """
        return self._forward.before

    @property
    def behind(self) -> np.ndarray:
        """Derivatives (n, N, q) of the states behind the transitions, which move.

        Behind the last of boundaries that come apart; NaN where both sides differ.
        """
        return self._forward.behind

    @property
    def end(self) -> np.ndarray:
        """Derivative (q,) of the time at which the simulation ended.

        Raises
        ------
        InputError
            If it ended where it cannot go on.
        """
        return self._end(self._forward)

    def _end(self, changes: MotionChanges) -> np.ndarray:
        """Derivatives of the end by the numbers of `changes`; see `end`."""
        if self.trajectory.status in CUT:
            raise InputError(
                f"the motion ends at t = {self.trajectory.end!r}: {self.trajectory.message};"
                " that time has no derivative"
            )
        events = changes.event_times
        if self.trajectory.status == Status.UNTIL or not len(events):
            return np.zeros(events.shape[1])
        return np.asarray(events[-1])

    def jvp(self, direction: Mapping[str, float] | Any) -> dict[str, np.ndarray]:
        """Differentiate along one direction (forward mode).

        Parameters
        ----------
        direction : mapping of str to float, or array (q,)
            Change of each of the numbers; of those that a mapping leaves out none. On one side
            the motion is moved along it, or against it.

        Returns
        -------
        dict of str to array
            ``states`` (m, N), ``event_times`` (n - 1,), ``before`` and ``behind`` (n, N).

        Raises
        ------
        InputError
            For an unknown name, another count of numbers, or a direction in which the motion
            has no derivative.
        """
        if isinstance(direction, Mapping):
            for name in direction:
                if name not in self.by:
                    raise unknown_name("number", str(name), self.by)
            direction = [direction.get(name, 0.0) for name in self.by]
        factors = real_array("direction", direction)
        if factors.shape != (len(self.by),):
            raise InputError(f"the direction has not {len(self.by)} entries: {', '.join(self.by)}")
        along = self.by, factors[:, None], self.times, self.one_sided
        every = gathered(directed_motions(self.trajectory, *along), 1)
        return {name: getattr(every, name)[..., 0] for name in MotionChanges._fields[:4]}

    def vjp(
        self, *, states: Any = None, event_times: Any = None, before: Any = None, behind: Any = None
    ) -> np.ndarray:
        """Differentiate one combination of the results by all numbers (reverse mode).

        Parameters
        ----------
        states : array (m, N), optional
            Factors of the states at the times.
        event_times : array (n - 1,), optional
            Factors of the transitions' times.
        before, behind : array (n, N), optional
            Factors of the states in front of the transitions and behind them.

        Returns
        -------
        array (q,)

        Raises
        ------
        InputError
            For factors of another shape.
        """
        count, size = self.trajectory.states.shape
        shapes = {
            "states": (len(self.times), size),
            "event_times": (count - 1,),
            "before": (count, size),
            "behind": (count, size),
        }
        factors = []
        for (name, shape), given in zip(
            shapes.items(), (states, event_times, before, behind), strict=True
        ):
            found = np.zeros(shape) if given is None else real_array(name, given)
            if found.shape != shape:
                raise InputError(f"factors of {name} have the shape {found.shape}, not {shape}")
            factors.append(found)
        gradient = np.empty(len(self.by))
        for part in self.parts:
            gradient[part.columns] = part.gradient(*scattered(part, *factors))
        return gradient

    @cached_property
    def numbers(self) -> Numbers:
        """Fields, rows and resets (q, ...) of the system, each with a step of one number."""
        first, *others = (part.moves[0] for part in self.parts)
        order = np.argsort(np.concatenate([part.columns for part in self.parts]))
        tables = first.each(lambda *parts: np.concatenate(parts)[order], *others)
        system = self.trajectory.system
        now = Numbers(system.fields, system.rows, system.resets)
        return now.each(lambda part, rates: stepped(part, rates, None), tables)

    def moved_phases(self) -> MovedPhases:
        """Give the motion's phases as they move with the numbers.

        Where boundaries come apart, the times at which phases behind them begin are NaN.

        Returns
        -------
        MovedPhases

        Raises
        ------
        InputError
            As for `nonsmooth.observe`, or where the motion ended where it cannot go on.
        """
        found = self._moved(self.trajectory, self._forward, self.numbers, 0.0)
        for part in self.parts:
            found.rates[0, :, 1:][:, part.first != part.last] = np.nan
        return found

    def moved_parts(self, since: float) -> Iterator[tuple[np.ndarray, str | None, MovedPhases]]:
        """Yield indices of numbers, the side, and the phases that the moved motions have in turn.

        The side is None where no boundaries come apart. An `InputError` is raised where they do
        and their times have other derivatives on the other side.
        """
        for part in self.parts:
            if part.open.any():
                reached = self.trajectory.boundaries[1 + int(np.argmax(part.open))]
                raise InputError(
                    f"{' and '.join(reached)} are reached together: observables have derivatives on"
                    " one side there; ask for them by one_sided"
                )
            if part.columns.size:
                own = self.numbers.each(operator.itemgetter(part.columns))
                moved = self._moved(part.trajectory, part.changes, own, since)
                yield part.columns, self.one_sided if part.apart.any() else None, moved

    def _moved(
        self, trajectory: Trajectory, changes: MotionChanges, numbers: Numbers, since: float
    ) -> MovedPhases:
        """The phases of a motion from a time on that stays, as they move."""
        phases = phases_of(trajectory, since)
        first = len(trajectory.times) - len(phases.begins)
        rates = np.zeros((2, changes.event_times.shape[1], len(phases.begins)))
        rates[1, :, :-1] = rates[0, :, 1:] = changes.event_times[first:].T
        rates[1, :, -1] = self._end(changes)
        beginnings = changes.beginnings[first:].copy()
        found = MovedPhases(trajectory.system, numbers, phases, beginnings, rates)
        passed = float(phases.begins[0] - trajectory.times[first])
        if passed:
            whole = replace(phases, starts=trajectory.states[first:])
            cut = replace(found, phases=whole).at(np.array([0]), np.array([passed]))
            beginnings[0] = imaginary_parts(cut[:, 0], None).T
        return found

    def observables(self, since: float = 0.0) -> ObservableDerivatives:
        """Differentiate what `nonsmooth.observe` tells of the motion.

        Parameters
        ----------
        since : float
            Where to begin; it stays.

        Raises
        ------
        InputError
            As for `nonsmooth.observe`, or where the motion ended where it cannot go on.
        """
        return _observable_derivatives(self, since)

    @cached_property
    def condition(self) -> float:
        """How much roundings at all events grow along the motion, and what depends on them.

        Each state errs at each event by one unit, independently, in terms of its largest value
        along the motion; the flows and transitions carry the errors on. Their largest size,
        times what the slowest speed at which a boundary is reached makes of it.
        """
        return max(part.condition() for part in self.parts)


def motion_derivatives(
    trajectory: Trajectory,
    by: Iterable[str] | None = None,
    times: Any = None,
    one_sided: str | None = None,
) -> MotionDerivatives:
    """Differentiate a motion; see `Trajectory.derivatives`.

    An `InputError` is raised for an unknown name or time, or if the motion has no
    derivative.
    """
    names, starts = input_names(trajectory)
    if by is None:
        forced = trajectory.structure.forced
        free = (name for place, name in enumerate(starts) if place not in forced)
        chosen = (*names, *free)
    else:
        chosen = chosen_numbers(by, trajectory.names, names)
    array = np.atleast_1d(real_array("times", [] if times is None else times))
    if array.ndim > 1:
        raise InputError(f"times: a row is expected, not the shape {array.shape}")
    if not ((array >= 0) & (array <= trajectory.end)).all():
        raise InputError(f"a time is not between 0 and the end of the motion, {trajectory.end!r}")
    check_times(trajectory, array, one_sided)
    parts = directed_motions(trajectory, chosen, np.eye(len(chosen)), array, one_sided)
    for part in parts:
        part.transitions  # noqa: B018 - what has no derivative is refused here
    return MotionDerivatives(trajectory, chosen, array, one_sided, parts)


def chosen_numbers(
    by: Iterable[str] | str, states: Sequence[str], parameters: Sequence[str]
) -> tuple[str, ...]:
    """Names of parameters and of states at the start; an `InputError` refuses others."""
    known = (*parameters, *start_names(states, parameters))
    return chosen_names("parameter or start", by, known)


@dataclass(frozen=True, eq=False)
class ContactDerivatives:
    """Derivatives (q,) of what passes through one contact; see `ContactObservables`.

    Attributes
    ----------
    minimum, maximum, mean, work, dissipated : array (q,)
    """

    minimum: np.ndarray
    maximum: np.ndarray
    mean: np.ndarray
    work: np.ndarray
    dissipated: np.ndarray


@dataclass(frozen=True, eq=False)
class ObservableDerivatives:
    """Derivatives of a motion's observables by q numbers; see `Observables`.

    Where two extremes of one function are equal they are those of one of them.

    Attributes
    ----------
    by : tuple of str
    duration : array (q,)
    minima, maxima, means, rms : dict of state to array (q,)
    fractions : dict of configuration to array (q,)
    sticking : dict of position to array (q,)
    contacts : dict of str to ContactDerivatives
    """

    by: tuple[str, ...]
    duration: np.ndarray
    minima: dict[str, np.ndarray]
    maxima: dict[str, np.ndarray]
    means: dict[str, np.ndarray]
    rms: dict[str, np.ndarray]
    fractions: dict[str, np.ndarray]
    sticking: dict[str, np.ndarray]
    contacts: dict[str, ContactDerivatives]


def _observable_derivatives(found: MotionDerivatives, since: float = 0.0) -> ObservableDerivatives:
    """Derivatives of a motion's observables from the fixed time `since` on.

    The motion is refused as by `observe`, if it ended where it cannot go on, or if
    boundaries come apart whose times have other derivatives on the other side.
    """
    by, structure, values = found.by, found.trajectory.structure, observe(found.trajectory, since)
    size, contacts = len(structure.states), len(structure.contacts)
    forces = [size + 3 * i for i in range(contacts)]
    lowest, highest = np.empty((2, size + contacts, len(by)))
    moments = np.empty((len(by), size + 3 * contacts, size + 3 * contacts + 1), dtype=complex)
    spent = np.empty((len(by), len(structure.configurations)), dtype=complex)
    for columns, side, moved in found.moved_parts(since):
        rows = observed_rows(structure, moved.numbers.rows)
        ends = moved.extremes(rows[:, :, [*range(size), *forces]], side)
        for whole, part in zip((lowest, highest), ends, strict=True):
            whole[:, columns] = [extreme.rates for extreme in part]
        moments[columns], spent[columns] = moved.moments(rows), moved.spent
    duration = stepped(values.duration, found.end, None)
    means = imaginary_parts(moments[..., -1] / duration[:, None], None).T
    squares = np.diagonal(moments, axis1=1, axis2=2)[:, :size] / duration[:, None]
    fractions = imaginary_parts(spent / duration[:, None], None).T
    with np.errstate(divide="ignore", invalid="ignore"):  # what rests has no slope
        rms = imaginary_parts(squares, None).T / (2 * np.array([*values.rms.values()])[:, None])
    works = imaginary_parts(np.moveaxis(moments, 0, -1), None)
    told = told_of(structure, ContactDerivatives, lowest, highest, means, rms, fractions, works)
    return ObservableDerivatives(by, found.end, *told)

"""Attractors over one parameter, by brute force: bifurcation diagrams."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError, Interrupted, unknown_name
from nonsmooth.runtime.core.json_codec import AnyTable, BlankDigits, BlankText, Integers, Row
from nonsmooth.runtime.core.registry import Kept, registered
from nonsmooth.runtime.core.result_files import check_same_question
from nonsmooth.runtime.core.values import Value, as_value
from nonsmooth.runtime.core.workload import BYTES, check_memory
from nonsmooth.runtime.explore.finding.outcomes import Outcome, settled
from nonsmooth.runtime.model.engine_run import Status
from nonsmooth.runtime.model.kernels import SystemKernels, kernels_of, load_system
from nonsmooth.runtime.model.loading.declared import DeclaredSystem
from nonsmooth.runtime.model.parameters import parameter_points
from nonsmooth.runtime.model.piecewise import PiecewiseLinear, piecewise
from nonsmooth.runtime.model.saved_system import KeptSystemName, check_same_system
from nonsmooth.runtime.model.structure import structure_of
from nonsmooth.runtime.simulation.phase_functions import phase_states
from nonsmooth.runtime.simulation.simulate import checked_count, simulate_many
from nonsmooth.runtime.simulation.simulate import follow as follow_motion
from nonsmooth.runtime.simulation.starting import configuration_of, start_state

_CHUNK = 64  # values of the parameter between two reports of progress
_KEPT = 65  # entries at the end of a motion that is classified


@dataclass(frozen=True, eq=False, kw_only=True, repr=False)
class Sweep(Kept):
    """Samples of a state over a parameter, after transients: a bifurcation diagram.

    Attributes
    ----------
    system : str
    parameters : dict of str to Value
        All others than the one that is swept.
    parameter, state : str
    configuration : str or None
        At each entry of which the state was taken; None where the forcing's phase says when.
    phase : float or None
        Of the forcing, in radians, at which the state was taken once in each of its periods.
    values : array (n,)
    samples : array (n, m)
        NaN where a motion entered the configuration less often, or ended.
    outcomes : array (n,) of int
        What the motions settle on: numbers of `nonsmooth.runtime.explore.finding.outcomes`.
    start : array (N,)
    transient : int
        Transitions, or periods of the forcing, before the first sample.
    follow : bool
        Whether motions start where the one before ended.
    done : int
        How many of the values were looked at: all of them unless it was interrupted.
    next_start : array (N,)
        Where the motion at the next value starts.
    """

    system: KeptSystemName
    parameters: Mapping[str, Value]
    parameter: str
    state: str
    configuration: BlankText
    phase: BlankDigits
    values: Row
    samples: AnyTable
    outcomes: Integers
    start: Row
    transient: int
    follow: bool
    done: int
    next_start: Row

    @property
    def when(self) -> str:
        """When the state was taken."""
        if self.configuration is not None:
            return f"at each entry of {self.configuration}"
        return f"at the phase {self.phase:g} of the forcing"

    def plot(self, axes: Any = None) -> Any:
        """Draw the bifurcation diagram.

        Parameters
        ----------
        axes : matplotlib Axes, optional
            Where to draw; a figure of its own when omitted.

        Returns
        -------
        matplotlib Axes or Figure
            The Axes that were given, or the new figure.
        """
        return registered("draw_sweep")(self, axes)


def sweep(
    system: str | SystemKernels | DeclaredSystem,
    parameters: Mapping[str, object],
    name: str,
    values: Any,
    start: Mapping[str, object],
    *,
    state: str,
    configuration: str | None = None,
    phase: float | None = None,
    transient: int = 1000,
    samples: int = 60,
    follow: bool = True,
    threads: int | None = None,
    resume: Sweep | None = None,
    progress: Callable[[int], None] = lambda done: None,
) -> Sweep:
    """Follow motions over one parameter and take a state again and again.

    Parameters
    ----------
    system : str, System or SystemKernels
    parameters : mapping
        All others than `name`.
    name : str
        The parameter that varies.
    values : array (n,)
    start : mapping of state to number
        Where every motion starts.
    state : str
        The state that is taken.
    configuration : str, optional
        The state is taken at each entry of it.
    phase : float, optional
        Or once in each period of the forcing, when that has this phase, in radians. Of several
        forcings the first one counts.
    transient : int
        Transitions before the first sample; with a phase, periods of the forcing.
    samples : int
        Transitions among which the samples are taken; with a phase, samples.
    follow : bool
        Whether the motions at a value start where those before it ended, if that is possible,
        chunk by chunk of values; with a phase value by value. Else all start at `start`.
    threads : int, optional
        As many as processors when omitted.
    resume : Sweep, optional
        An interrupted one of the same question: what it has is not computed again.
    progress : callable
        Told how many values are done.

    Returns
    -------
    Sweep
        The samples of each value.

    Raises
    ------
    InputError
        For wrong names or numbers, a phase where there is no forcing, or another question's
        sweep to resume.
    Interrupted
        By Ctrl-C; its `partial` is the Sweep until then.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> data = dict(chi="0.5", eta=1, us1=1, us2=1, ur1="4.0195", ur2="1.4831")
    >>> diagram = ns.sweep(
    ...     "dry-friction", data, "V", [0.9, 1.0], dict(x1=0, x2=0, v1=0, v2=0),
    ...     state="x1", configuration="stick-stick", transient=40, samples=12,
    ... )
    >>> len(diagram.values)
    2
    """
    kernels = kernels_of(system)
    structure = structure_of(kernels)
    structure.check_listed("a sweep")
    if state not in structure.states:
        raise unknown_name("state", state, structure.states)
    if (configuration is None) == (phase is None):
        raise InputError("the state is taken at a configuration, or at a phase: give one of them")
    if configuration is not None:
        structure.configuration(configuration)
    elif not structure.forcing:
        raise InputError(f"{kernels.name} has no forcing, whose phase could be waited for")
    try:
        grid = np.asarray(values, dtype=float)
    except (TypeError, ValueError):
        grid = np.empty(0)
    if grid.ndim != 1 or not grid.size or not np.isfinite(grid).all():
        raise InputError(f"the values of {name} are no row of finite numbers")
    if name in parameters:
        raise InputError(f"parameter {name} is both given and swept")
    first = start_state(structure, start)
    check_sweep(grid.size, checked_count("samples", samples, 1))
    question = Sweep(
        system=kernels.name,
        parameters={key: as_value(value) for key, value in parameters.items()},
        parameter=name,
        state=state,
        configuration=configuration,
        phase=None if phase is None else float(phase),
        values=grid,
        samples=np.full((grid.size, samples), np.nan),
        outcomes=np.full(grid.size, int(Outcome.UNCLASSIFIED)),
        start=first,
        transient=checked_count("transient", transient, 0),
        follow=follow,
        done=0,
        next_start=first,
    )
    diagram = question if resume is None else _resumed(question, resume)
    look = _at_entries if phase is None else _at_phase
    followed = diagram.done > 0
    forced = list(structure.forced)
    try:
        while diagram.done < grid.size:
            end = min(diagram.done + (_CHUNK if phase is None else 1), grid.size)
            here = slice(diagram.done, end)
            found, outcomes, last, possible = look(kernels, diagram, here, threads)
            followed |= possible
            begin = last.copy() if follow and np.isfinite(last).all() else first
            if len(forced) > 2:  # at other frequencies they are together at other times
                begin[forced] = first[forced]
            taken, ends = diagram.samples.copy(), diagram.outcomes.copy()
            taken[here], ends[here] = found, outcomes
            diagram = replace(diagram, samples=taken, outcomes=ends, done=end, next_start=begin)
            progress(end)
    except KeyboardInterrupt:
        raise Interrupted(diagram) from None
    if not followed:
        raise InputError(f"for no value of {name} are the parameters and the start possible")
    return diagram


def check_sweep(count: int, samples: int) -> None:
    """Refuse a diagram that does not fit in memory: it is copied once for each report.

    `samples` is the number at each of `count` values. Raises `TooLarge`.
    """
    what = f"{samples} samples at each of {count} values"
    check_memory(what, 2 * BYTES * count * (samples + 1))


def _resumed(question: Sweep, known: Sweep) -> Sweep:
    """The interrupted sweep of the same question; raises `InputError` if it is of another one."""
    check_same_system("sweep", load_system(question.system), load_system(known.system))
    found = ("system", "samples", "outcomes", "done", "next_start")
    asked = {name: value for name, value in vars(question).items() if name not in found}
    count = "number of samples"
    check_same_question(
        "sweep",
        {**asked, count: question.samples.shape},
        {**vars(known), count: known.samples.shape},
    )
    return replace(known, system=question.system)


# samples, what the motions settle on, where the last one ended, whether one was possible
Looked = tuple[np.ndarray, np.ndarray, np.ndarray, bool]


def _at_entries(kernels: SystemKernels, diagram: Sweep, here: slice, threads: int | None) -> Looked:
    """Samples at the entries of a configuration, for some of the values."""
    structure, taken = structure_of(kernels), diagram.samples.shape[1]
    point = {**diagram.parameters, diagram.parameter: diagram.values[here]}
    motions = simulate_many(
        kernels,
        point,
        diagram.next_start,
        transitions=diagram.transient + taken,
        keep=max(taken, _KEPT),
        threads=threads,
    )
    # a motion that ended early has kept entries of its transient too
    places = motions.transitions[:, None] - np.arange(taken)[::-1]
    where = structure.configuration(str(diagram.configuration))
    entered = (motions.last_configurations[:, -taken:] == where) & (places > diagram.transient)
    states = motions.last_states[:, -taken:, structure.states.index(diagram.state)]
    outcomes = settled(kernels, point, motions, threads).outcomes
    possible = bool((motions.status >= 0).any())
    return np.where(entered, states, np.nan), outcomes, motions.states[-1], possible


def _at_phase(kernels: SystemKernels, diagram: Sweep, here: slice, threads: int | None) -> Looked:
    """Samples at a phase of the forcing, for one value, as a stroboscope shows the motion."""
    taken, first = diagram.samples.shape[1], diagram.start
    states, possible = np.full((taken, len(first)), np.nan), False
    outcomes, last = np.array([int(Outcome.ILLEGAL)]), states[-1]
    point = {**diagram.parameters, diagram.parameter: float(diagram.values[here][0])}
    parameter_points(kernels, point)  # refuses wrong names
    with suppress(InputError):  # no such system, or no state at which a motion may start
        system = piecewise(kernels, point)
        start, chosen = _beginning(system, diagram.next_start, first)
        possible = True
        (cosine, sine), *_ = system.structure.forcing
        speed = float(system.forcing_speeds[0])
        angle, period = np.arctan2(start[sine], start[cosine]), 2 * np.pi / abs(speed)
        wait = float(((diagram.phase or 0.0) - angle) / speed) % period
        times = wait + period * (diagram.transient + np.arange(taken))
        run = follow_motion(system, start, chosen, float(times[-1] + period))
        reached = times <= run.end if run.status != Status.QUIET else np.full(taken, True)
        phases = np.searchsorted(run.times, times[reached], side="right") - 1
        since, passed = times[reached] - run.times[phases], run.configurations[phases]
        states[reached] = phase_states(system, passed, since, run.states[phases])
        if np.isfinite(last).all():
            # what is at rest has moved by rounding, as no start may; the entry is exact
            last, _ = _beginning(system, last, run.states[phases[-1]])
    if np.isfinite(last).all():
        goes_on = simulate_many(
            kernels, point, last[None], transitions=_KEPT, keep=_KEPT, threads=threads
        )
        outcomes = settled(kernels, point, goes_on, threads).outcomes
    column = structure_of(kernels).states.index(diagram.state)
    return states[None, :, column], outcomes, last, possible


def _beginning(
    system: PiecewiseLinear, wanted: np.ndarray, other: np.ndarray
) -> tuple[np.ndarray, int]:
    """The first of two states at which a motion may start, and its configuration."""
    try:
        return wanted, configuration_of(system, wanted)
    except InputError:
        return other, configuration_of(system, other)

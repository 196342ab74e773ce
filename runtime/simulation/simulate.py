"""Exact simulation from event to event, of one motion or of many."""

from __future__ import annotations

import math
import os
from collections.abc import Mapping, Sequence
from types import ModuleType
from typing import TYPE_CHECKING, Any, overload

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.parallel import thread_pool
from nonsmooth.runtime.core.values import axes, by_name, real_array
from nonsmooth.runtime.core.workload import check_memory
from nonsmooth.runtime.model.engine_run import Run, Status
from nonsmooth.runtime.model.kernels import SystemKernels, compiled_engine, grown, kernels_of
from nonsmooth.runtime.model.loading.declared import DeclaredSystem
from nonsmooth.runtime.model.parameters import parameter_points
from nonsmooth.runtime.model.piecewise import (
    PiecewiseLinear,
    PointGroup,
    cut_tables,
    numbers_at,
    piecewise,
    piecewise_at,
)
from nonsmooth.runtime.model.structure import structure_of
from nonsmooth.runtime.simulation.engines import (
    Trajectories,
    entry_size,
    in_order,
    no_ends,
    run_compiled,
    run_motions,
    store_end,
)
from nonsmooth.runtime.simulation.starting import (
    check_phases,
    configuration_of,
    configurations_of,
    start_state,
    start_states,
    visits_behind,
    with_starts,
)
from nonsmooth.runtime.simulation.trajectory import Trajectory

if TYPE_CHECKING:
    from nonsmooth.runtime.core.values import Number, Numbers

AnySystem = str | SystemKernels | DeclaredSystem

_LEAST_CHUNK, _LARGEST_CHUNK = 64, 4096  # motions given to a thread at a time
LARGEST_COUNT = 2**62


@overload
def simulate(  # type: ignore[overload-overlap]  # what has no array is one motion
    system: AnySystem,
    parameters: Mapping[str, Number],
    state: Mapping[str, Number] | Sequence[Number],
    configuration: str | None = None,
    *,
    until: float = math.inf,
    transitions: int | None = None,
) -> Trajectory: ...
@overload
def simulate(
    system: AnySystem,
    parameters: Mapping[str, Number | Numbers],
    state: Mapping[str, Number | Numbers] | Sequence[Number | Numbers],
    configuration: str | np.ndarray | None = None,
    *,
    until: float | Numbers = math.inf,
    transitions: int | None = None,
    keep: int = 0,
    threads: int | None = None,
) -> Trajectories: ...
@overload
def simulate(
    system: AnySystem,
    parameters: Mapping[str, object],
    state: Any,
    configuration: Any = None,
    *,
    until: Any = math.inf,
    transitions: int | None = None,
    keep: int = 0,
    threads: int | None = None,
) -> Any: ...


def simulate(
    system: AnySystem,
    parameters: Mapping[str, object],
    state: Sequence[Any] | np.ndarray | Mapping[str, Any],
    configuration: Any = None,
    *,
    until: Any = math.inf,
    transitions: int | None = None,
    keep: int = 0,
    threads: int | None = None,
) -> Trajectory | Trajectories:
    """Follow one motion from event to event, or many motions where arrays are given.

    Inside a configuration the motion is known in closed form; the first crossing of a
    boundary is found with a guarantee, so that no event is missed. Many motions are followed
    in the compiled engine, in threads.

    Parameters
    ----------
    system : str, System or SystemKernels
        A system that `nonsmooth list` shows.
    parameters : mapping of str to number, text, Value or array
        All physical parameters. Arrays broadcast against each other and the starts.
    state : mapping of str to number or array, sequence (N,) or array (..., N)
        Physical coordinates: positions, then velocities.
    configuration : str or array (...) of int, optional
        Where it starts; found by the system's own conditions when omitted. An array has the
        indices with which `Trajectories` tells where motions ended, which are not checked again.
    until : float or array (...)
        Time at which to end.
    transitions : int, optional
        Number of transitions after which to end; at least one of the two has to be given.
    keep : int
        Of many motions, how many of the last entries of each to keep: memory grows with what is
        returned only.
    threads : int, optional
        Of many motions; as many as there are processors when omitted.

    Returns
    -------
    Trajectory or Trajectories
        Of one motion the start, and the state behind each transition. Of many, where parameters,
        starts, configurations or ends are arrays, where and how each ended, and what was kept.

    Raises
    ------
    InputError
        For wrong names, numbers, shapes or counts, or an end that is none. For one motion also
        if its start belongs to no configuration or not to the one that is named, or if the
        forcings are at no time as at the start; of many motions each has a status of its own.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> data = {"m1": 1, "m2": 2, "k1": 1, "k2": 5, "r": "0.5"}
    >>> motion = ns.simulate("rigid-stop", data, [0, 0, 1.5, 0], transitions=2)
    >>> motion.boundaries[1:]
    (('first-reaches-stop',), ('first-reaches-stop',))
    >>> ends = ns.simulate("rigid-stop", data, [[0, 0, 1.5, 0], [0, 0, 2, 0]], transitions=4)
    >>> ends.states.shape
    (2, 4)
    """
    values = by_name("parameters", parameters)
    alone = [*values.values(), until, configuration]
    alone += state.values() if isinstance(state, Mapping) else ()
    if any(map(axes, alone)) or axes(state) > 1:
        return simulate_many(
            system, values, state, configuration,
            until=until, transitions=transitions, keep=keep, threads=threads,
        )  # fmt: skip
    if keep or threads is not None:
        raise InputError("keep and threads: of many motions only, whose starts are an array")
    return simulate_one(system, values, state, configuration, until=until, transitions=transitions)


def simulate_one(
    system: AnySystem,
    parameters: Mapping[str, object],
    state: Any,
    configuration: str | None = None,
    *,
    until: Any = math.inf,
    transitions: int | None = None,
) -> Trajectory:
    """Follow one motion, as `simulate` does where numbers are given."""
    kernels = kernels_of(system)
    pieces = piecewise(kernels, parameters)
    start = start_state(pieces.structure, state)
    check_phases(pieces, start)
    end = real_array("until", until)
    if end.ndim:
        raise InputError("until is no number")
    most = _most_transitions(end, transitions)
    if most is not None and math.isinf(end):
        check_memory(f"{most} transitions", most * entry_size(len(start)))
    if configuration is None:
        point = np.array([[float(value) for value in pieces.parameters.values()]])
        visited = with_starts(kernels, point, np.zeros(1, dtype=int), start[None])
    else:
        visited = grown(kernels, [(configuration, ())])
    if visited is not kernels:
        kernels, pieces = visited, piecewise(visited, parameters)
    chosen = configuration_of(pieces, start, configuration)
    while True:
        run = follow(pieces, start, chosen, float(end), most)
        structure, last = pieces.structure, int(run.configurations[-1])
        missing = [(last, run.missing)] if run.missing else []
        visited = grown(kernels, visits_behind(structure, [last], missing))
        if visited is kernels:
            return Trajectory(pieces, run)
        kernels, pieces = visited, piecewise(visited, parameters)


def follow(
    system: PiecewiseLinear,
    state: np.ndarray,
    configuration: int,
    until: float = math.inf,
    transitions: int | None = None,
) -> Run:
    """Follow one motion from a state (N,) in the compiled engine, or else in Python.

    The start is not checked, and the system is in double precision. Without a number of
    `transitions` only the time `until` ends the motion.
    """
    engine = compiled_engine()
    if engine is not None:
        return run_compiled(engine, system, state, configuration, until, transitions)
    from nonsmooth.runtime.simulation.stepping import run

    return run(system, state, configuration, until, transitions)


def simulate_many(
    system: AnySystem,
    parameters: Mapping[str, Any],
    states: Any,
    configurations: str | np.ndarray | None = None,
    *,
    until: Any = math.inf,
    transitions: int | None = None,
    keep: int = 0,
    threads: int | None = None,
) -> Trajectories:
    """Follow many motions in the compiled engine, in threads, as `simulate` does of arrays.

    States are (..., N), or arrays by name; the arrays (...) of parameters, configurations and
    ends broadcast.
    """
    kernels = grown(kernels_of(system))
    structure = structure_of(kernels)
    points, shape = parameter_points(kernels, parameters)
    starts, size = start_states(structure, states), len(structure.states)
    limits = real_array("until", until)
    most = _most_transitions(limits, transitions)
    kept = checked_count("keep", keep, 0)
    workers = (os.cpu_count() or 1) if threads is None else checked_count("threads", threads, 1)
    try:
        common = np.broadcast_shapes(shape, starts.shape[:-1], limits.shape)
    except ValueError:
        raise InputError(
            f"parameters {shape}, states {starts.shape} and until {limits.shape} do not broadcast"
        ) from None
    which = np.broadcast_to(np.arange(len(points)).reshape(shape), common).ravel()
    flat = np.broadcast_to(starts, (*common, size)).reshape(-1, size)
    until_each = np.broadcast_to(limits, common).ravel()
    wanted, given = (
        (None, np.broadcast_to(configurations, common).ravel())
        if isinstance(configurations, np.ndarray)
        else (configurations, None)
    )
    size_of_one = entry_size(size) * (1 + kept)
    check_memory(f"{len(flat)} motions of {kept} entries", len(flat) * size_of_one)
    engine = compiled_engine()
    chunk = min(max(len(flat) // (8 * workers), _LEAST_CHUNK), _LARGEST_CHUNK)
    if wanted is not None:
        kernels = grown(kernels, [(wanted, ())])
    elif given is None:
        kernels = with_starts(kernels, points, which, flat)

    def part(begin: int) -> Trajectories:
        here = slice(begin, begin + chunk)
        used, places = np.unique(which[here], return_inverse=True)
        states, limits = flat[here], until_each[here]
        ends, now, left = no_ends(structure, len(states), kept), kernels, np.arange(len(states))
        while True:
            missing: list[tuple[int, int]] = []
            for group in numbers_at(now, points[used]):
                row_of = np.full(len(used), -1)
                row_of[group.places] = np.arange(len(group.places))
                members = left[row_of[places[left]] >= 0]
                rows_of = row_of[places[members]]
                if given is not None:
                    found = given[here][members]
                else:
                    found = _configurations(group, rows_of, states[members], wanted)
                sound = found >= 0
                members = members[sound]
                _follow_many(
                    engine, now, group, points[used[group.places]], rows_of[sound], members,
                    states, found[sound], limits, most, ends, missing,
                )  # fmt: skip
            left = left[ends.status[left] == Status.UNDECLARED]
            entered = ends.configurations[left].tolist()
            larger = grown(now, visits_behind(structure_of(now), entered, missing))
            if larger is now:
                break
            now = larger
        return ends

    begins = range(0, len(flat), chunk)
    with thread_pool(workers) as pool:
        parts = list(pool.map(part, begins))
    if not parts:
        parts = [no_ends(structure, 0, kept)]
    arrays = zip(*(each.arrays for each in parts), strict=True)
    joined = in_order(Trajectories(structure_of(grown(kernels)), *map(np.concatenate, arrays)))
    return joined.reshaped(*common)


def _configurations(
    group: PointGroup, rows_of: np.ndarray, states: np.ndarray, wanted: str | None
) -> np.ndarray:
    """Configuration of each start for the numbers in its row; -1 if there is none."""
    fields, rows, _ = cut_tables(group.structure, group.flat)
    if len(rows) > 1:
        fields, rows = fields[rows_of], rows[rows_of]
    found = configurations_of(group.structure, fields, rows, states, wanted)
    found[~np.isfinite(group.flat).all(axis=1)[rows_of]] = -1
    return found


def _follow_many(
    engine: ModuleType | None,
    kernels: SystemKernels,
    group: PointGroup,
    points: np.ndarray,
    rows_of: np.ndarray,
    members: np.ndarray,
    states: np.ndarray,
    configurations: np.ndarray,
    until: np.ndarray,
    most: int | None,
    ends: Trajectories,
    missing: list[tuple[int, int]],
) -> None:
    """Follow the motions `members` of a chunk, each with the numbers in its row of a group.

    Their ends are written to `ends`. Boundaries that are reached together with nothing
    declared for them are added to `missing`.
    """
    if engine is not None:
        found = run_motions(
            engine, group.structure, group.flat, rows_of, states[members], configurations,
            until[members], most, ends.last_times.shape[1], missing,
        )  # fmt: skip
        for whole, piece in zip(ends.arrays, found.arrays, strict=True):
            whole[members] = piece
        return
    systems: dict[int, PiecewiseLinear] = {}
    for i, row, configuration in zip(
        members.tolist(), rows_of.tolist(), configurations, strict=True
    ):
        if row not in systems:
            systems[row] = piecewise_at(kernels, points[row])
        run = follow(systems[row], states[i], int(configuration), float(until[i]), most)
        store_end(ends, i, systems[row], run)
        if run.missing:
            missing.append((int(run.configurations[-1]), run.missing))


def _most_transitions(until: np.ndarray, transitions: int | None) -> int | None:
    """The largest number of transitions; `InputError` unless something ends each motion."""
    if not (until > 0).all():
        wrong = float(until[~(until > 0)].flat[0])
        raise InputError(f"until = {wrong!r} is not a positive time")
    if transitions is None:
        if np.isinf(until).any():
            raise InputError("nothing ends the motion: give until, or transitions")
        return None
    return checked_count("transitions", transitions, 1)


def checked_count(label: str, value: object, least: int, most: int = LARGEST_COUNT) -> int:
    """The integer that is given; `InputError` unless it is one from `least` to `most`.

    `label` names it in the message.
    """
    if isinstance(value, bool) or not isinstance(value, int | np.integer) or value < least:
        raise InputError(f"{label} = {value!r} is not an integer from {least}")
    if value > most:
        raise InputError(f"{label} is more than {most}")
    return int(value)

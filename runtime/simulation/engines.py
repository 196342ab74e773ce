"""The engine that follows a motion: compiled where it is built, else in Python.

NONSMOOTH_BACKEND chooses, as it does for the kernels.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, fields, replace
from types import ModuleType
from typing import Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.registry import Shown
from nonsmooth.runtime.core.workload import BYTES, check_memory
from nonsmooth.runtime.events.transition_choice import batch_decider
from nonsmooth.runtime.model.boundary_sets import mask_type, masks_of, no_words
from nonsmooth.runtime.model.engine_layout import layout_of, numbers_of
from nonsmooth.runtime.model.engine_run import Grazing, Run, Status
from nonsmooth.runtime.model.flows import flow_states
from nonsmooth.runtime.model.piecewise import PiecewiseLinear
from nonsmooth.runtime.model.structure import Structure

_FIRST_ENTRIES, _GRAZINGS = 4096, 64


@dataclass(frozen=True, eq=False, repr=False)
class Trajectories(Shown):
    """Ends of many motions; arrays have the common shape of what was given.

    Attributes
    ----------
    structure : Structure
    times : array (...)
        At which each motion ended.
    states : array (..., N)
        At that time, behind the last transition.
    configurations : array (...) of int32
        Indices of `structure.configurations`; -1 where the start belongs to none.
    transitions : array (...) of int64
    grazings : array (...) of int64
        How many boundaries were touched and not crossed.
    status : array (...) of int64
        Members of `nonsmooth.runtime.model.engine_run.Status`; -1 where nothing was simulated.
    last_times : array (..., kept)
    last_configurations : array (..., kept) of int32
    last_sets : array (..., kept)
        Boundaries that were reached together, as a mask.
    last_states : array (..., kept, N)
        The last entries in their order, behind the transitions; NaN and -1 in front of the
        start.
    """

    structure: Structure
    times: np.ndarray
    states: np.ndarray
    configurations: np.ndarray
    transitions: np.ndarray
    grazings: np.ndarray
    status: np.ndarray
    last_times: np.ndarray
    last_configurations: np.ndarray
    last_sets: np.ndarray
    last_states: np.ndarray

    def at(self, places: Any) -> Trajectories:
        """Select motions by their places on the first axis.

        Parameters
        ----------
        places : int, slice or array
            What indexes an array.

        Returns
        -------
        Trajectories

        Raises
        ------
        InputError
            For what is no index of the motions.
        """
        try:
            return self._with(lambda array: array[places])
        except (IndexError, TypeError):
            raise InputError(f"places: no index of {self.status.shape} motions") from None

    def reshaped(self, *shape: int) -> Trajectories:
        """Give the same motions in another common shape.

        Parameters
        ----------
        *shape : int
            Lengths of its axes.

        Returns
        -------
        Trajectories

        Raises
        ------
        InputError
            If another number of motions has that shape.
        """
        inner = self.status.ndim
        try:
            return self._with(lambda array: array.reshape((*shape, *array.shape[inner:])))
        except ValueError:
            raise InputError(f"shape = {shape} is none of {self.status.size} motions") from None

    @property
    def arrays(self) -> list[np.ndarray]:
        """All arrays, in the order of the fields."""
        return [getattr(self, field.name) for field in fields(self)[1:]]

    def _with(self, change: Callable[[np.ndarray], np.ndarray]) -> Trajectories:
        return Trajectories(self.structure, *map(change, self.arrays))


def run_compiled(
    engine: ModuleType,
    system: PiecewiseLinear,
    state: np.ndarray,
    configuration: int,
    until: float = math.inf,
    transitions: int | None = None,
) -> Run:
    """Follow one motion from a state (N,) in the compiled engine, in double precision.

    Without a number of `transitions` only `until` ends the motion. A system or state that
    is not finite raises `InputError`, and more transitions than memory holds raise
    `TooLarge`.
    """
    structure = system.structure
    size = len(structure.states)
    layout, numbers = layout_of(structure), numbers_of(system)
    if not (np.isfinite(numbers).all() and np.isfinite(state).all()):
        raise InputError("the system or the state is not finite")
    most = np.iinfo(np.int64).max if transitions is None else transitions
    options: list[tuple[tuple[int, ...], int]] = []
    missing: list[tuple[int, int]] = []
    decide = batch_decider(structure, numbers[None], options, missing)
    # unknown counts: once more with room for twice as many
    entries, touches = min(most + 1, _FIRST_ENTRIES), _GRAZINGS
    while True:
        times, kept = np.empty(entries), np.empty(entries, dtype=np.int32)
        before, after = np.empty((entries, size)), np.empty((entries, size))
        sets, grazings = no_words(structure, (entries,)), np.empty((touches, 4))
        counts, ends = np.empty(3, dtype=np.int64), np.array([float(until)])
        engine.simulate(
            layout,
            numbers,
            np.zeros(1, dtype=np.int32),
            np.array(state, dtype=float),
            np.array([configuration], dtype=np.int32),
            ends,
            min(most, entries),
            times,
            kept,
            before,
            after,
            sets,
            grazings,
            counts,
            decide,
        )
        status, done, touched = counts.tolist()
        if done < entries and touched <= touches:
            break
        touches = max(touches, touched)
        if done >= entries:
            entries = min(most + 1, 2 * entries)
            # as many as there will be if it goes on like this, or as are asked for
            expected = max(entries, min(most, done * float(until) / times[done - 1]))
            check_memory(f"{expected:.3g} transitions", expected * entry_size(size))
    return Run(
        times[: done + 1].copy(),
        kept[: done + 1].copy(),
        before[: done + 1].copy(),
        after[: done + 1].copy(),
        masks_of(structure, sets[: done + 1].copy()),
        tuple(
            Grazing(time, int(where), int(boundary), depth)
            for time, where, boundary, depth in grazings[:touched].tolist()
        ),
        Status(status),
        float(ends[0]),
        *(options[-1] if status == Status.AMBIGUOUS else ((), 0)),
        missing[-1][1] if missing and status == Status.UNDECLARED else 0,
    )


def entry_size(size: int) -> int:
    """Bytes of one entry of a motion with `size` states."""
    return BYTES * (2 + size)


def no_ends(structure: Structure, count: int, kept: int) -> Trajectories:
    """Ends of `count` motions that were not simulated: arrays of NaN, -1 and 0.

    They have the shapes that the compiled engine fills, with `kept` entries for each
    motion.
    """
    size = len(structure.states)
    return Trajectories(
        structure,
        np.full(count, np.nan),
        np.full((count, size), np.nan),
        np.full(count, -1, dtype=np.int32),
        np.zeros(count, dtype=np.int64),
        np.zeros(count, dtype=np.int64),
        np.full(count, -1, dtype=np.int64),
        np.full((count, kept), np.nan),
        np.full((count, kept), -1, dtype=np.int32),
        np.zeros((count, kept), dtype=mask_type(structure)),
        np.full((count, kept, size), np.nan),
    )


def in_order(ends: Trajectories) -> Trajectories:
    """The ends, with the last entries in the order of time instead of that of the ring buffer."""
    kept = ends.last_times.shape[1]
    if kept == 0:
        return ends
    first = (ends.transitions + 1 - kept)[:, None]
    places = np.arange(len(first))[:, None], (first + np.arange(kept)) % kept
    turned = (array[places] for array in ends.arrays[6:])
    return Trajectories(ends.structure, *ends.arrays[:6], *turned)


def store_end(ends: Trajectories, place: int, system: PiecewiseLinear, run: Run) -> None:
    """Write the end and the last entries of one motion as the compiled engine writes them.

    They go to index `place` of `ends`; the system is in double precision.
    """
    kept, last = ends.last_times.shape[1], len(run.times) - 1
    where = int(run.configurations[-1])
    since = np.array([run.end - run.times[-1]])
    with np.errstate(over="ignore", invalid="ignore"):  # of a motion that has escaped
        ends.states[place] = flow_states(system, where, since, run.states[-1])[0]
    ends.configurations[place], ends.times[place] = where, run.end
    ends.transitions[place], ends.grazings[place] = last, len(run.grazings)
    ends.status[place] = run.status
    for entry in range(max(0, last + 1 - kept), last + 1):
        ends.last_times[place, entry % kept] = run.times[entry]
        ends.last_configurations[place, entry % kept] = run.configurations[entry]
        ends.last_sets[place, entry % kept] = run.sets[entry]
        ends.last_states[place, entry % kept] = run.states[entry]


def run_motions(
    engine: ModuleType,
    structure: Structure,
    numbers: np.ndarray,
    points: np.ndarray,
    states: np.ndarray,
    configurations: np.ndarray,
    until: np.ndarray,
    transitions: int | None,
    kept: int = 0,
    missing: list[tuple[int, int]] | None = None,
) -> Trajectories:
    """Follow many motions in the compiled engine, one after the other, without the GIL.

    The parameter points `numbers` (p, size) are those of
    `nonsmooth.runtime.model.piecewise.numbers_at`; `points` (count,) has the row of each
    motion. The starts are `states` (count, N) in `configurations` (count,), and `until` is
    (count,). Of each motion the last `kept` entries are kept. The list `missing` receives
    the configurations in which motions end because nothing is declared, each with the mask
    of the boundaries that are reached together.
    """
    count = len(states)
    ends, sets = no_ends(structure, count, kept), no_words(structure, (count, kept))
    ends.states[:], ends.configurations[:], ends.times[:] = states, configurations, until
    counts = np.zeros((count, 3), dtype=np.int64)
    engine.simulate(
        layout_of(structure),
        np.ascontiguousarray(numbers, dtype=float),
        np.ascontiguousarray(points, dtype=np.int32),
        ends.states,
        ends.configurations,
        ends.times,
        np.iinfo(np.int64).max if transitions is None else transitions,
        ends.last_times,
        ends.last_configurations,
        np.empty(0),
        ends.last_states,
        sets,
        np.empty((count, 0, 4)),
        counts,
        batch_decider(structure, numbers, [], [] if missing is None else missing),
    )
    return replace(
        ends,
        last_sets=masks_of(structure, sets),
        status=counts[:, 0],
        transitions=counts[:, 1],
        grazings=counts[:, 2],
    )

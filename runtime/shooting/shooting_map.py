"""Itineraries of a system, and their shooting map in arrays.

An itinerary is a cyclic sequence of phases. Given the start and the dwell times, its shooting
map gives each phase's end, what closure and the switching conditions miss, and the derivatives
of all that, in which the change of each dwell time is eliminated: its switching condition,
linearised, makes it an affine function of the change of the start. Arrays may have leading
axes, one point each, and hold floats, complex or mpmath numbers.

Its derivatives by dwell times, start and a parameter ask for no modes: flows are exponentials of
the fields, by the compiled engine where it is built. The same on NumPy serves elsewhere, with a
tiny imaginary part for the derivative (Al-Mohy and Higham, 2010).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from itertools import accumulate, pairwise
from typing import Any, NamedTuple

import numpy as np

from nonsmooth.runtime.core.arithmetic import Mpmath
from nonsmooth.runtime.core.complex_steps import imaginary_parts, stepped
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.exponentials.matrices import exponentials, inverses
from nonsmooth.runtime.model.factored_flows import (
    FactoredFlows,
    Flows,
    arrays_of,
    cut_flows,
    flows_size,
)
from nonsmooth.runtime.model.flows import exponential
from nonsmooth.runtime.model.kernels import SystemKernels, compiled_engine
from nonsmooth.runtime.model.modes.natural_units import balanced
from nonsmooth.runtime.model.piecewise import PiecewiseLinear, tables_at
from nonsmooth.runtime.model.structure import FORCING_PHASE, Structure, TransitionShape
from nonsmooth.runtime.model.time_functions import functions_at


@dataclass(frozen=True, eq=False)
class ItineraryShape:
    """An itinerary of a system, phase by phase, with the transition that ends each phase."""

    structure: Structure
    # names of configuration and boundary; boundaries reached together as ``"a+b"``
    itinerary: tuple[tuple[str, str], ...]
    configurations: tuple[int, ...]  # indices
    # index among the configuration's; of several the first, whose switching condition is solved;
    # None for the forcing's phase, at which a configuration is not left
    boundaries: tuple[int | None, ...]
    transitions: tuple[TransitionShape, ...]

    @cached_property
    def rows(self) -> tuple[int, ...]:
        """Row of the boundary, or of the forcing's phase, that ends each phase."""
        ends = zip(self.configurations, self.boundaries, strict=True)
        return tuple(
            _forcing_row_of(self.structure) if b is None else self.structure.boundaries[c][b].row
            for c, b in ends
        )

    @property
    def uninterrupted(self) -> bool:
        """Whether no boundary is reached: the motion stays in one configuration."""
        return self.boundaries == (None,)

    @property
    def one_sided(self) -> bool:
        """Whether boundaries are reached together: nearby motions have other itineraries then."""
        return any(len(transition.boundaries) > 1 for transition in self.transitions)

    @cached_property
    def packed(self) -> np.ndarray:
        """The cycle as the compiled engine reads it, an int32 array.

        It has configurations, rows and resets of the phases, then the pairs of forcing states.
        """
        resets = [t.reset for t in self.transitions]
        parts = (self.configurations, self.rows, resets, self.structure.forced)
        return np.array([place for part in parts for place in part], dtype=np.int32)

    def at(self, structure: Structure) -> ItineraryShape:
        """The same cycle with the modes of a structure, that of the system at a parameter point."""
        return replace(self, structure=structure)

    def rotated(self, first: int) -> ItineraryShape:
        """The same cycle, beginning with the phase at place `first`."""
        return self.phases([*range(first, len(self)), *range(first)])

    def phases(self, places: Sequence[int]) -> ItineraryShape:
        """The phases at some places, one after the other."""
        parts = (self.itinerary, self.configurations, self.boundaries, self.transitions)
        chosen: Any = (tuple(part[place] for place in places) for part in parts)
        return ItineraryShape(self.structure, *chosen)

    def __len__(self) -> int:
        return len(self.itinerary)


def itinerary_shape(structure: Structure, itinerary: Sequence[tuple[str, str]]) -> ItineraryShape:
    """The shape of an itinerary of configurations and the boundaries that end their phases.

    Between two phases the first transition that is declared for the boundary and leads to the
    next configuration is taken. Boundaries that are reached together are one name ``"a+b"``
    or a sequence of names; the first one's switching condition is solved. A motion that
    reaches no boundary is one phase that ends with ``forcing-phase``, where the phase of the first
    forcing begins anew. Raises `InputError` for an empty or malformed itinerary, unknown names, or
    phases between which the system declares no transition.
    """
    try:
        pairs = tuple((str(c), b if isinstance(b, str) else "+".join(b)) for c, b in itinerary)
    except (TypeError, ValueError):
        raise InputError("an itinerary is a sequence of (configuration, boundary)") from None
    if not pairs:
        raise InputError("the itinerary has no phase")
    return _shape_of(structure, pairs)


@lru_cache(maxsize=1024)
def _shape_of(structure: Structure, pairs: tuple[tuple[str, str], ...]) -> ItineraryShape:
    """Return the shape of an itinerary whose names are joined; errors as `itinerary_shape`."""
    configurations = tuple(structure.configuration(c) for c, _ in pairs)
    if [boundary for _, boundary in pairs] == [FORCING_PHASE]:
        _forcing_row_of(structure)
        staying = TransitionShape(frozenset(), (), 0, configurations[0])  # reset 0: the identity
        return ItineraryShape(structure, pairs, configurations, (None,), (staying,))
    sets = [
        [structure.boundary(c, name) for name in joined.split("+")]
        for c, (_, joined) in zip(configurations, pairs, strict=True)
    ]
    transitions = []
    for i, (source, reached) in enumerate(zip(configurations, sets, strict=True)):
        target = configurations[(i + 1) % len(pairs)]
        found = [
            t
            for t in structure.transitions[source]
            if t.boundaries == set(reached) and t.target == target
        ]
        if not found:
            after = structure.configurations[target]
            raise InputError(
                f"{structure.name} has no transition from {pairs[i][0]} to {after} at {pairs[i][1]}"
            )
        transitions.append(found[0])
    boundaries = tuple(reached[0] for reached in sets)
    return ItineraryShape(structure, pairs, configurations, boundaries, tuple(transitions))


def _forcing_row_of(structure: Structure) -> int:
    """Row that is zero where the forcing's phase begins anew.

    Raises `InputError` if the system has no forcing.
    """
    if structure.forcing_row is None:
        raise InputError(f"{structure.name} has no forcing whose phase could begin anew")
    return structure.forcing_row


def guesses(name: str, given: Any, count: int, *, positive: bool = False) -> np.ndarray:
    """Guesses (..., count) as floats; `name` says in the message what they are for.

    Raises `InputError` if they are not `count`, not finite, or not positive where they must be.
    """
    try:
        array = np.asarray(given, dtype=float)
    except (TypeError, ValueError):
        raise InputError(f"{name}: not real numbers") from None
    if array.ndim == 0 or array.shape[-1] != count:
        found = 1 if array.ndim == 0 else array.shape[-1]
        raise InputError(f"{name}: {found} given, {count} needed")
    if not np.isfinite(array).all() or (positive and not (array > 0).all()):
        raise InputError(f"{name}: not all are finite{' and positive' if positive else ''}")
    return array


class Numbers(NamedTuple):
    """A system's numbers or derivatives of them, with leading axes where there are many points."""

    fields: np.ndarray  # (..., configurations, N, N + 1)
    rows: np.ndarray  # (..., R, N + 1)
    resets: np.ndarray  # (..., S, N, N + 1)
    # for each configuration (..., modes, 2); empty, as flows, if not asked for
    exponents: tuple[np.ndarray, ...] = ()
    # for each configuration (..., functions, N, N + 1), or FactoredFlows
    flows: tuple[Flows, ...] = ()

    def each(self, function: Callable[..., Any], *others: Numbers) -> Numbers:
        """What a function makes of fields, rows and resets, with those of other numbers beside."""
        return Numbers(*map(function, *(numbers[:3] for numbers in (self, *others))))


def relative_rates(
    numbers: Sequence[np.ndarray], changes: Sequence[np.ndarray], sizes: np.ndarray
) -> np.ndarray:
    """Largest relative change (q,) of functions of a state, such as boundaries, by q parameters.

    So a parameter that is zero has a size too: the one that changes a function by that
    function's size. `numbers` are functions (..., N + 1), such as fields and rows, `changes` their
    derivatives (q, ..., N + 1), and `sizes` (N,) those of the states.
    """
    state = np.append(sizes, 1.0)
    found = []
    for number, change in zip(numbers, changes, strict=True):
        size = (np.abs(number) @ state).ravel()
        moved = (np.abs(change) @ state).reshape(len(change), -1)
        found.append(moved[:, size > 0] / size[size > 0])
    return np.asarray(np.concatenate(found, axis=1).max(axis=1, initial=0.0))


def stepped_tables(
    kernels: SystemKernels, points: np.ndarray, steps: np.ndarray, lib: Mpmath | None
) -> Numbers:
    """Fields, rows and resets (k q, ...) at points (k, p), each with q steps (q, p).

    Points are in the system's order. `lib` is None in double precision; an `Mpmath` works with
    twice the digits that derivatives need.

    Examples
    --------
    >>> from nonsmooth.runtime.model.kernels import load_system
    >>> kernels = load_system("rigid-stop")  # parameters m1, m2, k1, k2, r
    >>> point = np.array([[1.0, 2.0, 1.0, 5.0, 0.5]])
    >>> resets = stepped_tables(kernels, point, np.eye(5)[[4]], None).resets
    >>> float(imaginary_parts(resets, None).min())  # by the restitution: v1 = -r v1 in front
    -1.0
    """
    every = stepped(points[:, None], steps, lib).reshape(len(points) * len(steps), len(points.T))
    if lib is None:
        return Numbers(*tables_at(kernels, every))
    size = len(kernels.table["states"])
    shapes = {
        "fields": (-1, size, size + 1),
        "rows": (-1, size + 1),
        "resets": (-1, size, size + 1),
    }
    convert = np.frompyfunc(lib.mp.convert, 1, 1)
    parts = ([kernels.source(kernel)(row.tolist(), lib=lib) for row in every] for kernel in shapes)
    return Numbers(
        *(
            convert(np.array(part, dtype=object)).reshape(len(every), *shape)
            for part, shape in zip(parts, shapes.values(), strict=True)
        )
    )


def finite_at(cycle: ItineraryShape, flat: np.ndarray) -> np.ndarray:
    """Bools (n,): whether all numbers that a cycle needs are finite.

    `flat` (n, size) is as `nonsmooth.runtime.model.piecewise.numbers_at` gives it.
    """
    numbers = numbers_in(cycle.structure, flat)
    parts = [numbers.fields, numbers.rows, numbers.resets]
    for configuration in {*cycle.configurations}:
        parts += [numbers.exponents[configuration], *arrays_of(numbers.flows[configuration])]
    sound = [np.isfinite(part).all(axis=tuple(range(1, part.ndim))) for part in parts]
    return np.asarray(np.all(sound, axis=0))


def numbers_in(system: PiecewiseLinear | Structure, flat: np.ndarray | None = None) -> Numbers:
    """Numbers of one point, or those of `flat` (..., size) for a structure.

    `flat` is as `numbers_at` gives it. Raises `InputError` for a structure without it.
    """
    if isinstance(system, PiecewiseLinear):
        return Numbers(system.fields, system.rows, system.resets, system.exponents, system.flows)
    if flat is None:
        raise InputError("a structure alone has no numbers")
    size, lead = len(system.states), flat.shape[:-1]
    parts = [flat[..., part].reshape(*lead, *shape) for part, shape in _layout(system)]
    cut = 3 + len(system.shapes)
    fields, rows, resets = parts[:3]
    flows = (
        cut_flows(modes, size, part) for modes, part in zip(system.shapes, parts[cut:], strict=True)
    )
    return Numbers(fields, rows, resets, tuple(parts[3:cut]), tuple(flows))


@lru_cache(maxsize=1024)
def _layout(structure: Structure) -> list[tuple[slice, tuple[int, ...]]]:
    """Where fields, rows, resets, exponents and flows are in numbers, and their shapes."""
    size, counts = len(structure.states), [len(modes) for modes in structure.shapes]
    shapes: list[tuple[int, ...]] = [
        (len(counts), size, size + 1),
        (structure.rows, size + 1),
        (structure.resets, size, size + 1),
        *((count, 2) for count in counts),
        *((flows_size(modes, size),) for modes in structure.shapes),
    ]
    ends = accumulate(map(math.prod, shapes), initial=0)
    return [(slice(*part), shape) for part, shape in zip(pairwise(ends), shapes, strict=True)]


def flow_at(structure: Structure, numbers: Numbers, configuration: int, time: Any, lib: Any) -> Any:
    """Flow (..., N, N + 1) of a configuration at times (...): matrix, then constant.

    Times are in the system's unit. If a structure has no modes the flow is the exponential of the
    field, at one mpmath time. `lib` is an arithmetic with `sin`, `cos` and `exp` of arrays.
    """
    if structure.modes is None:
        return exponential(numbers.fields[configuration], np.asarray(time).item(), lib)
    functions = functions_at(
        structure.modes[configuration], numbers.exponents[configuration], time, lib
    )
    parts = numbers.flows[configuration]
    if isinstance(parts, FactoredFlows):
        return parts.at(np.stack(np.broadcast_arrays(*functions), axis=-1))
    return sum(
        np.asarray(function)[..., None, None] * parts[..., place, :, :]
        for place, function in enumerate(functions)
    )


class Phase(NamedTuple):
    """Affine maps of one phase."""

    field: Any  # (..., N, N + 1), the rate of the state
    row: Any  # (..., 1, N + 1), the boundary function that is zero where the phase ends
    reset: Any  # (..., N, N + 1), the state behind the boundary


class Shooting(NamedTuple):
    """The shooting map of p phases at a start, and its derivatives by n unknowns.

    `shooting_map` gives sequences of columns, `shoot` arrays of the shapes below. Dwell times are
    unknowns or follow the start.
    """

    flows: Any  # (p, ..., N, N + 1)
    starts: Any  # (p + 1, ..., N), state at each phase's start; last the state after the chain
    ends: Any  # (p, ..., N), state at each phase's end
    velocities: Any  # (p, ..., N), velocity at each phase's end
    residual: Any  # (p, ...), boundary function at each phase's end
    speeds: Any  # (p, ...), rate of the boundary function; empty if dwell times are unknowns
    # (p, ..., n), derivative of each dwell time by the unknowns; if dwell times follow, by the
    # start, and last their change at a fixed start
    rates: Any
    slopes: Any  # (p, ..., n), derivative of the boundary functions; empty if dwell times follow
    variational: Any  # (..., N, n), derivative of the state after the chain


def applied(affine: Any, state: Any) -> Any:
    """Value (..., m, 1) of an affine map at a state (..., N, 1)."""
    return affine[..., :-1] @ state + affine[..., -1:]


def shooting_map(
    phases: Sequence[Phase],
    flows: Iterable[Any],
    start: Any,
    changes: Any,
    rates: Sequence[Any] | None = None,
) -> Shooting:
    """Carry a start, and its changes by each unknown, through a chain of phases.

    Behind a flow a change of the dwell time moves the state by its velocity. `flows` are those of
    the phases over their dwell times; `start` is a column in the system's units, and `changes` has
    one column for each unknown. `rates` has a row for each phase, the change of its dwell time by
    each unknown. Without them a dwell time changes such that its linearised switching condition is
    solved; the last unknown then stands for the 1 that multiplies constants.
    """
    state, starts = start, [start]
    found: list[tuple[Any, ...]] = []
    slopes, speeds = [], []
    for place, (phase, flow) in enumerate(zip(phases, flows, strict=True)):
        end, moved = applied(flow, state), flow[..., :-1] @ changes
        velocity, value = applied(phase.field, end), applied(phase.row, end)
        normal = phase.row[..., :-1]
        if rates is None:
            speeds.append(normal @ velocity)
            missed = normal @ moved
            missed[..., -1:] += value
            rate = -missed / speeds[-1]
        else:
            rate = rates[place]
        moved = moved + velocity * rate
        if rates is not None:
            slopes.append(normal @ moved)
        found.append((flow, end, velocity, value, rate))
        state, changes = applied(phase.reset, end), phase.reset[..., :-1] @ moved
        starts.append(state)
    parts = [list(part) for part in zip(*found, strict=True)]
    passed, ends, velocities, residual, taken = parts
    return Shooting(passed, starts, ends, velocities, residual, speeds, taken, slopes, changes)


def phases_in(cycle: ItineraryShape, numbers: Numbers) -> list[Phase]:
    """Fields, rows and resets of each phase of a cycle, as arrays."""
    return [
        Phase(
            numbers.fields[..., configuration, :, :],
            numbers.rows[..., row : row + 1, :],
            numbers.resets[..., transition.reset, :, :],
        )
        for configuration, row, transition in zip(
            cycle.configurations, cycle.rows, cycle.transitions, strict=True
        )
    ]


@np.errstate(all="ignore")  # where nothing is finite there is no orbit
def shoot(cycle: ItineraryShape, numbers: Numbers, dwell: Any, start: Any, lib: Any) -> Shooting:
    """The shooting map of one passage through a cycle, with dwell times that follow the start.

    Dwell times (..., p) and the start (..., N) are in the system's units, and `lib` is an
    arithmetic with `sin`, `cos` and `exp` of arrays. The n = N + 1 unknowns of the result are the
    start and the 1 that multiplies constants.
    """
    return shoot_along(cycle, numbers, flows_along(cycle, numbers, dwell, lib), start)


def flows_along(cycle: ItineraryShape, numbers: Numbers, dwell: Any, lib: Any) -> list[Any]:
    """Flows (..., N, N + 1) of the phases of a cycle over their dwell times (..., p)."""
    return [
        flow_at(cycle.structure, numbers, configuration, dwell[..., place], lib)
        for place, configuration in enumerate(cycle.configurations)
    ]


def shoot_along(
    cycle: ItineraryShape, numbers: Numbers, flows: Iterable[Any], start: Any
) -> Shooting:
    """The passage that `shoot` gives, from the flows (..., N, N + 1) of the phases."""
    size = start.shape[-1]
    unit = np.eye(size, size + 1, dtype=object if start.dtype == object else float)
    changes = np.broadcast_to(unit, (*start.shape[:-1], size, size + 1))
    phases = phases_in(cycle, numbers)
    found = shooting_map(phases, flows, start[..., None], changes)
    return Shooting(
        np.array(found.flows),
        np.array(found.starts)[..., 0],
        np.array(found.ends)[..., 0],
        np.array(found.velocities)[..., 0],
        np.array(found.residual)[..., 0, 0],
        np.array(found.speeds)[..., 0, 0],
        np.array(found.rates)[..., 0, :],
        (),
        found.variational,
    )


class ShootingDerivatives(NamedTuple):
    """The shooting map at k points; its w unknowns are p dwell times, N states, a parameter."""

    starts: np.ndarray  # (k, p + 1, N), state at each phase's start; last the state after the chain
    ends: np.ndarray  # (k, p, N), state at each phase's end
    velocities: np.ndarray  # (k, p, N), velocity at each phase's end
    residual: np.ndarray  # (k, p), boundary function at each phase's end
    slopes: np.ndarray  # (k, p, w), its derivatives by the unknowns
    variational: np.ndarray  # (k, N, w), derivatives of the state after the chain


def shooting_derivatives(
    cycle: ItineraryShape,
    numbers: Numbers,
    dwell: np.ndarray,
    start: np.ndarray,
    changes: Numbers | None = None,
) -> ShootingDerivatives:
    """The shooting map of one passage through a cycle, with its derivatives, at k points.

    The numbers' exponents and flows are not used. Dwell times (k, p) and the start (k, N) are in
    the system's units. `changes` are derivatives of the numbers by a parameter, which is then the
    last unknown. The result is NaN where flows are not finite.
    """
    count, (points, size) = len(cycle), start.shape
    engine = compiled_engine()
    if engine is None:
        return _in_python(cycle, numbers, dwell, start, changes)
    unknowns = count + size + (changes is not None)
    found = ShootingDerivatives(
        np.empty((points, count + 1, size)),
        np.empty((points, count, size)),
        np.empty((points, count, size)),
        np.empty((points, count)),
        np.empty((points, count, unknowns)),
        np.empty((points, size, unknowns)),
    )
    found.starts[:, 0] = start
    nothing = (np.empty(0),) * 3
    moved = nothing if changes is None else cycle_maps(cycle, changes)
    maps = (np.ascontiguousarray(dwell), *cycle_maps(cycle, numbers))
    engine.shoot(points, count, size, *maps, *moved, *found)
    return found


def shoot_many(cycle: ItineraryShape, numbers: Numbers, dwell: Any, start: Any) -> Shooting:
    """The passages that `shoot` gives at k points, by `shooting_derivatives`, without flows."""
    return dependent(shooting_derivatives(cycle, numbers, dwell, start))


def dependent(found: ShootingDerivatives) -> Shooting:
    """The passages of k points where dwell times follow the start, as `shoot` gives them.

    Derivatives are NaN where a boundary is touched tangentially.
    """
    count, size = found.residual.shape[1], found.ends.shape[2]
    unknowns = slice(count, count + size)
    slopes = np.concatenate([found.slopes[:, :, unknowns], found.residual[..., None]], axis=-1)
    by_dwell = found.slopes[:, :, :count]  # triangular: a dwell time changes what follows alone
    rates = -inverses(by_dwell) @ slopes
    changes = found.variational[:, :, :count] @ rates
    changes[..., :size] += found.variational[:, :, unknowns]
    speeds = np.diagonal(by_dwell, axis1=1, axis2=2).T
    starts, ends, velocities, residual, rates = (
        part.swapaxes(0, 1) for part in (*found[:4], rates)
    )
    return Shooting((), starts, ends, velocities, residual, speeds, rates, (), changes)


def cycle_maps(cycle: ItineraryShape, numbers: Numbers) -> tuple[np.ndarray, ...]:
    """Fields, rows and resets (k, p, ...) phase by phase, contiguous for the compiled engine."""
    configurations, rows, resets = cycle.packed[: 3 * len(cycle)].reshape(3, -1)
    return (
        numbers.fields.take(configurations, axis=1),
        numbers.rows.take(rows, axis=1),
        numbers.resets.take(resets, axis=1),
    )


def flows_over(fields: np.ndarray, dwell: np.ndarray, lib: Mpmath | None = None) -> np.ndarray:
    """Flows (..., N, N + 1) of fields (..., N, N + 1) over times (...), in the system's unit.

    Fields may be complex: a tiny imaginary part comes out as a derivative. Flows that are not
    finite are NaN. `lib` is None in double precision.
    """
    size = fields.shape[-2]
    flat = fields.reshape(-1, size, size + 1)
    if lib is not None:
        mp, times = lib.mp, dwell.ravel()
        flows = [exponential(f, mp.mpc(t), mp) for f, t in zip(flat, times, strict=True)]
        return np.array(flows, dtype=object).reshape(fields.shape)
    kind = np.result_type(fields, dwell)
    generators = np.zeros((dwell.size, size + 1, size + 1), dtype=kind)
    generators[:, :size] = flat
    with np.errstate(all="ignore"):  # of what is not finite nothing is
        _, units = balanced(generators.real)
        scaled = generators * units[:, None] / units[:, :, None] * dwell.reshape(-1, 1, 1)
        flows = exponentials(scaled) * units[:, :, None] / units[:, None]
    return np.asarray(flows.reshape(*dwell.shape, size + 1, size + 1)[..., :size, :])


def _in_python(
    cycle: ItineraryShape,
    numbers: Numbers,
    dwell: np.ndarray,
    start: np.ndarray,
    changes: Numbers | None,
) -> ShootingDerivatives:
    """The result of `shooting_derivatives`, computed by NumPy."""
    count, (points, size) = len(cycle), start.shape
    if changes is not None:
        numbers = numbers.each(lambda part, rates: stepped(part, rates, None), changes)
    flows = flows_over(numbers.fields[:, list(cycle.configurations)], dwell)
    unit = np.broadcast_to(np.eye(count + size), (points, count + size, count + size))
    with np.errstate(all="ignore"):
        found = shooting_map(
            phases_in(cycle, numbers),
            np.moveaxis(flows, 1, 0),
            start[..., None],
            unit[:, count:],
            [unit[:, place, None] for place in range(count)],
        )
    states, ends, velocities = (
        np.stack(part, axis=1)[..., 0] for part in (found.starts, found.ends, found.velocities)
    )
    residual = np.stack(found.residual, axis=1)[..., 0, 0]
    slopes, variational = np.stack(found.slopes, axis=1)[..., 0, :], found.variational
    if changes is not None:
        slopes = np.concatenate([slopes, imaginary_parts(residual, None)[..., None]], axis=-1)
        moved = imaginary_parts(states[:, -1], None)[..., None]
        variational = np.concatenate([variational, moved], axis=-1)
    parts = (states, ends, velocities, residual, slopes, variational)
    return ShootingDerivatives(*(np.ascontiguousarray(part.real) for part in parts))

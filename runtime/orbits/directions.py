"""How orbits move with what was given: the implicit function theorem, in any arithmetic.

Kernels have the derivatives of their equations. By the tables of a system a passage of the cycle
has tiny imaginary parts, and so have the equations of its closure and all that is told of it. At
many parameter points the compiled engine does the same in doubles.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property, reduce
from itertools import accumulate, chain
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from nonsmooth.runtime.core.arithmetic import FLOATS, Mpmath
from nonsmooth.runtime.core.complex_steps import (
    ComplexSteps,
    imaginary_parts,
    real_parts,
    step_of,
    stepped,
)
from nonsmooth.runtime.core.errors import InputError, chosen_names
from nonsmooth.runtime.core.exponentials.matrices import inverses
from nonsmooth.runtime.core.parallel import in_parallel
from nonsmooth.runtime.model.kernels import OrbitKernels, SystemKernels, compiled_engine
from nonsmooth.runtime.model.piecewise import tables_at
from nonsmooth.runtime.model.structure import structure_of
from nonsmooth.runtime.orbits.orbit import GUARD, PERIOD, Orbit, Orbits
from nonsmooth.runtime.shooting.closure_conditions import closed_cycle, closure_equations
from nonsmooth.runtime.shooting.kernel_newton import natural_scales
from nonsmooth.runtime.shooting.multipliers import (
    MapDerivatives,
    many_multiplier_derivatives,
)
from nonsmooth.runtime.shooting.newton import LEAST
from nonsmooth.runtime.shooting.section_map import mechanical_states, timed_maps
from nonsmooth.runtime.shooting.shooting_map import (
    ItineraryShape,
    Numbers,
    Shooting,
    cycle_maps,
    flows_over,
    itinerary_shape,
    relative_rates,
    shoot_along,
    stepped_tables,
)
from nonsmooth.runtime.shooting.table_newton import sizes
from nonsmooth.runtime.shooting.translations import projection_along

if TYPE_CHECKING:
    from nonsmooth.runtime.orbits.problem import Evaluation


CONSISTENT = 1e-7  # of the terms of an equation: what no orbit can follow
_POINTS, _COLUMNS = 1 << 9, 1 << 15  # that one thread takes at a time, by tables and kernels
_ZERO = 1e-12  # of the largest multiplier: one that is zero but for rounding
_OF_MAPS = ("determinant", "spectral_radius")  # where multipliers are asked for


@dataclass(frozen=True, eq=False)
class Directions:
    """Derivatives of an orbit by q numbers."""

    unknowns: Mapping[str, np.ndarray]  # (q,) each, of what was solved for
    dwell: np.ndarray  # (q, p), of each phase
    moved: Callable[[], np.ndarray]  # gives `starts` when asked
    mapped: Callable[[], MapDerivatives]  # gives `section` when asked
    trace: np.ndarray | None = None  # (q,), where a formula gives it sharper than the map
    cycles: MovedCycles | None = None  # the one orbit itself, by the tables of its system

    @cached_property
    def starts(self) -> np.ndarray:
        """Derivatives (q, p, N) of the state at each phase's start, which moves in time too."""
        return self.moved()

    @cached_property
    def section(self) -> MapDerivatives:
        """The map whose eigenvalues are the multipliers, and its derivatives."""
        return self.mapped()


# why there are no changes, by number; a sentence that `check_reasons` completes
SOUND, TANGENTIAL, SINGULAR, LOST = range(4)
_SENTENCES = {
    TANGENTIAL: "a boundary is reached tangentially (grazing): there no derivative exists",
    SINGULAR: "its equations are singular (a fold, a branch point or one of a family of orbits):"
    " there no derivative exists",
    LOST: "no such orbit is left where {} changes alone (forcings out of tune with each other or"
    " with the period): there is no derivative",
}


def check_reasons(reasons: np.ndarray, by: Sequence[str], name: str) -> None:
    """Raise an `InputError` for the first of the reasons (q,) that is not `SOUND`.

    Its message names the orbit and what changes.
    """
    for reason, parameter in zip(reasons.tolist(), by, strict=True):
        if reason != SOUND:
            raise InputError(f"{name}: {_SENTENCES[reason].format(parameter)}")


def solve_linear(
    matrix: np.ndarray, right: np.ndarray, usual: np.ndarray, lib: Mpmath | None = None
) -> tuple[np.ndarray, np.ndarray]:
    """Return the changes (k, n, q) that linearised, scaled equations ask for, and the reasons.

    The matrices are (k, m, n), with m > n for equations that follow from others; `right`
    is (k, m, q). `usual` (k, q) is the relative change of what the equations are made of:
    a change that is tiny beside it is rounding. Changes are NaN where the reason (k, q) is
    not `SOUND`. `lib` is None in double precision.
    """
    floats, sides = matrix.astype(float, copy=False), right.astype(float, copy=False)
    with np.errstate(all="ignore"):
        square, turned = floats, sides
        if matrix.shape[1] != matrix.shape[2]:
            orthogonal, square = np.linalg.qr(floats)
            turned = np.swapaxes(orthogonal, 1, 2) @ sides
        inverse = inverses(square)
        size = np.linalg.norm(square, axis=(1, 2))
        regular = size * np.linalg.norm(inverse, axis=(1, 2)) * LEAST < 1
        changes = inverse @ turned
        missed = abs(floats @ changes - sides).max(axis=1)
        terms = (abs(floats) @ abs(changes) + abs(sides)).max(axis=1)
    reasons = np.where(missed > CONSISTENT * np.maximum(terms, usual), LOST, SOUND)
    reasons[~regular] = SINGULAR
    finite = np.isfinite(size) & np.isfinite(sides).all(axis=(1, 2))
    reasons[~finite] = TANGENTIAL
    if lib is not None:
        changes = np.full(changes.shape, np.nan, dtype=object)
        for place in np.flatnonzero(regular & finite):
            rows = matrix[place].tolist()
            solved = [lib.solve(rows, side) for side in right[place].T.tolist()]
            changes[place] = np.array(solved, dtype=object).reshape(len(solved), -1).T
    np.swapaxes(changes, 1, 2)[reasons != SOUND] = np.nan
    return changes, reasons


def _working(orbit: Orbit) -> Mpmath | None:
    """Return the arithmetic of complex steps, with twice the orbit's digits; None for doubles."""
    return Mpmath(2 * (orbit.digits + GUARD)) if orbit.precise else None


def _stepped_kernel(
    orbit: Orbit, quantity: str, rates: dict[str, Any], count: int, lib: Mpmath | None
) -> list[Any]:
    """Return a quantity with complex steps of what it depends on, one for each of q directions.

    A kernel gives it from parameters, spectrum and unknowns. `rates` has the rates (q,) of all of
    them, `count` is q, and `lib` is None in double precision.
    """
    kernels = orbit.kernels
    names = (kernels.parameter_names, kernels.unknowns)
    number = float if lib is None else lib.mp.mpf
    parameters, unknowns = (
        [stepped(number(orbit.values[name]), rates[name], lib) for name in part] for part in names
    )
    arithmetic = ComplexSteps(FLOATS if lib is None else lib)
    found = []
    for place in range(count):
        point, solved = ([x[place] for x in part] for part in (parameters, unknowns))
        spectrum, _ = kernels.spectrum(point, arithmetic)
        values = kernels.evaluate(quantity, at=(point, spectrum, solved), lib=arithmetic)
        found.append(np.array(values, dtype=complex if lib is None else object))
    return found


@np.errstate(all="ignore")  # of an orbit that hardly fits doubles
def kernel_directions(orbit: Orbit, by: Sequence[str]) -> Directions:
    """Return how unknowns, dwell times and states move with each of some given numbers.

    `InputError` says why where there is no derivative.
    """
    kernels, lib = orbit.kernels, orbit.arithmetic if orbit.precise else None
    kind = float if lib is None else object
    names = [*kernels.unknowns, *kernels.parameter_names]
    parts = orbit.evaluate("jacobian", "parameter_jacobian")
    jacobian = np.concatenate([np.array(part, dtype=kind) for part in parts], axis=1)
    places = [names.index(name) for name in orbit.unknowns]
    right = -jacobian[:, [names.index(name) for name in by]]
    values = np.array([float(orbit.values[name]) for name in names])
    rows, sizes = natural_scales(jacobian, values)
    scaled = jacobian[:, places] * sizes[places] / rows[:, None]
    right = right / rows[:, None]
    found, reasons = solve_linear(scaled[None], right[None], np.zeros((1, len(by))), lib)
    check_reasons(reasons[0], by, orbit.name)
    rates = dict(zip(orbit.unknowns, found[0] * sizes[places, None], strict=True))
    one, still = 1.0 if lib is None else lib.mp.mpf(1), np.zeros(len(by), dtype=int)
    every = dict.fromkeys(names, still * one) | rates
    every |= dict(zip(by, np.eye(len(by), dtype=int) * one, strict=True))
    waits = np.stack(np.broadcast_arrays(*kernels.durations(every).values(), still)[:-1], axis=-1)
    gradient = np.array(orbit.evaluate("trace_gradient"), dtype=kind)
    trace = sum(slope * every[name] for name, slope in zip(names, gradient, strict=True))
    wide = _working(orbit)

    def along(quantity: str) -> np.ndarray:
        return imaginary_parts(_stepped_kernel(orbit, quantity, every, len(by), wide), wide)

    def section() -> MapDerivatives:
        return MapDerivatives(
            real_parts(np.array(orbit.evaluate("poincare_jacobian"), dtype=kind)),
            along("poincare_jacobian"),
            kernels.table["rank"],
            int(bool(kernels.table["conservative"])),
        )

    own = {name: rates[name] for name in orbit.unknowns}
    return Directions(own, waits, lambda: along("states")[:, :-1], section, np.asarray(trace))


def passed(
    cycle: ItineraryShape, numbers: Numbers, dwell: np.ndarray, start: np.ndarray, lib: Any
) -> Shooting:
    """Return a passage of a cycle with complex steps, where dwell times follow the start.

    `numbers` are those of q directions; `dwell` (q, p) and `start` (q, N) are in the
    system's units. `lib` is None in double precision.
    """
    flows = flows_over(numbers.fields[:, list(cycle.configurations)], dwell, lib)
    return shoot_along(cycle, numbers, np.moveaxis(flows, 1, 0), start)


@dataclass(frozen=True, eq=False)
class MovedCycles:
    """Cycles of one itinerary at k points that move in q directions each, as complex steps."""

    cycle: ItineraryShape  # closed up to translations
    sizes: np.ndarray  # (k, N), of the states
    numbers: Numbers  # (k q, ...), with those of the closure
    directions: np.ndarray  # (k q, m, N), of translations
    dwell: np.ndarray  # (k q, p), with steps
    start: np.ndarray  # (k q, N), with steps
    reasons: np.ndarray  # (k, q), why there are no changes, as `solve_linear` tells it
    lib: Mpmath | None

    @cached_property
    def passage(self) -> Shooting:
        """The cycles as they move."""
        return passed(self.cycle, self.numbers, self.dwell, self.start, self.lib)

    @property
    def waits(self) -> np.ndarray:
        """Changes (k q, p) of the dwell times."""
        return imaginary_parts(self.dwell, self.lib)

    @property
    def starts(self) -> np.ndarray:
        """Changes (k q, N) of the start."""
        return imaginary_parts(self.start, self.lib)


def moved_cycles(
    cycle: ItineraryShape,
    numbers: Numbers,
    dwell: np.ndarray,
    start: np.ndarray,
    lib: Mpmath | None,
    period: np.ndarray | None = None,
    *,
    family: bool = False,
) -> MovedCycles:
    """Return how orbits at k points move with numbers of a system, each in q directions.

    The `numbers` (k q, ...) have steps; `dwell` (k, p) and `start` (k, N) have none. A
    `period` (k q,) with steps is one more equation where the others are singular, or
    everywhere for members of a `family`.
    """
    (k, size), q = start.shape, len(numbers.fields) // len(start)
    cycle, closed, directions = closed_cycle(cycle, numbers)
    times, states = (np.repeat(part, q, axis=0) for part in (dwell, start))
    plain_times = stepped(times, 0, lib)
    with np.errstate(all="ignore"):
        now = passed(cycle, closed, plain_times, stepped(states, 0, lib), lib)
        parts = (real_parts(part[:, ::q]) for part in (now.starts, now.ends, now.velocities))
        plain = dict(zip(("starts", "ends", "velocities"), parts, strict=True))
        size_of = sizes(now._replace(**plain), dwell)
        every_size = np.repeat(size_of, q, axis=0)
        usual = np.array(
            [
                relative_changes([part[n * q : (n + 1) * q] for part in numbers[:3]], each, lib)
                for n, each in enumerate(size_of)
            ]
        ).reshape(k, q)

        def solved(total: np.ndarray | None) -> tuple[np.ndarray, np.ndarray]:
            options: Any = {"start": states, "lib": FLOATS if lib is None else lib}
            asked = cycle, closed, now, plain_times, every_size, total
            matrix, right = closure_equations(*asked, **options)
            changed = imaginary_parts(right, lib).reshape(k, q, -1)
            plain_matrix = real_parts(matrix[::q])
            return solve_linear(plain_matrix, np.swapaxes(changed, 1, 2), usual, lib)

        changes, reasons = solved(period if family else None)
        singular = (reasons == SINGULAR).any(axis=1)
        if period is not None and not family and singular.any():
            given, why = solved(period)
            changes[singular], reasons[singular] = given[singular], why[singular]
        starts = np.swapaxes(changes, 1, 2) * size_of[:, None]
        rates = np.swapaxes(real_parts(now.rates[:, ::q, :size]), 0, 1)
        waits = (starts @ np.swapaxes(rates, 1, 2)).reshape(k * q, -1)
        waits = waits + imaginary_parts(now.rates[..., size].T, lib)
        start = stepped(states, starts.reshape(k * q, size), lib)
    waits = stepped(times, waits, lib)
    return MovedCycles(cycle, size_of, closed, directions, waits, start, reasons, lib)


def table_directions(
    evaluation: Evaluation, by: Sequence[str], rates: Mapping[str, np.ndarray]
) -> Directions:
    """Return how dwell times and states move with each of q numbers.

    Parameters of the system, and the period where it was given, have `rates` (q,) by them; what
    has none stays. The equations of the whole orbit are linearised, not those of the part that a
    symmetry closes: a parameter may break the symmetry. `InputError` says why where there is no
    derivative.
    """
    orbit, lib = evaluation.orbit, _working(evaluation.orbit)
    family = evaluation.family
    if PERIOD in rates and not family:
        raise InputError("the period follows from the forcing: nothing is differentiated by it")
    if family and orbit.given_period is None:
        raise InputError(
            f"{orbit.name} is one of a family of orbits: give its period, and the derivatives are"
            " those at a given period"
        )
    dwell, start = orbit.dwell_times, evaluation.states_up_to_shift[0]
    if lib is not None:
        dwell, start = (np.array([lib.mp.mpf(x) for x in part]) for part in (dwell, start))
    still = np.zeros(len(by), dtype=int)
    period = stepped(dwell.sum(), rates.get(PERIOD, still), lib) if family else None
    names = [table.name for table in orbit.system.parameters]
    steps = np.array([rates.get(name, still) for name in names]).T
    number = float if lib is None else lib.number
    point = np.array([number(orbit.parameters[name]) for name in names])
    numbers = stepped_tables(orbit.system, point[None], steps, lib)
    moved = moved_cycles(
        evaluation.cycle, numbers, dwell[None], start[None], lib, period, family=family
    )
    check_reasons(moved.reasons[0], by, orbit.name)
    waits = moved.waits
    unknowns = np.concatenate([waits, moved.starts], axis=1).T

    def states() -> np.ndarray:
        return np.moveaxis(imaginary_parts(moved.passage.starts[:-1], lib), 1, 0)

    def section() -> MapDerivatives:
        return _section(evaluation, moved)

    found = dict(zip(orbit.problem.unknown_names, unknowns, strict=True))
    return Directions(found, waits, states, section, cycles=moved)


def relative_changes(
    numbers: Sequence[np.ndarray], size_of: np.ndarray, lib: Mpmath | None
) -> np.ndarray:
    """Return the largest relative change (q,) of a system's numbers, where states have sizes (N,).

    `numbers` are fields, rows and resets with steps; `lib` is None in double precision.
    """
    values = [real_parts(part[0]).astype(float) for part in numbers]
    changes = [imaginary_parts(part, lib).astype(float) for part in numbers]
    return relative_rates(values, changes, size_of.astype(float))


def section_along(moved: MovedCycles) -> np.ndarray:
    """Return the map (k q, m, m), with steps, on the section at the start, or the stroboscopic one.

    The stroboscopic map is that of forced motions. The multipliers 1 of translations are
    zeros of the map.
    """
    cycle, numbers, now = moved.cycle, moved.numbers, moved.passage
    driven = mechanical_states(cycle)
    maps = now.variational[..., :-1]
    if driven is None:
        return np.asarray(maps)
    maps = reduce(lambda maps, local: local @ maps, timed_maps(cycle, numbers, now, driven))
    if not moved.directions.shape[1]:
        return np.asarray(maps)
    along = (projection_along(each)[np.ix_(driven, driven)] for each in moved.directions)
    return np.array([p @ m for p, m in zip(along, maps, strict=True)])


def _section(evaluation: Evaluation, moved: MovedCycles) -> MapDerivatives:
    """Return the section map, or the stroboscopic one of forced motions, with its derivatives."""
    rank = evaluation.stability.rank - len(evaluation.translations)
    maps, lib = section_along(moved), moved.lib
    found = MapDerivatives(
        real_parts(maps[0]), imaginary_parts(maps, lib), rank, int(evaluation.family)
    )
    if lib is None or not step_of(lib):
        return found
    rounded = np.frompyfunc(evaluation.orbit.arithmetic.mp.mpf, 1, 1)
    return found._replace(matrix=rounded(found.matrix), rates=rounded(found.rates))


_Found = dict[str, dict[str, np.ndarray]]


class TableRates(NamedTuple):
    """The entries of the tables that some parameters change, at k points."""

    directions: np.ndarray  # (m,) of int, index of the parameter
    entries: np.ndarray  # (m,) of int, index of the entry, through fields, rows and resets
    values: np.ndarray  # (k, m), derivative of the entry by the parameter

    def beside(self, added: np.ndarray, numbers: Numbers) -> TableRates:
        """Return these and those (k, q, size) of the last reset, which was added to the numbers."""
        points, parameters, size = added.shape
        last = sum(part[0].size for part in numbers[:3]) - size + np.arange(size)
        return TableRates(
            np.concatenate([self.directions, np.repeat(np.arange(parameters), size)]),
            np.concatenate([self.entries, np.tile(last, parameters)]),
            np.concatenate([self.values, added.reshape(points, -1)], axis=1),
        )


def table_rates(kernels: SystemKernels, points: np.ndarray, places: Sequence[int]) -> TableRates:
    """Nonzero derivatives of fields, rows and resets by some parameters, at points (k, p).

    Points are in the system's order, and `places` are the parameters' indices there. One
    parameter after the other becomes complex, and so do the entries that depend on it.

    Examples
    --------
    >>> from nonsmooth.runtime.model.kernels import load_system
    >>> kernels = load_system("rigid-stop")  # parameters m1, m2, k1, k2, r
    >>> found = table_rates(kernels, np.array([[1.0, 2.0, 1.0, 5.0, 0.5]]), [4])
    >>> found.values  # the restitution stands in one reset
    array([[-1.]])
    """
    columns = list(np.array(points.T, dtype=float, order="C"))
    directions, entries, values = [], [], [np.empty((0, len(points)))]
    for direction, place in enumerate(places):
        moved = [stepped(x, 1, None) if k == place else x
                 for k, x in enumerate(columns)]  # fmt: skip
        first = 0
        for kernel in ("fields", "rows", "resets"):
            with np.errstate(all="ignore"):  # who takes them looks whether they are finite
                found = list(chain.from_iterable(kernels.source(kernel)(moved, lib=FLOATS)))
            for entry, value in enumerate(found):
                if np.iscomplexobj(value):
                    directions.append(direction)
                    entries.append(first + entry)
                    values.append(imaginary_parts(value, None)[None])
            first += len(found)
    return TableRates(
        np.array(directions, dtype=int),
        np.array(entries, dtype=int),
        np.ascontiguousarray(np.concatenate(values).T),
    )


class ManyDirections(NamedTuple):
    """Derivatives of k orbits by q parameters; NaN where there are none."""

    dwell: np.ndarray  # (k, q, p), of each phase
    start: np.ndarray  # (k, q, N)
    trace: np.ndarray  # (k, q), of the map on the section at the start, or the stroboscopic one
    maps: np.ndarray  # (k, m, m), that map; empty where it is not asked for, like `rates`
    rates: np.ndarray  # (k, q, m, m), of the map
    shifts: int = 0  # number of translations; their multipliers 1 are zeros of the map


def table_directions_many(
    system: SystemKernels,
    cycle: ItineraryShape,
    points: np.ndarray,
    dwell: np.ndarray,
    start: np.ndarray,
    places: Sequence[int],
    *,
    timed: bool,
    maps: bool,
) -> ManyDirections:
    """Return derivatives of orbits of one cycle by the parameters at q places.

    `points` (k, parameters), `dwell` (k, p) and `start` (k, N) are in the system's order
    and units. With `timed` the period was given, and that of one of a family stays what
    it is. With `maps` the maps are given, too.
    """
    (k, size), q, count = start.shape, len(places), len(cycle)
    engine, steps = compiled_engine(), np.eye(points.shape[1])[list(places)]
    if engine is None or len(cycle.structure.forcing) > 1:
        numbers = stepped_tables(system, points, steps, None)
        period = np.repeat(dwell.sum(axis=-1), q) + 0j if timed else None
        moved = moved_cycles(cycle, numbers, dwell, start, None, period)
        with np.errstate(all="ignore"):
            whole = section_along(moved)
        whole = whole.reshape(k, q, *whole.shape[1:])
        changed = imaginary_parts(whole, None)
        return ManyDirections(
            moved.waits.reshape(k, q, -1),
            moved.starts.reshape(k, q, size),
            np.trace(changed, axis1=-2, axis2=-1),
            real_parts(whole[: k if maps else 0, 0]),
            changed[: k if maps else 0],
            moved.directions.shape[1],
        )
    rates = table_rates(system, points, places)
    closed, numbers, along = closed_cycle(cycle, Numbers(*tables_at(system, points)))
    if along.shape[1]:  # the directions of translations may turn, and with them the last reset
        _, turned, along = closed_cycle(cycle, stepped_tables(system, points, steps, None))
        rates = rates.beside(imaginary_parts(turned.resets[:, -1], None).reshape(k, q, -1), numbers)
    shape = (k if maps else 0, size, size)
    found = ManyDirections(
        np.empty((k, q, count)),
        np.empty((k, q, size)),
        np.empty((k, q)),
        np.empty(shape),
        np.empty((shape[0], q, size, size)),
        along.shape[1],
    )
    engine.move(
        k, count, size, q, rates.values.shape[1], timed,
        *_moving(closed, numbers, rates, q), closed.packed[3 * count :],
        np.ascontiguousarray(dwell), np.ascontiguousarray(start), *cycle_maps(closed, numbers),
        rates.values, *found[:5],
    )  # fmt: skip
    driven = mechanical_states(cycle)
    if driven is None or not maps:
        return found
    own, changed = (part[..., driven, :][..., driven] for part in found[3:5])
    if along.shape[1]:
        projections = np.array([projection_along(each) for each in along])
        projections = projections.reshape(k, q, size, size)[..., driven, :][..., driven]
        whole = projections @ stepped(own[:, None], changed, None)
        own, changed = real_parts(whole[:, 0]), imaginary_parts(whole, None)
    return found._replace(maps=own, rates=changed)


def _moving(
    cycle: ItineraryShape, numbers: Numbers, rates: TableRates, directions: int
) -> tuple[np.ndarray, ...]:
    """Return where the engine finds the entries that change.

    The first array says where those of each phase and direction begin; the others are
    their places in the maps of the phase, and in the rates of a point.
    """
    count = len(cycle)
    befores = accumulate((part[0].size for part in numbers[:2]), initial=0)
    entries = [
        before + places[:, None] * part[0, 0].size + np.arange(part[0, 0].size)
        for places, part, before in zip(
            cycle.packed[: 3 * count].reshape(3, count), numbers[:3], befores, strict=True
        )
    ]
    same = np.concatenate(entries, axis=1)[..., None] == rates.entries
    phase_of, entry_of, rate_of = np.nonzero(same)
    pair_of = phase_of * directions + rates.directions[rate_of]
    order = np.argsort(pair_of, kind="stable")
    starts = np.searchsorted(pair_of[order], np.arange(count * directions + 1))
    return tuple(part.astype(np.int32) for part in (starts, entry_of[order], rate_of[order]))


def derivatives_of_many(
    orbits: Orbits, by: Sequence[str] | str, threads: int | None = None
) -> _Found:
    """Return derivatives of unknowns, period and trace at many points; see `Orbits.derivatives`.

    They are arrays (...) by quantity and parameter, NaN where there is no orbit or no
    derivative. `threads` None takes as many as processors. `InputError` is raised for an
    unknown parameter, and where boundaries are reached together.
    """
    known = [table.name for table in orbits.problem.parameters]
    names = chosen_names("parameter", by, known)
    shape, kernels = orbits.status.shape, orbits.problem.kernels
    sound = np.flatnonzero(orbits.converged.ravel())
    every: slice | np.ndarray = slice(None) if len(sound) == orbits.status.size else sound
    points, unknowns = (
        np.stack([np.broadcast_to(a, shape).ravel()[every] for a in arrays]).astype(float).T
        for arrays in ([orbits.parameters[n] for n in known], list(orbits.unknowns.values()))
    )
    places = [known.index(name) for name in names]
    if kernels is None:
        rates = _by_tables(orbits, points, unknowns, places, threads)
    else:
        rates = _by_kernels(kernels, points, unknowns, places, threads)
    quantities = (*orbits.unknowns, "trace", "period", *_OF_MAPS)[: len(rates)]
    if every is sound:
        filled = np.full((*rates.shape[:2], orbits.status.size), np.nan)
        filled[..., sound] = rates
        rates = filled
    return {
        quantity: {name: rate.reshape(shape) for name, rate in zip(names, moved, strict=True)}
        for quantity, moved in zip(quantities, rates, strict=True)
    }


def _by_kernels(
    kernels: OrbitKernels,
    points: np.ndarray,
    unknowns: np.ndarray,
    places: list[int],
    threads: int | None,
) -> np.ndarray:
    """Return rates (n + 2, q, k), by compiled code if the kernels are compiled."""
    if kernels.table["vanishing"]:
        raise InputError(f"{kernels.name} is a border collision: its derivatives are one-sided")
    (count, size), width = unknowns.shape, points.shape[1]
    found = np.empty((size + 2, width, count))
    unit = np.eye(width)[:, :, None]

    def work(begin: int) -> None:
        part = slice(begin, begin + _COLUMNS)
        moved = found[..., part]
        at = np.moveaxis(moved[:-1], -1, 0)
        if kernels.directions is None:
            _on_numpy(kernels, points[part], unknowns[part], at)
        else:
            kernels.directions(points[part], unknowns[part], out=at)
        columns = dict(zip(kernels.parameter_names, unit, strict=True))
        columns |= dict(zip(kernels.unknowns, moved[:-2], strict=True))
        moved[-1] = reduce(np.add, kernels.durations(columns).values())

    in_parallel(work, range(0, count, _COLUMNS), threads)
    return found if places == [*range(width)] else found[:, places]


def _on_numpy(
    kernels: OrbitKernels, points: np.ndarray, unknowns: np.ndarray, found: np.ndarray
) -> None:
    """Fill in derivatives (k, n + 1, p) of the unknowns and of the trace by all parameters."""
    spectrum, moved = kernels.spectrum(points)
    at = (points, spectrum, unknowns, moved)
    jacobian, changes = kernels.evaluate("jacobian", "parameter_jacobian", at=at)
    gradient = kernels.evaluate("trace_gradient", at=at)
    size = unknowns.shape[1]
    found[:, :size], _ = solve_linear(jacobian, -changes, np.zeros(points.shape))
    found[:, size] = gradient[:, size:]
    found[:, size] += np.einsum("kn,knq->kq", gradient[:, :size], found[:, :size])


def _by_tables(
    orbits: Orbits,
    points: np.ndarray,
    unknowns: np.ndarray,
    places: list[int],
    threads: int | None,
) -> np.ndarray:
    """Return rates (n + 2, q, k), with two rows more where there are multipliers."""
    problem = orbits.problem
    cycle = itinerary_shape(structure_of(problem.system), problem.itinerary)
    if cycle.one_sided:
        raise InputError(
            f"{orbits.name}: boundaries are reached together: derivatives are one-sided"
        )
    count, (amount, size) = len(cycle), unknowns.shape
    maps = orbits.multipliers is not None
    found = np.empty((size + 2 + maps * len(_OF_MAPS), len(places), amount))
    driven = mechanical_states(cycle)
    rank = _rank(orbits) if maps else 0

    def work(begin: int) -> None:
        part = slice(begin, begin + _POINTS)
        moved = table_directions_many(
            problem.system, cycle, points[part],
            unknowns[part, :count], unknowns[part, count:], places,
            timed=orbits.timed, maps=maps,
        )  # fmt: skip
        found[:count, :, part] = moved.dwell.T
        found[count:size, :, part] = moved.start.T
        found[size, :, part] = moved.trace.T
        found[size + 1, :, part] = moved.dwell.sum(axis=-1).T
        if maps:
            trivial = int(orbits.timed and driven is None)
            section = MapDerivatives(moved.maps, moved.rates, rank - moved.shifts, trivial)
            for row, rates in enumerate(many_multiplier_derivatives(section), size + 2):
                found[row, :, part] = rates.T

    in_parallel(work, range(0, amount, _POINTS), threads)
    return found


def _rank(orbits: Orbits) -> int:
    """Return how many multipliers are not zero at all points."""
    assert orbits.multipliers is not None
    sizes = abs(orbits.multipliers[orbits.converged])
    apart = sizes > _ZERO * sizes.max(axis=1, initial=0.0, keepdims=True)
    return int(apart.sum(axis=1).max(initial=0))

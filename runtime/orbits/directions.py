"""How an orbit moves with what was given: the implicit function theorem, in any arithmetic.

Kernels have the derivatives of their equations. By the tables of a system a passage of the cycle
has tiny imaginary parts, and so have the equations of its closure and all that is told of it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property, reduce
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.core.arithmetic import FLOATS, Mpmath
from nonsmooth.runtime.core.complex_steps import (
    ComplexSteps,
    imaginary_parts,
    real_parts,
    step_of,
    stepped,
)
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.exponentials.matrices import inverses
from nonsmooth.runtime.orbits.orbit import GUARD, PERIOD, Orbit
from nonsmooth.runtime.shooting.closure_conditions import closed_cycle, closure_equations
from nonsmooth.runtime.shooting.kernel_newton import natural_scales
from nonsmooth.runtime.shooting.multipliers import MapDerivatives
from nonsmooth.runtime.shooting.newton import LEAST
from nonsmooth.runtime.shooting.section_map import mechanical_states, timed_maps
from nonsmooth.runtime.shooting.shooting_map import (
    ItineraryShape,
    Numbers,
    Shooting,
    flows_over,
    relative_rates,
    shoot_along,
    stepped_tables,
)
from nonsmooth.runtime.shooting.table_newton import sizes
from nonsmooth.runtime.shooting.translations import projection_along

if TYPE_CHECKING:
    from nonsmooth.runtime.orbits.problem import Evaluation

CONSISTENT = 1e-7  # of the terms of an equation: what no orbit can follow


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

"""How an orbit by the tables of its system moves with what was given."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.core.arithmetic import FLOATS, Mpmath
from nonsmooth.runtime.core.complex_steps import imaginary_parts, real_parts, step_of, stepped
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.model.table_derivatives import relative_rates, stepped_tables
from nonsmooth.runtime.orbits.directions import SINGULAR, Directions, check_reasons, solve_linear
from nonsmooth.runtime.orbits.orbit import GUARD, PERIOD, Orbit
from nonsmooth.runtime.shooting.closure_conditions import closed_cycle, closure_equations
from nonsmooth.runtime.shooting.derivatives import flows_over
from nonsmooth.runtime.shooting.multipliers import MapDerivatives
from nonsmooth.runtime.shooting.section_map import mechanical_states, timed_maps
from nonsmooth.runtime.shooting.shooting_map import (
    ItineraryShape,
    Numbers,
    shoot_along,
)
from nonsmooth.runtime.shooting.table_newton import sizes
from nonsmooth.runtime.shooting.translations import projection_along
from nonsmooth.runtime.shooting.variational import Shooting

if TYPE_CHECKING:
    from nonsmooth.runtime.orbits.problem import Evaluation

__all__ = [
    "moved_cycles",
    "numbers_along",
    "passed",
    "relative_changes",
    "section_along",
    "table_directions",
    "working",
]


def working(orbit: Orbit) -> Mpmath | None:
    """Return the arithmetic of complex steps, with twice the orbit's digits; None for doubles."""
    return Mpmath(2 * (orbit.digits + GUARD)) if orbit.precise else None


def numbers_along(orbit: Orbit, by: Sequence[str], lib: Mpmath | None) -> Numbers:
    """Return fields, rows and resets (q, ...) of the system, each with a step of one number.

    The numbers `by` are parameters, or the period, which changes none of them. `lib` is
    None in double precision.
    """
    names = [table.name for table in orbit.system.parameters]
    steps = np.array([[int(name == other) for name in names] for other in by])
    number = float if lib is None else lib.number
    point = np.array([number(orbit.parameters[name]) for name in names])
    return Numbers(*stepped_tables(orbit.system, point[None], steps, lib))


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
    return MovedCycles(cycle, closed, directions, waits, start, reasons, lib)


def table_directions(evaluation: Evaluation, by: Sequence[str]) -> Directions:
    """Return how dwell times and states move with each of some given numbers.

    The equations of the whole orbit are linearised, not those of the part that a symmetry
    closes: a parameter may break the symmetry. The period may be one of the numbers where
    it was given. `InputError` says why where there is no derivative.
    """
    orbit, lib = evaluation.orbit, working(evaluation.orbit)
    family = evaluation.family
    if PERIOD in by and not family:
        raise InputError("the period follows from the forcing: nothing is differentiated by it")
    if family and orbit.given_period is None:
        raise InputError(
            f"{orbit.name} is one of a family of orbits: give its period, and the derivatives are"
            " those at a given period"
        )
    dwell, start = orbit.dwell_times, evaluation.states_up_to_shift[0]
    if lib is not None:
        dwell, start = (np.array([lib.mp.mpf(x) for x in part]) for part in (dwell, start))
    asked = np.array([int(name == PERIOD) for name in by])
    period = stepped(dwell.sum(), asked, lib) if family else None
    numbers = numbers_along(orbit, by, lib)
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

    names = orbit.problem.unknown_names
    return Directions(dict(zip(names, unknowns, strict=True)), waits, states, section)


def relative_changes(
    numbers: Sequence[np.ndarray], size_of: np.ndarray, lib: Mpmath | None
) -> np.ndarray:
    """Return the largest relative change (q,) of a system's numbers, where states have sizes (N,).

    `numbers` are the fields, rows and resets of `numbers_along`; `lib` is None in double
    precision.
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
    maps = np.eye(len(driven), dtype=int)
    for local in timed_maps(cycle, numbers, now, driven):
        maps = local @ maps
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

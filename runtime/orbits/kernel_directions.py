"""How an orbit with kernels moves with what was given."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.core.arithmetic import FLOATS, Mpmath
from nonsmooth.runtime.core.complex_steps import (
    ComplexSteps,
    imaginary_parts,
    real_parts,
    stepped,
)
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.orbits.directions import Directions, check_reasons, solve_linear
from nonsmooth.runtime.orbits.kernel_values import evaluate
from nonsmooth.runtime.orbits.motion_derivatives import OrbitMotionDerivatives
from nonsmooth.runtime.orbits.orbit import GUARD, PERIOD, Orbit
from nonsmooth.runtime.shooting.kernel_newton import natural_scales
from nonsmooth.runtime.shooting.multiplier_derivatives import MapDerivatives

if TYPE_CHECKING:
    from nonsmooth.runtime.orbits.derivatives import OrbitDerivatives

__all__ = ["along_tables", "kernel_directions", "stepped_kernel"]


def stepped_kernel(
    orbit: Orbit, quantity: str, rates: dict[str, Any], count: int, lib: Mpmath | None
) -> list[Any]:
    """Return a quantity with complex steps of what it depends on, one for each of q directions.

    A kernel gives it from parameters, spectrum and unknowns. `rates` has the rates (q,) of what
    changes, `count` is q, and `lib` is None in double precision.
    """
    kernels, still = orbit.kernels, np.zeros(count, dtype=int)
    names = (kernels.parameter_names, kernels.unknowns)
    number = float if lib is None else lib.mp.mpf
    parameters, unknowns = (
        [stepped(number(orbit.values[name]), rates.get(name, still), lib) for name in part]
        for part in names
    )
    arithmetic = ComplexSteps(FLOATS if lib is None else lib)
    found = []
    for place in range(count):
        point, solved = ([x[place] for x in part] for part in (parameters, unknowns))
        spectrum, _ = kernels.spectrum(point, arithmetic)
        values = kernels.evaluate(quantity, at=(point, spectrum, solved), lib=arithmetic)
        found.append(np.array(values, dtype=complex if lib is None else object))
    return found


def kernel_directions(orbit: Orbit, by: Sequence[str]) -> Directions:
    """Return how unknowns, dwell times and states move with each of some given numbers.

    `InputError` says why where there is no derivative.
    """
    kernels, lib = orbit.kernels, orbit.arithmetic if orbit.precise else None
    kind = float if lib is None else object
    names = [*kernels.unknowns, *kernels.parameter_names]
    parts = evaluate(orbit, "jacobian", "parameter_jacobian")
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
    number = float if lib is None else lib.mp.mpf
    unit = np.vectorize(number, otypes=[kind])(np.eye(len(by), dtype=int)).reshape(len(by), -1)
    rates |= dict(zip(by, unit, strict=True))
    everything = {name: np.zeros(len(by), dtype=kind) * number(0) for name in names} | rates
    dwell = kernels.durations(everything).values()
    waits = np.stack([np.broadcast_to(np.asarray(w), (len(by),)) for w in dwell], axis=-1)
    gradient = np.array(evaluate(orbit, "trace_gradient"), dtype=kind)
    trace = sum(slope * everything[name] for name, slope in zip(names, gradient, strict=True))
    wide = None if lib is None else Mpmath(2 * (orbit.digits + GUARD))

    def along(quantity: str) -> np.ndarray:
        return imaginary_parts(stepped_kernel(orbit, quantity, rates, len(by), wide), wide)

    def section() -> MapDerivatives:
        return MapDerivatives(
            real_parts(np.array(evaluate(orbit, "poincare_jacobian"), dtype=kind)),
            along("poincare_jacobian"),
            kernels.table["rank"],
            int(bool(kernels.table["conservative"])),
        )

    own = {name: rates[name] for name in orbit.unknowns}
    return Directions(own, waits, lambda: along("states")[:, :-1], section, np.asarray(trace))


def along_tables(
    orbit: Orbit, found: OrbitDerivatives
) -> tuple[OrbitMotionDerivatives, np.ndarray]:
    """Return an orbit with kernels as its tables see it move, and the rates of its parameters.

    The rates are (parameters, q). A sum such as e1 = ur1 - us1 is changed by the one of
    its parameters that is not open. Of a border collision, phases that take no time are
    left out: what is given and solved for keeps the collision, so that both boundaries go
    on to be reached together. `InputError` is raised where the orbit by tables has no
    derivatives.
    """
    kernels = orbit.kernels
    tables = orbit.problem.by_tables(orbit)
    if orbit.precise:
        tables = tables.problem.refined(tables, orbit.digits, "mpmath")
    moving: dict[str, np.ndarray] = {}
    opened = {table.name for table in kernels.open_parameters}
    physical = {table.name for table in kernels.system.parameters}
    unit = dict(zip(found.by, np.eye(len(found.by), dtype=int), strict=True))
    solved = [name for name in found.unknowns if name in kernels.combined or name in physical]
    for name in dict.fromkeys((*kernels.parameter_names, *solved)):
        rate = unit.get(name, found.unknowns.get(name))
        if rate is None:
            continue
        if name in kernels.combined:
            terms = kernels.combined[name]
            (target,) = [n for n in terms if n not in opened][:1] or [next(iter(terms))]
            moving[target] = rate * terms[target]  # factors are 1 and -1
        elif name in physical:
            moving[name] = rate
        elif name == kernels.period_name and tables.given_period is not None:
            moving[PERIOD] = rate
        else:
            raise InputError(f"{orbit.name}: how its motion changes with {name} is left open")
    by = tuple(moving)
    directions = tables.evaluation.directions(by)
    rates = np.array([moving[name] for name in by]).reshape(len(by), len(found.by))
    return OrbitMotionDerivatives(tables, by, directions), rates

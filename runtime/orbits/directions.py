"""How an orbit moves with what was given: the implicit function theorem, in any arithmetic."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from nonsmooth.runtime.core.arithmetic import FLOATS, Mpmath
from nonsmooth.runtime.core.complex_steps import (
    ComplexSteps,
    imaginary_parts,
    real_parts,
    stepped,
)
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.matrices import inverses
from nonsmooth.runtime.orbits.orbit import GUARD, Orbit
from nonsmooth.runtime.shooting.kernel_newton import natural_scales
from nonsmooth.runtime.shooting.multipliers import MapDerivatives
from nonsmooth.runtime.shooting.newton import LEAST

__all__ = ["SINGULAR", "Directions", "check_reasons", "kernel_directions", "solve_linear"]

CONSISTENT = 1e-7  # of the terms of an equation: what no orbit can follow


@dataclass(frozen=True, eq=False)
class Directions:
    """Derivatives of an orbit by q numbers."""

    unknowns: Mapping[str, np.ndarray]  # (q,) each, of what was solved for
    dwell: np.ndarray  # (q, p), of each phase
    moved: Callable[[], np.ndarray]  # gives `starts` when asked
    mapped: Callable[[], MapDerivatives]  # gives `section` when asked
    trace: np.ndarray | None = None  # (q,), where a formula gives it sharper than the map

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
    number = float if lib is None else lib.mp.mpf
    unit = np.vectorize(number, otypes=[kind])(np.eye(len(by), dtype=int)).reshape(len(by), -1)
    rates |= dict(zip(by, unit, strict=True))
    everything = {name: np.zeros(len(by), dtype=kind) * number(0) for name in names} | rates
    dwell = kernels.durations(everything).values()
    waits = np.stack([np.broadcast_to(np.asarray(w), (len(by),)) for w in dwell], axis=-1)
    gradient = np.array(orbit.evaluate("trace_gradient"), dtype=kind)
    trace = sum(slope * everything[name] for name, slope in zip(names, gradient, strict=True))
    wide = None if lib is None else Mpmath(2 * (orbit.digits + GUARD))

    def along(quantity: str) -> np.ndarray:
        return imaginary_parts(stepped_kernel(orbit, quantity, rates, len(by), wide), wide)

    def section() -> MapDerivatives:
        return MapDerivatives(
            real_parts(np.array(orbit.evaluate("poincare_jacobian"), dtype=kind)),
            along("poincare_jacobian"),
            kernels.table["rank"],
            int(bool(kernels.table["conservative"])),
        )

    own = {name: rates[name] for name in orbit.unknowns}
    return Directions(own, waits, lambda: along("states")[:, :-1], section, np.asarray(trace))

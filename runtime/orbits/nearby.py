"""The same orbit at other parameters, followed from where it is known."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np

from nonsmooth.runtime.core.errors import InputError, NoConvergence
from nonsmooth.runtime.core.values import Value, as_value
from nonsmooth.runtime.orbits.kernel_solve import solve_kernels
from nonsmooth.runtime.orbits.orbit import PERIOD, Orbit
from nonsmooth.runtime.orbits.table_problem import TableProblem, labelled
from nonsmooth.runtime.orbits.table_solve import solve_itinerary

if TYPE_CHECKING:
    from nonsmooth.runtime.orbits.derivatives import OrbitDerivatives

__all__ = ["followed"]

_SHORTEST = 1.0 / 1024  # of the way
_FAR = 0.2  # difference from the prediction, in units of the unknowns, of another orbit


def followed(
    reference: OrbitDerivatives, point: np.ndarray, shortest: float = _SHORTEST
) -> OrbitDerivatives:
    """Return the derivatives of the same orbit at another point, to which it is followed.

    The way is a straight line in the q numbers by which the reference is differentiated;
    it ends at the values `point` (q,). Steps shorter than the share `shortest` of the way
    are not tried. `NoConvergence` is raised where the orbit cannot be followed,
    `InputError` where there is no such system or no derivative.
    """
    if not np.isfinite(point).all():
        raise InputError("a point that is not finite")
    here, by = reference, reference.by
    begin = np.array([float(reference.orbit.given[name]) for name in by])
    done, step = 0.0, 1.0
    while done < 1:
        ahead = min(1.0, done + step)
        aim = point if ahead == 1 else begin + ahead * (point - begin)
        try:
            here = _stepped(here, aim)
        except (InputError, NoConvergence):
            step /= 2
            if step < shortest:
                raise
            continue
        done, step = ahead, 2 * step
    return here


def _stepped(here: OrbitDerivatives, aim: np.ndarray) -> OrbitDerivatives:
    """Return the derivatives one step ahead; `NoConvergence` if the orbit is not as predicted."""
    orbit, by = here.orbit, here.by
    now = np.array([float(orbit.given[name]) for name in by])
    names = tuple(orbit.unknowns)
    values = np.array([float(orbit.unknowns[name]) for name in names])
    rates = np.array([here.unknowns[name].astype(float) for name in names])
    guess = values + rates @ (aim - now)
    given = {**orbit.given, **{n: as_value(float(x)) for n, x in zip(by, aim, strict=True)}}
    found = _solved(orbit, given, dict(zip(names, guess.tolist(), strict=True)))
    if not found.converged:
        raise NoConvergence(f"{orbit.name}: {found.message}")
    if (found.dwell_times < 0).any():
        raise NoConvergence(f"{orbit.name}: a dwell time is negative")
    solved = np.array([float(found.unknowns[name]) for name in names])
    size = np.maximum(abs(values), abs(values).max(initial=0.0) * _FAR)
    if (abs(solved - guess) > _FAR * np.where(size > 0, size, 1.0)).any():
        raise NoConvergence(f"{orbit.name}: Newton's method leaves the orbit that was predicted")
    return found.derivatives(by, one_sided=bool(here.one_sided) or None)


def _solved(orbit: Orbit, given: Mapping[str, Value], guess: Mapping[str, float]) -> Orbit:
    """Return an orbit of the same itinerary and the same unknowns, from a guess of them.

    An orbit that was solved for by a part is solved for as a whole: a parameter may break
    the symmetry.
    """
    kernels = orbit.problem.kernels
    if kernels is None:
        period = given[PERIOD] if PERIOD in given and orbit.tables.family else None
        parameters = {name: value for name, value in given.items() if name != PERIOD}
        values, count = list(guess.values()), len(orbit.itinerary)
        found = solve_itinerary(
            orbit.system, parameters, orbit.itinerary, values[:count], values[count:], period=period
        )
        assert isinstance(orbit.problem, TableProblem)
        return labelled(found, orbit.problem.label, orbit.problem.names)
    swapped = tuple(name for name in orbit.unknowns if name not in kernels.unknowns)
    fixed = {name: value for name, value in given.items() if name in kernels.unknowns}
    taken = {name: value for name, value in given.items() if name not in fixed}
    start = {name: float(value) for name, value in fixed.items()}
    start |= {name: value for name, value in guess.items() if name in kernels.unknowns}
    return solve_kernels(
        kernels, {**taken, **orbit.opened}, start, unknown=swapped, given=fixed, throw=False
    )

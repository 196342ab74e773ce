"""An orbit at other parameters: followed to them, and its quantities as functions of them."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress

import numpy as np

from nonsmooth.runtime.core.differentiable import DifferentiableFunction
from nonsmooth.runtime.core.errors import InputError, NoConvergence, chosen_names
from nonsmooth.runtime.core.values import Value, as_value
from nonsmooth.runtime.orbits.derivatives import OrbitDerivatives
from nonsmooth.runtime.orbits.orbit import PERIOD, Orbit, check_converged
from nonsmooth.runtime.orbits.problem import labelled_as
from nonsmooth.runtime.orbits.solve import solve_kernels
from nonsmooth.runtime.orbits.table_solve import solve_itinerary

__all__ = ["followed", "orbit_function"]

_KEPT = 64  # points whose orbits are remembered
_SHORTEST = 1.0 / 1024  # of the way
_FAR = 0.2  # difference from the prediction, in units of the unknowns, of another orbit


def orbit_function(
    orbit: Orbit, *, by: Sequence[str] | str, of: Sequence[str] | str
) -> DifferentiableFunction:
    """Quantities of an orbit as a function of some of what was given.

    At other points the orbit is followed from the reference along a straight line, by steps
    that a first-order prediction bears out, so that another orbit is not taken for it. Where
    it cannot be followed, values and derivatives are NaN.

    Parameters
    ----------
    orbit : Orbit
        Where the function is made.
    by : sequence of str, or str
        Names of what was given; the others are kept.
    of : sequence of str, or str
        Quantities, as `OrbitDerivatives.quantity` knows them.

    Returns
    -------
    DifferentiableFunction

    Raises
    ------
    InputError
        For unknown names, and where the orbit has no derivatives.

    Examples
    --------
    >>> from nonsmooth.runtime.orbits.solve import solve
    >>> found = orbit_function(solve("dry-friction/global-stick"), by="eta", of=["period"])
    >>> found([1.01]).shape, found.jacobian([1.01]).shape
    ((1,), (1, 1))
    """
    check_converged(orbit, "made a function of parameters")
    inputs = chosen_names("given parameter", by, orbit.given)
    outputs = tuple(of) if isinstance(of, Iterable) and not isinstance(of, str) else (of,)
    if not outputs:
        raise InputError("a function gives at least one number")
    first = orbit.derivatives(inputs)
    for name in outputs:
        if not isinstance(name, str):
            raise InputError(f"{name!r} is no name of a quantity")
        first.quantity(name)
    reference = np.array([float(orbit.given[name]) for name in inputs])
    known: OrderedDict[bytes, OrbitDerivatives | None] = OrderedDict()
    known[reference.tobytes()] = first

    def at(point: np.ndarray) -> OrbitDerivatives | None:
        key = point.tobytes()
        if key not in known:
            try:
                found = followed(first, point)
            except (InputError, NoConvergence, ArithmeticError):
                found = None
            known[key] = found
            if len(known) > _KEPT:
                known.pop(next(k for k in known if k != reference.tobytes()))
        return known[key]

    def differentiate(points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        values = np.full((len(points), len(outputs)), np.nan)
        jacobians = np.full((len(points), len(outputs), len(inputs)), np.nan)
        for place, point in enumerate(points):
            if (found := at(np.ascontiguousarray(point))) is not None:
                with suppress(InputError, NoConvergence):
                    entries = [found.quantity(name) for name in outputs]
                    values[place] = [float(value) for value, _ in entries]
                    jacobians[place] = [rates.astype(float) for _, rates in entries]
        return values, jacobians

    def evaluate(points: np.ndarray) -> np.ndarray:
        return differentiate(points)[0]

    return DifferentiableFunction(inputs, outputs, reference, evaluate, differentiate)


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
        return labelled_as(found, orbit)
    swapped = tuple(name for name in orbit.unknowns if name not in kernels.unknowns)
    fixed = {name: value for name, value in given.items() if name in kernels.unknowns}
    taken = {name: value for name, value in given.items() if name not in fixed}
    start = {name: float(value) for name, value in fixed.items()}
    start |= {name: value for name, value in guess.items() if name in kernels.unknowns}
    return solve_kernels(
        kernels, {**taken, **orbit.opened}, start, unknown=swapped, given=fixed, throw=False
    )

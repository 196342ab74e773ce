"""Quantities of an orbit as functions of what was given, with exact derivatives."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.core.differentiable import DifferentiableFunction
from nonsmooth.runtime.core.errors import InputError, NoConvergence
from nonsmooth.runtime.orbits.derivatives import OrbitDerivatives
from nonsmooth.runtime.orbits.nearby import followed

if TYPE_CHECKING:
    from nonsmooth.runtime.orbits.orbit import Orbit

__all__ = ["orbit_function"]

_KEPT = 64  # points whose orbits are remembered


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
    inputs = (by,) if isinstance(by, str) else tuple(by)
    outputs = (of,) if isinstance(of, str) else tuple(of)
    if not inputs or not outputs:
        raise InputError("a function takes at least one number and gives at least one")
    first = orbit.derivatives(inputs)
    for name in outputs:
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

    def rows(points: np.ndarray) -> list[list[tuple[Any, np.ndarray]] | None]:
        return [row(at(np.ascontiguousarray(point))) for point in points]

    def row(found: OrbitDerivatives | None) -> list[tuple[Any, np.ndarray]] | None:
        try:
            return None if found is None else [found.quantity(name) for name in outputs]
        except (InputError, NoConvergence):
            return None

    def evaluate(points: np.ndarray) -> np.ndarray:
        return differentiate(points)[0]

    def differentiate(points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        values = np.full((len(points), len(outputs)), np.nan)
        jacobians = np.full((len(points), len(outputs), len(inputs)), np.nan)
        for place, entries in enumerate(rows(points)):
            if entries is not None:
                values[place] = [float(value) for value, _ in entries]
                jacobians[place] = [rates.astype(float) for _, rates in entries]
        return values, jacobians

    return DifferentiableFunction(inputs, outputs, reference, evaluate, differentiate)

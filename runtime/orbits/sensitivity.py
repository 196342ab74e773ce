"""Kernels of an orbit at its own numbers, and derivatives by its parameters."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.core.errors import unknown_name

if TYPE_CHECKING:
    from nonsmooth.runtime.orbits.orbit import Orbit

__all__ = ["Sensitivity", "evaluate", "sensitivity"]


def evaluate(orbit: Orbit, kernel: str, *, moved: bool = False) -> Any:
    """A kernel of an orbit at its own parameters and unknowns; see `Orbit.evaluate`.

    Parameters
    ----------
    orbit : Orbit
    kernel : str
        Its name.
    moved : bool
        Whether the kernel takes the derivatives of the spectrum.

    Returns
    -------
    array, or nested list
        Of doubles, or of numbers of the orbit's own arithmetic.
    """
    kernels, values = orbit.kernels, orbit.values
    parameters = [values[name] for name in kernels.parameter_names]
    unknowns = [values[name] for name in kernels.unknowns]
    if orbit.precise:
        lib = orbit.arithmetic
        spectrum, derivatives = kernels.spectrum(parameters, lib)
        arrays = (parameters, spectrum, *([derivatives] if moved else []), unknowns)
        return kernels.source(kernel)(*arrays, lib=lib)
    spectrum, derivatives = kernels.spectrum(parameters)
    arrays = (parameters, spectrum, *([derivatives] if moved else []), unknowns)
    return kernels.evaluate(kernel, *arrays)


@dataclass(frozen=True)
class Sensitivity:
    """Derivatives by one parameter, the others kept: nondimensional.

    Attributes
    ----------
    unknowns : dict of str to number
    period, trace : number
    """

    unknowns: dict[str, Any]
    period: Any
    trace: Any


def sensitivity(orbit: Orbit, parameter: str) -> Sensitivity:
    """Derivatives of unknowns, period and trace by one given parameter.

    By the implicit function theorem on the full equations, J du = -dF/dp, for the choice of
    unknowns of this orbit.

    Parameters
    ----------
    orbit : Orbit
        With kernels.
    parameter : str
        Name of one that was given.

    Returns
    -------
    Sensitivity
        Nondimensional.

    Raises
    ------
    InputError
        If the parameter is not among those given.
    """
    if parameter not in orbit.given:
        raise unknown_name("given parameter", parameter, orbit.given)
    kernels = orbit.kernels
    names = [*kernels.unknowns, *kernels.parameter_names]
    rows = [
        [*by_unknowns, *by_parameters]
        for by_unknowns, by_parameters in zip(
            evaluate(orbit, "jacobian"),
            evaluate(orbit, "parameter_jacobian", moved=True),
            strict=True,
        )
    ]
    places = [names.index(name) for name in orbit.unknowns]
    column = names.index(parameter)
    matrix = [[row[i] for i in places] for row in rows]
    right = [-row[column] for row in rows]
    solution = (
        orbit.arithmetic.solve(matrix, right)
        if orbit.precise
        else [float(x) for x in np.linalg.solve(np.array(matrix), np.array(right))]
    )
    rates = dict(zip(orbit.unknowns, solution, strict=True)) | {parameter: 1}
    gradient = evaluate(orbit, "trace_gradient", moved=True)
    slopes = dict(zip(names, gradient if orbit.precise else gradient.tolist(), strict=True))
    return Sensitivity(
        dict(zip(orbit.unknowns, solution, strict=True)),
        sum(kernels.durations({**dict.fromkeys(names, 0), **rates}).values()),
        sum(slopes[name] * rate for name, rate in rates.items()),
    )

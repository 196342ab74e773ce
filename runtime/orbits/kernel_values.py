"""Kernels of an orbit at its own numbers."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from nonsmooth.runtime.core.errors import InputError

if TYPE_CHECKING:
    from nonsmooth.runtime.orbits.orbit import Orbit

__all__ = ["evaluate"]


def evaluate(orbit: Orbit, *quantities: str) -> Any:
    """Return quantities of an orbit by its kernels, in its arithmetic; see `Orbit.evaluate`.

    They are arrays of doubles, or nested lists of numbers.
    """
    kernels, values = orbit.kernels, orbit.values
    for quantity in quantities:
        if quantity not in kernels.of_equations and kernels.has(quantity):
            raise InputError(
                f"{quantity!r} is of the reduced equations, which `kernels.evaluate` takes at"
                f" {', '.join(kernels.reduced) or 'no unknowns'}; at all unknowns there are:"
                f" {', '.join(kernels.of_equations)}"
            )
    lib = orbit.arithmetic if orbit.precise else None
    parameters = [values[name] for name in kernels.parameter_names]
    unknowns = [values[name] for name in kernels.unknowns]
    spectrum, derivatives = kernels.spectrum(parameters, lib)
    at = (parameters, spectrum, unknowns, derivatives)
    return kernels.evaluate(*quantities, at=at, lib=lib)

"""Kernels of an orbit at its own numbers."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from nonsmooth.runtime.orbits.orbit import Orbit

__all__ = ["evaluate"]


def evaluate(orbit: Orbit, kernel: str, *, moved: bool = False) -> Any:
    """Return a kernel's values at an orbit, in its arithmetic; see `Orbit.evaluate`.

    They are an array of doubles, or nested lists of numbers. `moved` says that the kernel
    takes the derivatives of the spectrum.
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

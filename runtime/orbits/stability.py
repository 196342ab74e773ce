"""Stability of an orbit: Poincare map, multipliers and the trace criterion (Secs. 4, 5).

The multipliers are those that `shooting.section_map` gives without kernels. Both stay: the trace
of the kernels keeps the digits of a reciprocal pair, in any precision, without an eigenvalue.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np

from nonsmooth.runtime.core.errors import NoConvergence
from nonsmooth.runtime.orbits.orbit import DOUBLE, GUARD, Orbit
from nonsmooth.runtime.orbits.refine import refine_kernels
from nonsmooth.runtime.shooting.kernel_newton import frequency_spread
from nonsmooth.runtime.shooting.multipliers import (
    Multiplier,
    Stability,
    eigenvalues_of,
    modulus,
    stability_of,
)
from nonsmooth.runtime.shooting.newton import LEAST
from nonsmooth.runtime.shooting.section_map import reciprocal

__all__ = ["assess_stability", "has_reciprocal_pair"]

_WIDE = 50.0  # ratio of frequencies beyond which doubles lose digits of the Poincare map


def assess_stability(orbit: Orbit) -> Stability:
    """Return the multipliers of an orbit with kernels and the verdict, to the orbit's digits.

    Where frequencies are so far apart that the map in doubles has fewer digits than the
    orbit, both are computed with more. The verdict is "undecided" where more digits
    cannot be had.
    """
    if orbit.precise or not frequency_spread(orbit.kernels, _spectrum(orbit)) > _WIDE:
        return _assessed(orbit)
    try:
        found = _assessed(refine_kernels(orbit, DOUBLE, "flint"))
    except NoConvergence:
        return replace(_assessed(orbit), verdict="undecided")
    multipliers = tuple(
        Multiplier(float(m.real), float(m.imaginary), m.trivial) for m in found.multipliers
    )
    trace, margin = float(found.trace), float(found.margin)
    return replace(found, multipliers=multipliers, trace=trace, margin=margin)


def _spectrum(orbit: Orbit) -> np.ndarray:
    values = [float(orbit.values[name]) for name in orbit.kernels.parameter_names]
    return np.asarray(orbit.kernels.spectrum(values)[0])


def _assessed(orbit: Orbit) -> Stability:
    table, precise = orbit.kernels.table, orbit.precise
    lib: Any = orbit.arithmetic.mp if precise else np
    trace = orbit.evaluate("trace") if precise else float(orbit.evaluate("trace"))
    rank, family = table["rank"], bool(table["conservative"])

    def eigenvalues() -> list[Multiplier]:
        if rank == 1:
            return [Multiplier(trace, lib.zero if precise else 0.0, trivial=family)]
        found = eigenvalues_of(_map(orbit), lib) if rank else []
        return sorted(found, key=lambda m: -float(modulus(m, lib)))[:rank]

    # what is carried beyond the digits asked for decides too
    ten = lib.mpf(10) if precise else 10.0
    error = ten ** -(orbit.digits + (GUARD - 5 if precise else -2))
    return stability_of(
        trace,
        rank,
        len(table["section"]),
        eigenvalues,
        family=family,
        pair=rank != 1 and has_reciprocal_pair(orbit),
        errors=(error, error),
        defective=lib.sqrt(error) if precise else math.sqrt(LEAST),
        grazes=_grazes(orbit, error),
        lib=lib,
        one_sided=" and ".join(f"{name} > 0" for name in table["vanishing"]),
    )


def _grazes(orbit: Orbit, error: Any) -> bool:
    """Return whether a phase may reach its exit boundary tangentially, where no map has a slope."""
    rates = _exit_rates if orbit.kernels.trigonometric else _exit_rates_of_fields
    return any(abs(rate) <= error * size for rate, size in rates(orbit))


def _exit_rates(orbit: Orbit) -> Iterator[tuple[Any, Any]]:
    """Yield the rate of the boundary that ends each phase, there, and the size of its terms."""
    kernels, lib = orbit.kernels, orbit.arithmetic.mp if orbit.precise else np
    coefficients, frequencies = map(list, orbit.evaluate("coefficients", "frequencies"))
    dwell, terms = orbit.dwell_times.tolist(), kernels.table["terms"]
    row = 0
    for boundary in kernels.boundaries:
        phase = boundary.phase
        count, before = terms[phase], sum(terms[:phase])
        _, rate, *waves = coefficients[row : row + 2 + 2 * count]
        row += 2 + 2 * count
        if boundary.name != kernels.table["phases"][phase][1]:
            continue
        size = abs(rate)
        for j, w in enumerate(frequencies[before : before + count]):
            cosine, sine = waves[j], waves[count + j]
            rate += w * (sine * lib.cos(w * dwell[phase]) - cosine * lib.sin(w * dwell[phase]))
            size += w * (abs(sine) + abs(cosine))
        yield rate, size


def _exit_rates_of_fields(orbit: Orbit) -> Iterator[tuple[Any, Any]]:
    """Yield these rates along damped and forced motions: n (A y + b) at the end y of a phase."""
    kernels = orbit.kernels
    found = orbit.evaluate("fields", "ends", "boundaries")
    fields, ends, rows = (np.array(a, dtype=object) for a in found)
    fields = fields.reshape(len(ends), -1, fields.shape[-1])
    for boundary, row in zip(kernels.boundaries, rows, strict=True):
        phase = boundary.phase
        if boundary.name == kernels.table["phases"][phase][1]:
            terms = row[:-1, None] * fields[phase] * np.append(ends[phase], 1)
            yield terms.sum(), abs(terms).sum()


def has_reciprocal_pair(orbit: Orbit) -> bool:
    """Return whether an orbit with kernels has multipliers 1, mu and 1/mu.

    The derivation tells it of transitions that keep volume. Others keep it along orbits that are
    their own time reversal, which the determinant of the map tells.
    """
    table = orbit.kernels.table
    if table["reciprocal_pair"] or not table["conservative"] or len(table["section"]) != 3:
        return bool(table["reciprocal_pair"])
    return reciprocal(_map(orbit), table["rank"], orbit.arithmetic.mp if orbit.precise else np)


def _map(orbit: Orbit) -> np.ndarray:
    matrix = orbit.evaluate("poincare_jacobian")
    return np.array(matrix, dtype=object if orbit.precise else float)

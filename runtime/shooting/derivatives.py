"""The shooting map of an itinerary with its derivatives by dwell times, start and a parameter.

Flows are exponentials of the fields, found without modes: nothing is asked of the eigenvalues.
The compiled engine does it where it is built; the same on NumPy serves elsewhere, with a tiny
imaginary part for the derivative (Al-Mohy and Higham, 2010).
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from nonsmooth.runtime.core.matrices import exponentials
from nonsmooth.runtime.model.balancing import balanced
from nonsmooth.runtime.model.kernels import compiled_engine
from nonsmooth.runtime.shooting.shooting_map import ItineraryShape, Numbers, phases_in
from nonsmooth.runtime.shooting.variational import COMPLEX_STEP, shooting_map

__all__ = [
    "ShootingDerivatives",
    "cycle_maps",
    "dependent_variational",
    "flows_over",
    "shooting_derivatives",
]

_TINY = 1e-30


class ShootingDerivatives(NamedTuple):
    """The shooting map at k points; its w unknowns are p dwell times, N states, a parameter.

    Attributes
    ----------
    starts : array (k, p + 1, N)
        State at each phase's start; last what the first would be after the chain.
    ends, velocities : array (k, p, N)
        State at each phase's end, and its velocity there.
    residual : array (k, p)
        Boundary function at each phase's end.
    slopes : array (k, p, w)
        Its derivatives.
    variational : array (k, N, w)
        Derivatives of the state after the chain.
    """

    starts: np.ndarray
    ends: np.ndarray
    velocities: np.ndarray
    residual: np.ndarray
    slopes: np.ndarray
    variational: np.ndarray


def shooting_derivatives(
    cycle: ItineraryShape,
    numbers: Numbers,
    dwell: np.ndarray,
    start: np.ndarray,
    changes: Numbers | None = None,
) -> ShootingDerivatives:
    """Pass through a cycle once, at k points.

    Parameters
    ----------
    cycle : ItineraryShape
    numbers : Numbers
        Of k points; exponents and flows are not used.
    dwell : array (k, p)
        In the system's unit of time.
    start : array (k, N)
        In the system's units.
    changes : Numbers, optional
        Derivatives of the numbers by a parameter, which is then the last unknown.

    Returns
    -------
    ShootingDerivatives
        NaN where flows are not finite.
    """
    count, (points, size) = len(cycle), start.shape
    engine = compiled_engine()
    if engine is None:
        return _in_python(cycle, numbers, dwell, start, changes)
    unknowns = count + size + (changes is not None)
    found = ShootingDerivatives(
        np.empty((points, count + 1, size)),
        np.empty((points, count, size)),
        np.empty((points, count, size)),
        np.empty((points, count)),
        np.empty((points, count, unknowns)),
        np.empty((points, size, unknowns)),
    )
    found.starts[:, 0] = start
    nothing = (np.empty(0),) * 3
    moved = nothing if changes is None else cycle_maps(cycle, changes)
    maps = (np.ascontiguousarray(dwell), *cycle_maps(cycle, numbers))
    engine.shoot(points, count, size, *maps, *moved, *found)
    return found


def dependent_variational(found: ShootingDerivatives) -> np.ndarray:
    """Derivatives of the state after a chain whose dwell times follow the start.

    Parameters
    ----------
    found : ShootingDerivatives
        Of k points.

    Returns
    -------
    array (k, N, N)
        Infinite or NaN where a boundary is touched.
    """
    count, size = found.residual.shape[1], found.ends.shape[2]
    changes = found.variational[:, :, count : count + size].copy()
    slopes = found.slopes[:, :, count : count + size].copy()
    for place in range(count):  # a dwell time changes what follows alone
        with np.errstate(all="ignore"):
            rate = slopes[:, place] / -found.slopes[:, place, place, None]
        for later in range(place + 1, count):
            slopes[:, later] += found.slopes[:, later, place, None] * rate
        changes += found.variational[:, :, place, None] * rate[:, None]
    return changes


def cycle_maps(cycle: ItineraryShape, numbers: Numbers) -> tuple[np.ndarray, ...]:
    """Fields, rows and resets phase by phase, as the compiled engine reads them.

    Parameters
    ----------
    cycle : ItineraryShape
    numbers : Numbers
        Of k points.

    Returns
    -------
    fields, rows, resets : array (k, p, ...)
        Contiguous.
    """
    configurations, rows, resets = cycle.packed[: 3 * len(cycle)].reshape(3, -1)
    return (
        numbers.fields.take(configurations, axis=1),
        numbers.rows.take(rows, axis=1),
        numbers.resets.take(resets, axis=1),
    )


def flows_over(fields: np.ndarray, dwell: np.ndarray) -> np.ndarray:
    """Flows of fields over times; a tiny imaginary part comes out as a derivative.

    Parameters
    ----------
    fields : array (..., N, N + 1)
        Real or complex.
    dwell : array (...)
        In the system's unit of time.

    Returns
    -------
    array (..., N, N + 1)
        NaN where they are not finite.
    """
    size = fields.shape[-2]
    kind = np.result_type(fields, dwell)
    generators = np.zeros((dwell.size, size + 1, size + 1), dtype=kind)
    generators[:, :size] = fields.reshape(-1, size, size + 1)
    with np.errstate(all="ignore"):  # of what is not finite nothing is
        _, units = balanced(generators.real)
        scaled = generators * units[:, None] / units[:, :, None] * dwell.reshape(-1, 1, 1)
        flows = exponentials(scaled) * units[:, :, None] / units[:, None]
    return np.asarray(flows.reshape(*dwell.shape, size + 1, size + 1)[..., :size, :])


def _in_python(
    cycle: ItineraryShape,
    numbers: Numbers,
    dwell: np.ndarray,
    start: np.ndarray,
    changes: Numbers | None,
) -> ShootingDerivatives:
    """The same on NumPy."""
    count, (points, size) = len(cycle), start.shape
    if changes is not None:
        numbers = Numbers(
            numbers.fields + 1j * _TINY * changes.fields,
            numbers.rows + 1j * _TINY * changes.rows,
            numbers.resets + 1j * _TINY * changes.resets,
        )
    flows = flows_over(numbers.fields[:, list(cycle.configurations)], dwell)
    unit = np.broadcast_to(np.eye(count + size), (points, count + size, count + size))
    with np.errstate(all="ignore"):
        found = shooting_map(
            COMPLEX_STEP,
            phases_in(cycle, numbers),
            np.moveaxis(flows, 1, 0),
            start[..., None],
            unit[:, count:],
            [unit[:, place, None] for place in range(count)],
        )
    states, ends, velocities = (
        np.stack(part, axis=1)[..., 0] for part in (found.starts, found.ends, found.velocities)
    )
    residual = np.stack(found.residual, axis=1)[..., 0, 0]
    slopes, variational = np.stack(found.slopes, axis=1)[..., 0, :], found.variational
    if changes is not None:
        slopes = np.concatenate([slopes, residual.imag[..., None] / _TINY], axis=-1)
        moved = states[:, -1].imag[..., None] / _TINY
        variational = np.concatenate([variational, moved], axis=-1)
    parts = (states, ends, velocities, residual, slopes, variational)
    return ShootingDerivatives(*(np.ascontiguousarray(part.real) for part in parts))

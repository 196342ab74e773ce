"""The shooting map of an itinerary with its derivatives by dwell times, start and a parameter.

Flows are exponentials of the fields, found without modes: nothing is asked of the eigenvalues.
The compiled engine does it where it is built; the same on NumPy serves elsewhere, with a tiny
imaginary part for the derivative (Al-Mohy and Higham, 2010).
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from nonsmooth.runtime.core.arithmetic import Mpmath
from nonsmooth.runtime.core.complex_steps import imaginary_parts, stepped
from nonsmooth.runtime.core.matrices import exponentials
from nonsmooth.runtime.model.exponential import exponential
from nonsmooth.runtime.model.kernels import compiled_engine
from nonsmooth.runtime.model.natural_units import balanced
from nonsmooth.runtime.shooting.shooting_map import ItineraryShape, Numbers, phases_in
from nonsmooth.runtime.shooting.variational import COMPLEX_STEP, shooting_map

__all__ = [
    "ShootingDerivatives",
    "cycle_maps",
    "dependent_variational",
    "flows_over",
    "shooting_derivatives",
]


class ShootingDerivatives(NamedTuple):
    """The shooting map at k points; its w unknowns are p dwell times, N states, a parameter."""

    starts: np.ndarray  # (k, p + 1, N), state at each phase's start; last the state after the chain
    ends: np.ndarray  # (k, p, N), state at each phase's end
    velocities: np.ndarray  # (k, p, N), velocity at each phase's end
    residual: np.ndarray  # (k, p), boundary function at each phase's end
    slopes: np.ndarray  # (k, p, w), its derivatives by the unknowns
    variational: np.ndarray  # (k, N, w), derivatives of the state after the chain


def shooting_derivatives(
    cycle: ItineraryShape,
    numbers: Numbers,
    dwell: np.ndarray,
    start: np.ndarray,
    changes: Numbers | None = None,
) -> ShootingDerivatives:
    """The shooting map of one passage through a cycle, with its derivatives, at k points.

    The numbers' exponents and flows are not used. Dwell times (k, p) and the start (k, N) are in
    the system's units. `changes` are derivatives of the numbers by a parameter, which is then the
    last unknown. The result is NaN where flows are not finite.
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
    """Derivatives (k, N, N) of the state after a chain by the start, dwell times following it.

    They are infinite or NaN where a boundary is touched tangentially.
    """
    count, size = found.residual.shape[1], found.ends.shape[2]
    changes = found.variational[:, :, count : count + size].copy()
    slopes = found.slopes[:, :, count : count + size].copy()
    with np.errstate(all="ignore"):
        for place in range(count):  # a dwell time changes what follows alone
            rate = slopes[:, place] / -found.slopes[:, place, place, None]
            for later in range(place + 1, count):
                slopes[:, later] += found.slopes[:, later, place, None] * rate
            changes += found.variational[:, :, place, None] * rate[:, None]
    return changes


def cycle_maps(cycle: ItineraryShape, numbers: Numbers) -> tuple[np.ndarray, ...]:
    """Fields, rows and resets (k, p, ...) phase by phase, contiguous for the compiled engine."""
    configurations, rows, resets = cycle.packed[: 3 * len(cycle)].reshape(3, -1)
    return (
        numbers.fields.take(configurations, axis=1),
        numbers.rows.take(rows, axis=1),
        numbers.resets.take(resets, axis=1),
    )


def flows_over(fields: np.ndarray, dwell: np.ndarray, lib: Mpmath | None = None) -> np.ndarray:
    """Flows (..., N, N + 1) of fields (..., N, N + 1) over times (...), in the system's unit.

    Fields may be complex: a tiny imaginary part comes out as a derivative. Flows that are not
    finite are NaN. `lib` is None in double precision.
    """
    size = fields.shape[-2]
    flat = fields.reshape(-1, size, size + 1)
    if lib is not None:
        mp, times = lib.mp, dwell.ravel()
        flows = [exponential(f, mp.mpc(t), mp) for f, t in zip(flat, times, strict=True)]
        return np.array(flows, dtype=object).reshape(fields.shape)
    kind = np.result_type(fields, dwell)
    generators = np.zeros((dwell.size, size + 1, size + 1), dtype=kind)
    generators[:, :size] = flat
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
    """The result of `shooting_derivatives`, computed by NumPy."""
    count, (points, size) = len(cycle), start.shape
    if changes is not None:
        numbers = numbers.each(lambda part, rates: stepped(part, rates, None), changes)
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
        slopes = np.concatenate([slopes, imaginary_parts(residual, None)[..., None]], axis=-1)
        moved = imaginary_parts(states[:, -1], None)[..., None]
        variational = np.concatenate([variational, moved], axis=-1)
    parts = (states, ends, velocities, residual, slopes, variational)
    return ShootingDerivatives(*(np.ascontiguousarray(part.real) for part in parts))

"""The energy of an undamped orbit, from the numbers of its system alone.

A system's tables know accelerations, not masses. The energy is looked for as
v M v / 2 + potential: M is symmetric and makes each stiffness M A symmetric, and energies on
both sides of a transition agree on its boundary. That is linear in M and in the potentials'
constants, and fixes M up to a factor wherever the masses are coupled.
"""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.model.piecewise import piecewise
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.shooting.shooting_map import ItineraryShape, Numbers, numbers_in

_ZERO = 1e-10  # relative size of a singular value, or of a number, that is zero
_KEPT = 1e-7  # relative difference of the energy at the starts of two phases


def energy_of(orbit: Orbit) -> float:
    """Energy of a converged conservative orbit.

    Its unit is that in which the first coordinate has the mass 1 (divide energies in other
    units by that mass), and it is zero at the lowest of the equilibria of the configurations
    that the orbit passes. Raises `InputError` if no energy is kept along the orbit.
    """
    by_tables = orbit.problem.by_tables(orbit)  # kernels may have other parameters and states
    cycle, states = by_tables.tables.cycle, by_tables.states.astype(float)
    time, units = _units(states, float(orbit.period))
    numbers = numbers_in(piecewise(by_tables.system, by_tables.parameters))
    numbers = _measured(numbers, time, units)
    states = states / units
    forms = _forms(cycle, numbers, states.shape[1])
    if forms is None:
        raise InputError(f"no energy is kept along {orbit.name}")
    extended = np.column_stack([states, np.ones(len(states))])
    absolute = {configuration: np.abs(form) for configuration, form in forms.items()}
    values = _energies(cycle, forms, extended)
    if np.ptp(values) > _KEPT * max(_energies(cycle, absolute, np.abs(extended))):
        raise InputError(f"no energy is kept along {orbit.name}")
    unit = units[states.shape[1] // 2] ** 2  # of the first velocity
    return float(unit) * (values[0] - min(_lowest(form) for form in forms.values()))


def _units(states: np.ndarray, period: float) -> tuple[float, np.ndarray]:
    """Unit of time, and units (N,) of positions, then velocities.

    They are powers of two near the sizes of these.
    """
    time = 2.0 ** round(math.log2(period / (2 * math.pi)))
    count = states.shape[1] // 2
    sizes = np.abs(states).max(axis=0)
    lengths = np.maximum(sizes[:count], sizes[count : 2 * count] * time)
    lengths = np.exp2(np.rint(np.log2(np.where(lengths > 0, lengths, 1.0))))
    units = np.ones(states.shape[1])
    units[:count], units[count : 2 * count] = lengths, lengths / time
    return time, units


def _measured(numbers: Numbers, time: float, units: np.ndarray) -> Numbers:
    """Numbers of a system in other units of time and states, with normalised rows."""
    columns = np.append(units, 1.0)
    rows = numbers.rows * columns
    largest = np.abs(rows).max(axis=1, keepdims=True)
    return numbers._replace(
        fields=numbers.fields * columns / units[:, None] * time,
        rows=rows / np.where(largest > 0, largest, 1.0),
        resets=numbers.resets * columns / units[:, None],
    )


def _energies(
    cycle: ItineraryShape, forms: dict[int, np.ndarray], extended: np.ndarray
) -> list[float]:
    """Values (y, 1) H (y, 1) / 2 at the starts (p, N + 1) of the phases."""
    return [
        float(state @ forms[configuration] @ state) / 2
        for configuration, state in zip(cycle.configurations, extended, strict=True)
    ]


def _forms(cycle: ItineraryShape, numbers: Numbers, size: int) -> dict[int, np.ndarray] | None:
    """Symmetric matrices H of the energies (y, 1) H (y, 1) / 2, by configuration."""
    visited, count = sorted(set(cycle.configurations)), size // 2
    if size % 2:
        return None
    for field in numbers.fields[visited]:  # x' = v, v' = b - A x, without damping
        kinematics = np.array_equal(field[:count], np.eye(count, 2 * count + 1, count))
        if not kinematics or field[count:, count:-1].any():
            return None
    lower = np.tril_indices(count)
    pairs = len(lower[0])

    def forms(values: np.ndarray) -> dict[int, np.ndarray]:
        """Those of a mass matrix and of the potentials' constants."""
        mass = np.zeros((count, count))
        mass[lower] = mass.T[lower] = values[:pairs]
        constants = zip(visited, values[pairs:].tolist(), strict=True)
        return {c: _form(numbers.fields[c], mass, constant) for c, constant in constants}

    units = np.eye(pairs + len(visited))
    missed = np.array([_missed(cycle, numbers, forms(unit)) for unit in units]).T
    _, values, right = np.linalg.svd(missed)
    rank = int(np.count_nonzero(values > _ZERO * max(1.0, float(values[0]))))
    kept = right[rank:]
    # without masses a constant that all potentials share is left, and roundings
    masses = np.where(np.abs(kept[:, :pairs]) > _ZERO, kept[:, :pairs], 0.0)
    wanted = (lower[0] == lower[1]).astype(float)
    found = np.linalg.lstsq(masses.T, wanted, rcond=_ZERO)[0] @ kept
    mass = forms(found)[visited[0]][count:-1, count:-1]
    if np.linalg.eigvalsh(mass)[0] <= _ZERO:
        return None
    return forms(found / mass[0, 0])


def _form(field: np.ndarray, mass: np.ndarray, constant: float) -> np.ndarray:
    """The matrix of an energy, which is symmetric if the stiffness is."""
    count = len(mass)
    form = np.zeros((2 * count + 1, 2 * count + 1))
    form[:count, :count] = -mass @ field[count:, :count]
    form[count:-1, count:-1] = mass
    form[-1, :count] = form[:count, -1] = -mass @ field[count:, -1]
    form[-1, -1] = constant
    return form


def _missed(cycle: ItineraryShape, numbers: Numbers, forms: Mapping[int, np.ndarray]) -> np.ndarray:
    """Residuals of the conditions for a conserved energy, linear in its forms."""
    missed = [(form - form.T).ravel() for form in forms.values()]
    for place, transition in enumerate(cycle.transitions):
        before = forms[cycle.configurations[place]]
        after = forms[cycle.configurations[(place + 1) % len(cycle)]]
        reset = np.vstack(
            [numbers.resets[transition.reset], np.eye(1, len(before), len(before) - 1)]
        )
        row = numbers.rows[cycle.rows[place]]
        on = np.linalg.svd(row[None])[2][1:].T
        jump = on.T @ (reset.T @ after @ reset - before) @ on
        missed.append((jump + jump.T).ravel())
    return np.concatenate(missed)


def _lowest(form: np.ndarray) -> float:
    """Energy at a configuration's equilibrium; without one, at the zero state."""
    matrix, linear, constant = form[:-1, :-1], form[:-1, -1], form[-1, -1]
    if np.linalg.eigvalsh(matrix)[0] <= _ZERO:
        return float(constant) / 2
    return float(constant - linear @ np.linalg.solve(matrix, linear)) / 2

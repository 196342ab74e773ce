"""Derivatives of observables of a motion: extremes, averages, times in configurations, works."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.core.complex_steps import imaginary_parts, stepped
from nonsmooth.runtime.simulation.observables import observe, observed_rows, sticking

if TYPE_CHECKING:
    from nonsmooth.runtime.simulation.derivatives import MotionDerivatives

__all__ = ["ContactDerivatives", "ObservableDerivatives", "observable_derivatives"]


@dataclass(frozen=True, eq=False)
class ContactDerivatives:
    """Derivatives (q,) of what passes through one contact; see `ContactObservables`.

    Attributes
    ----------
    minimum, maximum, mean, work, dissipated : array (q,)
    """

    minimum: np.ndarray
    maximum: np.ndarray
    mean: np.ndarray
    work: np.ndarray
    dissipated: np.ndarray


@dataclass(frozen=True, eq=False)
class ObservableDerivatives:
    """Derivatives of a motion's observables by q numbers; see `Observables`.

    Where two extremes of one function are equal they are those of one of them.

    Attributes
    ----------
    by : tuple of str
    duration : array (q,)
    minima, maxima, means, rms : dict of state to array (q,)
    fractions : dict of configuration to array (q,)
    sticking : dict of position to array (q,)
    contacts : dict of str to ContactDerivatives
    """

    by: tuple[str, ...]
    duration: np.ndarray
    minima: dict[str, np.ndarray]
    maxima: dict[str, np.ndarray]
    means: dict[str, np.ndarray]
    rms: dict[str, np.ndarray]
    fractions: dict[str, np.ndarray]
    sticking: dict[str, np.ndarray]
    contacts: dict[str, ContactDerivatives]


def observable_derivatives(found: MotionDerivatives, since: float = 0.0) -> ObservableDerivatives:
    """Derivatives of a motion's observables from the fixed time `since` on.

    The motion is refused as by `observe`, if it ended where it cannot go on, or if
    boundaries come apart whose times have other derivatives on the other side.
    """
    by, structure, values = found.by, found.trajectory.structure, observe(found.trajectory, since)
    names, size, contacts = structure.states, len(structure.states), len(structure.contacts)
    forces = [size + 3 * i for i in range(contacts)]
    lowest, highest = np.empty((2, size + contacts, len(by)))
    moments = np.empty((len(by), size + 3 * contacts, size + 3 * contacts + 1), dtype=complex)
    spent = np.empty((len(by), len(structure.configurations)), dtype=complex)
    for columns, side, moved in found.moved_parts(since):
        rows = observed_rows(structure, moved.numbers.rows)
        ends = moved.extremes(rows[:, :, [*range(size), *forces]], side)
        for whole, part in zip((lowest, highest), ends, strict=True):
            whole[:, columns] = [extreme.rates for extreme in part]
        moments[columns], spent[columns] = moved.moments(rows), moved.spent
    duration = stepped(values.duration, found.end, None)
    means = imaginary_parts(moments[..., -1] / duration[:, None], None).T
    squares = np.diagonal(moments, axis1=1, axis2=2)[:, :size] / duration[:, None]
    fractions = imaginary_parts(spent / duration[:, None], None)
    with np.errstate(divide="ignore", invalid="ignore"):  # what rests has no slope
        rms = imaginary_parts(squares, None).T / (2 * np.array([*values.rms.values()])[:, None])
    works = imaginary_parts(moments, None)
    return ObservableDerivatives(
        by,
        found.end,
        dict(zip(names, lowest[:size], strict=True)),
        dict(zip(names, highest[:size], strict=True)),
        dict(zip(names, means[:size], strict=True)),
        dict(zip(names, rms, strict=True)),
        dict(zip(structure.configurations, fractions.T, strict=True)),
        _columns(sticking(structure, part) for part in fractions),
        {
            contact.name: ContactDerivatives(
                lowest[size + i],
                highest[size + i],
                means[force],
                works[:, force, force + 1],
                works[:, force, force + 2] - works[:, force, force + 1],
            )
            for i, (contact, force) in enumerate(zip(structure.contacts, forces, strict=True))
        },
    )


def _columns(parts: Iterable[dict[str, Any]]) -> dict[str, np.ndarray]:
    """Arrays (q,) by name, from q dicts of numbers by name."""
    listed = list(parts)
    return {name: np.array([part[name] for part in listed]) for name in (listed or [{}])[0]}

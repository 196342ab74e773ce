"""Derivatives of observables of a motion: extremes, averages, times in configurations, works."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, fields, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.core.complex_steps import imaginary_parts, stepped
from nonsmooth.runtime.core.errors import InputError
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
    (motion, *others) = found.parts
    if others or motion.trajectory is not found.trajectory:
        return _joined(found, since)
    trajectory, by, structure = found.trajectory, found.by, found.trajectory.structure
    names, size = structure.states, len(structure.states)
    values, moved = observe(trajectory, since), found.moved_phases(since)
    rows = observed_rows(structure, moved.numbers.rows)
    forces = [size + 3 * i for i in range(len(structure.contacts))]
    side = found.one_sided if motion.apart.any() else None
    lowest, highest = (
        [extreme.rates for extreme in each]
        for each in moved.extremes(rows[:, :, [*range(size), *forces]], side)
    )
    moments, duration = moved.moments(rows), stepped(values.duration, found.end, None)
    means = imaginary_parts(moments[..., -1] / duration[:, None], None).T
    squares = np.diagonal(moments, axis1=1, axis2=2)[:, :size] / duration[:, None]
    spent = np.zeros((len(by), len(structure.configurations)), dtype=complex)
    waits = stepped(moved.phases.durations, moved.rates[1] - moved.rates[0], None)
    for configuration in range(spent.shape[1]):
        there = moved.phases.configurations == configuration
        spent[:, configuration] = waits[:, there].sum(axis=1)
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


def _joined(found: MotionDerivatives, since: float) -> ObservableDerivatives:
    """Derivatives by all numbers, joined from the motions of `found.parts`.

    Each of these has the transitions that the motion moved by some of the numbers makes.
    """
    every: list[tuple[np.ndarray, ObservableDerivatives]] = []
    for part in found.parts:
        if part.open.any():
            reached = found.trajectory.boundaries[1 + int(np.argmax(part.open))]
            raise InputError(
                f"{' and '.join(reached)} are reached together: observables have derivatives on"
                " one side there; ask for them by one_sided"
            )
        by = tuple(found.by[column] for column in part.columns)
        own = replace(found, trajectory=part.trajectory, by=by, parts=(part.alone,))
        every.append((part.columns, observable_derivatives(own, since)))

    def join(parts: list[Any]) -> Any:
        if isinstance(parts[0], dict):
            keys = dict.fromkeys(key for part in parts for key in part)
            return {key: join([part.get(key) for part in parts]) for key in keys}
        if isinstance(parts[0], ContactDerivatives):
            return ContactDerivatives(
                *(join([getattr(part, f.name) for part in parts]) for f in fields(parts[0]))
            )
        whole = np.zeros(len(found.by))
        for (columns, _), part in zip(every, parts, strict=True):
            whole[columns] = 0.0 if part is None else part
        return whole

    names = [f.name for f in fields(ObservableDerivatives) if f.name != "by"]
    return ObservableDerivatives(
        found.by, *(join([getattr(own, name) for _, own in every]) for name in names)
    )


def _columns(parts: Iterable[dict[str, Any]]) -> dict[str, np.ndarray]:
    """Arrays (q,) by name, from q dicts of numbers by name."""
    listed = list(parts)
    return {name: np.array([part[name] for part in listed]) for name in (listed or [{}])[0]}

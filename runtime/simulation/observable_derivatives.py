"""Derivatives of observables of a motion: extremes, averages, times in configurations, works.

An extreme inside a phase moves with the state at its time, which may be held fixed (the envelope
theorem); one at a transition moves with the state on that side of it. An integral changes by that
of its integrand's change, and at the ends of phases by what the transitions' times add.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, fields, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.simulation.extremes import Extreme
from nonsmooth.runtime.simulation.flow_derivatives import quadrature
from nonsmooth.runtime.simulation.observables import contact_rows, observe, sticking
from nonsmooth.runtime.simulation.phase_functions import phases_of
from nonsmooth.runtime.simulation.transition_derivatives import extended

if TYPE_CHECKING:
    from nonsmooth.runtime.simulation.derivatives import MotionDerivatives

__all__ = ["ContactDerivatives", "ObservableDerivatives", "observable_derivatives"]


_TIED = 1e-12


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
    trajectory, by = found.trajectory, found.by
    system, structure = trajectory.system, trajectory.structure
    values, phases = observe(trajectory, since), phases_of(trajectory, since)
    contacts = [values.contacts[contact.name] for contact in structure.contacts]
    wanted = [*values.minima.values(), *values.maxima.values()]
    wanted += [part for contact in contacts for part in (contact.minimum, contact.maximum)]
    places, nodes, weights = quadrature(system, phases)
    first = len(trajectory.times) - len(phases.begins)
    begins = np.concatenate([np.zeros((1, len(by))), found.event_times])[first:]
    begins[0] = 0.0
    ends = np.concatenate([begins[1:], found.end[None]])
    at = np.concatenate([nodes, [extreme.time for extreme in wanted]])
    linear = motion.linearisation(np.minimum(at, trajectory.end))
    tables, starts = linear.directions(by)
    changes = linear.forward(tables, starts)[0]
    # functions: the states, then force, velocity and surface of each contact
    size = len(structure.states)
    rows = _rows(found, system.rows)
    moved = [_rows(found, part) for part in tables.rows]
    for part in moved:
        part[:, :size] = 0.0
    slopes = np.array(moved).reshape(len(by), *rows.shape)

    own = phases.configurations[places]
    states = extended(trajectory(nodes))
    g = (rows[own] @ states[..., None])[..., 0]
    change = rows[own][..., :-1] @ changes[: len(nodes)] + np.einsum(
        "qnki,ni->nkq", slopes[:, own], states
    )
    borders = [
        (rows[phases.configurations] @ extended(part)[..., None])[..., 0]
        for part in (phases.starts, phases.ends)
    ]

    def integral(one: int, other: int | None = None) -> tuple[float, np.ndarray]:
        """Integral of one function, or of the product of two, and its derivatives (q,)."""
        product = g[:, one] if other is None else g[:, one] * g[:, other]
        inside = change[:, one]
        left, right = (part[:, one] for part in borders)
        if other is not None:
            inside = inside * g[:, other, None] + change[:, other] * g[:, one, None]
            left, right = (part[:, one] * part[:, other] for part in borders)
        return float(weights @ product), weights @ inside + right @ ends - left @ begins

    duration, by_duration = values.duration, ends[-1]

    def mean(one: int, other: int | None = None) -> np.ndarray:
        total, slope = integral(one, other)
        return np.asarray((slope - total / duration * by_duration) / duration)

    def extreme(one: int, which: int) -> np.ndarray:
        upper = size <= which < 2 * size or (which >= 2 * size and which % 2 == 1)
        change = changes[len(nodes) + which]
        return _extreme(found, rows, slopes, one, wanted[which], upper, change)

    names = structure.states
    spent = np.zeros((len(structure.configurations), len(by)))
    np.add.at(spent, phases.configurations, ends - begins)
    times = np.array([values.fractions[name] for name in structure.configurations])
    fractions = (spent - times[:, None] * by_duration) / duration
    squares = {name: mean(i, i) for i, name in enumerate(names)}
    told: dict[str, ContactDerivatives] = {}
    for i, contact in enumerate(structure.contacts):
        force = size + 3 * i
        work, belt = integral(force, force + 1)[1], integral(force, force + 2)[1]
        told[contact.name] = ContactDerivatives(
            extreme(force, 2 * size + 2 * i),
            extreme(force, 2 * size + 2 * i + 1),
            mean(force),
            work,
            belt - work,
        )
    with np.errstate(divide="ignore", invalid="ignore"):  # what rests has no slope
        rms = {name: part / (2 * values.rms[name]) for name, part in squares.items()}
    return ObservableDerivatives(
        by,
        by_duration,
        {name: extreme(i, i) for i, name in enumerate(names)},
        {name: extreme(i, size + i) for i, name in enumerate(names)},
        {name: mean(i) for i, name in enumerate(names)},
        rms,
        dict(zip(structure.configurations, fractions, strict=True)),
        _columns(sticking(structure, part) for part in fractions.T),
        told,
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


def _rows(found: MotionDerivatives, rows: np.ndarray) -> np.ndarray:
    """Rows (configurations, K, N + 1) of the observed functions, from the system's rows.

    Instead of these, `rows` may be their changes by a number. The functions are the states,
    then force, velocity and surface of each contact.
    """
    system = replace(found.trajectory.system, rows=rows)
    structure = system.structure
    size = len(structure.states)
    parts = [np.tile(np.eye(size, size + 1), (len(structure.configurations), 1, 1))]
    parts += [contact_rows(system, contact) for contact in structure.contacts]
    return np.concatenate(parts, axis=1)


def _extreme(
    found: MotionDerivatives,
    rows: np.ndarray,
    slopes: np.ndarray,
    one: int,
    extreme: Extreme,
    upper: bool,
    change: np.ndarray,
) -> np.ndarray:
    """Derivatives (q,) of an extreme value, which is attained in a phase or beside a transition.

    If several values tie where boundaries come apart, a one-sided derivative takes the
    value that becomes the extreme.
    """
    trajectory = found.trajectory
    run, time = trajectory.run, extreme.time
    phase = int(np.searchsorted(run.times, time, side="right")) - 1
    state = trajectory(min(time, trajectory.end))
    where = int(run.configurations[phase])
    near = np.abs(run.times[1:] - time) <= 64 * np.spacing(run.times[-1])
    found_at = []
    for entry in np.flatnonzero(near) + 1:
        sides = (
            (int(run.configurations[entry - 1]), run.before[entry], found.before[entry]),
            (int(run.configurations[entry]), run.states[entry], found.behind[entry]),
        )
        for configuration, border, moved in sides:
            row = rows[configuration, one]
            missed = abs(row @ extended(border) - extreme.value)
            size = np.abs(row) @ np.abs(extended(border))
            rates = row[:-1] @ moved + slopes[:, configuration, one] @ extended(border)
            found_at.append((missed, size, rates))
    if not found_at:
        return np.asarray(rows[where, one, :-1] @ change + slopes[:, where, one] @ extended(state))
    best, _, rates = min(found_at, key=lambda each: each[0])
    if not found.parts[0].apart.any() or found.one_sided is None:
        return np.asarray(rates)
    tied = [own for missed, size, own in found_at if missed <= best + _TIED * size]
    return np.asarray((np.max if upper == (found.one_sided == "+") else np.min)(tied, axis=0))


def _columns(parts: Iterable[dict[str, Any]]) -> dict[str, np.ndarray]:
    """Arrays (q,) by name, from q dicts of numbers by name."""
    listed = list(parts)
    return {name: np.array([part[name] for part in listed]) for name in (listed or [{}])[0]}

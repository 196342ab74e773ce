"""The start of a simulation: a state by names, and the configuration that it belongs to.

Some systems have configurations that are made when they are visited. A motion that enters one of
which nothing is known ends there, as one that reaches boundaries together for which nothing is
listed. Both are made, and the motion is followed again from its start: its digits are those that
it has where all configurations are listed.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import chain
from typing import Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError, unknown_name
from nonsmooth.runtime.core.values import as_value, axes, real_array
from nonsmooth.runtime.events.leading_derivative import derivatives, leading_signs
from nonsmooth.runtime.events.transition_choice import Decider
from nonsmooth.runtime.model.boundary_sets import members_of
from nonsmooth.runtime.model.contacts.law import Law
from nonsmooth.runtime.model.flows import extended
from nonsmooth.runtime.model.kernels import SystemKernels, grown
from nonsmooth.runtime.model.loading.growing import Growth, Visit, growth_of
from nonsmooth.runtime.model.piecewise import PiecewiseLinear, piecewise_at
from nonsmooth.runtime.model.structure import Structure, structure_of

_ERROR = 16 * np.finfo(float).eps

_CIRCLE = 1e-8  # error of c^2 + s^2 that roundings of a long motion may make
_PHASE = 1e-7  # radians
_MOST_TURNS = 100_000  # of the first forcing, behind the time zero or in front of it
_MOST_AT_REST = 64  # configurations that one start is tried in


def start_state(structure: Structure, given: Mapping[str, object] | Sequence[object]) -> np.ndarray:
    """State (N,) from values by name, or in the system's order: positions, then velocities.

    By name, a forcing c, s that is left out starts at c = 1, s = 0. `InputError` is raised
    for an unknown or missing name, a wrong number of values, a value that is not finite, or
    a forcing with c^2 + s^2 other than 1.
    """
    names = structure.states
    if isinstance(given, Mapping):
        values = _in_order(structure, given)
    else:
        try:
            values = list(given)
        except TypeError:
            raise InputError(f"the start is no row of values: {given!r}") from None
        if len(values) != len(names):
            raise InputError(
                f"the start has {len(values)} values; {structure.name} has {', '.join(names)}"
            )
    start = np.array([_number(n, v) for n, v in zip(names, values, strict=True)])
    check_forcing(structure, start[None])
    return start


def start_states(structure: Structure, given: Any) -> np.ndarray:
    """Many states (..., N), from arrays by name that broadcast or an array in the system's order.

    What is refused, and what may be left out, is as for `start_state`.
    """
    names = structure.states
    if isinstance(given, Mapping):
        values = zip(names, _in_order(structure, given), strict=True)
        arrays = [real_array(f"state {name}", value) for name, value in values]
        try:
            given = np.stack(np.broadcast_arrays(*arrays), -1)
        except ValueError:
            raise InputError("the arrays of the state do not broadcast") from None
    elif axes(given) == 1:
        return start_state(structure, given)
    starts = real_array("state", given)
    if starts.ndim == 0 or starts.shape[-1] != len(names):
        raise InputError(f"the last axis of the states is not {len(names)} long")
    check_forcing(structure, starts.reshape(-1, len(names)))
    return starts


def _in_order(structure: Structure, given: Mapping[str, object]) -> list[Any]:
    """What is given of each state, in the system's order; forcings begin at c = 1, s = 0."""
    names = structure.states
    for name in given:
        if name not in names:
            raise unknown_name("state", str(name), names)
    given = forcing_start(structure) | dict(given)
    missing = [name for name in names if name not in given]
    if missing:
        raise InputError(f"the start needs a value for: {', '.join(missing)}")
    return [given[name] for name in names]


def check_forcing(structure: Structure, states: np.ndarray) -> None:
    """Raise `InputError` unless c^2 + s^2 = 1 for each forcing in each of the states (n, N)."""
    for cosine, sine in structure.forcing:
        square = states[:, cosine] ** 2 + states[:, sine] ** 2
        wrong = np.flatnonzero(np.abs(square - 1) > _CIRCLE)
        if wrong.size:
            c, s = structure.states[cosine], structure.states[sine]
            raise InputError(
                f"the forcing starts at {c} = {states[wrong[0], cosine]:.6g},"
                f" {s} = {states[wrong[0], sine]:.6g}: {c}^2 + {s}^2 is"
                f" {square[wrong[0]]:.6g}, not 1"
            )


def check_phases(system: PiecewiseLinear, start: np.ndarray) -> None:
    """Raise `InputError` unless there is a time at which all forcings are as in a start (N,).

    All forcings share one time t, at which c = cos(w t) and s = sin(w t) of each; their
    phase shifts are part of the declaration.
    """
    pairs = system.structure.forcing
    speeds = [float(system.fields[0, sine, cosine]) for cosine, sine in pairs]
    if len(pairs) < 2 or not all(speeds):
        return
    angles = [math.atan2(start[sine], start[cosine]) for cosine, sine in pairs]
    turns = np.arange(_MOST_TURNS)
    missed = np.zeros(2 * _MOST_TURNS)
    times = (angles[0] + 2 * np.pi * np.concatenate([turns, -turns])) / speeds[0]
    for speed, angle in zip(speeds[1:], angles[1:], strict=True):
        rest = speed * times - angle
        missed = np.maximum(missed, np.abs(rest - 2 * np.pi * np.round(rest / (2 * np.pi))))
    if missed.min() > _PHASE:
        names = [system.structure.states[state] for state in system.structure.forced]
        raise InputError(
            f"the forcings ({', '.join(names)}) are at no time as in the start: their phases to"
            " each other belong to the declaration, as Harmonic(..., phase=...)"
        )


def forcing_start(structure: Structure) -> dict[str, object]:
    """Cosine and sine of each forcing where its time is zero, by name."""
    begin: dict[str, object] = {}
    for cosine, sine in structure.forcing:
        begin |= {structure.states[cosine]: 1, structure.states[sine]: 0}
    return begin


def on_circles(system: PiecewiseLinear, states: np.ndarray, angles: np.ndarray) -> np.ndarray:
    """States (n, N) with the first forcing at angles (n,) in radians, the others at the same time.

    All other states are unchanged.
    """
    found, first = states.copy(), None
    for cosine, sine in system.structure.forcing:
        speed = float(system.fields[0, sine, cosine])
        first = first or speed
        turned = angles * (speed / first)
        found[:, cosine], found[:, sine] = np.cos(turned), np.sin(turned)
    return found


def configuration_of(system: PiecewiseLinear, state: np.ndarray, wanted: str | None = None) -> int:
    """Index of the configuration that a state (N,) belongs to, by the system's own conditions.

    A configuration with constraints (a stuck mass, a mass resting on a stop) is tried
    before those with fewer: it takes the state if its constraints hold and it is not left
    at once. Where every configuration is left at once, the first whose boundaries are not
    exceeded takes it, and its transition follows. Where several contacts that the mass
    matrix couples are at rest, their law decides. If a configuration is `wanted`, only that
    one is tried. `InputError` is raised if none takes the state.
    """
    structure = system.structure
    if wanted is not None:
        chosen = structure.configuration(wanted)
        problem = _violated(system, chosen, state)
        if problem:
            raise InputError(f"the start does not belong to {wanted}: {problem}")
        return chosen
    found = configurations_of(structure, system.fields[None], system.rows[None], state[None])
    if found[0] >= 0:
        return int(found[0])
    open_ = _left_open(system, state)
    if open_:
        raise InputError(
            f"the laws of contact leave open to which of {', '.join(open_)} the start belongs:"
            " name the configuration"
        )
    problems = {
        structure.configurations[c]: _violated(system, c, state)
        for c in structure.visited
        if not structure.constraints[c]
    }
    told = "; ".join(f"{name}: {problem}" for name, problem in problems.items())
    raise InputError(f"the start belongs to no configuration ({told})")


def configurations_of(
    structure: Structure,
    fields: np.ndarray,
    rows: np.ndarray,
    states: np.ndarray,
    wanted: str | None = None,
) -> np.ndarray:
    """Configurations (n,) of states (n, N), by the rules of `configuration_of`; -1 if none fits.

    `fields` (n or 1, configurations, N, N + 1) and `rows` (n or 1, R, N + 1) are those of
    each state, or the same for all.
    """
    order = sorted(structure.visited, key=lambda c: -len(structure.constraints[c]))
    if wanted is not None:
        order = [structure.configuration(wanted)]
    staying = np.full(len(states), -1, dtype=np.int32)
    possible = staying.copy()
    whole = extended(states)
    with np.errstate(invalid="ignore", over="ignore"):
        for c in order:
            inside = np.isfinite(whole).all(axis=1)
            for row in structure.constraints[c]:
                value, error = next(orders_along(fields[:, c], rows[:, row], whole))
                inside &= np.abs(value) <= error
            stays = inside.copy()
            for boundary in structure.boundaries[c]:
                orders = orders_along(fields[:, c], rows[:, boundary.row], whole)
                value, error = first = next(orders)
                inside &= value <= error
                stays &= leading_signs(chain([first], orders)) <= 0
            staying[(staying < 0) & inside & stays] = c
            possible[(possible < 0) & inside] = c
    found = np.where(staying >= 0, staying, possible)
    if structure.law is not None and wanted is None:
        for place, resting in _resting(structure.law, fields, rows, whole):
            if found[place] >= 0:
                at = place if len(rows) > 1 else 0
                decider = Decider(structure, fields[at], rows[at], fields[:0])
                targets = decider.beginnings(int(found[place]), whole[place], resting).targets
                found[place] = targets[0] if len(targets) == 1 else -1
    return found


def _resting(
    law: Law, fields: np.ndarray, rows: np.ndarray, whole: np.ndarray
) -> Iterator[tuple[int, np.ndarray]]:
    """Yield each state's index that has several of a law's contacts at rest, and their mask."""
    rests = np.ones((len(law.contacts), len(whole)), dtype=bool)
    for place, contact in enumerate(law.contacts):
        for row in (contact.relative, contact.gap):
            # constraints err alike in all configurations: by the fields of the first
            value, error = next(orders_along(fields[:, 0], rows[:, row], whole))
            rests[place] &= np.abs(value) <= error
    for place in np.flatnonzero(rests.sum(axis=0) > 1).tolist():
        yield place, rests[:, place]


def _left_open(system: PiecewiseLinear, state: np.ndarray) -> tuple[str, ...]:
    """Configurations that the law leaves open for a start."""
    structure, law = system.structure, system.structure.law
    whole = extended(state[None])
    inside = [c for c in structure.visited if not _violated(system, c, state)]
    if law is None or not inside:
        return ()
    order = sorted(inside, key=lambda c: -len(structure.constraints[c]))
    for _, resting in _resting(law, system.fields[None], system.rows[None], whole):
        decider = Decider(structure, system.fields, system.rows, system.resets)
        found = decider.beginnings(order[0], whole[0], resting).targets
        return tuple(structure.configurations[c] for c in found)
    return ()


def _number(name: str, given: object) -> float:
    try:
        value = float(given) if isinstance(given, np.floating) else float(as_value(given))
    except InputError as problem:
        raise InputError(f"state {name}: {problem}") from None
    if not np.isfinite(value):
        raise InputError(f"state {name} is {value}, not a finite number")
    return value


def orders_along(
    field: np.ndarray, row: np.ndarray, whole: np.ndarray
) -> Iterator[tuple[np.ndarray, np.ndarray]]:
    """Yield values and errors (n,) of a row and of its derivatives of order 1 to N along a flow.

    `whole` (n, N + 1) are the states and 1; the field (n or 1, N, N + 1) and the row (n
    or 1, N + 1) may be common. Each error is made of the value's rounding, and of that of
    the time at which the state was computed: a position at zero has no size of its own.
    """
    sizes, lengths = np.abs(whole), np.abs(field)
    speed = lengths[:, :, :-1].sum(axis=2).max(axis=1)
    shortest = np.divide(1.0, speed, out=np.zeros_like(speed), where=speed > 0)
    count = whole.shape[1]
    bounds = derivatives(np.abs(row), lengths, count + 1)
    behind = ((bound * sizes).sum(axis=-1) for bound in bounds)
    size = next(behind)
    for function, following in zip(derivatives(row, field, count), behind, strict=True):
        value = (function * whole).sum(axis=-1)
        yield value, _ERROR * (size + shortest * following)
        size = following


def _violated(system: PiecewiseLinear, c: int, state: np.ndarray) -> str:
    """Explain which constraint or boundary the state violates; the text is empty if none."""
    structure, whole = system.structure, extended(state[None])

    def excess(row: int) -> tuple[float, float]:
        value, error = next(orders_along(system.fields[c][None], system.rows[row][None], whole))
        return float(value[0]), float(error[0])

    for row in structure.constraints[c]:
        value, error = excess(row)
        if abs(value) > error:
            return f"{_text(structure, system.rows[row])} is {value:.6g} there, not 0"
    for boundary in structure.boundaries[c]:
        value, error = excess(boundary.row)
        if value > error:
            function = _text(structure, system.rows[boundary.row])
            return f"beyond {boundary.name}, {function} is {value:.6g} > 0"
    return ""


def _text(structure: Structure, row: np.ndarray) -> str:
    """An affine function as text: ``v1 - 1``."""
    text = ""
    for name, factor in zip((*structure.states, ""), row.tolist(), strict=True):
        if factor == 0:
            continue
        size = f"{abs(factor):.6g}"
        size = name if size == "1" and name else f"{size} {name}".strip()
        sign = "-" if factor < 0 else "+" if text else ""
        text += f" {sign} {size}" if text else f"{sign}{size}"
    return text or "0"


def visits_behind(
    structure: Structure, configurations: Iterable[int], missing: Iterable[tuple[int, int]] = ()
) -> list[Visit]:
    """Visits that a system needs so that motions can go on that ended because nothing is declared.

    The motions ended in `configurations`. The pairs `missing` are a configuration and the
    mask of boundaries that are reached together in it. The list is empty if the system is
    listed whole.
    """
    names = structure.configurations
    found: list[Visit] = [
        (names[c], ()) for c in dict.fromkeys(configurations) if c in structure.unvisited
    ]
    for source, mask in dict.fromkeys(missing):
        reached = members_of(mask)
        if structure.unvisited - {source} and len(reached) > 1:
            boundaries = sorted(structure.boundaries[source][b].name for b in reached)
            found.append((names[source], tuple(boundaries)))
    return found


def with_starts(
    kernels: SystemKernels, points: np.ndarray, which: np.ndarray, states: np.ndarray
) -> SystemKernels:
    """The system, grown by the configurations that starts may belong to.

    `which` (n,) is the parameter point, of points (p, parameters), of each start (n, N). A
    system that is listed whole is returned unchanged.
    """
    growth = growth_of(kernels.module)
    if growth is None:
        return kernels
    kernels = grown(kernels)
    for place, point in enumerate(points):
        own = states[which == place]
        if len(own):
            kernels = _with_starts(kernels, growth, point, own[np.isfinite(own).all(axis=1)])
    return kernels


def _with_starts(
    kernels: SystemKernels, growth: Growth, point: np.ndarray, states: np.ndarray
) -> SystemKernels:
    system = piecewise_at(kernels, point, ())
    whole = extended(states)
    fields, rows = system.fields, system.rows
    signs: dict[int, np.ndarray] = {}

    def sign(row: int) -> np.ndarray:
        if row not in signs:
            value, error = next(orders_along(fields[:1], rows[row][None], whole))
            signs[row] = np.where(np.abs(value) <= error, 0, np.sign(value))
        return signs[row]

    fits = [
        {
            regime: np.logical_and.reduce(
                [np.ones(len(states), dtype=bool)]
                + [sign(row) <= 0 for row in bounds]
                + [sign(row) == 0 for row in vanishing]
            )
            # what holds comes first: a configuration with more constraints takes the state
            for regime, (bounds, vanishing) in sorted(
                part.items(), key=lambda item: -len(item[1][1])
            )
        }
        for part in growth.starts
    ]
    options = {
        tuple(tuple(r for r, fit in found.items() if fit[k]) for found in fits): k
        for k in range(len(states))
    }
    first = {growth.first_of(regimes): k for regimes, k in options.items()}
    kernels = grown(kernels, [(name, ()) for name in first if name is not None])
    for regimes, k in options.items():
        if any(len(each) > 1 for each in regimes):
            kernels = _at_rest(kernels, growth, point, whole[k], regimes)
    return kernels


def _at_rest(
    kernels: SystemKernels,
    growth: Growth,
    point: np.ndarray,
    whole: np.ndarray,
    regimes: Sequence[Sequence[str]],
) -> SystemKernels:
    """The system, grown by the configurations of a start at rest.

    They are made one after the other, as their boundaries lead, until the start stays in
    one.
    """
    first = growth.first_of(regimes)
    level = [] if first is None else [first]
    tried: set[str] = set()
    while level and len(tried) < _MOST_AT_REST:
        kernels = grown(kernels, [(name, ()) for name in level])
        system, structure = piecewise_at(kernels, point, ()), structure_of(kernels)
        tried |= {*level}
        following, stays = dict[str, None](), False
        for name in level:
            c = structure.configuration(name)
            left = []
            for index, boundary in enumerate(structure.boundaries[c]):
                row = system.rows[boundary.row][None]
                if leading_signs(orders_along(system.fields[c][None], row, whole[None]))[0] > 0:
                    left.append(index)
            stays = stays or not left
            for transition in structure.transitions[c]:
                if transition.boundaries <= {*left}:
                    following[structure.configurations[transition.target]] = None
        if stays:
            break
        level = [name for name in following if name not in tried]
    return kernels

"""Orbits that begin at an event of a branch: of other itineraries, and on branches that meet it.

Next to a border collision phases are inserted, dropped or exchanged. Every way through the
system's transitions that replaces one or two phases at the collision is tried, and a simulation
from there; what converges near the orbit and is a motion of the real system is returned.

Where two branches meet, at twice the period, a lost symmetry or a crossing, the equations of the
other family leave two directions open. One is the tangent of the branch that is known; the other
one leads, at first order, to the other branch.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from nonsmooth.runtime.core.errors import InputError, NoConvergence
from nonsmooth.runtime.core.values import Value, as_value, parse
from nonsmooth.runtime.explore.continuation.event import Event, point_of
from nonsmooth.runtime.explore.continuation.stepping import correct, scaled_rows
from nonsmooth.runtime.explore.finding.solved import (
    canonical_itinerary,
    repeated_part,
    settled_orbit,
)
from nonsmooth.runtime.model.engine_layout import numbers_of
from nonsmooth.runtime.model.piecewise import piecewise
from nonsmooth.runtime.model.structure import FORCING_PHASE, Structure
from nonsmooth.runtime.orbits.equations import OrbitEquations, equations_of
from nonsmooth.runtime.orbits.kernel_problem import chosen_parameters
from nonsmooth.runtime.orbits.orbit import PERIOD, Orbit
from nonsmooth.runtime.orbits.table_solve import solve_itinerary
from nonsmooth.runtime.shooting.closure_conditions import closing
from nonsmooth.runtime.shooting.newton import CONVERGED, SINGULAR
from nonsmooth.runtime.shooting.shooting_map import ItineraryShape, itinerary_shape
from nonsmooth.runtime.shooting.symmetry import whole_shape
from nonsmooth.runtime.shooting.table_newton import solve_shape
from nonsmooth.runtime.simulation.recurrence import Itinerary

if TYPE_CHECKING:
    from nonsmooth.runtime.explore.continuation.branch import Branch

_CLOSE = (1e-5, 1e-4)  # from the collision, in units of the branch's range: very near
_DISTANCES = (1e-3, 1e-2)  # from the collision, in units of the branch's range
_LONGER, _MOST_WAYS = 2, 300  # phases that a way may have more; ways
_SHORT = 0.02  # of the phases that are replaced: a new one
_SHORTER = _SHORT / 50  # very near the collision
_SHORTEST = 1e-9  # of the period: what lasts less is no phase
_SAME = 1e-6  # of the period: how near the dwell times of one orbit are
_NEAR = 0.3  # of the period: how much another orbit's may differ
_LENGTHS = (0.02, 0.005, 0.05, 0.1, 0.001)  # of the step from one branch to the other
_CORRECTED = 10.0  # of a step to another branch: how far the corrector may go
_APART = 0.5  # of such a step: how far from the meeting point an orbit has to be
_OPEN = 1e-3  # largest singular value, relative, of a direction that is open

# physical parameters, and the period if it is given, at a value of the branch's parameter
_SystemAt = Callable[[float], tuple[dict[str, Value], Value | None]]


def next_itineraries(
    branch: Branch, event: Event, parameters: Mapping[str, Any] | None = None
) -> tuple[Orbit, ...]:
    """Admissible orbits of other itineraries just beyond a border collision, one for each.

    `parameters` are those that the orbit leaves open; absent ones are chosen. Orbits on the
    side where the branch ceases to be a motion come first; each can be continued. Parameters
    that the orbit left open are those of its point beside the collision. Raises `InputError`
    if the event is no border collision or an exchanged unknown is the branch's parameter.
    """
    if not event.border_collision:
        raise InputError(f"{event.kind} is no border collision: the itinerary goes on")
    ways_off = [[side * distance for distance in _DISTANCES] for side in (1, -1)]
    found: dict[Itinerary, Orbit] = {}
    for orbit in _others(branch, event, parameters, ways_off, _SHORT, settling=True):
        found.setdefault(canonical_itinerary(orbit.itinerary), orbit)
    return tuple(found.values())


def orbits_beside(branch: Branch, event: Event, parameters: Mapping[str, Any]) -> tuple[Orbit, ...]:
    """Admissible orbits of other itineraries on both sides of a border collision, very near it.

    Unlike `next_itineraries` all that converge are returned. Those nearest to the collision,
    whose new phases are shortest, come first: one itinerary may have several orbits nearby, of
    which one begins at the collision. `parameters` are those of the system that the orbit
    leaves open; absent ones are chosen.
    """
    ways_off = [[side * distance] for distance in _CLOSE for side in (1, -1)]
    return tuple(_others(branch, event, parameters, ways_off, _SHORTER, settling=False))


def _others(
    branch: Branch,
    event: Event,
    parameters: Mapping[str, Any] | None,
    ways_off: Sequence[Sequence[float]],
    short: float,
    *,
    settling: bool,
) -> Iterator[Orbit]:
    """Admissible orbits of other itineraries near a collision, at the first place of each way off.

    Places without any are passed. Distances are in units of the branch's range, positive where
    the branch ceases to be a motion; with `settling` a motion is simulated there too.
    """
    place = _beside(branch, event)
    base, system_at = composed_family(branch, place, parameters)
    span = float(np.ptp(branch.parameter_values)) or abs(event.value) or 1.0
    side = 1 if branch.parameter_values[place] < event.value else -1
    own, ways = canonical_itinerary(base.itinerary), _candidates(base, event)
    for distances in ways_off:
        for distance in distances:
            orbits: list[Orbit] = []
            try:
                here, period = system_at(event.value + side * distance * span)
                orbits.extend(_composed(base, ways, here, event, period, short))
                orbits.extend(_without_boundary(base, here, event))
            except InputError:  # beyond a domain; those that are known already count
                if not orbits:
                    break
            if settling and distance > 0 and period is None:
                orbits += _settled(base, here)
            for orbit in orbits:
                if canonical_itinerary(orbit.itinerary) != own and _near(orbit.period, base):
                    yield orbit
            if orbits:
                break


def _beside(branch: Branch, event: Event) -> int:
    """Number of the branch's point beside an event at which it is a motion, if one of them is."""
    places = [math.floor(event.place), math.ceil(event.place)]
    if places[0] == places[1]:  # the end of the branch
        places = [places[0] - 1, places[0] + 1]
    places = [place for place in places if 0 <= place < len(branch)]
    return next((place for place in places if branch.admissible[place]), places[0])


class _Way(NamedTuple):
    """An itinerary of the part that is solved for, from the phase before the collision.

    It replaces the phases `begin` to `end` of the old one by `phases` new ones.
    """

    itinerary: Itinerary
    begin: int
    end: int
    phases: int


def _first(base: Orbit, event: Event) -> tuple[int, int]:
    """First phase of the part that is examined, and the number of its phases."""
    symmetry = base.symmetry
    count = len(base.itinerary) // (1 if symmetry is None else symmetry.order)
    return 0 if symmetry is not None or event.phase is None else (event.phase - 1) % count, count


def _candidates(base: Orbit, event: Event) -> list[_Way]:
    """Other itineraries, from the ways through the system's transitions."""
    if event.phase is None:
        return []
    first, count = _first(base, event)
    structure, at = base.tables.cycle.structure, (event.phase - first) % count
    phases = [base.itinerary[(first + k) % len(base.itinerary)] for k in range(count + 1)]
    found = [
        _Way((*phases[:begin], *way, *phases[end + 1 : count]), begin, end, len(way))
        for begin, end in [(at, at), (at - 1, at), (at, at + 1), (at - 1, at - 1), (at - 1, at + 1)]
        if 0 <= begin <= end < count
        for way in _paths(
            structure, phases[begin][0], phases[end + 1][0], end - begin + 1 + _LONGER
        )
        if way != tuple(phases[begin : end + 1])
    ]
    # shorter ones first
    return sorted(found, key=lambda each: each.phases - (each.end - each.begin))[:_MOST_WAYS]


def _composed(
    base: Orbit,
    ways: Sequence[_Way],
    parameters: Mapping[str, Any],
    event: Event,
    period: Value | None,
    short: float,
) -> Iterator[Orbit]:
    """Admissible orbits of the itineraries of `ways`, near the known orbit."""
    point, symmetry = piecewise(base.system, parameters), base.symmetry
    first, count = _first(base, event)
    dwell = np.roll(base.dwell_times, -first)[:count].astype(float)
    state, time = base.states[first].astype(float), event.time
    if base.itinerary[0][1] == FORCING_PHASE and time is not None:
        state, time = base.motion()(time), None  # a cycle that has boundaries begins at one
    length = np.nan if period is None else float(period) * count / len(base.itinerary)
    for way in ways:
        try:
            cycle = (
                itinerary_shape(point.structure, way.itinerary)
                if symmetry is None
                else whole_shape(point, symmetry, way.itinerary)
            )
        except InputError:  # leads nowhere
            continue
        closed, part, _ = closing(point, cycle, symmetry)
        replaced = float(dwell[way.begin : way.end + 1].sum())
        rows = [
            [*dwell[: way.begin], *split, *dwell[way.end + 1 :]]
            for split in _splits(replaced, way.phases, time, short)
        ]
        for solved in _solved(part, numbers_of(closed), np.array(rows), state, length):
            if not _near(solved[0].sum() * len(base.itinerary) / count, base):
                continue
            orbit = solve_itinerary(
                base.system,
                parameters,
                way.itinerary,
                solved[0].tolist(),
                solved[1].tolist(),
                period=period,
                symmetry=None if symmetry is None else symmetry.matrix,
            )
            if _is_motion(orbit) and not repeated_part(orbit):
                yield orbit


def _solved(
    part: ItineraryShape, flat: np.ndarray, dwell: np.ndarray, state: np.ndarray, length: float
) -> list[tuple[np.ndarray, np.ndarray]]:
    """Dwell times and first states of the orbits that guesses lead to, the nearest first.

    The guesses begin at `state`, or without success at the start that fits each best.
    """
    count = len(dwell)
    numbers = np.repeat(flat[None], count, axis=0)
    for start in (np.repeat(state[None], count, axis=0), None):
        with np.errstate(all="ignore"):
            try:
                found = solve_shape(part, numbers, dwell, start, np.full(count, length))
            except np.linalg.LinAlgError:
                continue
        least = _SHORTEST * found.dwell.sum(axis=-1)
        sound = np.flatnonzero((found.status == CONVERGED) & (found.dwell.min(axis=-1) > least))
        away = abs(found.dwell[sound] - dwell[sound]).max(axis=-1)
        told: list[int] = []
        for k in sound[np.argsort(away, kind="stable")]:
            apart = np.abs(found.dwell[told] - found.dwell[k]) > _SAME * found.dwell[k].sum()
            if apart.any(axis=-1).all():
                told.append(int(k))
        if told:
            return [(found.dwell[k], found.starts[k, 0]) for k in told]
    return []


def _paths(structure: Structure, source: str, target: str, most: int) -> Iterator[Itinerary]:
    """Sequences of at most `most` phases (never more than three) between two configurations."""
    waiting: list[tuple[str, Itinerary]] = [(source, ())]
    while waiting:
        configuration, way = waiting.pop(0)
        if way and configuration == target:
            yield way
        if len(way) == min(most, 3):
            continue
        index = structure.configuration(configuration)
        names = [shape.name for shape in structure.boundaries[index]]
        for boundary, behind in structure.exits(index):  # several at once: a collision
            following = structure.configurations[behind]
            waiting.append((following, (*way, (configuration, names[boundary]))))


def _splits(total: float, count: int, time: float | None, share: float) -> list[list[float]]:
    """Guesses of the dwell times of new phases, with a fixed sum: mostly all but one are short."""
    short = share * total
    found = [[total / count] * count]
    for place in range(count):
        split = [short] * count
        split[place] = total - (count - 1) * short
        found.append(split)
    if time is not None and count > 1 and 0 < time < total:
        middle = [short] * (count - 2)
        found.append([time, *middle, max(total - time - sum(middle), short)])
    return found


def _without_boundary(base: Orbit, parameters: Mapping[str, Any], event: Event) -> Iterator[Orbit]:
    """The admissible motion that no longer reaches any boundary, if there is one.

    It is tried where one of two phases vanishes, or where the only boundary that is reached is
    reached without speed.
    """
    vanishes, count = event.kind == "vanishing-phase", len(base.itinerary)
    slows = event.kind == "tangent"
    if event.phase is None or not (vanishes or slows) or count != 1 + vanishes:
        return
    left = base.itinerary[(event.phase + vanishes) % count][0]
    try:
        orbit = solve_itinerary(
            base.system, parameters, ((left, FORCING_PHASE),), [float(base.period)]
        )
    except InputError:  # no forcing
        return
    if _is_motion(orbit):
        yield orbit


def _settled(base: Orbit, parameters: Mapping[str, Any]) -> list[Orbit]:
    """The admissible periodic orbit that a motion from the orbit's start settles on, if any."""
    start = base.states[0].astype(float).tolist()
    with suppress(InputError):  # no such motion, or it does not come back
        orbit = settled_orbit(base.system, parameters, start, base.itinerary[0][0])
        if orbit is not None and _is_motion(orbit):
            return [orbit]
    return []


def _is_motion(orbit: Orbit) -> bool:
    return orbit.converged and orbit.admissibility.verdict is True


def _near(period: Any, base: Orbit) -> bool:
    """Whether an orbit of such a period may coincide with the known one at the collision."""
    return abs(float(period) / float(base.period) - 1) < _NEAR


def other_branch(branch: Branch, event: Event, parameters: Mapping[str, Any] | None) -> Orbit:
    """An orbit near an event on the branch that meets this one there, admissible if possible.

    At a flip it has twice the itinerary, and nearly twice the period; at a symmetry breaking it
    is solved for without the symmetry; at a branch point it has the same itinerary. It may exist
    on either side of the event, and be no motion of the real system (`admissibility` says).
    `parameters` are those that the orbit leaves open; absent ones are chosen. Raises
    `InputError` for another kind of event or a parameter that is none of the system's, and
    `NoConvergence` if no such orbit is found.
    """
    if not event.switches:
        raise InputError(f"no other branch meets this one at a {event.kind}: {event.text}")
    base, system_at = composed_family(branch, _away(event), parameters)
    parameter = branch.parameter if branch.parameter in base.parameters else PERIOD
    if parameter == PERIOD and base.given_period is None:
        raise InputError(
            f"{branch.parameter} is no parameter of {base.system.name}: follow one that is"
        )
    curve = equations_of(base, parameter, lengths=np.ptp(branch.parameter_values) or 1.0)
    meeting = _meeting(branch, event, curve, system_at)
    if event.kind == "branch-point":
        other, copies = curve, 1
    else:
        copies = curve.order * (2 if event.kind == "flip" else 1)
        unfolded = _unfolded(base, copies // curve.order)
        other = equations_of(unfolded, parameter, lengths=curve.sizes[-1])
    times = copies // curve.order if parameter == PERIOD else 1
    start = _repeated(curve, meeting, copies, times)
    along = _repeated(curve, curve.first - meeting, copies, times)
    direction = _open_direction(other, start, along / other.sizes)
    signs = (1, -1) if event.kind == "branch-point" else (1,)
    tried = [(sign * direction, length) for length in _LENGTHS for sign in signs]
    found = [orbit for each in tried if (orbit := _at_distance(other, start, *each)) is not None]
    if not found:
        raise NoConvergence(f"no orbit was found on the other branch: {event.text}")
    if not any(orbit.converged for orbit in found):
        raise NoConvergence(
            f"the other branch has one value of {parameter} only, which does not tell its orbits"
            f" apart: {event.text}"
        )
    found.sort(key=lambda orbit: not _is_motion(orbit))
    return found[0]


def _away(event: Event) -> int:
    """Number of the branch point beside the event that is not too near to it."""
    before = math.floor(event.place)
    if event.place == before:
        return before - 1 if before else 1
    return before if event.place - before > 0.5 else before + 1


def _meeting(
    branch: Branch, event: Event, curve: OrbitEquations, system_at: _SystemAt
) -> np.ndarray:
    """The meeting point of the branches, as a point of the family over all physical parameters."""
    if branch.unknown_names == curve.unknowns:
        return point_of(event)
    base, orbit = curve.orbit, branch.orbit_at(event)
    parameters, period = system_at(event.value)
    dwell = [float(time) for time in orbit.dwell_times if time > 0]
    found = solve_itinerary(base.system, parameters, base.itinerary, dwell, period=period)
    if not found.converged:
        raise InputError(f"{base.name} at {event.parameter} = {event.value:.10g}: {found.message}")
    value = float(found.period) if branch.parameter not in parameters else event.value
    return np.array([*found.dwell_times, *found.states[0], value])


def _unfolded(base: Orbit, periods: int) -> Orbit:
    """The same orbit without its symmetry, over `periods` periods."""
    period = base.given_period
    return solve_itinerary(
        base.system,
        base.parameters,
        base.itinerary * periods,
        np.tile(base.dwell_times.astype(float), periods).tolist(),
        base.states[0].astype(float).tolist(),
        period=None if period is None else _times(period, periods),
    )


def _times(period: Value, count: int) -> Value:
    """A multiple of a period, exactly."""
    if period.exact is not None:
        return as_value(period.exact * count)
    return parse(f"{count}*({period.text})")


def _repeated(curve: OrbitEquations, z: np.ndarray, copies: int, times: int) -> np.ndarray:
    """The point for `copies` repetitions of a part, with the parameter multiplied by `times`."""
    count = len(curve.dwell_names)
    return np.concatenate([np.tile(z[:count], copies), z[count:-1], times * z[-1:]])


def _open_direction(curve: OrbitEquations, z: np.ndarray, along: np.ndarray) -> np.ndarray:
    """Unit vector, in the curve's units, of the open direction across the known branch."""
    rows, _ = scaled_rows(curve.equations(z)[1] * curve.sizes)
    _, values, right = np.linalg.svd(rows)
    values = np.pad(values, (0, len(right) - len(values)))
    if values[-2] > _OPEN * values[0]:
        raise NoConvergence("the equations leave no direction open: no other branch meets here")
    first, second = right[-2:] @ along
    across = second * right[-2] - first * right[-1]
    return np.asarray(across / np.linalg.norm(across))


def _at_distance(
    curve: OrbitEquations, start: np.ndarray, direction: np.ndarray, length: float
) -> Orbit | None:
    """An orbit at a distance from the meeting point along a direction, or None."""
    guess = start + length * direction * curve.sizes
    found = correct(curve, guess, direction)
    if found is None or not (curve.dwell(found[0][None]) > 0).all():
        return None
    if np.linalg.norm((found[0] - guess) / curve.sizes) > _CORRECTED * length:
        return None
    orbit = curve.at(found[0])
    if orbit.status not in (CONVERGED, SINGULAR):
        return None
    dwell = orbit.dwell_times[: len(curve.dwell_names)]
    reached = np.concatenate([dwell, orbit.states[0]]).astype(float) - start[:-1]
    return orbit if np.linalg.norm(reached / curve.sizes[:-1]) > _APART * length else None


def composed_family(
    branch: Branch, place: int, beside: Mapping[str, Any] | None = None
) -> tuple[Orbit, _SystemAt]:
    """The orbit at a point of a branch by the tables of its system, and a `_SystemAt`.

    The `_SystemAt` gives the physical parameters, and the period if it is given, at other values
    of the branch's parameter. Parameters that the orbit leaves open take the values in
    `beside`, or are chosen once for the whole branch. Raises `InputError` if the branch's
    parameter is none of the system's, or if the system does not take its values.
    """
    orbit, name = branch.orbit_at(place), branch.parameter
    problem = orbit.problem
    if name not in (PERIOD, *(table.name for table in problem.parameters)):
        raise InputError(f"{name} is no parameter of {problem.name}: follow one that is")
    orbit = replace(orbit, opened={**orbit.opened, **chosen_parameters(orbit, beside)})

    def system_at(value: float) -> tuple[dict[str, Value], Value | None]:
        moved = replace(orbit, given={**orbit.given, name: as_value(value)})
        return problem.physical(moved, beside).values, problem.period(moved)

    return problem.by_tables(orbit, beside), system_at

"""Whether a composed orbit is a motion of the real system, in double precision.

No boundary may be crossed inside a phase, and of the transitions that are declared for a
boundary the first whose conditions hold has to be the itinerary's.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np

from nonsmooth.runtime.admissible import MOST_MISSED, Admissibility, Violation
from nonsmooth.runtime.composition.passage import Cycle, Numbers, Passage
from nonsmooth.runtime.crossing import LONGEST_PHASE, TrigonometricSum, maximum
from nonsmooth.runtime.errors import InputError

__all__ = ["assess_cycle", "boundary_sums"]

_EPSILON = float(np.finfo(float).eps)


def assess_cycle(cycle: Cycle, numbers: Numbers, now: Passage, dwell: np.ndarray) -> Admissibility:
    """Check all boundaries along all phases, and all transitions.

    A transition that the conditions refuse is a violation of its own boundary at the end of
    its phase, by no excess.

    Raises
    ------
    InputError
        For a flow that decays or grows, or a phase longer than a guarantee reaches.
    """
    begins = np.concatenate([[0.0], np.cumsum(dwell)])
    violations = []
    for place, duration in enumerate(dwell.tolist()):
        configuration = cycle.configurations[place]
        name = cycle.structure.configurations[configuration]
        noise = _noise(cycle, numbers, now, place)
        for boundary, row, function in boundary_sums(cycle, numbers, now, place):
            if not duration * max(function.frequency, default=0.0) <= LONGEST_PHASE:
                raise InputError(
                    f"{name} lasts {duration:.6g}, more than {LONGEST_PHASE:g} radians of its"
                    " fastest oscillation: no guarantee reaches that far"
                )
            floor = function.rounding(duration) + noise[row]
            begins_there = abs(function(0.0)) <= floor
            rises = begins_there and duration > 0 and function.rises(float(noise[row]))
            found = maximum(function, duration, -math.inf if rises else floor)
            if rises or found.value > floor:
                time = found.time if found.value > floor else 0.0
                violations.append(
                    Violation(
                        place, name, boundary, float(begins[place]) + time, max(found.value, 0.0)
                    )
                )
        if not _taken(cycle, numbers, now, place, noise):
            boundary = cycle.itinerary[place][1]
            violations.append(Violation(place, name, boundary, float(begins[place + 1]), 0.0))
    return Admissibility(not violations, tuple(violations), ())


def boundary_sums(
    cycle: Cycle, numbers: Numbers, now: Passage, place: int
) -> Iterator[tuple[str, int, TrigonometricSum]]:
    """Each boundary of a phase's configuration: name, row, function of the time in the phase."""
    structure, configuration = cycle.structure, cycle.configurations[place]
    modes, exponents = structure.modes[configuration], numbers.exponents[configuration]
    parts = numbers.flows[configuration]
    start = now.starts[place]
    amplitudes = parts[..., :-1] @ start + parts[..., -1]
    for shape in structure.boundaries[configuration]:
        row = numbers.rows[shape.row]
        values = amplitudes @ row[:-1]
        constant, slope = float(row[-1]), 0.0
        cosine, sine, frequency = [], [], []
        for mode, (rate, turn) in zip(modes, exponents.tolist(), strict=True):
            waves = mode.oscillates
            if rate != 0 or mode.length > (1 if waves else 2):
                raise InputError(
                    f"{structure.name}: {structure.configurations[configuration]} does not only"
                    " oscillate and drift; its boundaries are not checked"
                )
            if waves:
                cosine.append(float(values[mode.places[0]]))
                sine.append(float(values[mode.places[1]]))
                frequency.append(abs(turn))
                sine[-1] *= math.copysign(1.0, turn)
            else:
                constant += float(values[mode.places[0]])
                slope += float(values[mode.places[1]]) if mode.length == 2 else 0.0
        yield (
            shape.name,
            shape.row,
            TrigonometricSum(constant, slope, tuple(cosine), tuple(sine), tuple(frequency)),
        )


def _noise(cycle: Cycle, numbers: Numbers, now: Passage, place: int) -> np.ndarray:
    """Rounding of every row along a phase, whose terms are differences of the data.

    By as much as the phase misses the boundary that ends it, all may be off: up to a limit.
    """
    states = np.maximum(abs(now.starts[place]), abs(now.ends[place]))
    size = abs(numbers.rows[:, :-1]) @ states + abs(numbers.rows[:, -1])
    missed = abs(float(now.gaps[place])) + float(np.max(abs(now.starts[-1] - now.starts[0])))
    return np.asarray(64 * _EPSILON * size + np.minimum(2 * missed, MOST_MISSED * size))


def _taken(cycle: Cycle, numbers: Numbers, now: Passage, place: int, noise: np.ndarray) -> bool:
    """Whether the first declared transition whose conditions hold is the itinerary's."""
    wanted = cycle.transitions[place]
    for transition in cycle.structure.transitions[cycle.configurations[place]]:
        if transition.boundaries != wanted.boundaries:
            continue
        holds = all(
            _positive(numbers, row, along, now.ends[place], noise, cycle.rows[place]) == expected
            for row, along, expected in transition.conditions
        )
        if holds:
            return transition is wanted
    return False


def _positive(
    numbers: Numbers, row: int, along: int, state: np.ndarray, noise: np.ndarray, own: int
) -> bool:
    """Whether the first nonzero derivative of a row along a flow is positive.

    The boundary that has just been reached is zero itself.
    """
    field: Any = numbers.fields[along]
    normal, constant = numbers.rows[row, :-1], float(numbers.rows[row, -1])
    error = float(noise[row])
    for order in range(len(state) + 1):
        value = float(normal @ state) + constant
        if abs(value) > error and not (order == 0 and row == own):
            return value > 0
        constant = float(normal @ field[:, -1])
        normal = normal @ field[:, :-1]
        size = abs(normal) @ abs(state) + abs(constant)
        relative = float(noise[row]) / max(float(abs(numbers.rows[row, :-1]) @ abs(state)), 1e-300)
        error = max(64 * _EPSILON, min(relative, MOST_MISSED)) * float(size)
    return False

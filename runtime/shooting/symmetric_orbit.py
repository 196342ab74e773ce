"""Orbits that a symmetry maps to themselves: the part that it closes, and the whole.

Such an orbit, shifted by a part of its period, is known by that part: its phases lead from a
start to the start's image, and the symmetry leads back.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import lru_cache
from typing import Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.values import Value, as_value, parse
from nonsmooth.runtime.model.piecewise import PiecewiseLinear
from nonsmooth.runtime.model.structure import Structure
from nonsmooth.runtime.shooting.shooting_map import (
    ItineraryShape,
    itinerary_shape,
    numbers_in,
    shoot,
)
from nonsmooth.runtime.shooting.symmetry import Symmetry, same_maps, seen_in_images
from nonsmooth.runtime.shooting.translations import (
    directions_of,
    gauges_of,
    projection_along,
    translations_of,
)

__all__ = [
    "closed_shape",
    "closing",
    "closing_matrix",
    "part_of",
    "whole_itinerary",
    "whole_orbit",
    "whole_shape",
]


def whole_itinerary(
    structure: Structure, symmetry: Symmetry, part: Sequence[tuple[str, str]]
) -> tuple[tuple[str, str], ...]:
    """Itinerary of the whole orbit whose first part is given, and which a symmetry closes.

    The symmetry maps the end of a part to its start: each part is the preimage of the one
    before it. Raises `InputError` if the part is malformed or has names that do not exist.
    """
    try:
        part = tuple((c, b) for c, b in part)
    except (TypeError, ValueError):
        raise InputError("an itinerary is a sequence of (configuration, boundary)") from None
    backward = {image: c for c, image in enumerate(symmetry.configurations)}
    whole = []
    phases = [_phase(structure, *pair) for pair in part]
    for _ in range(symmetry.order):
        for configuration, places in phases:
            names = [structure.boundaries[configuration][b].name for b in sorted(places)]
            whole.append((structure.configurations[configuration], "+".join(names)))
        phases = [
            (backward[c], [symmetry.boundaries[backward[c]].index(b) for b in places])
            for c, places in phases
        ]
    return tuple(whole)


def closing(
    system: PiecewiseLinear, cycle: ItineraryShape, symmetry: Symmetry | None
) -> tuple[PiecewiseLinear, ItineraryShape]:
    """The part of a whole cycle that the symmetry closes, in a system with one more reset.

    The added reset is the part's last one followed by the symmetry, and by the projection along
    the system's translations if it has any. Without either, system and cycle stay as they are.
    """
    matrix = closing_matrix(system.structure, *system.numbers, symmetry)
    if matrix is None:
        return system, cycle
    count = len(cycle) if symmetry is None else len(cycle) // symmetry.order
    part = closed_shape(cycle, count)
    reset = matrix @ system.resets[cycle.transitions[count - 1].reset]
    resets = np.concatenate([system.resets, reset[None]])
    return replace(system, structure=part.structure, resets=resets), part


def closing_matrix(
    structure: Structure, fields: Any, rows: Any, resets: Any, symmetry: Symmetry | None
) -> np.ndarray | None:
    """The matrix (N, N) that follows the last reset where an orbit closes; None if nothing does.

    It is made of the symmetry and of the projection along translations. Fields are
    (c, N, N + 1), rows (R, N + 1) and resets (r, N, N + 1).
    """
    directions = directions_of(structure, fields, rows, resets)
    matrix = None if symmetry is None else symmetry.matrix
    if not len(directions):
        return matrix
    projection = projection_along(directions)
    return projection if matrix is None else projection @ matrix


def closed_shape(cycle: ItineraryShape, count: int) -> ItineraryShape:
    """The first `count` phases of a cycle, where the last one ends with an added reset."""
    structure = _with_one_reset_more(cycle.structure)
    last = cycle.transitions[count - 1]
    turned = replace(last, reset=structure.resets - 1, target=cycle.configurations[0])
    return replace(
        cycle,
        structure=structure,
        itinerary=cycle.itinerary[:count],
        configurations=cycle.configurations[:count],
        boundaries=cycle.boundaries[:count],
        transitions=(*cycle.transitions[: count - 1], turned),
    )


@lru_cache(maxsize=1024)  # what is kept for a structure serves again
def _with_one_reset_more(structure: Structure) -> Structure:
    return replace(structure, resets=structure.resets + 1)


def whole_shape(system: PiecewiseLinear, symmetry: Symmetry, part: Any) -> ItineraryShape:
    """The whole cycle of a part that the symmetry closes.

    Raises `InputError` as `itinerary_shape` does, and where the resets at boundaries are not the
    images of each other.
    """
    cycle = itinerary_shape(system.structure, whole_itinerary(system.structure, symmetry, part))
    for place, transition in enumerate(cycle.transitions):
        image = place - len(part)
        resets = system.resets[[transition.reset, cycle.transitions[image].reset]]
        if not same_maps(seen_in_images(symmetry.matrix, resets[0]), resets[1]):
            names = " and ".join(cycle.itinerary[k][1] for k in (place, image))
            raise InputError(f"symmetry: {names}, its image, reset the state in different ways")
    return cycle


def whole_orbit(
    system: PiecewiseLinear,
    cycle: ItineraryShape,
    symmetry: Symmetry | None,
    dwell: np.ndarray,
    states: np.ndarray,
    lib: Any,
) -> tuple[np.ndarray, np.ndarray]:
    """Dwell times (q,) and states (q, N) of the whole orbit from those (p,), (p, N) of its part.

    States are those at the start of each phase; q is p times the order of the symmetry, or p
    without one. `cycle` is the whole one, of that system. All is in the system's units, and
    `lib` is an arithmetic with `sin`, `cos` and `exp` of arrays.
    """
    if symmetry is None:
        return dwell, states
    directions = translations_of(system)
    shift = np.zeros_like(states[0])
    if len(directions):  # by how much the image of the part's end is moved from its start
        first = len(states) - 1
        last = replace(
            cycle,
            itinerary=cycle.itinerary[first : first + 1],
            configurations=cycle.configurations[first : first + 1],
            boundaries=cycle.boundaries[first : first + 1],
            transitions=cycle.transitions[first : first + 1],
        )
        end = shoot(last, numbers_in(system), dwell[-1:], states[-1], lib).starts[-1]
        image = symmetry.matrix @ end
        shift = image[gauges_of(directions)] @ directions
    parts = [states]
    for _ in range(symmetry.order - 1):
        parts.append((parts[-1] + shift) @ symmetry.matrix)  # its inverse from the left
    return np.tile(dwell, symmetry.order), np.concatenate(parts)


def part_of(period: Value, order: int) -> Value:
    """The `order`-th part of a period, exactly."""
    if period.exact is not None:
        return as_value(period.exact / order)
    return parse(f"({period.text})/{order}")


def _phase(structure: Structure, name: str, boundary: Any) -> tuple[int, list[int]]:
    configuration = structure.configuration(str(name))
    names = boundary.split("+") if isinstance(boundary, str) else boundary
    return configuration, [structure.boundary(configuration, str(b)) for b in names]

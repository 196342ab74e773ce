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
    Numbers,
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
    "closed_cycle",
    "closing",
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
    """The part of a whole cycle that closes, in a system with the numbers of `closed_cycle`."""
    fields, rows, resets = (part[None] for part in system.numbers)
    part, closed, _ = closed_cycle(cycle, Numbers(fields, rows, resets), symmetry)
    if part is cycle:
        return system, cycle
    return replace(system, structure=part.structure, resets=closed.resets[0]), part


def closed_cycle(
    cycle: ItineraryShape, numbers: Numbers, symmetry: Symmetry | None = None
) -> tuple[ItineraryShape, Numbers, np.ndarray]:
    """The part of a whole cycle that closes, its numbers (n, ...), and directions (n, m, N).

    The directions are those of the system's translations. Where a symmetry or translations close
    the orbit the numbers have one more reset: the part's last one, followed by the symmetry and by
    the projection along the translations. Without either, cycle and numbers stay as they are.
    """
    arrays = list(zip(numbers.fields, numbers.rows, numbers.resets, strict=True))
    structure, size = cycle.structure, numbers.fields.shape[-2]
    if not len(arrays) or (symmetry is None and not len(directions_of(structure, *arrays[0]))):
        return cycle, numbers, np.empty((len(arrays), 0, size))
    directions = np.array([directions_of(structure, *each) for each in arrays])
    matrices = np.array([projection_along(each) for each in directions])
    if symmetry is not None:
        matrices = matrices @ symmetry.matrix
    count = len(cycle) if symmetry is None else len(cycle) // symmetry.order
    added = matrices @ numbers.resets[:, cycle.transitions[count - 1].reset]
    resets = np.concatenate([numbers.resets, added[:, None]], axis=1)
    return _closed_shape(cycle, count), numbers._replace(resets=resets), directions


def _closed_shape(cycle: ItineraryShape, count: int) -> ItineraryShape:
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

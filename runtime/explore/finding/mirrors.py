"""Symmetries of a system, found from its tables: signed permutations of its coordinates."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import permutations, product

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.explore.finding.primitive import image_of, same_orbit
from nonsmooth.runtime.explore.finding.steady import Equilibrium
from nonsmooth.runtime.model.piecewise import PiecewiseLinear
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.shooting.symmetry import Symmetry, symmetry_of

__all__ = ["mirror_places", "mirrors"]

_MOST_COORDINATES = 3  # of which all permutations are tried; of more, one sign of all


def mirrors(system: PiecewiseLinear) -> list[Symmetry]:
    """Symmetries that map positions to positions and velocities likewise, without the identity.

    A forcing stays, or is turned by half a period.
    """
    found = []
    for matrix in _candidates(system):
        # a symmetry takes some vector field to each of the others: that is soon told
        if not _follows(system, matrix):
            continue
        try:
            found.append(symmetry_of(system, matrix))
        except InputError:
            continue
    return found


def mirror_places(
    entries: Sequence[Orbit | Equilibrium], symmetries: Sequence[Symmetry]
) -> list[int | None]:
    """For each entry the place of the first one whose mirror image it is, or None.

    The place may be that of the entry itself.
    """
    return [
        next(
            (
                place
                for place, other in enumerate(entries[: own + 1])
                if any(_is_image(entry, other, symmetry) for symmetry in symmetries)
            ),
            None,
        )
        for own, entry in enumerate(entries)
    ]


def _is_image(entry: Orbit | Equilibrium, other: Orbit | Equilibrium, symmetry: Symmetry) -> bool:
    if isinstance(entry, Orbit):
        return isinstance(other, Orbit) and same_orbit(entry, image_of(other, symmetry))
    if isinstance(other, Orbit):
        return False
    size = np.abs(entry.state).max()
    return bool((np.abs(entry.state - symmetry.matrix @ other.state) <= 1e-9 * size).all())


def _candidates(system: PiecewiseLinear) -> Iterator[np.ndarray]:
    structure = system.structure
    size, coordinates = len(structure.states), structure.coordinates
    paired = {state for pair in (*coordinates, *structure.forcing) for state in pair}
    others = [state for state in range(size) if state not in paired]
    count = len(coordinates)
    if count <= _MOST_COORDINATES:
        orders, signs = list(permutations(range(count))), list(product((1, -1), repeat=count))
    else:
        orders, signs = [tuple(range(count))], [(1,) * count, (-1,) * count]
    for order in orders:
        for sign in signs:
            for forcing in product((1, -1), repeat=len(structure.forcing)):
                for rest in (1, -1) if others else (1,):
                    matrix = np.zeros((size, size), dtype=int)
                    for image, source, s in zip(coordinates, order, sign, strict=True):
                        for to, of in zip(image, coordinates[source], strict=True):
                            matrix[to, of] = s
                    for pair, s in zip(structure.forcing, forcing, strict=True):
                        matrix[pair, pair] = s
                    matrix[others, others] = rest
                    if (matrix != np.eye(size, dtype=int)).any():
                        yield matrix


def _follows(system: PiecewiseLinear, matrix: np.ndarray) -> bool:
    """Whether the image of the first vector field is one of the system's."""
    field = system.fields[0]
    image = np.concatenate([matrix @ field[:, :-1] @ matrix.T, matrix @ field[:, -1:]], axis=1)
    size = np.abs(system.fields).max()
    return bool((np.abs(system.fields - image).max(axis=(1, 2)) <= 1e-9 * size).any())

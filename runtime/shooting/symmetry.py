"""Symmetries of a system: signed permutations of the states that map motions to motions.

An orbit that a symmetry maps to itself, shifted by a part of its period, is known by that part:
its phases lead from a start to the start's image, and the symmetry leads back.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError, unknown_name
from nonsmooth.runtime.core.values import Value, as_value, parse
from nonsmooth.runtime.model.piecewise import PiecewiseLinear
from nonsmooth.runtime.model.structure import Structure, TransitionShape
from nonsmooth.runtime.shooting.shooting_map import (
    ItineraryShape,
    itinerary_shape,
    numbers_in,
    shoot,
)
from nonsmooth.runtime.shooting.translations import (
    gauges_of,
    translations_of,
)

_SAME = 1e-12  # of the largest entry: numbers that are equal but for rounding
_LARGEST_ORDER = 64


@dataclass(frozen=True, eq=False)
class Symmetry:
    """A symmetry of a system, checked against its numbers."""

    # (N, N) of int, a signed permutation: the image of the state y is ``matrix @ y``
    matrix: np.ndarray
    order: int  # the least power that is the identity
    configurations: tuple[int, ...]  # image of each configuration
    # for each configuration the image of each boundary, among those of the image
    boundaries: tuple[tuple[int, ...], ...]


def matrix_of(structure: Structure, given: Mapping[str, str] | Any) -> np.ndarray:
    """Matrix (N, N) of a signed permutation, from images by name or from a matrix.

    Images are ``{"x": "-x", "v": "-v"}``, and states that are not named stay; a matrix P maps y
    to P y. Raises `InputError` for unknown names, or if it is no signed permutation.
    """
    names = structure.states
    if isinstance(given, Mapping):
        found = np.eye(len(names), dtype=int)
        for name, image in given.items():
            if name not in names:
                raise unknown_name("state", str(name), names)
            text = str(image).replace(" ", "")
            source = text.lstrip("+-")
            if source not in names or len(text) - len(source) > 1:
                raise InputError(f"symmetry: {name} -> {image!r} is no state, or minus one")
            row = np.zeros(len(names), dtype=int)
            row[names.index(source)] = -1 if text.startswith("-") else 1
            found[names.index(name)] = row
    else:
        try:
            array = np.asarray(given, dtype=float)
        except (TypeError, ValueError):
            raise InputError("symmetry: neither images by name nor a matrix of numbers") from None
        if array.shape != (len(names), len(names)) or not np.isin(array, (-1, 0, 1)).all():
            raise InputError(
                f"symmetry: no {len(names)} x {len(names)} matrix of -1, 0 and 1, a signed"
                f" permutation of {', '.join(names)}"
            )
        found = array.astype(int)
    if not (abs(found).sum(axis=0) == 1).all() or not (abs(found).sum(axis=1) == 1).all():
        raise InputError("symmetry: no permutation: two states have the same image")
    return found


def images_of(matrix: np.ndarray, states: Sequence[str]) -> dict[str, str]:
    """Images of all states by name under a signed permutation, as `matrix_of` takes them.

    Examples
    --------
    >>> images_of(np.array([[-1, 0], [0, -1]]), ["x", "v"])
    {'x': '-x', 'v': '-v'}
    """
    found = {}
    for name, row in zip(states, matrix, strict=True):
        (place,) = np.flatnonzero(row).tolist()
        found[name] = f"{'-' if row[place] < 0 else ''}{states[place]}"
    return found


def symmetry_of(system: PiecewiseLinear, given: Any, error: float = _SAME) -> Symmetry:
    """A symmetry of a system at its parameters, with the images of what the system declares.

    It is given as for `matrix_of`; numbers are equal if they differ by `error` at most, relatively.
    Raises `InputError` for the identity, for anything but a signed permutation, or if fields,
    boundaries, constraints or transitions do not follow: the message names what has no image.
    """
    structure = system.structure
    matrix = matrix_of(structure, given)
    order, power = 1, matrix
    while (power != np.eye(len(matrix), dtype=int)).any():
        order, power = order + 1, power @ matrix
        if order > _LARGEST_ORDER:
            raise InputError(f"symmetry: more than {_LARGEST_ORDER} images of one state")
    if order == 1:
        raise InputError("symmetry: it is the identity: leave it out")
    pairs = {frozenset(pair) for pair in structure.forcing}
    for pair in structure.forcing:
        image = frozenset(int(np.flatnonzero(matrix[:, state])[0]) for state in pair)
        if image not in pairs:
            told = " and ".join(structure.states[state] for state in pair)
            raise InputError(f"symmetry: it takes the forcing {told} apart")
    if structure.unvisited:
        raise InputError(
            f"symmetry: {structure.name} has too many configurations to be compared with their"
            " images: give the itinerary of the whole orbit"
        )
    images = _Images(system, matrix, error)
    found = next(images.bijections({}), None)
    if found is None:
        raise InputError(f"symmetry: no symmetry of {structure.name} here: {images.reason()}")
    every = range(len(structure.configurations))
    boundaries = tuple(images.boundaries[c, found[c]] for c in every)
    return Symmetry(matrix, order, tuple(found[c] for c in every), boundaries)


def _of_images(matrix: np.ndarray, functions: np.ndarray) -> np.ndarray:
    """Affine functions (..., N + 1) of states as functions of the states' images."""
    return np.concatenate([functions[..., :-1] @ matrix.T, functions[..., -1:]], axis=-1)


def _same_maps(first: np.ndarray, second: np.ndarray, error: float = _SAME) -> bool:
    """Whether two maps of one shape are equal, up to an error relative to the first's entries."""
    return bool((abs(first - second) <= error * abs(first).max()).all())


def _units(rows: np.ndarray) -> np.ndarray:
    """Rows (R, N + 1) in units of their largest entries; zero ones stay zero."""
    sizes = abs(rows).max(axis=1, keepdims=True)
    return rows / np.where(sizes == 0, 1, sizes)


def _matched(
    own: Sequence[Any], others: Sequence[Any], fits: Callable[[Any, Any], bool]
) -> tuple[int, ...] | None:
    """Place among others of the first that fits, for each in turn; None unless all are paired."""
    found: list[int] = []
    for each in own:
        left = (k for k, other in enumerate(others) if k not in found and fits(each, other))
        found.append(next(left, -1))
    return tuple(found) if len(own) == len(others) and -1 not in found else None


class _Images:
    """Candidates for the image of each configuration, with the images of their boundaries."""

    def __init__(self, system: PiecewiseLinear, matrix: np.ndarray, error: float) -> None:
        self.system, self.structure, self.error = system, system.structure, error
        self.rows, self.images = _units(system.rows), _units(_of_images(matrix, system.rows))
        self.fields, self.resets = (
            matrix @ _of_images(matrix, part) for part in (system.fields, system.resets)
        )
        every = range(len(self.structure.configurations))
        pairs = {(c, image): self._correspondence(c, image) for c in every for image in every}
        self.boundaries = {pair: found for pair, found in pairs.items() if found is not None}

    def bijections(self, chosen: dict[int, int]) -> Iterator[dict[int, int]]:
        """Yield the maps of configurations that complete `chosen` and suit the transitions."""
        c = len(chosen)
        if c == len(self.structure.configurations):
            if all(self._transitions_follow(source, chosen) for source in chosen):
                yield chosen
            return
        for image in range(len(self.structure.configurations)):
            if (c, image) in self.boundaries and image not in chosen.values():
                yield from self.bijections({**chosen, c: image})

    def reason(self) -> str:
        """Why there is no symmetry, in words."""
        for c, name in enumerate(self.structure.configurations):
            if not any(source == c for source, _ in self.boundaries):
                return f"no configuration is the image of {name}, with its field and boundaries"
        return "the transitions do not follow"

    def _correspondence(self, c: int, image: int) -> tuple[int, ...] | None:
        """Images of a configuration's boundaries in another one; None if it is not its image."""
        if not self._equal(self.fields[c], self.system.fields[image]):
            return None
        (held, others), (own, their) = (
            (part[c], part[image])
            for part in (self.structure.constraints, self.structure.boundaries)
        )
        if _matched(held, others, self._holds_with) is None:
            return None
        return _matched(
            own, their, lambda b, r: r.reached == b.reached and self._row_maps(b.row, r.row)
        )

    def _row_maps(self, row: int, other: int) -> bool:
        """Whether the image of a row is a positive multiple of another row."""
        return self._equal(self.images[row], self.rows[other])

    def _holds_with(self, row: int, other: int) -> bool:
        """Whether the image of a row is a multiple of another row: both are zero together."""
        return self._row_maps(row, other) or self._equal(-self.images[row], self.rows[other])

    def _equal(self, first: np.ndarray, second: np.ndarray) -> bool:
        return _same_maps(first, second, self.error)

    def _transitions_follow(self, source: int, chosen: Mapping[int, int]) -> bool:
        """Whether each transition has its image among those of the image, in the same order.

        Transitions that never apply together may have any order. Boundaries reached together are
        left out: contacts are decided one after another there, in the order of declaration.
        """
        image = chosen[source]
        places = self.boundaries[source, image]
        own, others = (
            [
                t
                for t in self.structure.transitions[c]
                if len(t.boundaries) == 1 and t.path is None  # fields and boundaries tell a law
            ]
            for c in (source, image)
        )
        if len(others) != len(own):
            return False
        for transition in own:
            boundaries = frozenset(places[b] for b in transition.boundaries)
            passed: list[TransitionShape] = []
            for other in others:
                if other.boundaries != boundaries:
                    continue
                exclusive = all(self._exclude_each_other(other, before) for before in passed)
                if exclusive and self._transition_maps(transition, other, chosen):
                    others.remove(other)
                    break
                passed.append(other)
            else:
                return False
        return True

    def _exclude_each_other(self, first: TransitionShape, second: TransitionShape) -> bool:
        """Whether two transitions have conditions that never hold together."""
        return any(
            along == along_ and holds and holds_ and self._opposed(row, row_)
            for row, along, holds in first.conditions
            for row_, along_, holds_ in second.conditions
        )

    def _opposed(self, row: int, other: int) -> bool:
        """Whether two functions are never positive together: their sum is a constant, at most 0."""
        rows = self.system.rows[[row, other]]
        sizes = abs(rows[:, :-1]).max(axis=1)
        if not sizes.all():
            return False
        first, second = rows / sizes[:, None]
        return self._equal(first[:-1], -second[:-1]) and bool(first[-1] + second[-1] <= 0)

    def _transition_maps(
        self, transition: TransitionShape, other: TransitionShape, chosen: Mapping[int, int]
    ) -> bool:
        if chosen[transition.target] != other.target:
            return False
        if not self._equal(self.resets[transition.reset], self.system.resets[other.reset]):
            return False
        if len(transition.conditions) != len(other.conditions):
            return False
        return all(
            any(
                along_ == chosen[along] and holds_ == holds and self._row_maps(row, row_)
                for row_, along_, holds_ in other.conditions
            )
            for row, along, holds in transition.conditions
        )


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


def whole_shape(system: PiecewiseLinear, symmetry: Symmetry, part: Any) -> ItineraryShape:
    """The whole cycle of a part that the symmetry closes.

    Raises `InputError` as `itinerary_shape` does, and where the resets at boundaries are not the
    images of each other.
    """
    cycle = itinerary_shape(system.structure, whole_itinerary(system.structure, symmetry, part))
    for place, transition in enumerate(cycle.transitions):
        image = place - len(part)
        reset, wanted = system.resets[[transition.reset, cycle.transitions[image].reset]]
        if not _same_maps(symmetry.matrix @ _of_images(symmetry.matrix, reset), wanted):
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
        last = cycle.phases([len(states) - 1])
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

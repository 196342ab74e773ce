"""Modes of a configuration from its numbers, where its flow has no closed form.

With Y = (y, 1) the motion y' = A y + b is Y' = B Y, and

    exp(B t) = sum_c e^(mu_c t) sum_k t^k/k! (B - mu_c)^k P_c,

a sum over clusters of eigenvalues with centres mu_c and spectral projectors P_c. A cluster is a
single eigenvalue wherever its projector is small enough to be known well; eigenvalues that are
equal, or so near each other that their projectors cancel, are taken together. The powers of a
cluster end at its size where its eigenvalues are equal, and a little later where they are not.

The first of four ways that succeeds is taken:

- `simple_modes` where all eigenvalues are apart.
- `driven_modes` where only what drives a structure has equal eigenvalues, as a held coordinate and
  a constant: a forcing may be faster than the structure by any factor. Both take a whole stack of
  fields: they serve sweeps.
- `subspace_modes` where other eigenvalues are equal, and always from `LARGE` states on.
- `precise_modes`, in many digits, where eigenvalues are neither equal nor apart: chains of at most
  seven that nearly meet. More of them are refused.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache, lru_cache

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.model.factored_flows import Flows, arrays_of, matrices_of
from nonsmooth.runtime.model.modes.driven_modes import driven_modes
from nonsmooth.runtime.model.modes.natural_units import dependence, fall_rates, natural_units
from nonsmooth.runtime.model.modes.precise_modes import best_modes
from nonsmooth.runtime.model.modes.simple_modes import (
    ModeGroup,
    NumericModes,
    is_moderate,
    simple_modes,
)
from nonsmooth.runtime.model.modes.subspace_modes import LARGE, subspace_modes
from nonsmooth.runtime.model.structure import ModeShape, mode_shapes

__all__ = ["NumericModes", "grouped_modes", "no_modes", "numeric_modes", "standing_modes"]

_ONE = mode_shapes([(1, False)])
_FEW = 4  # for fewer fields it pays to remember their modes
_FAR_APART = 2.0**200  # entries in natural units, of which a few multiplied are no infinity
_MOST, _FEWEST = 128 << 20, 32  # bytes of what is remembered of one size, and entries of any size


@np.errstate(over="ignore", invalid="ignore")
def numeric_modes(field: np.ndarray, rows: np.ndarray | None = None) -> NumericModes:
    """Modes of y' = A y + b; `field` (N, N + 1) is A, then b, and finite.

    `rows` (r, N + 1) are the boundaries in front of which the motion takes place; they set the
    unit of time. Raises `InputError` if eigenvalues are so close, without being equal, that
    double precision does not determine the motion.
    """
    array = np.ascontiguousarray(field, dtype=float)
    rate = 0.0 if rows is None else float(fall_rates(array[None], rows[None])[0])
    try:
        return _remembered(len(array))(array.tobytes(), rate)
    except np.linalg.LinAlgError:
        raise InputError(
            "entries of a vector field are too far apart: double precision does not tell its modes"
        ) from None


@np.errstate(over="ignore", invalid="ignore")
def grouped_modes(fields: np.ndarray, rows: np.ndarray) -> list[ModeGroup]:
    """Modes of n motions y' = A y + b, grouped by their shapes.

    `fields` (n, N, N + 1) are A, then b; `rows` (n, r, N + 1) as for `numeric_modes`. Motions
    whose numbers are not finite, or that double precision does not determine, get NaN.
    """
    count = len(fields)
    if count > 1 and (fields == fields[:1]).all() and (rows == rows[:1]).all():
        (only,) = grouped_modes(fields[:1], rows[:1])
        exponents, *flows = (
            np.broadcast_to(part, (count, *part.shape[1:]))
            for part in (only.exponents, *only.flows)
        )
        return [ModeGroup(np.arange(count), only.shapes, exponents, tuple(flows))]
    finite = np.flatnonzero(np.isfinite(fields).all(axis=(-2, -1)))
    groups = []
    if len(finite) > _FEW and fields.shape[1] < LARGE:
        for group in _modes_of_many(fields[finite], rows[finite]):
            groups.append(group._replace(places=finite[group.places]))
    members: dict[tuple[ModeShape, ...], list[tuple[int, NumericModes]]] = {}
    for place in sorted({*range(count)}.difference(*(g.places.tolist() for g in groups))):
        try:
            found = numeric_modes(fields[place], rows[place])
        except InputError:
            found = no_modes(fields.shape[1])
        members.setdefault(found.shapes, []).append((place, found))
    for shapes, each in members.items():
        exponents = np.stack([modes.exponents for _, modes in each])
        arrays = zip(*(arrays_of(modes.flows) for _, modes in each), strict=True)
        places = np.array([place for place, _ in each])
        groups.append(ModeGroup(places, shapes, exponents, tuple(map(np.stack, arrays))))
    return groups


@cache
def no_modes(size: int) -> NumericModes:
    """A placeholder for unknown modes of a configuration: one mode, and NaN."""
    return _unchanging(np.full((1, 2), np.nan), np.full((1, size, size + 1), np.nan))


@cache
def standing_modes(size: int) -> NumericModes:
    """A placeholder for a configuration in which motions end at once.

    It has one mode, with which the state stays constant.
    """
    return _unchanging(np.zeros((1, 2)), np.eye(size, size + 1)[None])


def _unchanging(
    exponents: np.ndarray, flows: Flows, shapes: tuple[ModeShape, ...] = _ONE
) -> NumericModes:
    """Modes that are shared, by default one: nobody may write into their arrays."""
    for array in (exponents, *arrays_of(flows)):
        array.flags.writeable = False
    return NumericModes(shapes, exponents, flows)


@cache
def _remembered(size: int) -> Callable[[bytes, float], NumericModes]:
    """Modes by field and rate: configurations share fields, and so do points of a sweep."""
    terms = size if size < LARGE else 5  # matrices of all modes, or factors
    most = max(_FEWEST, min(4096, _MOST // (8 * size**2 * terms)))

    @lru_cache(most)
    def modes(content: bytes, rate: float) -> NumericModes:
        found = _found(np.frombuffer(content).reshape(size, size + 1), rate)
        return _unchanging(found.exponents, found.flows, found.shapes)

    return modes


def _modes_of_many(fields: np.ndarray, rows: np.ndarray) -> list[ModeGroup]:
    """Modes of the motions of a stack that `_by_stacks` finds, computed in natural units."""
    units = natural_units(fields, fall_rates(fields, rows))
    scaled = units.fields(fields)
    near = np.flatnonzero(np.isfinite(scaled).all(axis=(-2, -1)))
    groups = []
    for group in _by_stacks(scaled[near]):
        places = near[group.places]
        own = units.at(places)
        exponents, flows = own.exponents(group.exponents), own.flows(group.shapes, group.flows)
        groups.append(ModeGroup(places, group.shapes, exponents, flows))
    return groups


def _by_stacks(fields: np.ndarray) -> list[ModeGroup]:
    """Modes of the motions of a stack that are simple or driven; others are left out."""
    groups = simple_modes(fields)
    rest = np.setdiff1d(np.arange(len(fields)), [p for g in groups for p in g.places.tolist()])
    if not len(rest):
        return groups
    driven = driven_modes(fields[rest], _without_boundaries)
    return [*groups, *(group._replace(places=rest[group.places]) for group in driven)]


def _without_boundaries(fields: np.ndarray) -> list[ModeGroup]:
    """Modes of motions in front of no boundary."""
    return grouped_modes(fields, np.empty((len(fields), 0, fields.shape[-1])))


def _found(field: np.ndarray, rate: float) -> NumericModes:
    """Modes of one motion, computed in its natural units."""
    units = natural_units(field[None], np.array([rate]))
    shapes, exponents, flows = _found_in_natural_units(units.fields(field[None])[0])
    return NumericModes(
        shapes, units.exponents(exponents[None])[0], units.flows_of_one(shapes, flows)
    )


def _found_in_natural_units(field: np.ndarray) -> NumericModes:
    """Modes of one motion by the first way that succeeds; `LinAlgError` if none can."""
    size = len(field)
    if size < LARGE:
        for group in _by_stacks(field[None]):
            return NumericModes(group.shapes, group.exponents[0], group.flows[0][0])
    if not np.abs(field).max(initial=0.0) < _FAR_APART:
        raise np.linalg.LinAlgError
    whole = np.vstack([field, np.zeros(size + 1)])
    depends = dependence(whole[None])[0]
    found, sure = subspace_modes(whole, depends) or (None, False)
    # small terms do not cancel while the motion is small
    if found and (size >= LARGE or (sure and is_moderate(matrices_of(found.flows), field))):
        return found
    return best_modes(whole, depends, found)

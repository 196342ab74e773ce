"""A system at a parameter point: affine rows, fields, flows and resets, in any arithmetic.

`piecewise` gives the numbers of one point, `numbers_at` those of many points in double
precision, `piecewise_in` those of one point in another arithmetic. Coordinates are the
system's own: positions, then velocities, for motions of second order.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.values import Value, as_value
from nonsmooth.runtime.model.factored_flows import Flows, arrays_of
from nonsmooth.runtime.model.kernels import SystemKernels, kernels_of
from nonsmooth.runtime.model.loading.declared import DeclaredSystem
from nonsmooth.runtime.model.modes.numeric_modes import (
    NumericModes,
    grouped_modes,
    no_modes,
    numeric_modes,
    standing_modes,
)
from nonsmooth.runtime.model.modes.simple_modes import ModeGroup
from nonsmooth.runtime.model.parameters import system_parameters
from nonsmooth.runtime.model.structure import Structure, structure_of


@dataclass(frozen=True, eq=False)
class PiecewiseLinear:
    """A system at one parameter point, in one arithmetic, whose numbers are the entries.

    In other arithmetics than double precision a system whose flows have no closed form has
    neither modes, exponents nor flows: its flow is the exponential of the field.
    """

    structure: Structure
    parameters: dict[str, Value]
    fields: np.ndarray  # (configurations, N, N + 1), ``y' = A y + b``: A, then b as the last column
    rows: np.ndarray  # (R, N + 1), affine functions ``n y + c``: n, then c
    resets: np.ndarray  # (S, N, N + 1)
    exponents: tuple[np.ndarray, ...]  # for each configuration (modes, 2), real and imaginary parts
    # for each configuration (functions, N, N + 1) or FactoredFlows, with ``y(t) = sum_f phi_f(t)
    # (B_f y(0) + beta_f)``: B_f, then beta_f
    flows: tuple[Flows, ...]

    @property
    def forcing_speeds(self) -> np.ndarray:
        """Angular frequencies (f,) of the forcings, negative where a sine falls first."""
        pairs = self.structure.forcing
        return np.array([self.fields[0, sine, cosine] for cosine, sine in pairs], dtype=float)

    @property
    def kernels(self) -> SystemKernels:
        """Tables and kernels that it was made from."""
        assert self.structure.kernels is not None
        return self.structure.kernels

    @property
    def numbers(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Fields, rows and resets."""
        return self.fields, self.rows, self.resets


def piecewise(
    system: str | SystemKernels | DeclaredSystem, parameters: Mapping[str, object]
) -> PiecewiseLinear:
    """A system at one parameter point, in double precision; all physical parameters are given.

    Raises `InputError` as `system_parameters` and `structure_of` do.
    """
    kernels = kernels_of(system)
    values = system_parameters(kernels, parameters)
    return _piecewise(kernels, values, np.array([float(value) for value in values.values()]))


def piecewise_at(
    kernels: SystemKernels, point: np.ndarray, visited: Collection[int] | None = None
) -> PiecewiseLinear:
    """A system at a checked parameter point (p,), in double precision, in the system's order.

    `visited` are the configurations whose flows are needed, as for `numbers_at`. Raises
    `InputError` where double precision does not tell the modes from each other.
    """
    values = {p.name: as_value(x) for p, x in zip(kernels.parameters, point.tolist(), strict=True)}
    return _piecewise(kernels, values, point, visited)


def _piecewise(
    kernels: SystemKernels,
    values: dict[str, Value],
    point: np.ndarray,
    visited: Collection[int] | None = None,
) -> PiecewiseLinear:
    tables = [part[0] for part in _evaluated(kernels, point[None])]
    structure = structure_of(kernels)
    if structure.modes is not None:
        stacked = (part[0] for part in _closed_modes(kernels, point[None]))
        return _record(structure, values, tables, *_cut(structure, *stacked))
    found = _numeric(structure, tables[0], tables[1], visited)
    _, exponents, flows = zip(*found, strict=True)
    structure = structure.with_modes(tuple(modes.shapes for modes in found))
    return _record(structure, values, tables, exponents, flows)


class PointGroup(NamedTuple):
    """Numbers of parameter points whose configurations have the same modes."""

    structure: Structure  # with these modes
    places: np.ndarray  # (k,) of int, indices of the points
    flat: np.ndarray  # (k, size), fields, rows, resets, exponents and flows, one after the other


def numbers_at(
    kernels: SystemKernels, points: np.ndarray, visited: Collection[int] | None = None
) -> list[PointGroup]:
    """Numbers at points (n, p), grouped by their modes: one group for flows in closed form.

    Points are in the system's order. Flows are needed of the configurations in `visited`, all by
    default; if eigenvalues are computed numerically, those of the others are NaN. Points that
    have no modes get NaN.
    """
    structure, count = structure_of(kernels), len(points)
    parts = _evaluated(kernels, points)
    if structure.modes is not None:
        parts = (*parts, *_closed_modes(kernels, points))
        return [PointGroup(structure, np.arange(count), _flat(parts))]
    size = len(structure.states)
    fields = parts[0].reshape(count, -1, size, size + 1)
    told = np.isfinite(fields).all(axis=(1, 2, 3))
    found: dict[int, list[ModeGroup]] = {}
    for place in range(fields.shape[1]) if visited is None else sorted({*visited}):
        if place in structure.unvisited:
            found[place] = [_everywhere(standing_modes(size), np.arange(count))]
            continue
        finite = np.where(told[:, None, None], fields[:, place], np.nan)
        found[place] = grouped_modes(finite, parts[1][:, _rows_of(structure, place)])
        for group in found[place]:
            told[group.places] &= np.isfinite(group.exponents).all(axis=(1, 2))
    result = []
    for places in _alike(told, found.values()):
        visible = found if told[places[0]] else {}
        own = [
            _members(visible[place], places)
            if place in visible
            else _everywhere(no_modes(size), places)
            for place in range(fields.shape[1])
        ]
        arrays = [part[places] for part in parts]
        arrays += [modes.exponents for modes in own]
        arrays += [part for modes in own for part in modes.flows]
        flat = np.concatenate([part.reshape(len(places), -1) for part in arrays], axis=1)
        shapes = tuple(modes.shapes for modes in own)
        result.append(PointGroup(structure.with_modes(shapes), places, flat))
    return result


def cut_tables(structure: Structure, flat: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Fields, rows and resets as views of the numbers (..., size) of `PointGroup`."""
    size, lead = len(structure.states), flat.shape[:-1]
    shapes = [
        (len(structure.configurations), size, size + 1),
        (structure.rows, size + 1),
        (structure.resets, size, size + 1),
    ]
    ends = np.cumsum([math.prod(shape) for shape in shapes])
    parts = np.split(flat[..., : ends[2]], ends[:2], axis=-1)
    fields, rows, resets = (
        part.reshape(*lead, *shape) for part, shape in zip(parts, shapes, strict=True)
    )
    return fields, rows, resets


def _everywhere(modes: NumericModes, places: np.ndarray) -> ModeGroup:
    """The modes of one motion, repeated for the points at some places."""
    exponents, *flows = (
        np.broadcast_to(part, (len(places), *part.shape))
        for part in (modes.exponents, *arrays_of(modes.flows))
    )
    return ModeGroup(places, modes.shapes, exponents, tuple(flows))


def _alike(told: np.ndarray, found: Iterable[list[ModeGroup]]) -> list[np.ndarray]:
    """Places of the points, split so that in each part all configurations have equal mode shapes.

    Points whose numbers are not `told` are a part by themselves.
    """
    labels = [~told]
    for groups in found:
        label = np.zeros(len(told), dtype=int)
        for number, group in enumerate(groups):
            label[group.places] = number
        labels.append(np.where(told, label, 0))
    _, inverse = np.unique(np.stack(labels, axis=1), axis=0, return_inverse=True)
    inverse = inverse.ravel()  # numpy 2.0.0 gives it another axis
    return [np.flatnonzero(inverse == k) for k in range(inverse.max(initial=-1) + 1)]


def _members(groups: list[ModeGroup], places: np.ndarray) -> ModeGroup:
    """The modes of some points, all of which are in one of the groups."""
    for group in groups:
        row = np.searchsorted(group.places, places[0])
        if row < len(group.places) and group.places[row] == places[0]:
            rows = np.searchsorted(group.places, places)
            flows = tuple(part[rows] for part in group.flows)
            return ModeGroup(places, group.shapes, group.exponents[rows], flows)
    raise AssertionError("each point is in a group")  # pragma: no cover


def _flat(parts: Iterable[np.ndarray]) -> np.ndarray:
    return np.concatenate([p.reshape(len(p), p.shape[1] * p.shape[2]) for p in parts], axis=1)


def _rows_of(structure: Structure, place: int) -> list[int]:
    """The rows of a configuration's boundaries."""
    return [boundary.row for boundary in structure.boundaries[place]]


def _numeric(
    structure: Structure, fields: np.ndarray, rows: np.ndarray, visited: Collection[int] | None
) -> list[NumericModes]:
    """Modes of each configuration from stacked fields (c N, N + 1) and rows (R, N + 1)."""
    size = len(structure.states)
    if not np.isfinite(fields).all():
        raise InputError(f"the vector fields of {structure.name} are not finite")
    return [
        standing_modes(size)
        if place in structure.unvisited
        else numeric_modes(field, rows[_rows_of(structure, place)])
        if visited is None or place in visited
        else no_modes(size)
        for place, field in enumerate(fields.reshape(-1, size, size + 1))
    ]


def piecewise_in(
    system: str | SystemKernels | DeclaredSystem, parameters: Mapping[str, object], lib: Any
) -> PiecewiseLinear:
    """A system at one parameter point in another arithmetic, `Mpmath` or `Balls`.

    Entries are that arithmetic's numbers, or integers, in arrays of objects; all physical
    parameters are given. There are no exponents and flows if the flow has no closed form.
    Raises `InputError` as `piecewise` does.
    """
    kernels = kernels_of(system)
    structure = structure_of(kernels)
    values = system_parameters(kernels, parameters)
    numbers = {name: lib.number(value) for name, value in values.items()}
    point = list(numbers.values())
    tables = [
        _objects(kernels.source(kernel)(point, lib=lib)) for kernel in ("fields", "rows", "resets")
    ]
    if structure.modes is None:
        return _record(structure, values, tables)
    spectrum, _ = kernels.source("spectrum")(
        [numbers[name] for name in kernels.table["spectrum_parameters"]], lib=lib
    )
    stacked = map(_objects, kernels.source("modes")(point, spectrum, lib=lib))
    return _record(structure, values, tables, *_cut(structure, *stacked))


def tables_at(
    kernels: SystemKernels, points: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Fields, rows and resets at points (n, p), in double precision.

    Points are in the system's order; the arrays are (n, configurations, N, N + 1), (n, R, N + 1)
    and (n, S, N, N + 1).
    """
    size = len(kernels.table["states"])
    fields, rows, resets = _evaluated(kernels, points)
    shape = (len(points), -1, size, size + 1)
    return fields.reshape(shape), rows, resets.reshape(shape)


def _evaluated(kernels: SystemKernels, points: np.ndarray) -> tuple[np.ndarray, ...]:
    """Fields, rows and resets at points (n, p), each (n, rows, columns)."""
    return tuple(kernels.evaluate(kernel, points) for kernel in ("fields", "rows", "resets"))


def _closed_modes(kernels: SystemKernels, points: np.ndarray) -> tuple[np.ndarray, ...]:
    """Exponents (n, modes, 2) and flows (n, rows, N + 1) in closed form."""
    names = [p.name for p in kernels.parameters]
    places = [names.index(name) for name in kernels.table["spectrum_parameters"]]
    spectrum, _ = kernels.evaluate("spectrum", points[:, places])
    exponents, flows = kernels.evaluate("modes", points, spectrum)
    return exponents, flows


def _objects(rows: Sequence[Sequence[Any]]) -> np.ndarray:
    array = np.empty((len(rows), len(rows[0])), dtype=object)
    for i, row in enumerate(rows):
        array[i, :] = row
    return array


def _cut(
    structure: Structure, exponents: np.ndarray, flows: np.ndarray
) -> tuple[list[np.ndarray], list[np.ndarray]]:
    """Exponents and flows of each configuration, from arrays in which all of them are stacked."""
    size = len(structure.states)
    ends = np.cumsum([0, *map(len, structure.shapes)])
    stops = np.cumsum([0, *structure.functions]) * size
    return (
        [exponents[a:b].copy() for a, b in pairwise(ends)],
        [flows[a:b].copy().reshape(-1, size, size + 1) for a, b in pairwise(stops)],
    )


def _record(
    structure: Structure,
    values: dict[str, Value],
    tables: Sequence[np.ndarray],
    exponents: Iterable[np.ndarray] = (),
    flows: Iterable[Flows] = (),
) -> PiecewiseLinear:
    """The system at one point; fields and resets of all configurations are stacked in `tables`."""
    size = len(structure.states)
    fields, rows, resets = tables
    fields, resets = (part.reshape(-1, size, size + 1) for part in (fields, resets))
    return PiecewiseLinear(structure, values, fields, rows, resets, tuple(exponents), tuple(flows))

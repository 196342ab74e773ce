"""A system at a parameter point: affine rows, fields, flows and resets, in any arithmetic.

`structure_of` reads what does not depend on parameters; `piecewise` adds the numbers of one
point, `numbers_at` those of many points in double precision, `piecewise_in` those of one point
in another arithmetic. Coordinates are physical: positions, then velocities.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cache, cached_property
from itertools import pairwise
from typing import Any

import numpy as np

from nonsmooth.runtime.errors import InputError, unknown_name
from nonsmooth.runtime.kernels import SystemKernels, load_system
from nonsmooth.runtime.parameters import in_domains, value_of
from nonsmooth.runtime.values import Value, as_value

__all__ = [
    "BoundaryShape",
    "ContactShape",
    "ModeShape",
    "PiecewiseLinear",
    "Structure",
    "TransitionShape",
    "numbers_at",
    "parameter_points",
    "piecewise",
    "piecewise_at",
    "piecewise_in",
    "structure_of",
    "system_parameters",
]


@dataclass(frozen=True)
class ModeShape:
    """Functions of time with one exponent: t^k e^(st) cos(wt), and sines where it oscillates.

    `places` are the functions' places among those of the configuration: for each power k the
    cosine's, then the sine's if there is one.
    """

    length: int
    oscillates: bool
    places: tuple[int, ...]


@dataclass(frozen=True)
class BoundaryShape:
    """A boundary of a configuration: its name, its row, and whether reaching it is enough."""

    name: str
    row: int
    reached: bool


@dataclass(frozen=True)
class TransitionShape:
    """What follows when exactly these boundaries are reached at one instant.

    Attributes
    ----------
    boundaries : frozenset of int
        Indices among the boundaries of the source.
    conditions : tuple of (row, configuration, bool)
        The first nonzero derivative of the row along the configuration's flow is positive,
        or not.
    reset, target : int
    """

    boundaries: frozenset[int]
    conditions: tuple[tuple[int, int, bool], ...]
    reset: int
    target: int


@dataclass(frozen=True)
class ContactShape:
    """Where the surroundings act: rows of force by configuration, of velocity, of the surface."""

    name: str
    forces: Mapping[int, int]
    velocity: int
    surface: int


@dataclass(frozen=True, eq=False)
class Structure:
    """What a system is apart from its parameters; configurations and states by index.

    Attributes
    ----------
    name : str
    states, configurations : tuple of str
    modes : for each configuration its modes
    held : for each configuration the positions that keep their velocity
    constraints : for each configuration the rows that vanish in it
    boundaries, transitions : for each configuration
    contacts : tuple of ContactShape
    rows, resets : int
        How many there are.
    """

    name: str
    states: tuple[str, ...]
    configurations: tuple[str, ...]
    modes: tuple[tuple[ModeShape, ...], ...]
    held: tuple[tuple[int, ...], ...]
    constraints: tuple[tuple[int, ...], ...]
    boundaries: tuple[tuple[BoundaryShape, ...], ...]
    transitions: tuple[tuple[TransitionShape, ...], ...]
    contacts: tuple[ContactShape, ...]
    rows: int
    resets: int

    def configuration(self, name: str) -> int:
        """Index of a configuration; InputError if there is none of that name."""
        if name not in self.configurations:
            raise unknown_name("configuration", str(name), self.configurations)
        return self.configurations.index(name)

    def boundary(self, configuration: int, name: str) -> int:
        """Index of a boundary of a configuration; InputError if it has none of that name."""
        names = [b.name for b in self.boundaries[configuration]]
        if name not in names:
            where = self.configurations[configuration]
            raise unknown_name(f"boundary of {where}", name, names)
        return names.index(name)

    @cached_property
    def functions(self) -> tuple[int, ...]:
        """Number of functions of time of each configuration."""
        return tuple(sum(len(mode.places) for mode in modes) for modes in self.modes)


@dataclass(frozen=True, eq=False)
class PiecewiseLinear:
    """A system at one parameter point, in one arithmetic: entries are its numbers.

    Attributes
    ----------
    structure : Structure
    parameters : dict of str to Value
    fields : array (configurations, N, N + 1)
        ``y' = A y + b``: A, then b as the last column.
    rows : array (R, N + 1)
        Affine functions ``n y + c``: n, then c.
    resets : array (S, N, N + 1)
    exponents : for each configuration an array (modes, 2)
        Real and imaginary parts.
    flows : for each configuration an array (functions, N, N + 1)
        ``y(t) = sum_f phi_f(t) (B_f y(0) + beta_f)``: B_f, then beta_f.
    """

    structure: Structure
    parameters: dict[str, Value]
    fields: np.ndarray
    rows: np.ndarray
    resets: np.ndarray
    exponents: tuple[np.ndarray, ...]
    flows: tuple[np.ndarray, ...]


def structure_of(system: str | SystemKernels) -> Structure:
    """Structure of a generated system.

    Raises
    ------
    InputError
        For an unknown name, or a system whose flows have no closed form of modes.
    """
    kernels = load_system(system) if isinstance(system, str) else system
    return _structure(kernels)


@cache
def _structure(kernels: SystemKernels) -> Structure:
    table = kernels.table
    configurations = tuple(table["configurations"])
    states = tuple(table["states"])
    if table["modes"] is None:
        raise InputError(f"{kernels.name} has configurations without modes in closed form")
    boundaries = tuple(
        tuple(
            BoundaryShape(b["name"], row, b["acts_when"] == "reached")
            for b, row in zip(found, table["boundary_rows"][name], strict=True)
        )
        for name, found in table["configurations"].items()
    )
    transitions: list[list[TransitionShape]] = [[] for _ in configurations]
    for entry in table["transitions"]:
        source = configurations.index(entry["source"])
        names = [b.name for b in boundaries[source]]
        transitions[source].append(
            TransitionShape(
                frozenset(names.index(name) for name in entry["boundaries"]),
                tuple(
                    (row, configurations.index(along), holds)
                    for row, along, holds in entry["conditions"]
                ),
                entry["reset"],
                configurations.index(entry["target"]),
            )
        )
    return Structure(
        table["name"],
        states,
        configurations,
        tuple(_modes(table["modes"][name]) for name in configurations),
        tuple(tuple(states.index(x) for x in table["held"][name]) for name in configurations),
        tuple(tuple(table["constraint_rows"][name]) for name in configurations),
        boundaries,
        tuple(map(tuple, transitions)),
        tuple(
            ContactShape(
                name,
                {configurations.index(c): row for c, row in found["forces"].items()},
                found["velocity"],
                found["surface"],
            )
            for name, found in table["contacts"].items()
        ),
        kernels.module.KERNELS["rows"][1][0][0],
        kernels.module.KERNELS["resets"][1][0][0] // len(states),
    )


def _modes(entries: Sequence[Mapping[str, Any]]) -> tuple[ModeShape, ...]:
    shapes, first = [], 0
    for entry in entries:
        count = entry["length"] * (2 if entry["oscillates"] else 1)
        places = tuple(range(first, first + count))
        shapes.append(ModeShape(entry["length"], entry["oscillates"], places))
        first += count
    return tuple(shapes)


def system_parameters(kernels: SystemKernels, given: Mapping[str, object]) -> dict[str, Value]:
    """All parameters of a system, checked, in its order.

    Raises
    ------
    InputError
        For an unknown or missing name, a value outside its domain, or values that break a
        constraint.
    """
    tables = {p.name: p for p in kernels.parameters}
    _check_names(kernels, given)
    values = {name: value_of(table, given[name]) for name, table in tables.items()}
    for constraint in kernels.table["constraints"]:
        terms = [(factor, values[name]) for name, factor in constraint["terms"].items()]
        if all(value.exact is not None for _, value in terms):
            total = float(sum(Fraction(f) * v.exact for f, v in terms if v.exact is not None))
        else:
            total = sum(factor * float(value) for factor, value in terms)
        if total < 0:
            told = ", ".join(f"{name} = {values[name]}" for name in constraint["terms"])
            raise InputError(f"{told}: {constraint['text']} does not hold")
    return values


def piecewise(system: str | SystemKernels, parameters: Mapping[str, object]) -> PiecewiseLinear:
    """A system at one parameter point, in double precision.

    Parameters
    ----------
    system : str or SystemKernels
    parameters : mapping of str to str, number or Value
        All physical parameters of the system.

    Raises
    ------
    InputError
        As for `system_parameters` and `structure_of`.
    """
    kernels = load_system(system) if isinstance(system, str) else system
    values = system_parameters(kernels, parameters)
    found = piecewise_at(kernels, np.array([float(value) for value in values.values()]))
    return replace(found, parameters=values)


def piecewise_at(kernels: SystemKernels, point: np.ndarray) -> PiecewiseLinear:
    """A system at a checked parameter point (p,), in double precision."""
    values = {p.name: as_value(x) for p, x in zip(kernels.parameters, point.tolist(), strict=True)}
    fields, rows, resets, exponents, flows = _evaluated(kernels, point[None])
    return _record(
        structure_of(kernels),
        values,
        fields[0],
        rows[0],
        resets[0],
        list(exponents[0]),
        list(flows[0]),
    )


def parameter_points(
    kernels: SystemKernels, parameters: Mapping[str, Any]
) -> tuple[np.ndarray, tuple[int, ...]]:
    """Points (n, p) of parameters that broadcast against each other, and their common shape.

    A point outside a domain, or one that breaks a constraint, is NaN.

    Raises
    ------
    InputError
        For an unknown or missing name, or arrays that do not fit.
    """
    tables = {p.name: p for p in kernels.parameters}
    _check_names(kernels, parameters)
    arrays = []
    for name, table in tables.items():
        given = parameters[name]
        if isinstance(given, str | Value):
            given = float(value_of(table, given))
        try:
            array = np.asarray(given, dtype=float)
        except (TypeError, ValueError):
            raise InputError(f"parameter {name} is no array of real numbers") from None
        arrays.append(np.where(in_domains(table, array), array, np.nan))
    try:
        joined = np.broadcast_arrays(*arrays)
    except ValueError:
        shapes = ", ".join(f"{n} {a.shape}" for n, a in zip(tables, arrays, strict=True))
        raise InputError(f"the parameters do not broadcast: {shapes}") from None
    points = np.stack([array.ravel() for array in joined], axis=-1)
    names = list(tables)
    for constraint in kernels.table["constraints"]:
        total = sum(f * points[:, names.index(n)] for n, f in constraint["terms"].items())
        points[np.asarray(total) < 0] = np.nan
    return points, joined[0].shape


def numbers_at(kernels: SystemKernels, points: np.ndarray) -> np.ndarray:
    """Fields, rows, resets, exponents and flows at points (n, p), flat: (n, size)."""
    parts = _evaluated(kernels, points)
    return np.concatenate([p.reshape(len(points), p.shape[1] * p.shape[2]) for p in parts], axis=1)


def piecewise_in(
    system: str | SystemKernels, parameters: Mapping[str, object], lib: Any
) -> PiecewiseLinear:
    """A system at one parameter point in another arithmetic, Mpmath or Balls.

    Entries are that arithmetic's numbers, or integers, in arrays of objects.

    Raises
    ------
    InputError
        As for `piecewise`.
    """
    kernels = load_system(system) if isinstance(system, str) else system
    structure = structure_of(kernels)
    values = system_parameters(kernels, parameters)
    numbers = {name: lib.number(value) for name, value in values.items()}
    point = list(numbers.values())
    spectrum, _ = kernels.source("spectrum")(
        [numbers[name] for name in kernels.table["spectrum_parameters"]], lib=lib
    )
    parts = [
        _objects(kernels.source(kernel)(point, lib=lib)) for kernel in ("fields", "rows", "resets")
    ]
    exponents, flows = (
        _objects(part) for part in kernels.source("modes")(point, spectrum, lib=lib)
    )
    fields, rows, resets = parts
    return _record(structure, values, fields, rows, resets, list(exponents), list(flows))


def _check_names(kernels: SystemKernels, given: Iterable[str]) -> None:
    names = [p.name for p in kernels.parameters]
    for name in given:
        if name not in names:
            raise unknown_name("parameter", str(name), names)
    missing = [name for name in names if name not in given]
    if missing:
        raise InputError(f"{kernels.name} needs a value for: {', '.join(missing)}")


def _evaluated(kernels: SystemKernels, points: np.ndarray) -> tuple[np.ndarray, ...]:
    """Fields, rows, resets, exponents, flows at points (n, p), each (n, rows, columns)."""
    names = [p.name for p in kernels.parameters]
    places = [names.index(name) for name in kernels.table["spectrum_parameters"]]
    spectrum, _ = kernels.evaluate("spectrum", points[:, places])
    exponents, flows = kernels.evaluate("modes", points, spectrum)
    parts = [kernels.evaluate(kernel, points) for kernel in ("fields", "rows", "resets")]
    return (*parts, exponents, flows)


def _objects(rows: Sequence[Sequence[Any]]) -> np.ndarray:
    array = np.empty((len(rows), len(rows[0])), dtype=object)
    for i, row in enumerate(rows):
        array[i, :] = row
    return array


def _record(
    structure: Structure,
    values: dict[str, Value],
    fields: np.ndarray,
    rows: np.ndarray,
    resets: np.ndarray,
    exponents: list[Any],
    flows: list[Any],
) -> PiecewiseLinear:
    """Cut stacked arrays into configurations."""
    size = len(structure.states)
    counts = [len(modes) for modes in structure.modes]
    ends = np.cumsum([0, *counts])
    stops = np.cumsum([0, *structure.functions]) * size
    return PiecewiseLinear(
        structure,
        values,
        fields.reshape(-1, size, size + 1),
        rows,
        resets.reshape(-1, size, size + 1),
        tuple(np.array(exponents[a:b]) for a, b in pairwise(ends)),
        tuple(np.array(flows[a:b]).reshape(-1, size, size + 1) for a, b in pairwise(stops)),
    )

"""Completion of many parameter points at once: arrays that broadcast, with what follows from them.

What is given, what follows and what stays open is as for one point: see
`nonsmooth.runtime.model.completion`.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError, unknown_name
from nonsmooth.runtime.core.values import Value, as_value
from nonsmooth.runtime.model.completion import Terms, check_names, default_parameters, followers
from nonsmooth.runtime.model.kernels import OrbitKernels, SystemKernels
from nonsmooth.runtime.model.parameters import (
    constrained,
    in_domains,
    value_of,
)

__all__ = [
    "Batch",
    "complete_arrays",
    "complete_batch",
    "parameter_array",
    "parameter_points",
]


@dataclass(frozen=True, eq=False)
class Batch:
    """How the parameters of many points are completed."""

    kernels: OrbitKernels
    known: tuple[str, ...]  # parameters that need values
    opened: tuple[str, ...]  # open parameters that have values or follow
    # parameters that follow, each with the factors of the known ones whose sum it is
    completed: dict[str, Terms]

    def complete(self, values: Mapping[str, np.ndarray]) -> dict[str, np.ndarray]:
        """Arrays of all parameters of the equations, and of open ones, from those that are known.

        The arrays broadcast. A point at which another parameter is outside its domain is NaN.
        """
        found, own = dict(values), self.kernels.parameter_names
        for name, terms in self.completed.items():
            parts = (float(factor) * found[term] for term, factor in terms.items())
            found[name] = np.asarray(sum(parts))
        for name in [name for name in found if name not in own]:
            inside = in_domains(self.kernels.tables[name], found[name])
            if not inside.all():
                found[own[0]] = np.where(inside, found[own[0]], np.nan)
        return {name: found[name] for name in (*own, *self.opened)}


def complete_batch(kernels: OrbitKernels, given: Iterable[str]) -> Batch:
    """Which parameters of many points are given, follow, or stay open.

    `given` has the names of those that are fixed or swept. Raises `InputError` for a name that
    fixes nothing, or names that fix one parameter twice.
    """
    given, tables, own = list(given), kernels.tables, kernels.parameter_names
    opened = [table.name for table in kernels.open_parameters]
    relations = {name: terms for name, terms in kernels.combined.items() if name in own}
    replacing = [t for terms in relations.values() for t in terms if t not in opened]
    for name in given:
        if name not in tables:
            raise unknown_name("parameter", str(name), [*own, *opened, *replacing])
    for name, terms in relations.items():
        if {name, *terms} <= set(given):
            raise InputError(f"{name} follows from {' and '.join(terms)}: leave one of them out")
    completed = {n: terms for n, terms in followers(kernels, given).items() if n in own}
    following = followers(kernels, {*given, *own})
    completed |= {n: terms for n, terms in following.items() if n in opened}
    used = {*own, *opened, *(term for terms in completed.values() for term in terms)}
    for name in given:
        if name not in used:
            raise InputError(f"{name} decides nothing about {kernels.name}: leave it out")
    defaults = default_parameters(kernels)
    saved = [n for n in opened if n in defaults and n not in given and n not in completed]
    known = [name for name in own if name not in completed]
    known += [*(name for name in given if name not in own), *saved]
    told = [name for name in opened if name in known or name in completed]
    return Batch(kernels, tuple(known), tuple(told), completed)


def complete_arrays(kernels: OrbitKernels, given: Mapping[str, Any]) -> dict[str, np.ndarray]:
    """Arrays of parameters for a batch: the given ones, and the rest from the reference point.

    Given are parameters of the equations or the physical ones in their place; returned are
    those of the equations, then open ones as far as they are given. Values outside a domain
    stay: their points get a status of their own. Raises `InputError` as `complete_batch` does,
    for a missing name, and for anything but arrays of real numbers.
    """
    batch, defaults = complete_batch(kernels, given), default_parameters(kernels)
    found = {}
    for name in batch.known:
        value = given.get(name, defaults.get(name))
        if value is None:
            raise InputError(f"{kernels.name} needs a value for: {name}")
        found[name] = parameter_array(name, value)
    try:
        return batch.complete(found)
    except ValueError as error:
        raise InputError(f"the parameter arrays do not broadcast: {error}") from None


def parameter_array(name: str, given: Any) -> np.ndarray:
    """A parameter's values at many points, or the one that they share, as an array of floats.

    Raises `InputError` unless they are real numbers.
    """
    try:
        array = np.asarray(float(as_value(given)) if isinstance(given, str | Value) else given)
        if array.dtype.kind in "bcmM":
            raise TypeError(f"{array.dtype} is no type of real numbers")
        return array.astype(float)
    except (TypeError, ValueError) as error:
        raise InputError(f"parameter {name}: {error}") from None


def parameter_points(
    kernels: SystemKernels, parameters: Mapping[str, Any]
) -> tuple[np.ndarray, tuple[int, ...]]:
    """Points (n, p) of all parameters of a system, broadcast together, and their common shape.

    Columns are in the system's order. A point outside a domain, or one that breaks a constraint,
    is NaN. Raises `InputError` for an unknown or missing name, or arrays that do not broadcast.
    """
    tables = {p.name: p for p in kernels.parameters}
    check_names(kernels, parameters)
    arrays = {}
    for name, table in tables.items():
        given = parameters[name]
        if isinstance(given, str | Value):
            given = float(value_of(table, given))
        array = parameter_array(name, given)
        arrays[name] = np.where(in_domains(table, array), array, np.nan)
    if not arrays:  # a declaration in numbers alone
        return np.empty((1, 0)), ()
    try:
        shape = np.broadcast_shapes(*(array.shape for array in arrays.values()))
    except ValueError:
        shapes = ", ".join(f"{name} {array.shape}" for name, array in arrays.items())
        raise InputError(f"the parameters do not broadcast: {shapes}") from None
    joined = [np.broadcast_to(array, shape) for array in arrays.values()]
    points = np.stack([array.ravel() for array in joined], axis=-1)
    columns = dict(zip(tables, points.T, strict=True))
    points[~constrained(kernels, columns)] = np.nan
    return points, shape

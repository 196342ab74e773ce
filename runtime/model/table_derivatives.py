"""Derivatives of a system's fields, rows and resets by its parameters."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import chain
from typing import Any, NamedTuple

import numpy as np

from nonsmooth.runtime.core.arithmetic import FLOATS, Mpmath
from nonsmooth.runtime.core.complex_steps import imaginary_parts, stepped
from nonsmooth.runtime.model.kernels import SystemKernels
from nonsmooth.runtime.model.piecewise import tables_at

__all__ = [
    "TableRates",
    "relative_rates",
    "stepped_tables",
    "table_rates",
]


def relative_rates(
    numbers: Sequence[np.ndarray], changes: Sequence[np.ndarray], sizes: np.ndarray
) -> np.ndarray:
    """Largest relative change (q,) of functions of a state, such as boundaries, by q parameters.

    So a parameter that is zero has a size too: the one that changes a function by that
    function's size. `numbers` are functions (..., N + 1), such as fields and rows, `changes` their
    derivatives (q, ..., N + 1), and `sizes` (N,) those of the states.
    """
    state = np.append(sizes, 1.0)
    found = []
    for number, change in zip(numbers, changes, strict=True):
        size = (np.abs(number) @ state).ravel()
        moved = (np.abs(change) @ state).reshape(len(change), -1)
        found.append(moved[:, size > 0] / size[size > 0])
    return np.asarray(np.concatenate(found, axis=1).max(axis=1, initial=0.0))


class TableRates(NamedTuple):
    """The entries of the tables that some parameters change, at k points."""

    directions: np.ndarray  # (m,) of int, index of the parameter
    entries: np.ndarray  # (m,) of int, index of the entry, through fields, rows and resets
    values: np.ndarray  # (k, m), derivative of the entry by the parameter


def table_rates(kernels: SystemKernels, points: np.ndarray, places: Sequence[int]) -> TableRates:
    """Nonzero derivatives of fields, rows and resets by some parameters, at points (k, p).

    Points are in the system's order, and `places` are the parameters' indices there. One
    parameter after the other becomes complex, and so do the entries that depend on it.

    Examples
    --------
    >>> from nonsmooth.runtime.model.kernels import load_system
    >>> kernels = load_system("rigid-stop")  # parameters m1, m2, k1, k2, r
    >>> found = table_rates(kernels, np.array([[1.0, 2.0, 1.0, 5.0, 0.5]]), [4])
    >>> found.values  # the restitution stands in one reset
    array([[-1.]])
    """
    columns = list(np.array(points.T, dtype=float, order="C"))
    directions, entries, values = [], [], [np.empty((0, len(points)))]
    for direction, place in enumerate(places):
        moved = [stepped(x, 1, None) if k == place else x
                 for k, x in enumerate(columns)]  # fmt: skip
        first = 0
        for kernel in ("fields", "rows", "resets"):
            with np.errstate(all="ignore"):  # who takes them looks whether they are finite
                found = list(chain.from_iterable(kernels.source(kernel)(moved, lib=FLOATS)))
            for entry, value in enumerate(found):
                if np.iscomplexobj(value):
                    directions.append(direction)
                    entries.append(first + entry)
                    values.append(imaginary_parts(value, None)[None])
            first += len(found)
    return TableRates(
        np.array(directions, dtype=int),
        np.array(entries, dtype=int),
        np.ascontiguousarray(np.concatenate(values).T),
    )


def stepped_tables(
    kernels: SystemKernels, points: np.ndarray, steps: np.ndarray, lib: Mpmath | None
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Fields, rows and resets (k q, ...) at points (k, p), each with q steps (q, p).

    Points are in the system's order. `lib` is None in double precision; an `Mpmath` works with
    twice the digits that derivatives need.

    Examples
    --------
    >>> from nonsmooth.runtime.model.kernels import load_system
    >>> kernels = load_system("rigid-stop")  # parameters m1, m2, k1, k2, r
    >>> point = np.array([[1.0, 2.0, 1.0, 5.0, 0.5]])
    >>> _, _, resets = stepped_tables(kernels, point, np.eye(5)[[4]], None)
    >>> float(imaginary_parts(resets, None).min())  # by the restitution: v1 = -r v1 in front
    -1.0
    """
    every = stepped(points[:, None], steps, lib).reshape(len(points) * len(steps), len(points.T))
    if lib is None:
        return tables_at(kernels, every)
    parts: list[list[Any]] = [[], [], []]
    size = len(kernels.table["states"])
    for row in every:
        for part, kernel in zip(parts, ("fields", "rows", "resets"), strict=True):
            found = kernels.source(kernel)(row.tolist(), lib=lib)
            part.append([[lib.mp.convert(x) for x in line] for line in found])
    shapes = [(-1, size, size + 1), (-1, size + 1), (-1, size, size + 1)]
    fields, rows, resets = (
        np.array(part, dtype=object).reshape(len(every), *shape)
        for part, shape in zip(parts, shapes, strict=True)
    )
    return fields, rows, resets

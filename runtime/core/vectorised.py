"""Generalized ufuncs of any-arithmetic kernels, where there are no compiled ones."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from nonsmooth.runtime.core.arithmetic import FLOATS

__all__ = ["vectorised", "with_entries"]


def vectorised(
    function: Callable[..., Any], inputs: list[tuple[int, ...]], outputs: list[tuple[int, ...]]
) -> Callable[..., Any]:
    """The generalized ufunc of an any-arithmetic kernel, on NumPy.

    Parameters
    ----------
    function : callable
        Takes its arrays as sequences, and ``lib``; one result, or a tuple of them.
    inputs, outputs : list of tuple of int
        Shapes of the arguments and of the results, without the leading axes.

    Returns
    -------
    callable
        Takes arrays (..., shape) of floats that broadcast over the leading axes. It raises
        ValueError for an argument of another shape.
    """

    def call(*arrays: Any) -> Any:
        unpacked = []
        for array, shape in zip(arrays, inputs, strict=True):
            array = np.asarray(array, dtype=float)
            if array.shape[array.ndim - len(shape) :] != tuple(shape):
                raise ValueError(f"an argument of shape {array.shape} does not end in {shape}")
            unpacked.append(np.moveaxis(array, range(-len(shape), 0), range(len(shape))))
        lead = np.broadcast_shapes(
            *(a.shape[len(shape) :] for a, shape in zip(unpacked, inputs, strict=True))
        )
        found = function(*unpacked, lib=FLOATS)
        results = []
        for value, shape in zip(found if len(outputs) > 1 else (found,), outputs, strict=True):
            flat = [value] if not shape else list(value)
            if len(shape) == 2:
                flat = [entry for row in flat for entry in row]
            varying = [place for place, entry in enumerate(flat) if isinstance(entry, np.ndarray)]
            filled = np.empty((*lead, len(flat)))
            filled[...] = [0.0 if isinstance(entry, np.ndarray) else entry for entry in flat]
            for place in varying:
                filled[..., place] = flat[place]
            results.append(filled.reshape((*lead, *shape)))
        return tuple(results) if len(results) > 1 else results[0][()]

    return call


def with_entries(compiled: Callable[..., Any], inputs: list[tuple[int, ...]]) -> Callable[..., Any]:
    """A compiled kernel that takes all arguments, those without entries too.

    Parameters
    ----------
    compiled : callable
        The generalized ufunc: of the arguments that have entries.
    inputs : list of tuple of int
        Shapes of all arguments, without the leading axes.

    Returns
    -------
    callable
        Takes arrays (..., shape) of floats, as `vectorised`.
    """
    if all(all(shape) for shape in inputs):
        return compiled

    def call(*arrays: Any) -> Any:
        return compiled(*(a for a, shape in zip(arrays, inputs, strict=True) if all(shape)))

    return call

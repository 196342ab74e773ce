"""Generalized ufuncs of any-arithmetic kernels, where there are no compiled ones."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from itertools import chain
from typing import Any

import numpy as np

from nonsmooth.runtime.core.arithmetic import FLOATS


def vectorised(
    function: Callable[..., Any], inputs: list[tuple[int, ...]], outputs: list[tuple[int, ...]]
) -> Callable[..., Any]:
    """The generalized ufunc, on NumPy, of a kernel over any arithmetic.

    The kernel takes its arrays as sequences, and ``lib``, and gives one result or a tuple of
    them. `inputs` and `outputs` are the shapes of arguments and results without the leading
    axes. The ufunc takes arrays (..., shape) of floats or complex numbers that broadcast over
    the leading axes; an argument of another shape raises ValueError.
    """

    def call(*arrays: Any) -> Any:
        unpacked = []
        for array, shape in zip(arrays, inputs, strict=True):
            array = np.asarray(array)
            array = array.astype(complex if array.dtype.kind == "c" else float, copy=False)
            if array.shape[array.ndim - len(shape) :] != tuple(shape):
                raise ValueError(f"an argument of shape {array.shape} does not end in {shape}")
            axes, own = range(array.ndim), array.ndim - len(shape)
            unpacked.append(array.transpose(*axes[own:], *axes[:own]))
        lead = np.broadcast_shapes(
            *(a.shape[len(shape) :] for a, shape in zip(unpacked, inputs, strict=True))
        )
        dtype = complex if any(array.dtype.kind == "c" for array in unpacked) else float
        results = []
        known = patterns()
        every = listed(unpacked) if any(varying for _, varying in known) else [[]] * len(known)
        for entries, shape, (constants, varying) in zip(every, outputs, known, strict=True):
            filled = np.empty((*lead, len(constants)), dtype)
            filled[...] = constants
            for place in varying:
                filled[..., place] = entries[place]
            results.append(filled.reshape((*lead, *shape)))
        return tuple(results) if len(results) > 1 else results[0][()]

    def listed(arrays: list[np.ndarray]) -> list[list[Any]]:
        """The entries of each result, as one flat list."""
        found = function(*arrays, lib=FLOATS)
        results = found if len(outputs) > 1 else (found,)
        return [
            list(chain.from_iterable(result)) if len(shape) == 2 else list(result) if shape
            else [result]
            for result, shape in zip(results, outputs, strict=True)
        ]  # fmt: skip

    @cache
    def patterns() -> list[tuple[np.ndarray, list[int]]]:
        """For each result the entries that are the same at all points, and the places that vary."""
        entries = listed([np.ones((*shape, 1)) for shape in inputs])
        varying = [[k for k, x in enumerate(e) if isinstance(x, np.ndarray)] for e in entries]
        constants = [
            np.array([0.0 if isinstance(x, np.ndarray) else float(x) for x in e]) for e in entries
        ]
        return list(zip(constants, varying, strict=True))

    return call


def filled(
    compiled: Callable[..., Any], inputs: list[tuple[int, ...]], outputs: list[tuple[int, ...]]
) -> Callable[..., Any]:
    """A compiled kernel that takes and gives all arrays, also those without entries.

    `compiled` is the generalized ufunc of the arrays that have entries; `inputs` and `outputs`
    are the shapes of all, without the leading axes. Arrays of floats are taken as by
    `vectorised`.
    """
    if all(map(all, (*inputs, *outputs))):
        return compiled

    def call(*arrays: Any) -> Any:
        taken = [(np.asarray(a), s) for a, s in zip(arrays, inputs, strict=True)]
        lead = np.broadcast_shapes(*(a.shape[: a.ndim - len(s)] for a, s in taken))
        values = compiled(*(a for a, shape in taken if all(shape)))
        given = iter(values if isinstance(values, tuple) else (values,))
        results = tuple(next(given) if all(s) else np.empty((*lead, *s)) for s in outputs)
        return results if len(results) > 1 else results[0]

    return call

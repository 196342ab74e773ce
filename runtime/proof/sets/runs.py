"""What is said of each box of a grid, in files: runs of one number, and how often it follows."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated, Any

import numpy as np
from numpy.typing import NDArray

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.json_codec import by

_MOST = 10**8  # boxes of a grid


def _runs(values: NDArray[Any]) -> list[tuple[int, int]]:
    """Runs of an array (B,) of integers or booleans."""
    if not values.size:
        return []
    starts = np.flatnonzero(np.r_[True, values[1:] != values[:-1]])
    lengths = np.diff(np.r_[starts, values.size])
    return [(int(values[k]), int(n)) for k, n in zip(starts, lengths, strict=True)]


def _numbers(told: Sequence[tuple[int, int]]) -> NDArray[np.int_]:
    """The array of which `told` are the runs; `InputError` if it is too long."""
    if any(n < 1 for _, n in told) or sum(n for _, n in told) > _MOST:
        raise InputError("it is of no number of boxes, or of too many")
    return np.repeat(np.array([x for x, _ in told], dtype=int), [n for _, n in told])


_RUN = tuple[tuple[int, int], ...]
Numbers = Annotated[NDArray[np.int_], by(_RUN, _runs, _numbers)]
Flags = Annotated[NDArray[np.bool_], by(_RUN, _runs, lambda told: _numbers(told) != 0)]


def check_size(values: NDArray[Any], size: int) -> None:
    """Raise `InputError` if an array is not of so many boxes."""
    if len(values) != size:
        raise InputError("a grid has another number of boxes than is told of")

"""The start that fits given dwell times best: where Newton's method begins."""

from __future__ import annotations

from typing import Any

import numpy as np

from nonsmooth.runtime.shooting.newton import LEAST
from nonsmooth.runtime.shooting.shooting_map import ItineraryShape, numbers_in, shoot

__all__ = ["fitting_start", "least_squares"]

_ANGLES = 48  # of a forcing, tried for a start


def fitting_start(cycle: ItineraryShape, flat: np.ndarray, dwell: np.ndarray) -> np.ndarray:
    """The start (n, N) that fits given dwell times (n, p) best, by least squares.

    Closure and switching conditions are linear in the start. A forcing has some angle at the
    start: several are tried, and the best fit is kept. `flat` (n, size) has the numbers of each
    point, as `numbers_at` gives them; times are in the system's unit.
    """
    size = len(cycle.structure.states)
    numbers = numbers_in(cycle.structure, flat)
    # differences of affine functions are their coefficients
    passages = [
        shoot(cycle, numbers, dwell, np.broadcast_to(start, (len(flat), size)), np)
        for start in (np.zeros(size), *np.eye(size))
    ]
    missed = [
        np.concatenate([np.moveaxis(p.residual, 0, -1), p.starts[0] - p.starts[-1]], axis=-1)
        for p in passages
    ]
    matrix = np.stack([m - missed[0] for m in missed[1:]], axis=-1)
    forcing = cycle.structure.forcing
    if forcing:
        rates = np.stack([np.moveaxis(p.speeds, 0, -1) for p in passages], axis=-1)
        rates[..., 1:] -= rates[..., :1]
        turns = np.abs(numbers.fields[:, 0][:, [s for _, s in forcing], [c for c, _ in forcing]])
        return _fitting_forced(matrix, -missed[0], rates, forcing, turns)
    # in no units: equations in those of their largest term, unknowns of their coefficients
    unit = np.concatenate([np.zeros((len(cycle), size)), np.eye(size)])
    rows = (np.abs(matrix - unit) + unit).max(axis=-1, keepdims=True)
    matrix = matrix / np.where(rows > 0, rows, 1)
    columns = np.abs(matrix).max(axis=-2)
    columns = np.where(columns > 0, columns, 1)
    right = -missed[0] / np.where(rows > 0, rows, 1)[..., 0]
    start, _ = least_squares(matrix / columns[..., None, :], right)
    return start / columns


def _fitting_forced(
    matrix: np.ndarray, right: np.ndarray, rates: np.ndarray, forcing: Any, turns: np.ndarray
) -> np.ndarray:
    """The best start over the time that has passed since all forcings were at c = 1, s = 0.

    Of two that fit equally well, such as mirror images, the one that reaches its boundaries
    from inside is taken: there their `rates`, affine in the start, are positive.
    """
    count, _, size = matrix.shape
    known = [state for pair in forcing for state in pair]
    free = [k for k in range(size) if k not in known]
    best, least = np.full((count, size), np.nan), np.full(count, np.inf)
    for part in np.arange(_ANGLES) / _ANGLES:
        start = np.zeros((count, size))
        for place, (cosine, sine) in enumerate(forcing):
            angle = 2 * np.pi * part * turns[:, place] / turns.min(axis=1)
            start[:, cosine], start[:, sine] = np.cos(angle), np.sin(angle)
        rest = right - np.einsum("nij,nj->ni", matrix, start)
        scale = np.abs(matrix[..., free]).max(axis=(-2, -1), keepdims=True)
        found, _ = least_squares(matrix[..., free] / scale, rest / scale[..., 0])
        start[:, free] = found
        missed = np.einsum("nij,nj->ni", matrix, start) - right
        reached = np.einsum("npj,nj->np", rates[..., 1:], start) + rates[..., 0]
        error = np.abs(missed).max(axis=-1) * np.where((reached > 0).all(axis=-1), 1, 1e3)
        better = error < least
        best[better], least[better] = start[better], error[better]
    return best


def least_squares(matrix: np.ndarray, right: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Shortest least-squares solutions (n, k), and the smallest singular values (n,).

    Matrices are (n, m, k), right-hand sides (n, m). Singular values are relative to the largest.
    Both are NaN where something is not finite.
    """
    count, _, size = matrix.shape
    solution, least = np.full((count, size), np.nan), np.full(count, np.nan)
    sound = np.isfinite(matrix).all(axis=(-2, -1)) & np.isfinite(right).all(axis=-1)
    if sound.any():
        left, values, rest = np.linalg.svd(matrix[sound], full_matrices=False)
        kept = values > LEAST * values[:, :1]
        inverse = np.where(kept, 1 / np.where(kept, values, 1), 0)
        parts = inverse * np.einsum("nij,ni->nj", left, right[sound])
        solution[sound] = np.einsum("nji,nj->ni", rest, parts)
        least[sound] = np.nan_to_num(values[:, -1] / values[:, 0])
    return solution, least

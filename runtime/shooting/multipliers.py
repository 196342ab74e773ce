"""Multipliers: the eigenvalues of a Poincare map's Jacobian."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from nonsmooth.runtime.core.matrices import sorted_by_size
from nonsmooth.runtime.shooting.newton import LEAST

__all__ = ["Multiplier", "Stability", "family_margins", "margins", "reciprocal_pair"]

_ROUNDING = 1e-12  # of multipliers: nearer to the unit circle nothing is told


@dataclass(frozen=True)
class Multiplier:
    """Eigenvalue of the Poincare map's Jacobian.

    `trivial` marks a 1 that a first integral enforces.
    """

    real: Any
    imaginary: Any
    trivial: bool = False


@dataclass(frozen=True)
class Stability:
    """Multipliers and verdict.

    Attributes
    ----------
    multipliers : tuple of Multiplier
        Of the map on the section where the orbit starts, by decreasing absolute value; those
        that are zero because the orbit passes a smaller section are exact.
    trace : number
        Of the same Jacobian.
    rank : int
        No more multipliers differ from zero, because the map passes through a section of
        that dimension; with rank one ``|trace| < 1`` decides.
    margin : number
        1 less the largest absolute value of a nontrivial multiplier, ``1 - |trace|`` for rank
        one; 0 where the verdict is "neutral".
    verdict : {"stable", "neutral", "unstable", "undecided"}
        "stable" is the paper's "conditionally stable": with respect to perturbations that
        keep the sequence of switches. "neutral": a conservative orbit whose nontrivial
        multipliers lie on the unit circle. Undecided if the margin is within its own error,
        or if a phase reaches the boundary that ends it with no speed beyond its error.
    one_sided : str
        On which side derivatives are taken, as "ta > 0", where the orbit is a border
        collision; else empty.
    """

    multipliers: tuple[Multiplier, ...]
    trace: Any
    rank: int
    margin: Any
    verdict: str
    one_sided: str = ""

    @property
    def rank_one(self) -> bool:
        """Whether the trace alone decides."""
        return self.rank == 1


def reciprocal_pair(trace: Any, root: Callable[[Any], Any]) -> list[Multiplier]:
    """Multipliers mu, 1/mu and a trivial 1, from their sum, whose digits they have.

    `root` is the square root of the trace's arithmetic.
    """
    one, zero = 0 * trace + 1, 0 * abs(trace)
    half = (trace - 1) / 2
    if abs(half) <= 1:
        height = root((1 - half) * (1 + half))
        pair = [Multiplier(half, height), Multiplier(half, -height)]
    else:
        # the larger one first: the smaller is its reciprocal, without cancellation
        larger = half + (1 if half > 0 else -1) * root((half - 1) * (half + 1))
        pair = [Multiplier(larger, zero), Multiplier(1 / larger, zero)]
    return [*pair, Multiplier(one, zero, trivial=True)]


def _pair_margins(trace: np.ndarray) -> np.ndarray:
    """1 - |mu| (n,) of the larger one of each reciprocal pair beside a 1; 0 on the unit circle."""
    half = np.abs(trace - 1) / 2
    root = np.sqrt(np.maximum((half - 1) * (half + 1), 0))
    return np.where(half <= 1, 0.0, 1 - (half + root))


def margins(maps: np.ndarray, trace: np.ndarray, rank: int, *, family: bool) -> np.ndarray:
    """Return 1 less the largest nontrivial |multiplier| (n,) of orbits with section maps (n, k, k).

    One multiplier of each orbit of a family is 1; there the margin is 0 where the others lie on
    the unit circle. No more than `rank` multipliers differ from zero. The margin is NaN where
    a map is not finite.
    """
    found = np.full(len(maps), np.nan)
    sound = np.isfinite(maps).all(axis=(-2, -1))
    if family:
        found[sound] = family_margins(np.linalg.eigvals(maps[sound]), trace[sound], rank)
    else:
        found[sound] = 1 - _largest_sizes(maps[sound])
    return np.where(np.abs(found) <= _ROUNDING, 0.0, found)


def _largest_sizes(matrices: np.ndarray) -> np.ndarray:
    """Return the largest absolute eigenvalue of each of the matrices (n, k, k)."""
    if matrices.shape[-1] != 2:
        return np.asarray(np.abs(np.linalg.eigvals(matrices)).max(axis=-1, initial=0.0))
    # in closed form, far quicker: no difference of large numbers but in the discriminant
    (a, b), (c, d) = np.moveaxis(matrices, 0, -1)
    mean, discriminant = (a + d) / 2, ((a - d) / 2) ** 2 + b * c
    real = np.abs(mean) + np.sqrt(np.maximum(discriminant, 0))
    turning = np.sqrt(mean**2 + np.abs(discriminant))
    return np.asarray(np.where(discriminant < 0, turning, real))


def family_margins(values: np.ndarray, trace: np.ndarray, rank: int) -> np.ndarray:
    """Return margins of orbits one of whose multipliers (n, k) is 1; 0 where neutral."""
    values = sorted_by_size(values)
    trivial = np.argmin(np.abs(values - 1), axis=-1)[:, None]
    rest = np.abs(values)
    np.put_along_axis(rest, trivial, 0.0, axis=-1)
    margin = 1 - rest.max(axis=-1)
    margin[np.abs(margin) <= np.sqrt(LEAST)] = 0  # a neutral one may be a defective one
    if rank != 3:
        return np.asarray(margin)
    # of a reciprocal pair beside the 1 the sum keeps the digits
    pair = np.abs(values[:, :3].prod(axis=-1) - 1) < np.sqrt(LEAST)
    return np.where(pair, _pair_margins(trace), margin)

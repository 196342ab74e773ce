"""Multipliers in pairs: trace and determinant of each, which have derivatives where they meet.

Of an invariant plane with bases V and U of it and of that of the transposed map the map on it is
(UᵀV)⁻¹UᵀAV, and its eigenvalues change as those of (UᵀV)⁻¹Uᵀ(dA)V are added to it (G. W. Stewart
and J. Sun, Matrix Perturbation Theory, 1990, chapter V). It has derivatives as long as the two
are apart from all other multipliers, however near they are to each other.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

if TYPE_CHECKING:
    from nonsmooth.runtime.orbits.derivatives import OrbitDerivatives
    from nonsmooth.runtime.shooting.multipliers import MultiplierDerivatives

__all__ = ["MultiplierGroup", "multiplier_groups"]

_REAL = 1e-12  # of the largest: imaginary part of a real eigenvalue


class MultiplierGroup(NamedTuple):
    """A multiplier alone, or two of them."""

    size: int  # 1 or 2
    trace: float  # sum
    trace_rates: np.ndarray  # (q,)
    determinant: float  # product
    determinant_rates: np.ndarray  # (q,)


def multiplier_groups(derivatives: OrbitDerivatives) -> tuple[MultiplierGroup, ...]:
    """Nontrivial multipliers in pairs, and one alone where their number is odd.

    Conjugate ones are a pair, and real ones next to each other, so that a pair remains the
    same where two multipliers meet and leave the real axis.
    """
    found, section = derivatives.section, derivatives.directions.section
    count = section.rank - section.trivial
    if count > 2:
        return _split(section.matrix.astype(float), section.rates.astype(float), count, found)
    if not count:
        return ()
    # a trivial multiplier is 1: it adds to the trace and not to the product
    return (
        MultiplierGroup(
            count,
            float(found.trace) - section.trivial,
            np.asarray(found.trace_rates, dtype=float),
            float(found.determinant),
            np.asarray(found.determinant_rates, dtype=float),
        ),
    )


def _split(
    matrix: np.ndarray, rates: np.ndarray, count: int, found: MultiplierDerivatives
) -> tuple[MultiplierGroup, ...]:
    wanted = np.asarray(found.multipliers).astype(complex)
    largest = float(np.abs(wanted).max())
    real = np.sort(wanted[np.abs(wanted.imag) <= _REAL * largest].real)
    pairs = [np.array([z, z.conjugate()]) for z in wanted if z.imag > _REAL * largest]
    alone = None
    if len(real) % 2:
        alone = min(range(0, len(real), 2), key=lambda k: _gaps(np.delete(real, k)))
        real, alone = np.delete(real, alone), real[alone]
    pairs += [real[k : k + 2].astype(complex) for k in range(0, len(real), 2)]
    pairs.sort(key=lambda pair: -float(np.abs(pair).max()))
    groups = pairs + ([] if alone is None else [np.array([alone], dtype=complex)])
    return tuple(_group(matrix, rates, values) for values in groups)


def _gaps(real: np.ndarray) -> float:
    return float((real[1::2] - real[::2]).sum())


def _group(matrix: np.ndarray, rates: np.ndarray, values: np.ndarray) -> MultiplierGroup:
    right, left = _plane(matrix, values), _plane(matrix.T, values)
    onto = np.linalg.solve(left.T @ right, left.T)
    own, moved = onto @ matrix @ right, onto @ rates @ right
    trace, determinant = float(np.trace(own)), float(np.linalg.det(own))
    trace_rates = np.trace(moved, axis1=-2, axis2=-1)
    if len(own) == 1:
        return MultiplierGroup(1, trace, trace_rates, determinant, trace_rates)
    cofactors = np.array([[own[1, 1], -own[0, 1]], [-own[1, 0], own[0, 0]]])
    determinant_rates = np.trace(cofactors @ moved, axis1=-2, axis2=-1)
    return MultiplierGroup(2, trace, trace_rates, determinant, determinant_rates)


def _plane(matrix: np.ndarray, values: np.ndarray) -> np.ndarray:
    """Orthonormal basis of the invariant subspace of some eigenvalues, by an ordered Schur form."""
    from scipy.linalg import schur

    every = np.linalg.eigvals(matrix)
    chosen = {int(np.abs(every - value).argmin()) for value in values}
    if len(chosen) < len(values):  # equal ones: the next nearest too
        chosen = set(np.argsort(np.abs(every - values.mean()))[: len(values)].tolist())
    others = [k for k in range(len(every)) if k not in chosen]
    inside, outside = every[sorted(chosen)], every[others]

    def ours(re: float, im: float = 0.0) -> bool:
        z = complex(re, im)
        return bool(np.abs(inside - z).min() < np.abs(outside - z).min(initial=np.inf))

    _, basis, size = schur(matrix, output="real", sort=ours)
    if size != len(values):
        raise np.linalg.LinAlgError("multipliers are not told apart")
    return np.asarray(basis[:, : len(values)])

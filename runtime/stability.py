"""Stability of an orbit: Poincare map, multipliers and the trace criterion (Secs. 4, 5)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from nonsmooth.runtime.orbit import GUARD, Orbit

__all__ = ["Multiplier", "Stability", "assess_stability"]


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
        Of the map on the section; by decreasing absolute value.
    trace : number
        Of the same Jacobian.
    rank : int
        No more multipliers differ from zero, because the map passes through a section of
        that dimension; with rank one |trace| < 1 decides.
    margin : number
        1 - the largest nontrivial |multiplier|; 1 - |trace| for rank one.
    verdict : {"stable", "unstable", "undecided"}
        "stable" is the paper's "conditionally stable": with respect to perturbations that
        keep the sequence of switches. Undecided if the margin is within its own error.
    """

    multipliers: tuple[Multiplier, ...]
    trace: Any
    rank: int
    margin: Any
    verdict: str

    @property
    def rank_one(self) -> bool:
        """Whether the trace alone decides."""
        return self.rank == 1


def assess_stability(orbit: Orbit) -> Stability:
    """Multipliers of an orbit and what they mean, to the orbit's own digits."""
    zero = orbit.arithmetic.mp.zero if orbit.precise else 0.0
    trace = orbit.evaluate("trace") if orbit.precise else float(orbit.evaluate("trace"))
    rank, dimension = orbit.kernels.table["rank"], len(orbit.kernels.table["section"])
    nonzero = [Multiplier(trace, zero)] if rank == 1 else _eigenvalues(orbit)[:rank]
    found = nonzero + [Multiplier(zero, zero)] * (dimension - len(nonzero))
    largest = max((_modulus(m, orbit) for m in found if not m.trivial), default=zero)
    margin = 1 - largest
    # what is carried beyond the digits asked for decides too
    ten = orbit.arithmetic.mp.mpf(10) if orbit.precise else 10.0
    uncertain = abs(margin) <= ten ** -(orbit.digits + (GUARD - 5 if orbit.precise else -2))
    verdict = "undecided" if uncertain else "stable" if margin > 0 else "unstable"
    return Stability(tuple(found), trace, rank, margin, verdict)


def _eigenvalues(orbit: Orbit) -> list[Multiplier]:
    matrix = orbit.evaluate("poincare_jacobian")
    if orbit.precise:
        mp = orbit.arithmetic.mp
        values = mp.eig(mp.matrix(matrix), left=False, right=False)
        found = [Multiplier(mp.re(v), mp.im(v)) for v in values]
    else:
        found = [Multiplier(float(v.real), float(v.imag)) for v in np.linalg.eigvals(matrix)]
    return sorted(found, key=lambda m: -float(_modulus(m, orbit)))


def _modulus(multiplier: Multiplier, orbit: Orbit) -> Any:
    square = multiplier.real**2 + multiplier.imaginary**2
    return orbit.arithmetic.mp.sqrt(square) if orbit.precise else float(np.sqrt(square))

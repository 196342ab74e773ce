"""Multipliers: the eigenvalues of a Poincare map's Jacobian."""

from dataclasses import dataclass
from typing import Any

__all__ = ["ROUNDING", "Multiplier", "Stability"]

ROUNDING = 1e-12  # of multipliers: nearer to the unit circle nothing is told


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

"""Multipliers: the eigenvalues of a Poincare map's Jacobian."""

from dataclasses import dataclass
from typing import Any

__all__ = ["Multiplier"]


@dataclass(frozen=True)
class Multiplier:
    """Eigenvalue of the Poincare map's Jacobian.

    `trivial` marks a 1 that a first integral enforces.
    """

    real: Any
    imaginary: Any
    trivial: bool = False

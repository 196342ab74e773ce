"""Normal forms of rational expressions, each found once: matrices repeat their entries."""

from __future__ import annotations

from functools import lru_cache

import sympy as sp

__all__ = ["cancel", "factor"]


@lru_cache(maxsize=1 << 14)
def cancel(expression: sp.Expr) -> sp.Expr:
    """Ratio of two expanded polynomials without a common factor, as SymPy gives it."""
    return expression if expression.is_Atom else sp.cancel(expression)


@lru_cache(maxsize=1 << 14)
def factor(expression: sp.Expr) -> sp.Expr:
    """Product of irreducible factors, as SymPy gives it."""
    return expression if expression.is_Atom else sp.factor(expression)

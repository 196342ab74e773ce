"""Entire functions of an eigenvalue, which never divide by it.

For z'' + lambda z = 0 every solution is built from the functions

    c_k(lambda, t) = sum_j (-lambda)^j t^(k + 2j) / (k + 2j)!,

c_0 = cos(sqrt(lambda) t), c_1 = sin(sqrt(lambda) t)/sqrt(lambda), c_2 = (1 - c_0)/lambda,
c_3 = (t - c_1)/lambda, entire in lambda: zero, negative and complex eigenvalues need no
case of their own. A function of a matrix needs their divided differences as well, which
are entire in all their nodes, equal or not.
"""

from __future__ import annotations

from typing import Any

import sympy as sp

__all__ = ["Eigenvalue", "EntireDifference", "EntirePair"]


class EntireDifference(sp.Function):
    """Divided difference c_k[l_1, ..., l_j](t), written EntireDifference(k, t, l_1, ..., l_j)."""

    @classmethod
    def eval(cls, k: Any, t: Any, *nodes: Any) -> Any:
        """Equal to a polynomial in t where every node is zero."""
        if nodes and all(node == 0 for node in nodes):
            order = len(nodes) - 1
            power = k + 2 * order
            return sp.Integer(-1) ** order * t**power / sp.factorial(power)
        return None

    def fdiff(self, argindex: int = 1) -> sp.Expr:
        """Derivative by the time (argument 2) or by one of the nodes (arguments 3, ...)."""
        k, t, *nodes = self.args
        if argindex == 2:
            if k > 0:
                return EntireDifference(k - 1, t, *nodes)
            # c_0' = -lambda c_1; Leibniz' rule for the divided difference of a product
            derivative = -nodes[-1] * EntireDifference(1, t, *nodes)
            return derivative - EntireDifference(1, t, *nodes[:-1]) if nodes[1:] else derivative
        if argindex > 2:
            return EntireDifference(k, t, *nodes, nodes[argindex - 3])
        raise sp.core.function.ArgumentIndexError(self, argindex)


class EntirePair(sp.Function):
    """Coefficients of c_k modulo powers of q(l) = (l - m)^2 - d, in real arithmetic.

    EntirePair(k, level, part, t, m, d) is the coefficient of ``(l - m)^part q^level`` in the
    expansion of c_k(l, t) in powers of q. At level 0 the parts are the mean
    (c_k(m + s) + c_k(m - s))/2 and the difference (c_k(m + s) - c_k(m - s))/(2 s) with
    s = sqrt(d), which are real and entire for d positive (real eigenvalues m +- s), zero
    (a double one) and negative (a complex pair). Higher levels are their derivatives.
    """

    nargs = 6

    def fdiff(self, argindex: int = 1) -> sp.Expr:
        """Derivative by t, m or d (arguments 4, 5, 6)."""
        k, level, part, t, m, d = self.args

        def at(shift: int, which: int, order: Any = k) -> sp.Expr:
            return EntirePair(order, level + shift, which, t, m, d)

        if argindex == 4:
            if k > 0:
                return at(0, part, k - 1)
            # multiplication by -l = -(m + (l - m)), with (l - m)^2 = q + d
            if part == 1:
                return -m * at(0, 1, 1) - at(0, 0, 1)
            below = at(-1, 1, 1) if level > 0 else sp.Integer(0)
            return -m * at(0, 0, 1) - d * at(0, 1, 1) - below
        if argindex == 5:
            if part == 1:
                return 2 * (level + 1) * at(1, 0)
            return (2 * level + 1) * at(0, 1) + 2 * (level + 1) * d * at(1, 1)
        if argindex == 6:
            return (level + 1) * at(1, part)
        raise sp.core.function.ArgumentIndexError(self, argindex)


class Eigenvalue(sp.Function):
    """One eigenvalue of a matrix without a closed form: Eigenvalue(i, n, L11, L12, ..., Lnn).

    They are counted by real, then imaginary part. The arithmetic that runs the kernel finds
    them; their derivatives follow from the characteristic polynomial.
    """

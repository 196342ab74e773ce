"""Parameters with domains, and the decisions that hold on a whole domain."""

from __future__ import annotations

from functools import cached_property, lru_cache
from keyword import iskeyword

import sympy as sp

from nonsmooth.derive.declaration.fields import declared
from nonsmooth.derive.errors import DeclarationError


def check_finite(expression: sp.Expr, where: str) -> None:
    """Refuse an expression with NaN, an infinity or the imaginary unit.

    The DeclarationError names `where` and what the expression contains.
    """
    for strange in (sp.nan, sp.oo, -sp.oo, sp.zoo, sp.I):
        if expression.has(strange):
            raise DeclarationError(f"{where} holds {strange}, which is no finite real number")


@declared
class Parameter:
    """A real parameter of a system and the interval it lives in.

    Parameters
    ----------
    name : str
        Name under which users give its value; also the name of its symbol.
    description : str
        Meaning, with units or "nondimensional".
    lower, upper : sympy expression or number
        Ends of the domain; infinite where unbounded.
    closed, upper_closed : bool
        Whether `lower` itself, and `upper` itself, belong to the domain.

    Examples
    --------
    >>> from nonsmooth.derive import Parameter
    >>> r = Parameter("r", "restitution, nondimensional", lower=0, upper=1, closed=True)
    >>> r.symbol, r.upper
    (r, 1)
    """

    name: str
    description: str
    lower: sp.Expr = 0
    upper: sp.Expr = sp.oo
    closed: bool = False
    upper_closed: bool = False

    def __post_init__(self) -> None:
        if not self.name.isidentifier() or iskeyword(self.name):
            raise DeclarationError(f"parameter name {self.name!r} is not an identifier")
        for end in (self.lower, self.upper):
            if not (end.is_number and end.is_extended_real):
                raise DeclarationError(
                    f"parameter {self.name}: the end {end} of its domain is not a real number"
                )
        if not self.lower < self.upper:
            raise DeclarationError(f"parameter {self.name}: the domain is empty")

    @cached_property
    def symbol(self) -> sp.Symbol:
        """Symbol that carries as much of the domain as SymPy's assumptions can."""
        if self.lower >= 0:
            if self.closed and self.lower == 0:
                return sp.Symbol(self.name, nonnegative=True)
            return sp.Symbol(self.name, positive=True)
        return sp.Symbol(self.name, real=True)

    def unconstrained(self) -> sp.Expr:
        """Write the parameter as a map of a positive (or nonnegative) free symbol.

        Returns
        -------
        expression
            It reaches every value of the domain.
        """
        free = sp.Symbol(f"free_{self.name}", nonnegative=True, zero=None if self.closed else False)
        lower, upper = self.lower, self.upper
        if self.upper_closed:
            return self.symbol
        if lower.is_finite and upper.is_finite:
            return (lower + upper * free) / (1 + free)
        if lower.is_finite:
            return lower + free
        if upper.is_finite:
            return upper - free
        return self.symbol


@lru_cache(maxsize=4096)  # configurations share their masses and stiffnesses
def is_positive(expression: sp.Expr, parameters: tuple[Parameter, ...]) -> bool:
    """Whether an expression is shown to be positive on the whole domain of the parameters.

    True is a proof; False means "not shown". Each parameter is replaced by a map of a
    positive symbol onto its domain, of a nonnegative one if the domain is closed; then
    either SymPy's assumptions decide, or all coefficients of numerator and denominator have
    one sign.
    """
    expression = sp.sympify(expression)
    if expression.is_positive:
        return True
    mapped = expression.subs({p.symbol: p.unconstrained() for p in parameters}, simultaneous=True)
    if mapped.is_positive:
        return True
    numerator, denominator = sp.fraction(sp.cancel(sp.together(mapped)))
    if numerator.is_positive and denominator.is_positive:
        return True
    return _one_sign(numerator) * _one_sign(denominator) > 0


def sign_of(expression: sp.Expr, parameters: tuple[Parameter, ...]) -> int | None:
    """Sign of an expression on the whole domain of the parameters; None if none is shown."""
    if expression == 0:
        return 0
    return next((sign for sign in (1, -1) if is_positive(sign * expression, parameters)), None)


def is_rational(expression: sp.Expr) -> bool:
    """Whether an expression is a rational function with rational coefficients."""
    for part in sp.fraction(sp.together(expression)):
        if not part.is_polynomial():
            return False
        symbols = part.free_symbols or {sp.Dummy()}
        if not all(c.is_Rational for c in sp.Poly(part, *symbols).coeffs()):
            return False
    return True


def _one_sign(expression: sp.Expr) -> int:
    """Sign of a polynomial in positive symbols whose coefficients all share it, else 0."""
    if not expression.free_symbols:
        return int(sp.sign(expression)) if expression.is_number else 0
    if not expression.is_polynomial():
        return 0
    polynomial = sp.Poly(expression, *sorted(expression.free_symbols, key=str))
    if any(s.is_positive is not True for s in polynomial.gens):
        # a symbol that may vanish leaves only the constant term for strictness
        if polynomial.coeff_monomial(1) == 0:
            return 0
        if any(s.is_nonnegative is not True for s in polynomial.gens):
            return 0
    signs = {sp.sign(c) for c in polynomial.coeffs()}
    return int(signs.pop()) if len(signs) == 1 else 0

"""Irrational numbers of a declaration: real for certain, exactly zero or not, and as texts.

A closed expression such as ``sqrt(2)*pi/3`` is one number. Its text is in the grammar in which
parameters are given, so every arithmetic evaluates it as it does a value that a user gives: the
nearest double, any number of digits, balls.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from functools import lru_cache
from typing import Any

import sympy as sp
from sympy.polys.polyerrors import NotAlgebraic
from sympy.printing.str import StrPrinter

from nonsmooth.derive.errors import DeclarationError

_FUNCTIONS = (sp.sin, sp.cos, sp.exp, sp.log, sp.asin, sp.acos, sp.atan)
_EXPONENTIAL = (sp.exp, sp.sinh, sp.cosh, sp.tanh, sp.coth)
_WRITTEN = (sp.Rational, sp.Pow, sp.Add, sp.Mul, sp.pi.func, sp.E.func, *_FUNCTIONS)
_REWRITTEN = {
    sp.tan: sp.sin, sp.cot: sp.sin, sp.sec: sp.cos, sp.csc: sp.sin,
    sp.sinh: sp.exp, sp.cosh: sp.exp, sp.tanh: sp.exp, sp.coth: sp.exp,
    sp.asinh: sp.log, sp.acosh: sp.log, sp.atanh: sp.log,
}  # fmt: skip
_DIGITS = 60
_NOISE = sp.Rational(10) ** -(_DIGITS - 15)
_MOST_DIGITS = 4000  # of the whole numbers in a number; Python writes 4300
_LARGEST_LOGARITHM = 745  # of a number that a double holds, in size
_LARGEST_EXPANDED = 200  # power of a sum
_LARGEST_DENOMINATOR = 10**6  # of a rational number that is written with irrational ones
_X = sp.Dummy("x")


def is_irrational(expression: Any) -> bool:
    """Whether an expression is a closed number that texts can express, but not as a fraction."""
    return bool(expression.is_Rational is False) and _is_written(expression)


@lru_cache(maxsize=4096)
def _is_written(expression: Any) -> bool:
    """Whether the grammar of values has all operations and functions of a number."""
    if isinstance(expression, sp.CRootOf):
        return True
    return isinstance(expression, _WRITTEN) and all(map(_is_written, expression.args))


def map_numbers(
    expression: Any, change: Callable[[Any], Any], takes: Callable[[Any], bool] = is_irrational
) -> Any:
    """Replace each closed irrational number in an expression, the largest ones as a whole.

    `change` maps a number, such as ``sqrt(2)*pi``, to what takes its place; `takes` decides
    whether an expression is such a number.
    """
    if takes(expression):
        return change(expression)
    arguments = expression.args
    if expression.is_Add or expression.is_Mul:
        closed = [a for a in arguments if a.is_Rational or takes(a)]
        if not all(a.is_Rational for a in closed):
            rest = [map_numbers(a, change, takes) for a in arguments if a not in closed]
            return expression.func(change(expression.func(*closed)), *rest)
    found = tuple(map_numbers(a, change, takes) for a in arguments)
    return expression if found == arguments else expression.func(*found)


def settled(expression: Any) -> Any:
    """The expression with its closed numbers real, and the rational ones written as fractions.

    DeclarationError refuses in one line a number that is not real, or not known to be, and
    one that has no text.
    """
    if expression.is_Atom and not expression.is_number:
        return expression
    for number in expression.atoms(sp.Rational):
        if max(abs(number.p), number.q) >= 10**_MOST_DIGITS:
            raise DeclarationError(f"it has a number of more than {_MOST_DIGITS} digits")
    return map_numbers(expression, _settled, _is_closed)


def _is_closed(expression: Any) -> bool:
    """Whether an expression is a finite number that is not written as a fraction."""
    closed = isinstance(expression, sp.Expr) and expression.is_number
    strange = (sp.nan, sp.oo, -sp.oo, sp.zoo)  # these are reported where they are declared
    return bool(closed and not expression.is_Rational and not expression.has(*strange))


@lru_cache(maxsize=4096)
def _settled(number: Any) -> Any:
    if number.is_real is False and not number.has(sp.I):
        raise DeclarationError(f"{number} is no real number")
    largest = _largest_power(number)
    found = number.replace(lambda e: e.func in _REWRITTEN, _rewritten)
    found = sp.expand(found, func=True, multinomial=largest <= _LARGEST_EXPANDED)
    value = sp.N(found, _DIGITS)
    if found.has(sp.I) or not isinstance(value, sp.Float | sp.Rational):
        found, value = _as_root(number, found, value)
    guess = sp.Rational(Fraction(str(value)).limit_denominator(_LARGEST_DENOMINATOR))
    if abs(sp.Rational(str(value)) - guess) < _NOISE:
        if _is_zero(found - guess):
            return guess
        if guess == 0:
            raise DeclarationError(f"whether {number} is zero is not decided")
    number_text(found)
    nearest_double(found)
    return found


def _largest_power(number: Any) -> Any:
    """The largest power of a sum, in size, in a number.

    DeclarationError refuses a power that no double comes near; inner ones are looked at first.
    """
    largest = sp.S.Zero
    for part in sp.postorder_traversal(number):
        if part.func in _EXPONENTIAL and part.is_number:
            logarithm = sp.N(part.args[0], 15)
        elif isinstance(part, sp.Pow) and part.is_number:
            base, exponent = (sp.N(each, 15) for each in part.args)
            largest = max(largest, abs(exponent)) if part.base.is_Add else largest
            logarithm = exponent * sp.log(abs(base))
        else:
            continue
        if abs(logarithm).is_finite and abs(logarithm) > _LARGEST_LOGARITHM:
            raise DeclarationError(f"{part} takes numbers beyond the range of doubles")
    return largest


def nearest_double(number: Any) -> float:
    """The double nearest to a number; DeclarationError refuses one that is too large."""
    try:
        return float(Fraction(str(sp.N(number, _DIGITS))))
    except OverflowError:
        raise DeclarationError(f"{number} is too large for a double") from None


def _rewritten(number: Any) -> Any:
    """A function of a number in terms of functions that texts have."""
    return number.rewrite(_REWRITTEN[number.func])


def _is_zero(number: Any) -> bool:
    """Whether a number is proved to be zero."""
    if sp.simplify(number) == 0:
        return True
    return bool(_minimal(number) == _X)


def _minimal(number: Any) -> Any:
    """The minimal polynomial of a number; None if SymPy cannot give it."""
    try:
        return sp.minimal_polynomial(number, _X)
    except (NotImplementedError, NotAlgebraic):  # SymPy's words for a number that it cannot take
        return None


def _as_root(number: Any, found: Any, value: Any) -> tuple[Any, Any]:
    """A number that is real though not written so, as a real root, and its value.

    The root is that of its minimal polynomial. DeclarationError refuses a number for which
    this does not prove that it is real.
    """
    real, imaginary = value.as_real_imag()
    noise = _NOISE * (1 + abs(real))
    polynomial = None
    if found.is_real is not False and abs(imaginary) < noise:
        polynomial = _minimal(found)
    if polynomial is not None:
        near = [r for r in sp.Poly(polynomial, _X).real_roots() if abs(sp.N(r - real)) < noise]
        every = sp.Poly(polynomial, _X).nroots(n=_DIGITS, maxsteps=500)
        if len(near) == len([z for z in every if abs(z - value) < 2 * noise]) == 1:
            return near[0], sp.N(near[0], _DIGITS)
    raise DeclarationError(f"{number} is no real number, or not known to be one")


class _Printer(StrPrinter):
    """Numbers in the grammar of values, without blanks."""

    def _print_Exp1(self, expr: sp.Expr) -> str:
        return "exp(1)"

    def _print_ComplexRootOf(self, expr: Any) -> str:
        coefficients = ",".join(map(str, expr.poly.all_coeffs()))
        return f"root({expr.index},{coefficients})"


@lru_cache(maxsize=4096)
def number_text(number: Any) -> str:
    """A number in the grammar of parameter values.

    DeclarationError refuses a number with functions that values do not have.
    """
    if not _is_written(number):
        raise DeclarationError(
            f"{number} is no number of fractions, pi, roots, exp, log, sine, cosine and inverses"
        )
    return str(_Printer().doprint(number)).replace(" ", "")

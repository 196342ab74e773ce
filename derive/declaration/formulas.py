"""Texts of formulas, read without executing them: numbers, names, operators, known functions."""

from __future__ import annotations

import ast
import math
import operator
import re
import unicodedata
from collections.abc import Callable
from typing import Any

import sympy as sp

from nonsmooth.derive.errors import DeclarationError

_TOKEN = re.compile(r"\s*((?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?|[^\W\d]\w*|\*\*|[-+*/^(),])\s*")
_NOT_ZERO = re.compile(r"[\d.]*[1-9][\d.]*[eE]-\d+|[0.]*\.\d*[1-9]\d*")  # as it is written
_LARGEST_POWER = 200_000  # bits
# E is no constant: it is the modulus of elasticity where it is declared, and refused elsewhere
_CONSTANTS = {"pi": sp.pi, "I": sp.I, "oo": sp.oo, "zoo": sp.zoo, "nan": sp.nan}
_X = sp.Dummy("x")


def _root(first: Any, *others: Any) -> Any:
    """The root of a number; of a polynomial with integer coefficients, as texts of values say."""
    if len(others) == 1:
        return _power(first, 1 / others[0])
    try:
        return sp.CRootOf(sp.Poly(others, _X), int(first))
    except IndexError:
        raise DeclarationError(f"root {first} of a polynomial is beyond its real ones") from None


def _exponential(value: Any) -> Any:
    """The exponential, which of a logarithm is a power."""
    _check_logarithms(value)
    return sp.exp(value)


def _check_logarithms(exponent: Any) -> None:
    """Refuse an exponential that is the power of an enormous number."""
    for term in sp.Add.make_args(exponent):
        factor, inner = term.as_coeff_Mul()
        if isinstance(inner, sp.log):
            _power(inner.args[0], factor)


_FUNCTIONS: dict[str, Callable[..., Any]] = {
    name: getattr(sp, name)
    for name in (
        *("log", "ln", "sin", "cos", "tan", "cot", "sec", "csc"),
        *("asin", "acos", "atan", "acot", "asec", "acsc", "atan2", "sinh", "cosh", "tanh", "coth"),
        *("sech", "csch", "asinh", "acosh", "atanh", "acoth", "asech", "acsch"),
        *("Abs", "Max", "Min", "sign", "Rational", "Integer"),
    )
} | {
    "abs": sp.Abs,
    "exp": _exponential,
    "root": _root,
    "sqrt": sp.sqrt,
    "cbrt": sp.cbrt,
    "S": sp.S,
}
_OF_ONE = ("exp", "sqrt", "cbrt", "S")  # SymPy's own have options too


def formula(text: str) -> sp.Expr:
    """The expression that a text says, in SymPy's words; a decimal is the double it stands for.

    A name is a symbol, but for the constants and functions above: also where SymPy has a function
    or number of that name (E, N, gamma). DeclarationError says what is not known in it.
    """
    try:
        tokens = _tokens(text)
        names = {unicodedata.normalize("NFKC", token): token for token in tokens}
        if len(names) < len({*tokens}):
            raise DeclarationError("two of its names differ in the form of letters alone")
        return _value(ast.parse(" ".join(tokens), mode="eval").body, names)
    except DeclarationError:
        raise
    except (RecursionError, MemoryError):
        raise DeclarationError("it is nested too deeply") from None
    # SymPy's functions have no one exception for what they do not take
    except (TypeError, ValueError, NotImplementedError, sp.PolynomialError) as problem:
        reason = " ".join(str(problem).split())
        raise DeclarationError(f"a function does not take what it is given: {reason}") from None
    except SyntaxError as problem:
        raise DeclarationError(problem.msg.partition(";")[0].partition(". ")[0]) from None


def _tokens(text: str) -> list[str]:
    """The tokens of a text, with Python's sign of a power."""
    tokens, place = [], 0
    while place < len(text):
        token = _TOKEN.match(text, place)
        if token is None or "__" in token[1]:
            raise DeclarationError(f"{token[1] if token else text[place]!r} is not known in it")
        if _NOT_ZERO.fullmatch(token[1]) and float(token[1]) == 0:
            raise DeclarationError("it has a number beyond the range of doubles")
        tokens.append("**" if token[1] == "^" else token[1])
        place = token.end()
    return tokens


def _value(node: ast.expr, names: dict[str, str]) -> Any:
    """The value of a part of a formula; sums and products may have many terms.

    Python reads a letter such as the sign of micro as another one: `names` gives what was written.
    """
    steps = []
    while isinstance(node, ast.BinOp) and type(node.op) in _OPERATORS:
        steps.append((_OPERATORS[type(node.op)], _value(node.right, names)))
        node = node.left
    match node:
        case ast.Constant(value=bool()):
            raise DeclarationError(f"{node.value!r} is no number")
        case ast.Constant(value=int(number)):
            value = sp.Integer(number)
        case ast.Constant(value=float(number)):
            if not math.isfinite(number):
                raise DeclarationError("it has a number beyond the range of doubles")
            value = sp.Rational(repr(number))
        case ast.UnaryOp(op=ast.USub(), operand=inner):
            value = -_value(inner, names)
        case ast.UnaryOp(op=ast.UAdd(), operand=inner):
            value = _value(inner, names)
        case ast.Name(id=name) if name in _FUNCTIONS and name != "S":  # which may be a parameter
            raise DeclarationError(f"the function {name} stands without its argument")
        case ast.Name(id=name):
            value = _CONSTANTS.get(name, sp.Symbol(names[name]))
        case ast.Call(func=ast.Name(id=name)) if name not in _FUNCTIONS:
            raise DeclarationError(f"the function {name} is not known in it")
        case ast.Call(func=ast.Name(id=name), args=arguments, keywords=[]):
            if name in _OF_ONE and len(arguments) != 1:
                raise DeclarationError(f"the function {name} takes one value")
            value = _FUNCTIONS[name](*[_value(each, names) for each in arguments])
        case _:
            raise DeclarationError(f"{ast.unparse(node)!r} is not allowed in it")
    for apply, right in reversed(steps):
        value = apply(value, right)
    return value


def _power(base: Any, exponent: Any) -> Any:
    """A power; refused if a number in it becomes enormous."""
    for factor in sp.Mul.make_args(base):
        number, inner = factor.as_base_exp()
        power = inner * exponent
        if number is sp.E:
            _check_logarithms(power)
        if number.is_Rational and power.is_Rational and abs(number) not in (0, 1):
            bits = max(abs(int(part)).bit_length() for part in (number.p, number.q))
            if bits * abs(power) > _LARGEST_POWER:
                raise DeclarationError(f"the power {exponent} is too large")
    return base**exponent


_OPERATORS: dict[type[ast.operator], Callable[[Any, Any], Any]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.Pow: _power,
}

"""Irrational numbers as rational functions of few of them, whose algebraic relations are known.

``sqrt(12)/2`` is ``sqrt(3)``, the square of that is 3, and ``cos(2*pi/7)`` is a polynomial of
``cos(pi/7)``. What remains are generators: pi, roots of primes and of other numbers, roots of
polynomials, the cosine of a fraction of a turn, powers of e, logarithms of primes, and any other
function as it is written. A relation holds exactly, so what it shows to be zero is zero; that no
other relation holds is not claimed.
"""

from __future__ import annotations

import ast
import math
import operator
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from nonsmooth.runtime.core.rational_functions import Extension, RationalFunction, symbols

if TYPE_CHECKING:
    from flint import arb

_OPERATORS: dict[type[ast.operator], Callable[[Any, Any], Any]] = {
    ast.Add: operator.add, ast.Sub: operator.sub, ast.Mult: operator.mul, ast.Div: operator.truediv,
}  # fmt: skip
_HIGHEST_POWER = 64  # that is multiplied out
_FACTORED = 64  # bits of an integer that is written by its primes
_LARGEST_ORDER = 24  # of a root of a prime, where roots of several orders are its powers
_MOST_PARTS = 240  # of a turn
_LARGEST_LITERAL = 10_000  # bits
_HIGHEST_DEGREE = 24  # of a polynomial that reduces powers of its root


@dataclass(frozen=True)
class Irrationals:
    """Irrational numbers as rational functions of parameters and generators."""

    variables: list[RationalFunction]  # the parameters
    generators: tuple[str, ...]  # expressions of the last variables of the functions, in this order
    numbers: dict[str, Any]  # fmpq or RationalFunction of each number, by its text


def irrationals(
    names: Sequence[str], texts: Iterable[str], evaluate: Callable[[str], arb]
) -> Irrationals:
    """Numbers as rational functions of their generators, beside the parameters `names`.

    `texts` are in the grammar of parameter values, and known to be finite and real.
    `evaluate` gives a ball around an expression, which tells what is certainly not zero.
    Raises ArithmeticError if a number divides by what may be zero, or a literal is
    enormous.
    """
    trees = {text: _tree(text) for text in dict.fromkeys(texts)}
    reader = _NumberReader()
    for tree in trees.values():
        reader.collect(tree)
    generators = reader.generators()
    places = [*names, *(f"constant{k}" for k in range(len(generators)))]
    values = tuple(evaluate(text) for text in generators.values())
    found = symbols(places, Extension(values)) if places else []
    reader.known = dict(zip(generators, found[len(names) :], strict=True))
    relations = tuple(
        relation for key in reversed(generators) if (relation := reader.relation(key)) is not None
    )  # those of inner numbers come first, and are taken in turn by what follows
    whole = Extension(values, tuple(reversed(relations)))
    whole.check()
    variables = [RationalFunction(x.above, x.below, whole) for x in found]
    reader.known = dict(zip(generators, variables[len(names) :], strict=True))
    numbers = {text: reader.number(tree) for text, tree in trees.items()}
    return Irrationals(variables[: len(names)], tuple(generators.values()), numbers)


def _tree(text: str) -> ast.expr:
    """The syntax tree of a number, whose literals are integers."""
    source = " ".join(text.split())
    tree: ast.expr = _Fractions(source).visit(ast.parse(source, mode="eval").body)
    return tree


class _Fractions(ast.NodeTransformer):
    """Writes decimals as quotients of integers."""

    def __init__(self, source: str) -> None:
        self.source = source

    def visit_Constant(self, node: ast.Constant) -> ast.expr:
        # the literal's own text: its value is rounded to a double already
        exact = Fraction(ast.get_source_segment(self.source, node) or "")
        above, below = exact.as_integer_ratio()
        if max(above.bit_length(), below.bit_length()) > _LARGEST_LITERAL:
            raise ArithmeticError("a literal is too large")
        if below == 1:
            return ast.Constant(above)
        return ast.BinOp(left=ast.Constant(above), op=ast.Div(), right=ast.Constant(below))


class _NumberReader:
    """Collects the generators of syntax trees, and expresses the trees by them."""

    def __init__(self) -> None:
        self.keys: dict[Any, Any] = {}  # with the number inside, if there is one
        self.order: dict[Any, int] = {}  # of roots of primes, powers of e, parts of a turn
        self.known: dict[Any, RationalFunction] = {}

    def collect(self, node: ast.expr) -> None:
        """Note the generators of a tree, those inside others first."""
        match self._what(node):
            case ("rational", _):
                pass
            case ("round", parts) | ("combined", _, *parts):
                for part in parts:
                    self.collect(part)
            case ("powers", powers):
                for key, power in powers.items():
                    if key == "e" or power.denominator > 1:
                        self._note(key, power.denominator)
            case ("logarithms", primes):
                for prime in primes:
                    self._note(("log", prime), 1)
            case ("turn", share):
                self._note("turn", share.denominator)
            case ("radical", inner, power):
                self.collect(inner)
                self._note(("radical", ast.unparse(inner), power.denominator), 1, inner)
            case ("generator", key):
                self._note(key, 1, node)

    def _note(self, key: Any, order: int, node: Any = None) -> None:
        self.keys[key] = node
        self.order[key] = math.lcm(self.order.get(key, 1), order)

    def generators(self) -> dict[Any, str]:
        """Expressions of the generators by their keys, each before those that it contains."""
        return {key: self._text(key) for key in reversed(self.keys)}

    def _text(self, key: Any) -> str:
        order = self.order[key]
        match key:
            case ("prime", prime):
                return _root_text(str(prime), order)
            case "e":
                return f"exp(1/{order})"
            case "turn":
                return f"cos(2*pi/{order})"
            case ("log", prime):
                return f"log({prime})"
            case ("radical", inner, power):
                return _root_text(f"({inner})", power)
        return str(key)

    def relation(self, key: Any) -> Any:
        """A polynomial that is zero and monic in a generator; None where none is known."""
        from flint import fmpz_poly

        generator, order = self.known[key], self.order[key]
        coefficients: list[Any] = []
        match key:
            case ("prime", prime):
                found = generator**order - prime
            case "turn":
                coefficients = [int(c) << k for k, c in enumerate(fmpz_poly.cos_minpoly(order))]
            case ("radical", _, power):
                found = generator**power - self.number(self.keys[key])
            case str() if key.startswith("root"):
                _, *descending = _plain_arguments(self.keys[key])
                coefficients = descending[::-1]
            case _:
                return None
        if coefficients:
            found = sum((generator**k * c for k, c in enumerate(coefficients)), 0 * generator)
            found = found / coefficients[-1]
        small = found.below.is_constant() and len(coefficients) <= _HIGHEST_DEGREE + 1
        return found.above / found.below.leading_coefficient() if small else None

    def number(self, node: ast.expr) -> Any:
        """The number that a tree stands for: a fraction, or a function of the generators."""
        from flint import fmpq, fmpz_poly

        match self._what(node):
            case ("rational", value):
                return fmpq(value.numerator, value.denominator)
            case ("round", [inner]):
                sign = -1 if isinstance(getattr(node, "op", None), ast.USub) else 1
                return sign * self.number(inner)
            case ("combined", apply, left, right):
                return apply(self.number(left), self.number(right))
            case ("powers", powers):
                result: Any = fmpq(1)
                for key, power in powers.items():
                    whole, rest = divmod(power, 1)
                    if rest or key == "e":
                        rest = int(rest * self.order[key])
                        result = result * self.known[key] ** rest
                    base = self.known[key] ** self.order[key] if key == "e" else fmpq(key[1])
                    result = result * base ** int(whole)
                return result
            case ("logarithms", primes):
                return sum((self.known["log", p] * n for p, n in primes.items()), fmpq(0))
            case ("turn", share):
                whole = int(share * self.order["turn"])
                terms = enumerate(fmpz_poly.chebyshev_t(whole))
                return sum((self.known["turn"] ** k * int(c) for k, c in terms), fmpq(0))
            case ("radical", inner, power):
                key = "radical", ast.unparse(inner), power.denominator
                return self.known[key] ** power.numerator
            case ("generator", key):
                return self.known[key]
        raise AssertionError(type(node).__name__)

    def _what(self, node: ast.expr) -> tuple[Any, ...]:
        """The kind of number that a tree is, and the parts that it is made of."""
        linear = _linear(node)
        if linear is not None and linear[1] == 0:
            return "rational", linear[0]
        opaque: tuple[Any, ...] = "generator", ast.unparse(node)
        match node:
            case ast.UnaryOp(operand=inner):
                return "round", [inner]
            case ast.BinOp(left=left, op=op, right=right) if type(op) in _OPERATORS:
                return "combined", _OPERATORS[type(op)], left, right
            case ast.BinOp(left=base, op=ast.Pow(), right=exponent):
                power = _linear(exponent)
                return opaque if power is None or power[1] else self._power(base, power[0], opaque)
            case ast.Call(func=ast.Name(id="sqrt"), args=[inner]):
                return self._power(inner, Fraction(1, 2), opaque)
            case ast.Call(func=ast.Name(id="exp" | "log" | "cos" | "sin" as name), args=[inner]):
                argument = _linear(inner)
                if argument is None:
                    return opaque
                called = self._called(str(name), *argument)
                return opaque if called is None else called
        return opaque

    def _power(self, base: ast.expr, power: Fraction, opaque: tuple[Any, ...]) -> tuple[Any, ...]:
        value = _linear(base)
        if abs(power.numerator) > _HIGHEST_POWER or power.denominator > _LARGEST_ORDER:
            return opaque
        if value is not None and not value[1]:
            primes = _primes(value[0])
            if primes is not None:
                return "powers", {("prime", p): n * power for p, n in primes.items()}
        if power.denominator == 1:
            return "combined", lambda x, _: x**power.numerator, base, ast.Constant(1)
        return "radical", base, power

    def _called(self, name: str, plain: Fraction, turns: Fraction) -> tuple[Any, ...] | None:
        """The kind and parts of a function of a fraction plus a fraction of pi.

        None where the function has to be a generator itself.
        """
        if name == "exp":
            small = not turns and abs(plain) < _HIGHEST_POWER and plain.denominator < _LARGEST_ORDER
            return ("powers", {"e": plain}) if small else None
        if name == "log":
            primes = None if turns else _primes(plain)
            return None if primes is None else ("logarithms", primes)
        share = turns / 2 if name == "cos" else Fraction(1, 4) - turns / 2
        share = min(share % 1, -share % 1)
        return None if plain or share.denominator > _MOST_PARTS else ("turn", share)


def _root_text(base: str, order: int) -> str:
    return base if order == 1 else f"sqrt({base})" if order == 2 else f"{base}**(1/{order})"


def _plain_arguments(node: Any) -> list[int]:
    """Integers that a function is called with."""
    return [int(value[0]) for value in map(_linear, node.args) if value is not None]


def _linear(node: ast.expr) -> tuple[Fraction, Fraction] | None:
    """Fractions a and b where a tree is a + b pi by the rules of fractions; else None."""
    match node:
        case ast.Constant(value=int() as value):
            return Fraction(value), Fraction(0)
        case ast.Name(id="pi"):
            return Fraction(0), Fraction(1)
        case ast.UnaryOp(op=sign, operand=inner):
            found = _linear(inner)
            flip = -1 if isinstance(sign, ast.USub) else 1
            return found and (flip * found[0], flip * found[1])
        case ast.BinOp(left=first, op=op, right=second):
            left, right = _linear(first), _linear(second)
            if left is None or right is None:
                return None
            match op:
                case ast.Add():
                    return left[0] + right[0], left[1] + right[1]
                case ast.Sub():
                    return left[0] - right[0], left[1] - right[1]
                case ast.Mult() if not (left[1] and right[1]):
                    return left[0] * right[0], left[0] * right[1] + left[1] * right[0]
                case ast.Div() if right[0] and not right[1]:
                    return left[0] / right[0], left[1] / right[0]
                case ast.Pow() if not left[1] and not right[1] and right[0].denominator == 1:
                    large = abs(right[0]) > _HIGHEST_POWER
                    return None if large else (left[0] ** int(right[0]), Fraction(0))
    return None


def _primes(number: Fraction) -> dict[int, int] | None:
    """Exponents of the primes of a positive fraction; None if it is too large or not positive."""
    from flint import fmpz

    above, below = number.numerator, number.denominator
    if above <= 0 or max(above.bit_length(), below.bit_length()) > _FACTORED:
        return None
    powers = {int(p): int(n) for p, n in fmpz(above).factor()}
    return powers | {int(p): -int(n) for p, n in fmpz(below).factor()}

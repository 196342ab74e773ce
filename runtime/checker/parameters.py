"""The numbers that a file names: exact where they are rational, else functions of constants."""

import ast
import operator
import re
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from flint import arb, fmpq

from nonsmooth.runtime.checker.declared import Declared
from nonsmooth.runtime.checker.exact import NUMBER, Failure, demand, exact
from nonsmooth.runtime.core.rational_functions import symbols

__all__ = ["independent", "number_at", "number_in", "values_of"]

_OPERATORS = {
    ast.Add: operator.add, ast.Sub: operator.sub, ast.Mult: operator.mul,
    ast.Div: operator.truediv, ast.Pow: operator.pow,
}  # fmt: skip
_TOKEN = re.compile(
    r"\s*((?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d{1,5})?|[^\W\d]\w*|\*\*|[-+*/()])\s*", re.ASCII
)
_LONGEST = 1000  # characters of an expression
_HIGHEST = 10_000  # exponent


def number_in(text: str) -> Any:
    """What an expression means: a fraction, or a ball where irrational functions enter."""
    if NUMBER.fullmatch(text):
        return exact(text)
    tokens, place = [], 0
    while place < len(text) <= _LONGEST and (token := _TOKEN.match(text, place)):
        tokens.append(token[1])
        place = token.end()
    demand(tokens and place == len(text), f"{text[:60]!r} is no number")
    source = " ".join(tokens)
    try:
        return _value(ast.parse(source, mode="eval").body, source)
    except (SyntaxError, RecursionError, MemoryError, ArithmeticError, ValueError):
        raise Failure(f"{text[:60]!r} is no number") from None


def _value(node: Any, source: str) -> Any:
    match node:
        case ast.Constant():
            return exact((ast.get_source_segment(source, node) or "").lower())
        case ast.Name(id="pi"):
            return arb.pi()
        case ast.Call(
            func=ast.Name(id="sqrt" | "sin" | "cos" | "exp" | "log" as name),
            args=[inner],
            keywords=[],
        ):
            return getattr(arb(_value(inner, source)), name)()
        case ast.UnaryOp(op=ast.USub() | ast.UAdd() as sign, operand=inner):
            operand = _value(inner, source)
            return -operand if isinstance(sign, ast.USub) else operand
        case ast.BinOp(left=first, op=symbol, right=second) if type(symbol) in _OPERATORS:
            left, right = _value(first, source), _value(second, source)
            if isinstance(symbol, ast.Pow):
                demand(not isinstance(right, fmpq) or abs(right) <= _HIGHEST, "a power too high")
                if isinstance(right, fmpq):
                    right = int(right.p) if right.q == 1 else arb(right)
            return _OPERATORS[type(symbol)](*_alike(left, right))
    raise Failure(f"{source[:60]!r} is no number")


def _alike(left: Any, right: Any) -> tuple[Any, Any]:
    """Two numbers of one kind; integers go with both."""
    if isinstance(left, arb) or isinstance(right, arb):
        return arb(left), arb(right)
    return left, right


def values_of(
    parameters: Mapping[str, str], varying: Sequence[str] = ()
) -> tuple[dict[str, Any], list[Any]]:
    """Exact values by name, and the irrational constants that some are functions of.

    Parameters that vary are variables; in functions they come before the constants.
    """
    demand(not {*parameters} & {*varying}, "a parameter is given twice")
    known = {text: number_in(text) for text in parameters.values()}
    constants = {text: value for text, value in known.items() if isinstance(value, arb)}
    demand(all(value.is_finite() for value in constants.values()), "a parameter is not finite")
    places = [f"variable{k}" for k in range(len(varying) + len(constants))]
    own = dict(zip([*varying, *constants], symbols(places), strict=True)) if places else {}
    values = {name: own[name] for name in varying}
    # a name that varies may look like the text of a constant
    place = dict(zip(constants, [*own.values()][len(varying) :], strict=True)) if own else {}
    values |= {name: place.get(text, known[text]) for name, text in parameters.items()}
    return values, [*constants.values()]


def number_at(values: Sequence[Any]) -> Callable[[Any], Any]:
    """Exact entries in numbers, at values of what they are functions of."""
    found: dict[Any, Any] = {}

    def number(entry: Any) -> Any:
        if not callable(entry):
            return arb(entry)
        if entry not in found:
            found[entry] = entry(values)
        return found[entry]

    return number


def independent(declared: Declared, constants: Any, box: Sequence[Any] = ()) -> None:
    """No divisor of the exact arithmetic is zero for all parameters at these constants.

    Where only parameters vary no rational function is; constants may depend on each other.
    """
    point = [arb(low + (high - low) * fmpq(37 + k, 101)) for k, (low, high) in enumerate(box)]
    for divisor in declared.exactly.divisors if constants else ():
        value = divisor([*point, *constants]) if callable(divisor) else divisor
        demand(value > 0 or value < 0, "constants depend on each other")

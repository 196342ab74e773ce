"""The numbers that a file names: exact where they are rational, else functions of constants."""

import ast
import operator
import re
from collections.abc import Mapping, Sequence
from typing import Any

from flint import arb, fmpq, fmpz_poly

from nonsmooth.runtime.checker.stated.declared import StatedSystem
from nonsmooth.runtime.checker.stated.exact import (
    NUMBER,
    Entries,
    Failure,
    Numbers,
    ToNumber,
    demand,
    demand_sign,
    exact,
)
from nonsmooth.runtime.core.irrational_numbers import irrationals

_OPERATORS = {
    ast.Add: operator.add, ast.Sub: operator.sub, ast.Mult: operator.mul,
    ast.Div: operator.truediv, ast.Pow: operator.pow,
}  # fmt: skip
_TOKEN = re.compile(
    r"\s*((?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d{1,5})?|[^\W\d]\w*|\*\*|[-+*/(),])\s*", re.ASCII
)
_LONGEST = 1000  # characters of an expression
_HIGHEST = 10_000  # exponent
_LARGEST, _MOST_COEFFICIENTS = fmpq(2) ** 8192, 102  # of a polynomial whose root is taken


def number_in(text: str) -> Any:
    """Return the value of an expression: a fraction, or a ball where irrational functions enter.

    As in "3/4" or "sqrt(2)/2"; `Failure` is raised for a text that is no such number.
    """
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
            func=ast.Name(
                id="sqrt" | "sin" | "cos" | "exp" | "log" | "asin" | "acos" | "atan" as name
            ),
            args=[inner],
            keywords=[],
        ):
            return getattr(arb(_value(inner, source)), name)()
        case ast.Call(func=ast.Name(id="root"), args=[_, _, _, *_] as numbers, keywords=[]):
            return _root([_value(number, source) for number in numbers])
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


def _root(numbers: list[Any]) -> Any:
    """Return a real root of an integer polynomial.

    The numbers are the root's place, from the lowest, and coefficients from the highest
    power on.
    """
    fits = all(isinstance(n, fmpq) and n.q == 1 and abs(n) < _LARGEST for n in numbers)
    demand(fits and len(numbers) < _MOST_COEFFICIENTS, "no root of a polynomial")
    place, *coefficients = (int(n.p) for n in numbers)
    roots: Any = fmpz_poly(coefficients[::-1]).complex_roots()
    real = sorted((x.real for x, _ in roots if x.imag == 0), key=lambda x: x.mid())
    demand(coefficients[0] and 0 <= place < len(real), "a polynomial has no such root")
    return real[place]


def _alike(left: Any, right: Any) -> tuple[Any, Any]:
    """Return two numbers as numbers of one kind; integers go with both kinds."""
    if isinstance(left, arb) or isinstance(right, arb):
        return arb(left), arb(right)
    return left, right


def values_of(
    parameters: Mapping[str, str], varying: Sequence[str] = (), stated: Sequence[str] = ()
) -> tuple[dict[str, Any], list[Any], list[Any]]:
    """Return exact values by name, exact values of stated expressions, and irrational constants.

    Parameters that vary become variables; functions take these before the irrational
    constants, which are balls. `stated` has expressions that a declaration holds beside
    its parameters. `Failure` is raised for a parameter that is given twice, is no number,
    or is not finite.
    """
    demand(not {*parameters} & {*varying}, "a parameter is given twice")
    known = {text: number_in(text) for text in (*parameters.values(), *stated)}
    irrational = [text for text, value in known.items() if isinstance(value, arb)]
    demand(all(known[text].is_finite() for text in irrational), "a parameter is not finite")
    try:
        found = irrationals(varying, irrational, lambda text: arb(number_in(text)))
    except ArithmeticError:
        raise Failure("an irrational number cannot be told from others") from None
    known |= found.numbers
    values = dict(zip(varying, found.variables, strict=True))
    values |= {name: known[text] for name, text in parameters.items()}
    constants = [arb(number_in(text)) for text in found.generators]
    return values, [known[text] for text in stated], constants


def stated_system(
    content: Entries, parameters: Mapping[str, str], varying: Sequence[str] = ()
) -> tuple[StatedSystem, list[Any]]:
    """Return the system that a file states, and the irrational constants of its functions.

    `parameters` holds the values of all but those that vary.
    """
    told = content["declaration"].get("constants", [])
    values, stated, constants = values_of(parameters, varying, told)
    return StatedSystem(content, values, stated), constants


def number_at(values: Numbers) -> ToNumber:
    """Return a function that turns exact entries into numbers.

    `values` are those of the variables, then of the constants, that the entries are
    functions of.
    """
    found: dict[Any, Any] = {}

    def number(entry: Any) -> Any:
        if not callable(entry):
            return arb(entry)
        if entry not in found:
            found[entry] = entry(values)
        return found[entry]

    return number


def independent(declared: StatedSystem, constants: Any, box: Sequence[Any] = ()) -> None:
    """Demand that no divisor of the exact arithmetic vanishes for all parameters at the constants.

    Irrational constants may depend on each other, so that a divisor may vanish at them
    though it is not the zero function. Each is evaluated at one point of the `box`, the
    ends of the parameters that vary; `Failure` is raised if one may be zero there.
    Without constants nothing is to be shown.
    """
    point = [arb(low + (high - low) * fmpq(37 + k, 101)) for k, (low, high) in enumerate(box)]
    for divisor in declared.exactly.divisors if constants else ():
        value = divisor([*point, *constants]) if callable(divisor) else divisor
        demand_sign(value, "constants depend on each other")

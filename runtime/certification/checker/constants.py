"""Irrational numbers that entries of a declaration are functions of."""

import ast
import operator
from collections.abc import Callable, Sequence
from typing import Any

from flint import arb, fmpq

from nonsmooth.runtime.certification.checker.declared import Declared
from nonsmooth.runtime.certification.checker.exact import Failure, demand, exact

__all__ = ["constant", "independent", "numbers_at"]

_OPERATORS = {
    ast.Add: operator.add, ast.Sub: operator.sub, ast.Mult: operator.mul,
    ast.Div: operator.truediv, ast.Pow: operator.pow,
}  # fmt: skip


def constant(text: str) -> Any:
    """The number that an expression means."""
    source = text.strip()

    def value(node: Any) -> Any:
        match node:
            case ast.Constant():
                return arb(exact(ast.get_source_segment(source, node) or ""))
            case ast.Name(id="pi"):
                return arb.pi()
            case ast.Call(func=ast.Name(id="sqrt" | "sin" | "cos" | "exp" | "log" as name)):
                return getattr(value(node.args[0]), name)()
            case ast.UnaryOp(op=ast.USub() | ast.UAdd() as sign):
                return -value(node.operand) if isinstance(sign, ast.USub) else value(node.operand)
            case ast.BinOp():
                return _OPERATORS[type(node.op)](value(node.left), value(node.right))
        raise Failure(f"{source} is no number")

    return value(ast.parse(source, mode="eval").body)


def numbers_at(values: Sequence[Any]) -> Callable[[Any], Any]:
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

"""Kernels as Python functions whose mathematics comes from an argument.

The emitted functions take ``lib`` with ``sin``, ``cos``, ``sqrt``, ``angle``, ``rational``,
``constant`` and ``exponential_difference``; one source serves NumPy arrays,
mpmath and ball arithmetic.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from textwrap import wrap

import sympy as sp
from sympy.printing.precedence import PRECEDENCE
from sympy.printing.str import StrPrinter

from nonsmooth.derive.codegen.body import Constant, body_of
from nonsmooth.derive.codegen.naming import python_function
from nonsmooth.derive.equations.program import Array, Kernel
from nonsmooth.derive.errors import DerivationError


@lru_cache(maxsize=1 << 14)
def _ordered_terms(expression: sp.Expr, order: str | None) -> list[sp.Expr]:
    return list(expression.as_ordered_terms(order))


class Ordered:
    """A mixin of printers that finds the order of a sum's terms once for all of them."""

    def _as_ordered_terms(self, expr: sp.Expr, order: str | None = None) -> list[sp.Expr]:
        return _ordered_terms(expr, order)


class _Printer(Ordered, StrPrinter):
    """Python expressions over ``lib``; integers stay integers, other rationals are exact."""

    def _print_Rational(self, expr: sp.Rational) -> str:
        return f"lib.rational({expr.p}, {expr.q})"

    def _print_Half(self, expr: sp.Expr) -> str:
        return "lib.rational(1, 2)"

    def _print_Pow(self, expr: sp.Pow, rational: bool = False) -> str:
        exponent = expr.exp
        base = self.parenthesize(expr.base, PRECEDENCE["Pow"])
        if (2 * exponent).is_Integer and not exponent.is_Integer:
            exponent = 2 * exponent
            base = f"lib.sqrt({self._print(expr.base)})"
        if not exponent.is_Integer:
            raise DerivationError(f"no kernel for the power {expr}")
        power = base if abs(exponent) == 1 else f"{base}**{abs(exponent)}"
        return power if exponent > 0 else f"1/{power}"

    def _print_Constant(self, expr: Constant) -> str:
        return f'lib.constant("{expr.text}")'

    def _print_wave(self, expr: sp.Expr) -> str:
        return f"lib.{expr.func}({self._print(expr.args[0])})"

    _print_sin = _print_cos = _print_wave

    def _print_Abs(self, expr: sp.Expr) -> str:
        return f"abs({self._print(expr.args[0])})"

    def _print_Angle(self, expr: sp.Expr) -> str:
        # not every arithmetic has the angle of plain integers
        arguments = (f"lib.rational({a}, 1)" if a.is_Integer else self._print(a) for a in expr.args)
        return f"lib.angle({', '.join(arguments)})"

    def _print_ExponentialDifference(self, expr: sp.Expr) -> str:
        k, t, *factors = expr.args
        texts = [f"({self.stringify(f.args, ', ')}{',' if len(f.args) == 1 else ''})"
                 for f in factors]  # fmt: skip
        return f"lib.exponential_difference({', '.join([str(k), self._print(t), *texts])})"

    def _print_Function(self, expr: sp.Expr) -> str:
        raise DerivationError(f"no kernel for the function {type(expr).__name__}")


_PRINTER = _Printer()


@lru_cache(maxsize=1 << 14)  # kernels of one orbit share most of their expressions
def print_python(expression: sp.Expr) -> str:
    """Python source of an expression, over the arithmetic ``lib``."""
    return str(_PRINTER.doprint(expression))


def shape_text(array: Array) -> str:
    """Name and shape of an array, as the docstrings of kernels state them."""
    return f"{array.name} ({', '.join(map(str, array.shape))})" if array.shape else array.name


def python_kernel(kernel: Kernel, orbit: str | None) -> str:
    """Python source of one kernel, which computes as many of its outputs as it is asked for."""
    body, count = body_of(kernel), len(kernel.outputs)
    name = python_function(kernel.name, orbit)
    arguments = ", ".join(f"{a.name}=None" if a.since else a.name for a in kernel.arguments)
    some = f", outputs={count}" if count > 1 else ""
    lines = [f"def {name}({arguments}, *, lib{some}):"]
    lines += _wrap(f'"""{kernel.title}', indent="    ")
    lines.append("")
    for argument in kernel.arguments:
        symbols = f": {', '.join(map(str, argument.entries))}" if argument.shape else ""
        late = f", for {kernel.outputs[argument.since].name}" if argument.since else ""
        lines += _wrap(f"Takes {shape_text(argument)}{symbols}{late}.")
    for output in kernel.outputs:
        lines.append(f"    Gives {shape_text(output)}.")
    lines.append(f"    Operations: {body.operations}. Intermediate terms: {len(body.lines)}.")
    lines.append('    """')
    for place, (output, part) in enumerate(zip(body.outputs, body.parts, strict=True)):
        for argument in body.arguments:
            if argument.since == place:
                lines += _unpack(argument, body.used)
        for line in part:
            if line.title:
                lines.append(f"    # {line.title}")
            lines.append(f"    {line.symbol} = {print_python(line.expression)}")
        if count == 1:
            lines.append(f"    return {_pack(output)}")
            continue
        lines.append(f"    {output.name} = {_pack(output)}")
        results = ", ".join(o.name for o in kernel.outputs[: place + 1])
        if place == count - 1:
            lines.append(f"    return {results}")
        else:
            lines.append(f"    if outputs == {place + 1}:")
            lines.append(f"        return {results}")
    return "\n".join(lines)


def _unpack(argument: Array, used: frozenset[sp.Symbol]) -> list[str]:
    if not argument.shape or not set(argument.entries) & used:
        return []
    names = [str(s) if s in used else "_" for s in argument.entries]
    return [f"    {_nested(names, argument.shape)} = {argument.name}"]


def _pack(output: Array) -> str:
    return _nested([print_python(e) for e in output.entries], output.shape)


def _nested(entries: Sequence[str], shape: tuple[int, ...]) -> str:
    """Entries as a number, a list or a list of rows."""
    if not shape:
        return entries[0]
    if len(shape) == 2:
        rows, columns = shape
        parts = (entries[i * columns : (i + 1) * columns] for i in range(rows))
        entries = [_nested(part, (columns,)) for part in parts]
    return f"[{', '.join(entries)}]"


def _wrap(text: str, indent: str = "        ") -> list[str]:
    return wrap(
        text,
        92,
        initial_indent="    ",
        subsequent_indent=indent,
        break_long_words=False,
        break_on_hyphens=False,
    )

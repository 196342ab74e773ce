"""Kernels as C99 functions over plain arrays, with a header any C program can include."""

from __future__ import annotations

from collections.abc import Iterable

import sympy as sp
from sympy.printing.c import C99CodePrinter
from sympy.printing.precedence import PRECEDENCE

from nonsmooth.derive.codegen.any_arithmetic import shape_text
from nonsmooth.derive.codegen.body import Line, body_of
from nonsmooth.derive.codegen.naming import c_function
from nonsmooth.derive.equations.program import Argument, Kernel, Output
from nonsmooth.derive.errors import DerivationError

__all__ = ["c_kernel", "c_prototype", "line_sources", "print_c"]


class _Printer(C99CodePrinter):
    """C expressions: products for integer powers, calls for the rest."""

    def _print_Pow(self, expr: sp.Pow) -> str:
        base, exponent = expr.base, expr.exp
        if exponent == sp.Rational(1, 2):
            return f"sqrt({self._print(base)})"
        if exponent == sp.Rational(-1, 2):
            return f"(1.0/sqrt({self._print(base)}))"
        factor = self.parenthesize(base, PRECEDENCE["Mul"])
        if (2 * exponent).is_Integer and not exponent.is_Integer:
            factor, exponent = f"sqrt({self._print(base)})", 2 * exponent
        if not exponent.is_Integer:
            raise DerivationError(f"no kernel for the power {expr}")
        product = "*".join([factor] * abs(int(exponent)))
        if exponent > 0:
            return f"({product})"
        return f"(1.0/({product}))"

    def _print_Angle(self, expr: sp.Expr) -> str:
        return f"nonsmooth_angle({', '.join(self._print(a) for a in expr.args)})"

    def _print_Function(self, expr: sp.Expr) -> str:
        raise DerivationError(f"{type(expr).__name__} has no C: emit this system for Python only")


def print_c(expression: sp.Expr) -> str:
    """An expression as C source."""
    return str(_Printer().doprint(expression))


def line_sources(lines: Iterable[Line], indent: str) -> list[str]:
    """Assignments of local constants, with the stages' titles as comments."""
    sources = []
    for line in lines:
        if line.title:
            sources.append(f"{indent}/* {line.title} */")
        sources.append(f"{indent}const double {line.symbol} = {print_c(line.expression)};")
    return sources


def c_prototype(kernel: Kernel, system: str, orbit: str | None) -> str:
    """Declaration of one function, without the semicolon."""
    parameters = [_declare(a, constant=True) for a in kernel.arguments]
    parameters += [_declare(o, constant=False) for o in kernel.outputs]
    return f"void {c_function(system, kernel.name, orbit)}(\n    {', '.join(parameters)})"


def c_kernel(kernel: Kernel, system: str, orbit: str | None) -> str:
    """Definition of one function."""
    body = body_of(kernel)
    lines = [
        f"/* {kernel.title}",
        f" * Takes {', '.join(shape_text(a) for a in kernel.arguments)};"
        f" gives {', '.join(shape_text(o) for o in kernel.outputs)}, row by row.",
        f" * Operations: {body.operations}. Intermediate terms: {len(body.lines)}. */",
        c_prototype(kernel, system, orbit),
        "{",
    ]
    for argument in kernel.arguments:
        if not set(argument.symbols) & body.used:
            lines.append(f"    (void){argument.name};")
        for position, symbol in enumerate(argument.symbols):
            if symbol in body.used and (argument.shape or str(symbol) != argument.name):
                value = f"{argument.name}[{position}]" if argument.shape else argument.name
                lines.append(f"    const double {symbol} = {value};")
    lines += line_sources(body.lines, "    ")
    for output, expressions in zip(kernel.outputs, body.outputs, strict=True):
        for position, expression in enumerate(expressions):
            target = f"{output.name}[{position}]" if output.shape else f"*{output.name}"
            lines.append(f"    {target} = {print_c(expression)};")
    lines.append("}")
    return "\n".join(lines)


def _declare(array: Argument | Output, *, constant: bool) -> str:
    qualifier = "const " if constant else ""
    if not array.shape:
        return f"double {array.name}" if constant else f"double *{array.name}"
    size = 1
    for extent in array.shape:
        size *= extent
    return f"{qualifier}double {array.name}[{size}]" if size else f"{qualifier}double *{array.name}"

"""Kernels as C99 functions over plain arrays, with a header any C program can include."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from functools import lru_cache

import sympy as sp
from sympy.printing.c import C99CodePrinter
from sympy.printing.precedence import PRECEDENCE

from nonsmooth.derive.codegen.any_arithmetic import Ordered
from nonsmooth.derive.codegen.body import Body, Constant, Line, body_of, split
from nonsmooth.derive.codegen.function import (
    c_declaration,
    c_statement,
    function_of_kernel,
    listed,
)
from nonsmooth.derive.equations.program import Array, Kernel, required
from nonsmooth.derive.errors import DerivationError
from nonsmooth.derive.flows.entire import ExponentialDifference

_IN_LANES = (
    "spectrum",
    "equations",
    "trace",
    "reduced",
)  # kernels that functions of many points call
_ITERATED = "reduced"  # the argument that changes while the others stay


class _Printer(Ordered, C99CodePrinter):
    """C expressions: products for integer powers, calls for the rest.

    A `scope` computes each set of differences of the exponential once, and in lanes each pair of
    a sine and a cosine.
    """

    def __init__(self, scope: Scope | None = None) -> None:
        super().__init__()
        self.scope = scope

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

    def _print_Constant(self, expr: Constant) -> str:
        number = repr(expr.double)
        return f"({number})" if number.startswith("-") else number

    def _print_Angle(self, expr: sp.Expr) -> str:
        return f"nonsmooth_angle({', '.join(self._print(a) for a in expr.args)})"

    def _print_ExponentialDifference(self, expr: sp.Expr) -> str:
        order, t, *factors = expr.args
        loads, rates, pairs, rest = _by_kind(factors)
        degree = sum(len(f.args) for f in factors)
        if not rates + pairs + rest:
            power = degree - 1 - int(order)
            return str(self.parenthesize(t**power / sp.factorial(power), PRECEDENCE["Pow"]))
        if degree == 1:
            return str(self._print(sp.exp(-rates[0] * t)))
        waves = [pair for pair in pairs if pair[1] == 0]
        name, numbers, lowest = "any", [], 0
        if not rest and len(rates) == 1 == loads and not pairs:
            name, numbers = "rate_load", rates
        elif not rest and not rates and len(pairs) == 1 and loads <= 2:
            name, numbers = ("pair", "pair_load", "pair_drift")[loads], list(pairs[0])
        elif not rest and not rates and len(pairs) == 2 and waves and not loads:
            other = pairs[pairs[0] == waves[-1]]
            name, numbers = "pair_wave", [*other, waves[-1][0]]
        if name == "any":
            lowest = 0 if order <= 3 else int(order)
            flat = [x for f in factors for x in (sp.Integer(len(f.args)), *f.args)]
            array = f"(const double[]){{{', '.join(self._print(x) for x in flat)}}}"
            call = f"nonsmooth_any({self._print(t)}, {lowest}, {len(factors)}, {array})"
        else:
            call = f"nonsmooth_{name}({', '.join(self._print(x) for x in (t, *numbers))})"
        if self.scope:
            call = self.scope.named("nonsmooth_derivatives", "derivatives", call)
        return f"{call}.d{order - lowest}"

    def _print_sin(self, expr: sp.Expr) -> str:
        return self._wave(expr, "sin", "sine")

    def _print_cos(self, expr: sp.Expr) -> str:
        return self._wave(expr, "cos", "cosine")

    def _wave(self, expr: sp.Expr, function: str, part: str) -> str:
        argument = self._print(expr.args[0])
        if not (self.scope and self.scope.lanes):
            return f"{function}({argument})"
        call = f"nonsmooth_wave_of(lanes, {argument})"
        return f"{self.scope.named('nonsmooth_wave', 'wave', call)}.{part}"

    def _print_Function(self, expr: sp.Expr) -> str:
        raise DerivationError(f"{type(expr).__name__} has no C: emit this system for Python only")


def _by_kind(
    factors: Sequence[sp.Tuple],
) -> tuple[int, list[sp.Expr], list[tuple[sp.Expr, ...]], list[sp.Tuple]]:
    """Characteristic factors by kind, for the choice of a C function.

    They are the number of factors s, the constants of other linear ones, the coefficients
    of quadratic ones, and the remaining factors.
    """
    linear = [f.args[0] for f in factors if len(f.args) == 1]
    pairs = [f.args for f in factors if len(f.args) == 2]
    rates = [c for c in linear if c != 0]
    return len(linear) - len(rates), rates, pairs, [f for f in factors if len(f.args) > 2]


class Scope:
    """A block of C that computes each set of derivatives of exponential differences once.

    In `lanes` it is one turn of a loop over them, whose sines and cosines vectorise.
    """

    def __init__(self, indent: str, lanes: bool = False) -> None:
        self.indent = indent
        self.lanes = lanes
        self._names: dict[str, str] = {}
        self._new: list[str] = []

    def nested(self) -> Scope:
        """A block inside this one, which knows what has been computed so far."""
        inner = Scope(self.indent + "    ", self.lanes)
        inner._names = dict(self._names)
        return inner

    def entry(self, array: Array, position: int) -> str:
        """C expression of one entry of an array."""
        if not self.lanes:
            return f"{array.name}[{position}]" if array.shape else f"*{array.name}"
        return f"{array.name}[{position}*lanes + lane]" if position else f"{array.name}[lane]"

    def named(self, kind: str, name: str, call: str) -> str:
        """Name of the result of a call; the first time a declaration is prepared."""
        if call not in self._names:
            self._names[call] = f"{name}_{len(self._names)}"
            self._new.append(f"{self.indent}const {kind} {self._names[call]} = {call};")
        return self._names[call]

    def assigned(self, target: str, expression: sp.Expr) -> list[str]:
        """Source lines of one assignment, after the declarations that it is the first to need."""
        calls = (ExponentialDifference, sp.sin, sp.cos) if self.lanes else (ExponentialDifference,)
        text = (_Printer(self)._print if expression.has(*calls) else print_c)(expression)
        declared, self._new = self._new, []
        return [*declared, f"{self.indent}{target} = {text};"]


_PRINTER = _Printer()


@lru_cache(maxsize=1 << 14)  # kernels of one orbit share most of their expressions
def print_c(expression: sp.Expr) -> str:
    """C source of an expression."""
    return str(_PRINTER._print(sp.sympify(expression)))


def line_sources(lines: Iterable[Line], scope: Scope) -> list[str]:
    """Source lines of local constants, with the titles of stages as comments."""
    sources = []
    for line in lines:
        if line.title:
            sources.append(f"{scope.indent}/* {line.title} */")
        sources += scope.assigned(f"const double {line.symbol}", line.expression)
    return sources


def c_kernel(kernel: Kernel, system: str, orbit: str | None) -> str:
    """C definition of one kernel, which ends behind the last output that is wanted.

    One that functions of many points call is the case of one lane of its `in_lane`.
    """
    body, described = body_of(kernel), function_of_kernel(kernel, system, orbit)
    function = described.name
    comment = [
        f"/* {kernel.title}",
        f" * Operations: {body.operations}. Intermediate terms: {len(body.lines)}. */",
    ]
    # orbits with other parameters may have the same body
    public = ["NONSMOOTH_UNMERGED"] if orbit is not None else []
    public += [described.prototype, "{"]
    if not _runs_in_lanes(kernel):
        return "\n".join([*comment, *public, *_statements(body, lanes=False), "}"])
    fixed, moving = _parts(kernel)
    if fixed is not None:
        comment += [*_for_one_lane(fixed, fixed_part(function)), ""]
        public += [
            f"    double fixed[{count_of_fixed(kernel)}];",
            *_called(fixed_part(function), fixed),
        ]
    return "\n".join(
        [*comment, *_for_one_lane(moving, function), "", *public, *_called(function, moving), "}"]
    )


def _for_one_lane(body: Body, function: str) -> list[str]:
    """C definition of what a kernel computes for one lane."""
    arrays = [f"const double *{a.name}" for a in body.arguments]
    arrays += [f"double *{o.name}" for o in body.outputs]
    declared = c_declaration(in_lane(function), ["int lanes", "int lane", *arrays])
    statements = _statements(body, lanes=True)
    unused = [] if any("lanes" in line for line in statements) else ["    (void)lanes;"]
    return [f"static NONSMOOTH_INLINE {declared}", "{", *unused, *statements, "}"]


def _called(function: str, body: Body) -> list[str]:
    """C statement that computes a kernel for the only lane."""
    given = [*(a.name for a in body.arguments), *(o.name for o in body.outputs)]
    return c_statement(lane_call(function, given, "1, 0"), "    ")


def lane_call(function: str, given: Iterable[str], lane: str = "lanes, lane") -> str:
    """C statement that computes a kernel, of which this is the function, for one lane."""
    return f"{in_lane(function)}({lane}, {', '.join(given)});"


@lru_cache(maxsize=64)
def _parts(kernel: Kernel) -> tuple[Body | None, Body]:
    """What of a kernel does not depend on the argument that changes in iterations, and the rest.

    The first part is None if there is nothing of it.
    """
    body = body_of(kernel)
    given = tuple(a for a in body.arguments if a.name != _ITERATED)
    iterated = tuple(a for a in body.arguments if a.name == _ITERATED)
    fixed, moving = split(body, {s for argument in given for s in argument.entries})
    left = {line.symbol for line in moving}
    ends = tuple(sum(line.symbol in left for line in body.lines[:end]) for end in body.ends)
    rest = replace(body, lines=moving, ends=ends)
    carried = tuple(line.symbol for line in fixed if line.symbol in rest.used)
    if not iterated or not carried:
        return None, body
    values = Array.of("fixed", carried)
    needed = required([(line.symbol, line.expression) for line in fixed], carried)
    lines = tuple(line for line in fixed if line.symbol in needed)
    return (
        Body(given, lines, (values,), (len(lines),)),
        replace(rest, arguments=(*given, values, *iterated)),
    )


def count_of_fixed(kernel: Kernel) -> int:
    """Number of those values of a kernel that iterations carry from one to the next."""
    fixed, _ = _parts(kernel)
    return 0 if fixed is None else len(fixed.outputs[0].entries)


def fixed_part(function: str) -> str:
    """Name of the function that computes what iterations of a kernel have in common."""
    return f"{function}_fixed"


def _runs_in_lanes(kernel: Kernel) -> bool:
    """Whether functions of many points call a kernel, and it computes anything."""
    return kernel.name in _IN_LANES and any(output.entries for output in kernel.outputs)


def in_lane(function: str) -> str:
    """Name of the function that computes a kernel for one lane: entry i is at [i*lanes + lane]."""
    return f"{function}_in_lane"


def _statements(body: Body, *, lanes: bool) -> list[str]:
    """C statements of a kernel, for one lane or for the only point."""
    lines = []
    scope, some = Scope("    ", lanes), len(body.outputs) > 1
    for place, (output, part) in enumerate(zip(body.outputs, body.parts, strict=True)):
        for argument in body.arguments:
            if argument.since == place:
                lines += _loads(argument, body.used, scope)
        lines += line_sources(part, scope)
        if some:
            lines += [f"    if ({output.name}) {{", *_stores(output, scope.nested()), "    }"]
        else:
            lines += _stores(output, scope)
        later = [f"!{o.name}" for o in body.outputs[place + 1 :]]
        if later:
            lines += [f"    if ({' && '.join(later)})", "        return;"]
    return lines


def _loads(argument: Array, used: frozenset[sp.Symbol], scope: Scope) -> list[str]:
    """C statements that name the entries of an argument."""
    if not set(argument.entries) & used:
        return [f"    (void){argument.name};"]
    if not argument.shape:
        return []
    named = (
        f"{symbol} = {scope.entry(argument, position)}"
        for position, symbol in enumerate(argument.entries)
        if symbol in used
    )
    return listed("const double ", named, ";", "    ", " " * 8)


def _stores(output: Array, scope: Scope) -> list[str]:
    """C statements that fill an output, its zeros by a loop where there are some.

    A loop over lanes has no loop inside: compilers would not use vectors for it.
    """
    expressions = output.entries
    some = not scope.lanes and expressions.count(sp.S.Zero) > 2
    head = f"{scope.indent}for (int i = 0; i < {len(expressions)}; ++i)"
    return [
        *([head, f"{scope.indent}    {output.name}[i] = 0.0;"] if some else []),
        *(
            line
            for position, expression in enumerate(expressions)
            if expression != 0 or not some
            for line in scope.assigned(scope.entry(output, position), expression)
        ),
    ]

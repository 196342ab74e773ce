"""Dwell times in closed form: exit conditions that are linear in time or have one frequency."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import sympy as sp

from nonsmooth.derive.equations.program import Stages, assign, filled
from nonsmooth.derive.flows.modal import TIME
from nonsmooth.derive.symbols import Symbol, Symbols


class Angle(sp.Function):
    """Angle in [0, 2 pi) of a point (cosine, sine): written Angle(sine, cosine)."""

    nargs = 2

    def fdiff(self, argindex: int = 1) -> sp.Expr:
        """Derivative by the sine (1) or the cosine (2)."""
        sine, cosine = self.args
        square = sine**2 + cosine**2
        return cosine / square if argindex == 1 else -sine / square


LINEAR, RETURN = "linear in time", "first return"


@dataclass(frozen=True)
class ExplicitTime:
    """A dwell time in closed form, by one of the rules `LINEAR` and `RETURN`.

    `stages` compute what `time` contains, and `functions` are the values of cosine and sine
    that the rule fixes. `identities` between the rule's symbols shorten expressions.
    """

    rule: str
    stages: Stages
    functions: Mapping[sp.Expr, sp.Expr]
    time: sp.Expr
    identities: tuple[Mapping[sp.Expr, sp.Expr], ...] = ()

    def shorten(self, expression: sp.Expr) -> sp.Expr:
        """The expression after the identities of the rule are applied."""
        for identity in self.identities:
            expression = sp.expand(expression.subs(identity, simultaneous=True))
        return expression


def explicit_time(
    coefficients: Mapping[sp.Expr, sp.Expr], dwell: sp.Symbol, variables: Symbols
) -> ExplicitTime | None:
    """Closed form of the dwell time after which an exit condition is first met; else None.

    `coefficients` are those of each basis function in the boundary's function of time, and
    `variables` are what the state may contain beside parameters and spectrum.
    """
    present = {f: sp.expand(c) for f, c in coefficients.items()}
    present = {f: c for f, c in present.items() if c != 0}
    return _linear_time(present) or _first_return(present, dwell, variables)


def _linear_time(present: Mapping[sp.Expr, sp.Expr]) -> ExplicitTime | None:
    """Dwell time of an exit condition ``c + s t = 0``; None for another condition."""
    if TIME not in present or set(present) - {sp.Integer(1), TIME}:
        return None
    constant = present.get(sp.Integer(1), sp.Integer(0))
    return ExplicitTime(LINEAR, (), {}, -constant / sp.factor(present[TIME]))


def _first_return(
    present: Mapping[sp.Expr, sp.Expr], dwell: sp.Symbol, variables: Symbols
) -> ExplicitTime | None:
    """Dwell time of an exit condition ``a cos(w t) + b sin(w t) + c = 0`` that is met rising.

    None for another condition. Rising through zero the derivative is w s with
    s = sqrt(a^2 + b^2 - c^2), which fixes cosine and sine; the angle in (0, 2 pi) is the
    first return.
    """
    oscillating = [f for f in present if isinstance(f, sp.cos | sp.sin)]
    arguments = {f.args[0] for f in oscillating}
    if len(arguments) != 1 or set(present) - {sp.Integer(1), *oscillating}:
        return None
    (argument,) = arguments
    cosine, sine = sp.cos(argument), sp.sin(argument)
    title = f"first return of {dwell}"
    parts, (a, b, c) = assign(
        title,
        [Symbol(part, dwell) for part in ("cosine part", "sine part", "constant part")],
        [present.get(f, sp.Integer(0)) for f in (cosine, sine, sp.Integer(1))],
    )
    square = a**2 + b**2
    identities: tuple[Mapping[sp.Expr, sp.Expr], ...] = ()
    if c == 0:
        scale, (r,) = assign(title, [Symbol("amplitude", dwell)], [sp.sqrt(square)])
        at = (b / r, -a / r)
        if a.is_Symbol and b.is_Symbol:
            parts_of = ((present[cosine], a), (present[sine], b))
            identities = _amplitude_identities(parts_of, r, variables)
    else:
        scale, (s,) = assign(title, [Symbol("rate", dwell)], [sp.sqrt(square - c**2)])
        at = ((b * s - a * c) / square, -(b * c + a * s) / square)
    naming, values = assign(title, [Symbol("cosine", dwell), Symbol("sine", dwell)], at)
    if identities:
        identities = ({**identities[0], **dict(zip(values, at, strict=True))}, identities[1])
    stages = filled((parts, scale, naming))
    time = Angle(values[1], values[0]) / (argument / TIME)
    return ExplicitTime(RETURN, stages, {cosine: values[0], sine: values[1]}, time, identities)


def _amplitude_identities(
    parts: Sequence[tuple[sp.Expr, sp.Symbol]], r: sp.Expr, variables: Symbols
) -> tuple[dict[sp.Expr, sp.Expr], dict[sp.Expr, sp.Expr]]:
    """State symbols in terms of a and b, and a^2 = r^2 - b^2: the state reduces to r."""
    used = set().union(*(e.free_symbols for e, _ in parts))
    states = [s for s in variables if s in used]
    solution = _linear_solution([e - s for e, s in parts], states)
    solved = {x: v for x, v in zip(states, solution, strict=True) if x != v}
    (_, a), (_, b) = parts
    return solved, {a**2: r**2 - b**2}


def _linear_solution(equations: Sequence[sp.Expr], unknowns: Symbols) -> Sequence[sp.Expr]:
    """Solution of linear equations; the unknowns themselves if there is none."""
    if any(sp.diff(e, x, y) != 0 for e in equations for x in unknowns for y in unknowns):
        return unknowns
    return next(iter(sp.linsolve(equations, unknowns)), unknowns)

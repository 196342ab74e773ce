"""The start of an orbit in functions of its dwell times, where nothing remains to be solved."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import sympy as sp

from nonsmooth.derive.document.blocks import Line
from nonsmooth.derive.document.notation.arrange import by_function
from nonsmooth.derive.document.views.view import View

__all__ = ["ExplicitStart", "explicit_start"]

# a longer numerator is left to Cramer's rule
_MOST_TERMS = 4


@dataclass(frozen=True)
class ExplicitStart:
    """Determinant and coordinates of a start, written out."""

    determinant: Line
    coordinates: tuple[Line, ...]  # each a numerator over the determinant
    because: str  # text of the identity by which the products are shorter


def explicit_start(view: View) -> ExplicitStart | None:
    """The start written out; None if unknowns remain, or if it takes too many terms."""
    reduction, notation = view.equations.reduction, view.naming.notation
    if reduction.unknowns or not reduction.determinants:
        return None
    ((symbol, _),) = reduction.determinants
    assigned = dict(a for stage in reduction.stages for a in stage.assignments)
    kernel, written = _inlined(view, assigned), _inlined(view, view.written)
    relations = _relations(view)

    def short(expression: sp.Expr) -> tuple[sp.Expr, ...]:
        expanded = sp.expand(notation.plain(expression.xreplace(written)))
        for product, value in relations:
            expanded = sp.expand(expanded.subs(product, value))
        return by_function(notation, expanded)

    letter, period = notation.symbol(symbol), view.equations.itinerary.period
    below = f"{letter}({notation.symbol(period.symbol)})" if period else letter
    lines = [Line(letter, "=", notation.signed(short(symbol)), symbol, kernel[symbol])]
    coordinates = [q for q in view.equations.chain.start.coordinates if q in assigned]
    for q in coordinates:
        terms = short(sp.expand(assigned[q] * symbol))
        if len(terms) > _MOST_TERMS:
            return None
        pieces = (rf"\frac{{{' '.join(notation.signed(terms))}}}{{{below}}}",)
        lines.append(Line(notation.symbol(q), "=", pieces, q, assigned[q].xreplace(kernel)))
    return ExplicitStart(lines[0], tuple(lines[1:]), _because(view, relations))


def _inlined(view: View, assigned: Mapping[sp.Symbol, sp.Expr]) -> dict[sp.Symbol, sp.Expr]:
    """Expressions of the reduction's symbols in functions of time and constants alone."""
    found: dict[sp.Symbol, sp.Expr] = {}
    for stage in view.equations.reduction.stages:
        for symbol, _ in stage.assignments:
            if symbol not in view.naming.notation.functions:
                found[symbol] = assigned[symbol].xreplace(found)
    return found


def _relations(view: View) -> list[tuple[sp.Expr, sp.Expr]]:
    """Products of entries of projectors, and what they equal because of P P = P."""
    found: dict[sp.Expr, sp.Expr] = {}
    size = len(view.naming.positions)
    for flow in view.flows.values():
        for function, matrix in zip(flow.basis, flow.matrices, strict=True):
            if not isinstance(function, sp.cos):
                continue
            block = matrix[:size, :size]
            for entry in block * block - block:
                entry = sp.expand(entry)
                mixed = [t for t in sp.Add.make_args(entry) if len(t.free_symbols) > 1]
                if len(mixed) == 1:
                    coefficient, product = mixed[0].as_coeff_Mul()
                    found.setdefault(product, sp.factor(-(entry - mixed[0]) / coefficient))
    return list(found.items())


def _because(view: View, relations: list[tuple[sp.Expr, sp.Expr]]) -> str:
    latex = view.naming.notation.latex
    shown = [f"${latex(product)} = {latex(value)}$" for product, value in relations]
    return f" with {', '.join(shown)}, as projectors have it" if shown else ""

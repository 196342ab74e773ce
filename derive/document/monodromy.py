"""Saltation matrices of an orbit as they are written, and the trace of their product."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import sympy as sp

from nonsmooth.derive.declaration.algebra import cancel, factor
from nonsmooth.derive.document.symbols import grouped_by
from nonsmooth.derive.document.view import View
from nonsmooth.derive.equations.linearisation import saltation_matrix
from nonsmooth.derive.symbols import Symbol, meaning_of

__all__ = [
    "MonodromyTrace",
    "monodromy_trace",
    "saltations",
    "where_zero",
]

# more products of functions of time are not written out
_MOST_TERMS = 12
# a factor of more terms gets a letter
_LONG = 3


@dataclass(frozen=True)
class MonodromyTrace:
    """Trace of a monodromy matrix as a sum of terms."""

    terms: tuple[sp.Expr, ...]
    names: dict[sp.Symbol, sp.Expr]  # symbols for entries of saltation matrices
    factors: dict[sp.Symbol, sp.Expr]  # symbols for long factors


def saltations(view: View) -> tuple[sp.Matrix, ...]:
    """Saltation matrix (N x N) of each transition, where its switching condition holds.

    It is written in the states at the ends of the phases, for a reversible orbit in the
    coordinates of its start.
    """
    links, found = view.links, []
    every = (a for stage in view.equations.chain.stages for a in stage.assignments)
    resets = {symbol: value for symbol, value in every if meaning_of(symbol) == "reset"}
    for index, link in enumerate(links):
        following = links[(index + 1) % len(links)].flow
        behind = following.velocity(link.following.xreplace(resets))
        matrix = saltation_matrix(link.reset, link.normal, link.velocity, behind)
        condition = link.exit
        if view.reversible:
            images = {
                s: e for s, e in zip(link.after, view.images[index], strict=True) if s.is_Symbol
            }
            matrix = matrix.subs(images, simultaneous=True)
            condition = condition.subs(images, simultaneous=True)
        states = sorted(filter(view.naming.notation.is_state, condition.free_symbols), key=str)
        found.append(where_zero(sp.expand(condition), states, matrix))
    return tuple(found)


def monodromy_trace(view: View) -> MonodromyTrace | None:
    """Trace of the monodromy matrix in functions of the dwell times; None if it is too long."""
    notation, names = view.naming.notation, dict[sp.Symbol, sp.Expr]()
    product = sp.eye(len(view.naming.system.states))
    for index, (link, matrix) in enumerate(zip(view.links, saltations(view), strict=True), 1):
        named = matrix.as_mutable()
        for i in range(matrix.rows):
            for j in range(matrix.cols):
                if not matrix[i, j].is_number:
                    latex = rf"\left(S_{{{index}}}\right)_{{{i + 1}{j + 1}}}"
                    symbol = Symbol("written", f"saltation_{index}_{i}{j}", latex)
                    named[i, j], names[symbol] = symbol, matrix[i, j]
        product = named * link.transfer * product
    total = sp.expand(product.trace())
    functions = [s for s in total.free_symbols if notation.is_function(s)]
    collected = grouped_by(total, [*functions, *names])
    if len(collected) > _MOST_TERMS:
        return None
    order = {s: i for i, s in enumerate((*notation.functions, *names))}
    # functions with one coefficient, but for frequencies, share it
    groups: dict[sp.Expr, sp.Expr] = {}
    for monomial in sorted(collected, key=lambda m: sorted(order[s] for s in m.free_symbols)):
        entry, function = monomial.as_independent(*functions, as_Add=False)
        inner, outer = factor(collected[monomial]).as_independent(
            *notation.projectors, as_Add=False
        )
        key, sign = (-outer * entry, -1) if -outer * entry in groups else (outer * entry, 1)
        groups[key] = groups.get(key, sp.Integer(0)) + sign * inner * function
    long = [outer for outer in groups if len(sp.Add.make_args(outer)) > _LONG]
    letters = {k: Symbol("written", f"kappa{i}", rf"\kappa_{{{i}}}") for i, k in enumerate(long, 1)}
    terms = [
        sp.Mul(letters.get(outer, outer), sp.factor_terms(inner)) for outer, inner in groups.items()
    ]
    return MonodromyTrace(tuple(terms), names, {letter: k for k, letter in letters.items()})


def where_zero(
    condition: sp.Expr, states: Iterable[sp.Symbol], matrix: sp.Matrix
) -> sp.ImmutableMatrix:
    """A matrix where a switching condition holds, which is solved for one of the states.

    The first with a number as its coefficient is preferred.
    """
    slopes = {s: slope for s in states if (slope := sp.diff(condition, s)) != 0}
    if slopes:
        state = min(slopes, key=lambda s: not slopes[s].is_number)
        solution = sp.expand(-(condition - slopes[state] * state) / slopes[state])
        matrix = matrix.subs(state, solution)
    return sp.ImmutableMatrix(matrix.applyfunc(lambda e: factor(cancel(e))))

"""Saltation matrices of an orbit as they are written, and the trace of their product."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import sympy as sp

from nonsmooth.derive.declaration.algebra import cancel, factor
from nonsmooth.derive.document.notation.symbols import grouped_by
from nonsmooth.derive.document.views.view import View
from nonsmooth.derive.equations.linearisation import saltation_matrix
from nonsmooth.derive.symbols import Symbol, meaning_of

__all__ = [
    "FACTOR",
    "MonodromyTrace",
    "monodromy_trace",
    "saltations",
    "where_zero",
]

FACTOR = Symbol("written", "kappa", r"\kappa")
# more products of functions of time are not written out
_MOST_TERMS = 12


@dataclass(frozen=True)
class MonodromyTrace:
    """Trace of a monodromy matrix as a sum of terms."""

    terms: tuple[sp.Expr, ...]
    names: dict[sp.Symbol, sp.Expr]  # symbols for entries of saltation matrices or a long factor


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
    groups: dict[tuple[sp.Expr, sp.Expr], sp.Expr] = {}
    for monomial in sorted(collected, key=lambda m: sorted(order[s] for s in m.free_symbols)):
        entry, function = monomial.as_independent(*functions, as_Add=False)
        coefficient = factor(collected[monomial])
        inner, outer = coefficient.as_independent(*notation.projectors, as_Add=False)
        key, sign = ((entry, -outer), -1) if (entry, -outer) in groups else ((entry, outer), 1)
        groups[key] = groups.get(key, sp.Integer(0)) + sign * inner * function
    keys = [outer for entry, outer in groups if entry == 1]
    long = _long(keys)
    if long is not None:
        names[FACTOR], other = long, next(k for k in keys if k != long)
        sign = 1 if sp.expand(long + other - 1) == 0 else -1
        groups = {
            (e, FACTOR if k == long else 1 - FACTOR if k == other else k): (
                sign * inner if k == other else inner
            )
            for (e, k), inner in groups.items()
        }
    joined: dict[sp.Expr, list[sp.Expr]] = {}
    for (entry, outer), inner in groups.items():
        joined.setdefault(entry, []).append(sp.Mul(outer, sp.factor_terms(inner)))
    terms: list[sp.Expr] = []
    for entry, parts in joined.items():
        terms += parts if entry == 1 else [sp.Mul(entry, sp.Add(*parts))]
    used = set().union(*(term.free_symbols for term in terms))
    return MonodromyTrace(tuple(terms), {s: e for s, e in names.items() if s in used})


def _long(keys: list[sp.Expr]) -> sp.Expr | None:
    """A long factor k if the only other factor is 1 - k or k - 1; else None."""
    different = list(dict.fromkeys(keys))
    if len(different) != 2 or len(sp.Add.make_args(different[0])) < 4:
        return None
    first, second = different
    apart = (first + second, first - second)
    return first if any(sp.expand(e - 1) == 0 for e in apart) else None


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

"""Saltation matrices of an orbit as they are written, and the trace of their product."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from nonsmooth.derive.declaration.algebra import cancel, factor
from nonsmooth.derive.document.notation.arrange import grouped_by
from nonsmooth.derive.document.views.view import View
from nonsmooth.derive.equations.linearisation import saltation_matrix

__all__ = ["MonodromyTrace", "keeps_volume", "monodromy_trace", "saltations"]

# more products of functions of time are not written out
_MOST_TERMS = 12


@dataclass(frozen=True)
class MonodromyTrace:
    """Trace of a monodromy matrix as a sum of terms."""

    terms: tuple[sp.Expr, ...]
    # (LaTeX, expression) of symbols for entries of saltation matrices or a long factor
    names: dict[sp.Symbol, tuple[str, sp.Expr]]


def saltations(view: View) -> tuple[sp.Matrix, ...]:
    """Saltation matrix (N x N) of each transition, where its switching condition holds.

    It is written in the states at the ends of the phases, for a reversible orbit in the
    coordinates of its start.
    """
    links, assigned = view.links, _resets(view)
    found = []
    for index, link in enumerate(links):
        following = links[(index + 1) % len(links)].flow
        behind = following.velocity(link.following.xreplace(assigned))
        matrix = saltation_matrix(link.reset, link.normal, link.velocity, behind)
        condition = link.exit
        if view.reversible:
            images = {
                s: e for s, e in zip(link.after, view.images[index], strict=True) if s.is_Symbol
            }
            matrix = matrix.subs(images, simultaneous=True)
            condition = condition.subs(images, simultaneous=True)
        at_boundary = _solved(view, sp.expand(condition))
        found.append(
            sp.ImmutableMatrix(matrix.subs(at_boundary).applyfunc(lambda e: factor(cancel(e))))
        )
    return tuple(found)


def keeps_volume(view: View) -> bool:
    """Whether no transition changes volumes of the state space; the flows never do."""
    return all(cancel(matrix.det()) == 1 for matrix in saltations(view))


def monodromy_trace(view: View) -> MonodromyTrace | None:
    """Trace of the monodromy matrix in functions of the dwell times; None if it is too long."""
    names: dict[sp.Symbol, tuple[str, sp.Expr]] = {}
    product = sp.eye(len(view.naming.system.states))
    for index, (link, matrix) in enumerate(zip(view.links, saltations(view), strict=True), 1):
        named = matrix.as_mutable()
        for i in range(matrix.rows):
            for j in range(matrix.cols):
                if not matrix[i, j].is_number:
                    symbol = sp.Symbol(f"saltation_{index}_{i}{j}", real=True)
                    latex = rf"\left(S_{{{index}}}\right)_{{{i + 1}{j + 1}}}"
                    named[i, j], names[symbol] = symbol, (latex, matrix[i, j])
        product = named * link.transfer * product
    total = sp.expand(product.trace())
    functions = [s for s in total.free_symbols if view.naming.notation.is_function(s)]
    collected = grouped_by(total, [*functions, *names])
    if len(collected) > _MOST_TERMS:
        return None
    order = {s: i for i, s in enumerate((*view.naming.notation.functions, *names))}
    groups: dict[tuple[sp.Expr, sp.Expr], sp.Expr] = {}
    for monomial in sorted(collected, key=lambda m: sorted(order[s] for s in m.free_symbols)):
        entry, function = monomial.as_independent(*functions, as_Add=False)
        outer, inner = _split(collected[monomial], view.naming.notation.projectors)
        key, sign = ((entry, -outer), -1) if (entry, -outer) in groups else ((entry, outer), 1)
        groups[key] = groups.get(key, sp.Integer(0)) + sign * inner * function
    keys = [outer for entry, outer in groups if entry == 1]
    factor = _long(keys)
    if factor is not None:
        symbol, other = sp.Symbol("kappa", real=True), next(k for k in keys if k != factor)
        names[symbol] = (r"\kappa", factor)
        sign = 1 if sp.expand(factor + other - 1) == 0 else -1
        groups = {
            (e, symbol if k == factor else 1 - symbol if k == other else k): (
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
    return MonodromyTrace(tuple(terms), {s: n for s, n in names.items() if _within(s, terms)})


def _within(symbol: sp.Symbol, terms: list[sp.Expr]) -> bool:
    return any(symbol in term.free_symbols for term in terms)


def _split(coefficient: sp.Expr, projectors: tuple[sp.Symbol, ...]) -> tuple[sp.Expr, sp.Expr]:
    """The factors of a coefficient that contain entries of projectors, and the others."""
    factors = sp.Mul.make_args(factor(coefficient))
    outer = sp.Mul(*(f for f in factors if f.free_symbols & set(projectors)))
    inner = sp.Mul(*(f for f in factors if not f.free_symbols & set(projectors)))
    return outer, inner


def _long(keys: list[sp.Expr]) -> sp.Expr | None:
    """A long factor k if the only other factor is 1 - k or k - 1; else None."""
    different = list(dict.fromkeys(keys))
    if len(different) != 2 or len(sp.Add.make_args(different[0])) < 4:
        return None
    first, second = different
    apart = (first + second, first - second)
    return first if any(sp.expand(e - 1) == 0 for e in apart) else None


def _resets(view: View) -> dict[sp.Symbol, sp.Expr]:
    """Expressions that the chain assigns behind the transitions, by their symbols."""
    assignments = (a for s in view.equations.chain.stages for a in s.assignments)
    return {s: e for s, e in assignments if str(s).endswith("_reset")}


def _solved(view: View, condition: sp.Expr) -> dict[sp.Symbol, sp.Expr]:
    """A switching condition solved for one state, by the state's symbol.

    A state with a number as its coefficient is preferred.
    """
    notation = view.naming.notation
    states = sorted((s for s in condition.free_symbols if notation.is_state(s)), key=str)
    if not states:
        return {}
    state = min(states, key=lambda s: not sp.diff(condition, s).is_number)
    slope = sp.diff(condition, state)
    return {state: sp.expand(-(condition - slope * state) / slope)}

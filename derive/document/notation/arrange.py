"""Sums arranged function by function of time, as one writes a sum of oscillations."""

from __future__ import annotations

from collections.abc import Iterable

import sympy as sp

from nonsmooth.derive.document.notation.symbols import Notation

__all__ = ["by_function", "grouped_by", "signed"]


def by_function(notation: Notation, expression: sp.Expr) -> tuple[sp.Expr, ...]:
    """Terms of a sum: each function of time once, times its coefficient, then the rest."""
    expression = sp.expand(notation.plain(expression))
    known = list(notation.functions)
    functions = sorted(
        (s for s in expression.free_symbols if notation.is_function(s)),
        key=lambda s: (str(s).startswith("sin"), known.index(s) if s in known else -1, str(s)),
    )
    collected = grouped_by(expression, functions)
    order = {f: i for i, f in enumerate(functions)}
    inner = {a for s in functions if s in known for a in notation.functions[s].free_symbols}
    # functions with one coefficient, but for frequencies, share it
    shared: dict[sp.Expr, sp.Expr] = {}
    terms: list[sp.Expr] = []
    for function in sorted(collected, key=lambda f: (order.get(f, len(order)), str(f))):
        coefficient = _coefficient(notation, collected[function])
        moving = coefficient.free_symbols - inner
        frequency, core = coefficient.as_independent(*moving, as_Add=False)
        if function == 1 or not moving:
            terms.append(coefficient * function)
        else:
            shared[core] = shared.get(core, sp.Integer(0)) + frequency * function
    return (*(sp.Mul(core, total) for core, total in shared.items()), *terms)


def signed(notation: Notation, terms: Iterable[sp.Expr]) -> tuple[str, ...]:
    """LaTeX of the terms of a sum in the given order, each with its sign; wide ones are cut."""
    found: list[str] = []
    for term in terms:
        sign, text = notation.term(term)
        text = f"- {text}" if sign < 0 else f"+ {text}" if found else text
        found += notation.cut(term, text, leading=not found)
    return tuple(found)


def grouped_by(expression: sp.Expr, symbols: Iterable[sp.Symbol]) -> dict[sp.Expr, sp.Expr]:
    """Coefficient of each monomial in the symbols; the sum has to be expanded."""
    collected: dict[sp.Expr, sp.Expr] = {}
    symbols = list(symbols)
    for term in sp.Add.make_args(expression):
        coefficient, monomial = term.as_independent(*symbols, as_Add=False)
        collected[monomial] = collected.get(monomial, sp.Integer(0)) + coefficient
    return {m: c for m, c in collected.items() if c != 0}


def _coefficient(notation: Notation, coefficient: sp.Expr) -> sp.Expr:
    """A coefficient with its common factor in front, and entries of projectors factored."""
    factors = sp.Mul.make_args(sp.factor_terms(coefficient))
    return sp.Mul(*(_factored(notation, f) if f.is_Add else f for f in factors))


def _factored(notation: Notation, total: sp.Expr) -> sp.Expr:
    """A sum in which the factors of each entry of the projectors are collected.

    The number in its first term, which contains no state, is made positive by a minus sign
    in front of the sum.
    """
    if not total.free_symbols & set(notation.projectors):
        return notation.tidy(total)
    groups: dict[sp.Expr, sp.Expr] = {}
    for monomial, rest in grouped_by(sp.expand(total), notation.projectors).items():
        key, factor = _oriented(notation, sp.factor_terms(rest)), sp.Integer(1)
        if key.is_number:
            factor, key = rest, factor
        elif sp.expand(key - rest) != 0:
            factor = sp.Integer(-1)
        groups[key] = groups.get(key, sp.Integer(0)) + factor * monomial
    first = next((k for k in groups if not any(map(notation.is_state, k.free_symbols))), None)
    if first is None or _leading(groups[first]) > 0:
        return sp.Add(*(entries * key for key, entries in groups.items()))
    turned = sp.Add(*(-entries * key for key, entries in groups.items()))
    return sp.Mul(-1, turned, evaluate=False)


def _oriented(notation: Notation, key: sp.Expr) -> sp.Expr:
    """A factor or its negative, so that its first state, or else its number, is positive."""
    terms = sp.Add.make_args(key)
    leading = next(
        (t for t in terms if any(map(notation.is_state, t.free_symbols))),
        next((t for t in terms if t.is_number), None),
    )
    if leading is None:
        return -key if key.could_extract_minus_sign() else key
    return -key if leading.as_coeff_Mul()[0] < 0 else key


def _leading(entries: sp.Expr) -> sp.Expr:
    """The number that is added in a sum, or else the number that multiplies it."""
    return entries.as_coeff_Add()[0] or entries.as_coeff_Mul()[0]

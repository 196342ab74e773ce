"""Sums arranged as one writes them: oscillations function by function, polynomials by powers."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from nonsmooth.derive.document.blocks import width
from nonsmooth.derive.document.notation.printer import Notation
from nonsmooth.derive.document.notation.symbols import grouped_by
from nonsmooth.derive.symbols import meaning_of

__all__ = ["by_function", "characteristic_pieces", "polynomial_pieces"]

_LARGEST_BLOCK = 6
# of a block with more than two rows; more make coefficients that nobody reads
_MOST_SYMBOLS = 6
_MOST_TERMS = 12
# em of two lines
_LONGEST = 76.0


def by_function(notation: Notation, expression: sp.Expr) -> tuple[sp.Expr, ...]:
    """Terms of a sum: each function of time once, times its coefficient, then the rest."""
    expression = sp.expand(notation.plain(expression))
    known = list(notation.functions)
    functions = sorted(
        (s for s in expression.free_symbols if notation.is_function(s)),
        key=lambda s: (_is_sine(notation, s), known.index(s) if s in known else -1, str(s)),
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


def characteristic_pieces(
    notation: Notation, matrix: sp.Matrix, variable: str
) -> tuple[str, ...] | None:
    """LaTeX of det(lambda - A) as a product over the irreducible blocks of A.

    The pieces are those between which a line may break; None for a long polynomial.
    `matrix` is A (N x N), and `variable` the LaTeX of lambda.
    """
    blocks = matrix.strongly_connected_components()
    if max(map(len, blocks)) > _LARGEST_BLOCK:
        return None
    factors: dict[tuple[str, ...], int] = {}
    for block in blocks:
        part = matrix.extract(block, block)
        if len(block) > 2 and len(part.free_symbols) > _MOST_SYMBOLS:
            return None
        field = DomainMatrix.from_Matrix(part).to_field()
        expanded = [field.domain.to_sympy(c) for c in field.charpoly()]
        if any(len(sp.Add.make_args(sp.fraction(c)[0])) > _MOST_TERMS for c in expanded):
            return None
        coefficients = [sp.factor(c) for c in expanded]
        pieces = polynomial_pieces(notation, coefficients, variable)
        factors[pieces] = factors.get(pieces, 0) + 1
    found: list[str] = []
    for pieces, power in sorted(factors.items(), key=lambda f: (len(f[0]), f[0])):
        bare = len(pieces) == 1 or (len(factors) == 1 and power == 1)
        raised = f"^{{{power}}}" if power > 1 else ""
        if bare:
            found += [*pieces[:-1], pieces[-1] + raised]
        else:
            found += [rf"\left({' '.join(pieces)}\right){raised}"]
    return tuple(found) if sum(map(width, found)) <= _LONGEST else None


def polynomial_pieces(
    notation: Notation, coefficients: Sequence[sp.Expr], variable: str
) -> tuple[str, ...]:
    """LaTeX of the terms of a monic polynomial, the highest power first."""
    degree = len(coefficients) - 1
    pieces: list[str] = []
    for place, coefficient in enumerate(coefficients):
        if coefficient == 0:
            continue
        power = degree - place
        raised = variable if power == 1 else f"{variable}^{{{power}}}" if power else ""
        sign, text = notation.factor(coefficient) if power else notation.term(coefficient)
        if text == "1" and power:
            text = ""
        term = " ".join(filter(None, (text, raised)))
        pieces.append(f"- {term}" if sign < 0 else f"+ {term}" if pieces else term)
    return tuple(pieces)


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


def _is_sine(notation: Notation, symbol: sp.Symbol) -> bool:
    """Whether a symbol stands for a sine."""
    return isinstance(notation.functions.get(symbol), sp.sin) or meaning_of(symbol) == "sine"

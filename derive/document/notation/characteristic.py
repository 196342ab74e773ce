"""The characteristic polynomial of a matrix, where it is short enough to read."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from nonsmooth.derive.document.layout import width
from nonsmooth.derive.document.notation.symbols import Notation

__all__ = ["characteristic_pieces", "polynomial_pieces"]

_LARGEST_BLOCK = 6
# of a block with more than two rows; more make coefficients that nobody reads
_MOST_SYMBOLS = 6
_MOST_TERMS = 12
# em of two lines
_LONGEST = 76.0


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

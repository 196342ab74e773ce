"""Impulse responses: the functions of time of damped and forced motions, and their names.

A factor chi of a characteristic polynomial has a number, and the response h of a product of
factors has their numbers: h_12 is the inverse Laplace transform of 1/(chi_1 chi_2).
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import sympy as sp

from nonsmooth.derive.flows.entire import ExponentialDifference
from nonsmooth.derive.flows.modal import Flow

__all__ = ["Responses", "is_response", "responses_of"]

Factors = tuple[sp.Tuple, ...]

_LETTERS = (("h", r"\chi"), ("g", "p"), (r"\mathsf{h}", r"\mathsf{p}"))


@dataclass(frozen=True)
class Responses:
    """Numbers of characteristic factors, and letters that nothing else has."""

    # in the order of their numbers, from 1; the factor s of a constant has the number 0
    factors: Factors = ()
    # products of factors whose responses occur, short ones first
    products: tuple[Factors, ...] = ()
    letter: str = "h"  # LaTeX of the response
    polynomial: str = r"\chi"  # LaTeX of the factor

    def number(self, factor: sp.Tuple) -> int:
        """Number of a factor."""
        return 0 if factor == _CONSTANT else self.factors.index(factor) + 1

    def label(self, factors: Factors) -> str:
        """Numbers of the factors of a product, written as an index."""
        numbers = sorted(map(self.number, factors))
        return ("," if max(numbers) > 9 else "").join(map(str, numbers))

    def latex(self, order: int, factors: Factors, time: str) -> str:
        """LaTeX of a response, or of its derivative of some order, at a time."""
        primes = "'" * order if order < 4 else f"^{{({order})}}"
        return rf"{self.letter}_{{{self.label(factors)}}}{primes}\left({time}\right)"

    def knows(self, factors: Factors) -> bool:
        """Whether all factors have numbers."""
        return all(factor == _CONSTANT or factor in self.factors for factor in factors)


_CONSTANT = sp.Tuple(sp.Integer(0))


def is_response(flow: Flow) -> bool:
    """Whether a flow is written in impulse responses."""
    return any(function.has(ExponentialDifference) for function in flow.basis)


def responses_of(flows: Iterable[Flow], taken: Iterable[str]) -> Responses:
    """Numbers of the characteristic factors of flows, and letters for their responses.

    `taken` is the LaTeX of all symbols, whose letters are avoided.
    """
    known = {text.partition("_")[0] for text in taken}
    letter, polynomial = next((p for p in _LETTERS if not known & {*p}), _LETTERS[-1])
    products: dict[Factors, None] = {}
    for flow in flows:
        for function in flow.basis:
            for found in function.atoms(ExponentialDifference):
                products[tuple(found.args[2:])] = None
    ordered = sorted(products, key=lambda p: (len(p), sp.default_sort_key(sp.Tuple(*p))))
    factors = dict.fromkeys(f for product in ordered for f in product if f != _CONSTANT)
    return Responses(tuple(factors), tuple(ordered), letter, polynomial)

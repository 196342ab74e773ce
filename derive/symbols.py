"""Symbols that the derivation makes, each of which carries what it means.

Who makes a symbol says what it means, and who writes it asks for that: no other module composes a
name or reads one, which is for kernels. No such symbol equals one of a declaration, whatever the
user calls that: a parameter `x_1` is not the state x behind phase 1.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import sympy as sp

Symbols = Sequence[sp.Symbol]
Values = Mapping[sp.Symbol, sp.Expr]  # what stands, or is put, in the place of each symbol

# name of a symbol by its meaning, from its parts
_NAMES = {
    # a part of the spectrum, a number
    "spectrum": "{}{}",
    # a state behind a phase, 0 for the start, and behind the transition that follows
    "state": "{}_{}",
    "reset": "{}_{}_reset",
    # another symbol and what it is differentiated by
    "derivative": "{}_by_{}",
    # derivative of an expression by a symbol, from the end of the stages
    "slope": "slope_by_{}",
    # a state that the flow carries along, and on the boundary; the time to the boundary
    "carried": "carried_{}",
    "on boundary": "{}_on_boundary",
    "delay": "delay_{}",
    # vector fields around a transition
    "field before": "before_{}_{}",
    "field behind": "behind_{}_{}",
    # a product of matrices, the phase, the entry
    "product": "{}_{}_{}{}",
    # the value of a function of time: of which, and when
    "function": "{}",
    "half": "half_{}",
    # first return after a dwell time: parts of the condition, their amplitude, rate, cosine, sine
    "cosine part": "cosine_part_{}",
    "sine part": "sine_part_{}",
    "constant part": "constant_part_{}",
    "amplitude": "amplitude_{}",
    "rate": "rate_{}",
    "cosine": "cos_{}_return",
    "sine": "sin_{}_return",
    # what is affine in coordinates: its value where they are zero, the coefficient of one
    "constant": "{}_constant",
    "times": "{}_times_{}",
    "divisor": "{}_slope",
    # the same of a state: its place, the coordinate (1 for the constant), the dwell time
    "part": "part{}_of_{}_{}",
    # constant of a map: its row, the phase, a mark behind the transition
    "offset": "c_{}_{}{}",
    # linear equations and their elimination
    "coefficient": "coefficient{}",
    "right": "right{}",
    "determinant": "determinant",
    "numerator": "numerator{}",
    "without": "{}_without{}",
    # of a reduction: an equation, the coordinate at the start; of a forcing
    "equation": "equation{}",
    "start": "start",
    "phase": "phase",
    # what a document introduces: a name, and the LaTeX
    "written": "{0}",
}


class Symbol(sp.Symbol):
    """A symbol with a meaning, and with the symbols, names and numbers that belong to it.

    Its class has SymPy's name, by which SymPy orders the terms of a sum.
    """

    __slots__ = ("content", "meaning", "parts")
    content: tuple[Any, ...]  # by which SymPy tells and orders symbols
    meaning: str
    parts: tuple[Any, ...]

    def __new__(cls, meaning: str, *parts: Any, **assumptions: bool) -> Symbol:
        """Make the symbol of a meaning; it is real unless the assumptions say more."""
        name = _NAMES[meaning].format(*parts)
        symbol: Symbol = sp.Symbol.__xnew__(cls, name, **(assumptions or {"real": True}))
        symbol.meaning, symbol.parts = meaning, parts
        # ordered by name as all symbols are, and behind one of a declaration that has this name
        content = sp.Symbol._hashable_content(symbol)
        from_what = [part.content[0] if isinstance(part, Symbol) else part for part in parts]
        symbol.content = (f"{name}\0{meaning}\0{from_what}", *content[1:])
        return symbol

    def _hashable_content(self) -> tuple[Any, ...]:
        return self.content

    def __getnewargs_ex__(self) -> tuple[tuple[Any, ...], dict[str, bool]]:
        """Arguments that make an equal symbol."""
        return (self.meaning, *self.parts), self._assumptions_orig

    def __eq__(self, other: object) -> bool:
        """Whether another symbol means the same."""
        if self is other:
            return True
        if not isinstance(other, Symbol) or self._hashable_content() != other._hashable_content():
            return False
        return (self.meaning, self.parts) == (other.meaning, other.parts)

    __hash__ = sp.Symbol.__hash__


def derivative(symbol: sp.Symbol, by: sp.Symbol) -> Symbol:
    """The symbol of a derivative."""
    return Symbol("derivative", symbol, by)


def parts_of_derivative(symbol: sp.Symbol) -> tuple[sp.Symbol, sp.Symbol | None]:
    """What a derivative is of, and by; another symbol itself, and None."""
    if meaning_of(symbol) != "derivative":
        return symbol, None
    inner, by = symbol.parts
    return inner, by


def inside(symbol: sp.Symbol, *meanings: str) -> sp.Symbol:
    """What a symbol is made from, once these meanings are taken off."""
    while meaning_of(symbol) in meanings:
        symbol = symbol.parts[0]
    return symbol


def meaning_of(symbol: sp.Basic) -> str:
    """What a symbol of the derivation means; empty for one of a declaration."""
    return symbol.meaning if isinstance(symbol, Symbol) else ""

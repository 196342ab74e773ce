"""The notation of one document: the words, relations and letters that all its sections share."""

from __future__ import annotations

import re
from collections.abc import Hashable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import sympy as sp

from nonsmooth.derive.declaration.dynamics import SecondOrder
from nonsmooth.derive.declaration.source import Source
from nonsmooth.derive.declaration.system import System
from nonsmooth.derive.document.blocks import LINE_WIDTH, Line, width
from nonsmooth.derive.document.printer import Printer
from nonsmooth.derive.document.symbols import Letters, free, free_letters, head, is_response
from nonsmooth.derive.flows.modal import Spectrum

# capitals that stand for matrices and the like in every document
_TAKEN = set("ADEFIJKMPQRSTU")
# letters that have one meaning in all documents
_KEPT = ("I", "M", "C", "K", r"\ell", r"\Phi", "t", "k", "j")
_COUNTS = ("no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten")


@dataclass(eq=False, kw_only=True)
class Notation(Printer):
    """How a document writes, the system whose words it uses, and the source it cites."""

    system: System
    names: Sequence[str]  # of the configurations that the document describes
    spectrum: Spectrum
    source: Source | None = None

    def cited(self, *keys: str) -> str:
        """Text ``, = (14) of Pascal (2011)`` on what the keys stand for; empty without a source."""
        return self.source.cited(*keys) if self.source else ""

    @cached_property
    def in_responses(self) -> bool:
        """Whether flows are written in impulse responses."""
        return any(map(is_response, self.flows.values()))

    @property
    def open(self) -> bool:
        """Whether the flow of a configuration is no sum of functions of time."""
        return self.in_responses or len(self.flows) < len(self.names)

    @cached_property
    def sharing(self) -> dict[int, list[str]]:
        """Configurations by the number of their flow, from 1; those with equal flows share one.

        Those whose flows have no closed form come last.
        """
        groups: dict[Hashable, list[str]] = {}
        for name in sorted(self.names, key=lambda name: name not in self.flows):
            flow = self.flows.get(name)
            if flow is None:
                key = self.system.configuration(name).dynamics.field(self.system.states)[0]
            else:
                key = flow.basis, flow.matrices, self.in_responses and flow.offsets
            groups.setdefault(key, []).append(name)
        return dict(enumerate(groups.values(), start=1))

    def flow_number(self, name: str) -> int:
        """Number of the flow of a configuration."""
        return next(number for number, names in self.sharing.items() if name in names)

    def flow_of(self, number: int) -> str:
        """Text on a flow by its number, and on the configurations that share it."""
        names = self.sharing[number]
        cited = self.cited(*(f"flow {name}" for name in names))
        return rf"$\Phi_{{{number}}}$, of {', '.join(f'*{name}*' for name in names)}{cited}"

    @property
    def second_order(self) -> bool:
        """Whether some configuration has positions and velocities as its state."""
        return any(isinstance(c.dynamics, SecondOrder) for c in self.system.configurations)

    @property
    def column(self) -> str:
        """The states, as the entries of a column."""
        return ", ".join(map(self.symbol, self.system.states))

    @property
    def positions(self) -> tuple[sp.Symbol, ...]:
        """The positions among the states."""
        return self.system.states[: len(self.system.states) // 2]

    @property
    def letter(self) -> str:
        """Letter of the vector of positions: the one that they share, else one that is free."""
        letters = sorted({str(s).rstrip("0123456789") for s in self.positions})
        if len(letters) == 1 and len(letters[0]) == 1:
            return letters[0]
        return free(("x", "z", "q", "u"), self.declared)

    @property
    def state(self) -> str:
        """Letter of the whole state: a capital that stands for nothing else."""
        letter = self.letter.upper()
        return letter if self.second_order and letter not in _TAKEN else "Y"

    @cached_property
    def letters(self) -> Letters:
        """Letters different from those of all symbols, of the state and of responses."""
        named = map(self.symbol, (*self.states, *self.constants, *self.unknowns))
        taken = {self.state, self.letter, self.responses.letter, self.responses.polynomial}
        return free_letters({*map(head, named), *taken, *_KEPT})

    def prose(self, text: str) -> str:
        """Text with formulas for symbols and emphasis on the system's own names."""
        names = [c.name for c in self.system.configurations]
        names += [b.name for c in self.system.configurations for b in c.boundaries]
        longest = sorted(dict.fromkeys(names), key=lambda n: (-len(n), n))
        pattern = rf"(?<![-\w])(?:{'|'.join(map(re.escape, longest))})(?![-\w])"
        parts = re.split(f"({pattern})", text)
        return "".join(f"*{p}*" if p in names else self.with_formulas(p) for p in parts)

    def relation(
        self,
        left: sp.Symbol | str,
        value: Any,
        mark: str = "",
        *,
        shows: sp.Basic | None = None,
        tidy: bool = True,
    ) -> Line:
        """The line ``left = value`` with a mark at its end, which shows the value or `shows`.

        The value is an expression, a matrix, LaTeX, or LaTeX in pieces.
        """
        if isinstance(value, tuple):
            pieces = value
        elif isinstance(value, sp.Expr) and not isinstance(value, sp.MatrixBase):
            pieces = self.pieces(self.tidy(value) if tidy else value)
        else:
            pieces = (self.text(value),)
        subject = left if isinstance(left, sp.Symbol) else None
        shown = value if shows is None else shows
        if isinstance(shown, sp.MatrixBase):
            shown = sp.ImmutableMatrix(shown)
        shown = shown if isinstance(shown, sp.Basic) else None
        return Line(self.text(left), "=", pieces, subject, shown).ended(mark)

    def entries(self, name: sp.Symbol | str, matrix: Any) -> list[Line]:
        """The line ``name = value``; one for each entry but zeros of a matrix that is too wide."""
        whole = self.relation(name, matrix)
        if not isinstance(matrix, sp.MatrixBase) or width(whole.latex) <= LINE_WIDTH:
            return [whole]
        comma = "," if max(matrix.shape) > 9 else ""
        return [
            self.relation(rf"\left({name}\right)_{{{i + 1}{column}}}", matrix[i, j])
            for i in range(matrix.rows)
            for j in range(matrix.cols)
            for column in ["" if matrix.cols == 1 else f"{comma}{j + 1}"]
            if matrix[i, j] != 0
        ]

    def text(self, value: Any) -> str:
        """A value as text: expressions and matrices as LaTeX, lists with an "and"."""
        if isinstance(value, (list, tuple)):
            return enumeration([self.math(v) if isinstance(v, sp.Symbol) else v for v in value])
        if isinstance(value, sp.MatrixBase):
            return self._matrix_text(value)
        if isinstance(value, sp.Symbol):
            return self.symbol(value)
        if isinstance(value, sp.Basic):
            return self.latex(self.tidy(value))
        return "" if value is None else str(value)

    def _matrix_text(self, matrix: sp.Matrix) -> str:
        """LaTeX of a matrix; a column is a transposed row, a single entry stands alone."""
        if matrix.cols == 1:
            if matrix.rows == 1:
                return self.text(matrix[0])
            return rf"{self.latex(matrix.T.applyfunc(self.tidy))}^{{\mathsf{{T}}}}"
        if matrix.is_square and matrix.is_diagonal():
            if matrix == sp.eye(matrix.rows):
                return "I"
            entries = ", ".join(map(self.latex, matrix.diagonal()))
            return rf"\operatorname{{diag}}\left({entries}\right)"
        return self.latex(matrix)

    def math(self, value: object, after: str = "") -> str:
        """A formula in running text: a value, and what follows it."""
        return f"${self.text(value)}{after}$"


def enumeration(words: Sequence[str]) -> str:
    """Words listed with commas and an "and"."""
    if len(words) < 2:
        return "".join(words)
    return f"{', '.join(words[:-1])} and {words[-1]}"


def number(value: int) -> str:
    """A number in words; in digits if it is greater than ten."""
    return _COUNTS[value] if value < len(_COUNTS) else str(value)

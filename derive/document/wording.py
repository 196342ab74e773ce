"""Words and lines that all sections of a document share."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import sympy as sp

from nonsmooth.derive.document.blocks import Formula, Line
from nonsmooth.derive.document.symbols import Notation
from nonsmooth.derive.dynamics import SecondOrder
from nonsmooth.derive.system import System

__all__ = ["Naming", "count", "enumeration", "numbered"]

_COUNTS = ("no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten")


@dataclass(frozen=True)
class Naming:
    """Notation, and the letters of the state and of its positions."""

    notation: Notation
    system: System

    @property
    def second_order(self) -> bool:
        """Whether the state is positions and velocities."""
        return any(isinstance(c.dynamics, SecondOrder) for c in self.system.configurations)

    @property
    def positions(self) -> tuple[sp.Symbol, ...]:
        """The positions among the states."""
        return self.system.states[: len(self.system.states) // 2]

    @property
    def letter(self) -> str:
        """Letter of the vector of positions: theirs, when they share one."""
        letters = sorted({str(s).rstrip("0123456789") for s in self.positions})
        return letters[0] if len(letters) == 1 and len(letters[0]) == 1 else "x"

    @property
    def state(self) -> str:
        """Letter of the whole state."""
        return self.letter.upper() if self.second_order else "Y"

    def prose(self, text: str) -> str:
        """Text with formulas for symbols and emphasis on the system's own names."""
        names = [c.name for c in self.system.configurations]
        names += [b.name for c in self.system.configurations for b in c.boundaries]
        longest = sorted(dict.fromkeys(names), key=lambda n: (-len(n), n))
        pattern = rf"(?<![-\w])(?:{'|'.join(map(re.escape, longest))})(?![-\w])"
        marked = re.split(f"({pattern})", text)
        return "".join(f"*{p}*" if p in names else self.notation.prose(p) for p in marked)

    def equal(self, left: sp.Symbol, right: sp.Expr, *, tidy: bool = True) -> Line:
        """Make the line ``left = right``."""
        shown = self.notation.tidy(right) if tidy else right
        return Line(
            self.notation.symbol(left), "=", self.notation.pieces(shown), left, sp.sympify(right)
        )

    def list(self, symbols: Iterable[sp.Symbol]) -> str:
        """Symbols in running text."""
        return enumeration([f"${self.notation.symbol(s)}$" for s in symbols])


def enumeration(words: Sequence[str]) -> str:
    """Words with commas and an "and"."""
    if len(words) < 2:
        return "".join(words)
    return f"{', '.join(words[:-1])} and {words[-1]}"


def count(number: int, noun: str) -> str:
    """Number and noun in words."""
    word = _COUNTS[number] if number < len(_COUNTS) else str(number)
    return f"{word} {noun}{'' if number == 1 else 's'}"


def numbered(
    naming: Naming, equations: Sequence[tuple[str, sp.Expr]], prefix: str
) -> list[Formula]:
    """Number equations with their meanings, each a formula."""
    return [
        Formula(
            (_vanishing(naming, expression),),
            label=f"{prefix}{number}",
            note=naming.prose(meaning),
        )
        for number, (meaning, expression) in enumerate(equations, start=1)
    ]


def _vanishing(naming: Naming, expression: sp.Expr) -> Line:
    pieces = naming.notation.pieces(naming.notation.tidy(expression))
    return Line("", "", (*pieces[:-1], f"{pieces[-1]} = 0"), None, expression)

"""Words and lines that all sections of a document share."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

import sympy as sp

from nonsmooth.derive.declaration.dynamics import SecondOrder
from nonsmooth.derive.declaration.source import Source
from nonsmooth.derive.declaration.system import System
from nonsmooth.derive.document.blocks import Formula, Line
from nonsmooth.derive.document.notation.arrange import by_function, signed
from nonsmooth.derive.document.notation.symbols import Notation

__all__ = ["Naming", "count", "enumeration", "in_one_line", "number", "numbered"]

# capitals that stand for matrices and the like in every document
_TAKEN = set("ADEFIJKMPQRSTU")
_COUNTS = ("no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten")


@dataclass(frozen=True)
class Naming:
    """The notation of a document, the system whose words it uses, and the source it cites."""

    notation: Notation
    system: System
    source: Source | None = None

    def cited(self, *keys: str) -> str:
        """Text ``, = (14) of Pascal (2011)`` on what the keys stand for; empty without a source."""
        return self.source.cited(*keys) if self.source else ""

    def flow_of(self, names: Sequence[str]) -> str:
        """Text on the configurations that share a flow."""
        cited = self.cited(*(f"flow {name}" for name in names))
        return f"of {', '.join(f'*{name}*' for name in names)}{cited}"

    @property
    def second_order(self) -> bool:
        """Whether some configuration has positions and velocities as its state."""
        return any(isinstance(c.dynamics, SecondOrder) for c in self.system.configurations)

    @property
    def positions(self) -> tuple[sp.Symbol, ...]:
        """The positions among the states."""
        return self.system.states[: len(self.system.states) // 2]

    @property
    def letter(self) -> str:
        """Letter of the vector of positions: their common letter if they share one, else x."""
        letters = sorted({str(s).rstrip("0123456789") for s in self.positions})
        return letters[0] if len(letters) == 1 and len(letters[0]) == 1 else "x"

    @property
    def state(self) -> str:
        """Letter of the whole state: a capital that stands for nothing else."""
        letter = self.letter.upper()
        return letter if self.second_order and letter not in _TAKEN else "Y"

    def prose(self, text: str) -> str:
        """Text with formulas for symbols and emphasis on the system's own names."""
        names = [c.name for c in self.system.configurations]
        names += [b.name for c in self.system.configurations for b in c.boundaries]
        longest = sorted(dict.fromkeys(names), key=lambda n: (-len(n), n))
        pattern = rf"(?<![-\w])(?:{'|'.join(map(re.escape, longest))})(?![-\w])"
        marked = re.split(f"({pattern})", text)
        return "".join(f"*{p}*" if p in names else self.notation.prose(p) for p in marked)

    def equal(
        self,
        left: sp.Symbol,
        right: sp.Expr,
        *,
        tidy: bool = True,
        written: sp.Expr | None = None,
    ) -> Line:
        """The line ``left = right``; the right side is shown as `written` if that is given."""
        shown = right if written is None else written
        shown = self.notation.tidy(shown) if tidy else shown
        return Line(
            self.notation.symbol(left), "=", self.notation.pieces(shown), left, sp.sympify(right)
        )

    def sum(self, left: sp.Symbol, right: sp.Expr, written: sp.Expr | None = None) -> Line:
        """The line ``left = right``, arranged function by function of time."""
        terms = by_function(self.notation, right if written is None else written)
        pieces = signed(self.notation, terms)
        return Line(self.notation.symbol(left), "=", pieces, left, sp.sympify(right))

    def list(self, symbols: Iterable[sp.Symbol]) -> str:
        """Symbols listed for running text."""
        return enumeration([f"${self.notation.symbol(s)}$" for s in symbols])


def enumeration(words: Sequence[str]) -> str:
    """Words listed with commas and an "and"."""
    if len(words) < 2:
        return "".join(words)
    return f"{', '.join(words[:-1])} and {words[-1]}"


def number(value: int) -> str:
    """A number in words; in digits if it is greater than ten."""
    return _COUNTS[value] if value < len(_COUNTS) else str(value)


def count(value: int, noun: str) -> str:
    """A number and a noun in words, the noun in the plural unless the number is one."""
    return f"{number(value)} {noun}{'' if value == 1 else 's'}"


def in_one_line(lines: Sequence[Line]) -> Line:
    """One line of short relations side by side; the first is aligned with the lines above."""
    first, *others = lines
    if not others:
        return first
    texts = [" ".join(first.pieces), *(line.latex for line in others)]
    pieces = (*(rf"{text},\qquad" for text in texts[:-1]), texts[-1])
    return Line(first.left, first.relation, pieces, parts=tuple(lines))


def numbered(
    naming: Naming,
    equations: Sequence[tuple[str, sp.Expr]],
    labels: Sequence[str],
    written: Sequence[sp.Expr] | None = None,
    ends: Mapping[str, Sequence[int]] | None = None,
) -> list[Formula]:
    """Equations as numbered formulas with their meanings, and their places in the source.

    Those in which functions of time occur are arranged by these functions. `ends` has the
    phases of which each meaning is the condition that ends them.
    """
    found = []
    for (meaning, expression), label, shown in zip(
        equations, labels, written or [e for _, e in equations], strict=True
    ):
        notation = naming.notation
        if any(notation.is_function(s) for s in shown.free_symbols):
            pieces = signed(notation, by_function(notation, shown))
        else:
            pieces = notation.pieces(notation.tidy(shown))
        line = Line("", "", (*pieces[:-1], f"{pieces[-1]} = 0"), None, expression)
        others = ("halfway" if "halfway" in meaning else "closure",)
        keys = [f"end {k}" for k in (ends or {}).get(meaning, ())] or others
        note = f"{_meaning(naming, meaning)}{naming.cited(*keys)}"
        found.append(Formula((line,), label=label, note=note))
    return found


def _meaning(naming: Naming, text: str) -> str:
    """Meaning of an equation as text, its first word set as a symbol if it is one."""
    word, _, rest = text.partition(" ")
    names = {str(s): s for s in (*naming.system.states, *naming.notation.unknowns)}
    if word in names and rest:
        return f"${naming.notation.symbol(names[word])}$ {naming.prose(rest)}"
    return naming.prose(text)

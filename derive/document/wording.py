"""Words and lines that all sections of a document share."""

from __future__ import annotations

import re
from collections.abc import Hashable, Iterable, Mapping, Sequence
from dataclasses import dataclass

import sympy as sp

from nonsmooth.derive.declaration.dynamics import SecondOrder
from nonsmooth.derive.declaration.source import Source
from nonsmooth.derive.declaration.system import System
from nonsmooth.derive.document.blocks import Line
from nonsmooth.derive.document.printer import Notation
from nonsmooth.derive.document.symbols import Letters, free, free_letters, head

# capitals that stand for matrices and the like in every document
_TAKEN = set("ADEFIJKMPQRSTU")
# letters that have one meaning in all documents
_KEPT = ("I", "M", "C", "K", r"\ell", r"\Phi", "t", "k", "j")
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
        """Letter of the vector of positions: the one that they share, else one that is free."""
        letters = sorted({str(s).rstrip("0123456789") for s in self.positions})
        if len(letters) == 1 and len(letters[0]) == 1:
            return letters[0]
        return free(("x", "z", "q", "u"), self.notation.declared)

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

    def equal(self, left: sp.Symbol, right: sp.Expr, *, tidy: bool = True) -> Line:
        """The line ``left = right``."""
        pieces = self.notation.pieces(self.notation.tidy(right) if tidy else right)
        return Line(self.notation.symbol(left), "=", pieces, left, sp.sympify(right))

    def sum(self, left: sp.Symbol, right: sp.Expr) -> Line:
        """The line ``left = right``, arranged function by function of time."""
        pieces = self.notation.signed(self.notation.by_function(right))
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


def alike(keys: Mapping[str, Hashable], first: int = 1) -> dict[int, list[str]]:
    """Names by number, from the first number on; those with equal keys share one."""
    groups: dict[Hashable, list[str]] = {}
    for name, key in keys.items():
        groups.setdefault(key, []).append(name)
    return dict(enumerate(groups.values(), start=first))


def letters_of(naming: Naming, symbols: Iterable[sp.Symbol]) -> Letters:
    """Letters different from those of the symbols and the state."""
    notation = naming.notation
    taken = {head(notation.symbol(s)) for s in symbols} | {naming.state, naming.letter, *_KEPT}
    return free_letters(taken | {notation.responses.letter, notation.responses.polynomial})

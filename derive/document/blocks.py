"""What a document is made of: headings, paragraphs, formulas and tables.

Text carries two marks: ``$...$`` around LaTeX and ``*...*`` around emphasised words.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import groupby

import sympy as sp

from nonsmooth.derive.document.layout import LINE_WIDTH, rows, text_width, width

__all__ = ["Block", "Document", "Formula", "Heading", "Line", "Paragraph", "Table", "notes_beside"]

# em that a number and the gaps of a note beside a formula take
_AROUND_NOTE = 7.0


@dataclass(frozen=True)
class Heading:
    """Title of a section (level 1) or of a part of a section (level 2)."""

    text: str
    level: int = 1
    number: int | None = None  # of a section among those of the whole document

    @property
    def numbered(self) -> str:
        """The title behind its number."""
        return self.text if self.number is None else f"{self.number}. {self.text}"


@dataclass(frozen=True)
class Paragraph:
    """Running text."""

    text: str


@dataclass(frozen=True)
class Line:
    """One relation of a formula, in LaTeX."""

    left: str  # left-hand side
    relation: str  # sign behind it
    pieces: tuple[str, ...]  # right-hand side, cut where a line may break
    subject: sp.Basic | None = None  # what the left-hand side stands for, if that is one symbol
    # expression or matrix of the derivation that the right-hand side shows
    shows: sp.Basic | None = None
    parts: tuple[Line, ...] = ()  # the relations, if several stand side by side

    @property
    def latex(self) -> str:
        """The relation on one line."""
        return " ".join(filter(None, (self.left, self.relation, *self.pieces)))


@dataclass(frozen=True)
class Formula:
    """Displayed relations, aligned at their signs."""

    lines: tuple[Line, ...]
    label: str | None = None  # number of the equation
    note: str | None = None  # meaning of the equation, as text

    @property
    def relations(self) -> tuple[Line, ...]:
        """All relations, also those that stand side by side on one line."""
        return tuple(part for line in self.lines for part in (line.parts or (line,)))

    @property
    def latex(self) -> str:
        """The relations as one ``aligned`` environment, long ones over several rows."""
        body = " \\\\\n".join(f"{left} &{right}" for left, right in self.rows)
        return f"\\begin{{aligned}}\n{body}\n\\end{{aligned}}"

    @property
    def rows(self) -> list[tuple[str, str]]:
        """Left and right part of every row."""
        return rows(self.lines)

    @property
    def lead(self) -> str:
        """The note as a sentence that stands above."""
        return f"{self.note[:1].upper()}{self.note[1:]}:" if self.note else ""


def notes_beside(formulas: Sequence[Formula]) -> bool:
    """Whether the notes of aligned formulas have room beside them."""
    widest = [width(left) + width(right) for f in formulas for left, right in f.rows]
    notes = [text_width(f.note) for f in formulas if f.note]
    return max(widest, default=0.0) + max(notes, default=0.0) + _AROUND_NOTE <= LINE_WIDTH


@dataclass(frozen=True)
class Table:
    """Rows of text below a header; the column `wrapped` takes the remaining width."""

    header: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    wrapped: int | None = None


Block = Heading | Paragraph | Formula | Table

# titles of the sections that are a part by themselves, of an orbit or of an itinerary
_PARTS = {
    "flows": ("Modal analysis",),
    "equations": ("The equations",),
    "map": ("Derivatives and the Poincaré map", "Stability"),
    "trace": ("The trace", "Stability"),
}


@dataclass(frozen=True)
class Document:
    """A title and the blocks that follow it."""

    title: str
    blocks: tuple[Block, ...]

    @property
    def groups(self) -> tuple[tuple[Block, ...], ...]:
        """The blocks in groups: consecutive numbered formulas together, every other block alone."""
        found: list[tuple[Block, ...]] = []
        for numbered, run in groupby(
            self.blocks, lambda b: isinstance(b, Formula) and b.label is not None
        ):
            blocks = tuple(run)
            found += [blocks] if numbered else [(block,) for block in blocks]
        return tuple(found)

    @property
    def formulas(self) -> tuple[Formula, ...]:
        """All displayed formulas in order."""
        return tuple(b for b in self.blocks if isinstance(b, Formula))

    def part(self, name: str) -> Document:
        """A document of one part: flows, equations, map or trace, numbered as in the whole."""
        return Document(self.title, self._sections(_PARTS[name]))

    def section(self, title: str) -> tuple[Block, ...]:
        """The blocks between a section's heading and the next section."""
        return self._sections((title,))[1:]

    def _sections(self, titles: Sequence[str]) -> tuple[Block, ...]:
        """The sections of the given titles, with their headings."""
        found: list[Block] = []
        inside = False
        for block in self.blocks:
            if isinstance(block, Heading) and block.level == 1:
                inside = block.text in titles
            if inside:
                found.append(block)
        return tuple(found)

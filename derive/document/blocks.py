"""What a document is made of: headings, paragraphs, formulas and tables.

Text carries two marks: ``$...$`` around LaTeX and ``*...*`` around emphasised words.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import groupby

import sympy as sp

from nonsmooth.derive.document.layout import rows

__all__ = ["Block", "Document", "Formula", "Heading", "Line", "Paragraph", "Table"]


@dataclass(frozen=True)
class Heading:
    """Title of a section (level 1) or of a part of one (level 2)."""

    text: str
    level: int = 1


@dataclass(frozen=True)
class Paragraph:
    """Running text."""

    text: str


@dataclass(frozen=True)
class Line:
    """One relation of a formula.

    Attributes
    ----------
    left, relation : str
        LaTeX of the left-hand side and of the sign behind it.
    pieces : tuple of str
        LaTeX of the right-hand side, cut where a line may break.
    subject : expression, or None
        What the left-hand side stands for, where that is one symbol.
    shows : expression or matrix, or None
        The derivation's own object of which the right-hand side is the LaTeX.
    parts : tuple of Line
        Where several relations stand side by side: those.
    """

    left: str
    relation: str
    pieces: tuple[str, ...]
    subject: sp.Basic | None = None
    shows: sp.Basic | None = None
    parts: tuple[Line, ...] = ()

    @property
    def latex(self) -> str:
        """The relation on one line."""
        return " ".join(filter(None, (self.left, self.relation, *self.pieces)))


@dataclass(frozen=True)
class Formula:
    """Displayed relations, aligned at their signs.

    Attributes
    ----------
    lines : tuple of Line
    label : str, or None
        Number of the equation.
    note : str, or None
        What it means, as text.
    """

    lines: tuple[Line, ...]
    label: str | None = None
    note: str | None = None

    @property
    def relations(self) -> tuple[Line, ...]:
        """The relations, also those that stand side by side."""
        return tuple(part for line in self.lines for part in (line.parts or (line,)))

    @property
    def latex(self) -> str:
        """The relations as one ``aligned`` environment, long ones over several rows."""
        body = " \\\\\n".join(f"{left} &{right}" for left, right in rows(self.lines))
        return f"\\begin{{aligned}}\n{body}\n\\end{{aligned}}"


@dataclass(frozen=True)
class Table:
    """Rows of text below a header; the column `wrapped` takes the width that is left."""

    header: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    wrapped: int | None = None


Block = Heading | Paragraph | Formula | Table


@dataclass(frozen=True)
class Document:
    """A title and what follows it."""

    title: str
    blocks: tuple[Block, ...]

    @property
    def groups(self) -> tuple[tuple[Block, ...], ...]:
        """The blocks, numbered formulas in a row together."""
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

    def section(self, title: str) -> tuple[Block, ...]:
        """Give the blocks between a section's heading and the next section."""
        found: list[Block] = []
        inside = False
        for block in self.blocks:
            if isinstance(block, Heading) and block.level == 1:
                inside = block.text == title
            elif inside:
                found.append(block)
        return tuple(found)

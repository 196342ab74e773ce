"""What a document is made of: headings, paragraphs, formulas and tables, and their widths.

Text carries two marks: ``$...$`` around LaTeX and ``*...*`` around emphasised words.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import sympy as sp

# em of the text block that the LaTeX preamble sets, less the room of an equation number
LINE_WIDTH = 42.0

_TOKEN = re.compile(r"\\(?:begin|end)\{\w+\}|\\[A-Za-z]+|\\.|\s+|.", re.DOTALL)
_SIGNS = {"+", "-", "=", "<", ">"}
_SPACES = {r"\,": 0.17, r"\;": 0.28, r"\quad": 1.0, r"\qquad": 2.0, r"\!": -0.17}
_FUNCTIONS = {r"\cos": 1.6, r"\sin": 1.5}
_TRANSPARENT = {r"\left", r"\right", r"\biggl", r"\biggr", r"\mathrm", r"\mathsf", r"\text"}
_TRANSPARENT |= {r"\operatorname", r"\bar", r"\hat", r"\displaystyle"}

_MARKS = re.compile(r"(\$[^$]+\$|\*[^*]+\*)")


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

    @property
    def latex(self) -> str:
        """The relation on one line."""
        return " ".join(filter(None, (self.left, self.relation, *self.pieces)))

    def ended(self, mark: str) -> Line:
        """The line with a mark at its end, in place of a comma there."""
        *others, last = self.pieces
        last = last.removesuffix(",") if mark else last
        return replace(self, pieces=(*others, f"{last}{mark}"))


@dataclass(frozen=True)
class Formula:
    """Displayed relations, aligned at their signs."""

    lines: tuple[Line, ...]
    label: str | None = None  # number of the equation
    note: str | None = None  # meaning of the equation, as text

    @property
    def latex(self) -> str:
        """The relations as one ``aligned`` environment, long ones over several rows."""
        body = " \\\\\n".join(f"{left} &{right}" for left, right in self.rows)
        return f"\\begin{{aligned}}\n{body}\n\\end{{aligned}}"

    @property
    def rows(self) -> list[tuple[str, str]]:
        """Left and right part of every row, with lines broken so that no row is too wide."""
        indent = max((width(line.left) for line in self.lines), default=0.0)
        found = []
        for line in self.lines:
            left, text, used = line.left, line.relation, width(line.relation)
            empty = True
            for piece in line.pieces:
                needed = width(piece)
                if not empty and indent + used + needed > LINE_WIDTH:
                    found.append((left, text.removesuffix(r"\qquad")))
                    left, text, used = "", r"\qquad{}", 2.0
                text, used, empty = f"{text} {piece}", used + needed, False
            found.append((left, text))
        return found

    @property
    def lead(self) -> str:
        """The note as a sentence that stands above."""
        return f"{self.note[:1].upper()}{self.note[1:]}:" if self.note else ""


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
    """A title and the blocks that follow it, and what the blocks show, with its notation."""

    title: str
    blocks: tuple[Block, ...]
    shown: Any = field(default=None, compare=False, repr=False)

    @property
    def formulas(self) -> tuple[Formula, ...]:
        """All displayed formulas in order."""
        return tuple(b for b in self.blocks if isinstance(b, Formula))

    def part(self, name: str) -> Document:
        """A document of one part: flows, equations, map or trace, numbered as in the whole."""
        return Document(self.title, self._sections(_PARTS[name]), self.shown)

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


def marked(text: str) -> list[tuple[str, str]]:
    """Parts of text behind their marks: ``$`` for LaTeX, ``*`` for emphasis, nothing for words."""
    parts = enumerate(_MARKS.split(text))
    return [(part[0], part[1:-1]) if place % 2 else ("", part) for place, part in parts]


def rendered(
    text: str, words: Callable[[str], str], formula: Callable[[str], str], emphasis: str
) -> str:
    """Text in another format: its words, its formulas, and what emphasised words stand in."""
    return "".join(
        formula(part) if mark == "$" else emphasis.format(words(part)) if mark else words(part)
        for mark, part in marked(text)
    )


def text_width(text: str) -> float:
    """Approximate width in em of text with formulas and emphasis."""
    return sum(width(part) if mark == "$" else 0.52 * len(part) for mark, part in marked(text))


def width(latex: str) -> float:
    """Approximate width of a formula in em of its font."""
    tokens = [t for t in _TOKEN.findall(latex) if not t.isspace()]
    return _sequence(iter(tokens))


def _sequence(tokens: Iterator[str]) -> float:
    """Width of the tokens up to the end, or to the brace that closes the group."""
    total, scripts = 0.0, 0.0
    for token in tokens:
        if token in "_^":
            # an index below and one above stand over each other
            script = 0.7 * _argument(tokens)
            total += max(0.0, script - scripts)
            scripts = max(script, scripts)
            continue
        scripts = 0.0
        if token == "}":
            break
        if token == "{":
            total += _sequence(tokens)
        elif token == r"\frac":
            total += max(_argument(tokens), _argument(tokens)) + 0.25
        elif token == r"\sqrt":
            total += _argument(tokens) + 0.9
        elif token.startswith(r"\begin"):
            total += _matrix(tokens)
        elif token not in _TRANSPARENT:
            total += _single(token)
    return total


def _argument(tokens: Iterator[str]) -> float:
    token = next(tokens)
    return _sequence(tokens) if token == "{" else _single(token)


def _matrix(tokens: Iterator[str]) -> float:
    """Width of a matrix: the sum of its columns' widths, with the gaps between them."""
    columns, column, depth, entry = [0.0], 0, 0, ""
    for token in tokens:
        if token.startswith(r"\end"):
            depth -= 1
        elif token.startswith(r"\begin"):
            depth += 1
        if depth == 0 and token in ("&", r"\\"):
            columns[column] = max(columns[column], width(entry))
            column, entry = (column + 1 if token == "&" else 0), ""
            if column == len(columns):
                columns.append(0.0)
        elif depth < 0:
            columns[column] = max(columns[column], width(entry))
            break
        else:
            entry += f" {token}"
    return sum(columns) + 1.0 * (len(columns) - 1) + 0.4


def _single(token: str) -> float:
    if token in _SIGNS:
        return 1.25
    if token in _SPACES:
        return _SPACES[token]
    if token in _FUNCTIONS:
        return _FUNCTIONS[token]
    if token in "()[]|.,;:":
        return 0.45
    return 0.64 if token.startswith("\\") else 0.54

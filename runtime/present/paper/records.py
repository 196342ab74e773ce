"""What a report is made of: chapters of text, equations, tables, figures and comparisons.

Text carries two marks: ``$...$`` around LaTeX and ``*...*`` around emphasised words.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

__all__ = [
    "Block",
    "Chapter",
    "Comparison",
    "Comparisons",
    "Equation",
    "Finding",
    "Report",
    "ReportFigure",
    "Table",
    "Text",
]


@dataclass(frozen=True)
class Text:
    """A paragraph."""

    text: str


@dataclass(frozen=True)
class Equation:
    """A displayed formula."""

    latex: str
    note: str = ""  # its meaning as text, may be empty


@dataclass(frozen=True)
class Table:
    """A table of text cells under a caption."""

    caption: str
    header: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]


@dataclass(frozen=True)
class ReportFigure:
    """A figure in the files ``<stem>.svg`` and ``<stem>.png`` beside the report."""

    stem: str  # such as figure-02
    caption: str  # begins with the paper's number if it has one


@dataclass(frozen=True)
class Comparison:
    """A number of the paper beside ours."""

    quantity: str  # LaTeX
    where: str  # section or equation of the paper
    printed: str  # the paper's digits
    ours: str  # decimal string of 30 digits
    difference: str  # ours less the paper's, three digits
    verdict: str  # "agrees within the printed digits", "agrees within 0.2 %", or "misprint"
    enclosure: str = ""  # proven, empty if none was asked for


@dataclass(frozen=True)
class Comparisons:
    """Numbers of the paper beside ours, under a caption."""

    caption: str
    rows: tuple[Comparison, ...]


@dataclass(frozen=True)
class Finding:
    """A claim or misprint of the paper, and the computation that decides it."""

    title: str  # such as "Eq. (2): the impact law"
    printed: str  # text of the paper
    verdict: str  # "misprint", "holds", "does not hold" or "holds with a correction"
    corrected: str  # what it has to be, empty if the claim holds
    evidence: str  # what was computed and what came out
    table: Table | None = None


Block = Text | Equation | Table | ReportFigure | Comparisons | Finding


@dataclass(frozen=True)
class Chapter:
    """A section of the report."""

    anchor: str  # lower-case words joined by hyphens, unique in the report
    title: str
    blocks: tuple[Block, ...]


@dataclass(frozen=True)
class Report:
    """The whole report."""

    title: str
    summary: tuple[str, ...]  # paragraphs before the chapters
    chapters: tuple[Chapter, ...]
    results: dict[str, Any]  # for results.json: decimal strings, integers, nested dicts and lists

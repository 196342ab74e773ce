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
    """A displayed formula.

    Attributes
    ----------
    latex : str
    note : str
        What it means, as text; may be empty.
    """

    latex: str
    note: str = ""


@dataclass(frozen=True)
class Table:
    """A table of text cells under a caption."""

    caption: str
    header: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]


@dataclass(frozen=True)
class ReportFigure:
    """A figure that lies as ``<stem>.svg`` and ``<stem>.png`` beside the report.

    Attributes
    ----------
    stem : str
        Name of the files without their ending, e.g. ``figure-02``.
    caption : str
        Begins with the paper's number where it has one.
    """

    stem: str
    caption: str


@dataclass(frozen=True)
class Comparison:
    """A number of the paper beside ours.

    Attributes
    ----------
    quantity : str
        LaTeX.
    where : str
        Section or equation of the paper.
    printed : str
        The paper's digits.
    ours : str
        Decimal string of 30 digits.
    difference : str
        Ours less the paper's, three digits.
    verdict : str
        "agrees within the printed digits", "agrees within 0.2 %", or "misprint".
    enclosure : str
        Proven enclosure; empty where none was asked for.
    """

    quantity: str
    where: str
    printed: str
    ours: str
    difference: str
    verdict: str
    enclosure: str = ""


@dataclass(frozen=True)
class Comparisons:
    """Numbers of the paper beside ours, under a caption."""

    caption: str
    rows: tuple[Comparison, ...]


@dataclass(frozen=True)
class Finding:
    """A claim or misprint of the paper, and the computation that decides it.

    Attributes
    ----------
    title : str
        e.g. "Eq. (2): the impact law".
    printed : str
        What the paper has, as text.
    verdict : str
        "misprint", "holds", "does not hold" or "holds with a correction".
    corrected : str
        What it has to be; empty where the claim holds.
    evidence : str
        What was computed and what came out.
    table : Table, or None
        The numbers.
    """

    title: str
    printed: str
    verdict: str
    corrected: str
    evidence: str
    table: Table | None = None


Block = Text | Equation | Table | ReportFigure | Comparisons | Finding


@dataclass(frozen=True)
class Chapter:
    """A section of the report.

    Attributes
    ----------
    anchor : str
        Lower-case words joined by hyphens, unique in the report.
    title : str
    blocks : tuple of Block
    """

    anchor: str
    title: str
    blocks: tuple[Block, ...]


@dataclass(frozen=True)
class Report:
    """The whole report.

    Attributes
    ----------
    title : str
    summary : tuple of str
        A few paragraphs in front of the chapters.
    chapters : tuple of Chapter
    results : dict
        Every number for ``results.json``: decimal strings, integers, nested dicts and lists.
    """

    title: str
    summary: tuple[str, ...]
    chapters: tuple[Chapter, ...]
    results: dict[str, Any]

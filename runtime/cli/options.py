"""Arguments and options that several commands share."""

from __future__ import annotations

from enum import StrEnum
from pathlib import Path
from typing import Annotated

import typer

__all__ = [
    "PICTURES",
    "AsJson",
    "Assignments",
    "Digits",
    "Format",
    "Given",
    "Guess",
    "Kind",
    "OrbitName",
    "Physical",
    "Require",
    "Requirement",
    "Save",
    "SystemName",
    "Unknown",
]


PICTURES = (".png", ".svg", ".pdf")  # endings of files


class Format(StrEnum):
    """What `equations` writes."""

    LATEX = "latex"
    MARKDOWN = "markdown"
    HTML = "html"
    PDF = "pdf"


class Kind(StrEnum):
    """What `plot` draws."""

    TIME = "time"
    VELOCITY = "velocity"
    PHASE = "phase"
    STRIP = "strip"
    MULTIPLIERS = "multipliers"
    ALL = "all"


class Requirement(StrEnum):
    """Verdicts that can be required."""

    STABLE = "stable"
    ADMISSIBLE = "admissible"


OrbitName = Annotated[
    str,
    typer.Argument(
        metavar="SYSTEM/ORBIT",
        help="An orbit that `nonsmooth list` shows, or your own: FILE.py:ORBIT, or DIR:ORBIT"
        " of a folder that `nonsmooth generate` wrote; or one of a file: FILE.json:N, the N-th"
        " of `find --save`, or FILE.json of `solve --save`.",
    ),
]
SystemName = Annotated[
    str,
    typer.Argument(
        metavar="SYSTEM",
        help="A system that `nonsmooth list` shows, or your own: a FILE.py that defines `system`,"
        " or a folder that `nonsmooth generate` wrote.",
    ),
]
Physical = Annotated[
    list[str] | None,
    typer.Argument(
        metavar="NAME=VALUE",
        help="All physical parameters: chi=1/2 eta=1 V=1 us1=1 ...",
        show_default=False,
    ),
]
Assignments = Annotated[
    list[str] | None,
    typer.Argument(
        metavar="NAME=VALUE",
        help="Parameters: eta=0.98, chi=1/3, V=pi/3. Absent ones take their defaults"
        " (docs/parameters.md).",
        show_default=False,
    ),
]
Unknown = Annotated[
    list[str] | None,
    typer.Option("--unknown", metavar="NAME,...", help="Parameters to be solved for."),
]
Given = Annotated[
    list[str] | None,
    typer.Option(
        "--given", metavar="NAME=VALUE,...", help="Unknowns that are given in their place."
    ),
]
Guess = Annotated[
    list[str] | None,
    typer.Option("--guess", metavar="NAME=VALUE,...", help="Start of some or all unknowns."),
]
Require = Annotated[
    list[Requirement] | None,
    typer.Option("--require", help="Exit with 3 unless the orbit is so; may be repeated."),
]
Digits = Annotated[
    int,
    typer.Option(
        "--digits", metavar="N", help="The error of a number x is at most 10^-N max(1, |x|)."
    ),
]
Save = Annotated[
    Path | None,
    typer.Option("--save", metavar="FILE", help="Save the orbit with all its digits, as JSON."),
]
AsJson = Annotated[
    bool, typer.Option("--json", help="One JSON document on stdout, numbers as decimal strings.")
]

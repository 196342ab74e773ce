"""Arguments and options that several commands share."""

from __future__ import annotations

from collections.abc import Sequence
from enum import StrEnum
from pathlib import Path
from typing import Annotated

import typer

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.workload import HOURS
from nonsmooth.runtime.present.pictures.kinds import KINDS

__all__ = [
    "PICTURES",
    "AsJson",
    "Assignments",
    "Derivatives",
    "Digits",
    "Format",
    "Frequency",
    "FrequencyIn",
    "Given",
    "Guess",
    "Kind",
    "OrbitName",
    "Over",
    "Physical",
    "Plot",
    "Quantity",
    "Require",
    "RequiredVerdict",
    "Resume",
    "Save",
    "SaveResult",
    "Start",
    "SystemName",
    "Unknown",
    "Workers",
    "Yes",
    "known_orbits",
    "known_systems",
    "missing_start",
]


PICTURES = (".png", ".svg", ".pdf")  # endings of files


class Frequency(StrEnum):
    """The unit in which frequencies are drawn."""

    ANGULAR = "angular"
    CYCLES = "cycles"


class Format(StrEnum):
    """The formats that `equations` writes."""

    LATEX = "latex"
    MARKDOWN = "markdown"
    HTML = "html"
    PDF = "pdf"


class DocumentPart(StrEnum):
    """The parts of a document that `equations` writes alone."""

    FLOWS = "flows"
    EQUATIONS = "equations"
    MAP = "map"
    TRACE = "trace"


# What `plot` draws. Typer wants an enumeration; mypy wants its names written out, which are
# those of `present.pictures.kinds`, where a new kind is added.
Kind = StrEnum("Kind", {name.upper(): name for name in KINDS})  # type: ignore[misc]  # as above


class RefiningArithmetic(StrEnum):
    """The arithmetics that refine an orbit."""

    FLINT = "flint"
    MPMATH = "mpmath"
    BOTH = "both"


class RequiredVerdict(StrEnum):
    """The verdicts on an orbit that `--require` can demand."""

    STABLE = "stable"
    ADMISSIBLE = "admissible"


def known_orbits(incomplete: str) -> list[str]:
    """Names of built-in orbits that begin with a text, for the completion of a shell.

    A shell completes names of files by itself.
    """
    from nonsmooth.runtime.model.kernels import orbit_names

    return [name for name in orbit_names() if name.startswith(incomplete)]


def known_systems(incomplete: str) -> list[str]:
    """Names of built-in systems that begin with a text, for the completion of a shell."""
    from nonsmooth.runtime.model.kernels import system_names

    return [name for name in system_names() if name.startswith(incomplete)]


OrbitName = Annotated[
    str,
    typer.Argument(
        autocompletion=known_orbits,
        metavar="SYSTEM/ORBIT",
        help="An orbit that `nonsmooth list` shows, or your own: FILE.py:ORBIT, or DIR:ORBIT"
        " of a folder that `nonsmooth generate` wrote; or one of a file: FILE.json:N, the N-th"
        " of `find --save`, or FILE.json of `solve --save` or `design --save`.",
    ),
]
SystemName = Annotated[
    str,
    typer.Argument(
        autocompletion=known_systems,
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
        " (docs/parameters.md); those of an orbit in a file are in the file.",
        show_default=False,
    ),
]
Derivatives = Annotated[
    list[str] | None,
    typer.Option(
        metavar="NAME,...",
        help="Differentiate unknowns, period, trace, determinant and spectral radius by these"
        " given numbers.",
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
    list[RequiredVerdict] | None,
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
SaveResult = Annotated[
    Path | None, typer.Option("--save", metavar="FILE", help="Save all of it as JSON.")
]
Resume = Annotated[
    Path | None,
    typer.Option(
        "--resume",
        metavar="FILE",
        help="Go on with what --save wrote: the file holds the question, and keeps the answer.",
    ),
]
Plot = Annotated[
    Path | None, typer.Option("--plot", metavar="FILE", help="Draw it: .png, .svg or .pdf.")
]
Quantity = Annotated[
    list[str] | None,
    typer.Option(
        "--quantity",
        metavar="NAME,...",
        help="What is drawn of a branch: period, frequency, energy, trace, amplitude_x of a state"
        " x, or an unknown. Of a forced system by default the amplitude of each coordinate, else"
        " the period.",
    ),
]
FrequencyIn = Annotated[
    Frequency | None,
    typer.Option("--frequency", help="Frequencies in radians (as by default) or cycles."),
]
Over = Annotated[
    str | None,
    typer.Option(
        "--over",
        metavar="NAME",
        help="Over which other quantity, such as energy, in place of the parameter.",
    ),
]
Start = Annotated[
    list[str] | None,
    typer.Option("--from", metavar="NAME=VALUE,...", help="The start: all states but a forcing's."),
]
Workers = Annotated[
    int, typer.Option("--workers", min=1, metavar="N", help="Processes that share the work.")
]
Yes = Annotated[
    bool,
    typer.Option(
        "--yes",
        help=f"Begin even what is estimated to take this machine over {HOURS:g} hours.",
    ),
]
AsJson = Annotated[
    bool, typer.Option("--json", help="One JSON document on stdout, numbers as decimal strings.")
]


def missing_start(system: str, others: Sequence[str] = ()) -> InputError:
    """An error for the caller to raise: the start is missing, with an example of one.

    `others` lists further options that are missing.
    """
    from nonsmooth.runtime.model.structure import structure_of

    structure = structure_of(system)
    forced = {state for pair in structure.forcing for state in pair}
    free = [name for place, name in enumerate(structure.states) if place not in forced]
    begin = ",".join(f"{name}=0" for name in free)
    missing = f"{', '.join(others)} and the start are" if others else "the start is"
    return InputError(f"{missing} missing, such as --from {begin}")

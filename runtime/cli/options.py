"""Arguments and options that several commands share."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from nonsmooth.runtime.cli.completion import (
    complete_assignments,
    complete_files,
    complete_orbits,
    complete_systems,
)
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.workload import HOURS

if TYPE_CHECKING:
    from nonsmooth.runtime.orbits.orbit import Orbit

KEPT = "Keep and show"


class RequiredVerdict(StrEnum):
    """The verdicts on an orbit that `--require` can demand."""

    STABLE = "stable"
    ADMISSIBLE = "admissible"


class Proven(StrEnum):
    """The verdict that `--require` can demand of a proof."""

    PROVED = "proved"


def option(flag: str, told: str, metavar: str | None = None, **more: Any) -> Any:
    """An option with what it is for, the form of its value, and what else Typer takes."""
    return typer.Option(flag, help=told, metavar=metavar, **more)


OrbitName = Annotated[
    str,
    typer.Argument(
        autocompletion=complete_orbits,
        metavar="SYSTEM/ORBIT",
        help="An orbit that `nonsmooth list` shows; your own, FILE.py:ORBIT, or DIR:ORBIT of"
        " `generate`; or a saved one, FILE.json, or FILE.json:N, the N-th of `find --save`.",
        show_default=False,
    ),
]
SystemName = Annotated[
    str,
    typer.Argument(
        autocompletion=complete_systems,
        metavar="SYSTEM",
        help="A system that `nonsmooth list` shows; or your own, a FILE.py that defines `system`,"
        " or a folder of `generate`.",
        show_default=False,
    ),
]


def parameters_as(metavar: str, told: str) -> Any:
    """The argument of parameters, whose names are completed, with what a command says of it."""
    return typer.Argument(
        autocompletion=complete_assignments, metavar=metavar, help=told, show_default=False
    )


Parameters = Annotated[
    list[str] | None,
    parameters_as(
        "NAME=VALUE",
        "Parameters: eta=0.98, chi=1/3, V=pi/3. Absent ones take their defaults"
        " (docs/parameters.md); those of an orbit in a file are in the file.",
    ),
]
Physical = Annotated[
    list[str] | None,
    parameters_as("NAME=VALUE", "All physical parameters: chi=1/2 eta=1 V=1 us1=1 ..."),
]
Derivatives = Annotated[
    list[str] | None,
    option(
        "--derivatives",
        "Differentiate all that is told by these given numbers; of a motion also by its"
        " starts (x10), or by `all`.",
        "NAME,...",
    ),
]
Guess = Annotated[
    list[str] | None,
    option("--guess", "Start of some or all unknowns.", "NAME=VALUE,..."),
]
Require = Annotated[
    list[RequiredVerdict] | None,
    option("--require", "Exit with 3 unless the orbit is so; may be repeated."),
]
RequireProof = Annotated[
    Proven | None, option("--require", "Exit with 3 unless every claim is proved.")
]
Digits = Annotated[
    int,
    option("--digits", "The error of a number x is at most 10^-N max(1, |x|).", "N"),
]
Quantity = Annotated[
    list[str] | None,
    option(
        "--quantity",
        "What is drawn of a branch: period, frequency, energy, trace, amplitude_x of a state"
        " x, or an unknown. Of a forced system by default the amplitude of each coordinate, else"
        " the period.",
        "NAME,...",
    ),
]
Over = Annotated[
    str | None,
    option(
        "--over", "Over which other quantity, such as energy, in place of the parameter.", "NAME"
    ),
]
Start = Annotated[
    list[str] | None,
    option("--from", "The start: all states but a forcing's.", "NAME=VALUE,..."),
]
Configuration = Annotated[
    str | None,
    option("--in", "The configuration it starts in; found if not given.", "NAME"),
]
Seed = Annotated[int, option("--seed", "Of what is random.", "N")]
Beyond = Annotated[
    bool,
    option("--beyond", "Also the itineraries beyond each border collision."),
]
Check = Annotated[bool, option("--check", "Write nothing; exit with 1 if a file differs.")]
Tiles = Annotated[int, option("--tiles", "At most so many are looked at in all.", "N")]
Workers = Annotated[
    int | None,
    option("--workers", "How many share the work.", "N", min=1),
]
Yes = Annotated[
    bool,
    option("--yes", f"Begin even what is estimated to take this machine over {HOURS:g} hours."),
]
Save = Annotated[
    Path | None,
    option("--save", "Save all of it with all its digits, as JSON.", "FILE", rich_help_panel=KEPT),
]
Resume = Annotated[
    Path | None,
    option(
        "--resume",
        "Go on with what --save wrote: the file holds the question, which is then left out,"
        " and keeps the answer.",
        "FILE",
        autocompletion=complete_files,
        rich_help_panel=KEPT,
    ),
]
Plot = Annotated[
    Path | None,
    option("--plot", "Draw it: .png, .svg or .pdf.", "FILE", rich_help_panel=KEPT),
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


def solved_within(
    name: str, fixed: Mapping[str, object], ranges: Mapping[str, tuple[float, float]]
) -> Orbit:
    """An orbit whose parameters lie in ranges: at the reference point's values.

    Those that are outside, and are not fixed, lie in the middle.
    """
    from nonsmooth.runtime.orbits.solve import solve

    found: Orbit = solve(name, fixed)
    middles = {
        each: (low + high) / 2
        for each, (low, high) in ranges.items()
        if each in found.given and each not in fixed and not low <= float(found.given[each]) <= high
    }
    return solve(name, {**fixed, **middles}) if middles else found

"""The command line: what its program does first, and the commands of one orbit and of files.

What is heavy is imported by the commands that need it.
"""

from __future__ import annotations

import gc
import os
import sys
import warnings
from enum import StrEnum
from pathlib import Path
from typing import Annotated, Any

import typer

from nonsmooth.runtime.cli import (  # noqa: F401 - their commands join the application
    charting,
    continuing,
    deriving,
    designing,
    doctor,
    fitting,
    listing,
    motions,
)
from nonsmooth.runtime.cli.application import ANSWERED, UNANSWERED, app
from nonsmooth.runtime.cli.command import command
from nonsmooth.runtime.cli.completion import complete_files
from nonsmooth.runtime.cli.options import (
    Derivatives,
    Digits,
    Guess,
    OrbitName,
    Over,
    Parameters,
    Quantity,
    Require,
    RequiredVerdict,
    Save,
    option,
)
from nonsmooth.runtime.cli.parsing import assignments, guessed, split
from nonsmooth.runtime.cli.proofs import certifying, motion_sets, over_ranges  # noqa: F401 - as well
from nonsmooth.runtime.cli.reply import Reply, met
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.present.pictures.kinds import KINDS

__all__ = ["app", "main"]

_WORKING_DIGITS = 20  # at least: a verdict does not depend on how many digits are shown

# What `plot` draws. Typer wants an enumeration; mypy wants its names written out, which are
# those of `present.pictures.kinds`, where a new kind is added.
Kind = StrEnum("Kind", {name.upper(): name for name in KINDS})  # type: ignore[misc]  # as above
_ALL = Kind("all")


class RefiningArithmetic(StrEnum):
    """The arithmetics that refine an orbit."""

    FLINT = "flint"
    MPMATH = "mpmath"
    BOTH = "both"


Unknown = Annotated[
    list[str] | None,
    option("--unknown", "Parameters to be solved for.", "NAME,..."),
]
Given = Annotated[
    list[str] | None,
    option("--given", "Unknowns that are given in their place.", "NAME=VALUE,..."),
]


def main(command: str | None = None) -> None:
    """Run the command line, or the one command of that name as a script."""
    if not sys.warnoptions:
        warnings.simplefilter("ignore")  # overflows and the like: answers say what they are
    os.environ["MPLBACKEND"] = "agg"  # pictures are files: what the user names is for windows
    # derivations make millions of small objects without cycles, and the same ones again
    os.environ.setdefault("SYMPY_CACHE_SIZE", "50000")
    gc.set_threshold(50_000, 20, 20)
    _open_streams()
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(errors="backslashreplace")
    group: Any = typer.main.get_command(app)
    if command is None:
        group(prog_name="nonsmooth")
    else:
        group.commands[command](prog_name=Path(sys.argv[0]).name)


def _open_streams() -> None:
    """Replace closed standard streams by the null device, which child processes inherit.

    Else the next file that is opened would get the number of such a stream.
    """
    for name, mode in (("stdin", "r"), ("stdout", "w"), ("stderr", "w")):
        if getattr(sys, name) is None:
            stream = open(os.devnull, mode, encoding="utf-8")  # noqa: SIM115 - as long as this runs
            os.set_inheritable(stream.fileno(), True)
            setattr(sys, name, stream)


@command(
    "solve",
    "solve dry-friction/global-stick eta=0.98 V=1.01",
    "solve dry-friction/global-stick us2=0.8 us1=1 --require admissible",
    "solve dry-friction/global-stick --unknown e1,e2 --given ta=1,tau=2",
    "solve dry-friction/global-stick --save orbit.json",
    "solve dry-friction/global-stick --derivatives eta,V",
    "solve found.json:1 Omega=2.5 --digits 30",
    save=Save,
)
def solve(
    orbit: OrbitName,
    parameters: Parameters = None,
    unknown: Unknown = None,
    given: Given = None,
    guess: Guess = None,
    digits: Digits = 15,
    derivatives: Derivatives = None,
    require: Require = None,
    *,
    reply: Reply,
) -> int:
    """Find a periodic orbit: unknowns, multipliers, stability, admissibility."""
    problem = (orbit, parameters, unknown, given, guess, digits, derivatives)
    return _report(*problem, require=require, reply=reply)


@command(
    "verify",
    "verify dry-friction/global-stick --digits 50",
    "verify dry-friction/global-stick --digits 50 --arithmetic both",
    "verify dry-friction/global-stick eta=0.98 --require stable --json",
    save=Save,
)
def verify(
    orbit: OrbitName,
    parameters: Parameters = None,
    unknown: Unknown = None,
    given: Given = None,
    guess: Guess = None,
    digits: Digits = 50,
    arithmetic: Annotated[
        RefiningArithmetic,
        option(
            "--arithmetic",
            "What refines the orbit: balls, whose digits are proved; mpmath, whose digits are"
            " compared with twice as many; or both, which have to agree, and how far they differ:"
            " in the unknowns, and in the trace where it is enclosed.",
        ),
    ] = RefiningArithmetic.FLINT,
    require: Require = None,
    *,
    reply: Reply,
) -> int:
    """Decide stability by the trace, to any number of digits, and enclose the trace.

    The enclosure holds the trace of the one orbit in a box around the numbers shown; the
    criterion, if the trace has one, is proved if it holds for all of the enclosure. Orbits
    composed from tables are certified instead.
    """
    problem = (orbit, parameters, unknown, given, guess, digits, None)
    return _report(*problem, require=require, reply=reply, verified_by=arithmetic)


@command(
    "plot",
    "plot orbit.json",
    "plot orbit.json --kind phase --out phase.svg",
    "plot motion.npz --kind strip",
    "plot found.json:2",
    "plot F.zarr --out F.png",
    "plot branch.json --quantity amplitude_x1,period",
    "plot orbit.json --kind time --periods 2 --out time.pdf",
)
def plot(
    file: Annotated[
        Path,
        typer.Argument(
            autocompletion=complete_files,
            metavar="FILE",
            help="What a command wrote with --save: an orbit, a motion, found orbits or one of"
            " them, FILE.json:N, a branch, a curve of events, a sweep, a fit, a design, a proof"
            " that has a picture; or a chart of `chart --out`.",
        ),
    ],
    kind: Annotated[Kind, option("--kind", "What to draw of an orbit or a motion.")] = _ALL,
    periods: Annotated[
        int,
        option("--periods", "How many of an orbit to draw against time.", "N"),
    ] = 1,
    quantity: Quantity = None,
    over: Over = None,
    out: Annotated[
        Path | None,
        option("--out", "A PNG, SVG or PDF; FILE.png by default.", "FILE"),
    ] = None,
    *,
    reply: Reply,
) -> int:
    """Draw what is saved: histories, phase portraits, multipliers, branches, maps."""
    from nonsmooth.runtime.core.files import check_target
    from nonsmooth.runtime.present.pictures.plot import save_figure
    from nonsmooth.runtime.present.pictures.saved_files import figure_of

    if not file.name:
        raise InputError(f"{file} is no saved file")
    own = file.with_name(f"{Path(file.name.replace('.json:', '-')).stem}.png")
    target = own if out is None else out
    if os.path.realpath(target) == os.path.realpath(file):
        raise InputError(f"cannot write {target}: it is the saved file")
    check_target(target)
    of_branch = {"quantity": tuple(split(quantity)) or None, "over": over}
    drawn, figure = figure_of(file, kind.value, periods, of_branch if quantity or over else None)
    save_figure(figure, target)
    told = {**drawn, "kind": kind.value, "file": str(target)}
    return reply.show(lambda: told, lambda: print(f"{target} written"))


@command("reproduce", "reproduce --out paper", "reproduce --out paper --certify --json")
def reproduce(
    out: Annotated[Path, option("--out", "Folder of the report, made if need be.", "DIR")],
    certified: Annotated[
        bool, option("--certify", "Add what ball arithmetic proves of every orbit.")
    ] = False,
    *,
    reply: Reply,
) -> int:
    """Write every number and figure of the source paper beside ours: a report in HTML."""
    from nonsmooth.runtime.cli.deriving import section_formulas
    from nonsmooth.runtime.cli.display import show_written, steps
    from nonsmooth.runtime.present.paper.writing import reproduce as write

    with steps() as begin:
        files = [str(path) for path in write(out, section_formulas, begin, certified=certified)]
    pages = [f"{path} written" for path in files if not path.endswith((".svg", ".png"))]
    return reply.show(lambda: {"folder": str(out), "files": files}, lambda: show_written(pages, ""))


def _report(
    name: str,
    parameters: list[str] | None,
    unknown: list[str] | None,
    given: list[str] | None,
    guess: list[str] | None,
    digits: int,
    derivatives: list[str] | None,
    *,
    require: list[RequiredVerdict] | None,
    reply: Reply,
    verified_by: RefiningArithmetic | None = None,
) -> int:
    """Solve for an orbit, refine, save and show it; gives the exit code.

    One that is verified is refined by that arithmetic, and its trace is enclosed and shown first.
    """
    from nonsmooth.runtime.core.values import decimal_string
    from nonsmooth.runtime.model.kernels import is_saved
    from nonsmooth.runtime.orbits.refine import check_digits, refine, refine_both
    from nonsmooth.runtime.orbits.solve import solve as find_orbit
    from nonsmooth.runtime.present.report import (
        derivatives_json,
        orbit_json,
        short,
        trace_proof_json,
    )

    check_digits(digits)
    assigned = assignments("parameter", parameters or [])
    found = find_orbit(
        name,
        assigned,
        guessed(guess),
        unknown=split(unknown),
        given=assignments("unknown", split(given)),
    )
    working = max(digits, _WORKING_DIGITS)
    by_kernels = found.problem.derived
    arithmetic = (verified_by or RefiningArithmetic.FLINT).value
    if verified_by is RefiningArithmetic.BOTH:
        refined = refine_both(found, working)
        orbit = refined.by_balls
    else:
        refined, orbit = None, refine(found, working, arithmetic=arithmetic)
    told = orbit_json(orbit, digits)
    if verified_by is not None:
        told["arithmetic"] = arithmetic if by_kernels else RefiningArithmetic.MPMATH.value
        if refined is not None:
            told["difference"], told["compared"] = short(refined.difference), refined.compared
        told["proof"] = trace_proof_json(orbit)
    for parameter, value in assigned.items():  # also those that others stand for
        told["parameters"][parameter] = decimal_string(value.mpf(digits + 5), digits)
    if derivatives:
        told["derivatives"] = derivatives_json(orbit, split(derivatives), digits)

    def show() -> None:
        from nonsmooth.runtime.cli.display import show_told
        from nonsmooth.runtime.present.report import tell_report

        absent = f"from {name}" if is_saved(name) else "default"
        show_told(tell_report(orbit, told, assigned, absent))

    code = reply.give(orbit, told=lambda: told, show=show)
    verdicts = {"stable": told["stability"], "admissible": told["admissible"]}
    undecided = UNANSWERED if "undecided" in verdicts.values() else ANSWERED
    return code or met(verdicts, require) or undecided

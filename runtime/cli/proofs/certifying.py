"""The commands that certify: one orbit, all orbits of an itinerary, and saved certificates."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from pathlib import Path
from typing import Annotated, Any

import typer
from typer.core import TyperGroup

from nonsmooth.runtime.cli.application import (
    ANSWERED,
    UNANSWERED,
    WRONG_INPUT,
    app,
    print_json,
)
from nonsmooth.runtime.cli.command import command
from nonsmooth.runtime.cli.completion import complete_files
from nonsmooth.runtime.cli.keeping import say, worked
from nonsmooth.runtime.cli.options import (
    Derivatives,
    Guess,
    OrbitName,
    Parameters,
    RequireProof,
    Save,
    Workers,
    option,
    parameters_as,
)
from nonsmooth.runtime.cli.parsing import assignments, guessed, split, values_and_ranges
from nonsmooth.runtime.cli.reply import Reply, proved
from nonsmooth.runtime.core.errors import InputError

_MORE = 8  # bits beyond those of the digits
_SUBCOMMANDS = (
    *("orbit", "box", "branch", "event", "doubling", "all"),
    *("basin", "region", "chaos", "check"),
)

EnclosedDigits = Annotated[int, option("--digits", "Decimals of the enclosures.", "N", min=1)]


class _Certify(TyperGroup):
    """The group of `certify`: an orbit in place of a subcommand is that of `certify orbit`."""

    def list_commands(self, ctx: Any) -> list[str]:
        """Names of the subcommands, as people look for them."""
        return [*_SUBCOMMANDS]

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Read the words of the command line; without any the help is shown."""
        if not args and not ctx.resilient_parsing:
            ctx.get_help()
            raise typer.Exit(WRONG_INPUT)
        names: Mapping[str, Any] = self.commands
        if args and args[0] not in names and not re.fullmatch(r"--help|\w+", args[0]):
            args = ["orbit", *args]
        parsed: list[str] = super().parse_args(ctx, args)
        return parsed

    def shell_complete(self, ctx: Any, incomplete: str) -> list[Any]:
        """Subcommands, and orbits in their place."""
        orbit = next(each for each in self.commands["orbit"].params if each.name == "orbit")
        return [
            *super().shell_complete(ctx, incomplete),
            *orbit.shell_complete(ctx, incomplete),
        ]


certifying = typer.Typer(
    cls=_Certify,
    help="Prove by ball arithmetic what an orbit, a branch, or a motion does.\n\n"
    "`certify ORBIT` is `certify orbit ORBIT`.",
    rich_markup_mode="rich",
    subcommand_metavar="[orbit] ORBIT | SUBCOMMAND",
)
app.add_typer(certifying, name="certify")


@command(
    "orbit",
    "certify dry-friction/global-stick eta=0.98",
    "certify rigid-stop/one-impact T=2*pi --digits 100 --require proved",
    "certify orbit my_oscillator.py:loop --save certificate.json",
    "certify orbit dry-friction/global-stick eta=0.98 --derivatives eta,V",
    group=certifying,
    save=Save,
    long=True,
)
def certify_orbit(
    orbit: OrbitName,
    parameters: Parameters = None,
    guess: Guess = None,
    digits: EnclosedDigits = 36,
    derivatives: Derivatives = None,
    require: RequireProof = None,
    *,
    reply: Reply,
) -> int:
    """Prove that an orbit exists, is a motion of the system, and is stable."""
    from nonsmooth.runtime.cli.display import steps
    from nonsmooth.runtime.orbits.solve import solve
    from nonsmooth.runtime.proof.certify_orbit import certify as prove

    for text in parameters or ():
        if ":" in text:
            raise InputError(
                f"{text} is a range: `certify box` proves all of a box, `certify branch` all of a"
                " branch, `certify event` and `certify doubling` what happens on it, and"
                " `certify all` takes ranges of dwell times"
            )
    by = split(derivatives) if derivatives else None
    if by == []:
        raise InputError("--derivatives: no parameter is named, as in --derivatives eta,V")
    values = assignments("parameter", parameters or ())
    with steps(f"solving {orbit}") as begin:
        found = solve(orbit, values, guessed(guess))
        certificate = prove(found, bits_of(digits), derivatives=by, begin=begin)
    return reply.give(
        certificate,
        enough=certificate.decided,
        require=require,
    )


@command(
    "all",
    "certify all dry-friction/global-stick tau=0:6.3 tau1=0:6.3",
    group=certifying,
    save=Save,
    long=True,
)
def certify_all(
    orbit: OrbitName,
    parameters: Annotated[
        list[str] | None,
        parameters_as(
            "NAME=VALUE|A:B",
            "Parameters in NAME=VALUE form, and the box of dwell times: tau=0:12.6 for each."
            " tau=:12.6 begins at 1e-6; 0 does not belong to the box.",
        ),
    ] = None,
    digits: EnclosedDigits = 36,
    require: RequireProof = None,
    *,
    reply: Reply,
) -> int:
    """Prove how many orbits an itinerary has with dwell times in a box."""
    from nonsmooth.runtime.cli.display import steps
    from nonsmooth.runtime.proof.certify_all import certify_all as count

    values, ranged = values_and_ranges(parameters, blank=True)
    for name, (_, high) in ranged.items():
        if high is None:
            raise InputError(f"{name} has no upper bound: it is written {name}=0:12.6")
    bounds = {name: high if low is None else (low, high) for name, (low, high) in ranged.items()}
    with steps() as begin:
        census, stopped = worked(
            lambda: count(orbit, values, bounds, bits=bits_of(digits), begin=begin)
        )
    return reply.give(
        census,
        stopped,
        enough=census.decided,
        done=f"{census.looked} boxes are looked at, {census.count} orbits found",
        require=require,
    )


@command(
    "check",
    "certify check certificate.json",
    "certify check certificate.json my_oscillator.py:loop --require proved",
    group=certifying,
)
def check(
    file: Annotated[
        Path,
        typer.Argument(
            autocompletion=complete_files,
            metavar="FILE",
            help="What `certify` wrote with --save.",
            show_default=False,
        ),
    ],
    declared: Annotated[
        str | None,
        typer.Argument(
            metavar="FILE.py:ORBIT",
            help="A declaration that has to be the one in the file.",
            show_default=False,
        ),
    ] = None,
    workers: Workers = None,
    require: RequireProof = None,
    *,
    reply: Reply,
) -> int:
    """Prove a saved certificate again, from the file alone; exit with 1 if it differs.

    The work on a basin can be shared.
    """
    from nonsmooth.runtime.cli.display import shared, show_result
    from nonsmooth.runtime.present.check_file import check_certificate

    with shared(f"proving {file} again") as progress:
        found = check_certificate(
            file,
            declared,
            workers=workers or 1,
            progress=lambda done, count: progress(done / count, done),
        )
    if reply.as_json:
        same = found.difference is None
        told = {"file": str(file), "same": same, "claims": dict(found.claims)}
        print_json({**told, "difference": found.difference, "note": found.note})
    elif found.difference is None:
        show_result(found)
        print(f"{file}: every claim holds; what is shown was proved again from the file")
    if found.difference is not None:
        say(f"{file}: {found.difference}")
        return UNANSWERED
    return proved(found.claims, ANSWERED) if require else ANSWERED


def bits_of(digits: int) -> int:
    """The working precision in bits at which enclosures have that many decimals."""
    return max(53, math.ceil(digits * math.log2(10)) + _MORE)

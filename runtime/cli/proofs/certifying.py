"""The command that certifies orbits, and checks certificates."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from enum import StrEnum
from pathlib import Path
from typing import Annotated

import typer

from nonsmooth.runtime.cli.application import (
    ANSWERED,
    NOT_MET,
    UNANSWERED,
    answering,
    app,
    assignments,
    print_json,
    split,
)
from nonsmooth.runtime.cli.keeping import INTERRUPTED, Overwrite, check_new, say
from nonsmooth.runtime.cli.options import AsJson, Assignments, Guess, Resume, SaveResult, Yes
from nonsmooth.runtime.cli.proofs.counting import Every, count_orbits
from nonsmooth.runtime.cli.proofs.long_proofs import LongProof
from nonsmooth.runtime.cli.proofs.over_ranges import (
    certify_events,
    certify_flip,
    certify_over,
    certify_whole_branch,
    is_box,
)
from nonsmooth.runtime.cli.resuming import resumable
from nonsmooth.runtime.cli.written import Written
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.workload import SECONDS, check_hours

__all__ = ["certify"]

_BITS = 128
_TILES = 4000
_BRANCH_TILES = 2000
_MORE = 8  # bits beyond those of the digits


class Proven(StrEnum):
    """The verdict that `--require` can demand of a proof."""

    PROVED = "proved"


@app.command(
    epilog="Examples:\n\n"
    "nonsmooth certify dry-friction/global-stick eta=0.98\n\n"
    "nonsmooth certify rigid-stop/one-impact T=2*pi --digits 100 --require proved\n\n"
    "nonsmooth certify my_oscillator.py:loop --save certificate.json\n\n"
    "nonsmooth certify dry-friction/global-stick eta=0.98 --derivatives eta,V\n\n"
    "nonsmooth certify dry-friction/global-stick V=0.9:1.1 eta=0.9:1.1 --save map.json"
    " --plot map.png\n\n"
    "nonsmooth certify dry-friction/global-stick --all tau=0:6.3 tau1=0:6.3\n\n"
    "nonsmooth certify dry-friction/symmetric V=0.6:1.3 --events --digits 50 --save events.json\n\n"
    "nonsmooth certify dry-friction/symmetric V=0.6:1.3 --branch --save branch.json"
    " --plot branch.png\n\n"
    "nonsmooth certify dry-friction/symmetric V=1:1.2 --doubling --save doubling.json"
    " --plot doubling.png\n\n"
    "nonsmooth certify --check certificate.json"
)
@answering
@resumable(
    "orbit parameters guess digits bits derivatives every events branch doubling",
    anew="tiles beyond",
)
def certify(
    orbit: Annotated[
        str | None,
        typer.Argument(
            metavar="SYSTEM/ORBIT",
            help="An orbit that `nonsmooth list` shows, your own FILE.py:ORBIT, or FILE.json:N of"
            " `find --save`.",
            show_default=False,
        ),
    ] = None,
    parameters: Assignments = None,
    guess: Guess = None,
    digits: Annotated[
        int | None, typer.Option("--digits", metavar="N", help="Decimals of the enclosures.")
    ] = None,
    bits: Annotated[
        int | None,
        typer.Option("--bits", metavar="N", help=f"Or binary digits of them; {_BITS} by default."),
    ] = None,
    require: Annotated[
        Proven | None, typer.Option("--require", help="Exit with 3 unless every claim is proved.")
    ] = None,
    save: SaveResult = None,
    tiles: Annotated[
        int | None,
        typer.Option(
            "--tiles",
            metavar="N",
            help=f"Of a box at most so many are looked at in all, {_TILES} by default; of a branch"
            f" {_BRANCH_TILES}.",
        ),
    ] = None,
    resume: Resume = None,
    plot: Annotated[
        Path | None,
        typer.Option(
            "--plot", metavar="FILE", help="Draw the box's map, or the branch: .png, .svg or .pdf."
        ),
    ] = None,
    derivatives: Annotated[
        list[str] | None,
        typer.Option(
            "--derivatives",
            metavar="NAME,...",
            help="Enclose the derivatives of start, dwell times, period, trace and multipliers by"
            " these given numbers.",
        ),
    ] = None,
    check: Annotated[
        Path | None,
        typer.Option(
            "--check",
            metavar="FILE",
            help="Prove a saved certificate again, from the file alone; exit with 1 if it differs."
            " With FILE.py:ORBIT that declaration has to be the one in the file.",
        ),
    ] = None,
    overwrite: Overwrite = False,
    every: Every = False,
    events: Annotated[
        bool,
        typer.Option(
            "--events", help="Enclose the bifurcations and collisions over one range, V=0.6:1.3."
        ),
    ] = False,
    branch: Annotated[
        bool,
        typer.Option(
            "--branch",
            help="Prove all of the branch over one range, V=0.6:1.3: every interval and event.",
        ),
    ] = False,
    beyond: Annotated[
        bool,
        typer.Option(
            "--beyond",
            help="With --branch: prove which other itineraries begin where it meets a border,"
            " and on which side.",
        ),
    ] = False,
    doubling: Annotated[
        bool,
        typer.Option(
            "--doubling",
            help="Prove the orbits of twice the period beside the first flip over one range,"
            " V=1:1.2, their side and stability, and how they go on.",
        ),
    ] = False,
    seconds: Annotated[
        float | None,
        typer.Option(
            "--seconds",
            min=0,
            help="With --branch or --doubling: after so long nothing more is begun;"
            " --resume goes on.",
        ),
    ] = None,
    workers: Annotated[
        int,
        typer.Option(
            "--workers", min=1, metavar="N", help="With --check: processes that share a basin."
        ),
    ] = 1,
    yes: Yes = False,
    as_json: AsJson = False,
) -> int:
    """Prove that an orbit exists, is a motion of the system, and is stable: by ball arithmetic.

    Ranges of parameters, V=0.99:1.01, span a box: all of it is proved for each of its points.

    Of two parameters regions, curves of events between them, and what is left open are told.

    The exit code is then 1 while more than 1 % of the box is undecided.

    With --all ranges are of dwell times, and orbits are counted; with --events: what happens;
    with --branch: that nothing else happens; with --doubling: what is beyond a flip.
    """
    if check is not None:
        options = (
            parameters, guess, digits, bits, save, resume, plot, tiles, derivatives, seconds,
        )  # fmt: skip
        chosen = (every, events, branch, doubling, beyond, overwrite, yes)
        if any(chosen) or any(option is not None and option != [] for option in options):
            raise InputError("--check takes a file, and perhaps its orbit, and nothing else")
        return _check(check, orbit, require, workers, as_json=as_json)
    if workers != 1:
        raise InputError("--workers goes with --check")
    if orbit is None:
        raise InputError("an orbit is missing, --resume FILE or --check FILE")
    if every + events + branch + doubling > 1:
        raise InputError(
            "--all, --events, --branch and --doubling are questions of their own: ask one of them"
        )
    if seconds is not None and not (branch or doubling):
        raise InputError("--seconds is for --branch and --doubling")
    if derivatives and (every or events or branch or is_box(parameters)):
        raise InputError("--derivatives are for one orbit, at one point")
    if beyond and not branch:
        raise InputError("--beyond goes with --branch")
    near = {n: float(v) for n, v in assignments("unknown", split(guess)).items()} or None
    given = parameters or []
    proof = LongProof(
        name=orbit, parameters=given, near=near, resume=resume, save=save, plot=plot,
        overwrite=overwrite, as_json=as_json,
    )  # fmt: skip
    if branch:
        if digits is not None or bits is not None:
            raise InputError("--digits and --bits are not for --branch: --events takes them")
        looked_at = _BRANCH_TILES if tiles is None else tiles
        check_hours(f"{looked_at} tiles", looked_at * SECONDS["tile"], yes=yes)
        told, code = certify_whole_branch(proof, looked_at, seconds, beyond=beyond)
        return _judged(told, require, code)
    if doubling:
        if digits is not None or bits is not None:
            raise InputError("--digits and --bits are not for --doubling")
        looked_at = _BRANCH_TILES if tiles is None else tiles
        check_hours(f"{looked_at} tiles", looked_at * SECONDS["tile"], yes=yes)
        told, code = certify_flip(proof, looked_at, seconds)
        return _judged(told, require, code)
    if is_box(parameters) and not (every or events):
        if digits is not None or bits is not None:
            raise InputError("--digits and --bits are for one point: a box's enclosures are wide")
        looked_at = _TILES if tiles is None else tiles
        check_hours(f"{looked_at} tiles", looked_at * SECONDS["tile"], yes=yes)
        told, code = certify_over(proof, looked_at)
        return _judged(told, require, code)
    if tiles is not None:
        raise InputError("--tiles is for a box of parameters, as in V=0.99:1.01")
    if plot is not None or (resume is not None and not events):
        raise InputError("--resume and --plot are for a box of parameters, as in V=0.99:1.01")
    check_new(save, overwrite, resume, resumes=events)
    if digits is not None and bits is not None:
        raise InputError("--digits and --bits say the same: give one of them")
    if digits is not None:
        if digits < 1:
            raise InputError(f"digits = {digits} is not a positive integer")
        bits = max(53, math.ceil(digits * math.log2(10)) + _MORE)
    wanted = _BITS if bits is None else bits
    if every:
        return count_orbits(orbit, parameters, guess, wanted, require, save, as_json=as_json)
    if events:
        told, code = certify_events(orbit, given, near, wanted, resume, save, as_json=as_json)
        return _judged(told, require, code)
    by = split(derivatives) if derivatives else None
    if by == []:
        raise InputError("--derivatives: no parameter is named, as in --derivatives eta,V")
    return _certify(orbit, parameters, near, wanted, by, require, save, as_json)


def _certify(
    orbit: str,
    parameters: list[str] | None,
    near: dict[str, float] | None,
    bits: int,
    by: Sequence[str] | None,
    require: Proven | None,
    save: Path | None,
    as_json: bool,
) -> int:
    from nonsmooth.runtime.cli.display import steps
    from nonsmooth.runtime.cli.proofs.display_certificates import show_certificate
    from nonsmooth.runtime.orbits.solve import solve
    from nonsmooth.runtime.proof.certify_orbit import certify as prove

    values = assignments("parameter", parameters or [])
    with steps(f"solving {orbit}") as begin:
        found = solve(orbit, values, near)
        certificate = prove(found, bits, derivatives=by, begin=begin)
    written = Written()
    written.save(certificate.save, save)
    code = written.show_one(
        certificate.to_json, lambda: show_certificate(certificate), save, as_json=as_json
    )
    return code or _judged(
        certificate.claims, require, ANSWERED if certificate.decided else UNANSWERED
    )


def _check(
    path: Path, declared: str | None, require: Proven | None, workers: int, *, as_json: bool
) -> int:
    from nonsmooth.runtime.cli.display import shared
    from nonsmooth.runtime.cli.proofs.display_checks import show_check
    from nonsmooth.runtime.present.checking.check_file import check_certificate
    from nonsmooth.runtime.proof.counting.census import Census

    with shared(f"proving {path} again") as progress:
        found = check_certificate(
            path,
            declared,
            workers=workers,
            progress=lambda done, count: progress(done / count, done),
        )
    if as_json:
        same = found.difference is None
        told = {"file": str(path), "same": same, "claims": dict(found.claims)}
        print_json({**told, "difference": found.difference, "note": found.note})
    elif found.difference is None:
        show_check(found)
        every = "" if isinstance(found.certificate, Census) else "every claim holds; "
        print(f"{path}: {every}what is shown was proved again from the file")
        if found.note:
            print(found.note)
    if found.difference is not None:
        say(f"{path}: {found.difference}")
        return UNANSWERED
    return _judged(found.claims, require, ANSWERED)


def _judged(claims: Mapping[str, str], require: Proven | None, code: int) -> int:
    """The given exit code, or `NOT_MET` if `--require` is given and a claim is not proved.

    Missed claims are named on stderr. The code of an interrupted command stays.
    """
    if code == INTERRUPTED:
        return code
    missed = [f"{name} {verdict}" for name, verdict in claims.items() if verdict != "proved"]
    if require is not None and missed:
        say(f"required: proved; found: {', '.join(missed)}")
        return NOT_MET
    return code

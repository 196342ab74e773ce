"""The command that proves part of a basin."""

from __future__ import annotations

from typing import Annotated

import typer

from nonsmooth.runtime.cli.application import NOT_MET, answering, app, assignments, split
from nonsmooth.runtime.cli.keeping import INTERRUPTED, Overwrite, say, worked
from nonsmooth.runtime.cli.options import (
    AsJson,
    Assignments,
    Guess,
    Plot,
    Resume,
    SaveResult,
    Workers,
)
from nonsmooth.runtime.cli.proofs.certifying import Proven
from nonsmooth.runtime.cli.proofs.long_proofs import LongProof
from nonsmooth.runtime.cli.resuming import resumable
from nonsmooth.runtime.core.errors import InputError

__all__ = ["basin"]


@app.command(
    epilog="Examples:\n\n"
    "nonsmooth basin dry-friction/global-stick us1=1 us2=1 ur1=4.0195 ur2=1.4831"
    " --box x1=2.5:2.75,x2=6.5:6.75,v1=-0.25:0,v2=-0.25:0 --side 0.125 --save basin.json\n\n"
    "nonsmooth basin mass_on_belt.py:stick-slip --box x=0:2,v=-0.5:0.5 --side 0.25 --workers 2"
    " --plot basin.png"
)
@answering
@resumable("orbit parameters guess box side parts", anew="tiles")
def basin(
    orbit: Annotated[
        str,
        typer.Argument(
            metavar="SYSTEM/ORBIT",
            help="A stable orbit that `nonsmooth list` shows, your own FILE.py:ORBIT, or"
            " FILE.json:N of `find --save`.",
            show_default=False,
        ),
    ],
    parameters: Assignments = None,
    guess: Guess = None,
    box: Annotated[
        list[str] | None,
        typer.Option(
            "--box",
            metavar="STATE=A:B,...",
            help="The box of starts; other states take what `find` uses.",
        ),
    ] = None,
    side: Annotated[
        float | None, typer.Option("--side", metavar="H", help="The longest side of a tile.")
    ] = None,
    tiles: Annotated[
        int, typer.Option("--tiles", metavar="N", help="At most so many are looked at in all.")
    ] = 20_000,
    parts: Annotated[
        int, typer.Option("--parts", metavar="N", help="Parts of one tile, at most.")
    ] = 60,
    workers: Workers = 1,
    require: Annotated[
        Proven | None, typer.Option("--require", help="Exit with 3 unless a basin is proved.")
    ] = None,
    resume: Resume = None,
    save: SaveResult = None,
    plot: Plot = None,
    overwrite: Overwrite = False,
    as_json: AsJson = False,
) -> int:
    """Prove from which starts every motion tends to an orbit.

    Around the orbit a set is proved to be contracted; then boxes of a section, and tiles of a
    box of starts, are proved to lead there. What is not proved may be attracted nevertheless.

    Tiles are looked at where most of them have been attracted so far.

    `certify --check` proves what is saved again.
    """
    from nonsmooth.runtime.cli.display import shared, steps
    from nonsmooth.runtime.cli.tables import show_result
    from nonsmooth.runtime.orbits.solve import solve
    from nonsmooth.runtime.present.files.kept import format_named
    from nonsmooth.runtime.proof.basin.certify_basin import certify_basin

    near = {n: float(v) for n, v in assignments("unknown", split(guess)).items()} or None
    proof = LongProof(
        name=orbit,
        parameters=parameters or [],
        near=near,
        resume=resume,
        save=save,
        plot=plot,
        overwrite=overwrite,
        as_json=as_json,
    )
    known = proof.known(format_named("nonsmooth basin certificate").load)
    limits = dict(map(_bounds, split(box)))
    with steps(f"solving {orbit}"):
        solved = solve(orbit, assignments("parameter", parameters or []), near)
    with shared(f"proving {orbit}") as progress:
        found, stopped = worked(
            lambda: certify_basin(
                solved,
                box=limits,
                side=side,
                tiles=tiles,
                most=parts,
                workers=workers,
                resume=known,
                progress=progress,
                keep=proof.keep,
            )
        )
    done = f"{int(found.attracted.sum())} of {int(found.looked.sum())} tiles are attracted"
    claims, code = proof.answer(found, stopped, show_result, enough=found.proved, done=done)
    if code != INTERRUPTED and require is not None and claims["basin"] != "proved":
        say(f"required: proved; found: basin {claims['basin']}")
        return NOT_MET
    return code


def _bounds(text: str) -> tuple[str, tuple[float, float]]:
    """Name of a state and its bounds (low, high), parsed from ``STATE=A:B``."""
    name, _, bounds = text.partition("=")
    low, _, high = bounds.partition(":")
    try:
        return name.strip(), (float(low), float(high))
    except ValueError:
        raise InputError(f"{text!r} is no range of a state, as in x1=-1:1") from None

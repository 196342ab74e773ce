"""The command that proves where motions go from the boxes of a region."""

from __future__ import annotations

from enum import StrEnum
from typing import Annotated

import typer

from nonsmooth.runtime.cli.application import (
    NOT_MET,
    answering,
    app,
    assignments,
    ranges,
    split,
)
from nonsmooth.runtime.cli.keeping import INTERRUPTED, Overwrite, say, worked
from nonsmooth.runtime.cli.options import (
    AsJson,
    Physical,
    Plot,
    Resume,
    SaveResult,
    Start,
    SystemName,
    Workers,
    missing_start,
)
from nonsmooth.runtime.cli.proofs.long_proofs import LongProof
from nonsmooth.runtime.cli.resuming import resumable
from nonsmooth.runtime.core.workload import SECONDS, hours_told

__all__ = ["graph"]

_SOON = 60.0  # seconds: of what takes no longer nothing is said before


class Trapping(StrEnum):
    """The verdict that `--require` can demand of a graph."""

    TRAPPING = "trapping"


@app.command(
    epilog="Examples:\n\n"
    "nonsmooth graph dry-friction chi=0.5 eta=1 V=1 us1=1 us2=1 ur1=4.0195 ur2=1.4831"
    " --from x1=5,x2=4,v1=0.5,v2=0.25 --region x2=2:14 --boxes 64 --levels 3 --save graph.json\n\n"
    "nonsmooth graph impact_oscillator.py r=0.65 sigma=0 w=2.3 --from x=-0.7,v=0.1"
    " --region x=-2:0,v=-2:2 --boxes 32 --levels 1 --plot graph.png --require trapping"
)
@answering
@resumable("system parameters start configuration boxes region", anew="levels parts transitions")
def graph(
    system: SystemName,
    parameters: Physical = None,
    start: Start = None,
    configuration: Annotated[
        str | None,
        typer.Option(
            "--in", metavar="NAME", help="The configuration it starts in; found if not given."
        ),
    ] = None,
    boxes: Annotated[
        int | None,
        typer.Option(
            "--boxes",
            metavar="N",
            help="Boxes along each coordinate of the section, at least; 1024 of one coordinate,"
            " 96 of each of two, if not given.",
        ),
    ] = None,
    region: Annotated[
        list[str] | None,
        typer.Option(
            "--region",
            metavar="NAME=A:B,...",
            help="The region of the section; if not given, where the motion comes to, and a"
            " quarter more at both sides.",
        ),
    ] = None,
    levels: Annotated[
        int,
        typer.Option(
            "--levels",
            metavar="N",
            help="How often boxes are divided at most: those on cycles, of unknown image, and"
            " those that leave the region in part.",
        ),
    ] = 0,
    parts: Annotated[
        int, typer.Option("--parts", metavar="N", help="Parts of one box on its ways, at most.")
    ] = 400,
    transitions: Annotated[
        int,
        typer.Option("--transitions", metavar="N", help="Of a motion until it returns, at most."),
    ] = 40,
    workers: Workers = 1,
    require: Annotated[
        Trapping | None,
        typer.Option("--require", help="Exit with 3 unless an attracting component is proved."),
    ] = None,
    resume: Resume = None,
    save: SaveResult = None,
    plot: Plot = None,
    overwrite: Overwrite = False,
    as_json: AsJson = False,
) -> int:
    """Prove where motions stay: trapping regions and components of a graph of boxes.

    The section is chosen along the motion from the start, and the image of each box of a region
    on it is enclosed. `certify --check` proves what is saved again.
    """
    from nonsmooth.runtime.cli.display import counted
    from nonsmooth.runtime.cli.tables import show_result
    from nonsmooth.runtime.present.files.kept import format_named
    from nonsmooth.runtime.proof.graphs.certify_graph import certify_graph

    if not start:
        raise missing_start(system)
    proof = LongProof(
        name=system,
        parameters=parameters or [],
        near=None,
        resume=resume,
        save=save,
        plot=plot,
        overwrite=overwrite,
        as_json=as_json,
    )
    known = proof.known(format_named("nonsmooth graph certificate").load)
    values, state = assignments("parameter", parameters or []), assignments("state", split(start))
    limits = ranges("coordinate", split(region))

    def show(done: int, count: int) -> None:
        seconds = count * SECONDS["image"] / workers
        if done == 0 and seconds > _SOON:
            say(hours_told(f"images of {count} boxes", seconds))
        progress(done, count)

    with counted("enclosing images") as progress:
        found, stopped = worked(
            lambda: certify_graph(
                system,
                values,
                state,
                configuration,
                boxes=boxes,
                region={name: (low, high) for name, (low, high, _) in limits.items()},
                parts=parts,
                transitions=transitions,
                levels=levels,
                workers=workers,
                resume=known,
                progress=show,
                keep=proof.keep,
            )
        )
    seen = len(found.graph.grid) - len(found.unknown)
    claims, code = proof.answer(
        found,
        stopped,
        show_result,
        enough=True,
        done=f"{seen} images of {len(found.graph.grid)} boxes are known",
    )
    if code != INTERRUPTED and require is not None and claims["trapping"] != "proved":
        say("required: trapping; found: no attracting component")
        return NOT_MET
    return code

"""The command that proves where motions go from the boxes of a region."""

from __future__ import annotations

from enum import StrEnum
from typing import Annotated

import typer

from nonsmooth.runtime.cli.application import (
    ANSWERED,
    NOT_MET,
    answering,
    app,
    assignments,
    check_drawing,
    ranges,
    split,
)
from nonsmooth.runtime.cli.keeping import say
from nonsmooth.runtime.cli.options import (
    AsJson,
    Physical,
    Plot,
    Start,
    SystemName,
    missing_start,
)
from nonsmooth.runtime.cli.written import Written

__all__ = ["graph"]


class Trapping(StrEnum):
    """What can be required."""

    TRAPPING = "trapping"


@app.command(
    epilog="Examples:\n\n"
    "nonsmooth graph dry-friction chi=0.5 eta=1 V=1 us1=1 us2=1 ur1=4.0195 ur2=1.4831"
    " --from x1=5,x2=4,v1=0.5,v2=0.25 --region x2=2:14 --boxes 512 --require trapping\n\n"
    "nonsmooth graph impact_oscillator.py r=0.65 sigma=0 w=2.8 --from x=-0.5,v=0.1"
    " --boxes 128 --plot graph.png"
)
@answering
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
    parts: Annotated[
        int, typer.Option("--parts", metavar="N", help="Parts of one box on its ways, at most.")
    ] = 400,
    transitions: Annotated[
        int,
        typer.Option("--transitions", metavar="N", help="Of a motion until it returns, at most."),
    ] = 40,
    require: Annotated[
        Trapping | None,
        typer.Option("--require", help="Exit with 3 unless an attracting component is proved."),
    ] = None,
    plot: Plot = None,
    as_json: AsJson = False,
) -> int:
    """Prove where motions stay: trapping regions and components of a graph of boxes.

    The section is chosen along the motion from the start, and the image of each box of a region
    on it is enclosed. What is proved is not saved: there is no check of graphs yet.
    """
    from nonsmooth.runtime.cli.display import counted
    from nonsmooth.runtime.cli.display_graphs import show_graph
    from nonsmooth.runtime.present.pictures.box_graphs import graph_figure
    from nonsmooth.runtime.proof.graphs.certify_graph import certify_graph

    if not start:
        raise missing_start(system)
    check_drawing(plot)
    values, state = assignments("parameter", parameters or []), assignments("state", split(start))
    limits = ranges("coordinate", split(region))
    with counted("enclosing images") as progress:
        found = certify_graph(
            system,
            values,
            state,
            configuration,
            boxes=boxes,
            region={name: (low, high) for name, (low, high, _) in limits.items()},
            parts=parts,
            transitions=transitions,
            progress=progress,
        )
    written = Written()
    if plot is not None:
        written.draw(lambda: graph_figure(found), plot)
    code = written.show(found.to_json, lambda: show_graph(found), as_json=as_json)
    if require is not None and not found.proved:
        say("required: trapping; found: no attracting component")
        return NOT_MET
    return code or ANSWERED

"""The commands that simulate."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Annotated

import typer

from nonsmooth.runtime.command import ANSWERED, answering, app, assignments, print_json, split
from nonsmooth.runtime.errors import InputError
from nonsmooth.runtime.options import AsJson, Physical, SystemName

__all__ = ["simulate"]


@app.command(
    epilog="Examples:\n\n"
    "nonsmooth simulate rigid-stop m1=1 m2=2 k1=1 k2=5 r=0.8"
    " --from x1=0,x2=0.5,v1=1,v2=0 --transitions 20\n\n"
    "nonsmooth simulate dry-friction chi=0.5 eta=1 V=1 us1=1 us2=1 ur1=4.0195 ur2=1.4831"
    " --from x1=0,x2=0,v1=0,v2=0 --until 100 --save motion.npz --plot motion.png"
)
@answering
def simulate(
    system: SystemName,
    parameters: Physical = None,
    start: Annotated[
        list[str] | None,
        typer.Option(
            "--from", metavar="NAME=VALUE,...", help="The start: positions and velocities."
        ),
    ] = None,
    configuration: Annotated[
        str | None,
        typer.Option("--in", metavar="NAME", help="Where it starts; found when it is not given."),
    ] = None,
    transitions: Annotated[
        int | None, typer.Option("--transitions", metavar="N", help="End after so many.")
    ] = None,
    until: Annotated[
        str | None, typer.Option("--until", metavar="TIME", help="End at this time.")
    ] = None,
    save: Annotated[
        Path | None, typer.Option("--save", metavar="FILE", help="Save the motion: .npz or .csv.")
    ] = None,
    plot: Annotated[
        Path | None, typer.Option("--plot", metavar="FILE", help="Draw it: .png, .svg or .pdf.")
    ] = None,
    as_json: AsJson = False,
) -> int:
    """Follow a motion from event to event, exactly: no event is missed."""
    from nonsmooth.runtime.display_motion import show_motion
    from nonsmooth.runtime.files import check_target
    from nonsmooth.runtime.report_motion import motion_json
    from nonsmooth.runtime.simulate import simulate as follow
    from nonsmooth.runtime.values import parse

    for path, endings in ((save, (".npz", ".csv")), (plot, (".png", ".svg", ".pdf"))):
        if path is not None:
            check_target(path)
            if path.suffix.lower() not in endings:
                raise InputError(f"{path} does not end in {', '.join(endings)}")
    if start is None:
        raise InputError("the start is missing: --from NAME=VALUE,...")
    end = math.inf if until is None else float(parse(until))
    motion = follow(
        system,
        assignments("parameter", parameters or []),
        assignments("state", split(start)),
        configuration,
        until=end,
        transitions=transitions,
    )
    written = []
    if save is not None:
        motion.save(save)
        written.append(str(save))
    if plot is not None:
        from nonsmooth.runtime.plot import save_figure
        from nonsmooth.runtime.scenes import trajectory_figure

        save_figure(trajectory_figure(motion, "all"), plot)
        written.append(str(plot))
    if as_json:
        print_json({**motion_json(motion), "files": written})
    else:
        show_motion(motion)
        for path in written:
            print(f"{path} written")
    return ANSWERED

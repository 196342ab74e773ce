"""The commands that prove where motions go: basins, trapping regions, chaos."""

from __future__ import annotations

from typing import Annotated

from nonsmooth.runtime.cli.command import command
from nonsmooth.runtime.cli.keeping import say, worked
from nonsmooth.runtime.cli.options import (
    Configuration,
    Guess,
    OrbitName,
    Physical,
    RequireProof,
    Save,
    Start,
    SystemName,
    Tiles,
    Workers,
    missing_start,
    option,
    parameters_as,
)
from nonsmooth.runtime.cli.parsing import assignments, ends, guessed, split, values_and_ranges
from nonsmooth.runtime.cli.proofs.certifying import certifying
from nonsmooth.runtime.cli.reply import Reply
from nonsmooth.runtime.core.workload import SECONDS, hours_told

_SOON = 60.0  # seconds: of what takes no longer nothing is said before


@command(
    "basin",
    "certify basin dry-friction/global-stick us1=1 us2=1 ur1=4.0195 ur2=1.4831"
    " x1=2.5:2.75 x2=6.5:6.75 v1=-0.25:0 v2=-0.25:0 --side 0.125 --save basin.json",
    "certify basin mass_on_belt.py:stick-slip x=0:2 v=-0.5:0.5 --side 0.25 --workers 2"
    " --plot basin.png",
    group=certifying,
    save=Save,
    plot=True,
    long=True,
    question="orbit parameters guess side",
    anew="tiles",
    kept="basin certificate",
)
def certify_basin(
    orbit: OrbitName,
    parameters: Annotated[
        list[str] | None,
        parameters_as(
            "NAME=VALUE|STATE=A:B",
            "Parameters in NAME=VALUE form, and the box of starts: ranges of states, x1=-1:1;"
            " other states take what `find` uses.",
        ),
    ] = None,
    guess: Guess = None,
    side: Annotated[float | None, option("--side", "The longest side of a tile.", "H")] = None,
    tiles: Tiles = 20_000,
    workers: Workers = None,
    require: RequireProof = None,
    *,
    reply: Reply,
) -> int:
    """Prove from which starts every motion tends to a stable orbit.

    Around the orbit a set is proved to be contracted; then boxes of a section, and tiles of a
    box of starts, are proved to lead there. What is not proved may be attracted nevertheless.

    Tiles are looked at where most of them have been attracted so far.
    """
    from nonsmooth.runtime.cli.display import shared, steps
    from nonsmooth.runtime.orbits.solve import solve
    from nonsmooth.runtime.proof.sets.certify_basin import certify_basin as prove

    known = reply.known
    values, box = values_and_ranges(parameters)
    with steps(f"solving {orbit}"):
        solved = solve(orbit, values, guessed(guess))
    with shared(f"proving {orbit}") as progress:
        found, stopped = worked(
            lambda: prove(
                solved,
                box=ends(box),
                side=side,
                tiles=tiles,
                workers=workers or 1,
                resume=known,
                progress=progress,
                keep=reply.keep,
            )
        )
    return reply.give(
        found,
        stopped,
        enough=found.proved,
        done=f"{int(found.attracted.sum())} of {int(found.looked.sum())} tiles are attracted",
        require=require,
    )


@command(
    "chaos",
    "certify chaos dry-friction chi=0.34 eta=2.88 V=1.23 us1=0.75 us2=1.19 ur1=2.04 ur2=1.83"
    " --from x1=1.93,x2=7.18,v1=1.18,v2=1.18 --exponents --save chaos.json --plot chaos.png",
    "certify chaos impact_oscillator.py r=0.65 sigma=0 w=2.8 --from x=-0.5,v=0.1 --require proved",
    group=certifying,
    save=Save,
    plot=True,
    long=True,
)
def certify_chaos(
    system: SystemName,
    parameters: Physical = None,
    start: Start = None,
    configuration: Configuration = None,
    iterates: Annotated[int, option("--iterates", "The largest power of the map.", "N", min=1)] = 8,
    exponents: Annotated[
        bool,
        option("--exponents", "Bound Lyapunov exponents too, by a cone condition."),
    ] = False,
    require: RequireProof = None,
    *,
    reply: Reply,
) -> int:
    """Prove that motions are chaotic: sets that cover each other, and the entropy that follows.

    Looks along the motion from the start. The exit code is 1 if nothing is found and proved.
    """
    from nonsmooth.runtime.cli.display import counted
    from nonsmooth.runtime.proof.chaos.certify_chaos import certify_chaos as prove

    if not start:
        raise missing_start(system)
    values, state = assignments("parameter", parameters or []), assignments("state", split(start))
    with counted("enclosing images") as progress:
        found, stopped = worked(
            lambda: prove(
                system,
                values,
                state,
                configuration,
                iterates=iterates,
                exponents=exponents,
                progress=progress,
            )
        )
    if reply.plot is not None and not found.proved:
        reply.plot = None
        say("no picture: nothing is proved")
    return reply.give(
        found,
        stopped,
        enough=found.proved,
        done="chaos is proved, no exponents",
        require=require,
        claims={"chaos": found.claim},
    )


@command(
    "region",
    "certify region dry-friction chi=0.5 eta=1 V=1 us1=1 us2=1 ur1=4.0195 ur2=1.4831"
    " --from x1=5,x2=4,v1=0.5,v2=0.25 x2=2:14 --boxes 64 --levels 3 --save region.json",
    "certify region impact_oscillator.py r=0.65 sigma=0 w=2.3 --from x=-0.7,v=0.1"
    " x=-2:0 v=-2:2 --boxes 32 --levels 1 --plot region.png --require proved",
    group=certifying,
    save=Save,
    plot=True,
    long=True,
    question="system parameters start configuration boxes",
    anew="levels",
    kept="region certificate",
)
def certify_region(
    system: SystemName,
    parameters: Annotated[
        list[str] | None,
        parameters_as(
            "NAME=VALUE|STATE=A:B",
            "All physical parameters: chi=1/2 eta=1 ...; and the region of the section, ranges"
            " of states: x2=2:14. Without one: where the motion comes to, and a quarter more at"
            " both sides.",
        ),
    ] = None,
    start: Start = None,
    configuration: Configuration = None,
    boxes: Annotated[
        int | None,
        option(
            "--boxes",
            "Boxes along each coordinate of the section, at least; 1024 of one coordinate,"
            " 96 of each of two, if not given.",
            "N",
        ),
    ] = None,
    levels: Annotated[
        int,
        option(
            "--levels",
            "How often boxes are divided at most: those on cycles, of unknown image, and"
            " those that leave the region in part.",
            "N",
        ),
    ] = 0,
    workers: Workers = None,
    require: RequireProof = None,
    *,
    reply: Reply,
) -> int:
    """Prove where motions stay: trapping regions and components of a graph of boxes.

    The section is chosen along the motion from the start, and the image of each box of a region
    on it is enclosed.
    """
    from nonsmooth.runtime.cli.display import counted
    from nonsmooth.runtime.proof.sets.certify_graph import certify_graph

    if not start:
        raise missing_start(system)
    known = reply.known
    values, region = values_and_ranges(parameters)
    state, shared_by = assignments("state", split(start)), workers or 1

    def show(done: int, count: int) -> None:
        seconds = count * SECONDS["image"] / shared_by
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
                region=ends(region),
                levels=levels,
                workers=shared_by,
                resume=known,
                progress=show,
                keep=reply.keep,
            )
        )
    boxed = len(found.graph.grid)
    return reply.give(
        found,
        stopped,
        done=f"{boxed - len(found.unknown)} images of {boxed} boxes are known",
        require=require,
    )

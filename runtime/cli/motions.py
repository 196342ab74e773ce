"""The commands that simulate, find and sweep."""

from __future__ import annotations

import math
import sys
from pathlib import Path
from typing import Annotated, Any

import typer

from nonsmooth.runtime.cli.command import command
from nonsmooth.runtime.cli.keeping import heeding, say, worked
from nonsmooth.runtime.cli.options import (
    KEPT,
    Configuration,
    Derivatives,
    Physical,
    Save,
    Seed,
    Start,
    SystemName,
    Yes,
    missing_start,
    option,
    parameters_as,
)
from nonsmooth.runtime.cli.parsing import assignments, ends, grid, split, values_and_ranges
from nonsmooth.runtime.cli.reply import Reply
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.workload import SECONDS, check_hours

_FORCING = "forcing-phase"

SaveMotion = Annotated[
    Path | None,
    option("--save", "Save the motion: .npz or .csv.", "FILE", rich_help_panel=KEPT),
]


@command(
    "simulate",
    "simulate rigid-stop m1=1 m2=2 k1=1 k2=5 r=0.8 --from x1=0,x2=0.5,v1=1,v2=0 --transitions 20",
    "simulate dry-friction chi=0.5 eta=1 V=1 us1=1 us2=1 ur1=4.0195 ur2=1.4831"
    " --from x1=0,x2=0,v1=0,v2=0 --until 100 --save motion.npz --plot motion.png",
    "simulate elastic-stop m1=1 m2=2 k1=1 k2=5 k3=10 --from x1=0,x2=0,v1=2,v2=0"
    " --transitions 40 --observe --prove",
    "simulate rigid-stop m1=1 m2=2 k1=1 k2=5 r=0.8"
    " --from x1=0,x2=0.5,v1=1,v2=0 --transitions 5 --derivatives k1,r,v10",
    save=SaveMotion,
    plot=True,
)
def simulate(
    system: SystemName,
    parameters: Physical = None,
    start: Start = None,
    configuration: Configuration = None,
    transitions: Annotated[int | None, option("--transitions", "End after so many.", "N")] = None,
    until: Annotated[str | None, option("--until", "End at this time.", "TIME")] = None,
    observe: Annotated[
        bool,
        option("--observe", "Peaks, averages, contact forces, Lyapunov exponent too."),
    ] = False,
    since: Annotated[str | None, option("--since", "Where --observe begins.", "TIME")] = None,
    derivatives: Derivatives = None,
    prove: Annotated[
        bool,
        option("--prove", "Prove the sequence of configurations by ball arithmetic."),
    ] = False,
    yes: Yes = False,
    *,
    reply: Reply,
) -> int:
    """Follow a motion from event to event, exactly: no event is missed."""
    from nonsmooth.runtime.cli.display import show_result
    from nonsmooth.runtime.core.files import check_ending
    from nonsmooth.runtime.core.values import parse
    from nonsmooth.runtime.model.engine_run import Status
    from nonsmooth.runtime.model.structure import structure_of
    from nonsmooth.runtime.present.answers import result_json
    from nonsmooth.runtime.present.pictures.plot import motion_figure
    from nonsmooth.runtime.simulation.derivatives import chosen_numbers
    from nonsmooth.runtime.simulation.simulate import simulate as follow

    if reply.save is not None:
        check_ending(reply.save, (".npz", ".csv"))
    if since is not None and not observe:
        raise InputError("--since says where --observe begins, which is missing")
    if start is None:
        raise missing_start(system)
    end = math.inf if until is None else float(parse(until))
    observed_since = float(parse(since or "0"))
    values, state = assignments("parameter", parameters or []), assignments("state", split(start))
    exact = {name: value.exact for name, value in state.items()}
    for name, fraction in exact.items():
        if prove and fraction is None:
            raise InputError(f"state {name} = {state[name]} is not rational: no proof")
    by = None if derivatives in (None, ["all"]) else split(derivatives)
    if by is not None:
        chosen_numbers(by, structure_of(system).states, tuple(values))
    if transitions is not None and until is None:
        each = SECONDS["proved transition" if prove else "transition"]
        check_hours(f"{transitions} transitions", transitions * each, yes=yes)
    motion = follow(system, values, state, configuration, until=end, transitions=transitions)
    observed = proof = changes = None
    if derivatives is not None:
        changes = motion.derivatives(by)
    if observe:
        from nonsmooth.runtime.simulation.observables import observe as observe_motion

        observed = observe_motion(motion, observed_since)
    if prove:
        from nonsmooth.runtime.proof.certify_motion import certify_motion

        begin = motion.configurations[0]
        proof = certify_motion(system, values, exact, begin, motion.transitions)

    def told() -> dict[str, Any]:
        found: dict[str, Any] = motion.to_json()
        parts = {"observables": observed, "derivatives": changes, "proof": proof}
        return found | {name: result_json(part) for name, part in parts.items() if part is not None}

    def show() -> None:
        show_result(motion)
        for more in (observed, changes, proof):
            if more is not None:
                print()
                show_result(more)

    overflown = motion.status == Status.OVERFLOW
    decided = proof is None or proof.decided
    code = reply.give(
        motion,
        told=told,
        show=show,
        figure=lambda: motion_figure(motion),
        enough=decided and not overflown,
    )
    if overflown:
        say(f"the motion ends at {motion.end:g}: {motion.message}")
    return code


@command(
    "find",
    "find dry-friction chi=0.4 eta=4 V=0.6773 us1=0.0127 ur1=0.0255 us2=0.5 ur2=1",
    "find dry-friction chi=0.5 eta=1 V=1 us1=1 us2=1 ur1=4.0195 ur2=1.4831 x1=-4:4 x2=-4:4"
    " --starts 800 --save found.json",
    after="Then found.json:1 is an orbit for every command, and `nonsmooth chart found.json"
    " x1=-4:4:40 x2=-4:4:40 --out basins.zarr` maps the basins of all that is found.",
    save=Save,
    long=True,
    several=True,
)
def find(
    system: SystemName,
    parameters: Annotated[
        list[str] | None,
        parameters_as(
            "NAME=VALUE|A:B",
            "All physical parameters: chi=1/2 eta=1 ...; ranges of states: where starts are"
            " drawn, x1=-4:4.",
        ),
    ] = None,
    starts: Annotated[int, option("--starts", "Random starts to follow.", "N", min=1)] = 400,
    transitions: Annotated[int, option("--transitions", "Length of the transients.", "N")] = 2000,
    seed: Seed = 0,
    write: Annotated[
        Path | None,
        option(
            "--write",
            "Append the orbits that reach a boundary as itineraries found-1, ... to the file"
            " of the system.",
            "FILE.py",
            rich_help_panel=KEPT,
        ),
    ] = None,
    yes: Yes = False,
    *,
    reply: Reply,
) -> int:
    """Find the periodic orbits and equilibria of a system, and where random starts lead."""
    from nonsmooth.runtime.cli.display import show_result, steps
    from nonsmooth.runtime.explore.finding.find import find_orbits
    from nonsmooth.runtime.present.files.declaring import check_declaration, write_itineraries

    if write is not None:
        check_declaration(system, write)
    values, box = values_and_ranges(parameters)
    what = f"{starts} starts, followed over {transitions} transitions,"
    check_hours(what, starts * transitions * SECONDS["transition"], yes=yes)
    with steps() as begin:
        found, stopped = worked(
            lambda: find_orbits(
                system,
                values,
                starts,
                transitions=transitions,
                box=ends(box),
                rng=seed,
                progress=begin,
            )
        )
    reply.settle(found.save)
    names: tuple[str, ...] = ()

    def append(path: Path) -> None:
        nonlocal names
        names = write_itineraries(found, path)

    if write is not None and found.orbits and _agreed(f"append the orbits to {write}?"):
        reply.write(append, write)
        if names and (rest := len(found.orbits) - len(names)):
            say(f"not appended: {rest} of the orbits, which reach no boundary")

    def show() -> None:
        show_result(found)
        if reply.saved and found.orbits:
            print(
                f"nonsmooth solve, continue, certify, chart and plot take {reply.saved}:1 and so on"
            )
        for name in names:
            print(f"{write}:{name}")

    return reply.give(
        found,
        stopped,
        told=lambda: {**found.to_json(), "itineraries": list(names)},
        show=show,
        done=f"{len(found.orbits) + len(found.equilibria)} orbits and equilibria are found",
    )


@command(
    "sweep",
    "sweep dry-friction V=0.2:1.2:200 chi=0.4 eta=4 us1=0.0127 ur1=0.0255 us2=0.5 ur2=1"
    " --quantity x1 --at slip-stick --from x1=0,x2=0,v1=0,v2=0 --plot diagram.png"
    " --save sweep.json",
    "sweep impact_oscillator.py w=2:3:50 sigma=1/5 r=4/5 --quantity v --at forcing-phase=pi/2"
    " --from x=0,v=0 --transient 200 --plot strobe.png",
    save=Save,
    plot=True,
    long=True,
    question="system parameters quantity at start transient samples restart",
    kept="sweep",
)
def sweep(
    system: SystemName,
    parameters: Annotated[
        list[str] | None,
        parameters_as(
            "NAME=VALUE|A:B:N",
            "All physical parameters, one of them as a range: V=0.5:1.5:400.",
        ),
    ] = None,
    quantity: Annotated[
        str | None,
        option("--quantity", "What is drawn: a state.", "NAME"),
    ] = None,
    at: Annotated[
        str | None,
        option(
            "--at",
            "At each entry of this configuration; or `forcing-phase`, once in each period of"
            " the forcing, or `forcing-phase=pi/2`.",
            "NAME",
        ),
    ] = None,
    start: Start = None,
    transient: Annotated[
        int,
        option("--transient", "Transitions, or periods, before the first point.", "N"),
    ] = 1000,
    samples: Annotated[
        int,
        option("--samples", "Transitions, or periods, that points are taken from.", "N"),
    ] = 60,
    restart: Annotated[
        bool, option("--restart", "Start every value anew instead of following.")
    ] = False,
    yes: Yes = False,
    *,
    reply: Reply,
) -> int:
    """Draw a bifurcation diagram by brute force: where motions settle over one parameter."""
    from numpy import linspace

    from nonsmooth.runtime.cli.display import counted
    from nonsmooth.runtime.core.values import parse
    from nonsmooth.runtime.explore.finding.sweep import check_sweep
    from nonsmooth.runtime.explore.finding.sweep import sweep as follow

    known = reply.known
    wanted = (("--quantity", quantity), ("--at", at))
    missing = [option for option, value in wanted if not value]
    if not start:
        raise missing_start(system, missing)
    if missing:
        raise InputError(f"{' and '.join(missing)} {'are' if missing[1:] else 'is'} missing")
    place, phased, phase = str(at).partition("=")
    strobed = place.strip() == _FORCING
    if phased and not strobed:
        raise InputError(f"--at {at}: a phase is of {_FORCING} alone")
    given, ranged = values_and_ranges(parameters, "A:B:N")
    if len(ranged) != 1:
        raise InputError(f"one parameter has to be a range A:B:N, not {len(ranged)}")
    ((name, (low, high, count)),) = grid(ranged).items()
    begin = assignments("state", split(start))
    check_sweep(count, samples)
    what = f"{count} values, followed over {transient + samples} transitions or periods each,"
    check_hours(what, count * (transient + samples) * SECONDS["transition"], yes=yes)
    with counted(f"sweeping {name}", count) as progress:
        diagram, stopped = worked(
            lambda: follow(
                system,
                given,
                name,
                linspace(low, high, count),
                begin,
                state=str(quantity),
                configuration=None if strobed else at,
                phase=float(parse(phase if phased else "0")) if strobed else None,
                transient=transient,
                samples=samples,
                follow=not restart,
                resume=known,
                progress=progress,
            )
        )
    return reply.give(
        diagram,
        stopped,
        done=f"{diagram.done} of {count} values are done",
    )


def _agreed(question: str) -> bool:
    """Whether a file of the user may be changed: asked on a terminal, elsewhere true."""
    if not sys.stdin.isatty():
        return True
    with heeding():
        try:
            return typer.confirm(question, err=True)
        except typer.Abort:  # Ctrl-C or the end of input: the answer is shown nevertheless
            return False

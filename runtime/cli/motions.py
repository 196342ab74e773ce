"""The commands that simulate."""

from __future__ import annotations

import math
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from nonsmooth.runtime.cli.application import (
    ANSWERED,
    UNANSWERED,
    answering,
    app,
    assignments,
    check_drawing,
    ranges,
    split,
)
from nonsmooth.runtime.cli.keeping import Overwrite, check_new, heeding, kept_of, say, worked
from nonsmooth.runtime.cli.options import (
    AsJson,
    Physical,
    Plot,
    Resume,
    SaveResult,
    Start,
    SystemName,
    Yes,
    missing_start,
)
from nonsmooth.runtime.cli.resuming import resumable
from nonsmooth.runtime.cli.written import Written
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.workload import SECONDS, check_hours

if TYPE_CHECKING:
    from matplotlib.figure import Figure


__all__ = ["find", "simulate", "sweep"]

_FORCING = "forcing-phase"


@app.command(
    epilog="Examples:\n\n"
    "nonsmooth simulate rigid-stop m1=1 m2=2 k1=1 k2=5 r=0.8"
    " --from x1=0,x2=0.5,v1=1,v2=0 --transitions 20\n\n"
    "nonsmooth simulate dry-friction chi=0.5 eta=1 V=1 us1=1 us2=1 ur1=4.0195 ur2=1.4831"
    " --from x1=0,x2=0,v1=0,v2=0 --until 100 --save motion.npz --plot motion.png\n\n"
    "nonsmooth simulate elastic-stop m1=1 m2=2 k1=1 k2=5 k3=10 --from x1=0,x2=0,v1=2,v2=0"
    " --transitions 40 --observe --prove\n\n"
    "nonsmooth simulate rigid-stop m1=1 m2=2 k1=1 k2=5 r=0.8"
    " --from x1=0,x2=0.5,v1=1,v2=0 --transitions 5 --derivatives k1,r,v10"
)
@answering
def simulate(
    system: SystemName,
    parameters: Physical = None,
    start: Start = None,
    configuration: Annotated[
        str | None,
        typer.Option(
            "--in", metavar="NAME", help="The configuration it starts in; found if not given."
        ),
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
    plot: Plot = None,
    observe: Annotated[
        bool,
        typer.Option("--observe", help="Peaks, averages, contact forces, Lyapunov exponent too."),
    ] = False,
    since: Annotated[
        str | None, typer.Option("--since", metavar="TIME", help="Where --observe begins.")
    ] = None,
    derivatives: Annotated[
        str | None,
        typer.Option(
            "--derivatives",
            metavar="NAMES",
            help="Derivatives by parameters and starts: k1,x10; or by all.",
        ),
    ] = None,
    prove: Annotated[
        bool,
        typer.Option("--prove", help="Prove the sequence of configurations by ball arithmetic."),
    ] = False,
    yes: Yes = False,
    as_json: AsJson = False,
) -> int:
    """Follow a motion from event to event, exactly: no event is missed."""
    from nonsmooth.runtime.cli.tables import show_result
    from nonsmooth.runtime.core.files import check_ending, check_target
    from nonsmooth.runtime.core.values import parse
    from nonsmooth.runtime.model.engine_run import Status
    from nonsmooth.runtime.model.structure import structure_of
    from nonsmooth.runtime.present.answers import (
        motion_derivatives_json,
        motion_json,
        observables_json,
        proof_json,
    )
    from nonsmooth.runtime.simulation.derivatives import chosen_numbers
    from nonsmooth.runtime.simulation.simulate import simulate as follow

    if save is not None:
        check_target(save)
        check_ending(save, (".npz", ".csv"))
    check_drawing(plot)
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
    by = None if derivatives in (None, "all") else split([derivatives])
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
        from nonsmooth.runtime.proof.motion.validate import validate

        begin = motion.configurations[0]
        proof = validate(system, values, exact, begin, motion.transitions)
    written = Written()
    written.save(motion.save, save)
    if plot is not None:
        from nonsmooth.runtime.present.pictures.plot import trajectory_figure

        written.draw(lambda: trajectory_figure(motion, "all"), plot)

    def told() -> dict[str, Any]:
        found = motion_json(motion)
        if observed is not None:
            found["observables"] = observables_json(observed)
        if changes is not None:
            found["derivatives"] = motion_derivatives_json(changes)
        if proof is not None:
            found["proof"] = proof_json(proof)
        return found

    def show() -> None:
        show_result(motion)
        for more in (observed, changes, proof):
            if more is not None:
                print()
                show_result(more)

    code = written.show(told, show, as_json=as_json)
    overflown = motion.status == Status.OVERFLOW
    if overflown:
        say(f"the motion ends at {motion.end:g}: {motion.message}")
    answered = (proof is None or proof.decided) and not overflown
    return code or (ANSWERED if answered else UNANSWERED)


@app.command(
    epilog="Examples:\n\n"
    "nonsmooth find dry-friction chi=0.4 eta=4 V=0.6773 us1=0.0127 ur1=0.0255 us2=0.5 ur2=1\n\n"
    "nonsmooth find dry-friction chi=0.5 eta=1 V=1 us1=1 us2=1 ur1=4.0195 ur2=1.4831"
    " --starts 800 --box x1=-4:4,x2=-4:4 --save found.json\n\n"
    "nonsmooth find dry-friction chi=0.4 eta=4 V=0.6773 us1=0.0127 ur1=0.0255 us2=0.5 ur2=1"
    " --basins x1=-3:3:40,v2=-1:1:40 --plot basins.png"
)
@answering
def find(
    system: SystemName,
    parameters: Physical = None,
    starts: Annotated[
        int, typer.Option("--starts", min=1, metavar="N", help="Random starts to follow.")
    ] = 400,
    transitions: Annotated[
        int, typer.Option("--transitions", metavar="N", help="Length of the transients.")
    ] = 2000,
    box: Annotated[
        list[str] | None,
        typer.Option("--box", metavar="NAME=A:B,...", help="Where the starts are drawn."),
    ] = None,
    seed: Annotated[int, typer.Option("--seed", metavar="N", help="Of the random starts.")] = 0,
    basins: Annotated[
        str | None,
        typer.Option(
            "--basins",
            metavar="NAME=A:B:N,NAME=A:B:N",
            help="Map a plane of starts: two states with their ranges and counts.",
        ),
    ] = None,
    start: Annotated[
        list[str] | None,
        typer.Option("--from", metavar="NAME=VALUE,...", help="The other states of that plane."),
    ] = None,
    plot: Annotated[
        Path | None, typer.Option("--plot", metavar="FILE", help="Draw the map of --basins.")
    ] = None,
    save: SaveResult = None,
    write: Annotated[
        Path | None,
        typer.Option(
            "--write",
            metavar="FILE.py",
            help="Append the orbits that reach a boundary as itineraries found-1, ... to the file"
            " of the system.",
        ),
    ] = None,
    overwrite: Overwrite = False,
    yes: Yes = False,
    as_json: AsJson = False,
) -> int:
    """Find the periodic orbits and equilibria of a system, and where random starts lead."""
    from nonsmooth.runtime.cli.display import counted, steps
    from nonsmooth.runtime.cli.tables import show_result
    from nonsmooth.runtime.explore.finding.basins import plane_of_starts
    from nonsmooth.runtime.explore.finding.find import find_orbits
    from nonsmooth.runtime.model.kernels import load_system
    from nonsmooth.runtime.present.answers import found_json
    from nonsmooth.runtime.present.files.declaring import check_declaration, write_itineraries

    if (plot is None) != (basins is None):
        raise InputError("--basins says what to map and --plot where to draw it: give both")
    if start and basins is None:
        raise InputError("--from is for the plane of --basins, which is missing")
    check_drawing(plot)
    check_new(save, overwrite)
    if write is not None:
        check_declaration(system, write)
    axes = ranges("state", split([basins]), counts=True) if basins else {}
    if basins and len(axes) != 2:
        raise InputError(f"--basins takes two states, not {len(axes)}")
    others = assignments("state", split(start))
    if basins:
        x, y = ((name, *bounds) for name, bounds in axes.items())
        plane_of_starts(load_system(system), x, y, others)
    values = assignments("parameter", parameters or [])
    limits = {name: (low, high) for name, (low, high, _) in ranges("state", split(box)).items()}
    what = f"{starts} starts, followed over {transitions} transitions,"
    check_hours(what, starts * transitions * SECONDS["transition"], yes=yes)
    with steps() as begin:
        found, stopped = worked(
            lambda: find_orbits(
                system,
                values,
                starts,
                transitions=transitions,
                box=limits,
                rng=seed,
                progress=begin,
            )
        )
    written = Written()
    written.save(found.save, save)
    if plot is not None and not stopped:
        from nonsmooth.runtime.explore.finding.basins import basins as map_basins
        from nonsmooth.runtime.present.pictures.maps import draw_basins

        def picture() -> Figure:
            nonlocal stopped
            with counted("mapping basins", y[3]) as progress:
                mapped, stopped = worked(lambda: map_basins(found, x, y, others, progress=progress))
            drawn: Figure = draw_basins(mapped)
            return drawn

        written.draw(picture, plot)
    names: tuple[str, ...] = ()

    def append(path: Path) -> None:
        nonlocal names
        names = write_itineraries(found, path)

    if write is not None and found.orbits and _agreed(f"append the orbits to {write}?"):
        written.save(append, write)
        if names and (rest := len(found.orbits) - len(names)):
            say(f"not appended: {rest} of the orbits, which reach no boundary")
    code = written.show(
        lambda: {**found_json(found), "itineraries": list(names)},
        lambda: show_result(found),
        as_json=as_json,
    )
    if not as_json:
        if written.kept(save) and found.orbits:
            print(f"nonsmooth solve, continue, certify, chart and plot take {save}:1 and so on")
        for name in names:
            print(f"{write}:{name}")
    if stopped:
        count = len(found.orbits) + len(found.equilibria)
        return kept_of(
            f"{count} orbits and equilibria are found", written.kept(save), resumes=False
        )
    return code


@app.command(
    epilog="Examples:\n\n"
    "nonsmooth sweep dry-friction V=0.2:1.2:200 chi=0.4 eta=4 us1=0.0127 ur1=0.0255 us2=0.5 ur2=1"
    " --quantity x1 --at slip-stick --from x1=0,x2=0,v1=0,v2=0 --plot diagram.png"
    " --save sweep.json\n\n"
    "nonsmooth sweep impact_oscillator.py w=2:3:50 sigma=1/5 r=4/5 --quantity v --at forcing-phase"
    " --phase pi/2 --from x=0,v=0 --transient 200 --plot strobe.png"
)
@answering
@resumable("system parameters quantity at phase start transient samples restart")
def sweep(
    system: SystemName,
    parameters: Annotated[
        list[str] | None,
        typer.Argument(
            metavar="NAME=VALUE|A:B:N",
            help="All physical parameters, one of them as a range: V=0.5:1.5:400.",
            show_default=False,
        ),
    ] = None,
    quantity: Annotated[
        str | None,
        typer.Option("--quantity", metavar="NAME", help="What is drawn: a state."),
    ] = None,
    at: Annotated[
        str | None,
        typer.Option(
            "--at",
            metavar="NAME",
            help="At each entry of this configuration, or `forcing-phase`: once in each period"
            " of the forcing.",
        ),
    ] = None,
    phase: Annotated[
        str | None,
        typer.Option(
            "--phase", metavar="ANGLE", help="With --at forcing-phase: which, such as pi/2."
        ),
    ] = None,
    start: Start = None,
    transient: Annotated[
        int,
        typer.Option(
            "--transient", metavar="N", help="Transitions, or periods, before the first point."
        ),
    ] = 1000,
    samples: Annotated[
        int,
        typer.Option(
            "--samples", metavar="N", help="Transitions, or periods, that points are taken from."
        ),
    ] = 60,
    restart: Annotated[
        bool, typer.Option("--restart", help="Start every value anew instead of following.")
    ] = False,
    plot: Plot = None,
    save: SaveResult = None,
    resume: Resume = None,
    overwrite: Overwrite = False,
    yes: Yes = False,
    as_json: AsJson = False,
) -> int:
    """Draw a bifurcation diagram by brute force: where motions settle over one parameter."""
    from nonsmooth.runtime.cli.display import counted
    from nonsmooth.runtime.cli.tables import show_result
    from nonsmooth.runtime.explore.finding.sweep import sweep as follow
    from nonsmooth.runtime.present.answers import sweep_json
    from nonsmooth.runtime.present.files.kept import SWEEP

    check_drawing(plot)
    check_new(save, overwrite, resume, resumes=True)
    known = None if resume is None else SWEEP.load(resume)
    asked, options = _question(
        system, parameters or [], quantity, at, phase, start, transient, samples, not restart
    )
    name, values = asked[2:4]
    count, length = len(values), options["transient"] + options["samples"]
    what = f"{count} values, followed over {length} transitions or periods each,"
    check_hours(what, count * length * SECONDS["transition"], yes=yes)
    with counted(f"sweeping {name}", count) as progress:
        diagram, stopped = worked(
            lambda: follow(*asked, **options, resume=known, progress=progress)
        )
    written = Written()
    written.save(diagram.save, save)
    if plot is not None:
        from nonsmooth.runtime.present.pictures.maps import draw_sweep

        written.draw(lambda: draw_sweep(diagram), plot)
    code = written.show(lambda: sweep_json(diagram), lambda: show_result(diagram), as_json=as_json)
    if stopped:
        return kept_of(f"{diagram.done} of {count} values are done", written.kept(save))
    return code


def _question(
    system: str,
    parameters: list[str],
    quantity: str | None,
    at: str | None,
    phase: str | None,
    start: list[str] | None,
    transient: int,
    samples: int,
    follow: bool,
) -> tuple[tuple[Any, ...], dict[str, Any]]:
    """Positional arguments and options of the sweep that a command line asks for."""
    from numpy import linspace

    from nonsmooth.runtime.core.values import parse
    from nonsmooth.runtime.explore.finding.sweep import check_sweep

    given = (("--quantity", quantity), ("--at", at))
    missing = [option for option, value in given if not value]
    if not start:
        raise missing_start(system, missing)
    if missing:
        raise InputError(f"{' and '.join(missing)} {'are' if missing[1:] else 'is'} missing")
    strobed = at == _FORCING
    if phase is not None and not strobed:
        raise InputError(f"--phase is for --at {_FORCING}")
    swept = [text for text in parameters if ":" in text]
    if len(swept) != 1:
        raise InputError(f"one parameter has to be a range A:B:N, not {len(swept)}")
    fixed = [text for text in parameters if text not in swept]
    ((name, (low, high, count)),) = ranges("parameter", swept, counts=True).items()
    values, begin = assignments("parameter", fixed), assignments("state", split(start))
    check_sweep(count, samples)
    options = {
        "state": str(quantity),
        "configuration": None if strobed else at,
        "phase": float(parse(phase or "0")) if strobed else None,
        "transient": transient,
        "samples": samples,
        "follow": follow,
    }
    return (system, values, name, linspace(low, high, count), begin), options


def _agreed(question: str) -> bool:
    """Whether a file of the user may be changed: asked on a terminal, elsewhere true."""
    if not sys.stdin.isatty():
        return True
    with heeding():
        try:
            return typer.confirm(question, err=True)
        except typer.Abort:  # Ctrl-C or the end of input: the answer is shown nevertheless
            return False

"""The command that follows branches of periodic orbits."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from nonsmooth.runtime.commands.application import (
    ANSWERED,
    answering,
    app,
    assignments,
    print_json,
    ranges,
)
from nonsmooth.runtime.commands.options import AsJson, OrbitName
from nonsmooth.runtime.errors import InputError

if TYPE_CHECKING:
    from nonsmooth.runtime.continuation.branch import Branch

__all__ = ["follow"]

_PICTURES = (".png", ".svg", ".pdf")


@app.command(
    "continue",
    epilog="Examples:\n\n"
    "nonsmooth continue dry-friction/global-stick V=0.8:1.3\n\n"
    "nonsmooth continue dry-friction/global-stick eta=0.5:2 V=1.05 --plot branch.png"
    " --quantity ta\n\n"
    "nonsmooth continue my_oscillator.py:loop r=0.3:0.7 --save branch.json --beyond",
)
@answering
def follow(
    orbit: OrbitName,
    parameters: Annotated[
        list[str] | None,
        typer.Argument(
            metavar="NAME=VALUE|A:B",
            help="The parameter to follow as a range: V=0.8:1.3; others in NAME=VALUE form.",
            show_default=False,
        ),
    ] = None,
    at: Annotated[
        str | None,
        typer.Option(
            "--at",
            metavar="VALUE",
            help="Where the branch is entered; the reference point's value, or the middle.",
        ),
    ] = None,
    step: Annotated[
        float, typer.Option("--step", metavar="LENGTH", help="The longest step of arclength.")
    ] = 0.01,
    points: Annotated[
        int, typer.Option("--points", metavar="N", help="At most so many in each direction.")
    ] = 2000,
    admissible: Annotated[
        bool, typer.Option("--admissible", help="End where the orbit is no motion any more.")
    ] = False,
    beyond: Annotated[
        bool,
        typer.Option("--beyond", help="Find the itineraries beyond each border collision."),
    ] = False,
    quantity: Annotated[
        str,
        typer.Option(
            "--quantity",
            metavar="NAME",
            help="What --plot draws: period, frequency, trace, amplitude_x of a state x, or an"
            " unknown.",
        ),
    ] = "period",
    plot: Annotated[
        Path | None, typer.Option("--plot", metavar="FILE", help="Draw it: .png, .svg or .pdf.")
    ] = None,
    save: Annotated[
        Path | None, typer.Option("--save", metavar="FILE", help="Save the branch as JSON.")
    ] = None,
    as_json: AsJson = False,
) -> int:
    """Follow an orbit over one parameter: folds, flips, grazing, phases that vanish."""
    from nonsmooth.runtime.commands.display import counted
    from nonsmooth.runtime.continuation.branch import continue_orbit
    from nonsmooth.runtime.files import check_ending, check_target
    from nonsmooth.runtime.solve import solve

    if plot is not None:
        check_ending(plot, _PICTURES)
    for path in (plot, save):
        if path is not None:
            check_target(path)
    followed = [text for text in parameters or [] if ":" in text]
    if len(followed) != 1:
        raise InputError(f"one parameter has to be a range A:B, not {len(followed)}")
    ((name, (low, high, _)),) = ranges("parameter", followed).items()
    fixed = assignments("parameter", [text for text in parameters or [] if text not in followed])
    if name in fixed:
        raise InputError(f"parameter {name} is given twice")
    if at is not None:
        fixed |= assignments("parameter", [f"{name}={at}"])
    begin = solve(orbit, fixed)
    if at is None and name in begin.given and not low <= float(begin.given[name]) <= high:
        begin = solve(orbit, {**fixed, name: (low + high) / 2})
    with counted(f"following {name}", 2 * points) as progress:
        branch = continue_orbit(
            begin,
            name,
            (low, high),
            step=step,
            points=points,
            stop="admissible" if admissible else None,
            progress=progress,
        )
    others = _beyond(branch) if beyond else {}
    written = []
    if save is not None:
        branch.save(save)
        written.append(str(save))
    if plot is not None:
        from nonsmooth.runtime.continuation.drawing import branch_figure
        from nonsmooth.runtime.pictures.plot import save_figure

        save_figure(branch_figure(branch, quantity), plot)
        written.append(str(plot))
    if as_json:
        print_json({**_json(branch, others), "files": written})
    else:
        _show(branch, others)
        for path_name in written:
            print(f"{path_name} written")
    return ANSWERED


_Others = dict[int, list[dict[str, Any]]]


def _beyond(branch: Branch) -> _Others:
    """Itineraries beyond each border collision, by the number of the event."""
    from nonsmooth.runtime.commands.display import steps

    found: _Others = {}
    with steps() as begin:
        for number, event in enumerate(branch.events):
            if not event.border_collision:
                continue
            begin(f"beyond {event.parameter} = {event.value:.6g}")
            found[number] = [
                {
                    "itinerary": [list(phase) for phase in orbit.itinerary],
                    "value": float(orbit.given[branch.parameter]),
                    "stability": orbit.stability.verdict,
                }
                for orbit in branch.next_itineraries(event)
                if branch.parameter in orbit.given
            ]
    return found


def _json(branch: Branch, others: _Others) -> dict[str, Any]:
    def told(values: Any) -> list[float | None]:
        return [x if abs(x) < float("inf") else None for x in values.tolist()]

    return {
        "orbit": branch.name,
        "parameter": branch.parameter,
        "values": told(branch.parameter_values),
        "unknowns": {name: told(branch.quantity(name)) for name in branch.unknown_names},
        "period": told(branch.period),
        "trace": told(branch.trace),
        "stability": list(branch.stability),
        "admissible": branch.admissible.tolist(),
        "ends": list(branch.ends),
        "events": [
            {
                "kind": event.kind,
                "value": event.value,
                "phase": event.phase,
                "configuration": event.configuration,
                "boundary": event.boundary,
                "time": event.time,
                "unknowns": dict(event.unknowns),
                **({"beyond": others[number]} if number in others else {}),
            }
            for number, event in enumerate(branch.events)
        ],
    }


def _show(branch: Branch, others: _Others) -> None:
    """A table of the events, and why the branch ends."""
    from rich import box
    from rich.console import Console
    from rich.table import Table

    low, high = float(branch.parameter_values.min()), float(branch.parameter_values.max())
    allowed = int(branch.admissible.sum())
    print(
        f"{branch.name}: {len(branch)} points, {branch.parameter} from {low:.10g} to {high:.10g},"
        f" {allowed} of them motions of the real system"
    )
    if branch.events:
        table = Table(box=box.SIMPLE)
        for title in ("event", branch.parameter, "where", "boundary"):
            table.add_column(title)
        for event in branch.events:
            where = "" if event.phase is None else f"{event.configuration} ({event.phase + 1})"
            kind = event.kind.replace("-", " ")
            table.add_row(kind, f"{event.value:.12g}", where, event.boundary)
        Console().print(table)
    for number, orbits in others.items():
        value = branch.events[number].value
        for orbit in orbits:
            names = " > ".join(f"{configuration}" for configuration, _ in orbit["itinerary"])
            print(f"beyond {branch.parameter} = {value:.6g}: {names} ({orbit['stability']})")
    for end, reason in zip(("begins", "ends"), branch.ends, strict=True):
        print(f"{end}: {reason}")

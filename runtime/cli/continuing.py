"""The command that follows branches of periodic orbits."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Any

from nonsmooth.runtime.cli.command import command
from nonsmooth.runtime.cli.keeping import heed_interrupts, worked
from nonsmooth.runtime.cli.options import (
    Beyond,
    OrbitName,
    Over,
    Quantity,
    Save,
    Yes,
    option,
    parameters_as,
    solved_within,
)
from nonsmooth.runtime.cli.parsing import assignments, ends, split, values_and_ranges
from nonsmooth.runtime.cli.reply import Reply
from nonsmooth.runtime.core.errors import InputError, Interrupted, unknown_name
from nonsmooth.runtime.core.workload import SECONDS, check_hours

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping, Sequence

    from nonsmooth.runtime.core.values import Value
    from nonsmooth.runtime.explore.continuation.branch import Branch
    from nonsmooth.runtime.explore.continuation.event import Event
    from nonsmooth.runtime.orbits.orbit import Orbit
    from nonsmooth.runtime.present.answers import Others


@command(
    "continue",
    "continue dry-friction/global-stick V=0.8:1.3",
    "continue dry-friction/global-stick eta=0.5:2 V=1.05 --plot branch.png --quantity ta",
    "continue my_oscillator.py:loop r=0.3:0.7 --save branch.json --beyond",
    "continue elastic-stop/one-contact T=6.1:6.4 --quantity frequency --over energy"
    " --plot backbone.png",
    "continue dry-friction/symmetric V=0.6:1.3 us1=1 ur1=1 --switch flip --plot doubled.png",
    "continue dry-friction/symmetric V=0.6:1.3 eta=3.9:4.1 --follow flip"
    " --save flips.json --plot flips.png",
    save=Save,
    plot=True,
    long=True,
    question="orbit parameters start admissible switch follow_event",
    anew="step points beyond",
    kept="branch",
)
def follow(
    orbit: OrbitName,
    parameters: Annotated[
        list[str] | None,
        parameters_as(
            "NAME=VALUE|A:B",
            "The parameter to follow as a range: V=0.8:1.3; others in NAME=VALUE form."
            " With --follow a second range (docs/parameters.md).",
        ),
    ] = None,
    start: Annotated[
        list[str] | None,
        option(
            "--from",
            "Where the ranges are entered; at the reference point or in the middle.",
            "NAME=VALUE,...",
        ),
    ] = None,
    step: Annotated[float, option("--step", "The longest step of arclength.", "LENGTH")] = 0.01,
    points: Annotated[int, option("--points", "At most so many in each direction.", "N")] = 2000,
    admissible: Annotated[
        bool, option("--admissible", "End where the orbit is no motion any more.")
    ] = False,
    beyond: Beyond = False,
    switch: Annotated[
        list[str] | None,
        option(
            "--switch",
            "Go over to the branch that meets this one at an event, such as flip, where the"
            " period doubles, or symmetry-breaking:2 (the second one); may be repeated.",
            "KIND[:N]",
        ),
    ] = None,
    follow_event: Annotated[
        str | None,
        option(
            "--follow",
            "Follow an event of the branch, such as flip or grazing:2 (the second one), in"
            " the plane of both ranges; --save and --plot are of that curve.",
            "KIND[:N]",
        ),
    ] = None,
    quantity: Quantity = None,
    over: Over = None,
    yes: Yes = False,
    *,
    reply: Reply,
) -> int:
    """Follow an orbit over one parameter: folds, flips, grazing, phases that vanish."""
    from nonsmooth.runtime.present.answers import branch_json

    _check_picture(reply, quantity, over, follow_event)
    if reply.resume is not None and (switch or follow_event is not None):
        raise InputError("--resume is for a branch, and not for what --switch and --follow lead to")
    known = reply.known
    if follow_event is not None and beyond:
        raise InputError("--beyond is of a branch: leave it out with --follow")
    wanted = 1 if follow_event is None else 2
    fixed, ranged = values_and_ranges(parameters)
    if len(ranged) != wanted:
        told = "one parameter has" if wanted == 1 else "with --follow two parameters have"
        raise InputError(f"{told} to be a range A:B, not {len(ranged)}")
    spans = ends(ranged)
    (name, interval), *others = spans.items()
    entered = assignments("parameter", split(start))
    if unknown := [each for each in entered if each not in (name, *dict(others))]:
        raise InputError(f"--from is for parameters with a range, which {unknown[0]} has not")
    fixed |= entered
    check_hours(f"{points} points", 2 * points * SECONDS["point"], yes=yes)
    begin = solved_within(orbit, fixed, spans)
    if not switch:  # beyond an event the unknowns may be others
        _check_quantities(begin, name, [*split(quantity), *([over] if over else [])])
    options = {"step": step, "points": points, "admissible": admissible}
    branch, stopped = _branch(begin, name, interval, {**options, "resume": known})
    for text in switch or ():
        _go_on(stopped)
        event = chosen_event(branch, text)
        other = branch.switch(event, fixed)
        if name not in other.parameters:  # the period that was given
            name, times = "period", 2 if event.kind == "flip" else 1
            interval = times * interval[0], times * interval[1]
        branch, stopped = _branch(other, name, interval, options)
    if follow_event is not None:
        _go_on(stopped)
        ((second, span),) = others
        event = chosen_event(branch, follow_event)
        return _in_the_plane(branch, event, second, span, step, reply)
    reply.settle(branch.save)
    beyond_events: Others = {}
    if beyond and not stopped:
        beyond_events, stopped = worked(lambda: _beyond(branch, fixed))

    return reply.give(
        branch,
        stopped,
        told=lambda: branch_json(branch, beyond_events),
        show=lambda: _show(branch, beyond_events),
        figure=lambda: branch.plot(split(quantity) or None, over=over),
        done=f"{len(branch)} points are done",
        resumes=not switch,
    )


def _show(branch: Branch, others: Others) -> None:
    """Show a branch, the itineraries beyond its events, and the options that go on from them."""
    from nonsmooth.runtime.cli.display import show_result

    show_result(branch)
    for number, orbits in others.items():
        value = branch.events[number].value
        for orbit in orbits:
            names = " > ".join(configuration for configuration, _ in orbit["itinerary"])
            print(f"beyond {branch.parameter} = {value:.6g}: {names} ({orbit['stability']})")
    for line in _ways_on(branch, others):
        print(line)


def _ways_on(branch: Branch, others: Others) -> Iterator[str]:
    """Give a line for each option that goes on from an event of the branch."""
    switches = [event.kind for event in branch.events if event.switches]
    if switches:
        yield f"--switch {_named(switches)} follows the other branch there"
    if not others and any(event.border_collision for event in branch.events):
        yield "--beyond finds the itineraries beyond border collisions"
    if followed := [event.kind for event in branch.events if event.kind != "admissibility"]:
        yield f"--follow {_named(followed)} with a second range NAME=A:B follows it in the plane"


def _named(kinds: Sequence[str]) -> str:
    """The first of some events as an option takes it: its kind, and ``:1`` if there are more."""
    return kinds[0] + ":1" * (kinds.count(kinds[0]) > 1)


def _check_picture(
    reply: Reply, quantity: list[str] | None, over: str | None, follow_event: str | None
) -> None:
    """Refuse options for the picture of a branch where no branch is drawn."""
    for flag, given in (("--quantity", quantity), ("--over", over)):
        if given and reply.plot is None:
            raise InputError(f"{flag} is for the picture of --plot, which is missing")
        if given and follow_event is not None:
            raise InputError(f"{flag} is of a branch: leave it out with --follow")


def _check_quantities(orbit: Orbit, parameter: str, names: list[str]) -> None:
    """Refuse, before the branch is followed, quantities that its picture could not show."""
    from nonsmooth.runtime.model.structure import structure_of

    amplitudes = (f"amplitude_{state}" for state in structure_of(orbit.system).states)
    own = (parameter, *orbit.unknowns, *orbit.dwell_time_names)
    known = dict.fromkeys(("period", "frequency", "energy", "trace", *own, *amplitudes))
    for name in names:
        if name not in known:
            raise unknown_name("quantity", name, known)


def _go_on(stopped: bool) -> None:
    """Heed Ctrl-C again, or end if the branch before was interrupted.

    Nothing is kept of a branch that only leads to the branch that was asked for.
    """
    if stopped:
        raise KeyboardInterrupt
    heed_interrupts()


def _branch(
    orbit: Orbit,
    name: str,
    interval: tuple[float, float],
    options: Mapping[str, Any],
) -> tuple[Branch, bool]:
    """The branch of an orbit over an interval, and whether Ctrl-C ended it early."""
    from nonsmooth.runtime.cli.display import counted
    from nonsmooth.runtime.explore.continuation.continue_orbit import continue_orbit

    with counted(f"following {name}", 2 * options["points"]) as progress:
        return worked(lambda: continue_orbit(orbit, name, interval, progress=progress, **options))


def chosen_event(branch: Branch, text: str) -> Event:
    """The event of a branch that ``KIND`` or ``KIND:N`` names, where N counts from 1.

    InputError refuses an event that is missing or ambiguous, and names those there are.
    """
    from nonsmooth.runtime.explore.continuation.event import KINDS

    kind, _, number = text.partition(":")
    kind = kind.strip().replace(" ", "-")
    there = ", ".join(f"{e.kind} ({e.parameter} = {e.value:.6g})" for e in branch.events)
    if kind not in KINDS:
        raise unknown_name("kind of event", kind, KINDS)
    found = [event for event in branch.events if event.kind == kind]
    if not found:
        raise InputError(f"no {kind} on this branch; there is {there or 'no event'}")
    if not number:
        if len(found) > 1:
            raise InputError(f"which {kind}, {kind}:1 ... {kind}:{len(found)}? There is {there}")
        return found[0]
    if not number.strip().isdecimal() or not 1 <= int(number) <= len(found):
        raise InputError(f"no {kind}:{number} on this branch; there is {there}")
    return found[int(number) - 1]


def _in_the_plane(
    branch: Branch,
    event: Event,
    second: str,
    interval: tuple[float, float],
    step: float,
    reply: Reply,
) -> int:
    """Follow an event in the plane of two parameters, keep and show it; gives the exit code."""
    from nonsmooth.runtime.cli.display import counted
    from nonsmooth.runtime.explore.continuation.continue_orbit import MOST_EVENTS, continue_orbit

    what = f"following {event.kind.replace('-', ' ')}"
    with counted(what, 2 * MOST_EVENTS) as progress:
        locus, stopped = worked(
            lambda: continue_orbit(
                branch, second, interval, event=event, step=2 * step, progress=progress
            )
        )
    return reply.give(
        locus,
        stopped,
        done=f"{len(locus)} points are done",
        resumes=False,
    )


def _beyond(branch: Branch, fixed: Mapping[str, Value]) -> Others:
    """Itineraries beyond each border collision, by the index of the event on the branch."""
    from nonsmooth.runtime.cli.display import steps

    found: dict[int, list[dict[str, Any]]] = {}
    with steps() as begin:
        for number, event in enumerate(branch.events):
            if not event.border_collision:
                continue
            begin(f"beyond {event.parameter} = {event.value:.6g}")
            try:
                orbits = branch.next_itineraries(event, fixed)
            except KeyboardInterrupt:
                raise Interrupted(found) from None
            found[number] = [
                {
                    "itinerary": [list(phase) for phase in orbit.itinerary],
                    "value": float(orbit.given[branch.parameter]),
                    "stability": orbit.stability.verdict,
                }
                for orbit in orbits
                if branch.parameter in orbit.given
            ]
    return found

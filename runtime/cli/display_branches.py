"""What the command line shows of branches and of curves of events."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

from nonsmooth.runtime.cli.tables import listing, show_table
from nonsmooth.runtime.model.naming import shown_name

if TYPE_CHECKING:
    from nonsmooth.runtime.explore.continuation.branch import Branch
    from nonsmooth.runtime.explore.continuation.locus import Locus

__all__ = ["Others", "branch_json", "locus_json", "show_branch", "show_locus"]

Others = dict[int, list[dict[str, Any]]]  # itineraries beyond events, by the events' numbers


def branch_json(branch: Branch, others: Others) -> dict[str, Any]:
    """A branch as JSON; `others` holds itineraries beyond events, by the events' indices."""
    return {
        "orbit": branch.name,
        "parameter": branch.parameter,
        "values": _finite(branch.parameter_values),
        "unknowns": {name: _finite(branch.quantity(name)) for name in branch.unknown_names},
        "period": _finite(branch.period),
        "trace": _finite(branch.trace),
        "stability": list(branch.stability),
        "admissible": branch.admissible.tolist(),
        "ends": list(branch.ends),
        "events": [
            {
                "kind": event.kind,
                "value": event.value,
                "phase": None if event.phase is None else event.phase + 1,
                "configuration": event.configuration,
                "boundary": event.boundary,
                "touching": event.touching,
                "time": event.time,
                "unknowns": dict(event.unknowns),
                **({"beyond": others[number]} if number in others else {}),
            }
            for number, event in enumerate(branch.events)
        ],
    }


def show_branch(branch: Branch, others: Others) -> None:
    """Show the events of a branch, the itineraries beyond them, and why the branch ends.

    `others` holds those itineraries by the indices of the events.
    """
    low, high = float(branch.parameter_values.min()), float(branch.parameter_values.max())
    allowed = int(branch.admissible.sum())
    print(
        f"{shown_name(branch.name)}: {len(branch)} points,"
        f" {branch.parameter} from {low:.10g} to {high:.10g},"
        f" {allowed} of them motions of the real system"
    )
    if branch.events:
        table = listing("event", branch.parameter, "where", "boundary")
        for event in branch.events:
            where = "" if event.phase is None else f"{event.configuration} ({event.phase + 1})"
            kind = event.kind + ", touched" * event.touching
            table.add_row(kind, f"{event.value:.12g}", where, event.boundary)
        show_table(table)
    for number, orbits in others.items():
        value = branch.events[number].value
        for orbit in orbits:
            names = " > ".join(f"{configuration}" for configuration, _ in orbit["itinerary"])
            print(f"beyond {branch.parameter} = {value:.6g}: {names} ({orbit['stability']})")
    for end, reason in zip(("begins", "ends"), branch.ends, strict=True):
        print(f"{end}: {reason}")
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


def locus_json(locus: Locus) -> dict[str, Any]:
    """A curve of events as JSON."""
    return {
        "orbit": locus.name,
        "kind": locus.kind,
        "boundary": locus.boundary,
        "parameters": list(locus.parameters),
        "values": locus.values.tolist(),
        "unknowns": {
            name: locus.unknowns[:, place].tolist()
            for place, name in enumerate(locus.unknown_names)
        },
        "ends": list(locus.ends),
    }


def show_locus(locus: Locus) -> None:
    """Show where a curve of events begins and ends in the plane of its parameters, and why."""
    print(f"{locus.title}: {len(locus)} points in the plane of {' and '.join(locus.parameters)}")
    table = listing("", *locus.parameters)
    places = {"begins": 0, "from": locus.start, "ends": len(locus) - 1}
    for word, place in places.items():
        table.add_row(word, *(f"{value:.12g}" for value in locus.values[place].tolist()))
    show_table(table)
    for end, reason in zip(("begins", "ends"), locus.ends, strict=True):
        print(f"{end}: {reason}")


def _finite(values: Any) -> list[float | None]:
    return [x if abs(x) < float("inf") else None for x in values.tolist()]

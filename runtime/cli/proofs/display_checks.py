"""What `certify --check` shows to people: nothing that was not proved again or compared."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from rich.console import Console
from rich.text import Text

from nonsmooth.runtime.cli.proofs.display_certificates import (
    UNIFORM,
    basin_lines,
    branch_table,
    chaos_lines,
    doubling_table,
    enclosure_table,
    share_table,
    show_boxes,
    show_census,
    show_derivatives,
    show_regions,
)
from nonsmooth.runtime.cli.tables import STYLES, console_as_wide, listing, show_table
from nonsmooth.runtime.core.values import Value
from nonsmooth.runtime.model.naming import shown_name
from nonsmooth.runtime.present.checking.check_file import Check
from nonsmooth.runtime.proof.basin.basin_certificate import BasinCertificate
from nonsmooth.runtime.proof.boxes.box_certificate import BoxCertificate
from nonsmooth.runtime.proof.branch.certified_branch import CertifiedBranch
from nonsmooth.runtime.proof.certificate import Certificate
from nonsmooth.runtime.proof.chaos.chaos_certificate import ChaosCertificate
from nonsmooth.runtime.proof.counting.census import Census
from nonsmooth.runtime.proof.doubling.certified_doubling import CertifiedDoubling
from nonsmooth.runtime.proof.events.event_certificate import EventCertificate
from nonsmooth.runtime.proof.graphs.graph_certificate import GraphCertificate

__all__ = ["show_check"]

_POINT = {
    "existence": "one orbit, and no other, in the box of the file",
    "admissibility": "a motion of the real system",
}

_VERDICTS = {"proved": "proved", "refuted": "refuted", "undecided": "not claimed"}
_OF_A_BOX = {
    "proved": "proved",
    "refuted": "refuted on a part of it",
    "undecided": "not claimed on a part of it",
}


def show_check(found: Check) -> None:
    """Show what was proved again of a file, and what the file does not claim."""
    out = console_as_wide()
    match found.certificate:
        case Certificate() as certificate:
            _show_point(out, certificate, compared=found.compared)
        case BoxCertificate() as certificate:
            _show_map(out, certificate, compared=found.compared)
        case CertifiedBranch() as branch:
            _show_branch(out, branch, compared=found.compared)
        case CertifiedDoubling() as doubling:
            _show_doubling(out, doubling, compared=found.compared)
        case Census() as census:
            _show_census(census, compared=found.compared)
        case BasinCertificate() as basin:
            _show_basin(out, basin)
        case GraphCertificate() as graph:
            _show_graph(out, graph)
        case ChaosCertificate() as chaos:
            _show_chaos(out, chaos)
        case tuple() as events:
            _show_events(out, events, compared=found.compared)


def _show_point(out: Console, certificate: Certificate, *, compared: bool) -> None:
    if certificate.claims["existence"] == "undecided":
        out.print(Text("nothing is claimed", style="bold"))
        return
    out.print(Text(_called(certificate.orbit, compared=compared), style="bold"))
    _show_cycle(out, certificate.itinerary)
    _show_point_values(out, certificate, compared=compared)
    meaning = {**_POINT, "stability": certificate.stability}
    _show_claims(out, certificate.claims, meaning, _VERDICTS)
    if certificate.enclosures:
        table = listing("enclosure", "")
        for name, enclosure in certificate.enclosures.items():
            table.add_row(name, str(enclosure))
        show_table(table, out)
    show_derivatives(out, certificate)


def _show_map(out: Console, found: BoxCertificate, *, compared: bool) -> None:
    if not found.declaration:
        out.print(Text("nothing is claimed", style="bold"))
        return
    ends = ", ".join(f"{name} = {low} ... {high}" for name, (low, high) in found.box.items())
    out.print(Text(f"{_called(found.orbit, compared=compared)} for all {ends}", style="bold"))
    _show_cycle(out, found.itinerary)
    _show_values(out, found.parameters)
    meaning = {**UNIFORM, "stability": found.stability}
    _show_claims(out, found.claims, meaning, _OF_A_BOX)
    show_table(share_table(found), out)
    show_regions(out, found)
    if found.enclosures:
        show_table(enclosure_table(found), out)


def _show_branch(out: Console, found: CertifiedBranch, *, compared: bool) -> None:
    if not found.tiles:
        out.print(Text("nothing is claimed", style="bold"))
        return
    low, high = found.interval
    over = f"{found.parameter} = {low} ... {high}"
    out.print(Text(f"{_called(found.orbit, compared=compared)}, {over}", style="bold"))
    _show_cycle(out, found.itinerary)
    _show_values(out, found.parameters)
    show_table(branch_table(found), out)
    meaning = {"branch": "exactly these intervals and events"}
    _show_claims(out, found.claims, meaning, _VERDICTS)


def _show_doubling(out: Console, found: CertifiedDoubling, *, compared: bool) -> None:
    out.print(
        Text(f"{_called(found.orbit, compared=compared)}, along {found.parameter}", style="bold")
    )
    _show_cycle(out, found.branch.itinerary)
    _show_values(out, found.parameters)
    show_table(doubling_table(found), out)
    meaning = {"doubling": "the flip, and the orbits of twice the period beside it"}
    _show_claims(out, found.claims, meaning, _VERDICTS)


def _show_events(out: Console, events: Sequence[EventCertificate], *, compared: bool) -> None:
    groups: dict[Any, list[EventCertificate]] = {}
    for event in events:
        if event.proved:
            told = (event.orbit, event.itinerary, tuple(event.parameters.items()))
            groups.setdefault(told, []).append(event)
    for (label, itinerary, values), group in groups.items():
        out.print(Text(_called(label, compared=compared), style="bold"))
        _show_cycle(out, itinerary)
        _show_values(out, dict(values))
        table = listing("event", "where", "parameter")
        for event in group:
            where = "" if event.phase is None else f"phase {event.phase + 1} {event.configuration}"
            where += f": {event.boundary}" if event.boundary else ""
            table.add_row(event.kind, where, f"{event.parameter} = {event.value}")
        show_table(table, out)
    left = sum(1 for event in events if not event.proved)
    if left or not events:
        out.print(f"{left} of {len(events)} events {'is' if left == 1 else 'are'} not claimed")


def _show_census(census: Census, *, compared: bool) -> None:
    bound = compared or census.declaration["parameters"]
    called = _called(census.orbit, compared=compared)
    show_census(replace(census, orbit=called, parameters=census.parameters if bound else {}))


def _show_basin(out: Console, found: BasinCertificate) -> None:
    if not found.proved:
        out.print(Text("nothing is claimed", style="bold"))
        return
    out.print(Text(shown_name(found.system), style="bold"))
    _show_values(out, found.parameters)
    # what it is called was not compared
    for line in basin_lines(replace(found, orbit="the orbit through the core")):
        out.print(line)


def _show_graph(out: Console, found: GraphCertificate) -> None:
    out.print(Text(shown_name(found.system), style="bold"))
    _show_values(out, found.parameters)
    show_boxes(out, found)


def _show_chaos(out: Console, found: ChaosCertificate) -> None:
    if not found.proved:
        out.print(Text("nothing is claimed", style="bold"))
        return
    out.print(Text(shown_name(found.system), style="bold"))
    _show_values(out, found.parameters)
    for line in chaos_lines(found):
        out.print(line)


def _show_point_values(out: Console, certificate: Certificate, *, compared: bool) -> None:
    """Show only those parameters that the checked declaration fixes.

    All of them count if the declaration was compared, or contains parameters itself.
    """
    bound = compared or certificate.declaration["parameters"]
    values = dict(certificate.parameters) if bound else {}
    if certificate.given_period is not None:
        values["period"] = certificate.given_period
    _show_values(out, values)


def _show_cycle(out: Console, itinerary: Sequence[tuple[str, str]]) -> None:
    out.print(Text(" -> ".join([*(configuration for configuration, _ in itinerary), "..."])))


def _show_values(out: Console, values: Mapping[str, Value]) -> None:
    if values:
        out.print(Text("at " + ", ".join(f"{name} = {value}" for name, value in values.items())))


def _show_claims(
    out: Console,
    claims: Mapping[str, str],
    meaning: Mapping[str, str],
    words: Mapping[str, str],
) -> None:
    table = listing("claim", "", "")
    for name, verdict in claims.items():
        table.add_row(name, Text(words[verdict], style=STYLES[verdict]), meaning[name])
    show_table(table, out)


def _called(label: str, *, compared: bool) -> str:
    """The orbit's name if the declaration of that name was compared, else a description."""
    return shown_name(label) if compared else "an orbit of the declaration in the file"

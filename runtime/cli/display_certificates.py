"""What the command that certifies shows to people."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from rich.console import Console
from rich.table import Table
from rich.text import Text

from nonsmooth.runtime.cli.display_graphs import section_words
from nonsmooth.runtime.cli.display_regions import show_regions
from nonsmooth.runtime.cli.tables import console_as_wide, listing, show_table
from nonsmooth.runtime.model.naming import shown_name
from nonsmooth.runtime.proof.boxes.box_certificate import BoxCertificate
from nonsmooth.runtime.proof.branch.certified_branch import FINISHED, CertifiedBranch
from nonsmooth.runtime.proof.branch.look import UNDECIDED
from nonsmooth.runtime.proof.certificate import Certificate
from nonsmooth.runtime.proof.chaos.chaos_certificate import ChaosCertificate
from nonsmooth.runtime.proof.doubling.certified_doubling import CertifiedDoubling
from nonsmooth.runtime.proof.events.event_certificate import EventCertificate

if TYPE_CHECKING:
    from nonsmooth.runtime.core.values import Value

__all__ = [
    "STYLES",
    "UNIFORM",
    "branch_table",
    "chaos_lines",
    "doubling_table",
    "enclosure_table",
    "share_table",
    "show_box",
    "show_branch",
    "show_certificate",
    "show_chaos",
    "show_derivatives",
    "show_doubling",
    "show_events",
]

_ENDS = {
    "unfinished": "the work was stopped, and --resume goes on with it",
    "no flip": "the branch has no flip that is proved",
    "not covered": "such orbits are not covered",
    "not proved": "a step is not proved",
}

UNIFORM = {
    "existence": "one orbit next to the one that was followed",
    "admissibility": "a motion of the real system",
}
STYLES = {"proved": "green", "refuted": "red", "undecided": "yellow"}


def _show_claims(certificate: Certificate) -> None:
    out = console_as_wide()
    out.print(Text(f"{shown_name(certificate.orbit)}, {certificate.bits} bits", style="bold"))
    out.print(Text(" -> ".join([*(c for c, _ in certificate.itinerary), "..."])))
    table = listing("claim", "", "")
    meaning = {
        "existence": "one orbit, and no other, in the box",
        "admissibility": "a motion of the real system",
        "stability": certificate.stability,
    }
    for name, verdict in certificate.claims.items():
        told = Text("not " * (verdict == "refuted") + meaning[name])
        if name in certificate.reasons:
            told.append(f": {certificate.reasons[name]}", style="dim")
        table.add_row(name, Text(verdict, style=STYLES[verdict]), told)
    show_table(table, out)


def show_certificate(certificate: Certificate) -> None:
    """Show claims, parameters, enclosures with their box, derivatives and margins."""
    _show_claims(certificate)
    out = console_as_wide()
    values = {**certificate.parameters}
    if certificate.given_period is not None:
        values["period"] = certificate.given_period
    _show_point(values, certificate.chosen, out)
    for name, reason in certificate.no_derivatives.items():
        out.print(Text(f"no derivatives by {name}: {reason}", style="dim"))
    if not certificate.enclosures:
        return
    table = listing("enclosure", "", "unique within")
    sides = {side.name: side.rad for side in certificate.box}
    for name, enclosure in certificate.enclosures.items():
        table.add_row(name, str(enclosure), _rounded(sides[name]) if name in sides else "")
    for number, (re, im) in enumerate(certificate.multipliers, 1):
        imaginary = "" if im.contains(0) else f" + {im} i"
        table.add_row(f"multiplier {number}", f"{re}{imaginary}", "")
    others = certificate.other_multipliers
    bound = f"at most {float(others):g} in absolute value" if others else "not enclosed"
    table.add_row("other multipliers", bound, "")
    show_table(table, out)
    show_derivatives(out, certificate)
    if certificate.margins:
        table = listing("phase", "boundary", "respected by at least")
        for margin in certificate.margins:
            place = f"{margin['phase']} {margin['configuration']}"
            size = f"{_rounded(margin['least'])} ({margin['quantity']})"
            table.add_row(place, margin["boundary"], size)
        show_table(table, out)


def show_derivatives(out: Console, certificate: Certificate) -> None:
    """Show the enclosed derivatives.

    Where a name stands for a direction of several parameters, what moves along it is shown.
    """
    if not certificate.derivatives:
        return
    table = listing("derivative", "by", "")
    for quantity, rates in certificate.derivatives.items():
        for name, enclosure in rates.items():
            table.add_row(quantity, name, str(enclosure))
    show_table(table, out)
    for name, direction in certificate.directions.items():
        if direction.keys() != {name}:
            moves = ", ".join(f"{other} by {rate}" for other, rate in direction.items())
            out.print(Text(f"with {name} by 1 moves {moves}", style="dim"))


def show_box(found: BoxCertificate) -> None:
    """Show what is proved for a box of parameters, and for which share of it."""
    out = console_as_wide()
    ends = ", ".join(f"{name} = {low} ... {high}" for name, (low, high) in _decimal(found))
    out.print(Text(f"{shown_name(found.orbit)} for all {ends}", style="bold"))
    out.print(Text(" -> ".join([*(c for c, _ in found.itinerary), "..."])))
    table = listing("claim", "", "")
    reasons = found.reasons
    for name, verdict in found.claims.items():
        told = Text(found.stability if name == "stability" else UNIFORM[name])
        if name in reasons:
            told.append(f"; {verdict} {reasons[name]}", style="dim")
        table.add_row(name, Text(verdict, style=STYLES[verdict]), told)
    show_table(table, out)
    show_table(share_table(found), out)
    show_regions(out, found)
    _show_point(found.parameters, found.chosen, out)
    if found.enclosures:
        show_table(enclosure_table(found), out)


def _show_point(values: Mapping[str, Value], chosen: Sequence[str], out: Console) -> None:
    """Show the fixed parameters of a proof, and which of them were chosen for it."""
    if values:
        out.print(Text("at " + ", ".join(f"{name} = {value}" for name, value in values.items())))
    if chosen:
        out.print(Text(f"{', '.join(chosen)} left open: chosen for this proof", style="dim"))


def share_table(found: BoxCertificate) -> Table:
    """Share of the box and number of tiles, one row for each verdict that occurs."""
    table = listing("of the box", "", "tiles")
    for verdict, share in found.shares.items():
        tiles = found.verdicts.count(verdict)
        name = f"{found.stability}, proved" if verdict == "proved" else verdict
        name = "divided by a curve" if verdict == "divided" else name
        if tiles:
            table.add_row(name, f"{float(100 * share):.4g} %", str(tiles))
    return table


def enclosure_table(found: BoxCertificate) -> Table:
    """Bounds over all of the box, one row for each enclosed number."""
    table = listing("enclosure", "from", "to")
    for name, enclosure in found.enclosures.items():
        table.add_row(name, f"{enclosure.lower:.8g}", f"{enclosure.upper:.8g}")
    return table


def show_events(told: str, found: Sequence[EventCertificate]) -> None:
    """Show where events are proved to be, below a title that says what they are events of."""
    out = console_as_wide()
    out.print(Text(told, style="bold"))
    table = listing("event", "where", "", "parameter")
    for certificate in found:
        where = ""
        if certificate.phase is not None:
            where = f"phase {certificate.phase + 1} {certificate.configuration}:"
            where += f" {certificate.boundary}"
        value = certificate.reason
        if certificate.proved:
            value = f"{certificate.parameter} = {certificate.value}"
        claim = Text(certificate.claim, style=STYLES[certificate.claim])
        table.add_row(certificate.kind, where, claim, value)
    if found:
        show_table(table, out)
    else:
        out.print(Text("nothing happens: no events"))


def show_branch(found: CertifiedBranch) -> None:
    """Show the intervals of a proved branch and the events between them."""
    out = console_as_wide()
    low, high = map(float, found.interval)
    over = f"{found.parameter} = {low:.6g} ... {high:.6g}"
    out.print(Text(f"{shown_name(found.orbit)}, {over}", style="bold"))
    out.print(Text(" -> ".join([*(c for c, _ in found.itinerary), "..."])))
    if found.intervals:
        show_table(branch_table(found), out)
    for name, value in (("beginning", found.ends[0]), ("end", found.ends[1])):
        if value != FINISHED:
            out.print(Text(f"{name}: {value or 'not followed further'}", style="dim"))
    _show_point(found.parameters, found.chosen, out)
    if found.complete:
        out.print(Text("the branch consists of exactly these intervals and events", style="green"))


def branch_table(found: CertifiedBranch) -> Table:
    """Intervals and events in the order of the branch, and what is proved beyond events."""
    table = listing("", found.parameter, "", "tiles")
    events = iter(found.events)
    before = UNDECIDED
    for part in found.intervals:
        if UNDECIDED not in (before, part.verdict):
            event = next(events)
            where = event.configuration
            if event.phase is not None:
                where = f"phase {event.phase + 1} {where}: {event.boundary}"
            value = str(event.enclosures[found.parameter])
            table.add_row(Text(event.kind, style="bold"), value, where, "")
            for beyond in event.beyond:
                ends = f"{float(event.enclosures[found.parameter]):.10g} ... {beyond.reach:.10g}"
                way = " -> ".join(configuration for configuration, _ in beyond.itinerary)
                table.add_row(f"beyond: {beyond.verdict}", ends, f"{beyond.scenario}: {way}", "1")
        told = f"{part.begin:.10g} ... {part.end:.10g}"
        why = part.reason
        if part.verdict == UNDECIDED:
            why = f"{part.width:.3g} wide: {why}"
        style = "yellow" if part.verdict == UNDECIDED else ""
        table.add_row(Text(part.verdict, style=style), told, why, str(part.tiles))
        before = part.verdict
    return table


def show_doubling(found: CertifiedDoubling) -> None:
    """Show the flip, and what is proved of the orbits of twice the period beside it."""
    out = console_as_wide()
    out.print(Text(f"{shown_name(found.orbit)}, along {found.parameter}", style="bold"))
    show_table(doubling_table(found), out)
    values = found.parameters
    out.print(Text("at " + ", ".join(f"{name} = {value}" for name, value in values.items())))
    if found.ended != "complete":
        told = f"ended because {_ENDS[found.ended]}"
        out.print(Text(f"{told}: {found.end}" if found.end else told, style="yellow"))


def doubling_table(found: CertifiedDoubling) -> Table:
    """A row for the flip, one for the doubled orbits, and one for each part of their branch."""
    table = listing("", found.parameter, "", "phases")
    doubled, flip = found.doubled, found.flip
    if doubled is None or flip is None:
        return table
    phases = len(found.branch.itinerary)
    value = str(flip.enclosures[found.parameter])
    table.add_row(Text("flip", style="bold"), value, found.kind, str(phases))
    low, high = map(float, doubled.branch.interval)
    near = f"{doubled.side} the flip: {doubled.verdict}"
    told = f"{near}: {doubled.reason}" if doubled.reason else near
    table.add_row("doubled orbits", f"{low:.10g} ... {high:.10g}", told, str(2 * phases))
    for part in doubled.branch.intervals:
        table.add_row("", f"{part.begin:.10g} ... {part.end:.10g}", part.verdict, "")
    return table


def show_chaos(found: ChaosCertificate) -> None:
    """Show what is proved of chaos, or, if nothing is, what was tried."""
    out = console_as_wide()
    out.print(Text(f"{shown_name(found.system)}, {found.bits} bits", style="bold"))
    table = listing("claim", "", "")
    table.add_row("chaos", Text(found.claim, style=STYLES[found.claim]), found.reason)
    show_table(table, out)
    if not found.proved:
        for line in found.tried:
            out.print(f"tried: {line}")
        return
    for line in chaos_lines(found):
        out.print(line)


def chaos_lines(found: ChaosCertificate) -> list[str]:
    """What a proved certificate of chaos says, in lines of text."""
    lines = [
        f"the map P {section_words(found)}",
        f"topological entropy of P at least {found.entropy}",
    ]
    power = "P" if found.iterates == 1 else f"P^{found.iterates}"
    for h_set in found.h_sets:
        targets = [other for one, other in found.coverings if one == h_set.name]
        centre = ", ".join(
            f"{name} = {x}" for name, x in zip(found.coordinates, h_set.centre, strict=True)
        )
        lines.append(f"{h_set.name} about {centre} covers {', '.join(targets)} by {power}")
    counts = ", ".join(str(found.periodic_points(steps)) for steps in range(1, 7))
    least = "at least" if found.cones is None else "exactly, of these histories"
    lines.append(f"points that come back after 1 to 6 times {power}, {least}: {counts}")
    if found.cones is not None:
        lines.append(f"largest Lyapunov exponents of these motions at least {found.exponent} by P")
        lines.append("each history through the graph is that of one motion, which is hyperbolic")
    return lines


def _decimal(found: BoxCertificate) -> list[tuple[str, tuple[float, float]]]:
    return [(name, (float(low), float(high))) for name, (low, high) in found.box.items()]


def _rounded(text: str) -> str:
    return f"{float(text):.3g}"

"""What the command that certifies shows to people."""

from __future__ import annotations

from collections.abc import Sequence

from rich import box
from rich.table import Table
from rich.text import Text

from nonsmooth.runtime.certification.boxes.record import BoxCertificate
from nonsmooth.runtime.certification.certificate import Certificate
from nonsmooth.runtime.certification.events.record import EventCertificate
from nonsmooth.runtime.commands.display import wide_console

__all__ = [
    "STYLES",
    "UNIFORM",
    "WIDTH",
    "enclosure_table",
    "share_table",
    "show_box",
    "show_certificate",
    "show_events",
    "table_of",
]

WIDTH = 118
UNIFORM = {
    "existence": "one orbit next to the one that was followed",
    "admissibility": "a motion of the real system",
}
STYLES = {"proved": "green", "refuted": "red", "undecided": "yellow"}


def _show_claims(certificate: Certificate) -> None:
    out = wide_console(WIDTH)
    out.print(Text(f"{certificate.orbit}, {certificate.bits} bits", style="bold"))
    out.print(Text(" -> ".join([*(c for c, _ in certificate.itinerary), "..."])))
    table = table_of("claim", "", "")
    meaning = {
        "existence": "one orbit, and no other, in the box",
        "admissibility": "a motion of the real system",
        "stability": certificate.stability,
    }
    for name, verdict in certificate.claims.items():
        told = Text(meaning[name])
        if name in certificate.reasons:
            told.append(f": {certificate.reasons[name]}", style="dim")
        table.add_row(name, Text(verdict, style=STYLES[verdict]), told)
    out.print(table)


def show_certificate(certificate: Certificate) -> None:
    """Show claims, parameters, enclosures, the box, and the margins."""
    _show_claims(certificate)
    out = wide_console(WIDTH)
    values = {**certificate.parameters}
    if certificate.given_period is not None:
        values["period"] = certificate.given_period
    out.print(Text("at " + ", ".join(f"{name} = {value}" for name, value in values.items())))
    if certificate.chosen:
        names = ", ".join(certificate.chosen)
        out.print(Text(f"{names} left open: chosen for this proof", style="dim"))
    if not certificate.enclosures:
        return
    table = table_of("enclosure", "", "unique within")
    sides = {side.name: side.rad for side in certificate.box}
    for name, enclosure in certificate.enclosures.items():
        table.add_row(name, str(enclosure), _rounded(sides[name]) if name in sides else "")
    for number, (re, im) in enumerate(certificate.multipliers, 1):
        imaginary = "" if im.contains(0) else f" + {im} i"
        table.add_row(f"multiplier {number}", f"{re}{imaginary}", "")
    out.print(table)
    if certificate.margins:
        table = table_of("phase", "boundary", "respected by at least")
        for margin in certificate.margins:
            place = f"{margin['phase']} {margin['configuration']}"
            size = f"{_rounded(margin['least'])} ({margin['quantity']})"
            table.add_row(place, margin["boundary"], size)
        out.print(table)


def show_box(found: BoxCertificate) -> None:
    """Show what is proved for a box of parameters, and of how much of it."""
    out = wide_console(WIDTH)
    ends = ", ".join(f"{name} = {low} ... {high}" for name, (low, high) in _decimal(found))
    out.print(Text(f"{found.orbit} for all {ends}", style="bold"))
    out.print(Text(" -> ".join([*(c for c, _ in found.itinerary), "..."])))
    table = table_of("claim", "", "")
    reasons = found.reasons
    for name, verdict in found.claims.items():
        told = Text(found.stability if name == "stability" else UNIFORM[name])
        if name in reasons:
            told.append(f"; {verdict} {reasons[name]}", style="dim")
        table.add_row(name, Text(verdict, style=STYLES[verdict]), told)
    out.print(table)
    out.print(share_table(found))
    values = found.parameters
    if values:
        out.print(Text("at " + ", ".join(f"{name} = {value}" for name, value in values.items())))
    if found.chosen:
        names = ", ".join(found.chosen)
        out.print(Text(f"{names} left open: chosen for this proof", style="dim"))
    if found.enclosures:
        out.print(enclosure_table(found))


def share_table(found: BoxCertificate) -> Table:
    """How much of the box has which verdict, on how many tiles."""
    table = table_of("of the box", "", "tiles")
    for verdict, share in found.shares.items():
        tiles = sum(tile.verdict == verdict for tile in found.tiles)
        name = f"{found.stability}, proved" if verdict == "proved" else verdict
        if tiles:
            table.add_row(name, f"{float(100 * share):.4g} %", str(tiles))
    return table


def enclosure_table(found: BoxCertificate) -> Table:
    """Bounds over all of the box."""
    table = table_of("enclosure", "from", "to")
    for name, enclosure in found.enclosures.items():
        table.add_row(name, f"{enclosure.lower:.8g}", f"{enclosure.upper:.8g}")
    return table


def show_events(told: str, found: Sequence[EventCertificate]) -> None:
    """Show where events are proved to be, below what they are events of."""
    out = wide_console(WIDTH)
    out.print(Text(told, style="bold"))
    table = table_of("event", "where", "", "parameter")
    for certificate in found:
        where = ""
        if certificate.phase is not None:
            where = f"phase {certificate.phase} {certificate.configuration}: {certificate.boundary}"
        value = certificate.reason
        if certificate.proved:
            value = f"{certificate.parameter} = {certificate.value}"
        claim = Text(certificate.claim, style=STYLES[certificate.claim])
        table.add_row(certificate.kind, where, claim, value)
    out.print(table if found else Text("nothing happens: no events"))


def _decimal(found: BoxCertificate) -> list[tuple[str, tuple[float, float]]]:
    return [(name, (float(low), float(high))) for name, (low, high) in found.box.items()]


def table_of(*columns: str) -> Table:
    """An empty table with these columns."""
    table = Table(box=box.SIMPLE_HEAD, pad_edge=False, padding=(0, 2, 0, 0))
    for name in columns:
        table.add_column(name, overflow="fold")
    return table


def _rounded(text: str) -> str:
    return f"{float(text):.3g}"

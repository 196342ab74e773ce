"""What `certify --all` shows to people."""

from __future__ import annotations

from rich.text import Text

from nonsmooth.runtime.cli.tables import console_as_wide, listing, show_table
from nonsmooth.runtime.model.naming import shown_name
from nonsmooth.runtime.proof.counting.census import Bounds, Census

__all__ = ["show_census"]

_VERDICTS = {True: ("yes", "green"), False: ("no", "red"), None: ("undecided", "yellow")}


def show_census(census: Census) -> None:
    """Show what a census proves, its orbits, and the boxes that are undecided."""
    out = console_as_wide()
    out.print(Text(f"{shown_name(census.orbit)}, {census.looked} boxes", style="bold"))
    out.print(Text(" -> ".join([*(c for c, _ in census.itinerary), "..."])))
    found = [orbit.certificate for orbit in census.orbits if orbit.certificate is not None]
    names = found[0].dwell_names if found else ()
    table = listing("orbit", *names, "admissible", "stability")
    for number, orbit in enumerate(census.orbits, 1):
        word, style = _VERDICTS[orbit.admissible]
        times = ["" for _ in names]
        stability = "undecided"
        if orbit.certificate is not None:
            times = [f"{float(orbit.certificate.enclosures[n]):.9f}" for n in names]
            words = {"proved": orbit.certificate.stability, "refuted": "unstable"}
            stability = words.get(orbit.certificate.claims["stability"], stability)
        table.add_row(str(number), *times, Text(word, style=style), stability)
    if census.orbits:
        show_table(table, out)
    for number, orbit in enumerate(census.orbits, 1):
        if orbit.certificate is None:
            out.print(f"orbit {number}, {_text(orbit.unique)}: no certificate: {orbit.reason}")
    if census.undecided:
        table = listing("undecided box", "why")
        for entry in census.undecided:
            table.add_row(_text(entry.bounds), entry.reason)
        show_table(table, out)
    if census.beyond:
        solutions = "solution has" if census.beyond == 1 else "solutions have"
        follow = "a dwell time that follows and is not positive, or not in the box"
        out.print(Text(f"{census.beyond} more {solutions} {follow}", style="dim"))
    style = "green" if census.decided else "yellow"
    out.print(Text(census.statement, style=style))


def _text(bounds: Bounds) -> str:
    return ", ".join(f"{low} <= {name} <= {high}" for name, (low, high) in bounds.items())

"""Graphs of boxes for people."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rich.text import Text

from nonsmooth.runtime.cli.tables import console_as_wide, listing, show_table
from nonsmooth.runtime.model.naming import shown_name

if TYPE_CHECKING:
    from rich.console import Console

    from nonsmooth.runtime.proof.chaos.chaos_certificate import ChaosCertificate
    from nonsmooth.runtime.proof.graphs.graph_certificate import GraphCertificate

__all__ = ["section_words", "show_boxes", "show_graph"]

_MOST = 12  # components that are listed


def show_graph(found: GraphCertificate) -> None:
    """Show the region of a graph of boxes, its largest trapping region and its components."""
    out = console_as_wide()
    out.print(Text(f"{shown_name(found.system)}, {found.bits} bits", style="bold"))
    show_boxes(out, found)


def show_boxes(out: Console, found: GraphCertificate) -> None:
    """Show the part of `show_graph` that follows the name of the system."""
    grid = found.graph.grid
    region = ", ".join(f"{name} = {a:g}:{b:g}" for name, (a, b) in found.region.items())
    out.print(f"the map P {section_words(found)}")
    divided = f", divided into {len(grid)}" if len(grid) > len(grid.grid) else ""
    out.print(f"region {region} in {' x '.join(map(str, grid.grid.counts))} boxes{divided}")
    out.print(f"largest trapping region: {len(found.trapping)} boxes")
    table = listing("component", "boxes", "within", "", "leads to")
    for number, own in enumerate(found.components[:_MOST]):
        ends = zip(found.coordinates, own.low, own.high, strict=True)
        within = ", ".join(f"{name} = {a:g}:{b:g}" for name, a, b in ends)
        kind = Text("attracting", style="green") if own.attracting else Text("")
        ahead = [str(j) for i, j in found.arrows if i == number]
        ahead += ["outside or not known"] if own.leaves else []
        table.add_row(str(number), str(len(own.boxes)), within, kind, ", ".join(ahead))
    show_table(table, out)
    if (rest := len(found.components) - _MOST) > 0:
        out.print(f"and {rest} smaller components")
    out.print(f"boxes whose image is not known: {len(found.unknown)}")
    out.print(f"boxes whose image may leave the region: {len(found.outside)}")


def section_words(found: ChaosCertificate | GraphCertificate) -> str:
    """A phrase that says from which section to which the map of a certificate goes."""
    if found.phase:
        cosine, sine = found.phase
        where = f"in {found.configuration} where the forcing has the phase ({cosine}, {sine})"
        return f"over one period of the forcing, states {where}"
    where = f"behind {found.source} by {found.boundary} for {found.configuration}"
    return f"from one passage of this transition to the next, states {where}"

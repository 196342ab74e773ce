"""Basins that are proved, for people."""

from __future__ import annotations

from decimal import ROUND_DOWN, Context

from rich.text import Text

from nonsmooth.runtime.cli.display_certificates import STYLES
from nonsmooth.runtime.cli.tables import console_as_wide, listing, show_table
from nonsmooth.runtime.model.naming import shown_name
from nonsmooth.runtime.proof.basin.basin_certificate import BasinCertificate

__all__ = ["basin_lines", "show_basin"]

_DOWN = Context(prec=3, rounding=ROUND_DOWN)  # no more is said than is proved


def show_basin(found: BasinCertificate) -> None:
    """Show what is proved of a basin."""
    out = console_as_wide()
    out.print(Text(f"{shown_name(found.orbit)}, {found.bits} bits", style="bold"))
    table = listing("claim", "", "")
    table.add_row("basin", Text(found.claim, style=STYLES[found.claim]), found.reason)
    show_table(table, out)
    for line in basin_lines(found):
        out.print(line)


def basin_lines(found: BasinCertificate) -> list[str]:
    """What is proved of a basin, in lines of text; none if nothing is."""
    if not found.proved or found.core is None or found.grid is None:
        return []
    if found.phase:
        cosine, sine = found.phase
        where = f"in {found.configuration} where the forcing has the phase ({cosine}, {sine})"
    else:
        where = f"behind {found.source} by {found.boundary} for {found.configuration}"
    centre = ", ".join(
        f"{name} = {x}" for name, x in zip(found.coordinates, found.core.centre, strict=True)
    )
    power = "P" if found.iterates == 1 else f"P^{found.iterates}"
    lines = [
        f"the map P takes states {where}, to where they come back to it",
        f"{power} contracts a set about {centre}, by less than {found.contraction}",
        f"{found.statement}",
    ]
    known = found.to_json()
    lines += [
        f"the section: {name} from {low:.6g} to {high:.6g}"
        for name, (low, high) in known["section"]["bounds"].items()
    ]
    if found.tiles is not None:
        looked = int(found.looked.sum())
        good = int(found.attracted.sum())
        sides = ", ".join(f"{side:g}" for side in found.tiles.sides)
        lines.append(
            f"tiles of the sides {sides}: {good} of {looked} that were looked at are attracted,"
            f" {_DOWN.create_decimal(100 * found.share)} % of the box"
        )
    return lines

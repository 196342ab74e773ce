"""How regions and curves of a proven map are shown in a terminal."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rich.text import Text

from nonsmooth.runtime.cli.tables import listing, show_table

if TYPE_CHECKING:
    from rich.console import Console

    from nonsmooth.runtime.proof.boxes.box_certificate import BoxCertificate

__all__ = ["show_regions"]

_MOST = 12  # rows of a table


def show_regions(out: Console, found: BoxCertificate) -> None:
    """Show the regions, the curves and the undecided parts of a box of two parameters.

    Nothing is shown of a box of another number of parameters.
    """
    if not found.statement:
        return
    out.print(Text(found.statement))
    if found.curves:
        table = listing("curve", "phase", "boundary", "tiles", "width", "from", "to")
        for curve in found.curves[:_MOST]:
            event = curve.event
            ends = [_place(found, point) for point in (curve.points[0], curve.points[-1])]
            told = [f"{at} ({end})" for at, end in zip(ends, curve.ends, strict=False)]
            table.add_row(
                event.kind,
                "" if event.phase is None else str(event.phase + 1),
                event.boundary,
                str(len(curve.tiles)),
                f"{curve.width:.1e}",
                *(told or ["closed", ""]),
            )
        show_table(table, out)
    if found.open:
        table = listing("undecided", "of the box", "tiles", "events beside it")
        for box in found.open[:_MOST]:
            where = ", ".join(
                f"{name} = {float(low):.6g} ... {float(high):.6g}"
                for name, (low, high) in box.where.items()
            )
            share = f"{float(100 * box.share):.3g} %"
            table.add_row(where, share, str(box.tiles), "; ".join(box.events))
        show_table(table, out)
    hidden = max(len(found.curves), len(found.open)) - _MOST
    if hidden > 0:
        out.print(Text(f"and {hidden} more, which --json lists", style="dim"))


def _place(found: BoxCertificate, point: tuple[float, float]) -> str:
    return ", ".join(f"{n} = {x:.6g}" for n, x in zip(found.box, point, strict=True))

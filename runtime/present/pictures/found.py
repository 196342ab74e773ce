"""Pictures of orbits that were found: a row for each, its portrait beside its history."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.explore.finding.find import Found, FoundOrbit
from nonsmooth.runtime.model.naming import shown_name
from nonsmooth.runtime.present.pictures.drawing import check_picture
from nonsmooth.runtime.present.pictures.plot import draw
from nonsmooth.runtime.present.pictures.view import orbit_view

if TYPE_CHECKING:
    from matplotlib.figure import Figure

__all__ = ["KINDS", "found_figure"]

KINDS = ("time", "velocity", "phase", "all")

_MOST_ROWS = 12
_ROW = 3.4  # inches
_WIDTHS = {"phase": 4.6, "time": 6.8, "velocity": 6.8}


def found_figure(found: Found, kind: str = "all", *, periods: int = 1) -> Figure:
    """Figure, outside pyplot, of the found orbits with the largest basins.

    The kind is "time" or "velocity" (positions or velocities over so many periods), "phase"
    (portraits of all masses in one), or "all" (portraits and positions). `InputError` is
    raised for another kind, or if no orbit was found.
    """
    check_picture(kind, KINDS)
    known = [k for k, entry in enumerate(found.orbits) if not isinstance(entry.solved, str)]
    if not known:
        told = f", but {len(found.equilibria)} equilibria" if found.equilibria else ""
        told = "; ".join(str(entry.solved) for entry in found.orbits) or (
            f"no orbit of {found.system} was found{told}"
        )
        raise InputError(f"{told}: there is nothing to draw")
    from matplotlib.figure import Figure

    shown = known[:_MOST_ROWS]
    kinds = ("phase", "time") if kind == "all" else (kind,)
    widths = [_WIDTHS[one] for one in kinds]
    figure = Figure(figsize=(sum(widths), _ROW * len(shown)))
    figure.set_layout_engine("constrained", wspace=0.04, hspace=0.04)
    if len(shown) < len(found.orbits):
        figure.suptitle(f"{shown_name(found.system)}: {len(shown)} of {len(found.orbits)} orbits")
    grid = figure.add_gridspec(len(shown), len(kinds), width_ratios=widths)
    for row, place in enumerate(shown):
        entry = found.orbits[place]
        for column, one in enumerate(kinds):
            view = orbit_view(entry.orbit, periods, 600, None)
            title = _title(place, entry) if column == 0 else " "
            draw(replace(view, name=title), one, [figure.add_subplot(grid[row, column])])
    return figure


def _title(place: int, entry: FoundOrbit) -> str:
    share = f"{100 * entry.share:.3g} % of the starts" if entry.starts else "no start leads there"
    turns = ", ".join(map(str, entry.forcing_periods))
    count = "" if not turns else f" = {turns} forcing period{'' if turns == '1' else 's'}"
    mirror = ""
    if entry.mirror is not None and entry.mirror != place:
        mirror = f", mirror image of {entry.mirror + 1}"
    return f"{place + 1}: period {entry.period:.6g}{count}, {entry.verdict}, {share}{mirror}"

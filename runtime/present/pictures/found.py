"""Pictures of what was found: orbits, each with its portrait and its history, and sweeps."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.explore.finding.find import Found, FoundOrbit
from nonsmooth.runtime.explore.finding.sweep import Sweep
from nonsmooth.runtime.model.naming import shown_name, units_of
from nonsmooth.runtime.present.pictures.drawing import (
    check_picture,
    drawn_alone,
    finish,
    mark_style,
    widen,
)
from nonsmooth.runtime.present.pictures.plot import draw
from nonsmooth.runtime.present.pictures.view import orbit_view

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_KINDS = ("time", "velocity", "phase", "all")

_MOST_ROWS = 12
_ROW = 3.4  # inches
_WIDTHS = {"phase": 4.6, "time": 6.8, "velocity": 6.8}


def found_figure(found: Found, kind: str = "all", *, periods: int = 1) -> Figure:
    """Figure, outside pyplot, of the found orbits with the largest basins.

    The kind is "time" or "velocity" (positions or velocities over so many periods), "phase"
    (portraits of all masses in one), or "all" (portraits and positions). `InputError` is
    raised for another kind, or if no orbit was found.
    """
    check_picture(kind, _KINDS)
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


def draw_sweep(diagram: Sweep, axes: Any = None) -> Any:
    """Draw a bifurcation diagram; NaN is left out.

    The result is the Axes that are given, or else a new figure.
    """
    return drawn_alone("sweep", (6.4, 4.4), lambda own: _draw_diagram(own, diagram), axes)


def _draw_diagram(axes: Axes, diagram: Sweep) -> None:
    values, taken = np.nonzero(np.isfinite(diagram.samples))
    axes.plot(
        diagram.values[values],
        diagram.samples[values, taken],
        # the more points there are, the smaller they are
        markersize=float(np.clip(60.0 / np.sqrt(1 + len(values)), 1.1, 4.0)),
        markeredgewidth=0,
        alpha=0.7,
        rasterized=len(values) > 20_000,
        **mark_style(0),
    )
    units = units_of(diagram.system)
    ends = diagram.values[[0, -1]]  # values without samples are shown too
    axes.update_datalim(np.stack([ends, ends], axis=-1), updatey=False)
    axes.margins(0.02, 0.05)
    widen(axes)
    title = f"{shown_name(diagram.system)}: {diagram.state} {diagram.when}"
    finish(axes, title, units.label(diagram.parameter), units.label(diagram.state))

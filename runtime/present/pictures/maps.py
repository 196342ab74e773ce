"""Pictures of many motions: basins of attraction, and bifurcation diagrams."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.explore.finding.found import label_names
from nonsmooth.runtime.explore.finding.outcomes import Outcome
from nonsmooth.runtime.model.naming import shown_name, units_of
from nonsmooth.runtime.present.pictures.drawing import (
    SHADES,
    check_matplotlib,
    finish,
    mark_style,
    shaded,
)

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from nonsmooth.runtime.explore.finding.basins import Basins
    from nonsmooth.runtime.explore.finding.sweep import Sweep

__all__ = ["draw_basins", "draw_sweep"]

# after Tol's scheme "muted", ordered so that neighbours differ in lightness too
_BASINS = (
    *("#332288", "#DDCC77", "#117733", "#88CCEE", "#882255"),
    *("#CC6677", "#44AA99", "#AA4499", "#999933"),
)
_UNCLASSIFIED = "#DDDDDD"


def draw_basins(plane: Basins) -> Figure:
    """Figure, outside pyplot, of a plane of starts from `basins`.

    The attractors come in their order, then the other outcomes. `InputError` is raised if there
    are more than can be told apart.
    """
    check_matplotlib()
    from matplotlib.colors import ListedColormap
    from matplotlib.figure import Figure

    names = label_names(plane.found)
    ends = [outcome for outcome in Outcome if outcome != Outcome.UNCLASSIFIED]
    order = [label for label in names if label >= 0]
    order += [int(outcome) for outcome in ends if (plane.labels == outcome).any()]
    most = SHADES * len(_BASINS)
    if len(order) > most:
        raise InputError(f"{len(order)} attractors, of which {most} can be told apart")
    places = np.full(plane.labels.shape, -1)
    for place, label in enumerate(order):
        places[plane.labels == label] = place
    colors = [_UNCLASSIFIED, *(shaded(_BASINS, place) for place in range(len(order)))]
    figure = Figure(figsize=(6.0, 5.4))
    figure.set_layout_engine("constrained")
    axes = figure.add_subplot()
    axes.pcolormesh(
        plane.x_values,
        plane.y_values,
        places,
        shading="nearest",
        cmap=ListedColormap(colors),
        vmin=-1.5,
        vmax=len(order) - 0.5,
        rasterized=True,
    )
    for place in [*range(len(order)), -1]:
        part = 100 * float((places == place).mean())
        name = names[order[place]] if place >= 0 else "unclassified"
        if part or place >= 0:
            axes.fill_between([], [], color=colors[place + 1], label=f"{name} ({_percent(part)})")
    units = units_of(plane.found.system)
    axes.set_xlabel(units.label(plane.x))
    axes.set_ylabel(units.label(plane.y))
    finish(axes, shown_name(plane.found.system))
    return figure


def draw_sweep(diagram: Sweep) -> Figure:
    """Figure, outside pyplot, of a bifurcation diagram; NaN is left out."""
    check_matplotlib()
    from matplotlib.figure import Figure

    figure = Figure(figsize=(6.4, 4.4))
    figure.set_layout_engine("constrained")
    axes = figure.add_subplot()
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
    axes.set_xlabel(units.label(diagram.parameter))
    axes.set_ylabel(units.label(diagram.state))
    axes.margins(0.02, 0.05)
    finish(axes, f"{shown_name(diagram.system)}: {diagram.state} {diagram.when}")
    return figure


def _percent(part: float) -> str:
    return f"{part:.1f} %" if part >= 0.1 or part == 0 else "< 0.1 %"

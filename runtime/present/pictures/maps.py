"""Pictures of many motions: basins of attraction, and bifurcation diagrams."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.explore.finding.found import label_names
from nonsmooth.runtime.explore.finding.outcomes import Outcome
from nonsmooth.runtime.model.naming import shown_name, units_of
from nonsmooth.runtime.present.pictures.drawing import (
    SHADES,
    drawn_alone,
    finish,
    mark_style,
    shaded,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from nonsmooth.runtime.explore.finding.basins import Basins
    from nonsmooth.runtime.explore.finding.sweep import Sweep

__all__ = ["draw_basins", "draw_sweep"]

# after Tol's scheme "muted", ordered so that neighbours differ in lightness too
_BASINS = (
    *("#332288", "#DDCC77", "#117733", "#88CCEE", "#882255"),
    *("#CC6677", "#44AA99", "#AA4499", "#999933"),
)
_UNCLASSIFIED = "#DDDDDD"


def draw_basins(plane: Basins, axes: Any = None) -> Any:
    """Draw a plane of starts from `basins`: the attractors in their order, then other outcomes.

    The result is the Axes that are given, or else a new figure. `InputError` is raised if there
    are more attractors than can be told apart.
    """
    names = label_names(plane.found)
    ends = [outcome for outcome in Outcome if outcome != Outcome.UNCLASSIFIED]
    order = [label for label in names if label >= 0]
    order += [int(outcome) for outcome in ends if (plane.labels == outcome).any()]
    most = SHADES * len(_BASINS)
    if len(order) > most:
        raise InputError(f"{len(order)} attractors, of which {most} can be told apart")
    labels = [names[label] for label in order]
    places = np.full(plane.labels.shape, -1)
    for place, label in enumerate(order):
        places[plane.labels == label] = place
    return drawn_alone(
        "basins", (6.0, 5.4), lambda own: _draw_plane(own, plane, places, labels), axes
    )


def _draw_plane(axes: Axes, plane: Basins, places: np.ndarray, labels: Sequence[str]) -> None:
    from matplotlib.colors import ListedColormap

    colors = [_UNCLASSIFIED, *(shaded(_BASINS, place) for place in range(len(labels)))]
    axes.pcolormesh(
        plane.x_values,
        plane.y_values,
        places,
        shading="nearest",
        cmap=ListedColormap(colors),
        vmin=-1.5,
        vmax=len(labels) - 0.5,
        rasterized=True,
    )
    for place in [*range(len(labels)), -1]:
        part = 100 * float((places == place).mean())
        name = labels[place] if place >= 0 else "unclassified"
        if part or place >= 0:
            axes.fill_between([], [], color=colors[place + 1], label=f"{name} ({_percent(part)})")
    units = units_of(plane.found.system)
    axes.set_xlabel(units.label(plane.x))
    axes.set_ylabel(units.label(plane.y))
    finish(axes, shown_name(plane.found.system))


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
    axes.set_xlabel(units.label(diagram.parameter))
    axes.set_ylabel(units.label(diagram.state))
    axes.margins(0.02, 0.05)
    finish(axes, f"{shown_name(diagram.system)}: {diagram.state} {diagram.when}")


def _percent(part: float) -> str:
    return f"{part:.1f} %" if part >= 0.1 or part == 0 else "< 0.1 %"

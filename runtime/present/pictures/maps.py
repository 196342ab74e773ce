"""Pictures of sweeps: bifurcation diagrams."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.model.naming import shown_name, units_of
from nonsmooth.runtime.present.pictures.drawing import drawn_alone, finish, mark_style

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from nonsmooth.runtime.explore.finding.sweep import Sweep

__all__ = ["draw_sweep"]


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
    axes.margins(0.02, 0.05)
    title = f"{shown_name(diagram.system)}: {diagram.state} {diagram.when}"
    finish(axes, title, units.label(diagram.parameter), units.label(diagram.state))

"""The paper's three schematics, drawn from shapes that paper.toml has as data.

Lengths are inches of the printed figure. Lines and letters tell everything without colour.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.present.paper.findings import PAPER

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_WIDTH = 5.7
_PIECES = 20  # of a curve between two of its points
_STYLES: dict[str, dict[str, Any]] = {
    "line": {"color": "black", "linewidth": 1.5, "markersize": 5.5, "markerfacecolor": "white"},
    "area": {"edgecolor": "black", "linewidth": 0},
    "circle": {"edgecolor": "black", "facecolor": "white", "linewidth": 1.5},
    "arrow": {"arrowstyle": "-|>", "color": "black", "linewidth": 1.5, "mutation_scale": 13},
    "label": {"ha": "center", "va": "center", "fontsize": 16, "color": "black"},
}
_GEOMETRY = ("shape", "points", "smooth", "radius", "text", "scale", "name")
_FACE: dict[str, Any] = {"family": "STIXGeneral", "math_fontfamily": "stix"}


def schematic(height: float, shapes: Iterable[Mapping[str, Any]]) -> Figure:
    """White figure, outside pyplot, of the shapes that paper.toml has of it."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(_WIDTH, height), facecolor="white")
    axes = figure.add_axes((0, 0, 1, 1), xlim=(0, _WIDTH), ylim=(0, height))
    axes.set_axis_off()
    _draw(axes, shapes, (0, 0), (1, 1), "")
    return figure


def _draw(
    axes: Axes,
    shapes: Iterable[Mapping[str, Any]],
    origin: Sequence[float],
    scale: Sequence[float],
    name: str,
) -> None:
    """Draw shapes whose points are scaled and moved to an origin; `name` is put into labels."""
    from matplotlib.patches import Circle, FancyArrowPatch
    from scipy.interpolate import CubicSpline

    for shape in shapes:
        kind = shape["shape"]
        points = np.multiply(shape["points"], scale) + origin
        style = {"clip_on": False, **_STYLES.get(kind, {})}
        style |= {key: x for key, x in shape.items() if key not in _GEOMETRY}
        if shape.get("smooth"):
            knots = np.arange(len(points))
            fine = np.linspace(0, knots[-1], _PIECES * knots[-1] + 1)
            points = CubicSpline(knots, points)(fine)
        if kind == "line":
            axes.plot(*points.T, **style)
        elif kind == "area":
            axes.fill(*points.T, **style)
        elif kind == "circle":
            axes.add_patch(Circle(points[0], shape["radius"] * scale[0], **style))
        elif kind == "arrow":
            axes.add_patch(FancyArrowPatch(*points, shrinkA=0, shrinkB=0, **style))
        elif kind == "label":
            x, y = points[0]
            axes.text(x, y, shape["text"].replace("NAME", name), **style, **_FACE)
        else:
            own = PAPER["symbols"][kind]
            _draw(axes, own, points[0], shape.get("scale", (1, 1)), shape.get("name", ""))

"""The paper's three schematics: the oscillator with a stop, the one on a belt, the Poincaré map.

Lengths are inches of the printed figure. Lines and letters tell everything without colour.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import ArrayLike

Point = tuple[float, float]

_WIDTH = 5.7
_HEAVY, _LINE, _FINE = 2.2, 1.5, 0.8  # widths in points
_BLUE, _RED = "#0072B2", "#D55E00"
_DASHES = (0, (5, 1.6))
_OUTLINE: dict[str, Any] = {"edgecolor": "black", "linewidth": _LINE, "clip_on": False}
_MASS = 0.78  # width and height of a block
_HATCH = 0.14  # thickness of the ground, and the distance of its strokes along an edge
_ORBIT, _INNER, _OUTER = 1.25, 0.9, 2.25  # radii: of the periodic orbit, and of the boundaries
_BULGE = 0.1  # of the curves between two boundaries


def schematic(height: float, shapes: Iterable[Mapping[str, Any]]) -> Figure:
    """White figure, outside pyplot, of shapes: each has the name of its function and arguments."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(_WIDTH, height), facecolor="white")
    axes = figure.add_axes((0, 0, 1, 1), xlim=(0, _WIDTH), ylim=(0, height))
    axes.set_axis_off()
    drawn: dict[str, Callable[..., None]] = {
        "arrow": _draw_arrow,
        "belt": _draw_belt,
        "ground": _draw_ground,
        "label": _write,
        "line": _draw_line,
        "maps": _draw_maps,
        "mass": _draw_mass,
        "roller": _draw_roller,
        "spring": _draw_spring,
    }
    for shape in shapes:
        drawn[shape["shape"]](axes, **{name: x for name, x in shape.items() if name != "shape"})
    return figure


def _write(axes: Axes, place: ArrayLike, text: str, offset: Point = (0, 0), **style: Any) -> None:
    """Write a formula or words around a place, or beside it by an offset."""
    shape = {"ha": "center", "va": "center", "fontsize": 16, "color": "black"}
    face = {"family": "STIXGeneral", "math_fontfamily": "stix"}
    x, y = np.add(place, offset)
    axes.text(x, y, text, **{**shape, **face, **style})


def _draw_line(axes: Axes, points: ArrayLike, **style: Any) -> None:
    """Draw a polygonal line."""
    shape = {"color": "black", "linewidth": _LINE, "linestyle": "-", "clip_on": False}
    axes.plot(*np.transpose(points), **{**shape, **style})


def _draw_arrow(axes: Axes, start: Point, end: Point, **style: Any) -> None:
    """Draw an arrow from one place to another."""
    from matplotlib.patches import FancyArrowPatch

    shape = {"arrowstyle": "-|>", "color": "black", "linewidth": _LINE, "mutation_scale": 13}
    ends = {"shrinkA": 0, "shrinkB": 0, "clip_on": False}
    axes.add_patch(FancyArrowPatch(start, end, **{**shape, **ends, **style}))


def _draw_head(axes: Axes, points: np.ndarray, color: str) -> None:
    """Draw the head of an arrow on a curve, at the second of two points."""
    _draw_arrow(axes, *points.tolist(), color=color, linewidth=0, mutation_scale=15)


def _draw_mass(axes: Axes, corner: Point, number: int) -> None:
    """Draw a block at its lower left corner, with its mass and its coordinate."""
    from matplotlib.patches import Rectangle

    axes.add_patch(Rectangle(corner, _MASS, _MASS, facecolor="0.9", **_OUTLINE))
    middle, top = corner[0] + _MASS / 2, corner[1] + _MASS
    _write(axes, (middle, corner[1] + _MASS / 2), f"$m_{number}$")
    _draw_line(axes, [(middle, top), (middle, top + 0.34)], linewidth=_FINE)
    _draw_arrow(axes, (middle, top + 0.22), (middle + 0.5, top + 0.22))
    _write(axes, (middle + 0.68, top + 0.22), f"$x_{number}$")


def _draw_spring(axes: Axes, left: float, right: float, height: float, text: str) -> None:
    """Draw a level spring with its stiffness above it."""
    lead, swing, corners = 0.12, 0.11, np.arange(13)
    x = np.linspace(left + lead, right - lead, len(corners))
    y = height + swing * np.sin(np.pi / 2 * corners)
    _draw_line(axes, [(left, height), *zip(x, y, strict=True), (right, height)])
    _write(axes, ((left + right) / 2, height + swing + 0.18), text)


def _draw_roller(axes: Axes, hub: Point, radius: float) -> None:
    """Draw a roller and its axle."""
    from matplotlib.patches import Circle

    axes.add_patch(Circle(hub, radius, facecolor="white", **_OUTLINE))
    axes.add_patch(Circle(hub, 0.12 * radius, color="black", linewidth=0, clip_on=False))


def _draw_belt(axes: Axes, hubs: Sequence[Point], radius: float) -> None:
    """Draw a belt over two rollers, which turn clockwise."""

    def arc(hub: Point, radius: float, angle: np.ndarray) -> np.ndarray:
        return np.column_stack((np.cos(angle), np.sin(angle))) * radius + hub

    turn = np.linspace(0, np.pi, 61)
    right, left = arc(hubs[1], radius, np.pi / 2 - turn), arc(hubs[0], radius, -np.pi / 2 - turn)
    _draw_line(axes, [*right, *left, right[0]], linewidth=_HEAVY)
    for hub in hubs:
        _draw_roller(axes, hub, radius - 0.05)
        sweep = arc(hub, 0.22, np.linspace(1.2 * np.pi, 0.08 * np.pi, 41))
        _draw_line(axes, sweep, linewidth=_FINE)
        _draw_head(axes, sweep[[-5, -1]], "black")


def _draw_ground(axes: Axes, face: ArrayLike, bands: Iterable[Sequence[float]]) -> None:
    """Draw the face of the ground (n, 2), and hatch the rectangles behind it.

    Each rectangle has left, right, bottom and top; strokes run on from one to the next.
    """
    _draw_line(axes, face)
    for left, right, bottom, top in bands:
        first, last = np.round(((left - top) / _HATCH, (right - bottom) / _HATCH))
        for shift in _HATCH * (np.arange(first, last) + 0.5):
            x = np.array([max(left, bottom + shift), min(right, top + shift)])
            _draw_line(axes, np.column_stack((x, x - shift)), linewidth=_FINE)


def _draw_maps(axes: Axes, centre: Point) -> None:
    """Draw a periodic orbit through all configurations, and its Poincaré map.

    The neighbouring trajectory (dashed) starts in Z and returns to the first boundary in P(Z),
    nearer to the point Z0 of the periodic orbit (solid).
    """

    def swirl(turn: Any, radius: Any) -> np.ndarray:
        """Points (n, 2) at angles clockwise from the top, on slightly bent rays."""
        turn = turn + 0.12 * (radius - _ORBIT)
        x, y = 1.1 * radius * np.sin(turn), radius * np.cos(turn)
        return np.column_stack((x, y)) + centre

    turns = np.radians([0, 66, 143, 217, 294, 360])
    distances = np.array([0.55, 0.5, 0.45, 0.4, 0.34, 0.28])  # of the trajectory from the orbit
    boundaries = ("0 = \\Sigma_n", "1", "{k{-}1}", "k", "{n{-}1}")
    for turn, boundary in zip(turns[:-1], boundaries, strict=True):
        _draw_line(axes, swirl(turn, np.linspace(_INNER, _OUTER, 41)))
        _write(axes, swirl(turn, _OUTER + 0.24)[0], f"$\\Sigma_{boundary}$")
    # without an index a configuration stands for several
    for index, ends, gaps in zip(
        ("1", "", "k", "", "n"), pairwise(turns), pairwise(distances), strict=True
    ):
        turn, gap = np.linspace(*ends, 81), np.linspace(*gaps, 81)
        orbit = _ORBIT + _BULGE * np.sin(np.linspace(0, np.pi, 81))
        for radius, color, dashes in ((orbit, _BLUE, "-"), (orbit + gap, _RED, _DASHES)):
            curve = swirl(turn, radius)
            _draw_line(axes, curve, color=color, linestyle=dashes)
            _draw_head(axes, curve[40:42], color)
        _write(axes, swirl(turn[40], _INNER + 0.2)[0], f"$\\Phi_{index}$" if index else "$\\vdots$")
        if index:
            _write(axes, swirl(turn[40], orbit[40] + gap[40] + 0.19)[0], f"$P_{index}$")
            out = np.linspace(_INNER, _OUTER, 41)
            edge = [swirl(turn, _OUTER), swirl(ends[1], out[::-1])]
            edge += [swirl(turn[::-1], _INNER), swirl(ends[0], out)]
            axes.fill(*np.vstack(edge).T, color="0.93", linewidth=0, clip_on=False, zorder=0)
    trajectory, orbit = swirl(turns, _ORBIT + distances), swirl(turns[:-1], _ORBIT)
    for points, color in ((trajectory, _RED), (orbit, _BLUE)):
        dots = {"marker": "o", "markersize": 5.5, "markerfacecolor": "white", "zorder": 3}
        _draw_line(axes, points, linestyle="none", markeredgecolor=color, **dots)
    _write(axes, trajectory[0], "$Z$", (-0.19, 0.08))
    _write(axes, trajectory[-1], "$P(Z)$", (0.36, -0.02))
    _write(axes, orbit[0], "$Z_0$", (0.2, -0.17))

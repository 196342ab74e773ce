"""The paper's three schematics: the oscillator with a stop, the one on a belt, the Poincaré map.

Lengths are inches of the printed figure. Lines and letters tell everything without colour.
"""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.core.errors import missing_extra

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import ArrayLike

__all__ = ["belt_schematic", "poincare_schematic", "stop_schematic"]

Point = tuple[float, float]

_WIDTH = 5.7
_MARGIN = 0.08
_HEAVY, _LINE, _FINE = 2.2, 1.5, 0.8  # widths in points
_LETTERS = 16.0  # points
_WORDS = 14.0  # points
_BLUE, _RED = "#0072B2", "#D55E00"
_DASHES = (0, (5, 1.6))
_OUTLINE: dict[str, Any] = {"edgecolor": "black", "linewidth": _LINE, "clip_on": False}
_MASS = 0.78  # width and height of a block
_HATCH = 0.14  # thickness of the ground, and the distance of its strokes along an edge

_CENTRE = (_WIDTH / 2, 2.66)  # of the phase space
_ORBIT, _INNER, _OUTER = 1.25, 0.9, 2.25  # radii: of the periodic orbit, and of the boundaries
_BULGE = 0.1  # of the curves between two boundaries


def stop_schematic() -> Figure:
    """Figure of the two masses with a stop, Fig. 1 of the paper, outside pyplot.

    From the left: the ground, k2, m2, k1, m1, and the stop, which is held by k3 at the
    clearance 1 from the first mass.
    """
    figure, axes = _canvas(1.62)
    left, floor, top = _MARGIN + _HATCH, _MARGIN + _HATCH, 1.54
    right, radius = _WIDTH - left, 0.075
    _draw_ground(
        axes,
        [(left, top), (left, floor), (right, floor), (right, top)],
        (_MARGIN, left, _MARGIN, top),
        (left, right, _MARGIN, floor),
        (right, _WIDTH - _MARGIN, _MARGIN, top),
    )
    bottom = floor + 2 * radius
    middle = bottom + _MASS / 2
    second, first, stop = 1.16, 2.90, 4.32
    for number, place in ((2, second), (1, first)):
        for share in (0.22, 0.78):
            _draw_roller(axes, (place + share * _MASS, floor + radius), radius)
        _draw_mass(axes, (place, bottom), number)
    _draw_spring(axes, left, second, middle, "$k_2$")
    _draw_spring(axes, second + _MASS, first, middle, "$k_1$")
    _draw_spring(axes, stop, right, middle, "$k_3$")
    _draw_line(axes, [(stop, middle - 0.3), (stop, middle + 0.3)], linewidth=2 * _HEAVY)
    face, near = first + _MASS, stop - 0.03
    _draw_arrow(axes, (face, middle), (near, middle), arrowstyle="<|-|>", linewidth=_FINE)
    _write(axes, ((face + near) / 2, middle + 0.18), "$1$")
    return figure


def belt_schematic() -> Figure:
    """Figure of the two masses on a driving belt, Fig. 6 of the paper, outside pyplot.

    From the left: the ground, k1, m1, k2, m2. The friction forces are those on the masses,
    positive along the belt's velocity.
    """
    figure, axes = _canvas(2.24)
    radius, left = 0.42, _MARGIN + _HATCH
    axle = _MARGIN + 0.02 + radius
    belt, hubs = axle + radius, ((left + 0.3 + radius, axle), (_WIDTH - axle, axle))
    turn = np.linspace(0, np.pi, 61)
    ends = (_arc(hubs[1], radius, np.pi / 2 - turn), _arc(hubs[0], radius, -np.pi / 2 - turn))
    _draw_line(axes, [*ends[0], *ends[1], ends[0][0]], linewidth=_HEAVY)
    for hub in hubs:
        _draw_roller(axes, hub, radius - 0.05)
        sweep = _arc(hub, 0.22, np.linspace(1.2 * np.pi, 0.08 * np.pi, 41))
        _draw_line(axes, sweep, linewidth=_FINE)
        _draw_head(axes, sweep[[-5, -1]], "black")
    _draw_arrow(axes, (2.55, belt - 0.27), (3.3, belt - 0.27))
    _write(axes, (3.47, belt - 0.27), "$V$")
    first, second, bottom = 1.42, 3.48, belt + 0.02
    top, middle = bottom + _MASS, bottom + 0.62 * _MASS
    _draw_ground(axes, [(left, belt), (left, top)], (_MARGIN, left, belt, top))
    for number, place in ((1, first), (2, second)):
        _draw_mass(axes, (place, bottom), number)
        tail, level = place + _MASS, bottom + 0.1
        _draw_arrow(axes, (tail, level), (tail + 0.5, level), color=_RED, linewidth=_HEAVY)
        _write(axes, (tail + 0.68, level + 0.03), f"$F_{number}$")
    _draw_spring(axes, left, first, middle, "$k_1$")
    _draw_spring(axes, first + _MASS, second, middle, "$k_2$")
    return figure


def poincare_schematic() -> Figure:
    """Figure of a periodic orbit through all configurations and its Poincaré map, Fig. 11.

    The neighbouring trajectory (dashed) starts in Z and returns to the first boundary in
    P(Z), nearer to the point Z0 of the periodic orbit (solid). The figure is outside
    pyplot.
    """
    figure, axes = _canvas(5.37)
    turns = np.radians([0, 66, 143, 217, 294, 360])
    distances = np.array([0.55, 0.5, 0.45, 0.4, 0.34, 0.28])  # of the trajectory from the orbit
    boundaries = ("0 = \\Sigma_n", "1", "{k{-}1}", "k", "{n{-}1}")
    for turn, boundary in zip(turns[:-1], boundaries, strict=True):
        _draw_line(axes, _swirl(turn, np.linspace(_INNER, _OUTER, 41)))
        _write(axes, _swirl(turn, _OUTER + 0.24)[0], f"$\\Sigma_{boundary}$")
    stages = zip(("1", "", "k", "", "n"), pairwise(turns), pairwise(distances), strict=True)
    for stage, ends, gaps in stages:
        _draw_stage(axes, stage, ends, gaps)
    start, image = _draw_points(axes, _swirl(turns, _ORBIT + distances), _RED)[[0, -1]]
    fixed = _draw_points(axes, _swirl(turns[:-1], _ORBIT), _BLUE)[0]
    _write(axes, start, "$Z$", (-0.19, 0.08))
    _write(axes, image, "$P(Z)$", (0.36, -0.02))
    _write(axes, fixed, "$Z_0$", (0.2, -0.17))
    _write(axes, _CENTRE, "$P = P_n \\circ \\cdots \\circ P_1$")
    _draw_key(axes, 0.5, "periodic orbit", _BLUE, "-")
    _draw_key(axes, 2.6, "neighbouring trajectory", _RED, _DASHES)
    return figure


def _draw_stage(axes: Axes, stage: str, ends: Point, gaps: Point) -> None:
    """Draw both motions through one configuration; without a name it stands for several.

    `stage` is the index of the configuration and of the local map, and may be empty. `ends`
    are the angles, in radians, of the boundaries before and behind it, and `gaps` the
    distances of the trajectory from the orbit there.
    """
    turn, gap = np.linspace(*ends, 81), np.linspace(*gaps, 81)
    orbit = _ORBIT + _BULGE * np.sin(np.linspace(0, np.pi, 81))
    for radius, color, dashes in ((orbit, _BLUE, "-"), (orbit + gap, _RED, _DASHES)):
        curve = _swirl(turn, radius)
        _draw_line(axes, curve, color=color, linestyle=dashes)
        _draw_head(axes, curve[40:42], color)
    name, place = f"$\\Phi_{stage}$", _swirl(turn[40], _INNER + 0.2)[0]
    _write(axes, place, name if stage else "$\\vdots$")
    if stage:
        _write(axes, _swirl(turn[40], orbit[40] + gap[40] + 0.19)[0], f"$P_{stage}$")
        edge = [_swirl(turn, _OUTER), _swirl(ends[1], np.linspace(_OUTER, _INNER, 41))]
        edge += [_swirl(turn[::-1], _INNER), _swirl(ends[0], np.linspace(_INNER, _OUTER, 41))]
        axes.fill(*np.vstack(edge).T, color="0.93", linewidth=0, clip_on=False, zorder=0)


def _swirl(turn: Any, radius: Any) -> np.ndarray:
    """Points (n, 2) of the phase space at angles clockwise from the top, on slightly bent rays."""
    turn = turn + 0.12 * (radius - _ORBIT)
    x, y = 1.1 * radius * np.sin(turn), radius * np.cos(turn)
    return np.column_stack((x, y)) + _CENTRE


def _canvas(height: float) -> tuple[Figure, Axes]:
    """Open a white figure whose coordinates are inches."""
    try:
        from matplotlib.figure import Figure
    except ImportError:
        raise missing_extra("plot", "matplotlib") from None
    figure = Figure(figsize=(_WIDTH, height), facecolor="white")
    axes = figure.add_axes((0, 0, 1, 1), xlim=(0, _WIDTH), ylim=(0, height))
    axes.set_axis_off()
    return figure, axes


def _write(axes: Axes, place: ArrayLike, text: str, offset: Point = (0, 0), **style: Any) -> None:
    """Write a formula or words around a place, or beside it by an offset."""
    shape = {"ha": "center", "va": "center", "fontsize": _LETTERS, "color": "black"}
    face = {"family": "STIXGeneral", "math_fontfamily": "stix"}
    x, y = np.add(place, offset)
    axes.text(x, y, text, **{**shape, **face, **style})


def _draw_line(axes: Axes, points: ArrayLike, **style: Any) -> None:
    """Draw a polygonal line."""
    shape = {"color": "black", "linewidth": _LINE, "linestyle": "-", "clip_on": False}
    axes.plot(*np.transpose(points), **{**shape, **style})


def _draw_points(axes: Axes, points: np.ndarray, color: str) -> np.ndarray:
    """Mark points by small circles, and return them."""
    shape = {"marker": "o", "markersize": 5.5, "markerfacecolor": "white", "zorder": 3}
    _draw_line(axes, points, linestyle="none", markeredgecolor=color, **shape)
    return points


def _draw_arrow(axes: Axes, start: Point, end: Point, **style: Any) -> None:
    """Draw an arrow from one place to another."""
    from matplotlib.patches import FancyArrowPatch

    shape = {"arrowstyle": "-|>", "color": "black", "linewidth": _LINE, "mutation_scale": 13}
    ends = {"shrinkA": 0, "shrinkB": 0, "clip_on": False}
    axes.add_patch(FancyArrowPatch(start, end, **{**shape, **ends, **style}))


def _draw_head(axes: Axes, points: np.ndarray, color: str) -> None:
    """Draw the head of an arrow on a curve, at the second of two points."""
    start, end = points.tolist()
    _draw_arrow(axes, start, end, color=color, linewidth=0, mutation_scale=15)


def _draw_key(axes: Axes, left: float, text: str, color: str, dashes: Any) -> None:
    """Explain a line in words at the foot of the figure."""
    height = 0.17
    line = [(left, height), (left + 0.45, height)]
    _draw_line(axes, line, color=color, linestyle=dashes)
    _write(axes, (left + 0.55, height), text, ha="left", fontsize=_WORDS)


def _draw_mass(axes: Axes, corner: Point, number: int) -> None:
    """Draw a block at its lower left corner, with its mass and its coordinate."""
    from matplotlib.patches import Rectangle

    left, bottom = corner
    axes.add_patch(Rectangle(corner, _MASS, _MASS, facecolor="0.9", **_OUTLINE))
    middle, top = left + _MASS / 2, bottom + _MASS
    _write(axes, (middle, bottom + _MASS / 2), f"$m_{number}$")
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


def _draw_ground(axes: Axes, face: ArrayLike, *bands: tuple[float, float, float, float]) -> None:
    """Draw the face of the ground (n, 2), and hatch the rectangles behind it.

    Each rectangle has left, right, bottom and top; strokes run on from one to the next.
    """
    _draw_line(axes, face)
    for left, right, bottom, top in bands:
        first, last = np.round(((left - top) / _HATCH, (right - bottom) / _HATCH))
        for shift in _HATCH * (np.arange(first, last) + 0.5):
            x = np.array([max(left, bottom + shift), min(right, top + shift)])
            _draw_line(axes, np.column_stack((x, x - shift)), linewidth=_FINE)


def _arc(hub: Point, radius: float, angle: np.ndarray) -> np.ndarray:
    """Points of a circle at given angles."""
    return np.column_stack((np.cos(angle), np.sin(angle))) * radius + hub

"""Pictures of graphs of boxes: where motions recur, what they do not leave, Morse graphs."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.model.naming import shown_name, units_of
from nonsmooth.runtime.present.pictures.drawing import drawn_alone, finish
from nonsmooth.runtime.proof.sets.graph_certificate import RegionCertificate

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["draw_graph"]

_COLORS = ("#CC3311", "#0077BB", "#EE7733", "#009988", "#EE3377", "#AA3377", "#332288")
_TRAPPING, _UNKNOWN, _IMAGES, _SMALL = "#D5E8D4", "#555555", "#8899AA", "#BBAA44"
_SHOWN = 7  # components with a colour and a vertex of their own


def draw_graph(found: RegionCertificate, axes: Any = None) -> Figure | Axes:
    """Draw the boxes of the components over the largest trapping region, and the Morse graph.

    With one coordinate, the graph of the map is drawn: each box against the boxes that its
    image may meet. Axes that are given receive the boxes without the Morse graph, and are
    returned; else a new figure is. A section of more than two coordinates raises
    `InputError`.
    """
    if len(found.coordinates) > 2:
        raise InputError("boxes of a section of more than two coordinates have no picture")

    def compose(figure: Figure) -> None:
        left, right = figure.subplots(1, 2, width_ratios=[1.9, 1])
        _draw_boxes(left, found)
        _draw_morse(right, found)

    drawn: Figure | Axes = drawn_alone(
        "boxes", (9.6, 5.4), lambda own: _draw_boxes(own, found), axes, compose
    )
    return drawn


def _color(number: int) -> str:
    return _COLORS[number] if number < _SHOWN else _SMALL


def _draw_boxes(axes: Axes, found: RegionCertificate) -> None:
    flat, units = len(found.coordinates) == 1, units_of(found.system)
    region = [found.region[name] for name in found.coordinates]
    graph = found.graph
    _fill(axes, found, found.trapping, _TRAPPING, f"trapping region, {len(found.trapping)} boxes")
    if flat:
        _corners(axes, graph, graph.sources, graph.targets, _IMAGES)
    if len(found.unknown):
        _fill(axes, found, found.unknown, _UNKNOWN, f"image not known, {len(found.unknown)} boxes")
    for number, own in reversed([*enumerate(found.components)]):
        told = "attracting" if own.attracting else "recurrent"
        label = f"{number}: {told}, {len(own.boxes)} boxes" if number < _SHOWN else None
        if flat:
            inner = np.isin(graph.sources, own.boxes)
            edges = graph.sources[inner], graph.targets[inner]
            _corners(axes, graph, *edges, _color(number), label)
        else:
            _fill(axes, found, own.boxes, _color(number), label)
    axes.set_xlim(*region[0])
    axes.set_xlabel(units.label(found.coordinates[0]))
    if flat:
        axes.plot(region[0], region[0], color="0.3", linewidth=0.6, linestyle=":")
        axes.set_ylim(*region[0])
        axes.set_ylabel(f"{units.label(found.coordinates[0])} at the next return")
    else:
        axes.set_ylim(*region[1])
        axes.set_ylabel(units.label(found.coordinates[1]))
    finish(axes, shown_name(found.system))


def _fill(
    axes: Axes, found: RegionCertificate, boxes: NDArray[np.int_], color: str, label: str | None
) -> None:
    """Draw boxes; with one coordinate they are strips of the whole height."""
    if not len(boxes):
        return
    low, high = found.graph.grid.bounds(boxes)
    if len(found.coordinates) == 1:
        ends = np.array([found.region[found.coordinates[0]]] * len(boxes))
        low, high = np.hstack([low, ends[:, :1]]), np.hstack([high, ends[:, 1:]])
    _add(axes, low, high, color, label)


def _corners(
    axes: Axes, graph: Any, sources: Any, targets: Any, color: str, label: str | None = None
) -> None:
    """Draw boxes of one coordinate against those that their images may meet, in the plane."""
    (low, high), (below, above) = graph.grid.bounds(sources), graph.grid.bounds(targets)
    _add(axes, np.hstack([low, below]), np.hstack([high, above]), color, label)


def _add(axes: Axes, low: Any, high: Any, color: str, label: str | None) -> None:
    from matplotlib.collections import PolyCollection

    (left, right), (bottom, top) = (low[:, 0], high[:, 0]), (low[:, 1], high[:, 1])
    x = np.column_stack([left, right, right, left])
    y = np.column_stack([bottom, bottom, top, top])
    corners = np.stack([x, y], axis=2)
    own = PolyCollection(list(corners), facecolors=color, edgecolors=color, linewidths=0.8)
    own.set_rasterized(len(corners) > 2000)
    axes.add_collection(own)
    if label:
        axes.fill([], [], color=color, label=label)


def _arrows(found: RegionCertificate, count: int) -> list[tuple[int, int]]:
    """Arrows of the Morse graph of the first components, without those that others imply.

    A path through components that are left out counts as an arrow.
    """
    size = len(found.components)
    reaches = np.zeros((size, size), dtype=bool)
    for i, j in found.arrows:
        reaches[i, j] = True
    while (more := reaches | (reaches.astype(int) @ reaches > 0)).sum() > reaches.sum():
        reaches = more
    own = reaches[:count, :count]
    direct = own & ~(own.astype(int) @ own > 0)
    return [(int(i), int(j)) for i, j in np.argwhere(direct)]


def _draw_morse(axes: Axes, found: RegionCertificate) -> None:
    """Draw the first components in levels, so that all arrows of the Morse graph point down."""
    from matplotlib.patches import FancyArrowPatch

    count = min(len(found.components), _SHOWN)
    arrows = _arrows(found, count)
    level = [0] * count
    for _ in range(count):
        for i, j in arrows:
            level[i] = max(level[i], level[j] + 1)
    rows = {h: [k for k in range(count) if level[k] == h] for h in set(level)}
    places = {
        k: ((place + 1) / (len(row) + 1), float(h))
        for h, row in rows.items()
        for place, k in enumerate(row)
    }
    for i, j in arrows:
        axes.add_patch(
            FancyArrowPatch(
                places[i],
                places[j],
                arrowstyle="-|>",
                mutation_scale=14,
                shrinkA=14,
                shrinkB=14,
                color="0.4",
            )
        )
    for k, place in places.items():
        own = found.components[k]
        edge = "black" if own.attracting else "none"
        axes.plot(*place, "o", color=_color(k), markeredgecolor=edge, markersize=22)
        axes.annotate(str(k), place, ha="center", va="center", color="white")
    rest = len(found.components) - count
    told = "Morse graph" if not rest else f"Morse graph, without {rest} small components"
    axes.set_title(told, fontsize="medium")
    axes.set_xlim(0, 1)
    axes.set_ylim(-0.6, max(level, default=0) + 0.6)
    axes.set_axis_off()

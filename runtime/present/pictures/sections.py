"""Pictures of what is proved on a section: basins, chaos, and graphs of boxes.

Axes that are given receive what is on the section, and are returned. Else a new figure is; it
has more beside that. A section of more than two coordinates raises `InputError`.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from nonsmooth.runtime.core.box_grid import BoxGrid
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.model.naming import shown_name, units_of
from nonsmooth.runtime.present.pictures.drawing import drawn_alone, finish
from nonsmooth.runtime.proof.chaos.chaos_certificate import ChaosCertificate
from nonsmooth.runtime.proof.sets.basin_certificate import BasinCertificate
from nonsmooth.runtime.proof.sets.graph_certificate import RegionCertificate

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_COLORS = ("#CC3311", "#0077BB", "#EE7733", "#009988", "#EE3377", "#AA3377", "#332288")
_TRAPPING, _UNKNOWN, _IMAGES, _SMALL = "#D5E8D4", "#555555", "#8899AA", "#BBAA44"
_SHOWN = 7  # components with a colour and a vertex of their own
_AROUND = 2.5  # sets are shown with so much about them, in units of their extent
_MANY = 2000  # boxes, which are drawn as an image


def draw_basin(found: BasinCertificate, axes: Any = None) -> Any:
    """Draw what is proved of a basin: the section's boxes, coloured by their ranks.

    A figure has below the section, over two states each, the share of the examined tiles that is
    proved to be attracted. `InputError` is raised if nothing is proved.
    """
    _check_proved(found)
    grid, tiled = _drawable(found.grid), int(found.looked.any())
    pairs = [(k, k + 1) for k in range(0, tiled * len(found.states) - 1, 2)]

    def compose(figure: Figure) -> None:
        figure.suptitle(f"{shown_name(found.orbit)}: proved to attract", fontsize="medium")
        if not pairs:
            _draw_ranks(figure.add_subplot(), found, grid)
            return
        places = figure.add_gridspec(2, len(pairs), height_ratios=[1, 3])
        _draw_ranks(figure.add_subplot(places[0, :]), found, grid)
        for place, pair in enumerate(pairs):
            _draw_tiles(figure.add_subplot(places[1, place]), found, pair)

    size = (9.6, 5.4 if pairs else 4.8)
    return drawn_alone("basin", size, lambda own: _draw_ranks(own, found, grid), axes, compose)


def draw_chaos(found: ChaosCertificate, axes: Any = None) -> Any:
    """Draw the h-sets, the enclosures of their images, and beside them the graph of coverings.

    `InputError` is raised if nothing is proved.
    """
    _check_proved(found)
    _check_plane(found.coordinates)

    def compose(figure: Figure) -> None:
        left, right = figure.subplots(1, 2, width_ratios=[1.7, 1])
        _draw_sets(left, found)
        _draw_coverings(right, found)

    return drawn_alone("sets", (9.6, 5.0), lambda own: _draw_sets(own, found), axes, compose)


def draw_graph(found: RegionCertificate, axes: Any = None) -> Any:
    """Draw the boxes of the components over the largest trapping region, and the Morse graph.

    With one coordinate, the graph of the map is drawn: each box against the boxes that its
    image may meet.
    """
    _check_plane(found.coordinates)

    def compose(figure: Figure) -> None:
        left, right = figure.subplots(1, 2, width_ratios=[1.9, 1])
        _draw_boxes(left, found)
        _draw_morse(right, found)

    return drawn_alone("boxes", (9.6, 5.4), lambda own: _draw_boxes(own, found), axes, compose)


def _check_proved(found: BasinCertificate | ChaosCertificate) -> None:
    if not found.proved:
        raise InputError(f"there is nothing to draw: {found.reason}")


def _check_plane(coordinates: Sequence[object]) -> None:
    if len(coordinates) > 2:
        raise InputError("a section of more than two coordinates has no picture")


def _drawable(grid: BoxGrid | None) -> BoxGrid:
    assert grid is not None  # of what is proved
    _check_plane(grid.counts)
    return grid


# --- basins


def _edges(grid: BoxGrid, place: int) -> np.ndarray:
    found: np.ndarray = (grid.first[place] + np.arange(grid.counts[place] + 1)) * grid.sides[place]
    return found


def _draw_ranks(axes: Axes, found: BasinCertificate, grid: BoxGrid) -> None:
    """Draw the boxes of the section, coloured by how many steps lead to the core."""
    ranks = np.where(found.ranks >= 0, found.ranks, np.nan).reshape(grid.counts)
    edges = [_edges(grid, place) for place in range(len(grid.counts))]
    if len(edges) == 1:
        edges.append(np.array([0, 1]))
        ranks = ranks[:, None]
        axes.set_yticks([])
        inside = np.flatnonzero(found.ranks >= 0)
        if len(inside):
            low, high = edges[0][inside[0]], edges[0][inside[-1] + 1]
            margin = 0.05 * (high - low)
            axes.set_xlim(low - margin, high + margin)
    axes.pcolormesh(*edges, ranks.T, cmap="viridis", rasterized=True)
    _label(axes, found)
    finish(axes, "the section: steps to the core")


def _draw_tiles(axes: Axes, found: BasinCertificate, pair: tuple[int, int]) -> None:
    """Draw over two states the share of the examined tiles that is attracted."""
    grid = found.tiles
    assert grid is not None
    others = tuple(k for k in range(len(grid.counts)) if k not in pair)
    looked, good = (
        tiles.reshape(grid.counts).sum(axis=others) for tiles in (found.looked, found.attracted)
    )
    with np.errstate(invalid="ignore"):
        share = np.where(looked > 0, good / looked, np.nan)
    edges = [_edges(grid, place) for place in pair]
    mesh = axes.pcolormesh(*edges, share.T, cmap="Blues", vmin=0, vmax=1, rasterized=True)
    units = units_of(found.system)
    labels = [units.label(found.states[place]) for place in pair]
    finish(axes, "share of the tiles that were looked at", *labels)
    axes.figure.colorbar(mesh, ax=axes)


# --- chaos


def _draw_sets(axes: Axes, found: ChaosCertificate) -> None:
    """Draw h-sets, and what holds their images."""
    flat = len(found.coordinates) == 1
    corners = [h_set.corners for h_set in found.h_sets]
    for number, (h_set, own) in enumerate(zip(found.h_sets, corners, strict=True)):
        color = _COLORS[number % len(_COLORS)]
        parts = found.images.get(h_set.name, ())
        if flat:
            low, high = own.min(), own.max()
            axes.plot([low, high], [0, 0], color=color, linewidth=7, solid_capstyle="butt")
            place, offset = ((low + high) / 2, 0), -14
            if parts:
                ends = [min(low for (low,), _ in parts), max(high for _, (high,) in parts)]
                label = f"image of {h_set.name}"
                axes.plot(ends, 2 * [number + 1], color=color, linewidth=2, label=label)
        else:
            axes.fill(*own.T, facecolor=color, alpha=0.35, edgecolor=color, linewidth=1.5)
            place, offset = own[np.argmax(own[:, 1])], 3
            _add(axes, [np.array(part) for part in parts], "none", color, 0.4)
        text: dict[str, Any] = {"textcoords": "offset points", "ha": "center", "color": color}
        axes.annotate(h_set.name, place, (0, offset), **text)
    every = np.concatenate(corners)
    middle, half = every.mean(axis=0), _AROUND * np.ptp(every, axis=0) / 2
    axes.set_xlim(middle[0] - half[0], middle[0] + half[0])
    if flat:
        axes.set_yticks([])
        axes.set_ylim(-1, len(found.h_sets) + 1)
    else:
        axes.set_ylim(middle[1] - half[1], middle[1] + half[1])
    _label(axes, found)
    shown = found.images and found.iterates > 1  # a file holds no images
    power = f", images under P^{found.iterates}" if shown else ""
    finish(axes, f"{shown_name(found.system)}{power}")


def _draw_coverings(axes: Axes, found: ChaosCertificate) -> None:
    """Draw the graph of coverings: vertices on a circle, and an arrow for each covering."""
    from matplotlib.patches import Circle

    names = [h_set.name for h_set in found.h_sets]
    angles = np.pi / 2 - 2 * np.pi * np.arange(len(names)) / len(names)
    places = dict(zip(names, zip(np.cos(angles), np.sin(angles), strict=True), strict=True))
    for name, (x, y) in places.items():
        if (name, name) in found.coverings:
            axes.add_patch(Circle((1.28 * x, 1.28 * y), 0.2, fill=False, edgecolor="0.4"))
    arrows = [(one, other) for one, other in found.coverings if one != other]
    _draw_arrows(axes, places, arrows, bend=0.18)
    for number, (name, place) in enumerate(places.items()):
        color = _COLORS[number % len(_COLORS)]
        axes.add_patch(Circle(place, 0.15, facecolor=color, edgecolor="none", zorder=3))
        axes.annotate(name, place, ha="center", va="center", color="white", zorder=4)
    axes.set_xlim(-1.7, 1.7)
    axes.set_ylim(-1.7, 1.7)
    axes.set_aspect("equal")
    axes.set_axis_off()
    axes.set_title(f"entropy of P at least {float(found.entropy):.4g}", fontsize="medium")


# --- graphs of boxes


def _color(number: int) -> str:
    return _COLORS[number] if number < _SHOWN else _SMALL


def _draw_boxes(axes: Axes, found: RegionCertificate) -> None:
    flat = len(found.coordinates) == 1
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
    axes.set_ylim(*region[-1])
    _label(axes, found)
    if flat:
        axes.plot(region[0], region[0], color="0.3", linewidth=0.6, linestyle=":")
        axes.set_ylabel(f"{axes.get_xlabel()} at the next return")
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
    _add_boxes(axes, low, high, color, label)


def _corners(
    axes: Axes, graph: Any, sources: Any, targets: Any, color: str, label: str | None = None
) -> None:
    """Draw boxes of one coordinate against those that their images may meet, in the plane."""
    (low, high), (below, above) = graph.grid.bounds(sources), graph.grid.bounds(targets)
    _add_boxes(axes, np.hstack([low, below]), np.hstack([high, above]), color, label)


def _add_boxes(axes: Axes, low: Any, high: Any, color: str, label: str | None) -> None:
    (left, right), (bottom, top) = (low[:, 0], high[:, 0]), (low[:, 1], high[:, 1])
    x = np.column_stack([left, right, right, left])
    y = np.column_stack([bottom, bottom, top, top])
    _add(axes, list(np.stack([x, y], axis=2)), color, color, 0.8)
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
    _draw_arrows(axes, places, arrows)
    for k, place in places.items():
        edge = "black" if found.components[k].attracting else "none"
        axes.plot(*place, "o", color=_color(k), markeredgecolor=edge, markersize=22)
        axes.annotate(str(k), place, ha="center", va="center", color="white")
    rest = len(found.components) - count
    told = "Morse graph" if not rest else f"Morse graph, without {rest} small components"
    axes.set_title(told, fontsize="medium")
    axes.set_xlim(0, 1)
    axes.set_ylim(-0.6, max(level, default=0) + 0.6)
    axes.set_axis_off()


# --- of several


def _label(axes: Axes, found: BasinCertificate | ChaosCertificate | RegionCertificate) -> None:
    """Name the axes by the section's coordinates."""
    units = units_of(found.system)
    axes.set_xlabel(units.label(found.coordinates[0]))
    if len(found.coordinates) == 2:
        axes.set_ylabel(units.label(found.coordinates[1]))


def _add(
    axes: Axes, polygons: Sequence[np.ndarray], face: str, edge: str, linewidth: float
) -> None:
    from matplotlib.collections import PolyCollection

    own = PolyCollection(polygons, facecolors=face, edgecolors=edge, linewidths=linewidth)
    own.set_rasterized(len(polygons) > _MANY)
    axes.add_collection(own)


def _draw_arrows(
    axes: Axes,
    places: Mapping[Any, tuple[float, float]],
    arrows: Iterable[tuple[Any, Any]],
    bend: float = 0.0,
) -> None:
    """Draw arrows between vertices, which lie at places by their names."""
    from matplotlib.patches import FancyArrowPatch

    style: dict[str, Any] = {"arrowstyle": "-|>", "mutation_scale": 14, "color": "0.4"}
    style |= {"shrinkA": 15, "shrinkB": 15, "connectionstyle": f"arc3,rad={bend}"}
    for one, other in arrows:
        axes.add_patch(FancyArrowPatch(places[one], places[other], **style))

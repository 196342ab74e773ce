"""Pictures of charts: a labelled map with its boundaries drawn, or a line."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.explore.charting.classes import Part, parts_of, title_of
from nonsmooth.runtime.model.naming import symbol, with_unit
from nonsmooth.runtime.present.pictures.drawing import (
    SHADES,
    drawn_alone,
    finish,
    shaded,
    widen,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from xarray import Dataset

_MOST = 800  # points along an axis: a picture shows no more
_LEAST_LABEL = 0.05  # width of a part that bears its label, in units of the map's
# Tol's schemes "vibrant" and "muted"; what is no motion is grey, darker for each limit
_COLORS = {
    "stable": ("#0077BB",),
    "neutral": ("#33BBEE",),
    "unstable": ("#EE7733",),
    "admissible": ("#009988",),
    "limit": ("#DDDDDD", "#BBBBBB", "#999999", "#777777", "#555555", "#333333"),
    "none": ("#FFFFFF",),
    "missing": ("#FFF3B0",),
    "periodic": (
        *("#332288", "#DDCC77", "#117733", "#88CCEE", "#882255"),
        *("#CC6677", "#AA4499", "#999933"),
    ),
    "rest": ("#44AA99",),
    "other": ("#DDDDDD",),
}


def chart_figure(chart: Dataset) -> Figure:
    """Figure, outside pyplot, of a chart of one or two parameters.

    The chart is that of `chart` or `load_chart`; its method `isel` gives one plane of a
    larger one. `InputError` is raised for another dataset, or for more than two dimensions
    of more than one value.
    """
    chart = chart.squeeze()
    names = [str(name) for name in chart.sizes]
    if not names:
        raise InputError("a chart of one point has no picture: give more values")
    if len(names) > 2:
        raise InputError(
            f"a chart of {len(names)} parameters is drawn one plane at a time: chart it with one"
            " value of each of the others"
        )
    thin = chart.isel({name: slice(None, None, -(-n // _MOST)) for name, n in chart.sizes.items()})
    thin = thin.load()
    parts = [part for part in parts_of(thin) if part.where.any()]
    drawn: Figure = drawn_alone("chart", (7.2, 5.6), lambda axes: _draw(axes, thin, parts))
    return drawn


def _draw(axes: Axes, chart: Dataset, parts: list[Part]) -> None:
    colors = _colors(parts)
    (_draw_map if len(chart.sizes) == 2 else _draw_line)(axes, chart, parts, colors)
    for part, color in zip(parts, colors, strict=True):
        share = f"{100 * float(part.where.mean()):.1f} %"
        axes.fill_between([], [], facecolor=color, edgecolor="0.2", label=f"{part.name} ({share})")
    finish(axes, title_of(chart))


def _colors(parts: list[Part]) -> list[str]:
    """Colours of the parts; raises `InputError` if more of a kind than can be told apart."""
    found: list[str] = []
    used = dict.fromkeys(_COLORS, 0)
    for part in parts:
        choice, count = _COLORS[part.kind], used[part.kind]
        if count == SHADES * len(choice):
            raise InputError(f"more than {count} parts like {part.name}: they look alike")
        found.append(shaded(choice, count))
        used[part.kind] += 1
    return found


def _draw_map(axes: Axes, chart: Dataset, parts: list[Part], colors: list[str]) -> None:
    across, up = map(str, chart.sizes)
    x, y = chart[across].values, chart[up].values
    _draw_cells(axes, x, y, parts, colors)
    for part, color in zip(parts, colors, strict=True):
        _label(axes, x, y, part, color)
    axes.set_xlabel(_named(chart, across))
    axes.set_ylabel(_named(chart, up))


def _draw_cells(
    axes: Axes, x: np.ndarray, y: np.ndarray, parts: list[Part], colors: list[str]
) -> None:
    """Draw cells around x (n,) and y (m,): parts (n, m) or (n,) have colours and outlines."""
    from matplotlib.collections import LineCollection
    from matplotlib.colors import ListedColormap

    labels = np.zeros(parts[0].where.shape, dtype=int)
    for number, part in enumerate(parts):
        labels[part.where] = number
    labels = np.broadcast_to(labels.reshape(len(x), -1), (len(x), len(y)))
    axes.pcolormesh(
        x,
        y,
        labels.T,
        shading="nearest",
        cmap=ListedColormap(colors),
        vmin=-0.5,
        vmax=len(parts) - 0.5,
        rasterized=True,
    )
    axes.add_collection(LineCollection(list(_outlines(labels, x, y)), colors="0.1", linewidths=0.7))


def _outlines(labels: np.ndarray, x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """Sides (n, 2, 2) between neighbouring cells that belong to different parts."""
    corners = np.stack(np.meshgrid(_sides(x), _sides(y), indexing="ij"), axis=-1)
    i, j = np.nonzero(labels[1:] != labels[:-1])
    upright = np.stack([corners[i + 1, j], corners[i + 1, j + 1]], axis=1)
    i, j = np.nonzero(labels[:, 1:] != labels[:, :-1])
    level = np.stack([corners[i, j + 1], corners[i + 1, j + 1]], axis=1)
    return np.concatenate([upright, level])


def _sides(values: np.ndarray) -> np.ndarray:
    """Edges (n + 1,) of cells (n,), halfway between their values."""
    middles = (values[1:] + values[:-1]) / 2
    first, last = 2 * values[0] - middles[0], 2 * values[-1] - middles[-1]
    return np.concatenate([[first], middles, [last]])


def _label(axes: Axes, x: np.ndarray, y: np.ndarray, part: Part, color: str) -> None:
    """Write a part's name where the part is widest, if it is wide enough."""
    from matplotlib.patheffects import withStroke
    from scipy.ndimage import distance_transform_edt

    inside = np.pad(part.where, 1)
    room = np.asarray(distance_transform_edt(inside))[1:-1, 1:-1]
    i, j = np.unravel_index(int(room.argmax()), room.shape)
    if room[i, j] < _LEAST_LABEL * max(room.shape):
        return
    name = part.name.partition(": ")[0]
    if part.kind == "periodic":
        name = name.partition(" transitions")[0].partition(",")[0]
    dark = sum(int(color[k : k + 2], 16) for k in (1, 3, 5)) < 384
    ink, halo = ("white", "black") if dark else ("black", "white")
    place: dict[str, Any] = {"ha": "center", "va": "center", "fontsize": "small", "color": ink}
    axes.text(
        float(x[i]),
        float(y[j]),
        name,
        path_effects=[withStroke(linewidth=1.5, foreground=halo)],
        clip_on=True,
        **place,
    )


def _draw_line(axes: Axes, chart: Dataset, parts: list[Part], colors: list[str]) -> None:
    (name,) = map(str, chart.sizes)
    x = chart[name].values
    axes.set_xlabel(_named(chart, name))
    shown = next((name for name in ("trace", "period") if name in chart), None)
    if shown is None:  # basins, which have names alone
        _draw_cells(axes, x, np.arange(2.0), parts, colors)
        axes.set_yticks([])
        return
    y = chart[shown].values
    for part, color in zip(parts, colors, strict=True):
        edge = color if color != "#FFFFFF" else "0.2"
        axes.plot(x[part.where], y[part.where], ".", color=edge, markersize=3)
    if shown == "trace":
        for level in (-1.0, 1.0):
            axes.axhline(level, color="0.3", linewidth=0.9, linestyle=":")
    widen(axes)
    axes.set_ylabel(with_unit(shown, str(chart[shown].attrs.get("units", ""))))


def _named(chart: Dataset, name: str) -> str:
    text = f"${symbol(name)}$" if name.isalnum() else name
    return with_unit(text, str(chart[name].attrs.get("units", "")))

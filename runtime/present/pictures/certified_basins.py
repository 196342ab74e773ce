"""Pictures of basins that are proved: boxes of the section, and shares of tiles over two states."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.core.box_grid import BoxGrid
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.model.naming import shown_name, units_of
from nonsmooth.runtime.present.pictures.drawing import drawn_alone, finish
from nonsmooth.runtime.proof.sets.basin_certificate import BasinCertificate

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["draw_basin"]


def draw_basin(found: BasinCertificate, axes: Any = None) -> Figure | Axes:
    """Draw what is proved of a basin: the section's boxes, coloured by their ranks.

    The result is the Axes that are given, or else a new figure. Below the section it has, over
    two states each, the share of the examined tiles that is proved to be attracted.
    `InputError` is raised if nothing is proved, or if the section has more than two coordinates.
    """
    if not found.proved:
        raise InputError(f"there is nothing to draw: {found.reason}")
    pairs = _pairs(found)

    def compose(figure: Figure) -> None:
        figure.suptitle(f"{shown_name(found.orbit)}: proved to attract", fontsize="medium")
        if not pairs:
            _draw_section(figure.add_subplot(), found)
            return
        places = figure.add_gridspec(2, len(pairs), height_ratios=[1, 3])
        _draw_section(figure.add_subplot(places[0, :]), found)
        for place, pair in enumerate(pairs):
            _draw_tiles(figure.add_subplot(places[1, place]), found, pair)

    size = (9.6, 5.4 if pairs else 4.8)
    drawn: Figure | Axes = drawn_alone(
        "basin", size, lambda own: _draw_section(own, found), axes, compose
    )
    return drawn


def _pairs(found: BasinCertificate) -> list[tuple[int, int]]:
    """Pairs of neighbouring states, as their indices; none if no tiles were examined."""
    count = len(found.states) if found.looked.any() else 0
    return [(k, k + 1) for k in range(0, count - 1, 2)]


def _edges(grid: BoxGrid, place: int) -> np.ndarray:
    found: np.ndarray = (grid.first[place] + np.arange(grid.counts[place] + 1)) * grid.sides[place]
    return found


def _draw_section(axes: Axes, found: BasinCertificate) -> None:
    grid = found.grid
    if grid is None or len(grid.counts) > 2:
        raise InputError("the section has more than two coordinates: it is not drawn")
    ranks = np.where(found.ranks >= 0, found.ranks, np.nan).reshape(grid.counts)
    units = units_of(found.system)
    if len(grid.counts) == 1:
        axes.pcolormesh(_edges(grid, 0), [0, 1], ranks[None, :], cmap="viridis", rasterized=True)
        axes.set_yticks([])
        inside = np.flatnonzero(found.ranks >= 0)
        if len(inside):
            edges = _edges(grid, 0)
            margin = 0.05 * (edges[inside[-1] + 1] - edges[inside[0]])
            axes.set_xlim(edges[inside[0]] - margin, edges[inside[-1] + 1] + margin)
    else:
        axes.pcolormesh(_edges(grid, 0), _edges(grid, 1), ranks.T, cmap="viridis", rasterized=True)
        axes.set_ylabel(units.label(found.coordinates[1]))
    finish(axes, "the section: steps to the core", units.label(found.coordinates[0]))


def _draw_tiles(axes: Axes, found: BasinCertificate, pair: tuple[int, int]) -> None:
    grid = found.tiles
    assert grid is not None
    others = tuple(k for k in range(len(grid.counts)) if k not in pair)
    looked = found.looked.reshape(grid.counts).sum(axis=others)
    good = found.attracted.reshape(grid.counts).sum(axis=others)
    with np.errstate(invalid="ignore"):
        share = np.where(looked > 0, good / looked, np.nan)
    one, two = pair
    mesh = axes.pcolormesh(
        _edges(grid, one), _edges(grid, two), share.T, cmap="Blues", vmin=0, vmax=1, rasterized=True
    )
    units = units_of(found.system)
    finish(
        axes,
        "share of the tiles that were looked at",
        units.label(found.states[one]),
        units.label(found.states[two]),
    )
    axes.figure.colorbar(mesh, ax=axes)

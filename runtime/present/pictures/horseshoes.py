"""Pictures of chaos that is proved: sets on a section, what holds their images, the graph."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.model.naming import shown_name, units_of
from nonsmooth.runtime.present.pictures.drawing import drawn_alone, finish
from nonsmooth.runtime.proof.chaos.chaos_certificate import ChaosCertificate

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["draw_chaos"]

_COLORS = ("#0077BB", "#EE7733", "#009988", "#CC3311", "#33BBEE", "#EE3377")
_AROUND = 2.5  # sets are shown with so much about them, in units of their extent


def draw_chaos(found: ChaosCertificate, axes: Any = None) -> Figure | Axes:
    """Draw the h-sets, the enclosures of their images, and the graph of the coverings.

    Axes that are given receive the sets without the graph, and are returned; else a new figure
    is. `InputError` is raised if nothing is proved, or if the section has more than two
    coordinates.
    """
    if not found.proved:
        raise InputError(f"nothing is proved, so that there is no picture: {found.reason}")
    if len(found.coordinates) > 2:
        raise InputError("sets on a section of more than two coordinates have no picture")

    def compose(figure: Figure) -> None:
        left, right = figure.subplots(1, 2, width_ratios=[1.7, 1])
        _draw_sets(left, found)
        _draw_graph(right, found)

    drawn: Figure | Axes = drawn_alone(
        "sets", (9.6, 5.0), lambda own: _draw_sets(own, found), axes, compose
    )
    return drawn


def _draw_sets(axes: Axes, found: ChaosCertificate) -> None:
    flat = len(found.coordinates) == 1
    units = units_of(found.system)
    corners = [h_set.corners for h_set in found.h_sets]
    for number, (h_set, own) in enumerate(zip(found.h_sets, corners, strict=True)):
        color = _COLORS[number % len(_COLORS)]
        parts = found.images.get(h_set.name, ())
        if flat:
            low, high = own.min(), own.max()
            axes.plot([low, high], [0, 0], color=color, linewidth=7, solid_capstyle="butt")
            axes.annotate(
                h_set.name,
                ((low + high) / 2, 0),
                (0, -14),
                textcoords="offset points",
                ha="center",
                color=color,
            )
            if parts:
                ends = [min(low for (low,), _ in parts), max(high for _, (high,) in parts)]
                label = f"image of {h_set.name}"
                axes.plot(ends, 2 * [number + 1], color=color, linewidth=2, label=label)
            continue
        axes.fill(*own.T, facecolor=color, alpha=0.35, edgecolor=color, linewidth=1.5)
        axes.annotate(
            h_set.name,
            own[np.argmax(own[:, 1])],
            (0, 3),
            textcoords="offset points",
            ha="center",
            color=color,
        )
        if parts:
            _draw_parts(axes, parts, color)
    every = np.concatenate(corners)
    middle, half = every.mean(axis=0), np.ptp(every, axis=0) / 2
    axes.set_xlabel(units.label(found.coordinates[0]))
    if flat:
        axes.set_yticks([])
        axes.set_ylim(-1, len(found.h_sets) + 1)
        axes.set_xlim(middle[0] - _AROUND * half[0], middle[0] + _AROUND * half[0])
    else:
        axes.set_ylabel(units.label(found.coordinates[1]))
        axes.set_xlim(middle[0] - _AROUND * half[0], middle[0] + _AROUND * half[0])
        axes.set_ylim(middle[1] - _AROUND * half[1], middle[1] + _AROUND * half[1])
    shown = found.images and found.iterates > 1  # a file holds no images
    power = f", images under P^{found.iterates}" if shown else ""
    finish(axes, f"{shown_name(found.system)}{power}")


def _draw_parts(axes: Axes, parts: Any, color: str) -> None:
    from matplotlib.collections import PolyCollection

    corners = [np.array(part) for part in parts]
    axes.add_collection(
        PolyCollection(corners, facecolors="none", edgecolors=color, linewidths=0.4)
    )


def _draw_graph(axes: Axes, found: ChaosCertificate) -> None:
    """Draw the graph of coverings: vertices on a circle, and an arrow for each covering."""
    from matplotlib.patches import Circle, FancyArrowPatch

    count = len(found.h_sets)
    angles = np.pi / 2 - 2 * np.pi * np.arange(count) / count
    places = np.column_stack([np.cos(angles), np.sin(angles)])
    names = [h_set.name for h_set in found.h_sets]
    for one, other in found.coverings:
        start, end = places[names.index(one)], places[names.index(other)]
        if one == other:
            axes.add_patch(Circle(tuple(1.28 * start), 0.2, fill=False, edgecolor="0.4"))
            continue
        axes.add_patch(
            FancyArrowPatch(
                tuple(start),
                tuple(end),
                connectionstyle="arc3,rad=0.18",
                arrowstyle="-|>",
                mutation_scale=14,
                shrinkA=15,
                shrinkB=15,
                color="0.4",
            )
        )
    for number, (name, place) in enumerate(zip(names, places, strict=True)):
        color = _COLORS[number % len(_COLORS)]
        axes.add_patch(Circle(tuple(place), 0.15, facecolor=color, edgecolor="none", zorder=3))
        axes.annotate(name, tuple(place), ha="center", va="center", color="white", zorder=4)
    axes.set_xlim(-1.7, 1.7)
    axes.set_ylim(-1.7, 1.7)
    axes.set_aspect("equal")
    axes.set_axis_off()
    axes.set_title(f"entropy of P at least {float(found.entropy):.4g}", fontsize="medium")

"""Pictures of proven maps: tiles of the plane, or of a line."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.model.naming import shown_name
from nonsmooth.runtime.model.units import units_of
from nonsmooth.runtime.present.pictures.drawing import check_picture, finish, given_axes
from nonsmooth.runtime.proof.boxes.box_certificate import VERDICTS, BoxCertificate

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["COLORS", "box_figure", "draw_box"]

# the colours of charts: Tol's scheme "vibrant"; white is what is not known
COLORS = {
    "stable": "#0077BB",
    "neutral": "#33BBEE",
    "unstable": "#EE7733",
    "not admissible": "#BBBBBB",
    "undecided": "#FFFFFF",
}


def box_figure(found: BoxCertificate) -> Figure:
    """Draw a map into a figure of its own; see `draw_box`.

    Parameters
    ----------
    found : BoxCertificate
        The map.

    Returns
    -------
    Figure
        Outside pyplot.

    Raises
    ------
    InputError
        If the box has more than two parameters.
    MissingExtra
        If matplotlib is not installed.
    """
    check_picture("map", ("map",))
    from matplotlib.figure import Figure

    figure = Figure(figsize=(7.2, 5.6))
    figure.set_layout_engine("constrained")
    _draw(found, figure.add_subplot())
    return figure


def draw_box(found: BoxCertificate, axes: Any = None) -> Figure | Axes:
    """Draw the tiles of a map of two parameters, or the trace over one.

    Parameters
    ----------
    found : BoxCertificate
        The map.
    axes : Axes, optional
        What is drawn into; a figure of its own by default.

    Returns
    -------
    Figure or Axes
        The figure, or the Axes that were given.

    Raises
    ------
    InputError
        If the box has more than two parameters.
    MissingExtra
        If matplotlib is not installed.
    """
    if axes is None:
        return box_figure(found)
    check_picture("map", ("map",))
    (own,) = given_axes(axes, "map", [1])
    _draw(found, own)
    return own


def _draw(found: BoxCertificate, own: Axes) -> None:
    names = list(found.box)
    if len(names) > 2:
        raise InputError("a box of more than two parameters has no picture")
    (_draw_plane if len(names) == 2 else _draw_line)(own, found)
    for verdict in VERDICTS:
        if share := float(100 * found.shares[verdict]):
            name = found.stability if verdict == "proved" else verdict
            label = f"{name}, proved ({share:.4g} %)" if verdict != "undecided" else ""
            own.fill_between(
                [],
                [],
                facecolor=COLORS[name],
                edgecolor="0.4",
                label=label or f"undecided ({share:.4g} %)",
            )
    own.set_xlabel(units_of(found.system).label(names[0]))
    finish(own, shown_name(found.orbit))


def _draw_plane(axes: Axes, found: BoxCertificate) -> None:
    from matplotlib.collections import PatchCollection
    from matplotlib.patches import Rectangle

    across, up = found.box
    patches, colors = [], []
    for tile in found.tiles:
        where = found.where(tile)
        (left, right), (below, above) = where[across], where[up]
        corner = (float(left), float(below))
        patches.append(Rectangle(corner, float(right - left), float(above - below)))
        colors.append(COLORS[found.stability if tile.verdict == "proved" else tile.verdict])
    width = 0.6 if len(patches) < 400 else 0.2
    axes.add_collection(
        PatchCollection(patches, facecolors=colors, edgecolors="0.3", linewidths=width)
    )
    axes.set_xlim(*map(float, found.box[across]))
    axes.set_ylim(*map(float, found.box[up]))
    axes.set_ylabel(units_of(found.system).label(up))


def _draw_line(axes: Axes, found: BoxCertificate) -> None:
    """The trace's enclosures over the parameter."""
    (name,) = found.box
    for tile in found.tiles:
        left, right = map(float, found.where(tile)[name])
        color = COLORS[found.stability if tile.verdict == "proved" else tile.verdict]
        trace = tile.enclosures.get("trace")
        if trace is None:
            axes.axvspan(left, right, facecolor=color, edgecolor="0.3", hatch="//", linewidth=0)
        else:
            axes.fill_between(
                [left, right], trace.lower, trace.upper, facecolor=color, edgecolor="0.3"
            )
    axes.set_xlim(*map(float, found.box[name]))
    axes.set_ylabel("trace")

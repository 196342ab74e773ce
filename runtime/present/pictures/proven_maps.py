"""Pictures of proven maps: tiles of the plane, or of a line."""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING, Any

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.model.naming import shown_name, units_of
from nonsmooth.runtime.present.pictures.drawing import drawn_alone, finish
from nonsmooth.runtime.proof.boxes.box_certificate import VERDICTS, BoxCertificate, Tile

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["COLORS", "draw_box"]

# the colours of charts: Tol's scheme "vibrant"; white is what is not known
COLORS = {
    "stable": "#0077BB",
    "neutral": "#33BBEE",
    "unstable": "#EE7733",
    "not admissible": "#BBBBBB",
    "beyond a fold": "#EEEEEE",
    "undecided": "#FFFFFF",
}
_PLANE = 2  # parameters
_PARTS = 16  # of a curve in a tile
_STYLES = ("-", "--", "-.", ":")


def draw_box(found: BoxCertificate, axes: Any = None) -> Any:
    """Draw the tiles of a map of two parameters, or the trace over one.

    The result is the Axes that are given, or else a new figure. `InputError` is raised if
    the box has more than two parameters.
    """
    return drawn_alone("map", (7.2, 5.6), lambda own: _draw(found, own), axes)


def _draw(found: BoxCertificate, own: Axes) -> None:
    names = list(found.box)
    if len(names) > 2:
        raise InputError("a box of more than two parameters has no picture")
    (_draw_plane if len(names) == 2 else _draw_line)(own, found)
    for name, share in _areas(found).items():
        label = f"{name}, proved" if name != "undecided" else name
        own.fill_between(
            [], [], facecolor=COLORS[name], edgecolor="0.4", label=f"{label} ({share:.4g} %)"
        )
    finish(own, shown_name(found.orbit), units_of(found.system).label(names[0]))


def _areas(found: BoxCertificate) -> dict[str, float]:
    """Percentages of the box by verdict; for a plane approximate, as curves divide tiles."""
    areas: dict[str, float] = {}
    if len(found.box) == _PLANE:
        for region in found.regions:
            areas[region.verdict] = areas.get(region.verdict, 0.0) + 100 * region.share
        areas["undecided"] = float(100 * found.shares["undecided"])
    else:
        for verdict in VERDICTS:
            name = found.stability if verdict == "proved" else verdict
            areas[name] = float(100 * found.shares[verdict])
    return {name: area for name, area in areas.items() if area}


def _draw_curves(axes: Axes, found: BoxCertificate) -> None:
    """Draw curves at which verdicts change, each kind of event in a style of its own."""
    kinds = list(dict.fromkeys(curve.event.kind for curve in found.curves))
    for curve in found.curves:
        number = kinds.index(curve.event.kind)
        first = curve is next(c for c in found.curves if c.event.kind == curve.event.kind)
        axes.plot(
            [x for x, _ in curve.points],
            [y for _, y in curve.points],
            color="black",
            linewidth=1.4,
            linestyle=_STYLES[number % len(_STYLES)],
            label=curve.event.kind if first else None,
        )


def _side_of_tile(found: BoxCertificate, tile: Tile) -> list[tuple[float, float]]:
    """Corners of the part of a divided tile below its curve."""
    assert tile.event is not None
    band = tile.event.band
    ends = list(found.where(tile).values())
    places = [Fraction(2 * k - _PARTS, _PARTS) for k in range(_PARTS + 1)]
    along = [(place, min(max(float(band.at(place)), -1.0), 1.0)) for place in places]
    corners = [(places[0], -1.0), *along, (places[-1], -1.0)]
    found_corners = []
    for other, at in corners:
        point = (at, float(other)) if band.axis == 0 else (float(other), at)
        x, y = (
            float(low) + (e + 1) / 2 * float(high - low)
            for e, (low, high) in zip(point, ends, strict=True)
        )
        found_corners.append((x, y))
    return found_corners


def _draw_plane(axes: Axes, found: BoxCertificate) -> None:
    from matplotlib.collections import PatchCollection
    from matplotlib.patches import Polygon, Rectangle

    across, up = found.box
    patches: list[Rectangle | Polygon] = []
    colors = []

    def color_of(verdict: str) -> str:
        return COLORS[found.stability if verdict == "proved" else verdict]

    for tile, verdict in zip(found.tiles, found.verdicts, strict=True):
        where = found.where(tile)
        (left, right), (below, above) = where[across], where[up]
        corner = (float(left), float(below))
        patches.append(Rectangle(corner, float(right - left), float(above - below)))
        colors.append(color_of(verdict if tile.event is None else tile.event.above))
        if tile.event is not None:
            patches.append(Polygon(_side_of_tile(found, tile)))
            colors.append(color_of(tile.event.below))
    width = 0.6 if len(patches) < 400 else 0.2
    axes.add_collection(
        PatchCollection(patches, facecolors=colors, edgecolors="0.3", linewidths=width)
    )
    _draw_curves(axes, found)
    for number, box in enumerate(found.open):
        across_it, up_it = (float(low + high) / 2 for low, high in box.where.values())
        axes.plot(
            across_it,
            up_it,
            marker="o",
            markersize=9,
            markerfacecolor="none",
            markeredgecolor="#CC3311",
            linestyle="none",
            label=None if number else "undecided box",
        )
    axes.set_xlim(*map(float, found.box[across]))
    axes.set_ylim(*map(float, found.box[up]))
    axes.set_ylabel(units_of(found.system).label(up))


def _draw_line(axes: Axes, found: BoxCertificate) -> None:
    """Draw the trace's enclosures over the parameter."""
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

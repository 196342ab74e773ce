"""Pictures of what is proved over parameters: maps of a box, branches and doublings."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError, unknown_name
from nonsmooth.runtime.model.naming import shown_name, units_of
from nonsmooth.runtime.present.pictures.drawing import drawn_alone, finish, line_style, mark_style
from nonsmooth.runtime.proof.boxes.box_certificate import VERDICTS, BoxCertificate, Tile
from nonsmooth.runtime.proof.branch.certified_branch import (
    BranchTile,
    CertifiedBranch,
    CertifiedDoubling,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes

# the colours of charts: Tol's scheme "vibrant"; white is what is not known
_COLORS = {
    "stable": "#0077BB",
    "neutral": "#33BBEE",
    "unstable": "#EE7733",
    "not admissible": "#BBBBBB",
    "beyond a fold": "#EEEEEE",
    "undecided": "#FFFFFF",
}
_OPEN = "#CC3311"  # of what is undecided, in lines
_PLANE = 2  # parameters
_PARTS = 16  # of a curve in a tile
_POINTS = 40  # of a tile
_AWAY = 60  # points of the orbits beside a flip


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
            [], [], facecolor=_COLORS[name], edgecolor="0.4", label=f"{label} ({share:.4g} %)"
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


def _side_of_tile(found: BoxCertificate, tile: Tile) -> np.ndarray:
    """Corners (n, 2) of the part of a divided tile below its curve."""
    assert tile.event is not None
    band = tile.event.band
    places = [Fraction(2 * k - _PARTS, _PARTS) for k in range(_PARTS + 1)]
    edge = [(place, min(max(float(band.at(place)), -1.0), 1.0)) for place in places]
    corners = [(-1, -1), *edge, (1, -1)]
    points = [(at, other) if band.axis == 0 else (other, at) for other, at in corners]
    low, high = np.array([*found.where(tile).values()], dtype=float).T
    placed: np.ndarray = low + (np.array(points, dtype=float) + 1) / 2 * (high - low)
    return placed


def _color(found: BoxCertificate, verdict: str) -> str:
    return _COLORS[found.stability if verdict == "proved" else verdict]


def _draw_plane(axes: Axes, found: BoxCertificate) -> None:
    from matplotlib.collections import PatchCollection
    from matplotlib.patches import Polygon, Rectangle

    across, up = found.box
    patches: list[Rectangle | Polygon] = []
    colors = []

    for tile, verdict in zip(found.tiles, found.verdicts, strict=True):
        where = found.where(tile)
        (left, right), (below, above) = where[across], where[up]
        corner = (float(left), float(below))
        patches.append(Rectangle(corner, float(right - left), float(above - below)))
        colors.append(_color(found, verdict if tile.event is None else tile.event.above))
        if tile.event is not None:
            patches.append(Polygon(_side_of_tile(found, tile)))
            colors.append(_color(found, tile.event.below))
    width = 0.6 if len(patches) < 400 else 0.2
    axes.add_collection(
        PatchCollection(patches, facecolors=colors, edgecolors="0.3", linewidths=width)
    )
    kinds = list(dict.fromkeys(curve.event.kind for curve in found.curves))
    for curve in found.curves:
        style = line_style(kinds.index(curve.event.kind)) | {"color": "black"}
        axes.plot(*np.transpose(curve.points), label=curve.event.kind, **style)
    for box in found.open:
        across_it, up_it = (float(low + high) / 2 for low, high in box.where.values())
        axes.plot(
            across_it,
            up_it,
            marker="o",
            markersize=9,
            markerfacecolor="none",
            markeredgecolor=_OPEN,
            linestyle="none",
            label="undecided box",
        )
    axes.set_xlim(*map(float, found.box[across]))
    axes.set_ylim(*map(float, found.box[up]))
    axes.set_ylabel(units_of(found.system).label(up))


def _draw_line(axes: Axes, found: BoxCertificate) -> None:
    """Draw the trace's enclosures over the parameter."""
    (name,) = found.box
    for tile in found.tiles:
        left, right = map(float, found.where(tile)[name])
        color = _color(found, tile.verdict)
        trace = tile.enclosures.get("trace")
        if trace is None:
            axes.axvspan(left, right, facecolor=color, edgecolor="0.3", hatch="//", linewidth=0)
        else:
            axes.fill_between(
                [left, right], trace.lower, trace.upper, facecolor=color, edgecolor="0.3"
            )
    axes.set_xlim(*map(float, found.box[name]))
    axes.set_ylabel("trace")


def draw_certified_branch(
    found: CertifiedBranch, quantity: str | None = None, axes: Any = None
) -> Any:
    """Draw an unknown over the parameter, by the polynomials of the tubes.

    The default is the last dwell time. The result is the Axes that are given, or else a new
    figure. An unknown name raises `InputError`.
    """

    def draw(own: Axes) -> None:
        _draw_branches(own, found.orbit, [found], quantity, found.unknown_names[-1:])

    return drawn_alone("branch", (7.2, 5.0), draw, axes)


def draw_doubling(found: CertifiedDoubling, quantity: str | None = None, axes: Any = None) -> Any:
    """Draw an unknown of both branches over the parameter, by the polynomials of the tubes.

    By default it is the one by which the halves of the doubled orbits are told apart, or else
    the first one. The result is the Axes that are given, or else a new
    figure. An unknown name raises `InputError`.
    """
    doubled, names = found.doubled, found.branch.unknown_names

    def draw(own: Axes) -> None:
        if doubled is None:
            _draw_branches(own, found.orbit, [found.branch], quantity, names)
            return
        both = [found.branch, doubled.branch]
        name = _draw_branches(own, found.orbit, both, quantity, [doubled.scaled])
        e = np.linspace(0, 1, _AWAY)
        rows = [np.polynomial.polynomial.polyval(e, row) for row in doubled.centre]
        away = rows[len(names) : -1]
        away.insert(names.index(doubled.scaled), np.ones(_AWAY))
        place = names.index(name)
        up = rows[place] + float(doubled.amplitude) * e * away[place]
        own.plot(rows[-1], up, color=_line_color(doubled.verdict), linewidth=2, linestyle=":")

    return drawn_alone("doubling", (7.2, 5.0), draw, axes)


def _line_color(verdict: str) -> str:
    """Colour of a curve, which white would not show."""
    return _OPEN if verdict == "undecided" else _COLORS[verdict]


def _draw_branches(
    axes: Axes,
    title: str,
    branches: Sequence[CertifiedBranch],
    quantity: str | None,
    usual: Sequence[str],
) -> str:
    """Draw an unknown along the tiles of branches of one parameter, and their events.

    Without a `quantity` it is the first of the `usual` ones
    that all branches have, or else the first that they have; it is returned. `InputError` is
    raised for another name.
    """
    first, *others = branches
    names = [n for n in first.unknown_names if all(n in b.unknown_names for b in others)]
    name = next((n for n in (*usual, *names) if n in names), "") if quantity is None else quantity
    if name not in names:
        raise unknown_name("unknown", name, names)
    for branch in branches:
        for tile in branch.tiles:
            across, up = _points(branch, tile, name)
            parts = [(tile.before, slice(None))]
            if tile.event is not None:
                low = float(tile.lower)
                share = (float(tile.event.lower) - low) / (float(tile.upper) - low)
                cut = int(share * (_POINTS - 1)) + 1
                halves = [slice(None, cut), slice(cut - 1, None)][:: 1 if tile.forwards else -1]
                parts = list(zip((tile.before, tile.after), halves, strict=True))
            for verdict, part in parts:
                told = verdict if verdict == "undecided" else f"{verdict}, proved"
                color = _line_color(verdict)
                axes.plot(across[part], up[part], color=color, linewidth=2, label=told)
    if others:
        axes.plot([], [], color="black", linestyle=":", label="twice the period, beside the flip")
    events = [event for branch in branches for event in branch.events]
    for place, kind in enumerate(dict.fromkeys(event.kind for event in events)):
        there = [event.enclosures for event in events if event.kind == kind]
        axes.plot(
            *([float(x[n]) for x in there] for n in (first.parameter, name)),
            label=f"{kind}, enclosed",
            **{**mark_style(place), "color": "black"},
        )
    units = units_of(first.system)
    finish(axes, shown_name(title), units.label(first.parameter), units.label(name))
    return name


def _points(found: CertifiedBranch, tile: BranchTile, name: str) -> tuple[np.ndarray, np.ndarray]:
    """Values of the parameter and of the unknown along a tile."""
    e = np.linspace(-1, 1, _POINTS)
    low, high = float(tile.lower), float(tile.upper)
    own = (low + high) / 2 + (high - low) / 2 * e
    names = [*found.unknown_names, None]
    place = len(names) - 1
    if tile.coordinate != found.parameter:
        place = names.index(tile.coordinate)
    others = [np.polynomial.polynomial.polyval(e, row) for row in tile.centre]
    every = [*others[:place], own, *others[place:]]
    return every[-1], every[names.index(name)]

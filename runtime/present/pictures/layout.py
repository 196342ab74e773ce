"""Where pictures of an orbit or a motion are drawn: Axes that are given, or of a new figure."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from importlib import import_module
from typing import TYPE_CHECKING, Any

from nonsmooth.runtime.present.pictures.drawing import given_axes, within
from nonsmooth.runtime.present.pictures.kinds import KINDS
from nonsmooth.runtime.present.pictures.panels import Scene
from nonsmooth.runtime.present.pictures.view import View

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["draw", "draw_all", "draw_into", "figure_of"]


def draw(scene: Scene | View, kind: str, places: Sequence[Axes]) -> None:
    """Draw one kind of picture into as many Axes as it takes.

    The kinds are those of `plot_orbit`.
    """
    entry = KINDS[kind]
    place = entry.draw if isinstance(scene, Scene) else entry.draw_view or entry.draw
    module, _, name = place.rpartition(".")
    getattr(import_module(f"nonsmooth.runtime.present.pictures.{module}"), name)(scene, places)


def draw_all(scene: Scene | View, places: Sequence[Axes]) -> None:
    """Draw positions, velocities, configurations, portraits, and the multipliers of an orbit."""
    figure = places[0].figure
    figure.suptitle(within(scene.title, figure.bbox.width / figure.dpi))
    part = replace(scene, composed=True)
    for kind, place in zip(("time", "velocity", "strip"), places, strict=False):
        draw(part, kind, [place])
    draw(part, "phase", places[3 : 3 + scene.portraits])
    for place in places[3 + scene.portraits :]:
        draw(part, "multipliers", [place])


def draw_into(scene: Scene | View, kind: str, axes: Any) -> list[Axes]:
    """Draw into the Axes that are given, or into a new figure of pyplot, and return the Axes.

    The kinds are those of `plot_orbit`. `InputError` is raised for a wrong number of Axes.
    """
    if axes is None:
        from matplotlib import pyplot

        places = _new_axes(pyplot.figure(figsize=_size(scene, kind)), scene, kind)
    else:
        several = {"all": [3 + _beside(scene)], "phase": sorted({1, len(scene.masses)})}
        places = given_axes(axes, kind, several.get(kind, [1]))
    draw(scene, kind, places)
    return places


def figure_of(scene: Scene | View, kind: str) -> Figure:
    """Figure, outside pyplot, of one kind of picture; the kinds are those of `plot_orbit`."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=_size(scene, kind))
    draw(scene, kind, _new_axes(figure, scene, kind))
    return figure


def _size(scene: Scene | View, kind: str) -> tuple[float, float]:
    width, height = KINDS[kind].size
    return (width * scene.portraits if kind == "phase" else width), height


def _beside(scene: Scene | View) -> int:
    """Number of Axes that "all" has beside the histories: portraits, and an orbit's multipliers."""
    return scene.portraits + (scene.orbit is not None)


def _new_axes(figure: Figure, scene: Scene | View, kind: str) -> list[Axes]:
    """Axes of a new figure."""
    figure.set_layout_engine("constrained", wspace=0.06, hspace=0.02)
    if kind == "phase":
        count = scene.portraits
        return [figure.add_subplot(1, count, place + 1) for place in range(count)]
    if kind != "all":
        return [figure.add_subplot()]
    grid = figure.add_gridspec(3, 2, width_ratios=(1.45, 1), height_ratios=(1, 1, 0.6))
    time = figure.add_subplot(grid[0, 0])
    velocity, strip = (figure.add_subplot(grid[row, 0], sharex=time) for row in (1, 2))
    for upper in (time, velocity):
        upper.tick_params(labelbottom=False)
        upper.xaxis.label.set_visible(False)
    right = grid[:, 1].subgridspec(_beside(scene), 1)
    return [time, velocity, strip, *(figure.add_subplot(right[k]) for k in range(_beside(scene)))]

"""Pictures of orbits and of simulated motions, by matplotlib.

They are drawn into the Axes that are given, or into a new figure. Where transitions or
oscillations are too many to be told apart, curves become the range that they fill, and
configurations the share of time that is spent in each.
"""

from __future__ import annotations

import io
import os
from collections.abc import Mapping, Sequence
from dataclasses import replace
from importlib import import_module
from typing import TYPE_CHECKING, Any

from nonsmooth.runtime.core.files import check_ending, path_of, write_file
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.present.pictures.drawing import check_picture, given_axes, within
from nonsmooth.runtime.present.pictures.kinds import KINDS
from nonsmooth.runtime.present.pictures.view import View, orbit_view, trajectory_view

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from nonsmooth.runtime.simulation.trajectory import Trajectory

_METADATA: dict[str, dict[str, Any]] = {  # without dates, by the ending of the file
    ".png": {},
    ".svg": {"Date": None},
    ".pdf": {"CreationDate": None},
}


def plot_motion(
    motion: Orbit | Trajectory, kind: str = "time", axes: Any = None, **options: Any
) -> Any:
    """Draw an orbit or a motion, and give the Axes: several for "all", or for several portraits.

    The kinds are those of `kinds.KINDS`: "time" or "velocity" (positions or velocities of
    all masses over time), "phase" (portraits (x, x')), "strip" (configurations over time),
    "multipliers" (of an orbit, in the unit circle) or "all". One Axes may be given; for "phase"
    also one for each mass; for "all" those of time, velocity and strip, of portraits, and of an
    orbit's multipliers. An orbit with kernels then takes one Axes for all its portraits, others
    take one for each mass. Without Axes a new figure is made.

    The options of an orbit are those of `orbit_view`, those of a motion of `trajectory_view`.
    Positions and time are those of the orbit's equations. The background has the colour of the
    configuration. Dotted lines are boundaries that depend on the position or the velocity of one
    mass alone; dashed ones are impacts. `InputError` is raised for an unknown kind or mass, a
    wrong number of points or Axes, an orbit that has not converged, or a motion that is not
    finite.
    """
    view = _view(motion, kind, options)
    if axes is None:
        from matplotlib import pyplot

        places = _new_axes(pyplot.figure(figsize=_size(view, kind)), view, kind)
    else:
        several = {"all": [3 + _beside(view)], "phase": sorted({1, len(view.masses)})}
        places = given_axes(axes, kind, several.get(kind, [1]))
    draw(view, kind, places)
    one = hasattr(axes, "plot") or (axes is None and len(places) == 1)
    return places[0] if kind not in ("all", "phase") or one else tuple(places)


def motion_figure(motion: Orbit | Trajectory, kind: str = "all", **options: Any) -> Figure:
    """Figure, outside pyplot, of an orbit or a motion; the arguments are those of `plot_motion`."""
    view = _view(motion, kind, options)
    from matplotlib.figure import Figure

    figure = Figure(figsize=_size(view, kind))
    draw(view, kind, _new_axes(figure, view, kind))
    return figure


def _view(motion: Orbit | Trajectory, kind: str, options: Mapping[str, Any]) -> View:
    """What is drawn, after all checks that need no drawing."""
    if isinstance(motion, Orbit):
        check_picture(kind, tuple(KINDS))
        return orbit_view(motion, **options)
    check_picture(kind, [name for name, one in KINDS.items() if one.of_motions])
    return trajectory_view(motion, **options)


def draw(view: View, kind: str, places: Sequence[Axes]) -> None:
    """Draw one kind of picture into as many Axes as it takes.

    The kinds are those of `plot_motion`.
    """
    module, _, name = KINDS[kind].draw.rpartition(".")
    getattr(import_module(f"nonsmooth.runtime.present.pictures.{module}"), name)(view, places)


def draw_all(view: View, places: Sequence[Axes]) -> None:
    """Draw positions, velocities, configurations, portraits, and the multipliers of an orbit."""
    figure = places[0].figure
    figure.suptitle(within(view.title, figure.bbox.width / figure.dpi))
    part = replace(view, composed=True)
    for kind, place in zip(("time", "velocity", "strip"), places, strict=False):
        draw(part, kind, [place])
    draw(part, "phase", places[3 : 3 + view.portraits])
    for place in places[3 + view.portraits :]:
        draw(part, "multipliers", [place])


def save_figure(figure: Figure, path: str | os.PathLike[str]) -> None:
    """Write a figure of matplotlib as PNG, SVG or PDF; the same figure gives the same bytes.

    `InputError` is raised for another ending, or if the file cannot be written.
    """
    target = path_of(path)
    check_ending(target, tuple(_METADATA))
    write_file(target, figure_bytes(figure, target.suffix.lower()))


def figure_bytes(figure: Figure, ending: str) -> bytes:
    """Content of a figure's file; the same figure gives the same bytes.

    The ending is ".png", ".svg" or ".pdf".
    """
    from matplotlib import rc_context

    content = io.BytesIO()
    with rc_context({"svg.hashsalt": "nonsmooth"}):
        figure.savefig(content, format=ending[1:], dpi=200, metadata=_METADATA[ending])
    return content.getvalue()


def _size(view: View, kind: str) -> tuple[float, float]:
    width, height = KINDS[kind].size
    return (width * view.portraits if kind == "phase" else width), height


def _beside(view: View) -> int:
    """Number of Axes that "all" has beside the histories: portraits, and an orbit's multipliers."""
    return view.portraits + (view.orbit is not None)


def _new_axes(figure: Figure, view: View, kind: str) -> list[Axes]:
    """Axes of a new figure."""
    figure.set_layout_engine("constrained", wspace=0.06, hspace=0.02)
    if kind == "phase":
        count = view.portraits
        return [figure.add_subplot(1, count, place + 1) for place in range(count)]
    if kind != "all":
        return [figure.add_subplot()]
    grid = figure.add_gridspec(3, 2, width_ratios=(1.45, 1), height_ratios=(1, 1, 0.6))
    time = figure.add_subplot(grid[0, 0])
    velocity, strip = (figure.add_subplot(grid[row, 0], sharex=time) for row in (1, 2))
    for upper in (time, velocity):
        upper.tick_params(labelbottom=False)
        upper.xaxis.label.set_visible(False)
    right = grid[:, 1].subgridspec(_beside(view), 1)
    return [time, velocity, strip, *(figure.add_subplot(right[k]) for k in range(_beside(view)))]

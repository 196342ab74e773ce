"""Pictures of orbits and of simulated motions, by matplotlib.

They are drawn into the Axes that are given, or into a new figure. Where transitions or
oscillations are too many to be told apart, curves become the range that they fill, and
configurations the share of time that is spent in each.
"""

from __future__ import annotations

import io
import os
from collections.abc import Iterable, Sequence
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

__all__ = [
    "draw",
    "draw_all",
    "figure_bytes",
    "orbit_figure",
    "plot_orbit",
    "plot_trajectory",
    "save_figure",
    "trajectory_figure",
]

_METADATA: dict[str, dict[str, Any]] = {  # without dates, by the ending of the file
    ".png": {},
    ".svg": {"Date": None},
    ".pdf": {"CreationDate": None},
}


def plot_orbit(
    orbit: Orbit,
    kind: str = "time",
    axes: Any = None,
    *,
    periods: int = 1,
    points_per_period: int = 600,
    masses: Iterable[int] | None = None,
) -> Any:
    """Draw an orbit, and give the Axes: several for "all", or for several portraits.

    The kinds are those of `kinds.KINDS`: "time" or "velocity" (positions or velocities of
    all masses over time), "phase" (portraits (x, x')), "strip" (configurations over time),
    "multipliers" (in the unit circle) or "all". One Axes may be given; for "phase" also one
    for each mass; for "all" those of time, velocity and strip, of portraits, and of
    multipliers. An orbit with kernels then takes one Axes for all its portraits, one
    without kernels takes one for each mass. Without Axes a new figure is made.

    `points_per_period` is a lower bound. The masses count from 0, and None stands for all.
    Positions and time are those of the orbit's equations. `InputError` is raised for an
    unknown kind or mass, a wrong number of points or Axes, or an orbit that has not
    converged.
    """
    places = _draw_into(_orbit_view(orbit, kind, periods, points_per_period, masses), kind, axes)
    one = hasattr(axes, "plot") or (axes is None and len(places) == 1)
    return places[0] if kind not in ("all", "phase") or one else tuple(places)


def orbit_figure(
    orbit: Orbit,
    kind: str = "all",
    *,
    periods: int = 1,
    points_per_period: int = 600,
    masses: Iterable[int] | None = None,
) -> Figure:
    """Figure, outside pyplot, of a converged orbit; the arguments are those of `plot_orbit`."""
    return _figure_of(_orbit_view(orbit, kind, periods, points_per_period, masses), kind)


def plot_trajectory(
    trajectory: Trajectory,
    kind: str = "time",
    axes: Any = None,
    *,
    masses: Iterable[int] | None = None,
    points: int = 2000,
) -> Any:
    """Draw a motion, and give the Axes: several for "all", or for several portraits.

    The kind is "time" or "velocity" (positions or velocities over time), "phase" (a
    portrait (x, x') of each mass), "strip" (configurations over time), or "all". One Axes
    may be given; for "phase" one for each mass, or one for all; for "all" those of time,
    velocity and strip, then one for each mass. Without Axes a new figure is made.

    The masses count from 0, and None stands for all. `points` is a lower bound; there are
    more where the motion needs them. The background has the colour of the configuration.
    Dotted lines are boundaries that depend on the position or the velocity of one mass
    alone; dashed ones are impacts. `InputError` is raised for an unknown kind or mass, a
    wrong number of points or Axes, or a motion that is not finite.
    """
    places = _draw_into(_trajectory_view(trajectory, kind, masses, points), kind, axes)
    single = kind not in ("all", "phase") or hasattr(axes, "plot")
    return places[0] if single else tuple(places)


def trajectory_figure(
    trajectory: Trajectory,
    kind: str = "all",
    *,
    masses: Iterable[int] | None = None,
    points: int = 2000,
) -> Figure:
    """Figure, outside pyplot, of a motion; the arguments are those of `plot_trajectory`."""
    return _figure_of(_trajectory_view(trajectory, kind, masses, points), kind)


def draw(view: View, kind: str, places: Sequence[Axes]) -> None:
    """Draw one kind of picture into as many Axes as it takes.

    The kinds are those of `plot_orbit`.
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


def _draw_into(view: View, kind: str, axes: Any) -> list[Axes]:
    """Draw into the Axes that are given, or into a new figure of pyplot, and return the Axes.

    The kinds are those of `plot_orbit`. `InputError` is raised for a wrong number of Axes.
    """
    if axes is None:
        from matplotlib import pyplot

        places = _new_axes(pyplot.figure(figsize=_size(view, kind)), view, kind)
    else:
        several = {"all": [3 + _beside(view)], "phase": sorted({1, len(view.masses)})}
        places = given_axes(axes, kind, several.get(kind, [1]))
    draw(view, kind, places)
    return places


def _figure_of(view: View, kind: str) -> Figure:
    """Figure, outside pyplot, of one kind of picture; the kinds are those of `plot_orbit`."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=_size(view, kind))
    draw(view, kind, _new_axes(figure, view, kind))
    return figure


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


def _orbit_view(
    orbit: Orbit,
    kind: str,
    periods: int,
    points_per_period: int,
    masses: Iterable[int] | None,
) -> View:
    """The orbit as it is drawn, after all checks that need no drawing."""
    check_picture(kind, tuple(KINDS))
    return orbit_view(orbit, periods, points_per_period, masses)


def _trajectory_view(
    trajectory: Trajectory, kind: str, masses: Iterable[int] | None, points: int
) -> View:
    """The motion as it is drawn, after all checks that need no drawing."""
    check_picture(kind, tuple(name for name, one in KINDS.items() if one.of_motions))
    return trajectory_view(trajectory, masses, points)


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

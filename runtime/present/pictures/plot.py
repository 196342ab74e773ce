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
from nonsmooth.runtime.model.naming import shown_name
from nonsmooth.runtime.orbits.motion import orbit_motion
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.present.pictures.drawing import (
    check_picture,
    chosen_masses,
    given_axes,
    within,
)
from nonsmooth.runtime.present.pictures.kinds import KINDS
from nonsmooth.runtime.present.pictures.panels import Scene
from nonsmooth.runtime.present.pictures.view import View, coordinates_of, view_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from nonsmooth.runtime.simulation.trajectory import Trajectory

__all__ = [
    "draw",
    "draw_all",
    "figure_bytes",
    "orbit_figure",
    "orbit_view",
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
    places = _draw_into(_scene(orbit, kind, periods, points_per_period, masses), kind, axes)
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
    return _figure_of(_scene(orbit, kind, periods, points_per_period, masses), kind)


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


def _draw_into(scene: Scene | View, kind: str, axes: Any) -> list[Axes]:
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


def _figure_of(scene: Scene | View, kind: str) -> Figure:
    """Figure, outside pyplot, of one kind of picture; the kinds are those of `plot_orbit`."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=_size(scene, kind))
    draw(scene, kind, _new_axes(figure, scene, kind))
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


def _scene(
    orbit: Orbit,
    kind: str,
    periods: int,
    points_per_period: int,
    masses: Iterable[int] | None,
) -> Scene | View:
    """The orbit as it is drawn, after all checks that need no drawing."""
    check_picture(kind, tuple(KINDS))
    if not orbit.problem.derived:
        return orbit_view(orbit, periods, points_per_period, masses)
    motion = orbit_motion(orbit)
    drawn = chosen_masses(masses, len(motion.names) // 2, orbit.name)
    return Scene(orbit, motion, motion.sample(points_per_period, periods), drawn)


def orbit_view(
    orbit: Orbit, periods: int, points_per_period: int, masses: Iterable[int] | None
) -> View:
    """The trajectory along a converged orbit, as motions are drawn.

    It has at least about so many points for each of the periods. The masses count from 0,
    and None stands for all; `InputError` is raised if there is no such mass.
    """
    motion = orbit.trajectory(periods)
    drawn = chosen_masses(masses, len(coordinates_of(motion)), orbit.name)
    points = points_per_period
    if isinstance(points, int) and not isinstance(points, bool):
        points *= periods
    return view_of(motion, drawn, points, orbit, shown_name(orbit.name))


def _trajectory_view(
    trajectory: Trajectory, kind: str, masses: Iterable[int] | None, points: int
) -> View:
    """The motion as it is drawn, after all checks that need no drawing."""
    check_picture(kind, tuple(name for name, one in KINDS.items() if one.of_motions))
    drawn = chosen_masses(masses, len(coordinates_of(trajectory)), trajectory.name)
    return view_of(trajectory, drawn, points)


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

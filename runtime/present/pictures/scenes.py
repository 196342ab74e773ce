"""Pictures of simulated motions, by matplotlib, with few transitions or with thousands.

Where transitions or oscillations are too many to be told apart, curves become the range that
they fill, and configurations the share of time that is spent in each.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from nonsmooth.runtime.present.pictures import kinds
from nonsmooth.runtime.present.pictures.drawing import check_picture, chosen_masses
from nonsmooth.runtime.present.pictures.layout import draw_into, figure_of
from nonsmooth.runtime.present.pictures.view import View, coordinates_of, view_of

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from nonsmooth.runtime.simulation.trajectory import Trajectory

__all__ = ["KINDS", "plot_trajectory", "trajectory_figure"]

KINDS = tuple(name for name, kind in kinds.KINDS.items() if kind.of_motions)


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
    places = draw_into(_view(trajectory, kind, masses, points), kind, axes)
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
    return figure_of(_view(trajectory, kind, masses, points), kind)


def _view(trajectory: Trajectory, kind: str, masses: Iterable[int] | None, points: int) -> View:
    """The motion as it is drawn, after all checks that need no drawing."""
    check_picture(kind, KINDS)
    drawn = chosen_masses(masses, len(coordinates_of(trajectory)), trajectory.name)
    return view_of(trajectory, drawn, points)

"""Pictures of simulated motions, by matplotlib, with few transitions or with thousands.

Where transitions or oscillations are too many to be told apart, curves become the range that
they fill, and configurations the share of time that is spent in each.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from nonsmooth.runtime.present.pictures.drawing import check_picture, chosen_masses, given_axes
from nonsmooth.runtime.present.pictures.maps import basin_figure, bifurcation_figure
from nonsmooth.runtime.present.pictures.motion_panels import (
    View,
    coordinates_of,
    draw_motion,
    view_of,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from nonsmooth.runtime.simulation.trajectory import Trajectory

__all__ = ["KINDS", "basin_figure", "bifurcation_figure", "plot_trajectory", "trajectory_figure"]

KINDS = ("time", "velocity", "phase", "strip", "all")

_SIZES = {"time": (6.4, 3.6), "velocity": (6.4, 3.6), "strip": (6.4, 2.4), "all": (11.0, 8.0)}
_PORTRAIT = (4.9, 4.4)


def plot_trajectory(
    trajectory: Trajectory,
    kind: str = "time",
    axes: Any = None,
    *,
    masses: Iterable[int] | None = None,
    points: int = 2000,
) -> Any:
    """Draw a motion.

    Parameters
    ----------
    trajectory : Trajectory
    kind : {"time", "velocity", "phase", "strip", "all"}
        Positions or velocities over time; a phase portrait (x, x') of each mass; which
        configuration when; or all of them.
    axes : Axes or sequence of Axes, optional
        Where to draw: one Axes; for "phase" one for each mass, or one for all; for "all"
        those of time, velocity and strip, then one for each mass. A new figure when omitted.
    masses : iterable of int, optional
        Which to draw, counted from 0; all when omitted.
    points : int
        At least about so many are drawn, more where the motion needs them.

    Returns
    -------
    Axes or tuple of Axes
        A tuple for "all", and for "phase" unless one Axes was given.

    Raises
    ------
    InputError
        For an unknown kind or mass, a wrong number of points or Axes, or a motion that is
        not finite.
    MissingExtra
        If matplotlib is not installed.

    Notes
    -----
    The background has the colour of the configuration. Dotted lines are boundaries that
    depend on the position or the velocity of one mass alone; dashed ones are impacts.
    """
    view = _view(trajectory, kind, masses, points)
    count = len(view.masses)
    if axes is None:
        from matplotlib import pyplot

        places = _places(pyplot.figure(figsize=_size(kind, count)), kind, count)
    else:
        counts = {"all": (3 + count,), "phase": tuple(sorted({1, count}))}.get(kind, (1,))
        places = given_axes(axes, kind, counts)
    draw_motion(view, kind, places)
    single = kind not in ("all", "phase") or hasattr(axes, "plot")
    return places[0] if single else tuple(places)


def trajectory_figure(
    trajectory: Trajectory,
    kind: str = "all",
    *,
    masses: Iterable[int] | None = None,
    points: int = 2000,
) -> Figure:
    """Draw a motion into a figure of its own, outside pyplot; as `plot_trajectory` does."""
    view = _view(trajectory, kind, masses, points)
    from matplotlib.figure import Figure

    figure = Figure(figsize=_size(kind, len(view.masses)))
    draw_motion(view, kind, _places(figure, kind, len(view.masses)))
    return figure


def _view(trajectory: Trajectory, kind: str, masses: Iterable[int] | None, points: int) -> View:
    """Check what can be checked before anything is drawn."""
    check_picture(kind, KINDS)
    drawn = chosen_masses(masses, len(coordinates_of(trajectory)), trajectory.name)
    return view_of(trajectory, drawn, points)


def _size(kind: str, masses: int) -> tuple[float, float]:
    return _SIZES.get(kind, (_PORTRAIT[0] * masses, _PORTRAIT[1]))


def _places(figure: Figure, kind: str, masses: int) -> list[Axes]:
    """Axes of a new figure."""
    figure.set_layout_engine("constrained", wspace=0.06, hspace=0.02)
    if kind == "phase":
        return [figure.add_subplot(1, masses, place + 1) for place in range(masses)]
    if kind != "all":
        return [figure.add_subplot()]
    grid = figure.add_gridspec(3, 2, width_ratios=(1.45, 1), height_ratios=(1, 1, 0.6))
    time = figure.add_subplot(grid[0, 0])
    velocity, strip = (figure.add_subplot(grid[row, 0], sharex=time) for row in (1, 2))
    for upper in (time, velocity):
        upper.tick_params(labelbottom=False)
        upper.xaxis.label.set_visible(False)
    right = grid[:, 1].subgridspec(masses, 1)
    return [time, velocity, strip, *(figure.add_subplot(right[m]) for m in range(masses))]

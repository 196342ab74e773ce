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
    """Draw a motion into a figure of its own, outside pyplot; as `plot_trajectory` does.

    Parameters
    ----------
    trajectory : Trajectory
        The motion.
    kind : str, default "all"
        As for `plot_trajectory`.
    masses : iterable of int, optional
        Numbers of the masses that are drawn, from 0; all by default.
    points : int, default 2000
        About how many points the motion has at least.

    Returns
    -------
    Figure
        Outside pyplot.

    Raises
    ------
    InputError
        As for `plot_trajectory`.
    MissingExtra
        If matplotlib is not installed.
    """
    return figure_of(_view(trajectory, kind, masses, points), kind)


def _view(trajectory: Trajectory, kind: str, masses: Iterable[int] | None, points: int) -> View:
    """Check what can be checked before anything is drawn."""
    check_picture(kind, KINDS)
    drawn = chosen_masses(masses, len(coordinates_of(trajectory)), trajectory.name)
    return view_of(trajectory, drawn, points)

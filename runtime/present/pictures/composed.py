"""Pictures of composed orbits: those of motions, and the multipliers."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from nonsmooth.runtime.model.naming import shown_name
from nonsmooth.runtime.orbits.composed_orbit import ComposedOrbit
from nonsmooth.runtime.present.pictures.drawing import check_picture, chosen_masses, given_axes
from nonsmooth.runtime.present.pictures.motion_panels import (
    View,
    coordinates_of,
    draw_motion,
    view_of,
)
from nonsmooth.runtime.present.pictures.panels import draw_multipliers

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["KINDS", "composed_figure", "composed_view", "plot_composed"]

KINDS = ("time", "velocity", "phase", "strip", "multipliers", "all")

_SIZES = {
    "time": (6.4, 3.6),
    "velocity": (6.4, 3.6),
    "strip": (6.4, 2.4),
    "multipliers": (4.8, 5.0),
    "all": (11.0, 8.0),
}
_PORTRAIT = (4.9, 4.4)


def plot_composed(
    orbit: ComposedOrbit,
    kind: str = "time",
    axes: Any = None,
    *,
    periods: int = 1,
    points_per_period: int = 600,
    masses: Iterable[int] | None = None,
) -> Any:
    """Draw a composed orbit.

    Parameters
    ----------
    orbit : ComposedOrbit
    kind : {"time", "velocity", "phase", "strip", "multipliers", "all"}
        Positions or velocities over time; a phase portrait (x, x') of each mass; which
        configuration when; multipliers in the unit circle; or all of them.
    axes : Axes or sequence of Axes, optional
        Where to draw: one Axes; for "phase" one for each mass, or one for all; for "all"
        those of time, velocity, strip and multipliers, then one for each mass. A new figure
        when omitted.
    periods : int
        How many to draw against time.
    points_per_period : int
        At least about so many.
    masses : iterable of int, optional
        Which to draw, counted from 0; all when omitted.

    Returns
    -------
    Axes or tuple of Axes
        A tuple for "all", and for "phase" unless one Axes was given.

    Raises
    ------
    InputError
        For an unknown kind or mass, a wrong number of points or Axes, or no orbit.
    MissingExtra
        If matplotlib is not installed.
    """
    view = composed_view(orbit, kind, periods, points_per_period, masses)
    count = len(view.masses)
    if axes is None:
        from matplotlib import pyplot

        places = _places(pyplot.figure(figsize=_size(kind, count)), kind, count)
    else:
        counts = {"all": (4 + count,), "phase": tuple(sorted({1, count}))}.get(kind, (1,))
        places = given_axes(axes, kind, counts)
    _draw(orbit, view, kind, places)
    single = kind not in ("all", "phase") or hasattr(axes, "plot")
    return places[0] if single else tuple(places)


def composed_figure(
    orbit: ComposedOrbit,
    kind: str = "all",
    *,
    periods: int = 1,
    points_per_period: int = 600,
    masses: Iterable[int] | None = None,
) -> Figure:
    """Draw an orbit into a figure of its own, outside pyplot; as `plot_composed` does."""
    view = composed_view(orbit, kind, periods, points_per_period, masses)
    from matplotlib.figure import Figure

    figure = Figure(figsize=_size(kind, len(view.masses)))
    _draw(orbit, view, kind, _places(figure, kind, len(view.masses)))
    return figure


def composed_view(
    orbit: ComposedOrbit,
    kind: str,
    periods: int,
    points_per_period: int,
    masses: Iterable[int] | None,
) -> View:
    """Check what can be checked before anything is drawn."""
    check_picture(kind, KINDS)
    motion = orbit.trajectory(periods)
    drawn = chosen_masses(masses, len(coordinates_of(motion)), orbit.name)
    points = points_per_period
    if isinstance(points, int) and not isinstance(points, bool):
        points *= periods
    return replace(view_of(motion, drawn, points, orbit.kernels), name=_title(orbit), closed=True)


def _title(orbit: ComposedOrbit) -> str:
    """Name of the orbit."""
    return shown_name(orbit.name) if orbit.label else orbit.name


def _draw(orbit: ComposedOrbit, view: View, kind: str, places: list[Axes]) -> None:
    if kind == "multipliers":
        draw_multipliers(orbit.stability.multipliers, places[0], _title(orbit))
    elif kind == "all":
        draw_multipliers(orbit.stability.multipliers, places[3], "")
        draw_motion(view, kind, [*places[:3], *places[4:]])
    else:
        draw_motion(view, kind, places)


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
    right = grid[:, 1].subgridspec(masses + 1, 1)
    portraits = [figure.add_subplot(right[m]) for m in range(masses)]
    return [time, velocity, strip, figure.add_subplot(right[masses]), *portraits]

"""Pictures of orbits, by matplotlib.

They are drawn into the Axes that are given, or into a new figure.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.files import unwritable
from nonsmooth.runtime.model.naming import shown_name
from nonsmooth.runtime.orbits.motion import orbit_motion
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.orbits.table_problem import TableProblem
from nonsmooth.runtime.present.pictures.drawing import check_picture, chosen_masses, given_axes
from nonsmooth.runtime.present.pictures.motion_panels import (
    View,
    coordinates_of,
    draw_motion,
    view_of,
)
from nonsmooth.runtime.present.pictures.panels import Scene, draw, draw_multipliers

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["KINDS", "orbit_figure", "orbit_view", "plot_orbit", "save_figure"]

KINDS = ("time", "velocity", "phase", "strip", "multipliers", "all")

_SIZES = {
    "time": (6.4, 3.6),
    "velocity": (6.4, 3.6),
    "strip": (6.4, 2.3),
    "multipliers": (4.8, 5.0),
    "all": (11.0, 8.0),
}


@dataclass(frozen=True)
class Picture:
    """What is drawn of one orbit.

    Attributes
    ----------
    size : (float, float)
        Of a new figure.
    portraits : int
        Axes for phase portraits in a new figure.
    masses : int
        How many are drawn.
    draw : function of a list of Axes
    """

    size: tuple[float, float]
    portraits: int
    masses: int
    draw: Callable[[list[Axes]], None]


def plot_orbit(
    orbit: Orbit,
    kind: str = "time",
    axes: Any = None,
    *,
    periods: int = 1,
    points_per_period: int = 600,
    masses: Iterable[int] | None = None,
) -> Any:
    """Draw an orbit.

    Parameters
    ----------
    orbit : Orbit
    kind : {"time", "velocity", "phase", "strip", "multipliers", "all"}
        Positions or velocities of all masses over time; phase portraits (x, x'); which
        configuration when; multipliers in the unit circle; or all of them.
    axes : Axes or sequence of Axes, optional
        Where to draw: one Axes; for "phase" also one for each mass; for "all" those of time,
        velocity and strip, of portraits, and of multipliers. An orbit with kernels takes one
        Axes for all its portraits then, one without kernels one for each mass. A new figure
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
        A tuple for "all", and for "phase" where there are several.

    Raises
    ------
    InputError
        For an unknown kind or mass, a wrong number of points or Axes, or an orbit that has not
        converged.
    MissingExtra
        If matplotlib is not installed.

    Notes
    -----
    Positions and time are those of the orbit's equations.
    """
    picture = _picture(orbit, kind, periods, points_per_period, masses)
    if axes is None:
        from matplotlib import pyplot

        places = _places(pyplot.figure(figsize=picture.size), kind, picture.portraits)
    else:
        counts = {"all": (4 + picture.portraits,), "phase": tuple(sorted({1, picture.masses}))}
        places = given_axes(axes, kind, counts.get(kind, (1,)))
    picture.draw(places)
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
    """Draw an orbit into a figure of its own, outside pyplot; arguments as for `plot_orbit`."""
    picture = _picture(orbit, kind, periods, points_per_period, masses)
    from matplotlib.figure import Figure

    figure = Figure(figsize=picture.size)
    picture.draw(_places(figure, kind, picture.portraits))
    return figure


def save_figure(figure: Figure, path: str | os.PathLike[str]) -> None:
    """Write a figure as PNG, SVG or PDF; the same figure gives the same bytes.

    Raises
    ------
    InputError
        For another ending, or a file that cannot be written.
    """
    from matplotlib import rc_context

    metadata: dict[str, Any] = {".png": {}, ".svg": {"Date": None}, ".pdf": {"CreationDate": None}}
    ending = Path(path).suffix.lower()
    if ending not in metadata:
        raise InputError(f"{path} does not end in {', '.join(metadata)}")
    try:
        with rc_context({"svg.hashsalt": "nonsmooth"}):
            figure.savefig(path, dpi=200, metadata=metadata[ending])
    except OSError as problem:
        raise unwritable(Path(path), problem) from None


def _picture(
    orbit: Orbit,
    kind: str,
    periods: int,
    points_per_period: int,
    masses: Iterable[int] | None,
) -> Picture:
    """Check what can be checked before anything is drawn."""
    check_picture(kind, KINDS)
    if orbit.problem.kernels is None:
        view = orbit_view(orbit, periods, points_per_period, masses)
        count = len(view.masses)
        size = _SIZES.get(kind, (4.9 * count, 4.4))
        return Picture(size, count, count, lambda places: _draw_view(orbit, view, kind, places))
    motion = orbit_motion(orbit)
    drawn = chosen_masses(masses, len(motion.names) // 2, orbit.name)
    scene = Scene(orbit, motion, motion.sample(points_per_period, periods), drawn)
    size = _SIZES.get(kind, (5.2, 4.4))
    return Picture(size, 1, len(drawn), lambda places: draw(scene, kind, places))


def orbit_view(
    orbit: Orbit, periods: int, points_per_period: int, masses: Iterable[int] | None
) -> View:
    """The motion along an orbit without kernels, as motions are drawn."""
    motion = orbit.trajectory(periods)
    drawn = chosen_masses(masses, len(coordinates_of(motion)), orbit.name)
    points = points_per_period
    if isinstance(points, int) and not isinstance(points, bool):
        points *= periods
    return replace(view_of(motion, drawn, points, orbit.system), name=_title(orbit), closed=True)


def _title(orbit: Orbit) -> str:
    """Name of the orbit."""
    named = isinstance(orbit.problem, TableProblem) and orbit.problem.label is None
    return orbit.name if named else shown_name(orbit.name)


def _draw_view(orbit: Orbit, view: View, kind: str, places: list[Axes]) -> None:
    if kind == "multipliers":
        draw_multipliers(orbit.stability.multipliers, places[0], _title(orbit))
    elif kind == "all":
        draw_multipliers(orbit.stability.multipliers, places[-1], "")
        draw_motion(view, kind, places[:-1])
    else:
        draw_motion(view, kind, places)


def _places(figure: Figure, kind: str, portraits: int) -> list[Axes]:
    """Axes of a new figure."""
    figure.set_layout_engine("constrained", wspace=0.06, hspace=0.02)
    if kind == "phase":
        return [figure.add_subplot(1, portraits, place + 1) for place in range(portraits)]
    if kind != "all":
        return [figure.add_subplot()]
    grid = figure.add_gridspec(3, 2, width_ratios=(1.45, 1), height_ratios=(1, 1, 0.6))
    time = figure.add_subplot(grid[0, 0])
    velocity, strip = (figure.add_subplot(grid[row, 0], sharex=time) for row in (1, 2))
    for upper in (time, velocity):
        upper.tick_params(labelbottom=False)
        upper.xaxis.label.set_visible(False)
    right = grid[:, 1].subgridspec(portraits + 1, 1)
    return [time, velocity, strip, *(figure.add_subplot(right[k]) for k in range(portraits + 1))]

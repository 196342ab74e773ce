"""Pictures of orbits, by matplotlib.

They are drawn into the Axes that are given, or into a new figure.
"""

from __future__ import annotations

import io
import os
from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from nonsmooth.runtime.core.files import check_ending, write_file
from nonsmooth.runtime.model.naming import shown_name
from nonsmooth.runtime.orbits.motion import orbit_motion
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.present.pictures.drawing import check_picture, chosen_masses
from nonsmooth.runtime.present.pictures.kinds import KINDS
from nonsmooth.runtime.present.pictures.layout import draw_into, figure_of
from nonsmooth.runtime.present.pictures.panels import Scene
from nonsmooth.runtime.present.pictures.view import View, coordinates_of, view_of

if TYPE_CHECKING:
    from matplotlib.figure import Figure

__all__ = ["figure_bytes", "orbit_figure", "orbit_view", "plot_orbit", "save_figure"]

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
    """Draw an orbit.

    Parameters
    ----------
    orbit : Orbit
    kind : str
        An entry of `kinds.KINDS`: "time", "velocity", "phase", "strip", "multipliers" or "all".
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
    places = draw_into(_scene(orbit, kind, periods, points_per_period, masses), kind, axes)
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
    """Draw an orbit into a figure of its own, outside pyplot; arguments as for `plot_orbit`.

    Parameters
    ----------
    orbit : Orbit
        Converged.
    kind : str, default "all"
        As for `plot_orbit`.
    periods : int, default 1
        How many are drawn against time.
    points_per_period : int, default 600
        About how many points a period has at least.
    masses : iterable of int, optional
        Numbers of the masses that are drawn, from 0; all by default.

    Returns
    -------
    Figure
        Not shown.

    Raises
    ------
    InputError
        As for `plot_orbit`.
    MissingExtra
        If matplotlib is not installed.
    """
    return figure_of(_scene(orbit, kind, periods, points_per_period, masses), kind)


def save_figure(figure: Figure, path: str | os.PathLike[str]) -> None:
    """Write a figure as PNG, SVG or PDF; the same figure gives the same bytes.

    Parameters
    ----------
    figure : Figure
        Of matplotlib.
    path : str or path
        The file.

    Raises
    ------
    InputError
        For another ending, or a file that cannot be written.
    """
    target = Path(path)
    check_ending(target, tuple(_METADATA))
    write_file(target, figure_bytes(figure, target.suffix.lower()))


def figure_bytes(figure: Figure, ending: str) -> bytes:
    """Content of a file of a figure; the same figure gives the same bytes.

    Parameters
    ----------
    figure : Figure
    ending : str
        ".png", ".svg" or ".pdf".

    Returns
    -------
    bytes
        Content of the file.
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
    """Check what can be checked before anything is drawn."""
    check_picture(kind, tuple(KINDS))
    if orbit.problem.has_trajectory:
        return orbit_view(orbit, periods, points_per_period, masses)
    motion = orbit_motion(orbit)
    drawn = chosen_masses(masses, len(motion.names) // 2, orbit.name)
    return Scene(orbit, motion, motion.sample(points_per_period, periods), drawn)


def orbit_view(
    orbit: Orbit, periods: int, points_per_period: int, masses: Iterable[int] | None
) -> View:
    """The trajectory along an orbit, as motions are drawn.

    Parameters
    ----------
    orbit : Orbit
        Converged.
    periods : int
        How many are drawn.
    points_per_period : int
        About how many points a period has at least.
    masses : iterable of int or None
        Numbers of masses, from 0; None for all.

    Returns
    -------
    View
        Of the whole trajectory.

    Raises
    ------
    InputError
        If there is no such mass.
    """
    motion = orbit.trajectory(periods)
    drawn = chosen_masses(masses, len(coordinates_of(motion)), orbit.name)
    points = points_per_period
    if isinstance(points, int) and not isinstance(points, bool):
        points *= periods
    return view_of(motion, drawn, points, orbit, shown_name(orbit.name))

"""Pictures of orbits, by matplotlib.

They are drawn into the Axes that are given, or into a new figure.
"""

from __future__ import annotations

import os
from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.files import unwritable
from nonsmooth.runtime.orbits.motion import orbit_motion
from nonsmooth.runtime.present.pictures.drawing import check_picture, chosen_masses, given_axes
from nonsmooth.runtime.present.pictures.panels import PANELS, Scene, draw

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from nonsmooth.runtime.orbits.orbit import Orbit

__all__ = ["KINDS", "orbit_figure", "plot_orbit", "save_figure"]

KINDS = ("time", "velocity", "phase", "strip", "multipliers", "all")

_SIZES = {
    "time": (6.4, 3.6),
    "velocity": (6.4, 3.6),
    "phase": (5.2, 4.4),
    "strip": (6.4, 2.2),
    "multipliers": (4.8, 5.0),
    "all": (11.0, 8.0),
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
    kind : {"time", "velocity", "phase", "strip", "multipliers", "all"}
        Positions or velocities of all masses over time; phase portraits (x, x'); which
        configuration when; multipliers in the unit circle; or all of them.
    axes : Axes or sequence of Axes, optional
        Where to draw: one Axes; for "phase" also one for each mass; for "all" five, for
        time, velocity, strip, phase and multipliers. A new figure when omitted.
    periods : int
        How many to draw against time.
    points_per_period : int
    masses : iterable of int, optional
        Which to draw, counted from 0; all when omitted.

    Returns
    -------
    Axes or tuple of Axes
        A tuple for "all", and for "phase" where several were given.

    Raises
    ------
    InputError
        For an unknown kind or mass, a wrong number of Axes, or an orbit that has not
        converged.
    MissingExtra
        If matplotlib is not installed.

    Notes
    -----
    Positions and time are nondimensional, in the coordinates of the orbit's equations.
    """
    scene = _scene(orbit, kind, periods, points_per_period, masses)
    if axes is None:
        from matplotlib import pyplot

        places = _places(pyplot.figure(figsize=_SIZES[kind]), kind)
    else:
        counts = {"all": (len(PANELS),), "phase": tuple(sorted({1, len(scene.masses)}))}
        places = given_axes(axes, kind, counts.get(kind, (1,)))
    draw(scene, kind, places)
    single = kind != "all" and (axes is None or hasattr(axes, "plot"))
    return places[0] if single else tuple(places)


def orbit_figure(
    orbit: Orbit,
    kind: str = "all",
    *,
    periods: int = 1,
    points_per_period: int = 600,
    masses: Iterable[int] | None = None,
) -> Figure:
    """Draw an orbit into a figure of its own, outside pyplot; arguments as for `plot_orbit`."""
    scene = _scene(orbit, kind, periods, points_per_period, masses)
    from matplotlib.figure import Figure

    figure = Figure(figsize=_SIZES[kind])
    draw(scene, kind, _places(figure, kind))
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


def _scene(
    orbit: Orbit,
    kind: str,
    periods: int,
    points_per_period: int,
    masses: Iterable[int] | None,
) -> Scene:
    """Check what can be checked before anything is drawn."""
    check_picture(kind, KINDS)
    motion = orbit_motion(orbit)
    drawn = chosen_masses(masses, len(motion.names) // 2, orbit.name)
    return Scene(orbit, motion, motion.sample(points_per_period, periods), drawn)


def _places(figure: Figure, kind: str) -> list[Axes]:
    """Axes of a new figure."""
    figure.set_layout_engine("constrained", wspace=0.06, hspace=0.02)
    if kind != "all":
        return [figure.add_subplot()]
    grid = figure.add_gridspec(3, 2, width_ratios=(1.45, 1), height_ratios=(1, 1, 0.6))
    time = figure.add_subplot(grid[0, 0])
    velocity, strip = (figure.add_subplot(grid[row, 0], sharex=time) for row in (1, 2))
    for upper in (time, velocity):
        upper.tick_params(labelbottom=False)
        upper.xaxis.label.set_visible(False)
    right = grid[:, 1].subgridspec(2, 1)
    return [time, velocity, strip, figure.add_subplot(right[0]), figure.add_subplot(right[1])]

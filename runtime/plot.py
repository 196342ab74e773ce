"""Pictures of orbits, by matplotlib.

They are drawn into the Axes that are given, or into a new figure. Colours are those of
Okabe and Ito and of Tol, which colour-blind readers can tell apart; lines differ by their
dashes too.
"""

from __future__ import annotations

import math
import os
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.deriving import unwritable
from nonsmooth.runtime.errors import InputError, missing_extra, unknown_name
from nonsmooth.runtime.motion import Motion, Samples, orbit_motion
from nonsmooth.runtime.notebook import symbol
from nonsmooth.runtime.values import parse

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from nonsmooth.runtime.orbit import Orbit

__all__ = [
    "KINDS",
    "orbit_figure",
    "plot_orbit",
    "save_figure",
]

KINDS = ("time", "velocity", "phase", "strip", "multipliers", "all")
PANELS = ("time", "velocity", "strip", "phase", "multipliers")  # of "all", in this order

_UNIT = "(nondimensional)"
_MASSES = (("#0072B2", "-"), ("#D55E00", (0, (5, 1.6))), ("#009E73", "-."), ("#CC79A7", ":"))
_CONFIGURATIONS = (
    *("#99DDFF", "#EEDD88", "#FFAABB", "#BBCC33", "#DDDDDD"),
    *("#EE8866", "#77AADD", "#44BB99", "#AAAA00"),
)
_SIZES = {
    "time": (6.4, 3.6),
    "velocity": (6.4, 3.6),
    "phase": (5.2, 4.4),
    "strip": (6.4, 2.2),
    "multipliers": (4.2, 4.6),
    "all": (11.0, 8.0),
}
_MARKERS = ("o", "s", "D", "^")
_PHASE_POINTS = 1200
_CONSTANT = 1e-9  # relative change of a velocity that is held


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
        places = _given(axes, kind, len(scene.masses))
    _draw(scene, kind, places)
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
    _draw(scene, kind, _places(figure, kind))
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


@dataclass(frozen=True)
class _Scene:
    """What every picture of one orbit needs."""

    orbit: Orbit
    motion: Motion
    samples: Samples
    masses: tuple[int, ...]
    composed: bool = False

    @property
    def count(self) -> int:
        """Number of all masses."""
        return len(self.motion.names) // 2

    @property
    def positions(self) -> list[str]:
        """Labels of the positions that are drawn."""
        return [f"${symbol(self.motion.names[mass])}$" for mass in self.masses]

    @property
    def velocities(self) -> list[str]:
        """Labels of the velocities that are drawn: derivatives of the positions."""
        return [f"${symbol(self.motion.names[mass])}'$" for mass in self.masses]

    def levels(self, *, moving: bool) -> dict[float, str]:
        """Values, and their labels, at which boundaries in the drawn states lie."""
        found = {}
        table = self.motion.kernels.table["levels"]
        for mass in self.masses:
            name = self.motion.names[mass + moving * self.count]
            text = table.get(name)
            if text in self.orbit.values:
                found[float(self.orbit.values[text])] = f"${symbol(text)}$"
            elif text is not None:
                found[float(parse(text))] = f"${symbol(name)} = {text}$"
        return found

    def color(self, phase: int) -> str:
        """Colour of a phase's configuration, the same in all pictures of the system."""
        known = self.motion.kernels.system.configurations
        place = known.index(self.motion.configurations[phase])
        return _CONFIGURATIONS[place % len(_CONFIGURATIONS)]

    def phases(self) -> Iterator[tuple[int, float, float]]:
        """Each phase that is drawn against time: its number, start and end."""
        breaks, period = self.motion.breaks, self.motion.period
        for start in np.arange(round(self.samples.times[-1] / period)) * period:
            for phase, (begin, end) in enumerate(pairwise(breaks)):
                yield phase, float(start + begin), float(start + end)


def _scene(
    orbit: Orbit,
    kind: str,
    periods: int,
    points_per_period: int,
    masses: Iterable[int] | None,
) -> _Scene:
    """Check what can be checked before anything is drawn."""
    if kind not in KINDS:
        raise unknown_name("kind of picture", kind, KINDS)
    try:
        import matplotlib  # noqa: F401
    except ImportError:
        raise missing_extra("plot", "matplotlib") from None
    motion = orbit_motion(orbit)
    every = range(len(motion.names) // 2)
    drawn = tuple(every if masses is None else masses)
    if not drawn or not set(drawn) <= set(every):
        raise InputError(f"masses = {list(drawn)}: {orbit.name} has {list(every)}")
    return _Scene(orbit, motion, motion.sample(points_per_period, periods), drawn)


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


def _given(axes: Any, kind: str, masses: int) -> list[Axes]:
    """Axes that a caller gave, as many as the kind takes."""
    places: list[Axes] = list(np.ravel(np.asarray(axes, dtype=object)))
    counts = {"all": (len(PANELS),), "phase": tuple(sorted({1, masses}))}.get(kind, (1,))
    if len(places) not in counts or not all(hasattr(place, "plot") for place in places):
        raise InputError(
            f"{kind!r} is drawn into {' or '.join(map(str, counts))} Axes;"
            f" given: {len(places)} {type(places[0]).__name__ if places else 'objects'}"
        )
    return places


def _draw(scene: _Scene, kind: str, places: Sequence[Axes]) -> None:
    if kind == "all":
        places[0].figure.suptitle(scene.orbit.name)
        for panel, place in zip(PANELS, places, strict=True):
            _draw(replace(scene, composed=True), panel, [place])
    elif kind == "phase":
        _draw_phase(scene, places)
    elif kind == "strip":
        _draw_strip(scene, places[0])
    elif kind == "multipliers":
        _draw_multipliers(scene, places[0])
    else:
        _draw_history(scene, places[0], moving=kind == "velocity")


def _draw_history(scene: _Scene, axes: Axes, *, moving: bool) -> None:
    """Draw all positions over time, or all velocities."""
    labels = scene.velocities if moving else scene.positions
    samples = scene.samples
    switches = np.flatnonzero(np.diff(samples.times) == 0)
    for mass, label in zip(scene.masses, labels, strict=True):
        style = _line(mass)
        values = samples.states[:, mass + moving * scene.count]
        axes.plot(samples.times, values, label=label, **style)
        axes.plot(samples.times[switches], values[switches], **_dots(style))
    _draw_levels(axes, scene.levels(moving=moving))
    for phase, begin, end in scene.phases():
        name = scene.motion.configurations[phase]
        fresh = begin < scene.motion.period and name not in scene.motion.configurations[:phase]
        label = name if fresh and not scene.composed else ""
        axes.axvspan(begin, end, color=scene.color(phase), alpha=0.35, linewidth=0, label=label)
        if begin:
            axes.axvline(begin, color="0.5", linewidth=0.6)
    axes.set_xlim(samples.times[0], samples.times[-1])
    axes.set_xlabel(f"time $t$ {_UNIT}")
    axes.set_ylabel(f"{_noun('velocity' if moving else 'position', labels)}\n{_UNIT}")
    _finish(scene, axes)


def _draw_phase(scene: _Scene, places: Sequence[Axes]) -> None:
    """Draw the phase portraits, all in one or each in Axes of its own."""
    positions, velocities = scene.positions, scene.velocities
    samples = scene.motion.sample(_PHASE_POINTS)
    switches = np.flatnonzero(np.diff(samples.times, prepend=samples.times[0] - 1) == 0)
    sticking = set()
    for place, mass in enumerate(scene.masses):
        axes, style = places[place % len(places)], _line(mass)
        x, v = samples.states[:, mass], samples.states[:, scene.count + mass]
        axes.plot(x, v, label=f"({positions[place]}, {velocities[place]})", **style)
        for phase in np.unique(samples.phases):
            here = samples.phases == phase
            if np.ptp(v[here]) <= _CONSTANT * (1 + np.abs(v).max()) and np.ptp(x[here]) > 0:
                axes.plot(x[here], v[here], **_band(style["color"]))
                sticking.add(axes)
        axes.plot(x[[0, *switches]], v[[0, *switches]], **_dots(style))
        _draw_arrow(axes, x, v, style)
    for place, axes in enumerate(places):
        drawn = slice(None) if len(places) == 1 else slice(place, place + 1)
        if axes in sticking:
            axes.plot([], [], label="sticking", **_band("0.3"))
        shown = replace(scene, masses=scene.masses[drawn])
        _draw_levels(axes, shown.levels(moving=True))
        _draw_levels(axes, shown.levels(moving=False), upright=True)
        axes.set_xlabel(f"{_noun('position', positions[drawn])} {_UNIT}")
        axes.set_ylabel(f"{_noun('velocity', velocities[drawn])} {_UNIT}")
        axes.margins(0.07)
        _finish(scene, axes)


def _draw_strip(scene: _Scene, axes: Axes) -> None:
    """Draw a row for each configuration, with a bar where it is the present one."""
    rows = list(dict.fromkeys(scene.motion.configurations))
    dwell_times = list(scene.orbit.dwell_times)
    for phase, begin, end in scene.phases():
        row = rows.index(scene.motion.configurations[phase])
        bar = axes.barh(row, end - begin, height=0.72, left=begin, color=scene.color(phase))
        bar.patches[0].set(edgecolor="0.3", linewidth=0.6)
        if begin:
            axes.axvline(begin, color="0.5", linewidth=0.6, zorder=0)
        name, middle = symbol(dwell_times[phase]), ((begin + end) / 2, row)
        label, side = (f"${name}$", "center") if end > begin else (f"${name} = 0$", "left")
        style = {"ha": side, "va": "center", "fontsize": "small", "clip_on": True}
        axes.annotate(label, middle, (3 * (end == begin), 0), textcoords="offset points", **style)
    axes.set_yticks(range(len(rows)), rows)
    axes.set_ylim(len(rows) - 0.4, -0.6)
    axes.set_xlim(scene.samples.times[0], scene.samples.times[-1])
    axes.set_xlabel(f"time $t$ {_UNIT}")
    axes.set_ylabel("configuration")
    _finish(scene, axes)


def _draw_multipliers(scene: _Scene, axes: Axes) -> None:
    """Draw the multipliers and the unit circle."""
    stability = scene.orbit.stability
    angle = np.linspace(0, 2 * np.pi, 361)
    axes.fill(np.cos(angle), np.sin(angle), color="0.95", zorder=0)
    axes.plot(np.cos(angle), np.sin(angle), color="0.35", linewidth=0.8)
    axes.axhline(0, color="0.75", linewidth=0.6, zorder=0.5)
    axes.axvline(0, color="0.75", linewidth=0.6, zorder=0.5)
    extent = 1.0
    for number, multiplier in enumerate(stability.multipliers, 1):
        real, imaginary = float(multiplier.real), float(multiplier.imaginary)
        value = f"{real:.6g}" + (f"{imaginary:+.6g}\\,\\mathrm{{i}}" if imaginary else "")
        color = _line(number - 1)["color"]
        axes.plot(
            [real],
            [imaginary],
            linestyle="none",
            marker=_MARKERS[(number - 1) % len(_MARKERS)],
            color=color,
            markerfacecolor="none" if multiplier.trivial else color,
            label=f"$\\mu_{{{number}}} = {value}$" + ", trivial" * multiplier.trivial,
        )
        extent = max(extent, abs(real), abs(imaginary))
    axes.set_xlim(-1.15 * extent, 1.15 * extent)
    axes.set_ylim(-1.15 * extent, 1.15 * extent)
    axes.set_aspect("equal")
    axes.set_xlabel(r"$\mathrm{Re}\,\mu$ " + _UNIT)
    axes.set_ylabel(r"$\mathrm{Im}\,\mu$ " + _UNIT)
    _finish(scene, axes)


def _draw_levels(axes: Axes, levels: Mapping[float, str], *, upright: bool = False) -> None:
    """Draw lines where boundaries lie: across the Axes, or upright."""
    line = {"color": "0.3", "linewidth": 0.9, "linestyle": ":", "zorder": 1.4}
    for level, label in levels.items():
        if upright:
            axes.axvline(level, **line)
            place, offset, transform = (level, 1), (3, -3), axes.get_xaxis_transform()
        else:
            axes.axhline(level, **line)
            place, offset, transform = (1, level), (3, 0), axes.get_yaxis_transform()
        axes.annotate(
            label, place, offset, transform, "offset points", va="top" if upright else "center"
        )


def _draw_arrow(axes: Axes, x: np.ndarray, v: np.ndarray, style: Mapping[str, Any]) -> None:
    """Show the direction of the motion, where the velocity is lowest."""
    place = min(max(int(np.argmin(v)), 1), len(v) - 1)
    arrow = {"arrowstyle": "-|>", "color": style["color"], "linewidth": 0, "mutation_scale": 16}
    axes.annotate("", (x[place], v[place]), (x[place - 1], v[place - 1]), arrowprops=arrow)


def _finish(scene: _Scene, axes: Axes) -> None:
    """Title, and a legend between it and the frame, where it covers no curve."""
    _, labels = axes.get_legend_handles_labels()
    columns = _columns(axes, labels)
    if labels:
        axes.legend(
            loc="lower left",
            bbox_to_anchor=(0, 1),
            ncols=columns,
            frameon=False,
            fontsize="small",
            borderpad=0.1,
            borderaxespad=0.3,
            handlelength=2.2,
            columnspacing=1.2,
            handletextpad=0.5,
        )
    if not scene.composed:
        rows = math.ceil(len(labels) / columns)
        axes.set_title(scene.orbit.name, loc="left", fontsize="medium", pad=6 + 14 * rows)
    axes.spines[["top", "right"]].set_visible(False)


def _columns(axes: Axes, labels: Sequence[str]) -> int:
    """As many columns of a legend as are about as wide as the Axes."""
    room = axes.bbox.width / axes.figure.dpi
    inches = [0.45 + 0.066 * len(re.sub(r"[$\\{}_^]|mathrm", "", label)) for label in labels]
    for columns in range(len(labels), 1, -1):
        if sum(max(column) for column in np.array_split(inches, columns)) <= room:
            return columns
    return 1


def _line(mass: int) -> dict[str, Any]:
    color, dashes = _MASSES[mass % len(_MASSES)]
    return {"color": color, "linestyle": dashes, "linewidth": 1.6}


def _band(color: str) -> dict[str, Any]:
    """Style of the parts in which a mass sticks."""
    shape = {"linewidth": 6, "alpha": 0.3, "solid_capstyle": "butt", "zorder": 1.5}
    return {**shape, "color": color}


def _dots(style: Mapping[str, Any]) -> dict[str, Any]:
    """Style of the marks at the transitions."""
    shape = {"linestyle": "none", "marker": "o", "markersize": 4.5, "zorder": 3}
    return {**shape, "markerfacecolor": "white", "markeredgecolor": style["color"]}


def _noun(noun: str, labels: Sequence[str]) -> str:
    plural = {"position": "positions", "velocity": "velocities"}[noun]
    return f"{noun if len(labels) == 1 else plural} {', '.join(labels)}"

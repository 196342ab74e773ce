"""What is drawn into one Axes: histories, portraits, configurations, multipliers.

Colours are those of Okabe and Ito and of Tol, which colour-blind readers can tell apart;
lines differ by their dashes too.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.motion import Motion, Samples
from nonsmooth.runtime.notebook import symbol
from nonsmooth.runtime.values import parse

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from nonsmooth.runtime.orbit import Orbit

__all__ = ["PANELS", "Scene", "draw"]

PANELS = ("time", "velocity", "strip", "phase", "multipliers")  # of "all", in this order

_UNIT = "(nondimensional)"
_MASSES = (("#0072B2", "-"), ("#D55E00", (0, (5, 1.6))), ("#009E73", "-."), ("#CC79A7", ":"))
_CONFIGURATIONS = (
    *("#99DDFF", "#EEDD88", "#FFAABB", "#BBCC33", "#DDDDDD"),
    *("#EE8866", "#77AADD", "#44BB99", "#AAAA00"),
)
_MARKERS = ("o", "s", "D", "^")
_PHASE_POINTS = 1200
_CONSTANT = 1e-9  # relative change of a velocity that is held


@dataclass(frozen=True)
class Scene:
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


def draw(scene: Scene, kind: str, places: Sequence[Axes]) -> None:
    """Draw one kind of picture, or all, into as many Axes as it takes."""
    if kind == "all":
        places[0].figure.suptitle(scene.orbit.name)
        for panel, place in zip(PANELS, places, strict=True):
            draw(replace(scene, composed=True), panel, [place])
    elif kind == "phase":
        _draw_phase(scene, places)
    elif kind == "strip":
        _draw_strip(scene, places[0])
    elif kind == "multipliers":
        _draw_multipliers(scene, places[0])
    else:
        _draw_history(scene, places[0], moving=kind == "velocity")


def _draw_history(scene: Scene, axes: Axes, *, moving: bool) -> None:
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


def _draw_phase(scene: Scene, places: Sequence[Axes]) -> None:
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


def _draw_strip(scene: Scene, axes: Axes) -> None:
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
        style: dict[str, Any] = {"ha": side, "va": "center", "fontsize": "small", "clip_on": True}
        axes.annotate(label, middle, (3 * (end == begin), 0), textcoords="offset points", **style)
    axes.set_yticks(range(len(rows)), rows)
    axes.set_ylim(len(rows) - 0.4, -0.6)
    axes.set_xlim(scene.samples.times[0], scene.samples.times[-1])
    axes.set_xlabel(f"time $t$ {_UNIT}")
    axes.set_ylabel("configuration")
    _finish(scene, axes)


def _draw_multipliers(scene: Scene, axes: Axes) -> None:
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
    line: dict[str, Any] = {"color": "0.3", "linewidth": 0.9, "linestyle": ":", "zorder": 1.4}
    for level, label in levels.items():
        if upright:
            axes.axvline(level, **line)
            place, offset, transform = (level, 1.0), (3, -3), axes.get_xaxis_transform()
        else:
            axes.axhline(level, **line)
            place, offset, transform = (1.0, level), (3, 0), axes.get_yaxis_transform()
        side = "top" if upright else "center"
        axes.annotate(label, place, offset, transform, "offset points", va=side)


def _draw_arrow(axes: Axes, x: np.ndarray, v: np.ndarray, style: Mapping[str, Any]) -> None:
    """Show the direction of the motion, where the velocity is lowest."""
    place = min(max(int(np.argmin(v)), 1), len(v) - 1)
    arrow = {"arrowstyle": "-|>", "color": style["color"], "linewidth": 0, "mutation_scale": 16}
    axes.annotate("", (x[place], v[place]), (x[place - 1], v[place - 1]), arrowprops=arrow)


def _finish(scene: Scene, axes: Axes) -> None:
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

"""What is drawn of an orbit into one Axes: histories, portraits, configurations, multipliers."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.core.values import parse
from nonsmooth.runtime.model.naming import NO_UNIT, Units, shown_name, symbol, units_of, with_unit
from nonsmooth.runtime.orbits.motion import Motion, Samples
from nonsmooth.runtime.present.pictures.drawing import (
    band_style,
    configuration_color,
    dot_style,
    draw_arrow,
    draw_levels,
    finish,
    fits,
    line_style,
    mark_style,
    noun,
    tex_number,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from nonsmooth.runtime.orbits.orbit import Orbit
    from nonsmooth.runtime.present.pictures.view import View

__all__ = [
    "Scene",
    "draw_multipliers",
    "draw_portraits",
    "draw_positions",
    "draw_strip",
    "draw_velocities",
]

_PHASE_POINTS = 1200
_CONSTANT = 1e-9  # relative change of a velocity that is held


@dataclass(frozen=True)
class Scene:
    """An orbit with its samples, as all its pictures need it."""

    orbit: Orbit
    motion: Motion
    samples: Samples
    masses: tuple[int, ...]
    composed: bool = False  # whether the picture is one part of several
    portraits = 1  # in a new figure

    @property
    def title(self) -> str:
        """Title of the picture; empty if it is one part of several."""
        return "" if self.composed else shown_name(self.orbit.name)

    @property
    def units(self) -> Units:
        """Units that the system declares."""
        return units_of(self.orbit.system)

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
        """Values, with labels, of boundaries in the drawn positions, or velocities if `moving`.

        The values are in the state's units.
        """
        found = {}
        table = self.orbit.kernels.table["levels"]
        for mass in self.masses:
            name = self.motion.names[mass + moving * self.count]
            text = table.get(name)
            if text in self.orbit.values:
                found[float(self.orbit.values[text])] = f"${symbol(text)}$"
            elif text is not None:
                found[float(parse(text))] = f"${symbol(name)} = {text}$"
        return found

    def color(self, phase: int) -> str:
        """Colour of the configuration of a phase (from 0), the same in all pictures of a system."""
        known = self.orbit.system.configurations
        place = known.index(self.motion.configurations[phase])
        return configuration_color(place)

    def phases(self) -> Iterator[tuple[int, float, float]]:
        """Yield each phase that is drawn against time: its number, start and end.

        Times are in the system's units.
        """
        breaks, period = self.motion.breaks, self.motion.period
        for start in np.arange(round(self.samples.times[-1] / period)) * period:
            for phase, (begin, end) in enumerate(pairwise(breaks)):
                yield phase, float(start + begin), float(start + end)


def draw_positions(scene: Scene, places: Sequence[Axes]) -> None:
    """Draw the positions over time into the first Axes."""
    _draw_history(scene, places[0], moving=False)


def draw_velocities(scene: Scene, places: Sequence[Axes]) -> None:
    """Draw the velocities over time into the first Axes."""
    _draw_history(scene, places[0], moving=True)


def _draw_history(scene: Scene, axes: Axes, *, moving: bool) -> None:
    """Draw all positions over time, or all velocities."""
    labels = scene.velocities if moving else scene.positions
    samples = scene.samples
    switches = np.flatnonzero(np.diff(samples.times) == 0)
    for mass, label in zip(scene.masses, labels, strict=True):
        style = line_style(mass)
        values = samples.states[:, mass + moving * scene.count]
        axes.plot(samples.times, values, label=label, **style)
        axes.plot(samples.times[switches], values[switches], **dot_style(style))
    draw_levels(axes, scene.levels(moving=moving))
    for phase, begin, end in scene.phases():
        name = scene.motion.configurations[phase]
        fresh = begin < scene.motion.period and name not in scene.motion.configurations[:phase]
        label = name if fresh and not scene.composed else ""
        axes.axvspan(begin, end, color=scene.color(phase), alpha=0.35, linewidth=0, label=label)
        if begin:
            axes.axvline(begin, color="0.5", linewidth=0.6)
    axes.set_xlim(samples.times[0], samples.times[-1])
    axes.set_xlabel(scene.units.text("time $t$"))
    axes.set_ylabel(scene.units.text(noun("velocity" if moving else "position", labels), "\n"))
    finish(axes, scene.title)


def draw_portraits(scene: Scene, places: Sequence[Axes]) -> None:
    """Draw the phase portraits, all in one Axes or each in its own."""
    positions, velocities = scene.positions, scene.velocities
    samples = scene.motion.sample(_PHASE_POINTS)
    switches = np.flatnonzero(np.diff(samples.times, prepend=samples.times[0] - 1) == 0)
    sticking = set()
    for place, mass in enumerate(scene.masses):
        axes, style = places[place % len(places)], line_style(mass)
        x, v = samples.states[:, mass], samples.states[:, scene.count + mass]
        axes.plot(x, v, label=f"({positions[place]}, {velocities[place]})", **style)
        for phase in np.unique(samples.phases):
            here = samples.phases == phase
            if np.ptp(v[here]) <= _CONSTANT * (1 + np.abs(v).max()) and np.ptp(x[here]) > 0:
                axes.plot(x[here], v[here], **band_style(style["color"]))
                sticking.add(axes)
        axes.plot(x[[0, *switches]], v[[0, *switches]], **dot_style(style))
        draw_arrow(axes, x, v, style)
    for place, axes in enumerate(places):
        drawn = slice(None) if len(places) == 1 else slice(place, place + 1)
        if axes in sticking:
            axes.plot([], [], label="sticking", **band_style("0.3"))
        shown = replace(scene, masses=scene.masses[drawn])
        draw_levels(axes, shown.levels(moving=True))
        draw_levels(axes, shown.levels(moving=False), upright=True)
        axes.set_xlabel(scene.units.text(noun("position", positions[drawn])))
        axes.set_ylabel(scene.units.text(noun("velocity", velocities[drawn])))
        axes.margins(0.07)
        finish(axes, scene.title)


def draw_strip(scene: Scene, places: Sequence[Axes]) -> None:
    """Draw a row for each configuration, with bars for the time in it."""
    axes = places[0]
    rows = list(dict.fromkeys(scene.motion.configurations))
    dwell_times = scene.orbit.dwell_time_names
    for phase, begin, end in scene.phases():
        row = rows.index(scene.motion.configurations[phase])
        bar = axes.barh(row, end - begin, height=0.72, left=begin, color=scene.color(phase))
        bar.patches[0].set(edgecolor="0.3", linewidth=0.6)
        if begin:
            axes.axvline(begin, color="0.5", linewidth=0.6, zorder=0)
        name, middle = symbol(dwell_times[phase]), ((begin + end) / 2, row)
        label, side = (f"${name}$", "center") if end > begin else (f"${name} = 0$", "left")
        room = end - begin if end > begin else scene.motion.period
        if not fits(label, axes, room / float(scene.samples.times[-1])):
            continue
        style: dict[str, Any] = {"ha": side, "va": "center", "fontsize": "small", "clip_on": True}
        axes.annotate(label, middle, (3 * (end == begin), 0), textcoords="offset points", **style)
    axes.set_yticks(range(len(rows)), rows)
    axes.set_ylim(len(rows) - 0.4, -0.6)
    axes.set_xlim(scene.samples.times[0], scene.samples.times[-1])
    axes.set_xlabel(scene.units.text("time $t$"))
    axes.set_ylabel("configuration")
    finish(axes, scene.title)


def draw_multipliers(scene: Scene | View, places: Sequence[Axes]) -> None:
    """Draw the multipliers of an orbit and the unit circle into the first Axes."""
    assert scene.orbit is not None
    axes = places[0]
    angle = np.linspace(0, 2 * np.pi, 361)
    axes.fill(np.cos(angle), np.sin(angle), color="0.95", zorder=0)
    axes.plot(np.cos(angle), np.sin(angle), color="0.35", linewidth=0.8)
    axes.axhline(0, color="0.75", linewidth=0.6, zorder=0.5)
    axes.axvline(0, color="0.75", linewidth=0.6, zorder=0.5)
    extent = 1.0
    for number, multiplier in enumerate(scene.orbit.stability.multipliers, 1):
        real, imaginary = float(multiplier.real), float(multiplier.imaginary)
        value = tex_number(real)
        if imaginary:
            value += f"{'+' * (imaginary > 0)}{tex_number(imaginary)}\\,\\mathrm{{i}}"
        style = mark_style(number - 1)
        axes.plot(
            [real],
            [imaginary],
            markerfacecolor="none" if multiplier.trivial else style["color"],
            label=f"$\\mu_{{{number}}} = {value}$" + ", trivial" * multiplier.trivial,
            **style,
        )
        extent = max(extent, abs(real), abs(imaginary))
    axes.set_xlim(-1.15 * extent, 1.15 * extent)
    axes.set_ylim(-1.15 * extent, 1.15 * extent)
    axes.set_aspect("equal")
    axes.set_xlabel(with_unit(r"$\mathrm{Re}\,\mu$", NO_UNIT))
    axes.set_ylabel(with_unit(r"$\mathrm{Im}\,\mu$", NO_UNIT))
    finish(axes, scene.title)

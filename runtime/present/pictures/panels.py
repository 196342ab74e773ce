"""What is drawn of a motion into one Axes: histories, portraits, configurations, multipliers."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.model.naming import NO_UNIT, symbol, with_unit
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
from nonsmooth.runtime.present.pictures.view import BINS, MANY, View

if TYPE_CHECKING:
    from matplotlib.axes import Axes


_BAND = 0.12  # of the height of a history, for shares of time
_PIECE = 64  # points of a curve that are drawn at once
_JUMP = 1e-9  # relative change of a state in an impact


def draw_positions(view: View, places: Sequence[Axes]) -> None:
    """Draw the positions over time into the first Axes."""
    _draw_history(view, places[0], moving=False)


def draw_velocities(view: View, places: Sequence[Axes]) -> None:
    """Draw the velocities over time into the first Axes."""
    _draw_history(view, places[0], moving=True)


def _draw_history(view: View, axes: Axes, *, moving: bool) -> None:
    """Draw all positions over time, or all velocities.

    Of a system of the first order, a picture of its own has all states.
    """
    drawn = view.drawn(moving=moving)
    if not (view.oscillates or view.composed):
        drawn = list(dict.fromkeys([*drawn, *view.drawn(moving=True)]))
    switches = np.flatnonzero(np.diff(view.times) == 0)
    styles = view.masses if view.oscillates else range(len(drawn))
    for place, (state, label) in zip(styles, drawn, strict=True):
        style = line_style(place)
        values = view.states[:, state]
        if view.dense:
            _draw_range(view, axes, values, label, style)
            continue
        axes.plot(view.times, values, label=label, **style)
        if len(switches) <= MANY / 4:
            axes.plot(view.times[switches], values[switches], **dot_style(style))
    axes.margins(y=0.07)
    _draw_background(view, axes)
    draw_levels(axes, view.levels_of(drawn))
    axes.set_xlim(0, view.end)
    shown = noun(view.noun(moving=moving), [label for _, label in drawn])
    finish(axes, view.title, view.units.text("time $t$"), view.units.text(shown, "\n"))


def _draw_range(
    view: View, axes: Axes, values: np.ndarray, label: str, style: dict[str, Any]
) -> None:
    """Draw the range of a curve in each bin of time."""
    edges = np.linspace(0, view.end, BINS + 1)
    starts = np.clip(np.searchsorted(view.times, edges[:-1]), 0, len(values) - 1)
    low, high = np.minimum.reduceat(values, starts), np.maximum.reduceat(values, starts)
    middles = (edges[:-1] + edges[1:]) / 2
    axes.fill_between(middles, low, high, color=style["color"], alpha=0.3, linewidth=0)
    thin = {**style, "linewidth": 0.9}
    axes.plot(middles, low, **thin)
    axes.plot(middles, high, label=f"{label}, range", **thin)


def _draw_background(view: View, axes: Axes) -> None:
    """Colour the background by configuration; with many transitions, draw shares of time below."""
    names = view.structure.configurations
    upright = axes.get_xaxis_transform()
    shape: dict[str, Any] = {"transform": upright, "linewidth": 0, "zorder": 0.5}
    alpha = 1.0 if view.many else 0.4
    edges, shares = view.shares() if view.many else (np.zeros(0), np.zeros((0, 0)))
    below = np.zeros(len(shares))
    for place, configuration in enumerate(view.present):
        style = {**shape, "color": configuration_color(configuration), "alpha": alpha}
        if view.many:
            above = below + _BAND * shares[:, place]
            axes.stairs(above, edges, baseline=below, fill=True, **style)
            below = above
        else:
            axes.broken_barh(view.bars(configuration), (0, 1), **style)
        if not view.composed:
            label = names[configuration] + ", share" * view.many
            axes.fill_between([], [], color=style["color"], alpha=alpha, linewidth=0, label=label)
    if view.many:
        low, high = axes.get_ylim()
        axes.set_ylim(low - (high - low) * _BAND / (1 - _BAND), high)
    else:
        axes.vlines(
            view.breaks[1:-1], 0, 1, color="0.5", linewidth=0.5, transform=upright, zorder=0.6
        )


def draw_strip(view: View, places: Sequence[Axes]) -> None:
    """Draw a row for each configuration, with bars for the time in it.

    With many transitions, the bars are as high as the share of time in each bin.
    """
    axes = places[0]
    names = view.structure.configurations
    for row, configuration in enumerate(view.present):
        bars = view.bars(configuration)
        color = configuration_color(configuration)
        if view.many:
            edges, shares = view.shares()
            half = 0.4 * shares[:, row]
            axes.stairs(row + half, edges, baseline=row - half, fill=True, color=color)
        else:
            axes.broken_barh(bars, (row - 0.36, 0.72), color=color, edgecolor="0.3", linewidth=0.5)
        part = sum(length for _, length in bars) / view.end
        axes.annotate(
            f"{100 * part:.1f} %",
            (1.0, row),
            (4, 0),
            axes.get_yaxis_transform(),
            "offset points",
            va="center",
            fontsize="small",
        )
    if view.orbit is not None and not view.many:
        _name_dwell_times(view, axes, view.orbit.dwell_time_names)
    axes.set_yticks(range(len(view.present)), [names[c] for c in view.present])
    axes.set_ylim(len(view.present) - 0.4, -0.6)
    axes.set_xlim(0, view.end)
    finish(axes, view.title, view.units.text("time $t$"), "configuration")


def _name_dwell_times(view: View, axes: Axes, names: Sequence[str]) -> None:
    """Write the symbols of an orbit's dwell times on the bars of a strip that have room."""
    for phase, (begin, end) in enumerate(pairwise(view.breaks.tolist())):
        row = view.present.index(view.configurations[phase])
        name, brief = symbol(names[phase % len(names)]), end == begin
        label, side = (f"${name} = 0$", "left") if brief else (f"${name}$", "center")
        if fits(label, axes, 1.0 if brief else (end - begin) / view.end):
            axes.annotate(
                label,
                ((begin + end) / 2, row),
                (3 * brief, 0),
                textcoords="offset points",
                ha=side,
                va="center",
                fontsize="small",
                clip_on=True,
            )


def draw_portraits(view: View, places: Sequence[Axes]) -> None:
    """Draw the phase portraits, all in one Axes or each in its own."""
    for place, mass in enumerate(view.masses):
        _draw_portrait(view, places[place % len(places)], place, mass)
    for place, axes in enumerate(places):
        drawn = slice(None) if len(places) == 1 else slice(place, place + 1)
        shown = replace(view, masses=view.masses[drawn])
        draw_levels(axes, view.levels_of(shown.drawn(moving=True)))
        draw_levels(axes, view.levels_of(shown.drawn(moving=False)), upright=True)
        texts = (
            view.units.text(noun(view.noun(moving=moving), labels))
            for moving, labels in ((False, shown.positions), (True, shown.velocities))
        )
        axes.margins(0.07)
        finish(axes, view.title if place == 0 else " " * bool(view.title), *texts)


def _draw_portrait(view: View, axes: Axes, place: int, mass: int) -> None:
    """Draw the phase portrait of one mass."""
    style = line_style(mass)
    both = list(view.coordinates[mass])
    points, switches = view.states[:, both], np.flatnonzero(np.diff(view.times) == 0)
    before, behind = points[switches], points[switches + 1]
    sizes = 1 + np.abs(points).max(axis=0)
    jumps = (np.abs(behind - before) > _JUMP * sizes).any(axis=1)
    held = [both[0] in view.structure.held[c] for c in view.configurations]
    label = f"({view.positions[place]}, {view.velocities[place]})"
    if len(view.configurations) > 1 + MANY / 10:
        style = {**style, "linestyle": "-", "linewidth": 0.9}
    parts = np.split(points, switches + 1)
    _draw_lines(axes, parts, label, style, dense=view.dense)
    riding = _riding(view, points, np.array(held))
    if np.isfinite(riding).any():
        wide: dict[str, Any] = {"linewidth": 3} if view.dense else {}
        axes.plot(*riding.T, **{**band_style(style["color"]), **wide})
        axes.plot([], [], label="sticking", **band_style("0.3"))
    if jumps.any():
        dashed = {**style, "linestyle": (0, (3, 2)), "linewidth": 1.1}
        lines = np.stack([before[jumps], behind[jumps]], axis=1)
        _draw_lines(axes, list(lines), "impact", dashed, dense=view.dense)
    if len(switches) <= MANY / 4:
        closed = [] if view.orbit is None else [0, -1]  # an orbit begins behind a transition
        axes.plot(*points[[*switches, *(switches + 1), *closed]].T, **dot_style(style))
    if not view.dense:
        lowest = int(np.searchsorted(switches, np.argmin(points[:, 1])))
        if len(parts[lowest]) > 2:
            draw_arrow(axes, parts[lowest][:, 0], parts[lowest][:, 1], style)
    if view.orbit is not None:
        return
    ends: dict[str, Any] = {"linestyle": "none", "color": "black", "zorder": 4}
    axes.plot(*points[:1].T, marker="x", markersize=7, label="start", **ends)
    axes.plot(*points[-1:].T, marker="s", markersize=5, label="end", **ends)


def _draw_lines(
    axes: Axes, parts: list[np.ndarray], label: str, style: dict[str, Any], *, dense: bool
) -> None:
    """Draw curves (n, 2); if they are dense, each is so faint that the density shows."""
    if not dense:
        gap = np.full((1, 2), np.nan)
        joined = [piece for part in parts for piece in (part, gap)][:-1]
        axes.plot(*np.concatenate(joined).T, label=label, **style)
        return
    from matplotlib.collections import LineCollection

    cuts = [cut for part in parts for cut in _short(part)]
    faint = {"linewidths": 0.5, "alpha": float(np.clip(100 / len(cuts), 0.09, 0.5))}
    lines = LineCollection(cuts, colors=style["color"], rasterized=True, **faint)
    axes.add_collection(lines)
    axes.autoscale_view()
    axes.plot([], [], label=label, **style)


def _short(curve: np.ndarray) -> list[np.ndarray]:
    """Pieces of a long curve, each of which begins with the last point of the one before."""
    return [curve[low : low + _PIECE + 1] for low in range(0, max(len(curve) - 1, 1), _PIECE)]


def _riding(view: View, points: np.ndarray, held: np.ndarray) -> np.ndarray:
    """Points (n, 2) at which a mass is held and moves, with NaN between the phases."""
    phase = np.searchsorted(view.breaks[:-1], view.times, side="right") - 1
    # the first of the two points at a transition ends a phase
    phase[:-1] -= (np.diff(view.times) == 0) & (phase[:-1] > 0)
    found = np.where(held[phase][:, None], points, np.nan)
    edges = np.flatnonzero(np.diff(phase)) + 1
    return np.insert(found, edges, np.nan, axis=0)


def draw_multipliers(view: View, places: Sequence[Axes]) -> None:
    """Draw the multipliers of an orbit and the unit circle into the first Axes."""
    assert view.orbit is not None
    axes = places[0]
    angle = np.linspace(0, 2 * np.pi, 361)
    axes.fill(np.cos(angle), np.sin(angle), color="0.95", zorder=0)
    axes.plot(np.cos(angle), np.sin(angle), color="0.35", linewidth=0.8)
    axes.axhline(0, color="0.75", linewidth=0.6, zorder=0.5)
    axes.axvline(0, color="0.75", linewidth=0.6, zorder=0.5)
    extent = 1.0
    for number, multiplier in enumerate(view.orbit.stability.multipliers, 1):
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
    finish(
        axes,
        view.title,
        with_unit(r"$\mathrm{Re}\,\mu$", NO_UNIT),
        with_unit(r"$\mathrm{Im}\,\mu$", NO_UNIT),
    )

"""Pictures of fits: what was measured over the fitted motion or responses, residuals below."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.explore.fitting.fit import Fit
from nonsmooth.runtime.explore.fitting.outputs import output_of
from nonsmooth.runtime.explore.fitting.prediction import response_curves
from nonsmooth.runtime.model.kernels import known_system
from nonsmooth.runtime.model.naming import shown_name, units_of
from nonsmooth.runtime.present.pictures.drawing import (
    LINES,
    check_picture,
    finish,
    given_axes,
    mark_style,
)
from nonsmooth.runtime.simulation.trajectory import Trajectory

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_WIDTH, _HEIGHT = 7.2, 5.2  # inches, of one experiment
_MOST = 4  # experiments in one figure
_SIZE = 3.8  # of a marker
_USUAL = 2.0  # standard deviations
_POINTS = 2000
_TOLD = 3  # estimates in a title


def fit_figure(fit: Fit) -> Figure:
    """Figure, outside pyplot, of a fit, with a column for each of the first experiments."""
    check_picture("fit", ("fit",))
    from matplotlib.figure import Figure

    shown = fit.experiments[:_MOST]
    figure = Figure(figsize=(_WIDTH * len(shown), _HEIGHT), layout="constrained")
    grid = _grid(figure, len(shown))
    if len(fit.experiments) > 1:
        figure.suptitle(_title(fit), x=0.01, ha="left", fontsize="medium")
    for number in range(len(shown)):
        _draw(fit, number, grid[0, number], grid[1, number])
    return figure


def plot_fit(fit: Fit, axes: Any = None, experiment: int = 0) -> Any:
    """Draw one experiment of a fit into two Axes, and give these: motion and residuals.

    Without Axes a figure of pyplot is made. The experiment counts from 0. `InputError` is
    raised if there is no such experiment, or if there are not two Axes.
    """
    check_picture("fit", ("fit",))
    fit.experiment(experiment)
    if axes is None:
        from matplotlib import pyplot

        axes = _grid(pyplot.figure(figsize=(_WIDTH, _HEIGHT), layout="constrained"), 1)
    upper, lower = given_axes(axes, "fit", [2])
    _draw(fit, experiment, upper, lower)
    return np.array([upper, lower])


def _grid(figure: Figure, count: int) -> Any:
    """Axes (2, count): of motions, and of residuals below them."""
    return figure.subplots(2, count, sharex="col", squeeze=False, height_ratios=[2.4, 1])


def _draw(fit: Fit, number: int, upper: Axes, lower: Axes) -> None:
    """Draw one experiment: its motion or responses with the measurements, and the residuals."""
    experiment, kernels = fit.experiments[number], known_system(fit.system)
    units, states = units_of(kernels), kernels.table["states"]
    outputs = [series for series in experiment.series if series.kind != "event"]
    events = [series for series in experiment.series if series.kind == "event"]
    if experiment.responses:
        along, curves = response_curves(fit, number)
        across = units.label(experiment.along) if experiment.along else "row"
    else:
        along, curves = _motion_curves(
            fit.motion(number), {series.name: series.expression for series in outputs}
        )
        along, across = along + experiment.offset, "time on the clock of the data"
    for place, (name, curve) in enumerate(curves.items()):
        color = mark_style(place)["color"]
        upper.plot(along, curve, color=color, linewidth=1.2, label=f"{name}, fitted")
    for place, series in enumerate([*outputs, *events]):
        marked, style = series.times, {**mark_style(place), "markersize": _SIZE}
        if series.kind == "event":  # a mark along the lower edge
            marked, style["color"] = series.values, "black"
            heights = np.full(len(marked), 0.03 + 0.06 * (place - len(outputs)))
            edge: dict[str, Any] = {"transform": upper.get_xaxis_transform(), "markersize": 9}
            label = f"{series.expression}, recorded"
            upper.plot(marked, heights, "|", color="black", label=label, **edge)
        else:
            style["markerfacecolor"] = "none"
            upper.plot(marked, series.values, label=f"{series.name}, measured", **style)
        lower.plot(marked, series.residuals, **style)
    lower.axhspan(-_USUAL, _USUAL, color="#DDDDDD", zorder=0)
    low, high = lower.get_ylim()
    lower.set_ylim(min(low, -1.2 * _USUAL), max(high, 1.2 * _USUAL))
    lower.axhline(0, color="#777777", linewidth=0.8, zorder=1)
    several = len(fit.experiments) > 1
    up = ", ".join(units.label(n) if n in states else n for n in curves)
    finish(upper, shown_name(experiment.name) if several else _title(fit), "", up)
    finish(lower, "", across, "residual / sigma")


def _motion_curves(
    motion: Trajectory, texts: Mapping[str, str]
) -> tuple[np.ndarray, dict[str, np.ndarray]]:
    """Times, and outputs of a fitted motion by name; if none was measured its first positions."""
    if not texts:
        places = [place for place, _ in motion.structure.coordinates] or [0]
        texts = {motion.names[place]: motion.names[place] for place in places[: len(LINES)]}
    times, states = motion.sample(_POINTS)
    phases = np.searchsorted(motion.times, times, side="right") - 1
    curves, structure, system = {}, motion.structure, motion.system
    for name, text in texts.items():
        output = output_of(text, structure)
        rows = output.in_configurations(structure, system.fields, system.rows)
        drawn = rows[motion.run.configurations[phases]]
        curves[name] = np.einsum("mn,mn->m", drawn[:, :-1], states) + drawn[:, -1]
    return times, curves


def _title(fit: Fit) -> str:
    found = zip(fit.names, fit.estimates.tolist(), fit.standard_errors.tolist(), strict=True)
    told = [
        f"{name} = {value:.5g}" + (f" ± {error:.1g}" if math.isfinite(error) else "")
        for name, value, error in found
    ]
    more = ", ..." if len(told) > _TOLD else ""
    return f"{shown_name(fit.system)}: {', '.join(told[:_TOLD])}{more}"

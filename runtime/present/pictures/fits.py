"""Pictures of fits: what was measured over the fitted motion or responses, residuals below."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.explore.fitting.fit import Fit, FittedSeries
from nonsmooth.runtime.explore.fitting.outputs import output_of
from nonsmooth.runtime.explore.fitting.prediction import response_curves
from nonsmooth.runtime.model.kernels import known_system
from nonsmooth.runtime.model.naming import shown_name, units_of
from nonsmooth.runtime.present.pictures.drawing import (
    LINES,
    check_picture,
    finish,
    given_axes,
)
from nonsmooth.runtime.simulation.trajectory import Trajectory

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_WIDTH, _HEIGHT = 7.2, 5.2  # inches, of one experiment
_MOST = 4  # experiments in one figure
_MARKERS = ("o", "s", "^", "D")
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
    if fit.experiments[number].responses:
        _draw_responses(fit, number, upper, lower)
        return
    experiment, motion = fit.experiments[number], fit.motion(number)
    outputs = [series for series in experiment.series if series.kind == "output"]
    events = [series for series in experiment.series if series.kind == "event"]
    times, states = motion.sample(_POINTS)
    units = units_of(known_system(fit.system))
    texts = {series.name: series.expression for series in outputs} or _positions(motion)
    colors = {name: LINES[place % len(LINES)][0] for place, name in enumerate(texts)}
    phases = np.searchsorted(motion.times, times, side="right") - 1
    configurations = motion.run.configurations[phases]
    for name, text in texts.items():
        output, system = output_of(text, motion.structure), motion.system
        rows = output.in_configurations(motion.structure, system.fields, system.rows)
        drawn = rows[configurations]
        upper.plot(
            times + experiment.offset,
            np.einsum("mn,mn->m", drawn[:, :-1], states) + drawn[:, -1],
            color=colors[name],
            linewidth=1.2,
            label=f"{name}, fitted",
        )
    for place, series in enumerate(outputs):
        upper.plot(
            series.times,
            series.values,
            _MARKERS[place % len(_MARKERS)],
            color=colors[series.name],
            markersize=3.2,
            markerfacecolor="none",
            label=f"{series.name}, measured",
        )
    for place, series in enumerate(events):
        _draw_events(upper, series, place)
    for place, series in enumerate([*outputs, *events]):
        lower.plot(
            series.values if series.kind == "event" else series.times,
            series.residuals,
            _MARKERS[place % len(_MARKERS)],
            color=colors.get(series.name, "black"),
            markersize=3.2,
            markerfacecolor="none" if series.kind == "output" else "black",
        )
    upper.set_ylabel(", ".join(units.label(n) if n in motion.names else n for n in texts))
    _finish(fit, number, upper, lower, "time on the clock of the data")


def _draw_responses(fit: Fit, number: int, upper: Axes, lower: Axes) -> None:
    """Draw measured steady responses over the curves of the fitted ones."""
    experiment = fit.experiments[number]
    values, curves = response_curves(fit, number)
    for place, series in enumerate(experiment.series):
        color, marker = LINES[place % len(LINES)][0], _MARKERS[place % len(_MARKERS)]
        upper.plot(
            values, curves[series.name], color=color, linewidth=1.2, label=f"{series.name}, fitted"
        )
        style: Any = {"color": color, "markersize": 4.2, "markerfacecolor": "none"}
        upper.plot(series.times, series.values, marker, label=f"{series.name}, measured", **style)
        lower.plot(series.times, series.residuals, marker, **style)
    upper.set_ylabel(", ".join(series.name for series in experiment.series))
    along = experiment.along
    _finish(fit, number, upper, lower, units_of(known_system(fit.system)).label(along) or "row")


def _finish(fit: Fit, number: int, upper: Axes, lower: Axes, along: str) -> None:
    """Draw the band of usual residuals, labels and titles."""
    lower.axhspan(-_USUAL, _USUAL, color="#DDDDDD", zorder=0)
    low, high = lower.get_ylim()
    lower.set_ylim(min(low, -1.2 * _USUAL), max(high, 1.2 * _USUAL))
    lower.axhline(0, color="#777777", linewidth=0.8, zorder=1)
    lower.set_ylabel("residual / sigma")
    lower.set_xlabel(along)
    several = len(fit.experiments) > 1
    finish(upper, shown_name(fit.experiments[number].name) if several else _title(fit))
    finish(lower, "")


def _title(fit: Fit) -> str:
    found = zip(fit.names, fit.estimates.tolist(), fit.standard_errors.tolist(), strict=True)
    told = [
        f"{name} = {value:.5g}" + (f" ± {error:.1g}" if math.isfinite(error) else "")
        for name, value, error in found
    ]
    more = ", ..." if len(told) > _TOLD else ""
    return f"{shown_name(fit.system)}: {', '.join(told[:_TOLD])}{more}"


def _draw_events(upper: Axes, series: FittedSeries, place: int) -> None:
    """Draw recorded times as marks along the lower edge."""
    upper.plot(
        series.values,
        np.full(len(series.values), 0.03 + 0.06 * place),
        "|",
        transform=upper.get_xaxis_transform(),
        color="black",
        markersize=9,
        label=f"{series.expression}, recorded",
    )


def _positions(motion: Trajectory) -> dict[str, str]:
    """The positions that are drawn if no output was measured, by name."""
    places = [place for place, _ in motion.structure.coordinates] or [0]
    return {motion.names[place]: motion.names[place] for place in places[: len(LINES)]}

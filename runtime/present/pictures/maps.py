"""Pictures of many motions: basins of attraction, and bifurcation diagrams."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.explore.finding.found import label_names
from nonsmooth.runtime.explore.finding.outcomes import Outcome
from nonsmooth.runtime.model.naming import shown_name, symbol
from nonsmooth.runtime.model.units import units_of
from nonsmooth.runtime.present.pictures.drawing import (
    SHADES,
    check_picture,
    finish,
    mark_style,
    shaded,
)

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from nonsmooth.runtime.explore.finding.basins import Basins
    from nonsmooth.runtime.explore.finding.sweep import Sweep

__all__ = ["basin_figure", "bifurcation_figure", "draw_basins", "draw_sweep"]

# after Tol's scheme "muted", ordered so that neighbours differ in lightness too
_BASINS = (
    *("#332288", "#DDCC77", "#117733", "#88CCEE", "#882255"),
    *("#CC6677", "#44AA99", "#AA4499", "#999933"),
)
_UNCLASSIFIED = "#DDDDDD"


def basin_figure(
    x: Any,
    y: Any,
    labels: Any,
    names: Sequence[str],
    *,
    axes_labels: tuple[str, str] = ("x", "y"),
    title: str = "",
) -> Figure:
    """Figure, outside pyplot, of the attractors that starts lead to.

    `labels` (m, n) are indices of `names`, or -1 if a start is not classified. The
    coordinates `x` (n,) and `y` (m,) are strictly increasing. `InputError` is raised for
    shapes that do not fit, coordinates that do not increase, or labels without name.
    """
    check_picture("basin", ("basin",))
    from matplotlib.colors import ListedColormap
    from matplotlib.figure import Figure

    x, y, found = _coordinates("x", x), _coordinates("y", y), np.asarray(labels)
    if found.shape != (len(y), len(x)):
        raise InputError(f"the labels have the shape {found.shape}, not {(len(y), len(x))}")
    if found.dtype.kind not in "iu":
        raise InputError("the labels are not integers")
    if found.min() < -1 or found.max() >= len(names):
        raise InputError(f"the labels are not between -1 and {len(names) - 1}")
    most = SHADES * len(_BASINS)
    if len(names) > most:
        raise InputError(f"{len(names)} attractors, of which {most} can be told apart")
    colors = [_UNCLASSIFIED, *(shaded(_BASINS, place) for place in range(len(names)))]
    figure = Figure(figsize=(6.0, 5.4))
    figure.set_layout_engine("constrained")
    axes = figure.add_subplot()
    axes.pcolormesh(
        x,
        y,
        found,
        shading="nearest",
        cmap=ListedColormap(colors),
        vmin=-1.5,
        vmax=len(names) - 0.5,
        rasterized=True,
    )
    for number in [*range(len(names)), -1]:
        part = 100 * float((found == number).mean())
        name = names[number] if number >= 0 else "unclassified"
        if part or number >= 0:
            axes.fill_between([], [], color=colors[number + 1], label=f"{name} ({_percent(part)})")
    axes.set_xlabel(_label(axes_labels[0]))
    axes.set_ylabel(_label(axes_labels[1]))
    finish(axes, title)
    return figure


def bifurcation_figure(
    parameter: str,
    values: Any,
    samples: Any,
    *,
    state: str = "",
    title: str = "",
) -> Figure:
    """Figure, outside pyplot, of a state at each return to a section, over a parameter.

    `samples` has the points at each of the values (n,): an array (n, k), n sequences, or a
    mapping that names several sweeps, such as up and down. NaN is left out. `InputError` is
    raised for counts that do not fit, or values that are not finite.
    """
    check_picture("bifurcation", ("bifurcation",))
    from matplotlib.figure import Figure

    numbers = np.asarray(values, dtype=float)
    if numbers.ndim != 1 or not numbers.size or not np.isfinite(numbers).all():
        raise InputError("the parameter's values are not a row of finite numbers")
    sweeps = samples if isinstance(samples, Mapping) else {"": samples}
    figure = Figure(figsize=(6.4, 4.4))
    figure.set_layout_engine("constrained")
    axes = figure.add_subplot()
    for place, (name, rows) in enumerate(sweeps.items()):
        if len(rows) != len(numbers):
            raise InputError(f"{len(numbers)} values of {parameter}, but {len(rows)} samples")
        columns = [np.ravel(np.asarray(row, dtype=float)) for row in rows]
        across = np.repeat(numbers, [len(column) for column in columns])
        points = np.concatenate(columns)
        kept = np.isfinite(points)
        _draw_sweep(axes, across[kept], points[kept], name, place)
    axes.set_xlabel(_label(parameter))
    axes.set_ylabel(_label(state) if state else "state at each return")
    axes.margins(0.02, 0.05)
    finish(axes, title)
    return figure


def _draw_sweep(axes: Any, across: np.ndarray, points: np.ndarray, name: str, place: int) -> None:
    """Draw the points of one sweep: the more there are, the smaller they are."""
    size = float(np.clip(60.0 / np.sqrt(1 + len(points)), 1.1, 4.0))
    style = mark_style(place)
    axes.plot(
        across,
        points,
        markersize=size,
        markeredgewidth=0,
        alpha=0.7,
        rasterized=len(points) > 20_000,
        **style,
    )
    if name:
        axes.plot([], [], label=name, **style)


def draw_basins(plane: Basins) -> Figure:
    """Figure, outside pyplot, of a plane of starts from `basins`.

    The attractors come in their order, then the other outcomes.
    """
    names = label_names(plane.found)
    ends = [outcome for outcome in Outcome if outcome != Outcome.UNCLASSIFIED]
    order = [label for label in names if label >= 0]
    order += [int(outcome) for outcome in ends if (plane.labels == outcome).any()]
    labels = np.full(plane.labels.shape, -1)
    for place, label in enumerate(order):
        labels[plane.labels == label] = place
    units = units_of(plane.found.system)
    return basin_figure(
        plane.x_values,
        plane.y_values,
        labels,
        [names[label] for label in order],
        axes_labels=(units.label(plane.x), units.label(plane.y)),
        title=shown_name(plane.found.system),
    )


def draw_sweep(diagram: Sweep) -> Figure:
    """Figure, outside pyplot, of a bifurcation diagram."""
    units = units_of(diagram.system)
    return bifurcation_figure(
        units.label(diagram.parameter),
        diagram.values,
        diagram.samples,
        state=units.label(diagram.state),
        title=f"{shown_name(diagram.system)}: {diagram.state} {diagram.when}",
    )


def _coordinates(name: str, given: Any) -> np.ndarray:
    found = np.asarray(given, dtype=float)
    if found.ndim != 1 or not found.size or not np.isfinite(found).all():
        raise InputError(f"{name} is not a row of finite numbers")
    if not (np.diff(found) > 0).all():
        raise InputError(f"{name} does not increase strictly")
    return found


def _percent(part: float) -> str:
    return f"{part:.1f} %" if part >= 0.1 or part == 0 else "< 0.1 %"


def _label(name: str) -> str:
    """A label: a name as a formula, any other text as it is."""
    return f"${symbol(name)}$" if name.isalnum() else name

"""Pictures of branches, and of curves of events in the plane of two parameters.

Of a branch stable parts are solid, unstable ones dashed, what is not admissible is grey.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from nonsmooth.runtime.core.errors import InputError, one_or_several, unknown_name
from nonsmooth.runtime.explore.continuation.branch import forcing_frequencies, usual_quantities
from nonsmooth.runtime.model.naming import shown_name, symbol, units_of
from nonsmooth.runtime.present.pictures.drawing import (
    LINES,
    drawn_alone,
    finish,
    line_style,
    widen,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from nonsmooth.runtime.explore.continuation.branch import Branch, Locus
    from nonsmooth.runtime.explore.continuation.event import Event

ANGULAR = "angular"
_TURNS = {ANGULAR: 1.0, "cycles": 2 * np.pi}  # angular frequencies of one unit
_UNITS = {ANGULAR: "angular (rad per unit of time)", "cycles": "in cycles per unit of time"}
FREQUENCIES = tuple(_TURNS)
_GREY = "#999999"
_STYLES = {"stable": "-", "neutral": "-", "unstable": (0, (5, 2)), "undecided": ":"}
_MARKERS = {
    "fold": "o",
    "flip": "s",
    "neimark-sacker": "D",
    "branch-point": "P",
    "symmetry-breaking": "P",
    "grazing": "v",
    "tangent": "<",
    "entry": ">",
    "simultaneous": "X",
    "condition": "d",
    "vanishing-phase": "*",
    "admissibility": "x",
}
_OTHER = "h"
_REFUSED = "not admissible"


def draw_branch(
    branch: Branch,
    quantity: str | Sequence[str] | None = None,
    axes: Any = None,
    *,
    over: str | None = None,
    frequency: str = ANGULAR,
) -> Any:
    """Draw quantities of a branch over the parameter, or over another quantity.

    They are named as for `Branch.quantity`, and stand one below the other in a new figure;
    Axes that are given receive the first one. The default is the amplitude of each coordinate
    of a forced system, else the period. The quantity "energy" with "frequency" as `over` is the
    frequency-energy curve of a conservative family. Frequencies are "angular" (radians) or in
    "cycles" per unit of time. The result is the Axes that are given, or else the figure. An
    unknown quantity raises `InputError`.
    """
    shown = usual_quantities(branch) if quantity is None else one_or_several(quantity)
    if not shown:
        raise InputError("no quantity is named: there is nothing to draw")

    def draw(place: Axes, name: str = shown[0]) -> None:
        _draw(branch, name, over or branch.parameter, place, frequency)

    def compose(figure: Figure) -> None:
        first = None
        for place, name in enumerate(shown, 1):
            own = figure.add_subplot(len(shown), 1, place, sharex=first)
            draw(own, name)
            first = first or own
            if place > 1:
                own.set_title("", loc="left")
                legend = own.get_legend()
                if legend is not None:
                    legend.remove()
            if place < len(shown):
                own.set_xlabel("")

    return drawn_alone("branch", (6.4, 4.4 + 2.6 * (len(shown) - 1)), draw, axes, compose)


def draw_locus(locus: Locus, axes: Any = None) -> Any:
    """Draw a curve of events in the plane of its parameters.

    The result is the Axes that are given, which may hold several curves, or else a new
    figure.
    """
    return drawn_alone("locus", (6.4, 4.4), lambda own: _draw_locus(locus, own), axes)


def _draw_locus(locus: Locus, axes: Any) -> None:
    style = line_style(len(axes.lines) // 2)
    label = f"{locus.kind.replace('-', ' ')} {locus.boundary}".strip()
    axes.plot(*locus.values.T, label=label, **style)
    axes.plot(*locus.values[locus.start], marker=_MARKERS.get(locus.kind, _OTHER), **style)
    first, second = locus.parameters
    units = units_of(locus.orbit.system)
    finish(axes, shown_name(locus.name), units.label(first), units.label(second))


def _draw(branch: Branch, quantity: str, over: str, axes: Any, frequency: str) -> None:
    if frequency not in FREQUENCIES:
        raise unknown_name("frequency", frequency, FREQUENCIES)
    across, up = (_shown(branch, name, frequency) for name in (over, quantity))
    x, y = across.values, up.values
    labels = [
        s if allowed else _REFUSED
        for s, allowed in zip(branch.stability, branch.admissible, strict=True)
    ]
    met = {
        event.place: (_at(event, branch, over, across), _at(event, branch, quantity, up))
        for event in branch.events
    }
    corners: dict[float, tuple[Any, Any]] = dict(enumerate(zip(x, y, strict=True)))
    corners |= met
    places = sorted(corners)
    kinds = [_between(labels, sorted(met), *ends) for ends in pairwise(places)]
    x, y = np.array([corners[place] for place in places]).T
    cuts = [0, *(k for k in range(1, len(kinds)) if kinds[k] != kinds[k - 1]), len(kinds)]
    for begin, end in pairwise(cuts):
        if begin == end:
            continue
        kind = kinds[begin]
        axes.plot(
            x[begin : end + 1],
            y[begin : end + 1],
            color=_GREY if kind == _REFUSED else LINES[0][0],
            linestyle=_STYLES.get(kind, "-"),
            linewidth=1.2 if kind == _REFUSED else 1.8,
            label=kind,
        )
    for event in branch.events:
        axes.plot(
            *met[event.place],
            marker=_MARKERS.get(event.kind, _OTHER),
            color=LINES[1][0],
            linestyle="none",
            label=event.kind.replace("-", " "),
            zorder=3,
        )
    widen(axes)
    if over == "energy" and x.min() > 0:
        axes.set_xscale("log")
    finish(axes, shown_name(branch.name), across.label, up.label)


class _Shown(NamedTuple):
    """A quantity as it is shown."""

    values: np.ndarray  # (k,)
    label: str
    factor: float = 1.0  # that the values were multiplied by


def _shown(branch: Branch, name: str, frequency: str) -> _Shown:
    units = units_of(branch.orbit.system)
    values = branch.quantity(name)
    forced = forcing_frequencies(branch) if name == branch.parameter else None
    if forced is not None or name == "frequency":
        text = "frequency" if forced is None else f"frequency of the forcing (${symbol(name)}$)"
        angular = values if forced is None else forced
        factor = float(angular[0] / values[0]) / _TURNS[frequency]
        return _Shown(values * factor, f"{text}, {_UNITS[frequency]}", factor)
    if name in (branch.parameter, *branch.unknown_names):
        return _Shown(values, units.label(name))
    if name.startswith("amplitude_"):
        text = f"amplitude of ${symbol(name.removeprefix('amplitude_'))}$"
        return _Shown(values, units.text(text))
    return _Shown(values, name if name == "trace" else units.text(name))


def _at(event: Event, branch: Branch, quantity: str, shown: _Shown) -> float:
    """Value of a quantity at an event, as it is shown."""
    known = {**event.unknowns, branch.parameter: event.value}
    if quantity in known:
        return known[quantity] * shown.factor
    return float(np.interp(event.place, np.arange(len(shown.values)), shown.values))


def _between(labels: Sequence[str], events: Sequence[float], begin: float, end: float) -> str:
    """Label of the curve between two places.

    Up to the first event in a step it is the label of the point before, and from the last
    event on that of the point behind. Otherwise it is the worse of both.
    """
    step = min(int(begin), len(labels) - 2)
    passed = [place for place in events if step <= place <= step + 1]
    if passed and end <= passed[0]:
        return labels[step]
    if passed and begin >= passed[-1]:
        return labels[step + 1]
    return _worse(labels[step : step + 2])


def _worse(labels: Sequence[str]) -> str:
    """The label of two neighbours that promises less."""
    order = (_REFUSED, "undecided", "unstable", "neutral", "stable")
    return min(labels, key=order.index)

"""Pictures of branches, and of curves of events in the plane of two parameters.

Of a branch stable parts are solid, unstable ones dashed, what is no motion is grey.
"""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.notebook import symbol
from nonsmooth.runtime.pictures.drawing import LINES, UNIT, check_picture, given_axes

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from nonsmooth.runtime.continuation.event import Event
    from nonsmooth.runtime.continuation.locus import Locus
    from nonsmooth.runtime.continuation.record import Branch

__all__ = ["branch_figure", "draw_branch", "draw_locus", "locus_figure"]

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


def branch_figure(branch: Branch, quantity: str = "period", over: str | None = None) -> Figure:
    """A figure of one quantity over the parameter, or over another one.

    Raises
    ------
    InputError
        For a quantity that the branch does not have.
    MissingExtra
        If matplotlib is not installed.
    """
    figure = _empty_figure()
    _draw(branch, quantity, over or branch.parameter, figure.add_subplot())
    return figure


def draw_branch(
    branch: Branch, quantity: str = "period", axes: Any = None, *, over: str | None = None
) -> Any:
    """Draw one quantity over the parameter, or over another one.

    Parameters
    ----------
    branch : Branch
    quantity : str
        As for `Branch.quantity`.
    axes : matplotlib Axes, optional
        Where to draw; a figure of its own by default.
    over : str, optional
        Another quantity in place of the parameter: "energy" below "frequency" is the
        frequency-energy curve of a conservative family.

    Returns
    -------
    Figure or Axes

    Raises
    ------
    InputError
        For a quantity that the branch does not have.
    MissingExtra
        If matplotlib is not installed.
    """
    if axes is None:
        return branch_figure(branch, quantity, over)
    check_picture("branch", ("branch",))
    (place,) = given_axes(axes, "branch", (1,))
    _draw(branch, quantity, over or branch.parameter, place)
    return place


def locus_figure(locus: Locus) -> Figure:
    """A figure of a curve of events in the plane of its parameters.

    Raises
    ------
    MissingExtra
        If matplotlib is not installed.
    """
    figure = _empty_figure()
    _draw_locus(locus, figure.add_subplot())
    return figure


def draw_locus(locus: Locus, axes: Any = None) -> Any:
    """Draw a curve of events in the plane of its parameters.

    Parameters
    ----------
    locus : Locus
    axes : matplotlib Axes, optional
        Where to draw; a figure of its own by default. Several curves fit into the same Axes.

    Returns
    -------
    Figure or Axes

    Raises
    ------
    MissingExtra
        If matplotlib is not installed.
    """
    if axes is None:
        return locus_figure(locus)
    check_picture("locus", ("locus",))
    (place,) = given_axes(axes, "locus", (1,))
    _draw_locus(locus, place)
    return place


def _empty_figure() -> Figure:
    check_picture("all", ("all",))
    from matplotlib.figure import Figure

    figure = Figure(figsize=(6.4, 4.4))
    figure.set_layout_engine("constrained")
    return figure


def _draw_locus(locus: Locus, axes: Any) -> None:
    color, dashes = LINES[len(axes.lines) // 2 % len(LINES)]
    label = f"{locus.kind.replace('-', ' ')} {locus.boundary}".strip()
    axes.plot(*locus.values.T, color=color, linestyle=dashes, linewidth=1.8, label=label)
    axes.plot(
        *locus.values[locus.start],
        marker=_MARKERS[locus.kind],
        color=color,
        linestyle="none",
    )
    first, second = locus.parameters
    axes.set_xlabel(f"${symbol(first)}$ {UNIT}")
    axes.set_ylabel(f"${symbol(second)}$ {UNIT}")
    axes.set_title(locus.name)
    axes.legend(frameon=False)


def _draw(branch: Branch, quantity: str, over: str, axes: Any) -> None:
    x, y = branch.quantity(over), branch.quantity(quantity)
    labels = [
        s if allowed else "no motion"
        for s, allowed in zip(branch.stability, branch.admissible, strict=True)
    ]
    # an interval between two points is drawn as the point at its end away from a change
    kinds = [
        labels[k] if labels[k] == labels[k + 1] else _worse(labels[k : k + 2])
        for k in range(len(x) - 1)
    ]
    cuts = [0, *(k for k in range(1, len(kinds)) if kinds[k] != kinds[k - 1]), len(kinds)]
    told: set[str] = set()
    for begin, end in pairwise(cuts):
        if begin == end:
            continue
        kind = kinds[begin]
        axes.plot(
            x[begin : end + 1],
            y[begin : end + 1],
            color=_GREY if kind == "no motion" else LINES[0][0],
            linestyle=_STYLES.get(kind, "-"),
            linewidth=1.2 if kind == "no motion" else 1.8,
            label=None if kind in told else kind,
        )
        told.add(kind)
    for event in branch.events:
        axes.plot(
            _at(event, branch, over, x),
            _at(event, branch, quantity, y),
            marker=_MARKERS[event.kind],
            color=LINES[1][0],
            linestyle="none",
            label=None if event.kind in told else event.kind.replace("-", " "),
            zorder=3,
        )
        told.add(event.kind)
    if over == "energy" and x.min() > 0:
        axes.set_xscale("log")
    axes.set_xlabel(_label(branch, over))
    axes.set_ylabel(_label(branch, quantity))
    axes.set_title(branch.name)
    axes.legend(frameon=False)


def _at(event: Event, branch: Branch, quantity: str, values: np.ndarray) -> float:
    """A quantity at an event."""
    known = {**event.unknowns, branch.parameter: event.value}
    if quantity in known:
        return known[quantity]
    return float(np.interp(event.place, np.arange(len(values)), values))


def _label(branch: Branch, quantity: str) -> str:
    known = quantity in (branch.parameter, *branch.unknown_names)
    return f"${symbol(quantity)}$ {UNIT}" if known else f"{quantity} {UNIT}"


def _worse(labels: list[str]) -> str:
    """Of two neighbours' labels the one that promises less."""
    order = ("no motion", "undecided", "unstable", "neutral", "stable")
    return min(labels, key=order.index)

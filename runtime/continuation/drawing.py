"""Pictures of branches: stable parts solid, unstable ones dashed, what is no motion grey."""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.notebook import symbol
from nonsmooth.runtime.pictures.drawing import LINES, UNIT, check_picture, given_axes

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from nonsmooth.runtime.continuation.branch import Branch

__all__ = ["branch_figure", "draw_branch"]

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


def branch_figure(branch: Branch, quantity: str = "period") -> Figure:
    """A figure of one quantity over the parameter.

    Raises
    ------
    InputError
        For a quantity that the branch does not have.
    MissingExtra
        If matplotlib is not installed.
    """
    check_picture("branch", ("branch",))
    from matplotlib.figure import Figure

    figure = Figure(figsize=(6.4, 4.4))
    figure.set_layout_engine("constrained")
    _draw(branch, quantity, figure.add_subplot())
    return figure


def draw_branch(branch: Branch, quantity: str = "period", axes: Any = None) -> Any:
    """Draw one quantity over the parameter.

    Parameters
    ----------
    branch : Branch
    quantity : str
        "period", "trace", or an unknown.
    axes : matplotlib Axes, optional
        Where to draw; a figure of its own by default.

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
        return branch_figure(branch, quantity)
    check_picture("branch", ("branch",))
    (place,) = given_axes(axes, "branch", (1,))
    _draw(branch, quantity, place)
    return place


def _draw(branch: Branch, quantity: str, axes: Any) -> None:
    x, y = branch.parameter_values, branch.quantity(quantity)
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
    places = np.arange(len(x))
    for event in branch.events:
        height = event.unknowns.get(quantity)
        if height is None:
            height = float(np.interp(event.place, places, y))
        axes.plot(
            event.value,
            height,
            marker=_MARKERS[event.kind],
            color=LINES[1][0],
            linestyle="none",
            label=None if event.kind in told else event.kind.replace("-", " "),
            zorder=3,
        )
        told.add(event.kind)
    axes.set_xlabel(f"${symbol(branch.parameter)}$ {UNIT}")
    known = quantity in (branch.parameter, *branch.unknown_names)
    axes.set_ylabel(f"${symbol(quantity)}$ {UNIT}" if known else f"{quantity} {UNIT}")
    axes.set_title(branch.name)
    axes.legend(frameon=False)


def _worse(labels: list[str]) -> str:
    """Of two neighbours' labels the one that promises less."""
    order = ("no motion", "undecided", "unstable", "neutral", "stable")
    return min(labels, key=order.index)

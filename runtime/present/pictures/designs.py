"""Pictures of designs: quantities over the iterates, and along each parameter around the end."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from nonsmooth.runtime.explore.design.design import along
from nonsmooth.runtime.model.naming import shown_name, units_of
from nonsmooth.runtime.present.pictures.drawing import (
    drawn_alone,
    finish,
    line_style,
)

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from nonsmooth.runtime.explore.design.optimum import Design

_WIDTH, _HEIGHT = 6.4, 3.0
_POINTS = 61


def draw_design(design: Design, axes: Any = None) -> Any:
    """Draw a design's iterates, and its quantities along each parameter, or along its branch.

    Axes that are given receive the iterates alone, and are returned; else a new figure is.
    """
    count = 2 if design.worst_over else 1 + len(design.parameters)

    def compose(figure: Figure) -> None:
        places = [figure.add_subplot(count, 1, 1 + place) for place in range(count)]
        _iterates(design, places[0])
        if design.worst_over:
            _along_branch(design, places[1])
            return
        for name, place in zip(design.parameters, places[1:], strict=True):
            _along(design, name, place)

    size = (_WIDTH, _HEIGHT * count)
    return drawn_alone("design", size, lambda own: _iterates(design, own), axes, compose)


def _iterates(design: Design, axes: Any) -> None:
    count = len(design.parameters)
    for place, name in enumerate(design.quantities):
        values = design.history[:, count + place]
        axes.plot(values, marker=".", label=_word(name), **line_style(place))
    finish(axes, shown_name(design.orbit.name), "iterate")


def _along(design: Design, name: str, axes: Any) -> None:
    values, found = along(design, design.orbit, name, _POINTS)
    for place, quantity in enumerate(design.quantities):
        style = line_style(place)
        axes.plot(values, found[:, place], label=_word(quantity), **style)
        axes.plot(design.after[name], design.after[quantity], marker="o", **style)
    finite = values[np.isfinite(found).any(axis=1)]
    if len(finite):
        axes.set_xlim(finite.min(), finite.max())
    finish(axes, "", units_of(design.orbit.system).label(name))


def _along_branch(design: Design, axes: Any) -> None:
    """Draw the quantities along the branch before and after the design, with their worst places."""
    (name,) = design.worst_over
    values, before = along(design, design.start, name, _POINTS)
    _, after = along(design, design.orbit, name, _POINTS)
    for place, quantity in enumerate(design.quantities):
        style = line_style(place)
        axes.plot(values, before[:, place], alpha=0.4, **style)
        axes.plot(values, after[:, place], label=_word(quantity), **style)
    worst = [design.after[design.quantity]] * len(design.worst_at)
    axes.plot(design.worst_at, worst, marker="o", **{**line_style(0), "linestyle": "none"})
    finish(axes, "pale: where it began", units_of(design.orbit.system).label(name))


def _word(name: str) -> str:
    return name.replace("_", " ").replace(":", " of ")

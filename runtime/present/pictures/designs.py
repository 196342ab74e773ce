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
        _iterates(design, figure.add_subplot(count, 1, 1))
        for place, name in enumerate(design.worst_over or design.parameters, 2):
            _along(design, name, figure.add_subplot(count, 1, place))

    size = (_WIDTH, _HEIGHT * count)
    return drawn_alone("design", size, lambda own: _iterates(design, own), axes, compose)


def _iterates(design: Design, axes: Any) -> None:
    count = len(design.parameters)
    for place, name in enumerate(design.quantities):
        values = design.history[:, count + place]
        axes.plot(values, marker=".", label=_word(name), **line_style(place))
    finish(axes, shown_name(design.orbit.name), "iterate")


def _along(design: Design, name: str, axes: Any) -> None:
    """Draw the quantities along a parameter.

    Of the one whose worst place counts, it is the branch before and after, with these places.
    """
    values, found = along(design, design.orbit, name, _POINTS)
    _, before = along(design, design.start, name, _POINTS) if design.worst_over else ((), found)
    for place, quantity in enumerate(design.quantities):
        style = line_style(place)
        if design.worst_over:
            axes.plot(values, before[:, place], alpha=0.4, **style)
        axes.plot(values, found[:, place], label=_word(quantity), **style)
        if not design.worst_over:
            axes.plot(design.after[name], design.after[quantity], marker="o", **style)
    finite = values[np.isfinite(found).any(axis=1)]
    if design.worst_over:
        worst = [design.after[design.quantity]] * len(design.worst_at)
        axes.plot(design.worst_at, worst, marker="o", **{**line_style(0), "linestyle": "none"})
    elif len(finite):
        axes.set_xlim(finite.min(), finite.max())
    title = "pale: where it began" if design.worst_over else ""
    finish(axes, title, units_of(design.orbit.system).label(name))


def _word(name: str) -> str:
    return name.replace("_", " ").replace(":", " of ")

"""What pictures share: labels of levels and of ticks, legends."""

import itertools
from typing import Any

import pytest

pytest.importorskip("matplotlib")

from matplotlib.figure import Figure

from nonsmooth.runtime.present.pictures.drawing import (
    draw_levels,
    drawn_alone,
    finish,
)


@pytest.mark.parametrize("upright", [False, True])
def test_labels_of_near_levels_do_not_overlap(upright: bool) -> None:
    figure = Figure(figsize=(4, 3))
    axes = figure.add_subplot()
    axes.plot([0, 1], [0, 1])
    draw_levels(axes, {0.01: "$a$", -0.01: "$b$", 0.8: "$c$"}, upright=upright)
    assert [text.get_text() for text in axes.texts] == ["$a$\n$b$", "$c$"]
    assert len(axes.lines) == 4  # each level has its line
    figure.draw_without_rendering()
    first, second = (text.get_window_extent() for text in axes.texts)
    assert not first.overlaps(second)


@pytest.mark.parametrize("middle", [0.0, 1.0, -123.456])
@pytest.mark.parametrize("width", [1e-9, 1e-5, 0.03, 40.0])
def test_tick_labels_stand_apart_and_say_all(middle: float, width: float) -> None:
    """None touches another, and nothing is added or multiplied elsewhere."""

    def draw(axes: Any) -> None:
        axes.set_xlim(middle - width, middle + width)
        axes.plot([middle - width, middle + width], [middle, middle + width], label="stable")
        finish(axes, "a title")

    figure = drawn_alone("lines", (5.0, 4.0), draw)
    (axes,) = figure.axes
    figure.draw_without_rendering()
    for axis in (axes.xaxis, axes.yaxis):
        boxes = [
            label.get_window_extent() for label in axis.get_majorticklabels() if label.get_text()
        ]
        assert len(boxes) >= 2
        assert all(not a.overlaps(b) for a, b in itertools.combinations(boxes, 2))
        assert not axis.get_offset_text().get_text()
        numbers = [
            float(x.get_text().replace("\N{MINUS SIGN}", "-")) for x in axis.get_majorticklabels()
        ]
        assert numbers == pytest.approx(list(axis.get_majorticklocs()), abs=width / 50, rel=0)


def test_tick_labels_stand_apart_at_every_draw() -> None:
    """Of a figure that is made narrower, and whose numbers are written longer, once drawn."""

    def labels() -> list[str]:
        figure.draw_without_rendering()
        drawn = [label for label in axes.get_xticklabels() if label.get_text()]
        boxes = [label.get_window_extent() for label in drawn]
        assert all(not a.overlaps(b) for a, b in itertools.pairwise(boxes))
        return [label.get_text() for label in drawn]

    figure = Figure(figsize=(9, 3))
    axes = figure.add_subplot()
    finish(axes, "")
    wide = labels()
    figure.set_size_inches(1.2, 3)
    narrow = labels()
    assert 2 <= len(narrow) < len(wide)
    figure.set_size_inches(9, 3)
    assert labels() == wide
    axes.xaxis.set_major_formatter(lambda x, _: f"{x:.9f} of a unit")
    assert 2 <= len(labels()) < len(wide)


def test_the_legend_of_a_square_picture_is_within_a_wide_panel() -> None:
    """Of multipliers with many digits beside the unit circle."""
    figure = Figure(figsize=(4.2, 2.4), layout="constrained")
    axes = figure.add_subplot()
    for number in range(1, 5):
        axes.plot([0], [number], "o", label=rf"$\mu_{{{number}}} = -0.0799775$")
    axes.set_aspect("equal")
    finish(axes, "")
    figure.draw_without_rendering()
    legend = axes.get_legend()
    assert legend is not None
    assert legend.get_window_extent().x1 <= figure.bbox.x1

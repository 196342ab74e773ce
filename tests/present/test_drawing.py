"""What pictures share: labels of levels."""

import pytest

pytest.importorskip("matplotlib")

from matplotlib.figure import Figure

from nonsmooth.runtime.present.pictures.drawing import draw_levels


@pytest.mark.parametrize("upright", [False, True])
def test_labels_of_near_levels_do_not_overlap(upright: bool) -> None:
    figure = Figure(figsize=(4, 3))
    axes = figure.add_subplot()
    axes.plot([0, 1], [0, 1])
    draw_levels(axes, {0.01: "$a$", -0.01: "$b$", 0.8: "$c$"}, upright=upright)
    assert [text.get_text() for text in axes.texts] == ["$a$\n$b$", "$c$"]
    assert len(axes.lines) == 4  # each level has its line
    figure.canvas.draw()
    first, second = (text.get_window_extent() for text in axes.texts)
    assert not first.overlaps(second)

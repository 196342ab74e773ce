"""What pictures share: labels of levels and of ticks, legends."""

import itertools
from dataclasses import replace
from functools import cache, partial

import numpy as np
import pytest
import sympy as sp

import nonsmooth as ns
from nonsmooth.derive import SoftStop
from tests.core.test_result_files import file_of
from tests.one_mass import one_mass

pytest.importorskip("matplotlib")

from matplotlib.figure import Figure


@pytest.mark.parametrize("kind", ["time", "phase"])
def test_labels_of_near_levels_do_not_overlap(kind):
    """Those of positions are horizontal in a history, and upright in a portrait."""
    places = {"a": sp.Rational(1, 100), "b": -sp.Rational(1, 100), "c": sp.Rational(4, 5)}
    stops = [SoftStop("x", at=x, stiffness=1, name=name) for name, x in places.items()]
    system = one_mass("near", *stops, stiffness=0, damping=1)
    motion = ns.simulate(system, {}, {"x": -1, "v": 1}, until=9)
    axes = Figure(figsize=(4, 3)).add_subplot()
    motion.plot(kind, axes)
    labels = [text for text in axes.texts if "=" in text.get_text()]
    assert [x.get_text() for x in labels] == ["$x$ = $0.01$\n$x$ = $-0.01$", "$x$ = $0.8$"]
    assert sum(line.get_linestyle() == ":" for line in axes.lines) == 3  # each has its line
    axes.figure.draw_without_rendering()
    first, second = (text.get_window_extent() for text in labels)
    assert not first.overlaps(second)


@cache
def branch():
    return ns.load(file_of("nonsmooth branch"))


def drawn(middle, width):
    """A branch with other numbers, and its Axes."""
    parts = np.linspace(-1, 1, len(branch()))
    figure = replace(
        branch(), parameter_values=middle + width * parts, period=middle + width * parts, events=()
    ).plot("period")
    return figure, figure.axes[0]


@pytest.mark.parametrize("middle", [0.0, 1.0, -123.456])
@pytest.mark.parametrize("width", [1e-9, 1e-5, 0.03, 40.0])
def test_tick_labels_stand_apart_and_say_all(middle, width):
    """None touches another, and nothing is added or multiplied elsewhere."""
    figure, axes = drawn(middle, width)
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


def test_numbers_that_are_written_as_formulas_take_no_more_room():
    plain = drawn(1.0, 0.03)[1].get_xticks()
    pyplot = pytest.importorskip("matplotlib.pyplot")
    with pyplot.rc_context({"axes.formatter.use_mathtext": True}):
        assert drawn(1.0, 0.03)[1].get_xticks().tolist() == plain.tolist()


def test_tick_labels_stand_apart_at_every_draw():
    """Of a figure that is made narrower, and whose numbers are written longer, once drawn."""
    figure, axes = drawn(0, 0.5)

    def labels():
        figure.draw_without_rendering()
        drawn = [label for label in axes.get_xticklabels() if label.get_text()]
        boxes = [label.get_window_extent() for label in drawn]
        assert all(not a.overlaps(b) for a, b in itertools.pairwise(boxes))
        return [label.get_text() for label in drawn]

    figure.set_size_inches(9, 3)
    wide = labels()
    figure.set_size_inches(2, 3)
    narrow = labels()
    assert 2 <= len(narrow) < len(wide)
    figure.set_size_inches(9, 3)
    assert labels() == wide
    axes.xaxis.set_major_formatter(lambda x, _: f"{x:.20f} of a unit")
    assert 2 <= len(labels()) < len(wide)


def test_a_constant_is_drawn_as_one():
    sweep = ns.load(file_of("nonsmooth sweep"))
    noise = partial(np.random.default_rng(0).normal, 2, 1e-13)
    for figure in (
        replace(branch(), period=noise(size=len(branch())), events=()).plot("period"),
        replace(sweep, samples=noise(size=sweep.samples.shape)).plot(),
    ):
        low, high = figure.axes[0].get_ylim()
        assert low < 1.95
        assert high > 2.05


def test_values_without_samples_have_a_place():
    sweep = ns.load(file_of("nonsmooth sweep"))
    sweep.samples[-2:] = np.nan
    low, high = sweep.plot().axes[0].get_xlim()
    assert low < sweep.values[0] < sweep.values[-1] < high

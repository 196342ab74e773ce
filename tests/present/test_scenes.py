"""Pictures of simulated motions, and of bifurcations."""

from collections.abc import Iterator
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from nonsmooth import observe, simulate, sweep
from nonsmooth.runtime.simulation.trajectory import Trajectory
from tests.pictures import figure_of_saved

matplotlib = pytest.importorskip("matplotlib")
matplotlib.use("Agg")
from matplotlib import pyplot
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.figure import Figure
from matplotlib.patches import StepPatch

FRICTION = {"chi": "0.5", "eta": 1, "V": 1, "us1": 1, "us2": 1, "ur1": "4.0195", "ur2": "1.4831"}
STOP = {"m1": 1, "m2": 2, "k1": 1, "k2": 5, "r": "0.8"}
CONFIGURATIONS = ["stick-stick", "slip-stick", "slip-slip", "stick-slip"]


@cache
def few() -> Trajectory:
    return simulate("dry-friction", FRICTION, [5, 3, 1, 1], transitions=4)


@cache
def many() -> Trajectory:
    return simulate("dry-friction", FRICTION, [0, 0, 0, 0], transitions=1500)


@cache
def impacts(count: int = 6) -> Trajectory:
    return simulate("rigid-stop", {**STOP, "r": 1}, [0, 0.5, 3, 0], transitions=count)


@pytest.fixture(autouse=True)
def closed() -> Iterator[None]:
    yield
    pyplot.close("all")


def axes_of(count: int = 1) -> list[Axes]:
    return list(np.ravel(Figure(layout="constrained").subplots(count, squeeze=False)))


def curve(axes: Axes, label: str) -> np.ndarray:
    (line,) = [line for line in axes.get_lines() if line.get_label() == label]
    return np.array(line.get_xydata(), dtype=float)


def legend(axes: Axes) -> list[str]:
    return [text.get_text() for text in axes.get_legend().get_texts()]


def levels(axes: Axes) -> list[str]:
    return [text.get_text() for text in axes.texts if text.get_text() and "%" not in str(text)]


# --- every kind


# --- what is drawn


def test_histories_are_the_motion() -> None:
    for kind, first, mark in (("time", 0, ""), ("velocity", 2, "'")):
        (axes,) = axes_of()
        few().plot(kind, axes)
        for mass in (0, 1):
            points = curve(axes, f"$x_{{{mass + 1}}}${mark}".replace("$'", "'$"))
            assert len(points) > 1900
            assert_allclose(points[:, 1], few()(points[:, 0])[:, first + mass], atol=1e-12)
        assert legend(axes)[2:] == CONFIGURATIONS
        assert levels(axes) == ([] if kind == "time" else ["$V$"])


def test_the_background_is_the_configuration() -> None:
    (axes,) = axes_of()
    few().plot("time", axes)
    colors = {}
    for handle, label in zip(*axes.get_legend_handles_labels(), strict=True):
        if label in CONFIGURATIONS:
            colors[tuple(handle.get_facecolor()[0][:3])] = label
    assert len(colors) == 4
    found = []
    for band in axes.collections:
        if isinstance(band, PolyCollection) and band.get_label() not in CONFIGURATIONS:
            label = colors[tuple(band.get_facecolor()[0][:3])]
            found += [(path.get_extents(), label) for path in band.get_paths()]
    assert len(found) == 4
    for box, label in found:
        assert few().configuration((box.x0 + box.x1) / 2) == label
        assert np.isin([box.x0, box.x1], [*few().times, few().end]).all()


def test_many_transitions_become_ranges_and_shares() -> None:
    found = observe(many())
    (axes,) = axes_of()
    many().plot("time", axes)
    high = curve(axes, "$x_{1}$, range")
    assert_allclose(high[:, 1].max(), found.maxima["x1"].value, atol=5e-3)
    (low,) = [
        line
        for line in axes.get_lines()
        if line.get_color() == axes.get_lines()[0].get_color() and line.get_label()[0] == "_"
    ]
    assert_allclose(np.min(low.get_ydata()), found.minima["x1"].value, atol=5e-3)
    assert (np.asarray(low.get_ydata()) <= high[:, 1]).all()
    shares = [patch for patch in axes.patches if isinstance(patch, StepPatch)]
    order = list(dict.fromkeys(many().configurations))
    assert legend(axes)[2:] == [f"{name}, share" for name in order]
    heights = [np.mean(p.get_data().values - p.get_data().baseline) for p in shares]
    assert_allclose(np.divide(heights, sum(heights)), [found.fractions[n] for n in order], 1e-9)
    assert len(axes.get_lines()) < 10


def test_the_strip_shows_which_configuration_when() -> None:
    (axes,) = axes_of()
    few().plot("strip", axes)
    assert [text.get_text() for text in axes.get_yticklabels()] == CONFIGURATIONS
    boxes = [path.get_extents() for bars in axes.collections for path in bars.get_paths()]
    assert len(boxes) == 4
    for box in boxes:
        row = round((box.y0 + box.y1) / 2)
        assert few().configuration((box.x0 + box.x1) / 2) == CONFIGURATIONS[row]
    found = observe(few()).fractions
    parts = [float(text.get_text().split()[0]) for text in axes.texts]
    assert_allclose(parts, [100 * found[name] for name in CONFIGURATIONS], atol=0.051)


def test_the_strip_of_many_transitions_is_as_high_as_the_share() -> None:
    (axes,) = axes_of()
    many().plot("strip", axes)
    names = [text.get_text() for text in axes.get_yticklabels()]
    fractions = observe(many()).fractions
    for name, patch in zip(names, axes.patches, strict=True):
        data = patch.get_data()
        assert np.mean(data.values - data.baseline) == pytest.approx(0.8 * fractions[name])


def test_portraits_are_the_motion_with_impacts_apart() -> None:
    motion = impacts()
    first, second = motion.plot("phase")
    points = curve(first, "($x_{1}$, $x_{1}'$)")
    gaps = np.flatnonzero(np.isnan(points[:, 0]))
    gaps = gaps[: motion.transitions]
    assert_allclose(points[gaps - 1], motion.before[1:, [0, 2]], atol=1e-12)
    assert_allclose(points[gaps + 1], motion.states[1:, [0, 2]], atol=1e-12)
    jumps = curve(first, "impact").reshape(-1)
    jumps = jumps[np.isfinite(jumps)].reshape(-1, 2, 2)
    assert_allclose(jumps[:, 0, 1], -jumps[:, 1, 1])
    assert len(jumps) == motion.transitions
    (line,) = [line for line in first.get_lines() if line.get_label() == "impact"]
    assert line.get_linestyle() == "--"
    assert "impact" not in legend(second)
    assert levels(first) == ["$x_{1}$ = $1$"]
    assert levels(second) == []
    assert_array_equal(curve(first, "start"), [[0, 3]])
    assert_allclose(curve(second, "end"), motion.states[-1:, [1, 3]])


def test_a_level_is_the_parameter_that_moves_it() -> None:
    """V = us1 = us2 = 1 in these data, and the stop's 1 is no parameter."""
    (axes,) = axes_of()
    few().plot("velocity", axes)
    assert levels(axes) == ["$V$"]
    (axes,) = axes_of()
    impacts().plot("time", axes)
    assert levels(axes) == ["$x_{1}$ = $1$"]
    # dry friction is nondimensional, and this one is in the units of its user
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("time $t$", "positions $x_{1}$, $x_{2}$")


def test_dense_portraits_are_faint_pieces() -> None:
    axes, _ = impacts(2000).plot("phase")
    lines = [c for c in axes.collections if isinstance(c, LineCollection)]
    assert len(lines) == 2
    segments = np.concatenate(lines[0].get_segments())
    assert segments[:, 0].max() == pytest.approx(1, abs=1e-9)
    assert lines[0].get_alpha() < 0.2
    assert lines[0].get_rasterized()
    low, high = axes.get_xlim()
    assert low < segments[:, 0].min()
    assert high > 1


# --- bifurcations


def test_a_bifurcation_is_its_samples() -> None:
    data = {name: value for name, value in FRICTION.items() if name != "V"}
    start = dict.fromkeys(("x1", "x2", "v1", "v2"), 0)
    diagram = sweep(
        "dry-friction", data, "V", [0.9, 1.0, 1.1], start, state="x1",
        configuration="slip-stick", transient=10, samples=3,
    )  # fmt: skip
    samples = np.array([[1, np.nan, np.nan], [1.5, np.nan, 2.5], [np.nan] * 3])
    figure = figure_of_saved(replace(diagram, samples=samples))
    figure.draw_without_rendering()
    (axes,) = figure.axes
    (line,) = axes.get_lines()
    assert line.get_xydata().tolist() == [[0.9, 1.0], [1.0, 1.5], [1.0, 2.5]]
    assert axes.get_legend() is None
    assert axes.get_xlabel() == "$V$ (nondimensional)"
    assert axes.get_ylabel() == "$x_{1}$ (nondimensional)"
    assert axes.get_title(loc="left") == "dry-friction: x1 at each entry of slip-stick"


# --- wrong input

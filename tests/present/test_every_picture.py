"""Every kind of picture: labels stand apart, nothing is cut, legends tell apart."""

import itertools
import os
import tempfile
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest
import sympy as sp

import nonsmooth as ns
from nonsmooth.derive import SoftStop, oscillator
from tests.certified import loop
from tests.one_mass import one_mass

pytest.importorskip("matplotlib")
from matplotlib import pyplot
from matplotlib.figure import Figure
from matplotlib.text import Text

from tests.pictures import figure_in, figure_of, figure_of_saved, with_multipliers
from tests.places import GALLERY
from tests.shared import FOLDER
from tests.tables import slow
from tests.two_masses import STICKING

STICK = "dry-friction/global-stick"


def gallery(name, **data):
    return ns.solve(f"{GALLERY}/{name}", data)


@cache
def stop(length=1.0):
    """A machine before a stop in units of length: 1e-6 for micrometres that are metres."""
    F, w = sp.symbols("F w")
    size = sp.nsimplify(length)
    return one_mass(
        "a-machine-of-a-long-name-before-a-stop",
        SoftStop("x", at=size / 2, stiffness=20, damping=sp.Rational(4, 5)),
        stiffness=sp.Rational(1, 20), damping=1, forces={w: F * size},
    )  # fmt: skip


@cache
def found(length=1.0, w="1.3"):
    return ns.find_orbits(stop(length), {"F": "0.7", "w": w}, 12, transitions=120)


@cache
def branch(low, high, length=1.0):
    orbit = found(length, low).orbits[0].orbit
    return ns.continue_orbit(orbit, "w", (low, high), points=8)


@cache
def motion(count=4):
    return ns.simulate("dry-friction", STICKING, [5, 3, 1, 1], transitions=count)


CASES = {
    **{
        f"orbit {kind}": lambda kind=kind: ns.solve(STICK).plot(kind)
        for kind in ("time", "velocity", "phase", "strip", "multipliers", "all")
    },
    "orbit over periods": lambda: ns.solve(STICK).plot("strip", periods=4),
    "orbit between two stops": lambda: gallery("two_stops.py:broken").plot("all"),
    "orbit of many phases": lambda: gallery("three_masses.py:two-each").plot("all"),
    "orbit in metres": lambda: found(1e-6).orbits[0].orbit.plot("all"),
    "four multipliers in a wide panel": lambda: with_multipliers(
        ns.solve("rigid-stop/one-impact"), *(-0.0799775 * k for k in range(1, 5))
    ).plot("multipliers", Figure(figsize=(6, 2.2), layout="constrained").add_subplot()),
    "motion": lambda: motion().plot("all"),
    "motion in micrometres": lambda: ns.simulate(
        stop(1e5), {"F": "0.7", "w": "1.3"}, {"x": 0, "v": 0}, until=60
    ).plot("all"),
    "found": lambda: figure_of_saved(found()),
    "found velocity": lambda: figure_of_saved(found(), "velocity"),
    "basins": lambda: basins(found(), 1, 6),
    "branch": lambda: symmetric_branch().plot(),
    "narrow branch": lambda: figure_of_saved(
        branch("1.3", "1.3001"),
        quantity=("amplitude_x", "trace"),
        over=None,
        frequency="angular",
    ),
    "branch in metres": lambda: branch("1.0", "1.05", 1e-6).plot(),
    "locus": lambda: flips().plot(),
    "sweep": lambda: figure_of_saved(swept()),
    "narrow sweep of small numbers": lambda: figure_of_saved(
        replace(swept(), values=np.linspace(1e5, 1.00001e5, 5), samples=1e-6 * swept().samples)
    ),
    "chart": lambda: figure_in(charted(16)),
    "chart along a line": lambda: figure_in(charted()),
    "fit": lambda: fitted().plot(),
    "design": lambda: ns.design(
        ns.solve("dry-friction/symmetric"), minimise="spectral_radius", over={"V": (0.3, 3)}
    ).plot(),
    "box": lambda: ns.certify.box(
        loop(r="-19/20", a="3/5"), {"r": ("-11/10", "-9/10"), "a": ("27/50", "7/10")}
    ).plot(),
    "line of a box": lambda: ns.certify.box(
        ns.solve("dry-friction/symmetric", {"V": "1.1"}), {"V": ("1.09", "1.11")}
    ).plot(),
    "certified branch": lambda: proved_branch().plot(),
    "motion of a chain": lambda: chain_motion().plot("all"),
    "motion of a chain over time": lambda: chain_motion().plot("time"),
    "many multipliers": lambda: many_multipliers().plot("multipliers"),
    "one point": lambda: figure_of_saved(
        replace(
            swept(),
            values=swept().values[:1],
            samples=swept().samples[:1, :1],
            outcomes=swept().outcomes[:1],
            done=1,
        )
    ),
    "at rest": lambda: ns.simulate(
        stop(), {"F": "1e-9", "w": "1.3"}, {"x": 0, "v": 0}, until=1e-7
    ).plot("all"),
    "late": lambda: ns.simulate(
        stop(), {"F": "0.7", "w": "1.3"}, {"x": 1e5, "v": 0}, until=1e-3
    ).plot("all"),
}


def basins(known, most, count):
    """A chart of starts whose positions are at most so large."""
    folder = Path(tempfile.mkdtemp(dir=os.environ[FOLDER]))
    known.save(folder / "found.json")
    starts = {"x": np.linspace(-most, most, count), "v": np.linspace(-1, 1, count)}
    ns.chart(str(folder / "found.json"), **starts, store=folder / "basins.zarr")
    return figure_in(folder / "basins.zarr")


@cache
def chain_motion():
    """Five masses, two of them before stops: more curves than there are colours."""
    size = 5
    K = sp.Matrix(size, size, lambda i, j: 2 * (i == j) - (abs(i - j) == 1))
    names = [f"x{k}" for k in range(1, size + 1)]
    chain = oscillator(
        "chain", names, sp.eye(size), K, sp.eye(size) / 20,
        elements=[SoftStop(name, at=1, stiffness=9, name=f"stop-of-{name}") for name in names[:2]],
    )  # fmt: skip
    start = {**{name: 0.1 for name in names}, **{f"v{k}": k for k in range(1, size + 1)}}
    return ns.simulate(chain, {}, start, until=9)


@cache
def many_multipliers():
    return with_multipliers(ns.solve(STICK), *(k * (-0.123456 + 0.01234567j) for k in range(1, 13)))


@cache
def symmetric_branch(high="1.3"):
    return ns.continue_orbit(ns.solve("dry-friction/symmetric", {"V": "1.05"}), "V", (1.0, high))


@cache
def proved_branch():
    return ns.certify.branch(symmetric_branch("1.2"), interval=("1", "1.05"))


@cache
def flips():
    (flip,) = (event for event in symmetric_branch().events if event.kind == "flip")
    return ns.continue_orbit(symmetric_branch(), "eta", (3.9, 4.1), event=flip)


@cache
def swept():
    data = {name: value for name, value in STICKING.items() if name != "V"}
    return ns.sweep(
        "dry-friction",
        data,
        "V",
        np.linspace(0.95, 1.05, 5),
        start=dict.fromkeys(("x1", "x2", "v1", "v2"), 0),
        state="x1",
        configuration="slip-stick",
        transient=400,
        samples=10,
    )


@cache
def charted(count=None):
    """The folder of a chart over one parameter, or over two."""
    folder = Path(tempfile.mkdtemp(dir=os.environ[FOLDER])) / "chart.zarr"
    other = {"eta": (0.8, 1.3, count)} if count else {}
    ns.chart("dry-friction/symmetric", V=(0.8, 1.3, 20), **other, store=folder)
    return folder


@cache
def fitted():
    times = np.linspace(0.2, 9, 30)
    x = ns.simulate("dry-friction", STICKING, [5, 3, 1, 1], until=10)(times)[:, 0]
    data = {"t": times, "x1": x}
    return ns.fit(
        "dry-friction",
        data,
        parameters={**STICKING, "us1": 1.01},
        free=["us1"],
        start={"x1": 5, "x2": 3, "v1": 1, "v2": 1},
        sigma=1e-3,
    )


def faults(figure):
    """What is wrong with the labels and legends of a figure that is drawn as it is."""
    figure.draw_without_rendering()
    room = figure.bbox.padded(1)
    for axes in figure.axes:
        ticks = [_labels(axis) for axis in (axes.xaxis, axes.yaxis)]
        for labels in ticks:
            for one, other in itertools.pairwise(labels):
                if one.get_window_extent().overlaps(other.get_window_extent()):
                    yield f"{one.get_text()!r} touches {other.get_text()!r}"
    for text in figure.findobj(Text):
        if not (text.get_visible() and text.get_text().strip()):
            continue
        box = text.get_window_extent()
        if not (
            room.containsx(box.x0)
            and room.containsx(box.x1)
            and room.containsy(box.y0)
            and room.containsy(box.y1)
        ) and not _hidden_tick(figure, text):
            yield f"{text.get_text()!r} is cut"
    for axes in figure.axes:
        legend = axes.get_legend()
        if legend is None:
            continue
        place = legend.get_window_extent()
        if place.y0 < axes.get_window_extent().y1 - 1:
            yield "the legend covers the picture"
        for title in (axes.title, axes._left_title):
            if title.get_text().strip() and place.overlaps(title.get_window_extent()):
                yield f"the legend covers {title.get_text()!r}"
        texts = [text.get_text() for text in legend.get_texts()]
        looks = [_look(handle) for handle in legend.legend_handles]
        entries = list(zip(texts, looks, strict=True))
        for (one, first), (other, second) in itertools.combinations(entries, 2):
            if one == other:
                yield f"two entries are {one!r}"
            if first == second:
                yield f"{one!r} looks like {other!r}"


SLOW = {  # whose kinds are drawn of other results too
    *("orbit of many phases", "motion in micrometres", "motion of a chain", "orbit in metres"),
    *("certified branch", "orbit between two stops", "branch in metres", "narrow branch", "late"),
}


@pytest.mark.parametrize("name", [slow(name, when=name in SLOW) for name in CASES])
def test_labels_stand_apart_and_legends_tell_apart(name):
    drawn = CASES[name]()
    assert not list(faults(drawn if isinstance(drawn, Figure) else figure_of(drawn)))
    pyplot.close("all")


def _labels(axis):
    low, high = sorted(axis.get_view_interval())
    return [
        tick.label1
        for tick in axis.get_major_ticks()
        if axis.axes.axison
        and axis.get_visible()
        and tick.label1.get_visible()
        and tick.label1.get_text()
        and low <= tick.get_loc() <= high
    ]


def _hidden_tick(figure, text):
    """Of an axis that is not shown, or beyond its ends."""
    for axes in figure.axes:
        for axis in (axes.xaxis, axes.yaxis):
            ticks = [*axis.get_major_ticks(), *axis.get_minor_ticks()]
            if any(text in (tick.label1, tick.label2) for tick in ticks):
                return text not in _labels(axis)
            if text in (axis.label, axis.offsetText):
                return not axes.axison
    return False


def _look(handle):
    told = "color", "facecolor", "linestyle", "linewidth", "marker", "markerfacecolor"
    names = (*told, "alpha", "hatch")
    found = [str(getattr(handle, f"get_{name}", lambda: None)()) for name in names]
    return (*found, str(getattr(handle, "_dash_pattern", None)))

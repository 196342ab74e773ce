"""Pictures of orbits, motions and bifurcations, and how a notebook shows orbits and equations."""

import re
import sys
from dataclasses import replace
from functools import cache, partial

import numpy as np
import pytest
import sympy as sp
from numpy.testing import assert_allclose, assert_array_equal

import nonsmooth
from nonsmooth import InputError, observe, simulate, sweep
from nonsmooth.derive import (
    Boundary,
    Configuration,
    FirstOrder,
    System,
    Transition,
    derive_equations,
    dry_friction,
)
from tests.cli.test_cli import run
from tests.pictures import figure_of_saved, legend_of, with_multipliers
from tests.present.elements import Elements
from tests.two_masses import CHAIN, STICKING

matplotlib = pytest.importorskip("matplotlib")
matplotlib.use("Agg")
from matplotlib import pyplot
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.figure import Figure
from matplotlib.patches import StepPatch

PANELS = 5  # of "all"
KINDS = ("time", "velocity", "phase", "strip", "multipliers", "all")
ORBIT = "dry-friction/global-stick"
ORBITS = (
    *("rigid-stop/one-impact", "elastic-stop/one-contact", "dry-friction/symmetric"),
    *(ORBIT, "dry-friction/solution-ii"),
)
CONFIGURATIONS = ["stick-stick", "slip-stick", "slip-slip", "stick-slip"]


@cache
def orbit(name=ORBIT):
    return nonsmooth.solve(name)


@cache
def few():
    return simulate("dry-friction", STICKING, [5, 3, 1, 1], transitions=4)


@cache
def many():
    return simulate("dry-friction", STICKING, [0, 0, 0, 0], transitions=1500)


@cache
def impacts(count=6):
    return simulate("rigid-stop", CHAIN | {"r": 1}, [0, 0.5, 3, 0], transitions=count)


@cache
def thermostat(lags):
    """A relay that switches by the last of some lags in a row: its states are no positions."""
    states = sp.symbols(f"a:{lags}", real=True)
    matrix = sp.Matrix(lags, lags, lambda i, j: {0: -1, 1: 1}.get(i - j, 0))

    def regime(name, way):
        reached = Boundary(f"{name}-ends", way * states[-1] - sp.Rational(1, 10))
        return Configuration(name, FirstOrder(matrix, [way, *[0] * (lags - 1)]), (reached,))

    system = System(
        "thermostat", "a relay", states, (), (regime("on", 1), regime("off", -1)),
        (Transition("on", {"on-ends"}, "off"), Transition("off", {"off-ends"}, "on")),
    )  # fmt: skip
    return simulate(system, {}, {str(state): 0 for state in states}, "on", until=12)


MOTIONS = {
    **{name: partial(orbit, name) for name in ORBITS},
    "motion": few,
    **{f"{lags} lags": partial(thermostat, lags) for lags in (1, 2, 3)},
}


@pytest.fixture(autouse=True)
def closed():
    yield
    pyplot.close("all")


def axes_of(count=1):
    return list(np.ravel(Figure(layout="constrained").subplots(count, squeeze=False)))


def curve(axes, label):
    """Points of the one curve of that label."""
    (line,) = [line for line in axes.get_lines() if line.get_label() == label]
    return np.array(line.get_xydata())


def bars(axes):
    """Where the bars of a strip are."""
    return [path.get_extents() for bars in axes.collections for path in bars.get_paths()]


def symbols(axes):
    """Symbols in a strip, without the shares of time."""
    return [text.get_text() for text in axes.texts if "%" not in text.get_text()]


def levels(axes):
    return [text.get_text() for text in axes.texts if text.get_text() and "%" not in str(text)]


# --- what is drawn


@pytest.mark.parametrize("kind", KINDS)
def test_every_kind_draws_into_given_axes_or_a_figure_of_pyplot(kind):
    places = axes_of(PANELS if kind == "all" else 1)
    given = places if kind == "all" else places[0]
    found = orbit().plot(kind, given)
    assert found == tuple(places) if kind == "all" else found is places[0]
    assert not pyplot.get_fignums()
    new = orbit().plot(kind)
    assert len(new) == PANELS if kind == "all" else isinstance(new, Axes)
    assert len(pyplot.get_fignums()) == 1
    for axes in places:
        assert "nondimensional" in axes.get_xlabel()
        assert re.search("nondimensional|configuration", axes.get_ylabel())


@pytest.mark.parametrize("name", ["rigid-stop/one-impact", "elastic-stop/one-contact"])
def test_the_stop_is_drawn_where_it_is(name):
    (axes,) = axes_of()
    orbit(name).plot("time", axes, periods=2)
    (stop,) = [line for line in axes.get_lines() if line.get_linestyle() == ":"]
    assert set(stop.get_ydata()) == {1.0}
    assert levels(axes) == ["$x_{1}$ = $1$"]
    places = axes_of(2)
    orbit(name).plot("phase", places)
    counts = [sum(line.get_linestyle() == ":" for line in a.get_lines()) for a in places]
    assert counts == [1, 0]
    assert "sticking" not in [*legend_of(places[0]), *legend_of(places[1])]


def test_an_impact_is_drawn_before_and_behind():
    (axes,) = axes_of()
    orbit("rigid-stop/one-impact").plot("velocity", axes, periods=2)
    points, u = curve(axes, "$x_{1}'$"), orbit("rigid-stop/one-impact").unknowns["u"]
    (switch,) = np.flatnonzero(np.diff(points[:, 0]) == 0)
    assert_allclose(points[[switch, switch + 1], 1], [-u, u], atol=1e-12)


@pytest.mark.parametrize("masses", [[1], (1, 0)])
def test_some_masses_alone(masses):
    (axes,) = axes_of()
    orbit().plot("time", axes, masses=masses)
    assert legend_of(axes)[: len(masses)] == [f"$z_{{{m + 1}}}$" for m in masses]
    assert legend_of(axes)[len(masses) :] == CONFIGURATIONS


@pytest.mark.parametrize("kind", ["time", "velocity"])
@pytest.mark.parametrize("of", MOTIONS)
def test_histories_are_the_motion(of, kind):
    (axes,) = axes_of()
    drawn, moving = MOTIONS[of](), kind == "velocity"
    motion, end, breaks, options = drawn, getattr(drawn, "end", None), (), {}
    if of in ORBITS:
        motion, options = drawn.motion(), {"periods": 1 + moving}
        end, breaks = motion.period, motion.breaks
    drawn.plot(kind, axes, **options)
    names, noun = motion.names[:2], "velocit" if moving else "position"
    places, prime = [2, 3] if moving else [0, 1], "'" * moving
    if "lags" in of:  # states that are neither; of several the first one has no other before it
        names, noun, prime = motion.names[moving:] or motion.names, "state", ""
        places = [motion.names.index(name) for name in names]
    labels = [f"${name[0]}_{{{name[1:]}}}{prime}$" for name in names]
    for place, label in zip(places, labels, strict=True):
        points = curve(axes, label)
        assert len(points) > 100
        inside = ~np.isin(points[:, 0] % end, breaks)
        assert_allclose(points[inside, 1], motion(points[inside, 0])[:, place], atol=1e-12)
        assert label in axes.get_ylabel()
    assert axes.get_ylabel().startswith(noun)
    assert axes.get_xlabel().startswith("time $t$")
    assert legend_of(axes) == [*labels, *dict.fromkeys(motion.configurations)]
    assert_allclose(axes.get_xlim(), (0, end * options.get("periods", 1)))


def test_pictures_of_states_that_are_no_positions_name_them():
    first, second = thermostat(3).plot("phase", axes_of(2))
    assert [first.get_xlabel(), first.get_ylabel()] == ["state $a_{0}$", "state $a_{1}$"]
    assert [second.get_xlabel(), second.get_ylabel()] == ["state $a_{1}$", "state $a_{2}$"]
    upper, lower, *_ = thermostat(2).plot("all", axes_of(4))
    assert [upper.get_ylabel(), lower.get_ylabel()] == ["state $a_{0}$", "state $a_{1}$"]


def test_phase_portraits_are_the_motion_together_or_apart():
    (axes,), places = axes_of(), axes_of(2)
    orbit().plot("phase", axes)
    assert orbit().plot("phase", places) == tuple(places)
    states = orbit().motion().sample(600).states
    for mass, own in enumerate(places):
        label = f"($z_{{{mass + 1}}}$, $z_{{{mass + 1}}}'$)"
        for drawn in (axes, own):
            points = curve(drawn, label)
            points = points[np.isfinite(points[:, 0])]
            assert_array_equal(points, states[:, [mass, 2 + mass]])
        assert own.get_xlabel() == f"position $z_{{{mass + 1}}}$ (nondimensional)"
        assert legend_of(own) == [label, "sticking"]
    assert axes.get_xlabel() == "positions $z_{1}$, $z_{2}$ (nondimensional)"
    assert axes.get_ylabel() == "velocities $z_{1}'$, $z_{2}'$ (nondimensional)"
    assert legend_of(axes) == ["($z_{1}$, $z_{1}'$)", "sticking", "($z_{2}$, $z_{2}'$)"]
    assert levels(axes) == ["$V$"]


def test_sticking_parts_and_belt_are_drawn_at_its_velocity():
    found = nonsmooth.solve(ORBIT, {"V": "0.9"})
    for kind in ("phase", "velocity"):
        (axes,) = axes_of()
        found.plot(kind, axes)
        belts = [line for line in axes.get_lines() if line.get_linestyle() == ":"]
        assert [set(line.get_ydata()) for line in belts] == [{0.9}]
    (axes,) = axes_of()
    found.plot("phase", axes)
    bands = [np.array(b.get_xydata()) for b in axes.get_lines() if b.get_linewidth() == 6]
    parts = [
        part[np.isfinite(part[:, 0])]
        for band in bands
        for part in np.split(band, np.flatnonzero(np.isnan(band[:, 0])))
    ]
    assert all((part[:, 1] == 0.9).all() for part in parts)
    # masses ride the belt in three phases together
    assert sum(np.ptp(part[:, 0]) for part in parts if len(part)) == pytest.approx(
        0.9 * sum(found.values[n] * c for n, c in (("ta", 2), ("tau", 1), ("tau2", 1)))
    )


@pytest.mark.parametrize(("name", "shown"), [(ORBIT, 4), ("dry-friction/solution-ii", 3)])
def test_dwell_times_are_named_in_the_strip(name, shown):
    """Also of a phase that takes no time, and has no bar."""
    (axes,) = axes_of()
    orbit(name).plot("strip", axes, periods=2)
    assert len(bars(axes)) == 2 * shown
    none = "" if shown == 4 else " = 0"
    assert symbols(axes) == [f"$t_{{a}}{none}$", "$\\tau$", "$\\tau_{1}$", "$\\tau_{2}$"] * 2


def test_multipliers_stand_in_the_unit_circle():
    (axes,) = axes_of()
    orbit().plot("multipliers", axes)
    circle = np.array(axes.get_lines()[0].get_xydata())
    assert_allclose(np.hypot(*circle.T), 1)
    assert axes.get_aspect() == 1
    for number, multiplier in enumerate(orbit().stability.multipliers, 1):
        (label,) = [text for text in legend_of(axes) if text.startswith(f"$\\mu_{{{number}}}")]
        assert_array_equal(curve(axes, label), [[multiplier.real, multiplier.imaginary]])


def test_multipliers_outside_the_circle_small_and_trivial_ones():
    axes = with_multipliers(orbit(), 1.7 + 2.4j, 1.7 - 2.4j, 2e-5 + 1.916322e-5j, 1).plot(
        "multipliers"
    )
    assert legend_of(axes) == [
        "$\\mu_{1} = 1.7+2.4\\,\\mathrm{i}$",
        "$\\mu_{2} = 1.7-2.4\\,\\mathrm{i}$",
        "$\\mu_{3} = 2\\cdot 10^{-5}+1.92\\cdot 10^{-5}\\,\\mathrm{i}$",
        "$\\mu_{4} = 1$, trivial",
    ]
    marks = [line for line in axes.get_lines() if line.get_label() in legend_of(axes)]
    assert [mark.get_markerfacecolor() == "none" for mark in marks] == [False, False, False, True]
    assert min(axes.get_ylim()) < -2.4 < 2.4 < max(axes.get_ylim())


def test_a_configuration_has_one_colour_in_all_pictures():
    places = orbit().plot("all")
    time, velocity, strip = (
        [
            tuple(bars.get_facecolor()[0][:3])
            for bars in axes.collections
            if isinstance(bars, PolyCollection)
        ]
        for axes in places[:3]
    )
    assert time == velocity == strip
    assert len(set(time)) == 4


# --- motions


def test_the_background_is_the_configuration():
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


def test_many_transitions_become_ranges_and_shares():
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
    assert legend_of(axes)[2:] == [f"{name}, share" for name in order]
    heights = [np.mean(p.get_data().values - p.get_data().baseline) for p in shares]
    assert_allclose(np.divide(heights, sum(heights)), [found.fractions[n] for n in order], 1e-9)
    assert len(axes.get_lines()) < 10


def test_the_strip_shows_which_configuration_when():
    (axes,) = axes_of()
    few().plot("strip", axes)
    assert [text.get_text() for text in axes.get_yticklabels()] == CONFIGURATIONS
    assert len(bars(axes)) == 4
    for box in bars(axes):
        row = round((box.y0 + box.y1) / 2)
        assert few().configuration((box.x0 + box.x1) / 2) == CONFIGURATIONS[row]
    found = observe(few()).fractions
    parts = [float(text.get_text().split()[0]) for text in axes.texts]
    assert_allclose(parts, [100 * found[name] for name in CONFIGURATIONS], atol=0.051)


def test_the_strip_of_many_transitions_is_as_high_as_the_share():
    (axes,) = axes_of()
    many().plot("strip", axes)
    names = [text.get_text() for text in axes.get_yticklabels()]
    fractions = observe(many()).fractions
    for name, patch in zip(names, axes.patches, strict=True):
        data = patch.get_data()
        assert np.mean(data.values - data.baseline) == pytest.approx(0.8 * fractions[name])


def test_portraits_are_the_motion_with_impacts_apart():
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
    assert "impact" not in legend_of(second)
    assert levels(first) == ["$x_{1}$ = $1$"]
    assert levels(second) == []
    assert_array_equal(curve(first, "start"), [[0, 3]])
    assert_allclose(curve(second, "end"), motion.states[-1:, [1, 3]])


def test_a_level_is_the_parameter_that_moves_it():
    """V = us1 = us2 = 1 in these data, and the stop's 1 is no parameter."""
    (axes,) = axes_of()
    few().plot("velocity", axes)
    assert levels(axes) == ["$V$"]
    (axes,) = axes_of()
    impacts().plot("time", axes)
    assert levels(axes) == ["$x_{1}$ = $1$"]
    # dry friction is nondimensional, and this one is in the units of its user
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("time $t$", "positions $x_{1}$, $x_{2}$")


def test_dense_portraits_are_faint_pieces():
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


def test_a_bifurcation_is_its_samples():
    data = {name: value for name, value in STICKING.items() if name != "V"}
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


# --- files


@pytest.mark.slow
def test_files_are_reproducible(tmp_path):
    """Those of the paper, .svg and .png, are looked at in test_schematics.py."""
    saved = tmp_path / "orbit.json"
    orbit().save(saved)
    paths = [tmp_path / f"{name}.pdf" for name in ("first", "second")]
    for path in paths:
        assert run("plot", str(saved), "--kind", "time", "--out", str(path))[0] == 0
    first, second = (path.read_bytes() for path in paths)
    assert first == second
    assert len(first) > 10_000
    assert b"Date" not in first
    assert not pyplot.get_fignums()


# --- wrong input


@pytest.mark.parametrize(
    ("of", "kind", "options", "part"),
    [
        (few, "phases", {}, "unknown kind of picture 'phases'; did you mean 'phase'"),
        (few, "multipliers", {}, "unknown kind of picture"),
        (few, "time", {"masses": [2]}, r"masses = \[2\]: dry-friction has \[0, 1\]"),
        (orbit, "time", {"masses": [0, 5]}, r"masses = \[0, 5\].*global-stick has \[0, 1\]"),
        (orbit, "time", {"masses": [-1]}, r"masses = \[-1\]"),
        (orbit, "time", {"masses": []}, r"masses = \[\]"),
        (orbit, "time", {"periods": 0}, "periods = 0"),
        (few, "time", {"points": 0}, "points = 0 is not an integer from 1"),
        (few, "time", {"axes": axes_of(2)}, "'time' is drawn into 1 Axes; given: 2 Axes"),
        (few, "phase", {"axes": axes_of(3)}, "'phase' is drawn into 1 or 2 Axes"),
        (few, "all", {"axes": axes_of(4)}, "'all' is drawn into 5 Axes"),
        (few, "time", {"axes": 3}, "given: 1 int"),
    ],
)
def test_wrong_input(of, kind, options, part):
    with pytest.raises(InputError, match=part):
        of().plot(kind, **options)
    assert not pyplot.get_fignums()


def test_no_picture_without_an_orbit():
    lost = nonsmooth.solve(ORBIT, {"eta": "1e300"}, throw=False)
    with pytest.raises(InputError, match="has no motion"):
        lost.plot()


@pytest.mark.parametrize("large", [1e308, -1.7e308, 1e151])
def test_no_picture_of_numbers_that_axes_do_not_hold(large):
    far = replace(few(), run=replace(few().run, states=few().states.copy()))
    far.run.states[3, 1] = large
    with pytest.raises(InputError, match=r"numbers of .*, beyond 1e\+150: no picture"):
        far.plot()
    assert not pyplot.get_fignums()


# --- notebooks


@pytest.mark.parametrize("name", ORBITS)
def test_notebooks_show_every_orbit(name):
    text = " ".join(Elements(orbit(name)._repr_html_()).texts)
    told = orbit(name).to_json()
    for number in (told["period"], *told["unknowns"].values()):
        assert number[:10] in text
    for multiplier in told["multipliers"]:
        assert multiplier["re"][:10] in text
    assert "+ -" not in text
    assert told["stability"] in text
    assert f"{orbit(name).digits} digits" in text
    rows = orbit(name)._repr_latex_().splitlines()[1:-1]
    assert len(rows) == len(told["unknowns"])


def test_html_says_what_is_wrong():
    sharp = nonsmooth.refine(nonsmooth.solve(ORBIT, {"chi": "1/2", "us2": "0.8"}), 40)
    table = Elements(sharp._repr_html_())
    assert table.tags == {"table", "caption", "tr", "th", "td", "br"}
    for part in ("chi = 1/2", "us2 = 0.8", "40 digits", "conditional", "it takes", "us1 > 0"):
        assert part in " ".join(table.texts)
    refused = nonsmooth.solve(ORBIT, {"us2": "0.7"})
    violations = refused._repr_html_().partition("violations")[2]
    for word in ("second-breaks-backward", "crossed at", "stick-stick", "0.0456843"):
        assert word in violations
    lost = nonsmooth.solve(ORBIT, {"eta": "1e300"}, throw=False)
    assert lost.message in " ".join(Elements(lost._repr_html_()).texts)
    assert lost.message in lost._repr_latex_()


def test_latex_of_an_orbit():
    latex = nonsmooth.refine(orbit(), 30)._repr_latex_()
    assert latex.startswith("$$\\begin{aligned}\n")
    assert latex.endswith("\n\\end{aligned}$$")
    rows = latex.splitlines()[1:-1]
    assert [row.partition(" &= ")[0] for row in rows] == [
        *("z_{10}", "z_{20}", "t_{a}", "\\tau", "\\tau_{1}", "\\tau_{2}")
    ]
    numbers = [row.partition(" &= ")[2].removesuffix(" \\\\") for row in rows]
    assert_allclose([float(n) for n in numbers], list(orbit().unknowns.values()), rtol=1e-12)
    assert all(len(number) > 30 for number in numbers)


@pytest.mark.slow
def test_equations_in_a_notebook(monkeypatch):
    equations = derive_equations(dry_friction.global_stick)
    latex = equations._repr_latex_()
    rows = latex.splitlines()[1:-1]
    assert len(rows) == 6
    meaning = "first-reaches-belt ends slip-slip, = (16) of Pascal (2011)"
    assert rows[2] == rf"& v_{{1}}^{{(3)}} - V = 0 && \text{{{meaning}}} \\"
    assert "*" not in latex
    pytest.importorskip("latex2mathml")
    html = equations._repr_html_()
    assert html is not None
    table = Elements(html)
    assert html.count("<tr>") == 6
    assert meaning in "".join(table.texts)
    assert "$" not in "".join(table.texts)
    monkeypatch.setitem(sys.modules, "latex2mathml.converter", None)
    assert equations._repr_html_() is None

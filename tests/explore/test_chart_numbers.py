"""What charts say of their points: against single orbits, proofs, closed forms, other routes."""

from functools import cache

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth import InputError
from nonsmooth.runtime.shooting.multipliers import family_margins
from tests.pictures import figure_in
from tests.places import GALLERY
from tests.user_systems import DAMPED, declare

STICK, SYMMETRIC = "dry-friction/global-stick", "dry-friction/symmetric"
IMPACT = f"{GALLERY / 'impact_oscillator.py'}:one-period"
BELTS = f"{GALLERY / 'two_belts.py'}:both-stick"
REST = {"x1": 0, "x2": 0, "v1": 0, "v2": 0}
MOTIONS = {"chi": 0.4, "us1": 0.0127, "ur1": 0.0255, "us2": 0.5, "ur2": 1}
# where the orbit comes and goes, and has others of the same itinerary beside it
WIDE = {"V": np.linspace(0.3, 2.0, 70), "eta": np.linspace(0.3, 3.0, 61)}
PLANES = {
    STICK: {"V": np.linspace(0.6, 1.9, 10), "eta": np.linspace(0.6, 1.7, 10)},
    IMPACT: {"sigma": np.linspace(-0.6, 0.6, 24), "w": np.linspace(1.6, 3.2, 21)},
    BELTS: {"chi": np.linspace(0.35, 0.7, 12), "u1": np.linspace(0.35, 0.7, 12)},
}
CHAIN = """
import sympy as sp
from nonsmooth.derive import Itinerary, Parameter, Reference, SoftStop, oscillator

k = Parameter("k", "stiffness of the stop")
system = oscillator(
    "chain",
    ["x1", "x2", "x3"],
    mass=sp.eye(3),
    stiffness=[[2, -1, 0], [-1, 2, -1], [0, -1, 2]],
    elements=[SoftStop("x1", at=sp.Rational(3, 10), stiffness=k.symbol, name="stop")],
    parameters=[k],
)
start = {"x10": "0.3", "x20": "0.42", "x30": "0.3", "v10": "0.73", "v20": "1.03", "v30": "0.73"}
orbits = [
    Itinerary(
        "mode",
        system,
        [("contact", "stop-leaves-stop", "on"), ("free", "stop-reaches-stop", "off")],
        period=Parameter("T", "period"),
        reference=Reference({"k": "0.1", "T": "8.14"}, {"on": "3.24", "off": "4.9", **start}),
    )
]
"""


@cache
def charted(orbit):
    return ns.chart(orbit, **PLANES[orbit])


def named(orbit, folder):
    """The name of an orbit, whose declaration is written if it has none."""
    declared = {"chain": (CHAIN, "mode"), "damped": (DAMPED, "loop")}.get(orbit)
    return orbit if declared is None else f"{declare(folder, declared[0])}:{declared[1]}"


def case(orbit, plane=None, *more, slow=False):
    """A chart; that kernels are compiled takes most of the time of some."""
    plane = PLANES[orbit] if plane is None else plane
    return pytest.param(orbit, plane, *more, marks=[pytest.mark.slow] * slow)


def assert_same_bits(first, second):
    assert set(first) == set(second)
    for name in first:
        assert first[name].values.tobytes() == second[name].values.tobytes(), name


SETTLING = {"V": np.linspace(0.3, 1.1, 5), "eta": [1.0, 4.0], "simulate": True, "start": REST}


@pytest.mark.parametrize(
    ("orbit", "plane", "chunk"),
    [
        case(STICK, None, 7),
        case(STICK, WIDE, 1000),
        case(STICK, {"V": np.linspace(0.3, 2, 9), "eta": [0.5, 1, 2.0], "chi": [0.2, 0.5, 0.8]}, 5),
        case(SYMMETRIC, {"V": np.linspace(0.5, 1.5, 90)}, 5),
        case("rigid-stop/one-impact", {"T": np.linspace(2, 8, 20), "k1": [0.5, 1.0, 2.0]}, 5),
        case("elastic-stop/one-contact", {"k3": np.geomspace(0.1, 50, 14), "T": [3.0, 4.5, 9]}, 5),
        # open parameters are judged, and forces given in place of their differences
        case(STICK, {"V": [0.85, 1.0, 1.1], "eta": [0.9, 1.2], "us1": 0.1, "us2": [0.5, 1.2]}, 5),
        case(STICK, {"us1": [0.4, 0.9], "ur1": [3.6, 3.9, 4.2]}, 5),
        case(IMPACT, {"w": np.linspace(2.2, 2.8, 9), "r": 1}, 5),  # which keeps areas
        *(case(orbit, None, 11, slow=True) for orbit in (IMPACT, BELTS)),
        case("chain", {"T": np.linspace(7.95, 8.2, 8), "k": [0.1, 0.2, 0.4]}, 5, slow=True),
        case("damped", {"r": np.linspace(0.2, 0.4, 4), "k": [0.9, 1.0]}, 3, slow=True),
        case("dry-friction", {**SETTLING, "transitions": 300, **MOTIONS}, 1, slow=True),
    ],
)
def test_a_point_is_what_its_orbit_is_whatever_the_chunks(orbit, plane, chunk, tmp_path):
    name = named(orbit, tmp_path)
    chart = ns.chart(name, chunk=10**6, **plane)
    assert_same_bits(chart, ns.chart(name, chunk=chunk, threads=3, **plane))
    assert (chart.status.values == 0).any()
    if orbit != "dry-friction":
        check_points(name, plane, chart)


def check_points(name, plane, chart):
    """Some of them, against orbits that are solved one by one."""
    there = chart.status.values == 0
    assert not chart.admissible.values[~there].any()
    assert (chart.limit.values[~there] == -2).all()
    names, meanings = list(ns.solve(name).unknowns), chart.limit.attrs["meanings"]
    for kind in (chart.admissible.values, there & ~chart.admissible.values):
        found = np.argwhere(kind)
        for place in found[:: max(1, len(found) // 10)]:
            point = chart.isel(dict(zip(chart.sizes, map(int, place), strict=True)))
            values = {k: x for k, x in plane.items() if np.ndim(x) == 0}
            values |= {str(k): float(point[k]) for k in chart.sizes}
            one = ns.solve(name, values, [float(point[n]) for n in names])
            for n in names:
                assert float(one.unknowns[n]) == pytest.approx(float(point[n]), rel=1e-6, abs=1e-6)
            assert one.period == pytest.approx(float(point.period), rel=1e-9)
            assert one.stability.margin == pytest.approx(float(point.margin), abs=1e-7)
            assert one.trace == pytest.approx(float(point.trace), rel=1e-7, abs=1e-7)
            verdict, told = one.admissibility.verdict, meanings[str(int(point.limit))]
            assert (verdict is not False) == bool(point.admissible) == (told == "none fails")
            if told.startswith("phase "):
                first = one.admissibility.violations[0]
                assert told == f"phase {first.phase + 1} {first.configuration}: {first.boundary}"
            if point.admissible:
                margin = float(point.margin)
                wanted = "stable" if margin > 1e-9 else "unstable" if margin < -1e-9 else "neutral"
                assert one.stability.verdict == wanted
    if "T" in plane and "k" in plane:
        assert there.sum() > 15
        np.testing.assert_allclose(
            chart.period.values[there], (chart["T"] + 0 * chart.k).values[there]
        )


def test_what_an_open_parameter_has_to_exceed():
    """What fails where it does not, and what one force gives of the others."""
    grid = {"V": [0.85, 1.0, 1.1], "eta": [0.9, 1.2]}
    plain, given = ns.chart(STICK, **grid), ns.chart(STICK, **grid, us1=0.1, us2=[0.5, 0.75, 1.2])
    assert given.admissible.dims == ("V", "eta", "us2")
    enough = (plain.least_us2 < given.us2) & (plain.least_us1 < 0.1)
    np.testing.assert_array_equal(given.admissible, plain.admissible & enough)
    meanings = given.limit.attrs["meanings"]
    told = {meanings[str(number)] for number in np.unique(given.limit)}
    assert {"none fails", "us2 is too small"} <= told
    # of ur1, us1 and e1, which has a default, one gives the other: us1 = ur1 - 3.0195
    line = ns.chart(STICK, ur1=[3.02, 3.5], e2=0.4831)
    wanted = line.least_us1 < line.ur1 - 3.0195
    np.testing.assert_array_equal(line.admissible, wanted)


def test_no_point_is_said_to_have_no_orbit(tmp_path):
    ns.chart(STICK, **PLANES[STICK], store=tmp_path / "F.zarr")
    texts = figure_in(tmp_path / "F.zarr").axes[0].get_legend().get_texts()
    told = {text.get_text().rpartition(" (")[0] for text in texts}
    assert {"none found", "stable"} <= told
    assert not any("no orbit" in text for text in told)


def test_simulated_chart_agrees_with_the_orbits():
    values = {**MOTIONS, "eta": 4}
    line = ns.chart("dry-friction", simulate=True, start=REST, V=[0.55, 0.6773, 0.7], **values)
    periodic = np.flatnonzero(line.transitions.values)
    assert periodic.size
    for place in periodic:
        given = {**values, "V": float(line.V[place])}
        recurrence = ns.itinerary_of(ns.simulate("dry-friction", given, REST, transitions=2000))
        assert len(recurrence.itinerary) == int(line.transitions[place])
        period = float(np.sum(recurrence.dwell_times))
        assert period == pytest.approx(float(line.period[place]), rel=1e-5)


# --- from anchor to anchor


def speckles(period):
    """Points whose period is 5 % off all four neighbours, which agree."""
    beside = np.stack([period[:-2, 1:-1], period[2:, 1:-1], period[1:-1, :-2], period[1:-1, 2:]])
    mean = beside.mean(axis=0)
    agree = (np.abs(beside - mean) < 0.05 * mean).all(axis=0)
    return int((agree & (np.abs(period[1:-1, 1:-1] - beside) > 0.05 * mean).all(axis=0)).sum())


def test_more_is_found_than_point_by_point():
    wide = ns.chart(STICK, chunk=10**6, **WIDE)
    alone = ns.solve(STICK, {"V": WIDE["V"][:, None], "eta": WIDE["eta"]})
    found = wide.status.values == 0
    assert found[alone.converged].all()
    assert wide.admissible.values[alone.admissible].all()
    assert (~found).sum() < 0.85 * (~alone.converged).sum()
    assert wide.admissible.values.sum() > alone.admissible.sum()
    # and speckles are gone
    assert speckles(alone.period) > 20
    assert speckles(wide.period.values) < 0.2 * speckles(alone.period)


# --- lost chunks, and other engines


@pytest.mark.slow
@pytest.mark.parametrize(
    ("orbit", "plane", "chunk"), [case(STICK, WIDE, 500), case(IMPACT, None, 60)]
)
def test_what_is_lost_or_damaged_is_computed_to_the_same_bits(orbit, plane, chunk, tmp_path):
    """Where anchors matter, which are the whole grid's."""
    store = tmp_path / "F.zarr"
    whole = ns.chart(orbit, store=store, chunk=chunk, **plane).load()
    for file in sorted(store.glob("*/c/1/*")):
        file.unlink()
    for file in sorted(store.glob("margin/c/0/*")):
        file.write_bytes(file.read_bytes()[:-1])
    assert_same_bits(whole, ns.chart(orbit, store=store, threads=1, **plane).load())


@pytest.mark.parametrize(
    ("orbit", "plane"),
    [
        case(STICK, {"V": [1.06, 1.13, 1.21, 1.29], "eta": np.linspace(0.8, 1.3, 5)}, slow=True),
        *(
            case(orbit, {name: values[::4] for name, values in PLANES[orbit].items()}, slow=True)
            for orbit in (IMPACT, BELTS)
        ),
    ],
)
def test_limits_without_compiled_kernels(orbit, plane, monkeypatch):
    compiled = ns.chart(orbit, **plane).limit.values
    monkeypatch.setenv("NONSMOOTH_BACKEND", "numpy")
    assert len({*compiled.ravel()}) > 1
    np.testing.assert_array_equal(compiled, ns.chart(orbit, **plane).limit.values)


# --- closed forms


def test_closed_forms_of_the_impact_oscillator():
    """Where there is an orbit, and the trace, as the file of the gallery derives them."""
    plane, r = charted(IMPACT), 0.8
    w, sigma = plane.w.values, plane.sigma.values[:, None]
    gain, period = 1 / (1 - w**2), 2 * np.pi / w
    cotangent = 1 / np.tan(period / 2)
    # (sigma + a U)^2 + (b U)^2 = gain^2
    a, b = (1 + r) * cotangent / 2, (1 - r) / (2 * w)
    root = (a * sigma) ** 2 - (a**2 + b**2) * (sigma**2 - gain**2)
    assert (plane.status.values[root > 0] == 0).mean() > 0.99
    assert (plane.status.values[root < 0] == 0).sum() <= 2  # of other periods
    motion = plane.admissible.values & (np.abs(plane.period.values - period) < 1e-9)
    traces = []
    for sign in (1, -1):
        with np.errstate(invalid="ignore"):
            impact = (-a * sigma + sign * np.sqrt(root)) / (a**2 + b**2)
            cosine = (sigma + (1 + r) * cotangent * impact / 2) / gain
            slope = (1 + r) * np.sin(period) * (cosine - sigma) / impact
            traces.append(np.where(impact > 0, -2 * r * np.cos(period) + slope, np.nan))
    off = np.nanmin(np.abs(np.stack(traces) - plane.trace.values)[:, motion], axis=0)
    assert motion.sum() > 200
    assert off.max() < 1e-8
    # both multipliers inside the circle: det = r^2, |trace| < 1 + det
    stable = np.abs(plane.trace.values) < 1 + r**2
    np.testing.assert_array_equal(plane.margin.values[motion] > 0, stable[motion])
    # where there is a stable motion it comes first
    both = motion & np.isfinite(np.stack(traces)).all(axis=0)
    assert (stable[both] | (np.abs(np.stack(traces)).min(axis=0)[both] > 1 + r**2)).mean() > 0.95


def test_margins_of_families():
    """One multiplier is 1; a reciprocal pair beside it is neutral on the circle."""
    angle = np.exp(0.7j)
    values = np.array([[1, angle, 1 / angle], [1, 3.0, 1 / 3.0], [0.5, 1, 0.2]], dtype=complex)
    margins = family_margins(values, values.sum(axis=-1).real, 3)
    np.testing.assert_allclose(margins, [0, -2, 0.5], atol=1e-12)
    np.testing.assert_allclose(
        family_margins(np.array([[1, 0.25 + 0j]]), np.array([1.25]), 2), [0.75]
    )


def test_a_point_outside_a_domain_has_no_orbit():
    line = ns.chart(IMPACT, r=[0.7, 0.8, 1.5])
    assert (line.status.values == 0).tolist() == [True, True, False]
    assert np.isnan(line.margin.values[2])
    assert (line.limit.values >= -1).tolist() == [True, True, False]


@pytest.mark.parametrize(
    ("orbit", "given", "told"),
    [
        (STICK, {}, "nothing to chart"),
        (STICK, {"V": [1.0, 1.0]}, "do not increase"),
        (STICK, {"V": [1.0, np.nan]}, "finite"),
        (STICK, {"V": ["a"]}, "no row of numbers"),
        (STICK, {"V": np.ma.array([1.0, 2.0], mask=[False, True])}, "no row of finite numbers"),
        (STICK, {"W": [1.0, 2.0]}, "unknown parameter 'W'"),
        (STICK, {"V": [1.0, 2.0], "eta": -1}, "eta = -1 is outside its domain"),
        (STICK, {"V": [1.0, 2.0], "chunk": 0}, "chunk = 0"),
        (STICK, {"V": [1.0, 2.0], "threads": -1}, "threads = -1"),
        (STICK, {"V": [1.0, 2.0], "scheduler": "tcp://x"}, "needs a store"),
        (STICK, {"V": [1.0, 2.0], "start": REST}, "a start is for motions"),
        ("dry-friction", {"V": [1.0, 2.0], "simulate": True}, "start of the motions is missing"),
        (STICK, {n: np.linspace(1, 2, 10_000) for n in ("V", "eta")}, "for a store"),
        (STICK, {"V": [1.0, 1.1], "us1": 1, "ur1": 4, "e1": 3}, "e1 follows from ur1 and us1"),
        (STICK, {"V": [1.0, 1.1], "us1": -1}, "us1 = -1 is outside its domain"),
        (STICK, {"V": [1.0], "z10": 1}, "parameter 'z10'.*known: chi, eta, V, e1, e2, us1"),
        (SYMMETRIC, {"V": [1.0, 1.1], "ur1": 1}, "ur1 decides nothing"),
        (IMPACT, {"w": [2.0, 2.1], "frequency": 2}, "unknown parameter 'frequency'"),
        (IMPACT, {"w": [2.0, 2.1], "r": 2}, "r = 2 is outside its domain"),
        (IMPACT, {"w": [2.0, 2.1], "T": 2}, "unknown parameter 'T'"),
    ],
)
def test_wrong_input(orbit, given, told):
    with pytest.raises(InputError, match=told) as caught:
        ns.chart(orbit, **given)
    assert "\n" not in str(caught.value)

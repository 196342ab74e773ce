"""Masses and stiffnesses that are far apart: digits that are claimed are right, or none are."""

import functools
import sys

import numpy as np
import pytest
import sympy as sp

import nonsmooth as ns
from nonsmooth import NoConvergence
from nonsmooth.derive import Harmonic, Parameter, RigidStop, oscillator
from tests.tables import slow

VARIED = {
    "rigid-stop/one-impact": ("m1", "m2", "k1", "k2"),
    "elastic-stop/one-contact": ("m1", "m2", "k1", "k2", "k3"),
    "dry-friction/symmetric": ("eta", "V", "e2"),
    "dry-friction/global-stick": ("eta", "V", "e1", "e2"),
    "dry-friction/solution-ii": ("eta", "V", "e2"),
}


@pytest.fixture(
    params=[
        pytest.param("c", marks=pytest.mark.compiled),
        slow("numpy"),
    ]
)
def backend(request, monkeypatch):
    monkeypatch.setenv("NONSMOOTH_BACKEND", request.param)
    return request.param


def points(name, count, decades):
    """Parameters over so many decades each; periods near one of a mode's."""
    rng = np.random.default_rng([*name.encode()])
    for _ in range(count):
        values = 10.0 ** rng.uniform(-decades / 2, decades / 2, len(VARIED[name]))
        point = dict(zip(VARIED[name], values.tolist(), strict=True))
        if "m1" in point:
            m1, m2, k1, k2 = (point[key] for key in ("m1", "m2", "k1", "k2"))
            squares = np.linalg.eigvals([[k1 / m1, -k1 / m1], [-k1 / m2, (k1 + k2) / m2]])
            point["T"] = float(2 * np.pi / np.sqrt(abs(rng.choice(squares))) * rng.uniform(0.2, 3))
        else:
            point["chi"] = float(rng.uniform(0.05, 0.95))
        yield point


@pytest.mark.parametrize("name", VARIED)
def test_the_digits_of_one_orbit_are_those_of_fifty(name, backend):
    solved, fewer = 0, backend == "numpy" and "friction" in name  # a search of seconds
    every = [*points(name, 12 if backend == "c" else 5, 8)]
    for point in every[:3:2] if fewer else every:
        try:
            orbit = ns.solve(name, point)
        except NoConvergence:
            continue
        solved += 1
        exact = ns.refine(orbit, 50)
        for unknown, value in exact.unknowns.items():
            size = max(1.0, abs(float(value)))
            assert abs(float(orbit.unknowns[unknown] - value)) <= 2 * size * 10.0**-orbit.digits
        trace, found = float(exact.stability.trace), orbit.stability
        assert found.trace == pytest.approx(trace, rel=1e-9, abs=1e-9)
        if found.verdict != "undecided":
            assert found.verdict == exact.stability.verdict
    assert solved > (0 if fewer else 3)


@pytest.mark.parametrize("name", VARIED)
def test_orbits_of_a_batch_have_six_digits(name, backend):
    every = list(points(name, 2 if backend == "numpy" else 12, 8))
    found = ns.solve(name, {key: np.array([p[key] for p in every]) for key in every[0]})
    for i in np.flatnonzero(found.converged):
        guess = {key: float(values[i]) for key, values in found.unknowns.items()}
        exact = ns.refine(ns.solve(name, every[i], guess), 50)
        for unknown, value in exact.unknowns.items():
            assert abs(guess[unknown] - value) <= 1e-6 * max(1, abs(value))
        trace = float(exact.stability.trace)
        assert found.trace[i] == pytest.approx(trace, rel=1e-6, abs=1e-6)


@pytest.mark.parametrize("tiny", [1e-200, sys.float_info.min, 5e-324])
def test_what_is_beyond_doubles_is_told(tiny, backend):
    """Without the second spring nothing holds both masses: no orbit, or a family of them."""
    name, point = "elastic-stop/one-contact", dict(m1=1, m2=1, k1=1, k2=tiny, k3=1, T=3)
    with pytest.raises(NoConvergence):
        ns.solve(name, point)
    found = ns.solve(name, {**point, "T": [3]})
    assert not found.converged
    assert "beyond double precision" in found.message(found.status.item()) or tiny < 1e-300
    assert np.isnan(found.trace)
    for name in ("rigid-stop/one-impact", "elastic-stop/one-contact"):
        ones = dict.fromkeys(VARIED[name], 1.0) | {"T": 3.0}
        every = [ones | {varied: tiny} for varied in VARIED[name]]
        many = ns.solve(name, {key: np.array([p[key] for p in every]) for key in ones})
        for i in np.flatnonzero(many.converged):
            exact = ns.refine(ns.solve(name, every[i]), 50)
            assert many.trace[i] == pytest.approx(float(exact.stability.trace), abs=1e-6)


# composed from tables: two masses with damping and a stop, kicked by a forcing
TABLES = {"w": 1.9, "m1": 1, "m2": 1, "k1": 1, "k2": 1, "c": 0.1, "gap": 0.1, "r": 0.8}
STRUCK = [("free", "stop-reaches-stop")]


@functools.cache
def masses():
    w, m1, m2, k1, k2, c = (Parameter(name, name) for name in ("w", "m1", "m2", "k1", "k2", "c"))
    gap = Parameter("gap", "place of the stop", lower=-sp.oo)
    r = Parameter("r", "restitution", upper=1)
    return oscillator(
        "far-apart",
        ["x1", "x2"],
        mass=[[m1.symbol, 0], [0, m2.symbol]],
        stiffness=[[k1.symbol + k2.symbol, -k2.symbol], [-k2.symbol, k2.symbol]],
        damping=[[c.symbol, 0], [0, c.symbol / 3]],
        forcing=[Harmonic(w.symbol, cosine=[1, 0])],
        parameters=[w, m1, m2, k1, k2, c, gap, r],
        elements=[RigidStop("x2", at=gap.symbol, restitution=r.symbol, name="stop")],
    )


def table_points(count, decades):
    rng = np.random.default_rng(5)
    found = []
    for _ in range(count):
        point = {**TABLES, "gap": float(rng.uniform(-1, 1) * 10 ** rng.uniform(-4, 0))}
        for name in ("m1", "m2", "k1", "k2", "c"):
            point[name] *= float(10 ** rng.uniform(-decades / 2, decades / 2))
        point["w"] = float(np.sqrt(point["k1"] / point["m1"]) * rng.uniform(0.5, 3))
        found.append(point)
    return found


@pytest.mark.slow
@pytest.mark.parametrize("decades", [0, 8, 14, 20])
def test_digits_of_composed_orbits_are_those_of_fifty(decades, backend):
    every = table_points(20 if backend == "c" else 3, decades)
    guess = [[2 * np.pi / point["w"]] for point in every]
    given = {name: np.array([point[name] for point in every]) for name in TABLES}
    many = ns.solve(masses(), given, guess, itinerary=STRUCK, admissibility=False)
    unsure = ["beyond double precision" in many.message(s) for s in many.status.tolist()]
    assert np.isnan(many.trace[unsure]).all()
    assert decades != 14 or backend != "c" or any(unsure)
    found = 0
    for i in np.flatnonzero(many.converged)[:6]:
        start = [float(values[i]) for values in many.unknowns.values()]
        orbit = ns.solve(masses(), every[i], start, itinerary=STRUCK, throw=False)
        if not orbit.converged:
            assert "beyond double precision" in orbit.message
            continue
        found += 1
        exact = ns.refine(orbit, 50)
        for number, (name, value) in zip(start, exact.unknowns.items(), strict=True):
            size = max(1.0, abs(float(value)))
            assert abs(float(orbit.unknowns[name] - value)) <= 2 * size * 10.0**-orbit.digits
            assert abs(float(number - value)) <= 1e-6 * size
        trace = float(exact.stability.trace)
        assert many.trace[i] == pytest.approx(trace, rel=1e-6, abs=1e-6)
    assert decades > 8 or found > 0


@pytest.mark.parametrize("tiny", [1e-200, 1e-308, 5e-324, 1e200, 1e307])
def test_composed_orbits_beyond_doubles_are_told(tiny, backend):
    given = {name: np.full(len(TABLES), value, float) for name, value in TABLES.items()}
    for place, name in enumerate(TABLES):
        given[name][place] = tiny
    guess = (2 * np.pi / np.clip(given["w"], 1e-3, 1e3))[:, None]
    many = ns.solve(masses(), given, guess, itinerary=STRUCK)
    assert np.isnan(many.trace[~many.converged]).all()
    for i in np.flatnonzero(many.converged):
        point = {name: float(values[i]) for name, values in given.items()}
        start = [float(values[i]) for values in many.unknowns.values()]
        exact = ns.refine(ns.solve(masses(), point, start, itinerary=STRUCK), 50)
        for number, value in zip(start, exact.unknowns.values(), strict=True):
            assert abs(float(number - value)) <= 1e-6 * max(1.0, abs(float(value)))
        assert many.trace[i] == pytest.approx(float(exact.stability.trace), rel=1e-6, abs=1e-6)

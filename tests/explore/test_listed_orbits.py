"""Orbits that are listed differ, last in each phase, keep in a file, and are what proofs say."""

from functools import cache

import numpy as np
import pytest
import sympy as sp

import nonsmooth as ns
from nonsmooth.derive import (
    Boundary,
    Configuration,
    FirstOrder,
    Friction,
    Harmonic,
    Parameter,
    SoftStop,
    System,
    Transition,
    oscillator,
)
from tests.explore.listed import check_listed
from tests.explore.test_units import OF_UNITS, converter

pytestmark = pytest.mark.compiled


@cache
def kicked():
    """A damped mass before a stop, which a clock kicks."""
    gap, kick, c = Parameter("gap", "place"), Parameter("kick", "speed"), Parameter("c", "damping")
    x, v, theta = sp.symbols("x v theta", real=True)
    free = FirstOrder([[0, 1, 0], [-1, -c.symbol, 0], [0, 0, 0]], [0, 0, 1])
    bounds = Boundary("stop", x - gap.symbol), Boundary("clock", theta - 4)
    return System(
        name="kicked",
        description="a mass that a clock kicks",
        states=(x, v, theta),
        parameters=(gap, kick, c),
        configurations=(Configuration("free", free, bounds),),
        transitions=(
            Transition("free", {"stop"}, "free", reset={v: -sp.Rational(4, 5) * v}),
            Transition("free", {"clock"}, "free", reset={theta: 0, v: v + kick.symbol}),
        ),
    )


@cache
def rub():
    """A forced mass meets an undamped stop, which ends where its force does, with friction."""
    w, gap, k = Parameter("w", "frequency"), Parameter("gap", "place"), Parameter("k", "stiffness")
    return oscillator(
        "rub",
        ["x", "y"],
        mass=sp.eye(2),
        damping=sp.eye(2) / 10,
        stiffness=sp.eye(2),
        forcing=[Harmonic(w.symbol, cosine=[1, 0], sine=[0, 1])],
        elements=[
            SoftStop("x", at=gap.symbol, stiffness=k.symbol, name="stator", released="force"),
            Friction("y", kinetic=sp.Rational(1, 10), normal="stator", velocity=-3, name="face"),
        ],
        parameters=[w, gap, k],
    )


RANGES = {
    converter: {"w": (20, 23)},
    kicked: {"gap": (0.1, 0.5), "kick": (0.5, 2), "c": (0.1, 0.5)},
    rub: {"w": (0.8, 1.3), "gap": (0.5, 1), "k": (2, 20)},
}
PROVED = 5  # orbits, with the shortest phases


@pytest.mark.slow
@pytest.mark.parametrize("build", RANGES, ids=lambda build: build.__name__)
def test_what_is_listed_is_true(build, tmp_path):
    rng = np.random.default_rng(0)
    data = {name: f"{rng.uniform(*bounds):.2f}" for name, bounds in RANGES[build].items()}
    data |= {p.name: "1" for p in build().parameters if p in OF_UNITS}
    found = ns.find_orbits(build(), data, 3, transitions=130, rng=0)
    orbits = [entry.orbit for entry in found.orbits]
    check_listed(build(), found)
    file = tmp_path / "found.json"
    found.save(file)
    again = [entry.orbit for entry in ns.load(file).orbits]
    assert [orbit.unknowns for orbit in again] == [orbit.unknowns for orbit in orbits]
    for place in np.argsort([orbit.dwell_times.min() for orbit in orbits])[:PROVED]:
        orbit, precise = orbits[place], ns.refine(again[place], 40)
        assert (precise.dwell_times > 0).all()
        for near in (orbit, ns.solve(f"{file}:{place + 1}")):
            for name, value in precise.unknowns.items():
                assert abs(near.unknowns[name] - value) <= 10.0**-near.digits * max(1, abs(value))
        certificate = ns.certify(orbit)
        for claim, verdict in certificate.claims.items():
            if verdict == "undecided":
                assert certificate.reasons[claim]
            elif claim == "stability" and orbit.stability.verdict != "undecided":
                assert (verdict == "proved") == (orbit.stability.verdict == "stable")
            else:
                assert verdict == "proved"

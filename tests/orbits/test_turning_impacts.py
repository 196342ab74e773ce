"""A transition that keeps energy and not volume: its multipliers are no reciprocal pair."""

from functools import cache

import numpy as np
import pytest
import sympy as sp

import nonsmooth as ns
from nonsmooth.derive import (
    Boundary,
    Configuration,
    Itinerary,
    Parameter,
    Phase,
    Reference,
    SecondOrder,
    System,
    Transition,
)
from tests.cli.test_cli import told

pytestmark = pytest.mark.slow
X, Y, V, W = sp.symbols("x y v w", real=True)
GIVEN = {"p": "1", "T": "6.26574158"}


@cache
def turned(reverse=False):
    """Two masses, one with a stop that is a spring; behind it the velocities are turned.

    The same motion run backwards is one of the system that turns them back in front of the stop.
    """
    load, period = Parameter("p", "load"), Parameter("T", "period")
    quarter, fifth = sp.Rational(1, 4), sp.Rational(1, 5)

    def masses(stop):
        forces = (-2 * quarter * load.symbol, quarter * load.symbol)
        return SecondOrder(sp.eye(2), [[7 * quarter + stop, -1], [-1, 7 * quarter]], forces)

    free = Configuration("free", masses(0), (Boundary("reaches", -X),))
    contact = Configuration("contact", masses(1), (Boundary("leaves", X),))
    turn = {V: fifth * (4 * V + 3 * W), W: fifth * (4 * W - 3 * V)}
    back = {V: fifth * (4 * V - 3 * W), W: fifth * (4 * W + 3 * V)}
    transitions = (
        Transition("free", {"reaches"}, "contact", (), back if reverse else {}),
        Transition("contact", {"leaves"}, "free", (), {} if reverse else turn),
    )
    system = System("turned", "", (X, Y, V, W), (load,), (free, contact), transitions)
    guess = {"y0": "0.392878", "v0": "0.451699", "w0": "0.481649", "ta": "2.466291"}
    if reverse:
        guess |= {"y0": "0.187998", "v0": "0.587674", "w0": "0.443265"}
    phases = (Phase("free", "reaches", "ta"), Phase("contact", "leaves", "tb"))
    reference = Reference(GIVEN, guess)
    return ns.solve(Itinerary("loop", system, phases, period=period, reference=reference))


def test_an_orbit_is_unstable_though_its_trace_is_small():
    orbit = turned()
    assert orbit.admissibility.verdict is True
    assert orbit.kernels.table["conservative"] is True
    assert orbit.kernels.table["reciprocal_pair"] is False
    assert abs(orbit.trace - 1) < 2
    values = np.linalg.eigvals(orbit.poincare_jacobian)
    largest = abs(values).max()
    assert largest > 2
    assert np.prod(values).real == pytest.approx(largest**2)
    tables = orbit.problem.by_tables(orbit)
    np.testing.assert_allclose(orbit.saltations, tables.saltations, atol=1e-9)
    for found in (orbit, ns.refine(orbit, 30), tables):
        assert found.stability.verdict == "unstable"
        assert [m.trivial for m in found.stability.multipliers] == [False, False, True]
        assert float(found.stability.margin) == pytest.approx(1 - largest)


def test_backwards_it_is_stable_on_its_level_of_energy():
    orbit, forward = turned(reverse=True), turned()
    assert orbit.admissibility.verdict is True
    assert orbit.kernels.table["reciprocal_pair"] is False
    largest = 1 / (1 - forward.stability.margin)
    for found in (orbit, ns.refine(orbit, 30), orbit.problem.by_tables(orbit)):
        assert found.stability.verdict == "stable"
        assert [m.trivial for m in found.stability.multipliers] == [True, False, False]
        assert float(found.stability.margin) == pytest.approx(1 - largest)
    branch = ns.continue_orbit(orbit, "p", (0.99, 1.01), points=5)
    assert set(branch.stability) == {"stable"}


@pytest.mark.parametrize("reverse", [False, True])
def test_a_chart_has_the_margin_of_the_orbit(reverse, tmp_path):
    orbit = turned(reverse)
    file = tmp_path / "turned.json"
    orbit.save(file)
    found = ns.chart(str(file), p=(1.0, 1.001), T=float(GIVEN["T"]))
    assert float(found["margin"][0]) == pytest.approx(orbit.stability.margin)
    assert orbit.stability.margin < -1 or reverse


def test_no_criterion_of_its_trace_is_proved(tmp_path):
    turned().save(tmp_path / "turned.json")
    found = told("verify", str(tmp_path / "turned.json"), "--digits", "30")
    assert found["proof"]["statement"] is None


def test_beside_the_trivial_multiplier_alone_an_orbit_is_neutral(tmp_path):
    place = Parameter("p", "place of the stop", lower=-sp.oo)
    free = Configuration("free", SecondOrder([[1]], [[1]]), (Boundary("hits", X - place.symbol),))
    bounce = Transition("free", {"hits"}, "free", (), {V: -V})
    system = System("one-mass", "", (X, V), (place,), (free,), (bounce,))
    known = Reference({"p": "-0.5", "T": "4"}, {"v0": "-1"})
    phases, period = (Phase("free", "hits", "T"),), Parameter("T", "period")
    orbit = ns.solve(Itinerary("bouncing", system, phases, period=period, reference=known))
    for name, found in (("T", orbit), ("period", orbit.problem.by_tables(orbit))):
        assert (found.stability.verdict, found.stability.margin) == ("neutral", 0)
        found.save(tmp_path / f"{name}.json")
        chart = ns.chart(str(tmp_path / f"{name}.json"), p=(-0.5, -0.49), **{name: 4.0})
        assert chart["margin"].values.tolist() == [0, 0]


@cache
def mirrored(period):
    """Return an orbit that is its own time reversal, of two masses whose impact mirrors velocities.

    Between impacts x = a cos(t - T/2), y = b cos(sqrt(5) (t - T/2)): the velocities in front of an
    impact are those behind it turned round, which the mirror keeps on its line v = -2 w.
    """
    place, time = Parameter("p", "place of the stop", lower=-sp.oo), Parameter("T", "period")
    linear = SecondOrder(sp.eye(2), [[1, 0], [0, 5]])
    free = Configuration("free", linear, (Boundary("hits", place.symbol - X),))
    fifth = sp.Rational(1, 5)
    mirror = {V: fifth * (4 * W - 3 * V), W: fifth * (4 * V + 3 * W)}
    impact = Transition("free", {"hits"}, "free", (), mirror)
    system = System("mirrored", "", (X, Y, V, W), (place,), (free,), (impact,))
    slow, fast = period / 2, np.sqrt(5) * period / 2
    v = -np.tan(slow)  # x = p = -1 at the impact
    y = -v / (2 * np.sqrt(5) * np.tan(fast))
    known = Reference(
        {"p": "-1", "T": repr(period)}, {"y0": str(y), "v0": str(v), "w0": str(-v / 2)}
    )
    phases = (Phase("free", "hits", "T"),)
    return ns.solve(Itinerary("loop", system, phases, period=time, reference=known))


@pytest.mark.parametrize("beyond", [1e-11, 1e-9, 1e-3])
def test_a_time_reversal_has_a_reciprocal_pair_where_no_derivation_tells_it(beyond):
    meeting = 5.183679393061944  # there the trace is 3: all multipliers are 1
    inside, outside = mirrored(meeting - beyond), mirrored(meeting + beyond)
    assert outside.kernels.table["reciprocal_pair"] is False
    assert outside.admissibility.verdict is inside.admissibility.verdict is True
    assert (inside.stability.verdict, inside.stability.margin) == ("neutral", 0)
    # mu + 1/mu is the trace less 1; where multipliers meet a solver of eigenvalues errs by 1e-8
    half = (outside.trace - 1) / 2
    largest = half + np.sqrt(half**2 - 1)
    precise = ns.refine(outside, 40).stability
    assert outside.stability.verdict == precise.verdict == "unstable"
    assert outside.stability.margin == pytest.approx(1 - largest, rel=1e-4)
    assert float(precise.margin) == pytest.approx(1 - largest, rel=1e-4)

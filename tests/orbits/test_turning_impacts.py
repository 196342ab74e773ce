"""A transition that keeps energy and not volume: its multipliers are no reciprocal pair."""

from functools import cache
from pathlib import Path

import numpy as np
import pytest
import sympy as sp

import nonsmooth as ns
from nonsmooth import Orbit
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
from nonsmooth.runtime.orbits.equations import equations_of
from nonsmooth.runtime.present.report import trace_proof_json

X, Y, V, W = sp.symbols("x y v w", real=True)
GIVEN = {"p": "1", "T": "6.26574158"}


@cache
def turned() -> Orbit:
    """Two masses, one with a stop that is a spring; behind it the velocities are turned."""
    load, period = Parameter("p", "load"), Parameter("T", "period")
    quarter, fifth = sp.Rational(1, 4), sp.Rational(1, 5)

    def masses(stop: int) -> SecondOrder:
        forces = (-2 * quarter * load.symbol, quarter * load.symbol)
        return SecondOrder(sp.eye(2), [[7 * quarter + stop, -1], [-1, 7 * quarter]], forces)

    free = Configuration("free", masses(0), (Boundary("reaches", -X),))
    contact = Configuration("contact", masses(1), (Boundary("leaves", X),))
    turn = {V: fifth * (4 * V + 3 * W), W: fifth * (4 * W - 3 * V)}
    transitions = (
        Transition("free", {"reaches"}, "contact"),
        Transition("contact", {"leaves"}, "free", (), turn),
    )
    system = System("turned", "", (X, Y, V, W), (load,), (free, contact), transitions)
    guess = {"y0": "0.392878", "v0": "0.451699", "w0": "0.481649", "ta": "2.466291"}
    phases = (Phase("free", "reaches", "ta"), Phase("contact", "leaves", "tb"))
    reference = Reference(GIVEN, guess)
    return ns.solve(Itinerary("loop", system, phases, period=period, reference=reference))


def test_an_orbit_is_unstable_though_its_trace_is_small() -> None:
    orbit = turned()
    assert orbit.admissibility.verdict is True
    assert orbit.kernels.table["conservative"] is True
    assert abs(orbit.trace - 1) < 2
    values = np.linalg.eigvals(orbit.poincare_jacobian)
    largest = abs(values).max()
    assert largest > 2
    assert np.prod(values).real == pytest.approx(largest**2)
    for found in (orbit, ns.refine(orbit, 30), orbit.problem.by_tables(orbit)):
        assert found.stability.verdict == "unstable"
        assert [m.trivial for m in found.stability.multipliers] == [False, False, True]
        assert float(found.stability.margin) == pytest.approx(1 - largest)


def test_a_chart_has_the_margin_of_the_orbit(tmp_path: Path) -> None:
    orbit = turned()
    file = tmp_path / "turned.json"
    orbit.save(file)
    found = ns.chart(str(file), p=(1.0, 1.001), T=float(GIVEN["T"]))
    assert float(found["margin"][0]) == pytest.approx(orbit.stability.margin)
    assert orbit.stability.margin < -1


def test_a_branch_has_the_multipliers_of_the_orbit() -> None:
    orbit = turned()
    equations = equations_of(orbit)
    largest = np.abs(equations.multipliers(equations.values[None]))
    assert largest[0] == pytest.approx(1 - orbit.stability.margin)


def test_no_criterion_of_its_trace_is_proved() -> None:
    assert trace_proof_json(ns.refine(turned(), 30))["statement"] is None

"""What is found, followed and proved is the same in all units of length, time and mass."""

from __future__ import annotations

from fractions import Fraction
from functools import cache
from typing import Any

import numpy as np
import pytest
import sympy as sp

import nonsmooth as ns
from nonsmooth.derive import (
    Boundary,
    Condition,
    Configuration,
    FirstOrder,
    Friction,
    Harmonic,
    Parameter,
    System,
    Transition,
    oscillator,
)
from tests.scaled_systems import DAMPING, FORCE, LENGTH, MASS, RATE, STIFFNESS

UNITS = [
    (1, 150, 3),
    (Fraction(1, 10**6), 1200, 7),
    (2**20, Fraction(1, 64), Fraction(1, 2)),
]
OF_UNITS = (
    Parameter("length", "unit of length"),
    Parameter("rate", "inverse of the unit of time"),
    Parameter("mass_unit", "unit of mass"),
)


@cache
def rubbing() -> System:
    """Two masses, one of them on a belt, under a force of the frequency w."""
    w = Parameter("w", "frequency of the force in the unit of it")
    return oscillator(
        "rubbing", ["x1", "x2"],
        mass=[[MASS, 0], [0, 2 * MASS]],
        stiffness=[[3 * STIFFNESS, -STIFFNESS], [-STIFFNESS, 2 * STIFFNESS]],
        damping=[[DAMPING / 5, 0], [0, DAMPING / 10]],
        forcing=[Harmonic(w.symbol * RATE, cosine=[2 * FORCE, 0])],
        elements=[Friction("x1", kinetic=FORCE / 2, static=FORCE * 3 / 4, name="belt")],
        parameters=(*OF_UNITS, w),
    )  # fmt: skip


@cache
def converter() -> System:
    """A buck converter that compares its voltage with a sawtooth; its clock is a time."""
    i, v, clock = sp.symbols("i v clock", real=True)
    w = Parameter("w", "input voltage in the unit of it")
    rows = [[0, -RATE / 50, 0], [RATE * 400 / 47, -RATE * 200 / 517, 0], [0, 0, 0]]
    gain, wanted = sp.Rational(42, 5), sp.Rational(113, 10) * LENGTH
    lowest, highest = sp.Rational(19, 5) * LENGTH, sp.Rational(41, 5) * LENGTH
    ramp = lowest + (highest - lowest) * clock * RATE
    above, at_reset = gain * (v - wanted) - ramp, gain * (v - wanted) - lowest
    ends = Boundary("clock", clock - 1 / RATE)
    on = FirstOrder(rows, [RATE * w.symbol * LENGTH / 50, 0, 1])
    again = {clock: 0}
    return System(
        "converter", "a buck converter", (i, v, clock), (*OF_UNITS, w),
        (
            Configuration("on", on, (Boundary("control", above), ends)),
            Configuration("off", FirstOrder(rows, [0, 0, 1]), (Boundary("control", -above), ends)),
        ),
        (
            Transition("on", {"control"}, "off"),
            Transition("off", {"control"}, "on"),
            Transition("on", {"clock"}, "off", reset=again,
                       conditions=(Condition(at_reset, along="off"),)),
            Transition("on", {"clock"}, "on", reset=again),
            Transition("off", {"clock"}, "off", reset=again,
                       conditions=(Condition(at_reset, along="off"),)),
            Transition("off", {"clock"}, "on", reset=again),
        ),
    )  # fmt: skip


SYSTEMS = {
    "rubbing": (rubbing, "1.2", ("1.1", "1.3")),
    "converter": (converter, "22", ("21", "27")),
}


@cache
def answers(name: str, length: Any, rate: Any, mass: Any) -> Any:
    """Orbits that are found, events along the branch of the first, and what is proved of it."""
    declare, value, (low, high) = SYSTEMS[name]
    given = {"length": length, "rate": rate, "mass_unit": mass, "w": value}
    found = ns.find_orbits(declare(), given, 4, transitions=150, seed=3)
    # those to which motions come: which unstable ones are met on the way is a matter of rounding
    listed = [each.orbit for each in found.orbits if each.starts]
    first = listed[0]
    branch = ns.continue_orbit(first, "w", (low, high), step=0.05)
    proof = ns.certify(first)
    return listed, branch, proof


@pytest.mark.parametrize("units", UNITS, ids=str)
@pytest.mark.parametrize("name", SYSTEMS)
def test_orbits_branches_and_proofs_do_not_depend_on_units(name: str, units: Any) -> None:
    wanted, wanted_branch, wanted_proof = answers(name, 1, 1, 1)
    listed, branch, proof = answers(name, *units)
    assert [orbit.itinerary for orbit in listed] == [orbit.itinerary for orbit in wanted]
    for one, other in zip(listed, wanted, strict=True):
        assert float(one.period) * float(units[1]) == pytest.approx(float(other.period), rel=1e-9)
        np.testing.assert_allclose(one.multipliers, other.multipliers, rtol=0, atol=1e-7)
    assert [event.kind for event in branch.events] == [event.kind for event in wanted_branch.events]
    for one, other in zip(branch.events, wanted_branch.events, strict=True):
        assert one.value == pytest.approx(other.value, rel=1e-8)
    assert branch.ends == wanted_branch.ends
    assert proof.claims == wanted_proof.claims
    assert set(proof.claims.values()) == {"proved"}

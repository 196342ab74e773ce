"""Transitions that lead to the same state on different conditions are the same motion."""

from dataclasses import replace

import sympy as sp

import nonsmooth as ns
from nonsmooth.derive import Condition, Harmonic, RigidStop, oscillator

ITINERARY = [("free", "wall-reaches-stop")]


def test_an_orbit_follows_whichever_of_two_equal_transitions_applies() -> None:
    r = sp.Symbol("r")
    system = oscillator(
        "one-stop",
        ["x"],
        mass=[[1]],
        stiffness=[[1]],
        forcing=[Harmonic("12/5", cosine=[1])],
        elements=[RigidStop("x", at=0, restitution=r, name="wall")],
    )
    impact = next(t for t in system.transitions if t.reset)
    beyond = Condition(system.states[1] - 1000, "free")
    never = replace(impact, conditions=(*impact.conditions, beyond))
    doubled = replace(system, name="one-stop-twice", transitions=(never, *system.transitions))
    for each in (system, doubled):
        orbit = ns.solve(each, {"r": 0.8}, [2.618], itinerary=ITINERARY)
        assert orbit.converged
        assert orbit.admissibility.verdict is True

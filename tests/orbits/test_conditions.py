"""Transitions that lead to the same state on different conditions are the same motion."""

from dataclasses import replace

import sympy as sp

import nonsmooth as ns
from nonsmooth.derive import Condition, RigidStop
from tests.one_mass import one_mass

ITINERARY = [("free", "wall-reaches-stop")]


def test_an_orbit_follows_whichever_of_two_equal_transitions_applies():
    r = sp.Symbol("r")
    wall = RigidStop("x", at=0, restitution=r, name="wall")
    system = one_mass("one-stop", wall, forces={"12/5": 1})
    impact = next(t for t in system.transitions if t.reset)
    beyond = Condition(system.states[1] - 1000, "free")
    never = replace(impact, conditions=(*impact.conditions, beyond))
    doubled = replace(system, name="one-stop-twice", transitions=(never, *system.transitions))
    for each in (system, doubled):
        orbit = ns.solve(each, {"r": 0.8}, [2.618], itinerary=ITINERARY)
        assert orbit.converged
        assert orbit.admissibility.verdict is True

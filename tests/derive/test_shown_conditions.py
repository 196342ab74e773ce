"""Which orbits have transitions whose conditions their phases show."""

import re

import sympy as sp

from nonsmooth.derive import Friction, Harmonic, Itinerary, Reference, RigidStop, oscillator
from nonsmooth.derive.codegen.derived import derive_system

S, E, W = sp.symbols("S E W", positive=True)
REFERENCE = Reference({"S": "0.3", "E": "0.1", "W": "0.5"}, {"down": "6.2832", "up": "6.2832"})
REVERSALS = [("slip", "ground-reaches-belt", "down"), ("overshoot", "ground-reaches-belt", "up")]


def unshown(orbit):
    """The boundary behind which the phases do not show where it leads: it has no kernels."""
    reasons = [other.reason for other in derive_system(orbit.system, [orbit]).underived]
    return [re.match("behind '(.*)' conditions decide", reason)[1] for reason in reasons]


def rubbed(kinetic, static):
    """A forced mass that reverses on ground and goes on at once."""
    ground, forcing = Friction("x", kinetic, static, 0, name="ground"), Harmonic(W, cosine=[1])
    system = oscillator("rubbed", ["x"], [[1]], [[1]], forcing=[forcing], elements=[ground])
    return Itinerary("reversing", system, REVERSALS, reference=REFERENCE)


def test_a_reversal_shows_that_kinetic_friction_is_overcome_and_not_static():
    same = rubbed(S + E, S + E)
    assert unshown(same) == []
    more = rubbed(S, S + E)
    assert unshown(more) == ["ground-reaches-belt"]


def test_an_impact_is_faster_than_rest():
    stop = RigidStop("x", at=1, restitution=S, name="stop")
    system = oscillator("struck", ["x"], [[1]], [[1]], elements=[stop])
    orbit = Itinerary("one", system, [("free", "stop-reaches-stop", "T")])
    assert unshown(orbit) == []
    resting = [("free", "stop-reaches-stop", "T"), ("contact", "stop-leaves-stop", "rest")]
    sticking = Itinerary("resting", system, resting)
    assert unshown(sticking) == ["stop-reaches-stop"]

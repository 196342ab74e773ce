"""Which orbits have transitions whose conditions their phases show."""

import pytest

from nonsmooth.derive import Friction, Harmonic, Itinerary, Parameter, RigidStop, oscillator
from nonsmooth.derive.equations.shown_conditions import transition_unshown
from nonsmooth.derive.systems import dry_friction, elastic_stop, rigid_stop

S, E = (Parameter(name, "a limit of friction", lower=0) for name in ("S", "E"))
W = Parameter("W", "frequency of the forcing")
REVERSALS = [("slip", "ground-reaches-belt", "down"), ("overshoot", "ground-reaches-belt", "up")]
BUILT_IN = [*dry_friction.orbits, *rigid_stop.orbits, *elastic_stop.orbits]


def rubbed(kinetic, static):
    """A forced mass that reverses on ground and goes on at once."""
    system = oscillator(
        "rubbed",
        ["x"],
        mass=[[1]],
        stiffness=[[1]],
        forcing=[Harmonic(W.symbol, cosine=[1])],
        elements=[Friction("x", kinetic, static, 0, name="ground")],
        parameters=[S, E, W],
    )
    return Itinerary("reversing", system, REVERSALS)


@pytest.mark.parametrize("orbit", BUILT_IN, ids=lambda orbit: orbit.name)
def test_those_that_are_built_in_show_them(orbit):
    assert transition_unshown(orbit) is None


def test_a_reversal_shows_that_kinetic_friction_is_overcome_and_not_static():
    same = rubbed(S.symbol, S.symbol)
    assert transition_unshown(same) is None
    more = rubbed(S.symbol, S.symbol + E.symbol)
    assert transition_unshown(more) == "ground-reaches-belt"


def test_an_impact_is_faster_than_rest():
    system = oscillator(
        "struck",
        ["x"],
        mass=[[1]],
        stiffness=[[1]],
        elements=[RigidStop("x", at=1, restitution=S.symbol, name="stop")],
        parameters=[S],
    )
    orbit = Itinerary("one", system, [("free", "stop-reaches-stop", "T")])
    assert transition_unshown(orbit) is None
    resting = [("free", "stop-reaches-stop", "T"), ("contact", "stop-leaves-stop", "rest")]
    sticking = Itinerary("resting", system, resting)
    assert transition_unshown(sticking) == "stop-reaches-stop"

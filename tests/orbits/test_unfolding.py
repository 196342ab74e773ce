"""Orbits declared by a part and a symmetry, and itineraries taken from motions."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
import sympy as sp
from numpy.testing import assert_allclose

import nonsmooth as ns
from nonsmooth import InputError
from nonsmooth.derive import (
    DeclarationError,
    Harmonic,
    Itinerary,
    Reference,
    RigidStop,
    dry_friction,
    oscillator,
)
from nonsmooth.derive.declaration.symmetry import unfolded
from nonsmooth.derive.document.describe import describe_orbit
from nonsmooth.derive.document.hypertext import to_markdown
from nonsmooth.runtime.model.kernels import load_orbit
from tests.one_mass import one_mass
from tests.two_masses import STICKING, SYSTEMS

HALF_PHASE = (("free-free", "right-reaches-stop"),)
HALF = [(*HALF_PHASE[0], "T")]
DATA = Reference({"r": "0.7"}, {"T": "2.6"})


@cache
def between(place=1):
    """A damped, forced mass between a stop at 1 and one at -1 or elsewhere."""
    r = sp.Symbol("r", nonnegative=True)
    stops = [RigidStop("x", 1, r, name="right"), RigidStop("x", -place, r, "lower", name="left")]
    forces = {sp.Rational(6, 5): 1}
    return one_mass("between", *stops, forces=forces, damping=sp.Rational(1, 10))


def symmetric(system, **changes):
    half = {s: -s for s in system.states}
    return replace(Itinerary("half", system, HALF, symmetry=half, reference=DATA), **changes)


def test_a_symmetry_of_order_four():
    """Two equal masses on springs of their own, turned into each other by quarters."""
    stops = [
        RigidStop(x, place, 1, side, name=f"{x}-{side}")
        for x in ("x1", "x2")
        for place, side in ((1, "upper"), (-1, "lower"))
    ]
    forces = [
        Harmonic(sp.Rational(6, 5), cosine=[1, 0], sine=[0, 1]),
    ]
    system = oscillator("quarters", ["x1", "x2"], [[1, 0], [0, 1]], [[1, 0], [0, 1]],
                        forcing=forces, elements=stops)  # fmt: skip
    x1, x2, v1, v2, c, s = system.states
    quarter = {x1: x2, x2: -x1, v1: v2, v2: -v1, c: s, s: -c}
    phases = [("free-free-free-free", "x1-upper-reaches-stop", "T")]
    whole = unfolded(Itinerary("quarter", system, phases, symmetry=quarter))
    assert [p.boundary[:8] for p in whole.phases] in (
        ["x1-upper", "x2-lower", "x1-lower", "x2-upper"],
        ["x1-upper", "x2-upper", "x1-lower", "x2-lower"],
    )


def test_it_is_solved_by_its_name_and_agrees_with_the_motion():
    kernels = load_orbit(symmetric(between()))
    orbit = ns.solve(kernels.name)
    assert list(orbit.unknowns)[:2] == ["T", "T_2"]
    assert orbit.itinerary == (*HALF_PHASE, ("free-free", "left-reaches-stop"))
    turn = 2 * np.pi / 1.2
    assert orbit.period == pytest.approx(turn, rel=1e-13)
    motion = ns.simulate(between(), {"r": "0.7"}, orbit.states[0], until=float(3 * turn))
    assert_allclose(motion(0.5 + 2 * turn), motion(0.5), atol=1e-9)
    half = ns.solve(kernels.name, {"r": "0.72"}).states
    assert_allclose(half[1], -half[0], atol=1e-12)


def test_its_document_has_all_phases():
    text = to_markdown(describe_orbit(symmetric(between())))
    assert "right-reaches-stop" in text
    assert "left-reaches-stop" in text
    assert "T_{2}" in text


def test_what_is_no_symmetry():
    with pytest.raises(DeclarationError, match="maps configuration 'free-free'"):
        unfolded(symmetric(between(2)))
    x = between().states[0]
    with pytest.raises(DeclarationError, match=r"maps x to 2\*x, which is no state"):
        symmetric(between(), symmetry={x: 2 * x})
    with pytest.raises(DeclarationError, match="symmetry of 'y', which is not declared"):
        symmetric(between(), symmetry={sp.Symbol("y"): x})
    with pytest.raises(InputError, match="symmetry"):
        ns.solve(load_orbit(symmetric(between(2))).name)


@pytest.mark.slow
def test_an_itinerary_from_a_motion_of_a_built_in_system():
    motion = ns.simulate("dry-friction", STICKING, [0, 0, 0, 0], transitions=400)
    found = Itinerary.from_trajectory(motion, dry_friction.system, "again")
    assert found.reference.parameters == {name: str(value) for name, value in STICKING.items()}
    orbit = ns.solve(load_orbit(found).name)
    assert [p.dwell_time for p in found.phases] == ["tau1", "tau2", "tau3", "tau4"]
    assert orbit.converged
    assert orbit.period == pytest.approx(7.8686, abs=1e-4)


def test_a_motion_that_does_not_come_back():
    motion = ns.simulate("rigid-stop", SYSTEMS["rigid-stop"], [0, 0, 2, 1], until=9)
    with pytest.raises(InputError, match="does not come back"):
        Itinerary.from_trajectory(motion, dry_friction.system)


def test_many_points_are_none_of_a_part():
    with pytest.raises(InputError, match="a part and a symmetry"):
        ns.solve(load_orbit(symmetric(between())).name, {"r": [0.6, 0.7]})

"""A motion does not depend on the order in which boundaries are declared, to the last bit."""

from __future__ import annotations

import random

import numpy as np
import pytest
import sympy as sp

import nonsmooth as ns
from nonsmooth.derive import Harmonic, RigidStop, System, oscillator

START = {"x": 0, "v": "0.3", "c1": 1, "s1": 0}


def struck(seed: int, *, far_first: bool) -> System:
    """A forced mass, its stop at no binary fraction, and another one that it never reaches."""
    draw = random.Random(seed)
    place, restitution = (
        sp.Rational(draw.randint(1, 99), 97),
        sp.Rational(draw.randint(50, 99), 100),
    )
    near = RigidStop("x", place, restitution, name="near")
    far = RigidStop("x", -1000, 1, side="lower", name="far")
    return oscillator(
        "struck",
        ["x"],
        [[1]],
        [[sp.Rational(draw.randint(1, 30), 10)]],
        [[sp.Rational(draw.randint(0, 20), 100)]],
        forcing=[Harmonic(sp.Rational(draw.randint(50, 300), 100), cosine=[3])],
        elements=[far, near] if far_first else [near, far],
    )


@pytest.mark.parametrize("seed", range(6))
def test_a_boundary_that_begins_a_flight_is_known_wherever_it_is_listed(seed: int) -> None:
    first, second = (
        ns.simulate(struck(seed, far_first=order), {}, START, transitions=300)
        for order in (False, True)
    )
    assert first.status == second.status
    np.testing.assert_array_equal(first.times, second.times)
    np.testing.assert_array_equal(first.states, second.states)

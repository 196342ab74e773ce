"""Equilibria: what is zero is zero."""

import numpy as np
import pytest
import sympy as sp

from nonsmooth import find_orbits
from nonsmooth.derive import SoftStop, oscillator


@pytest.mark.parametrize("seed", [2, 3])
def test_a_state_that_vanishes_is_zero(seed):
    """Where others are not, in coupled coordinates; velocities always."""
    random = np.random.default_rng(seed)
    factor = sp.Matrix(3, 3, lambda *_: sp.Rational(int(random.integers(-9, 10)), 7))
    stiffness = factor * factor.T + sp.eye(3)
    place = sp.Matrix([0, sp.Rational(int(random.integers(1, 6)), 7), 0])
    system = oscillator(
        "held",
        ["x1", "x2", "x3"],
        sp.eye(3).tolist(),
        stiffness.tolist(),
        (sp.eye(3) / 10).tolist(),
        load=list(stiffness * place),
        elements=[SoftStop("x1", at=100, stiffness=1, name="far")],
    )
    (entry,) = find_orbits(system, {}, 1, transitions=20, rng=1).equilibria
    found = entry.equilibrium
    assert found.state[[0, 2, 3, 4, 5]].tolist() == [0.0] * 5
    assert not np.signbit(found.state).any()
    assert found.state[1] == pytest.approx(float(place[1]), rel=1e-14)

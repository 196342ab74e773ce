"""Derivatives of motions of many states, and of configurations that are made when visited."""

from dataclasses import replace

import numpy as np
import pytest
import sympy as sp
from numpy.testing import assert_allclose

import nonsmooth as ns
from nonsmooth.derive import Friction, Harmonic, Parameter, RigidStop, oscillator
from tests.moved_motions import compared_with_digits

DATA = {"k": 2.0, "F": 1.0, "w": 1.1, "gap": 0.05, "r": 0.8}


def springs(count):
    """Their stiffness, between walls."""
    return sp.Matrix(count, count, lambda i, j: 2 * (i == j) - (abs(i - j) == 1))


def chain(count):
    """Masses in a chain between walls; the first one is forced, and strikes a stop."""
    found = [Parameter(name, name) for name in DATA]
    k, force, w, gap, r = (parameter.symbol for parameter in found)
    stiffness = springs(count)
    damping = sp.Rational(1, 50) * (stiffness + sp.eye(count))
    stiffness[0, 0] = 1 + k
    return oscillator(
        f"long-{count}",
        [f"x{i}" for i in range(1, count + 1)],
        sp.eye(count),
        stiffness,
        damping=damping,
        forcing=[Harmonic(w, cosine={"x1": force})],
        elements=[RigidStop("x1", gap, r, name="stop")],
        parameters=found,
    )


def rubbing(count):
    """Masses in a chain, each on a belt: 3^count configurations, made when they are visited."""
    found = [Parameter(name, name) for name in ("V", "mu")]
    belt, force = (parameter.symbol for parameter in found)
    names = [f"x{i}" for i in range(1, count + 1)]
    rubs = [
        Friction(name, force, force * sp.Rational(12 + i, 10), velocity=belt, name=f"belt{i}")
        for i, name in enumerate(names)
    ]
    masses = sp.diag(*[sp.Rational(10 + i, 10) for i in range(count)])
    system = oscillator(
        f"rubbing-{count}", names, masses, springs(count), elements=rubs, parameters=found
    )
    return system, {"V": 0.5, "mu": 0.25}


@pytest.mark.slow
@pytest.mark.parametrize("count", [9, 19])  # 20 and 40 states: modes as eigenvectors
def test_chains_agree_with_fifty_digits(count):
    system = chain(count)
    start = {name: 0.0 for name in (f"{a}{i}" for a in "xv" for i in range(1, count + 1))}
    motion = ns.simulate(system, DATA, start, transitions=6)
    assert hasattr(motion.system.flows[0], "left")
    assert compared_with_digits(system, motion, np.random.default_rng(count), 2) < 1e-12


def test_factors_and_matrices_have_the_same_derivatives():
    motion = ns.simulate(chain(9), DATA, [0.0] * 18 + [1.0, 0.0], transitions=8)
    flows = tuple(flows.all() for flows in motion.system.flows)
    dense = replace(motion, system=replace(motion.system, flows=flows))
    one, other = (each.derivatives(times=[0.5, motion.end / 2]) for each in (motion, dense))
    for name in ("states", "event_times", "before", "behind"):
        assert_allclose(getattr(one, name), getattr(other, name), atol=1e-10)
    factors = np.random.default_rng(1).normal(size=one.states.shape[:2])
    found, expected = one.vjp(states=factors), other.vjp(states=factors)
    assert_allclose(found, expected, atol=1e-10)
    assert_allclose(found, np.tensordot(factors, one.states, 2), atol=1e-10)


@pytest.mark.usefixtures("backend")
def test_motions_at_many_points_are_those_at_each():
    system, start = chain(9), [0.0] * 18 + [1.0, 0.0]
    stiffness = np.array([2.0, 2.5, 3.0])
    many = ns.simulate(system, DATA | {"k": stiffness}, start, transitions=4)
    for k, time, state in zip(stiffness, many.times, many.states, strict=True):
        one = ns.simulate(system, DATA | {"k": k}, start, transitions=4)
        assert hasattr(one.system.flows[0], "left")
        assert time == pytest.approx(one.end, rel=1e-12)
        assert_allclose(state, one.states[-1], atol=1e-11)


@pytest.mark.slow
def test_configurations_that_are_made_when_visited_have_derivatives():
    system, data = rubbing(8)
    start = [*np.linspace(-0.6, 0.7, 8).tolist(), *np.linspace(0.1, 0.45, 8).tolist()]
    motion = ns.simulate(system, data, start, transitions=12)
    assert motion.structure.unvisited
    assert len(set(motion.configurations)) > 4
    assert compared_with_digits(system, motion, np.random.default_rng(3), 2) < 1e-12

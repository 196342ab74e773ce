"""Oscillators from elements: the built-in systems again, impact and contact laws, bad input."""

import numpy as np
import pytest
import sympy as sp
from scipy.optimize import lsq_linear

from nonsmooth.derive import (
    FirstOrder,
    Friction,
    Harmonic,
    Parameter,
    RigidStop,
    SecondOrder,
    Slider,
    SoftStop,
    chain_matrices,
    dry_friction,
    oscillator,
)
from nonsmooth.runtime.events.transition_choice import Decider
from nonsmooth.runtime.model.piecewise import piecewise
from tests.declared import elastic_stop, rigid_stop
from tests.one_mass import one_mass

chi, eta, V, us1, ur1, us2, ur2, r = sp.symbols("chi eta V us1 ur1 us2 ur2 r")
m1, m2, k1, k2, k3 = sp.symbols("m1 m2 k1 k2 k3")
FULL = np.array([[2.0, 0.5, 0.1], [0.5, 1.0, -0.2], [0.1, -0.2, 1.5]])
SPRINGS = np.array([[2.0, -1, 0], [-1, 2, -1], [0, -1, 1]])


def belt():
    return oscillator(
        "dry-friction",
        ["x1", "x2"],
        sp.diag(1, 1 / eta),
        [[1, -chi], [-chi, chi]],
        elements=[
            Friction("x1", us1, ur1, V, name="first"),
            Friction("x2", us2, ur2, V, name="second"),
        ],
        parameters=dry_friction.system.parameters,
    )  # fmt: skip


def chain_with(*elements):
    mass, stiffness, _ = chain_matrices([m1, m2], [k1, k2], fixed="right")
    return oscillator("chain", ["x1", "x2"], mass, stiffness, elements=elements)


BUILT_IN = {
    "dry-friction": (belt, dry_friction.system),
    "rigid-stop": (lambda: chain_with(RigidStop("x1", 1, r, name="first")), rigid_stop.system),
    "elastic-stop": (lambda: chain_with(SoftStop("x1", 1, k3, name="first")), elastic_stop.system),
}


def rules(transition):
    conditions = tuple((sp.expand(c.function), c.along, c.holds) for c in transition.conditions)
    return (
        transition.source, transition.boundaries, transition.target, conditions, transition.reset
    )  # fmt: skip


@pytest.mark.parametrize("name", BUILT_IN)
def test_the_built_in_systems_are_built_again(name):
    build, given = BUILT_IN[name]
    built = build()
    assert {c.name for c in built.configurations} == {c.name for c in given.configurations}
    for source in (c.name for c in given.configurations):
        assert [rules(t) for t in built.transitions if t.source == source] == [
            rules(t) for t in given.transitions if t.source == source
        ]
        one, other = built.configuration(source), given.configuration(source)
        assert [(b.name, sp.expand(b.function), b.acts_when) for b in one.boundaries] == [
            (b.name, sp.expand(b.function), b.acts_when) for b in other.boundaries
        ]
        assert one.constraints == other.constraints
        for mine, theirs in zip(
            one.dynamics.field(built.states), other.dynamics.field(given.states), strict=True
        ):
            assert (mine - theirs).applyfunc(sp.cancel).is_zero_matrix
        for mine, theirs in zip(built.contacts, given.contacts, strict=True):
            forces = [sp.expand(c.forces.get(source, 0)) for c in (mine, theirs)]
            assert forces[0] == forces[1]
            assert (mine.velocity, mine.surface) == (theirs.velocity, theirs.surface)
    assert built.constraints == given.constraints
    domains = {p.name: (p.lower, p.upper, p.closed, p.upper_closed) for p in built.parameters}
    assert domains == {
        p.name: (p.lower, p.upper, p.closed, p.upper_closed) for p in given.parameters
    }


def after(system, transition, velocities):
    size = len(velocities)
    state = sp.Matrix([0] * size + [sp.Rational(str(v)) for v in velocities])
    found = transition.reset_of(state, system.states)
    return np.array([float(value) for value in found[size:]])


def struck(velocities, row, restitution):
    """Velocities behind an impact along a row, whose impulse acts along it too."""
    inverse = np.linalg.inv(FULL[: len(row), : len(row)])
    impulse = (1 + restitution) * (row @ velocities) / (row @ inverse @ row)
    return velocities - impulse * (inverse @ row)


@pytest.mark.parametrize("direction", ["x2", {"x1": -1, "x3": 1}])
@pytest.mark.parametrize("side", ["upper", "lower"])
def test_an_impact_obeys_newton_along_the_inverse_mass(direction, side):
    stop = RigidStop(direction, at=1, restitution=0.6, side=side)
    system = oscillator("full", ["x1", "x2", "x3"], FULL, SPRINGS, elements=[stop])
    row = np.array([0, 1.0, 0] if direction == "x2" else [-1.0, 0, 1])
    impact = next(t for t in system.transitions if t.source == t.target == "free")
    velocities = np.round(np.random.default_rng(3).normal(size=3), 6)
    velocities *= np.sign(row @ velocities) * (1 if side == "upper" else -1)
    wanted = struck(velocities, row, 0.6)
    assert np.allclose(after(system, impact, velocities), wanted, atol=1e-14)


def test_two_stops_at_one_instant_act_one_after_another():
    stops = [RigidStop("x1", 1, 0.5), RigidStop("x2", 1, 0.5)]
    system = oscillator("two", ["x1", "x2"], FULL[:2, :2], SPRINGS[:2, :2], elements=stops)
    both = {"x1-upper-reaches-stop", "x2-upper-reaches-stop"}
    impact = next(t for t in system.transitions if t.source == "free-free" and t.boundaries == both)
    velocities = np.array([0.25, 2.0])
    wanted = struck(struck(velocities, np.array([1, 0]), 0.5), np.array([0, 1]), 0.5)
    assert np.allclose(after(system, impact, velocities), wanted, atol=1e-14)


def test_stops_that_a_closed_one_couples_are_struck_in_both_orders():
    names = ["x1", "x2", "x3"]
    mass = sp.Matrix([[2, 1, 0], [1, 2, 1], [0, 1, 2]]).inv()
    stops = [RigidStop(name, 1, 0.5) for name in names]
    system = oscillator("row", names, mass, sp.eye(3), elements=stops)
    ends = {"x1-upper-reaches-stop", "x3-upper-reaches-stop"}
    for source, orders in (("free-free-free", set()), ("free-contact-free", {1, 2})):
        found = [t for t in system.transitions if (t.source, t.boundaries) == (source, ends)]
        assert {t.order for t in found} - {0} == orders


def decided(system, source, boundaries, state):
    """The configuration that follows by the contact law of a system without parameters."""
    point = piecewise(system, {})
    structure = point.structure
    decider = Decider(structure, point.fields, point.rows, point.resets)
    place, known = structure.configuration(source), np.append(state, 1.0)
    reached = frozenset(structure.boundary(place, name) for name in boundaries)
    found = decider.choice(place, reached, decider.located(place, known, 0.0)).transition
    return structure.configurations[found.target]


@pytest.mark.slow
def test_a_contact_and_a_stop_that_are_coupled_are_decided_together():
    elements = [Friction("x1", 0.4), RigidStop("x2", at=0.25, restitution=0.5)]
    names = ["x1", "x2", "x3"]
    system = oscillator("three", names, FULL, SPRINGS, elements=elements)
    root = np.linalg.inv(np.linalg.cholesky(FULL))
    rng, seen = np.random.default_rng(12), set()
    for _ in range(60):
        positions = np.array([rng.normal(), 0.25, rng.normal()])
        forces = -SPRINGS @ positions
        bounds = ([-0.4, -np.inf], [0.4, 0])
        held = lsq_linear(root[:, :2], -root @ forces, bounds, tol=1e-14).x
        friction = "slip" if held[0] > 0.4 - 1e-6 else "overshoot"
        friction = "stick" if abs(held[0]) < 0.4 - 1e-6 else friction
        expected = f"{friction}-{'contact' if held[1] < -1e-6 else 'free'}"
        reached = {"x1-reaches-belt", "x2-upper-reaches-stop"}
        state = np.array([*positions, 0, 0, 0])
        assert decided(system, "slip-free", reached, state) == expected
        seen.add(expected)
    assert len(seen) == 6


def field_of(system, name, values):
    configuration = system.configuration(name)
    matrix, offset = configuration.dynamics.field(system.states)
    rates = matrix * sp.Matrix(system.states) + offset
    by_name = {p.name: p.symbol for p in system.parameters}
    numbers = {by_name[n]: v for n, v in values.items()}
    return {str(s): sp.expand(e.subs(numbers)) for s, e in zip(system.states, rates, strict=True)}


def test_friction_may_fall_and_its_load_may_follow_the_state():
    y, mu, slope = sp.symbols("y mu slope")
    system = oscillator(
        "brake", ["x1", "y"], sp.eye(2), sp.eye(2),
        elements=[Friction("x1", mu, 2 * mu, V, falling=slope, normal=3 - y)],
    )  # fmt: skip
    x1, y, v1, _ = system.states
    values = {"mu": sp.Rational(1, 4), "slope": sp.Rational(1, 8), "V": 1}
    load = sp.Rational(1, 4) * (3 - y)
    for name, sign in (("slip", 1), ("overshoot", -1)):
        expected = -x1 + sign * load + sp.Rational(1, 8) * (v1 - 1)
        assert sp.expand(field_of(system, name, values)["v1"] - expected) == 0
        assert isinstance(system.configuration(name).dynamics, SecondOrder)
    forward = system.configuration("stick").boundary("x1-breaks-forward").function
    assert sp.expand(forward.subs({p.symbol: values[p.name] for p in system.parameters})) == (
        sp.expand(x1 - 2 * load)
    )


def test_forcing_adds_two_states_each_and_sliders_one():
    w = sp.Symbol("w")
    system = oscillator(
        "forced", ["x1", "x2"], sp.diag(1, 2), sp.eye(2), sp.eye(2) / 10,
        forcing=[Harmonic(w, {"x2": 3}), Harmonic(2, sine=(1, 0))],
        elements=[Slider({"x2": 1, "x1": -1}, stiffness=4, limit=1, name="joint")],
    )  # fmt: skip
    assert system.description == "oscillator with 2 coordinates"
    assert " ".join(map(str, system.states)) == "x1 x2 v1 v2 c1 s1 c2 s2 s_joint"
    assert [(str(c), str(s)) for c, s in system.forcing] == [("c1", "s1"), ("c2", "s2")]
    x1, x2, v1, v2, c1, s1, _, s2, joint = system.states
    rates = field_of(system, "stuck", {"w": 5})
    assert (rates["c1"], rates["s1"]) == (-5 * s1, 5 * c1)
    assert sp.expand(rates["v1"] - (-x1 - v1 / 10 + s2 + 4 * (x2 - x1 - joint))) == 0
    assert sp.expand(rates["v2"] - (-x2 - v2 / 10 + 3 * c1 - 4 * (x2 - x1 - joint)) / 2) == 0
    assert rates["s_joint"] == 0
    assert field_of(system, "backward", {})["s_joint"] == v2 - v1
    assert all(isinstance(c.dynamics, FirstOrder) for c in system.configurations)


@pytest.mark.parametrize(("fixed", "links"), [("left", 3), ("right", 3), ("both", 4), ("none", 2)])
def test_a_chain_stores_the_energy_of_its_springs(fixed, links):
    rng = np.random.default_rng(links)
    springs, positions = rng.integers(1, 9, links), rng.integers(-4, 5, 3)
    ends = [*([0] * (fixed in ("left", "both"))), *positions, *([0] * (fixed in ("right", "both")))]
    mass, stiffness, damping = chain_matrices([1, 2, 3], list(map(int, springs)), fixed=fixed)
    stored = (sp.Matrix([list(map(int, positions))]) * stiffness * sp.Matrix(positions))[0]
    assert stored == sum(springs * np.diff(ends) ** 2)
    assert mass == sp.diag(1, 2, 3)
    assert damping.is_zero_matrix


@pytest.mark.parametrize("damping", [0, sp.Rational(1, 5)])
def test_the_force_of_a_stop_without_a_damper_vanishes_as_the_gap_opens(damping):
    """A phase between the two would take no time."""
    stop = SoftStop("x", 1, 10, damping, released="force")
    system = one_mass("clearance", stop)
    regimes = {"free", "contact", "released"} if damping else {"free", "contact"}
    assert {configuration.name for configuration in system.configurations} == regimes


def test_domains_are_inferred():
    load, drag = sp.Symbol("load", real=True), sp.Symbol("drag", nonnegative=True)
    system = one_mass(
        "domains", RigidStop("x", 1, r), mass=m1, stiffness=k1, damping=drag, load=[load],
        parameters=[Parameter("k1", "stiffness", upper=2)],
    )  # fmt: skip
    assert system.description == "oscillator with 1 coordinate"
    domains = {p.name: (p.lower, p.upper, p.closed, p.upper_closed) for p in system.parameters}
    assert domains == {
        "k1": (0, 2, False, False),
        "m1": (0, sp.oo, False, False),
        "drag": (0, sp.oo, True, False),
        "load": (-sp.oo, sp.oo, False, False),
        "r": (0, 1, True, True),
    }

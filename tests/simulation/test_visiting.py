"""Systems whose configurations are made when they are first visited: the same motions."""

import pickle
from functools import cache

import numpy as np
import pytest
import sympy as sp
from numpy.testing import assert_allclose, assert_array_equal

import nonsmooth as ns
from nonsmooth import InputError
from nonsmooth.derive import (
    DeclarationError,
    Friction,
    Harmonic,
    Itinerary,
    RigidStop,
    Slider,
    SoftStop,
    chain_matrices,
    oscillator,
)
from nonsmooth.derive.building import growing
from nonsmooth.derive.document.describe import describe_system


def rubbing():
    """Three masses in a row on three belts."""
    rng = np.random.default_rng(0)
    mass, stiffness, damping = chain_matrices(
        rng.integers(1, 5, 3).tolist(), rng.integers(1, 9, 3).tolist(), [0, 0, 0]
    )
    kinetic = rng.integers(1, 9, 3)
    static = kinetic + rng.integers(0, 9, 3)
    elements = [
        Friction(f"x{k + 1}", int(a), int(b), velocity=speed, name=f"f{k + 1}")
        for k, (a, b, speed) in enumerate(zip(kinetic, static, ("1", "1/2", "-1"), strict=True))
    ]
    return oscillator("rubbing", ["x1", "x2", "x3"], mass, stiffness, damping, elements=elements)


def striking():
    """Three masses in a row, each between its neighbours and a stop; the first is shaken."""
    rng = np.random.default_rng(0)
    mass, stiffness, damping = chain_matrices(
        rng.integers(1, 5, 3).tolist(), rng.integers(1, 9, 3).tolist(), ["0.1", "0.1", "0.1"]
    )
    elements = [
        RigidStop("x1", at=1, restitution="0.6", name="s1"),
        RigidStop("x2", at="-0.5", restitution="0.5", side="lower", name="s2"),
        SoftStop("x3", at="0.7", stiffness=40, damping=1, name="s3"),
    ]
    return oscillator(
        "striking", ["x1", "x2", "x3"], mass, stiffness, damping, elements=elements,
        forcing=[Harmonic("1.3", [int(rng.integers(4, 9)), 0, 0])],
    )  # fmt: skip


def mixed():
    """A slider, and a contact that lifts."""
    rng = np.random.default_rng(0)
    mass, stiffness, _ = chain_matrices([1, 2, 3], rng.integers(1, 9, 3).tolist())
    elements = [
        Slider("x2", stiffness=20, limit=1, name="slider"),
        Friction("x1", "0.2", "0.3", velocity="0.4", normal=2 + sp.Symbol("x3"), name="pad"),
    ]
    return oscillator(
        "mixed", ["x1", "x2", "x3"], mass, stiffness, elements=elements,
        forcing=[Harmonic(2, [0, 3, 0])],
    )  # fmt: skip


def alike():
    """Three equal masses, each with a stop."""
    elements = [RigidStop(x, at=1, restitution="0.5", name=f"s{x}") for x in ("x1", "x2", "x3")]
    return oscillator("alike", ["x1", "x2", "x3"], *([np.eye(3)] * 2), elements=elements)


@cache
def listed(make):
    """One for all tests, with what was derived of it."""
    found = make()
    assert not isinstance(found, growing.GrowingSystem)
    return found


def visited(make):
    """The same as a system of its own, in which nothing was visited."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(growing, "_LARGEST", 0)
        found = make()
    assert isinstance(found, growing.GrowingSystem)
    return found


def compared(make, made, state, until):
    """The motion of a listed system, which is that of the visited one."""
    expected, found = (
        ns.simulate(system, {}, state, until=until) for system in (listed(make), made)
    )
    assert found.configurations == expected.configurations
    assert found.boundaries == expected.boundaries
    assert found.status.name == expected.status.name == "UNTIL"
    assert_allclose(found.times, expected.times, rtol=1e-11)
    assert_allclose(found.states, expected.states, rtol=1e-9, atol=1e-10)
    return expected


def named(system, start):
    """A start by names, in which a slider is where its mass is."""
    names = [str(s) for s in system.states]
    state = dict(zip(names, start.tolist(), strict=False))
    return state | ({"s_slider": state["x2"]} if "s_slider" in names else {})


@pytest.mark.slow
@pytest.mark.parametrize("make", [rubbing, striking, mixed])
def test_motions_are_those_of_the_listed_system(make):
    made, rng = visited(make), np.random.default_rng(0)
    starts = [named(made, rng.uniform(-1, 1, 6) * 0.4) for _ in range(3)]
    assert sum(len(compared(make, made, s, 30).boundaries) for s in starts) >= 20


@pytest.mark.slow
@pytest.mark.parametrize(
    ("make", "start"),
    [
        *((rubbing, [2 * scale, -scale, scale, 1, 0.5, -1]) for scale in (0.0, 0.3, 3.0)),
        (striking, [1, -0.5, 0.7, 0, 0, 0]),
        (alike, [0, 0, 0, 4, 4, 4]),
    ],
    ids=["at rest", "sticking", "pulled", "on all stops", "together"],
)
def test_special_starts_belong_where_the_listed_system_puts_them(make, start):
    made, until = visited(make), 20 if make is alike else 5
    expected = compared(make, made, named(made, np.array(start)), until)
    if make is alike:
        assert len(expected.boundaries[1]) == 3
        many = ns.simulate(visited(make), {}, [start, start], until=until)
        assert_allclose(many.states[0], expected(until), atol=1e-11)


@pytest.mark.slow
@pytest.mark.parametrize("make", [striking, rubbing, mixed])
def test_a_start_anywhere_belongs_where_the_listed_system_puts_it(make):
    """Each with a system of its own, in which nothing was visited before."""
    rng, configurations = np.random.default_rng(11), set()
    for number in range(4):
        made = visited(make)
        object.__setattr__(made, "name", f"{made.name}-{number}")
        state = named(made, rng.uniform(-2, 2, 6))
        state["x1"] = -abs(state["x1"])  # the stop of the first mass is rigid
        state["x2"] = abs(state["x2"])
        state |= {"s_slider": state["x2"]} if "s_slider" in state else {}
        configurations.add(compared(make, made, state, 0.5).configurations[0])
    assert len(configurations) > 1


@pytest.mark.slow
def test_many_motions_are_those_of_the_listed_system():
    made, rng = visited(striking), np.random.default_rng(3)
    starts = np.zeros((60, 8))
    starts[:, :6], starts[:, 6] = rng.uniform(-0.45, 0.45, (60, 6)), 1.0
    expected, found = (
        ns.simulate(system, {}, starts, until=20, keep=5, threads=2)
        for system in (listed(striking), made)
    )
    names = [np.array(many.structure.configurations) for many in (expected, found)]
    assert_array_equal(names[0][expected.configurations], names[1][found.configurations])
    assert_array_equal(found.transitions, expected.transitions)
    assert_allclose(found.last_times, expected.last_times, rtol=1e-9)
    # indices of an earlier result stay good where more was visited
    again = ns.simulate(made, {}, found.states, found.configurations, until=1.0, threads=2)
    assert (again.status == expected.status).all()


def belt_of_ten():
    """Ten masses in a row on one belt; the last one rubs most."""
    mass, stiffness, damping = chain_matrices(
        [1, 2, "3/2", 1, 2, 3, "5/4", 1, "7/4", 2], [3, 2, 4, 1, 5, 2, 3, 4, 1, 2], ["0.2"] * 10
    )
    names = [f"x{k}" for k in range(1, 11)]
    kinetic = [sp.Rational(3 + k % 3, 10) for k in range(10)]
    elements = [
        Friction(x, force, force * (5 if x == "x10" else sp.Rational(11, 10)), sp.Rational(3, 10))
        for x, force in zip(names, kinetic, strict=True)
    ]
    return oscillator("belt-of-ten", names, mass, stiffness, damping, elements=elements)


@pytest.mark.slow
def test_ten_contacts_have_an_orbit_that_solves_saves_and_loads(tmp_path):
    system = belt_of_ten()
    assert isinstance(pickle.loads(pickle.dumps(system)), growing.GrowingSystem)
    assert pickle.loads(pickle.dumps(system)) == system
    motion = ns.simulate(system, {}, [0.1 * k for k in range(10)] + [0.0] * 10, until=300)
    assert motion.status.name == "UNTIL"
    cycle = ns.itinerary_of(motion)
    orbit = ns.solve(system, {}, itinerary=cycle)
    assert orbit.converged
    assert (orbit.stability.verdict, orbit.admissibility.verdict) == ("stable", True)
    declared = ns.solve(Itinerary.from_trajectory(motion, system, "cycle"))
    assert_allclose(float(declared.period), float(orbit.period), rtol=1e-12)
    orbit.save(tmp_path / "orbit.json")
    again = ns.load(tmp_path / "orbit.json")
    assert again.period == orbit.period
    assert again.stability.verdict == "stable"


def test_what_needs_all_configurations_says_how_many_there_are():
    system = belt_of_ten()
    for ask in (lambda: system.configurations, lambda: describe_system(system)):
        with pytest.raises(DeclarationError, match="59,049 configurations") as refusal:
            ask()
        assert "\n" not in str(refusal.value)
    with pytest.raises(InputError, match="needs all configurations of belt-of-ten"):
        ns.sweep(system, {}, "V", [0.1], {}, state="x1", configuration="slip")


def test_names_of_configurations_are_regimes_that_go_together():
    system = belt_of_ten()
    name = "-".join(["slip", "stick"] * 5)
    assert system.configuration(name).name == name
    for wrong in ("slip", f"{name}-slip", name.replace("stick", "stack", 1)):
        with pytest.raises(DeclarationError, match="has no configuration"):
            system.configuration(wrong)
    with pytest.raises(DeclarationError, match="no transition leads"):
        system.transition(name, "x1-reaches-belt", name.replace("slip", "stick"))

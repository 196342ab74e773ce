"""Systems whose configurations are made when they are first visited: the same motions."""

import pickle
from functools import cache

import numpy as np
import pytest
import sympy as sp

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
    System,
    chain_matrices,
    oscillator,
)
from nonsmooth.derive.building import growing
from nonsmooth.derive.building.growing import GrowingSystem
from nonsmooth.derive.document.describe import describe_system
from nonsmooth.runtime.model.engine_run import Status


def rubbing(seed: int) -> tuple[System, dict[str, float]]:
    """Three masses in a row on three belts."""
    rng = np.random.default_rng(seed)
    mass, stiffness, damping = chain_matrices(
        rng.integers(1, 5, 3).tolist(), rng.integers(1, 9, 3).tolist(), [0, "0.01", 0]
    )
    kinetic = rng.integers(1, 9, 3)
    static = kinetic + rng.integers(0, 9, 3)
    elements = [
        Friction(f"x{k + 1}", int(a), int(b), velocity=speed, name=f"f{k + 1}")
        for k, (a, b, speed) in enumerate(zip(kinetic, static, ("1", "1/2", "-1"), strict=True))
    ]
    return oscillator(
        f"rubbing-{seed}", ["x1", "x2", "x3"], mass, stiffness, damping, elements=elements
    ), {}


def striking(seed: int) -> tuple[System, dict[str, float]]:
    """Three masses in a row, each between its neighbours and a stop; the first is shaken."""
    rng = np.random.default_rng(seed)
    mass, stiffness, damping = chain_matrices(
        rng.integers(1, 5, 3).tolist(), rng.integers(1, 9, 3).tolist(), ["0.1", "0.1", "0.1"]
    )
    elements = [
        RigidStop("x1", at=1, restitution="0.6", name="s1"),
        RigidStop("x2", at="-0.5", restitution="0.5", side="lower", name="s2"),
        SoftStop("x3", at="0.7", stiffness=40, damping=1, name="s3"),
    ]
    return oscillator(
        f"striking-{seed}", ["x1", "x2", "x3"], mass, stiffness, damping, elements=elements,
        forcing=[Harmonic("1.3", [int(rng.integers(4, 9)), 0, 0])],
    ), {}  # fmt: skip


def mixed(seed: int) -> tuple[System, dict[str, float]]:
    """A slider, and a contact that lifts."""
    rng = np.random.default_rng(seed)
    mass, stiffness, _ = chain_matrices([1, 2, 3], rng.integers(1, 9, 3).tolist())
    elements = [
        Slider("x2", stiffness=20, limit=1, name="slider"),
        Friction("x1", "0.2", "0.3", velocity="0.4", normal=2 + sp.Symbol("x3"), name="pad"),
    ]
    return oscillator(
        f"mixed-{seed}", ["x1", "x2", "x3"], mass, stiffness, elements=elements,
        forcing=[Harmonic(2, [0, 3, 0])],
    ), {}  # fmt: skip


@cache
def listed(make, seed: int) -> tuple[System, dict[str, float]]:
    """One for all tests, with what was derived of it."""
    return make(seed)


@pytest.mark.slow
@pytest.mark.parametrize("make", [rubbing, striking, mixed])
@pytest.mark.parametrize(
    "seed", [0, *(pytest.param(seed, marks=pytest.mark.slow) for seed in (1, 2))]
)
def test_motions_are_those_of_the_listed_system(make, seed, monkeypatch) -> None:
    whole, data = listed(make, seed)
    monkeypatch.setattr(growing, "_LARGEST", 0)
    made, _ = make(seed)
    assert isinstance(made, GrowingSystem)
    assert not isinstance(whole, GrowingSystem)
    rng = np.random.default_rng(seed)
    transitions = 0
    for _ in range(3):
        start = rng.uniform(-1, 1, 6) * 0.4
        names = [str(s) for s in whole.states]
        state = dict(zip(names, start.tolist(), strict=False))
        state |= {"s_slider": state["x2"]} if "s_slider" in names else {}
        expected = ns.simulate(whole, data, state, until=30)
        found = ns.simulate(made, data, state, until=30)
        transitions += len(expected.boundaries)
        assert found.configurations == expected.configurations
        assert found.boundaries == expected.boundaries
        assert found.status == expected.status == Status.UNTIL
        np.testing.assert_allclose(found.times, expected.times, rtol=1e-11)
        np.testing.assert_allclose(found.states, expected.states, rtol=1e-9, atol=1e-10)
    assert transitions >= 20


def test_starts_at_rest_belong_where_the_listed_system_puts_them(monkeypatch) -> None:
    whole, data = listed(rubbing, 0)
    monkeypatch.setattr(growing, "_LARGEST", 0)
    made, _ = rubbing(0)
    for scale in (0.0, 0.3, 3.0):
        state = {"x1": 2 * scale, "x2": -scale, "x3": scale, "v1": 1, "v2": 0.5, "v3": -1}
        expected = ns.simulate(whole, data, state, until=5)
        found = ns.simulate(made, data, state, until=5)
        assert found.configurations == expected.configurations
        np.testing.assert_allclose(found.times, expected.times, rtol=1e-11)


def test_starts_on_all_stops_belong_where_the_listed_system_puts_them(monkeypatch) -> None:
    whole, data = listed(striking, 0)
    monkeypatch.setattr(growing, "_LARGEST", 0)
    made, _ = striking(0)
    state = {"x1": 1, "x2": -0.5, "x3": 0.7, "v1": 0, "v2": 0, "v3": 0}
    expected = ns.simulate(whole, data, state, until=5)
    found = ns.simulate(made, data, state, until=5)
    assert found.configurations == expected.configurations
    np.testing.assert_allclose(found.times, expected.times, rtol=1e-11)


@pytest.mark.parametrize("make", [rubbing, striking, mixed])
def test_a_start_anywhere_belongs_where_the_listed_system_puts_it(make, monkeypatch) -> None:
    """Each with a system of its own, in which nothing was visited before."""
    whole, data = listed(make, 0)
    monkeypatch.setattr(growing, "_LARGEST", 0)
    rng = np.random.default_rng(11)
    names = [str(s) for s in whole.states]
    visited = set()
    for number in range(4):
        state = dict(zip(names, rng.uniform(-2, 2, 6).tolist(), strict=False))
        state["x1"] = -abs(state["x1"])  # the stop of the first mass is rigid
        state["x2"] = abs(state["x2"])
        state |= {"s_slider": state["x2"]} if "s_slider" in names else {}
        expected = ns.simulate(whole, data, state, until=0.5)
        made = make(0)[0]
        object.__setattr__(made, "name", f"{made.name}-{number}")
        found = ns.simulate(made, data, state, until=0.5)
        assert found.configurations == expected.configurations
        visited.add(expected.configurations[0])
    assert len(visited) > 1


@pytest.mark.slow
def test_many_motions_are_those_of_the_listed_system(monkeypatch) -> None:
    whole, data = listed(striking, 2)
    monkeypatch.setattr(growing, "_LARGEST", 0)
    made, _ = striking(2)
    rng = np.random.default_rng(3)
    starts = np.zeros((60, 8))
    starts[:, :6], starts[:, 6] = rng.uniform(-0.45, 0.45, (60, 6)), 1.0
    expected = ns.simulate_many(whole, data, starts, until=20, keep=5, threads=2)
    found = ns.simulate_many(made, data, starts, until=20, keep=5, threads=2)
    names = [np.array(many.structure.configurations) for many in (expected, found)]
    np.testing.assert_array_equal(names[0][expected.configurations], names[1][found.configurations])
    np.testing.assert_array_equal(found.transitions, expected.transitions)
    np.testing.assert_allclose(found.last_times, expected.last_times, rtol=1e-9)
    # indices of an earlier result stay good where more was visited
    again = ns.simulate_many(made, data, found.states, found.configurations, until=1.0, threads=2)
    assert (again.status == Status.UNTIL).all()


def belt_of_ten() -> System:
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
def test_ten_contacts_have_an_orbit_that_solves_saves_and_loads(tmp_path) -> None:
    system = belt_of_ten()
    assert isinstance(pickle.loads(pickle.dumps(system)), GrowingSystem)
    assert pickle.loads(pickle.dumps(system)) == system
    motion = ns.simulate(system, {}, [0.1 * k for k in range(10)] + [0.0] * 10, until=300)
    assert motion.status == Status.UNTIL
    cycle = ns.itinerary_of(motion)
    orbit = ns.solve(system, {}, itinerary=cycle)
    assert orbit.converged
    assert (orbit.stability.verdict, orbit.admissibility.verdict) == ("stable", True)
    declared = ns.solve(Itinerary.from_trajectory(motion, system, "cycle"))
    np.testing.assert_allclose(float(declared.period), float(orbit.period), rtol=1e-12)
    orbit.save(tmp_path / "orbit.json")
    again = ns.load(tmp_path / "orbit.json")
    assert again.period == orbit.period
    assert again.stability.verdict == "stable"


def test_what_needs_all_configurations_says_how_many_there_are() -> None:
    system = belt_of_ten()
    for ask in (lambda: system.configurations, lambda: describe_system(system)):
        with pytest.raises(DeclarationError, match="59,049 configurations") as refusal:
            ask()
        assert "\n" not in str(refusal.value)
    with pytest.raises(InputError, match="needs all configurations of belt-of-ten"):
        ns.sweep(system, {}, "V", [0.1], [0.0] * 20, state="x1", configuration="slip")


def test_names_of_configurations_are_regimes_that_go_together() -> None:
    system = belt_of_ten()
    name = "-".join(["slip", "stick"] * 5)
    assert system.configuration(name).name == name
    for wrong in ("slip", f"{name}-slip", name.replace("stick", "stack", 1)):
        with pytest.raises(DeclarationError, match="has no configuration"):
            system.configuration(wrong)
    with pytest.raises(DeclarationError, match="no transition leads"):
        system.transition(name, "x1-reaches-belt", name.replace("slip", "stick"))


def test_boundaries_reached_together_follow_as_in_the_listed_system(monkeypatch) -> None:
    def make() -> System:
        elements = [RigidStop(x, at=1, restitution="0.5", name=f"s{x}") for x in ("x1", "x2", "x3")]
        return oscillator("alike", ["x1", "x2", "x3"], *([np.eye(3)] * 2), elements=elements)

    whole = make()
    monkeypatch.setattr(growing, "_LARGEST", 0)
    start = [0.0, 0.0, 0.0, 4.0, 4.0, 4.0]
    expected = ns.simulate(whole, {}, start, until=20)
    found = ns.simulate(make(), {}, start, until=20)
    assert len(expected.boundaries[1]) == 3
    assert found.boundaries == expected.boundaries
    np.testing.assert_allclose(found.states, expected.states, atol=1e-12)
    many = ns.simulate_many(make(), {}, [start, start], until=20)
    np.testing.assert_allclose(many.states[0], expected([20.0])[0], atol=1e-11)

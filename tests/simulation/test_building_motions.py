"""Motions of built systems against closed forms, direct integration and time stepping."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
import sympy as sp
from scipy.integrate import solve_ivp

import nonsmooth as ns
from nonsmooth.derive import (
    Friction,
    Harmonic,
    RigidStop,
    Slider,
    SoftStop,
    chain_matrices,
    oscillator,
)
from tests.derive.test_building import BUILT_IN, FULL, SPRINGS

MASS, STIFFNESS = FULL[:2, :2], SPRINGS[:2, :2]


@pytest.mark.parametrize("name", BUILT_IN)
def test_motions_of_the_built_in_systems_come_out_again(name: str) -> None:
    system, rng = BUILT_IN[name][0](), np.random.default_rng(1)
    for _ in range(5):
        if name == "dry-friction":
            low, high = (0.2, 0.5, 0.3, 0, 0), (0.8, 4, 1, 0.5, 0.5)
            drawn = rng.uniform(low, high).tolist()
            data = dict(zip(("chi", "eta", "V", "us1", "us2"), drawn, strict=True))
            data |= {f"ur{i}": data[f"us{i}"] + rng.uniform(0, 0.5) for i in (1, 2)}
        else:
            data = dict(zip(("m1", "m2", "k1", "k2"), rng.uniform(0.5, 3, 4).tolist(), strict=True))
            data |= {"r": 0.5} if name == "rigid-stop" else {"k3": 2.0}
        start = rng.uniform([-1, -1, -1, -1], [0.9, 1, 1, 1])
        given = ns.simulate(name, data, start, transitions=30)
        built = ns.simulate(system, data, start, transitions=30)
        assert built.configurations == given.configurations
        assert built.boundaries == given.boundaries
        assert np.abs(built.states - given.states).max() < 1e-10
        assert np.allclose(built.times, given.times, rtol=1e-13, atol=1e-10)


@pytest.mark.slow
def test_elastic_impacts_with_a_full_mass_keep_the_energy() -> None:
    stops = [RigidStop("x1", 0.8, 1), RigidStop({"x2": 1, "x3": -1}, -0.3, 1, "lower")]
    system = oscillator("full", ["x1", "x2", "x3"], FULL, SPRINGS, elements=stops)
    motion = ns.simulate(system, {}, [0.1, 0.2, 0, 1, -1, 0.7], transitions=80)
    assert {"x1-upper-reaches-stop", "x2-x3-lower-reaches-stop"} <= {
        b for entry in motion.boundaries for b in entry
    }
    x, v = motion.states[:, :3], motion.states[:, 3:]
    energy = (np.einsum("ij,jk,ik->i", x, SPRINGS, x) + np.einsum("ij,jk,ik->i", v, FULL, v)) / 2
    assert np.ptp(energy) < 1e-12
    assert x[:, 0].max() < 0.8 + 1e-12
    assert (x[:, 1] - x[:, 2]).min() > -0.3 - 1e-12


def test_a_mass_between_masses_strikes_without_losing_momentum() -> None:
    stop = RigidStop({"x1": 1, "x2": -1}, 0, 0.25)
    mass, stiffness, _ = chain_matrices([1, 3], [2], fixed="none")
    system = oscillator("pair", ["x1", "x2"], mass, stiffness, load=[1, 0], elements=[stop])
    motion = ns.simulate(system, {}, [-1, 0.5, 0, 0], until=20.0)
    momentum = motion.states[:, 2] + 3 * motion.states[:, 3]
    assert np.allclose(momentum, motion.times, atol=1e-12)
    assert motion.configurations[-1] == "contact"  # the load presses one against the other
    end = motion(20.0)
    assert abs(end[0] - end[1]) < 1e-12


@pytest.mark.parametrize("restitution", [0, 0.5, 1])
def test_a_belt_carries_a_mass_against_a_stop(restitution: float) -> None:
    elements = [Friction("x", 1, velocity=0.5), RigidStop("x", 0.4, restitution)]
    system = oscillator("carried", ["x"], [[1]], [[1]], elements=elements)
    motion = ns.simulate(system, {}, [0, 0], transitions=200, until=60.0)
    assert motion.configurations[1] == "stick-free"
    if restitution < 1:
        assert motion.configurations[-1] == "slip-contact"
        assert np.allclose(motion(60.0), [0.4, 0], atol=1e-12)
    else:
        assert "slip-contact" not in motion.configurations


@pytest.mark.slow
def test_coupled_friction_agrees_with_time_stepping() -> None:
    limits = np.array([0.3, 0.5])
    elements = [Friction(x, u, velocity=0.4) for x, u in zip(("x1", "x2"), limits, strict=True)]
    system = oscillator("pair", ["x1", "x2"], MASS, STIFFNESS, elements=elements)
    start = np.array([1.0, -0.5, 0, 0])
    motion = ns.simulate(system, {}, start, until=12.0)
    assert len(set(motion.configurations)) >= 4
    coarse, fine = (stepped(limits, start, h) for h in (4e-3, 2e-3))
    states = motion(np.arange(1.0, 13.0))
    # steps of first order: their error halves with them
    assert np.abs(fine - states).max() < 0.55 * np.abs(coarse - states).max() < 0.02


def stepped(limits: np.ndarray, start: np.ndarray, h: float) -> np.ndarray:
    """States (12, 4) at whole times, by implicit steps.

    The friction impulses of a step minimise a quadratic form in their box.
    """
    x, v, impulse, found = start[:2], start[2:], np.zeros(2), []
    step = np.linalg.inv(MASS + h * h * STIFFNESS)
    for n in range(1, round(12 / h) + 1):
        freely = step @ (MASS @ v - h * STIFFNESS @ x) - 0.4
        for _ in range(12):
            for i in (0, 1):
                change = (freely + step @ impulse)[i] / step[i, i]
                impulse[i] = min(max(impulse[i] - change, -h * limits[i]), h * limits[i])
        v = freely + 0.4 + step @ impulse
        x = x + h * v
        if n % round(1 / h) == 0:
            found.append([*x, *v])
    return np.array(found)


def direct(rates: Callable[[float, np.ndarray], Any], start: list[float], end: float) -> np.ndarray:
    found = solve_ivp(rates, (0, end), start, "DOP853", rtol=1e-10, atol=1e-12, max_step=0.002)
    return np.asarray(found.y[:, -1])


@pytest.mark.slow
@pytest.mark.parametrize(("released", "damping"), [("gap", 0), ("gap", 0.8), ("force", 0.8)])
def test_soft_stops_agree_with_direct_integration(released: str, damping: float) -> None:
    w, end = 1.3, 8.0
    stop = SoftStop("x", 0.5, stiffness=20, damping=damping, released=released)
    system = oscillator(
        "shaw", ["x"], [[1]], [[1]], [[0.1]], forcing=[Harmonic(w, (0.7,))],
        elements=[stop, SoftStop("x", -2, 5, side="lower")],
    )  # fmt: skip
    motion = ns.simulate(system, {}, [0, 0, 1, 0], until=end)
    assert {"contact-free"} <= set(motion.configurations)
    assert ("released-free" in motion.configurations) == (released == "force")

    def rates(t: float, y: np.ndarray) -> list[float]:
        gap = y[0] - 0.5
        push = 20 * gap + damping * y[1] if gap > 0 else 0.0
        push = max(push, 0.0) if released == "force" else push
        below = max(-2 - y[0], 0.0)
        return [y[1], 0.7 * math.cos(w * t) - 0.1 * y[1] - y[0] - push + 5 * below]

    # the direct steps run over the jumps of the force
    assert np.abs(motion(end)[:2] - direct(rates, [0, 0], end)).max() < 2e-5


def test_a_slider_dissipates_the_area_of_its_loop() -> None:
    w, limit, stiffness = 0.9, 0.2, 3.0
    system = oscillator(
        "jenkins", ["x"], [[1]], [[0.5]], [[0.1]],
        forcing=[Harmonic(w, (0.6,))], elements=[Slider("x", stiffness, limit)],
    )  # fmt: skip
    motion = ns.simulate(system, {}, [0, 0, 1, 0, 0], until=400.0)
    period = 2 * math.pi / w
    end = period * math.floor(390 / period)
    times = np.linspace(end - period, end, 20001)
    states = motion(times)
    assert np.abs(states[0] - states[-1]).max() < 1e-9
    work = np.trapezoid(0.6 * states[:, 2] * states[:, 1], times)
    viscous = np.trapezoid(0.1 * states[:, 1] ** 2, times)
    amplitude = np.abs(states[:, 0]).max()
    assert amplitude > limit / stiffness
    loop = 4 * limit * (amplitude - limit / stiffness)
    assert work - viscous == pytest.approx(loop, rel=1e-6)
    stretched = np.abs(states[:, 0] - states[:, 4]) * stiffness
    assert stretched.max() < limit + 1e-10


@pytest.mark.slow
def test_a_forced_chain_with_stops_agrees_with_events_of_an_integrator() -> None:
    mass, stiffness, damping = chain_matrices([1, 2, 1], [3, 2, 2], [0.1, 0.2, 0.1])
    stops = [RigidStop("x1", 0.3, 0.8), RigidStop("x3", -0.6, 0.6, "lower")]
    system = oscillator(
        "chain", ["x1", "x2", "x3"], mass, stiffness, damping,
        forcing=[Harmonic(1.1, {"x2": 2}), Harmonic(2.7, sine={"x3": 0.5})], elements=stops,
    )  # fmt: skip
    motion = ns.simulate(system, {}, [0] * 6 + [1, 0, 1, 0], until=25.0)
    assert len(motion.times) > 15
    inverse = np.linalg.inv(np.array(mass, dtype=float))
    springs, dampers = np.array(stiffness, dtype=float), np.array(damping, dtype=float)

    def rates(t: float, y: np.ndarray) -> np.ndarray:
        force = np.array([0, 2 * math.cos(1.1 * t), 0.5 * math.sin(2.7 * t)])
        return np.concatenate([y[3:], inverse @ (force - springs @ y[:3] - dampers @ y[3:])])

    for begin, finish, state, entry in zip(
        motion.times[:-1], motion.times[1:], motion.states[:-1], motion.states[1:], strict=True
    ):
        found = solve_ivp(rates, (begin, finish), state[:6], "DOP853", rtol=1e-12, atol=1e-13)
        end = found.y[:, -1]
        struck = 0 if abs(end[0] - 0.3) < abs(end[2] + 0.6) else 2
        assert min(abs(end[0] - 0.3), abs(end[2] + 0.6)) < 1e-9
        assert np.all(found.y[0] < 0.3 + 1e-9)
        assert np.all(found.y[2] > -0.6 - 1e-9)
        end[3 + struck] *= -(0.8 if struck == 0 else 0.6)
        assert np.abs(end - entry[:6]).max() < 1e-9


@pytest.mark.slow
def test_friction_with_stops_never_leaves_its_rules() -> None:
    elements = [
        Friction("x1", 0.03, 0.06, 0),
        Friction("x2", 0.02, 0.05, 0.1),
        RigidStop("x1", 0.1, 0.7),
        RigidStop("x2", -0.1, 0.3, "lower"),
    ]
    load = [0.2, -0.2]
    system = oscillator("rubbing", ["x1", "x2"], MASS, STIFFNESS, load=load, elements=elements)
    rng = np.random.default_rng(4)
    for _ in range(4):
        start = rng.uniform([-1, -0.1, -1, -1], [0.1, 1, 1, 1])
        motion = ns.simulate(system, {}, start, until=20.0)
        assert motion.end == 20.0
        states = motion(np.linspace(0, 20, 401))
        assert states[:, 0].max() < 0.1 + 1e-9
        assert states[:, 1].min() > -0.1 - 1e-9
        for configuration, state in zip(motion.configurations, motion.states, strict=True):
            for i, regime in enumerate(configuration.split("-")[:2]):
                relative = state[2 + i] - (0, 0.1)[i]
                assert relative * {"slip": 1, "stick": 0, "overshoot": -1}[regime] < 1e-9
                assert regime != "stick" or abs(relative) < 1e-9


@pytest.mark.slow
@pytest.mark.usefixtures("backend")
def test_impacts_that_accumulate_never_pass_the_stop() -> None:
    """Each impact leaves the mass where rounding puts it: the next is found all the same."""
    w, r = sp.symbols("w r", positive=True)
    stop = RigidStop("x", at=0, restitution=r, name="stop")
    force = Harmonic(w, cosine=[1])
    system = oscillator(
        "accumulating", ["x"], [[1]], [[1]], [[0.1]], forcing=[force], elements=[stop]
    )
    phase = 0.6481012572874046, 0.7615541742401863
    starts = [([1.3e-18, -0.3584489936144315, *phase], 2.847457627118644)]
    random = np.random.default_rng(5)
    starts += [([0, -random.random(), 1, 0], random.uniform(2.7, 3.0)) for _ in range(6)]
    for start, frequency in starts:
        motion = ns.simulate(system, {"w": frequency, "r": 0.8}, start, until=400.0)
        assert motion.end == 400.0
        assert motion.states[:, 0].max() < 1e-12

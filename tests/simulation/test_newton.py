"""Motions of all elements, alone and beside others, obey Newton's law and the laws of contact."""

from functools import cache

import numpy as np
import pytest
import sympy as sp

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
from tests.derive.test_building import FULL, SPRINGS
from tests.newton import Newton
from tests.one_mass import one_mass
from tests.tables import slow
from tests.two_masses import STICKING, SYSTEMS

pytestmark = pytest.mark.compiled  # much slower, or nothing to compare, without it

MASS, STIFFNESS = np.array([[2, 0.5], [0.5, 1]]), np.array([[2, -0.4], [-0.4, 3]])
DAMPING = np.array([[0.2, 0], [0, 0.1]])
OBLIQUE, HARD = {"x": 1, "y": -0.25}, (0.8, 1.5)
WAVE = [Harmonic("1.3", {"x": 0.5, "y": 2})]
X, V = sp.symbols("x v")
FALLING_LOAD = sp.sympify("1 - 1.2*y + 0.2*v_y")


def soft(**options):
    return SoftStop("y", 0.15, 9, name="soft", **options)


def rub(coordinate="x", kinetic=0.45, static=0.9, **options):
    return Friction(coordinate, kinetic, static, velocity=0.3, name="pad", **options)


WALL = RigidStop({"x": 1, "y": 0.5}, at=0.25, restitution=0.6, name="wall")
GAP, FORCE = (soft(damping=0.8, released=released) for released in ("gap", "force"))
TWO = (["x", "y"], MASS, STIFFNESS, DAMPING)
CASES = {
    # matrices, elements and forces, and words of configurations that are visited
    "falling": (TWO, {"elements": [rub({"x": -1, "y": 0.25}, falling=0.4)], "forcing": WAVE},
                {"slip", "stick", "exhausted"}),
    "load and falling": (
        TWO, {"elements": [rub(OBLIQUE, *HARD, normal=FALLING_LOAD, falling=0.3)], "forcing": WAVE},
        {"slip", "stick", "lifted", "exhausted"}),
    "on a soft stop": (
        TWO, {"elements": [soft(), rub(OBLIQUE, normal="soft", falling=0.2)], "forcing": WAVE},
        {"lifted", "contact", "slip"}),
    "on a damped soft stop": (TWO, {"elements": [rub(normal=GAP), GAP], "forcing": WAVE},
                              {"lifted", "contact"}),
    "on a released soft stop": (TWO, {"elements": [FORCE, rub(normal=FORCE)], "forcing": WAVE},
                                {"lifted", "released"}),
    "exhausted beside a wall": (
        TWO, {"elements": [rub(normal=FALLING_LOAD, falling=0.3), WALL], "forcing": WAVE},
        {"lifted", "slip"}),
    "two pads": (
        TWO, {"elements": [rub(normal=FALLING_LOAD),
                           Friction("y", 0.1, normal=0.3 + 2 * X - 0.2 * V, name="guide")],
              "forcing": WAVE}, {"lifted", "slip"}),
    "coupled pads": (TWO, {"elements": [Friction(x, u, 1.3 * u, velocity=0.4)
                                        for x, u in (("x", 0.3), ("y", 0.5))]}, {"slip", "stick"}),
    "soft stops": (TWO, {"elements": [soft(), SoftStop("x", -0.3, 5, side="lower")],
                         "forcing": [Harmonic("1.3", {"y": 2}, {"x": 0.5}, phase=0.7)]},
                   {"contact"}),
    "slider": (TWO, {"elements": [Slider("x", 3, 0.2, name="jenkins")], "forcing": WAVE},
               {"forward", "backward"}),
    "belts and stops": (
        TWO, {"elements": [Friction("x", 0.03, 0.06, 0), Friction("y", 0.02, 0.05, 0.1),
                           RigidStop("x", 0.1, 0.7), RigidStop("y", -0.1, 0.3, "lower")],
              "load": [0.2, -0.2]}, {"slip", "stick"}),
    "carried to a stop": (
        (["x"], [[1]], [[1]]),
        {"elements": [Friction("x", 1, velocity=0.5), RigidStop("x", 0.2, 0.5)]}, {"contact"}),
    "between masses": (
        (["x1", "x2"], *chain_matrices([1, 3], [2], fixed="none")[:2]),
        {"elements": [RigidStop({"x1": 1, "x2": -1}, 0.36, 0.25)], "load": [1, 0]}, {"contact"}),
    "full masses": (
        (["x1", "x2", "x3"], FULL, SPRINGS, None),
        {"elements": [RigidStop("x1", 0.8, 1), RigidStop({"x2": 1, "x3": -1}, -0.3, 1, "lower")]},
        {"free"}),
    "chain": (
        (["x1", "x2", "x3"], *chain_matrices([1, 2, 1], [3, 2, 2], [0.1, 0.2, 0.1])),
        {"elements": [RigidStop("x1", 0.3, 0.8), RigidStop("x3", -0.6, 0.6, "lower")],
         "forcing": [Harmonic(1.1, {"x2": 2}, phase=2), Harmonic(2.7, sine={"x3": 0.5}, phase=1)]},
        {"free"}),
}  # fmt: skip


@cache
def declared(name):
    matrices, more, _ = CASES[name]
    return oscillator("obeying", *matrices, **more), Newton(*matrices, **more)


QUICK = ("falling", "carried to a stop", "slider")


@pytest.mark.parametrize("name", [slow(name, when=name not in QUICK) for name in CASES])
def test_motions_obey_newtons_law_and_the_laws_of_contact(name):
    system, newton = declared(name)
    rng, size, seen = np.random.default_rng(len(name)), len(newton.names), set()
    for _ in range(2):
        places = dict(zip(newton.names, rng.uniform(-0.3, 0.05, size).tolist(), strict=True))
        start = places | {str(s): 0.0 for s in system.states[size : 2 * size]}
        start |= {"s_jenkins": places["x"]} if name == "slider" else {}
        start |= {"y": 0.05} if name == "belts and stops" else {}
        motion = ns.simulate(system, {}, start, until=15.0)
        assert motion.end == 15.0
        newton.obeyed_by(motion)
        seen |= {word for c in motion.configurations for word in c.split("-")}
    assert seen >= CASES[name][-1]


@pytest.mark.parametrize(("name", "data"), [("dry-friction", STICKING), *SYSTEMS.items()])
def test_built_in_systems_obey_the_laws_of_their_elements(name, data, backend):
    p = {key: float(sp.sympify(value)) for key, value in data.items()}
    if name == "dry-friction":
        mass, chi = np.diag([1, 1 / p["eta"]]), p["chi"]
        stiffness = [[1, -chi], [-chi, chi]]
        elements = [Friction(f"x{k}", p[f"us{k}"], p[f"ur{k}"], velocity=p["V"]) for k in (1, 2)]
    else:
        mass, k1 = np.diag([p["m1"], p["m2"]]), p["k1"]
        stiffness = [[k1, -k1], [-k1, k1 + p["k2"]]]
        elements = [RigidStop("x1", 1, p["r"]) if "r" in p else SoftStop("x1", 1, p["k3"])]
    newton = Newton(["x1", "x2"], mass, stiffness, elements=elements)
    for start in ([0, 0, 0, 0], [0.5, -0.3, 0.2, 0.1], [-2, 1, 0.5, -3], [0, 4, -1, -2]):
        motion = ns.simulate(name, data, start, transitions=20, until=100)
        newton.obeyed_by(motion)


@pytest.mark.slow
@pytest.mark.usefixtures("backend")
def test_impacts_that_accumulate_never_pass_the_stop():
    """Each impact leaves the mass where rounding puts it: the next is found all the same."""
    w, r = sp.symbols("w r", positive=True)
    stop = RigidStop("x", at=0, restitution=r, name="stop")
    system = one_mass("accumulating", stop, forces={w: 1}, damping=0.1)
    phase = 0.6481012572874046, 0.7615541742401863
    starts = [([1.3e-18, -0.3584489936144315, *phase], 2.847457627118644)]
    random = np.random.default_rng(5)
    starts += [([0, -random.random(), 1, 0], random.uniform(2.7, 3.0)) for _ in range(6)]
    for start, frequency in starts:
        motion = ns.simulate(system, {"w": frequency, "r": 0.8}, start, until=400.0)
        assert motion.end == 400.0
        assert motion.states[:, 0].max() < 1e-12

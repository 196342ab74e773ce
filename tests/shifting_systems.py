"""Forced systems whose motions come back up to a shift, and the orbits on which they settle."""

import sympy as sp

import nonsmooth as ns
from nonsmooth.derive import Friction, Harmonic, RigidStop, oscillator

A, V, c, e, g, i, k, r, u, w = sp.symbols("A V c e g i k r u w")
GROUND = Friction("x", kinetic=u, static=u, velocity=0, name="ground")
WALL = RigidStop({"y": 1, "x": -1}, at=g, restitution=r, name="wall")


def box(name, *elements):
    """A box, moved by a mass in it."""
    return oscillator(
        name, ["x", "y"], mass=[[2, 0], [0, 1]], stiffness=[[k, -k], [-k, k]],
        damping=[[c, -c], [-c, c]], forcing=[Harmonic(w, cosine=[-A, A])], elements=elements,
    )  # fmt: skip


# on rough ground, where the mass strikes the wall of its box
CAPSULE = box("capsule", GROUND, WALL)
SHAKEN = {"A": 1.0, "w": 1.0, "u": 0.3, "k": 0.5, "g": 0.5, "r": 0.5, "c": 0.1}
# two wheels with a spring and a stop between their teeth: how they turn together depends on i
GEARED = oscillator(
    "geared-wheels", ["x", "y"], mass=sp.diag(1, 2), damping=c * sp.eye(2),
    stiffness=k * sp.Matrix([[1, -i], [-i, i**2]]), forcing=[Harmonic(w, cosine=[A, 0])],
    elements=[RigidStop({"x": 1, "y": -i}, at=g, restitution=r, name="tooth")],
)  # fmt: skip
TURNED = {"c": 0.1, "g": 0.5, "i": 1.5, "r": 0.5, "k": 0.6, "A": 1.0, "w": 1.1}


def pulled(name, damping):
    """A sled on rough ground, pulled by a spring whose end moves at V in the end."""
    ground = Friction("x", kinetic=u, static=u + e, velocity=0, name="ground")
    return oscillator(
        name, ["x", "y"], mass=[[1, 0], [0, 1]], stiffness=[[1, -1], [0, 0]], damping=damping,
        load=[0, V], elements=[ground],
    )  # fmt: skip


SLED = pulled("sled", [[0, 0], [0, 1]])
PULLED = {"u": "1", "e": "0.3", "V": "0.5"}


def settled_orbit(system, data, start=(0, 0, 0, 0, 1, 0)):
    """The orbit on which a motion settles."""
    motion = ns.simulate(system, data, start, transitions=800)
    return ns.solve(system, data, itinerary=ns.itinerary_of(motion))

"""Systems without closed forms, and itineraries in them, for the tests of documents."""

from __future__ import annotations

import sympy as sp

from nonsmooth.derive import (
    Boundary,
    Condition,
    Configuration,
    Contact,
    FirstOrder,
    Itinerary,
    Parameter,
    Phase,
    SecondOrder,
    System,
    Transition,
)

__all__ = ["chain", "forced_stop", "impacts", "one_mass", "rattle", "switched", "switching"]

ZETA = Parameter("zeta", "damping ratio, nondimensional", closed=True)
OMEGA = Parameter("Omega", "frequency of the forcing", lower=0)
RESTITUTION = Parameter("r", "coefficient of restitution", upper=1, closed=True, upper_closed=True)


def forced_stop() -> System:
    """Damped mass under harmonic forcing, in front of a stop: states x, v and c, s."""
    zeta, omega, r = (p.symbol for p in (ZETA, OMEGA, RESTITUTION))
    x, v, c, _ = states = sp.symbols("x v c s", real=True)
    turning = [[0, 0, 0, -omega], [0, 0, omega, 0]]
    force = -x - 2 * zeta * v + c
    free = Configuration(
        "free",
        FirstOrder([[0, 1, 0, 0], [-1, -2 * zeta, 1, 0], *turning]),
        (Boundary("reaches-stop", x - 1),),
    )
    pressed = c - x
    contact = Configuration(
        "contact",
        FirstOrder([[0, 0, 0, 0], [0, 0, 0, 0], *turning]),
        (Boundary("leaves-stop", -pressed),),
        constraints=(x - 1, v),
    )
    reached = frozenset({"reaches-stop"})
    return System(
        "forced-stop",
        "a damped mass under harmonic forcing in front of a rigid stop",
        states,
        (ZETA, OMEGA, RESTITUTION),
        (free, contact),
        (
            Transition("free", reached, "free", (Condition(v, "contact"),), {v: -r * v}),
            Transition("free", reached, "contact", (Condition(force, "contact"),), {x: 1, v: 0}),
            Transition("free", reached, "free"),
            Transition("contact", frozenset({"leaves-stop"}), "free"),
        ),
        contacts=(Contact("stop", v, {"contact": -pressed}),),
    )


def impacts(count: int) -> Itinerary:
    """That many impacts in a period of the orbit."""
    phases = tuple(Phase("free", "reaches-stop", f"tau{k + 1}") for k in range(count))
    return Itinerary("impacts", forced_stop(), phases)


def chain(damping: str | int = "0.1") -> System:
    """Three masses between two walls; the outer ones in front of elastic stops."""
    k, stop = Parameter("k", "stiffness of the springs"), Parameter("kappa", "stiffness of a stop")
    states = sp.symbols("x1:4 v1:4", real=True)
    springs = k.symbol * sp.Matrix([[2, -1, 0], [-1, 2, -1], [0, -1, 2]])
    damper = sp.Rational(str(damping)) * sp.eye(3)
    configurations, transitions = [], []
    for left in (0, 1):
        for right in (0, 1):
            name = {(0, 0): "free", (1, 0): "left", (0, 1): "right", (1, 1): "both"}[left, right]
            stiffness = springs + stop.symbol * sp.diag(left, 0, right)
            load = (-left * stop.symbol, 0, right * stop.symbol)
            below, above = -states[0] - 1, states[2] - 1
            configurations.append(
                Configuration(
                    name,
                    SecondOrder(sp.eye(3), stiffness, load, damper),
                    (
                        Boundary("left-leaves", -below)
                        if left
                        else Boundary("left-reaches", below),
                        Boundary("right-leaves", -above)
                        if right
                        else Boundary("right-reaches", above),
                    ),
                )
            )
    for source, boundary, target in (
        ("free", "left-reaches", "left"), ("free", "right-reaches", "right"),
        ("left", "left-leaves", "free"), ("left", "right-reaches", "both"),
        ("right", "right-leaves", "free"), ("right", "left-reaches", "both"),
        ("both", "left-leaves", "right"), ("both", "right-leaves", "left"),
    ):  # fmt: skip
        transitions.append(Transition(source, frozenset({boundary}), target))
    return System(
        "chain", "three masses between two stops", states, (k, stop), configurations, transitions
    )


def rattle(damping: str | int = "0.1") -> Itinerary:
    """The chain meets its left stop and then its right one."""
    turn = [
        ("free", "left-reaches"), ("left", "left-leaves"),
        ("free", "right-reaches"), ("right", "right-leaves"),
    ]  # fmt: skip
    phases = [Phase(*phase, f"tau{k}") for k, phase in enumerate(turn, start=1)]
    return Itinerary("rattle", chain(damping), tuple(phases))


def one_mass(zeta: object, square: object = 1) -> System:
    """One damped mass with a boundary."""
    x, v = sp.symbols("x v", real=True)
    motion = SecondOrder([[1]], [[square]], (1,), [[2 * sp.sympify(zeta)]])
    known = {str(s): s for s in motion.free_symbols()}
    parameters = tuple(Parameter(name, name) for name in sorted(known))
    return System(
        "mass",
        "one damped mass",
        (x, v),
        parameters,
        (Configuration("swing", motion, (Boundary("reaches-stop", x - 2),)),),
        (Transition("swing", frozenset({"reaches-stop"}), "swing", (), {v: -v}),),
    )


def switched() -> System:
    """Damping that changes its sign where the velocity passes one."""
    x, v = sp.symbols("x v", real=True)
    configurations = [
        Configuration(
            name,
            SecondOrder([[1]], [[1]], (2 * sp.Rational(zeta),), [[2 * sp.Rational(zeta)]]),
            (Boundary(boundary, sign * (v - 1), "reached"),),
        )
        for name, zeta, boundary, sign in (
            ("above", "3/10", "slows", -1),
            ("below", "-1/10", "speeds", 1),
        )
    ]
    transitions = [
        Transition("above", frozenset({"slows"}), "below"),
        Transition("below", frozenset({"speeds"}), "above"),
    ]
    return System("switched", "switched damping", (x, v), (), configurations, transitions)


def switching(turns: int = 1) -> Itinerary:
    """The cycle of switched damping, that many times."""
    turn = [("above", "slows"), ("below", "speeds")]
    phases = [Phase(*phase, f"tau{k}") for k, phase in enumerate(turns * turn, start=1)]
    return Itinerary("cycle", switched(), tuple(phases))

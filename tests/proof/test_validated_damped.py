"""Proofs of motions whose flows have no closed form: damped, forced, defective, growing."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise
from types import ModuleType
from typing import Any

import pytest
import sympy as sp
from mpmath import MPContext

from nonsmooth import certify
from nonsmooth.derive import (
    Boundary,
    Condition,
    Configuration,
    FirstOrder,
    Parameter,
    SecondOrder,
    System,
    Transition,
)
from nonsmooth.derive.codegen.any_arithmetic import python_kernel
from nonsmooth.derive.codegen.python_file import system_table
from nonsmooth.derive.codegen.simulation_form import SimulationForm
from nonsmooth.derive.flows.modal import TIME, Flow, Spectrum
from nonsmooth.runtime.model.kernels import SystemKernels
from nonsmooth.runtime.proof.motion.motion_proof import Proof

mp = MPContext()
mp.dps = 50

x, v, c, s = sp.symbols("x v c s", real=True)
a, k, r, g, w, f = sp.symbols("a k r g w f", real=True)
REACHED = frozenset({"reaches-stop"})


def kernels_of(system: System) -> SystemKernels:
    """Kernels of rows, fields and resets alone, as of a system without closed-form modes."""
    # a function that is no mode stands for the flow, of which only the field is used
    flows = {
        c.name: Flow(c.name, (sp.exp(TIME),), (), (), c.dynamics.field(system.states))
        for c in system.configurations
    }
    declaration = SimulationForm(system, Spectrum(), flows)
    module = ModuleType(system.name)
    exact = declaration.kernels()
    for kernel in exact:
        exec(python_kernel(kernel, None), module.__dict__)
    table: Any = module
    table.SYSTEM = system_table(declaration)
    assert table.SYSTEM["modes"] is None
    table.KERNELS = {
        e.name: ([(i.shape, 0) for i in e.arguments], [(o.name, o.shape) for o in e.outputs])
        for e in exact
    }
    return SystemKernels(system.name, module, None)


def parameters(*names: str) -> tuple[Parameter, ...]:
    return tuple(Parameter(name, name, lower=-sp.oo) for name in names)


def damped() -> SystemKernels:
    """A mass with x'' + a x' + k x = g in front of a stop at x = 1."""
    one = sp.Matrix([[1]])
    free = SecondOrder(one, k * one, (g,), a * one)
    stuck = SecondOrder(one, k * one, (g,), a * one, {x: 0})
    return kernels_of(
        System(
            "damped",
            "one mass",
            (x, v),
            parameters("a", "k", "g", "r"),
            (
                Configuration("free", free, (Boundary("reaches-stop", x - 1),)),
                Configuration("rest", stuck, (Boundary("leaves-stop", k * x - g),), (x - 1,)),
            ),
            (
                Transition("free", REACHED, "free", (Condition(v, "rest"),), {x: 1, v: -r * v}),
                Transition("free", REACHED, "rest", (), {x: 1, v: 0}),
                Transition("rest", frozenset({"leaves-stop"}), "free"),
            ),
        )
    )


def forced() -> SystemKernels:
    """x'' + a x' + k x = f c with c' = -w s, s' = w c, in front of a stop at x = 1."""
    matrix = sp.Matrix([[0, 1, 0, 0], [-k, -a, f, 0], [0, 0, 0, -w], [0, 0, w, 0]])
    free = Configuration("free", FirstOrder(matrix), (Boundary("reaches-stop", x - 1),))
    return kernels_of(
        System(
            "forced",
            "one mass, forced",
            (x, v, c, s),
            parameters("a", "k", "f", "w", "r"),
            (free,),
            (Transition("free", REACHED, "free", (), {x: 1, v: -r * v}),),
        )
    )


def number(text: str) -> Any:
    return mp.mpf(Fraction(text).numerator) / Fraction(text).denominator


def impacts(
    field: Sequence[Sequence[Any]], restitution: Any, start: Sequence[str], count: int
) -> tuple[list[Any], list[list[Any]]]:
    """Instants and states behind impacts at x = 1, by matrix exponentials and bisection."""
    matrix = mp.matrix([[*row] for row in field] + [[0] * len(field[0])])
    state = mp.matrix([number(t) for t in start] + [1])
    step, now = mp.mpf(1) / 64, mp.mpf(0)
    stride = mp.expm(matrix * step)
    instants, states = [], []
    while len(instants) < count:
        following = stride * state
        if following[0] <= 1:
            state, now = following, now + step
            continue
        low, high = mp.mpf(0), step
        for _ in range(12):
            middle = (low + high) / 2
            low, high = (
                (low, middle) if (mp.expm(matrix * middle) * state)[0] > 1 else (middle, high)
            )
        at = (low + high) / 2
        for _ in range(6):
            there = mp.expm(matrix * at) * state
            at -= (there[0] - 1) / there[1]
        state, now = mp.expm(matrix * at) * state, now + at
        state[0], state[1] = mp.mpf(1), -restitution * state[1]
        instants.append(now)
        states.append(list(state)[:-1])
    return instants, states


def agrees(proof: Proof, instants: list[Any], states: list[list[Any]], narrow: float) -> None:
    assert proof.decided
    assert proof.transitions == len(instants)
    # 50 digits hold their own error
    slack = mp.mpf(10) ** -42
    for enclosure, instant in zip(proof.times[1:], instants, strict=True):
        assert enclosure.lower <= instant <= enclosure.upper
        assert abs(number_of(enclosure.mid) - instant) <= number_of(enclosure.rad) + slack
        assert float(enclosure.rad) < narrow
    for balls, state in zip(proof.states[1:], states, strict=True):
        for ball, value in zip(balls, state, strict=True):
            assert abs(number_of(ball.mid) - value) <= number_of(ball.rad) + slack
            assert float(ball.rad) < narrow


def number_of(text: str) -> Any:
    return mp.mpf(text)


@pytest.mark.parametrize(
    ("a", "k", "g", "start"),
    [
        ("1/10", "4", "8", ["0", "0"]),  # underdamped
        ("2", "1", "3", ["0", "1"]),  # critically damped: defective
        ("5", "4", "12", ["-1", "0"]),  # overdamped
        ("-1/10", "4", "2", ["1/2", "1/10"]),  # growing
        ("2000001/1000000", "1", "3", ["0", "1"]),  # all but defective
        ("0", "0", "1", ["0", "0"]),  # bouncing ball
    ],
)
def test_a_damped_mass_agrees_with_50_digits(a: str, k: str, g: str, start: list[str]) -> None:
    proof = certify.motion(damped(), dict(a=a, k=k, g=g, r="1/2"), start, "free", 5)
    field = [[0, 1, 0], [-number(k), -number(a), number(g)]]
    agrees(proof, *impacts(field, mp.mpf(1) / 2, start, 5), 1e-28)


@pytest.mark.slow
@pytest.mark.parametrize("w", ["1/2", "1", "999/1000", "7/10"])
def test_a_forced_impact_oscillator_agrees_with_50_digits(w: str) -> None:
    """At resonance and next to it as well: without damping, w = 1 is defective."""
    start = ["0", "0", "1", "0"]
    data = dict(a="0", k="1", f="1", w=w, r="4/5")
    proof = certify.motion(forced(), data, start, "free", 6)
    turn = number(w)
    field = [[0, 1, 0, 0, 0], [-1, 0, 1, 0, 0], [0, 0, 0, -turn, 0], [0, 0, turn, 0, 0]]
    agrees(proof, *impacts(field, mp.mpf(4) / 5, start, 6), 1e-28)


def test_impacts_that_accumulate_are_proved_one_by_one() -> None:
    """Dwell times shrink like the restitution; what is proved goes on as digits allow."""
    data = dict(a="1/10", k="1", g="3", r="1/2")
    proof = certify.motion(damped(), data, ["0", "0"], "free", 60)
    assert proof.decided
    assert set(proof.configurations) == {"free"}
    dwells = [
        float(later.ball - earlier.ball)
        for earlier, later in zip(proof.times[40:], proof.times[41:], strict=False)
    ]
    for earlier, later in pairwise(dwells):
        assert later / earlier == pytest.approx(0.5, rel=1e-6)


def test_a_grazing_contact_is_not_decided() -> None:
    """Thrown up so that it comes to rest at the stop for an instant, at t = 1."""
    data = dict(a="0", k="0", g="-2", r="1/2")
    proof = certify.motion(damped(), data, ["0", "2"], "free", 1, most_bits=256)
    assert not proof.decided
    assert proof.reason is not None
    assert "reaches-stop is reached tangentially" in proof.reason
    assert proof.instant is not None
    assert proof.instant.contains(1)
    for velocity, transitions in (("2.0000000001", 1), ("1.9999999999", 0)):
        near = certify.motion(damped(), data, ["0", velocity], "free", 1)
        assert near.decided
        assert near.transitions == transitions


@pytest.mark.parametrize(("a", "k"), [("1/10", "4"), ("2", "1"), ("5", "4")])
def test_a_damped_mass_is_proved_to_come_to_rest(a: str, k: str) -> None:
    proof = certify.motion(damped(), dict(a=a, k=k, g="0", r="1/2"), ["1/2", "0"], "free", 1)
    assert proof.decided
    assert proof.transitions == 0
    assert proof.reason == "no boundary is reached any more"


def test_a_growing_motion_is_not_called_quiet() -> None:
    data = dict(a="-1/10", k="4", g="0", r="1/2")
    proof = certify.motion(damped(), data, ["1/100000", "0"], "free", 1)
    assert proof.transitions == 1
    assert float(proof.times[1]) > 100

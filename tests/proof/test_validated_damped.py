"""Proofs of motions whose flows have no closed form: damped, forced, defective, growing."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise

import pytest
import sympy as sp
from flint import arb

from nonsmooth import certify
from nonsmooth.derive import (
    Boundary,
    Condition,
    Configuration,
    FirstOrder,
    Harmonic,
    Parameter,
    RigidStop,
    SecondOrder,
    System,
    Transition,
    oscillator,
)
from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.proof.motion.motion_proof import Proof
from tests.declared_motion import DeclaredMotion

x, v, c, s = sp.symbols("x v c s", real=True)
a, k, r, g, w, f = sp.symbols("a k r g w f", real=True)
REACHED = frozenset({"reaches-stop"})


def parameters(*names: str) -> tuple[Parameter, ...]:
    return tuple(Parameter(name, name, lower=-sp.oo) for name in names)


def damped() -> System:
    """A mass with x'' + a x' + k x = g in front of a stop at x = 1."""
    one = sp.Matrix([[1]])
    free = SecondOrder(one, k * one, (g,), a * one)
    stuck = SecondOrder(one, k * one, (g,), a * one, {x: 0})
    return System(
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


def forced() -> System:
    """x'' + a x' + k x = f c with c' = -w s, s' = w c, in front of a stop at x = 1."""
    matrix = sp.Matrix([[0, 1, 0, 0], [-k, -a, f, 0], [0, 0, 0, -w], [0, 0, w, 0]])
    free = Configuration("free", FirstOrder(matrix), (Boundary("reaches-stop", x - 1),))
    return System(
        "forced",
        "one mass, forced",
        (x, v, c, s),
        parameters("a", "k", "f", "w", "r"),
        (free,),
        (Transition("free", REACHED, "free", (), {x: 1, v: -r * v}),),
    )


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
def test_a_damped_mass_agrees_with_60_digits(a: str, k: str, g: str, start: list[str]) -> None:
    data = dict(a=a, k=k, g=g, r="1/2")
    proof = certify.motion(damped(), data, start, "free", 5)
    assert proof.transitions == 5
    DeclaredMotion(damped(), data).agrees(proof, start, 1e-28)


@pytest.mark.slow
@pytest.mark.parametrize("w", ["1/2", "1", "999/1000", "7/10"])
def test_a_forced_impact_oscillator_agrees_with_60_digits(w: str) -> None:
    """At resonance and next to it as well: without damping, w = 1 is defective."""
    start = ["0", "0", "1", "0"]
    data = dict(a="0", k="1", f="1", w=w, r="4/5")
    proof = certify.motion(forced(), data, start, "free", 6)
    assert proof.transitions == 6
    DeclaredMotion(forced(), data).agrees(proof, start, 1e-28)


def test_a_forcing_that_is_left_out_of_a_start_begins_at_its_time_zero() -> None:
    stop = RigidStop("x", "1/2", "4/5", name="stop")
    system = oscillator(
        "driven", ["x"], [[1]], [[1]], forcing=[Harmonic("7/10", cosine=[1])], elements=[stop]
    )
    left_out = certify.motion(system, {}, {"v": 0, "x": "1/4"}, "free", 3)
    whole = certify.motion(system, {}, ["1/4", 0, 1, 0], "free", 3)
    assert left_out.decided
    assert [time.mid for time in left_out.times] == [time.mid for time in whole.times]


def test_impacts_that_accumulate_are_proved_one_by_one() -> None:
    """Dwell times shrink like the restitution; what is proved goes on as digits allow."""
    data = dict(a="1/10", k="1", g="3", r="1/2")
    proof = certify.motion(damped(), data, ["0", "0"], "free", 60, 256)
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


@pytest.mark.parametrize("rate", [10**4, 10**6])
def test_a_motion_takes_a_unit_of_time_that_is_longer(rate: int) -> None:
    """Of a mass of some megahertz in seconds as much is proved as in its own unit."""

    def proved(rate: int) -> Proof:
        stop = RigidStop("x", at="1/1000", restitution="4/5")
        matrices = [[1]], [[rate**2]], [[Fraction(rate, 10)]]
        system = oscillator("struck", ["x"], *matrices, elements=[stop])
        return certify.motion(system, {}, [0, Fraction(rate, 100)], "free", 6)

    fast, slow = proved(rate), proved(1)
    assert fast.transitions == slow.transitions == 6
    for one, other in zip(fast.times, slow.times, strict=True):
        assert (one.ball * rate).overlaps(other.ball)


def test_the_arrival_behind_which_nothing_is_declared_is_enclosed() -> None:
    """At x = 1 with v < 9, where x'' = 2: after a time 1/sqrt(2), as x begins at 1/2."""
    one = Boundary("stop", x - 1)
    system = System(
        "falling", "", (x, v), (),
        (Configuration("free", SecondOrder([[1]], [[0]], (2,)), (one,)),),
        (Transition("free", {"stop"}, "free", (Condition(v - 9, "free"),), {v: -v}),),
    )  # fmt: skip
    proof = certify.motion(system, {}, ["1/2", 0], "free", 1)
    assert proof.reason is not None
    assert "no transition is declared for stop" in proof.reason
    assert proof.instant is not None
    with flint_precision(2 * proof.bits):
        assert proof.instant.contains(1 / arb(2).sqrt())
    assert 0 < float(proof.instant.rad) < 1e-30


def test_a_growing_motion_is_not_called_quiet() -> None:
    data = dict(a="-1/10", k="4", g="0", r="1/2")
    proof = certify.motion(damped(), data, ["1/100000", "0"], "free", 1)
    assert proof.transitions == 1
    assert float(proof.times[1]) > 100

"""Proofs of motions whose flows have no closed form: damped, forced, defective, growing."""

from fractions import Fraction
from itertools import pairwise

import pytest
import sympy as sp
from flint import arb, fmpq

from nonsmooth import certify
from nonsmooth.derive import (
    Boundary,
    Condition,
    Configuration,
    FirstOrder,
    Parameter,
    RigidStop,
    SecondOrder,
    System,
    Transition,
)
from nonsmooth.runtime.checker.state_sets.one_motion import stays_negative
from nonsmooth.runtime.core.values import flint_precision
from tests.declared_motion import DeclaredMotion
from tests.one_mass import one_mass
from tests.tables import slow

x, v, c, s = sp.symbols("x v c s", real=True)
a, k, r, g, w, f = sp.symbols("a k r g w f", real=True)
REACHED = frozenset({"reaches-stop"})


def parameters(*names):
    return tuple(Parameter(name, name, lower=-sp.oo) for name in names)


def damped(*more):
    """A mass with x'' + a x' + k x = g in front of a stop at x = 1."""
    reached = REACHED | {boundary.name for boundary in more}
    one = sp.Matrix([[1]])
    free = SecondOrder(one, k * one, (g,), a * one)
    stuck = SecondOrder(one, k * one, (g,), a * one, {x: 0})
    return System(
        "damped",
        "one mass",
        (x, v),
        parameters("a", "k", "g", "r"),
        (
            Configuration("free", free, (Boundary("reaches-stop", x - 1), *more)),
            Configuration("rest", stuck, (Boundary("leaves-stop", k * x - g),), (x - 1,)),
        ),
        (
            Transition("free", reached, "free", (Condition(v, "rest"),), {x: 1, v: -r * v}),
            Transition("free", reached, "rest", (), {x: 1, v: 0}),
            Transition("rest", {"leaves-stop"}, "free"),
        ),
    )


def forced():
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


def forced_impacts(w):
    return forced(), dict(a="0", k="1", f="1", w=w, r="4/5"), ["0", "0", "1", "0"], 6


def damped_impacts(a, k, g, start):
    return damped(), dict(a=a, k=k, g=g, r="1/2"), start, 5


MOTIONS = {
    "underdamped": damped_impacts("1/10", "4", "8", ["0", "0"]),
    "critically damped: defective": damped_impacts("2", "1", "3", ["0", "1"]),
    "overdamped": damped_impacts("5", "4", "12", ["-1", "0"]),
    "growing": damped_impacts("-1/10", "4", "2", ["1/2", "1/10"]),
    "all but defective": damped_impacts("2000001/1000000", "1", "3", ["0", "1"]),
    "a bouncing ball": damped_impacts("0", "0", "1", ["0", "0"]),
    "forced": forced_impacts("1/2"),
    "at resonance: defective": forced_impacts("1"),
    "next to resonance": forced_impacts("999/1000"),
    "forced at another frequency": forced_impacts("7/10"),
}


@pytest.mark.parametrize(
    "name",
    [slow(name, when=motion[0].name == "forced") for name, motion in MOTIONS.items()],
)
def test_motions_agree_with_60_digits(name):
    system, data, start, transitions = MOTIONS[name]
    proof = certify.motion(system, data, start, "free", transitions)
    assert proof.transitions == transitions
    DeclaredMotion(system, data).agrees(proof, start, 1e-28)


def test_a_forcing_that_is_left_out_of_a_start_begins_at_its_time_zero():
    stop = RigidStop("x", "1/2", "4/5", name="stop")
    system = one_mass("driven", stop, forces={"7/10": 1})
    left_out = certify.motion(system, {}, {"v": 0, "x": "1/4"}, "free", 3)
    whole = certify.motion(system, {}, ["1/4", 0, 1, 0], "free", 3)
    assert left_out.decided
    assert [time.mid for time in left_out.times] == [time.mid for time in whole.times]


def test_impacts_that_accumulate_are_proved_one_by_one():
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


def test_boundaries_that_are_multiples_are_reached_together():
    """No digits tell that x - 1 and 2 x - 2 vanish at one instant, their rows do."""
    data, start = dict(a="1/10", k="4", g="8", r="1/2"), ["0", "0"]
    alone = certify.motion(damped(), data, start, "free", 3)
    both = certify.motion(damped(Boundary("twice", 2 * x - 2)), data, start, "free", 3)
    assert both.sets == (("reaches-stop", "twice"),) * 3
    for one, other in zip(alone.times, both.times, strict=True):
        assert one.ball.overlaps(other.ball)


@pytest.mark.parametrize(("a", "k"), [("1/10", "4"), ("2", "1"), ("5", "4")])
def test_a_damped_mass_is_proved_to_come_to_rest(a, k):
    proof = certify.motion(damped(), dict(a=a, k=k, g="0", r="1/2"), ["1/2", "0"], "free", 1)
    assert proof.decided
    assert proof.transitions == 0
    assert proof.reason == "no boundary is reached any more"


@pytest.mark.parametrize("rate", [10**4, 10**6])
def test_a_motion_takes_a_unit_of_time_that_is_longer(rate):
    """Of a mass of some megahertz in seconds as much is proved as in its own unit."""

    def proved(rate):
        stop = RigidStop("x", at="1/1000", restitution="4/5")
        system = one_mass("struck", stop, stiffness=rate**2, damping=Fraction(rate, 10))
        return certify.motion(system, {}, [0, Fraction(rate, 100)], "free", 6)

    fast, slow = proved(rate), proved(1)
    assert fast.transitions == slow.transitions == 6
    for one, other in zip(fast.times, slow.times, strict=True):
        assert (one.ball * rate).overlaps(other.ball)


def test_the_arrival_behind_which_nothing_is_declared_is_enclosed():
    """At x = 1 with v < 9, where x'' = 2: after a time 1/sqrt(2), as x begins at 1/2."""
    one = Boundary("stop", x - 1)
    system = System(
        "falling", "", (x, v), (),
        (Configuration("free", SecondOrder([[1]], [[0]], (2,)), (one,)),),
        (Transition("free", {"stop"}, "free", (Condition(v - 9, "free"),), {v: -v}),),
    )  # fmt: skip
    proof = certify.motion(system, {}, ["1/2", 0], "free", 1)
    assert "no transition is declared for stop" in proof.reason
    with flint_precision(2 * proof.bits):
        assert proof.instant.contains(1 / arb(2).sqrt())
    assert 0 < float(proof.instant.rad) < 1e-30


def test_what_comes_and_goes_within_a_step_of_the_slow_forcing_is_not_missed():
    """The function (t - 1) (t - 2) (t - 30): no eigenvalue tells how soon it is zero."""
    p, q, u = sp.symbols("p q u", real=True)
    rates = sp.zeros(5)
    rates[0, 1] = rates[1, 2] = 1
    rates[4, 3], rates[3, 4] = sp.Rational(1, 1000), -sp.Rational(1, 1000)
    cubic = Configuration("cubic", FirstOrder(rates, (0, 0, 6, 0, 0)), (Boundary("passed", p),))
    passed = Transition("cubic", {"passed"}, "cubic")
    system = System("cubic", "", (p, q, u, c, s), (), (cubic,), (passed,))
    proof = certify.motion(system, {}, [-60, 92, -66, 1, 0], "cubic", 1)
    assert proof.decided
    assert proof.times[1].contains(1)


FALLING = [[0, 1, 0], [0, 0, -1]]
RISING = [[0, 1, 0], [0, 0, 1]]
DRIFTING = [[0, 1, 0], [0, 0, 0]]
CRITICAL = [[0, 1, 0], [-1, -2, 0]]
TURNING = [[0, 1, 0], [-1, 0, 0]]
RESONANT = [[0, 1, 0, 0, 0], [-1, 0, 1, 0, 0], [0, 0, 0, 1, 0], [0, 0, -1, 0, 0]]


@pytest.mark.parametrize(
    ("field", "start", "below", "stays"),
    [
        (FALLING, [-1, 0], 0, True),
        (RISING, [-1, -1], 0, False),
        (DRIFTING, [-1, 0], 0, True),
        (DRIFTING, [-1, 2.0**-20], 0, False),
        (CRITICAL, [0, 2.5], 1, True),  # at most 2.5/e
        (CRITICAL, [0, 3], 1, False),
        (TURNING, [1, 1], 2, True),  # at most sqrt(2)
        (TURNING, [2, 1], 2, False),
        (RESONANT, [0, 0, 0.125, 0], 5, False),  # it grows slowly
    ],
)
def test_what_stays_negative_for_ever_is_told_by_its_exponentials(field, start, below, stays):
    size = len(start)
    rows = [tuple(map(fmpq, row)) for row in (*field, [0] * (size + 1))]
    first = (fmpq(1), *[fmpq(0)] * (size - 1), fmpq(-below))
    with flint_precision(128):
        assert stays_negative(first, rows, [], [*map(arb, start)], arb(0)) == stays


def test_a_growing_motion_is_not_called_quiet():
    data = dict(a="-1/10", k="4", g="0", r="1/2")
    proof = certify.motion(damped(), data, ["1/100000", "0"], "free", 1)
    assert proof.transitions == 1
    assert float(proof.times[1]) > 100

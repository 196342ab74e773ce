"""What a clock of doubles cannot tell apart is one event; the order of boundaries tells nothing."""

import random
from functools import cache

import numpy as np
import pytest
import sympy as sp

import nonsmooth as ns
from nonsmooth.derive import (
    Boundary,
    Condition,
    Configuration,
    FirstOrder,
    Parameter,
    RigidStop,
    System,
    Transition,
)
from tests.one_mass import one_mass

START = {"x": 0, "v": "0.3", "c1": 1, "s1": 0}
FREQUENCY, SPEED = 1000, sp.Rational(1, 20)  # many radians pass before the event


@cache
def shaken(kind):
    """Two oscillators on one slope: the functions of both are zero at one instant.

    Together both are boundaries of `early`; else the first one's is. Then a phase without
    duration follows, and of the second one it is asked whether it rises then; or it is a
    boundary of what follows, where it falls from the zero that it has but for rounding.
    Or that phase begins beyond its boundary, whose function is known not to be zero.
    """
    u, a, _, p, _, k = states = sp.symbols("u a b p q k", real=True)
    height = sp.Symbol("height", positive=True)
    turns = sp.Matrix([[0, FREQUENCY], [-FREQUENCY, 0]])
    matrix = sp.diag(sp.zeros(1), turns, turns, sp.zeros(1))
    moving = FirstOrder(matrix, [SPEED, 0, 0, 0, 0, 0])
    first, second = a + u - height, p + 3 * u - 3 * height
    one, two, now = Boundary("one", first), Boundary("two", second), Boundary("now", k)
    back = FirstOrder(-matrix, [-SPEED, 0, 0, 0, 0, 0])
    names = ("right", "wrong") if kind.startswith("falls") else ("wrong", "right")
    fields = zip(names, (back, moving), strict=True)
    left = {"right": (two,)} if kind == "falls behind" else {}
    ends = tuple(Configuration(name, field, left.get(name, ())) for name, field in fields)
    if kind == "falls behind":
        begins = (Configuration("early", moving, (one,)),)
        transitions = Transition("early", {"one"}, "right"), Transition("right", {"two"}, "wrong")
    elif kind == "together":
        begins = (Configuration("early", moving, (one, two)),)
        transitions = (
            Transition("early", {"one"}, "wrong"),
            Transition("early", {"two"}, "wrong"),
            Transition("early", {"one", "two"}, "right"),
        )
    else:
        still = FirstOrder(sp.zeros(6), [0, 0, 0, 0, 0, 1])
        begins = Configuration("early", moving, (one,)), Configuration("still", still, (now,))
        rises = Condition(k if kind == "beyond" else second, along="right")
        transitions = (
            Transition("early", {"one"}, "still"),
            Transition("still", {"now"}, names[1], conditions=(rises,)),
            Transition("still", {"now"}, names[0]),
        )
    return System(
        name="shaken",
        description="two oscillators that a slope lifts",
        states=states,
        parameters=(Parameter("height", "of the slope"),),
        configurations=(*begins, *ends),
        transitions=transitions,
    )


@pytest.mark.parametrize("kind", ["together", "rises", "falls", "falls behind", "beyond"])
def test_what_is_zero_at_one_instant_is_one_event(kind, backend):
    rng, slow = np.random.default_rng(3), 4 if kind == "falls behind" else 2
    for height, angle in rng.uniform([1.8, 0], [2.2, 6], (8 if backend == "c" else slow, 2)):
        cosine, sine = np.cos(angle), np.sin(angle)
        start = dict(u=0, a=cosine, b=sine, p=3 * cosine, q=3 * sine, k=int(kind == "beyond"))
        motion = ns.simulate(shaken(kind), {"height": height}, start, until=30)
        assert motion.configurations[-1] == "right"


def test_a_top_is_reached_where_another_boundary_is_crossed(backend):
    x, a, _ = states = sp.symbols("x a b", real=True)
    moving = FirstOrder([[0, 0, 0], [0, 0, 1], [0, 0, 0]], [1, 0, -2])
    ends = Boundary("crossed", x - 1), Boundary("top", a, "reached")
    both = {end.name for end in ends}
    system = System(
        "topped", "", states, (),
        (Configuration("early", moving, ends), Configuration("late", moving, ())),
        (Transition("early", both, "late"),),
    )  # fmt: skip
    motion = ns.simulate(system, {}, {"x": 0, "a": -1, "b": 2}, until=2)
    assert motion.configurations == ("early", "late")


def struck(seed, *, far_first):
    """A forced mass, its stop at no binary fraction, and another one that it never reaches."""
    draw = random.Random(seed)
    place, restitution = (
        sp.Rational(draw.randint(1, 99), 97),
        sp.Rational(draw.randint(50, 99), 100),
    )
    near = RigidStop("x", place, restitution, name="near")
    far = RigidStop("x", -1000, 1, side="lower", name="far")
    return one_mass(
        "struck",
        *([far, near] if far_first else [near, far]),
        stiffness=sp.Rational(draw.randint(1, 30), 10),
        damping=sp.Rational(draw.randint(0, 20), 100),
        forces={sp.Rational(draw.randint(50, 300), 100): 3},
    )


@pytest.mark.parametrize("seed", range(6))
def test_a_boundary_that_begins_a_flight_is_known_wherever_it_is_listed(seed):
    """The motion does not depend on the order of the boundaries, to the last bit."""
    first, second = (
        ns.simulate(struck(seed, far_first=order), {}, START, transitions=300)
        for order in (False, True)
    )
    assert first.status == second.status
    np.testing.assert_array_equal(first.times, second.times)
    np.testing.assert_array_equal(first.states, second.states)

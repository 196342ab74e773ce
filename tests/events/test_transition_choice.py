"""One choice of transitions: doubles and balls agree, and so do mirror images and other orders."""

from dataclasses import replace
from functools import cache
from itertools import accumulate, islice, repeat

import numpy as np
import pytest
import sympy as sp

import nonsmooth as ns
from nonsmooth.derive import (
    Boundary,
    Condition,
    Configuration,
    FirstOrder,
    Harmonic,
    RigidStop,
    System,
    Transition,
    oscillator,
)
from nonsmooth.runtime.events.transition_choice import Decider
from nonsmooth.runtime.model.piecewise import piecewise
from nonsmooth.runtime.model.structure import TransitionShape
from nonsmooth.runtime.proof.statement import exact_system
from tests.engines import with_both
from tests.simulation.test_contact_law import SIGN, drawn

FRICTION = dict(chi="1/2", eta="1", V="1", us1="1", us2="3/4", ur1="3/2", ur2="5/4")
PLACE = sp.Rational(65, 64)  # which no swing of a drawn start just touches
STOP = dict(m1="1", m2="2", k1="1", k2="3/2", r="4/5")


@cache
def pair(coupling, law=None, order=1, sign=1):
    """Two masses that the mass matrix couples, each at a stop on a side; declared in an order."""
    side = "upper" if sign > 0 else "lower"
    both = [RigidStop(x, sign * PLACE, "1/2", side=side, name=f"at-{x}") for x in ("x1", "x2")]
    mass = sp.Matrix([[1, sp.Rational(coupling)], [sp.Rational(coupling), 2]])
    system = oscillator(
        "pair", ["x1", "x2"], mass, sp.eye(2), elements=both[::order], simultaneous_impacts=law
    )
    return system, {}


SYSTEMS = {
    "dry-friction": ("dry-friction", FRICTION),
    "rigid-stop": ("rigid-stop", STOP),
    "one by one": pair("0"),
    "coupled": pair("1/4"),
    "moreau": pair("1/4", "moreau"),
}


def state_where(rng, zero):
    """A random rational state at which rows vanish; None where there is none."""
    reduced, pivots = sp.Matrix([[sp.Rational(str(x)) for x in row] for row in zero]).rref()
    size = reduced.cols - 1
    if size in pivots:
        return None
    state = [sp.Rational(int(k), 16) for k in rng.integers(-20, 21, size)]
    for place, pivot in enumerate(pivots):
        free = [k for k in range(size) if k not in pivots]
        state[pivot] = -reduced[place, size] - sum(reduced[place, k] * state[k] for k in free)
    return state


def drawn_start(rng, system):
    """A configuration, and a state at some of its boundaries and rates of functions."""
    structure, exact = system.structure, system.exact
    source = int(rng.choice([c for c, t in enumerate(structure.transitions) if t]))
    listed = structure.transitions[source]
    reached = listed[int(rng.integers(len(listed)))].boundaries
    zero = [exact.rows[structure.boundaries[source][b].row] for b in reached]
    for _ in range(int(rng.integers(3))):
        row, field = (np.array(x[int(rng.integers(len(x)))]) for x in (exact.rows, exact.fields))
        rates = accumulate(repeat(field), np.matmul, initial=row)
        zero += islice(rates, int(rng.integers(1, 3)))
    return structure.configurations[source], state_where(rng, zero)


def told_by_all(system, data, state, where):
    """What follows the start, by proof; each engine says the same where that decides."""
    start = list(map(str, state))
    try:
        motions = with_both(ns.simulate, system, data, start, where, until=3, transitions=1)
    except ns.InputError:  # it belongs elsewhere, if anywhere
        return ("outside", None) if where is None else told_by_all(system, data, state, None)
    if motions[0].transitions == 0:  # what a proof takes long to see
        assert motions[1].transitions == 0
        return "late", None
    proof = ns.certify.motion(system, data, start, motions[0].configurations[0], 1)
    for motion in motions:
        if proof.decided:
            assert motion.configurations == proof.configurations
            assert [*map(set, motion.boundaries[1:])] == [*map(set, proof.sets)]
    return (motion.status.name if motion.end == 0 else "later"), motion.configurations[-1]


@pytest.mark.compiled
@pytest.mark.parametrize("name", SYSTEMS)
def test_every_arithmetic_makes_the_same_choice(name):
    system, data = SYSTEMS[name]
    exact, rng, seen = exact_system(system, data), np.random.default_rng(1), set()
    for _ in range(60):
        where, state = drawn_start(rng, exact)
        if state is not None:
            seen.add(told_by_all(system, data, state, where)[0])
    assert seen >= {"TRANSITIONS", "later"}


@pytest.mark.compiled
@pytest.mark.parametrize("sign", [1, -1])
@pytest.mark.parametrize("order", [1, 2, 3])
def test_a_start_passes_at_once_what_its_leading_derivative_leads_beyond(order, sign):
    """At a stop: with a speed, under a load, or a force that begins to grow."""
    system = oscillator(
        "at-a-stop", ["x"], [[1]], [[0]], load=[2 * sign * (order == 2)],
        forcing=[Harmonic(1, sine={"x": 1})], elements=[RigidStop("x", 0, "1/2", name="stop")],
    )  # fmt: skip
    start = [0, sign * (order == 1), sign if order == 3 else 1, 0]
    for motion in with_both(ns.simulate, system, {}, start, "free", until=0.1):
        assert (0 in motion.times[1:].tolist()) == (sign > 0)
    if sign > 0:
        assert ns.certify.motion(system, {}, start, "free", 1).sets == (("stop-reaches-stop",),)


@pytest.mark.compiled
@pytest.mark.slow
def test_balls_say_of_a_law_what_doubles_say():
    system, data = drawn(5, 2, range(2), SIGN), {"sign": "1"}
    exact = exact_system(system, data)
    structure, law, size = exact.structure, exact.structure.law, len(exact.structure.states)
    assert law is not None
    shapes = structure.boundaries[structure.configuration("stick-stick")]
    limits = [exact.exact.rows[b.row] for b in shapes if b.name in law.limits]
    # both at rest, at the beginning of the forcing
    given = [exact.exact.rows[contact.relative] for contact in law.contacts]
    given += [[int(k == j) for k in range(size)] + [-value] for j, value in ((4, 1), (5, 0))]
    rng, seen = np.random.default_rng(3), set()
    for _ in range(30):
        state = state_where(rng, [limits[int(rng.integers(len(limits)))], *given])
        if state is not None:
            seen.add(told_by_all(system, data, state, "stick-stick"))
    assert len({where for _, where in seen}) > 2


@pytest.mark.parametrize("speeds", [[1, 2], [0, 1]])
def test_stops_struck_together_have_no_order_and_no_side(speeds):
    found = []
    for sign in (1, -1):
        for order in (1, -1):
            system, data = pair("1/4", None, order, sign)
            start = [sign * x for x in (PLACE, PLACE, *speeds)]
            motion = ns.simulate(system, data, start, transitions=1)
            found.append((motion.status, *(sign * motion.states[-1]).round(13)))
    assert len({*found}) == 1


def test_what_an_error_of_the_time_moves_away_from_zero_is_zero():
    """Along either field: the one that led to the event, and the one behind it."""
    point = piecewise("dry-friction", FRICTION)
    decider = Decider(point.structure, point.fields, point.rows, point.resets)
    rng, error, told = np.random.default_rng(1), 1e-6, 0
    for case in range(80):
        source, along = rng.integers(len(point.fields), size=2).tolist()
        place = int(rng.integers(len(point.rows)))
        row, exact = point.rows[place], np.append(rng.normal(size=4), 1.0)
        if not row[:-1].any():
            continue
        exact[:-1] -= row[:-1] * (row @ exact) / (row[:-1] @ row[:-1])
        moved = np.append(point.fields[(source, along)[case % 2]] @ exact, 0.0)
        state = exact + error * rng.uniform(-0.9, 0.9) * moved
        rate = row[:-1] @ point.fields[along] @ exact
        if abs(row @ state) < 1e-9 or abs(rate) < 1e-2:
            continue
        for known, sign in ((error, np.sign(rate)), (0.0, np.sign(row @ state))):
            at = decider.located(source, state, known)
            found = at.leading(*decider.pair(place, along))
            assert found is not None
            assert found.sign == sign
            assert at.signs(row[None], abs(row)[None], point.fields[along]) == [sign]
        told += 1
    assert told > 20


def altered(*transitions):
    """Dry friction with other transitions, at a state where both masses reach the belt."""
    point = piecewise("dry-friction", FRICTION)
    listed = (transitions, *(() for _ in point.structure.configurations[1:]))
    structure = replace(point.structure, transitions=listed)
    known = np.array([0.5, 0.25, 1.0, 1.0, 1.0])
    return Decider(structure, point.fields, point.rows, point.resets), frozenset({0, 1}), known


def test_orders_in_which_nothing_or_something_else_follows_leave_it_open():
    both = frozenset({0, 1})
    never = ((0, 0, True), (0, 0, False))
    for conditions, target, verdict, options in (
        ((), 3, "chosen", ()),
        (never, 3, "ambiguous", (3,)),
        ((), 4, "ambiguous", (3, 4)),
    ):
        decider, reached, known = altered(
            TransitionShape(both, (), 0, 3, 1), TransitionShape(both, conditions, 0, target, 2)
        )
        found = decider.choice(0, reached, decider.located(0, known, 0.0))
        assert (found.verdict, found.options) == (verdict, options)
    alone = decider.choice(0, frozenset({0}), decider.located(0, known, 0.0))
    assert alone.verdict == "undeclared"


def test_a_row_that_is_known_to_be_zero_is_judged_by_its_rate():
    row = piecewise("dry-friction", FRICTION).structure.boundaries[0][0].row
    both = frozenset({0, 1})
    decider, reached, known = altered(
        TransitionShape(both, ((row, 0, True),), 0, 3), TransitionShape(both, (), 0, 4)
    )
    rate = decider.rows[row, :-1] @ decider.fields[0] @ known
    for sign in (1, -1):  # beyond the boundary by more than roundings, or before it
        off = known + np.array([0, 0, sign * 1e-9, 0, 0])
        at = decider.located(0, off, 0.0)
        told = [decider.choice(0, reached, at, zero) for zero in (frozenset({row}), frozenset())]
        targets = [choice.transition.target for choice in told if choice.transition]
        assert targets == [4 if rate < 0 else 3, 3 if sign > 0 else 4]


@pytest.mark.compiled
def test_within_the_error_of_an_events_time_all_happens_at_once():
    """A swing touches 1 while a clock comes to 0; that the clock is behind 0 is then not known."""
    x, u, _ = states = sp.symbols("x u w", real=True)
    swing = FirstOrder([[0, 0, 0], [0, 0, 1], [0, -1, 0]], [1, 0, 0])
    comes, touches = Boundary("comes", x), Boundary("touches", u - 1, acts_when="reached")
    ways = [Transition("on", own, "off") for own in ({"comes"}, {"touches"}, {"comes", "touches"})]
    late = Transition("on", {"touches"}, "late", (Condition(x, "late"),))
    rests = [Configuration(name, FirstOrder([[0] * 3] * 3), ()) for name in ("late", "off")]
    two, one = (
        System("clock", "", states, (), [Configuration("on", swing, watched), *rests], taken)
        for watched, taken in (([comes, touches], ways), ([touches], [late, ways[1]]))
    )
    for angle in np.random.default_rng(6).uniform(0, 1.2, 10):
        for system, early in ((two, 0), (one, 1e-4)):  # touched from below, or passed
            state = np.array([np.sin(angle), np.cos(angle)]) / np.cos(early)
            start = [angle + early - np.pi / 2, *state]
            for motion in with_both(ns.simulate, system, {}, start, transitions=1):
                assert motion.configurations[-1] == "off"
                assert system is one or motion.boundaries[-1] == ("comes", "touches")

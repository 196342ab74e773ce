"""One choice of transitions: floats, mpmath and balls agree, and so do mirror images."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from itertools import accumulate, repeat
from typing import Any

import numpy as np
import pytest
import sympy as sp
from flint import arb, arb_mat, fmpq
from mpmath import mp, mpf

from nonsmooth.derive import RigidStop, System, oscillator
from nonsmooth.runtime.checker.state_sets.entries import CarryingSystem, Entry, Unlisted
from nonsmooth.runtime.checker.state_sets.sets import StateSet, TooWide
from nonsmooth.runtime.checker.state_sets.switching import SwitchingSystem
from nonsmooth.runtime.checker.stated.exact import Elimination, Failure, product
from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.events.leading_derivative import Undecided
from nonsmooth.runtime.events.transition_choice import Decider, first_following
from nonsmooth.runtime.model.contacts.unfolding import Route, unfolded
from nonsmooth.runtime.model.kernels import kernels_of
from nonsmooth.runtime.model.piecewise import piecewise
from nonsmooth.runtime.model.structure import TransitionShape, mode_shapes
from nonsmooth.runtime.proof.exact_tables import ExactSystem, Row, exact_system
from nonsmooth.runtime.proof.sets.sections import whole_system
from nonsmooth.runtime.simulation.simulate import follow
from tests.certified import struck
from tests.large_systems import by_tables
from tests.simulation.test_contact_law import declared

FRICTION = dict(chi="1/2", eta="1", V="1", us1="1", us2="3/4", ur1="3/2", ur2="5/4")
STOP = dict(m1="1", m2="2", k1="1", k2="3/2", r="4/5")


def rational(rng: np.random.Generator) -> Any:
    return fmpq(int(rng.integers(-40, 41)), 16)


def state_where(rng: np.random.Generator, zero: list[Row]) -> list[Any] | None:
    """A random rational state at which rows vanish; None where there is none."""
    facts = Elimination().echelon(zero)
    if not all(any(row[:-1]) for row in facts):
        return None
    pivots = [next(k for k, x in enumerate(row) if x) for row in facts]
    state = [rational(rng) for _ in zero[0][:-1]]
    state = [0 * x if k in pivots else x for k, x in enumerate(state)]
    for row, pivot in zip(facts, pivots, strict=True):
        known = row[-1] + sum(x * y for x, y in zip(row, state, strict=False))
        state[pivot] = -known
    return state


def whole(state: list[Any]) -> list[Row]:
    size = len(state)
    return [(*(fmpq(int(i == j)) for j in range(size)), -x) for i, x in enumerate(state)]


def point_set(state: list[Any]) -> StateSet:
    """The set of (states, time, 1) of one state in balls."""
    column = [[x] for x in (*state, arb(0), arb(1))]
    return StateSet.of(arb_mat(column), arb_mat(len(column), 0), arb_mat(len(column), 1))


def proved(
    system: SwitchingSystem, source: str, reached: frozenset[str], facts: Any, state: list[Any]
) -> tuple[str, str | None]:
    """Verdict and target of what the checker says of boundaries, by facts and balls."""
    entry = Entry(CarryingSystem(system), source, facts)
    try:
        _, behind = entry.behind(reached, point_set(state), at_once=True)
    except TooWide:
        return "undecided", None
    except Unlisted:
        return "undeclared", None
    except Failure:
        return "ambiguous", None
    return "chosen", behind.here


def floats(numbers: Any) -> np.ndarray:
    exact = np.array(numbers, dtype=object)
    return np.array([int(x.p) / int(x.q) for x in exact.flat]).reshape(exact.shape)


def mpfs(numbers: Any) -> np.ndarray:
    exact = np.array(numbers, dtype=object)
    found = np.empty(exact.size, dtype=object)
    found[:] = [mpf(int(x.p)) / int(x.q) for x in exact.flat]
    return found.reshape(exact.shape)


def rates(row: Row, field: Any, count: int) -> list[Row]:
    """A row with its derivatives along a field."""
    return list(accumulate(repeat(field, count - 1), product, initial=row))


def exact_leading(row: Row, field: Any, state: list[Any]) -> tuple[int, int]:
    """Order and sign of the first derivative that is not zero; -1 and 0 for none."""
    for order, derivative in enumerate(rates(row, field, len(row))):
        value = derivative[-1] + sum(x * y for x, y in zip(derivative, state, strict=False))
        if value:
            return order, 1 if value > 0 else -1
    return -1, 0


def sign_told(row: Any, before: Any, behind: Any, state: Any, error: float, *unit: Any) -> int:
    """What a decider takes a function's sign for behind an event, where another field is."""
    size = len(row) - 1
    conditions = ((0, 1, True),), ((1, 1, True),), ()
    transitions = [TransitionShape(frozenset({0}), c, 0, 1 + k) for k, c in enumerate(conditions)]
    rows, resets = np.array([row, -row]), np.eye(size, size + 1)[None]
    table = by_tables(
        "told", np.zeros((4, size, size + 1)), rows, resets,
        [[("there", 0, False)], [], [], []], [transitions, [], [], []],
        [(mode_shapes([(1, False)]), np.zeros((1, 2)), resets)] * 4,
    )  # fmt: skip
    decider = Decider(table.structure, np.array([before, *[behind] * 3]), rows, resets, *unit)
    at = decider.located(0, state, error)
    found = decider.choice(0, frozenset({0}), at).transition
    assert found is not None
    sign = (1, -1, 0)[found.target - 1]
    # as of many functions at once, which the law of contacts asks for
    assert at.signs(rows, abs(rows), behind).tolist() == [sign, -sign]
    return sign


def test_the_sign_of_the_leading_derivative_is_the_same_in_every_arithmetic() -> None:
    rng, seen = np.random.default_rng(0), set()
    for case in range(200):
        size = int(rng.integers(2, 6))
        entries = rng.integers(-3, 4, (size, size + 1)) * (rng.random((size, size + 1)) < 0.6)
        field = [tuple(map(fmpq, row)) for row in [*entries.tolist(), [0] * (size + 1)]]
        row = tuple(map(fmpq, rng.integers(-3, 4, size + 1).tolist()))
        zero = rates(row, field, 1 + case % (size + 1))[: case % (size + 1)]
        state = state_where(rng, zero or [tuple(fmpq(0) for _ in row)])
        if state is None:
            continue
        order, sign = exact_leading(row, field, state)
        seen.add(order)
        for numbers, unit in ((floats, 2.0**-48), (mpfs, 16 * mp.eps)):
            own, along, here = numbers(row), numbers(field[:-1]), numbers([*state, fmpq(1)])
            assert sign_told(own, along, along, here, 0.0, unit) == sign
    assert seen >= {-1, 0, 1, 2, 3}


def test_what_an_error_of_the_time_moves_away_from_zero_is_zero() -> None:
    """Along either field: the one that led to the event, and the one behind it."""
    rng, error = np.random.default_rng(1), 1e-6
    for case in range(60):
        size = int(rng.integers(2, 6))
        before, behind = rng.normal(size=(2, size, size + 1))
        row, exact = rng.normal(size=size + 1), np.append(rng.normal(size=size), 1.0)
        row[-1] -= row @ exact
        field = (before, behind)[case % 2]
        state = exact + error * rng.uniform(-0.9, 0.9) * np.append(field @ exact, 0.0)
        rate = row @ np.append(behind @ exact, 0.0)
        if abs(row @ (state - exact)) < 1e-9 or abs(rate) < 1e-2:
            continue
        assert sign_told(row, before, behind, state, error) == np.sign(rate)
        assert sign_told(row, before, behind, state, 0.0) == np.sign(row @ state)


@cache
def systems() -> dict[str, ExactSystem]:
    return {
        "dry-friction": exact_system("dry-friction", FRICTION),
        "rigid-stop": exact_system("rigid-stop", STOP),
        "one by one": exact_system(struck(), {"c": "0"}),
        "coupled": exact_system(struck(), {"c": "1/4"}),
        "moreau": exact_system(struck("moreau"), {"c": "1/4"}),
    }


def drawn_set(rng: np.random.Generator, structure: Any) -> tuple[int, frozenset[int]]:
    """A configuration and a set of its boundaries for which something is listed."""
    source = int(rng.choice([c for c, t in enumerate(structure.transitions) if t]))
    found = structure.transitions[source]
    return source, found[int(rng.integers(len(found)))].boundaries


def told_of(choice: Any) -> tuple[Any, ...]:
    transition = choice.transition
    return choice.verdict, choice.options, transition and (transition.target, transition.reset)


def target_of(structure: Any, choice: Any) -> str | None:
    transition = choice.transition
    return None if transition is None else str(structure.configurations[transition.target])


@pytest.mark.parametrize("name", ["dry-friction", "rigid-stop", "one by one", "coupled", "moreau"])
def test_every_arithmetic_makes_the_same_choice(name: str) -> None:
    system = systems()[name]
    structure, exact, stated = system.structure, system.exact, whole_system(system)
    cut = ([f[:-1] for f in exact.fields], exact.rows, [r[:-1] for r in exact.resets])
    deciders = [
        Decider(structure, *map(floats, cut)),
        Decider(structure, *map(mpfs, cut), 16 * mp.eps),
    ]
    rng, seen = np.random.default_rng(1), set()
    for case in range(60):
        source, boundaries = drawn_set(rng, structure)
        rows = frozenset(structure.boundaries[source][b].row for b in boundaries)
        zero = [exact.rows[row] for row in rows]
        for _ in range(case % 4):  # and some derivative of some row besides
            row, along = exact.rows[int(rng.integers(len(exact.rows)))], rng.integers(len(cut[0]))
            zero += rates(row, exact.fields[int(along)], int(rng.integers(1, 3)))
        state = state_where(rng, zero)
        if state is None:
            continue
        found = []
        for decider, numbers in zip(deciders, (floats, mpfs), strict=True):
            at = decider.located(source, numbers([*state, fmpq(1)]), 0.0)
            found.append(decider.choice(source, boundaries, at, rows))
        assert len({told_of(choice) for choice in found}) == 1
        seen.add(found[0].verdict)
        by_floats = found[0].verdict, target_of(structure, found[0])
        names = frozenset(structure.boundaries[source][b].name for b in boundaries)
        with flint_precision(128):
            here, balls = structure.configurations[source], [arb(x) for x in state]
            assert proved(stated, here, names, whole(state), balls) == by_floats
            wide = [x + arb(0, 2.0**-40) for x in balls]
            facts = Elimination().echelon(zero[: len(rows)])
            less = proved(stated, here, names, facts, wide)
        if less[0] == "chosen":  # exact agreement of resets may need what is left out
            assert less == by_floats
        seen.add(less[0])
    assert seen >= {"chosen", "ambiguous" if name == "coupled" else "chosen"}


@pytest.mark.usefixtures("backend")
def test_a_start_reaches_at_once_what_its_leading_derivative_leads_beyond() -> None:
    system, point = systems()["dry-friction"], piecewise("dry-friction", FRICTION)
    stated, structure = CarryingSystem(whole_system(system)), system.structure
    rng, seen = np.random.default_rng(2), set()
    for case in range(200):
        c = int(rng.integers(len(point.structure.configurations)))
        shapes, field = point.structure.boundaries[c], system.exact.fields[c]
        row = system.exact.rows[shapes[int(rng.integers(len(shapes)))].row]
        state = state_where(rng, rates(row, field, 1 + case % 3))
        if state is None:
            continue
        told = [exact_leading(system.exact.rows[shape.row], field, state) for shape in shapes]
        found = follow(point, floats(state), c, 1.0, 1)
        reached = sum(1 << b for b, (_, sign) in enumerate(told) if sign > 0)
        assert (len(found.times) > 1 and found.times[1] == 0) == (reached > 0)
        assert not reached or found.sets[1] == reached
        told_names = {s.name for s, (_, sign) in zip(shapes, told, strict=True) if sign > 0}
        with flint_precision(128):
            entry = Entry(stated, structure.configurations[c], whole(state))
            assert entry.passed(point_set([arb(x) for x in state])) == told_names
        seen |= {*told}
    assert len(seen) > 4


def law_choices(system: System, sign: int, cases: list[tuple[list[float], str, str]]) -> list[Any]:
    point = piecewise(system, {"sign": sign})
    structure = point.structure
    decider = Decider(structure, point.fields, point.rows, point.resets)
    found = []
    for state, source, boundary in cases:
        place = structure.configuration(source)
        reached = frozenset({structure.boundary(place, boundary)})
        at = decider.located(place, np.array([*state, 1.0]), 0.0)
        found.append(decider.choice(place, reached, at))
    return found


@pytest.mark.slow
def test_balls_say_of_a_law_what_floats_say() -> None:
    kernels = kernels_of(declared(5, 2, [0, 1]))
    system = exact_system(kernels, {"sign": "1"})
    structure, exact, law = system.structure, system.exact, system.structure.law
    assert law is not None
    cut = ([f[:-1] for f in exact.fields], exact.rows, [r[:-1] for r in exact.resets])
    decider = Decider(structure, *map(floats, cut))
    source = structure.configuration("stick-stick")
    boundaries = [b for b, s in enumerate(structure.boundaries[source]) if s.name in law.limits]
    rng, decided = np.random.default_rng(3), set()
    for _ in range(30):
        reached = boundaries[int(rng.integers(len(boundaries)))]
        shape = structure.boundaries[source][reached]
        relative = [exact.rows[c.relative] for c in law.contacts]
        state = state_where(rng, [exact.rows[shape.row], *relative])
        if state is None:
            continue
        event = law.event(source, [shape.name])
        assert event is not None
        at = decider.located(source, floats([*state, fmpq(1)]), 0.0)
        outcome = decider.outcome(event, at)
        targets = [structure.configurations[target] for target in outcome.targets]
        routes = [
            Route("stick-stick", (shape.name,), target, path)
            for target, path in zip(targets, outcome.paths, strict=True)
        ]
        stated = whole_system(exact_system(unfolded(kernels, routes), {"sign": "1"}))
        with flint_precision(128):
            balls = [arb(x) for x in state]
            told = proved(stated, "stick-stick", frozenset({shape.name}), whole(state), balls)
        assert told[0] in ("chosen", "undecided")
        if told[0] == "chosen":
            assert [told[1]] == targets
            decided.add(told[1])
    assert len(decided) > 2


def mirrored(name: str) -> str:
    swaps = {"slip": "overshoot", "overshoot": "slip", "forward": "backward", "backward": "forward"}
    return "-".join(swaps.get(part, part) for part in name.split("-"))


@pytest.mark.slow
def test_the_law_says_the_same_of_mirrored_and_reordered_declarations() -> None:
    seed = count = 2
    order = list(range(count))
    plain, other = (declared(seed, count, o) for o in (order, order[::-1]))
    point = piecewise(plain, {"sign": 1})
    law = point.structure.law
    assert law is not None
    directions = np.array([point.rows[c.relative][count : 2 * count] for c in law.contacts])
    at_rest = np.linalg.solve(directions, [-point.rows[c.relative][-1] for c in law.contacts])
    rng = np.random.default_rng(seed)
    stuck = "-".join(["stick"] * count)
    shapes = point.structure.boundaries[point.structure.configuration(stuck)]
    boundaries = [b.name for b in shapes if b.name in law.limits]
    cases, images = [], []
    for _ in range(40):
        state = np.array([*rng.normal(size=count) * 0.6, *at_rest])
        boundary = boundaries[int(rng.integers(len(boundaries)))]
        cases.append(([*state, 1.0, 0.0], stuck, boundary))
        images.append(([*-state, 1.0, 0.0], stuck, mirrored(boundary)))
    names = {}
    for key, system, sign, given in (
        ("plain", plain, 1, cases), ("order", other, 1, cases), ("mirror", plain, -1, images),
    ):  # fmt: skip
        configurations = piecewise(system, {"sign": sign}).structure.configurations
        names[key] = [
            (c.verdict, c.transition and configurations[c.transition.target])
            for c in law_choices(system, sign, given)
        ]
    assert [(v, n and "-".join(n.split("-")[::-1])) for v, n in names["order"]] == names["plain"]
    assert [(v, n and mirrored(n)) for v, n in names["mirror"]] == names["plain"]
    assert len(set(names["plain"])) > 3


def hit(reverse: bool, sign: int, at: list[float]) -> tuple[str, list[float]]:
    """Verdict and state behind two coupled stops that are struck together."""
    low = sign < 0
    pair = [
        RigidStop("x1", sign, "1/2", side="lower" if low else "upper", name="a"),
        RigidStop("x2", sign, "1/2", side="lower" if low else "upper", name="b"),
    ]
    system = oscillator(
        "hit", ["x1", "x2"], sp.Matrix([[1, "1/4"], ["1/4", 2]]), sp.eye(2),
        elements=pair[::-1] if reverse else pair,
    )  # fmt: skip
    point = piecewise(system, {})
    structure = point.structure
    decider = Decider(structure, point.fields, point.rows, point.resets)
    source = structure.configuration("free-free")
    known = np.array([sign * x for x in at] + [1.0])
    found = decider.choice(source, frozenset({0, 1}), decider.located(source, known, 0.0))
    if found.transition is None:
        return found.verdict, []
    return found.verdict, (sign * (point.resets[found.transition.reset] @ known)).tolist()


@pytest.mark.parametrize("state", [[1.0, 1.0, 1.0, 2.0], [1.0, 1.0, 0.0, 1.0]])
def test_stops_struck_together_have_no_order_and_no_side(state: list[float]) -> None:
    expected, behind = hit(False, 1, state)
    for reverse in (False, True):
        for sign in (1, -1):
            verdict, after = hit(reverse, sign, state)
            assert verdict == expected
            np.testing.assert_allclose(after, behind, atol=1e-14)


def altered(*transitions: TransitionShape) -> tuple[Decider, frozenset[int], np.ndarray]:
    """Dry friction with other transitions, at a state where both masses reach the belt."""
    point = piecewise("dry-friction", FRICTION)
    none: tuple[TransitionShape, ...] = ()
    listed = (transitions, *(none for _ in point.structure.configurations[1:]))
    structure = replace(point.structure, transitions=listed)
    known = np.array([0.5, 0.25, 1.0, 1.0, 1.0])
    return Decider(structure, point.fields, point.rows, point.resets), frozenset({0, 1}), known


def test_an_order_in_which_nothing_follows_leaves_it_open() -> None:
    both = frozenset({0, 1})
    never = ((0, 0, True), (0, 0, False))
    for conditions, verdict in (((), "chosen"), (never, "ambiguous")):
        decider, reached, known = altered(
            TransitionShape(both, (), 0, 3, 1), TransitionShape(both, conditions, 0, 3, 2)
        )
        found = decider.choice(0, reached, decider.located(0, known, 0.0))
        assert found.verdict == verdict
    assert found.options == (3,)
    alone = decider.choice(0, frozenset({0}), decider.located(0, known, 0.0))
    assert alone.verdict == "undeclared"


def test_a_row_that_is_known_to_be_zero_is_judged_by_its_rate() -> None:
    row = piecewise("dry-friction", FRICTION).structure.boundaries[0][0].row
    both = frozenset({0, 1})
    decider, reached, known = altered(
        TransitionShape(both, ((row, 0, True),), 0, 3), TransitionShape(both, (), 0, 4)
    )
    for sign in (1, -1):  # beyond the boundary by more than roundings, or before it
        off = known + np.array([0, 0, sign * 1e-9, 0, 0])
        at = decider.located(0, off, 0.0)
        told = [decider.choice(0, reached, at, zero) for zero in (frozenset({row}), frozenset())]
        targets = [choice.transition.target for choice in told if choice.transition]
        assert targets == [4 if rate(decider, row, known) < 0 else 3, 3 if sign > 0 else 4]


def rate(decider: Decider, row: int, known: np.ndarray) -> float:
    return float(decider.rows[row, :-1] @ decider.fields[0] @ known)


class Given:
    def __init__(self, *conditions: tuple[float, bool]) -> None:
        self.conditions = conditions


def test_what_is_open_matters_only_where_nothing_refutes_it() -> None:
    def sign(value: float) -> int:
        if np.isnan(value):
            raise Undecided("open")
        return int(np.sign(value))

    nan, holds = float("nan"), Given((0.5, True), (0.0, False))
    refuted, doubtful = Given((nan, True), (1.0, False)), Given((1.0, True), (nan, False))
    assert first_following([refuted, holds, doubtful], sign) == (holds, None)
    found, trouble = first_following([refuted, doubtful, holds], sign)
    assert found is doubtful
    assert trouble is not None
    assert first_following([refuted], sign) == (None, None)

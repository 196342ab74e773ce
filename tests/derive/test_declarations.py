"""Declarations: checked when made, right about signs, and the dry friction's own rules."""

from __future__ import annotations

import random
from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
import sympy as sp
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from nonsmooth.derive import (
    Boundary,
    Condition,
    Configuration,
    FirstOrder,
    Parameter,
    Presentation,
    SecondOrder,
    System,
    Transition,
)
from nonsmooth.derive.declaration.parameter import is_positive
from nonsmooth.derive.systems import dry_friction

X, Y, V, W = STATES = sp.symbols("x y v w", real=True)
K, G = Parameter("k", "stiffness"), Parameter("g", "load")
KS, GS = K.symbol, G.symbol
STRANGER = sp.Symbol("stranger")

PROPERTY = settings(max_examples=40)


def test_rotations_of_an_itinerary_are_cyclic_and_have_no_source() -> None:
    orbit = dry_friction.global_stick
    count = len(orbit.phases)
    assert orbit.rotated(count) == orbit == orbit.rotated(-count)
    assert orbit.rotated(1).phases == (*orbit.phases[1:], orbit.phases[0])
    assert orbit.rotated(1).rotated(2) == orbit.rotated(3)
    assert orbit.source is not None
    assert orbit.rotated(1).source is None


def test_declarations_are_frozen_and_floats_are_decimals() -> None:
    motion = SecondOrder([[1]], [[0.2]], (1e-3,))
    tenth, fifth, thousandth = sp.Rational(1, 10), sp.Rational(1, 5), sp.Rational(1, 1000)
    boundary = Boundary("far", 0.1 * X - 0.3)
    assert boundary.function == tenth * X - sp.Rational(3, 10)
    assert motion.stiffness == sp.Matrix([[fifth]])
    assert motion.load == sp.Matrix([thousandth])
    assert Parameter("k", "", 0.5, 1).lower == sp.Rational(1, 2)
    with pytest.raises(AttributeError):
        boundary.name = "other"


# --- signs on whole domains -------------------------------------------------------------

DOMAINS = (
    Parameter("a", "", 0, 1),
    Parameter("b", ""),
    Parameter("c", "", closed=True),
    Parameter("d", "", -2, 3),
    Parameter("m", "", -sp.oo, -1),
    Parameter("f", "", -sp.oo, sp.oo),
)
A, B, C, D, M, F = (p.symbol for p in DOMAINS)


@pytest.mark.parametrize(
    "expression",
    [
        A, 1 - A, B, B + C, C + 1, D + 2, 3 - D, -M, -1 - M, 6 + D - D**2, A / (1 - A),
        (1 - A) * B / (1 + C), 1 + F**2, sp.Integer(3), sp.sqrt(B), sp.sqrt(2) - 1,
        (1 - A * B) ** 2 + 4 * A**2 * B, -B / (A - 1), 1 + A * B, B - M, A - A**2,
    ],
    ids=str,
)  # fmt: skip
def test_positive_on_the_whole_domain_is_shown(expression: sp.Expr) -> None:
    assert is_positive(expression, DOMAINS)


@pytest.mark.parametrize(
    "expression",
    [
        C, B - A, A - 1, D, F, F**2, sp.Integer(0), -B, 2 * A - 1, 2 - B, B * C, M, M + 2,
        (A - sp.Rational(1, 2)) ** 2, STRANGER, B + STRANGER, sp.sqrt(B) - 1, D + 1, 1 / (A - 2),
    ],
    ids=str,
)  # fmt: skip
def test_what_is_not_positive_everywhere_is_not_shown(expression: sp.Expr) -> None:
    assert not is_positive(expression, DOMAINS)


def inside(parameter: Parameter, unit: Fraction) -> sp.Expr:
    """A rational point of a domain, from a number in (0, 1); ends that belong come up too."""
    lower, upper = parameter.lower, parameter.upper
    u = sp.Rational(unit.numerator, unit.denominator)
    if parameter.closed and unit < Fraction(1, 10):
        return lower
    if lower.is_finite and upper.is_finite:
        return lower + (upper - lower) * u
    if lower.is_finite:
        return lower + u / (1 - u)
    if upper.is_finite:
        return upper - u / (1 - u)
    return (2 * u - 1) / (u * (1 - u))


coefficients = st.integers(-3, 3)
polynomials = st.lists(
    st.tuples(coefficients, st.lists(st.integers(0, 5), max_size=3)), min_size=1, max_size=4
).map(lambda terms: sp.Add(*(c * sp.Mul(*((A, B, C, D, M, F)[i] for i in t)) for c, t in terms)))
units = st.fractions(Fraction(1, 1000), Fraction(999, 1000), max_denominator=1000)


@pytest.mark.slow
@settings(PROPERTY, max_examples=15)
@given(polynomials, polynomials, st.lists(st.tuples(*[units] * 6), min_size=4, max_size=4))
def test_true_is_a_proof(numerator: sp.Expr, denominator: sp.Expr, points: list[Any]) -> None:
    assume(denominator != 0)
    expression = numerator / denominator
    if is_positive(expression, DOMAINS):
        for point in points:
            values = {p.symbol: inside(p, u) for p, u in zip(DOMAINS, point, strict=True)}
            assert expression.subs(values) > 0


# --- presentations ----------------------------------------------------------------------


def numbers(parameters: Sequence[Parameter], source: random.Random) -> dict[sp.Symbol, sp.Expr]:
    return {p.symbol: inside(p, Fraction(source.randint(1, 99), 100)) for p in parameters}


def same_system_shifted(system: System, presentation: Presentation, seed: int) -> None:
    """Vector fields, boundaries, conditions and resets agree at corresponding states."""
    source = random.Random(seed)
    presented = presentation.present(system)
    # numbers for the parameters of the presented system fix those of the original one
    values = numbers(presented.parameters, source)
    original = values | {s: e.subs(values) for s, e in presentation.substitution.items()}
    origin = sp.Matrix(presentation.origin).subs(original)
    state = sp.Matrix([sp.Rational(source.randint(-99, 99), 10) for _ in system.states])
    at_old = original | dict(zip(system.states, state + origin, strict=True))
    at_new = values | dict(zip(presented.states, state, strict=True))
    for old, new in zip(system.configurations, presented.configurations, strict=True):
        matrix, offset = old.dynamics.field(system.states)
        field = (matrix * (state + origin) + offset).subs(original)
        matrix, offset = new.dynamics.field(presented.states)
        assert (matrix * state + offset).subs(values) == field
        assert old.name == new.name
        for one, other in zip(old.boundaries, new.boundaries, strict=True):
            assert (one.name, one.acts_when) == (other.name, other.acts_when)
            assert one.function.subs(at_old) == other.function.subs(at_new)
    for old, new in zip(system.transitions, presented.transitions, strict=True):
        assert (old.source, old.target, old.boundaries) == (new.source, new.target, new.boundaries)
        before = old.reset_of(state + origin, system.states).subs(original)
        assert new.reset_of(state, presented.states).subs(values) == before - origin
        for one, other in zip(old.conditions, new.conditions, strict=True):
            assert (one.along, one.holds) == (other.along, other.holds)
            assert one.function.subs(at_old) == other.function.subs(at_new)
    for one, other in zip(system.constraints, presented.constraints, strict=True):
        assert one.subs(original) == other.subs(values)


@pytest.mark.slow
def test_the_shifted_dry_friction_is_the_same_motion() -> None:
    same_system_shifted(dry_friction.system, dry_friction.shifted, seed=1)


@pytest.mark.parametrize("seed", range(3))
def test_resets_first_order_motions_and_new_parameters_are_shifted_too(seed: int) -> None:
    double = Parameter("double", "twice the load", closed=True)
    swing = Configuration(
        "swing", SecondOrder([[1]], [[KS]], (GS,), [[1]]), (Boundary("far", X - KS),)
    )
    stiff = Configuration("stiff", FirstOrder([[0, 1], [-KS, -1]], (GS, 1)), ())
    over = Transition(
        "swing", {"far"}, "stiff", (Condition(X - GS, "stiff"),), {X: -X + 1, V: 2 * X - V}
    )
    system = System("one", "", (X, V), (K, G), (swing, stiff), (over,), (KS - GS,))
    presentation = Presentation((Y, W), (GS / KS, 0), (double,), {GS: double.symbol / 2})
    same_system_shifted(system, presentation, seed)
    assert GS not in {p.symbol for p in presentation.present(system).parameters}


# --- dry friction -----------------------------------------------------------------------


def field(configuration: str, values: dict[str, float]) -> Callable[[np.ndarray], np.ndarray]:
    """Motion of the two masses, from Newton's law: the test's own equations."""
    first, second = configuration.split("-")
    signs = {"slip": 1, "overshoot": -1}

    def rate(y: np.ndarray) -> np.ndarray:
        x1, x2, v1, v2 = y
        a1 = signs.get(first, 0) * values["us1"] - x1 + values["chi"] * x2
        a2 = values["eta"] * (signs.get(second, 0) * values["us2"] - values["chi"] * (x2 - x1))
        return np.array([v1, v2, 0 if first == "stick" else a1, 0 if second == "stick" else a2])

    return rate


def leading(function: sp.Expr, along: str, state: dict[str, Fraction], values: Any) -> Fraction:
    """First nonzero among g, g', g'', ... along a configuration's motion, else zero; exact."""
    rate = field(along, values)
    y = np.array([state[s] for s in ("x1", "x2", "v1", "v2")], dtype=object)
    zero = np.array([Fraction(0)] * 4, dtype=object)
    subs = {s: sp.Rational(values[s.name]) for s in function.free_symbols if s.name in values}
    row = [Fraction(str(sp.diff(function, s).subs(subs))) for s in dry_friction.states]
    constant = Fraction(str(function.subs(subs).subs(dict.fromkeys(dry_friction.states, 0))))
    value = constant + sum(a * b for a, b in zip(row, y, strict=True))
    derivative = rate(y)
    for _ in range(9):  # a motion in four dimensions: beyond, all vanish
        if value != 0:
            return value
        value = sum((a * b for a, b in zip(row, derivative, strict=True)), Fraction(0))
        derivative = rate(derivative) - rate(zero)  # the field is affine
    return Fraction(0)


def declared(source: str, boundaries: set[str], state: Any, values: Any) -> Transition:
    """The first transition of the declaration whose conditions hold."""
    for transition in dry_friction.system.transitions:
        if (transition.source, transition.boundaries) == (source, boundaries) and all(
            (leading(c.function, c.along, state, values) > 0) == c.holds
            for c in transition.conditions
        ):
            return transition
    raise AssertionError("no transition applies")


def regime(force: Fraction, slope: Fraction, limit: Fraction) -> str:
    """Rule of the source for a mass at the belt: its force, the force's first nonzero slope."""
    if abs(force) < limit or (abs(force) == limit and slope * force <= 0):
        return "stick"
    return "slip" if force > 0 else "overshoot"


VALUES: dict[str, Any] = {
    "chi": Fraction(1, 2), "eta": Fraction(1), "V": Fraction(1),
    "us1": Fraction(1), "ur1": Fraction(3), "us2": Fraction(1), "ur2": Fraction(2),
}  # fmt: skip


def at_belt(f1: Any, f2: Any, values: Any = VALUES) -> dict[str, Fraction]:
    """Both masses at the belt's velocity under given friction forces."""
    # f1 = x1 - chi x2, f2 = chi (x2 - x1)
    chi = values["chi"]
    x1 = (Fraction(f1) + Fraction(f2)) / (1 - chi)
    return {"x1": x1, "x2": x1 + Fraction(f2) / chi, "v1": values["V"], "v2": values["V"]}


forces = st.integers(-45, 45).map(lambda n: Fraction(n, 10)) | st.sampled_from(
    [Fraction(n) for n in (-3, -2, 0, 2, 3)]  # the limits themselves
)


@settings(PROPERTY, max_examples=60)
@given(
    forces, forces, st.fractions(Fraction(1, 10), Fraction(9, 10), max_denominator=10),
    st.sampled_from([Fraction(1, 2), Fraction(3, 2)]),
)  # fmt: skip
def test_at_the_belt_the_force_and_its_first_slope_decide(
    f1: Fraction, f2: Fraction, chi: Fraction, speed: Fraction
) -> None:
    """Of both masses at one instant, of each beside the other, and where one breaks away."""
    values = VALUES | {"chi": chi}
    belt, limit1, limit2 = values["V"], values["ur1"], values["ur2"]
    state = at_belt(f1, f2, values)
    first = regime(f1, belt * (1 - chi), limit1)
    # f2' = chi (V - v1) = 0 and f2'' = -chi a1, zero while the first mass sticks
    friction = {"slip": values["us1"], "overshoot": -values["us1"]}
    slope = -chi * (friction[first] - f1) if first in friction else Fraction(0)
    targets = first, regime(f2, slope, limit2)
    both = {"first-reaches-belt", "second-reaches-belt"}
    transition = declared("slip-slip", both, state, values)
    assert transition.target == "-".join(targets)
    velocities = zip((dry_friction.v1, dry_friction.v2), targets, strict=True)
    stuck = [velocity for velocity, target in velocities if target == "stick"]
    assert dict(transition.reset) == dict.fromkeys(stuck, dry_friction.V)
    for source in ("slip-stick", "overshoot-stick"):
        transition = declared(source, {"first-reaches-belt"}, at_belt(f1, 0, values), values)
        assert transition.target == f"{first}-stick"
    for source in ("slip-slip", "slip-overshoot"):
        transition = declared(source, {"second-reaches-belt"}, state | {"v1": speed}, values)
        assert transition.target == f"slip-{regime(f2, chi * (belt - speed), limit2)}"
    for mass, pair, target in (
        ("first", (f1, 0), f"{first}-stick"),
        ("second", (0, f2), f"stick-{regime(f2, Fraction(0), limit2)}"),
    ):
        way = "forward" if sum(pair) > 0 else "backward"
        state = at_belt(*pair, values)
        assert declared("stick-stick", {f"{mass}-breaks-{way}"}, state, values).target == target


@pytest.mark.parametrize("configuration", [c.name for c in dry_friction.system.configurations])
def test_every_configuration_obeys_newtons_law(configuration: str) -> None:
    source = random.Random(configuration)
    values = {name: Fraction(source.randint(1, 19), 20) for name in VALUES}
    state = np.array([Fraction(source.randint(-20, 20), 7) for _ in range(4)], dtype=object)
    dynamics = dry_friction.system.configuration(configuration).dynamics
    matrix, offset = dynamics.field(dry_friction.states)
    found = matrix * sp.Matrix([sp.Rational(str(s)) for s in state]) + offset
    subs = {s: sp.Rational(str(values[s.name])) for s in found.free_symbols}
    expected = field(configuration, values)(state)
    assert [Fraction(str(e.subs(subs))) for e in found] == list(expected)

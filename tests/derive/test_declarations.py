"""Declarations: checked when made, right about signs, and the same from another origin."""

import random
from fractions import Fraction

import pytest
import sympy as sp
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from nonsmooth.derive import (
    Boundary,
    Condition,
    Configuration,
    DeclarationError,
    FirstOrder,
    Parameter,
    Presentation,
    SecondOrder,
    SoftStop,
    System,
    Transition,
    dry_friction,
)
from tests.one_mass import one_mass

X, Y, V, W = STATES = sp.symbols("x y v w", real=True)
K, G = Parameter("k", "stiffness"), Parameter("g", "load")
KS, GS = K.symbol, G.symbol

PROPERTY = settings(max_examples=40)


def test_rotations_of_an_itinerary_are_cyclic_and_have_no_source():
    orbit = dry_friction.global_stick
    count = len(orbit.phases)
    assert orbit.rotated(count) == orbit == orbit.rotated(-count)
    assert orbit.rotated(1).phases == (*orbit.phases[1:], orbit.phases[0])
    assert orbit.rotated(1).rotated(2) == orbit.rotated(3)
    assert orbit.source is not None
    assert orbit.rotated(1).source is None


def test_declarations_are_frozen_and_floats_are_decimals():
    motion = SecondOrder([[1]], [[0.2]], (1e-3,))
    tenth, fifth, thousandth = sp.Rational(1, 10), sp.Rational(1, 5), sp.Rational(1, 1000)
    boundary = Boundary("far", 0.1 * X - 0.3)
    assert boundary.function == tenth * X - sp.Rational(3, 10)
    assert motion.stiffness == sp.Matrix([[fifth]])
    assert motion.load == sp.Matrix([thousandth])
    assert Parameter("k", "", 0.5, 1).lower == sp.Rational(1, 2)
    with pytest.raises(AttributeError):
        boundary.name = "other"


def test_affine_functions_have_a_gradient_and_a_constant():
    only = Configuration("only", SecondOrder([[1]], [[KS]]), ())
    system = System("one", "", (X, V), (K,), (only,), ())
    for function in (
        KS * X + 2 * V - 3, KS * (X - 1) + X, X - X / KS, (X + V) * KS / 2 + KS, sp.S(4), X, -V,
    ):  # fmt: skip
        row, constant = system.gradient(function)
        assert row == sp.Matrix([function]).jacobian((X, V)).applyfunc(sp.expand)
        assert sp.expand(constant - function.subs({X: 0, V: 0})) == 0


# --- signs on whole domains -------------------------------------------------------------

DOMAINS = (
    Parameter("a", "", 0, 1),
    Parameter("b", ""),
    Parameter("c", "", closed=True),
    Parameter("d", "", -2, 3),
    Parameter("m", "", -sp.oo, -1),
    Parameter("f", "", -sp.oo, sp.oo),
    Parameter("r", "", 0, 1, upper_closed=True),
)
A, B, C, D, M, F, R = (p.symbol for p in DOMAINS)


def is_positive(expression):
    """Whether an expression is shown to be positive: a stop may have it as a damping then."""
    try:
        stop = SoftStop("x", at=1, stiffness=1, damping=expression, released="force")
        one_mass("signs", stop, parameters=DOMAINS)
    except DeclarationError:
        return False
    return expression != 0


@pytest.mark.parametrize(
    "expression",
    [
        A, 1 - A, B, B + C, C + 1, D + 2, 3 - D, -M, -1 - M, 6 + D - D**2, A / (1 - A),
        (1 - A) * B / (1 + C), 1 + F**2, sp.Integer(3), sp.sqrt(B), sp.sqrt(2) - 1,
        -B / (A - 1), 1 + A * B, B - M, A - A**2, R,
    ],
    ids=str,
)  # fmt: skip
def test_positive_on_the_whole_domain_is_shown(expression):
    assert is_positive(expression)


@pytest.mark.parametrize(
    "expression",
    [
        C, B - A, A - 1, D, F, F + 1, F**2, 1 - R, -B, 2 * A - 1, 2 - B, B * C, M, M + 2,
        (A - sp.Rational(1, 2)) ** 2, sp.sqrt(B) - 1, D + 1, 1 / (A - 2), 1 / (2 * A - 1),
    ],
    ids=str,
)  # fmt: skip
def test_what_is_not_positive_everywhere_is_not_shown(expression):
    assert not is_positive(expression)


def inside(parameter, unit):
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
    st.tuples(coefficients, st.lists(st.integers(0, 6), max_size=3)), min_size=1, max_size=4
).map(lambda terms: sp.Add(*(c * sp.Mul(*((A, B, C, D, M, F, R)[i] for i in t)) for c, t in terms)))
units = st.fractions(Fraction(1, 1000), Fraction(999, 1000), max_denominator=1000)


@pytest.mark.slow
@settings(PROPERTY, max_examples=15)
@given(polynomials, polynomials, st.lists(st.tuples(*[units] * 7), min_size=4, max_size=4))
def test_true_is_a_proof(numerator, denominator, points):
    assume(denominator != 0)
    expression = numerator / denominator
    if is_positive(expression):
        for point in points:
            values = {p.symbol: inside(p, u) for p, u in zip(DOMAINS, point, strict=True)}
            assert expression.subs(values) > 0


# --- presentations ----------------------------------------------------------------------


@pytest.mark.parametrize("seed", range(3))
def test_resets_first_order_motions_and_new_parameters_are_shifted_too(seed):
    """Vector fields, boundaries, conditions and resets agree at corresponding states."""
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
    source, presented = random.Random(seed), presentation.present(system)
    # numbers for the parameters of the presented system fix those of the original one
    values = {
        p.symbol: inside(p, Fraction(source.randint(1, 99), 100)) for p in presented.parameters
    }
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
    assert GS not in {p.symbol for p in presented.parameters}

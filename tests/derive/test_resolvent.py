"""Flows of any linear motion: the matrix exponential at 40 digits, whatever the roots do."""

from __future__ import annotations

import random
from fractions import Fraction
from typing import Any

import mpmath
import pytest
import sympy as sp

from nonsmooth.derive import (
    Configuration,
    DerivationError,
    FirstOrder,
    Harmonic,
    Parameter,
    SecondOrder,
    Slider,
    System,
    oscillator,
)
from nonsmooth.derive.flows.entire import ExponentialDifference
from nonsmooth.derive.flows.modal import TIME, derive_flows

ZETA = Parameter("zeta", "damping ratio", closed=True)
OMEGA = Parameter("Omega", "frequency of the forcing")
STIFFNESS = Parameter("k", "stiffness", lower=-sp.oo)
COUPLING = Parameter("kc", "stiffness between the masses")
DIGITS = 40


def second_order(stiffness: Any, damping: Any, *parameters: Parameter, load: Any = ()) -> System:
    size = len(stiffness)
    states = sp.symbols([f"{kind}{i + 1}" for kind in "xv" for i in range(size)], real=True)
    dynamics = SecondOrder(sp.eye(size), stiffness, load, damping)
    return System("case", "", states, parameters, (Configuration("only", dynamics, ()),))


def forced(damping: Any, stiffness: Any = 1, **more: Any) -> System:
    cosine = Harmonic(OMEGA.symbol, cosine=[1])
    return oscillator("forced", ["x"], [[1]], [[stiffness]], [[damping]], forcing=[cosine], **more)


z, k, kc = ZETA.symbol, STIFFNESS.symbol, COUPLING.symbol
SYSTEMS = {
    "forced": forced(2 * z, k, parameters=[ZETA, OMEGA, STIFFNESS], load=[sp.sqrt(2)]),
    "two frequencies": oscillator(
        "two",
        ["x"],
        [[sp.sqrt(3)]],
        [[sp.sqrt(sp.pi) + sp.CRootOf(sp.Symbol("q") ** 5 + sp.Symbol("q") - 1, 0)]],
        [[z]],
        forcing=[Harmonic(OMEGA.symbol, cosine=[1]), Harmonic(sp.pi, sine=[1])],
    ),
    "slider": forced(2 * z, elements=[Slider("x", 2, 1, name="jenkins")]),
    "proportional": second_order(
        [[1 + kc, -kc], [-kc, 1 + kc]], [[2 * z, 0], [0, 2 * z]], ZETA, COUPLING
    ),
    "not proportional": second_order(
        [[2, -1], [-1, k]], [[z, 0], [0, 0]], ZETA, STIFFNESS, load=[1, 2]
    ),
    "follower": second_order([[2, k], [-k, 2]], [[z, 0], [0, z]], ZETA, STIFFNESS),
    "three": second_order(
        [[2, -1, 0], [-1, 2, -1], [0, -1, 2]],
        z * sp.Matrix([[2, -1, 0], [-1, 2, -1], [0, -1, 2]]),
        ZETA,
    ),
    "first order": System(
        "field",
        "",
        sp.symbols("a b", real=True),
        (STIFFNESS,),
        (Configuration("only", FirstOrder([[k, 1], [-1, 2]], [0, 1]), ()),),
    ),
}
POINTS = {
    "resonance": {"zeta": 0, "Omega": 1, "k": 1},
    "near resonance": {"zeta": 0, "Omega": 1 + Fraction(1, 10**9), "k": 1},
    "critical": {"zeta": 1, "Omega": 2, "k": 1},
    "nearly critical": {"zeta": 1 + Fraction(1, 10**9), "Omega": 2, "k": 1},
    "overdamped": {"zeta": 3, "Omega": Fraction(1, 3), "k": 1},
    "no stiffness": {"zeta": Fraction(1, 20), "Omega": 2, "k": 0},
    "repelling": {"zeta": Fraction(1, 20), "Omega": 2, "k": -1},
}


def divided_difference(order: int, time: Any, factors: Any) -> Any:
    """The last column of the exponential of a companion matrix, by mpmath."""
    polynomial = [mpmath.mpf(1)]
    for factor in factors:
        longer = [mpmath.mpf(0)] * (len(polynomial) + len(factor))
        for i, a in enumerate(polynomial):
            for j, b in enumerate([*factor, 1]):
                longer[i + j] += a * b
        polynomial = longer
    size = len(polynomial) - 1
    companion = mpmath.zeros(size)
    for i in range(size - 1):
        companion[i, i + 1] = 1
    for j in range(size):
        companion[size - 1, j] = -polynomial[j]
    return mpmath.expm(companion * time)[order, size - 1]


def number(expression: Any) -> Any:
    return mpmath.mpf(str(sp.N(expression, DIGITS + 10)))


def value(function: sp.Expr, known: dict[sp.Symbol, sp.Expr]) -> Any:
    found = function.xreplace(known)
    if not isinstance(found, ExponentialDifference):
        return number(found)
    order, time, *factors = found.args
    return divided_difference(int(order), number(time), [list(map(number, f)) for f in factors])


def flow_and_exponential(system: System, point: dict[str, Any], time: Any) -> tuple[Any, Any]:
    """Matrix and offset of the flow, as derived and as exponential, side by side."""
    spectrum, flows = derive_flows(system)
    flow = next(iter(flows.values()))
    known: dict[sp.Symbol, sp.Expr] = {
        p.symbol: sp.Rational(point.get(p.name, Fraction(3, 7))) for p in system.parameters
    }
    for symbol, expression in spectrum.entries:
        known[symbol] = sp.sympify(expression.xreplace(known))
    field = sp.Matrix.hstack(*flow.field).xreplace(known)
    size = field.rows
    augmented = mpmath.zeros(size + 1)
    derived = mpmath.zeros(size, size + 1)
    for i in range(size):
        for j in range(size + 1):
            augmented[i, j] = number(field[i, j])
    known[TIME] = sp.Rational(time)
    for function, matrix, offset in zip(flow.basis, flow.matrices, flow.offsets, strict=True):
        scale = value(function, known)
        table = matrix.row_join(offset).xreplace(known)
        for i in range(size):
            for j in range(size + 1):
                derived[i, j] += scale * number(table[i, j])
    return derived, mpmath.expm(augmented * number(time))[:size, :]


@pytest.mark.parametrize(
    ("name", "point"),
    [(n, p) for n in SYSTEMS for p in POINTS if n != "three" or p in ("critical", "resonance")],
)
def test_a_flow_is_the_exponential(name: str, point: str) -> None:
    system = SYSTEMS[name]
    with mpmath.workdps(DIGITS + 10):
        derived, exponential = flow_and_exponential(system, POINTS[point], Fraction(13, 7))
        size = max(map(abs, exponential))
        assert max(map(abs, derived - exponential)) < size * mpmath.mpf(10) ** -DIGITS


@pytest.mark.slow
def test_derivatives_by_every_coefficient() -> None:
    """They agree with differences, where roots meet too."""
    draw = random.Random(1)
    b, w, r, t = sp.symbols("b w r t", real=True)
    with mpmath.workdps(50):
        for point in ({b: 0, w: 1, r: 0}, {b: 1, w: 1, r: 1}, {b: draw.random(), w: 2, r: -1}):
            for order in (0, 3):
                function = ExponentialDifference(
                    order, t, sp.Tuple(w**2, 2 * b), sp.Tuple(1, 0), sp.Tuple(-r)
                )
                for symbol in (b, w, r, t):
                    known = {s: sp.Rational(v) for s, v in (point | {t: Fraction(8, 5)}).items()}
                    slope = sum(
                        number(c.xreplace(known)) * value(g, known)
                        for g, c in _terms(sp.diff(function, symbol))
                    )
                    step = sp.Rational(1, 10**16)
                    above, below = (
                        value(function, known | {symbol: known[symbol] + sign * step})
                        for sign in (1, -1)
                    )
                    difference = (above - below) / number(2 * step)
                    assert abs(slope - difference) < mpmath.mpf(10) ** -28


def _terms(expression: sp.Expr) -> list[tuple[sp.Expr, sp.Expr]]:
    """Functions of time and their coefficients."""
    found = []
    for term in sp.Add.make_args(sp.expand(expression)):
        functions = [f for f in sp.Mul.make_args(term) if f.has(ExponentialDifference)]
        if term != 0:
            found.append((sp.Mul(*functions), term / sp.Mul(*functions)))
    return found


def test_polynomials_and_constants_are_reduced() -> None:
    t, zero, pair = TIME, sp.Tuple(0), sp.Tuple(2, 3)
    assert ExponentialDifference(0, t, zero) == 1
    assert ExponentialDifference(0, t, zero, zero, zero) == t**2 / 2
    assert ExponentialDifference(2, t, zero, pair) == ExponentialDifference(1, t, pair)
    assert ExponentialDifference(2, t, pair) == -2 * ExponentialDifference(
        0, t, pair
    ) - 3 * ExponentialDifference(1, t, pair)


def test_resonance_is_no_singularity() -> None:
    """Nothing is divided by the distance of two roots."""
    _, flows = derive_flows(SYSTEMS["forced"])
    (free,) = [f for f in flows.values() if f.configuration == "only" or len(flows) == 1]
    for matrix in (*free.matrices, *free.offsets):
        assert all(sp.fraction(e)[1].is_number for e in matrix)


def test_too_long_a_closed_form_is_refused_by_name() -> None:
    stiffness = sp.Matrix(4, 4, lambda i, j: 1 / sp.Integer(i + j + 1)) + sp.eye(4)
    system = second_order(stiffness.tolist(), sp.diag(1, 2, 3, 4).tolist())
    with pytest.raises(
        DerivationError, match=r"configuration 'only': its characteristic .* 8 roots"
    ):
        derive_flows(system)

"""Conservative orbits: the first integral, the defective double one, the reciprocal pair."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from typing import Any

import mpmath
import numpy as np
import pytest
import sympy as sp

from nonsmooth import refine, solve
from nonsmooth.derive import (
    Boundary,
    Configuration,
    FirstOrder,
    Itinerary,
    Parameter,
    Phase,
    SecondOrder,
    System,
    Transition,
)
from nonsmooth.derive.equations.energy import energy_of, is_conservative
from nonsmooth.derive.systems import SYSTEMS, declaration
from nonsmooth.runtime.model.kernels import load_orbit
from nonsmooth.runtime.orbits.orbit import Orbit
from tests.declared import RANGES, Declared, itinerary_of, random_points, rigid_stop, single

RIGID, ELASTIC = "rigid-stop/one-impact", "elastic-stop/one-contact"
POINTS: list[tuple[str, dict[str, str]]] = [
    (RIGID, {}),
    (RIGID, {"T": "5"}),
    (RIGID, {"T": "6.95"}),  # unstable
    (RIGID, {"m1": "1.3", "k2": "17/3", "T": "2*pi - 1/10"}),
    (ELASTIC, {}),
    (ELASTIC, {"T": "6.95"}),  # unstable
    (ELASTIC, {"k3": "100", "m2": "7/4"}),
]
every_point = pytest.mark.parametrize("point", range(len(POINTS)))
X, Y, V, W = sp.symbols("x y v w", real=True)


@cache
def orbit(point: int) -> Orbit:
    return solve(*POINTS[point])


@cache
def sharp(point: int) -> Orbit:
    return refine(orbit(point), 50)


def matrix_of(rows: Any) -> Any:
    return mpmath.matrix([[mpmath.mpf(e) for e in row] for row in rows])


# --- the first integral -----------------------------------------------------------------


@pytest.mark.parametrize("name", RANGES)
def test_which_orbits_are_conservative(name: str) -> None:
    itinerary = itinerary_of(name)
    if name == RIGID:
        itinerary = itinerary.specialised({rigid_stop.r: sp.Integer(1)})
    expected = not name.startswith("dry-friction")
    assert is_conservative(itinerary) is expected
    assert load_orbit(name).table["conservative"] is expected


def test_an_impact_that_loses_energy_is_not_conservative() -> None:
    """Neither with r left open nor with a value below 1."""
    one_impact = rigid_stop.one_impact
    assert not is_conservative(one_impact)
    for value in (0, sp.Rational(1, 2), sp.Rational(99, 100)):
        lossy = one_impact.specialised({rigid_stop.r: sp.sympify(value)})
        assert not is_conservative(lossy)


@pytest.mark.parametrize("system", SYSTEMS)
def test_energy_is_kept_by_the_field(system: str) -> None:
    """dE/dt = grad E f = 0, by sympy, wherever there is an energy."""
    declared = declaration(system).system
    for configuration in declared.configurations:
        energy = energy_of(configuration.dynamics, declared.states)
        held = system == "dry-friction" or bool(configuration.dynamics.held)
        assert (energy is None) == held
        if energy is not None:
            matrix, offset = configuration.dynamics.field(declared.states)
            field = matrix * sp.Matrix(declared.states) + offset
            gradient = sp.Matrix([[sp.diff(energy, s) for s in declared.states]])
            assert sp.simplify((gradient * field)[0]) == 0


def test_what_has_no_energy() -> None:
    states = (X, Y, V, W)
    assert energy_of(FirstOrder(sp.zeros(4, 4), sp.zeros(4, 1)), states) is None
    symmetric = [[2, -1], [-1, 3]]
    plain = SecondOrder(sp.eye(2), symmetric, (1, 0))
    expected = (V**2 + W**2 + 2 * X**2 - 2 * X * Y + 3 * Y**2) / 2 - X
    assert sp.expand(energy_of(plain, states) - expected) == 0
    assert energy_of(SecondOrder(sp.eye(2), [[2, -1], [0, 3]]), states) is None
    assert energy_of(SecondOrder([[1, 2], [0, 1]], symmetric), states) is None
    damped = SecondOrder(sp.eye(2), symmetric, damping=[[1, 0], [0, 0]])
    assert energy_of(damped, states) is None
    assert energy_of(SecondOrder(sp.eye(2), symmetric, held={X: 1}), states) is None


@pytest.mark.parametrize(
    ("reset", "stiffness", "expected"),
    [
        ({V: -V}, 1, True),
        ({}, 1, True),
        ({V: V + 1}, 1, False),
        ({V: -V / 2}, 1, False),
        ({X: -X, V: -V}, 1, True),  # the other side of an even potential
        ({}, 3, True),  # on x = 0 another spring has the same energy
    ],
)
def test_energies_may_differ_by_a_constant(
    reset: dict[sp.Symbol, sp.Expr], stiffness: int, expected: bool
) -> None:
    """A load changes by a step where x = 0: the energies differ there by no function of v."""
    p = Parameter("p", "load")
    mass = sp.eye(1)
    first = Configuration("a", SecondOrder(mass, [[1]], (p.symbol,)), (Boundary("up", X),))
    second = Configuration("b", SecondOrder(mass, [[stiffness]]), (Boundary("down", -X),))
    system = System(
        "two", "", (X, V), (p,), (first, second),
        (Transition("a", {"up"}, "b", (), reset), Transition("b", {"down"}, "a")),
    )  # fmt: skip
    loop = Itinerary("loop", system, (Phase("a", "up", "ta"), Phase("b", "down", "tb")))
    assert is_conservative(loop) is expected


# --- the pair ---------------------------------------------------------------------------


@every_point
def test_the_pair_to_forty_digits(point: int) -> None:
    found = sharp(point)
    (one,) = (m for m in found.stability.multipliers if m.trivial)
    first, second = (m for m in found.stability.multipliers if not m.trivial)
    assert (one.trivial, one.real, one.imaginary) == (True, 1, 0)
    with mpmath.workdps(70):
        matrix = matrix_of(found.monodromy)
        bound = mpmath.mpf(10) ** -40
        mu, nu = (mpmath.mpc(m.real, m.imaginary) for m in (first, second))
        trace = sum(matrix[i, i] for i in range(4))
        assert abs(mu * nu - 1) < bound
        assert abs(mu + nu - (trace - 2)) < bound
        assert abs(found.trace - (trace - 1)) < bound
        for value in (mu, nu, mpmath.mpf(1)):
            assert abs(mpmath.det(matrix - value * mpmath.eye(4))) < bound
        # 1 is double, and defective: M - 1 has rank three
        singular = mpmath.svd_r(matrix - mpmath.eye(4), compute_uv=False)
        assert singular[3] < bound < mpmath.mpf(10) ** -6 < singular[2]
        if abs(trace - 2) < 2:
            assert mu == mpmath.conj(nu)
            assert abs(abs(mu) - 1) < bound
        else:
            assert (first.imaginary, second.imaginary) == (0, 0)
            assert abs(mu) > 1 > abs(nu)


@every_point
def test_the_monodromy_matrix_is_symplectic(point: int) -> None:
    """For the form of masses: momenta m v are conjugate to x. And it keeps the motion."""
    found = sharp(point)
    with mpmath.workdps(70):
        bound = mpmath.mpf(10) ** -45
        matrix, form = matrix_of(found.monodromy), mpmath.zeros(4)
        for place, name in enumerate(("m1", "m2")):
            mass = mpmath.mpf(found.values[name])
            form[place, place + 2], form[place + 2, place] = mass, -mass
        assert mpmath.norm(matrix.T * form * matrix - form, mpmath.inf) < bound
        declared = Declared(found, precise=True)
        field = (declared.pieces[0].field @ declared.start)[:4]
        assert mpmath.norm(matrix * field - field, mpmath.inf) < bound
        # energy is the integral: its gradient at the start is a left eigenvector
        x, v = declared.start[:2], declared.start[2:4]
        k1, k2, m1, m2 = (mpmath.mpf(found.values[n]) for n in ("k1", "k2", "m1", "m2"))
        gradient = mpmath.matrix(
            [[k1 * (x[0] - x[1]), k1 * (x[1] - x[0]) + k2 * x[1], m1 * v[0], m2 * v[1]]]
        )
        assert mpmath.norm(gradient * matrix - gradient, mpmath.inf) < bound


@every_point
def test_doubles_lose_half_the_digits_of_the_double_one(point: int) -> None:
    """Why the pair comes from the trace: a plain eigensolver splits the defective one."""
    found = orbit(point)
    ones = sorted(abs(np.linalg.eigvals(found.monodromy) - 1))[:2]
    assert max(ones) > 1e-10
    assert max(ones) < 1e-5
    exact = sharp(point).stability.multipliers
    for double, precise in zip(found.stability.multipliers, exact, strict=True):
        scale = max(1.0, abs(float(precise.real)))
        assert double.real == pytest.approx(float(precise.real), abs=1e-12 * scale)
        assert double.imaginary == pytest.approx(float(precise.imaginary), abs=1e-11 * scale)


# --- the verdict ------------------------------------------------------------------------


@pytest.mark.parametrize("name", [RIGID, ELASTIC])
def test_the_verdict_is_that_of_the_trace(name: str) -> None:
    points = random_points(name, 72, 120)
    many = solve(name, points)
    verdicts = []
    for i in np.flatnonzero(many.admissible):
        found = single(many, i)
        sum_of_pair = np.trace(Declared(found).monodromy()) - 2
        stability = found.stability
        verdicts.append(stability.verdict)
        assert abs(abs(sum_of_pair) - 2) > 1e-6
        assert stability.verdict == ("neutral" if abs(sum_of_pair) < 2 else "unstable")
        assert stability.rank == 3
        assert not stability.rank_one
        assert stability.one_sided == ""
        first, second = (m for m in stability.multipliers if not m.trivial)
        if stability.verdict == "neutral":
            assert stability.margin == 0
            assert [m.trivial for m in stability.multipliers] == [False, False, True]
            assert first.imaginary == -second.imaginary > 0
        else:
            assert first.imaginary == second.imaginary == 0
            assert first.real * second.real == pytest.approx(1)
            assert stability.margin == 1 - abs(first.real)
            assert abs(first.real) > 1
            assert [m.trivial for m in stability.multipliers] == [False, True, False]
    assert verdicts.count("neutral") > 10
    assert "unstable" in verdicts or name == ELASTIC


@cache
def border() -> str:
    """The period between 6.8 and 6.85 at which the pair meets at 1, with 700 digits."""
    text = "6.82"
    for _ in range(12):
        found = refine(solve(RIGID, {"T": text}), 700)
        step = (found.trace - 3) / found.derivatives("T").trace[0]
        text = found.arithmetic.mp.nstr(found.values["T"] - step, 690)
    return text


@pytest.mark.parametrize(("shift", "few", "enough"), [("1e-30", 16, 40), ("1e-462", 450, 550)])
def test_near_the_border_digits_decide(shift: str, few: int, enough: int) -> None:
    assert 6.8 < float(border()) < 6.85
    verdicts = []
    for sign in "+-":
        found = solve(RIGID, {"T": f"{border()} {sign} {shift}"})
        assert found.stability.verdict == "undecided"
        assert refine(found, few).stability.verdict == "undecided"
        verdicts.append(refine(found, enough).stability.verdict)
    assert verdicts == ["unstable", "neutral"]


def test_undecided_is_said_within_the_error_alone() -> None:
    for exponent in range(2, 16):
        for sign, right in (("+", "unstable"), ("-", "neutral")):
            found = solve(RIGID, {"T": f"{border()} {sign} 1e-{exponent}"})
            verdict = found.stability.verdict
            within = abs(2 - abs(found.trace - 1)) <= 10.0 ** (2 - found.digits)
            assert verdict == ("undecided" if within else right)
            assert not within or exponent > 9


def test_specialising_keeps_the_itinerary() -> None:
    one_impact = rigid_stop.one_impact
    assert one_impact.specialised({}) is one_impact
    fixed = one_impact.specialised({rigid_stop.r: sp.Integer(1)})
    transition = fixed.presented_system.transitions[0]
    assert dict(transition.reset)[one_impact.system.states[2]] == -one_impact.system.states[2]
    assert replace(fixed, presentation=None) == one_impact

"""Conservative orbits: the first integral, the defective double one, the reciprocal pair."""

from functools import cache

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
from nonsmooth.derive.equations.energy import is_conservative
from tests.declared import Declared, random_points, single

RIGID, ELASTIC = "rigid-stop/one-impact", "elastic-stop/one-contact"
POINTS = [
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
def orbit(point):
    return solve(*POINTS[point])


def matrix_of(rows):
    return mpmath.matrix([[mpmath.mpf(e) for e in row] for row in rows])


# --- the first integral -----------------------------------------------------------------

SPRINGS = sp.Matrix([[2, -1], [-1, 3]])


@pytest.mark.parametrize(
    ("reset", "behind", "expected"),
    [
        ({}, SecondOrder(sp.eye(2), SPRINGS), True),
        ({V: -V}, SecondOrder(sp.eye(2), SPRINGS), True),
        ({X: -X, V: -V}, SecondOrder(sp.eye(2), SPRINGS), True),
        ({V: V + 1}, SecondOrder(sp.eye(2), SPRINGS), False),
        ({V: -V / 2}, SecondOrder(sp.eye(2), SPRINGS), False),
        # on x = 0 another spring there has the same energy
        ({}, SecondOrder(sp.eye(2), SPRINGS + sp.diag(2, 0)), True),
        ({}, SecondOrder(sp.eye(2), SPRINGS + sp.diag(0, 2)), False),
        ({}, SecondOrder(sp.diag(1, 2), SPRINGS), False),
        ({}, SecondOrder(sp.eye(2), SPRINGS, (0, 1)), False),
        ({Y: Y + 1}, SecondOrder(sp.eye(2), [[2, 0], [0, 0]], (0, 1)), False),
        ({}, SecondOrder(sp.eye(2), [[2, -1], [0, 3]]), False),
        ({}, SecondOrder(sp.eye(2), SPRINGS, damping=[[1, 0], [0, 0]]), False),
        ({}, SecondOrder(sp.eye(2), SPRINGS, held={X: 1}), False),
        ({}, FirstOrder(sp.zeros(4, 4), sp.zeros(4, 1)), False),
    ],
)
def test_energies_before_and_behind_a_transition_differ_by_a_constant_at_most(
    reset, behind, expected
):
    """A load along x changes by a step where x = 0: the energies differ there by no function."""
    p = Parameter("p", "load")
    loaded = SecondOrder(sp.eye(2), SPRINGS, (p.symbol, 0))
    first = Configuration("a", loaded, (Boundary("up", X),))
    second = Configuration("b", behind, (Boundary("down", -X),))
    system = System(
        "two", "", (X, Y, V, W), (p,), (first, second),
        (Transition("a", {"up"}, "b", (), reset), Transition("b", {"down"}, "a")),
    )  # fmt: skip
    loop = Itinerary("loop", system, (Phase("a", "up", "ta"), Phase("b", "down", "tb")))
    assert is_conservative(loop) is expected


# --- the pair ---------------------------------------------------------------------------


@every_point
def test_the_pair_to_forty_digits(point):
    found = refine(orbit(point), 50)
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
    # a plain eigensolver splits the defective double one: the pair comes from the trace
    rough, precise = orbit(point), found.stability.multipliers
    assert 1e-10 < sorted(abs(np.linalg.eigvals(rough.monodromy) - 1))[1] < 1e-5
    for double, exact in zip(rough.stability.multipliers, precise, strict=True):
        scale = max(1.0, abs(float(exact.real)))
        assert double.real == pytest.approx(float(exact.real), abs=1e-12 * scale)
        assert double.imaginary == pytest.approx(float(exact.imaginary), abs=1e-11 * scale)


# --- the verdict ------------------------------------------------------------------------


@pytest.mark.parametrize("name", [RIGID, ELASTIC])
def test_the_verdict_is_that_of_the_trace(name):
    points = random_points(name, 72, 120)
    many = solve(name, points)
    verdicts = []
    for i in np.flatnonzero(many.admissible):
        found = single(many, i)
        sum_of_pair = np.trace(Declared(found).monodromy()) - 2
        stability = found.stability
        verdicts.append(stability.verdict)
        assert stability.verdict == ("neutral" if abs(sum_of_pair) < 2 else "unstable")
        assert stability.rank == 3
        first, second = (m for m in stability.multipliers if not m.trivial)
        if stability.verdict == "neutral":
            assert stability.margin == 0
            assert first.imaginary == -second.imaginary > 0
        else:
            assert first.imaginary == second.imaginary == 0
            assert first.real * second.real == pytest.approx(1)
            assert stability.margin == 1 - abs(first.real)
            assert abs(first.real) > 1
    assert verdicts.count("neutral") > 10
    assert "unstable" in verdicts or name == ELASTIC

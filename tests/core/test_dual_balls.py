"""Dual numbers over balls: the derivative is enclosed, by mpmath's and by closed forms."""

from __future__ import annotations

import random

import mpmath
from flint import arb, arb_mat

from nonsmooth.runtime.core.arithmetic import exact_ball
from nonsmooth.runtime.core.dual_balls import DualBall, rate_of, value_of
from nonsmooth.runtime.core.taylor_models import matrix, middle_of, range_of
from nonsmooth.runtime.core.values import flint_precision

BITS = 200
STEP = mpmath.mpf(10) ** -20


def near(ball: arb, number: mpmath.mpf, error: float = 1e-35) -> bool:
    """Whether a sharp ball is about a number."""
    return bool(abs(ball - exact_ball(number)) < error) and float(ball.rad()) < 1e-40


def slope(function: object, at: mpmath.mpf) -> mpmath.mpf:
    """Central difference."""
    return (function(at + STEP) - function(at - STEP)) / (2 * STEP)  # type: ignore[operator]


def test_quotients_and_circular_functions() -> None:
    with flint_precision(BITS), mpmath.workdps(70):
        x = DualBall(arb("0.7"), arb(1))

        def of(t: mpmath.mpf) -> mpmath.mpf:
            return 3 * mpmath.sin(t * t) / (2 - t) + mpmath.cos(t) - 1 / t

        sine, _ = (x * x).sin_cos()
        _, cosine = x.sin_cos()
        found = 3 * sine / (2 - x) + cosine - 1 / x
        point = mpmath.mpf("0.7")
        assert near(value_of(found), of(point))
        assert near(rate_of(found), slope(of, point))


def test_exponentials_of_matrices_that_do_not_commute_with_their_derivative() -> None:
    drawn = random.Random(3)
    size = 3
    a, b = ([[drawn.randint(-9, 9) for _ in range(size)] for _ in range(size)] for _ in range(2))
    with flint_precision(BITS), mpmath.workdps(70):
        found = (DualBall(arb_mat(a), arb_mat(b)) * (arb(1) / 4)).exp()

        def of(t: mpmath.mpf) -> mpmath.matrix:
            return mpmath.expm((mpmath.matrix(a) + t * mpmath.matrix(b)) / 4)

        rates = slope(of, mpmath.mpf(0))
        for i in range(size):
            for j in range(size):
                assert abs(found.rate[i, j] - exact_ball(rates[i, j])) < 1e-25
                assert float(found.rate[i, j].rad()) < 1e-40


def test_the_radius_of_a_value_reaches_its_derivative() -> None:
    # over all x in the ball the derivative of x^2 is 2 x: what a Taylor model does not enclose
    x = DualBall(arb(1, 0.25), arb(1))
    rate = rate_of(x * x)
    assert rate.contains(arb(1.5))
    assert rate.contains(arb(2.5))


def test_matrices_of_balls_and_dual_numbers() -> None:
    found = matrix([[DualBall(arb(2), arb(3)), 1], [arb(4), 0]])
    assert isinstance(found, DualBall)
    assert found.value == arb_mat([[2, 1], [4, 0]])
    assert found.rate == arb_mat([[3, 0], [0, 0]])
    assert (found.nrows(), found.ncols()) == (2, 2)
    assert not found[0, 0].is_zero()
    assert (found - found)[0, 0].is_zero()
    assert not DualBall(arb(0), arb(1)).is_zero()
    assert middle_of(found) == range_of(found) == found.value
    assert (arb_mat([[0, 1], [1, 0]]) * found).rate == arb_mat([[0, 0], [3, 0]])

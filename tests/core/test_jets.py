"""Jets: derivatives of what is computed, against mpmath's and closed forms."""

import mpmath
import pytest
from flint import arb, arb_mat
from mpmath import mp

from nonsmooth.runtime.core.arithmetic import exact_ball
from nonsmooth.runtime.core.jets import jet, part_of
from nonsmooth.runtime.core.taylor_models import matrix, range_of, space_of
from nonsmooth.runtime.core.values import flint_precision

AT = 0.3
BITS = 200
STEP = mpmath.mpf(10) ** -20


def functions(x):
    sine, cosine = x.sin_cos()
    flow = (matrix([[x, 1], [0, x * x]]) * arb(2)).exp()
    return [3 / (2 + sine * cosine), (1 - x) ** 3 / x, *flow.entries()]


def expected(x):
    flow = mp.expm(2 * mp.matrix([[x, 1], [0, x * x]]))
    return [3 / (2 + mp.sin(x) * mp.cos(x)), (1 - x) ** 3 / x, *flow]


@pytest.mark.parametrize("place", range(6))
def test_derivatives_are_enclosed_at_a_point_and_over_a_tile(place):
    space = space_of(1, 5)
    over = jet(space.variable(0, arb(AT), arb(0.01)), arb(1), None, None)
    with mp.workdps(40):
        series = mp.taylor(lambda x: expected(x)[place], mp.mpf(AT), 3)
        beside = mp.taylor(lambda x: expected(x)[place], mp.mpf(AT + 0.009), 3)
    at = functions(jet(arb(AT), arb(1), None, None))[place]
    tile = functions(over)[place]
    for k in range(4):
        point = part_of(at, k)
        assert abs(float(point.mid()) - float(series[k])) < 1e-12
        assert point.rad() < 1e-12
        assert range_of(part_of(tile, k)).contains(arb(float(series[k])))
        assert range_of(part_of(tile, k)).contains(arb(float(beside[k])))
        assert range_of(part_of(tile, k)).rad() < 0.25 * abs(series[k]) + 0.5


def test_what_is_no_jet_does_not_depend_on_the_parameter():
    x = jet(arb(2), arb(1))
    space = space_of(1, 3)
    model = space.variable(0, arb(1), arb(0.5))
    for found, rate in ((model * x, 1), (model - x, -1), (model / x, -0.25), (x + 1, 1)):
        told = part_of(found, 1)
        value = told.at([arb(0)]) if hasattr(told, "at") else told
        assert value.contains(rate)
    assert part_of(arb(3), 1) == 0


def test_every_coefficient_is_felt_to_all_digits():
    """Of an angle that is curved, in sine, cosine and a quotient: order 3, signs included."""
    with flint_precision(BITS), mpmath.workdps(70):
        angle = jet(arb("0.7"), arb(-2), arb(3), arb(5))
        sine, cosine = angle.sin_cos()
        found = 3 * sine / (2 - angle) + cosine - 1 / angle

        def of(t):
            x = mpmath.mpf("0.7") - 2 * t + 3 * t**2 + 5 * t**3
            return 3 * mpmath.sin(x) / (2 - x) + mpmath.cos(x) - 1 / x

        for k, number in enumerate(mp.taylor(of, 0, 3)):
            ball = part_of(found, k)
            assert abs(ball - exact_ball(number)) < 1e-35
            assert float(ball.rad()) < 1e-40


def test_the_radius_of_a_value_reaches_its_derivative():
    # over all x in the ball the derivative of x^2 is 2 x: what a Taylor model does not enclose
    x = jet(arb(1, 0.25), arb(1))
    rate = part_of(x * x, 1)
    assert rate.contains(arb(1.5))
    assert rate.contains(arb(2.5))


def test_matrices_of_balls_and_jets():
    found = matrix([[jet(arb(2), arb(3)), 1], [arb(4), 0]])
    assert part_of(found, 0) == arb_mat([[2, 1], [4, 0]])
    assert part_of(found, 1) == arb_mat([[3, 0], [0, 0]])
    assert (found.nrows(), found.ncols()) == (2, 2)
    assert part_of(arb_mat([[0, 1], [1, 0]]) * found, 1) == arb_mat([[0, 0], [3, 0]])
    other = matrix([[0, 1], [jet(arb(1), arb(5)), 0]])
    assert part_of(found * other, 1) == arb_mat([[5, 3], [0, 0]])

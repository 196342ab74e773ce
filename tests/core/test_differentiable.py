"""Functions with derivatives: leading axes, both modes, and wrong input."""

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal
from scipy.optimize import check_grad, least_squares, minimize

from nonsmooth import InputError
from tests.face.bridges import made


@pytest.mark.parametrize("pulled", [True, False])
@pytest.mark.parametrize("lead", [(), (4,), (2, 3)])
def test_both_modes_are_those_of_the_jacobian(lead, pulled):
    function, rng = made(pulled=pulled), np.random.default_rng(3)
    x, dx, dy = (rng.normal(size=(*lead, k)) for k in (2, 2, 3))
    jacobian = function.jacobian(x)
    assert function(x).shape == (*lead, 3)
    assert jacobian.shape == (*lead, 3, 2)
    assert_allclose(function.jvp(x, dx), np.einsum("...mq,...q->...m", jacobian, dx))
    assert_allclose(function.vjp(x, dy), np.einsum("...m,...mq->...q", dy, jacobian))
    step = 1e-6
    slope = (function(x + step * dx) - function(x - step * dx)) / (2 * step)
    assert_allclose(function.jvp(x, dx), slope, rtol=1e-7, atol=1e-8)


@pytest.mark.parametrize("x", [1.0, [1.0], np.ones((2, 3))])
def test_points_of_the_wrong_length_are_refused_by_name(x):
    with pytest.raises(InputError, match="takes 2 numbers: a, b"):
        made(pulled=False)(x)


def test_scipy_takes_all_values_or_one():
    function, x = made(pulled=False), np.array([0.3, 0.4])
    fun, jac = function.scipy_pair()
    assert_array_equal(fun(x), function(x))
    assert_array_equal(jac(x), function.jacobian(x))
    wanted = function([1.2, -0.7])
    fitted = least_squares(lambda x: fun(x) - wanted, [1.0, -0.5], jac=jac, xtol=1e-15)
    assert_allclose(fitted.x, [1.2, -0.7], rtol=1e-9)
    fun, jac = function.scipy_pair("sine")
    assert check_grad(fun, jac, x) < 1e-7
    assert isinstance(fun(x), float)
    lowest = minimize(fun, x, jac=jac, method="BFGS")
    assert lowest.fun == pytest.approx(-1, abs=1e-9)
    with pytest.raises(InputError, match="unknown output 'sin'; did you mean 'sine'"):
        function.scipy_pair("sin")

"""Kernels over any arithmetic as functions of arrays."""

from types import ModuleType

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from nonsmooth.runtime.model.kernels import SystemKernels


def function_of(kernel, inputs, outputs, compiled=None):
    """A kernel as a function of arrays: that of a system made by hand, compiled or not."""
    module, extension = ModuleType("by_hand"), ModuleType("compiled")
    module.SYSTEM, module.kernel = {"name": "by-hand"}, kernel
    module.KERNELS = {
        "kernel": ([(shape, 0) for shape in inputs], [("result", shape) for shape in outputs])
    }
    setattr(extension, f"by_hand_kernel_{len(outputs)}", compiled)
    return SystemKernels("by-hand", module, extension).function("kernel")


def kernel(point, lib):
    """A matrix of which some entries are the same everywhere, and a number."""
    x, y = point
    return [[1, x * y, 0.0], [lib.sin(x), 2, -y]], x + 1


@pytest.fixture
def function():
    return function_of(kernel, [(2,)], [(2, 3), ()])


@pytest.mark.parametrize("shape", [(), (1,), (4,), (2, 3), (0,)])
def test_points_may_have_any_leading_axes(function, shape):
    points = np.random.default_rng(2).normal(size=(*shape, 2))
    matrix, number = function(points)
    x, y = points[..., 0], points[..., 1]
    assert matrix.shape == (*shape, 2, 3)
    assert_array_equal(matrix[..., 0, 1], x * y)
    assert_array_equal(matrix[..., 1, 0], np.sin(x))
    assert_array_equal(matrix[..., 1, 2], -y)
    for place, constant in (((0, 0), 1), ((0, 2), 0), ((1, 1), 2)):
        assert (matrix[(..., *place)] == constant).all()
    assert_array_equal(number, x + 1)


def test_a_tiny_imaginary_part_is_a_derivative(function):
    x, tiny = np.array([0.7, -1.2]), 1e-30
    matrix, number = function(x + 1j * tiny * np.array([1.0, 0.0]))
    assert_allclose(matrix.imag / tiny, [[0, x[1], 0], [np.cos(x[0]), 0, 0]], rtol=1e-15)
    assert number.imag == tiny


def test_an_argument_of_another_shape_is_refused(function):
    with pytest.raises(ValueError, match="does not end in"):
        function(np.zeros((4, 3)))


@pytest.mark.parametrize("order", [slice(None), slice(None, None, -1), slice(None, None, 2)])
def test_results_never_lie_in_the_memory_of_arguments(order):
    function = function_of(lambda point, lib: (point, point[0]), [(2,)], [(2,), ()])
    points = np.random.default_rng(3).normal(size=(6, 2))
    before = points.copy()
    state, first = function(points[order])
    for result in (state, first):
        assert not np.shares_memory(result, points)
        result[...] = np.nan
    assert_array_equal(points, before)

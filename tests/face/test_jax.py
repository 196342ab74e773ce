"""Functions with derivatives in JAX: every transformation, both modes, and what is refused.

All in one file, so that one process alone loads JAX. Gradients through motions are measured against
differences in 40 digits.
"""

from functools import partial

import numpy as np
import pytest
from benchmarking import gradients
from numpy.testing import assert_allclose

import nonsmooth as ns
from nonsmooth.jax import differentiable
from tests.face.bridges import Bridge, Laws, made, refused_in_one_line

MODES = "both", "reverse"
pytestmark = pytest.mark.slow  # loading JAX and its first Jacobians take 140 MB


@pytest.fixture
def jax():
    """JAX with 64 bits; what it compiled for a test goes with the test."""
    module = pytest.importorskip("jax")
    before = module.config.jax_enable_x64
    module.config.update("jax_enable_x64", True)
    yield module
    module.config.update("jax_enable_x64", before)
    module.clear_caches()


def checked(function, x, *, forward=True, **options):
    """By JAX's own checker, against differences."""
    checks = pytest.importorskip("jax.test_util")
    modes = ("fwd", "rev") if forward else ("rev",)
    checks.check_grads(function, (x,), 1, modes, **options)


class TestJax(Laws):
    @pytest.fixture(params=MODES)
    def bridge(self, jax, request):
        forward = request.param == "both"
        return Bridge(
            name="jax",
            numbers=jax.numpy,
            transformations=jax,
            tensor=jax.numpy.array,
            differentiable=partial(differentiable, mode=request.param),
            ways=(lambda f, x: f(x), lambda f, x: jax.jit(f)(x)),
            check=lambda f, x: checked(
                f, jax.numpy.array(x), forward=forward, rtol=1e-7, atol=1e-7
            ),
            pulled=True,
            reverse_calls=["differentiate 5"] if forward else ["evaluate 5", "pull 5"],
            forward=forward,
        )


def test_large_batches_do_not_wait_for_each_other(jax):
    """A callback that used JAX itself could wait for the thread that runs it."""
    function, x = differentiable(made()), np.ones((50_000, 2))
    found = jax.jit(jax.grad(lambda x: function(2 * x).sum()))(x)
    assert_allclose(found[-1], [12.0, 4 + 2 * np.cos(2)], rtol=1e-14)


@pytest.mark.parametrize(
    ("x", "message"),
    [(np.ones(3), "takes 2 numbers: a, b"), (np.ones(2) * 1j, "real numbers"), (1.0, "no entries")],
)
def test_what_is_no_point_is_refused_in_one_line(jax, x, message):
    refused_in_one_line(jax.jit(differentiable(made())), x, message)


def test_numbers_of_32_bits_become_64_and_half_of_the_digits_is_refused(jax):
    function = differentiable(made())
    found = function(jax.numpy.ones(2, dtype="float32"))
    assert (found.dtype, found[2]) == (np.float64, np.sin(1.0))
    jax.config.update("jax_enable_x64", False)
    for asked in (function, jax.jit(jax.grad(lambda x: function(x).sum()))):
        refused_in_one_line(asked, np.ones(2), "jax_enable_x64")


@pytest.mark.usefixtures("jax")
def test_modes_that_are_not_there():
    with pytest.raises(ns.InputError, match="no reverse pass"):
        differentiable(made(), mode="reverse")
    with pytest.raises(ns.InputError, match="unknown mode 'forward'; known: both, reverse"):
        differentiable(made(), mode="forward")  # what is refused


def test_the_gradient_of_an_orbit_is_that_of_its_function(jax):
    orbit = ns.solve("dry-friction/global-stick", {"eta": "0.98", "V": "1.01"})
    source = ns.orbit_function(orbit, by=("eta", "V"), of=("period", "trace"))
    function, x = differentiable(source), jax.numpy.array([0.98, 1.01])
    found = jax.vmap(jax.grad(lambda x: function(x)[1]))(jax.numpy.stack([x, x + 1e-3]))
    assert_allclose(found[0], source.jacobian(x)[1], rtol=1e-12)
    checked(function, x, rtol=1e-5, atol=1e-6)


def test_the_gradient_behind_impacts_is_that_of_forty_digits(jax):
    x, expected = jax.numpy.array(gradients.POINT), gradients.reference(40)
    for mode in MODES:
        function = differentiable(gradients.motion(), mode=mode)
        found = jax.jit(jax.grad(lambda x, function=function: function(x)[0]))(x)
        assert_allclose(found, expected, rtol=0, atol=1e-9 * np.abs(expected).max())
        checked(function, x, forward=mode == "both", rtol=1e-4, atol=1e-4, eps=1e-7)

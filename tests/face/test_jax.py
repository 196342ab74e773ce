"""Functions with derivatives in JAX: every transformation, both modes, and what is refused.

All in one file, so that one process alone loads JAX. Gradients through motions are measured against
differences in 40 digits.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import pytest
from benchmarking import gradients
from numpy.testing import assert_allclose, assert_array_equal

import nonsmooth as ns
from nonsmooth.jax import differentiable
from tests.face.functions import made

MODES = ("both", "reverse")


@pytest.fixture
def jax() -> Iterator[Any]:
    """JAX with 64 bits; what it compiled for a test goes with the test."""
    module = pytest.importorskip("jax")
    before = module.config.jax_enable_x64
    module.config.update("jax_enable_x64", True)
    yield module
    module.config.update("jax_enable_x64", before)
    module.clear_caches()


def at(*lead: int) -> np.ndarray:
    return np.random.default_rng(5).normal(size=(*lead, 2))


@pytest.mark.parametrize("compiled", [False, True])
@pytest.mark.parametrize("mode", MODES)
@pytest.mark.parametrize("lead", [(), (4,), (2, 3), (0,)])
def test_values_are_those_of_the_function(
    jax: Any, lead: tuple[int, ...], mode: Any, compiled: bool
) -> None:
    source, x = made(pulled=True), at(*lead)
    function = differentiable(source, mode=mode)
    found = (jax.jit(function) if compiled else function)(x)
    assert found.dtype == np.float64
    assert_array_equal(np.asarray(found), source(x))


def transformations(jax: Any, mode: str) -> list[Callable[..., Any]]:
    return [jax.jacrev] if mode == "reverse" else [jax.jacrev, jax.jacfwd]


@pytest.mark.slow
@pytest.mark.parametrize("compiled", [False, True])
@pytest.mark.parametrize("mode", MODES)
def test_jacobians_are_those_of_the_function(jax: Any, mode: Any, compiled: bool) -> None:
    source, x, many = made(pulled=True), at(), at(2, 3)
    function = differentiable(source, mode=mode)
    once = jax.jit if compiled else lambda f: f
    for transformed in transformations(jax, mode):
        found = once(transformed(function))(x)
        assert_allclose(found, source.jacobian(x), rtol=1e-15)
        mapped = jax.vmap(jax.vmap(transformed(function), in_axes=1), in_axes=0, out_axes=1)
        found = once(mapped)(many.swapaxes(1, 2)).swapaxes(0, 1)
        assert_allclose(found, source.jacobian(many), rtol=1e-15)
    gradient = once(jax.grad(lambda x: function(x) @ jax.numpy.array([1.0, -2.0, 3.0])))(x)
    assert_allclose(gradient, source.vjp(x, [1.0, -2.0, 3.0]), rtol=1e-14)


@pytest.mark.parametrize("mode", MODES)
@pytest.mark.parametrize("axis", [0, 1])
def test_a_batch_is_one_call(jax: Any, mode: Any, axis: int) -> None:
    calls: list[str] = []
    source = made(pulled=True, calls=calls)
    function, x = differentiable(source, mode=mode), at(5)
    given = x if axis == 0 else x.T
    assert_array_equal(jax.vmap(function, in_axes=axis)(given), source(x))
    calls.clear()
    jax.vmap(function, in_axes=axis)(given).block_until_ready()
    assert calls == ["evaluate 5"]
    calls.clear()
    found = jax.vmap(jax.grad(lambda x: function(x).sum()), in_axes=axis)(given)
    assert_allclose(found, source.vjp(x, np.ones((5, 3))), rtol=1e-14)
    assert calls[:-1] == (["differentiate 5"] if mode == "both" else ["evaluate 5", "pull 5"])


@pytest.mark.parametrize("mode", MODES)
def test_jax_own_checker_agrees(jax: Any, mode: Any) -> None:
    checks = pytest.importorskip("jax.test_util")
    function = differentiable(made(pulled=True), mode=mode)
    modes = ("rev",) if mode == "reverse" else ("fwd", "rev")
    for lead in ((), (3,)):
        checks.check_grads(function, (jax.numpy.array(at(*lead)),), 1, modes, rtol=1e-7, atol=1e-7)


def test_forward_mode_along_a_direction(jax: Any) -> None:
    source, x, dx = made(), at(4), at(4)[::-1].copy()
    values, along = jax.jvp(differentiable(source), (x,), (dx,))
    assert_array_equal(values, source(x))
    assert_allclose(along, source.jvp(x, dx), rtol=1e-14)


@pytest.mark.slow
def test_it_composes_with_what_jax_differentiates_itself(jax: Any) -> None:
    function, numpy = differentiable(made()), jax.numpy

    def whole(t: Any) -> Any:
        def step(x: Any, _: Any) -> tuple[Any, None]:
            return function(numpy.sin(x))[:2], None

        return jax.lax.scan(step, numpy.stack([t, t**2]), length=3)[0].sum()

    def plain(t: Any) -> Any:
        x = numpy.stack([t, t**2])
        for _ in range(3):
            a, b = numpy.sin(x)
            x = numpy.stack([a * b, a**2])
        return x.sum()

    expected = jax.value_and_grad(plain)(0.7)
    assert_allclose(jax.jit(jax.value_and_grad(whole))(0.7), expected, rtol=1e-13)


@pytest.mark.parametrize("mode", MODES)
def test_where_there_is_no_value_all_is_nan(jax: Any, mode: Any) -> None:
    function = differentiable(made(pulled=True), mode=mode)
    x = np.array([[1.0, 2.0], [11.0, 2.0]])
    for found in (function(x), jax.grad(lambda x: function(x).sum())(x)):
        assert_array_equal(np.isnan(found).any(axis=1), [False, True])
        assert_array_equal(np.isnan(found).all(axis=1), [False, True])


def test_large_batches_do_not_wait_for_each_other(jax: Any) -> None:
    """A callback that used JAX itself could wait for the thread that runs it."""
    function, x = differentiable(made()), np.ones((300_000, 2))
    found = jax.jit(jax.grad(lambda x: function(2 * x).sum()))(x)
    assert_allclose(found[-1], [12.0, 4 + 2 * np.cos(2)], rtol=1e-14)


@pytest.mark.parametrize("mode", MODES)
def test_second_derivatives_are_refused(jax: Any, mode: Any) -> None:
    function = differentiable(made(pulled=True), mode=mode)
    with pytest.raises(ns.InputError, match="first derivatives only"):
        jax.jacrev(jax.jacrev(function))(at())
    if mode == "both":
        with pytest.raises(ns.InputError, match="first derivatives only"):
            jax.hessian(function)(at())


@pytest.mark.parametrize(
    ("x", "message"),
    [(np.ones(3), "takes 2 numbers: a, b"), (np.ones(2) * 1j, "real numbers"), (1.0, "no entries")],
)
def test_what_is_no_point_is_refused_in_one_line(jax: Any, x: Any, message: str) -> None:
    with pytest.raises(ns.InputError, match=message) as caught:
        jax.jit(differentiable(made()))(x)
    assert "\n" not in str(caught.value)


def test_numbers_of_32_bits_become_64(jax: Any) -> None:
    found = differentiable(made())(jax.numpy.ones(2, dtype="float32"))
    assert found.dtype == np.float64
    assert found[2] == np.sin(1.0)


def test_half_of_the_digits_is_refused(jax: Any) -> None:
    function = differentiable(made())
    jax.config.update("jax_enable_x64", False)
    try:
        with pytest.raises(ns.InputError, match="jax_enable_x64") as caught:
            function(np.ones(2))
        with pytest.raises(ns.InputError, match="jax_enable_x64"):
            jax.jit(jax.grad(lambda x: function(x).sum()))(np.ones(2))
    finally:
        jax.config.update("jax_enable_x64", True)
    assert "\n" not in str(caught.value)


@pytest.mark.usefixtures("jax")
def test_modes_that_are_not_there() -> None:
    with pytest.raises(ns.InputError, match="no reverse pass"):
        differentiable(made(), mode="reverse")
    with pytest.raises(ns.InputError, match="unknown mode 'forward'; known: both, reverse"):
        differentiable(made(), mode="forward")  # what is refused


def test_without_jax_the_command_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "jax", None)
    with pytest.raises(ns.MissingExtra, match=r'pip install "nonsmooth\[jax\]"'):
        differentiable(made())


def test_the_gradient_of_an_orbit_is_that_of_its_function(jax: Any) -> None:
    checks = pytest.importorskip("jax.test_util")
    orbit = ns.solve("dry-friction/global-stick", {"eta": "0.98", "V": "1.01"})
    source = ns.orbit_function(orbit, by=("eta", "V"), of=("period", "trace"))
    function, x = differentiable(source), jax.numpy.array([0.98, 1.01])
    for transformed in (jax.jacfwd, jax.jacrev):
        assert_allclose(jax.jit(transformed(function))(x), source.jacobian(x), rtol=1e-12)
    many = jax.numpy.stack([x, x + 1e-3])
    found = jax.vmap(jax.grad(lambda x: function(x)[1]))(many)
    assert_allclose(found, source.jacobian(many)[:, 1], rtol=1e-12)
    checks.check_grads(function, (x,), 1, rtol=1e-5, atol=1e-6)


@pytest.mark.parametrize("mode", ["both", pytest.param("reverse", marks=pytest.mark.slow)])
def test_the_gradient_behind_impacts_is_that_of_forty_digits(jax: Any, mode: Any) -> None:
    checks = pytest.importorskip("jax.test_util")
    function = differentiable(gradients.motion(), mode=mode)
    x = jax.numpy.array(gradients.POINT)
    expected = gradients.reference(40)
    found = jax.jit(jax.grad(lambda x: function(x)[0]))(x)
    assert_allclose(found, expected, rtol=0, atol=1e-9 * np.abs(expected).max())
    modes = ("rev",) if mode == "reverse" else ("fwd", "rev")
    checks.check_grads(function, (x,), 1, modes, rtol=1e-4, atol=1e-4, eps=1e-7)

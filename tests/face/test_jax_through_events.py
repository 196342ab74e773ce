"""Gradients of JAX through orbits and motions, against differences in 40 digits."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth.jax import differentiable
from tests.places import CHECKOUT

sys.path.append(str(CHECKOUT / "scripts"))

from benchmarking import gradients

jax = pytest.importorskip("jax")
pytest.importorskip("jax.test_util")


@pytest.fixture(autouse=True)
def _with_64_bits() -> Iterator[None]:
    before = jax.config.jax_enable_x64
    jax.config.update("jax_enable_x64", True)
    yield
    jax.config.update("jax_enable_x64", before)


NAME, BY, OF = "dry-friction/global-stick", ("eta", "V"), ("period", "trace")


def refined(numbers: list[Fraction]) -> list[Any]:
    """Period and trace in 40 digits."""
    given = {name: f"{n.numerator}/{n.denominator}" for name, n in zip(BY, numbers, strict=True)}
    orbit = ns.solve(NAME, given, digits=40)
    return [orbit.period, orbit.trace]


def test_the_gradient_of_an_orbit_is_that_of_forty_digits() -> None:
    point, step = [Fraction(98, 100), Fraction(101, 100)], Fraction(1, 10**12)
    expected = np.empty((2, 2))
    for place in range(2):
        sides = []
        for sign in (1, -1):
            moved = list(point)
            moved[place] += sign * step
            sides.append(refined(moved))
        slopes = [(a - b) / float(2 * step) for a, b in zip(*sides, strict=True)]
        expected[:, place] = [float(slope) for slope in slopes]
    orbit = ns.solve(NAME, {"eta": "0.98", "V": "1.01"})
    function = differentiable(ns.orbit_function(orbit, by=BY, of=OF))
    x = jax.numpy.array([float(n) for n in point])
    for transformed in (jax.jacfwd, jax.jacrev):
        np.testing.assert_allclose(jax.jit(transformed(function))(x), expected, rtol=1e-10)
    many = jax.numpy.stack([x, x + 1e-3])
    found = jax.vmap(jax.grad(lambda x: function(x)[1]))(many)
    np.testing.assert_allclose(found[0], expected[1], rtol=1e-10)
    jax.test_util.check_grads(function, (x,), 1, rtol=1e-5, atol=1e-6)


@pytest.mark.parametrize("mode", ["both", pytest.param("reverse", marks=pytest.mark.slow)])
def test_the_gradient_behind_impacts_is_that_of_forty_digits(mode: Any) -> None:
    function = differentiable(gradients.motion(), mode=mode)
    x = jax.numpy.array(gradients.POINT)
    expected = gradients.reference(40)
    found = jax.jit(jax.grad(lambda x: function(x)[0]))(x)
    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-9 * np.abs(expected).max())
    modes = ("rev",) if mode == "reverse" else ("fwd", "rev")
    jax.test_util.check_grads(function, (x,), 1, modes, rtol=1e-4, atol=1e-4, eps=1e-7)

"""Laws of functions that another library differentiates, the same for JAX and PyTorch."""

import sys
from typing import NamedTuple

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

import nonsmooth as ns

WEIGHTS = np.array([1.0, -2.0, 3.0])


def made(*, pulled=False, calls=None):
    """Three values of two numbers, NaN where the first number is above 10; note each call."""
    noted = [] if calls is None else calls

    def evaluate(x):
        noted.append(f"evaluate {len(x)}")
        found = np.stack([x[:, 0] * x[:, 1], x[:, 0] ** 2, np.sin(x[:, 1])], axis=1)
        found[x[:, 0] > 10] = np.nan
        return found

    def jacobian(x):
        found = np.zeros((len(x), 3, 2))
        found[:, 0, 0], found[:, 0, 1] = x[:, 1], x[:, 0]
        found[:, 1, 0], found[:, 2, 1] = 2 * x[:, 0], np.cos(x[:, 1])
        found[x[:, 0] > 10] = np.nan
        return found

    def differentiate(x):
        values = evaluate(x)
        noted[-1] = f"differentiate {len(x)}"
        return values, jacobian(x)

    def pull(x, y):
        noted.append(f"pull {len(x)}")
        return np.einsum("nm,nmq->nq", y, jacobian(x))

    names = ("a", "b"), ("product", "square", "sine")
    return ns.DifferentiableFunction(
        *names, np.ones(2), evaluate, differentiate, pull if pulled else None
    )


def at(*lead):
    return np.random.default_rng(5).normal(size=(*lead, 2))


class Bridge(NamedTuple):
    """A library, and how functions are handed to it."""

    name: str
    numbers: object  # its functions of arrays
    transformations: object  # its grad, vmap, jvp, jacrev and jacfwd
    tensor: object
    differentiable: object
    # what calls a function of tensors at an array: plainly, and compiled or with a gradient
    ways: list
    check: object  # its own checker of derivatives
    pulled: bool  # whether functions have a reverse pass
    reverse_calls: list  # of a gradient of five points
    forward: bool = True

    def jacobians(self):
        found = self.transformations
        return [found.jacrev, found.jacfwd] if self.forward else [found.jacrev]

    def of(self, **options):
        """A function, and what the library makes of it."""
        source = made(pulled=self.pulled, **options)
        return source, self.differentiable(source)


class Laws:
    """What holds of each library; a subclass has a fixture `bridge`."""

    @pytest.mark.parametrize("lead", [(), (4,), (2, 3), (0,)])
    def test_values_are_those_of_the_function(self, bridge, lead):
        source, function = bridge.of()
        for way in bridge.ways:
            found = np.asarray(way(function, at(*lead)))
            assert found.dtype == np.float64
            assert_array_equal(found, source(at(*lead)))

    def test_jacobians_are_those_of_the_function(self, bridge):
        source, function = bridge.of()
        x, many, vmap = at(), at(2, 3), bridge.transformations.vmap
        weights = bridge.tensor(WEIGHTS)
        gradient = bridge.transformations.grad(lambda x: function(x) @ weights)
        way, *_, compiled = bridge.ways
        for jacobian in bridge.jacobians():
            assert_allclose(compiled(jacobian(function), x), source.jacobian(x), rtol=1e-14)
            found = way(vmap(vmap(jacobian(function), 1), 0, 1), many.swapaxes(1, 2))
            assert_allclose(found, source.jacobian(many).swapaxes(0, 1), rtol=1e-14)
        assert_allclose(compiled(gradient, x), source.vjp(x, WEIGHTS), rtol=1e-14)
        if bridge.forward:
            dx = many[::-1].copy()
            given = bridge.tensor(many), bridge.tensor(dx)
            values, along = bridge.transformations.jvp(function, given[:1], given[1:])
            assert_array_equal(values, source(many))
            assert_allclose(along, source.jvp(many, dx), rtol=1e-14)

    @pytest.mark.parametrize("axis", [0, 1])
    def test_a_batch_is_one_call(self, bridge, axis):
        calls = []
        source, function = bridge.of(calls=calls)
        x, (way, *_) = at(5), bridge.ways
        given = x if axis == 0 else np.ascontiguousarray(x.T)
        found = way(bridge.transformations.vmap(function, axis), given)
        assert calls == ["evaluate 5"]
        assert_array_equal(found, source(x))
        calls.clear()
        gradient = bridge.transformations.grad(lambda x: function(x).sum())
        found = np.asarray(way(bridge.transformations.vmap(gradient, axis), given))
        assert calls == bridge.reverse_calls
        assert_allclose(found, source.vjp(x, np.ones((5, 3))), rtol=1e-14)

    @pytest.mark.parametrize("lead", [(), (3,), (2, 2)])
    def test_its_own_checker_agrees(self, bridge, lead):
        bridge.check(bridge.of()[1], at(*lead))

    def test_it_composes_with_what_the_library_differentiates(self, bridge):
        _, function = bridge.of()

        def plain(x):
            return bridge.numbers.stack([x[..., 0] * x[..., 1], x[..., 0] ** 2], -1)

        def thrice(step):
            def whole(x):
                for _ in range(3):
                    x = step(bridge.numbers.sin(x))[..., :2]
                return x.sum()

            return bridge.transformations.grad(whole)

        found, expected = (bridge.ways[-1](thrice(step), at(4)) for step in (function, plain))
        assert_allclose(found, expected, rtol=1e-13)

    def test_where_there_is_no_value_all_is_nan(self, bridge):
        _, function = bridge.of()
        x, (way, *_) = np.array([[1.0, 2.0], [11.0, 2.0]]), bridge.ways
        gradient = bridge.transformations.grad(lambda x: function(x).sum())
        for found in (np.asarray(way(f, x)) for f in (function, gradient)):
            assert_array_equal(np.isnan(found).any(axis=1), [False, True])
            assert_array_equal(np.isnan(found).all(axis=1), [False, True])

    def test_second_derivatives_are_refused(self, bridge):
        _, function = bridge.of()
        for outer in bridge.jacobians():
            for inner in bridge.jacobians():
                with pytest.raises(ns.InputError, match="first derivatives only"):
                    outer(inner(function))(bridge.tensor(at()))

    def test_without_the_library_the_command_is_told(self, bridge, monkeypatch):
        monkeypatch.setitem(sys.modules, bridge.name, None)
        with pytest.raises(ns.MissingExtra, match=rf'pip install "nonsmooth\[{bridge.name}\]"'):
            bridge.of()


def refused_in_one_line(function, x, message):
    with pytest.raises(ns.InputError, match=message) as caught:
        function(x)
    assert "\n" not in str(caught.value)

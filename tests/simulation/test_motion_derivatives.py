"""Derivatives of motions against differences, forward against reverse, and what is refused."""

from __future__ import annotations

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth.runtime.core.differentiable import DifferentiableFunction

DATA = {"m1": 1, "m2": 2, "k1": 1, "k2": 5, "r": 0.5}
START = [0, 0, 1.5, 0.3]
ALL = ("m1", "m2", "k1", "k2", "r", "x10", "x20", "v10", "v20")


def _differences(function: DifferentiableFunction, step: float = 1e-6) -> np.ndarray:
    """Central differences, of the second order."""
    x = function.reference
    columns = [
        (function(x + step * unit) - function(x - step * unit)) / (2 * step)
        for unit in np.eye(len(x))
    ]
    return np.stack(columns, axis=1)


def test_states_follow_all_numbers_through_impacts() -> None:
    found = ns.motion_function("rigid-stop", DATA, START, by=ALL, times=[1.0, 5.0, 9.9])
    np.testing.assert_allclose(found.jacobian(found.reference), _differences(found), atol=3e-9)


def test_times_of_transitions_follow_all_numbers() -> None:
    found = ns.motion_function("rigid-stop", DATA, START, by=ALL, transitions=6)
    np.testing.assert_allclose(
        found.jacobian(found.reference), _differences(found), rtol=1e-8, atol=1e-8
    )


@pytest.mark.parametrize("times", [None, [0.5, 7.0]])
def test_reverse_is_forward(times: list[float] | None) -> None:
    motion = ns.simulate("rigid-stop", DATA, START, until=20)
    found = motion.derivatives(times=times)
    random = np.random.default_rng(1)
    factors = {
        name: random.normal(size=getattr(found, name).shape[:-1])
        for name in ("states", "event_times", "before", "behind")
    }
    expected = sum(
        np.tensordot(part, getattr(found, name), axes=part.ndim) for name, part in factors.items()
    )
    np.testing.assert_allclose(found.vjp(**factors), expected, rtol=1e-12, atol=1e-12)
    direction = random.normal(size=len(found.by))
    for name, part in found.jvp(direction).items():
        np.testing.assert_allclose(part, getattr(found, name) @ direction, atol=1e-12)


def test_what_is_unknown_is_named() -> None:
    motion = ns.simulate("rigid-stop", DATA, START, until=5)
    with pytest.raises(ns.InputError, match="parameter or start"):
        motion.derivatives(["m3"])

"""Derivatives of observables against differences, on random oscillators."""

import numpy as np
import pytest

import nonsmooth as ns
from tests.moved_motions import random_oscillator

STEP = 1e-6


def _numbers(found):
    """All observables, or their derivatives, in one order."""
    yield found.duration
    for name in ("minima", "maxima", "means", "rms", "fractions", "sticking"):
        yield from getattr(found, name).values()
    for contact in found.contacts.values():
        for name in ("minimum", "maximum", "mean", "work", "dissipated"):
            yield getattr(contact, name)


def _values(found):
    parts = _numbers(ns.observe(found, 2.0))
    return np.array([getattr(part, "value", part) for part in parts])


@pytest.mark.slow
@pytest.mark.parametrize("end", [{"until": 15.0}, {"transitions": 9}], ids=["time", "transition"])
@pytest.mark.parametrize(  # slider and stop, friction and stop, both stops
    ("seed", "masses"), [(4, 2), (2, 2), (4, 1)]
)
def test_observables_follow_all_parameters(seed, masses, end):
    system, data, start = random_oscillator(np.random.default_rng([7, seed]), "random", masses)
    found = ns.simulate(system, data, start, **end).derivatives(list(data)).observables(2.0)
    exact = np.array(list(_numbers(found)))
    # all are moved at once, each by another size
    sizes = np.random.default_rng(seed).uniform(0.3, 1, len(data))
    above, below = (
        _values(
            ns.simulate(
                system,
                {n: value + step * by for (n, value), by in zip(data.items(), sizes, strict=True)},
                start,
                **end,
            )
        )
        for step in (STEP, -STEP)
    )
    np.testing.assert_allclose(exact @ sizes, (above - below) / (2 * STEP), atol=5e-7)

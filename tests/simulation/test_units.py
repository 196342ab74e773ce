"""Motions are the same in all units of length, time and mass, and of both engines."""

import os
from fractions import Fraction
from functools import cache

import numpy as np
import pytest

import nonsmooth as ns
from tests.engines import ENGINES, with_both, with_engine
from tests.scaled_systems import random_scaled
from tests.tables import slow

# units of length, inverse units of time, units of mass
POWERS_OF_TWO = [
    (1, 64, 1),
    (Fraction(1, 2**20), 2**10, 8),
    (2**30, Fraction(1, 2**12), Fraction(1, 2)),
]
OTHERS = [
    (1, 70, 1),
    (1, 150, 3),
    (Fraction(1, 1000), 300, 1),
    (Fraction(1, 10**6), 1200, 7),
    (Fraction(1, 1000), 75, 1000),
    (10**9, Fraction(1, 10**6), 1),
    (1, 10**5, 1),
]
TRANSITIONS = 40
scaled_by = cache(random_scaled)


def motion(scaled, length, rate, mass):
    return _motion(os.environ.get("NONSMOOTH_BACKEND"), scaled, length, rate, mass)


@cache
def _motion(backend, scaled, length, rate, mass):
    """Of a backend: two tests compare the same one."""
    return ns.simulate(
        scaled.system,
        scaled.parameters(length, rate, mass),
        scaled.start(length, rate),
        until=40 / float(rate),
        transitions=TRANSITIONS,
    )


def compare(found, rate, wanted, wanted_rate=1):
    """The same sequence, at times that differ by rounding."""
    assert found.configurations == wanted.configurations
    assert found.status == wanted.status
    # a motion that diverges by e^(0.5 t) makes of a rounding 1e-8
    times, expected = found.times * float(rate), wanted.times * float(wanted_rate)
    np.testing.assert_allclose(times, expected, rtol=0, atol=1e-8)


SEEDS = [0, 3, *map(slow, (1, 2, 4, 5, 6, 9))]  # others of the first ten have no new element


@pytest.mark.slow
@pytest.mark.parametrize("seed", SEEDS)
def test_motions_do_not_depend_on_units(seed, backend):
    scaled = scaled_by(seed)
    try:
        wanted = motion(scaled, 1, 1, 1)
    except ns.InputError as error:  # a start beyond a slider's limit is so in all units
        for units in (*POWERS_OF_TWO, *OTHERS):
            with pytest.raises(type(error)):
                motion(scaled, *units)
        return
    for units in POWERS_OF_TWO:
        found = motion(scaled, *units)
        assert found.configurations == wanted.configurations
        np.testing.assert_array_equal(found.times * float(units[1]), wanted.times)
    for units in OTHERS if backend == "c" else OTHERS[seed % len(OTHERS) :: len(OTHERS)]:
        compare(motion(scaled, *units), units[1], wanted)


@pytest.mark.compiled
@pytest.mark.parametrize("seed", SEEDS)
def test_engines_agree(seed):
    units = OTHERS[seed % len(OTHERS)]
    try:
        found, other = with_both(motion, scaled_by(seed), *units)
    except ns.InputError:
        for engine in ENGINES:
            with pytest.raises(ns.InputError):
                with_engine(engine, motion, scaled_by(seed), *units)
        return
    compare(found, units[1], other, units[1])

"""Orbits of more than 16 states: compiled as in Python."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from nonsmooth import InputError
from nonsmooth.runtime.model.engine_layout import numbers_of
from nonsmooth.runtime.orbits.equations import phase_waves
from nonsmooth.runtime.orbits.table_admissible import assess_cycle
from nonsmooth.runtime.shooting.newton import CONVERGED
from nonsmooth.runtime.shooting.shooting_map import itinerary_shape, numbers_in, shoot
from nonsmooth.runtime.shooting.table_newton import digits_of, solve_shape
from nonsmooth.runtime.simulation.simulate import follow
from tests.engines import with_both
from tests.large_systems import OMEGA, chain


@pytest.mark.compiled
@pytest.mark.parametrize("factored", [False, True])
@pytest.mark.parametrize(("count", "phases", "periods"), [(8, 5, 2), (10, 2, 1)])
def test_the_compiled_solver_takes_any_number_of_states(
    count: int, phases: int, periods: int, factored: bool
) -> None:
    system = chain(count, factored=factored)
    start = np.array([*np.zeros(count), *np.random.default_rng(0).normal(size=count), 1, 0])
    motion = follow(system, start, 0, transitions=3000)
    cycle = itinerary_shape(system.structure, [("c0", "stop")] * phases)
    dwell = np.diff(motion.times)[-phases:][None]
    near = motion.states[-1 - phases][None] + 1e-3
    period = np.array([2 * np.pi / OMEGA * periods])
    flat = numbers_of(system)[None]
    found, known = with_both(solve_shape, cycle, flat, dwell * 1.001, near, period)
    assert found.status.tolist() == known.status.tolist() == [CONVERGED]
    assert found.iterations.tolist() == known.iterations.tolist()
    assert_allclose(found.dwell, known.dwell, rtol=0, atol=1e-12)
    assert_allclose(found.starts, known.starts, rtol=0, atol=1e-12)
    assert_allclose(found.maps, known.maps, rtol=0, atol=1e-11)
    # the simulated motion has come to this orbit
    assert_allclose(found.dwell, dwell, rtol=0, atol=1e-5)


@pytest.mark.compiled
def test_orbits_are_judged_by_factors_as_by_matrices() -> None:
    """Shooting, digits, admissibility and boundary functions of one orbit, both ways."""
    count = 10
    start = np.array([*np.zeros(count), *np.random.default_rng(0).normal(size=count), 1, 0])
    motion = follow(chain(count), start, 0, transitions=3000)
    period = np.array([2 * np.pi / OMEGA])
    told = []
    for factored in (False, True):
        system = chain(count, factored=factored)
        cycle = itinerary_shape(system.structure, [("c0", "stop")] * 2)
        flat = numbers_of(system)[None]
        dwell, near = np.diff(motion.times)[-2:][None], motion.states[-3][None]
        found = solve_shape(cycle, flat, dwell, near, period)
        numbers = numbers_in(system)
        now = shoot(cycle, numbers, found.dwell[0], found.starts[0, 0], np)
        verdict = assess_cycle(cycle, system, now, found.dwell[0])
        fixed = np.empty((1, 0, len(start)))
        digits, _ = digits_of(cycle, flat, found, period, fixed)
        many = numbers_in(system.structure, flat)
        waves = phase_waves(cycle, many, found.starts[:, 1], found.dwell, 1)
        told.append((now, verdict, digits, waves))
    (one, motion_is, digits, waves), (other, same, fewer, again) = told
    for name in ("flows", "ends", "residual", "variational"):
        assert_allclose(getattr(other, name), getattr(one, name), rtol=0, atol=1e-11)
    assert (motion_is.verdict, same.verdict) == (True, True)
    assert digits[0] >= 10
    assert abs(digits[0] - fewer[0]) <= 1
    assert_allclose(again.coefficients, waves.coefficients, rtol=0, atol=1e-12)


def test_a_structure_alone_has_no_numbers() -> None:
    with pytest.raises(InputError, match="a structure alone has no numbers"):
        numbers_in(chain(2, factored=False).structure)

"""Orbits of more than 16 states: compiled as in Python."""

import numpy as np
import pytest

from nonsmooth.runtime.model.engine_layout import numbers_of
from nonsmooth.runtime.shooting.newton import CONVERGED
from nonsmooth.runtime.shooting.shooting_map import itinerary_shape
from nonsmooth.runtime.shooting.table_newton import solve_in_python, solve_shape
from nonsmooth.runtime.simulation.engines import compiled_engine
from nonsmooth.runtime.simulation.simulate import follow
from tests.large_systems import OMEGA, chain


@pytest.mark.skipif(compiled_engine() is None, reason="no compiled engine")
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
    found = solve_shape(cycle, flat, dwell * 1.001, near, period)
    known = solve_in_python(cycle, flat, dwell * 1.001, near, period)
    assert found.status.tolist() == known.status.tolist() == [CONVERGED]
    assert found.iterations.tolist() == known.iterations.tolist()
    np.testing.assert_allclose(found.dwell, known.dwell, rtol=0, atol=1e-12)
    np.testing.assert_allclose(found.starts, known.starts, rtol=0, atol=1e-12)
    np.testing.assert_allclose(found.maps, known.maps, rtol=0, atol=1e-11)
    # the simulated motion has come to this orbit
    np.testing.assert_allclose(found.dwell, dwell, rtol=0, atol=1e-5)

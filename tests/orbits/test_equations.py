"""Kernels and tables answer the same of one orbit, at one point and at many."""

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth.runtime.core.values import as_value
from nonsmooth.runtime.orbits.equations import OrbitEquations, equations_of
from nonsmooth.runtime.orbits.orbit import Orbit

NAMES = {
    "dry-friction/global-stick": "V",
    "dry-friction/symmetric": "V",
    "rigid-stop/one-impact": "k2",
    "elastic-stop/one-contact": "k3",
}


def _both(name: str) -> tuple[Orbit, Orbit]:
    """An orbit by its kernels and by the tables of its system."""
    orbit = ns.solve(name)
    return orbit, orbit.problem.by_tables(orbit)


def _points(equations: OrbitEquations, parameter: str) -> np.ndarray:
    """The orbit, and others of the itinerary beside it, by Newton's method."""
    place = equations.names.index(parameter)
    x, found = equations.values.copy(), [equations.values]
    unknowns = [equations.names.index(name) for name in equations.unknowns]
    for _ in range(3):
        x = x.copy()
        x[place] *= 1.001
        for _ in range(4):
            residual, jacobian = equations.linearised(x, place)
            x[unknowns] -= np.linalg.lstsq(jacobian[:, :-1], residual, rcond=None)[0]
        found.append(x)
    return np.array(found)


@pytest.mark.parametrize("name", NAMES)
def test_both_tell_the_same_along_a_family(name: str) -> None:
    one, other = (equations_of(orbit) for orbit in _both(name))
    first, second = _points(one, NAMES[name]), _points(other, NAMES[name])
    assert one.dwell(first) == pytest.approx(other.dwell(second), abs=1e-8)
    assert one.traces(first) == pytest.approx(other.traces(second), abs=1e-6)
    sizes = [
        np.sort(abs(each), axis=-1) for each in (one.multipliers(first), other.multipliers(second))
    ]
    count = min(size.shape[-1] for size in sizes)
    assert sizes[0][:, -count:] == pytest.approx(sizes[1][:, -count:], abs=1e-6)
    assert one.admissible(first).tolist() == other.admissible(second).tolist()
    assert one.phases == other.phases
    assert one.conservative == other.conservative


@pytest.mark.parametrize("name", NAMES)
def test_jacobians_are_those_of_the_left_hand_sides(name: str) -> None:
    for orbit in _both(name):
        equations = equations_of(orbit)
        place = equations.names.index(NAMES[name])
        places = [*(equations.names.index(n) for n in equations.unknowns), place]
        _, jacobian = equations.linearised(equations.values, place)
        step = 1e-6
        for column, at in enumerate(places):
            shift = step * np.eye(len(equations.names))[at]
            above, below = (
                equations.linearised(equations.values + sign * shift, place)[0] for sign in (1, -1)
            )
            slope = (above - below) / (2 * step)
            assert jacobian[:, column] == pytest.approx(slope, abs=1e-5 * max(1, abs(slope).max()))


@pytest.mark.parametrize("name", NAMES)
def test_both_take_the_same_system_and_period(name: str) -> None:
    orbit, same = _both(name)
    point = orbit.problem.physical(orbit)
    assert same.problem.physical(same).values == same.parameters == point.values
    assert not same.problem.physical(same).chosen
    periods = [each.problem.period(each) for each in (orbit, same)]
    assert periods[0] == periods[1]
    starts = [each.problem.system_start(each, point.values) for each in (orbit, same)]
    assert starts[0] == pytest.approx(starts[1], abs=1e-9)
    told = {**orbit.unknowns, **orbit.given, **orbit.opened}
    values = {n: as_value(told[n]) for n in orbit.problem.all_parameters if n in told}
    whole = orbit.problem.system_values({**values, **{n: point.values[n] for n in point.chosen}})
    assert whole == point.values


def test_an_orbit_at_a_point_is_the_one_that_was_followed() -> None:
    for orbit in _both("dry-friction/global-stick"):
        equations = equations_of(orbit)
        x = _points(equations, "V")[-1]
        given = {**orbit.given, "V": as_value(float(x[equations.names.index("V")]))}
        found = equations.orbit_at(x, given)
        assert found.converged
        assert found.period == pytest.approx(float(equations.dwell(x[None]).sum()), rel=1e-9)
        assert float(equations.motion_at(x, given)(0.1)[0]) == pytest.approx(
            float(found.motion()(0.1)[0]), abs=1e-9
        )

"""Kernels and tables answer the same of one orbit, at one point and at many."""

from typing import Any

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth.runtime.core.values import as_value
from nonsmooth.runtime.orbits.equations import equations_of
from tests.places import GALLERY

NAMES = {
    "dry-friction/global-stick": "V",
    "dry-friction/symmetric": "V",
    "rigid-stop/one-impact": "k2",
    "elastic-stop/one-contact": "k3",
}
DECLARED = tuple(
    f"{GALLERY}/{name}"
    for name in ("two_stops.py:symmetric", "backlash_gear.py:rattle", "two_belts.py:both-stick")
)


def _both(name: str) -> tuple[Any, Any]:
    """An orbit by its kernels and by the tables of its system."""
    orbit = ns.solve(name)
    return orbit, orbit.problem.by_tables(orbit)


def _points(equations: Any) -> np.ndarray:
    """The orbit, and others of the itinerary beside it, by Newton's method."""
    z, found = equations.first, [equations.first]
    for _ in range(3):
        z = z * np.append(np.ones(len(z) - 1), 1.001)
        for _ in range(4):
            residual, jacobian = equations.equations(z)
            z[:-1] -= np.linalg.lstsq(jacobian[:, :-1], residual, rcond=None)[0]
        found.append(z)
    return np.array(found)


@pytest.mark.parametrize("name", NAMES)
def test_both_tell_the_same_along_a_family(name: str) -> None:
    one, other = (equations_of(orbit, NAMES[name]) for orbit in _both(name))
    first, second = _points(one), _points(other)
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


@pytest.mark.parametrize("name", [*NAMES, *DECLARED])
def test_linearised_equations_tell_how_an_orbit_moves(name: str, backend: str) -> None:
    """By the implicit function theorem; sixty digits hold an orbit's derivatives elsewhere."""
    for orbit in _both(name) if name in NAMES else (ns.solve(name),):
        for by in {*orbit.given} - {"r" if "rigid" in name else ""}:  # no orbit where r < 1
            equations = equations_of(orbit, by)
            missed, jacobian = equations.equations(equations.first)
            assert missed == pytest.approx(0, abs=1e-9)
            moved, *_ = np.linalg.lstsq(jacobian[:, :-1], -jacobian[:, -1], rcond=None)
            rates = orbit.derivatives(by).unknowns
            wanted = np.array([rates[unknown][0] for unknown in equations.unknowns])
            assert moved == pytest.approx(wanted, rel=1e-8, abs=1e-8)


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
        equations = equations_of(orbit, "V")
        z = _points(equations)[-1]
        found = equations.at(z)
        assert found.given == {**orbit.given, "V": as_value(float(z[-1]))}
        assert found.converged
        assert found.period == pytest.approx(float(equations.dwell(z[None]).sum()), rel=1e-9)
        assert float(equations.motion(z)(0.1)[0]) == pytest.approx(
            float(found.motion()(0.1)[0]), abs=1e-9
        )

"""Derivatives of orbits by all that was given, against differences in many digits."""

import dataclasses
from fractions import Fraction

import numpy as np
import pytest
from numpy.testing import assert_allclose

import nonsmooth as ns
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.values import as_value
from tests.places import GALLERY

KERNELS = (
    "dry-friction/global-stick",
    "dry-friction/symmetric",
    "rigid-stop/one-impact",
    "elastic-stop/one-contact",
)
DECLARED = (
    f"{GALLERY}/impact_oscillator.py:two-periods",
    f"{GALLERY}/two_stops.py:symmetric",
    f"{GALLERY}/two_stops.py:broken",
    f"{GALLERY}/jenkins.py:yielding-both-ways",
    f"{GALLERY}/mass_on_belt.py:stick-slip",
    f"{GALLERY}/two_belts.py:both-stick",
)
STEP = Fraction(1, 10**18)


def differences(orbit, parameter, of):
    """Central differences of quantities of an orbit, refined to sixty digits."""
    sides = []
    for side in (1, -1):
        value = orbit.given[parameter].exact + side * STEP
        moved = dataclasses.replace(orbit, given={**orbit.given, parameter: as_value(value)})
        sides.append(of(ns.refine(moved, 60)))
    return [float((a - b) * 10**18 / 2) for a, b in zip(*sides, strict=True)]


def quantities(orbit):
    return [*orbit.unknowns.values(), orbit.period, orbit.trace]


@pytest.mark.parametrize("name", [*KERNELS, *DECLARED], ids=lambda name: name.split("/")[-1])
def test_derivatives_are_those_of_orbits_of_sixty_digits(name):
    orbit = ns.solve(name)
    found = orbit.derivatives()
    for place, parameter in enumerate(found.by):
        if orbit.given[parameter].exact is None:
            continue
        rates = [*found.unknowns.values(), found.period, found.trace]
        expected = differences(orbit, parameter, quantities)
        assert_allclose([rate[place] for rate in rates], expected, rtol=1e-11, atol=1e-11)


@pytest.mark.parametrize("name", [KERNELS[0], DECLARED[1], DECLARED[5]])
def test_a_refined_orbit_has_derivatives_of_its_own_digits(name):
    orbit = ns.solve(name)
    precise = ns.refine(orbit, 30).derivatives()
    doubles = orbit.derivatives()
    for quantity in (*orbit.unknowns, "period", "trace", "determinant", "spectral_radius"):
        _, rates = precise.quantity(quantity)
        assert_allclose(rates.astype(float), doubles.quantity(quantity)[1], rtol=1e-11, atol=1e-12)
    parameter = precise.by[-1]
    sides = []
    for side in (1, -1):
        value = orbit.given[parameter].exact + side * STEP
        moved = dataclasses.replace(orbit, given={**orbit.given, parameter: as_value(value)})
        sides.append(quantities(ns.refine(moved, 60)))
    rates = [*precise.unknowns.values(), precise.period, precise.trace]
    for rate, a, b in zip(rates, *sides, strict=True):
        assert abs(rate[-1] - (a - b) * 10**18 / 2) < 1e-29  # the differences' own h^2


def test_kernels_and_tables_agree_where_parameters_mean_the_same():
    orbit = ns.solve(KERNELS[0])
    kernels, tables = orbit.derivatives(), orbit.problem.by_tables(orbit).derivatives()
    pairs = {"chi": "chi", "eta": "eta", "V": "V", "e1": "ur1", "e2": "ur2"}
    for one, other in pairs.items():
        i, j = kernels.by.index(one), tables.by.index(other)
        assert_allclose(kernels.dwell_times[:, i], tables.dwell_times[:, j], atol=1e-12)
        assert kernels.trace[i] == pytest.approx(tables.trace[j], abs=1e-12)
        assert kernels.determinant[i] == pytest.approx(tables.determinant[j], abs=1e-12)


@pytest.mark.parametrize("name", [KERNELS[0], KERNELS[1], DECLARED[0], DECLARED[5]])
def test_functions_of_orbits_have_the_derivatives_that_they_give(name):
    orbit = ns.solve(name)
    by = tuple(orbit.given)[:2]
    of = [*orbit.unknowns, "period", "trace", "determinant", "spectral_radius"]
    function = ns.orbit_function(orbit, by=by, of=of)
    point = function.reference * 1.002
    step = 1e-6
    columns = [
        (function(point + step * unit) - function(point - step * unit)) / (2 * step)
        for unit in np.eye(2)
    ]
    assert_allclose(function.jacobian(point), np.stack(columns, axis=-1), rtol=2e-6, atol=2e-7)


def test_a_function_is_nan_where_the_orbit_is_not():
    function = ns.orbit_function(ns.solve(KERNELS[0]), by="eta", of="period")
    values, jacobian = function.value_and_jacobian([[1.01], [-3.0], [np.nan]])
    assert np.isfinite(values[0]).all()
    assert np.isfinite(jacobian[0]).all()
    assert np.isnan(values[1:]).all()
    assert np.isnan(jacobian[1:]).all()


def test_a_border_collision_is_differentiated_on_request():
    orbit = ns.solve("dry-friction/solution-ii")
    with pytest.raises(InputError, match=r"ta > 0.*one_sided"):
        orbit.derivatives()
    found = orbit.derivatives(one_sided=True)
    assert found.one_sided == "ta > 0"
    assert found.unknowns["tau"][0] == orbit.sensitivity(found.by[0]).unknowns["tau"]


def test_what_was_not_given_is_refused():
    with pytest.raises(InputError, match="unknown given parameter 'etta'"):
        ns.solve(KERNELS[0]).derivatives(["etta"])
    with pytest.raises(InputError, match="unknown quantity 'perio'"):
        ns.orbit_function(ns.solve(KERNELS[0]), by="eta", of="perio")

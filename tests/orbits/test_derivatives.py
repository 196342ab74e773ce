"""Derivatives of orbits by all that was given, against differences in many digits."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

import nonsmooth as ns
from nonsmooth import InputError
from tests.differences import in_digits, in_doubles
from tests.places import GALLERY
from tests.tables import slow

KERNELS = (
    "dry-friction/global-stick",
    "dry-friction/symmetric",
    "rigid-stop/one-impact",
    "elastic-stop/one-contact",
)
BORDER = "dry-friction/solution-ii"
EXCHANGED = (
    (("e1", "e2"), {"ta": 1, "tau": 2}),
    (("V",), {"z10": "1.2"}),
    (("chi", "eta"), {"tau1": "1.56", "tau2": "3.3"}),
    (("eta", "e1", "e2"), {"ta": "1.02", "tau": 2, "z20": "-2.69"}),
)
DECLARED = (
    f"{GALLERY}/impact_oscillator.py:two-periods",
    f"{GALLERY}/two_stops.py:symmetric",
    f"{GALLERY}/two_stops.py:broken",
    f"{GALLERY}/jenkins.py:yielding-both-ways",
    f"{GALLERY}/mass_on_belt.py:stick-slip",
    f"{GALLERY}/two_belts.py:both-stick",
)


def quantities(orbit):
    return [*orbit.unknowns.values(), orbit.period, orbit.trace]


@pytest.mark.parametrize(
    ("name", "exchange"),
    [
        *(pytest.param(name, ((), {}), id=name.split("/")[-1]) for name in (*KERNELS, BORDER)),
        *(pytest.param(KERNELS[0], exchange, id="-".join(exchange[0])) for exchange in EXCHANGED),
        *(
            slow(name, ((), {}), when=name.endswith(("both-ways", "both-stick")))
            for name in DECLARED
        ),
    ],
)
def test_derivatives_are_those_of_orbits_of_sixty_digits(name, exchange):
    orbit = ns.solve(name, unknown=exchange[0], given=exchange[1])
    found = orbit.derivatives(one_sided=True)
    for place, parameter in enumerate(found.by):
        if orbit.given[parameter].exact is None:
            continue
        rates = [*found.unknowns.values(), found.period, found.trace]
        expected = [*map(float, in_digits(orbit, parameter, quantities))]
        assert_allclose([rate[place] for rate in rates], expected, rtol=1e-11, atol=1e-11)
    for unknown in exchange[0]:
        with pytest.raises(InputError, match=unknown):
            orbit.derivatives(unknown)


@pytest.mark.parametrize("name", [KERNELS[0], BORDER, DECLARED[1], slow(DECLARED[5])])
def test_a_refined_orbit_has_derivatives_of_its_own_digits(name):
    orbit = ns.solve(name)
    precise = ns.refine(orbit, 30).derivatives(one_sided=True)
    doubles = orbit.derivatives(one_sided=True)
    for quantity in (*orbit.unknowns, "period", "trace", "determinant", "spectral_radius"):
        _, rates = precise.quantity(quantity)
        assert_allclose(rates.astype(float), doubles.quantity(quantity)[1], rtol=1e-11, atol=1e-12)
    parameter = precise.by[-1]
    rates = [*precise.unknowns.values(), precise.period, precise.trace]
    for rate, expected in zip(rates, in_digits(orbit, parameter, quantities), strict=True):
        assert abs(rate[-1] - expected) < 1e-29  # the differences' own h^2


@pytest.mark.parametrize("name", [KERNELS[0], KERNELS[1], DECLARED[0], DECLARED[5]])
def test_functions_of_orbits_have_the_derivatives_that_they_give(name):
    orbit = ns.solve(name)
    by = tuple(orbit.given)[:2]
    of = [*orbit.unknowns, "period", "trace", "determinant", "spectral_radius"]
    function = ns.orbit_function(orbit, by=by, of=of)
    point = function.reference * 1.002
    assert_allclose(function.jacobian(point), in_doubles(function, point), rtol=2e-6, atol=2e-7)


def test_a_function_is_nan_where_the_orbit_is_not():
    function = ns.orbit_function(ns.solve(KERNELS[0]), by="eta", of="period")
    values, jacobian = function.value_and_jacobian([[1.01], [-3.0], [np.nan]])
    assert np.isfinite(values[0]).all()
    assert np.isfinite(jacobian[0]).all()
    assert np.isnan(values[1:]).all()
    assert np.isnan(jacobian[1:]).all()


def test_a_border_collision_is_differentiated_on_request():
    orbit = ns.solve(BORDER)
    with pytest.raises(InputError, match=r"ta > 0.*one_sided"):
        orbit.derivatives()
    found = orbit.derivatives(one_sided=True)
    assert found.one_sided == "ta > 0"
    (alone,) = orbit.derivatives(found.by[0], one_sided=True).unknowns["tau"]
    assert found.unknowns["tau"][0] == pytest.approx(alone, rel=1e-12)


@pytest.mark.parametrize(
    ("names", "told"),
    [
        ([], "is named|etta"),
        ([5, "eta"], "text"),
        (["etta"], "'etta'"),
    ],
)
def test_names_that_are_none_are_refused_wherever_they_are_asked_for(names, told):
    orbit = ns.solve(KERNELS[0])
    motion = ns.solve("rigid-stop/one-impact").trajectory()
    for asked in (
        lambda: orbit.derivatives(names),
        lambda: ns.solve(KERNELS[0], {"eta": [1.0, 1.01]}, derivatives=names or "etta"),
        lambda: motion.derivatives(names),
        lambda: ns.orbit_function(orbit, by=names, of="period"),
        lambda: ns.certify(orbit, derivatives=names),
    ):
        with pytest.raises(InputError, match=told):
            asked()
    with pytest.raises(InputError, match="unknown quantity 'perio'"):
        ns.orbit_function(orbit, by="eta", of="perio")


@pytest.mark.parametrize("none", [(), [], np.array([])])
def test_no_names_are_no_derivatives_of_many(none):
    assert ns.solve(KERNELS[0], {"eta": [1.0, 1.01]}, derivatives=none).derivatives is None


ALONG = (
    f"{GALLERY}/two_belts.py:both-stick",
    f"{GALLERY}/piecewise_stiffness.py:doubled",
    f"{GALLERY}/impact_oscillator.py:three-periods",
    "dry-friction/global-stick",
    "elastic-stop/one-contact",
)


@pytest.mark.slow
@pytest.mark.parametrize("name", ALONG, ids=lambda name: name.split("/")[-1])
def test_what_is_seen_along_an_orbit_has_derivatives(name):
    """Extremes, forces, dissipation, margins: against differences of the values themselves.

    All parameters are moved at once, each by another size.
    """
    orbit = ns.solve(name)
    found = orbit.derivatives()
    given = [q for q in found.names if q not in found.unknowns]
    wanted = [q for q in given if q != "margin" or found.margins]
    function = ns.orbit_function(orbit, by=found.by, of=wanted)
    point, step = function.reference, 1e-6
    sizes = np.random.default_rng(len(wanted)).uniform(0.3, 1, len(found.by))
    expected = (function(point + step * sizes) - function(point - step * sizes)) / (2 * step)
    error = abs(function.jacobian(point) @ sizes - expected) / np.maximum(1, abs(expected))
    assert error.max() < 1e-6, wanted[int(np.argmax(error))]


@pytest.mark.parametrize("name", ALONG[:2], ids=lambda name: name.split("/")[-1])
def test_values_along_an_orbit_are_those_of_its_motion(name):
    orbit = ns.solve(name)
    found, seen = orbit.derivatives(), ns.observe(orbit.trajectory())
    for state in orbit.state_names:
        assert float(found.quantity(f"maximum:{state}")[0]) == pytest.approx(
            seen.maxima[state].value, abs=1e-12
        )
    lost = sum(contact.dissipated for contact in seen.contacts.values())
    assert found.quantity("dissipation")[0] == pytest.approx(lost, abs=1e-11)


def test_states_have_derivatives_at_fixed_times():
    orbit = ns.solve(ALONG[2])
    found, step = orbit.derivatives("w"), 1e-6
    times = np.array([0.2, 0.6]) * orbit.period
    sides = []
    for side in (1, -1):
        moved = {name: float(x) for name, x in orbit.given.items()}
        moved["w"] += side * step
        sides.append(ns.solve(ALONG[2], moved, dict(orbit.unknowns)).trajectory())
    fixed = (sides[0](times) - sides[1](times)) / (2 * step)
    assert_allclose(found.states(times)[..., 0], fixed, rtol=1e-6, atol=1e-6)
    precise = ns.refine(orbit, 25).derivatives("w")
    assert_allclose(precise.states(times).astype(float), found.states(times), atol=1e-12)


def test_margins_tell_of_the_next_grazing():
    """A forced mass that nearly strikes a second time: the inner maximum is its margin."""
    orbit = ns.solve(ALONG[2], {"w": "6.4", "sigma": "0.01", "r": "0.3"})
    (margin,) = orbit.derivatives().margins
    assert margin.boundary == "wall-reaches-stop"
    times = np.linspace(0, orbit.period, 20001)[200:-200]
    x = orbit.trajectory()(times)[:, 0]
    inside = x[1:-1][(x[1:-1] > x[:-2]) & (x[1:-1] > x[2:])]
    assert float(margin.value) == pytest.approx(0.01 - inside.max(), abs=1e-6)
    function = ns.orbit_function(orbit, by=("w", "sigma", "r"), of="margin")
    exact = function.jacobian(function.reference)
    assert_allclose(exact, in_doubles(function, function.reference), rtol=1e-6, atol=1e-8)
    assert abs(exact).min() > 1e-4


@pytest.mark.parametrize(
    "name",
    [
        *KERNELS,
        # their kernels are compiled first
        *(slow(name) for name in (DECLARED[0], DECLARED[4])),
        DECLARED[5],
    ],
)
def test_many_orbits_have_the_derivatives_of_each(name, backend):
    orbit = ns.solve(name)
    by = tuple(orbit.given)
    values = {name: float(value) for name, value in orbit.given.items()}
    values[by[0]] += np.array([0.0, 0.003, 1e3 if name == DECLARED[0] else -50.0])
    found = ns.solve(name, values, derivatives=by)
    assert found.converged.tolist() == [True, True, False]
    for place in (0, 1):
        point = {key: np.broadcast_to(x, 3)[place] for key, x in values.items()}
        single = ns.solve(name, point).derivatives(by)
        for quantity in (*orbit.unknowns, "period", "trace"):
            rates = [found.derivatives[quantity][p][place] for p in by]
            assert_allclose(rates, single.quantity(quantity)[1], rtol=1e-8, atol=1e-8)
    for rates in found.derivatives.values():
        assert all(np.isnan(rate[2]) for rate in rates.values())


@pytest.mark.parametrize("name", [KERNELS[0], KERNELS[2], *DECLARED])
def test_the_section_has_the_orbits_own_multipliers(name):
    orbit = ns.solve(name)
    section = orbit.derivatives().section
    nontrivial = [abs(complex(m.real, m.imaginary)) for m in orbit.stability.multipliers
                  if not m.trivial]  # fmt: skip
    assert section.spectral_radius == pytest.approx(max(nontrivial), abs=1e-10)
    product = np.prod(sorted(nontrivial, reverse=True)[: len(section.multipliers)])
    assert abs(section.determinant) == pytest.approx(product, abs=1e-10)


def test_extremes_have_derivatives_of_all_digits():
    """Where the extreme is has to be polished: a place in doubles leaves eight digits."""
    orbit = ns.solve(ALONG[2])
    precise = ns.refine(orbit, 30)
    along = precise.derivatives("r").along
    extreme = along.quantity("minimum:x")
    (state,), _ = along.states([extreme.time])
    assert abs(state[1]) < 1e-28  # its velocity
    rate = extreme.rates[0]
    (expected,) = in_digits(orbit, "r", lambda o: [o.derivatives("r").quantity("minimum:x")[0]], 50)
    assert abs(rate - expected) < 1e-28


def test_local_extremes_of_a_motion_that_turns_back_are_symmetric_in_time():
    """An elastic impact reverses time: an extreme near one end of the period is near the other."""
    orbit = ns.solve("rigid-stop/one-impact")
    found = orbit.derivatives().local_extremes("maximum:x2")
    times, values = (
        np.array([getattr(each, name) for each in found]) for name in ("time", "value")
    )
    rates = np.array([each.rates for each in found])
    assert_allclose(times + times[::-1], orbit.period, rtol=1e-12)
    assert_allclose(values, values[::-1], rtol=1e-12)
    assert_allclose(rates, rates[::-1], rtol=1e-9, atol=1e-9)

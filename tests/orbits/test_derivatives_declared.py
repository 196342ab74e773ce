"""Derivatives of orbits of declared systems: random ones, several forcings, families, exchanges."""

import dataclasses

import numpy as np
import pytest
import sympy as sp
from numpy.testing import assert_allclose

import nonsmooth as ns
from nonsmooth import InputError, NoConvergence
from nonsmooth.derive import Parameter, RigidStop, SoftStop
from nonsmooth.runtime.core.values import as_value
from tests.differences import in_digits, in_doubles
from tests.one_mass import one_mass

R, W, W2, Z, K = sp.symbols("r w w2 z k", positive=True)
FREQUENCY, DAMPING = Parameter("w", "frequency"), Parameter("z", "damping")


RIGID = RigidStop("x", at=0, restitution=R, name="wall")
PAD = SoftStop("x", at=sp.Rational(1, 10), stiffness=K, name="pad")


def struck(element, forces, *parameters):
    known = [DAMPING, FREQUENCY, *parameters]
    return one_mass("one-mass", element, forces=forces, damping=Z, parameters=known)


SYSTEMS = {
    "rigid": struck(RIGID, {W: 1}),
    "soft": struck(PAD, {W: 1}, Parameter("k", "stiffness")),
}
NAMES = {"rigid": ("r", "w", "z"), "soft": ("k", "w", "z")}
DATA = {"r": (0.3, 0.9), "w": (1.5, 6.0), "z": (0.05, 0.3), "k": (1.0, 9.0)}


def settled(system, values):
    """The orbit on which a motion settles."""
    motion = ns.simulate(system, values, {"x": -1.0, "v": 0.0}, until=600)
    return ns.solve(system, values, itinerary=ns.itinerary_of(motion))


def rates(orbit, parameter):
    """Of all unknowns, the period and the trace, in sixty digits."""
    found = in_digits(orbit, parameter, lambda o: [*o.unknowns.values(), o.period, o.trace])
    return [*map(float, found)]


def stacked(found, place):
    return [rate[place] for rate in (*found.unknowns.values(), found.period, found.trace)]


@pytest.mark.parametrize("kind", SYSTEMS)
@pytest.mark.parametrize("seed", range(4))
def test_orbits_of_random_systems_have_exact_derivatives(kind, seed):
    random, system = np.random.default_rng(100 + seed), SYSTEMS[kind]
    orbit = None
    while orbit is None or len(orbit.itinerary) > 9:
        values = {name: f"{random.uniform(*DATA[name]):.3f}" for name in NAMES[kind]}
        try:
            orbit = settled(system, values)
        except (InputError, NoConvergence):
            continue
    found = orbit.derivatives()
    for place, parameter in enumerate(found.by):
        expected = np.array(rates(orbit, parameter))
        scale = max(1.0, abs(expected).max())
        assert_allclose(stacked(found, place), expected, rtol=0, atol=1e-11 * scale)


def test_several_forcings_are_in_tune_or_refused():
    fifth = sp.Rational(1, 5)
    system = struck(RIGID, {W: 1, W2: fifth}, Parameter("w2", "another frequency"))
    orbit = settled(system, {"r": "0.6", "w": "2.4", "w2": "7.2", "z": "0.1"})
    found = orbit.derivatives(["z", "r"])
    for place, parameter in enumerate(found.by):
        assert_allclose(stacked(found, place), rates(orbit, parameter), rtol=1e-10, atol=1e-10)
    for alone in ("w", "w2"):
        with pytest.raises(InputError, match=f"{alone} changes alone.*out of tune"):
            orbit.derivatives(alone)
    orbit = settled(struck(RIGID, {W: 1, 3 * W: fifth}), {"r": "0.6", "w": "2.4", "z": "0.1"})
    assert_allclose(stacked(orbit.derivatives("w"), 0), rates(orbit, "w"), rtol=1e-10, atol=1e-10)


def test_the_period_is_a_number_of_a_family_alone():
    orbit = ns.solve("elastic-stop/one-contact")
    tables = orbit.problem.by_tables(orbit)
    own, by_tables = orbit.derivatives("T"), tables.derivatives("period")
    assert own.unknowns["tau"][0] == pytest.approx(by_tables.unknowns["tau1"][0], abs=1e-10)
    free = dataclasses.replace(tables, given=tables.parameters)
    with pytest.raises(InputError, match="one of a family of orbits: give its period"):
        free.derivatives("k2")
    forced = settled(SYSTEMS["rigid"], {"r": "0.6", "w": "2.4", "z": "0.1"})
    timed = dataclasses.replace(
        forced, given={**forced.given, "period": as_value(float(forced.period))}
    )
    with pytest.raises(InputError, match="the period follows from the forcing"):
        timed.derivatives("period")


def test_exchanged_orbits_have_derivatives_along_their_motion():
    name, given = "dry-friction/global-stick", {"ta": 1, "tau": 2}
    orbit = ns.solve(name, unknown=["e1", "e2"], given=given)
    of = ["e1", "maximum:x1", "margin", "period"]
    function = ns.orbit_function(orbit, by=["ta", "V"], of=of)
    point = function.reference
    assert_allclose(function.jacobian(point), in_doubles(function, point), atol=1e-7)
    ours = orbit.derivatives().quantity("maximum:x1")[1]
    precise = ns.refine(orbit, 30).derivatives().quantity("maximum:x1")[1]
    assert_allclose(precise.astype(float), ours, rtol=1e-11)


@pytest.mark.slow
def test_along_a_border_collision_both_boundaries_stay_together():
    """What is solved for, e1, keeps the collision: all against differences."""
    name = "dry-friction/solution-ii"
    orbit = ns.solve(name)
    found = orbit.derivatives(one_sided=True)
    wanted = [q for q in found.names if q not in found.unknowns]

    def values(parameter, step):
        given = {key: float(x) for key, x in orbit.given.items()}
        given[parameter] += step
        moved = ns.solve(name, given, dict(orbit.unknowns)).derivatives(one_sided=True)
        return np.array([float(moved.quantity(q)[0]) for q in wanted])

    exact = np.array([found.quantity(q)[1] for q in wanted])
    for place, parameter in enumerate(found.by):
        expected = (values(parameter, 1e-6) - values(parameter, -1e-6)) / 2e-6
        assert_allclose(exact[:, place], expected, atol=2e-8)
    precise = ns.refine(orbit, 30).derivatives(one_sided=True).quantity("maximum:x1")[1]
    assert_allclose(precise.astype(float), found.quantity("maximum:x1")[1], rtol=1e-11)


def test_many_orbits_of_a_border_collision_are_refused_by_name():
    with pytest.raises(InputError, match="border collision"):
        ns.solve("dry-friction/solution-ii", {"V": [1.0, 1.01]}, derivatives="V")

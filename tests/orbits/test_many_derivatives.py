"""Derivatives of batches: what has none, and what no point owes to its neighbours."""

import numpy as np
import pytest
import sympy as sp
from numpy.testing import assert_array_equal

import nonsmooth as ns
from nonsmooth.derive import Parameter, RigidStop
from nonsmooth.runtime.model.kernels import compiled_engine
from tests.one_mass import one_mass
from tests.places import GALLERY
from tests.shifting_systems import GEARED, TURNED, settled_orbit


def scattered(values, count, width=1e-4):
    random = np.random.default_rng(5)
    return {
        name: value * (1 - width * random.uniform(0, 1, count)) for name, value in values.items()
    }


@pytest.mark.compiled  # its orbit is found by simulation
def test_a_direction_that_turns_with_a_parameter_has_its_share():
    """Wheels with teeth turn freely along (i, 1), where i is the ratio of their gear."""
    orbit = settled_orbit(GEARED, TURNED)
    data, guess = {"i": TURNED["i"]}, [*orbit.dwell_times, *orbit.states[0]]

    def solved(i):
        return ns.solve(GEARED, {**TURNED, "i": i}, guess, itinerary=orbit.itinerary)

    values = {**TURNED, "i": [TURNED["i"]]}
    options = {"itinerary": orbit.itinerary, "multipliers": True}
    found = ns.solve(GEARED, values, guess, derivatives=list(data), **options).derivatives
    above, below = solved(TURNED["i"] + 1e-5), solved(TURNED["i"] - 1e-5)
    pairs = {name: (above.unknowns[name], below.unknowns[name]) for name in orbit.unknowns}
    pairs["trace"] = above.trace, below.trace
    for side in (above, below):
        assert side.shift == pytest.approx(dict.fromkeys(side.shift, 0), abs=1e-12)
    for name, (one, other) in pairs.items():
        assert found[name]["i"][0] == pytest.approx((one - other) / 2e-5, abs=1e-8), name
    assert abs(found["trace"]["i"][0]) > 0.1


@pytest.mark.parametrize("rate", [1, 10**12])
def test_a_forcing_out_of_tune_has_no_derivative_in_any_unit(rate):
    """The orbit of two forcings whose frequencies have the ratio 3 is lost where one changes."""
    w, w2, r = sp.symbols("w w2 r")
    system = one_mass(
        f"tuned-{rate}", RigidStop("x", at=sp.Rational(1, 8), restitution=r), stiffness=rate**2,
        damping=sp.Rational(rate, 5), forces={w: rate**2, w2: sp.Rational(rate**2, 5)},
    )  # fmt: skip
    data = {"w": 2.4 * rate, "w2": 7.2 * rate, "r": 0.6}
    motion = ns.simulate(system, data, [0, 0, 1, 0, 1, 0], transitions=400)
    orbit = ns.solve(system, data, itinerary=ns.itinerary_of(motion))
    assert have_derivatives(orbit, data) == {"w": False, "w2": False, "r": True}


@pytest.mark.parametrize("engine", [pytest.param("c", marks=pytest.mark.compiled), "numpy"])
@pytest.mark.parametrize("rate", [1, 10**12])
def test_a_family_that_is_lost_has_no_derivative_in_any_unit(engine, rate, monkeypatch):
    """Of a mass that loses nothing at its stop: no period is left where it is damped."""
    monkeypatch.setenv("NONSMOOTH_BACKEND", engine)
    k = sp.Symbol("k")
    c = Parameter("c", "a damping", lower=0, closed=True)
    system = one_mass(
        f"lossless-{rate}", RigidStop("x", at=sp.Rational(1, 2), restitution=1),
        stiffness=k * rate**2, damping=c.symbol, parameters=(c,),
    )  # fmt: skip
    data = {"c": 0, "k": 1}
    orbit = ns.solve(
        system, data, {"tau1": 4.2 / rate, "x": 0.5, "v": -0.9 * rate},
        itinerary=[("free", "x-upper-reaches-stop")], given={"period": 4.2 / rate},
    )  # fmt: skip
    assert have_derivatives(orbit, data) == {"c": False, "k": True}


def have_derivatives(orbit, data):
    """Of many orbits, of which this is one, by parameters; the last one is given as an array."""
    *_, (name, value) = data.items()
    found = ns.solve(
        orbit.system, {**data, name: [value]}, [*orbit.dwell_times, *orbit.states[0]],
        itinerary=orbit.itinerary, derivatives=list(data), given={
            name: value for name, value in orbit.given.items() if name == "period"
        },
    )  # fmt: skip
    return {by: bool(np.isfinite(found.derivatives["trace"][by][0])) for by in data}


@pytest.mark.parametrize(
    ("name", "tables", "by"),
    [
        ("dry-friction/global-stick", False, ["eta", "V"]),
        ("dry-friction/global-stick", True, ["eta", "V"]),
        (f"{GALLERY}/backlash_gear.py:rattle", True, ["J", "k"]),
        (f"{GALLERY}/two_stops.py:symmetric", True, ["d", "r"]),
    ],
    ids=["kernels", "tables", "rattle", "symmetric"],
)
def test_no_point_depends_on_its_neighbours(name, tables, by):
    orbit, options = ns.solve(name), {}
    system, given = name, orbit.given
    if tables:
        orbit = orbit.problem.by_tables(orbit)
        system, given = orbit.problem.system, orbit.parameters
        options = {"itinerary": orbit.itinerary, "multipliers": True}
        options["guess"] = [*map(float, orbit.dwell_times), *map(float, orbit.states[0])]
    count = 600 if "friction" in name else 40
    values = {key: float(value) for key, value in given.items() if key != "period"}
    values |= scattered({key: values[key] for key in by}, count)
    order = np.random.default_rng(1).permutation(count)[: count - 3]
    whole = ns.solve(system, values, derivatives=by, **options)
    for chosen in (order, order[:1]):
        given = values | {key: values[key][chosen] for key in by}
        part = ns.solve(system, given, derivatives=by, **options)
        for quantity, rates in whole.derivatives.items():
            for key, rate in rates.items():
                assert_array_equal(rate[chosen], part.derivatives[quantity][key])


@pytest.mark.compiled
def test_arrays_that_do_not_fit_are_refused():
    engine = compiled_engine()
    places = [[0, 1, 1, 2, 2], [0, 14], [0, 1], []]  # two phases, two directions, two states
    sizes = [2, 2, 12, 6, 12, 2, 4, 4, 2, 4, 8]

    def given():
        integers = [np.array(part, dtype=np.int32) for part in places]
        return [*integers, *(np.zeros(size) for size in sizes)]

    counts = (1, 2, 2, 2, 2, False)
    engine.move(*counts, *given())
    for place in {*range(len(places) + len(sizes))} - {3}:
        wrong = given()
        wrong[place] = np.append(wrong[place], wrong[place][:1])
        with pytest.raises(ValueError, match=r"wrong size|not of this cycle"):
            engine.move(*counts, *wrong)
    for place, entry in ((0, 3), (1, 15), (1, -1), (2, 2)):
        wrong = given()
        wrong[place][1] = entry
        with pytest.raises(ValueError, match="not of this cycle"):
            engine.move(*counts, *wrong)
    for forcing in ([0], [0, 2]):
        wrong = given()
        wrong[3] = np.array(forcing, dtype=np.int32)
        with pytest.raises(ValueError, match="not of this cycle"):
            engine.move(*counts, *wrong)
    with pytest.raises(ValueError, match="wrong numbers"):
        engine.move(-1, *counts[1:], *given())
    arrays = [np.zeros(size) for size in (2, 12, 6, 12, 0, 0, 0, 6, 4, 4, 2, 8, 8)]
    engine.shoot(1, 2, 2, *arrays)
    for place, array in enumerate(arrays):
        with pytest.raises(ValueError, match="wrong size"):
            engine.shoot(1, 2, 2, *arrays[:place], np.append(array, 0.0), *arrays[place + 1 :])
    for few in ((-1, 2, 2), (1, 0, 2), (1, 2, 0)):
        with pytest.raises(ValueError, match="wrong numbers"):
            engine.shoot(*few, *arrays)

"""Orbits of any itinerary, composed from the system's numbers."""

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from nonsmooth import InputError, NoConvergence, refine, solve
from nonsmooth.derive import RigidStop
from nonsmooth.runtime.model.engine_layout import layout_of, numbers_of
from nonsmooth.runtime.model.kernels import compiled_engine
from tests.engines import with_both
from tests.one_mass import one_mass
from tests.places import GALLERY
from tests.shifting_systems import (
    CAPSULE,
    GEARED,
    PULLED,
    SHAKEN,
    SLED,
    TURNED,
    settled_orbit,
)  # fmt: skip
from tests.two_masses import CHAIN, PHASES, RUBBING, STICKING

STICK_GUESS = [1.02, 2.0, 1.57, 3.28]
SYMMETRIC = [("slip-slip", "second-reaches-belt"), ("slip-stick", "second-breaks-forward")]
SYMMETRIC_GUESS = [2.65, 2.24]
CONTACT = [("contact", "first-leaves-stop"), ("free", "first-reaches-stop")]
IMPACT = [("free", "first-reaches-stop")]
MANY = STICKING | {"V": [1.0, 1.01]}


def stick(**changes):
    return solve("dry-friction", STICKING | changes, STICK_GUESS, itinerary=PHASES)


def turned(sequence, first):
    return [*sequence[first:], *sequence[:first]]


def test_admissibility_is_the_kernels():
    random = np.random.default_rng(7)
    seen = set()
    for _ in range(40):
        us1, us2 = random.uniform(0.2, 2, 2)
        data = {"chi": 0.5, "us1": us1, "us2": us2, "ur1": us1 + random.uniform(2.5, 3.5)}
        data |= {"ur2": us2 + random.uniform(0.1, 0.8)}
        data |= {"eta": random.uniform(0.6, 1.4), "V": random.uniform(0.6, 1.4)}
        kernels = solve("dry-friction/global-stick", data, throw=False)
        if not kernels.converged:
            continue
        orbit = solve("dry-friction", data, kernels.dwell_times.tolist(), itinerary=PHASES)
        assert orbit.trace == pytest.approx(kernels.trace, rel=1e-10, abs=1e-10)
        assert orbit.stability.verdict == kernels.stability.verdict
        assert orbit.admissibility.verdict == kernels.admissibility.verdict
        found = {(v.phase, v.boundary) for v in orbit.admissibility.violations if v.excess > 0}
        assert found == {(v.phase, v.boundary) for v in kernels.admissibility.violations}
        seen.add(orbit.admissibility.verdict)
    assert seen == {True, False}


def test_a_transition_that_the_conditions_refuse():
    # with us1 + us2 as small as that the second mass, at the belt, is torn off at once
    data = {"chi": 0.5, "eta": 1, "V": 1, "us1": 0.3, "us2": 0.3, "ur1": 3.3, "ur2": 0.7}
    kernels = solve("dry-friction/global-stick", data)
    orbit = solve("dry-friction", data, kernels.dwell_times.tolist(), itinerary=PHASES)
    refused = [(v.phase, v.boundary) for v in orbit.admissibility.violations if v.excess == 0]
    assert refused == [(3, "second-reaches-belt")]


@pytest.mark.compiled
@pytest.mark.parametrize(("guided", "threads"), [(False, None), (True, 2)])
def test_compiled_as_in_python_whatever_the_threads(guided, threads):
    random = np.random.default_rng(11)
    eta, speed = 1 + 0.05 * random.uniform(-1, 1, (2, 50))
    eta[7] = -1  # outside its domain
    data = STICKING | {"eta": eta, "V": speed}
    guess = [*STICK_GUESS, *(stick().states[0] if guided else ())]
    compiled, python = with_both(
        solve, "dry-friction", data, guess, itinerary=PHASES, threads=threads, multipliers=True
    )
    assert compiled.converged.tolist() == python.converged.tolist() == [k != 7 for k in range(50)]
    assert "domain" in compiled.message(compiled.status[7])
    assert_array_equal(compiled.status, python.status)
    assert_array_equal(compiled.admissible, python.admissible)
    for name in ("dwell_times", "starts", "trace", "multipliers", "margin", "residual"):
        found, wanted = (getattr(each, name) for each in (compiled, python))
        assert_allclose(found, wanted, rtol=0, atol=1e-12, err_msg=name)
    whole = solve("dry-friction", data, guess, itinerary=PHASES, threads=1, multipliers=True)
    for name in ("dwell_times", "starts", "trace", "multipliers"):
        assert_array_equal(getattr(compiled, name), getattr(whole, name))


@pytest.mark.parametrize(
    ("system", "data", "itinerary", "guess", "period", "status"),
    [
        ("dry-friction", STICKING, PHASES, STICK_GUESS, None, "converged"),
        ("dry-friction", STICKING, PHASES, STICK_GUESS, 8, "not converged"),
        ("dry-friction", STICKING, PHASES, [0.1] * 4, None, "dwell time goes to zero"),
        ("elastic-stop", CHAIN | {"k3": 1}, CONTACT, [2.1, 4.2], None, "singular"),
        ("elastic-stop", CHAIN | {"k3": 1}, CONTACT, [2.1, 4.2], 2 * np.pi, "converged"),
        ("rigid-stop", CHAIN | {"r": 1}, IMPACT, [6.2], None, "singular"),
        ("rigid-stop", CHAIN | {"r": 1}, IMPACT, [6.2], 2 * np.pi, "converged"),
    ],
)
def test_either_solver_gives_every_status(backend, system, data, itinerary, guess, period, status):
    given = {} if period is None else {"period": period}
    one = solve(system, data, guess, itinerary=itinerary, given=given, throw=False)
    many = solve(system, data, [guess], itinerary=itinerary, given=given)
    assert many.status.tolist() == [one.status]
    assert status in one.message
    assert one.converged == (status == "converged")


@pytest.mark.compiled
def test_what_is_lost_at_the_very_last_step_is_said_to_be_lost():
    """Dwell times grow fourfold at each step, exponential motions along them beyond any number."""
    wall = RigidStop("x", at=1, restitution=1, name="wall")
    falling = one_mass("falling", wall, stiffness=-1)
    guesses = [[dwell, 1.0, -1e-3] for dwell in np.geomspace(1e-17, 1e-15, 40)]
    phases = [("free", "wall-reaches-stop")]
    found, python = with_both(solve, falling, {}, guesses, itinerary=phases, given={"period": 1e4})
    assert_array_equal(found.status, python.status)
    told = [found.message(status).partition(":")[0] for status in found.status.tolist()]
    assert {*told} == {"not converged", "not finite"}
    assert 32 in found.iterations[np.array(told) == "not finite"]


def itineraries():
    """Orbits by tables, with what is varied.

    Two masses stick, one is pulled or turns on, a box goes on as its mass strikes it, wheels turn
    along a direction of which a parameter tells, one orbit is symmetric, one of a family.
    """
    sled = settled_orbit(SLED, PULLED, [0, 1, 0, 0.4])
    gear = solve(f"{GALLERY}/backlash_gear.py:rattle")
    soft = solve("elastic-stop/one-contact")
    return [
        (stick(), {"eta": np.linspace(0.95, 1.05, 3)[:, None], "V": [0.98, 1.02]}),
        (sled, {"V": [0.5, 0.51]}),
        (gear, {"c": [0.0998, 0.1, 0.1002]}),
        (solve(f"{GALLERY}/two_stops.py:symmetric"), {"r": [0.79, 0.8]}),
        (soft.problem.by_tables(soft), {"k3": [1.0, 1.001], "m1": 1.001}),
        (settled_orbit(CAPSULE, SHAKEN), {"k": [0.5, 0.4999], "r": 0.4999}),
        (settled_orbit(GEARED, TURNED), {"i": [1.5, 1.5001], "w": 1.1}),
    ]


@pytest.mark.slow
@pytest.mark.compiled  # some of its orbits are found by simulation
@pytest.mark.parametrize("engine", ["c", "numpy"])
def test_many_points(engine, monkeypatch):
    for orbit, varied in itineraries():
        system, phases, by = orbit.problem.system, orbit.itinerary, list(varied)
        data = {name: float(value) for name, value in orbit.parameters.items()} | varied
        guess = [*map(float, orbit.dwell_times), *map(float, orbit.states[0])]
        options = {"given": {"period": float(orbit.period)} if orbit.tables.family else {}}
        options["itinerary"] = phases
        monkeypatch.setenv("NONSMOOTH_BACKEND", engine)
        many = solve(system, data, guess, multipliers=True, derivatives=by, **options)
        shape = np.broadcast_shapes(*(np.shape(array) for array in varied.values()))
        assert many.converged.all()
        assert many.converged.shape == many.admissible.shape == shape
        assert many.dwell_times.shape == (*shape, len(phases))
        assert many.starts.shape == (*shape, len(phases), len(orbit.states[0]))
        for place in np.ndindex(shape):
            point = {n: float(np.broadcast_to(a, shape)[place]) for n, a in data.items()}
            one = solve(system, point, guess, **options)
            assert_allclose(many.dwell_times[place], one.dwell_times, rtol=1e-10)
            assert_allclose(many.starts[place], one.states, atol=1e-9)
            assert many.trace[place] == pytest.approx(one.trace, abs=1e-8)
            missing = many.multipliers.shape[-1] - len(one.multipliers)
            mine = np.append(one.multipliers, np.zeros(missing))
            assert_allclose(many.multipliers[place], mine, atol=1e-8)
            assert many.margin[place] == pytest.approx(one.stability.margin, abs=1e-9)
            assert bool(many.admissible[place]) is one.admissibility.verdict
            wanted = one.derivatives(by)
            for quantity, rates in many.derivatives.items():
                mine = [rates[name][place] for name in by]
                expected = wanted.quantity(quantity)[1]
                assert_allclose(mine, expected, rtol=1e-8, atol=1e-8, err_msg=quantity)
        assert {"determinant", "spectral_radius"} <= {*many.derivatives}
        monkeypatch.delenv("NONSMOOTH_BACKEND")


@pytest.mark.parametrize("first", range(4))
def test_a_guess_of_the_state_is_taken_where_the_orbit_starts(first):
    # the engine starts from another phase: an exact guess is exact there too
    phases = turned(PHASES, first)
    exact = solve("dry-friction", STICKING, turned(STICK_GUESS, first), itinerary=phases)
    kernels = solve("dry-friction/global-stick")
    assert_allclose(exact.dwell_times, turned(kernels.dwell_times.tolist(), first), atol=1e-13)
    assert exact.multipliers[0] == pytest.approx(kernels.trace, abs=1e-13)
    assert not exact.multipliers[1:].any()
    guess = [*exact.dwell_times, *exact.states[0]]
    again = solve("dry-friction", STICKING, guess, itinerary=phases)
    assert again.converged
    assert again.iterations == 1


def test_no_points_and_lost_points():
    for shape in ((0,), (2, 0), (0, 3)):
        empty = {"V": np.empty(shape)}
        none = solve("dry-friction", STICKING | empty, STICK_GUESS, itinerary=PHASES)
        assert none.dwell_times.shape == (*shape, 4)
        assert none.status.shape == none.admissible.shape == none.trace.shape == shape
    lost = solve("dry-friction", STICKING | {"V": [-1, 1]}, STICK_GUESS, itinerary=PHASES)
    assert lost.converged.tolist() == [False, True]
    assert np.isnan(lost.dwell_times[0]).all()
    assert np.isnan(lost.trace[0])
    assert "domain" in lost.message(lost.status[0])


@pytest.mark.parametrize(
    ("orbit", "data", "itinerary", "guess", "period"),
    [
        ("dry-friction/global-stick", STICKING, PHASES, STICK_GUESS, None),
        ("dry-friction/symmetric", RUBBING, SYMMETRIC, SYMMETRIC_GUESS, None),
        ("elastic-stop/one-contact", CHAIN | {"k3": 1}, CONTACT, [2.1, 4.2], "2*pi"),
        ("rigid-stop/one-impact", CHAIN | {"r": 1}, IMPACT, [6.2], "2*pi"),
    ],
)
@pytest.mark.parametrize("digits", [15, 40])
def test_an_orbit_by_tables_is_the_one_of_the_kernels(
    orbit, data, itinerary, guess, period, digits
):
    given = {} if period is None else {"period": period}
    system = orbit.partition("/")[0]
    found = solve(system, data, guess, itinerary=itinerary, given=given, digits=digits)
    kernels = solve(orbit)
    kernels = kernels if digits == 15 else refine(kernels, digits)
    limit = 10.0 ** -(13 if digits == 15 else 38)
    for one, other in zip(found.dwell_times, kernels.dwell_times, strict=True):
        assert abs(one - other) < limit
    origin = [0] * 4 if "stop" in orbit else centre(found.values)
    for one, other, shift in zip(found.states[0], kernels.states[0], origin, strict=True):
        assert abs(one - other - shift) < 10 * limit
    assert abs(found.trace - kernels.trace) < 100 * limit
    assert found.residual < limit
    assert found.stability.verdict == kernels.stability.verdict
    assert found.stability.rank == kernels.stability.rank
    if period is None:
        assert abs(np.trace(found.poincare_jacobian) - found.trace) < 1e-11
    assert found.tables.family == (period is not None)
    for one, other in zip(found.stability.multipliers, kernels.stability.multipliers, strict=True):
        assert abs(one.real - other.real) + abs(one.imaginary - other.imaginary) < 100 * limit
        assert one.trivial == other.trivial
    assert found.admissibility.verdict is True


def centre(values):
    """Where the paper's positions z of the masses on the belt are zero."""
    chi, us1, us2 = (values[name] for name in ("chi", "us1", "us2"))
    return [(us1 + us2) / (1 - chi), (chi * us1 + us2) / (chi * (1 - chi)), 0, 0]


def test_units_change_no_verdict():
    # a thousand times heavier and a million million times stiffer: time in other units
    data = {"m1": 1e3, "m2": 2e3, "k1": 1e15, "k2": 5e15, "k3": 1e15}
    orbit = solve(
        "elastic-stop", data, [2.1e-6, 4.2e-6], itinerary=CONTACT, given={"period": 2e-6 * np.pi}
    )
    assert orbit.converged
    assert orbit.stability.verdict == "neutral"
    free = solve("elastic-stop", data, [2.1e-6, 4.2e-6], itinerary=CONTACT, digits=40, throw=False)
    assert free.message.startswith("singular")
    assert not free.converged
    assert "give its period" in free.message
    assert free.tables.family
    assert free.residual < 1e-12 * 1e6  # a member of the family, whose speeds are that large
    assert free.stability.verdict == "neutral"


def test_a_period_that_no_orbit_has():
    problem = {"itinerary": PHASES, "given": {"period": 8}}
    with pytest.raises(NoConvergence, match="period"):
        solve("dry-friction", STICKING, STICK_GUESS, **problem)
    orbit = solve("dry-friction", STICKING, STICK_GUESS, **problem, throw=False)
    assert "period" in orbit.message
    with pytest.raises(InputError, match="no orbit"):
        _ = orbit.stability
    with pytest.raises(InputError, match="no orbit"):
        _ = orbit.admissibility


@pytest.mark.compiled
def test_the_engine_checks_its_arrays():
    engine, system, cycle = compiled_engine(), stick().tables.piecewise, stick().tables.cycle
    layout, flat = layout_of(system.structure), numbers_of(system)[None]
    one = np.zeros(1)
    arrays = [np.array([STICK_GUESS]), np.zeros((1, 4, 4)), np.zeros((1, 4, 4)), one.copy()]
    arrays += [np.zeros(1, dtype=np.int32), np.zeros(1, dtype=np.int32)]
    wrong = cycle.packed.copy()
    wrong[0] = 99
    for part, message in ((wrong, "not of this layout"), (cycle.packed[:5], "cycle")):
        with pytest.raises(ValueError, match=message):
            engine.compose(layout, part, one, flat, *arrays, False)
    for place, name in enumerate(("dwell", "starts", "maps", "residuals")):
        short = list(arrays)
        short[place] = np.zeros(0)
        with pytest.raises(ValueError, match=name):
            engine.compose(layout, cycle.packed, one, flat, *short, False)
    with pytest.raises(ValueError, match="numbers"):
        engine.compose(layout, cycle.packed, one, flat[:, 1:].copy(), *arrays, False)

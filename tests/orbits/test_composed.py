"""Orbits of any itinerary, composed from the system's numbers."""

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from nonsmooth import InputError, NoConvergence, refine, solve
from nonsmooth.derive import RigidStop, oscillator
from nonsmooth.runtime.model.kernels import compiled_engine, load_system
from nonsmooth.runtime.model.parameters import parameter_points
from nonsmooth.runtime.model.piecewise import numbers_at
from nonsmooth.runtime.model.structure import structure_of
from nonsmooth.runtime.shooting import table_newton
from nonsmooth.runtime.shooting.newton import CONVERGED, INVALID, NEGATIVE, SINGULAR, STALLED
from nonsmooth.runtime.shooting.shooting_map import itinerary_shape, numbers_in, shoot
from nonsmooth.runtime.shooting.table_newton import solve_in_python, solve_shape
from tests.two_masses import CHAIN, PHASES, RUBBING, STICKING

STICK_GUESS = [1.02, 2.0, 1.57, 3.28]
SYMMETRIC = [("slip-slip", "second-reaches-belt"), ("slip-stick", "second-breaks-forward")]
SYMMETRIC_GUESS = [2.65, 2.24]
CONTACT = [("contact", "first-leaves-stop"), ("free", "first-reaches-stop")]
IMPACT = [("free", "first-reaches-stop")]
TRACE = -0.980114981284158715

needs_engine = pytest.mark.skipif(compiled_engine() is None, reason="the engine is not compiled")


def stick(**changes):
    return solve("dry-friction", STICKING | changes, STICK_GUESS, itinerary=PHASES)


def turned(sequence, first):
    return [*sequence[first:], *sequence[:first]]


@pytest.mark.parametrize("first", range(4))
def test_global_stick_from_every_phase(first):
    kernels = solve("dry-friction/global-stick")
    orbit = solve(
        "dry-friction",
        STICKING,
        turned(STICK_GUESS, first),
        itinerary=turned(PHASES, first),
    )
    wanted = turned(kernels.dwell_times.tolist(), first)
    assert orbit.converged
    assert_allclose(orbit.dwell_times, wanted, rtol=0, atol=1e-13)
    assert orbit.trace == pytest.approx(TRACE, abs=1e-13)
    assert orbit.multipliers[0] == pytest.approx(TRACE, abs=1e-13)
    assert not orbit.multipliers[1:].any()
    assert np.trace(orbit.poincare_jacobian) == pytest.approx(TRACE, abs=1e-12)
    assert orbit.stability.rank == 1
    assert orbit.stability.verdict == "stable"
    assert orbit.admissibility.verdict is True


def test_start_section_and_physical_coordinates():
    orbit, kernels = stick(), solve("dry-friction/global-stick")
    assert orbit.multipliers.shape == (2,)  # as the kernels': behind it both masses are stuck
    chi, us1, us2 = 0.5, 1.0, 1.0
    origin = [(us1 + us2) / (1 - chi), (chi * us1 + us2) / (chi * (1 - chi)), 0, 0]
    assert_allclose(orbit.states, kernels.states + origin, rtol=0, atol=1e-12)


def test_many_phases():
    once = solve("dry-friction", RUBBING, SYMMETRIC_GUESS, itinerary=SYMMETRIC)
    orbit = solve("dry-friction", RUBBING, SYMMETRIC_GUESS * 15, itinerary=SYMMETRIC * 15)
    assert orbit.converged
    assert_allclose(orbit.dwell_times, np.tile(once.dwell_times, 15), atol=1e-12)
    assert orbit.multipliers[0].real == pytest.approx(once.multipliers[0].real ** 15, rel=1e-11)


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


def test_linearisation_against_finite_differences():
    orbit = stick()
    numbers, cycle, step = numbers_in(orbit.tables.piecewise), orbit.tables.cycle, 1e-6
    now = orbit.tables.shooting
    for k, unit in enumerate(np.eye(4)):
        moved = []
        for sign in (1, -1):
            change = now.rates[:, :-1] @ (sign * step * unit)
            moved.append(
                shoot(
                    cycle,
                    numbers,
                    orbit.dwell_times + change,
                    orbit.states[0] + sign * step * unit,
                    np,
                )
            )
        slopes = (moved[0].starts[-1] - moved[1].starts[-1]) / (2 * step)
        assert_allclose(now.variational[:, k], slopes, rtol=0, atol=2e-8)
        gaps = (moved[0].residual - moved[1].residual) / (2 * step)
        assert_allclose(gaps, 0, atol=2e-8)


def test_residual_is_removed_by_the_affine_part():
    orbit = stick()
    numbers, cycle = numbers_in(orbit.tables.piecewise), orbit.tables.cycle
    errors = []
    for size in (1e-3, 1e-4):
        dwell = orbit.dwell_times * (1 + size * np.array([1, -1, 0.5, 0.3]))
        first = shoot(cycle, numbers, dwell, orbit.states[0], np)
        second = shoot(cycle, numbers, dwell + first.rates[:, -1], orbit.states[0], np)
        errors.append(abs(second.residual).max())
    assert errors[1] < 2e-2 * errors[0]  # of the second order


def test_monodromy_keeps_the_field_and_saltations_map_it():
    orbit = stick()
    field = orbit.tables.piecewise.fields[orbit.tables.cycle.configurations[0]]
    speed = field[:, :-1] @ orbit.states[0] + field[:, -1]
    assert_allclose(orbit.monodromy @ speed, speed, atol=1e-13)
    for place, jump in enumerate(orbit.saltations):
        after = orbit.tables.piecewise.fields[orbit.tables.cycle.configurations[(place + 1) % 4]]
        state = orbit.states[(place + 1) % 4]
        assert_allclose(
            jump @ orbit.tables.shooting.velocities[place],
            after[:, :-1] @ state + after[:, -1],
            atol=1e-12,
        )
    nonzero = np.linalg.eigvals(orbit.monodromy)
    assert min(abs(nonzero - TRACE)) < 1e-7


def made(data):
    kernels = load_system("dry-friction")
    points, _ = parameter_points(kernels, data)
    (group,) = numbers_at(kernels, points)
    return structure_of(kernels), group.flat


@needs_engine
@pytest.mark.parametrize("guided", [False, True])
def test_compiled_as_in_python(guided):
    random = np.random.default_rng(11)
    count = 50
    data = {name: float(value) for name, value in STICKING.items()}
    data["eta"] = 1 + 0.05 * random.uniform(-1, 1, count)
    data["V"] = 1 + 0.05 * random.uniform(-1, 1, count)
    data["eta"][7] = -1  # outside its domain
    structure, flat = made(data)
    cycle, free = itinerary_shape(structure, PHASES), np.full(count, np.nan)
    dwell = np.tile(STICK_GUESS, (count, 1))
    start = np.tile(stick().states[0], (count, 1)) if guided else None
    compiled = solve_shape(cycle, flat, dwell, start, free)
    python = solve_in_python(cycle, flat, dwell, start, free)
    assert compiled.status[7] == python.status[7] == INVALID
    assert np.delete(compiled.status, 7).max() == CONVERGED
    for found, wanted in zip(compiled, python, strict=True):
        assert_allclose(
            np.delete(found, 7, axis=0), np.delete(wanted, 7, axis=0), rtol=0, atol=1e-12
        )


either_solver = pytest.mark.parametrize(
    "solver", [pytest.param(solve_shape, marks=needs_engine), solve_in_python]
)


@either_solver
@pytest.mark.parametrize(
    ("system", "data", "itinerary", "guess", "period", "status"),
    [
        ("dry-friction", STICKING, PHASES, STICK_GUESS, np.nan, CONVERGED),
        ("dry-friction", STICKING, PHASES, STICK_GUESS, 8, STALLED),
        ("dry-friction", STICKING, PHASES, [0.1] * 4, np.nan, NEGATIVE),
        ("elastic-stop", CHAIN | {"k3": 1}, CONTACT, [2.1, 4.2], np.nan, SINGULAR),
        ("elastic-stop", CHAIN | {"k3": 1}, CONTACT, [2.1, 4.2], 2 * np.pi, CONVERGED),
        ("rigid-stop", CHAIN | {"r": 1}, IMPACT, [6.2], np.nan, SINGULAR),
        ("rigid-stop", CHAIN | {"r": 1}, IMPACT, [6.2], np.inf, INVALID),
    ],
)
def test_either_solver_gives_every_status(solver, system, data, itinerary, guess, period, status):
    kernels = load_system(system)
    (group,) = numbers_at(kernels, parameter_points(kernels, data)[0])
    cycle = itinerary_shape(structure_of(kernels), itinerary)
    found = solver(cycle, group.flat, np.array([guess]), None, np.array([float(period)]))
    assert found.status.tolist() == [status]


@either_solver
def test_what_is_lost_at_the_very_last_step_is_said_to_be_lost(solver):
    """Dwell times grow fourfold at each step, exponential motions along them beyond any number."""
    falling = oscillator(
        "falling", ["x"], mass=[[1]], stiffness=[[-1]],
        elements=[RigidStop("x", at=1, restitution=1, name="wall")],
    )  # fmt: skip
    (group,) = numbers_at(load_system(falling), parameter_points(load_system(falling), {})[0])
    cycle = itinerary_shape(group.structure, [("free", "wall-reaches-stop")])
    count = 40
    dwell, start = np.geomspace(1e-17, 1e-15, count)[:, None], np.tile([1.0, -1e-3], (count, 1))
    flat = np.repeat(group.flat, count, axis=0)
    found = solver(cycle, flat, dwell, start, np.full(count, 1e4))
    assert set(found.status) == {STALLED, INVALID}
    assert np.isfinite(found.residual[found.status == STALLED]).all()
    assert (found.iterations[~np.isfinite(found.residual)] == 32).any()


@needs_engine
def test_compiled_as_in_python_with_a_period(monkeypatch):
    found = []
    for backend in ("c", "numpy"):
        monkeypatch.setenv("NONSMOOTH_BACKEND", backend)
        found.append(
            solve(
                "elastic-stop",
                CHAIN | {"k3": 1},
                [2, 4],
                itinerary=CONTACT,
                given={"period": "2*pi"},
            )
        )
    assert_allclose(found[0].dwell_times, found[1].dwell_times, atol=1e-12)
    assert_allclose(found[0].states, found[1].states, atol=1e-12)


def test_many_points():
    eta = np.linspace(0.95, 1.05, 3)[:, None]
    data = STICKING | {"eta": eta, "V": [0.98, 1.02]}
    many = solve("dry-friction", data, STICK_GUESS, itinerary=PHASES, multipliers=True)
    assert many.admissible.all()
    assert many.converged.all()
    assert many.dwell_times.shape == (3, 2, 4)
    assert many.starts.shape == (3, 2, 4, 4)
    assert many.multipliers.shape == (3, 2, 2)
    for i, j in np.ndindex(3, 2):
        one = stick(eta=eta[i, 0], V=[0.98, 1.02][j])
        assert_allclose(many.dwell_times[i, j], one.dwell_times, atol=1e-12)
        assert_allclose(many.starts[i, j], one.states, atol=1e-12)
        assert many.trace[i, j] == pytest.approx(one.trace, abs=1e-12)
        assert_allclose(many.multipliers[i, j], one.multipliers, atol=1e-12)
        assert many.multipliers[i, j, 1] == 0
        assert many.margin[i, j] == pytest.approx(one.stability.margin, abs=1e-12)


@pytest.mark.parametrize("threads", [1, 2])
def test_threads_and_chunks_change_nothing(threads, monkeypatch):
    monkeypatch.setattr("nonsmooth.runtime.orbits.table_many.CHUNK", 3)
    data = STICKING | {"V": np.linspace(0.98, 1.02, 8)}
    start = stick().states[0]
    guess = [*STICK_GUESS, *start]
    many = solve("dry-friction", data, guess, itinerary=PHASES, threads=threads)
    monkeypatch.undo()
    whole = solve("dry-friction", data, guess, itinerary=PHASES)
    assert_array_equal(many.dwell_times, whole.dwell_times)
    assert_array_equal(many.trace, whole.trace)


@pytest.mark.parametrize("first", range(4))
def test_a_guess_of_the_state_is_taken_where_the_orbit_starts(first):
    # the engine starts from another phase: an exact guess is exact there too
    exact = solve(
        "dry-friction",
        STICKING,
        turned(STICK_GUESS, first),
        itinerary=turned(PHASES, first),
    )
    guess = [*exact.dwell_times, *exact.states[0]]
    many = solve("dry-friction", STICKING, guess, itinerary=turned(PHASES, first))
    assert many.converged
    assert many.iterations == 1


def test_no_points_and_lost_points():
    none = solve("dry-friction", STICKING | {"V": []}, STICK_GUESS, itinerary=PHASES)
    assert none.dwell_times.shape == (0, 4)
    lost = solve("dry-friction", STICKING | {"V": [-1, 1]}, STICK_GUESS, itinerary=PHASES)
    assert lost.status.tolist() == [INVALID, CONVERGED]
    assert np.isnan(lost.dwell_times[0]).all()
    assert np.isnan(lost.trace[0])
    assert "domain" in lost.message(INVALID)


def test_forty_digits():
    orbit = solve("dry-friction", STICKING, STICK_GUESS, itinerary=PHASES, digits=40)
    kernels = refine(solve("dry-friction/global-stick"), 40)
    for found, wanted in zip(orbit.dwell_times, kernels.dwell_times, strict=True):
        assert abs(found - wanted) < 1e-40
    assert abs(orbit.trace - kernels.trace) < 1e-38
    assert orbit.multipliers[1] == 0
    assert orbit.residual < 1e-40
    assert orbit.stability.verdict == "stable"
    assert orbit.admissibility.verdict is True


@pytest.mark.parametrize("digits", [15, 40])
def test_elastic_stop_of_given_period(digits):
    orbit = solve(
        "elastic-stop",
        CHAIN | {"k3": 1},
        [2.1, 4.2],
        itinerary=CONTACT,
        given={"period": "2*pi"},
        digits=digits,
    )
    kernels = solve("elastic-stop/one-contact")
    kernels = kernels if digits == 15 else refine(kernels, digits)
    assert orbit.converged
    assert orbit.tables.family
    limit = 10.0 ** -(13 if digits == 15 else 40)
    for found, wanted in zip(orbit.dwell_times, kernels.dwell_times, strict=True):
        assert abs(found - wanted) < limit
    for found, wanted in zip(orbit.states[0], kernels.states[0], strict=True):
        assert abs(found - wanted) < 10 * limit
    assert abs(orbit.trace - kernels.trace) < 100 * limit
    assert orbit.stability.verdict == "neutral"
    assert [m.trivial for m in orbit.stability.multipliers] == [False, False, True]
    assert orbit.admissibility.verdict is True


def test_rigid_stop_of_given_period():
    orbit = solve("rigid-stop", CHAIN | {"r": 1}, [6.2], itinerary=IMPACT, given={"period": "2*pi"})
    kernels = solve("rigid-stop/one-impact")
    assert orbit.converged
    assert_allclose(orbit.states[0], kernels.states[0], atol=1e-13)
    assert orbit.trace == pytest.approx(kernels.trace, abs=1e-12)
    assert orbit.stability.verdict == kernels.stability.verdict == "neutral"
    assert orbit.admissibility.verdict is True


@pytest.mark.parametrize(
    ("system", "more", "itinerary", "guess"),
    [("elastic-stop", {"k3": 1}, CONTACT, [2.1, 4.2]), ("rigid-stop", {"r": 1}, IMPACT, [6.2])],
)
def test_a_family_is_said_to_be_one(system, more, itinerary, guess):
    orbit = solve(system, CHAIN | more, guess, itinerary=itinerary, digits=40, throw=False)
    assert orbit.status == SINGULAR
    assert not orbit.converged
    assert "give its period" in orbit.message
    assert orbit.tables.family
    assert orbit.residual < 1e-12  # a member of the family all the same
    assert orbit.stability.verdict == "neutral"


def test_units_change_no_verdict():
    # a thousand times heavier and a million million times stiffer: time in other units
    data = {"m1": 1e3, "m2": 2e3, "k1": 1e15, "k2": 5e15, "k3": 1e15}
    orbit = solve(
        "elastic-stop", data, [2.1e-6, 4.2e-6], itinerary=CONTACT, given={"period": 2e-6 * np.pi}
    )
    assert orbit.converged
    assert orbit.stability.verdict == "neutral"
    free = solve("elastic-stop", data, [2.1e-6, 4.2e-6], itinerary=CONTACT, throw=False)
    assert free.status == SINGULAR


def test_a_period_that_no_orbit_has():
    problem = {"itinerary": PHASES, "given": {"period": 8}}
    with pytest.raises(NoConvergence, match="period"):
        solve("dry-friction", STICKING, STICK_GUESS, **problem)
    orbit = solve("dry-friction", STICKING, STICK_GUESS, **problem, throw=False)
    assert orbit.status == STALLED
    assert "period" in orbit.message
    with pytest.raises(InputError, match="no orbit"):
        _ = orbit.stability
    with pytest.raises(InputError, match="no orbit"):
        _ = orbit.admissibility


def test_a_phase_that_takes_no_time():
    orbit = solve("dry-friction", STICKING, [0.1] * 4, itinerary=PHASES, digits=40, throw=False)
    assert orbit.status == NEGATIVE
    assert not orbit.precise


@pytest.mark.parametrize(
    ("changes", "match"),
    [
        ({"itinerary": []}, "no phase"),
        ({"itinerary": [("stick-stick",)], "guess": [1]}, "itinerary takes"),
        (
            {"itinerary": [PHASES[0], PHASES[2]], "guess": [1, 1]},
            "no transition from stick-stick to slip-slip",
        ),
        ({"itinerary": [("stik", "first-breaks-forward")], "guess": [1]}, "unknown configuration"),
        ({"itinerary": [("stick-stick", "first-reaches-belt")], "guess": [1]}, "unknown boundary"),
        ({"orbit": "dry-frictoin"}, "dry-friction"),
        ({"parameters": {"chi": 0.5}}, "needs a value"),
        ({"parameters": STICKING | {"chi": 2}}, "chi"),
        ({"guess": None}, "takes a guess"),
        ({"guess": [1, 2, 3]}, "3 values: it takes 4"),
        ({"guess": [1, 2, 3, float("nan")]}, "finite"),
        ({"guess": [1, 2, 3, -1]}, "positive"),
        ({"guess": {"tau1": 1, "tau2": 2, "tau3": 1}}, "no tau4"),
        ({"guess": {"tau": 1}}, "unknown variable"),
        ({"guess": [*STICK_GUESS, 1, 2]}, "6 values: it takes 4"),
        ({"guess": [*STICK_GUESS, 1, 2, 3, float("inf")]}, "finite"),
        ({"digits": 0}, "digits"),
        ({"given": {"period": -1}}, "period"),
        ({"given": {"tau1": 1}}, "exchanged"),
        ({"unknown": ["V"]}, "exchanged"),
    ],
)
def test_bad_input(changes, match):
    arguments = {
        "orbit": "dry-friction",
        "parameters": STICKING,
        "itinerary": PHASES,
        "guess": STICK_GUESS,
    }
    with pytest.raises(InputError, match=match):
        solve(**(arguments | changes))


@pytest.mark.parametrize(
    ("changes", "match"),
    [
        ({"parameters": STICKING | {"V": [1, 2], "eta": [1, 2, 3]}}, "broadcast"),
        ({"parameters": STICKING | {"W": [1, 2]}}, "unknown parameter"),
        ({"parameters": STICKING | {"V": ["a"]}}, "V"),
        ({"parameters": {}}, "needs a value"),
        ({"guess": np.ones((3, 4))}, "broadcast"),
        ({"threads": 0}, "threads"),
        ({"given": {"period": -1.0}}, "period"),
    ],
)
def test_bad_input_of_many(changes, match):
    arguments = {
        "orbit": "dry-friction",
        "parameters": STICKING | {"V": [1.0, 1.01]},
        "itinerary": PHASES,
        "guess": STICK_GUESS,
    }
    with pytest.raises(InputError, match=match):
        solve(**arguments | changes)


@needs_engine
def test_the_engine_checks_its_arrays():
    engine = compiled_engine()
    structure, flat = made(STICKING)
    cycle = itinerary_shape(structure, PHASES)
    layout = table_newton.layout_of(structure)
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


def test_the_motion_along_an_orbit_closes_and_can_be_observed():
    orbit = stick()
    motion = orbit.trajectory(3)
    names = [configuration for configuration, _ in orbit.itinerary]
    assert list(motion.configurations) == [*names * 3, names[0]]
    assert_allclose(motion.times[::4], np.arange(4) * orbit.period, rtol=1e-13)
    assert_allclose(motion.states[-1], orbit.states[0], atol=1e-12)
    with pytest.raises(InputError, match="periods = 0"):
        orbit.trajectory(0)

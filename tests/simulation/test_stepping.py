"""Motions by the engine in Python, against matrix exponentials, 40 digits and exact sums."""

import math
from dataclasses import replace
from fractions import Fraction
from importlib import import_module

import mpmath as mp
import numpy as np
import pytest
from scipy.linalg import expm
from scipy.optimize import brentq

from nonsmooth.runtime.events.first_crossing import Start
from nonsmooth.runtime.model.engine_run import LONGEST_WAIT, Status
from nonsmooth.runtime.model.modes import numeric_modes
from nonsmooth.runtime.model.piecewise import PiecewiseLinear, piecewise
from nonsmooth.runtime.model.quasi_polynomials import QuasiPolynomial
from nonsmooth.runtime.model.structure import (
    BoundaryShape,
    ModeShape,
    Structure,
    TransitionShape,
)
from nonsmooth.runtime.simulation import stepping
from nonsmooth.runtime.simulation.engines import run_compiled
from nonsmooth.runtime.simulation.stepping import run

FRICTION = {
    "A": {"chi": 0.5, "eta": 1, "V": 1, "us1": 1, "us2": 1, "ur1": "4.0195", "ur2": "1.4831"},
    "B": {
        "chi": "0.4",
        "eta": 4,
        "V": "0.6773",
        "us1": "0.0127",
        "ur1": "0.0255",
        "us2": "0.5",
        "ur2": 1,
    },
}
STARTS = ((0, 0, 0, 0), (0.5, -0.3, 0.2, 0.1), (-2, 1, 0.5, -3), (3, 4, -1, -2))
STOP = {"m1": 1, "m2": 2, "k1": 1, "k2": 5}


def friction(name):
    return piecewise("dry-friction", FRICTION[name])


def matrix(field):
    return np.vstack([field, np.zeros(field.shape[1])])


def value(system, row, state):
    return system.rows[row, :-1] @ state + system.rows[row, -1]


def friction_regime(force, rate, static):
    """The rules of the design at the belt's velocity, where nothing is equal: 0, 1, 2."""
    if abs(force) > static + 1e-9:
        return 0 if force > 0 else 2
    if abs(force) < static - 1e-9:
        return 1
    sign = math.copysign(1, force)
    return (0 if sign > 0 else 2) if sign * rate > 0 else 1


def by_the_rules(system, configuration, mask, state):
    """The next configuration of dry friction, for a single boundary, and the state there."""
    p = {name: float(v) for name, v in system.parameters.items()}
    shape = system.structure
    regimes = [configuration // 3, configuration % 3]
    names = [b.name for i, b in enumerate(shape.boundaries[configuration]) if mask >> i & 1]
    assert len(names) == 1
    mass = int(names[0].startswith("second"))
    x, v = state[:2].copy(), state[2:].copy()
    v[mass] = p["V"]
    forces = (x[0] - p["chi"] * x[1], p["chi"] * (x[1] - x[0]))
    rates = (v[0] - p["chi"] * v[1], p["chi"] * (v[1] - v[0]))
    regimes[mass] = friction_regime(forces[mass], rates[mass], p[f"ur{mass + 1}"])
    after = state.copy()
    if regimes[mass] == 1:
        after[2 + mass] = p["V"]
    return 3 * regimes[0] + regimes[1], after


@pytest.mark.parametrize("name", FRICTION)
@pytest.mark.parametrize("start", STARTS)
def test_friction_goes_by_matrix_exponentials_and_the_rules(name, start):
    system = friction(name)
    motion = run(system, start, 0, transitions=40)
    assert motion.status is Status.TRANSITIONS
    assert len(motion.times) == 41
    assert motion.end == motion.times[-1]
    seen = set()
    for i in range(40):
        configuration, state = motion.configurations[i], motion.states[i]
        generator = matrix(system.fields[configuration])
        dwell = motion.times[i + 1] - motion.times[i]
        seen.add(int(configuration))

        def at(t, generator=generator, state=state):
            return (expm(generator * t) @ np.append(state, 1.0))[:-1]

        arrived = at(dwell)
        np.testing.assert_allclose(motion.before[i + 1], arrived, rtol=0, atol=1e-12)
        step = expm(generator * dwell / 400)
        path = [np.append(state, 1.0)]
        for _ in range(399):
            path.append(step @ path[-1])
        for index, boundary in enumerate(system.structure.boundaries[configuration]):
            crossed = [value(system, boundary.row, y[:-1]) for y in path[1:]]
            assert max(crossed) < 1e-12
            if motion.sets[i + 1] >> index & 1 and dwell > 1e-3:
                row = boundary.row
                time = brentq(
                    lambda t, at=at, row=row: value(system, row, at(t)),
                    dwell - 1e-4,
                    dwell + 1e-4,
                    xtol=1e-14,
                )
                assert time == pytest.approx(dwell, abs=2e-12)
        following, after = by_the_rules(system, configuration, motion.sets[i + 1], arrived)
        assert motion.configurations[i + 1] == following
        np.testing.assert_allclose(motion.states[i + 1], after, rtol=0, atol=1e-12)
    assert len(seen) >= 3


@pytest.mark.parametrize("name", FRICTION)
def test_event_times_hold_to_40_digits(name):
    system, high = friction(name), mp.MPContext()
    high.dps = 40
    motion = run(system, STARTS[1], 0, transitions=12)
    for i in range(12):
        configuration = motion.configurations[i]
        generator = high.matrix(matrix(system.fields[configuration]).tolist())
        state = high.matrix([*motion.states[i].tolist(), 1.0])
        index = int(motion.sets[i + 1]).bit_length() - 1
        boundary = system.structure.boundaries[configuration][index]
        row = high.matrix([system.rows[boundary.row].tolist()])
        # Newton in 40 digits from the time found
        time = high.mpf(float(motion.times[i + 1])) - high.mpf(float(motion.times[i]))
        found = time
        for _ in range(4):
            arrived = high.expm(generator * time, method="taylor") * state
            time -= (row * arrived)[0] / (row * (generator * arrived))[0]
        slope = abs((row * (generator * arrived))[0])
        assert abs(time - found) <= 4 * math.ulp(motion.times[i + 1]) + 1e-14 / slope
        for j in range(4):
            assert abs(motion.before[i + 1][j] - arrived[j]) <= 2e-14 / min(slope, 1)


either_engine = pytest.mark.parametrize(
    "engine", [pytest.param("compiled", marks=pytest.mark.compiled), "python"]
)


def follow(engine, system, state, **options):
    """A motion in one of the engines."""
    if engine == "python":
        return run(system, state, 0, **options)
    compiled = import_module("nonsmooth.runtime._engine")
    return run_compiled(compiled, system, np.array(state, dtype=float), 0, **options)


@either_engine
@pytest.mark.parametrize("wait", [0.4, 0.31, 0.17])
@pytest.mark.parametrize("shift", [0.0, 1e-9, -1e-9])
def test_two_boundaries_reached_at_one_instant_are_one_set(shift, wait, engine):
    system = friction("A")
    generator = matrix(system.fields[0])
    meeting = np.array([-0.5, 0.25, 1.0, 1.0, 1.0])  # both accelerate, both at V
    assert ((generator @ meeting)[2:4] > 0.1).all()
    late = meeting + np.array([0, 0, 0, shift, 0])
    start = expm(-wait * generator) @ late
    motion = follow(engine, system, start[:4], transitions=1)
    assert motion.times[1] == pytest.approx(wait, abs=1e-8)
    # both within their static friction: they stick
    expected = {0.0: (3, 4), 1e-9: (2, 1), -1e-9: (1, 3)}[shift]
    assert (motion.sets[1], motion.configurations[1]) == expected
    if shift == 0:
        assert (motion.states[1][2:] == 1.0).all()


@pytest.mark.parametrize("gap", [0.5, 1.5])
def test_the_order_of_boundaries_decides_nothing_within_an_error(gap):
    """One is reached at 1, within a large error; the other some part of that error later."""
    system = friction("A")
    stepper = stepping._Stepper(system)
    boundaries = stepper.configuration(0).boundaries[:2]
    vague = QuasiPolynomial((0j,), ((-1 + 0j, 1 + 0j),), ((1e8, 1.0),))
    error = vague.rounding(1.0)
    sharp = QuasiPolynomial((0j,), ((-1 - gap * error + 0j, 1 + 0j),))
    watches = [
        stepping._WatchedFunction(place, boundary, function, Start.of(function))
        for place, (boundary, function) in enumerate(zip(boundaries, (vague, sharp), strict=True))
    ]
    found = [stepper.event(order, 3.0) for order in (watches, watches[::-1])]
    assert found[0] == found[1]
    assert found[0].time == pytest.approx(1, abs=1e-15)
    assert found[0].boundaries == ({0, 1} if gap < 1 else {0})


def test_what_was_located_is_zero_behind_the_event_unless_a_reset_moves_it(monkeypatch):
    told = []
    watches = stepping._Stepper.watches

    def watched(self, configuration, state, size, error, left_out, zero):
        told.append(zero)
        return watches(self, configuration, state, size, error, left_out, zero)

    monkeypatch.setattr(stepping._Stepper, "watches", watched)
    for system, start, moved in (
        (piecewise("rigid-stop", STOP | {"r": 1}), (0, 0, 1, 0), False),  # an impact moves no place
        (friction("A"), STARTS[1], True),  # the velocity that reaches the belt's is set to it
    ):
        told.clear()
        motion = run(system, start, 0, transitions=12)
        shapes = system.structure.boundaries
        seen = set()
        assert told[0] == frozenset()
        for i, zero in enumerate(told[1:]):
            located = [
                b for j, b in enumerate(shapes[motion.configurations[i]])
                if motion.sets[i + 1] >> j & 1
            ]  # fmt: skip
            kept = {b.row for b in located if not b.name.endswith("belt")}
            assert zero == kept
            seen.add(len(located) > len(kept))
        assert seen == ({True, False} if moved else {False})


@pytest.mark.parametrize("ulps", [-4, -2, -1, 0, 1, 2, 4])
def test_a_force_at_its_limit_is_judged_by_its_derivative(ulps):
    base = friction("A")
    generator = matrix(base.fields[0])
    # the second mass arrives with f2 = -ur2, which then shrinks as the first falls behind
    meeting = np.array([2.0, -0.9662, -0.4, 1.0, 1.0])
    start = (expm(-0.3 * generator) @ meeting)[:4]
    limit = 0.5 * (2.0 + 0.9662)
    for shift, target in ((ulps * math.ulp(limit), 1), (-1e-9, 2), (1e-9, 1)):
        system = piecewise("dry-friction", FRICTION["A"] | {"ur2": limit + shift})
        motion = run(system, start, 0, transitions=1)
        assert (motion.sets[1], motion.configurations[1]) == (2, target)


def test_a_set_can_be_reached_at_the_very_start():
    system = friction("A")
    motion = run(system, (-0.5, 0.25, 1.0, 1.0), 0, transitions=2)
    assert motion.times[1] == 0
    assert motion.sets[1] == 3
    assert motion.configurations[1] == 4
    # beyond the boundary counts as reached as well
    motion = run(system, (-0.5, 0.25, 1.5, 0.0), 0, transitions=1)
    assert motion.times[1] == 0
    assert motion.sets[1] == 1


def test_a_velocity_that_only_touches_the_belt_is_an_event():
    system = friction("B")
    generator = matrix(system.fields[0])
    # at V with no acceleration, and its next derivative negative: the maximum is V
    V, chi, us1 = 0.6773, 0.4, 0.0127
    touch = np.array([us1 + chi * 1.0, 1.0, V, -0.5, 1.0])
    second = (generator @ generator @ touch)[2]
    touch[3] = (V + 0.3) / chi if second > 0 else touch[3]
    assert abs((generator @ touch)[2]) < 1e-15
    assert (generator @ generator @ touch)[2] < 0
    start = expm(-0.5 * generator) @ touch
    motion = run(system, start[:4], 0, transitions=1)
    assert motion.sets[1] == 1
    assert motion.times[1] == pytest.approx(0.5, abs=1e-7)
    motion = run(system, start[:4] - np.array([0, 0, 1e-9, 0]), 0, transitions=1)
    assert motion.times[1] > 0.6


def test_a_force_that_only_touches_its_limit_is_passed_by_and_told():
    base = friction("A")
    # stick-overshoot: f1 = x1 - chi x2 has its maximum where v2 = V/chi; the limit is set to it
    generator = matrix(base.fields[5])
    row = base.rows[5]
    state = np.array([0.0, -6.0, 1.0, 1.2, 1.0])
    slope = brentq(lambda t: row @ generator @ expm(generator * t) @ state, 0.1, 0.9, xtol=1e-15)
    limit = float(base.parameters["ur1"]) + row @ expm(generator * slope) @ state
    system = piecewise("dry-friction", FRICTION["A"] | {"ur1": limit})
    motion = run(system, state[:4], 5, transitions=1)
    assert len(motion.grazings) == 1
    grazing = motion.grazings[0]
    assert (grazing.configuration, grazing.boundary) == (5, 0)
    assert grazing.time == pytest.approx(slope, abs=1e-6)
    assert abs(grazing.depth) < 1e-13
    assert motion.times[1] > slope + 0.01
    lower = piecewise("dry-friction", FRICTION["A"] | {"ur1": limit - 1e-9})
    assert run(lower, state[:4], 5, transitions=1).times[1] < slope


def test_elastic_impacts_keep_the_energy():
    system = piecewise("rigid-stop", STOP | {"r": 1})
    motion = run(system, (0.5, 0.16, 2.5, -0.3), 0, transitions=300)

    def energy(y):
        x1, x2, v1, v2 = y.T
        return 0.5 * (v1**2 + 2 * v2**2 + (x1 - x2) ** 2 + 5 * x2**2)

    assert motion.status is Status.TRANSITIONS
    assert np.ptp(energy(motion.states)) < 1e-12 * energy(motion.states)[0]
    np.testing.assert_allclose(motion.before[1:, 0], 1.0, rtol=0, atol=1e-14)
    assert (motion.before[1:, 2] > 0).all()
    assert (motion.states[1:, 2] == -motion.before[1:, 2]).all()


@pytest.mark.parametrize(("r", "fewest", "most"), [(0.5, 40, 60), (0.9, 250, 400), (0, 2, 2)])
def test_impacts_that_accumulate_end_in_contact_which_releases(r, fewest, most):
    system = piecewise("rigid-stop", {"m1": 1, "m2": 2, "k1": 1, "k2": "0.1", "r": r})
    start = (0.9, 3.0, 0.0, 0.0) if r != 0.9 else (0.999, 3.0, 0.0, 0.0)
    motion = run(system, start, 0, until=8.0)
    resting = np.flatnonzero(motion.configurations)
    first = resting[0]
    assert fewest <= first <= most
    assert (motion.states[first, [0, 2]] == (1.0, 0.0)).all()
    impacts = motion.before[1 : first - 1, 2]
    if r:
        flights = np.diff(motion.times[1 : first - 1])
        # the force changes little in short flights: velocities and times shrink by r
        short = np.flatnonzero(impacts[1:] < 1e-5)
        assert short.size > 20
        early = short[impacts[1:][short] > 1e-9]
        np.testing.assert_allclose(impacts[1:][early] / impacts[:-1][early], r, rtol=1e-4)
        np.testing.assert_allclose(flights[early[1:]] / flights[early[:-1]], r, rtol=1e-4)
        # exact, in the limit: the times of all later flights are a geometric series
        i = int(early[0])
        rest = flights[i] / (1 - r)
        assert motion.times[first] - motion.times[i + 1] == pytest.approx(rest, rel=1e-3)
    # it leaves where the spring between the masses begins to pull
    assert motion.configurations[first + 1] == 0
    assert motion.before[first + 1, 1] == pytest.approx(1.0, abs=1e-14)
    assert motion.times[first + 1] > motion.times[first] + 0.5


def made(field, modes, exponents, flow, rows, boundaries, transitions, resets):
    """A system of one kind of configurations, by its tables."""
    size = len(field)
    count = len(boundaries)
    structure = Structure(
        "made",
        tuple(f"y{i}" for i in range(size)),
        tuple(f"c{i}" for i in range(count)),
        (modes,) * count,
        ((),) * count,
        ((),) * count,
        boundaries,
        transitions,
        (),
        len(rows),
        len(resets),
    )
    return PiecewiseLinear(
        structure,
        {},
        np.array([field] * count, dtype=float),
        np.array(rows, dtype=float),
        np.array(resets, dtype=float),
        (np.array(exponents, dtype=float),) * count,
        (np.array(flow, dtype=float),) * count,
    )


IDENTITY = [[1, 0, 0], [0, 1, 0]]


def ball(restitution, transitions=None):
    """A ball that bounces: x' = v, v' = -1; the stop is at x = 0 from above."""
    bounce = TransitionShape(frozenset({0}), ((1, 1, True),), 1, 0)
    rest = TransitionShape(frozenset({0}), (), 2, 2)
    fall = [[0, 1, 0], [0, 0, -1]]
    flow = [IDENTITY, [[0, 1, 0], [0, 0, -1]], [[0, 0, -0.5], [0, 0, 0]]]
    system = made(
        fall,
        (ModeShape(3, False, (0, 1, 2)),),
        [[0, 0]],
        flow,
        [[-1, 0, 0], [0, -1, 0]],
        ((BoundaryShape("reaches", 0, False),), (), ()),
        ((bounce, rest) if transitions is None else transitions, (), ()),
        [IDENTITY, [[1, 0, 0], [0, -restitution, 0]], [[0, 0, 0], [0, 0, 0]]],
    )
    system.fields[1:] = 0.0  # at rest
    still = np.array([IDENTITY, np.zeros((2, 3)), np.zeros((2, 3))])
    return replace(system, flows=(system.flows[0], still, still))


@pytest.mark.parametrize("r", [0.25, 0.5, 0.9])
def test_a_bouncing_ball_comes_to_rest_after_a_geometric_sum(r):
    motion = run(ball(r), (0.5, 0.0), 0)
    assert motion.status is Status.QUIET
    assert motion.configurations[-1] == 2
    # flights that a time in two doubles cannot tell from none are not made
    assert len(motion.times) <= 30 + 104 * math.log(2) / -math.log(r)
    # 1 to the ground, where the velocity is 1, then 2 r + 2 r^2 + ...
    assert motion.times[-1] == pytest.approx(1 + 2 * r / (1 - r), rel=1e-15)
    np.testing.assert_allclose(motion.before[1:40, 1], -(r ** np.arange(39.0)), rtol=1e-12)
    assert motion.end == motion.times[-1]


def test_until_and_transitions_and_undeclared():
    motion = run(ball(0.5), (0.5, 0.0), 0, until=2.5)
    assert motion.status is Status.UNTIL
    assert motion.end == 2.5
    assert motion.times.tolist() == pytest.approx([0, 1, 2, 2.5])
    motion = run(ball(0.5), (0.5, 0.0), 0, until=2.4, transitions=0)
    assert (motion.status, len(motion.times)) == (Status.TRANSITIONS, 1)
    motion = run(ball(0.5, ()), (0.5, 0.0), 0)
    assert (motion.status, len(motion.times)) == (Status.UNDECLARED, 1)
    assert motion.end == pytest.approx(1.0)
    motion = run(ball(0.5), (math.nan, 0.0), 0)
    assert motion.status is Status.OVERFLOW


def test_transitions_without_time_between_them_end():
    stay = (TransitionShape(frozenset({0}), (), 0, 0),)
    motion = run(ball(0.5, stay), (0.5, 0.0), 0)
    assert motion.status is Status.IMMEDIATE
    assert 100 <= len(motion.times) - 1 <= 105


def oscillator(rate, level, frequency=1.0):
    """y'' = 2 s y' - (s^2 + w^2) y with the boundary y = level and no transition."""
    s, w = rate, frequency
    sine = np.array([[-s, 1, 0], [-(s * s + w * w), s, 0]]) / w
    return made(
        [[0, 1, 0], [-(s * s + w * w), 2 * s, 0]],
        (ModeShape(1, False, (0,)), ModeShape(1, True, (1, 2))),
        [[0, 0], [s, w]],
        [np.zeros((2, 3)), IDENTITY, sine],
        [[1, 0, -level], [-1, 0, -1e300]],
        ((BoundaryShape("reaches", 0, False), BoundaryShape("below", 1, False)),),
        ((),),
        [IDENTITY],
    )


@either_engine
@pytest.mark.parametrize("speeds", [(1.0, 2.0), (2.0, 1.0), (4.0, 0.5), (-1.0, 0.25), (3.0, 3.0)])
def test_of_two_straight_flights_the_shorter_one_ends_first(engine, speeds):
    motion = follow(engine, straight(speeds, 1, ()), (0.0, 0.0))
    assert motion.status is Status.UNDECLARED
    assert motion.end == 1 / max(speeds)


@either_engine
def test_times_are_sums_without_rounding_errors_that_grow(engine):
    """Each flight takes the double 0.1; a sum of doubles would err by 1e-12."""
    again = TransitionShape(frozenset({0}), (), 1, 0)
    system = straight((1.0, 0.0), 0.1, (again,), [[0, 0, 0], [0, 1, 0]])
    motion = follow(engine, system, (0.0, 0.0), transitions=3000)
    assert motion.times.tolist() == [float(k * Fraction(0.1)) for k in range(3001)]


def straight(speeds, level, transitions, reset=IDENTITY):
    """x' = a and y' = b, with a boundary where x reaches a level, and one where y does."""
    field = [[0, 0, speeds[0]], [0, 0, speeds[1]]]
    return made(
        field,
        (ModeShape(2, False, (0, 1)),),
        [[0, 0]],
        [IDENTITY, field],
        [[1, 0, -level], [0, 1, -level]],
        ((BoundaryShape("right", 0, False), BoundaryShape("up", 1, False)),),
        (transitions,),
        [IDENTITY, reset],
    )


@pytest.mark.compiled
def test_a_swing_keeps_its_digits_over_thousands_of_radians():
    """Its angle is a product of doubles, whose rounding is taken in: x'' = -w^2 x, y' = s."""
    w, speed, high = math.sqrt(1.5), 2.0**-11, mp.MPContext()
    high.dps = 40
    for level in (3, 5, 7, 11):  # it is there at a time without rounding
        none = np.zeros((3, 4))
        still, drift, cosine, sine = none.copy(), none.copy(), none.copy(), none.copy()
        still[2, 2], drift[2, 3] = 1, speed
        cosine[0, 0] = cosine[1, 1] = 1
        sine[0, 1], sine[1, 0] = 1 / w, -w
        field = [[0, 1, 0, 0], [-w * w, 0, 0, 0], [0, 0, 0, speed]]
        system = made(
            field,
            (ModeShape(2, False, (0, 1)), ModeShape(1, True, (2, 3))),
            [[0, 0], [0, w]],
            [still, drift, cosine, sine],
            [[0, 0, 1, -level]],
            ((BoundaryShape("there", 0, False),),),
            ((TransitionShape(frozenset({0}), (), 0, 0),),),
            [np.eye(3, 4)],
        )
        motion = follow("compiled", system, (1.0, 0.0, 0.0), transitions=1)
        angle = high.mpf(w) * high.mpf(float(motion.times[1]))
        assert motion.times[1] == level / speed
        expected = [float(high.cos(angle)), float(-w * high.sin(angle))]
        np.testing.assert_allclose(motion.before[1][:2], expected, rtol=0, atol=1e-14)


def test_what_never_comes_is_quiet_or_until():
    below = oscillator(0.0, 2.0)
    motion = run(below, (1.0, 0.0), 0)
    assert (motion.status, motion.end) == (Status.QUIET, 0.0)
    motion = run(below, (1.0, 0.0), 0, until=1e9)
    assert (motion.status, motion.end) == (Status.UNTIL, 1e9)


@pytest.mark.parametrize("compiled", [pytest.param(True, marks=pytest.mark.compiled), False])
def test_a_slow_coordinate_is_waited_for_beside_a_fast_one(compiled):
    """Both turn undisturbed; the slow one, at 1/100 of the speed, grows to its boundary."""
    slow, speed = 1e-2, 100.0
    field = np.zeros((4, 5))
    field[0, 2] = field[1, 3] = 1
    field[2, 0], field[3, 1], field[3, 3] = -(speed**2), -(slow**2), 1.6e-4
    found = numeric_modes(field)
    structure = Structure(
        "two speeds", ("x", "y", "v", "w"), ("free",), (found.shapes,), ((),), ((),),
        ((BoundaryShape("far", 0, True),),), ((),), (), 1, 1,
    )  # fmt: skip
    row, identity = np.array([[0.0, 1, 0, 0, -1.1]]), np.eye(4, 5)[None]
    system = PiecewiseLinear(
        structure, {}, field[None], row, identity, (found.exponents,), (found.flows,)
    )
    state = np.array([1.0, 1.0, 0, 0])
    if compiled:
        motion = run_compiled(import_module("nonsmooth.runtime._engine"), system, state, 0)
    else:
        motion = run(system, state, 0)
    assert motion.status is Status.UNDECLARED
    assert motion.end > 1e5 / speed
    arrived = expm(matrix(field) * motion.end) @ [*state, 1.0]
    assert arrived[1] == pytest.approx(1.1, abs=1e-9)


def test_a_long_wait_is_quiet_unless_a_time_is_asked_for(monkeypatch):
    monkeypatch.setattr(stepping, "LONGEST_WAIT", 20.0)
    # it grows by e^(t/1000): 1 to 1.1 takes 95, many waits
    system = oscillator(1e-3, 1.1)
    assert LONGEST_WAIT > 20
    motion = run(system, (1.0, 0.0), 0)
    assert motion.status is Status.QUIET
    assert motion.end == 0.0
    motion = run(system, (1.0, 0.0), 0, until=1000.0)
    assert motion.status is Status.UNDECLARED
    assert 90 < motion.end < 102
    field = matrix(system.fields[0])
    arrived = expm(field * motion.end) @ [1.0, 0.0, 1.0]
    assert arrived[0] == pytest.approx(1.1, abs=1e-12)
    assert run(system, (1.0, 0.0), 0, until=60.0).status is Status.UNTIL


def test_growth_without_bound_overflows():
    system = oscillator(1.0, 1.0)
    sink = replace(system, rows=np.array([[0.0, 0.0, -1.0], [-1e-300, 0.0, -1e300]]))
    assert run(sink, (0.5, 0.0), 0).status is Status.OVERFLOW

"""Stability against a simulated Poincare map, which knows Coulomb's law and no itinerary."""

from functools import cache

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.linalg import expm
from scipy.optimize import brentq

from nonsmooth import refine, solve, solve_many

ORBIT = "dry-friction/global-stick"
PARAMETERS = ("chi", "eta", "V", "e1", "e2")
LOWER, UPPER = np.array([0.15, 0.3, 0.3, 1.5, 0.1]), np.array([0.85, 3.0, 1.5, 5.0, 1.5])


class Friction:
    """Two masses on the belt (Sec. 3), from one event to the next by matrix exponentials.

    The next phase follows from Coulomb's law alone: at the belt's velocity a mass sticks if
    the force on it is at most ur, and a force beyond ur lets it slip.
    """

    step = 0.02

    def __init__(self, values, us1, us2):
        self.chi, self.eta, self.speed = values["chi"], values["eta"], values["V"]
        self.sliding = np.array([us1, us2])
        self.sticking = np.array([us1 + values["e1"], us2 + values["e2"]])

    def centre(self):
        """The paper's shift d = x - z."""
        us1, us2 = self.sliding
        first = (us1 + us2) / (1 - self.chi)
        return np.array([first, first + us2 / self.chi])

    def generator(self, slips):
        matrix = np.zeros((5, 5))  # the last coordinate is 1
        matrix[:2, 2:4] = np.eye(2)
        if slips[0]:
            matrix[2, [0, 1, 4]] = -1, self.chi, self.sliding[0]
        if slips[1]:
            coupling = self.chi * self.eta
            matrix[3, [0, 1, 4]] = coupling, -coupling, self.eta * self.sliding[1]
        return matrix

    def forces(self, y):
        return np.array([y[0] - self.chi * y[1], self.chi * (y[1] - y[0])])

    def excess(self, y, slips):
        """What is positive where a phase has ended: r of a slipping mass, |f| - ur of another."""
        return np.where(slips, y[2:4] - self.speed, np.abs(self.forces(y)) - self.sticking)

    def advance(self, y, slips, times):
        """State and which masses slip after the next event; its time is appended to times."""
        matrix = self.generator(slips)
        stride, elapsed = expm(matrix * self.step), 0.0
        while not (self.excess(following := stride @ y, slips) > 0).any():
            y, elapsed = following, elapsed + self.step
            assert elapsed < 100
        events = []
        for mass in np.flatnonzero(self.excess(following, slips) > 0):

            def crossing(t, y=y, mass=mass):
                return self.excess(expm(matrix * t) @ y, slips)[mass]

            begin = 0.0 if crossing(0.0) < 0 else 1e-9  # a phase may begin on its boundary
            events.append((brentq(crossing, begin, self.step, xtol=1e-15, rtol=1e-15), mass))
        time, mass = min(events)
        y, slips = expm(matrix * time) @ y, slips.copy()
        if slips[mass]:
            y[2 + mass] = self.speed
            slips[mass] = abs(self.forces(y)[mass]) > self.sticking[mass]
        else:
            assert self.forces(y)[mass] > 0, "pulled forward"
            slips[mass] = True
        times.append(elapsed + time)
        return y, slips

    def poincare_map(self, positions, times=None):
        """Positions where both masses begin to stick, from those where they last did."""
        times = [] if times is None else times
        y = np.array([*positions, self.speed, self.speed, 1.0])
        y, slips = self.advance(y, np.array([False, False]), times)
        while slips.any():
            y, slips = self.advance(y, slips, times)
        return y[:2]


def simulated(orbit, margin=0.3):
    """A simulator with forces of friction that allow the orbit, and where the orbit starts."""
    bounds = {r.parameter: r.greater_than for r in orbit.admissibility.requires}
    friction = Friction(orbit.values, bounds["us1"] + margin, bounds["us2"] + margin)
    start = np.array([orbit.values["z10"], orbit.values["z20"]]) + friction.centre()
    return friction, start


@cache
def at_random_points():
    """Random points, and the orbits there."""
    points = LOWER + (UPPER - LOWER) * np.random.default_rng(11).random((1500, 5))
    return points, solve_many(ORBIT, **dict(zip(PARAMETERS, points.T, strict=True)))


def orbits_where(select, count):
    """Admissible orbits of random points whose trace is selected."""
    points, many = at_random_points()
    chosen = np.flatnonzero(many.admissible & (many.trace != 0) & select(many))[:count]
    assert len(chosen) == count
    return [
        solve(
            ORBIT,
            dict(zip(PARAMETERS, map(float, points[i]), strict=True)),
            {n: float(a[i]) for n, a in many.unknowns.items()},
        )
        for i in chosen
    ]


@pytest.fixture(scope="module")
def orbits():
    return [solve(ORBIT), *orbits_where(lambda many: np.abs(many.trace) > 0, 5)]


@pytest.fixture(scope="module")
def unstable():
    return orbits_where(lambda many: np.abs(many.trace) > 1.03, 3)


def test_the_simulated_motion_is_the_orbit(orbits, unstable):
    for orbit in (*orbits, *unstable):
        friction, start = simulated(orbit)
        times = []
        assert_allclose(friction.poincare_map(start, times), start, atol=1e-10)
        assert_allclose(times, orbit.dwell_times.tolist(), atol=1e-10)


def test_the_jacobian_is_that_of_the_simulated_map(orbits, unstable):
    for orbit in (*orbits, *unstable):
        friction, start = simulated(orbit)
        columns = []
        for step in 1e-4 * np.eye(2):
            near, far = (
                (friction.poincare_map(start + k * step) - friction.poincare_map(start - k * step))
                / (2e-4 * k)
                for k in (1, 2)
            )
            columns.append((4 * near - far) / 3)
        found = np.array(columns).T
        jacobian = orbit.evaluate("poincare_jacobian")
        scale = np.abs(jacobian).max()
        assert_allclose(jacobian, found, atol=1e-6 * scale)
        assert np.trace(found) == pytest.approx(orbit.trace, abs=1e-6 * scale)
        assert abs(np.linalg.det(jacobian)) < 1e-11 * scale**2
        assert abs(np.linalg.det(found)) < 1e-6 * scale**2


def test_perturbations_change_by_the_trace_each_period(orbits, unstable):
    for orbit in (*orbits, *unstable):
        friction, start = simulated(orbit)
        there = start + np.array([1e-6, 2e-6])
        distances = []
        for _ in range(6):
            there = friction.poincare_map(there)
            distances.append((there - start)[0])
        ratios = np.array(distances[1:]) / np.array(distances[:-1])
        assert_allclose(ratios, orbit.trace, rtol=1e-3)


@pytest.mark.slow
def test_the_verdict_is_what_becomes_of_a_perturbation(unstable):
    stable = orbits_where(lambda many: np.abs(many.trace) < 0.7, 3)
    for orbit, verdict in [(o, "stable") for o in stable] + [(o, "unstable") for o in unstable]:
        assert orbit.stability.verdict == verdict
        friction, start = simulated(orbit)
        there = first = friction.poincare_map(start + np.array([1e-6, 0]))
        for _ in range(12):
            there = friction.poincare_map(there)
        growth = np.abs(there - start).max() / np.abs(first - start).max()
        assert growth == pytest.approx(abs(orbit.trace) ** 12, rel=0.01, abs=1e-3)
        assert (growth < 1) == (verdict == "stable")


def test_batches_have_the_same_trace_and_both_verdicts_occur():
    points = LOWER + (UPPER - LOWER) * np.random.default_rng(12).random((120, 5))
    many = solve_many(ORBIT, **dict(zip(PARAMETERS, points.T, strict=True)))
    verdicts = set()
    for i in np.flatnonzero(many.admissible)[::3]:
        orbit = solve(
            ORBIT,
            dict(zip(PARAMETERS, map(float, points[i]), strict=True)),
            {n: float(a[i]) for n, a in many.unknowns.items()},
        )
        assert orbit.trace == pytest.approx(float(many.trace[i]), abs=1e-9)
        assert orbit.stability.margin == 1 - abs(orbit.trace)
        verdicts.add(orbit.stability.verdict)
        assert orbit.stability.verdict == ("stable" if abs(orbit.trace) < 1 else "unstable")
    assert verdicts == {"stable", "unstable"}


def test_the_trace_does_not_depend_on_the_forces_left_open(orbits):
    for orbit in orbits[:3]:
        required = {r.parameter: r.greater_than for r in orbit.admissibility.requires}
        given = {n: orbit.values[n] for n in ("chi", "eta", "V")}
        guess = dict(orbit.unknowns)
        for more in (0.01, 5.0):
            physical = given | {
                "us1": required["us1"] + more,
                "ur1": required["us1"] + more + orbit.values["e1"],
                "us2": required["us2"] + more,
                "ur2": required["us2"] + more + orbit.values["e2"],
            }
            other = solve(ORBIT, physical, guess)
            assert other.trace == pytest.approx(orbit.trace, abs=1e-11)
            assert other.admissibility.verdict is True


def test_a_margin_within_its_error_is_undecided_until_there_are_digits():
    # a trace of -1 along chi, located with Newton's method at 700 digits
    chi = np.linspace(0.6, 0.7, 100)
    many = solve_many(ORBIT, chi=chi)
    margin = 1 - np.abs(many.trace)
    sound = many.admissible[:-1] & many.admissible[1:]
    place = np.flatnonzero(sound & (margin[:-1] * margin[1:] < 0))[0]
    guess = {n: float(a[place]) for n, a in many.unknowns.items()}
    text = repr(float(chi[place]))
    for _ in range(9):
        found = refine(solve(ORBIT, {"chi": text}, guess), 700)
        step = (found.trace + 1) / found.sensitivity("chi").trace
        text = found.arithmetic.mp.nstr(found.values["chi"] - step, 690)
    for shift, few, enough in (("1e-30", 16, 40), ("1e-462", 450, 550)):
        verdicts = []
        for sign in ("+", "-"):
            orbit = solve(ORBIT, {"chi": f"{text} {sign} {shift}"}, guess)
            assert orbit.stability.verdict == "undecided"
            assert refine(orbit, few).stability.verdict == "undecided"
            verdicts.append(refine(orbit, enough).stability.verdict)
        assert set(verdicts) == {"stable", "unstable"}


@pytest.mark.parametrize(
    "name",
    [
        "rigid-stop/one-impact",
        "elastic-stop/one-contact",
        "dry-friction/symmetric",
        "dry-friction/global-stick",
    ],
)
@pytest.mark.parametrize("digits", [None, 30])
def test_multipliers_come_by_decreasing_size(name, digits):
    """The first is as large as the spectral radius; zeros, and a 1 that is trivial, come last."""
    orbit = solve(name)
    jacobian = np.array(orbit.evaluate("poincare_jacobian"), dtype=float)
    found = (orbit if digits is None else refine(orbit, digits)).stability
    values = np.array([complex(float(m.real), float(m.imaginary)) for m in found.multipliers])
    sizes = np.abs(values)
    assert (np.diff(sizes) <= 1e-9).all()
    assert_allclose(sizes[0], np.abs(np.linalg.eigvals(jacobian)).max(), rtol=1e-7)
    assert (sizes[found.rank :] == 0).all()
    assert (sizes[: found.rank] > 0).all()
    assert [m.trivial for m in found.multipliers] == sorted(m.trivial for m in found.multipliers)


def test_multipliers_of_composed_orbits_come_by_decreasing_size():
    data = dict(chi="0.4", eta=4, V="0.6773", us1="0.0127", ur1="0.0255", us2="0.5", ur2=1)
    named = solve("dry-friction/symmetric")
    composed = solve(
        "dry-friction",
        data,
        [*named.dwell_times],
        itinerary=named.itinerary,
    )
    sizes = [abs(complex(m.real, m.imaginary)) for m in composed.stability.multipliers]
    assert sizes == sorted(sizes, reverse=True)
    assert sizes[0] > 1.1 * sizes[1]

"""Admissibility of every orbit, against boundaries sampled along matrix exponentials."""

from dataclasses import replace
from itertools import chain, islice, product

import mpmath
import numpy as np
import pytest

from nonsmooth import refine, solve
from nonsmooth.runtime.core.values import as_value
from nonsmooth.runtime.model.kernels import load_orbit, orbit_names
from tests.declared import Declared, random_points, single

RIGID, ELASTIC = "rigid-stop/one-impact", "elastic-stop/one-contact"
STICK = "dry-friction/global-stick"
every_orbit = pytest.mark.parametrize("name", orbit_names())


def found_at(name, points):
    """What a batch finds at the points, as orbits, with or without a motion behind them."""
    many = solve(name, points)
    return (single(many, i) for i in np.flatnonzero(many.converged))


def sampled(piece, start, duration, count):
    """States (5, count + 1) at equal distances of time, by doubling."""
    states, flow = start, piece.flow(duration / count)
    while states.shape[1] <= count:
        states, flow = np.hstack([states, flow @ states]), flow @ flow
    return states[:, : count + 1]


def peak(row, piece, start, count=1000):
    """Largest value of a boundary along a phase: sampled, and again around the largest sample."""
    states = sampled(piece, start, piece.dwell, count)
    best = int(np.argmax((row @ states)[0]))
    found = float((row @ states)[0, best])
    if 0 < best < count:
        width = 2 * piece.dwell / count
        fine = (row @ sampled(piece, states[:, best - 1 : best], width, 64))[0]
        top = min(max(int(np.argmax(fine)), 1), 63)
        left, middle, right = fine[top - 1 : top + 2]
        bend = left - 2 * middle + right
        found = max(found, float(middle))
        if bend < -1e-13 * max(1, abs(middle)):
            vertex = 0.5 * (left - right) / bend
            found = max(found, float(middle - 0.25 * (left - right) * vertex))
    return found


def maxima(orbit):
    """Largest value of each boundary that needs no open parameter, by phase and name."""
    return {
        (phase, name): peak(row, piece, start)
        for phase, (piece, start, _) in enumerate(Declared(orbit).steps)
        for name, row in piece.boundaries.items()
        if np.isfinite(row).all()
    }


def roots(orbit, most):
    """Solutions from other starts that are no longer, admissible or not."""
    data = {n: orbit.values[n] for n in orbit.kernels.parameter_names}
    for tau, tau1 in product(np.linspace(1, 13, 7), repeat=2):
        found = solve(STICK, data, {"tau": tau, "tau1": tau1}, throw=False)
        if found.converged and found.period < most:
            yield found


@every_orbit
def test_violations_are_those_of_dense_sampling(name):
    verdicts, phases, found_by_batch = set(), set(), [*found_at(name, random_points(name, 41, 40))]
    several = chain(*(islice(roots(orbit, 60), 10) for orbit in found_by_batch[:4]))
    for orbit in chain(found_by_batch, several if name == STICK else ()):
        found = {(v.phase, v.boundary): v for v in orbit.admissibility.violations}
        verdicts.add(orbit.admissibility.verdict)
        largest = maxima(orbit)
        expected = {key for key, value in largest.items() if value > 1e-8}
        phases |= expected
        assert expected <= found.keys()
        assert all(largest[key] > -1e-10 for key in found)  # none is invented
        declared = Declared(orbit)
        begins = np.cumsum([0.0, *orbit.dwell_times])
        for key in expected:
            violation = found[key]
            piece, start, _ = declared.steps[key[0]]
            assert violation.configuration == piece.configuration
            assert violation.excess == pytest.approx(largest[key], rel=1e-7, abs=1e-9)
            time = violation.time - begins[key[0]]
            assert -1e-12 <= time <= piece.dwell + 1e-12
            there = (piece.boundaries[key[1]] @ piece.flow(time) @ start).item()
            assert there == pytest.approx(violation.excess, rel=1e-9, abs=1e-10)
    allowed = "conditional" if load_orbit(name).open_parameters else True
    assert verdicts == {False, allowed} or name == "dry-friction/solution-ii"
    assert len(phases) >= (4 if name == STICK else 0)


@every_orbit
def test_bounds_on_open_parameters_are_those_of_dense_sampling(name):
    """A mass breaks backward where -f - us - ur = -f - e - 2 us is positive."""
    opened = [p.name for p in load_orbit(name).open_parameters]
    judged, positive, points = 0, 0, random_points(name, 42, 12)
    if name == STICK:  # on a fast belt a mass may be thrown backward
        random = np.random.default_rng(24)
        fast = random.uniform([0.4, 0.4, 2, 0.5, 0.3], [0.7, 1, 4, 4, 3], (1000, 5)).T
        thrown = solve(name, dict(zip(points, fast, strict=True))).bounds["us1"] > 1e-3
        points = {
            n: np.append(a, b[thrown][:4]) for (n, a), b in zip(points.items(), fast, strict=True)
        }
    for orbit in found_at(name, points):
        if orbit.admissibility.verdict is False:
            continue
        required = {r.parameter: r.greater_than for r in orbit.admissibility.requires}
        least = dict.fromkeys(opened, 0.0)
        zero = {n: as_value(0) for n in opened}
        for piece, start, _ in Declared(replace(orbit, opened=zero)).steps:
            for boundary, row in piece.boundaries.items():
                if boundary.endswith("backward"):
                    us = "us1" if boundary.startswith("first") else "us2"
                    least[us] = max(least[us], peak(row, piece, start) / 2)
        assert set(least) == set(opened)
        for us, bound in least.items():
            assert required[us] == pytest.approx(bound, abs=1e-9)
            static, excess = us.replace("s", "r"), orbit.values[us.replace("us", "e")]
            assert required[static] == pytest.approx(bound + excess, abs=1e-9)
        judged += 1
        positive += least.get("us1", 0) > 1e-3
    assert judged > 3
    assert positive >= (2 if name == STICK else 0)


def exact_value(orbit, violation):
    """A boundary at the time of its violation, with forty digits."""
    sharp = refine(orbit, 40)
    with mpmath.workdps(60):
        declared = Declared(sharp, precise=True)
        piece, start, _ = declared.steps[violation.phase]
        begin = sum(sharp.dwell_times.tolist()[: violation.phase])
        time = min(max(mpmath.mpf(violation.time) - begin, 0), piece.dwell)
        return float((piece.boundaries[violation.boundary] @ (piece.flow(time) @ start))[0])


def test_a_penetration_of_a_stiff_stop_is_seen():
    """Three half swings of a stiff spring leave the contact in between, by u / omega."""
    stiffness = 1e12
    half = np.pi / np.sqrt(stiffness)
    plain = solve(ELASTIC, {"k3": stiffness})
    assert plain.unknowns["tau"] == pytest.approx(half, rel=1e-5)
    assert plain.admissibility.verdict is True
    orbit = solve(ELASTIC, {"k3": stiffness}, {"tau": 3 * half})
    assert orbit.unknowns["tau"] == pytest.approx(3 * half, rel=1e-3)
    assert orbit.admissibility.verdict is False
    (violation,) = (v for v in orbit.admissibility.violations if v.phase == 0)
    assert violation.excess == pytest.approx(orbit.unknowns["u"] / 1e6, rel=1e-3)
    assert violation.time == pytest.approx(1.5 * half, rel=1e-2)


def test_a_slow_penetration_is_seen_whatever_the_mass():
    """A heavy first mass drifts through the stop by some u^2: no parameter's size hides it."""
    for mass in (1e3, 1e6, 1e9):
        orbit = solve(RIGID, {"m1": mass})
        assert orbit.unknowns["u"] > 0
        assert orbit.admissibility.verdict is False
        (violation,) = orbit.admissibility.violations
        assert 0 < exact_value(orbit, violation) < 10 * orbit.unknowns["u"]
        assert not solve(RIGID, {"m1": [mass]}).admissible.any()


def test_a_penetration_too_shallow_to_be_seen_is_one():
    """Behind the impact u decides, however little the stop is passed: some u^2."""
    grazing = solve(RIGID, unknown=["T"], given={"u": 0}).values["T"]
    periods = [1e-12, 1e-9, 1e-6, *(grazing + s * d for d in (1e-4, 1e-8, 1e-11) for s in (1, -1))]
    many = solve(RIGID, {"T": periods})
    assert (many.unknowns["u"] > 0).tolist() == [True] * 3 + [True, False] * 3
    assert many.admissible.tolist() == [False] * 3 + [False, True] * 3
    for period, admissible in zip(periods, many.admissible, strict=True):
        found = solve(RIGID, {"T": period}).admissibility
        assert found.verdict is bool(admissible)
        for violation in found.violations:
            assert violation.boundary == "first-reaches-stop"
            assert violation.excess >= 0
            assert 0 <= violation.time < period


@pytest.mark.parametrize("name", [RIGID, ELASTIC])
@pytest.mark.parametrize(
    ("mass", "time"), [(1e-12, 1e-4), (1e-3, 1e-2), (1e3, 1e2), (1e12, 1e5), (1, 1e5), (1e12, 1)]
)
@pytest.mark.parametrize("period", ["2*pi", "6.9", "8"])
def test_units_of_mass_and_time_change_nothing(name, mass, time, period):
    plain = solve(name, {"T": period}, throw=False)
    if not plain.converged:
        return
    sizes = {"m": mass, "k": mass / time**2, "T": time, "y": 1, "u": 1 / time, "w": 1 / time}
    scaled = {n: x * sizes.get(n, sizes.get(n[0], time)) for n, x in plain.values.items()}
    other = solve(name, {n: scaled[n] for n in plain.kernels.parameter_names})
    assert other.admissibility.verdict is plain.admissibility.verdict
    assert other.stability.verdict == plain.stability.verdict
    assert other.trace == pytest.approx(plain.trace, rel=1e-8)
    for unknown, value in other.unknowns.items():
        assert value == pytest.approx(scaled[unknown], rel=1e-7, abs=1e-12 * max(sizes.values()))


@every_orbit
def test_what_meets_no_boundary_is_not_admissible(name):
    """Data that miss the boundaries by more than rounding are no motion."""
    orbit = solve(name)
    for unknown in orbit.kernels.timed:
        # beyond the end of a phase its boundary is crossed
        late = {**orbit.unknowns, unknown: orbit.values[unknown] + 1e-6}
        assert replace(orbit, unknowns=late).admissibility.verdict is False


def test_beyond_the_guarantee_it_says_so():
    orbit = solve(RIGID, {"T": "1e6"})
    assert orbit.converged
    with pytest.raises(ValueError, match=r"cannot be guaranteed: free lasts 1e\+06") as caught:
        _ = orbit.admissibility
    assert "\n" not in str(caught.value)
    many = solve(RIGID, {"T": [6.28, 1e6]})
    assert many.converged.all()
    assert many.admissible.tolist() == [True, False]

"""Orbits that are periodic up to a shift, against closed forms and direct integration."""

import json
import math
from functools import cache

import numpy as np
import pytest
import sympy as sp
from scipy.integrate import solve_ivp

import nonsmooth as ns
from nonsmooth import InputError
from nonsmooth.derive import Itinerary, Reference
from nonsmooth.runtime.explore.finding.outcomes import Outcome
from tests.certified import edited
from tests.places import GALLERY
from tests.shifting_systems import (
    CAPSULE,
    GEARED,
    GROUND,
    PULLED,
    SHAKEN,
    SLED,
    TURNED,
    box,
    pulled,
    settled_orbit,
)

pytestmark = pytest.mark.compiled  # much slower, or nothing to compare, without it

GEAR = str(GALLERY / "backlash_gear.py")
c = sp.Symbol("c")


@cache
def sled():
    return settled_orbit(SLED, PULLED, [0, 1, 0, 0.4])


@cache
def capsule():
    return settled_orbit(CAPSULE, SHAKEN)


@cache
def gear():
    return ns.solve(f"{GEAR}:rattle")


# --- directions


def test_the_direction_is_the_same_in_every_arithmetic():
    orbit = settled_orbit(GEARED, {**TURNED, "i": "3/2"})
    for each, error in ((orbit, 1e-15), (ns.refine(orbit, 40), 1e-38)):
        (direction,) = each.tables.translations
        assert abs(direction - np.array([1, 0, 0, 0, 0, 0]))[[0, 2, 3, 4, 5]].max() == 0
        assert abs(direction[1] * 3 - 2) < error


# --- orbits


def test_a_pulled_sled_is_den_hartogs_mass_on_a_belt():
    orbit = sled()
    period = 2 * math.pi - 2 * math.atan(0.3 / 0.5) + 2 * 0.3 / 0.5
    assert orbit.period == pytest.approx(period, abs=1e-13)
    assert orbit.shift == pytest.approx({"x": period / 2, "y": period / 2, "v": 0, "v_y": 0})
    first, second, *rest = orbit.stability.multipliers
    assert all(m.real == m.imaginary == 0 for m in rest)
    assert (first.real, first.trivial) == (1, True)
    assert second.real == pytest.approx(math.exp(-period), rel=1e-10)
    assert orbit.trace == pytest.approx(1 + math.exp(-period))
    assert (orbit.stability.verdict, orbit.admissibility.verdict) == ("stable", True)
    precise = ns.refine(orbit, 40)
    assert abs(precise.shift["x"] - precise.period / 2) < 1e-38


def test_what_a_period_shifts_has_no_extremes():
    derivatives = gear().derivatives("J")
    names = derivatives.along.names
    for name in ("maximum:x1", "minimum:x2", "peak:x1"):
        assert name not in names
        with pytest.raises(InputError, match="is shifted by each period"):
            derivatives.quantity(name)
    with pytest.raises(InputError, match="periodic up to a shift"):
        derivatives.along.states([1.0])
    value, _ = derivatives.quantity("maximum:v1")
    sampled = gear().motion().sample(4001).states[:, 2].max()
    assert value == pytest.approx(sampled, abs=1e-5)
    assert value >= sampled


def test_where_the_guess_lies_along_the_direction_does_not_matter():
    orbit = gear()
    data = {name: value.text for name, value in orbit.parameters.items()}
    moved = orbit.states[0] + [7, 7, 0, 0, 0, 0]
    again = ns.solve(GEAR, data, [*orbit.dwell_times * 1.001, *moved], itinerary=orbit.itinerary)
    np.testing.assert_allclose(again.dwell_times, orbit.dwell_times, rtol=1e-10)
    np.testing.assert_allclose(again.states[0], orbit.states[0], atol=1e-9)
    assert again.states[0, 0] == 0


def gear_field(data):
    def field(time, y):
        gap = y[0] - y[1]
        teeth = data["k"] * (max(gap - data["b"], 0) + min(gap + data["b"], 0))
        torque = data["M"] + data["A"] * y[5] - data["c"] * y[2]
        turn = data["w"] * np.array([-y[5], y[4]])
        return np.array([y[2], y[3], torque - teeth, (teeth - data["d"] * y[3]) / data["J"], *turn])

    return field


def test_the_gear_turns_by_the_mean_torque_and_comes_back_by_direct_integration():
    orbit = gear()
    data = {name: float(value) for name, value in orbit.parameters.items()}
    period = 4 * math.pi / data["w"]
    turn = data["M"] * period / (data["c"] + data["d"])
    assert orbit.period == pytest.approx(period, abs=1e-11)
    assert orbit.shift == pytest.approx(
        {"x1": turn, "x2": turn, "v1": 0, "v2": 0, "c1": 0, "s1": 0}, abs=1e-9
    )
    options = {"method": "DOP853", "rtol": 1e-12, "atol": 1e-13}
    start = end = orbit.states[0]
    for duration in orbit.dwell_times:  # no step goes over a kink, where teeth meet or part
        end = solve_ivp(gear_field(data), (0, duration), end, **options).y[:, -1]
    np.testing.assert_allclose(end - start, [turn, turn, 0, 0, 0, 0], atol=1e-10)
    # multipliers of the return map at a fixed phase, by differences
    step = 1e-7

    def returned(state):
        return ns.simulate(GEAR, data, state, until=period)([period])[0, :4]

    columns = [returned(start + step * d) - returned(start - step * d) for d in np.eye(6)[:4]]
    values = np.linalg.eigvals(np.array(columns).T / (2 * step))
    found = sorted(orbit.multipliers, key=lambda m: (m.real, m.imag))
    np.testing.assert_allclose(sorted(values, key=lambda m: (m.real, m.imag)), found, atol=2e-4)
    assert np.prod(found).real == pytest.approx(
        math.exp(-(data["c"] + data["d"] / data["J"]) * period), rel=1e-8
    )


def test_a_rotor_without_finite_numbers_is_left_out_of_a_batch():
    """Its direction is found at each point."""
    system, phases, guess = gear().system, gear().itinerary, [*gear().unknowns.values()]
    given = {name: float(value) for name, value in gear().parameters.items()}
    found = ns.solve(system, {**given, "J": [given["J"], 5e-324]}, guess, itinerary=phases)
    assert found.converged.tolist() == [True, False]
    stiff = {**given, "J": 2 * given["J"], "k": 1e101}
    lost = ns.solve(system, stiff, guess, itinerary=phases, throw=False)
    assert not np.isfinite(lost.saltations).all()


def test_a_capsule_moves_on_as_it_does_when_it_is_simulated():
    orbit = capsule()
    assert orbit.stability.verdict == "stable"
    assert orbit.admissibility.verdict is True
    name = orbit.itinerary[0][0]
    motion = ns.simulate(
        CAPSULE, SHAKEN, orbit.states[0], configuration=name, until=3 * orbit.period * (1 - 1e-12)
    )
    moved = motion([3 * orbit.period * (1 - 1e-12)])[0] - orbit.states[0]
    shift = list(orbit.shift.values())
    assert shift[0] == pytest.approx(shift[1], abs=1e-12)
    assert abs(shift[0]) > 0.01
    np.testing.assert_allclose(moved[:2], 3 * np.array(shift[:2]), atol=1e-8)
    drawn = orbit.trajectory(3)
    np.testing.assert_allclose(drawn.states[-1] - drawn.states[0], 3 * np.array(shift), atol=1e-12)


def test_orbits_are_found_up_to_their_shift():
    found = ns.find_orbits(SLED, PULLED, 10, transitions=200, rng=0)
    (entry,) = found.orbits
    assert entry.period == pytest.approx(sled().period, abs=1e-12)
    assert entry.starts > 5


@pytest.mark.parametrize(("damper", "outcome"), [("0", Outcome.FAMILY), ("0.3", Outcome.DRIFTING)])
def test_a_sled_that_is_pulled_for_ever_neither_rests_nor_diverges(damper, outcome):
    dragged = pulled("dragged", [[0, 0], [0, 1]] if damper == "0" else [[c, -c], [0, 1]])
    data = PULLED if damper == "0" else {**PULLED, "c": damper}
    box = {"v": (-2.6, 2.6), "v_y": (-2.6, 2.6)}
    found = ns.find_orbits(dragged, data, 30, transitions=100, box=box, rng=0)
    sliding = found.starts[found.labels == outcome]
    assert set(found.outcomes) == {outcome}
    assert len(sliding) == 30 - sum(entry.starts for entry in found.orbits) > 0
    speeds = []
    for start in sliding:
        later = ns.simulate(dragged, data, start, until=400)(np.linspace(200, 400, 500))[:, 2]
        assert later.min() > 0
        assert later.mean() == pytest.approx(0.5, abs=0.02)
        speeds.append(np.ptp(later))
    assert (max(speeds) > 0.1) == (outcome == Outcome.FAMILY)


@pytest.mark.slow
def test_they_are_saved_and_solved_again(tmp_path):
    path = tmp_path / "sled.json"
    ns.refine(sled(), 30).save(path)
    again = ns.load(path)
    assert list(again.to_json()["shift"]) == ["x", "y"]
    assert abs(again.shift["x"] - again.period / 2) < 1e-28
    moved = ns.solve(str(path), {"V": "0.51"})
    assert moved.shift["x"] == pytest.approx(0.51 * moved.period, rel=1e-10)
    content = edited(path, lambda found: found["starts"][0].__setitem__(1, "-0.11"))
    path.write_text(json.dumps(content))
    with pytest.raises(ns.InputError, match="not a solution"):
        ns.load(path)


def test_an_itinerary_that_is_declared_is_composed():
    period = {"ts": "1.2", "tau": "5.2", "x": "0", "y": "1.3", "v": "0", "v_y": "0.5"}
    phases = [
        ("overshoot", "ground-reaches-belt", "tau"),
        ("stick", "ground-breaks-backward", "ts"),
    ]
    orbit = Itinerary("pulled", SLED, phases, reference=Reference(PULLED, period))
    assert ns.solve(orbit).period == pytest.approx(sled().period, abs=1e-12)


def test_a_symmetry_closes_half_of_a_motion_on_open_ground():
    shaken = box("shaken", GROUND)
    data = {name: SHAKEN[name] for name in ("A", "w", "u", "k", "c")}
    motion = ns.simulate(shaken, data, [0, 0, 0, 0, 1, 0], transitions=400)
    phases, dwell, start = ns.itinerary_of(motion)
    whole = ns.solve(shaken, data, [*dwell, *start], itinerary=phases)
    mirror = {name: f"-{name}" for name in ("x", "y", "v", "v_y", "c1", "s1")}
    half = ns.solve(shaken, data, [*dwell[:1], *start], itinerary=phases[:1], symmetry=mirror)
    assert whole.converged
    assert half.converged
    assert list(half.shift.values()) == pytest.approx([0] * 6, abs=1e-12)
    np.testing.assert_allclose(half.dwell_times, whole.dwell_times, atol=1e-11)
    np.testing.assert_allclose(half.states[:, 1:], whole.states[:, 1:], atol=1e-9)
    np.testing.assert_allclose(half.multipliers, whole.multipliers, atol=1e-9)


# --- proofs


@pytest.mark.parametrize("orbit", [sled, gear])
def test_they_are_proved_and_proved_again(tmp_path, orbit):
    found = orbit()
    certificate = ns.certify(found, 96)
    assert set(certificate.claims.values()) == {"proved"}
    assert (
        certificate.trace.contains(repr(float(ns.refine(found, 25).trace)))
        or abs(float(certificate.trace.mid) - float(found.trace)) < 1e-9
    )
    path = tmp_path / "proof.json"
    certificate.save(path)
    assert ns.certify.check(path).certificate is not None


@pytest.mark.parametrize(
    "change",
    [
        lambda rows: rows[:0],
        lambda rows: [*rows, *rows],
        lambda rows: [["1", "0", "0", "0"]],
        lambda rows: [["1", "1", "0", "1"]],
        lambda rows: [*rows, ["0", "0", "1", "0"]],
        lambda rows: [row[:-1] for row in rows],
        lambda rows: [["0", "0", "0", "0"]],
    ],
)
def test_another_direction_is_refused(tmp_path, change):
    path = tmp_path / "proof.json"
    ns.certify(sled(), 64).save(path)

    def turn(found):
        found["closing"]["translations"] = change(found["closing"]["translations"])

    path.write_text(json.dumps(edited(path, turn)))
    assert ns.certify.check(path).certificate is None


def test_a_box_of_parameters_is_proved_and_proved_again(tmp_path):
    # the spring's end moves at V, whatever V is: its speed spans an interval and does not change
    found = ns.certify.box(sled(), {"V": ("0.499", "0.501")}, tiles=20)
    assert found.proved
    found.save(path := tmp_path / "box.json")
    assert ns.certify.check(path).certificate is not None
    assert found.enclosures["tau1"].lower < sled().dwell_times[0] < found.enclosures["tau1"].upper


def test_what_does_not_return_is_not_counted():
    orbit = sled()
    with pytest.raises(ns.InputError, match="up to a shift"):
        ns.certify.all(SLED, PULLED, {"tau1": (1, 9), "tau2": (1, 9)}, itinerary=orbit.itinerary)

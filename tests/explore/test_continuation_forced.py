"""Branches of impact oscillators: folds, flips and tori in closed form, multipliers by simulation.

Closed forms: C. Budd and F. Dux, Phil. Trans. R. Soc. Lond. A 347 (1994).
"""

import math
from functools import cache

import numpy as np
import pytest
import sympy as sp

import nonsmooth
from nonsmooth.derive import Parameter, RigidStop, SoftStop
from tests.differences import in_doubles
from tests.one_mass import one_mass
from tests.tables import slow

W, R = 2.8, 0.8


@cache
def struck_at(place, *signed, damping="0"):
    """A forced mass that strikes a wall at a place, over parameters of either sign."""
    r, w = sp.symbols("r w")
    wall = RigidStop("x", at=sp.sympify(place), restitution=r, name="wall")
    own = [Parameter(name, name, lower=-sp.oo) for name in signed]
    given = {"damping": sp.sympify(damping), "forces": {w: 1}}
    return one_mass("impact-oscillator", wall, parameters=own, **given)


def system():
    return struck_at("sigma", "sigma", "c", damping="c")


@cache
def orbit(sigma=0, c=0):
    return nonsmooth.solve(
        system(),
        {"r": R, "sigma": sigma, "w": W, "c": c},
        [2 * math.pi / W],
        itinerary=[("free", "wall-reaches-stop")],
    )


@cache
def branch():
    return nonsmooth.continue_orbit(orbit(), "sigma", (-2.0, 0.14), step=0.02)


def closed_forms(w=W):
    """Stops at which the orbits of one impact in a period of the forcing fold and flip."""
    period = 2 * math.pi / w
    cotangent, gain = 1 / np.tan(period / 2), 1 / (1 - w * w)
    fold = gain * np.sqrt(1 + (w * cotangent * (1 + R) / (1 - R)) ** 2)
    ratio = (
        (1 - w * w) * (1 + R) * cotangent / 2
        + (1 + R * R - 2 * R * np.cos(period)) / ((1 + R) * np.sin(period))
    ) / w**2
    speed = np.abs(gain) / np.hypot(ratio + (1 + R) * cotangent / 2, (1 - R) / (2 * w))
    return fold, ratio * speed


def test_fold_and_flip_in_closed_form():
    fold, flip = closed_forms()
    events = {kind: [e for e in branch().events if e.kind == kind] for kind in ("fold", "flip")}
    assert [e.value for e in events["fold"]] == [pytest.approx(fold, abs=1e-12)]
    assert events["flip"][-1].value == pytest.approx(flip, abs=1e-11)
    # the branch turns: no point is beyond the fold, and both orbits are on it
    assert branch().parameter_values.min() >= fold - 1e-12
    assert np.count_nonzero(np.diff(np.sign(branch().parameter_values + 1.0))) == 2
    assert branch().stability.count("stable") > 10


def test_impact_speeds_solve_the_closed_equation():
    period = 2 * math.pi / W
    cotangent, gain = 1 / math.tan(period / 2), 1 / (1 - W * W)
    sigma = branch().parameter_values
    speed = -branch().quantity("v0") / R
    missed = (sigma + (1 + R) * cotangent * speed / 2) ** 2 + ((1 - R) * speed / (2 * W)) ** 2
    np.testing.assert_allclose(missed, gain**2, rtol=1e-10)


def test_multipliers_by_simulation():
    admissible = np.flatnonzero(branch().admissible & (branch().quantity("v0") < -0.05))
    for place in admissible[:: len(admissible) // 4].tolist():
        here = branch().orbit_at(place)
        start = here.states[0].astype(float)
        angle = math.atan2(start[3], start[2])

        def impact(moved, here=here, start=start):
            speed, turn = moved
            state = [start[0], speed, math.cos(turn), math.sin(turn)]
            motion = nonsmooth.simulate(system(), here.parameters, state, "free", transitions=1)
            end = motion.states[-1]
            return np.array(
                [end[1], turn + math.remainder(math.atan2(end[3], end[2]) - turn, 2 * math.pi)]
            )

        jacobian = in_doubles(impact, np.array([start[1], angle]))
        expected = np.sort_complex(np.linalg.eigvals(jacobian))
        found = np.sort_complex(branch().multipliers[place])
        np.testing.assert_allclose(found, expected, atol=1e-5)
        assert np.prod(found).real == pytest.approx(R * R, abs=1e-9)


def test_torus_where_the_area_is_kept():
    # between impacts the area shrinks by e^(-c T), at an impact by r^2
    damped = nonsmooth.continue_orbit(orbit(-0.5), "c", (-0.4, 0.4), step=0.02)
    (event,) = [e for e in damped.events if e.kind == "neimark-sacker"]
    assert event.value == pytest.approx(2 * math.log(R) / (2 * math.pi / W), abs=1e-11)
    multipliers = damped.orbit_at(event).multipliers
    np.testing.assert_allclose(np.abs(multipliers), 1, atol=1e-9)


@cache
def stops():
    r, w, f = sp.symbols("r w f")
    return one_mass(
        "two-stops",
        RigidStop("x", 1, r, name="right"),
        RigidStop("x", -1, r, name="left", side="lower"),
        damping="1/10",
        forces={w: f},
    )


@cache
def mirrored():
    """From one stop to the other, which its mirror image is."""
    data = {"r": 0.7, "w": 1.3, "f": 2}
    motion = nonsmooth.simulate(stops(), data, [0, 1, 1, 0], transitions=400)
    phases, dwell, start = nonsmooth.itinerary_of(motion)
    return nonsmooth.solve(
        stops(),
        data,
        [*dwell[:1].tolist(), *start.tolist()],
        itinerary=phases[:1],
        symmetry={"x": "-x", "v": "-v", "c1": "-c1", "s1": "-s1"},
    )


@cache
def broken():
    """Its branch, and the events where it loses its symmetry."""
    found = nonsmooth.continue_orbit(mirrored(), "w", (1.0, 2.0), step=0.03)
    return found, [event for event in found.events if event.kind == "symmetry-breaking"]


def test_symmetry_breaking_between_two_stops():
    found, events = broken()
    assert len(events) == 2
    for event in events:
        at = found.orbit_at(event)
        nearest = min(at.part_stability.multipliers, key=lambda m: abs(m.real + 1))
        assert nearest.real == pytest.approx(-1, abs=1e-8)
    for place in (0, len(found) // 2, -1):
        whole = found.orbit_at(place)
        assert found.trace[place] == pytest.approx(whole.trace, abs=1e-9)
        assert found.period[place] == pytest.approx(whole.period, abs=1e-12)
        assert found.admissible[place] == whole.admissibility.verdict


@cache
def bumped():
    """The orbit that strikes once of 2 x'' + 2 x' + 800 x = 2 cos(Omega t) at x = 1/200."""
    rubber = SoftStop("x", at="1/200", stiffness=8000, damping=5, name="rubber")
    forces = {sp.Symbol("Omega"): 2}
    soft = one_mass("bump", rubber, mass=2, damping=2, stiffness=800, forces=forces)
    known = nonsmooth.find_orbits(soft, {"Omega": 26}, 5, transitions=300).orbits
    return next(entry.orbit for entry in known if len(entry.itinerary) == 2)


def bump_grazing():
    """The lower frequency W at which the motion without the stop touches it.

    There (800 - 2 W^2)^2 + 4 W^2 is 400^2.
    """
    return float(np.sqrt(np.roots([4, 4 - 3200, 640_000 - 160_000]).min()))


@pytest.mark.parametrize("seed", [2, *(slow(seed) for seed in (5, 8))])
def test_a_branch_ends_once_where_a_phase_vanishes(seed):
    """x'' + 2 zeta x' + x = cos(w t) touches x = 1 where w^2 = 2 - 4 zeta^2, whatever the stop.

    There the branch turns, and the contact is left without speed: all of it is one event.
    """
    w, k, zeta = sp.symbols("w k zeta")
    stop = SoftStop("x", at=1, stiffness=k, name="stop")
    system = one_mass("bump", stop, damping=2 * zeta, forces={w: 1})
    rng = np.random.default_rng(seed)
    bounds = {"w": (0.85, 1.1), "k": (1, 20), "zeta": (0.05, 0.25)}
    data = {name: f"{rng.uniform(*ends):.2f}" for name, ends in bounds.items()}
    motion = nonsmooth.simulate(system, data, {"x": 0, "v": 0, "c1": 1, "s1": 0}, until=300)
    known = nonsmooth.solve(system, data, itinerary=nonsmooth.itinerary_of(motion))
    branch = nonsmooth.continue_orbit(known, "w", (0.7, 1.7), step=0.05)
    border = math.sqrt(2 - 4 * float(data["zeta"]) ** 2)
    (event,) = (e for e in branch.events if abs(e.value - border) < 1e-7)
    assert (event.kind, branch.events[-1]) == ("vanishing-phase", event)
    for place in (event, -1):
        orbit = branch.orbit_at(place)
        assert not orbit.converged
        assert "a dwell time goes to zero" in orbit.message
        np.testing.assert_array_equal(orbit.dwell_times, np.maximum(branch.unknowns[-1, :2], 0))

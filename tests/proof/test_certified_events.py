"""Bifurcations and limits of admissibility enclosed: closed forms to many digits, other routes."""

import mpmath
import pytest
import sympy as sp

import nonsmooth as ns
from nonsmooth import InputError
from nonsmooth.derive import Friction
from nonsmooth.runtime.core.arithmetic import exact_ball
from tests.certified import kicked, loop
from tests.checker.test_checker_events import followed as branch
from tests.explore import test_continuation_forced as impacts
from tests.one_mass import one_mass

STICK = "dry-friction/global-stick"
SYMMETRIC = "dry-friction/symmetric"


def of_kind(found, kind):
    """The last of a kind along the branch."""
    return [event for event in found.events if event.kind == kind][-1]


def holds(certificate, number):
    return bool(certificate.value.ball.contains(exact_ball(number)))


@pytest.mark.parametrize("bits", [64, 200, 1000])
def test_closed_forms_of_folds_flips_and_tori(bits):
    with mpmath.workprec(bits + 100):
        w, r = mpmath.mpf(28) / 10, mpmath.mpf(8) / 10
        period = 2 * mpmath.pi / w
        cotangent, gain = 1 / mpmath.tan(period / 2), 1 / (1 - w * w)
        fold = gain * mpmath.sqrt(1 + (w * cotangent * (1 + r) / (1 - r)) ** 2)
        torus = 2 * mpmath.log(r) / period
        found = ns.certify.event(impacts.branch(), of_kind(impacts.branch(), "fold"), bits)
        assert found.proved
        assert holds(found, fold)
        assert float(found.value.ball.rad()) < 1e3 * 2.0**-bits
        damped = ns.continue_orbit(impacts.orbit(-0.5), "c", (-0.4, 0.4), step=0.02)
        found = ns.certify.event(damped, of_kind(damped, "neimark-sacker"), bits)
        assert found.proved
        assert holds(found, torus)


@pytest.mark.parametrize(("parameter", "lower", "upper"), [("V", 0.5, 1.6), ("eta", 0.3, 2)])
def test_a_phase_that_vanishes(parameter, lower, upper):
    whole = branch(STICK, parameter, lower, upper)
    found = ns.certify.event(whole, of_kind(whole, "vanishing-phase"), 128)
    assert found.proved
    # the dwell time itself is exactly zero, and positive on the one side
    assert found.enclosures["ta"].contains(0)
    assert float(found.enclosures["ta"].ball.rad()) < 1e-35
    # on the side of the orbit it grows with the distance, which tells where it was zero
    side = 1e-6 if parameter == "eta" else -1e-6
    near, far = (
        ns.solve(STICK, {parameter: float(found.value) + k * side}).values["ta"] for k in (1, 2)
    )
    assert 0 < near < 1e-4
    assert far / near == pytest.approx(2, abs=1e-4)


def test_solution_ii_is_the_collision_of_the_global_stick():
    collision = ns.refine(ns.solve("dry-friction/solution-ii"), 45)
    e1 = collision.unknowns["e1"]
    whole = branch(STICK, "e1", 2.3, 3.2)
    found = ns.certify.event(whole, of_kind(whole, "vanishing-phase"), 128)
    assert found.proved
    assert abs(float(found.value) - float(e1)) < 1e-14
    assert abs(mpmath.mpf(found.value.mid) - mpmath.mpf(str(e1))) < 1e-30


def test_composed_orbits_and_touched_walls():
    # the orbit reaches v0/sqrt(k) = 2: a wall there is touched
    found = ns.continue_orbit(loop(), "a", (1.5, 3.5))
    event = of_kind(found, "grazing")
    certificate = ns.certify.event(found, event, 200)
    assert certificate.proved
    assert certificate.value.contains(2)
    assert (certificate.phase, certificate.boundary) == (0, "wall")
    with mpmath.workdps(60):
        assert certificate.enclosures["time"].ball.contains(exact_ball(mpmath.pi / 2))
    over = ns.continue_orbit(loop(r="-1/2"), "r", (-1.5, -0.25))
    flip = ns.certify.event(over, of_kind(over, "flip"), 200)
    assert flip.proved
    assert flip.value.contains(-1)
    assert kicked().name in flip.orbit


def test_what_is_no_regular_root_is_undecided_and_says_why():
    whole = branch("rigid-stop/one-impact", "T", 5.5, 7.5)
    found = ns.certify.event(whole, of_kind(whole, "branch-point"))
    assert found.claim == "undecided"
    assert not found.proved
    assert "no regular root" in found.reason
    assert found.to_json()["enclosures"] == {}


def test_an_event_that_is_elsewhere_is_not_proved():
    from dataclasses import replace

    whole = branch(SYMMETRIC, "V", 0.6, 1.3)
    flip = of_kind(whole, "flip")
    moved = replace(flip, value=flip.value + 1e-3)
    with pytest.raises(InputError, match="no event of the branch"):
        ns.certify.event(whole, moved)
    wrong = replace(whole, events=(moved,))
    found = ns.certify.event(wrong, moved)
    assert found.claim == "undecided"
    for bits in (10, 1.5, True, 10**6):
        with pytest.raises(InputError, match="bits"):
            ns.certify.event(whole, flip, bits)  # type: ignore[arg-type]  # that is what is refused


def test_where_no_multiplier_differs_from_zero_a_fold_is_undecided_and_says_why():
    """A branch with rest at a belt turns where the force limit is touched: no multiplier is 1."""
    belt = Friction("x", kinetic="1/4", static="7/8", velocity=sp.Symbol("p") / 4)
    slider = one_mass("slider", belt, stiffness="19/8", damping="81/256")
    itinerary = [("slip", "x-reaches-belt"), ("stick", "x-breaks-forward")]
    orbit = ns.solve(slider, {"p": "1.07"}, [3.324, 1.068], itinerary=itinerary)
    found = ns.continue_orbit(orbit, "p", (1.06, 1.1))
    fold, touch = of_kind(found, "fold"), of_kind(found, "tangent")
    assert fold.value == pytest.approx(touch.value)
    assert ns.certify.event(found, touch).proved
    turn = ns.certify.event(found, fold)
    assert not turn.proved
    assert "too few multipliers differ from zero" in turn.reason

"""The grazing of a rigid stop: the orbit with one impact more, against closed forms."""

from functools import cache

import mpmath
import numpy as np
import pytest
import sympy as sp
from flint import ctx

import nonsmooth as ns
from nonsmooth.derive import Friction, Parameter, RigidStop, oscillator
from nonsmooth.runtime.checker.orbits.points import JudgedOrbit
from nonsmooth.runtime.checker.orbits.stability import outside_if_reached
from nonsmooth.runtime.core.arithmetic import exact_ball
from tests.certified import accepted, certified_over, content_of, refused, stating
from tests.one_mass import one_mass
from tests.proof.test_beyond_borders import along, fewer, forged, judged, only

GAP = Parameter("sigma", "position of the stop", lower=-sp.oo)
SIGMA, W, R = sp.symbols("sigma w r")
STRIKER = one_mass(
    "striker", RigidStop("x", at=SIGMA, restitution=R, name="wall"),
    damping="1/10", forces={W: 1}, parameters=[GAP],
)  # fmt: skip
FREE, IMPACT = ("free", "forcing-phase"), ("free", "wall-reaches-stop")


class Closed:
    """The orbit of one impact in a period, in 50 digits: its speed V solves a quadratic equation.

    (gap D + (1 + r) h V)^2 + (k V / w)^2 = D^2 A^2, with the amplitude A without the stop.
    """

    def __init__(self, w, r):
        mpmath.mp.dps = 50
        w_, r_, beta = mpmath.mpf(w), mpmath.mpf(r), mpmath.mpf(1) / 20
        period, nu = 2 * mpmath.pi / w_, mpmath.sqrt(1 - beta**2)
        decay = mpmath.exp(-beta * period)
        self.h = decay * mpmath.sin(nu * period) / nu
        rate = decay * mpmath.cos(nu * period) - beta * self.h
        self.d = 1 - 2 * rate - 2 * beta * self.h + decay**2
        self.k = (rate * (1 - r_) + 2 * beta * self.h - 1 + r_ * decay**2) / w_
        self.amplitude = 1 / mpmath.sqrt((1 - w_**2) ** 2 + (2 * beta * w_) ** 2)
        self.share = (1 + r_) * self.h

    def speed(self, gap):
        """The lowest positive speed of an impact."""
        a = self.share**2 + self.k**2
        b = 2 * mpmath.mpf(gap) * self.d * self.share
        c = self.d**2 * (mpmath.mpf(gap) ** 2 - self.amplitude**2)
        root = mpmath.sqrt(b * b - 4 * a * c)
        return min(x for x in ((-b - root) / (2 * a), (-b + root) / (2 * a)) if x > 0)


@cache
def without_impact(w, r):
    """The branch of motions that do not reach the stop, 5 % to both sides of its grazing."""
    amplitude = float(Closed(w, r).amplitude)
    low, high = f"{amplitude * 0.95:.4g}", f"{amplitude * 1.05:.4g}"
    given = {"w": w, "r": r, "sigma": high}
    orbit = ns.solve(STRIKER, given, [2 * np.pi / float(w)], itinerary=[FREE])
    return certified_over(orbit, "sigma", low, high, beyond=True)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("w", "r", "side", "scenario"),
    [
        ("2.4", "0.8", "below", "persistence"),
        ("1.5", "0.8", "above", "nonsmooth fold"),
        # a motion that begins beyond the stop is none
        ("0.8", "0.3", "below", "persistence"),
    ],
)
def test_an_impact_begins_with_the_speed_zero(w, r, side, scenario, tmp_path):
    found, closed = without_impact(w, r), Closed(w, r)
    assert found.complete, found.statement
    (event,), beyond = found.events, only(found)
    assert event.kind == "grazing"
    with ctx.workprec(160):
        assert event.enclosures["sigma"].ball.contains(exact_ball(closed.amplitude))
    assert beyond.itinerary == (IMPACT,)
    assert (beyond.side, beyond.own) == (side, "above")
    assert (beyond.verdict, beyond.scenario) == ("unstable", scenario)
    assert (side == "below") == (closed.share > 0)
    tile = beyond.branch.tiles[0]
    assert {tile.before, tile.after} == {"unstable", "not admissible"}
    sign = -1 if side == "below" else 1
    for e in (0.05, 0.4, 0.9):
        about = along(beyond, sign * e)
        speed = -list(about.values())[1]
        assert speed == pytest.approx(float(r) * float(closed.speed(about["sigma"])), 1e-9)
    # by an orbit that is solved for on its own
    x, v, time, *_, value = along(beyond, sign * 0.8).values()
    guess = [2 * np.pi / float(w), x, v, np.cos(time * float(w)), np.sin(time * float(w))]
    orbit = ns.solve(STRIKER, {"w": w, "r": r, "sigma": value}, guess, itinerary=[IMPACT])
    assert ns.certify(orbit).claims == {
        "existence": "proved", "admissibility": "proved", "stability": "refuted",
    }  # fmt: skip
    assert accepted(found, tmp_path).claims == {"branch": "proved"}


@pytest.mark.slow
def test_a_branch_of_impacts_is_proved_up_to_the_speed_zero(tmp_path):
    """The multiplier grows beyond all bounds; behind it the motion without impacts is stable."""
    closed = Closed("2.4", "0.8")
    given = {"w": "2.4", "r": "0.8", "sigma": "0.2"}
    orbit = ns.solve(STRIKER, given, [2 * np.pi / 2.4], itinerary=[IMPACT])
    found = certified_over(orbit, "sigma", "0.19", "0.22", beyond=True)
    assert found.complete
    assert [part.verdict for part in found.intervals] == ["unstable", "not admissible"]
    (event,), beyond = found.events, only(found)
    assert (event.kind, event.instant) == ("tangent", "end")
    with ctx.workprec(160):
        assert event.enclosures["sigma"].ball.contains(exact_ball(closed.amplitude))
        assert list(event.enclosures.values())[1].ball.contains(0)
    assert beyond.itinerary == (FREE,)
    assert (beyond.side, beyond.own, beyond.verdict) == ("above", "below", "stable")
    assert "there free (forcing-phase) begins, stable, above it" in found.statement
    accepted(found, tmp_path)


@pytest.mark.slow
def test_a_third_impact_and_a_fourth(tmp_path):
    """From three impacts to four and back: both proofs meet in one value."""
    given, events = {"w": "0.7", "r": "0.6", "sigma": "-0.1"}, []
    orbits = ns.find_orbits(STRIKER, given, 12, transitions=300).orbits
    for own, high, count, verdict in ((3, "-0.1", 4, "unstable"), (4, "-0.08", 3, "stable")):
        orbit = next(o.orbit for o in orbits if len(o.orbit.itinerary) == own)
        found = certified_over(orbit, "sigma", "-0.12", high, beyond=True)
        assert found.complete, found.statement
        beyond = only(found)
        assert beyond.itinerary == (IMPACT,) * count
        assert (beyond.side, beyond.own, beyond.verdict) == ("above", "above", verdict)
        assert beyond.scenario == "nonsmooth fold"
        event = next(event for event in found.events if event.beyond)
        events.append(event.enclosures["sigma"].ball)
        accepted(found, tmp_path)
    assert events[0].overlaps(events[1])
    assert max(float(x.rad()) for x in events) < 1e-32


@pytest.mark.slow
def test_a_motion_that_is_no_function_of_time(tmp_path):
    """Stick-slip beside a stop: the section of the impact is tangent to the motion that grazes."""
    belt = oscillator(
        "belt-beside-a-stop", ["x", "y"], mass=[[1, 0], [0, "1/2"]],
        damping=[[0, 0], [0, "1/20"]], stiffness=[[2, -1], [-1, 3]],
        elements=[
            Friction("x", kinetic=1, static="3/2", velocity="1/2", name="belt"),
            RigidStop("y", at=SIGMA, restitution="3/5", name="wall"),
        ],
        parameters=[GAP],
    )  # fmt: skip
    orbit = ns.find_orbits(belt, {"sigma": "0.42"}, 4, transitions=300).orbits[0].orbit
    found = certified_over(orbit, "sigma", "0.415", "0.42", beyond=True)
    beyond = only(found)
    assert [c for c, _ in beyond.itinerary].count("slip-free") == 2
    assert (beyond.side, beyond.own, beyond.verdict) == ("below", "above", "unstable")
    accepted(found, tmp_path)


@pytest.mark.slow
def test_where_a_motion_grazes_twice_the_branch_ends_and_nothing_is_said_beyond(tmp_path):
    """One impact in two periods, as slow as may be: the motion touches the stop each period."""
    given = {"w": "4.4", "r": "0.8", "sigma": "0.053"}
    orbit = ns.solve(STRIKER, given, [4 * np.pi / 4.4], itinerary=[IMPACT])
    found = certified_over(orbit, "sigma", "0.0525", "0.056", beyond=True)
    assert found.complete
    (event,) = found.events
    assert event.beyond == ()
    assert "grazing" in [kind for kind, *_ in event.also]
    with ctx.workprec(160):
        touches = exact_ball(Closed("4.4", "0.8").amplitude)
        assert event.enclosures["sigma"].ball.contains(touches)
    accepted(found, tmp_path)


@pytest.mark.parametrize(("sigma", "outside"), [("0.1", False), ("0.12", False), ("0.2", True)])
def test_a_stable_orbit_is_not_called_unstable(sigma, outside):
    """Also where the trace is -1.2: two multipliers inside the circle add up to 2 at most."""
    given = {"w": "2.4", "r": "0.8", "sigma": sigma}
    orbit = ns.solve(STRIKER, given, [2 * np.pi / 2.4], itinerary=[IMPACT])
    assert (np.abs(orbit.multipliers).max() > 1) == outside
    judged = JudgedOrbit(content_of(ns.certify(orbit)))
    assert judged.existence.claim == "proved"
    with ctx.workprec(128):
        assert judged.orbit.speed(0) > 0
        assert outside_if_reached(judged.orbit, 0) == outside


def earlier(beyond):
    """The event of the impacts a bit beside where it is."""
    own = beyond["branch"]["tiles"][0]["event"]
    own.update({end: str(sp.Rational(own[end]) - sp.Rational(1, 10**12)) for end in BOUNDS})


BOUNDS = "lower", "upper"
FORGERIES = {
    "the verdict": (lambda beyond: judged(beyond, "stable"), "it is unstable"),
    "the event": (earlier, "no event between"),
    "the restitution": (
        stating("branch", "parameters", r="7/10"), "other parameters"
    ),
    "the departure": (lambda beyond: fewer(beyond, "tangent", "start"), "but for the event"),
    "the condition": (lambda beyond: fewer(beyond, "condition", "end"), "but for the event"),
}  # fmt: skip


@pytest.mark.parametrize("name", FORGERIES)
def test_edited_files_are_refused(name):
    change, reason = FORGERIES[name]
    refused(forged(without_impact("2.4", "0.8"), lambda _, beyond: change(beyond)), reason)

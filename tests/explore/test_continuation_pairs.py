"""Two events between two points of a branch, and those that are touched but not passed.

A stop at place + q^2 - d makes of each event that an impact oscillator has over the place of
its stop a pair over q, at the square roots of d, that meets at d = 0.
"""

import math

import numpy as np
import pytest

import nonsmooth
from tests.explore.test_continuation_forced import R, W, branch, closed_forms, struck_at

START = -0.2  # of q


def pair(kind, d, step=0.1):
    event = [event for event in branch().events if event.kind == kind][-1]
    place = {"flip": closed_forms()[1], "fold": closed_forms()[0]}.get(kind, event.value)
    sigma = branch().parameter_values
    near = np.flatnonzero(abs(np.arange(len(sigma)) - event.place) < 30)
    k = int(near[np.argmin(abs(sigma[near] - place - START**2))])
    guess = branch().orbit_at(k)
    data = {"r": R, "w": W, "place": repr(float(place)), "q": START, "d": d}
    orbit = nonsmooth.solve(
        struck_at("place + q**2 - d", "place", "q", "d"),
        data,
        [*guess.dwell_times.tolist(), *guess.states[0].tolist()],
        itinerary=guess.itinerary,
    )
    return nonsmooth.continue_orbit(orbit, "q", (-0.25, 0.25), step=step)


@pytest.mark.parametrize("kind", ["flip", "grazing"])
@pytest.mark.parametrize("d", [1e-4, 1e-7, 1e-10])
def test_two_events_within_a_step(kind, d):
    found = pair(kind, d)
    root = math.sqrt(d)
    assert [event.kind for event in found.events] == [kind, kind]
    # both multipliers, or both maxima, are where they were: an error e shifts q by e / (2 q)
    for event, wanted in zip(found.events, (-root, root), strict=True):
        assert event.value == pytest.approx(wanted, abs=1e-13 / root)
        assert not event.touching
        orbit = found.orbit_at(event)
        if kind == "flip":
            assert min(abs(orbit.multipliers + 1)) < 1e-9
    if d < 1e-4:
        values = found.parameter_values
        assert not ((values > -root) & (values < root)).any()


@pytest.mark.parametrize("kind", ["flip", "grazing"])
def test_what_is_touched(kind):
    (event,) = pair(kind, 0).events
    assert (event.kind, event.touching) == (kind, True)
    assert event.value == pytest.approx(0, abs=1e-7)
    assert event.text.endswith("touched and not passed")


@pytest.mark.parametrize("kind", ["flip", "grazing"])
def test_what_is_not_reached(kind):
    for d in (-1e-8, -1e-4):
        assert pair(kind, d).events == ()


def test_a_branch_point_opens_into_a_fold():
    """Where two folds meet two branches cross: q^2 - d is a multiple of (y - y0)^2."""
    (crossing,) = pair("fold", 0, 0.02).events
    assert crossing.kind == "branch-point"
    assert crossing.value == pytest.approx(0, abs=1e-6)
    assert pair("fold", -1e-4, 0.02).events == ()
    folded = pair("fold", 1e-4, 0.01)
    (fold,) = folded.events
    assert (fold.kind, fold.value) == ("fold", pytest.approx(-1e-2, abs=1e-11))
    assert folded.parameter_values.max() <= fold.value + 1e-12


@pytest.mark.slow
def test_events_do_not_depend_on_the_steps():
    orbit = nonsmooth.solve("dry-friction/symmetric")
    fine = nonsmooth.continue_orbit(orbit, "V", (0.3, 1.3), step=0.005)
    coarse = nonsmooth.continue_orbit(orbit, "V", (0.3, 1.3), step=0.1)
    assert len(coarse) < len(fine) / 4
    assert [e.kind for e in coarse.events] == [e.kind for e in fine.events]
    for one, other in zip(coarse.events, fine.events, strict=True):
        assert one.value == pytest.approx(other.value, abs=1e-11)

"""Branches over one parameter: points, ends, events, against other routes to the same numbers."""

import math
from functools import cache

import numpy as np
import pytest

import nonsmooth
from nonsmooth.runtime.explore.intervals import admissible_intervals
from tests.certified import loop
from tests.core.test_result_files import composed as timed
from tests.places import GALLERY
from tests.two_masses import PHASES, STICKING

STICK = "dry-friction/global-stick"


@cache
def stick(parameter="V", lower=0.8, upper=1.3):
    return nonsmooth.continue_orbit(nonsmooth.solve(STICK), parameter, (lower, upper))


def composed():
    return nonsmooth.solve("dry-friction", STICKING, [1, 2, 1.5, 3.3], itinerary=PHASES)


@pytest.mark.parametrize(("parameter", "interval"), [("V", (0.8, 1.3)), ("eta", (0.5, 2.0))])
def test_points_are_orbits(parameter, interval):
    branch = stick(parameter, *interval)
    given = {name: float(value) for name, value in branch.orbit.given.items()}
    places = np.random.default_rng(1).integers(1, len(branch) - 1, 6)
    for place in places.tolist():
        here = {**given, parameter: float(branch.parameter_values[place])}
        orbit = nonsmooth.solve(STICK, here, branch.unknowns[place].tolist())
        found = np.array(list(orbit.unknowns.values()))
        np.testing.assert_allclose(branch.unknowns[place], found, rtol=0, atol=1e-12)
        assert branch.trace[place] == pytest.approx(orbit.trace, abs=1e-11)
        assert branch.period[place] == pytest.approx(orbit.period, abs=1e-12)
        assert branch.stability[place] == orbit.stability.verdict
    assert np.abs(np.diff(branch.parameter_values)).max() < 0.01 * np.diff(interval)[0] * 1.5


def test_ends_are_admissibility_limits():
    for parameter, interval in (("V", (0.8, 1.3)), ("eta", (0.5, 2.0)), ("e1", (1.0, 3.9))):
        branch = stick(parameter, *interval)
        (limits,) = admissible_intervals(STICK, parameter, *interval, points=200)
        (event,) = [e for e in branch.events if e.kind == "vanishing-phase"]
        end = limits.upper if branch.ends[1] == "ta goes to zero" else limits.lower
        assert event.value == pytest.approx(end, abs=1e-11)
        assert event.unknowns["ta"] == pytest.approx(0, abs=1e-13)
        assert (event.configuration, event.boundary) == PHASES[0]


def test_grazing_names_the_boundary_that_is_touched(monkeypatch):
    orbit = nonsmooth.solve("dry-friction/symmetric")
    branch = nonsmooth.continue_orbit(orbit, "V", (0.5, 0.8))
    (event,) = [e for e in branch.events if e.kind == "grazing"]
    assert (event.configuration, event.boundary) == ("slip-slip", "first-reaches-belt")
    at = branch.orbit_at(event)
    assert (event.phase, event.time is None) == (0, False)
    # the first mass comes as near to the belt's velocity as it does anywhere in the phase
    motion = at.motion()
    times = event.time + np.array([0, -1e-4, 1e-4])
    touched, before, after = motion(times)[:, motion.names.index("v1")] - event.value
    assert abs(touched) < 1e-11
    assert max(before, after) < -1e-10
    slower = motion(np.linspace(0, at.dwell_times[0], 2000))[:, motion.names.index("v1")]
    assert slower.max() < event.value + 1e-9
    before, behind = math.floor(event.place), math.ceil(event.place)
    assert branch.admissible[before] != branch.admissible[behind]
    # were it not seen, admissibility would still end there, here between sides that can be told
    room = "nonsmooth.runtime.explore.continuation"
    monkeypatch.setattr(f"{room}.continue_orbit.locate_all", lambda track: [])
    monkeypatch.setattr(f"{room}.locating._HALVINGS", 20)
    bare = nonsmooth.continue_orbit(orbit, "V", (0.5, 0.8))
    (limit,) = bare.events
    assert (limit.kind, limit.boundary) == ("admissibility", "first-reaches-belt")
    assert limit.value == pytest.approx(event.value, abs=1e-7)
    assert bare.orbit_at(limit).admissibility.verdict


def test_period_as_the_parameter():
    branch = nonsmooth.continue_orbit(timed(), "period", (5.1, 6.5))
    derived = nonsmooth.continue_orbit(nonsmooth.solve("rigid-stop/one-impact"), "T", (5.1, 6.5))
    assert [e.kind for e in branch.events] == [e.kind for e in derived.events]
    assert [e.kind for e in branch.events].count("flip") == 2
    for mine, theirs in zip(branch.events, derived.events, strict=True):
        assert mine.value == pytest.approx(theirs.value, abs=1e-8)


@pytest.mark.slow
def test_border_collision_is_passed(monkeypatch):
    branch = stick()
    (event,) = branch.events

    def refused(*_):
        raise nonsmooth.InputError("no such motion")

    # that one of the ways on cannot be judged loses none of the others
    inside = "nonsmooth.runtime.explore.continuation.next_orbits._without_boundary"
    monkeypatch.setattr(inside, refused)
    found = [o for o in branch.next_itineraries(event) if float(o.parameters["V"]) > event.value]
    (orbit,) = found
    assert orbit.admissibility.verdict is True
    # the first mass breaks before the second one has reached the belt
    assert orbit.itinerary[0] == ("stick-slip", "first-breaks-forward")
    back = nonsmooth.continue_orbit(orbit, "V", (1.19, 1.21), step=0.05)
    (meeting,) = [e for e in back.events if e.kind == "vanishing-phase"]
    assert meeting.value == pytest.approx(event.value, abs=1e-10)


def test_stops_where_it_is_no_motion():
    orbit = nonsmooth.solve("dry-friction/symmetric")
    branch = nonsmooth.continue_orbit(orbit, "V", (0.5, 0.8), admissible=True)
    assert branch.ends[0].startswith("the orbit is no motion")
    assert np.count_nonzero(~branch.admissible) == 1
    (event,) = [e for e in branch.events if e.kind == "grazing"]
    assert event.place < 1


def test_resonance_ends_a_branch():
    orbit = nonsmooth.solve("rigid-stop/one-impact")
    branch = nonsmooth.continue_orbit(orbit, "T", (3.2, 6.5))
    assert "resonance" in branch.ends[0]
    assert np.isfinite(branch.unknowns).all()


@pytest.mark.parametrize(
    ("arguments", "options", "message"),
    [
        (("W", (0.8, 1.3)), {}, "unknown given parameter 'W'"),
        (("V", (1.3, 0.8)), {}, "is empty"),
        (("V", (2, 3)), {}, "is not in 2 to 3"),
        (("V", (-1, 3)), {}, "V = -1 is outside its domain"),
        (("V", (0.8, 1.3)), {"step": 0}, "step = 0"),
        (("V", (0.8, 1.3)), {"points": 0}, "points = 0"),
    ],
)
def test_wrong_input(arguments, options, message):
    with pytest.raises(nonsmooth.InputError, match=message):
        nonsmooth.continue_orbit(nonsmooth.solve(STICK), *arguments, **options)


def test_no_orbit_to_follow():
    with pytest.raises(nonsmooth.InputError, match="orbit takes"):
        nonsmooth.continue_orbit(STICK, "V", (0, 1))
    with pytest.raises(nonsmooth.InputError, match="unknown given parameter 'period'"):
        nonsmooth.continue_orbit(composed(), "period", (7, 8))
    with pytest.raises(nonsmooth.InputError, match="no point 1000"):
        stick().orbit_at(1000)
    with pytest.raises(nonsmooth.InputError, match="unknown quantity 'tb'"):
        stick().quantity("tb")


def test_what_is_zero_all_along_is_no_event():
    # each phase begins on the boundary that the other one reached: x = 0, whatever k is
    whole = nonsmooth.continue_orbit(loop(), "k", (0.3, 1.5))
    ((kind, value),) = [(event.kind, event.value) for event in whole.events]
    # the orbit goes as far as 2/sqrt(k): a wall stands at 3
    assert (kind, value) == ("grazing", pytest.approx(4 / 9, abs=1e-12))
    assert nonsmooth.continue_orbit(loop(), "r", (0.3, 0.6)).events == ()


def test_the_docstring_of_an_event_names_its_kind():
    for event in (*stick().events, *nonsmooth.continue_orbit(loop(), "k", (0.3, 1.5)).events):
        assert f'"{event.kind}"' in str(type(event).__doc__)


def test_an_interrupt_while_events_are_located_loses_no_point(monkeypatch):
    """They take as long as the points; a branch that is whole is not followed again."""
    orbit, calls, median = nonsmooth.solve(STICK), list[int](), np.nanmedian

    def interrupted_once(values):
        calls.append(1)
        if len(calls) == 1:
            raise KeyboardInterrupt
        return median(values)

    whole = nonsmooth.continue_orbit(orbit, "V", (0.95, 1.05))
    monkeypatch.setattr(np, "nanmedian", interrupted_once)  # of what the events are told by
    with pytest.raises(nonsmooth.Interrupted) as stopped:
        nonsmooth.continue_orbit(orbit, "V", (0.95, 1.05))
    found = stopped.value.partial
    np.testing.assert_array_equal(found.unknowns, whole.unknowns)
    assert (found.ends, found.events) == (whole.ends, whole.events)
    again = nonsmooth.continue_orbit(orbit, "V", (0.95, 1.05), resume=found)
    assert (len(again), again.ends) == (len(whole), whole.ends)


def test_a_refined_orbit_by_tables_is_followed_as_the_one_in_doubles():
    orbit = nonsmooth.solve(f"{GALLERY / 'two_stops.py'}:symmetric")
    found, refined = (
        nonsmooth.continue_orbit(start, "d", (0.599, 0.601), points=8)
        for start in (orbit, nonsmooth.refine(orbit, 40))
    )
    assert refined.stability == found.stability
    np.testing.assert_allclose(refined.parameter_values, found.parameter_values, rtol=1e-12)
    np.testing.assert_allclose(refined.unknowns, found.unknowns, rtol=1e-10, atol=1e-12)

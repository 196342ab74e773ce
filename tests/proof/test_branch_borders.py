"""Borders of branches: entry, tangent, simultaneous and condition events, proved and checked."""

from dataclasses import replace
from functools import cache

import mpmath
import pytest
import sympy as sp

import nonsmooth as ns
from nonsmooth.derive import (
    Boundary,
    Condition,
    Configuration,
    FirstOrder,
    Parameter,
    System,
    Transition,
)
from nonsmooth.runtime.core.arithmetic import exact_ball
from tests.certified import accepted, believed, certified_over, content_of, edited, refused

A, B = sp.symbols("a b", real=True)
THRESHOLD = Parameter("w", "a threshold, nondimensional", lower=-sp.oo)
WIDTH = sp.Rational(1, 10)
ON_AND_OFF = (("on", "warm"), ("off", "cold"))


def relay(
    on=(),
    off=(),
    more=(),
    reset=None,
    before=(),
    when=(),
    threshold=THRESHOLD,
):
    """Two lags behind a relay with hysteresis: a' = +-1 - a, b' = a - b."""
    lags = [[-1, 0], [1, -1]]
    heats, cools = FirstOrder(lags, [1, 0]), FirstOrder(lags, [-1, 0])
    return System(
        "relay",
        "two lags and a relay; nondimensional",
        (A, B),
        (threshold,),
        (
            Configuration("on", heats, (Boundary("warm", B - WIDTH), *on)),
            Configuration("off", cools, (Boundary("cold", -B - WIDTH), *off)),
        ),
        (
            *before,
            Transition("on", {"warm"}, "off", reset=reset or {}, conditions=when),
            Transition("off", {"cold"}, "on"),
            *more,
        ),
    )


def two_phases(system, value, threshold="w"):
    """The orbit of a relay that is on and off once."""
    return ns.solve(system, {threshold: value}, [1.0, 1.0], itinerary=ON_AND_OFF)


def peak():
    """The largest a of the orbit, which both phases reach with opposite signs."""
    with mpmath.workprec(200):

        def missed(time):
            tenth = mpmath.mpf(1) / 10
            start, decay = -mpmath.tanh(time / 2), mpmath.exp(-time)
            return 1 + (start - 1) * time * decay - (1 + tenth) * decay - tenth

        return mpmath.tanh(mpmath.findroot(missed, 1.15) / 2)


HOT = Boundary("hot", A - THRESHOLD.symbol)
COOLED = {"source": "on", "boundaries": {"warm"}, "target": "on", "reset": {A: 0, B: 0}}
AROUND = "0.6", 0.3, 0.7  # where they are solved, and followed
SYSTEMS = {
    # the other boundary is reached together with the one that ends the phase
    "simultaneous": (relay(on=(HOT,), more=(Transition("on", {"hot"}, "off"),)), *AROUND),
    # the phase begins beyond a boundary
    "entry": (relay(off=(HOT,), more=(Transition("off", {"hot"}, "on"),)), *AROUND),
    # what follows is followed no more, as its condition does not hold
    "condition": (
        relay(
            when=(Condition(THRESHOLD.symbol - A, "off"),),
            more=(Transition(**COOLED),),
        ),
        *AROUND,
    ),
    # what stands before it begins to follow, as both of its conditions hold
    "condition, of another transition": (
        relay(
            before=(
                Transition(
                    **COOLED,
                    conditions=(Condition(A, "off"), Condition(A - THRESHOLD.symbol, "off")),
                ),
            ),
        ),
        *AROUND,
    ),
    # the phase begins on a boundary, and leaves it to the wrong side
    "tangent": (
        relay(
            off=(Boundary("again", B - WIDTH),),
            more=(Transition("off", {"again"}, "on"),),
            reset={A: THRESHOLD.symbol},
        ),
        "0.05",
        0.01,
        0.2,
    ),
}


@pytest.mark.slow
@pytest.mark.parametrize("kind", SYSTEMS)
def test_a_lone_border_is_one_event(kind, tmp_path):
    system, value, low, high = SYSTEMS[kind]
    orbit = two_phases(system, value)
    found = certified_over(orbit, "w", low, high)
    assert found.complete, found.statement
    (event,) = found.events
    assert (event.kind, event.also) == (kind.split(",")[0], ())
    assert {part.verdict for part in found.intervals} == {"stable", "not admissible"}
    (first, second) = found.intervals
    inside = second if kind != "tangent" else first
    assert inside.verdict == "stable"
    with mpmath.workprec(200):
        closed = mpmath.mpf(1) / 10 if kind == "tangent" else peak()
        assert event.enclosures["w"].ball.contains(exact_ball(closed))
    assert accepted(found, tmp_path).claims == {"branch": "proved"}


def certified(system):
    return certified_over(two_phases(system, "0.6"), "w", "0.45", "0.65")


def with_event(found, **changes):
    """The content of its file with another event."""

    def change(content):
        (tile,) = (tile for tile in content["tiles"] if tile["event"])
        tile["event"].update(changes)

    return edited(found, change)


@pytest.mark.slow
def test_a_condition_without_effect_is_no_event():
    """A transition whose other condition fails does not follow, whatever this one does."""
    idle = Condition(-A, "off"), Condition(A - THRESHOLD.symbol, "off")
    before = (Transition(**COOLED, conditions=idle),)
    found = certified(relay(before=before))
    assert found.complete
    assert found.events == ()
    # nor is it one in a file: the declaration of the one that has it, with this sign
    both = Condition(A, "off"), Condition(A - THRESHOLD.symbol, "off")
    event = certified(relay(before=(Transition(**COOLED, conditions=both),)))
    assert event.complete
    for boundary in ("1.1", "2.1", "1.3", "0.2", "1.2.1", "-1.2", ""):
        refused(with_event(event, boundary=boundary))
    refused(with_event(event, phase=2))
    refused(with_event(event, also=[["condition", 1, "1.1", "end"]]))

    def turned(content):
        first = content["declaration"]["transitions"][0]["conditions"][0]
        first[2] = not first[2]

    refused(edited(event, turned))


LENGTH = Parameter("p", "where a phase ends, nondimensional", lower=-sp.oo)


@cache
def shrinking():
    """A phase that lasts p, and would pass another boundary after 1/100."""
    full = Boundary("full", A - LENGTH.symbol), Boundary("hot", A - sp.Rational(1, 100))
    system = System(
        "saw",
        "a saw with a pause; nondimensional",
        (A, B),
        (LENGTH,),
        (
            Configuration("on", FirstOrder([[0, 0], [0, -1]], [1, 0]), full),
            Configuration(
                "off",
                FirstOrder([[0, 0], [0, -1]], [-1, 1]),
                (Boundary("cold", B - sp.Rational(1, 2)),),
            ),
        ),
        (
            Transition("on", {"full"}, "off"),
            Transition("off", {"cold"}, "on", reset={A: 0, B: 0}),
            Transition("on", {"hot"}, "off", reset={A: 7}),
        ),
    )
    itinerary = [("on", "full"), ("off", "cold")]
    orbit = ns.solve(system, {"p": "0.5"}, [0.5, 0.7], itinerary=itinerary)
    found = certified_over(orbit, "p", "-1/10", "9/10")
    assert found.complete
    assert [part.verdict for part in found.intervals] == [
        "not admissible", "stable", "not admissible",
    ]  # fmt: skip
    assert [event.kind for event in found.events] == ["vanishing-phase", "simultaneous"]
    return found


@pytest.mark.slow
def test_numbers_that_are_zero_are_proved_again(tmp_path):
    """The reset sets them to zero: no ball around them is that narrow in every proof."""
    assert accepted(shrinking(), tmp_path).claims == {"branch": "proved"}


def test_a_phase_that_may_end_before_passes_nothing():
    """One tile over all: where the phase lasts less than 1/100 the orbit is a motion."""

    def whole(content):
        first, last = content["tiles"][0], content["tiles"][-1]
        centre = [[0.0] * 6 for _ in content["unknown_names"]]
        centre[content["unknown_names"].index("tau1")][:2] = [0.4, 0.5]
        centre[content["unknown_names"].index("tau2")][0] = 0.6931471805599453
        tile = {**first, "upper": last["upper"], "centre": centre, "radii": [1e-8] * 4}
        content["tiles"], content["start"] = [tile], 0

    refused(edited(shrinking(), whole), "admissibility is undecided")


def test_a_branch_goes_on_where_its_phase_vanishes_and_nothing_turns():
    def cut(content):
        place = next(k for k, tile in enumerate(content["tiles"]) if tile["event"])
        content["tiles"] = content["tiles"][place:]
        content["start"] -= place
        content["ends"][0] = "a phase vanishes"

    refused(edited(shrinking(), cut), "it goes on")


@pytest.mark.slow
@pytest.mark.parametrize("place", ["before", "behind"])
def test_another_transition_that_does_the_same_is_no_other_motion(place):
    """Where it follows in place of the itinerary's the motion is still the orbit's."""
    plain = Transition("on", {"warm"}, "off")
    condition = Condition(THRESHOLD.symbol - A, "off")
    if place == "before":
        system = relay(before=(replace(plain, conditions=(condition,)),))
    else:
        system = relay(when=(condition,), more=(plain,))
    for value, claim in (("0.35", "undecided"), ("0.65", "proved")):
        claims = ns.certify(two_phases(system, value)).claims
        assert claims["admissibility"] in (claim, "undecided")
    motion = ns.simulate(system, {"w": "0.35"}, [0.0, 0.0], transitions=40)
    assert ns.itinerary_of(motion).itinerary == ON_AND_OFF
    found = certified_over(two_phases(system, "0.6"), "w", 0.3, 0.7)
    assert "not admissible" not in {part.verdict for part in found.intervals}


def alike(content):
    """Let the other transition of a declaration lead where the itinerary's leads."""
    first, other = content["declaration"]["transitions"][:2]
    other.update(reset=first["reset"], target=first["target"])


def test_no_file_tells_of_a_condition_behind_which_the_motion_is_the_same():
    system, value, *_ = SYSTEMS["condition"]
    orbit = two_phases(system, value)
    found = certified_over(orbit, "w", "0.5198", "0.6")  # one tile holds all that is below it
    believed(with_event(found))
    refused(with_event(found, window=["1/4", "1/2"]), "a window of no grazing")
    refused(edited(found, alike), r"admissibility|whether off follows")
    branch = ns.continue_orbit(orbit, "w", (0.5, 0.7))
    lone = ns.certify.event(branch, branch.events[0])
    believed(content_of(lone))
    misled = edited(lone, lambda content: alike(content["events"][0]))
    refused(misled, "another transition leads where")


def test_a_parameter_may_be_called_as_an_unknown_is():
    """What is stated has two names; in a file that has one its ball would hold both."""
    own = Parameter("a0", "a threshold, nondimensional", lower=-sp.oo)
    when = (Condition(own.symbol - A, "off"),)
    system = relay(when=when, more=(Transition(**COOLED),), threshold=own)
    orbit = two_phases(system, "0.6", "a0")
    found = certified_over(orbit, "a0", "0.5198", "0.6")
    (event,) = found.events
    reached = exact_ball(peak())
    assert event.enclosures["a0"].ball.contains(reached)
    assert (-event.enclosures["a"].ball).contains(reached)

    def renamed(content):
        content["declaration"]["start"][0] = content["unknown_names"][0] = "a0"
        (event,) = (tile["event"] for tile in content["tiles"] if tile["event"])
        del event["enclosures"]["a"]

    refused(edited(found, renamed), "a0 is not in its enclosure")

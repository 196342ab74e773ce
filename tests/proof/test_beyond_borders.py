"""What begins where a branch meets a border: proved, checked again, and seen by other means."""

import copy
from functools import cache
from itertools import product
from types import SimpleNamespace

import mpmath
import numpy as np
import pytest
from flint import arb, ctx

import nonsmooth as ns
from nonsmooth.derive import (
    Boundary,
    Configuration,
    FirstOrder,
    System,
    Transition,
)
from nonsmooth.runtime.checker import Failure
from nonsmooth.runtime.checker.orbits.motion import Border
from nonsmooth.runtime.checker.ranges.beyond import (
    _CheckedState,
    _demand_one_motion,
    _Met,
    _one_system,
    _side,
)
from nonsmooth.runtime.checker.ranges.branch import checked_tiles
from nonsmooth.runtime.checker.stated.declared import StatedTables
from nonsmooth.runtime.core.arithmetic import exact_ball
from nonsmooth.runtime.core.jets import Jet
from nonsmooth.runtime.core.values import as_value
from tests.certified import (
    PAD,
    accepted,
    certified_over,
    content_of,
    edited,
    prove_vanishing,
    refused,
)
from tests.proof.test_branch_borders import HOT, SYSTEMS, THRESHOLD, WIDTH, A, B, two_phases
from tests.shared import shared_file

GRAZING = 0.665294576295129867


@cache
def symmetric():
    """The paper's orbit: at its grazing a mass begins to stick for a moment."""
    orbit = ns.solve("dry-friction/symmetric", {"V": "0.668"})
    return certified_over(orbit, "V", "0.66", "0.67", beyond=True)


@cache
def relay():
    """Two boundaries are reached together: beyond it the other one ends the phase."""
    system, value, low, high = SYSTEMS["simultaneous"]
    return certified_over(two_phases(system, value), "w", low, high, beyond=True)


@cache
def pad():
    """A motion that reaches nothing, until it touches a soft stop."""
    orbit = ns.find_orbits(PAD, {"Omega": "0.79"}, 2, transitions=300).orbits[0].orbit
    return certified_over(orbit, "Omega", "0.79", "0.8", beyond=True)


def only(found):
    """What begins at its one border."""
    (beyond,) = (beyond for event in found.events for beyond in event.beyond)
    return beyond


def along(beyond, place):
    """The orbit at a place of the tile in which it begins, from -1 to 1."""
    (tile,) = beyond.branch.tiles
    names = [*beyond.branch.unknown_names, beyond.branch.parameter]
    numbers = [*np.polynomial.polynomial.polyval(place, np.transpose(tile.centre))]
    value = float(tile.lower + tile.upper) / 2 + place * float(tile.upper - tile.lower) / 2
    numbers.insert(names.index(tile.coordinate), value)
    return dict(zip(names, map(float, numbers), strict=True))


@pytest.mark.slow
def test_a_contact_that_grazes_begins_to_stick(tmp_path):
    found = symmetric()
    assert found.complete
    beyond = only(found)
    assert (beyond.side, beyond.own, beyond.verdict) == ("below", "above", "stable")
    assert beyond.scenario == "persistence"
    assert [c for c, _ in beyond.itinerary].count("stick-slip") == 1
    assert beyond.reach < GRAZING
    assert "stick-slip -> slip-slip begins, stable, below it" in found.statement
    told = beyond.branch.events[0].enclosures["V"]
    assert told.ball.overlaps(found.events[0].enclosures["V"].ball)
    assert accepted(found, tmp_path).claims == {"branch": "proved"}
    assert ns.load(tmp_path / "found.json").statement == found.statement


@pytest.mark.slow
def test_motions_beside_the_border_are_those_that_are_proved():
    """Simulated: a motion settles on the other itinerary below, the dwell time in its tube."""
    beyond = only(symmetric())
    system = ns.solve("dry-friction/symmetric").system
    given = {name: value for name, value in beyond.branch.parameters.items()}
    names = beyond.branch.unknown_names
    for place in (0.2, 0.9):
        about = along(beyond, place)
        assert beyond.reach < about["V"] < GRAZING
        x1, x2, v1, _ = (about[name] for name in names[:4])
        start = [x1 * (1 + 1e-7), x2, v1, about["V"]]  # the second mass sticks
        motion = ns.simulate(
            system, {**given, "V": as_value(about["V"])},
            start, beyond.itinerary[0][0], transitions=2000,
        )  # fmt: skip
        dwell = np.diff(motion.times)[-4:]
        wanted = sorted(about[name] for name in names[4:])
        assert np.allclose(sorted(dwell), wanted, atol=1e-9)


@pytest.mark.slow
def test_the_other_boundary_takes_over(tmp_path):
    beyond = only(relay())
    assert beyond.itinerary == (("off", "cold"), ("on", "hot"))
    assert (beyond.side, beyond.own, beyond.scenario) == ("below", "above", "persistence")
    accepted(relay(), tmp_path)
    # by an orbit at a point that is proved on its own
    system = SYSTEMS["simultaneous"][0]
    for value, verdict in (("0.5207", "proved"), ("0.521", "refuted")):
        orbit = ns.solve(system, {"w": value}, [1.15, 1.15], itinerary=beyond.itinerary)
        assert ns.certify(orbit).claims["admissibility"] == verdict


def corner(push):
    """The relay, but its input jumps by this where the threshold is passed, till it switches."""
    lags = [[-1, 0], [1, -1]]
    warm, cold = Boundary("warm", B - WIDTH), Boundary("cold", -B - WIDTH)
    return System(
        "corner",
        "two lags and a relay with a second stage; nondimensional",
        (A, B),
        (THRESHOLD,),
        (
            Configuration("on", FirstOrder(lags, [1, 0]), (warm, HOT)),
            Configuration("push", FirstOrder(lags, [1 + push, 0]), (warm,)),
            Configuration("off", FirstOrder(lags, [-1, 0]), (cold,)),
        ),
        (
            Transition("on", {"warm"}, "off"),
            Transition("on", {"hot"}, "push"),
            Transition("push", {"warm"}, "off"),
            Transition("off", {"cold"}, "on"),
        ),
    )


@pytest.mark.slow
@pytest.mark.parametrize(
    ("push", "side", "verdict", "scenario"),
    [
        (44, "below", "stable", "persistence"),
        (-200, "below", "unstable", "persistence"),
        # another orbit of the itinerary is near, and does not begin here
        (60, "above", "unstable", "nonsmooth fold"),
    ],
)
def test_itineraries_follow_each_other_or_end_together(push, side, verdict, scenario, tmp_path):
    system = corner(push)
    orbit = two_phases(system, "0.522")
    found = certified_over(orbit, "w", "0.518", "0.524", beyond=True)
    beyond = only(found)
    assert (beyond.side, beyond.own) == (side, "above")
    assert (beyond.verdict, beyond.scenario) == (verdict, scenario)
    accepted(found, tmp_path)
    # on that side it is an orbit that is proved on its own, of a short new phase
    at = float(found.events[0].enclosures["w"])
    value = as_value(at + (beyond.reach - at) / 2)
    other = ns.solve(system, {"w": value}, [1.155, 1.155, 1e-5], itinerary=beyond.itinerary)
    assert other.dwell_times[2] < 1e-3
    claims = ns.certify(other).claims
    told = "proved" if verdict == "stable" else "refuted"
    assert claims == {"existence": "proved", "admissibility": "proved", "stability": told}


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["entry", "condition", "tangent"])
def test_nothing_is_claimed_where_nothing_is_found(kind):
    system, value, low, high = SYSTEMS[kind]
    orbit = two_phases(system, value)
    found = certified_over(orbit, "w", low, high, beyond=True)
    assert found.complete
    assert [event.beyond for event in found.events] == [()]


@pytest.mark.slow
def test_a_contact_begins_where_a_soft_stop_is_touched(tmp_path):
    found = pad()
    beyond = only(found)
    assert (beyond.side, beyond.own, beyond.verdict) == ("above", "below", "stable")
    assert beyond.scenario == "persistence"
    accepted(found, tmp_path)
    # without the stop the amplitude is 2/5 / |1 - Omega^2 + i Omega / 5|: 1 at the event
    (event,) = found.events
    with mpmath.workprec(200):
        square = (
            mpmath.mpf(49) / 25 + mpmath.sqrt((mpmath.mpf(49) / 25) ** 2 - 4 * mpmath.mpf(21) / 25)
        ) / 2
        lower = mpmath.mpf(49) / 25 - square
        assert event.enclosures["Omega"].ball.contains(exact_ball(mpmath.sqrt(lower)))
    value = as_value((beyond.reach + float(event.enclosures["Omega"])) / 2)
    motion = ns.simulate(PAD, {"Omega": value}, {"x": 0, "v": 0}, until=800.0)
    names, tile = [*beyond.branch.unknown_names, "Omega"], beyond.branch.tiles[0]
    assert tile.coordinate == names[-2]
    contact = float(np.diff(motion.times)[-2:].min())
    place = (contact - float(tile.lower)) / float(tile.upper - tile.lower) * 2 - 1
    assert abs(along(beyond, place)["Omega"] - float(value)) < 1e-8


@pytest.mark.slow
def test_a_contact_that_vanishes_leaves_the_motion_without_it():
    path = shared_file("branch whose contact vanishes", prove_vanishing)
    beyond = only(ns.load(path))
    assert beyond.itinerary == (("free", "forcing-phase"),)
    assert (beyond.side, beyond.own, beyond.verdict) == ("below", "above", "stable")
    assert ns.certify.check(path).claims == {"branch": "proved"}


def forged(found, change):
    """A file whose claims about what is beyond were edited, with its checksum."""

    def both(content):
        event = next(t["event"] for t in content["tiles"] if (t["event"] or {}).get("beyond"))
        change(event, event["beyond"][0])

    return edited(found, both)


OTHER = {"above": "below", "below": "above"}


def judged(beyond, verdict):
    """Call the orbits beyond stable, or unstable."""
    (tile,) = beyond["branch"]["tiles"]
    for side in ("before", "after"):
        tile[side] = tile[side] if tile[side] == "not admissible" else verdict
    beyond["verdict"] = verdict


def swapped(beyond):
    (tile,) = beyond["branch"]["tiles"]
    tile["before"], tile["after"] = tile["after"], tile["before"]


def fewer(beyond, kind, instant=""):
    """Leave out a border that is met at the event, too."""
    event = beyond["branch"]["tiles"][0]["event"]
    event["also"] = [
        each for each in event["also"] if each[0] != kind or (instant and each[3] != instant)
    ]


FORGERIES = {
    "another side": (lambda _, beyond: beyond.update(side=OTHER[beyond["side"]]), "another side"),
    "its other side": (lambda _, beyond: beyond.update(own=OTHER[beyond["own"]]), "another side"),
    "another verdict": (lambda _, beyond: judged(beyond, "unstable"), "it is stable"),
    "verdicts swapped": (lambda _, beyond: swapped(beyond), "other verdicts"),
    "another parameter": (
        lambda _, beyond: beyond["branch"].update(parameter="W"), "another system's branch"
    ),
    "not divided": (
        lambda _, beyond: beyond["branch"]["tiles"][0].update(divided=None), "in tile 1"
    ),
    "a border less": (lambda _, beyond: fewer(beyond, "tangent"), "but for the event"),
    "twice": (lambda event, beyond: event["beyond"].append(copy.deepcopy(beyond)), "twice"),
}  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize("name", FORGERIES)
def test_edited_files_are_refused(name):
    change, reason = FORGERIES[name]
    refused(forged(symmetric(), change), reason)


def test_a_border_where_a_phase_began_is_not_met_where_it_ends():
    """The state at the end of a phase says nothing of its start."""
    with ctx.workprec(192):
        met = _Met(checked_tiles(content_of(relay()))[4])
        state = _CheckedState(met, 0)
        first = Border("entry", 0, "warm", "start")
        assert any(met.row(met.borders[0], state.before, state.behind))
        with pytest.raises(Failure, match="elsewhere"):
            met.row(first, state.before, state.behind)


def test_a_branch_is_not_beyond_itself():
    """A tile of the branch itself meets the border too, on its own side: no itinerary begins."""

    def itself(event, beyond):
        content = content_of(relay())
        branch = {name: content[name] for name in beyond["branch"]}
        tile = next(tile for tile in branch["tiles"] if tile["event"])
        del tile["event"]["beyond"]
        branch |= {"tiles": [tile], "start": 0, "ends": ["", ""], "claims": {"branch": "undecided"}}
        beyond.update(branch=branch, side=beyond["own"])

    refused(forged(relay(), itself), "two motions")


@pytest.mark.slow
def test_orbits_beside_the_event_are_not_its_motion():
    """The exact conditions hold for any such itinerary: the tube tells the orbits apart."""
    content = content_of(symmetric())
    beyond = next(t["event"] for t in content["tiles"] if t["event"])["beyond"][0]
    (other,) = checked_tiles(beyond["branch"])
    own = next(tile for tile in checked_tiles(content) if tile.event is not None)

    def same(longer=(), shorter=(), more=()):
        pair = _Met(other), _Met(own)
        for met, changed in zip(pair, (longer, shorter), strict=True):
            vars(met).update(changed)
        pair[0].borders += more
        try:
            _demand_one_motion(*pair)
        except Failure:
            return False
        return True

    with ctx.workprec(192):
        assert same()
        assert not same({"point": [x + 1e-3 for x in _Met(other).point]})
        later = [time + 1 for time in _Met(own).window or ()]
        assert not same(shorter={"window": later})
        # a border that is met elsewhere
        assert not same(more=[Border("tangent", 2, "second-reaches-belt", "end")])


STATED = {
    "parameters": [],
    "states": ["c", "s"],
    "forcing": [[0, 1]],
    "configurations": {
        name: {
            "field": [["0", "-1", "0"], ["1", "0", "0"]],
            "boundaries": {"low": ["1", "0", "1"], "high": ["1", "0", "-1"]},
            "held": [["0", "1", "0"]],
        }
        for name in ("on", "off")
    },
    "transitions": [
        {
            "source": "on", "boundaries": ["high"], "target": target, "order": order,
            "conditions": [[["0", "1", "0"], "on", True]],
            "reset": [["1", "0", "0"], ["0", "1", "0"]],
        }
        for order, target in ((1, "on"), (2, "off"))
    ],
}  # fmt: skip
ON, SECOND = ("configurations", "on"), ("transitions", 1)


def test_both_declarations_of_a_file_are_compared():
    """Also of a configuration in which neither orbit ever is."""

    def idle(content):
        event = next(tile["event"] for tile in content["tiles"] if tile["event"])
        for speed, own in zip("01", (content, event["beyond"][0]["branch"]), strict=True):
            field = [[speed, "0", "0"], ["0"] * 3]
            told = {"field": field, "boundaries": {}, "held": []}
            own["declaration"]["configurations"]["idle"] = told

    refused(edited(relay(), idle), "another field")


@pytest.mark.parametrize(
    ("path", "other"),
    [
        (("states",), ["s", "c"]),
        (("forcing",), [[1, 0]]),
        (("forcing",), []),
        ((*ON, "field", 1, 0), "2"),
        ((*ON, "boundaries", "high", 2), "-2"),
        ((*ON, "boundaries", "more"), ["1", "0", "-3"]),
        ((*ON, "held", 0, 0), "1"),
        ((*ON, "held"), []),
        ((*SECOND, "target"), "on"),
        ((*SECOND, "order"), 0),
        ((*SECOND, "reset", 1, 1), "-1"),
        ((*SECOND, "conditions", 0, 0, 2), "1"),
        ((*SECOND, "conditions", 0, 1), "off"),
        ((*SECOND, "conditions", 0, 2), False),
        ((*SECOND, "conditions"), []),
        (("transitions",), STATED["transitions"][:1]),
        (("constants",), ["1.7"]),
        (None, None),
    ],
)
def test_what_both_declare_is_the_same(path, other):
    """Also what neither branch passes; what one of them alone declares may be anything."""
    changed = copy.deepcopy({**STATED, "constants": ["1.4"]})
    if path is not None:
        *upper, last = path
        place = changed
        for step in upper:
            place = place[step]
        place[last] = other
    else:
        changed["configurations"]["more"] = copy.deepcopy(STATED["configurations"]["on"])

    def tile(stated):
        declared = StatedTables(stated, {})
        return SimpleNamespace(
            curve=SimpleNamespace(declared=declared, constants=stated["constants"])
        )

    pair = tile({**STATED, "constants": ["1.4"]}), tile(changed)
    for one, two in (pair, pair[::-1]):
        if path is None:
            _one_system(one, two)
            continue
        with pytest.raises(Failure, match="other"):
            _one_system(one, two)


@pytest.mark.parametrize("along", ["the parameter", "an unknown", "an unknown that turns it"])
@pytest.mark.parametrize(
    ("forwards", "moving", "grows"), [*product((True, False), (1, -1), (1, -1))]
)
def test_orbits_are_where_the_parameter_is_along_them(along, forwards, moving, grows):
    """Motions are at s > 0 or s < 0, and the parameter is s, or +-s, or +-s^2."""
    last, turns = along == "the parameter", along.endswith("it")
    here = moving if last else grows if turns else moving * grows
    parts = tuple(map(arb, (0, 0, grows) if turns else (0, grows, -grows)))
    verdicts = (
        ("not admissible", "stable") if (moving > 0) == forwards else ("stable", "not admissible")
    )
    tile = SimpleNamespace(
        tile=dict(zip(("before", "after"), verdicts, strict=True)),
        forwards=forwards, turns=turns, place=int(last),
        curve=SimpleNamespace(last=1, jets=lambda place, point, order: [Jet(None, parts)]),
        rises=lambda rate, otherwise: rate(()) > 0,
    )  # fmt: skip
    assert _side(tile) == ("above" if here > 0 else "below")

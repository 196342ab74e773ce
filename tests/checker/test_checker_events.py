"""The check of events: true ones pass, and no change that makes one false does."""

import copy
import json
import random
from fractions import Fraction
from functools import cache
from pathlib import Path

import mpmath
import numpy as np
import pytest
import sympy as sp
from flint import arb

import nonsmooth as ns
from nonsmooth.derive import (
    Boundary,
    Condition,
    Parameter,
    SecondOrder,
    Transition,
)
from nonsmooth.runtime.checker import Failure
from nonsmooth.runtime.checker.orbits.events import JudgedEvent
from nonsmooth.runtime.model.kernels import load_system
from nonsmooth.runtime.present.files.kept import save_result
from tests.certified import (
    LOOP,
    believed,
    between_springs,
    loop,
    moved,
    of_files,
    placing,
    refused,
    saved,
    signed,
)
from tests.checker.test_checker import other_systems
from tests.explore import test_continuation_forced as impacts


@cache
def gated():
    """The kicked mass, v -> r v + 1, with limits of its velocity that are reached at 2.

    It begins with v0 = 1/(1 - r) and comes back to x = 0 with -v0.
    """
    v = sp.Symbol("v", real=True)
    rest = Parameter("r", "what is left of the velocity")
    limits = [Parameter(name, name, lower=-sp.oo) for name in ("fast", "slow", "gate")]
    fast, slow, gate = (limit.symbol for limit in limits)
    kick = {v: rest.symbol * v + 1}
    springs = SecondOrder([[1]], [[1]]), SecondOrder([[1]], [[4]])
    watched = Boundary("fast", v - fast), Boundary("slow", -v - slow)
    more = (
        Transition("right", {"fast"}, "right", (), {v: fast - 1}),
        Transition("right", {"slow"}, "right", (), {v: 1 - slow}),
        Transition("left", {"rises"}, "right", (Condition(v - gate, "left"),), kick),
        Transition("left", {"rises"}, "right", (), {v: v + 1}),
    )
    return load_system(between_springs("gated", springs, more, (rest, *limits), watched))


def limited(parameter, lower, upper):
    given = {"r": "1/2", "fast": "3", "slow": "3", "gate": "1", parameter: str((lower + upper) / 2)}
    orbit = ns.solve(gated(), given, [*[np.pi, np.pi / 2], *[0.0, 2.0]], itinerary=LOOP)
    return ns.continue_orbit(orbit, parameter, (lower, upper))


@cache
def followed(name, parameter, lower, upper):
    return ns.continue_orbit(ns.solve(name), parameter, (lower, upper))


SYMMETRIC, STICK = "dry-friction/symmetric", "dry-friction/global-stick"
BRANCHES = {
    "symmetric": lambda: followed(SYMMETRIC, "V", 0.6, 1.3),
    "stick": lambda: followed(STICK, "V", 0.5, 1.6),
    "impacts": impacts.branch,
    "torus": lambda: ns.continue_orbit(impacts.orbit(-0.5), "c", (-0.4, 0.4), step=0.02),
    "rigid": lambda: followed("rigid-stop/one-impact", "T", 5.5, 7.5),
    "wall": lambda: ns.continue_orbit(loop(k="sqrt(2)", a="2"), "a", (1.2, 2.2)),
    "entry": lambda: limited("fast", 1.4, 3.1),
    "meeting": lambda: limited("slow", 1.4, 3.1),
    "condition": lambda: limited("gate", 0.9, 3.2),
}
KINDS = {
    "symmetric": ["grazing", "flip"],
    "stick": ["vanishing-phase"],
    "impacts": ["flip", "tangent", "grazing", "fold", "flip"],
    "torus": ["neimark-sacker"],
    "rigid": ["branch-point", "tangent"],
    "wall": ["grazing"],
    "entry": ["entry"],
    "meeting": ["simultaneous"],
    "condition": ["condition"],
}


@cache
def proved(name):
    branch = BRANCHES[name]()
    return tuple(ns.certify.event(branch, event) for event in branch.events)


@cache
def written(name, folder):
    path = folder / f"{name}.json"
    save_result(proved(name), path)
    return path.read_text()


@pytest.fixture
def content(request, tmp_path_factory):
    """The file of a branch's events."""
    folder = Path(tmp_path_factory.getbasetemp())
    return json.loads(written(request.param, folder))


def event_of(content, kind):
    """The last of a kind, alone in its file."""
    content["events"] = [event for event in content["events"] if event["kind"] == kind][-1:]
    return content["events"][0]


@of_files(*BRANCHES)
def test_true_events_pass(content):
    believed(content)
    assert [event["kind"] for event in content["events"]] == KINDS[content_name(content)]
    undecided = {event["kind"] for event in content["events"] if event["claim"] != "proved"}
    assert undecided <= {"branch-point"}


def content_name(content):
    return next(name for name in BRANCHES if proved(name)[0].text == content["events"][0]["text"])


@pytest.mark.parametrize("name", ["entry", "meeting", "condition"])
def test_limits_of_the_gated_mass_are_where_they_are_reached(name):
    (event,) = proved(name)
    assert event.value.contains(2)
    assert event.value.ball.rad() < 1e-30


@of_files(*BRANCHES)
def test_centres_outside_their_enclosures_are_refused(content):
    for place, event in enumerate(content["events"]):
        for name in event["enclosures"]:
            for by in (Fraction(-3, 2), Fraction(3, 2)):
                changed = copy.deepcopy(content)
                moved(changed["events"][place]["enclosures"][name], by)
                changed["events"] = changed["events"][place:][:1]
                refused(changed, f"event 1, {event['kind']}: {name} is not in its enclosure")


@of_files(*BRANCHES)
def test_boxes_without_the_event_are_refused(content):
    for place, event in enumerate(content["events"]):
        for side in range(len(event["box"])):
            changed = copy.deepcopy(content)
            changed["events"] = changed["events"][place:][:1]
            moved(changed["events"][0]["box"][side], Fraction(3))
            refused(changed)
    event = event_of(content, KINDS[content_name(content)][-1])
    for change in (
        lambda box: box.pop(),
        lambda box: box.append(box[0]),
        placing(0, "rad", "0"),
        lambda box: [side.__setitem__("rad", "1") for side in box],
        lambda box: box.insert(0, box.pop(-2)),
    ):
        box = copy.deepcopy(event["box"])
        change(box)
        refused({**content, "events": [{**event, "box": box}]})


@pytest.mark.parametrize("seed", range(12))
def test_no_false_enclosure_passes(seed, tmp_path):
    """The limits of the gated mass are reached at 2, and it begins with 2."""
    drawn = random.Random(seed)
    content = json.loads(written(drawn.choice(["entry", "meeting", "condition"]), tmp_path))
    (event,) = content["events"]
    name = drawn.choice([event["parameter"], "v0"])
    radius = Fraction(10) ** -drawn.randint(1, 30)
    off = radius * Fraction(drawn.choice([-1, 1]) * drawn.choice([0.5, 0.99, 1.01, 3]))
    event["enclosures"][name] = {
        "mid": f"{round((2 + off) * 10**50)}e-50", "rad": f"{round(radius * 10**50)}e-50",
    }  # fmt: skip
    if abs(off) > radius:
        refused(content, f"{name} is not in its enclosure")
    else:
        believed(signed(content))


def test_a_thousand_digits(tmp_path):
    branch = BRANCHES["wall"]()
    path = tmp_path / "events.json"
    found = ns.certify.event(branch, branch.events[-1], 3400)
    found.save(path)
    # the mass reaches v0/sqrt(k) = 2/2^(1/4)
    with mpmath.workdps(1100):
        assert found.value.contains(2 / mpmath.mpf(2) ** mpmath.mpf("0.25"))
    assert len(found.value.mid) > 1000
    assert ns.certify.check(path).difference is None


OTHERS = ("flip", "fold", "neimark-sacker", "vanishing-phase", "condition",
          "entry", "tangent", "simultaneous", "grazing", "branch-point", "flop")  # fmt: skip


@of_files(*BRANCHES)
def test_events_of_another_kind_are_refused(content):
    for kind in {event["kind"] for event in content["events"]} - {"branch-point"}:
        event = event_of(copy.deepcopy(content), kind)
        for other in OTHERS:
            for instant in ("start", "end"):
                # with a phase to be in, or without
                for phase in ({}, {"phase": None, "configuration": "", "boundary": ""}):
                    told = {**event, "kind": other, "instant": instant, **phase}
                    if other == kind and (other == "grazing" or told["phase"] == event["phase"]):
                        continue
                    if (kind, other, instant) == ("tangent", "condition", "end") and not phase:
                        continue  # without speed the condition of an impact just holds
                    refused({**content, "events": [told]})


@of_files("symmetric", "stick", "impacts", "entry", "meeting", "condition")
def test_other_places_are_refused(content):
    for event in content["events"]:
        if event["phase"] is None:
            continue
        count = len(event["itinerary"])
        for phase in (event["phase"] % count + 1, event["phase"] - count, count + 1, 0, True):
            if phase != event["phase"] or phase is True:
                refused({**content, "events": [{**event, "phase": phase}]})
        configuration = event["declaration"]["configurations"][event["configuration"]]
        for boundary in {*configuration["boundaries"], "nowhere"} - {event["boundary"]}:
            refused({**content, "events": [{**event, "boundary": boundary}]})
        refused({**content, "events": [{**event, "parameter": event["box"][0]["name"]}]})


@of_files("symmetric", "torus", "impacts", "entry")
def test_another_system_has_another_event(content):
    event = event_of(content, KINDS[content_name(content)][-1])
    for _ in other_systems(event["declaration"], "11/10", 8, fixed=True):
        refused(content)


@of_files("wall")
def test_other_constants_are_refused(content):
    event = event_of(content, "grazing")
    assert event["parameters"]["k"] == "sqrt(2)"
    for text in ("sqrt(3)", "-sqrt(2)", "1.4142", "open('x')", "", "sqrt(2)/0", "2**9**9**9"):
        parameters = {**event["parameters"], "k": text}
        refused({**content, "events": [{**event, "parameters": parameters}]})
    refused({**content, "events": [{**event, "parameters": {}}]}, "parameters that are named")


@of_files("rigid", "impacts")
def test_a_file_without_events_claims_nothing(content):
    content["events"] = []
    refused(content, "no event")


@of_files("rigid", "impacts")
def test_undecided_events_claim_nothing(content):
    event = content["events"][0]
    event |= {"claim": "undecided", "reason": "none", "enclosures": {}, "kind": "flop"}
    event |= {"box": [], "declaration": {}, "closing": {}}
    believed(signed(content))
    entry = {"mid": "1", "rad": "1"}
    refused({**content, "events": [{**event, "enclosures": {"T": entry}}]}, "no event")
    refused({**content, "events": [{**event, "claim": "proved"}]})
    refused({**content, "events": [{**event, "claim": "refuted"}]}, "claim")


@of_files("wall")
def test_a_parameter_is_not_hidden_behind_an_unknown_of_its_name(content):
    """The one enclosure has to hold both of them."""
    event = event_of(content, "grazing")
    name, other = event["parameter"], event["declaration"]["phases"][0]["dwell_time"]
    told = json.loads(json.dumps(event).replace(f'"{name}"', f'"{other}"'))
    told["text"] = event["text"]
    for value in (event["enclosures"][name], event["enclosures"][other]):
        told["enclosures"][other] = value
        refused({**content, "events": [told]}, f"{other} is not in its enclosure")


@of_files("symmetric", "stick", "rigid", "wall")
def test_events_are_compared_with_their_system(content, tmp_path):
    path = saved(content, tmp_path / "events.json")
    found = ns.certify.check(path)
    assert found.difference is None
    held = content["events"][0]["tables"] is not None
    assert ("no declaration was run" in str(found.note)) is held
    for event in content["events"]:
        name = next(n for n in event["parameters"] if n != event["parameter"])
        event["parameters"][name] += "+1/1000"  # it is the parameter of the declaration
    assert ns.certify.check(saved(content, path)).difference is not None
    for event in content["events"]:
        event |= {"system": "nowhere.py", "tables": None}
    told = str(ns.certify.check(saved(content, path)).difference)
    assert told.startswith("unknown system 'nowhere.py'")


@of_files("symmetric", "torus")
def test_no_event_is_believed_where_a_divisor_may_be_zero(content):
    event = content["events"][-1]
    judge = JudgedEvent(event)
    judge.declared.exactly.divisors.append(lambda point: point[0] - arb(event["box"][-1]["mid"]))
    with pytest.raises(Failure, match="zero there cannot be told"):
        judge.located(event["box"])

"""The check of a census: its tree of boxes, each orbit's certificate, and that it is that orbit."""

import copy
import json
from functools import cache
from types import SimpleNamespace

import pytest
import sympy as sp
from flint import arb, arb_mat

import nonsmooth as ns
from nonsmooth.derive import (
    Boundary,
    Condition,
    Configuration,
    FirstOrder,
    SecondOrder,
    System,
    Transition,
)
from nonsmooth.runtime.checker import Failure
from nonsmooth.runtime.checker.counting.census import Counting
from nonsmooth.runtime.checker.counting.covering import Walk
from tests.certified import (
    LOOP,
    PAD,
    accepted,
    between_springs,
    claimed,
    content_of,
    kicked,
    refused,
    refused_file,
    saved,
    stating,
    struck,
    struck_together,
    unhashed,
)


@cache
def _census():
    values, box = {"k": 9, "r": "1/3", "a": 10}, {"tau1": "2.5", "tau2": "2"}
    return ns.certify.all(kicked(), values, box, itinerary=LOOP)


@pytest.fixture
def content():
    """Of a file with two orbits: half a turn, and a whole one, on the right."""
    found = content_of(_census())
    assert found["count"] == 2
    return found


def checked(content, folder):
    """What the check says of changed content whose checksums are right."""
    return ns.certify.check(saved(content, folder / "changed.json"))


def test_a_census_is_proved_again_by_its_tree(content, tmp_path):
    found = checked(content, tmp_path)
    assert found.difference is None
    assert found.claims == {"orbits": "proved"}
    assert "exactly 2 orbits" in found.certificate.statement
    # what nothing proves is not told either: why claims are undecided
    told = json.loads(unhashed([orbit.certificate.to_json() for orbit in found.certificate.orbits]))
    known = json.loads(unhashed([orbit.certificate.to_json() for orbit in _census().orbits]))
    refuted = known[1]["reasons"]["admissibility"]
    assert "is reached from outside" in refuted
    assert "is reached from outside" not in json.dumps(told)
    for certificate in (*told, *known):
        del certificate["reasons"]
    assert told == known


def _stated(content):
    """A changed file whose counts and statement follow from its entries again."""
    found = [orbit["certificate"] for orbit in content["orbits"] if orbit["certificate"]]
    proved = [each["claims"]["admissibility"] for each in found].count("proved")
    content |= {
        "count": len(content["orbits"]),
        "admissible": proved,
        "decided": not content["undecided"],
        "looked": sum(len(tree) - tree.count("?") for tree in content["trees"]),
    }
    content["statement"] = claimed(type(_census()), content).statement
    return content


@pytest.mark.slow
def test_no_leaf_of_the_tree_can_be_changed(content, tmp_path):
    """Each letter is needed: the census without it, or with another one, is refused."""
    (tree,) = content["trees"]
    assert {*"ab-*"} <= {*tree}
    places = {letter: [k for k, x in enumerate(tree) if x == letter] for letter in {*tree}}
    some = sorted({k for own in places.values() for k in (own[0], own[-1])})
    for k in some:
        others = ["", *({*"-*?"} - {tree[k]})]
        for other in others:
            changed = tree[:k] + other + tree[k + 1 :]
            found = checked(_stated({**content, "trees": [changed]}), tmp_path)
            assert found.difference is not None, (k, tree[k], other)


@pytest.mark.parametrize(
    ("change", "told"),
    [
        (lambda c: c["trees"].append("-"), "too many trees"),
        (stating(trees=[]), "too many trees, or too few"),
        (lambda c: c.update(trees=[c["trees"][0] + "-"]), "beside the box"),
        (stating(trees=["?"]), "an orbit that is listed is not found"),
        (stating(trees=["?"], orbits=[]), "other boxes are undecided"),
        (lambda c: c.update(box=["1e-6 <= tau1 <= 3", c["box"][1]]), ""),
        (lambda c: c.update(box=["1e-6 <= tau1 <= 2", c["box"][1]]), ""),
        (lambda c: c.update(box=["0 < tau1 <= 2.5", c["box"][1]]), ""),
        (lambda c: c.update(box=c["box"][:1]), "one side for each dwell time"),
        *((lambda c, side=side: c.update(box=[side, c["box"][1]]), "is no bound")
          for side in ("0 <= tau1 <= 2.5", "0 <= tau1", "0.5 < tau1", "-1 <= tau1 <= 2")),
        (lambda c: c.update(box=["1 <= tau1 <= 1", c["box"][1]]), "not in order"),
        (stating(largest="1000"), "other orbits are asked for"),
        (stating(conditions=[]), "other orbits are asked for"),
        (lambda c: c["orbits"].pop(), "an orbit of the box is not listed"),
        (lambda c: c["orbits"].pop(0), "an orbit of the box is not listed"),
        (lambda c: c["orbits"].reverse(), "an orbit of the box is not listed"),
        (lambda c: c["undecided"].append({"bounds": {"tau1": ["0", "1"]}, "reason": "many"}),
         "other boxes are undecided"),
        (lambda c: c["orbits"].append({"unique": {}, "certificate": None, "reason": "no"}),
         "an orbit that is listed is not found"),
        (stating("orbits", 0, unique={"tau1": ["0", "1"], "tau2": ["0", "9"]}),
         "not listed"),
        (stating("parameters", r="1/4"), ""),
        (lambda c: c["declaration"]["phases"].reverse(), "itinerary is not that"),
    ],
)  # fmt: skip
def test_what_the_tree_does_not_prove_is_refused(content, tmp_path, change, told):
    change(content)
    refused_file(_stated(content), tmp_path, told)


def test_an_orbit_without_a_certificate_is_proved_by_the_tree(content, tmp_path):
    content["orbits"][1].update(certificate=None, reason="none was asked for")
    found = checked(_stated(content), tmp_path)
    assert found.difference is None
    assert "exactly 2 orbits" in found.certificate.statement
    assert "1 undecided" in found.certificate.statement


def test_orbits_that_their_system_does_not_name_are_refused(content, tmp_path):
    assert checked(content, tmp_path).compared
    for part in (content, *(orbit["certificate"] for orbit in content["orbits"])):
        part["orbit"] = "elsewhere.py:loop"
    assert "is no orbit of" in str(checked(_stated(content), tmp_path).difference)


@pytest.mark.parametrize(
    ("change", "told"),
    [
        (stating("orbits", 1, "certificate", "enclosures", "trace", mid="0.5"),
         "orbit 2: trace is not in its enclosure"),
        (lambda c: c["orbits"][0].update(certificate=c["orbits"][1]["certificate"], reason=""),
         "not where it was counted"),
        (stating("orbits", 0, "certificate", system="other"), "something else"),
        (lambda c: c["orbits"].pop(), "is not listed"),
        (stating("orbits", 0, "certificate", declaration={}), "declaration"),
        (stating(statement="exactly 7 orbits"), "not what the other entries give"),
        (stating("orbits", 0, "certificate", "parameters", k="8"), "parameters: it"),
    ],
)  # fmt: skip
def test_what_is_false_is_refused(content, tmp_path, change, told):
    change(content)
    refused_file(content, tmp_path, told)


def waiting():
    """A swing that waits for the phase of its forcing before it is struck anew."""
    x, v, c, s = sp.symbols("x v c s", real=True)
    half = sp.Rational(1, 2)
    turning = [[0, 0, 0, -half], [0, 0, half, 0]]
    swinging = [[0, 1, 0, 0], [-(half**2), 0, 0, 0]]
    return System(
        "waits",
        "a swing that waits for its forcing",
        (x, v, c, s),
        (),
        (
            Configuration("fly", FirstOrder([*swinging, *turning]), (Boundary("back", -x),)),
            Configuration("wait", FirstOrder([[0] * 4] * 2 + turning), (Boundary("go", s - half),)),
        ),
        (
            Transition("fly", {"back"}, "wait", (), {x: sp.Integer(0), v: sp.Integer(0)}),
            Transition("wait", {"go"}, "fly", (), {x: sp.Integer(0), v: sp.Integer(1)}),
        ),
        forcing=((c, s),),
    )  # fmt: skip


def test_a_certificate_of_another_number_of_turns_is_refused(tmp_path):
    """An orbit that waits for one turn has the start of one that waits for two."""
    phases = [("fly", "back"), ("wait", "go")]
    census = ns.certify.all(waiting(), {}, {"tau1": (1, 9), "tau2": (1, 25)}, itinerary=phases)
    accepted(census, tmp_path)
    assert (census.count, census.admissible) == (4, 1)
    content = content_of(census)
    (admissible,) = (
        o for o in content["orbits"] if o["certificate"]["claims"]["admissibility"] == "proved"
    )
    for place, orbit in enumerate(content["orbits"]):
        if orbit is not admissible:
            changed = copy.deepcopy(content)
            changed["orbits"][place]["certificate"] = copy.deepcopy(admissible["certificate"])
            assert checked(_stated(changed), tmp_path).difference is not None


@pytest.mark.slow
def test_an_itinerary_repeats_itself_by_its_transitions():
    """Kicked in two ways by turns, an orbit has not the half of the phases that it names twice."""
    v = sp.Symbol("v", real=True)
    kicks = [
        Transition("left", {"rises"}, "right", (Condition(v - 3, "left"),), {v: v / 2 + 1}),
        Transition("left", {"rises"}, "right", (), {v: v / 2 + sp.Rational(101, 100)}),
    ]
    springs = SecondOrder([[1]], [[1]]), SecondOrder([[1]], [[4]])
    system = between_springs("kicked-by-turns", springs, kicks)
    sides = [("2", "4"), ("1", "2")] * 2
    box = {f"tau{k}": side for k, side in enumerate(sides, 1)}
    content = content_of(ns.certify.all(system, {}, box, itinerary=LOOP * 2))
    for phase, transition in zip(content["declaration"]["phases"], (0, 1, 0, 2), strict=True):
        phase["transition"] = transition
    refused(content)


@pytest.mark.parametrize(
    ("change", "told"),
    [
        ({"largest": "1/100"}, "a coordinate is too large"),
        ({"box": ["1e-3 <= tau1 <= 1e-2", "0 < tau2 <= 2"]}, "tau1 is not in the box"),
    ],
)
def test_a_certificate_is_of_an_orbit_that_is_asked_for(content, change, told):
    judges = [Counting(each).within(each["box"]) for each in (content, content | change)]
    walk, letters = Walk(*judges[0].equations), iter(*content["trees"])
    walk.follow(lambda _: next(letters))
    for orbit, found in zip(content["orbits"], judges[0].judged([walk]).inside, strict=True):
        judges[0].check_orbit(orbit["certificate"], *found)
        with pytest.raises(Failure, match=told):
            judges[1].check_orbit(orbit["certificate"], *found)


@pytest.mark.parametrize(("size", "edges"), [(1, 0), (3, 1)])
def test_what_begins_with_another_size_later_may_be_another_orbit(content, size, edges):
    """Though it has the same dwell times: only one is in a box that is not too large."""
    judge, box = Counting(content).within(content["box"]), ((1.0, 1.125),)
    judge.largest, judge.setting = arb(2), SimpleNamespace(rotation=0, places=[0])
    judge.counting = SimpleNamespace(part=1, declared=SimpleNamespace(steps="ab"))
    root = SimpleNamespace(sides=box, unique=((0.5, 1.5),), coordinates=[arb(0)])
    equations = SimpleNamespace(
        first=False,
        dwell=lambda *_: {"tau1": arb(1), "tau2": arb(1)},
        starts=lambda *_: [arb_mat([[0]]), arb_mat([[size]])],
        begun_later=lambda *_: [box],
    )
    found = judge.judged([SimpleNamespace(roots=[root], equations=equations, undecided=[])])
    assert (len(found.inside), len(found.edges)) == (0, edges)


@pytest.mark.slow
def test_what_meets_no_boundary_or_two_at_once_is_not_counted():
    """Their equations hold elsewhere too: half a turn later, or where one of two is not reached."""
    with pytest.raises(ns.InputError, match="several boundaries end a phase"):
        ns.certify.all(struck(), {"c": 0}, {"tau1": (7, 8)},
                       itinerary=struck_together().itinerary[:1])  # fmt: skip
    with pytest.raises(ns.InputError, match="a phase ends with the forcing's period"):
        ns.certify.all(PAD, {"Omega": 3}, {"tau1": 3}, itinerary=[("free", "forcing-phase")])

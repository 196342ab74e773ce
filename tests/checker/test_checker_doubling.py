"""The check of a doubling: it proves what is so, and refuses a file that was edited."""

import copy
import json

import pytest
from flint import arb

import nonsmooth as ns
from nonsmooth.runtime.checker import Failure
from nonsmooth.runtime.checker.ranges.branch import curve_of
from nonsmooth.runtime.checker.ranges.branch_tile import CheckedTile
from nonsmooth.runtime.checker.ranges.doubling import (
    JudgedDoubling,
    check_doubled,
)
from tests.certified import believed, prove_doubling, refused, signed, stating
from tests.shared import shared_file

pytestmark = pytest.mark.compiled  # much slower without it
DOUBLING = "nonsmooth.runtime.checker.ranges.doubling"


@pytest.fixture(scope="module")
def content():
    path = shared_file("nonsmooth certified doubling", prove_doubling)
    assert ns.certify.check(path).claims == {"doubling": "proved"}
    return json.loads(path.read_text())


KRAWCZYK = "Krawczyk's test fails"
EDITS = [
    (lambda c, d: d.update(side="below"), "they are not below the flip"),
    (lambda c, d: d.update(verdict="stable"), "at one of them it is unstable"),
    (lambda c, d: d.update(reason="none"), "a reason of another verdict"),
    (lambda c, d: d.update(verdict="undecided"), "the claim is another one"),
    (lambda c, d: d.update(verdict="undecided", reason="so"), "the claim is another one"),
    (lambda c, d: d.update(amplitude="2"), KRAWCZYK),
    # the doubled branch is right, but it does not begin in the tube
    (lambda c, d: d.update(amplitude="1/1000"), KRAWCZYK),
    (lambda c, d: d.update(amplitude="-1/10"), "not positive"),
    (lambda c, d: d["centre"][-1].__setitem__(0, d["centre"][-1][0] + 1e-3), KRAWCZYK),
    # a tube whose parameter would not move: the same polynomials without their bend
    (lambda c, d: d["centre"].append([x * (not k) for k, x in enumerate(d["centre"].pop())]), None),
    (lambda c, d: d.update(radii=[1e-40] * len(d["radii"])), KRAWCZYK),
    (lambda c, d: d.update(radii=[1.0] * len(d["radii"])), KRAWCZYK),
    (lambda c, d: d["rate"].update(mid="1.4e-1"), "not in its enclosure"),
    (lambda c, d: d.update(tile=1 + [t["event"] for t in c["branch"]["tiles"]].index(None)),
     "there is no flip"),
    (lambda c, d: d.update(scaled="tau1"), KRAWCZYK),
    (lambda c, d: c.update(end="the time is over"), "though it is whole"),
    (lambda c, d: c.update(doubled=None, claims={"doubling": "undecided"}),
     "complete without doubled orbits"),
    (lambda c, d: c.update(doubled=None, ended="unfinished"), "the claim is another one"),
    (lambda c, d: d.update(branch={**copy.deepcopy(c["branch"]), "start": 0}), "not passed twice"),
    (lambda c, d: d["branch"]["parameters"].update(eta="4.001"), "the doubled branch"),
    (lambda c, d: d["branch"]["declaration"]["configurations"]["slip-slip"]["field"][2].__setitem__(
        0, "-1.0001"), "the doubled branch"),
]  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize(("edit", "told"), EDITS)
def test_what_is_false_is_refused(content, edit, told):
    edited = copy.deepcopy(content)
    edit(edited, edited["doubled"])
    refused(edited, told)


@pytest.fixture(scope="module")
def proved(content):
    """Both branches with their tiles, as if these were proved."""
    branches = [content["branch"], content["doubled"]["branch"]]
    tiles = [[CheckedTile(curve_of(each), tile) for tile in each["tiles"]] for each in branches]
    check_doubled(content["doubled"], branches, tiles)
    return branches, tiles


def other_stiffness(branch):
    branch["declaration"]["configurations"]["slip-slip"]["field"][2][0] = "-1.0001"


@pytest.mark.parametrize(
    ("change", "told"),
    [
        (stating(parameter="eta"), "another system's branch"),
        (stating(parameters={}), "another system's branch"),
        (stating(stability="neutral"), "another system's branch"),
        (stating(closing={"kind": "forcing", "turns": 1}), "closes in another way"),
        (other_stiffness, "the declarations differ"),
    ],
)
def test_a_branch_of_something_else_is_not_the_doubled_one(content, proved, change, told):
    (branch, beyond), tiles = copy.deepcopy(proved[0]), proved[1]
    change(beyond)
    with pytest.raises(Failure, match=told):
        check_doubled(content["doubled"], [branch, beyond], tiles)


def judged(content, proved):
    (branch, _), (own, _) = proved
    return JudgedDoubling(content["doubled"], branch, own[content["doubled"]["tile"] - 1])


def test_the_doubled_branch_begins_in_the_tube(content, proved):
    """Not in one of half the amplitude, nor in one that is beside it."""
    (_, beyond), (_, (first, *_)) = proved
    found = judged(content, proved)
    assert abs(float(found.first_of(beyond, first)[-1]) - float(first.low)) < 1e-12
    centre, found.centre = found.centre, [x + 1e-3 for x in found.centre]
    with pytest.raises(Failure, match="begins elsewhere"):
        found.first_of(beyond, first)
    found.centre, found.amplitude = centre, found.amplitude / 2
    with pytest.raises(Failure, match="begins elsewhere"):
        found.first_of(beyond, first)


@pytest.mark.parametrize(
    ("by", "told"), [(2, "outside of its tile"), (0, "not that of the branch")]
)
def test_the_flip_is_that_of_the_tile(content, proved, by, told):
    """A tile behind it, or one whose tube is elsewhere."""
    (branch, _), (own, _) = proved
    doubled = content["doubled"]
    tile = own[doubled["tile"] - 1]
    width = tile.high - tile.low
    ends = {"lower": str(tile.low + by * width), "upper": str(tile.high + by * width)}
    centre = [[first + (by == 0), *rest] for first, *rest in tile.tile["centre"]]
    moved = CheckedTile(curve_of(branch), {**tile.tile, **ends, "centre": centre})
    with pytest.raises(Failure, match=told):
        JudgedDoubling(doubled, branch, moved).locate()


def test_nothing_is_claimed_where_the_parameter_may_turn(content, proved, monkeypatch):
    found = judged(content, proved)
    monkeypatch.setattr(f"{DOUBLING}.DoubledEquations.rate", lambda *_: arb(-1, 2))
    with pytest.raises(Failure, match="on which side"):
        found.locate()


def test_another_event_on_the_tube_leaves_it_undecided(content, proved, monkeypatch):
    found = judged(content, proved)
    found.locate()
    found.decide()
    monkeypatch.setattr(f"{DOUBLING}.passing", lambda _, kind: arb(0, 1) + 3 * (kind == "flip"))
    with pytest.raises(Failure, match="another event: neimark-sacker"):
        found.decide()


@pytest.mark.slow
@pytest.mark.parametrize("name", ["dry-friction/global-stick", "rigid-stop/one-impact", "mine"])
def test_the_name_of_another_orbit_is_refused(content, name, tmp_path):
    path = tmp_path / "edited.json"
    path.write_text(json.dumps(signed({**content, "orbit": name})))
    assert name in str(ns.certify.check(path).difference)


def test_a_file_that_was_edited_is_refused(content):
    edited = copy.deepcopy(content)
    edited["end"] = "."
    with pytest.raises(Failure, match="checksum"):
        believed(edited)
    del edited["ended"]
    refused(edited, "'ended' of the file is missing")

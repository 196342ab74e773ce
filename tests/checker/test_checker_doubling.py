"""The check of a doubling: it proves what is so, and refuses a file that was edited."""

import copy

import pytest
from flint import arb

import nonsmooth as ns
from nonsmooth.runtime.checker import Failure
from nonsmooth.runtime.checker.ranges.branch import CheckedTile, curve_of
from nonsmooth.runtime.checker.ranges.doubling import (
    JudgedDoubling,
    check_doubled,
)
from tests.certified import (
    believed,
    content_of,
    edited,
    placing,
    prove_doubling,
    refused,
    saved,
    stating,
)
from tests.shared import shared_file

pytestmark = pytest.mark.compiled  # much slower without it
DOUBLING = "nonsmooth.runtime.checker.ranges.doubling"


@pytest.fixture(scope="module")
def content():
    path = shared_file("nonsmooth certified doubling", prove_doubling)
    assert ns.certify.check(path).claims == {"doubling": "proved"}
    return content_of(path)


def of_doubled(change):
    """A change of what is told of the doubled orbits."""
    return lambda content: change(content["doubled"])


def unbent(doubled):
    *others, last = doubled["centre"]
    doubled["centre"] = [*others, [x * (not k) for k, x in enumerate(last)]]


KRAWCZYK = "Krawczyk's test fails"
SLIP = "declaration", "configurations", "slip-slip", "field", 2, 0, "-1.0001"
EDITS = [
    (stating("doubled", side="below"), "they are not below the flip"),
    (stating("doubled", verdict="stable"), "at one of them it is unstable"),
    (stating("doubled", reason="none"), "a reason of another verdict"),
    (stating("doubled", verdict="undecided"), "the claim is another one"),
    (stating("doubled", verdict="undecided", reason="so"), "the claim is another one"),
    (stating("doubled", amplitude="2"), KRAWCZYK),
    # the doubled branch is right, but it does not begin in the tube
    (stating("doubled", amplitude="1/1000"), KRAWCZYK),
    (stating("doubled", amplitude="-1/10"), "not positive"),
    (of_doubled(lambda d: d["centre"][-1].__setitem__(0, d["centre"][-1][0] + 1e-3)), KRAWCZYK),
    # a tube whose parameter would not move: the same polynomials without their bend
    (of_doubled(unbent), None),
    (of_doubled(lambda d: d.update(radii=[1e-40] * len(d["radii"]))), KRAWCZYK),
    (of_doubled(lambda d: d.update(radii=[1.0] * len(d["radii"]))), KRAWCZYK),
    (stating("doubled", "rate", mid="1.4e-1"), "not in its enclosure"),
    (lambda c: c["doubled"].update(tile=1 + [t["event"] for t in c["branch"]["tiles"]].index(None)),
     "there is no flip"),
    (stating("doubled", scaled="tau1"), KRAWCZYK),
    (stating(end="the time is over"), "though it is whole"),
    (stating(doubled=None, claims={"doubling": "undecided"}),
     "complete without doubled orbits"),
    (stating(doubled=None, ended="unfinished"), "the claim is another one"),
    (lambda c: c["doubled"].update(branch={**copy.deepcopy(c["branch"]), "start": 0}),
     "not passed twice"),
    (stating("doubled", "branch", "parameters", eta="4.001"), "the doubled branch"),
    (placing("doubled", "branch", *SLIP), "the doubled branch"),
]  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize(("edit", "told"), EDITS)
def test_what_is_false_is_refused(content, edit, told):
    refused(edited(content, edit), told)


@pytest.fixture(scope="module")
def proved(content):
    """Both branches with their tiles, as if these were proved."""
    branches = [content["branch"], content["doubled"]["branch"]]
    tiles = [[CheckedTile(curve_of(each), tile) for tile in each["tiles"]] for each in branches]
    check_doubled(content["doubled"], branches, tiles)
    return branches, tiles


@pytest.mark.parametrize(
    ("change", "told"),
    [
        (stating(parameter="eta"), "another system's branch"),
        (stating(parameters={}), "another system's branch"),
        (stating(stability="neutral"), "another system's branch"),
        (stating(closing={"kind": "forcing", "turns": 1}), "closes in another way"),
        (placing(*SLIP), "the declarations differ"),
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
    path = saved({**content, "orbit": name}, tmp_path / "edited.json")
    assert name in str(ns.certify.check(path).difference)


def test_a_file_that_was_edited_is_refused(content):
    changed = copy.deepcopy(content)
    changed["end"] = "."
    with pytest.raises(Failure, match="checksum"):
        believed(changed)
    del changed["ended"]
    refused(changed, "'ended' of the file is missing")

"""What the checker refuses is undecided, with its reason, and the file holds nothing of it."""

from contextlib import contextmanager
from fractions import Fraction
from functools import cache
from pkgutil import resolve_name

import pytest
from flint import fmpq

import nonsmooth as ns
from nonsmooth.runtime.checker import Failure
from tests.certified import accepted
from tests.horseshoes import folded_horseshoe

ORBIT, SYMMETRIC = "dry-friction/global-stick", "dry-friction/symmetric"
PLANTED = "the checker refuses it: planted"


@contextmanager
def refusing(step, claimed=lambda *told: True):
    """Let a check refuse what is claimed, too."""
    check = resolve_name(f"nonsmooth.runtime.{step}")

    def planted(*told):
        if claimed(*told):
            raise Failure("planted")
        return check(*told)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(f"nonsmooth.runtime.{step}", planted)
        yield


@cache
def orbit():
    return ns.solve(ORBIT)


@cache
def branch():
    return ns.continue_orbit(ns.solve(SYMMETRIC, {"V": "1.078"}), "V", (1.075, 1.085))


@pytest.mark.parametrize("claim", ["existence", "admissibility", "stability", "derivatives"])
@pytest.mark.parametrize("error", [Failure("planted"), ZeroDivisionError("planted")])
def test_a_claim_of_an_orbit_that_cannot_be_judged(claim, error, tmp_path, monkeypatch):
    """It alone is undecided, with its reason, and all that follows from it."""
    step = {
        "existence": "stated_system", "stability": "judged_stability", "derivatives": "rates_along",
    }.get(claim, claim)  # fmt: skip

    def planted(*_, **__):
        raise error

    with monkeypatch.context() as judging:
        judging.setattr(f"nonsmooth.runtime.checker.orbits.points.{step}", planted)
        found = ns.certify(orbit(), derivatives="eta")
    left = {name for name, verdict in found.claims.items() if verdict == "undecided"}
    assert left == ({*found.claims} if claim == "existence" else {claim} - {"derivatives"})
    reasons = found.no_derivatives if claim == "derivatives" else found.reasons
    cannot = "" if isinstance(error, Failure) else "its numbers cannot be enclosed: "
    assert reasons["eta" if claim == "derivatives" else claim].endswith(f"{cannot}planted")
    assert "Error" not in str(reasons)
    assert bool(found.derivatives) == (claim in {"admissibility", "stability"})
    assert accepted(found, tmp_path).claims == found.claims


def test_an_event(tmp_path):
    (event,) = branch().events
    assert ns.certify.event(branch(), event).proved
    with refusing("checker.orbits.events.JudgedEvent.located"):
        found = ns.certify.event(branch(), event)
    assert (found.claim, found.reason) == ("undecided", PLANTED)
    assert accepted(found, tmp_path).claims == {"events": "undecided"}


@pytest.mark.slow
def test_a_tile_of_a_box_is_halved(tmp_path):
    """The check refuses the whole box, and all tiles at one of its corners."""
    with refusing(
        "checker.ranges.tiles.CheckedBox.judged", lambda _, place, *told: place[0][0] == 0
    ):
        found = ns.certify.box(orbit(), {"V": ("0.999", "1.001")}, tiles=9)
    verdicts = {tile.place.steps[0]: tile.verdict for tile in found.tiles}
    assert verdicts.pop((0, 5)) == verdicts.pop((1, 5), "undecided") == "undecided"
    assert {*verdicts.values()} == {"proved"}
    assert found.claims["existence"] == "undecided"
    reasons = [t.reasons["existence"] for t in found.tiles if t.verdict == "undecided"]
    assert {*reasons} <= {PLANTED, "not looked at yet"}
    assert accepted(found, tmp_path).claims == found.claims


def test_tiles_that_do_not_meet(tmp_path):
    box = {"V": ("0.999", "1.001"), "eta": ("0.999", "1.001")}
    whole = refusing(
        "checker.ranges.tiles.CheckedBox.judged", lambda _, place, *told: place == ((0, 0), (0, 0))
    )
    with whole, refusing("checker.ranges.tiles.CheckedBox.check_joint"):
        found = ns.certify.box(orbit(), box)
    assert sorted(tile.verdict for tile in found.tiles) == ["proved", "undecided"]
    check_told(found, tmp_path)


def check_told(found, folder):
    assert found.reasons["existence"].endswith(PLANTED)
    assert accepted(found, folder).claims == found.claims


def test_what_is_said_of_a_whole_box(tmp_path):
    with refusing("proof.boxes.certify_box.check_whole", lambda content: content["enclosures"]):
        found = ns.certify.box(orbit(), {"V": ("0.999", "1.001")})
    check_told(found, tmp_path)


@pytest.mark.slow
def test_a_tile_of_a_branch_is_divided(tmp_path):
    """What is stated is what the check proves, however little that can do."""
    widest = fmpq(1, 1000)
    with refusing(
        "checker.ranges.branch.CheckedTile.claims", lambda tile: tile.high - tile.low >= widest
    ):
        found = ns.certify.branch(branch(), interval=("1.075", "1.085"))
    assert found.complete, found.statement
    assert [event.kind for event in found.events] == ["flip"]
    assert all(tile.upper - tile.lower < Fraction(1, 1000) for tile in found.tiles)
    accepted(found, tmp_path)


@pytest.mark.slow
def test_a_tile_of_a_branch_that_is_not_joined(tmp_path):
    """The branch is given up where it is, on both sides, and the first tile stays."""
    with refusing("proof.branch.certify_branch.check_joint"):
        found = ns.certify.branch(branch(), interval=("1.077", "1.079"))
    assert len(found.tiles) == 1
    assert any("planted" in end for end in found.ends)
    assert not found.complete
    assert accepted(found, tmp_path).claims == {"branch": "undecided"}


@pytest.mark.slow
@pytest.mark.parametrize("what", ["verdict", "locate"])
def test_a_doubling(what, tmp_path):
    with refusing(f"checker.ranges.doubling.JudgedDoubling.{what}"):
        found = ns.certify.doubling(branch(), tiles=1)
    if what == "verdict":
        assert (found.doubled.verdict, found.doubled.reason) == ("undecided", PLANTED)
    else:
        assert (found.ended, found.end) == ("not proved", PLANTED)
        assert found.doubled is None
    assert accepted(found, tmp_path).claims == {"doubling": "undecided"}


def test_chaos():
    with (
        refusing("checker.state_sets.chaos.StretchedSets.covered"),
        pytest.raises(AssertionError, match="planted"),
    ):
        folded_horseshoe()


def test_cones():
    with refusing("checker.state_sets.chaos.Derivatives.hulls"):
        found = folded_horseshoe(exponents=True)
    assert found.proved
    assert found.cones is None
    assert found.tried == ("no cone condition: planted",)


@pytest.mark.slow
def test_an_orbit_that_is_counted(tmp_path):
    with refusing("checker.counting.census.CountedBox.check_orbit"):
        found = ns.certify.all(ORBIT, box={"tau": 3, "tau1": 3})
    (counted,) = found.orbits
    assert (counted.certificate, counted.reason) == (None, "planted")
    # that there is one orbit, and no other, is proved by the tree
    assert accepted(found, tmp_path).claims == {"orbits": "proved"}


@pytest.mark.parametrize("error", [KeyboardInterrupt, KeyError, TypeError, AttributeError])
def test_an_interruption_and_an_error_of_the_program_are_no_refusals(error, monkeypatch):
    def stopped(*told):
        raise error

    monkeypatch.setattr("nonsmooth.runtime.checker.ranges.tiles.CheckedBox.judged", stopped)
    with pytest.raises(ns.Interrupted if error is KeyboardInterrupt else error):
        ns.certify.box(orbit(), {"V": ("0.999", "1.001")})

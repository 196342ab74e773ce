"""Certified branches: what is proved, against the integrator, the events' certificates, attacks."""

import random
from dataclasses import replace
from fractions import Fraction
from functools import cache
from types import SimpleNamespace

import mpmath
import numpy as np
import pytest
import sympy as sp
from flint import arb, fmpq

import nonsmooth as ns
from nonsmooth import InputError, certify
from nonsmooth.derive import SoftStop
from nonsmooth.runtime.checker import Failure
from nonsmooth.runtime.checker.orbits.motion import Border, time_of_touch
from nonsmooth.runtime.checker.ranges.branch import checked_tiles
from nonsmooth.runtime.core.arithmetic import exact_ball
from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.proof.branch.certify_branch import _short_phase
from tests.certified import (
    accepted,
    believed,
    certified_over,
    content_of,
    edited,
    placing,
    prove_branch,
    prove_vanishing,
    refused,
    stating,
)
from tests.explore import test_continuation_forced as impacts
from tests.one_mass import one_mass
from tests.shared import shared_file

FINISHED, VANISHED = "end of the interval", "a phase vanishes"


@pytest.fixture(scope="module")
def branch():
    return ns.continue_orbit(ns.solve("dry-friction/symmetric"), "V", (0.6, 1.3))


@pytest.fixture(scope="module")
def found():
    return ns.load(shared_file("branch of friction", prove_branch))


@pytest.fixture(scope="module")
def tile_near():
    """The tile of the branch that holds a value, as the checker knows it."""
    path = shared_file("branch of friction", prove_branch)
    checked = checked_tiles(content_of(path))
    return lambda value: next(tile for tile in checked if tile.low <= value <= tile.high)


@pytest.mark.slow
def test_the_papers_orbit_has_three_intervals_and_two_events(found):
    assert found.complete
    assert found.claims == {"branch": "proved"}
    verdicts = [part.verdict for part in found.intervals]
    assert verdicts == ["not admissible", "unstable", "stable"]
    assert [event.kind for event in found.events] == ["grazing", "flip"]
    assert "consists of exactly" in found.statement
    assert (found.intervals[0].begin, found.intervals[-1].end) == (0.6, 1.3)


def test_events_are_those_of_their_certificates(branch, found):
    for event, computed in zip(found.events, branch.events, strict=True):
        assert event.kind == computed.kind
        told = certify.event(branch, computed, 180).value
        here = event.enclosures["V"]
        with flint_precision(300):
            assert here.ball.overlaps(told.ball)
            assert here.ball.rad() < 1e-31
        assert event.upper - event.lower < Fraction(1, 10**30)


def test_orbits_solved_anywhere_are_in_their_tubes_with_the_verdict(found):
    draw = random.Random(1)
    for tile in found.tiles:
        value = draw.uniform(float(tile.lower), float(tile.upper))
        orbit = ns.solve("dry-friction/symmetric", {"V": value})
        place = 2 * (value - float(tile.lower)) / float(tile.upper - tile.lower) - 1
        middles = [np.polynomial.polynomial.polyval(place, row) for row in tile.centre]
        numbers = ns.certify(orbit).enclosures
        for name, middle, radius in zip(found.unknown_names, middles, tile.radii, strict=True):
            assert abs(float(numbers[name]) - middle) < radius + 1e-9
        verdict = tile.before
        if tile.event is not None:
            verdict = tile.before if value < float(tile.event.lower) else tile.after
        admissible = orbit.admissibility.verdict is not False
        told = orbit.stability.verdict if admissible else "not admissible"
        assert told == verdict


@pytest.mark.slow
def test_progress_rises_to_all_of_it():
    """In between it is the part of the interval that the tiles so far cover."""
    told = []
    orbit = ns.solve("dry-friction/symmetric", {"V": "1.07"})
    branch = ns.continue_orbit(orbit, "V", (1.06, 1.1))
    found = ns.certify.branch(branch, progress=lambda *now: told.append(now))
    shares = [share for share, _ in told]
    assert shares == sorted(shares)
    assert shares[-1] == 1
    begun, count = found.tiles[: found.start][::-1], len(found.tiles)
    assert [number for _, number in told] == [*range(1, count + 1)]
    covered = Fraction(0)
    for share, tile in zip(shares, (*begun, *found.tiles[found.start :]), strict=True):
        assert tile.coordinate == "V"
        covered += abs(tile.upper - tile.lower)
        assert share == pytest.approx(float(covered / Fraction("0.04")), abs=0.01)


@pytest.mark.slow
def test_a_vanishing_phase_is_one_event():
    branch = ns.continue_orbit(ns.solve("dry-friction/global-stick"), "V", (0.9, 1.3))
    found = ns.certify.branch(branch, interval=("0.9", "1.3"))
    assert found.complete
    (event,) = found.events
    assert event.kind == "vanishing-phase"
    assert [other[0] for other in event.also] == ["simultaneous"]
    (computed,) = branch.events
    assert abs(float(event.enclosures["V"]) - computed.value) < 1e-9
    dwell = event.enclosures[found.unknown_names[-4]]
    assert dwell.ball.contains(0)
    assert float(dwell.ball.rad()) < 1e-30


def test_a_number_whose_rate_may_be_zero_is_not_passed_once(tile_near):
    """Its event may happen twice in the tile: the rate has one sign, or nothing is proved."""
    tile = tile_near(fmpq(27, 25))
    with flint_precision(64):
        tile.locate()
        for within, rises in ((fmpq(-1, 10), True), (fmpq(11, 10), False)):
            zero = arb(tile.low + within * (tile.high - tile.low))
            assert tile.rises(lambda point, at=zero: point[tile.place] - at, "") == rises
        for within in (fmpq(1, 100), fmpq(1, 3), fmpq(99, 100)):
            zero = arb(tile.low + within * (tile.high - tile.low))
            with pytest.raises(Failure, match="twice"):
                tile.rises(lambda point, at=zero: point[tile.place] - at, "twice")


def test_another_orbit_is_not_taken_for_the_one_that_is_known(tile_near):
    tile = tile_near(fmpq(27, 25))
    with flint_precision(192):
        *others, value = tile.at(arb("1.08"))
        assert tile.holds(value, others)
        for place in range(len(others)):
            moved = [x + arb("1e-6") * (k == place) for k, x in enumerate(others)]
            assert not tile.holds(value, moved)


@pytest.mark.slow
def test_a_pair_that_leaves_the_circle_at_both_ends_is_not_one_flip():
    """With a period that is given m + 1/m may pass 2 where the equations stay regular."""

    def orbit(period):
        values = {"m2": "1.13", "k1": "7.74", "k2": "0.85", "T": period}
        return ns.solve("rigid-stop/one-impact", values)

    found = certified_over(orbit("7.2425"), "T", "7.242", "7.243")
    (event,) = found.events
    assert event.kind == "flip"
    # a tile around it that is unstable at both ends
    nodes = np.cos(np.pi * (np.arange(12) + 0.5) / 12)
    numbers = [ns.certify(orbit(7.425 + 0.315 * e)).enclosures for e in nodes]
    rows = [[float(each[name]) for name in found.unknown_names] for each in numbers]

    def widen(content):
        (tile,) = (tile for tile in content["tiles"] if tile["event"])
        tile.update(lower="711/100", upper="387/50", before="unstable", after="unstable")
        tile["centre"] = np.polynomial.polynomial.polyfit(nodes, rows, 5).T.tolist()
        tile["radii"] = [0.1, 0.15, 0.3, 0.18, 1e-12]
        content.update(tiles=[tile], start=0, interval=["711/100", "387/50"])

    refused(edited(found, widen), "may meet at 1")


def test_a_touch_behind_the_end_of_its_phase_is_none(tile_near):
    """A window of time may reach beyond the phase; what is touched there is not touched."""
    tile = tile_near(fmpq(6653, 10_000))
    with flint_precision(192):
        point = tile.at(arb("0.6653"))
        orbit = tile.curve.orbit(point)
        found = []
        for place, phase in enumerate(orbit.declared.phases([])):
            for watched in phase.watched:
                border = Border("grazing", place, watched.name, "inside")
                window = orbit.dwell[place] / 20, orbit.dwell[place] * 19 / 20
                try:
                    found.append((border, window, time_of_touch(orbit, border, window)))
                except Failure:
                    continue
        assert found
        for border, window, time in found:
            shorter = tile.curve.orbit(point)
            shorter.dwell[border.phase] = time - arb("1e-9")
            with pytest.raises(Failure, match="outside of its phase"):
                time_of_touch(shorter, border, window)
            shorter.dwell[border.phase] = time + arb("1e-9")
            assert time_of_touch(shorter, border, window) is not None
            with pytest.raises(Failure, match="outside of its window"):
                time_of_touch(shorter, border, (time + arb("1e-9"), time + arb("2e-9")))


@pytest.mark.slow
def test_a_torus_is_an_event_and_a_neutral_saddle_is_none(tmp_path):
    """Two real multipliers whose product passes 1 do not pass the circle."""
    torus, saddle = (
        certified_over(impacts.orbit(sigma), "c", "-0.2", "0.1") for sigma in (-0.5, -0.05)
    )
    for found, verdicts in ((torus, ["unstable", "stable"]), (saddle, ["unstable"])):
        assert [part.verdict for part in found.intervals] == verdicts
        assert accepted(found, tmp_path).claims == {"branch": "proved"}
    (event,) = torus.events
    assert event.kind == "neimark-sacker"
    with mpmath.workprec(200):
        closed = 2 * mpmath.log(mpmath.mpf(8) / 10) / (2 * mpmath.pi / (mpmath.mpf(28) / 10))
        assert event.enclosures["c"].ball.contains(exact_ball(closed))
    (stated,) = (tile["event"] for tile in content_of(torus)["tiles"] if tile["event"])
    for ball in stated["enclosures"].values():
        ball["rad"] = "10"

    def plant(content):
        (tile,) = (
            tile
            for tile in content["tiles"]
            if Fraction(tile["lower"]) < Fraction(stated["lower"]) < Fraction(tile["upper"])
        )
        tile["event"] = stated

    refused(edited(saddle, plant), "neutral saddle")


def test_what_is_asked_wrongly_is_told(branch, found):
    with pytest.raises(InputError, match="branch takes"):
        ns.certify.branch(branch.orbit)
    with pytest.raises(InputError, match="not an integer from 1"):
        ns.certify.branch(branch, tiles=0)
    with pytest.raises(InputError, match="is not in"):
        ns.certify.branch(branch, interval=("1.2", "1.3"))
    with pytest.raises(InputError, match="another interval"):
        ns.certify.branch(branch, interval=("0.65", "1.1"), resume=found)
    with pytest.raises(InputError, match="resume takes a CertifiedBranch"):
        ns.certify.branch(branch, resume=branch)


@pytest.mark.slow
def test_narrow_tiles_are_proved_again(tmp_path):
    """Where tubes are as narrow as rounding the check takes more bits."""
    orbit = ns.solve("dry-friction/symmetric", {"V": "1.08"})
    branch = ns.continue_orbit(orbit, "V", (1.07, 1.09))
    found = ns.certify.branch(branch, interval=("1.08", "1.08000000001"))
    assert found.complete
    assert accepted(found, tmp_path).claims == {"branch": "proved"}


@pytest.mark.slow
def test_little_is_looked_at_beside_an_event_at_an_end(branch):
    """What is undecided at an end grows by doubling, not tile by tile of the smallest width."""
    event = branch.events[-1]
    orbit = ns.solve("dry-friction/symmetric", {"V": "1.080588075"})
    beside = ns.continue_orbit(orbit, "V", (1.0805, 1.0807))
    found = ns.certify.branch(beside, interval=("1.080588074177112019767064076", "1.0805881"))
    assert not found.complete
    assert all(abs(part.begin - event.value) < 1e-9 for part in found.undecided)
    assert sum(part.width for part in found.undecided) < 1e-11
    assert len(found.tiles) < 100


def test_an_undecided_tile_is_never_part_of_a_complete_branch(found):
    tiles = list(found.tiles)
    tiles[3] = replace(tiles[3], before="undecided", after="undecided", reason="planted")
    worse = replace(found, tiles=tuple(tiles))
    assert not worse.complete
    (part,) = worse.undecided
    assert part.width == pytest.approx(float(tiles[3].upper - tiles[3].lower))
    assert "not decided" in worse.statement


@pytest.mark.slow
def test_a_fold_is_passed_by_another_coordinate(tmp_path):
    force, rate = sp.symbols("F Omega")
    rubber = SoftStop("x", at="0.005", stiffness=8000, damping=5, name="rubber")
    system = one_mass("bump-stop", rubber, mass=2, damping=2, stiffness=800, forces={rate: force})
    orbit = ns.find_orbits(system, {"F": 2, "Omega": 26}, 50, transitions=500).orbits[0].orbit
    branch = ns.continue_orbit(orbit, "Omega", (25.5, 30), step=0.05)
    found = ns.certify.branch(branch, interval=("25.5", "30"))
    assert found.complete, found.statement
    assert [part.verdict for part in found.intervals] == ["stable", "unstable"]
    (event,) = found.events
    (computed,) = (other for other in branch.events if other.kind == "fold")
    assert event.kind == "fold"
    assert abs(float(event.enclosures["Omega"]) - computed.value) < 1e-9
    assert float(event.enclosures["Omega"].ball.rad()) < 1e-30
    assert len({tile.coordinate for tile in found.tiles}) > 1
    # both ends are at the lower end of the interval
    ends = [found.intervals[0].begin, found.intervals[-1].end]
    np.testing.assert_allclose(ends, 25.5)
    assert accepted(found, tmp_path).claims == {"branch": "proved"}
    assert found.plot() is not None


@cache
def grazing():
    """The file of a branch that ends where its contact vanishes; nothing is said of beyond."""
    content = content_of(shared_file("branch whose contact vanishes", prove_vanishing))
    content["tiles"][0]["event"]["beyond"] = []
    return content


@pytest.mark.slow
def test_a_branch_ends_where_a_contact_with_a_soft_stop_vanishes():
    found = ns.load(shared_file("branch whose contact vanishes", prove_vanishing))
    assert found.complete
    assert found.ends == (VANISHED, FINISHED)
    (event,) = found.events
    assert event.kind == "vanishing-phase"
    assert "fold" in [other[0] for other in event.also]
    assert found.tiles[0].divided == 0
    assert found.intervals[-1].verdict == "stable"
    # there the amplitude of the oscillator without the stop is its distance
    with mpmath.workprec(200):
        half = mpmath.mpf(49) / 50
        closed = mpmath.sqrt(half - mpmath.sqrt(half**2 - mpmath.mpf(21) / 25))
        assert event.enclosures["Omega"].ball.contains(exact_ball(closed))


def first_tile(content):
    """What is left is the tile in which the contact vanishes, and ends that claim nothing."""
    content["tiles"] = content["tiles"][:1]
    content |= {"start": 0, "ends": ["left out"] * 2, "claims": {"branch": "undecided"}}


def without(kind):
    """Leave all but the first tile out, and of what happens there one kind."""

    def change(content):
        first_tile(content)
        event = content["tiles"][0]["event"]
        event["also"] = [other for other in event["also"] if other[0] != kind]

    return change


def call_it_admissible(content):
    first_tile(content)
    content["tiles"][0]["before"] = "stable"


ATTACKS = {
    "not divided": stating("tiles", 0, divided=None),
    "divided by another": stating("tiles", 0, divided=2),
    "divided by none that is there": stating("tiles", 0, divided=3),
    "a turn in another phase": placing("tiles", 0, "event", "also", -1, 1, 2),
    "it vanishes at the other end": stating(ends=[FINISHED, VANISHED]),
    "no tangency": without("tangent"),
    "no turn": without("fold"),
    "admissible": call_it_admissible,
}


@pytest.mark.slow
@pytest.mark.parametrize("attack", ATTACKS)
def test_an_edited_end_is_refused(attack):
    refused(edited(grazing(), ATTACKS[attack]))


@pytest.mark.slow
def test_an_end_that_claims_nothing_is_accepted():
    """It is refused above for what is hidden in it."""
    believed(edited(grazing(), first_tile))


def test_of_many_phases_none_is_short_for_being_one_of_many():
    """All of 64 impacts last a 64th of the period; divided equations are not seen from frames."""
    curve = SimpleNamespace(
        last=67, declared=SimpleNamespace(dwell=[""] * 64), divided=lambda place: place
    )
    point = [arb(0)] * 3 + [arb("2.2")] * 64 + [arb(1)]
    assert _short_phase(curve, point) is None
    point[3 + 5] = arb("0.001")
    assert _short_phase(curve, point) == 5

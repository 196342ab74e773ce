"""The check of a branch: it proves what is so, and refuses a file that was edited."""

import copy
import json
from fractions import Fraction
from itertools import product

import pytest
import sympy as sp
from flint import arb, arb_mat, ctx

import nonsmooth as ns
from nonsmooth.derive import SoftStop
from nonsmooth.runtime.checker import Failure
from nonsmooth.runtime.checker.ranges.branch import CheckedTile, checked_tiles, curve_of
from nonsmooth.runtime.checker.ranges.branch_curve import solution
from nonsmooth.runtime.core.jets import part_of
from nonsmooth.runtime.core.taylor_models import range_of
from tests.certified import (
    believed,
    certified_over,
    content_of,
    prove_branch,
    refused,
    refused_file,
    stating,
)
from tests.checker.test_mutations import written
from tests.one_mass import one_mass
from tests.shared import shared_file
from tests.tables import slow


@pytest.fixture(scope="module")
def content():
    path = shared_file("branch of friction", prove_branch)
    assert ns.certify.check(path).claims == {"branch": "proved"}
    return content_of(path)


@pytest.fixture(scope="module")
def preloaded():
    """A tile of which only narrow parts are proved to be stable: a multiplier is near 1."""
    rate = sp.symbols("Omega")
    pad = SoftStop("x", at="-1/50", stiffness="71/25", damping="2/25", name="pad")
    system = one_mass("preloaded", pad, damping="3/10", forces={rate: "11/50"})
    orbit = ns.find_orbits(system, {"Omega": "0.7"}, 2, transitions=100).orbits[0].orbit
    found = certified_over(orbit, "Omega", "0.7", "0.7185", tiles=1)
    assert [tile.before for tile in found.tiles] == ["stable"]
    return content_of(found)


@pytest.mark.slow
def test_derivatives_along_the_branch_are_those_of_differences(content):
    """By the parameter and by an unknown: of orbits at a point, and in a box around it."""
    curve, middle, step = curve_of(content), arb(1.08), arb(2) ** -40
    with ctx.workprec(192):
        (tile,) = (
            tile
            for tile in (CheckedTile(curve, stated) for stated in content["tiles"])
            if tile.place == curve.last and arb(tile.low) < middle < arb(tile.high)
        )
        behind, at, ahead = (tile.at(middle + k * step) for k in (-1, 0, 1))
        wide = [x + arb(0, arb(2) ** -30) for x in at]
        for place in (curve.last, 2):
            before, found, after, over = (
                curve.jets(place, point, 2) for point in (behind, at, ahead, wide)
            )
            moved = ahead[place] - behind[place]
            for k, jet in enumerate(found):
                own, bend = part_of(jet, 1), 2 * part_of(jet, 2)
                assert abs((ahead[k] - behind[k]) / moved - own) < 1e-18
                assert abs((part_of(after[k], 1) - part_of(before[k], 1)) / moved - bend) < 1e-18
                assert part_of(over[k], 1).contains(own)
                assert (2 * part_of(over[k], 2)).contains(bend)


@pytest.mark.parametrize("radius", [0.125, 0.375])
def test_a_linear_system_is_solved_for_all_numbers_in_its_balls(radius):
    unit, right = arb_mat([[1, 0], [0, 1]]), arb_mat([[1], [1]])
    found = solution(unit + arb_mat([[arb(0, radius)] * 2] * 2), unit, right)
    for a, b, c, d in product((-radius, radius), repeat=4):
        true = (unit + arb_mat([[a, b], [c, d]])).solve(right)
        assert all(x.contains(true[k, 0]) for k, x in enumerate(found))


def event_of(content, kind):
    return tile_of(content, kind)["event"]


def tile_of(content, kind):
    return next(tile for tile in content["tiles"] if (tile["event"] or {}).get("kind") == kind)


def drop_an_event(content):
    tile = tile_of(content, "flip")
    tile["event"] = None
    for other in content["tiles"][content["tiles"].index(tile) :]:
        other["before"] = other["after"] = tile["before"]


def exchange_the_sides(content):
    tile = tile_of(content, "grazing")
    tile["before"], tile["after"] = tile["after"], tile["before"]


def call_it_stable(content):
    for tile in content["tiles"]:
        tile.update(event=None, before="stable", after="stable")


ON_ALL_TILES = [
    drop_an_event,
    call_it_stable,
    lambda c: tile_of(c, "flip").update(event=None, before=tile_of(c, "flip")["after"]),
    lambda c: event_of(c, "flip").update(kind="neimark-sacker"),
    lambda c: event_of(c, "flip").update(kind="fold"),
    lambda c: event_of(c, "grazing").update(window=["1/10", "1/5"]),
    # the function has its one maximum in this window too, but is convex where it begins
    lambda c: event_of(c, "grazing").update(window=["1/10", "2"]),
]
ATTACKS = [
    exchange_the_sides,
    lambda c: event_of(c, "flip").update(lower="107/100", upper="108/100"),
    lambda c: event_of(c, "flip")["enclosures"]["V"].update(rad="1e-60"),
    lambda c: event_of(c, "grazing").update(phase=2),
    lambda c: event_of(c, "grazing").update(also=[["flip", 1, "", ""]]),
    lambda c: c["tiles"].pop(3),
    stating("tiles", 0, lower="61/100"),
    lambda c: c["tiles"][4]["centre"][0].insert(0, c["tiles"][4]["centre"][0].pop(0) + 1e-3),
    lambda c: c["tiles"][4].update(radii=[10.0 for _ in c["tiles"][4]["radii"]]),
    stating("tiles", 4, forwards=False),
    stating("tiles", 4, before="undecided", after="undecided", reason="planted"),
    lambda c: c["tiles"][4].update(event=copy.deepcopy(event_of(c, "flip"))),
    # no phase of this orbit begins where it ends
    stating("tiles", 4, divided=1),
    stating(interval=["1/2", "13/10"]),
    lambda c: c.update(ends=[c["ends"][0], ""]),
    lambda c: c.update(ends=["a phase vanishes", c["ends"][1]]),
    *(slow(attack) for attack in ON_ALL_TILES),
]


@pytest.mark.slow
def test_a_branch_is_proved_again(content):
    believed(content)


@pytest.mark.parametrize("attack", ATTACKS)
def test_an_edited_branch_is_refused(content, attack):
    edited = copy.deepcopy(content)
    attack(edited)
    refused(edited)
    with pytest.raises(Failure, match="checksum"):
        believed({**edited, "sha256": content["sha256"]})


@pytest.mark.parametrize("kind", ["flip", "grazing"])
def test_an_event_is_between_its_bounds(content, kind):
    """They are amid the longer rest of its tile, and all that is there is enclosed."""
    edited = copy.deepcopy(content)
    tile = tile_of(edited, kind)
    low, high, at = (Fraction(x) for x in (tile["lower"], tile["upper"], tile["event"]["lower"]))
    middle = (at + (low if at - low > high - at else high)) / 2
    tile["event"].update(lower=str(middle), upper=str(middle + Fraction(1, 10**12)))
    for ball in tile["event"]["enclosures"].values():
        ball["rad"] = "1"
    refused(edited, "there may be no event between its bounds")


@pytest.mark.slow
def test_only_a_grazing_has_a_window():
    edited = json.loads(written("branch-vanishing"))
    event_of(edited, "vanishing-phase")["window"] = ["1/10", "1/5"]
    refused(edited, "a window of no grazing")


def test_other_parameters_are_another_branch(content, tmp_path):
    other = {**content["parameters"], "eta": "4.1"}
    refused_file({**content, "parameters": other}, tmp_path, "")


def width(number):
    return float(abs(range_of(number - number.mid())).upper())


@pytest.mark.slow
def test_a_tile_is_proved_on_parts(content, preloaded):
    """On each half of a tile the orbits are at least as narrowly enclosed, and are there."""
    for tile in [*checked_tiles(content), *checked_tiles(preloaded)]:
        seen = []

        def prove(point, seen=seen):
            seen.append(point)
            if len(seen) == 1:
                raise Failure("halve it")

        tile.parts(prove)
        whole, *halves = seen
        for side, half in zip((-1, 1), halves, strict=True):
            with ctx.workprec(192):
                orbit = tile.at(half[tile.place].at([0]).mid())
            e = whole[-1].space.variable(0, side / 2, 1 / 2)
            for before, after, exact in zip(whole, half, orbit, strict=True):
                assert width(after) <= width(before.at([e]))
                assert abs(after.at([0]) - exact) <= width(after) + 2**-40


@pytest.mark.slow
def test_a_map_that_is_multiplied_by_a_speed_is_the_map_times_it(preloaded):
    """Also where the equations are divided by a dwell time, and the map needs no speed."""
    curve, seen = curve_of(preloaded), set()
    for divided in (None, 1, 2):
        try:
            tile = CheckedTile(curve, {**preloaded["tiles"][0], "divided": divided})
        except Failure:
            continue
        with ctx.workprec(192):
            orbit = tile.curve.orbit(tile.at_end(tile.low))
            whole, section = orbit.section, orbit.declared.section
            for place in range(2):
                slow, speed = orbit.map_on(*section, slow=place), orbit.speed(place)
                assert abs(speed) > 0
                entries = zip(slow.entries(), whole.entries(), strict=True)
                assert all(x.overlaps(speed * y) and x.rad() < 1e-20 for x, y in entries)
        seen.add(divided)
    assert len(seen) > 1

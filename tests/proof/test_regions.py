"""Maps of two parameters: regions with one verdict, curves of events between them, and no more."""

import random
from fractions import Fraction
from functools import cache
from types import SimpleNamespace

import pytest
from flint import arb, fmpq

import nonsmooth as ns
from nonsmooth.runtime.checker import Failure
from nonsmooth.runtime.checker.orbits.motion import Border
from nonsmooth.runtime.checker.ranges.divided import Division
from nonsmooth.runtime.core.taylor_models import space_of
from tests.certified import (
    accepted,
    believed,
    claimed,
    content_of,
    loop,
    random_points,
    refused,
    signed,
    told_at,
    unhashed,
)
from tests.pictures import legend_of
from tests.proof import test_boxes, test_fold_curves

# the kicked mass reaches 1/(1 - r), where the wall stands, and has the multiplier r
CORNER = {"r": ("-3/2", "-1/4"), "a": ("2/5", "7/10")}
BESIDE = {"r": ("-5/4", "-3/4"), "a": ("27/50", "7/10")}


@cache
def corner():
    """A flip and a grazing that cross at r = -1, a = 1/2."""
    return ns.certify.box(loop(r="-1/2", a="3/5"), CORNER)


def true_verdict(r, a):
    """Of the kicked mass."""
    if a * (1 - r) < 1:
        return "not admissible"
    return "proved" if r > -1 else "unstable"


@pytest.mark.slow
def test_a_box_consists_of_regions_curves_and_one_open_corner():
    found = corner()
    assert [region.verdict for region in found.regions] == ["not admissible", "unstable", "stable"]
    # the area below a = 1/(1 - r)
    places = [-1.5 + 1.25 * (k + 0.5) / 4000 for k in range(4000)]
    below = [min(max(1 / (1 - r) - 0.4, 0), 0.3) / 0.3 for r in places]
    low = sum(below) / len(places)
    assert found.regions[0].share == pytest.approx(low, abs=1e-3)
    assert sum(region.share for region in found.regions) == pytest.approx(1, abs=1e-6)
    assert sorted(curve.event.kind for curve in found.curves) == ["flip", "grazing", "grazing"]
    (hole,) = found.open
    assert hole.where["r"][0] <= -1 <= hole.where["r"][1]
    assert hole.where["a"][0] <= Fraction(1, 2) <= hole.where["a"][1]
    assert hole.share < 1e-6
    assert hole.events == ("flip", "grazing of wall in phase 1")
    for curve in found.curves:
        assert sorted(curve.ends) == ["border", "open"]
        assert curve.width < 1e-5
    assert "3 regions" in found.statement
    assert "undecided: " in found.statement
    assert found.decided == 1 - hole.share


@pytest.mark.slow
def test_curves_are_those_of_the_closed_form():
    """Away from where they cross, in bands whose width is looked at above."""
    for k in range(25):
        value = Fraction(k, 25)
        r, a = Fraction(-3, 2) + value * Fraction(5, 4), Fraction(2, 5) + value * Fraction(3, 10)
        if a > Fraction(51, 100):
            assert told_at(corner(), {"r": -1, "a": a}) == ""
        if abs(r + 1) > Fraction(1, 100) and r < Fraction(-3, 7):
            assert told_at(corner(), {"r": r, "a": 1 / (1 - r)}) == ""


@pytest.mark.slow
def test_verdicts_at_random_points_are_the_true_ones():
    seen = set()
    for point in random_points(corner(), 5, 4):
        verdict = told_at(corner(), point)
        if verdict not in ("", "undecided"):
            assert verdict == true_verdict(point["r"], point["a"])
            event = corner().tile_at(point).event
            seen.add((event.kind if event else "", verdict))
    assert len(seen) == 6
    assert ("grazing", "not admissible") in seen


@pytest.mark.slow
def test_every_point_of_a_region_has_its_verdict():
    found = corner()
    for region in found.regions:
        for number, side in region.cells:
            tile = found.tiles[number]
            own = tile.verdict if not side else getattr(tile.event, side)
            assert (found.stability if own == "proved" else own) == region.verdict


@pytest.mark.slow
def test_an_event_on_the_edge_of_the_box():
    # r = -1 is the right edge: there is a flip, and beside it all is unstable
    found = ns.certify.box(loop(r="-5/4"), {"r": ("-3/2", "-1"), "k": ("4/5", "6/5")}, tiles=60)
    assert [region.verdict for region in found.regions] == ["unstable"]
    assert found.decided == 1
    (curve,) = found.curves
    assert all(r == pytest.approx(-1, abs=1e-9) for r, _ in curve.points)
    believed(content_of(found))


@pytest.mark.slow
def test_a_thin_tongue_is_found():
    # not admissible only between the edge a = 1/2 and a = 1/(1 - r), below 1e-3 of the box
    box = {"r": ("-101/100", "-999/1000"), "a": ("1/2", "5/8")}
    found = ns.certify.box(loop(r="-1001/1000", a="3/5"), box, tiles=60)
    (tongue,) = [region for region in found.regions if region.verdict == "not admissible"]
    assert 0 < tongue.share < 1e-3
    tile = found.tile_at({"r": "-0.9991", "a": "0.50015"})
    assert tile.verdict in ("divided", "not admissible", "undecided")


@pytest.mark.slow
def test_maps_with_curves_are_kept_and_resumed(tmp_path):
    """The two curves without the corner."""
    orbit = loop(r="-19/20", a="3/5")
    part = ns.certify.box(orbit, BESIDE, tiles=3)
    part.save(tmp_path / "map.json")
    again = ns.load(tmp_path / "map.json")
    assert unhashed(again.to_json()) == unhashed(part.to_json())
    whole = ns.certify.box(orbit, BESIDE, resume=again)
    once = ns.certify.box(orbit, BESIDE)
    assert part.shares != whole.shares == once.shares
    assert [r.verdict for r in whole.regions] == [r.verdict for r in once.regions]


@pytest.mark.slow
@pytest.mark.parametrize(
    ("drawn", "labels"),
    [
        (corner, ("flip", "grazing", "stable, proved", "unstable, proved", "undecided box")),
        (test_fold_curves.folded, ("fold", "stable, proved", "beyond a fold, proved")),
        (test_boxes.paper, ("stable, proved (100 %)",)),
        (test_boxes.line, ("unstable, proved",)),
    ],
)
def test_maps_are_drawn(drawn, labels):
    pytest.importorskip("matplotlib")
    (axes,) = drawn().plot().axes
    assert drawn().plot(axes) is axes
    for label in labels:
        assert any(text.startswith(label) for text in legend_of(axes))


def test_a_box_of_three_parameters_is_not_drawn():
    names = {"k": ("0.9", "1.1"), "r": ("0.4", "0.6"), "a": ("2.9", "3.1")}
    with pytest.raises(ns.InputError, match="two parameters"):
        ns.certify.box(loop(), names).plot()


SMALL = {
    "flip": ({"r": "-19/20", "a": "3/5"}, {"r": ("-11/10", "-9/10"), "a": ("27/50", "7/10")}),
    "grazing": ({"r": "-1/2", "a": "7/10"}, {"r": ("-11/20", "-9/20"), "a": ("13/20", "7/10")}),
}


@cache
def small(kind):
    """A part of the map with one curve, so that checks are fast."""
    values, box = SMALL[kind]
    return ns.certify.box(loop(**values), box)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(2))
def test_what_is_stated_beside_curves_is_never_refused(seed, tmp_path):
    """The curve is proposed, and what the checker finds beside it is what the file states."""
    drawn = random.Random(seed)
    size, a = Fraction(drawn.randint(8, 40), 100), Fraction(drawn.randint(600, 700), 1000)
    r = -1 + size * Fraction(drawn.randint(-9, 9), 20)
    box = {"r": (-1 - size, -1 + size / 2), "a": (a - size, a + size / 3)}
    found = ns.certify.box(loop(r=str(r), a=str(a)), box, tiles=20)
    assert any(tile.event is not None for tile in found.tiles)
    reasons = [reason for tile in found.tiles for reason in tile.reasons.values()]
    assert not any("the checker refuses it" in reason for reason in reasons)
    accepted(found, tmp_path)


def test_a_curve_that_is_left_out_is_refused():
    content = content_of(small("flip"))
    for tile in content["tiles"]:
        tile["event"] = None
    refused(content, "shares")


def test_a_curve_beside_its_tile_is_none_of_the_box():
    """The flip is at r = -1: a file may state it of a tile, but not that the box has one."""
    found = ns.certify.box(
        loop(r="-19/20", a="3/5"), {"r": ("-99/100", "-9/10"), "a": ("27/50", "7/10")}
    )
    content = content_of(found)
    (tile,) = content["tiles"]
    event = dict(next(t["event"] for t in content_of(small("flip"))["tiles"] if t["event"]))
    event |= {"centre": [-11 / 9, 0.0], "radius": 1e-6, "below": "proved", "above": "proved"}
    tile |= {"event": event, "claims": {**tile["claims"], "stability": "undecided"}}
    tile["reasons"] = {"stability": "so"}
    told = claimed(type(found), content)
    content |= {n: told.to_json()[n] for n in ("claims", "reasons", "shares", "enclosures")}
    believed(signed(content))
    assert [region.verdict for region in told.regions] == ["stable"]
    assert told.curves == ()


def away_of(number, centre):
    """How far the zeros of a number of p and q are from p = c(q), as the checker finds it."""
    curve = SimpleNamespace(kind="flip", borders=(), window=None, axis=0, centre=centre)
    division = Division(curve, ("proved", "proved", "undecided"))
    division._beyond(number, [(fmpq(-1), fmpq(1))] * 2, 1)
    return float(division.far.upper())


def test_a_band_holds_all_zeros_of_its_number():
    # p = 0.3 + 0.5 q + rho, |rho| < 1/100, and a slope between 1 and 3
    space = space_of(2, 3)
    p, q = (space.variable(k, arb(0), arb(1)) for k in (0, 1))
    number = (p - arb("0.3") - q * arb("0.5") + arb(0, 0.01)) * 2
    assert 0.01 <= away_of(number, (0.3, 0.5)) < 0.0101
    steeper = number + p * p * p * arb("0.2")
    # at q = 1 the zeros of 2 (p - 0.8 - rho) + 0.2 p^3 are up to 0.052 away
    assert 0.052 < away_of(steeper, (0.3, 0.5)) < 0.08
    # its zero is at 0.8086; the slope falls from 1 amid the tile to 1/10 at its ends
    slower = p - p * p * p * arb("0.3") - arb("0.65")
    assert 0.9 - 0.8087 < away_of(slower, (0.9, 0.0)) < 0.4
    for bad in (number * 0 + p * p, -number):
        with pytest.raises(Failure, match="beside its band"):
            away_of(bad, (0.3, 0.5))


def test_borders_that_are_crossed_in_both_directions_have_no_verdict():
    borders = (Border("grazing", 0, "wall", "inside"),)
    curve = SimpleNamespace(
        kind="grazing", borders=borders, window=(arb(1), arb(2)), axis=0, centre=(0.0, 0.0)
    )
    division = Division(curve, ("proved", "undecided", "refuted"))
    for signs, wanted in (
        ({True}, ("unstable", "not admissible")), ({False}, ("not admissible", "unstable")),
    ):  # fmt: skip
        division.signs = signs
        assert division.verdicts(lambda point: pytest.fail("it is not asked")) == wanted
    division.signs = {True, False}
    with pytest.raises(Failure, match="in both directions"):
        division.verdicts(lambda point: pytest.fail("it is not asked"))

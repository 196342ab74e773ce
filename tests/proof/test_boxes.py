"""Proofs over boxes of parameters: true at every point that is looked at, and never too much."""

import json
import math
import time
from fractions import Fraction
from functools import cache

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import nonsmooth as ns
from nonsmooth import InputError
from nonsmooth.runtime.core.arithmetic import exact_ball
from tests.certified import accepted, interrupted, loop
from tests.explore import test_continuation_forced as impacts
from tests.tables import slow

STICK = "dry-friction/global-stick"
SYMMETRIC = "dry-friction/symmetric"
PROVED = dict.fromkeys(("existence", "admissibility", "stability"), "proved")


@cache
def paper():
    """Five percent around the paper's data."""
    box = {"V": ("0.95", "1.05"), "eta": ("0.95", "1.05")}
    return ns.certify.box(ns.solve(STICK), box)


@cache
def line():
    """Not admissible, unstable and stable along V: a grazing and a flip are in between."""
    return ns.certify.box(ns.solve(SYMMETRIC), {"V": ("0.6", "1.3")})


def test_the_paper_s_orbit_is_stable_for_all_parameters_around_its_data():
    found = paper()
    assert found.claims == PROVED
    assert found.proved
    assert found.decided == 1
    assert found.reasons == {}
    assert found.undecided == ()
    assert len(found.tiles) < 12
    assert -1 < found.enclosures["trace"].lower < found.enclosures["trace"].upper < -0.95
    one = ns.certify.box(ns.solve(STICK), {"V": ("0.99", "1.01"), "eta": ("0.99", "1.01")})
    assert one.claims == PROVED
    assert len(one.tiles) == 1


@settings(max_examples=12)
@given(speed=st.integers(950, 1050), eta=st.integers(950, 1050))
def test_enclosures_hold_the_refined_values_of_every_point(speed, eta):
    point = {"V": Fraction(speed, 1000), "eta": Fraction(eta, 1000)}
    orbit = ns.refine(ns.solve(STICK, {name: str(value) for name, value in point.items()}), 100)
    tile = paper().tile_at(point)
    for name, number in (("trace", orbit.trace), ("period", orbit.period),
                         *zip(orbit.dwell_time_names, orbit.dwell_times, strict=True)):  # fmt: skip
        for enclosures in (tile.enclosures, paper().enclosures):
            assert enclosures[name].ball.contains(exact_ball(number))


@pytest.mark.slow
def test_verdicts_along_a_line_are_those_of_the_points():
    found = line()
    branch = ns.continue_orbit(ns.solve(SYMMETRIC), "V", (0.6, 1.3))
    (grazing,) = [e.value for e in branch.events if e.kind == "grazing"]
    (flip,) = [e.value for e in branch.events if e.kind == "flip"]
    for value in (grazing, flip):
        assert found.tile_at({"V": value}).verdict == "undecided"
    assert found.decided > Fraction(999, 1000)
    assert found.claims == {"existence": "proved", "admissibility": "refuted",
                            "stability": "refuted"}  # fmt: skip
    for value in np.linspace(0.6, 1.3, 29):
        wanted = "not admissible" if value < grazing else "unstable" if value < flip else "proved"
        assert found.tile_at({"V": float(value)}).verdict in (wanted, "undecided")
        nearest = int(abs(branch.parameter_values - value).argmin())
        orbit = ns.solve(SYMMETRIC, {"V": float(value)}, branch.orbit_at(nearest).unknowns)
        assert bool(orbit.admissibility.verdict) == (wanted != "not admissible")
    assert sum(found.shares.values()) == 1
    assert "outside the unit circle" in found.reasons["stability"]


def test_closed_forms_over_boxes():
    # the period is pi/sqrt(k) + pi/2, the multiplier r, the speed at the start 1/(1 - r)
    found = ns.certify.box(loop(), {"k": ("0.9", "1.1"), "r": ("0.45", "0.55")})
    beside = ns.certify.box(loop(k="sqrt(2)"), {"r": ("0.45", "0.55")})
    for own, ends in ((found, (1.1, 0.9)), (beside, (math.sqrt(2), math.sqrt(2)))):
        assert own.proved
        trace, period, speed = (own.enclosures[name] for name in ("trace", "period", "v0"))
        assert trace.lower <= 0.45 < 0.55 <= trace.upper < trace.lower + 0.11
        shortest, longest = (math.pi / math.sqrt(k) + math.pi / 2 for k in ends)
        assert period.lower - 1e-14 <= shortest <= longest <= period.upper + 1e-14
        assert period.upper < longest + 0.02
        assert speed.lower <= 1 / 0.55 < 1 / 0.45 <= speed.upper


@pytest.mark.parametrize(("name", "parameter"), [
    ("rigid-stop/one-impact", "m1"), ("rigid-stop/one-impact", "k2"),
    ("elastic-stop/one-contact", "k3"),
])  # fmt: skip
def test_conservative_orbits_are_neutral_over_boxes(name, parameter):
    orbit = ns.solve(name)
    middle = orbit.given[parameter].exact
    box = {parameter: (middle * Fraction(999, 1000), middle * Fraction(1001, 1000))}
    found = ns.certify.box(orbit, box)
    assert found.proved
    assert found.stability == "neutral"
    for end in (*box[parameter], middle):
        trace = ns.solve(name, {parameter: str(end)}).trace
        assert found.enclosures["trace"].lower <= trace <= found.enclosures["trace"].upper


def test_a_given_period_may_span_the_box():
    orbit = ns.solve("rigid-stop/one-impact", {"T": "6"})
    found = ns.certify.box(orbit, {"T": ("5.9", "6.1")})
    assert found.proved
    period = found.enclosures["period"]
    assert period.lower <= 5.9
    assert 6.1 <= period.upper < 6.103


def test_forced_orbits_over_frequency_and_restitution():
    """An impact in each period of the forcing."""
    orbit = impacts.orbit(-0.3, 0.1)
    found = ns.certify.box(orbit, {"w": ("2.78", "2.82"), "r": ("0.79", "0.81")})
    assert found.proved, found.reasons
    period, trace = (found.enclosures[name] for name in ("period", "trace"))
    assert period.lower <= 2 * math.pi / 2.82 < 2 * math.pi / 2.78 <= period.upper
    guess = [*orbit.dwell_times, *orbit.states[0]]
    for w in ("2.78", "2.8", "2.82"):
        values = {**orbit.parameters, "w": w}
        near = ns.solve(orbit.system, values, guess, itinerary=orbit.itinerary)
        assert trace.lower <= near.trace <= trace.upper


@pytest.mark.slow
def test_states_are_kept_on_the_way(monkeypatch):
    """Ten seconds after the last one that was kept."""
    kept = []
    told = []

    def passed(*share):
        told.append(share)
        monkeypatch.setattr(time, "monotonic", lambda: 11.0 * len(told))

    monkeypatch.setattr(time, "monotonic", lambda: 0.0)
    box = {"V": ("0.6", "1.3")}
    ns.certify.box(ns.solve(SYMMETRIC), box, tiles=5, keep=kept.append, progress=passed)
    assert len(kept) == 5
    assert told == [(pytest.approx(float(x.decided)), k) for k, x in enumerate(kept, 1)]
    for state in kept:
        assert sum(state.shares.values()) == 1
    resumed = ns.certify.box(ns.solve(SYMMETRIC), box, resume=kept[2])
    once, again = (
        sorted(json.dumps(tile) for tile in found.to_json()["tiles"]) for found in (line(), resumed)
    )
    assert once == again


@pytest.mark.parametrize(("box", "told"), [
    ({}, "no parameter"),
    ({"W": ("0.9", "1.1")}, "did you mean|known"),
    ({"V": ("1.1", "0.9")}, "below the upper"),
    ({"V": ("1", "1")}, "below the upper"),
    ({"V": ("1.1", "1.2")}, "is not in"),
    ({"V": ("0.9", "sqrt(2)")}, "rational"),
    ({"V": (0.9, float("nan"))}, "nan"),
    ({"V": (0.9, float("inf"))}, "inf"),
    ({"chi": ("0.4", "1.5")}, "chi"),
])  # fmt: skip
def test_wrong_boxes_are_refused(box, told):
    orbit = ns.solve(STICK)
    with pytest.raises(InputError, match=told):
        ns.certify.box(orbit, box)


def test_wrong_states_and_counts_are_refused():
    orbit = ns.solve(STICK)
    box = {"V": ("0.95", "1.05"), "eta": ("0.95", "1.05")}
    with pytest.raises(InputError, match="tiles"):
        ns.certify.box(orbit, box, tiles=0)
    with pytest.raises(InputError, match="another box"):
        ns.certify.box(orbit, {"V": ("0.95", "1.05")}, resume=paper())
    with pytest.raises(InputError, match="another chi"):
        ns.certify.box(ns.solve(STICK, {"chi": "0.49"}), box, resume=paper())
    with pytest.raises(InputError, match="another orbit"):
        ns.certify.box(ns.solve(SYMMETRIC), {"V": ("0.6", "0.7")}, resume=paper())
    far = ns.solve(STICK, {"V": "40"}, throw=False)
    assert not far.converged
    with pytest.raises(InputError, match="cannot be certified"):
        ns.certify.box(far, {"V": ("30", "50")})


def test_an_orbit_without_exact_parameters_is_undecided():
    found = ns.certify.box(ns.solve("dry-friction/solution-ii"), {"V": ("0.9", "1.1")})
    assert found.claims == dict.fromkeys(PROVED, "undecided")
    assert "border collision" in found.reasons["existence"]
    assert found.decided == 0


@pytest.mark.parametrize("parameter", ["V", "eta", "chi"])
def test_narrow_boxes_show_the_derived_slope_of_the_trace(parameter):
    orbit = ns.solve(STICK)
    width = Fraction(1, 10**5)
    middle = orbit.given[parameter].exact
    found = ns.certify.box(orbit, {parameter: (middle - width, middle + width)})
    trace = found.enclosures["trace"]
    slope = abs(orbit.derivatives(parameter).trace[0])
    assert (trace.upper - trace.lower) / float(2 * width) == pytest.approx(slope, rel=0.02)


@pytest.mark.slow
def test_the_orbit_is_handed_on_from_its_own_point():
    # Newton's method from far away leads to other roots, which are none of this orbit
    for orbit, box in (
        (loop(), {"k": ("1/100", "100")}),
        (ns.solve(SYMMETRIC), {"V": ("0.2", "5")}),
        (loop(), {"k": ("1/100", "11/10"), "r": ("1/4", "3/4")}),
    ):
        found = ns.certify.box(orbit, box, tiles=20)
        tile = found.tile_at({name: orbit.given[name] for name in box})
        period = tile.enclosures["period"]
        assert period.lower <= float(orbit.period) <= period.upper
        for other in found.tiles:
            if other.verdict == "not admissible":
                assert "negative" not in other.reasons["admissibility"]
    wide = ns.certify.box(loop(), {"k": ("1/10", "10")}, tiles=100)
    # the period is pi/sqrt(k) + pi/2 wherever the orbit is proved
    for tile in wide.tiles:
        if tile.claims["existence"] == "proved" and tile.enclosures:
            ends = wide.where(tile)["k"]
            for k in ends:
                period = math.pi / math.sqrt(k) + math.pi / 2
                assert tile.enclosures["period"].lower <= period <= tile.enclosures["period"].upper
    assert wide.decided > Fraction(99, 100)


@pytest.mark.slow
def test_totals_do_not_grow_with_the_number_of_tiles():
    found = ns.certify.box(loop(), {"k": ("1/2", "2"), "a": ("1.9", "3.1")}, tiles=120)
    assert len(found.tiles) > 15
    period = found.enclosures["period"]
    proved = [t.enclosures["period"] for t in found.tiles if t.enclosures]
    assert min(x.lower for x in proved) - period.lower < 1e-4
    assert period.upper - max(x.upper for x in proved) < 1e-4


def test_open_parameters_are_large_enough_for_the_whole_box():
    found = ns.certify.box(ns.solve(STICK), {"e1": ("2.6", "5")})
    assert set(found.chosen) == {"us1", "us2"}
    tile = found.tile_at({"e1": "4.9"})
    assert ns.solve(STICK, {"e1": "4.9"}).admissibility.verdict
    assert tile.verdict == "proved"


def test_domains_hold_in_every_corner():
    for box in ({"r": ("-6", "0.9")}, {"k": ("-1", "1.1")}):
        with pytest.raises(InputError, match="domain"):
            ns.certify.box(loop(), box)


@pytest.mark.parametrize("width", [Fraction(1, 10**4), Fraction(1, 10**9)])
@pytest.mark.parametrize(
    ("name", "point", "axis"),
    [
        (SYMMETRIC, {"V": "391/500", "eta": "4319/1000"}, "V"),
        (STICK, {"V": "57/50", "eta": "96/125", "chi": "353/1000"}, "e1"),
    ],
)
def test_a_narrow_box_says_what_its_point_does_and_its_file_is_proved_again(
    name, point, axis, width, tmp_path
):
    orbit = ns.solve(name, point)
    middle = orbit.given[axis].exact
    ends = (str(middle * (1 - width)), str(middle * (1 + width)))
    found, alone = ns.certify.box(orbit, {axis: ends}, tiles=1), ns.certify(orbit)
    (tile,) = found.tiles
    assert tile.claims == alone.claims
    for text, enclosure in alone.enclosures.items():
        assert tile.enclosures[text].lower < enclosure.lower
        assert enclosure.upper < tile.enclosures[text].upper
    accepted(found, tmp_path)


def asked(**more):
    """A map of a few tiles, some of which are not looked at."""
    return ns.certify.box(ns.solve(SYMMETRIC), {"V": ("0.6", "1.3")}, **{"tiles": 5, **more})


@cache
def lines():
    return interrupted(asked, ("certify_box.py",), {"look", "stated"})[0]


@pytest.mark.parametrize("share", [0.01, 0.7, *(slow(x) for x in (0.0, 0.3, 0.95, 0.99))])
def test_an_interruption_anywhere_leaves_tiles_that_fill_the_box(share, tmp_path):
    """Also in the check that ends a map, which asks about tiles that were not looked at."""
    _, state = interrupted(asked, ("certify_box.py",), {"look", "stated"}, share * lines())
    assert sum(tile.place.share for tile in state.tiles) == 1
    state.save(tmp_path / "map.json")
    read = ns.load(tmp_path / "map.json")
    assert len(asked(resume=read, tiles=7).tiles) > len(read.tiles)

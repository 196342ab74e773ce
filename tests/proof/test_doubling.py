"""Beyond a flip: the side and verdict of doubled orbits, against differences and the integrator."""

from dataclasses import replace

import numpy as np
import pytest
from flint import arb

import nonsmooth as ns
from nonsmooth import InputError, Interrupted
from nonsmooth.runtime.checker.ranges.branch import curve_of
from nonsmooth.runtime.checker.ranges.doubling import DoubledEquations
from nonsmooth.runtime.core.taylor_models import TaylorModel, space_of
from nonsmooth.runtime.core.values import flint_precision
from tests.certified import accepted, content_of
from tests.explore import test_continuation_forced as impacts
from tests.pictures import legend_of

pytestmark = pytest.mark.compiled  # much slower without it


@pytest.fixture(scope="module")
def branch():
    return ns.continue_orbit(ns.solve("dry-friction/symmetric", {"V": "1.08"}), "V", (1.07, 1.09))


@pytest.fixture(scope="module")
def found(branch):
    return ns.certify.doubling(branch, tiles=3)


@pytest.mark.slow
def test_the_papers_flip_is_subcritical(found):
    doubling = found.doubled
    assert found.claims == {"doubling": "proved"}
    assert (found.kind, doubling.side, doubling.verdict) == ("subcritical", "above", "unstable")
    assert str(found.flip.enclosures["V"]).startswith("[1.0805880741771120197670640")
    assert [len(each.branch.itinerary) for each in (found, doubling)] == [2, 4]
    assert "subcritical" in found.statement
    left = replace(doubling, verdict="undecided", reason="not known")
    assert replace(found, doubled=left).claims == {"doubling": "undecided"}
    unknown = [replace(tile, before="unstable", after="unstable") for tile in found.branch.tiles]
    assert replace(found, branch=replace(found.branch, tiles=tuple(unknown))).kind == ""
    away = doubling.branch.tiles  # followed from the other end, orbits are proved as far
    back = tuple(replace(tile, forwards=not tile.forwards) for tile in away[::-1])
    turned = replace(doubling.branch, tiles=back, start=len(back))
    assert replace(found, doubled=replace(doubling, branch=turned)).statement == found.statement


@pytest.mark.slow
def test_doubled_orbits_by_newton_are_where_the_rate_says(branch, found):
    """In floating point: V - V0 over a^2 tends to the rate, and the multiplier passes 1."""
    doubling = found.doubled
    event = next(event for event in branch.events if event.kind == "flip")
    flip = float(found.flip.enclosures["V"])
    place = found.doubled.branch.unknown_names.index(doubling.scaled)
    doubled = ns.continue_orbit(branch.switch(event), "V", (flip, 1.085))
    rates = []
    for number in range(len(doubled)):
        orbit = doubled.orbit_at(number)
        value = float(orbit.parameters["V"])
        if value < flip + 1e-4:
            continue
        assert max(abs(orbit.multipliers)) > 1
        a = float(orbit.states[0][place] - orbit.states[2][place]) / 2
        rates.append((a * a, (value - flip) / (a * a)))
    squares, quotients = np.array(sorted(rates)).T
    assert len(squares) > 3
    assert np.polyfit(squares, quotients, 2)[-1] == pytest.approx(float(doubling.rate), rel=1e-4)


@pytest.mark.slow
def test_motions_leave_the_unstable_doubled_orbit_and_settle_on_the_stable_one(found):
    """Just above the flip the orbit is stable; inside the doubled ones motions return to it."""
    orbit = ns.solve("dry-friction/symmetric", {"V": "1.083"})
    tables = orbit.problem.by_tables(orbit, {"us1": 1, "us2": 1})
    start = [float(x) for x in tables.states[0]]
    start[1] += 0.02
    motion = ns.simulate(
        "dry-friction", tables.parameters, start, tables.itinerary[0][0], transitions=400
    )
    itinerary, dwell, _ = ns.itinerary_of(motion)
    assert len(itinerary) == 2
    assert sum(dwell) == pytest.approx(float(tables.period), rel=1e-6)


@pytest.mark.parametrize("place", [0, 0.25])
def test_derivatives_of_the_doubled_equations_are_those_of_differences(found, place):
    """At the flip, and a quarter of the way to the largest amplitude."""
    doubled = content_of(found)["doubled"]
    curve = curve_of(content_of(found.branch))
    equations = DoubledEquations(curve, curve.declared.unknowns.index(doubled["scaled"]))
    step, e = arb(2) ** -20, [arb(place)]
    with flint_precision(128):
        amplitude = space_of(1, 5).variable(0, arb(0), arb(1) / 20)
        middles = [arb(row[0]) for row in doubled["centre"]]
        _, told = equations.at(amplitude, middles)
        for column in range(len(middles)):
            moved = [x + step if k == column else x for k, x in enumerate(middles)]
            back = [x - step if k == column else x for k, x in enumerate(middles)]
            rise = equations.at(amplitude, moved)[0] - equations.at(amplitude, back)[0]
            for row, change in enumerate(rise.entries()):
                slope, own = (
                    x.at(e).mid() if isinstance(x, TaylorModel) else x.mid()
                    for x in (change, told[row, column])
                )
                assert abs(slope / (2 * step) - own) < 1e-5, (row, column)


@pytest.mark.slow
def test_time_and_an_interruption_along_the_doubled_branch_keep_what_is_proved(
    branch, found, tmp_path
):
    short = ns.certify.doubling(branch, tiles=3, seconds=1e-6)
    assert (short.ended, short.claims) == ("unfinished", {"doubling": "undecided"})
    assert "s that were given are over" in short.end
    assert len(short.branch.tiles) == 1
    shares = []

    def stop(share, tiles):
        shares.append(share)
        if share > 0.6:  # beyond the tube
            raise KeyboardInterrupt

    with pytest.raises(Interrupted) as stopped:
        ns.certify.doubling(branch, tiles=3, progress=stop, resume=short)
    part = stopped.value.partial
    assert shares == sorted(shares)
    assert part.ended == "unfinished"
    assert 0 < len(part.doubled.branch.tiles) < 3
    assert accepted(part, tmp_path).claims == {"doubling": "proved"}
    whole = ns.certify.doubling(branch, tiles=3, resume=ns.load(tmp_path / "found.json"))
    assert (whole.ended, whole.end) == ("complete", "")
    assert whole.kind == found.kind
    assert len(whole.doubled.branch.tiles) > len(part.doubled.branch.tiles)


def test_an_interval_that_does_not_reach_the_flip_has_none(branch):
    event = next(event for event in branch.events if event.kind == "flip")
    begun = float(branch.parameter_values[round(event.place)])
    between = (begun + event.value) / 2
    ends = (between, "1.09") if begun > event.value else ("1.07", between)
    found = ns.certify.doubling(branch, interval=ends)
    assert (found.ended, found.end) == ("no flip", "no flip is proved on the branch")
    assert (found.flip, found.kind, found.claims) == (None, "", {"doubling": "undecided"})


def test_it_is_drawn_with_the_branch_and_beside_the_flip(found):
    pytest.importorskip("matplotlib")
    (axes,) = found.plot().axes
    assert axes.get_title(loc="left") == "dry-friction/symmetric"
    assert "flip, enclosed" in legend_of(axes)
    assert any("twice the period" in label for label in legend_of(axes))
    with pytest.raises(InputError):
        found.plot("tau9")


@pytest.mark.parametrize(
    "words",
    [
        {"flip": 2},
        {"tiles": True},
        {"seconds": 0},
        {"interval": ("1.2", "1")},
        {"resume": 3},
        {"resume": "found", "interval": ("1", "1.1")},
    ],
)
def test_wrong_questions_are_refused(branch, found, words):
    words = {name: found if value == "found" else value for name, value in words.items()}
    with pytest.raises(InputError):
        ns.certify.doubling(branch, **words)
    with pytest.raises(InputError):
        ns.certify.doubling(branch.orbit, **words)


@pytest.mark.slow
def test_each_of_two_doublings_of_impacts_is_asked_for_by_itself(tmp_path):
    """The first flip in closed form; the second on the branch to which the first one leads."""
    branch = ns.continue_orbit(impacts.orbit(-0.05), "sigma", (-0.1, -0.032))
    flips = []
    for impacted, ends in ((1, ("-0.07", "-0.032")), (2, ("-0.034", "-0.0325"))):
        found = ns.certify.doubling(branch, interval=ends, tiles=60)
        assert (found.claims, found.kind) == ({"doubling": "proved"}, "supercritical"), found.end
        assert [len(each.branch.itinerary) for each in (found, found.doubled)] == [
            impacted,
            2 * impacted,
        ]
        flips.append(float(found.flip.enclosures["sigma"]))
        assert accepted(found, tmp_path).claims == {"doubling": "proved"}
        event = next(event for event in branch.events if event.kind == "flip")
        branch = ns.continue_orbit(branch.switch(event), "sigma", (flips[0] + 1e-4, -0.03))
    assert flips[0] == pytest.approx(impacts.closed_forms()[1], abs=1e-12)
    # the exact motion between the two flips strikes twice before it comes back
    orbit = impacts.orbit()
    sigma = sum(flips) / 2
    start = [sigma, *(float(x) for x in orbit.states[0][1:])]
    given = {**orbit.parameters, "sigma": str(sigma)}
    motion = ns.simulate(orbit.system, given, start, "free", transitions=600)
    itinerary, dwell, _ = ns.itinerary_of(motion)
    assert len(itinerary) == 2
    assert abs(float(dwell[0]) - float(dwell[1])) > 1e-3

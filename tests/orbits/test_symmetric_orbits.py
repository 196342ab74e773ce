"""Orbits that a symmetry closes after a part, and phases that end on several boundaries."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from nonsmooth import InputError, simulate, solve
from tests.handmade import DATA, MIRROR, box, pair, two_stops

RIGHT = [("free", "reaches-right")]
BOTH = [*RIGHT, ("free", "reaches-left")]
BROKEN = {**DATA, "Omega": "1.48"}  # beyond the pitchfork
TURN = {"x": "y", "y": "-x", "v": "w", "w": "-v", "c": "s", "s": "-c"}


@cache
def half(digits=15):
    return solve(two_stops(), DATA, [1.85], itinerary=RIGHT, symmetry=MIRROR, digits=digits)


@cache
def broken():
    """Both of a pair of orbits that are each other's mirror image, and the one between them."""
    motion = simulate(two_stops(), BROKEN, [0, 0.3, 1, 0], transitions=600)
    start, dwell = motion.states[-3], np.diff(motion.times[-3:])
    phases = BOTH if start[0] < 0 else BOTH[::-1]
    one = solve(two_stops(), BROKEN, [*dwell, *start], itinerary=phases)
    other = solve(two_stops(), BROKEN, [*dwell, *-start], itinerary=phases[::-1])
    between = solve(two_stops(), BROKEN, [np.pi / 1.48], itinerary=RIGHT, symmetry=MIRROR)
    return one, other, between


def test_half_of_an_orbit_is_the_whole():
    orbit = half()
    whole = solve(two_stops(), DATA, [*orbit.dwell_times, *orbit.states[0]], itinerary=BOTH)
    assert orbit.converged
    assert orbit.itinerary == whole.itinerary == tuple(BOTH)
    np.testing.assert_allclose(orbit.dwell_times, whole.dwell_times, rtol=0, atol=1e-13)
    np.testing.assert_allclose(orbit.states, whole.states, rtol=0, atol=1e-13)
    np.testing.assert_allclose(orbit.states[1], -orbit.states[0], rtol=0, atol=0)
    assert orbit.period == pytest.approx(2 * np.pi / 1.7, rel=1e-14)
    assert orbit.admissibility.verdict is True
    assert orbit.stability.verdict == "stable"


def test_multipliers_are_squares_of_the_half_maps():
    orbit = half()
    part = [complex(m.real, m.imaginary) for m in orbit.part_stability.multipliers]
    squares = sorted((m**2 for m in part), key=lambda m: m.imag)
    np.testing.assert_allclose(
        squares, sorted(orbit.multipliers, key=lambda m: m.imag), rtol=0, atol=1e-13
    )
    # an impact multiplies areas by r^2, damping by exp(-2 zeta t)
    area = 0.8**4 * np.exp(-0.1 * orbit.period)
    assert np.prod(orbit.multipliers) == pytest.approx(area, rel=1e-12)


def test_forty_digits_and_their_symmetry():
    orbit, rough = half(40), half()
    pi = orbit.arithmetic.mp.pi
    assert abs(orbit.period - 2 * pi / orbit.arithmetic.mp.mpf("1.7")) < 1e-40
    assert abs(orbit.states[0, 0] + 0.5) < 1e-40
    assert all(abs(x + y) == 0 for x, y in zip(*orbit.states, strict=True))
    assert abs(orbit.trace - rough.trace) < 1e-13
    again = solve(
        two_stops(), DATA, [*rough.dwell_times, *rough.states[0]], itinerary=BOTH, digits=40
    )
    difference = (orbit.states - again.states).ravel()
    assert max(abs(x) for x in difference) < 1e-40


def test_a_pair_of_orbits_without_the_symmetry():
    one, other, between = broken()
    assert one.converged
    assert other.converged
    assert between.converged
    first, second = one.dwell_times
    assert abs(first - second) > 0.1 * one.period
    np.testing.assert_allclose(one.states, -other.states, rtol=0, atol=1e-11)
    np.testing.assert_allclose(np.sort(one.multipliers), np.sort(other.multipliers), atol=1e-10)
    assert one.stability.verdict == other.stability.verdict == "stable"
    # the symmetric one has lost its stability by a multiplier -1 of the half map
    assert between.stability.verdict == "unstable"
    least = min(m.real for m in between.part_stability.multipliers)
    assert least < -1
    assert min(m.real for m in half().part_stability.multipliers) > -1
    for orbit in (one, other, between):
        assert orbit.admissibility.verdict is True
        assert orbit.period == pytest.approx(2 * np.pi / 1.48, rel=1e-13)


def test_a_quarter_of_an_orbit():
    # x and y are each a mass between two stops, a quarter of a period apart
    orbit = solve(box(), DATA, [0.92], itinerary=[("free", "right")], symmetry=TURN)
    assert orbit.converged
    assert [boundary for _, boundary in orbit.itinerary] == ["right", "up", "left", "down"]
    np.testing.assert_allclose(orbit.dwell_times, np.pi / 2 / 1.7, rtol=1e-13)
    place = [name for _, name in orbit.itinerary].index("left") + 1
    single = half()
    np.testing.assert_allclose(
        orbit.states[place][[0, 2, 4, 5]], single.states[0], rtol=0, atol=1e-12
    )
    part = [complex(m.real, m.imaginary) ** 4 for m in orbit.part_stability.multipliers]
    np.testing.assert_allclose(np.sort(part), np.sort(orbit.multipliers), atol=1e-12)
    wanted = np.sort_complex(np.repeat(single.multipliers, 2))
    np.testing.assert_allclose(np.sort_complex(np.round(orbit.multipliers, 10)), wanted, atol=1e-9)


def test_a_given_period_is_that_of_the_whole_orbit():
    orbit = solve(
        two_stops(),
        DATA,
        [1.85],
        itinerary=RIGHT,
        symmetry=MIRROR,
        given={"period": "2*pi/1.7"},
        digits=20,
    )
    assert orbit.converged
    assert abs(orbit.period - 2 * orbit.arithmetic.mp.pi / orbit.arithmetic.mp.mpf("1.7")) < 1e-20


def test_the_motion_along_a_symmetric_orbit():
    orbit = half()
    motion = orbit.trajectory(2)
    times = np.linspace(0, orbit.period / 2, 9)
    np.testing.assert_allclose(motion(times), -motion(times + orbit.period / 2), atol=1e-12)
    assert motion.boundaries[1:] == (("reaches-right",), ("reaches-left",)) * 2


def test_an_unstable_orbit_is_not_left():
    between = broken()[2]
    motion = between.trajectory(200)
    np.testing.assert_array_equal(motion.states[-1], between.states[0])


@pytest.mark.parametrize(
    ("symmetry", "match"),
    [
        ({}, "identity"),
        ({"x": "-x"}, "no configuration is the image of free"),
        ({"x": "-x", "v": "-v"}, "no configuration is the image of free"),
        ({"x": "-z"}, "no state"),
        ({"z": "-x"}, "unknown state 'z'"),
        ({"x": "v"}, "permutation"),
        ({"x": "--x"}, "no state"),
        ({"x": "s", "s": "x"}, "takes the forcing"),
        (np.zeros((4, 4)), "permutation"),
        (np.eye(3), "4 x 4"),
        (2 * np.eye(4), "4 x 4"),
    ],
)
def test_what_is_no_symmetry(symmetry, match):
    with pytest.raises(InputError, match=match):
        solve(two_stops(), DATA, [1.85], itinerary=RIGHT, symmetry=symmetry)


def test_a_matrix_says_the_same():
    orbit = solve(two_stops(), DATA, [1.85], itinerary=RIGHT, symmetry=-np.eye(4))
    np.testing.assert_array_equal(orbit.states, half().states)


def altered(system, rows):
    """The system with another restitution in some rows of its resets."""
    good = system.module.resets

    def resets(p, lib):
        other = good([*p[:2], 0.5, *p[3:]], lib)
        return [other[k] if k in range(*rows.indices(len(other))) else row
                for k, row in enumerate(good(p, lib))]  # fmt: skip

    system.module.resets = resets
    return system


@pytest.mark.parametrize(
    ("system", "boundary", "digits", "match"),
    [
        (lambda: two_stops(1e-9), "reaches-right", 15, "no configuration is the image"),
        (lambda: two_stops(1e-14), "reaches-right", 15, ""),
        (lambda: two_stops(1e-14), "reaches-right", 30, "no configuration is the image"),
        (lambda: altered(two_stops(), slice(8, None)), "reaches-right", 15,
         "transitions do not follow"),
        (pair, "right+up", 15, ""),
        (lambda: altered(pair(), slice(-6, None)), "right+up", 15,
         r"right\+up and left\+down.* in different ways"),
    ],
)  # fmt: skip
def test_stops_and_resets_have_to_follow_a_symmetry(system, boundary, digits, match):
    made = system()
    mirror = {name: f"-{name}" for name in made.table["states"]}
    options = {"itinerary": [("free", boundary)], "symmetry": mirror, "digits": digits}
    if not match:
        assert solve(made, DATA, [1.85], **options).converged
        return
    with pytest.raises(InputError, match=match):
        solve(made, DATA, [1.85], **options)


def test_only_a_part_has_a_part():
    with pytest.raises(InputError, match="from a part"):
        _ = broken()[0].part_stability


# --- several boundaries at one instant


@cache
def together(boundary="right+up"):
    single = half()
    start = [*np.repeat(single.states[0][:2], 2), *single.states[0][2:]]
    phases = [("free", boundary), ("free", ("left", "down"))]
    return solve(pair(), DATA, [*single.dwell_times, *start], itinerary=phases)


@pytest.mark.parametrize("boundary", ["right+up", ("up", "right")])
def test_boundaries_that_are_reached_together(boundary):
    orbit = together(boundary)
    assert orbit.converged
    np.testing.assert_allclose(orbit.states[:, [0, 2, 4, 5]], half().states, atol=1e-12)
    np.testing.assert_allclose(orbit.states[:, [1, 3, 4, 5]], half().states, atol=1e-12)
    assert orbit.admissibility.verdict is True
    assert orbit.stability.verdict == "undecided"  # a perturbation separates them
    assert orbit.trajectory().boundaries[1:] == (("right", "up"), ("left", "down"))


def test_boundaries_that_are_not_reached_together_after_all():
    orbit = together()
    later = replace(orbit, starts=orbit.states - np.array([0, 1e-3, 0, 0, 0, 0]))
    violations = {(v.phase, v.boundary) for v in later.admissibility.violations}
    assert later.admissibility.verdict is False
    assert (0, "up") in violations


@pytest.mark.parametrize(
    ("boundary", "match"),
    [
        ("right+down", "no transition"),
        ("right+nowhere", "unknown boundary"),
        (("right", 3), "itinerary takes"),
    ],
)
def test_sets_without_a_transition(boundary, match):
    with pytest.raises(InputError, match=match):
        solve(pair(), DATA, [1.0], itinerary=[("free", boundary)])

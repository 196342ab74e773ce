"""Counted orbits: none is missed, none counts twice, and what cannot be told is undecided."""

import json
import math
from dataclasses import replace
from functools import cache
from itertools import product
from types import SimpleNamespace

import mpmath
import numpy as np
import pytest
import sympy as sp
from flint import arb, arb_mat

import nonsmooth as ns
from nonsmooth import InputError
from nonsmooth.derive import SecondOrder, Transition
from nonsmooth.runtime.checker.counting.census import Counting
from nonsmooth.runtime.checker.counting.contraction import (
    Linear,
    balls_of,
    contract,
    floats_around,
    middles_of,
)
from nonsmooth.runtime.checker.counting.covering import CoveringBox, Walk
from nonsmooth.runtime.core.values import flint_precision
from tests.certified import LOOP, between_springs, content_of, interrupted, kicked
from tests.cli.test_cli import run
from tests.friction_sets import DATA
from tests.places import GALLERY
from tests.proof.test_fold_curves import fold_at, velocities
from tests.tables import slow

STICK = "dry-friction/global-stick"
BELT = f"{GALLERY / 'mass_on_belt.py'}:stick-slip"
IMPACT = f"{GALLERY / 'impact_oscillator.py'}:one-period"
COUNT = "certify", "all"
TWO = [("slip-slip", "second-reaches-belt"), ("slip-stick", "second-breaks-forward")]


def times(census):
    """Certified dwell times, an orbit in each row."""
    certificates = [orbit.certificate for orbit in census.orbits]
    return np.array([[float(c.enclosures[n]) for n in c.dwell_names] for c in certificates])


def over(centre, slopes, sides, largest=0.0):
    """Equations with an enclosure by the mean value theorem."""
    pairs = zip(balls_of(sides), middles_of(sides), strict=True)
    found, offsets = centre, [ball - middle for ball, middle in pairs]
    for slope, offset in zip(slopes, offsets, strict=True):
        found = found + slope * offset
    return Linear(centre, tuple(slopes), found, offsets, arb(largest))


def test_a_root_is_unique_only_inside_the_very_numbers_of_a_box():
    """Not in the balls around its sides, which are wider by roundings."""
    random, seen = np.random.default_rng(2), set()
    for _ in range(40):
        low, width = random.uniform(0.1, 1, 2)
        (low, high), ulps = (low, low + width), int(random.integers(-60, 60))
        for end, into in ((low, 1), (high, -1)):
            root = end + ulps * math.ulp(end) * 4096
            linear = over(
                arb_mat([[middles_of(((low, high),))[0] - root]]), [arb_mat([[1]])], ((low, high),)
            )
            found = contract(linear, [], ((low, high),))
            assert found.unique == (ulps * into > 0)
            seen.add((found.unique, found.empty))
            assert contract(replace(linear, trivial=True), [], ((low, high),)) is None
    assert {(True, False), (False, False)} <= seen


def test_that_there_are_not_two_roots_takes_slopes_between_any_two_points():
    """Those from the middle tell of a root, and not that it is the only one."""

    def linear(sides, *, between=False):
        return over(arb_mat([[0]]), [arb_mat([[arb(1, 2 * between)]])], sides)

    box = CoveringBox(SimpleNamespace(linear=linear), ((-1.0, 1.0),))
    assert (box.image.unique, box.unique) == (True, False)


class Line:
    """The equations q (1 + u) = u + size and u = 0, which have the root u = 0, q = size."""

    domain = ((-0.25, 0.5),)

    def __init__(self, size):
        self.size = arb(size)

    def linear(self, sides, *, between=False):
        """Rows [1 + u, -u - size] and [0, u] on (q, 1), where no larger q than 1 is asked for."""
        (m,) = middles_of(sides)
        centre = arb_mat([[1 + m, -m - self.size], [arb(0), m]])
        return over(centre, [arb_mat([[1, -1], [0, 1]])], sides, 1.0)


def test_a_root_that_is_a_little_too_large_is_not_polished_away():
    """It keeps the coordinate that it has: neither another box nor one that is asked for."""
    equations = Line("1.00001")
    with flint_precision(64):
        found = CoveringBox(equations, ((-0.001, 0.0015),)).root
        (low, high), (q,) = found.sides[0], found.coordinates
        assert low <= 0 <= high
        assert q.contains(arb("1.00001"))
        assert q > 1
        # as sharply as any other one
        far = Line("1.5")
        wide = CoveringBox(far, ((-0.001, 0.0015),))
        rough = SimpleNamespace(sides=wide.sides, unique=wide.sides, coordinates=[arb("1.5 +/- 1")])
        (side,) = wide._polished(rough).sides
        assert side[0] <= 0 <= side[1] < side[0] + 1e-12


def test_of_two_roots_that_may_be_one_the_surer_is_kept():
    """With more equations than unknowns the one in whose box the other lies may exist alone."""
    small = SimpleNamespace(sides=((0.1, 0.2),), unique=((0.05, 0.25),))
    large = SimpleNamespace(sides=((0.3, 0.4),), unique=((0.0, 0.5),))
    for roots in ((small, large), (large, small)):
        equations = Line("1")
        walk = Walk(equations)
        for root in roots:
            walk._add(root)
        assert (walk.roots, walk.left) == ([large], [])


@pytest.mark.slow
def test_all_orbits_of_the_paper_in_a_box():
    """And those of them whose last dwell time, which follows, is bounded too."""
    told = []
    box = {"tau": 3, "tau1": 10}
    census = ns.certify.all(STICK, box=box, progress=told.append)
    assert census.decided
    assert f"exactly {len(census.orbits)} orbits" in census.statement
    assert told == sorted(told)
    assert 0 < told[-1] <= 1 + 1e-9
    (admissible,) = (o.certificate for o in census.orbits if o.admissible)
    assert admissible.enclosures["tau"].contains(ns.refine(ns.solve(STICK), 30).unknowns["tau"])
    bounded = ns.certify.all(STICK, box={**box, "ta": (1, 2)})
    assert bounded.decided
    (inside,) = (row for row in times(census) if 1 <= row[0] <= 2)
    np.testing.assert_allclose(times(bounded), [inside], atol=1e-12)


def test_its_four_dwell_times_give_the_same_orbit():
    orbit = ns.solve(STICK)
    box = {"tau1": (1, "1.1"), "tau2": ("1.9", "2.1"), "tau3": ("1.4", "1.6"), "tau4": (3, "3.5")}
    census = ns.certify.all("dry-friction", DATA, box, itinerary=orbit.itinerary)
    assert census.decided
    assert np.allclose(times(census), [orbit.dwell_times.tolist()], atol=1e-10)
    assert census.admissible == 1


def test_a_kicked_mass_has_an_orbit_for_each_pair_of_half_turns():
    # v returns after m half turns on the right and n on the left, whatever m and n are
    values = {"k": 9, "r": "1/3", "a": 10}
    box = {"tau1": "2.5", "tau2": "4"}  # half turns take pi/3 and pi/2
    census = ns.certify.all(kicked(), values, box, itinerary=LOOP)
    assert census.decided
    exact = [(m * math.pi / 3, n * math.pi / 2) for m in (1, 2) for n in (1, 2)]
    assert np.allclose(sorted(map(tuple, times(census))), exact, atol=1e-12)
    assert census.admissible == 1
    # of sqrt(81) it is not known that it is 9: the entries are functions of it
    rough = ns.certify.all(kicked(), {**values, "k": "sqrt(81)"}, box, itinerary=LOOP)
    assert rough.decided
    assert (rough.count, rough.admissible) == (4, 1)


def test_an_orbit_counts_once_wherever_it_begins():
    # half turns on the right take pi/3, m1 and m2 of them, those on the left pi/2, one each:
    # (1, 2) and (2, 1) are one orbit, (1, 1) and (2, 2) are orbits of half the itinerary
    box = {"tau1": (1, "2.2"), "tau2": ("1.5", "1.6"), "tau3": (1, "2.2"), "tau4": ("1.5", "1.6")}
    values = {"k": 9, "r": "1/3", "a": 10}
    census = ns.certify.all(kicked(), values, box, itinerary=LOOP * 2)
    assert census.decided
    (found,) = times(census)
    assert np.allclose(sorted(found), [math.pi / 3, *[math.pi / 2] * 2, 2 * math.pi / 3])
    assert "repeat themselves" in census.statement


def test_the_mass_on_a_belt_turns_any_number_of_times():
    census = ns.certify.all(BELT, box={"ts": 10, "tau": 20})
    exact = [(1.2, 2 * math.pi * m - 2 * math.atan(0.3 / 0.5)) for m in (1, 2, 3)]
    assert census.decided
    assert np.allclose(sorted(map(tuple, times(census))), exact, atol=1e-12)
    assert census.admissible == 1
    assert ns.certify.all(BELT, box={"ts": 10, "tau": 5}).statement.count("exactly 0 orbits") == 1


@pytest.mark.parametrize(
    ("stick", "count", "undecided"),
    [((1, 2), 1, 0), (("1.2", 2), 0, 1), (("1.20000001", 2), 0, 0), ((1, "1.2"), 0, 1)],
)
def test_a_solution_on_the_edge_is_never_counted(stick, count, undecided):
    census = ns.certify.all(BELT, box={"ts": stick, "tau": (4, 6)})
    assert (census.count, len(census.undecided)) == (count, undecided)
    for box in census.undecided:
        assert "edge" in box.reason
        low, high = map(float, box.bounds["tau"])
        assert low <= 2 * math.pi - 2 * math.atan(0.3 / 0.5) <= high


def test_phases_of_no_time_are_told_apart_by_the_default_bound_only():
    # after a whole turn it slips again at once: a solution with ts = 0 at tau = 2 pi
    whole = ns.certify.all(BELT, box={"ts": (0, 10), "tau": (6, 7)})
    assert whole.count == 0
    assert len(whole.undecided) == 1
    assert "at least 0" in whole.statement
    assert ns.certify.all(BELT, box={"ts": 10, "tau": (6, 7)}).decided


@pytest.mark.parametrize("sigma", ["0", "0.3", "-0.7", "4"])
def test_an_impact_oscillator_has_two_orbits_of_each_period_or_none(sigma):
    census = ns.certify.all(IMPACT, {"sigma": sigma}, {"T": 13})
    exact = [(k, u) for k in range(1, 5) for u in velocities(float(sigma), 0.8, k)]
    assert census.decided
    assert census.count == len(exact)
    period = 2 * math.pi / 2.4
    certificates = [orbit.certificate for orbit in census.orbits if orbit.certificate]
    found = sorted(
        (round(float(c.enclosures["T"]) / period), -float(c.enclosures["v0"]) / 0.8)
        for c in certificates
    )
    assert np.allclose(found, [(k, float(u)) for k, u in exact], atol=1e-10)


def test_where_two_orbits_meet_nothing_is_counted():
    with mpmath.workdps(40):
        fold, shift = -fold_at(mpmath.mpf("0.8")), mpmath.mpf("1e-6")
        below, at, above = (
            ns.certify.all(IMPACT, {"sigma": mpmath.nstr(fold + k * shift, 30)}, {"T": (2, 3)})
            for k in (-1, 0, 1)
        )
    assert (below.count, below.decided) == (2, True)
    assert (at.count, at.decided) == (0, False)
    assert (above.count, above.decided) == (0, True)
    (box,) = at.undecided
    assert "singular" in box.reason


def drawn(seed):
    """A mass between two springs of random numbers, kicked where it rises; and its numbers.

    They are a stiffness, damping and load on each side, and the kick v -> r v + a.
    """
    random = np.random.default_rng(seed)
    lows, highs = (30, 0, -60, 30, 0, -60, 20, 50), (300, 30, 60, 300, 30, 60, 90, 200)
    numbers = [sp.Rational(int(n), 100) for n in random.integers(lows, highs)]
    k, c, load, other, loss, pull, r, a = numbers
    v = sp.Symbol("v", real=True)
    sides = (
        SecondOrder([[1]], [[k]], [load], [[c]]),
        SecondOrder([[1]], [[other]], [pull], [[loss]]),
    )
    kick = Transition("left", {"rises"}, "right", (), {v: r * v + a})
    system = between_springs(f"drawn-{seed}", sides, [kick])
    return system, [float(number) for number in numbers]


def by_brute_force(numbers, longest):
    """How many cycles there are: Newton's method in doubles from many starts, and roots apart."""
    *sides, r, a = numbers

    def passed(side, time, speed):
        stiffness, damping, load = side
        at, rate = load / stiffness, np.emath.sqrt(damping**2 / 4 - stiffness)
        swing, decay = np.sinh(rate * time) / rate, np.exp(-damping / 2 * time)
        still = np.cosh(rate * time) + damping / 2 * swing
        position = at - decay * (at * still - speed * swing)
        velocity = decay * (at * stiffness * swing + speed * (still - damping * swing))
        return position.real, velocity.real

    def residual(unknowns):
        first, second, speed = unknowns
        position, velocity = passed(sides[:3], first, speed)
        end, back = passed(sides[3:], second, velocity)
        return np.array([position / first, end / second, r * back + a - speed])

    grid = np.linspace(0.1, longest, 16)
    found = np.array([axis.ravel() for axis in np.meshgrid(grid, grid, np.linspace(-9, 9, 13))])
    for _ in range(40):
        value, step = residual(found), 1e-7
        slopes = [(residual(found + step * e[:, None]) - value) / step for e in np.eye(3)]
        jacobian = np.array(slopes).transpose(2, 1, 0)
        regular = np.abs(np.linalg.det(jacobian)) > 1e-12
        moved = np.linalg.solve(jacobian[regular], -value[:, regular].T[..., None])[..., 0].T
        found = found[:, regular] + np.clip(moved, -1, 1)
        found = found[:, (found[:2] > 0.01).all(axis=0) & (found[:2] < 2 * longest).all(axis=0)]
    found = found[:, (np.abs(residual(found)) < 1e-9).all(axis=0)]
    inside = np.round(found[:, (found[:2] <= longest).all(axis=0)], 6)
    roots = []
    for one in np.unique(inside, axis=1).T:
        if all(np.abs(one - other).max() > 1e-4 for other in roots):
            roots.append(one)
    return len(roots)


@pytest.mark.parametrize("seed", range(6))
def test_small_systems_have_as_many_orbits_as_brute_force_finds(seed):
    system, numbers = drawn(seed)
    census = ns.certify.all(system, {}, {"tau1": 6, "tau2": 6}, itinerary=LOOP)
    assert census.decided
    assert census.count == by_brute_force(numbers, 6.0)


def test_conservative_orbits_are_counted_at_their_period():
    census = ns.certify.all("elastic-stop/one-contact", box={"tau": 10, "tau1": 10})
    orbit = ns.solve("elastic-stop/one-contact")
    assert census.decided
    assert np.allclose(times(census), [list(map(float, orbit.dwell_times))], atol=1e-10)
    assert ns.certify.all("rigid-stop/one-impact", box={"T": 7}).admissible == 1
    assert ns.certify.all("rigid-stop/one-impact", box={"T": 6}).count == 0


def equations_of(census):
    """The equations that the file of a census states."""
    content = content_of(census)
    (found,) = Counting(content).within(content["box"]).equations
    return found


def test_doubles_around_a_ball_hold_it():
    """A ball of many digits, narrower than doubles are apart."""
    with flint_precision(200):
        for number in (arb(k) / 7 for k in range(-20, 21)):
            low, high = floats_around(number)
            assert low < number < high


def test_equations_over_boxes_enclose_those_at_points():
    """By slopes from the middle, and between any two points; and the states at all starts."""
    random = np.random.default_rng(7)
    two = ns.certify.all("dry-friction", DATA, {"tau1": 9, "tau2": 9}, itinerary=TWO, limit=1)
    stick = ns.certify.all(STICK, box={"tau": 9, "tau1": 9}, limit=1)
    strikes = ns.certify.all(IMPACT, {"sigma": 0}, {"T": (2, 3)}, limit=1)
    problems = [equations_of(census) for census in (two, stick, strikes)]
    assert problems[0].setting.zeros == [1, 0]
    assert problems[1].names == ["tau", "tau1", "tau2"]
    assert problems[2].names == ["forcing time"]  # its dwell time is the period
    with flint_precision(64):
        for problem, _ in product(problems, range(30)):
            count = len(problem.names)
            # over a box that is not short a condition is not divided by its time
            most = 1.0 if problem is problems[0] else 8.0
            low = random.uniform(0, most, count) * random.integers(0, 2, count)
            high = low + 10.0 ** random.uniform(-6, 0.5, count)
            sides = tuple(zip(low.tolist(), np.minimum(high, low + most).tolist(), strict=True))
            whole, between = (problem.linear(sides, between=each) for each in (False, True))
            coordinates = random.uniform(-3, 3, len(problem.setting.places)).tolist()
            starts = problem.starts(sides, coordinates)
            ends = [random.uniform(*np.transpose(sides)) for _ in range(4)]
            points = [problem.linear(tuple((float(u), float(u)) for u in end)) for end in ends]
            middles = [float(m) for m in middles_of(sides)]
            for end, at, before, other in zip(ends, points, points[1:], ends[1:], strict=False):
                assert touch(whole.over, at.centre)
                pairs = (whole, middles, whole.centre), (between, other, before.centre)
                for linear, first, value in pairs:
                    for slope, u, m in zip(linear.slopes, end, first, strict=True):
                        value = value + slope * (arb(u) - arb(m))
                    assert touch(value, at.centre)
                point = tuple((float(u), float(u)) for u in end)
                for k, state in problem.starts(point, coordinates).items():
                    assert touch(starts[k], state)


def touch(wide, narrow):
    """Whether the balls of two matrices overlap."""
    return all(x.overlaps(y) for x, y in zip(wide.entries(), narrow.entries(), strict=True))


def test_too_few_boxes_leave_the_rest_undecided():
    census = ns.certify.all(STICK, box={"tau": 12, "tau1": 20}, limit=500)
    assert census.looked == 500
    assert not census.decided
    assert census.undecided[0].reason == "too many boxes"
    assert "at least" in census.statement


def test_an_orbit_without_a_certificate_is_told():
    census = ns.certify.all(BELT, box={"ts": 10, "tau": 8})
    (orbit,) = census.orbits
    bare = replace(census, orbits=(replace(orbit, certificate=None, reason="no reason"),))
    assert bare.count == 1
    assert "0 admissible, 0 not admissible, 1 undecided" in bare.statement
    assert "no certificate: no reason" in bare._repr_html_()


@pytest.mark.parametrize(
    ("arguments", "options", "culprit"),
    [
        ((STICK, {}, {"tau": 3}), {}, "no bounds of tau1"),
        ((STICK, {}, {"tau": 3, "tau9": 3}), {}, "tau9"),
        ((STICK, {}, {"tau": (3, 2), "tau1": 3}), {}, "tau: 3 and 2"),
        ((STICK, {}, {"tau": (1, 2, 3), "tau1": 3}), {}, "tau: 3 bounds"),
        ((STICK, {}, {"tau": "x", "tau1": 3}), {}, "tau: 'x'"),
        ((STICK, {}, {"tau": 3, "tau1": 3}), {"limit": 0}, "limit = 0"),
        ((STICK, {}, {"tau": 3, "tau1": 3}), {"bits": 8}, "bits = 8"),
        ((STICK, {}, {"tau": 3, "tau1": 3}), {"largest": -1.0}, "largest = -1.0"),
        ((STICK, {}, {"tau": 3, "tau1": 3}), {"period": 3}, "period"),
        (("dry-friction/solution-ii", {}, {}), {}, "border collision"),
        ((IMPACT, {}, {"T": 3}), {"period": 3}, "the forcing's"),
        (("elastic-stop", {"m1": 1, "m2": 2, "k1": 1, "k2": 5, "k3": 1}, {"tau1": 3, "tau2": 3}),
         {"itinerary": [("contact", "first-leaves-stop"), ("free", "first-reaches-stop")]},
         "keeps its energy"),
    ],
)  # fmt: skip
def test_wrong_input_is_refused_by_name(arguments, options, culprit):
    with pytest.raises(InputError, match=culprit):
        ns.certify.all(*arguments, **options)


def test_the_command_counts_and_tells(tmp_path):
    path = tmp_path / "census.json"
    code, out, err = run(*COUNT, STICK, "tau=:3", "tau1=0:3", "--json", "--save", str(path))
    assert (code, err) == (0, "")
    told = json.loads(out)
    assert (told["count"], told["decided"]) == (1, True)
    assert ns.load(path).box[1] == "1e-6 <= tau <= 3"
    code, out, _ = run(*COUNT, BELT, "ts=0:10", "tau=:8")
    assert code == 1
    assert "at least 1 orbit" in " ".join(out.split())
    assert "1.200000000" in out
    code, _, err = run(*COUNT, BELT, "ts=0:10", "tau=:8", "--require", "proved")
    assert code == 3
    assert "undecided" in err


@pytest.mark.parametrize(
    ("arguments", "culprit"),
    [
        (("tau=1:2:3", "tau1=0:3"), "tau=1:2:3"),
        (("tau=0:3", "tau=0:4"), "tau is given twice"),
        (("tau=0:3",), "no bounds of tau1"),
        (("tau=0:3", "tau1=0:3", "--guess", "tau=1"), "no such option"),
        (("tau=0:", "tau1=0:3"), "tau has no upper bound"),
    ],
)
def test_the_command_refuses_wrong_bounds(arguments, culprit):
    code, _, err = run(*COUNT, STICK, *arguments)
    assert code == 2
    assert culprit in err


def searched():
    return ns.certify.all(STICK, box={"tau": ("1.5", 3), "tau1": (1, 3), "tau2": (3, 4)})


SHARES = 0.0, 0.3, 0.9, 0.99, 0.999
SEARCHING = ("certify_all.py", "covering.py", "census.py"), {"follow", "certify_orbits"}


@cache
def whole():
    return interrupted(searched, *SEARCHING)


@pytest.mark.parametrize("share", [slow(x, when=x not in (0.3, 0.99)) for x in SHARES])
def test_an_interrupted_census_loses_no_orbit(share):
    lines, found = whole()
    _, partial = interrupted(searched, *SEARCHING, share * lines)
    assert found.decided
    assert found.count == 1
    boxes = [orbit.unique for orbit in partial.orbits] + [part.bounds for part in partial.undecided]
    for certificate in (orbit.certificate for orbit in found.orbits):
        assert any(
            all(
                float(low) <= float(certificate.enclosures[name]) <= float(high)
                for name, (low, high) in box.items()
            )
            for box in boxes
        )

"""Images of sets that divide: no state goes where no leaf is, however its way differs."""

from itertools import pairwise

import numpy as np
import pytest
from flint import fmpq

import nonsmooth as ns
from nonsmooth.runtime.core.float_sets import ManySets
from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.model.kernels import load_system
from nonsmooth.runtime.proof.motion.enclosures import enclosed_system
from nonsmooth.runtime.proof.motion.exact_rows import Invariants
from nonsmooth.runtime.proof.sets.affine_sets import affine_set
from nonsmooth.runtime.proof.sets.branching import BranchingMap
from nonsmooth.runtime.proof.sets.images import SectionMap
from nonsmooth.runtime.proof.sets.sections import forcing_section
from tests.friction_sets import (
    DATA,
    SCALES,
    anywhere,
    arrival,
    branching,
    corner,
    inside,
    missed,
    sampled,
)
from tests.places import GALLERY

BITS = 64
NONE = Invariants((), ())


@pytest.fixture(scope="module")
def system():
    with flint_precision(BITS):
        return enclosed_system("dry-friction", DATA)(BITS)


@pytest.fixture(scope="module")
def mapped(system):
    return mapping(system)


def mapping(system, **limits):
    with flint_precision(BITS):
        return branching(system, **limits)


@pytest.mark.slow
def test_every_start_of_a_box_comes_to_a_leaf(system, mapped):
    random, ran, several = np.random.default_rng(3), 0, 0
    for name, sign in (("slip-slip", (-1, -1)), ("overshoot-slip", (1, -1))):
        middles, half = sampled(random, sign, 16)
        with flint_precision(BITS):
            configuration = system.structure.configuration(name)
            starts = anywhere(middles - half, middles + half)
            leaves = mapped.leaves_of(starts, configuration, NONE)
        away, more, divided = missed(leaves, (middles, half), name, 10)
        assert not away
        ran, several = ran + more, several + divided
    assert ran >= 120
    assert several >= 2  # sets whose states do not all go the same way


def test_both_ways_are_taken_where_the_friction_force_is_about_the_static_limit(system, mapped):
    # the second mass comes to the belt and sticks, or slips on, as chi (x2 - x1) is below ur2
    low, high = np.array([(0.99, 1.01), (3.94, 3.99), (-0.01, 0.01), (1.02, 1.03)]).T
    random = np.random.default_rng(2)
    ways = set()
    with flint_precision(BITS):
        configuration = system.structure.configuration("slip-overshoot")
        leaves = mapped.leaves_of(anywhere(low, high), configuration, NONE)
    assert not leaves.lost.any()
    for _ in range(40):
        state = random.uniform(low, high)
        motion = ns.simulate("dry-friction", DATA, state, "slip-overshoot", transitions=1)
        ways.add(motion.configurations[1])
        assert inside(leaves, 0, arrival(state, "slip-overshoot")).any()
    assert ways == {"slip-stick", "slip-slip"}


def test_sets_that_go_one_way_have_the_image_that_they_have_without_branches(system, mapped):
    section = mapped.section
    single = SectionMap(system, section, 1)
    places = np.array([4.3, 4.32, 4.35])
    with flint_precision(BITS):
        starts = ManySets.of_boxes(places[:, None] - 2**-9, places[:, None] + 2**-9)
        leaves = mapped.leaves(starts)
        assert leaves.origin.tolist() == [0, 1, 2]
        lifted = starts.mapped(mapped.lift(section.facts))
        for k in range(3):
            columns = np.hstack([lifted.centre[k][:, None], lifted.sides[k]])
            start = affine_set(matrix(columns), matrix(np.zeros((6, 1))))
            tight = single.image(start).states.ranges[1]
            low, high, radius = leaves.low[k, 0], leaves.high[k, 0], float(tight.rad())
            assert low <= float(tight.mid()) <= high
            assert 0.9 * radius <= (high - low) / 2 <= 1.1 * radius


def matrix(rows):
    from flint import arb_mat

    return arb_mat(rows.tolist())


def test_passages_are_those_of_a_motion(system):
    mapped = mapping(system)
    names = system.structure.configurations
    with flint_precision(BITS):
        leaves = mapped.leaves(ManySets.of_boxes(np.array([[4.3]]), np.array([[4.301]])))
    assert leaves.origin.tolist() == [0]
    ways = {(names[p.source], names[p.target]) for p in mapped.passages}
    way = ["slip-stick", "slip-slip", "stick-slip", "stick-stick", "slip-stick"]
    assert ways == {*pairwise(way)}


def test_sets_with_too_many_parts_are_lost_alone(system):
    few = mapping(system, most=12)
    with flint_precision(BITS):
        configuration = system.structure.configuration("slip-slip")
        wide = anywhere([[-2, 5, -1, -1]], [[-1, 7, 0.5, 0.5]])
        assert few.leaves_of(wide, configuration, NONE).lost.all()
        both = anywhere(
            [[-2, 5, -1, -1], [-2, 5, -1, -1]], [[-1, 7, 0.5, 0.5], [-1.99, 5.01, -0.99, -0.99]]
        )
        leaves = few.leaves_of(both, configuration, NONE)
    assert leaves.lost.tolist() == [True, False]
    assert set(leaves.origin) == {1}


def test_wide_sets_are_divided(system):
    with flint_precision(BITS):
        start = ManySets.of_boxes(np.array([[4.3]]), np.array([[4.3 + 2**-5]]))
        whole = mapping(system, widest=np.inf).leaves(start)
        parts = mapping(system, widest=2**-8).leaves(start)
    assert len(parts.origin) > len(whole.origin)
    assert parts.low.min() >= whole.low.min()
    assert parts.high.max() <= whole.high.max()


@pytest.mark.compiled
def test_every_state_comes_to_a_leaf_at_the_phase_of_a_forcing():
    system = load_system(str(GALLERY / "impact_oscillator.py"))
    data = {"r": "0.65", "sigma": "0", "w": "2.8"}
    random = np.random.default_rng(5)
    middles = random.uniform((-1.5, -1), (-0.06, 1), (160, 2))
    with flint_precision(BITS):
        enclosed = enclosed_system(system, data)(BITS)
        section = forcing_section(enclosed, 0, (fmpq(1), fmpq(0)))
        stroboscopic = BranchingMap(enclosed, section, SCALES, 0.2, most=200, longest=12)
        leaves = stroboscopic.leaves(ManySets.of_boxes(middles - 0.02, middles + 0.02))
    tested = several = 0
    divided = np.bincount(leaves.origin, minlength=160) > 1
    for k in np.flatnonzero(~leaves.lost & (divided | (np.arange(160) % 16 == 0))):
        counts = set()
        for _ in range(12):
            state = [*(middles[k] + 0.02 * corner(random, 2)), 1.0, 0.0]
            motion = ns.simulate(system, data, state, "free", until=2 * np.pi / 2.8)
            end = motion(np.array([motion.end]))[0]
            counts.add(len(motion.times))
            assert inside(leaves, k, end[:2]).any(), state
            tested += 1
        several += len(counts) > 1
    assert tested >= 120
    assert several >= 2

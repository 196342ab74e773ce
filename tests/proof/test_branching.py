"""Images of sets that divide: no state goes where no leaf is, however its way differs."""

from itertools import pairwise
from pathlib import Path

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
from nonsmooth.runtime.proof.sets.sections import forcing_section, transition_section

BITS = 64
GALLERY = Path(__file__).parents[2] / "docs" / "gallery"
# the paper's orbit with a phase in which both masses stick
DATA = {
    "chi": "0.5",
    "eta": "1",
    "V": "1",
    "us1": "1",
    "us2": "1",
    "ur1": "4.0195",
    "ur2": "1.4831",
}
SCALES = np.ones(4)
NONE = Invariants((), ())


@pytest.fixture(scope="module")
def system():
    with flint_precision(BITS):
        return enclosed_system("dry-friction", DATA)(BITS)


@pytest.fixture(scope="module")
def mapped(system):
    return branching(system)


def branching(system, most=400, widest=0.25):
    structure = system.structure
    source = structure.configuration("stick-stick")
    boundary = structure.boundary(source, "first-breaks-forward")
    target = structure.configuration("slip-stick")
    with flint_precision(BITS):
        section = transition_section(system, source, frozenset({boundary}), target)
        return BranchingMap(system, section, SCALES, widest, most, longest=16)


def anywhere(low, high):
    """Boxes of states at the time 0."""
    boxes = ManySets.of_boxes(np.atleast_2d(low), np.atleast_2d(high))
    size = boxes.sides.shape[1]
    order = [*range(size - 1), size, size - 1]

    def timed(x):
        return np.insert(x, size - 1, 0.0, axis=1)[:, : len(order)]

    return ManySets(timed(boxes.centre), timed(boxes.sides), timed(boxes.box))


def arrival(start, configuration):
    """x2 where the motion from a state first comes to the section."""
    motion = ns.simulate("dry-friction", DATA, list(start), configuration, transitions=60)
    names = motion.configurations
    for k in range(1, len(names)):
        if names[k - 1 : k + 1] == ("stick-stick", "slip-stick"):
            return motion.states[k][1]
    return None


def corner(random, size):
    """Where in a box: corners and faces are where states first go another way."""
    share = random.uniform(-1, 1, size)
    return np.where(random.random(size) < 0.4, np.sign(share) * (1 - 1e-9), share)


def inside(leaves, number, point):
    own = leaves.origin == number
    return ((leaves.low[own] - 1e-9 <= point) & (point <= leaves.high[own] + 1e-9)).all(axis=1)


@pytest.mark.slow
def test_every_start_of_a_box_comes_to_a_leaf(system, mapped):
    random = np.random.default_rng(3)
    tested = several = 0
    for name, sign in (("slip-slip", (-1, -1)), ("overshoot-slip", (1, -1))):
        middles = random.uniform((-4, -8, 0.2, 0.2), (4, 8, 2, 2), (24, 4))
        middles[:, 2:] = 1 + middles[:, 2:] * sign
        half = random.choice([0.03, 0.06, 0.12], 24)[:, None]
        with flint_precision(BITS):
            configuration = system.structure.configuration(name)
            starts = anywhere(middles - half, middles + half)
            leaves = mapped.leaves_of(starts, configuration, NONE)
        for k in np.flatnonzero(~leaves.lost)[:10]:
            ways = set()
            for _ in range(10):
                state = middles[k] + half[k] * corner(random, 4)
                assert inside(leaves, k, arrival(state, name)).any(), (name, state)
                motion = ns.simulate("dry-friction", DATA, state, name, transitions=12)
                ways.add(motion.configurations[:4])
                tested += 1
            several += len(ways) > 1
    assert tested >= 120
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
    mapped = branching(system)
    names = system.structure.configurations
    with flint_precision(BITS):
        leaves = mapped.leaves(ManySets.of_boxes(np.array([[4.3]]), np.array([[4.301]])))
    assert leaves.origin.tolist() == [0]
    ways = {(names[p.source], names[p.target]) for p in mapped.passages}
    way = ["slip-stick", "slip-slip", "stick-slip", "stick-stick", "slip-stick"]
    assert ways == {*pairwise(way)}


def test_sets_with_too_many_parts_are_lost_alone(system):
    few = branching(system, most=12)
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
        whole = branching(system, widest=np.inf).leaves(start)
        parts = branching(system, widest=2**-8).leaves(start)
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

"""Images of sets that divide: no state goes where no leaf is, however its way differs."""

from pathlib import Path

import numpy as np
import pytest
from flint import arb, arb_mat, fmpq

import nonsmooth as ns
from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.events.leading_derivative import Undecided
from nonsmooth.runtime.model.kernels import load_system
from nonsmooth.runtime.proof.motion.enclosures import enclosed_system
from nonsmooth.runtime.proof.motion.exact_rows import Invariants
from nonsmooth.runtime.proof.sets.affine_sets import affine_set
from nonsmooth.runtime.proof.sets.branching import BranchingMap
from nonsmooth.runtime.proof.sets.images import SectionMap
from nonsmooth.runtime.proof.sets.parts import fewer_sides, halves, hull, kept, lifted, values_over
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
SCALES = (1.0,) * 4
NONE = Invariants((), ())


@pytest.fixture(scope="module")
def system():
    with flint_precision(BITS):
        return enclosed_system("dry-friction", DATA)(BITS)


@pytest.fixture(scope="module")
def mapped(system):
    return branching(system)


def branching(system, most=60):
    structure = system.structure
    source = structure.configuration("stick-stick")
    boundary = structure.boundary(source, "first-breaks-forward")
    target = structure.configuration("slip-stick")
    with flint_precision(BITS):
        section = transition_section(system, source, frozenset({boundary}), target)
        return BranchingMap(system, section, 1e9, SCALES, most=most, longest=12)


def arrival(start, configuration):
    """x2 where the motion from a state first comes to the section."""
    motion = ns.simulate("dry-friction", DATA, list(start), configuration, transitions=60)
    names = motion.configurations
    for k in range(1, len(names)):
        if names[k - 1 : k + 1] == ("stick-stick", "slip-stick"):
            return motion.states[k][1]
    return None


def tile(random, half):
    """A box of starts inside one configuration, and its name."""
    middle = random.uniform((-4, -8, -2, -2), (4, 8, 2, 2))
    for k in (2, 3):
        if abs(middle[k] - 1) < half:
            middle[k] = 1 + half
    name = "-".join("slip" if v < 1 else "overshoot" for v in middle[2:])
    return [(x - half, x + half) for x in middle], name


def spans(leaves):
    return [
        (float(ball.lower()), float(ball.upper()))
        for ball in (hull(leaf.states)[1, 0] for leaf in leaves)
    ]


def test_every_start_of_a_box_comes_to_a_leaf(system, mapped):
    random = np.random.default_rng(3)
    tested = several = 0
    with flint_precision(BITS):
        for half in (0.12, 0.25, 0.25) * 10:
            box, name = tile(random, half)
            start = lifted(box, NONE, 4)
            try:
                leaves = mapped.leaves(start, system.structure.configuration(name), NONE)
            except Undecided:
                continue
            found = spans(leaves)
            ways = set()
            for _ in range(20):
                # corners and faces are where states first go another way
                share = random.uniform(-1, 1, 4)
                share = np.where(random.random(4) < 0.4, np.sign(share) * (1 - 1e-9), share)
                state = [
                    (a + b) / 2 + s * (b - a) / 2 for (a, b), s in zip(box, share, strict=True)
                ]
                x2 = arrival(state, name)
                assert any(low - 1e-9 <= x2 <= high + 1e-9 for low, high in found), (box, state)
                motion = ns.simulate("dry-friction", DATA, state, name, transitions=12)
                ways.add(motion.configurations[:4])
                tested += 1
            several += len(ways) > 1
    assert tested >= 120
    assert several >= 2  # sets whose states do not all go the same way


def test_both_ways_are_taken_where_the_friction_force_is_about_the_static_limit(system, mapped):
    # the second mass comes to the belt and sticks, or slips on, as chi (x2 - x1) is below ur2
    box = [(0.99, 1.01), (3.94, 3.99), (-0.01, 0.01), (1.02, 1.03)]
    random = np.random.default_rng(2)
    ways = set()
    with flint_precision(BITS):
        configuration = system.structure.configuration("slip-overshoot")
        found = spans(mapped.leaves(lifted(box, NONE, 4), configuration, NONE))
        for _ in range(40):
            state = [random.uniform(*bounds) for bounds in box]
            motion = ns.simulate("dry-friction", DATA, state, "slip-overshoot", transitions=1)
            ways.add(motion.configurations[1])
            x2 = arrival(state, "slip-overshoot")
            assert any(low - 1e-9 <= x2 <= high + 1e-9 for low, high in found)
    assert ways == {"slip-stick", "slip-slip"}


def test_a_set_that_goes_one_way_has_the_image_that_it_has_without_branches(system, mapped):
    section = mapped.section
    single = SectionMap(system, section, 1)
    with flint_precision(BITS):
        for x2 in (4.3, 4.32, 4.35):
            start = lifted([(x2 - 2**-9, x2 + 2**-9)], section.facts, 4)
            (leaf,) = mapped.leaves(start, section.configuration, section.facts)
            tight = single.image(start).states.ranges[1]
            (low, high), radius = spans([leaf])[0], float(tight.rad())
            assert low <= float(tight.mid()) <= high
            assert 0.9 * radius <= (high - low) / 2 <= 1.1 * radius


def test_passages_are_those_of_a_motion(system, mapped):
    section = mapped.section
    with flint_precision(BITS):
        start = lifted([(4.3, 4.301)], section.facts, 4)
        (leaf,) = mapped.leaves(start, section.configuration, section.facts)
    names = system.structure.configurations
    way = ["slip-stick", "slip-slip", "stick-slip", "stick-stick"]
    assert [names[p.source] for p in leaf.passages] == way
    assert names[leaf.passages[-1].target] == "slip-stick"


def test_too_many_parts_are_undecided(system):
    few = branching(system, most=3)
    with flint_precision(BITS):
        wide = lifted([(-2, -1), (5, 7), (-1, 0.5), (-1, 0.5)], NONE, 4)
        with pytest.raises(Undecided, match="more than 3 parts"):
            few.leaves(wide, system.structure.configuration("slip-slip"), NONE)


def test_wide_sets_are_divided(system, mapped):
    section = mapped.section
    narrow = BranchingMap(system, section, 2**-8, SCALES)
    with flint_precision(BITS):
        start = lifted([(4.3, 4.3 + 2**-5)], section.facts, 4)
        whole = spans(mapped.leaves(start, section.configuration, section.facts))
        parts = spans(narrow.leaves(start, section.configuration, section.facts))
    assert len(whole) == 1
    assert len(parts) > 1
    assert min(low for low, _ in parts) >= whole[0][0]
    assert max(high for _, high in parts) <= whole[0][1]


@pytest.mark.compiled
def test_every_state_comes_to_a_leaf_at_the_phase_of_a_forcing():
    system = load_system(str(GALLERY / "impact_oscillator.py"))
    data = {"r": "0.65", "sigma": "0", "w": "2.8"}
    random = np.random.default_rng(5)
    with flint_precision(BITS):
        enclosed = enclosed_system(system, data)(BITS)
        section = forcing_section(enclosed, 0, (fmpq(1), fmpq(0)))
        stroboscopic = BranchingMap(enclosed, section, 1e9, (1.0,) * 4, most=40, longest=12)
        tested = several = 0
        for _ in range(30):
            x, v = random.uniform((-1.5, -1), (-0.06, 1))
            box = [(x - 0.06, x + 0.06), (v - 0.06, v + 0.06)]
            try:
                leaves = stroboscopic.leaves(lifted(box, section.facts, 4), 0, section.facts)
            except Undecided:
                continue
            hulls = [hull(leaf.states).entries()[:2] for leaf in leaves]
            counts = set()
            for _ in range(12):
                state = [*(random.uniform(*bounds) for bounds in box), 1.0, 0.0]
                motion = ns.simulate(system, data, state, "free", until=2 * np.pi / 2.8)
                end = motion(np.array([motion.end]))[0]
                counts.add(len(motion.times))
                assert any(
                    all(y.overlaps(arb(z, 1e-9)) for y, z in zip(own, end, strict=False))
                    for own in hulls
                ), (box, state)
                tested += 1
            several += len(counts) > 1
    assert tested >= 120
    assert several >= 2


# parts of sets


def drawn(random, sides=5):
    columns = random.normal(size=(6, 1 + sides))
    columns[4], columns[5] = 0, [1] + [0] * sides
    return affine_set(arb_mat(columns.tolist()), arb_mat(6, 1)), columns


def test_what_is_kept_holds_every_state_that_meets_the_condition():
    random = np.random.default_rng(11)
    cut = 0
    with flint_precision(BITS):
        for _ in range(40):
            states, columns = drawn(random)
            row = random.normal(size=6)
            row[5] += random.uniform(-4, 4)
            zero = bool(random.integers(2))
            left = kept(states, arb_mat([row.tolist()]), zero=zero)
            e = random.uniform(-1, 1, (600, 5))
            points = np.hstack([np.ones((600, 1)), e]) @ columns.T
            values = points @ row
            good = points[values >= 0]
            if zero:  # two points on both sides, and where the function is zero between them
                above, below = points[values > 0], points[values < 0]
                count = min(len(above), len(below))
                above, below = above[:count], below[:count]
                part = (above @ row / ((above - below) @ row))[:, None]
                good = above + part * (below - above)
            if left is None:
                assert not len(good)
                continue
            cut += left is not states
            for direction in random.normal(size=(6, 6)):
                most = float(values_over(arb_mat([direction.tolist()]), left)[0, 0].upper())
                assert not len(good) or (good @ direction).max() <= most + 1e-9
    assert cut > 20


def test_a_condition_that_is_far_from_met_leaves_nothing():
    with flint_precision(BITS):
        states, _ = drawn(np.random.default_rng(1))
        assert kept(states, arb_mat([[0, 0, 0, 0, 0, -1]])) is None
        assert kept(states, arb_mat([[0, 0, 0, 0, 0, 1]])) is states


def test_a_thin_oblique_part_is_thin():
    with flint_precision(BITS):
        square = lifted([(-1, 1), (-1, 1)], NONE, 2)
        left = kept(square, arb_mat([[1, 1, 0, 0]]), zero=True)
        ball = values_over(arb_mat([[1, 1, 0, 0]]), left)[0, 0]
    assert float(abs(ball).upper()) < 1e-12


def test_fewer_sides_hold_the_set_and_facts_hold_exactly():
    random = np.random.default_rng(5)
    facts = Invariants.of([(fmpq(1), fmpq(-1, 2), fmpq(0), fmpq(0), fmpq(-3))])
    with flint_precision(BITS):
        for _ in range(20):
            _, columns = drawn(random, 7)
            columns[0] = columns[1] / 2
            columns[0, 0] += 3
            states = affine_set(arb_mat(columns.tolist()), arb_mat(6, 1))
            less = fewer_sides(states, facts, False, hull(states))
            assert less.columns.ncols() == 1 + 3
            points = np.hstack([np.ones((400, 1)), random.uniform(-1, 1, (400, 7))]) @ columns.T
            for direction in random.normal(size=(8, 6)):
                most = float(values_over(arb_mat([direction.tolist()]), less)[0, 0].upper())
                assert (points @ direction).max() <= most + 1e-9
            fact = values_over(arb_mat([[1, -0.5, 0, 0, 0, -3]]), less)[0, 0]
            assert fact.overlaps(arb(0))
            assert float(fact.rad()) < 1e-12


def test_halves_are_the_set():
    with flint_precision(BITS):
        states = lifted([(0, 1), (2, 6)], NONE, 2)
        first, second = halves(states, (1.0, 1.0))
        bounds = [[float(hull(x)[k, 0].mid()) for k in (0, 1)] for x in (first, second)]
    assert bounds == [[0.5, 3.0], [0.5, 5.0]]

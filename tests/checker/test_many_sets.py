"""The check's own carrying of sets that divide: no state goes where no box is."""

import copy

import numpy as np
import pytest
from flint import fmpq

import nonsmooth as ns
from nonsmooth.runtime.checker import Failure
from nonsmooth.runtime.checker.many_sets import ManyMotions
from nonsmooth.runtime.checker.switching import StatedSection
from nonsmooth.runtime.core.float_sets import ManySets
from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.model.kernels import load_system
from nonsmooth.runtime.proof.motion.enclosures import enclosed_system
from nonsmooth.runtime.proof.motion.exact_rows import Invariants
from nonsmooth.runtime.proof.sets.branching import BranchingMap
from nonsmooth.runtime.proof.sets.sections import forcing_section
from nonsmooth.runtime.proof.sets.visited_declaration import visited_declaration
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

FORCED = {"r": "0.65", "sigma": "0", "w": "2.8"}
SECTION = StatedSection("slip-stick", source="stick-stick", boundary="first-breaks-forward")
KINDS = (("slip-slip", (-1, -1)), ("overshoot-slip", (1, -1)))


def boxes_of(name):
    return sampled(np.random.default_rng(len(name)), dict(KINDS)[name], 30)


def starts_of(name):
    middles, half = boxes_of(name)
    return anywhere(middles - half, middles + half)


@pytest.fixture(scope="module")
def proved():
    """The declaration of what the prover's sets pass, and its boxes."""
    kernels = load_system("dry-friction")
    with flint_precision(64):
        system = enclosed_system(kernels, DATA)(64)
        mapped = branching(system)
        leaves = {
            name: mapped.leaves_of(
                starts_of(name), system.structure.configuration(name), Invariants((), ())
            )
            for name, _ in KINDS
        }
        mapped.leaves(ManySets.of_boxes(np.array([[4.3]]), np.array([[4.31]])))
        declared = visited_declaration(kernels, system, sorted(mapped.passages))
    return declared, leaves


def motions(declared, widest=0.25):
    return ManyMotions(declared, DATA, SECTION, SCALES, widest, 400, 16)


@pytest.fixture(scope="module")
def found(proved):
    own = motions(proved[0])
    return {name: own.leaves(starts_of(name), name, []) for name, _ in KINDS}


@pytest.mark.slow
@pytest.mark.parametrize("name", [name for name, _ in KINDS])
def test_every_state_comes_to_a_box(found, name):
    away, ran, several = missed(found[name], boxes_of(name), name, 6)
    assert not away
    assert ran >= 120
    assert several >= 2


@pytest.mark.parametrize("name", [name for name, _ in KINDS])
def test_boxes_are_those_of_the_prover(proved, found, name):
    ours, others = found[name], proved[1][name]
    assert ours.lost.sum() <= others.lost.sum()
    ratios = []
    for k in np.flatnonzero(~ours.lost & ~others.lost):
        spans = []
        for leaves in (ours, others):
            own = leaves.origin == k
            spans.append(leaves.high[own].max() - leaves.low[own].min())
        ratios.append(spans[0] / spans[1])
    assert 0.5 <= np.median(ratios) <= 1.05
    assert max(ratios) <= 1.5


def test_both_ways_are_taken_where_the_friction_force_is_about_the_static_limit(proved):
    # the second mass comes to the belt and sticks, or slips on, as chi (x2 - x1) is below ur2
    low, high = np.array([(0.99, 1.01), (3.94, 3.99), (-0.01, 0.01), (1.02, 1.03)]).T
    leaves = motions(proved[0]).leaves(anywhere(low, high), "slip-overshoot", [])
    random, ways = np.random.default_rng(2), set()
    assert not leaves.lost.any()
    for _ in range(40):
        state = random.uniform(low, high)
        motion = ns.simulate("dry-friction", DATA, state, "slip-overshoot", transitions=1)
        ways.add(motion.configurations[1])
        assert inside(leaves, 0, arrival(state, "slip-overshoot")).any()
    assert ways == {"slip-stick", "slip-slip"}


def test_a_set_on_the_section_comes_back(proved):
    places = np.array([4.3, 4.302, 4.304])[:, None]
    own = motions(proved[0])
    assert [own.system.states[k] for k in own.free] == ["x2"]
    leaves = own.arrivals(ManySets.of_boxes(places - 2**-10, places + 2**-10))
    assert leaves.origin.tolist() == [0, 1, 2]
    matrix = own.lift(own.facts, timed=False).middle
    for k in range(3):
        for x2 in np.linspace(places[k, 0] - 2**-10, places[k, 0] + 2**-10, 5):
            state = (matrix @ [x2, 1.0])[:4]
            assert inside(leaves, k, arrival(state)).any()


def changed(declared, change):
    own = copy.deepcopy(declared)
    change(own)
    return own


def test_sets_are_lost_where_nothing_is_stated(proved, found):
    name = "slip-slip"

    def drop(declared):
        declared["transitions"] = [
            t for t in declared["transitions"] if t["boundaries"] != ["first-reaches-belt"]
        ]

    leaves = motions(changed(proved[0], drop)).leaves(starts_of(name), name, [])
    assert leaves.lost.sum() > found[name].lost.sum() + 10


@pytest.mark.slow
def test_a_boundary_that_is_dropped_leads_elsewhere(proved):
    name = "slip-slip"

    def drop(declared):
        del declared["configurations"]["slip-slip"]["boundaries"]["second-reaches-belt"]

    leaves = motions(changed(proved[0], drop)).leaves(starts_of(name), name, [])
    assert missed(leaves, boxes_of(name), name, 2)[0] >= 3


@pytest.mark.slow
def test_a_condition_that_is_flipped_leads_elsewhere(proved, found):
    name = "overshoot-slip"

    def flip(declared):
        for own in declared["transitions"]:
            if own["source"] == "stick-slip" and own["boundaries"] == ["second-reaches-belt"]:
                own["conditions"] = [[row, along, not h] for row, along, h in own["conditions"]]

    leaves = motions(changed(proved[0], flip)).leaves(starts_of(name), name, [])
    away = missed(leaves, boxes_of(name), name, 2)[0]
    assert away + (leaves.lost & ~found[name].lost).sum() >= 5


@pytest.fixture(scope="module")
def forced():
    kernels = load_system(str(GALLERY / "impact_oscillator.py"))
    random = np.random.default_rng(5)
    middles = random.uniform((-1.5, -1), (-0.06, 1), (160, 2))
    with flint_precision(64):
        system = enclosed_system(kernels, FORCED)(64)
        section = forcing_section(system, 0, (fmpq(1), fmpq(0)))
        mapped = BranchingMap(system, section, SCALES, 0.2, most=200, longest=12)
        leaves = mapped.leaves(ManySets.of_boxes(middles - 0.02, middles + 0.02))
        declared = visited_declaration(kernels, system, sorted(mapped.passages))
    return kernels, declared, middles, leaves


def stroboscopic(forced, data):
    """Of motions over a period how many end in no leaf; how many ran, divided sets, lost ones."""
    kernels, declared, middles, _ = forced
    section = StatedSection("free", phase=("1", "0"))
    own = ManyMotions(declared, data, section, SCALES, 0.2, 200, 12)
    leaves = own.arrivals(ManySets.of_boxes(middles - 0.02, middles + 0.02))
    random = np.random.default_rng(6)
    away = ran = several = 0
    divided = np.bincount(leaves.origin, minlength=160) > 1
    for k in np.flatnonzero(~leaves.lost & (divided | (np.arange(160) % 16 == 0))):
        counts = set()
        for _ in range(12):
            state = [*(middles[k] + 0.02 * corner(random, 2)), 1.0, 0.0]
            motion = ns.simulate(kernels, FORCED, state, "free", until=2 * np.pi / 2.8)
            end = motion(np.array([motion.end]))[0]
            counts.add(len(motion.times))
            away += not inside(leaves, k, end[:2]).any()
            ran += 1
        several += len(counts) > 1
    return away, ran, several, leaves.lost.sum()


@pytest.mark.slow
@pytest.mark.compiled
def test_every_state_comes_to_a_box_at_the_phase_of_a_forcing(forced):
    away, ran, several, lost = stroboscopic(forced, FORCED)
    assert not away
    assert ran >= 120
    assert several >= 2
    assert lost <= forced[3].lost.sum() + 2


@pytest.mark.slow
@pytest.mark.compiled
def test_another_restitution_leads_elsewhere(forced):
    away, ran, _, _ = stroboscopic(forced, {**FORCED, "r": "0.4"})
    assert away >= ran / 10


@pytest.mark.compiled
def test_states_at_another_phase_are_refused(forced):
    section = StatedSection("free", phase=("1", "0"))
    own = ManyMotions(forced[1], FORCED, section, SCALES)
    with pytest.raises(Failure, match="another phase"):
        own.leaves(anywhere([[-1, 0, 1, 0]], [[-1, 0, 1, 0]]), "free", [])


def configuration(boundaries):
    """x' = 1, y' = 0."""
    return {"field": [["0", "0", "1"], ["0", "0", "0"]], "boundaries": boundaries, "held": []}


def transition(source, boundaries, reset, target):
    told = {"source": source, "boundaries": boundaries, "conditions": []}
    return {**told, "reset": reset, "target": target}


def handmade(*more, side=None):
    """From (-1, y) to x = 0, on from (y, y) to x = 0, where y takes the value of x; and back."""
    x, last = ["1", "0", "0"], ["0", "0", "-1"]
    middle = {"top": x} if side is None else {"top": x, "side": side}
    return {
        "parameters": [],
        "states": ["x", "y"],
        "forcing": [],
        "configurations": {
            "first": configuration({"end": x}),
            "middle": configuration(middle),
            "last": configuration({"back": x}),
        },
        "transitions": [
            transition("first", ["end"], [["0", "1", "0"], ["0", "1", "0"]], "middle"),
            transition("middle", ["top"], [last, ["1", "0", "0"]], "last"),
            transition("last", ["back"], [last, ["0", "1", "0"]], "first"),
            *more,
        ],
    }


def carried(declared, low, high):
    section = StatedSection("first", source="last", boundary="back")
    own = ManyMotions(declared, {}, section, [1, 1], 0.5)
    return own.arrivals(ManySets.of_boxes(np.array(low)[:, None], np.array(high)[:, None]))


def test_states_that_begin_beyond_a_boundary_leave_at_once():
    leaves = carried(handmade(), [-0.2, 0.1, -0.1], [-0.1, 0.2, 0.1])
    assert not leaves.lost.any()
    for number, least, most in ((0, 0, 0), (1, 0.1, 0.2), (2, 0, 0.1)):
        own = leaves.origin == number
        assert leaves.low[own].min() == pytest.approx(least, abs=1e-9)
        assert leaves.high[own].max() == pytest.approx(most, abs=1e-9)


@pytest.mark.parametrize("side", [["0", "1", "0"], ["-1", "2", "0"]])
def test_two_boundaries_together_are_followed_where_that_is_stated(side):
    # y > 0 is beyond both; the second is 2 y - x, which falls
    both = transition("middle", ["side", "top"], [["0", "0", "-1"], ["0", "0", "5"]], "last")
    low, high = [-0.2, 0.1, -0.1], [-0.1, 0.2, 0.1]
    leaves = carried(handmade(both, side=side), low, high)
    assert not leaves.lost[:2].any()
    assert leaves.high[leaves.origin == 0].max() == pytest.approx(0, abs=1e-9)
    assert leaves.low[leaves.origin == 1].min() == pytest.approx(5, abs=1e-9)
    if not leaves.lost[2]:
        assert inside(leaves, 2, [0.0]).any()
        assert inside(leaves, 2, [5.0]).any()
    assert carried(handmade(side=side), low, high).lost.tolist() == [False, True, True]


def test_two_boundaries_that_are_reached_at_one_time_are_followed():
    # x and x + y are zero together where y is, of a set around that some states by either alone
    both = transition("middle", ["side", "top"], [["0", "0", "-1"], ["0", "0", "5"]], "last")
    alone = transition("middle", ["side"], [["0", "0", "-1"], ["0", "0", "7"]], "last")
    declared = handmade(both, alone, side=["1", "1", "0"])
    declared["transitions"][0]["reset"][0] = ["0", "0", "-1"]  # the middle begins at x = -1
    leaves = carried(declared, [-0.1, -0.1, 0.05], [0.1, -0.05, 0.1])
    assert not leaves.lost.any()
    for value in (0.0, 5.0, 7.0):
        assert inside(leaves, 0, [value]).any()
    assert set(np.round(leaves.low[leaves.origin == 1].ravel(), 6)) == {0.0}
    assert set(np.round(leaves.low[leaves.origin == 2].ravel(), 6)) == {7.0}


@pytest.mark.parametrize("count", [3, 4])
def test_more_boundaries_together_are_lost(count):
    names = [f"side {number}" for number in range(count)]
    told = [["0", "0", "-1"], ["0", "0", "5"]]
    both = [transition("middle", names[:many], told, "last") for many in range(1, count + 1)]
    declared = handmade(*both)
    rows = {name: ["1", str(number), "0"] for number, name in enumerate(names)}
    declared["configurations"]["middle"]["boundaries"] = rows
    # y > 0 is beyond all of them; from y < 0 on the first one is reached before the others
    assert carried(declared, [-0.2, 0.1], [-0.1, 0.2]).lost.tolist() == [False, True]

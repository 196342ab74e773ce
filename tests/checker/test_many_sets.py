"""Sets that divide: no state goes where no box is, however its way differs."""

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth.runtime.checker import Failure
from nonsmooth.runtime.checker.state_sets.many_sets import ManyMotions
from nonsmooth.runtime.checker.state_sets.switching import StatedSection
from nonsmooth.runtime.core.float_sets import ManySets
from nonsmooth.runtime.model.kernels import load_system
from tests.friction_sets import (
    DATA,
    anywhere,
    arrival,
    corner,
    declared_system,
    inside,
    missed,
    motions_of,
    sampled,
)
from tests.places import GALLERY

FORCED = {"r": "0.65", "sigma": "0", "w": "2.8"}
KINDS = (("slip-slip", (-1, -1)), ("overshoot-slip", (1, -1)))


def boxes_of(name):
    return sampled(np.random.default_rng(len(name)), dict(KINDS)[name], 30)


def starts_of(name):
    middles, half = boxes_of(name)
    return anywhere(middles - half, middles + half)


@pytest.fixture(scope="module")
def declared():
    return declared_system()


@pytest.fixture(scope="module")
def found(declared):
    own = motions_of(declared)
    return {name: own.leaves(starts_of(name), name, []) for name, _ in KINDS}


@pytest.mark.slow
@pytest.mark.parametrize("name", [name for name, _ in KINDS])
def test_every_state_comes_to_a_box(found, name):
    away, ran, several = missed(found[name], boxes_of(name), name, 6)
    assert not away
    assert ran >= 120
    assert several >= 2


def test_both_ways_are_taken_where_the_friction_force_is_about_the_static_limit(declared):
    # the second mass comes to the belt and sticks, or slips on, as chi (x2 - x1) is below ur2
    low, high = np.array([(0.99, 1.01), (3.94, 3.99), (-0.01, 0.01), (1.02, 1.03)]).T
    leaves = motions_of(declared).leaves(anywhere(low, high), "slip-overshoot", [])
    random, ways = np.random.default_rng(2), set()
    assert not leaves.lost.any()
    for _ in range(40):
        state = random.uniform(low, high)
        motion = ns.simulate("dry-friction", DATA, state, "slip-overshoot", transitions=1)
        ways.add(motion.configurations[1])
        assert inside(leaves, 0, arrival(state, "slip-overshoot")).any()
    assert ways == {"slip-stick", "slip-slip"}


def test_a_set_on_the_section_comes_back(declared):
    places = np.array([4.3, 4.302, 4.304])[:, None]
    own = motions_of(declared)
    assert [own.system.states[k] for k in own.free] == ["x2"]
    leaves = own.arrivals(ManySets.of_boxes(places - 2**-10, places + 2**-10))
    assert leaves.origin.tolist() == [0, 1, 2]
    matrix = own.lift(own.facts, timed=False).middle
    for k in range(3):
        for x2 in np.linspace(places[k, 0] - 2**-10, places[k, 0] + 2**-10, 5):
            state = (matrix @ [x2, 1.0])[:4]
            assert inside(leaves, k, arrival(state)).any()


def test_sets_with_too_many_parts_are_lost_alone(declared):
    few = motions_of(declared, most=12)
    wide = anywhere([[-2, 5, -1, -1]], [[-1, 7, 0.5, 0.5]])
    assert few.leaves(wide, "slip-slip", []).lost.all()
    both = anywhere(
        [[-2, 5, -1, -1], [-2, 5, -1, -1]], [[-1, 7, 0.5, 0.5], [-1.99, 5.01, -0.99, -0.99]]
    )
    leaves = few.leaves(both, "slip-slip", [])
    assert leaves.lost.tolist() == [True, False]
    assert set(leaves.origin) == {1}


def test_wide_sets_are_divided(declared):
    start = ManySets.of_boxes(np.array([[4.3]]), np.array([[4.3 + 2**-5]]))
    whole = motions_of(declared, widest=np.inf).arrivals(start)
    parts = motions_of(declared, widest=2**-8).arrivals(start)
    assert len(parts.origin) > len(whole.origin)
    assert parts.low.min() >= whole.low.min()
    assert parts.high.max() <= whole.high.max()


@pytest.mark.slow
def test_a_set_that_comes_elsewhere_is_lost_and_not_followed_further(declared, found):
    name = "slip-slip"
    whole, own = found[name], motions_of(declared)
    middle = np.median((whole.low + whole.high) / 2)

    def known(origin, low, high):
        return high[:, 0] < middle

    leaves = own.leaves(starts_of(name), name, [], known)
    elsewhere = np.unique(whole.origin[whole.high[:, 0] >= middle])
    lost = whole.lost.copy()
    lost[elsewhere] = True
    assert (leaves.lost == lost).all()
    assert 0 < lost.sum() < len(lost)
    assert leaves.portions < whole.portions


@pytest.fixture(scope="module")
def forced():
    name = str(GALLERY / "impact_oscillator.py")
    middles = np.random.default_rng(5).uniform((-1.5, -1), (-0.06, 1), (160, 2))
    return load_system(name), declared_system(name, FORCED), middles


@pytest.mark.slow
@pytest.mark.compiled
def test_every_state_comes_to_a_box_at_the_phase_of_a_forcing(forced):
    kernels, declared, middles = forced
    section = StatedSection("free", phase=("1", "0"))
    own = ManyMotions(declared, FORCED, section, np.ones(4), 0.2, 200, 12)
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
    assert not away
    assert ran >= 120
    assert several >= 2
    assert leaves.lost.sum() <= 30


@pytest.mark.compiled
def test_states_at_another_phase_are_refused(forced):
    section = StatedSection("free", phase=("1", "0"))
    own = ManyMotions(forced[1], FORCED, section, np.ones(4))
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


def test_stops_that_are_reached_together_act_in_all_orders():
    # y > 0 is beyond both, which leads to one place or another one, as one stop acts first or last
    ways = [
        transition("middle", ["side", "top"], [["0", "0", "-1"], ["0", "0", place]], "last")
        | {"order": number}
        for number, place in ((1, "5"), (2, "7"))
    ]
    leaves = carried(handmade(*ways, side=["0", "1", "0"]), [0.1], [0.2])
    assert not leaves.lost.any()
    assert set(np.round(leaves.low.ravel(), 6)) == {5.0, 7.0}
    one = handmade(ways[0], side=["0", "1", "0"])
    assert carried(one, [0.1], [0.2]).lost.all()


def test_sets_are_lost_where_no_transition_is_stated():
    declared = handmade()
    del declared["transitions"][1]
    assert carried(declared, [-0.2], [-0.1]).lost.all()


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

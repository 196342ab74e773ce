"""Graphs of boxes: motions go along edges, and what is called trapping is not left."""

from fractions import Fraction
from types import SimpleNamespace

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth import InputError
from nonsmooth.runtime.core.box_grid import BoxGrid, DividedGrid
from nonsmooth.runtime.model.kernels import load_system
from nonsmooth.runtime.proof.sets.graph_certificate import BoxGraph
from tests.friction_sets import DATA, arrival
from tests.horseshoes import FRICTION_DATA
from tests.pictures import legend_of
from tests.places import GALLERY

IMPACTS = {"r": "0.65", "sigma": "0", "w": "2.3"}


@pytest.fixture(scope="module")
def friction():
    region = {"x2": (2, 13.5)}
    return ns.certify.region("dry-friction", DATA, [5, 4, 0.5, 0.25], boxes=512, region=region)


@pytest.fixture(scope="module")
def impacts():
    return impacts_by(1)


def impacts_by(workers):
    system, start = load_system(str(GALLERY / "impact_oscillator.py")), {"x": -0.7, "v": 0.1}
    asked = {"boxes": 64, "region": {"x": (-2, 0), "v": (-2, 2)}, "workers": workers}
    return ns.certify.region(system, IMPACTS, start, **asked)


def returned(place):
    """x2 where a motion from the section of `friction` comes back to it; None if it does not."""
    try:
        return arrival([0.5 * place + float(DATA["ur1"]), place, 1, 1])
    except InputError:  # the second mass cannot stick there
        return None


def leads(found, box, place):
    """Whether a graph has an edge from a box to one that holds a place, but for rounding."""
    low, high = found.graph.grid.bounds(found.targets(box))
    return ((low <= place + 1e-9) & (place - 1e-9 <= high)).all(axis=1).any()


@pytest.mark.slow
def test_motions_go_along_edges(friction):
    random = np.random.default_rng(7)
    low, high = friction.graph.grid.bounds(np.arange(len(friction.graph.grid)))
    tested = 0
    for box in random.choice(len(low), 150, replace=False):
        share = random.choice([1e-9, random.random(), 1 - 1e-9])
        place = low[box, 0] + share * (high[box, 0] - low[box, 0])
        if friction.graph.unknown[box] or (there := returned(place)) is None:
            continue
        assert leads(friction, box, there), place
        tested += 1
    assert tested > 120


@pytest.mark.slow
def test_motions_go_along_edges_in_two_dimensions(impacts):
    system = load_system(str(GALLERY / "impact_oscillator.py"))
    graph = impacts.graph
    (low, high), random = graph.grid.bounds(np.arange(len(graph.grid))), np.random.default_rng(8)
    cosine, sine = (float(Fraction(x)) for x in impacts.phase)
    tested = escaped = 0
    for box in random.choice(np.flatnonzero(~graph.unknown & (high[:, 0] < 0)), 200, replace=False):
        state = low[box] + random.random(2) * (high[box] - low[box])
        motion = ns.simulate(system, IMPACTS, [*state, cosine, sine], "free", until=2 * np.pi / 2.3)
        end = motion(np.array([motion.end]))[0][:2]
        if not leads(impacts, box, end):
            assert graph.outside[box], state
            escaped += 1
        tested += 1
    assert tested == 200
    assert 0 < escaped < 100


def test_the_attracting_component_contains_the_stable_orbit(friction):
    (attracting,) = (own for own in friction.components if own.attracting)
    place = 4.0
    for _ in range(60):
        place = (place + returned(place)) / 2  # the multiplier is near -1
    assert abs(returned(place) - place) < 1e-3
    assert friction.box_of([place]) in attracting.boxes
    assert friction.component_of([place]) is attracting
    assert friction.proved


@pytest.mark.slow
def test_motions_do_not_leave_trapping_regions(friction, impacts):
    trapping = set(friction.trapping)
    assert len(trapping) > 600
    random = np.random.default_rng(9)
    low, high = friction.graph.grid.bounds(np.array(sorted(trapping)))
    for place in random.choice(low[:, 0] + 0.3 * (high - low)[:, 0], 25):
        here = place
        for _ in range(6):
            here = returned(here)
            if here is None:
                break
            assert friction.box_of([here]) in trapping, place
    for own in (friction, impacts):
        inner = np.isin(own.graph.sources, own.trapping)
        assert np.isin(own.graph.targets[inner], own.trapping).all()
        assert not (own.graph.outside | own.graph.unknown)[own.trapping].any()
    assert any(own.attracting for own in impacts.components)


def graph_of(edges, count, outside=(), unknown=()):
    """Boxes of width 1; the image of each is inside of those that edges name."""
    grid = DividedGrid.of(BoxGrid((0,), (0,), (count,)))
    origin = np.array([i for i, _ in edges] + list(outside))
    low = np.array([[j + 0.25] for _, j in edges] + [[count + 5.5]] * len(outside))
    lost = np.isin(np.arange(count), unknown)
    return BoxGraph.unseen(grid).seen(
        np.arange(count), SimpleNamespace(origin=origin, low=low, high=low + 0.5, lost=lost)
    )


def test_components_trapping_regions_and_the_morse_graph_of_a_small_graph():
    # 0 <-> 1 -> 2 -> (3) -> 4 <-> 5; 6 -> 6 and outside; 7 unknown; 8 -> 7; 9 nothing
    edges = [(0, 1), (1, 0), (1, 2), (2, 3), (3, 3), (3, 4), (4, 5), (5, 4), (6, 6), (8, 7)]
    graph = graph_of(edges, 10, outside=[6], unknown=[7])
    assert sorted(tuple(own.tolist()) for own in graph.components) == [(0, 1), (3,), (4, 5), (6,)]
    assert np.flatnonzero(graph.trapping).tolist() == [0, 1, 2, 3, 4, 5]
    names = [tuple(own.tolist()) for own in graph.components]
    arrows = {(names[i], names[j]) for i, j in graph.arrows()}
    assert arrows == {((0, 1), (3,)), ((3,), (4, 5))}
    assert np.flatnonzero(graph.ahead(np.array([2]))).tolist() == [2, 3, 4, 5]
    assert np.flatnonzero(graph.behind(np.array([7]))).tolist() == [7, 8]
    # ranks descend but for components
    assert graph.ranks.tolist() == [3, 3, 2, 1, 0, 0, 0, 0, 1, 0]


@pytest.mark.parametrize("bad", [np.inf, -np.inf, np.nan, 1e300])
def test_images_that_are_no_boxes_are_not_known_or_outside(bad):
    grid = DividedGrid.of(BoxGrid((0,), (0,), (4,)))
    low, high = np.array([[1.2], [min(bad, 1.0)]]), np.array([[1.4], [max(bad, 1.0)]])
    leaves = SimpleNamespace(
        origin=np.array([0, 1]), low=low, high=high, lost=np.zeros(4, dtype=bool)
    )
    graph = BoxGraph.unseen(grid).seen(np.arange(4), leaves)
    assert (graph.outside | graph.unknown).tolist() == [False, True, False, False]
    assert not graph.trapping[1]


@pytest.mark.parametrize(
    ("asked", "told"),
    [
        ({"region": {"x1": (0, 1)}}, "x1 is no coordinate"),
        ({"region": {"x2": (4, 4)}}, "no interval"),
        ({"region": {"x2": (1e15, 1.000001e15)}, "levels": 24}, "take longer ones"),
        ({"region": {"x2": (-1e308, 1e308)}}, "a side of a box"),
        ({"boxes": 0}, "boxes = 0"),
        ({"workers": 0}, "workers = 0"),
    ],
)
def test_what_cannot_be_asked_is_refused(asked, told):
    with pytest.raises(InputError, match=told):
        ns.certify.region("dry-friction", DATA, [5, 4, 0.5, 0.25], **asked)


def test_what_is_not_in_the_region_has_no_box(friction):
    with pytest.raises(InputError, match="not in the region"):
        friction.box_of([19])


def test_a_picture_shows_the_components(friction, impacts):
    for own in (friction, impacts):
        boxes, _ = own.plot().axes
        assert sum("attracting" in text for text in legend_of(boxes)) == 1
        assert any(text.startswith("trapping region") for text in legend_of(boxes))


@pytest.fixture(scope="module")
def chaotic():
    return ns.certify.region("dry-friction", FRICTION_DATA, [1.93, 7.18, 1.18, 1.18], levels=1)


@pytest.mark.slow
def test_a_chaotic_set_lies_in_an_attracting_component(chaotic):
    motion = ns.simulate("dry-friction", FRICTION_DATA, [1.93, 7.18, 1.18, 1.18], transitions=4000)
    names = motion.configurations
    places = [
        k for k in range(400, len(names)) if names[k - 1 : k + 1] == ("stick-stick", "slip-stick")
    ]
    seen = motion.states[places, 1]
    assert len(seen) > 300
    assert np.ptp(seen) > 6
    own = {id(chaotic.component_of([x2])): chaotic.component_of([x2]) for x2 in seen}
    (component,) = own.values()
    assert component.attracting
    # the stable orbit beside it is in another one
    other = chaotic.component_of([8.34])
    assert other.attracting
    assert other is not component


@pytest.mark.slow
def test_a_box_where_both_masses_break_away_together_has_a_known_image(chaotic):
    corner = (float(FRICTION_DATA["ur2"]) / 0.34 + float(FRICTION_DATA["ur1"])) / 0.66
    box = chaotic.box_of([corner])
    assert not chaotic.graph.unknown[box]
    for x2 in corner - np.array([1e-3, 1e-6, 1e-9]):
        start = [0.34 * x2 + float(FRICTION_DATA["ur1"]), x2, 1.23, 1.23]
        motion = ns.simulate("dry-friction", FRICTION_DATA, start, "slip-stick", transitions=12)
        names = motion.configurations
        k = next(k for k in range(1, 12) if names[k - 1 : k + 1] == ("stick-stick", "slip-stick"))
        assert leads(chaotic, box, motion.states[k, 1])


@pytest.mark.slow
def test_several_processes_find_the_same_graph(impacts):
    assert impacts_by(2).to_json() == impacts.to_json()


@pytest.mark.slow
def test_boxes_are_divided_where_it_helps():
    asked = {"region": {"x2": (2, 14)}, "boxes": 64}
    start = [5, 4, 0.5, 0.25]
    coarse = ns.certify.region("dry-friction", DATA, start, **asked)
    told = []
    fine = ns.certify.region(
        "dry-friction", DATA, start, levels=2, progress=lambda *now: told.append(now), **asked
    )
    begun = [k for k, (done, _) in enumerate(told) if not done]
    assert len(begun) == 3  # each level tells its boxes before the first
    assert all(told[k - 1][0] == told[k - 1][1] for k in begun[1:])
    again = ns.certify.region("dry-friction", DATA, start, levels=2, resume=coarse, **asked)
    assert again.to_json() == fine.to_json()
    assert len(coarse.graph.grid) < len(fine.graph.grid) < 2 * len(coarse.graph.grid)
    (one,) = (own for own in coarse.components if own.attracting)
    (two,) = (own for own in fine.components if own.attracting)
    assert two.high[0] - two.low[0] < 0.7 * (one.high[0] - one.low[0])
    # what motions do of each box is the same as with boxes of one size
    low, high = fine.graph.grid.bounds(np.arange(len(fine.graph.grid)))
    for box in range(1, len(low), 9):
        there = returned((low[box, 0] + high[box, 0]) / 2)
        if fine.graph.unknown[box] or there is None:
            continue
        assert leads(fine, box, there)
    with pytest.raises(InputError, match="another"):
        ns.certify.region("dry-friction", {**DATA, "ur1": "4.02"}, start, resume=coarse, **asked)


def test_images_that_do_not_change_are_not_lost_when_others_are_divided():
    graph = graph_of([(0, 1), (1, 2), (2, 2), (3, 0)], 4)
    more, again = graph.halved(np.array([False, False, True, False]))
    low, _ = more.grid.bounds(np.arange(len(more.grid)))
    assert sorted(low[again, 0].tolist()) == [1.0, 2.0, 2.5]
    pairs = {(low[s, 0], low[t, 0]) for s, t in zip(more.sources, more.targets, strict=True)}
    assert pairs == {(0.0, 1.0), (3.0, 0.0)}
    assert sorted(low[more.unknown, 0].tolist()) == [1.0, 2.0, 2.5]

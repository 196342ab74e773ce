"""Grids of boxes: what they meet and cover, by looking at every box."""

import numpy as np
import pytest

from nonsmooth.runtime.core.box_grid import BoxGrid

GRID = BoxGrid((-2, -1), (-3, 2), (7, 5))


def test_a_grid_covers_its_box_with_sides_that_are_short_enough():
    grid = BoxGrid.around(np.array([-1.0, 0.3]), np.array([2.0, 0.9]), np.array([0.3, 0.1]))
    low, high = grid.bounds(np.arange(len(grid)))
    assert grid.exponents == (-2, -4)
    assert (low.min(axis=0) <= [-1, 0.3]).all()
    assert (high.max(axis=0) >= [2, 0.9]).all()
    assert len(grid) == 12 * 11


@pytest.fixture
def boxes():
    random = np.random.default_rng(1)
    low = random.uniform((-1, 0.8), (1, 3.6), (300, 2))
    return low, low + random.uniform(0, 1.2, (300, 2))


def test_the_boxes_that_are_met_are_those_that_overlap(boxes):
    low, high = boxes
    owner, number, inside = GRID.numbers_met(low, high)
    least, most = GRID.bounds(np.arange(len(GRID)))
    for k in range(len(low)):
        overlap = ((least <= high[k]) & (low[k] < most)).all(axis=1)
        assert set(number[owner == k]) == set(np.flatnonzero(overlap))
        assert inside[k] == bool((low[k] >= least[0]).all() and (high[k] < most[-1]).all())
    assert 0 < inside.sum() < len(low)


def test_boxes_are_covered_where_all_that_they_meet_are_good(boxes):
    low, high = boxes
    good = np.random.default_rng(2).random(len(GRID)) < 0.9
    owner, number, inside = GRID.numbers_met(low, high)
    covered = GRID.covered(GRID.sums(good), low, high)
    for k in range(len(low)):
        assert covered[k] == bool(inside[k] and good[number[owner == k]].all())
    assert 0 < covered.sum() < len(low)


@pytest.mark.parametrize("first", [-1, 0, 1, 2])
@pytest.mark.parametrize("end", [1e30, -1e30, np.inf, -np.inf, np.nan])
def test_boxes_beyond_all_integers_are_not_covered(first, end):
    # the other coordinate is where no box is among the chosen ones
    grid = BoxGrid((0, 0), (first, first), (2, 2))
    sums = grid.sums(np.array([True, False, True, False]))
    inner = first + 1.2
    for low, high in ((end, end), (min(end, 0.5), max(end, 0.5))):
        box = np.array([[low, inner]]), np.array([[high, inner]])
        assert not grid.covered(sums, *box).any()
        assert not grid.met(*box)[2].any()


def test_what_is_no_number_may_be_in_any_box():
    box = np.array([[np.nan, 2.2]])
    owner, number, inside = BoxGrid((0, 0), (1, 1), (2, 2)).numbers_met(box, box)
    assert owner.tolist() == [0, 0]
    assert number.tolist() == [1, 3]
    assert not inside.any()

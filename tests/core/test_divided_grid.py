"""Boxes of several sizes: they cover the region once, and boxes that are met are found."""

import numpy as np
import pytest

from nonsmooth.runtime.core.box_grid import BoxGrid, DividedGrid


def divided(seed, exponents=(-1, 0), first=(-3, 2), counts=(4, 3), times=3):
    random = np.random.default_rng(seed)
    found = DividedGrid.of(BoxGrid(exponents, first, counts))
    for _ in range(times):
        found, _ = found.halved(random.random(len(found)) < 0.3)
    return found, random


@pytest.mark.parametrize("seed", range(5))
def test_boxes_cover_the_region_once(seed):
    found, random = divided(seed)
    low, high = found.bounds(np.arange(len(found)))
    assert (high - low).prod(axis=1).sum() == 12 * 0.5
    points = np.array([-1.5, 2.0]) + random.random((300, 2)) * np.array([2.0, 3.0])
    owner, number, inside = found.numbers_met(points, points)
    assert inside.all()
    assert sorted(owner.tolist()) == list(range(300))
    assert ((low[number] <= points[owner]) & (points[owner] < high[number])).all()


@pytest.mark.parametrize("seed", range(5))
def test_boxes_that_are_met_are_those_that_have_points_in_common(seed):
    found, random = divided(seed)
    low, high = found.bounds(np.arange(len(found)))
    corner = np.array([-1.8, 1.7]) + random.random((100, 2)) * np.array([2.4, 3.4])
    further = corner + random.random((100, 2)) ** 3
    # some that end on borders
    corner[::7], further[::5] = np.round(4 * corner[::7]) / 4, np.round(4 * further[::5]) / 4 + 1
    owner, number, inside = found.numbers_met(corner, further)
    told = np.zeros((100, len(found)), dtype=bool)
    told[owner, number] = True
    assert len(owner) == told.sum()
    met = ((low[None] <= further[:, None]) & (corner[:, None] < high[None])).all(axis=2)
    assert (told == met).all()
    whole = ((corner >= [-1.5, 2.0]) & (further < [0.5, 5.0])).all(axis=1)
    assert (inside == whole).all()
    assert inside.any()
    assert not inside.all()


def test_a_box_alone_is_a_grid_and_parts_know_what_they_are_parts_of():
    grid = BoxGrid((-2,), (3,), (5,))
    found = DividedGrid.of(grid)
    every = np.arange(5)
    assert all(map(np.array_equal, found.bounds(every), grid.bounds(every)))
    chosen = np.array([False, True, False, False, True])
    more, origin = found.halved(chosen)
    assert origin.tolist() == [0, 2, 3, 1, 1, 4, 4]
    chosen = np.array([True, False, False, False, True, False, False])
    last, origin = more.halved(chosen)
    assert origin.tolist() == [1, 2, 0, 0, 3, 5, 6, 4, 4]
    low, high = last.bounds(np.arange(len(last)))
    before = more.bounds(origin)
    assert (before[0] <= low).all()
    assert (high <= before[1]).all()
    assert last.finest.tolist() == [1 / 16]
    assert last == DividedGrid(grid, last.divided)
    assert last != more


def test_nothing_is_divided_where_nothing_is_chosen():
    found, _ = divided(3)
    same, origin = found.halved(np.zeros(len(found), dtype=bool))
    assert same == found
    assert origin.tolist() == list(range(len(found)))

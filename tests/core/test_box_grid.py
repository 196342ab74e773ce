"""Grids of boxes: what they meet and cover, by looking at every box."""

import random
from fractions import Fraction

import numpy as np
import pytest

from nonsmooth import InputError
from nonsmooth.runtime.core.box_grid import BoxGrid, DividedGrid

GRID = BoxGrid((-2, -1), (-3, 2), (7, 5))


def test_a_grid_covers_its_box_or_is_refused():
    """At all magnitudes of ends and sides, in exact arithmetic."""
    numbers, refused = random.Random(5), 0
    for _ in range(3000):
        low = numbers.uniform(-1, 1) * 10.0 ** numbers.randint(-300, 300)
        high = low + abs(low) * 10.0 ** numbers.randint(-12, 4)
        side = (high - low) * 10.0 ** numbers.randint(-25, 2) or 1e-320
        try:
            grid = BoxGrid.around(*(np.array([x]) for x in (low, high, side)))
        except InputError:
            refused += 1
            continue
        least, most = (x[:, 0].tolist() for x in grid.bounds(np.array([0, len(grid) - 1])))
        length, count = Fraction(most[0]) - Fraction(least[0]), len(grid)
        assert least[0] <= low
        assert most[1] >= high
        assert length <= Fraction(side) < 2 * length
        assert Fraction(most[1]) == Fraction(least[0]) + count * length
        assert count == 1 or (count - 1) * length < Fraction(high) - Fraction(least[0])
    assert 500 < refused < 2500


@pytest.mark.parametrize("first", [2**53, -(2**53), 2**62, 2**80])
def test_places_that_doubles_do_not_hold_are_no_grid(first):
    with pytest.raises(InputError, match="far from 0"):
        BoxGrid((0,), (first,), (1,))


def test_boxes_are_halved_only_as_long_as_doubles_hold_their_places():
    whole = BoxGrid((0,), (2**40,), (1,))
    flags = [np.array([True])]
    for levels in range(1, 20):
        divided = (*flags, np.array([False, False]))
        if levels > 11:  # 2^40 + 1 ends the box
            with pytest.raises(InputError, match="far from 0"):
                DividedGrid(whole, divided)
        else:
            grid = DividedGrid(whole, divided)
            low, high = (x.item() for x in grid.bounds(np.array([len(grid) - 2])))
            assert low == 2**40
            assert high - low == 0.5**levels
        flags.append(np.array([True, False]))


def divided(seed):
    """Boxes of several sizes, of a grid whose boxes were halved three times here and there."""
    random = np.random.default_rng(seed)
    found = DividedGrid.of(GRID)
    for _ in range(3):
        found, _ = found.halved(random.random(len(found)) < 0.3)
    return found


@pytest.mark.parametrize("grid", [GRID, *map(divided, range(3))], ids=["alike", *"012"])
def test_boxes_cover_the_region_once_and_those_are_met_that_overlap(grid):
    random = np.random.default_rng(1)
    low, high = grid.bounds(np.arange(len(grid)))
    least, most = (
        bounds[[0, -1]][k] for bounds, k in zip(GRID.bounds(np.arange(35)), (0, 1), strict=True)
    )
    assert (high - low).prod(axis=1).sum() == (most - least).prod()
    points = random.uniform(least, most, (300, 2))
    owner, number, inside = grid.numbers_met(points, points)
    assert inside.all()
    assert sorted(owner.tolist()) == list(range(300))
    assert ((low[number] <= points[owner]) & (points[owner] < high[number])).all()
    corner = random.uniform(least - 0.3, most, (300, 2))
    further = corner + random.random((300, 2)) ** 3
    # some that end on borders
    corner[::7], further[::5] = np.round(4 * corner[::7]) / 4, np.round(4 * further[::5]) / 4 + 1
    owner, number, inside = grid.numbers_met(corner, further)
    told = np.zeros((300, len(grid)), dtype=bool)
    told[owner, number] = True
    assert len(owner) == told.sum()
    met = ((low[None] <= further[:, None]) & (corner[:, None] < high[None])).all(axis=2)
    assert (told == met).all()
    assert (inside == ((corner >= least) & (further < most)).all(axis=1)).all()
    assert 0 < inside.sum() < 300
    if grid is GRID:  # covered where all that is met is good
        good = random.random(len(grid)) < 0.9
        covered = grid.covered(grid.sums(good), corner, further)
        assert (covered == (inside & ~(met & ~good).any(axis=1))).all()
        assert 0 < covered.sum() < 300


def test_a_box_alone_is_a_grid_and_parts_know_what_they_are_parts_of():
    grid = BoxGrid((-2,), (3,), (5,))
    found = DividedGrid.of(grid)
    every = np.arange(5)
    assert all(map(np.array_equal, found.bounds(every), grid.bounds(every)))
    same, origin = found.halved(np.zeros(5, dtype=bool))
    assert same == found
    assert origin.tolist() == [*range(5)]
    more, origin = found.halved(np.array([False, True, False, False, True]))
    assert origin.tolist() == [0, 2, 3, 1, 1, 4, 4]
    last, origin = more.halved(np.array([True, False, False, False, True, False, False]))
    assert origin.tolist() == [1, 2, 0, 0, 3, 5, 6, 4, 4]
    low, high = last.bounds(np.arange(len(last)))
    before = more.bounds(origin)
    assert (before[0] <= low).all()
    assert (high <= before[1]).all()
    assert last.finest.tolist() == [1 / 16]
    assert last == DividedGrid(grid, last.divided)
    assert last != more


def test_what_is_no_number_may_be_in_any_box():
    box = np.array([[np.nan, 2.2]])
    owner, number, inside = BoxGrid((0, 0), (1, 1), (2, 2)).numbers_met(box, box)
    assert owner.tolist() == [0, 0]
    assert number.tolist() == [1, 3]
    assert not inside.any()

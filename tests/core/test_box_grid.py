"""Grids of boxes: what they meet and cover, by looking at every box."""

import random
from fractions import Fraction

import numpy as np
import pytest

from nonsmooth import InputError
from nonsmooth.runtime.core.box_grid import BoxGrid, DividedGrid

GRID = BoxGrid((-2, -1), (-3, 2), (7, 5))


def test_a_grid_covers_its_box_with_sides_that_are_short_enough():
    grid = BoxGrid.around(np.array([-1.0, 0.3]), np.array([2.0, 0.9]), np.array([0.3, 0.1]))
    low, high = grid.bounds(np.arange(len(grid)))
    assert grid.exponents == (-2, -4)
    assert (low.min(axis=0) <= [-1, 0.3]).all()
    assert (high.max(axis=0) >= [2, 0.9]).all()
    assert len(grid) == 12 * 11


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

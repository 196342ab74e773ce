"""Charts from anchor to anchor: what is found, and that it depends on the grid alone."""

import numpy as np
import pytest

from nonsmooth.runtime.explore.charting.anchors import Solver, anchor_starts
from nonsmooth.runtime.explore.charting.grid import Grid


@pytest.mark.parametrize("count", [1, 2, 34, 400])
def test_points_lie_between_their_anchors(count):
    """Each is the mean of the two beside it, as its place in between says."""
    grid = Grid({"p": np.geomspace(1, 2, count), "q": np.linspace(0, 1, 7)}, (13, 3))
    for block in map(grid.block, range(grid.chunks)):
        for axis, anchors, points, cell, fraction in zip(
            grid.axes.values(),
            grid.anchors,
            block.points,
            block.cells,
            block.fractions,
            strict=True,
        ):
            known = axis[anchors]
            assert known[[0, -1]].tolist() == axis[[0, -1]].tolist()
            following = known[np.minimum(cell + 1, len(known) - 1)]
            np.testing.assert_allclose(
                (1 - fraction) * known[cell] + fraction * following, points, rtol=1e-14
            )
            assert ((fraction >= 0) & (fraction <= 1)).all()


@pytest.mark.parametrize("unit", [1.0, 1e-9, 1e9])
def test_most_neighbours_decide_between_orbits_that_are_as_good_in_all_units(unit):
    def either(values, start):
        """One and two units, from the nearer; without a start two at every seventh point."""
        alone = np.arange(values["p"].size) % 7 == 3
        second = alone if start is None else start[:, 0] > 1.5 * unit
        every = np.ones(second.shape)
        return {"status": 0 * every, "admissible": every > 0, "margin": every,
                "x": np.where(second, 2 * unit, unit)}  # fmt: skip

    solver = Solver(either, ["x"], np.array([unit]))
    grid = Grid(dict.fromkeys("pq", np.linspace(0, 1, 20)), (20, 20))
    np.testing.assert_array_equal(anchor_starts(grid, solver)[1:-1, 1:-1, 0], unit)

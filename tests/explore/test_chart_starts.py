"""Charts from anchor to anchor: what is found, and that it depends on the grid alone."""

from typing import Any

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth.runtime.explore.charting.anchors import Solver, anchor_starts, solve_block
from nonsmooth.runtime.explore.charting.grid import Grid, linear_axis

ORBIT = "dry-friction/global-stick"
# where the orbit comes and goes, and has others of the same itinerary beside it
WIDE: dict[str, Any] = {"V": np.linspace(0.3, 2.0, 70), "eta": np.linspace(0.3, 3.0, 61)}


@pytest.fixture(scope="module")
def wide() -> Any:
    return ns.chart(ORBIT, chunk=10**6, **WIDE)


def speckles(period: np.ndarray) -> int:
    """Points whose period is 5 % off all four neighbours, which agree."""
    beside = np.stack([period[:-2, 1:-1], period[2:, 1:-1], period[1:-1, :-2], period[1:-1, 2:]])
    mean = beside.mean(axis=0)
    agree = (np.abs(beside - mean) < 0.05 * mean).all(axis=0)
    return int((agree & (np.abs(period[1:-1, 1:-1] - beside) > 0.05 * mean).all(axis=0)).sum())


def test_more_is_found_than_point_by_point(wide: Any) -> None:
    alone = ns.solve(ORBIT, {"V": WIDE["V"][:, None], "eta": WIDE["eta"]})
    assert alone.admissible is not None
    found = wide.status.values == 0
    assert found[alone.converged].all()
    assert wide.admissible.values[alone.admissible].all()
    assert (~found).sum() < 0.85 * (~alone.converged).sum()
    assert wide.admissible.values.sum() > alone.admissible.sum()


def test_speckles_are_gone(wide: Any) -> None:
    alone = ns.solve(ORBIT, {"V": WIDE["V"][:, None], "eta": WIDE["eta"]})
    assert speckles(alone.period) > 20
    assert speckles(wide.period.values) < 0.2 * speckles(alone.period)


def test_anchors_and_cells() -> None:
    for count in (1, 2, 33, 34, 400):
        axes = (linear_axis("V", 1.0, 1.0 + (count > 1), count), linear_axis("eta", 0.5, 1.5, 7))
        grid = Grid(axes, (min(count, 13), 3))
        anchors, eta = grid.anchors
        assert anchors[0] == 0
        assert anchors[-1] == count - 1
        assert len(np.unique(anchors)) == len(anchors) <= 129
        np.testing.assert_array_equal(eta, np.arange(7))
        for number in range(grid.chunks):
            block, region = grid.block(number), grid.region(number)
            for k, axis in enumerate(axes):
                points, places = block.points[k], grid.anchors[k]
                assert (
                    points[block.inner[k]].tolist()
                    == axis.part(region[k].start, region[k].stop).tolist()
                )
                values = axis.part(0, axis.count)[places]
                upper = np.minimum(block.cells[k] + 1, len(places) - 1)
                width = values[upper] - values[block.cells[k]]
                again = values[block.cells[k]] + block.fractions[k] * width
                np.testing.assert_allclose(again, points, rtol=1e-14)
                assert ((block.fractions[k] >= 0) & (block.fractions[k] <= 1)).all()


def cubic(values: Any, start: np.ndarray | None) -> dict[str, np.ndarray]:
    """Roots of x^3 - 3 x = p by a few steps of Newton's method; |x| > 1 counts as stable.

    Without a start it knows but half of the plane.
    """
    p = values["p"] + 0 * values["q"]
    x = np.where(values["q"] > 0, np.nan, 2.5) if start is None else start[:, 0].copy()
    with np.errstate(all="ignore"):
        for _ in range(6):
            x = x - (x**3 - 3 * x - p) / (3 * x**2 - 3)
        found = np.abs(x**3 - 3 * x - p) < 1e-12
    x[~found] = np.nan
    return {
        "status": np.where(found, 0, 1),
        "admissible": found & (x > -1.5),
        "margin": np.abs(x) - 1,
        "x": x,
    }


def test_what_one_half_knows_reaches_the_other() -> None:
    solver = Solver(cubic, ["x"], np.ones(1))
    axes = (linear_axis("p", -1.5, 6.0, 101), linear_axis("q", -1.0, 1.0, 50))
    grid = Grid(axes, (101, 50))
    starts = anchor_starts(grid, solver)
    assert np.isfinite(starts).all()
    found = solve_block(grid.block(0), starts, solver)
    largest = [np.roots([1, 0, -3, -p]).real.max() for p in axes[0].part(0, 101)]
    np.testing.assert_allclose(found["x"], np.array(largest)[:, None] + np.zeros(50), atol=1e-9)


@pytest.mark.parametrize("unit", [1.0, 1e-9, 1e9])
def test_most_neighbours_decide_between_orbits_that_are_as_good_in_all_units(unit: float) -> None:
    def either(values: Any, start: np.ndarray | None) -> dict[str, np.ndarray]:
        """One and two units, from the nearer; without a start two at every seventh point."""
        alone = np.arange(values["p"].size) % 7 == 3
        second = alone if start is None else start[:, 0] > 1.5 * unit
        every = np.ones(second.shape)
        return {"status": 0 * every, "admissible": every > 0, "margin": every,
                "x": np.where(second, 2 * unit, unit)}  # fmt: skip

    solver = Solver(either, ["x"], np.array([unit]))
    grid = Grid((linear_axis("p", 0.0, 1.0, 20), linear_axis("q", 0.0, 1.0, 20)), (20, 20))
    np.testing.assert_array_equal(anchor_starts(grid, solver)[1:-1, 1:-1, 0], unit)

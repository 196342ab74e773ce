"""Charts from anchor to anchor: what is found, and that it depends on the grid alone."""

from typing import Any

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth.runtime.explore.charting.anchors import Solver, anchor_starts
from nonsmooth.runtime.explore.charting.grid import Grid

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
    grid = Grid(dict.fromkeys("pq", np.linspace(0, 1, 20)), (20, 20))
    np.testing.assert_array_equal(anchor_starts(grid, solver)[1:-1, 1:-1, 0], unit)

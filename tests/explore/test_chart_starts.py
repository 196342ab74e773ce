"""Charts from anchor to anchor: what is found, and that it depends on the grid alone."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth import InputError
from nonsmooth.runtime.explore.charting.anchors import Solver, anchor_starts, solve_block
from nonsmooth.runtime.explore.charting.grid import Grid, linear_axis
from nonsmooth.runtime.model.kernels import load_orbit

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


def assert_same_bits(first: Any, second: Any) -> None:
    assert set(first) == set(second)
    for name in first:
        assert first[name].values.tobytes() == second[name].values.tobytes(), name


def test_more_is_found_than_point_by_point(wide: Any) -> None:
    alone = ns.solve_many(ORBIT, V=WIDE["V"][:, None], eta=WIDE["eta"])
    assert alone.admissible is not None
    found = wide.status.values == 0
    assert found[alone.converged].all()
    assert wide.admissible.values[alone.admissible].all()
    assert (~found).sum() < 0.85 * (~alone.converged).sum()
    assert wide.admissible.values.sum() > alone.admissible.sum()


def test_speckles_are_gone(wide: Any) -> None:
    alone = ns.solve_many(ORBIT, V=WIDE["V"][:, None], eta=WIDE["eta"])
    assert speckles(alone.period) > 20
    assert speckles(wide.period.values) < 0.2 * speckles(alone.period)


def test_symmetric_orbits_are_motions_in_one_piece() -> None:
    plane = {"V": np.linspace(0.5, 1.5, 40), "eta": np.linspace(0.5, 1.5, 40)}
    found = ns.chart("dry-friction/symmetric", **plane)
    alone = ns.solve_many("dry-friction/symmetric", V=plane["V"][:, None], eta=plane["eta"])
    assert alone.admissible is not None
    assert found.admissible.values.sum() > 2 * alone.admissible.sum()
    assert found.admissible.values[alone.admissible].all()


def test_what_is_found_solves_the_full_equations(wide: Any) -> None:
    names = load_orbit(ORBIT).unknowns
    places = np.argwhere(wide.status.values == 0)
    for i, j in np.random.default_rng(3).choice(places, 25, replace=False):
        point = wide.isel(V=int(i), eta=int(j))
        guess = {name: float(point[name]) for name in names}
        orbit = ns.solve(ORBIT, {"V": float(point.V), "eta": float(point.eta)}, guess)
        assert orbit.period == pytest.approx(float(point.period), rel=1e-9)
        assert orbit.trace == pytest.approx(float(point.trace), rel=1e-7, abs=1e-7)
        assert (orbit.admissibility.verdict is not False) == bool(point.admissible)


@pytest.mark.parametrize("chunk", [90, 1000])
def test_bits_do_not_depend_on_chunks_where_orbits_are_lost(wide: Any, chunk: int) -> None:
    assert_same_bits(wide, ns.chart(ORBIT, chunk=chunk, threads=3, **WIDE))


@pytest.mark.parametrize(
    ("orbit", "plane"),
    [
        ("dry-friction/symmetric", {"V": np.linspace(0.5, 1.5, 90)}),
        ("elastic-stop/one-contact", {"k3": np.geomspace(0.1, 50, 14), "T": [3.0, 4.5, 6, 7, 9]}),
        (ORBIT, {"V": np.linspace(0.3, 2, 9), "eta": [0.5, 1, 2.0], "chi": [0.2, 0.5, 0.8]}),
        ("rigid-stop/one-impact", {"T": np.linspace(2, 8, 20), "k1": [0.5, 1.0, 2.0]}),
        (ORBIT, {"V": np.linspace(0.9, 1.1, 12), "us2": [0.3, 0.7, 1.0], "us1": [0.1, 0.5]}),
    ],
)
def test_bits_do_not_depend_on_chunks(orbit: str, plane: dict[str, Any]) -> None:
    whole = ns.chart(orbit, **plane)
    assert_same_bits(whole, ns.chart(orbit, chunk=5, threads=2, **plane))


def test_resumed_where_anchors_matter(wide: Any, tmp_path: Path) -> None:
    store = tmp_path / "F.zarr"
    ns.chart(ORBIT, store=store, chunk=500, **WIDE)
    for file in sorted(store.glob("*/c/1/*")):
        file.unlink()
    assert_same_bits(wide, ns.chart(ORBIT, store=store, threads=1, **WIDE).load())


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


def test_open_parameters_are_judged() -> None:
    plain = ns.chart(ORBIT, V=[0.85, 1.0, 1.1], eta=[0.9, 1.2])
    given = ns.chart(ORBIT, V=[0.85, 1.0, 1.1], eta=[0.9, 1.2], us1=0.1, us2=[0.5, 0.75, 1.2])
    assert given.admissible.dims == ("V", "eta", "us2")
    enough = (plain.least_us2 < given.us2) & (plain.least_us1 < 0.1)
    np.testing.assert_array_equal(given.admissible, plain.admissible & enough)
    seen = set()
    for i, j, k in np.ndindex(3, 2, 3):
        point = given.isel(V=i, eta=j, us2=k)
        values = {name: float(point[name]) for name in ("V", "eta", "us2")}
        verdict = ns.solve(ORBIT, {**values, "us1": "0.1"}).admissibility.verdict
        assert bool(point.admissible) == verdict
        seen.add(given.limit.attrs["meanings"][str(int(point.limit))])
    assert {"none fails", "us2 is too small"} <= seen


def test_forces_in_place_of_their_differences() -> None:
    plane = ns.chart(ORBIT, us1=[0.4, 0.9], ur1=[3.6, 3.9, 4.2])
    for i, j in np.ndindex(2, 3):
        point = plane.isel(us1=i, ur1=j)
        values = {"us1": float(point.us1), "ur1": float(point.ur1)}
        orbit = ns.solve(ORBIT, values, throw=False)
        assert orbit.converged == (int(point.status) == 0)
        assert orbit.trace == pytest.approx(float(point.trace), abs=1e-9)
        assert (orbit.admissibility.verdict is not False) == bool(point.admissible)
    # of ur1, us1 and e1, which has a default, one gives the other: us1 = ur1 - 3.0195
    line = ns.chart(ORBIT, ur1=[3.02, 3.5], e2=0.4831)
    assert line.admissible.values.tolist() == [
        bool(line.least_us1[0] < 3.02 - 3.0195),
        bool(line.least_us1[1] < 3.5 - 3.0195),
    ]


@pytest.mark.parametrize(
    ("orbit", "given", "told"),
    [
        (ORBIT, {"us1": 1, "ur1": 4, "e1": 3}, "e1 follows from ur1 and us1"),
        (ORBIT, {"us1": -1}, "us1 = -1 is outside its domain"),
        (ORBIT, {"z10": 1}, "unknown parameter 'z10'.*known: chi, eta, V, e1, e2, us1"),
        ("dry-friction/symmetric", {"ur1": 1}, "ur1 decides nothing"),
    ],
)
def test_wrong_input(orbit: str, given: dict[str, Any], told: str) -> None:
    with pytest.raises(InputError, match=told) as caught:
        ns.chart(orbit, V=[1.0, 1.1], **given)
    assert "\n" not in str(caught.value)


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
    solver = Solver(cubic, lambda columns: columns["x"][:, None], np.ones(1))
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

    solver = Solver(either, lambda columns: columns["x"][:, None], np.array([unit]))
    grid = Grid((linear_axis("p", 0.0, 1.0, 20), linear_axis("q", 0.0, 1.0, 20)), (20, 20))
    np.testing.assert_array_equal(anchor_starts(grid, solver)[1:-1, 1:-1, 0], unit)

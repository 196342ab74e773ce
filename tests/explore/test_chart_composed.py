"""Charts of orbits that are composed: against single orbits, closed forms, other routes."""

from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth import InputError
from nonsmooth.runtime.explore.charting.chart import chart_problem
from nonsmooth.runtime.explore.charting.grid import Grid
from nonsmooth.runtime.orbits import table_admissible
from nonsmooth.runtime.shooting.multipliers import family_margins
from tests.places import GALLERY
from tests.user_systems import declare

IMPACT = f"{GALLERY / 'impact_oscillator.py'}:one-period"
PLANES: dict[str, dict[str, Any]] = {
    IMPACT: {"sigma": np.linspace(-0.6, 0.6, 24), "w": np.linspace(1.6, 3.2, 21)},
    f"{GALLERY / 'piecewise_stiffness.py'}:subharmonic": {
        "w": np.linspace(2.0, 4.0, 10),
        "gap": np.linspace(-0.2, 0.6, 9),
    },
    f"{GALLERY / 'two_belts.py'}:both-stick": {
        "chi": np.linspace(0.35, 0.7, 12),
        "u1": np.linspace(0.35, 0.7, 12),
    },
}
# that its kernels are compiled takes most of the time
EACH = pytest.mark.parametrize(
    "orbit",
    [
        pytest.param(
            name,
            id=name.rpartition("/")[-1],
            marks=[pytest.mark.slow] if name.endswith("subharmonic") else [],
        )
        for name in PLANES
    ],
)


@cache
def charted(orbit: str) -> Any:
    return ns.chart(orbit, **PLANES[orbit])


@pytest.mark.slow
@EACH
def test_chart_says_what_single_orbits_say(orbit: str) -> None:
    plane = charted(orbit)
    names, found = list(ns.solve(orbit).unknowns), np.argwhere(plane.status.values == 0)
    motions = plane.admissible.values[tuple(found.T)]
    # as many of each kind as there are
    some = np.concatenate([found[motions][::17][:12], found[~motions][::11][:12]])
    for place in some:
        point = plane.isel(dict(zip(plane.sizes, map(int, place), strict=True)))
        values = {str(name): float(point[name]) for name in plane.sizes}
        one: Any = ns.solve(orbit, values, [float(point[name]) for name in names])
        assert one.period == pytest.approx(float(point.period), rel=1e-9)
        assert one.stability.margin == pytest.approx(float(point.margin), abs=1e-8)
        assert one.trace == pytest.approx(float(point.trace), rel=1e-8, abs=1e-8)
        assert one.admissibility.verdict == bool(point.admissible)
        told = plane.limit.attrs["meanings"][str(int(point.limit))]
        if one.admissibility.verdict:
            assert told == "none fails"
        else:
            first = one.admissibility.violations[0]
            assert told == f"phase {first.phase + 1} {first.configuration}: {first.boundary}"


@pytest.mark.slow
@EACH
def test_limits_are_those_of_the_guaranteed_search(
    orbit: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    plane = {name: values[::4] for name, values in PLANES[orbit].items()}
    fast = ns.chart(orbit, **plane)
    monkeypatch.setattr(table_admissible, "compiled_engine", lambda: None)
    np.testing.assert_array_equal(fast.limit.values, ns.chart(orbit, **plane).limit.values)


def test_closed_forms_of_the_impact_oscillator() -> None:
    """Where there is an orbit, and the trace, as the file of the gallery derives them."""
    plane, r = charted(IMPACT), 0.8
    w, sigma = plane.w.values, plane.sigma.values[:, None]
    gain, period = 1 / (1 - w**2), 2 * np.pi / w
    cotangent = 1 / np.tan(period / 2)
    # (sigma + a U)^2 + (b U)^2 = gain^2
    a, b = (1 + r) * cotangent / 2, (1 - r) / (2 * w)
    root = (a * sigma) ** 2 - (a**2 + b**2) * (sigma**2 - gain**2)
    assert (plane.status.values[root > 0] == 0).mean() > 0.99
    assert (plane.status.values[root < 0] == 0).sum() <= 2  # of other periods
    motion = plane.admissible.values & (np.abs(plane.period.values - period) < 1e-9)
    traces = []
    for sign in (1, -1):
        with np.errstate(invalid="ignore"):
            impact = (-a * sigma + sign * np.sqrt(root)) / (a**2 + b**2)
            cosine = (sigma + (1 + r) * cotangent * impact / 2) / gain
            slope = (1 + r) * np.sin(period) * (cosine - sigma) / impact
            traces.append(np.where(impact > 0, -2 * r * np.cos(period) + slope, np.nan))
    off = np.nanmin(np.abs(np.stack(traces) - plane.trace.values)[:, motion], axis=0)
    assert motion.sum() > 200
    assert off.max() < 1e-8
    # both multipliers inside the circle: det = r^2, |trace| < 1 + det
    stable = np.abs(plane.trace.values) < 1 + r**2
    np.testing.assert_array_equal(plane.margin.values[motion] > 0, stable[motion])
    # where there is a stable motion it comes first
    both = motion & np.isfinite(np.stack(traces)).all(axis=0)
    assert (stable[both] | (np.abs(np.stack(traces)).min(axis=0)[both] > 1 + r**2)).mean() > 0.95


def test_period_doubling_is_where_the_margin_vanishes() -> None:
    at = 0.12880531056707573  # w = 2.4
    line = ns.chart(IMPACT, sigma=[at - 1e-3, at, at + 1e-3])
    before, here, behind = line.margin.values
    assert before > 0 > behind
    assert abs(here) < 1e-9


@pytest.mark.slow
@EACH
def test_bits_do_not_depend_on_chunks(orbit: str) -> None:
    other = ns.chart(orbit, chunk=11, threads=2, **PLANES[orbit])
    for name in other:
        assert other[name].values.tobytes() == charted(orbit)[name].values.tobytes(), name


def test_store_and_resume(tmp_path: Path) -> None:
    store = tmp_path / "F.zarr"
    ns.chart(IMPACT, store=store, chunk=60, **PLANES[IMPACT])
    for file in sorted(store.glob("margin/c/1/*")):
        file.write_bytes(file.read_bytes()[:-1])
    again = ns.chart(IMPACT, store=store, **PLANES[IMPACT])
    for name in again:
        assert again[name].values.tobytes() == charted(IMPACT)[name].values.tobytes(), name


def test_neutral_where_the_map_keeps_the_area() -> None:
    line = ns.chart(IMPACT, w=np.linspace(2.2, 2.8, 9), r=1)
    inside = np.abs(line.trace.values) < 2
    assert inside.any()
    assert (line.margin.values[inside] == 0).all()
    assert (line.margin.values[np.abs(line.trace.values) > 2.001] < 0).all()


def test_margins_of_families() -> None:
    """One multiplier is 1; a reciprocal pair beside it is neutral on the circle."""
    angle = np.exp(0.7j)
    values = np.array([[1, angle, 1 / angle], [1, 3.0, 1 / 3.0], [0.5, 1, 0.2]], dtype=complex)
    margins = family_margins(values, values.sum(axis=-1).real, 3)
    np.testing.assert_allclose(margins, [0, -2, 0.5], atol=1e-12)
    np.testing.assert_allclose(
        family_margins(np.array([[1, 0.25 + 0j]]), np.array([1.25]), 2), [0.75]
    )


CHAIN = """
import sympy as sp
from nonsmooth.derive import Itinerary, Parameter, Reference, SoftStop, oscillator

k = Parameter("k", "stiffness of the stop")
system = oscillator(
    "chain",
    ["x1", "x2", "x3"],
    mass=sp.eye(3),
    stiffness=[[2, -1, 0], [-1, 2, -1], [0, -1, 2]],
    elements=[SoftStop("x1", at=sp.Rational(3, 10), stiffness=k.symbol, name="stop")],
    parameters=[k],
)
start = {"x10": "0.3", "x20": "0.42", "x30": "0.3", "v10": "0.73", "v20": "1.03", "v30": "0.73"}
orbits = [
    Itinerary(
        "mode",
        system,
        [("contact", "stop-leaves-stop", "on"), ("free", "stop-reaches-stop", "off")],
        period=Parameter("T", "period"),
        reference=Reference({"k": "0.1", "T": "8.14"}, {"on": "3.24", "off": "4.9", **start}),
    )
]
"""


def test_a_family_is_swept_by_its_period(tmp_path: Path) -> None:
    name = f"{declare(tmp_path, CHAIN)}:mode"
    plane = ns.chart(name, T=np.linspace(7.95, 8.2, 8), k=[0.1, 0.2, 0.4])
    found = np.argwhere(plane.status.values == 0)
    assert len(found) > 15
    for i, j in found[::4]:
        point = plane.isel(T=int(i), k=int(j))
        values = {str(axis): float(point[axis]) for axis in plane.sizes}
        names = ["on", "off", *(f"{x}{n}0" for x in "xv" for n in (1, 2, 3))]
        one: Any = ns.solve(name, values, [float(point[n]) for n in names])
        assert float(point.period) == pytest.approx(values["T"], rel=1e-12)
        assert one.stability.margin == pytest.approx(float(point.margin), abs=1e-7)
        assert one.admissibility.verdict == bool(point.admissible)


def test_a_point_outside_a_domain_has_no_orbit() -> None:
    line = ns.chart(IMPACT, r=[0.7, 0.8, 1.5])
    assert (line.status.values == 0).tolist() == [True, True, False]
    assert np.isnan(line.margin.values[2])
    assert (line.limit.values >= -1).tolist() == [True, True, False]


def test_chunk_knows_its_points_alone() -> None:
    """What is computed of a chunk is the same without the others."""
    problem, axes = chart_problem(IMPACT, PLANES[IMPACT], False, None, 0)
    grid, whole = Grid(axes, (5, 4)), Grid(axes, (24, 21))
    prepared = problem.prepare(grid)
    assert prepared.tobytes() == problem.prepare(whole).tobytes()
    every = problem.compute(whole.block(0), prepared)
    for number in (0, 7, grid.chunks - 1):
        part = problem.compute(grid.block(number), prepared)
        for name, column in part.items():
            assert column.tobytes() == every[name][grid.region(number)].tobytes(), name


@pytest.mark.parametrize(
    ("given", "told"),
    [
        ({"frequency": 2}, "unknown parameter 'frequency'"),
        ({"r": 2}, "r = 2 is outside its domain"),
        ({"T": 2}, "unknown parameter 'T'"),
    ],
)
def test_wrong_input(given: dict[str, Any], told: str) -> None:
    with pytest.raises(InputError, match=told):
        ns.chart(IMPACT, w=[2.0, 2.1], **given)

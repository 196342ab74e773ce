"""What a chart says of a point agrees with what is solved and proved there."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth.runtime.explore.charting.classes import parts_of
from nonsmooth.runtime.present.pictures.charts import _outlines, _sides

pytest.importorskip("zarr")

STICK = "dry-friction/global-stick"
RNG = np.random.default_rng(13)
POINTS = [(int(i), int(j)) for i, j in RNG.integers(0, 10, (12, 2))]


@cache
def plane() -> Any:
    return ns.chart(STICK, V=np.linspace(0.6, 1.9, 10), eta=np.linspace(0.6, 1.7, 10))


@cache
def kinds() -> np.ndarray:
    found = np.full(plane().status.shape, "", dtype=object)
    for part in parts_of(plane()):
        found[part.where] = part.kind
    return found


def test_no_point_is_said_to_have_no_orbit() -> None:
    (none,) = [part.name for part in parts_of(plane()) if part.kind == "none"]
    assert none == "none found"
    assert (kinds() == "none").any()
    assert (kinds() == "limit").any()
    assert (kinds() == "stable").any()


@pytest.mark.parametrize(("i", "j"), POINTS)
def test_a_point_is_what_its_orbit_is(i: int, j: int) -> None:
    point = plane().isel(V=i, eta=j)
    if kinds()[i, j] == "none":
        return  # nothing is claimed
    given = {"V": repr(float(point.V)), "eta": repr(float(point.eta))}
    names = ns.solve(STICK).unknowns
    orbit = ns.solve(STICK, given, {name: float(point[name]) for name in names})
    for name, value in orbit.unknowns.items():
        assert value == pytest.approx(float(point[name]), rel=1e-6, abs=1e-6)
    motion = orbit.admissibility.verdict in (True, "conditional")
    assert motion == (kinds()[i, j] != "limit")
    if motion:
        assert kinds()[i, j] == orbit.stability.verdict


@pytest.mark.parametrize("kind", ["stable", "limit"])
def test_a_proof_agrees(kind: str) -> None:
    i, j = np.argwhere(kinds() == kind)[3]
    point = plane().isel(V=i, eta=j)
    given = {"V": repr(float(point.V)), "eta": repr(float(point.eta))}
    names = ns.solve(STICK).unknowns
    orbit = ns.solve(STICK, given, {name: float(point[name]) for name in names})
    claims = ns.certify(orbit).claims
    assert claims["existence"] == "proved"
    assert claims["admissibility"] == ("proved" if kind == "stable" else "refuted")


@pytest.mark.parametrize("case", range(5))
def test_outlines_go_along_the_cells(case: int) -> None:
    rng = np.random.default_rng(case)
    x, y = np.sort(rng.uniform(0, 1, 9)), np.sort(rng.uniform(0, 5, 6))
    labels = rng.integers(0, 3, (9, 6))
    lines = _outlines(labels, x, y)
    changes = (labels[1:] != labels[:-1]).sum() + (labels[:, 1:] != labels[:, :-1]).sum()
    assert len(lines) == changes
    left, below = _sides(x), _sides(y)

    def label(point: np.ndarray) -> int:
        i = int(np.searchsorted(left, point[0])) - 1
        return int(labels[i, int(np.searchsorted(below, point[1])) - 1])

    for first, last in lines:
        middle, across = (first + last) / 2, 1e-9 * (last - first)[::-1]
        assert label(middle + across) != label(middle - across)

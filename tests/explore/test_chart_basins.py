"""Basins as charts: the labels of planes in memory, whatever the chunks, and resumed."""

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy as sp

import nonsmooth as ns
from nonsmooth import InputError
from nonsmooth.derive import Harmonic, SoftStop, System, oscillator
from nonsmooth.runtime.explore.finding.basins import basins
from tests.cli.test_cli import told
from tests.pictures import figure_in

STARTS: dict[str, Any] = {"x1": np.linspace(-1.5, 1.5, 11), "v1": np.linspace(-1, 1, 7)}
DATA = {"Omega": "1.3", "F": "0.3"}


def two_attractors() -> System:
    """Two forced masses behind a gap: with and without contact."""
    Omega, F = sp.symbols("Omega F")
    return oscillator(
        "two-attractors",
        ["x1", "x2"],
        [[1, 0], [0, 1]],
        [[1, 0], [0, 5]],
        [["0.1", 0], [0, 1]],
        forcing=[Harmonic(Omega, cosine={"x1": F})],
        elements=[SoftStop("x1", at=1, stiffness=15, name="stop")],
    )


@pytest.fixture(scope="module")
def found(tmp_path_factory: pytest.TempPathFactory) -> Path:
    file = tmp_path_factory.mktemp("found") / "found.json"
    box = {"x1": (-1.5, 1.5), "v1": (-1, 1)}
    ns.find_orbits(two_attractors(), DATA, 40, transitions=200, box=box).save(file)
    return file


@pytest.mark.slow
def test_a_chart_has_the_labels_of_single_planes(found: Path, tmp_path: Path) -> None:
    plane = ns.chart(str(found), **STARTS, start={"x2": "1/2"})
    x, v = (("x1", -1.5, 1.5, 11), ("v1", -1.0, 1.0, 7))
    expected = basins(ns.load(found), x, v, {"x2": "1/2"}).labels.T
    np.testing.assert_array_equal(plane.attractor, expected + (expected >= 0))
    assert len(np.unique(plane.attractor)) >= 2
    assert (plane.status == 0).all()
    names = plane.attractor.attrs["meanings"]
    assert names["1"].startswith("orbit 1, period ")
    store = tmp_path / "basins.zarr"
    ns.chart(str(found), **STARTS, start={"x2": "1/2"}, store=store)
    counts = told("chart", str(store))["points"]
    assert sum(counts.values()) == plane.attractor.size
    assert counts[names["1"]] == int((plane.attractor == 1).sum())
    legend = figure_in(store).axes[0].get_legend()
    assert names["1"] in "".join(text.get_text() for text in legend.get_texts())
    ns.chart(str(found), x1=STARTS["x1"], store=tmp_path / "line.zarr")
    assert figure_in(tmp_path / "line.zarr").axes[0].lines


def test_bits_are_the_same_for_any_chunks_and_threads_and_after_a_stop(
    found: Path, tmp_path: Path
) -> None:
    whole = ns.chart(str(found), **STARTS)
    store = tmp_path / "basins.zarr"

    def stop(done: int, total: int) -> None:
        if done > total // 2:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        ns.chart(str(found), store=store, chunk=6, threads=2, progress=stop, **STARTS)
    moved = found.with_name("moved.json")
    found.rename(moved)  # the store holds the attractors
    work = told("chart", str(store), "--workers", "1")
    moved.rename(found)
    assert 0 < work["computed"] < work["chunks"]
    again = ns.load(store)
    assert again.attractor.values.tobytes() == whole.attractor.values.tobytes()
    with pytest.raises(InputError, match="holds another chart: start"):
        ns.chart(str(found), store=store, start={"x2": 1}, **STARTS)


@pytest.mark.parametrize(
    ("options", "match"),
    [
        ({"Omega": [1.0, 2.0]}, "unknown state 'Omega'.*charted over states.*:1 is its first"),
        ({"x1": [0.0, 1.0], "v1": 1.0}, "v1 has one value.*--from gives the other states"),
        ({"x1": [0.0, 1.0], "start": {"q": 1}}, "unknown state 'q'"),
        ({"x1": [0.0, 1.0], "start": {"c1": 0}}, r"c1\^2 \+ s1\^2 is 0, not 1"),
        ({"x1": [0.0, 1.0], "start": {"x1": 0}, "simulate": True}, "without simulate"),
        ({}, "nothing to chart"),
    ],
)
def test_wrong_planes(found: Path, options: dict[str, Any], match: str) -> None:
    with pytest.raises(InputError, match=match):
        ns.chart(str(found), **options)


def test_a_file_without_attractors(found: Path, tmp_path: Path) -> None:
    file, known = tmp_path / "none.json", ns.load(found)
    replace(known, orbits=(), equilibria=(), labels=np.full_like(known.labels, -1)).save(file)
    with pytest.raises(InputError, match=r"none\.json holds no orbit or equilibrium"):
        ns.chart(str(file), x1=[0.0, 0.1])

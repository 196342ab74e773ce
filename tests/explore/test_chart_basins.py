"""Basins as charts: where single starts lead, whatever the chunks, and resumed."""

from dataclasses import replace

import numpy as np
import pytest
import sympy as sp

import nonsmooth as ns
from nonsmooth import InputError
from nonsmooth.derive import Harmonic, SoftStop, oscillator
from nonsmooth.runtime.explore.finding.outcomes import Outcome
from nonsmooth.runtime.present.pictures.charts import chart_figure
from tests.cli.test_cli import told
from tests.pictures import figure_in

STARTS = {"x1": np.linspace(-1.5, 1.5, 11), "v1": np.linspace(-1, 1, 7)}
DATA = {"Omega": "1.3", "F": "0.3"}


def two_attractors():
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
def found(tmp_path_factory):
    file = tmp_path_factory.mktemp("found") / "found.json"
    box = {"x1": (-1.5, 1.5), "v1": (-1, 1)}
    ns.find_orbits(two_attractors(), DATA, 40, transitions=200, box=box).save(file)
    return file


@pytest.mark.slow
def test_labels_agree_with_following_single_starts(found, tmp_path):
    store, known = tmp_path / "basins.zarr", ns.load(found)
    plane = ns.chart(str(found), **STARTS, start={"x2": "1/2"}, store=store)
    numbers = plane.attractor.values
    assert (plane.status == 0).all()
    assert np.unique(numbers).tolist() == [1, 2]
    for place in np.ndindex(numbers.shape):
        orbit = known.orbits[numbers[place] - 1].orbit
        x, v = (float(plane[name][k]) for name, k in zip(STARTS, place, strict=True))
        start = {"x1": x, "v1": v, "x2": 0.5, "v2": 0}
        motion = ns.simulate(two_attractors(), DATA, start, until=400)
        lasted = np.diff(motion.times[motion.times > 350])
        assert (len(lasted) > 0) == (len(orbit.itinerary) > 1)
        for dwell in lasted[1:-1]:
            assert np.abs(orbit.dwell_times - dwell).min() < 1e-6
    names = plane.attractor.attrs["meanings"]
    for number, entry in enumerate(known.orbits, 1):
        assert names[str(number)].startswith(f"orbit {number}, period {entry.period:.6g}")
    counts = told("chart", str(store))["points"]
    assert sum(counts.values()) == numbers.size
    assert counts[names["1"]] == int((numbers == 1).sum())


@pytest.mark.slow
def test_a_picture_has_the_colours_of_the_legend(found, tmp_path):
    pytest.importorskip("matplotlib")
    plane = ns.chart(str(found), **STARTS)
    numbers = np.arange(77).reshape(11, 7) % 3
    plane.attractor.values[:] = np.where(numbers == 0, int(Outcome.UNCLASSIFIED), numbers)
    line = ns.chart(str(found), x1=STARTS["x1"], store=tmp_path / "line.zarr")
    strip = figure_in(tmp_path / "line.zarr")
    assert not strip.axes[0].get_yticks().size
    for chart, figure in ((plane, chart_figure(plane)), (line, strip)):
        (axes,) = figure.axes
        (mesh,) = (each for each in axes.collections if hasattr(each, "get_coordinates"))
        shown = mesh.to_rgba(mesh.get_array()).reshape(-1, 11, 4)
        numbers = np.broadcast_to(chart.attractor.values.T, shown.shape[:2])
        handles, labels = axes.get_legend_handles_labels()
        names = chart.attractor.attrs["meanings"]
        assert len(labels) == len(np.unique(chart.attractor))
        for handle, label in zip(handles, labels, strict=True):
            name, _, share = label.rpartition(" (")
            (number,) = (int(key) for key, text in names.items() if text == name)
            here = numbers == number
            assert share == f"{100 * here.mean():.1f} %)"
            np.testing.assert_allclose(shown[here], [handle.get_facecolor()[0]] * here.sum())


def test_no_more_basins_than_can_be_told_apart(found, tmp_path):
    pytest.importorskip("matplotlib")
    file, known = tmp_path / "many.json", ns.load(found)
    replace(known, orbits=known.orbits[:1] * 25).save(file)
    plane = ns.chart(str(file), **STARTS)
    plane.attractor.values[:] = np.arange(77).reshape(11, 7) % 25 + 1
    with pytest.raises(InputError, match="more than 24 parts like orbit 25"):
        chart_figure(plane)


def test_equilibria_and_no_configuration_have_labels(tmp_path):
    file, data = tmp_path / "found.json", {"m1": 1, "m2": 2, "k1": 1, "k2": 5, "r": 1}
    quiet = ns.find_orbits("rigid-stop", data, 4, transitions=50, box={"x1": (-0.9, 0.9)})
    quiet.save(file)
    labels = ns.chart(str(file), x1=[0.0, 1.0, 2.0], v1=[0.0, 0.1]).attractor.values
    assert (labels[2] == Outcome.ILLEGAL).all()
    assert labels[0, 0] == len(quiet.orbits) + 1  # the equilibrium
    assert set(labels.ravel().tolist()) <= {*range(1, len(quiet.orbits) + 2), *Outcome}
    assert labels[0, 1] == Outcome.FAMILY


def test_bits_are_the_same_for_any_chunks_and_threads_and_after_a_stop(found, tmp_path):
    whole = ns.chart(str(found), **STARTS)
    store = tmp_path / "basins.zarr"

    def stop(done, total):
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
        ({"x1": [0.0, 1.0], "v1": 1.0}, "v1 has one value.*the start gives the other states"),
        ({"x1": [0.0, 1.0], "start": {"q": 1}}, "unknown state 'q'"),
        ({"x1": [0.0, 1.0], "start": {"x1": 0}}, "x1 is charted: the start gives the other states"),
        ({"x1": [0.0, 1.0], "start": {"c1": 0}}, r"c1\^2 \+ s1\^2 is 0, not 1"),
        ({"x1": [0.0, 1.0], "start": {"x1": 0}, "simulate": True}, "without simulate"),
        ({}, "nothing to chart"),
    ],
)
def test_wrong_planes(found, options, match):
    with pytest.raises(InputError, match=match):
        ns.chart(str(found), **options)


def test_a_file_without_attractors(found, tmp_path):
    file, known = tmp_path / "none.json", ns.load(found)
    replace(known, orbits=(), equilibria=(), labels=np.full_like(known.labels, -1)).save(file)
    with pytest.raises(InputError, match=r"none\.json holds no orbit or equilibrium"):
        ns.chart(str(file), x1=[0.0, 0.1])

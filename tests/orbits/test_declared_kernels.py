"""Declared orbits that are composed are found at many points by compiled kernels of their own."""

import os
import shutil
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

import nonsmooth as ns
from nonsmooth import InputError
from nonsmooth.derive import Itinerary, Parameter, Reference, RigidStop
from nonsmooth.runtime.explore.charting.chart import chart_problem
from nonsmooth.runtime.model.kernels import key_of_many, load_orbit
from nonsmooth.runtime.model.loading import background
from nonsmooth.runtime.orbits.solve import declared_kernels
from tests.one_mass import one_mass
from tests.places import GALLERY
from tests.tables import slow

pytestmark = pytest.mark.skipif(background.lacking() is not None, reason=str(background.lacking()))

ONE_PERIOD = f"{GALLERY / 'impact_oscillator.py'}:one-period"
SUBHARMONIC = f"{GALLERY / 'piecewise_stiffness.py'}:subharmonic"
BOXES = {
    ONE_PERIOD: {"r": (0.5, 0.95), "sigma": (-0.2, 0.2), "w": (2.2, 3.0)},
    f"{GALLERY / 'switched_damping.py'}:limit-cycle": {
        "driven": (-0.2, -0.05),
        "damped": (0.1, 0.6),
    },
    f"{GALLERY / 'two_stops.py'}:symmetric": {"d": (0.4, 0.6), "r": (0.6, 0.95)},
    SUBHARMONIC: {"w": (2.6, 3.9), "gap": (-0.1, 0.5)},
}


@pytest.fixture(autouse=True)
def own_backend(monkeypatch):
    monkeypatch.delenv("NONSMOOTH_BACKEND", raising=False)


def points_in(orbit, count, seed=5):
    rng = np.random.default_rng(seed)
    return {name: rng.uniform(*ends, count) for name, ends in BOXES[orbit].items()}


def by_tables(orbit, monkeypatch, values, **options):
    with monkeypatch.context() as elsewhere:
        elsewhere.setenv("NONSMOOTH_BACKEND", "numpy")
        assert declared_kernels(load_orbit(orbit)) is None
        return ns.solve(orbit, values, **options)


@pytest.mark.parametrize(
    "orbit",
    [
        pytest.param(
            orbit,
            id=orbit.rpartition("/")[-1],
            # kernels that no other test needs are compiled first
            marks=[] if orbit == ONE_PERIOD else [pytest.mark.slow],
        )
        for orbit in BOXES
    ],
)
def test_verdicts_are_those_of_the_tables(orbit, monkeypatch):
    assert declared_kernels(load_orbit(orbit)) is not None
    values = points_in(orbit, 120)
    fast = ns.solve(orbit, values)
    slow = by_tables(orbit, monkeypatch, values)
    assert list(fast.unknowns) == list(slow.unknowns) == list(ns.solve(orbit).unknowns)
    assert fast.parameters.keys() == slow.parameters.keys()
    assert fast.name == slow.name
    apart = [np.abs(fast.unknowns[n] - slow.unknowns[n]) for n in fast.unknowns]
    same = fast.converged & slow.converged & (np.max(apart, axis=0) < 1e-8)
    assert same.sum() > 40
    assert_array_equal(fast.admissible[same], slow.admissible[same])
    assert_allclose(fast.trace[same], slow.trace[same], rtol=1e-7, atol=1e-9)
    assert_allclose(fast.period[same], slow.period[same], rtol=1e-10)
    assert_allclose(fast.starts[same], slow.starts[same], rtol=1e-8, atol=1e-8)
    # no motion is lost
    assert (fast.admissible >= slow.admissible).all()
    other = ns.solve(orbit, values, threads=2, chunk=7)
    for name, row in fast.unknowns.items():
        assert other.unknowns[name].tobytes() == row.tobytes(), name


@pytest.mark.parametrize(
    "orbit",
    [
        pytest.param(ONE_PERIOD, id="kernels alone"),
        pytest.param(SUBHARMONIC, id="tables too", marks=pytest.mark.slow),
    ],
)
def test_a_point_has_the_bits_of_itself(orbit):
    """Not of the others, of their number, or of how often it was asked for."""
    values = points_in(orbit, 40)
    together = ns.solve(orbit, values)
    for place in (17, int(np.argmin(together.admissible)), int(np.argmax(together.admissible))):
        alone = ns.solve(orbit, {name: row[[place]] for name, row in values.items()})
        for name, row in together.unknowns.items():
            assert row[place].tobytes() == alone.unknowns[name].tobytes(), name
        assert together.trace[place].tobytes() == alone.trace.tobytes()


def closed_form(w, sigma, r):
    """Impact velocities of both orbits, as the file of the gallery derives them."""
    gain, cotangent = 1 / (1 - w**2), 1 / np.tan(np.pi / w)
    a, b = (1 + r) * cotangent / 2, (1 - r) / (2 * w)
    root = np.sqrt((a * sigma) ** 2 - (a**2 + b**2) * (sigma**2 - gain**2))
    return (-a * sigma + root) / (a**2 + b**2), (-a * sigma - root) / (a**2 + b**2)


def test_of_both_roots_the_motion_is_found():
    values = points_in(ONE_PERIOD, 1000, seed=8)
    # beside the resonance w = 2 one impact is many times as hard as at the reference
    values["w"][:100] = np.random.default_rng(9).uniform(2.02, 2.06, 100)
    found = ns.solve(ONE_PERIOD, values)
    with np.errstate(invalid="ignore"):
        roots = np.stack(closed_form(values["w"], values["sigma"], values["r"]))
    # an orbit of that period, and not of several
    assert_allclose(found.period[found.converged],
                               2 * np.pi / values["w"][found.converged], rtol=1e-12)  # fmt: skip
    assert_array_equal(found.converged, np.isfinite(roots).any(axis=0))
    speed = -found.unknowns["v0"] / values["r"]
    off = np.abs(roots - speed).min(axis=0) / np.maximum(1, np.abs(speed))
    assert off[found.converged].max() < 1e-9
    assert 0.4 < found.admissible.mean() < 1
    assert (speed[found.admissible] > 0).all()
    # where it penetrates the other one does so too, or there it comes from behind the stop
    other = roots[np.abs(roots - speed).argmax(axis=0), np.arange(roots.shape[1])]
    rest = found.converged & ~found.admissible & (other > 0)
    values = {name: row[rest] for name, row in values.items()}
    for place in range(0, int(rest.sum()), max(1, int(rest.sum()) // 6)):
        point = {name: float(row[place]) for name, row in values.items()}
        start = [2 * np.pi / point["w"], point["sigma"], -point["r"] * other[rest][place]]
        one = ns.solve(ONE_PERIOD, point, dict(zip(("T", "x0", "v0"), start, strict=True)))
        assert one.admissibility.verdict is False


@pytest.mark.slow
def test_where_kernels_find_no_motion_tables_look_for_one(monkeypatch):
    """Newton's method on fewer unknowns ends at another root there."""
    values = {"w": np.linspace(3.4, 3.9, 8), "gap": np.full(8, 0.2)}
    own = declared_kernels(load_orbit(SUBHARMONIC))
    assert not own.alone
    every = {**load_orbit(SUBHARMONIC).table["reference"]["parameters"], **values}
    kernels = own.by_kernels(every)
    assert not kernels.admissible.all()
    both = ns.solve(SUBHARMONIC, values)
    tables = by_tables(SUBHARMONIC, monkeypatch, values)
    lost = ~kernels.admissible
    for name, row in both.unknowns.items():
        assert_allclose(row[lost], tables.unknowns[name][lost], rtol=1e-12)
        assert_array_equal(row[~lost], kernels.unknowns[name][~lost])
    # they are looked for where nobody asks for the verdicts, too
    empty = ns.solve(SUBHARMONIC, {"w": np.empty((0, 3))})
    assert empty.status.shape == empty.admissible.shape == (0, 3)
    plain = ns.solve(SUBHARMONIC, values, admissibility=False)
    assert plain.admissible is None
    assert plain.trace.tobytes() == both.trace.tobytes()


@cache
def two_stops():
    """The restitution of the stop that is far away decides nothing; C has both names."""
    far = Parameter("M_PI", "restitution of the other", lower=0, upper=1, upper_closed=True)
    w = Parameter("cos", "frequency")
    system = one_mass(
        "two-sided", RigidStop("x", at=0, restitution="0.8", name="near"),
        RigidStop("x", at=-50, restitution=far.symbol, side="lower", name="other"),
        forces={w.symbol: 1}, damping="0.1", parameters=[far, w],
    )  # fmt: skip
    return Itinerary(
        "one",
        system,
        [("free-free", "near-reaches-stop", "T")],
        reference=Reference({"M_PI": "0.5", "cos": "2"}, {"T": "3.14"}),
    )


@pytest.mark.slow
@pytest.mark.parametrize("backend", [slow(""), "numpy"])
def test_parameters_that_decide_nothing_have_domains_and_names_of_functions_in_c(
    backend, monkeypatch
):
    orbit = two_stops()
    monkeypatch.setenv("NONSMOOTH_BACKEND", backend)
    assert (declared_kernels(load_orbit(orbit)) is None) == (backend == "numpy")
    found = ns.solve(orbit, {"M_PI": [0.5, 1.5, 1.0], "cos": 2.0})
    assert found.converged.tolist() == [True, False, True]
    assert np.isnan(found.unknowns["x0"]).tolist() == [False, True, False]
    # FLOWS of one forced, damped mass: the impact velocity is the root of a quadratic
    assert -found.unknowns["v0"][0] / 0.8 == pytest.approx(3.9016492908886392, rel=1e-13)
    assert found.trace[0] == pytest.approx(1.36747825761582, rel=1e-12)
    line = ns.chart(load_orbit(orbit).name, M_PI=[0.5, 1.0, 1.5], cos=2.0)
    assert (line.status.values == 0).tolist() == [True, True, False]
    with pytest.raises(InputError, match="unknown parameter 'near'"):
        ns.solve(orbit, {"near": 0.5})
    assert ns.solve(orbit, {"M_PI": "1/2", "cos": [2]}).converged.all()


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"w": [True]}, "parameter w: bool is no type of real numbers"),
        ({"w": np.array([1j])}, "parameter w: complex128 is no type"),
        ({"w": ["5/2 w"]}, "parameter w: '5/2 w' is not a number"),
        ({"w": [2.4, 2.5], "r": [0.7, 0.8, 0.9]}, "the parameters do not broadcast: "),
        ({"nu": 2.4}, "unknown parameter 'nu'"),
    ],
)
def test_wrong_arrays_are_refused_in_the_same_words(values, message, monkeypatch):
    """And before kernels are compiled, which takes seconds."""
    with monkeypatch.context() as elsewhere:
        elsewhere.setattr("nonsmooth.runtime.orbits.solve.declared_kernels", None)
        with pytest.raises(InputError, match=message) as early:
            ns.solve(ONE_PERIOD, values)
    with pytest.raises(InputError, match=message) as late:
        by_tables(ONE_PERIOD, monkeypatch, values)
    assert str(early.value) == str(late.value)


def test_kernels_whose_tables_went_are_made_again(tmp_path, monkeypatch):
    """The cache is kept small file by file: one of the two may go alone."""
    assert declared_kernels(load_orbit(ONE_PERIOD)) is not None
    key, folder = key_of_many(load_orbit(ONE_PERIOD)), Path(os.environ["NONSMOOTH_CACHE"])
    for path in folder.glob(f"{key}*"):
        shutil.copy2(path, tmp_path)
    monkeypatch.setenv("NONSMOOTH_CACHE", str(tmp_path))

    def found():
        library = background.KernelLibrary(key, None, "impact_oscillator")
        return library.module() is not None

    assert found()
    (tmp_path / f"{key}.py").unlink()
    assert not found()


def test_a_chart_keeps_the_kernels_that_it_began_with(tmp_path, monkeypatch):
    store, w = tmp_path / "F.zarr", np.linspace(2.3, 2.5, 6)
    before = ns.chart(ONE_PERIOD, store=store, chunk=2, w=w)
    problem, _ = chart_problem(ONE_PERIOD, {"w": w}, False, None, 0)
    assert problem.identity()["kernels"] == "c"
    (store / "trace" / "c" / "1").unlink()
    with monkeypatch.context() as elsewhere:
        elsewhere.setenv("NONSMOOTH_BACKEND", "numpy")
        with pytest.raises(InputError, match=r"compiled kernels of .* are not there any more"):
            problem.identity()
        with pytest.raises(InputError, match="computed by kernels in c, here they are in numpy"):
            ns.chart(str(store))
        other = ns.chart(ONE_PERIOD, w=w)
    again = ns.chart(str(store))
    for name in again:
        assert again[name].values.tobytes() == before[name].values.tobytes(), name
        assert_allclose(other[name].values, before[name].values, rtol=1e-9, atol=1e-9)
    assert sorted(other) == sorted(before)

"""Parameters from measurements, against the truth behind synthetic data."""

import math
import zipfile
import zlib

import numpy as np
import pytest
import sympy as sp
from scipy import optimize, sparse
from scipy.io import savemat
from scipy.stats import norm
from scipy.stats import t as student

import nonsmooth as ns
from nonsmooth import InputError, Interrupted
from nonsmooth.derive import (
    DeclarationError,
    RigidStop,
    read_matrices,
)
from tests.differences import in_doubles
from tests.one_mass import one_mass
from tests.tables import slow
from tests.unpacking import unpacked_pieces

k, m, r, c = sp.symbols("k m r c")
STOP = RigidStop("x", at=0.2, restitution=r, name="wall")
SYSTEM = one_mass("struck", STOP, mass=m, damping=c, stiffness=k)
FORCED = one_mass("struck-forced", STOP, damping=c, stiffness=k, forces={"2.1": 1})
TRUTH = {"k": 4.0, "m": 1.0, "r": 0.9, "c": 0.02}
START = {"x": -1.0, "v": 0.0}
WALL = "wall-reaches-stop"
REACHED = ns.simulate(SYSTEM, TRUTH, START, transitions=20)
TIMES = np.linspace(0.05, 8, 60)


def impacts(count=8, sigma=0.0, seed=0):
    times = [t for t, names in zip(REACHED.times, REACHED.boundaries, strict=True) if WALL in names]
    return np.array(times[:count]) + sigma * np.random.default_rng(seed).normal(size=count)


def series(sigma=0.0, seed=0):
    noise = sigma * np.random.default_rng(seed).normal(size=len(TIMES))
    return {"t": TIMES, "x": ns.simulate(SYSTEM, TRUTH, START, until=9)(TIMES)[:, 0] + noise}


def fitted(data, *free, **options):
    known = options.pop("known", TRUTH | options.pop("parameters", {}))
    given = {"parameters": known, "free": free, "start": START, **options}
    return ns.fit(SYSTEM, data, **given)


GUESS = {"k": 4.2, "r": 0.87}


# --- the truth comes back


def shifted():
    """Of a clock that is 3 ahead."""
    return {**series(), "t": TIMES + 3.0, WALL: np.r_[impacts(5) + 3.0, [np.nan] * 55]}


def with_gaps():
    """Without some values, and without the third impact."""
    gaps, events = series(), impacts()
    gaps["x"][5:20] = events[2] = np.nan
    return [gaps, {WALL: events}]


def of_two_masses():
    """Experiments with parameters, one of them in a column, and starts of their own."""
    heavy = ns.simulate(SYSTEM, {**TRUTH, "m": 2}, {"x": -0.8, "v": 0.3}, until=9)
    columns = {"t": TIMES, "x": heavy(TIMES)[:, 0], "m": np.full(len(TIMES), 2.0)}
    second = ns.Experiment(data=columns, start={"x": -0.7, "v": 0.2})
    return [ns.Experiment(data=series(), parameters={"m": 1}), second]


# data, with what they lead to from other values
TOLD = {
    "events": ({WALL: impacts()}, {"k": 4, "r": 0.9, "v0": 0}, {}),
    "series": (series(), {"k": 4, "r": 0.9, "v0": 0}, {}),
    "clock and start": (
        shifted(),
        {"offset": 3, "x0": -1, "k": 4},
        {"parameters": {"k": 4.1}, "offset": 2.9, "start": {"x": -0.95, "v": 0}},
    ),
    "gaps": (with_gaps(), {"k": 4, "r": 0.9}, {}),
    "without noise": (
        [series(), {WALL: impacts()}], {"k": 4, "r": 0.9}, {"sigma": None}
    ),
    # with k = 1.2, where the first step would go, the mass comes to the wall half as often
    "a step too far": (
        {WALL: impacts()}, {"k": 4, "r": 0.9}, {"parameters": {"k": 6.0, "r": 0.95}}
    ),
    "experiments": (
        of_two_masses(),
        {"k": 4, "r": 0.9, "x0@1": -1, "x0@2": -0.8, "v0@1": 0, "v0@2": 0.3},
        {"known": {"r": 0.87, "k": 4.2, "c": 0.02}},
    ),
}  # fmt: skip


@pytest.mark.parametrize(
    "case",
    [slow(n, when=n in ("gaps", "experiments")) for n in TOLD],
)
def test_exact_data_give_exact_parameters(case):
    data, expected, options = TOLD[case]
    free = dict.fromkeys(name.partition("@")[0] for name in expected)
    found = fitted(data, *free, **{"parameters": GUESS, "sigma": 1e-3, **options})
    assert found.names == tuple(expected)
    np.testing.assert_allclose(found.estimates, [*expected.values()], rtol=0, atol=1e-9)
    assert found.status == "converged"
    assert found.chi2 < 1e-10 or case == "without noise"
    assert np.isfinite(found.standard_errors).all()
    assert found.experiments[0].configurations[0] == "free"
    assert found.same_sequence is (None if case in ("series", "experiments") else True)
    if case == "events":
        assert found.experiments[0].boundaries == 8 * (WALL,)
        assert found.motion().transitions == 8
    if case == "gaps":
        assert found.data == 45 + 7
        # left out altogether, the third impact would be taken for the fourth
        events = {WALL: np.delete(data[1][WALL], 2)}
        wrong = fitted(events, "k", "r", parameters=GUESS, sigma=1e-3)
        assert wrong.chi2 > 1e4
    if case == "without noise":
        assert 0 < found.noise["x"] < 1e-6
    if case == "experiments":
        assert float(found.experiments[1].parameters["m"]) == 2
        assert found.motion(1)(0.0)[0] == pytest.approx(-0.8)


# what a residual weighs by each loss: its influence, and the slope of that
INFLUENCES = {
    "linear": lambda z: (z, np.ones_like(z)),
    "soft_l1": lambda z: (z / np.sqrt(1 + z**2), (1 + z**2) ** -1.5),
    "huber": lambda z: (np.clip(z, -1, 1), abs(z) <= 1),
    "cauchy": lambda z: (z / (1 + z**2), (1 - z**2) / (1 + z**2) ** 2),
}


@pytest.mark.parametrize(
    ("kind", "loss", "known"),
    [
        ("events", "linear", True),
        ("series", "linear", True),
        ("series", "linear", False),
        *(slow("series", each, True) for each in [*INFLUENCES][1:]),
    ],
)
def test_errors_are_those_of_an_m_estimate(kind, loss, known):
    """By the Jacobian by differences, to which influences at a minimum are perpendicular."""
    data = {WALL: impacts(8, 2e-3, 1)} if kind == "events" else series(0.02, 1)
    sigma = 2e-3 if kind == "events" else 0.02
    if loss != "linear":
        data["x"][::10] += 1
    found = fitted(data, "k", "r", parameters=GUESS, sigma=sigma if known else None, loss=loss)
    unit = sigma if known else found.noise["x"]

    def predicted(point):
        values = {**TRUTH, "k": point[0], "r": point[1]}
        motion = ns.simulate(SYSTEM, values, START, transitions=20)
        where = [WALL in names for names in motion.boundaries]
        return (motion.times[where][:8] if kind == "events" else motion(TIMES)[:, 0]) / unit

    jacobian, z = in_doubles(predicted, found.estimates), found.residuals
    influence, slope = INFLUENCES[loss](z)
    exact, freedom = loss == "linear" and known, len(z) - 2
    factor = 1 if exact else (influence @ influence) / freedom / np.mean(slope) ** 2
    np.testing.assert_allclose(
        found.covariance, factor * np.linalg.inv(jacobian.T @ jacobian), rtol=1e-6
    )
    size = np.linalg.norm(jacobian, axis=0) * np.linalg.norm(influence)
    assert (abs(influence @ jacobian) < 1e-5 * size).all()
    assert abs(found["k"] - 4) < 0.02
    assert found.degrees_of_freedom == freedom
    if loss == "linear":
        assert 0.5 < found.chi2 / freedom < 2
        np.testing.assert_allclose(z @ z, found.chi2, rtol=1e-12)
    if not known:
        left = found.experiments[0].series[0].values - found.experiments[0].series[0].fitted
        assert unit == pytest.approx(np.sqrt(left @ left / freedom), rel=1e-6)
    quantile = norm.ppf(0.975) if exact else student.ppf(0.975, freedom)
    half = found.upper - found.estimates
    np.testing.assert_allclose(half, quantile * found.standard_errors, rtol=1e-12)


@pytest.mark.slow
def test_noise_is_estimated_for_each_column():
    data, gap = series(0.02, 1), {"outputs": {"gap": "2*x - 3*v + 0.5"}, "parameters": GUESS}
    motion = ns.simulate(SYSTEM, TRUTH, START, until=9)(TIMES)
    rough = 0.3 * np.random.default_rng(5).normal(size=len(TIMES))
    data["gap"] = 2 * motion[:, 0] - 3 * motion[:, 1] + 0.5 + rough
    found = fitted(data, "k", "r", **gap)
    assert 0.015 < found.noise["x"] < 0.025
    assert 0.22 < found.noise["gap"] < 0.38
    given = fitted(data, "k", "r", **gap, sigma=dict(found.noise))
    np.testing.assert_allclose(given.estimates, found.estimates, rtol=1e-6)
    # what is weighted wrongly has a larger error
    only = fitted({n: data[n] for n in ("t", "gap")}, "k", "r", **gap)
    assert (only.standard_errors > found.standard_errors).all()


# --- what data do not tell


def test_a_combination_that_nothing_tells_is_named():
    found = fitted({WALL: impacts()}, "k", "m", "r", "c", parameters=GUESS, sigma=1e-3)
    (told,) = found.unidentified
    assert told == "k, m and c changed together (k by +1 %, m by +1 %, c by +1 %)"
    assert found.singular_values[-1] < 1e-9 * found.singular_values[0]
    assert np.isinf(found.standard_errors[[0, 1, 3]]).all()
    assert 0 < found.standard_errors[2] < 1e-2
    assert found["k"] / found["m"] == pytest.approx(4, rel=1e-8)


def test_a_prior_tells_it():
    found = fitted(
        {WALL: impacts(8, 1e-3, 1)}, "k", "m", "c", parameters={"k": 4.2, "m": 1.1},
        priors={"m": (1.1, 0.05)},
        sigma=1e-3,
    )  # fmt: skip
    assert found.unidentified == ()
    assert found["m"] == pytest.approx(1.1, rel=1e-6)
    assert found.standard_errors[1] == pytest.approx(0.05, rel=1e-3)
    assert found["k"] == pytest.approx(4.4, rel=2e-3)
    assert found.chi2 < 20


def test_a_later_start_is_told_by_no_clock():
    """Without a forcing a motion that starts later on its way is the same."""
    both = fitted(shifted(), "offset", "x0", "v0", offset=2.9, sigma=1e-3)
    assert len(both.unidentified) == 1
    assert np.isinf(both.standard_errors).all()


def test_bounds_hold_and_are_told():
    found = fitted({WALL: impacts()}, "k", "r", parameters={"k": 3.5}, bounds={"k": (3, 3.9)},
                   sigma=1e-2)  # fmt: skip
    assert found.at_bound == ("k",)
    assert found["k"] == pytest.approx(3.9, rel=1e-5)
    assert math.isnan(found.standard_errors[0])
    assert found.standard_errors[1] > 0
    assert found.untold == {"k": "at its bound"}
    assert "k, 3.9, at its bound" in str(found)
    assert "nan" not in str(found)


def test_without_a_degree_of_freedom_no_error_is_told():
    """Of as many numbers as there are free ones; a loss that heeds outliers needs one more."""
    exact, robust = (
        fitted({WALL: impacts(2, 1e-3, 1)}, "k", "r", parameters=GUESS, sigma=1e-3, loss=loss)
        for loss in ("linear", "huber")
    )
    assert exact.degrees_of_freedom == robust.degrees_of_freedom == 0
    assert np.isfinite(exact.standard_errors).all()
    assert exact.untold == {}
    assert np.isinf([robust.standard_errors, robust.lower, robust.upper]).all()
    assert robust.untold == dict.fromkeys("kr", "no degree of freedom tells its error")
    assert "no degree of freedom" in str(robust)
    assert "nan" not in str(robust)


# --- several starts


@pytest.mark.slow
def test_several_starts_find_what_one_misses_and_are_seeded():
    limits = {"k": (1, 12), "r": (0.3, 1)}
    told = []
    found, again = (
        fitted(
            {WALL: impacts(6, 1e-3, 2)}, known={"m": 1, "c": 0.02}, bounds=limits, sigma=1e-3,
            starts=3, rng=7, progress=lambda *done: told.append(done),
        )
        for _ in range(2)
    )  # fmt: skip
    assert found["k"] == pytest.approx(4, rel=1e-2)
    np.testing.assert_array_equal(found.estimates, again.estimates)
    assert told[:3] == [(n, len(found.costs)) for n in range(1, len(found.costs) + 1)][:3]
    assert min(found.costs) == pytest.approx(found.chi2 / 2)


def test_a_long_record_leads_to_its_minimum_by_way_of_its_beginnings():
    """A direct search ends among motions that miss an impact, hundreds of deviations off."""
    point = {"c": 0.05, "k": 3.464111363815697, "r": 0.8491271795904692}
    start = {"x": -0.6, "v": 0.31577651988954014}
    motion = ns.simulate(FORCED, point, start, transitions=12)
    found = ns.fit(
        FORCED,
        {WALL: motion.times[1:]},
        parameters=point | {"k": 3.439368044531334, "r": 0.8434874405963568},
        bounds={"k": (1, 6), "r": (0.2, 1), "v0": (-2, 2)},
        start=start | {"v": 0.28724740051015457},
        sigma=2e-3,
    )
    np.testing.assert_allclose(found.estimates, [point["k"], point["r"], start["v"]], rtol=1e-9)


def test_evaluations_are_those_of_all_searches(monkeypatch):
    spent, search = [], optimize.least_squares

    def counted(*arguments, **options):
        found = search(*arguments, **options)
        spent.append(found.nfev)
        return found

    monkeypatch.setattr(optimize, "least_squares", counted)
    found = fitted(series(0.02, 1), "k", "r", parameters=GUESS)
    assert len(spent) > 4
    assert found.evaluations == sum(spent)


def test_what_was_found_until_an_interruption_is_kept():
    def stop(done, total):
        if done == 2:
            raise KeyboardInterrupt

    with pytest.raises(Interrupted) as stopped:
        fitted({WALL: impacts()}, "k", parameters={"k": 4.1}, bounds={"k": (3, 5)}, sigma=1e-3,
               starts=5, progress=stop)  # fmt: skip
    assert stopped.value.partial["k"] == pytest.approx(4)
    assert np.isnan(stopped.value.partial.costs[2:]).all()


# --- how near it grazes


def test_distance_to_grazing_is_that_of_the_height():
    # without a wall in reach x = -cos(2 t): the largest x is 1, and grazes a wall at 1
    stop = RigidStop("x", at=sp.Symbol("h"), restitution=r, name="wall")
    data, known = {"t": TIMES, "x": -np.cos(2 * TIMES)}, {"h": 1.25, "k": 4.1, "r": 0.5}
    found = ns.fit(one_mass("near", stop, stiffness=k), data, parameters=known,
                   free=["k", "x0"], start={"x": -0.9, "v": 0}, sigma=0.01)  # fmt: skip
    near = found.grazing
    assert (near.kind, near.boundary) == ("missed", WALL)
    assert near.margin == pytest.approx(0.25, rel=1e-9)
    assert near.standard_errors == pytest.approx(0.25 / found.standard_errors[1], rel=1e-6)
    assert near.time == pytest.approx(np.pi / 2, rel=1e-6)


def test_distance_to_grazing_of_a_slow_arrival():
    # x = x0 cos(2 t) arrives at 0.2 with v^2 = 4 (x0^2 - 0.04), and bends by -4 x 0.2
    data = {WALL: np.array([np.pi / 2 - np.arccos(0.2 / 0.25) / 2])}
    known = {"c": "1e-12", "r": 0.5}
    given = {"sigma": 1e-3, "start": {"x": -0.25, "v": 0}}
    found = fitted(data, "x0", parameters=known, **given)
    near, slope = found.grazing, 2 * 0.25 / 0.4
    assert near.kind == "slowly reached"
    assert near.margin == pytest.approx((0.25**2 - 0.2**2) / 0.4, rel=1e-6)
    expected = near.margin / (slope * found.standard_errors[0])
    assert near.standard_errors == pytest.approx(expected, rel=1e-6)
    # the height (x0^2 - 0.2^2) / 0.4 does not depend on k
    assert fitted(data, "k", parameters=known | {"k": 4.1}, **given).grazing.standard_errors > 1e6


# --- bad input


def refusal(data, *free, ask=fitted, **options):
    with pytest.raises(InputError) as refused:
        ask(data, *free, **options)
    (line,) = str(refused.value).splitlines()
    return line


ONE = {"t": [0.5], "x": [0.1]}


@pytest.mark.parametrize(
    ("changes", "told"),
    [
        ({"data": ONE, "free": "kr", "sigma": 1}, "1 measured numbers are too few for 2 free ones"),
        ({"data": {"t": TIMES[:2], "x": [0, 0]}, "free": "kr"}, "2 free ones (k, r): 3"),
        ({"free": ""}, "nothing is free"),
        ({"free": "q"}, "unknown free parameter 'q'"),
        ({"bounds": {"k": (5, 3)}}, "the bounds of k, 5 and 3, are not in order"),
        ({"bounds": {"r": (0, 1)}}, "r has bounds or a prior, and is not free"),
        ({"bounds": {"k": (5, 6)}}, "k = 4 is not between 5 and 6"),
        ({"sigma": math.nan}, "the sigma of x is not positive and finite"),
        ({"sigma": 0.0}, "the sigma of x is not positive and finite"),
        ({"data": series() | {"y": TIMES}}, "unknown column 'y'"),
        ({"outputs": {"y": "x"}}, "unknown column 'y'"),
        ({"outputs": {"x": "x*v"}}, "output 'x*v' is not affine"),
        ({"outputs": {"x": "z"}}, "unknown name 'z'"),
        ({"data": {"t": TIMES[::-1], "x": TIMES}}, "the times do not increase"),
        ({"data": {"t": TIMES - 1, "x": TIMES}}, "data at -0.95 are before the motion starts"),
        ({"data": {"x": TIMES}}, "column 'x' needs times"),
        ({"data": {"t": TIMES, "x": TIMES[1:]}}, "column 'x' has 59 values for 60 times"),
        ({"data": {WALL: impacts()[::-1]}}, "do not increase"),
        ({"data": {WALL: np.arange(1, 90)}, "parameters": {"r": 0.2}}, "there is no fit from the"),
        ({"loss": "l1"}, "unknown loss 'l1'"),
        ({"events": ["door"]}, "unknown event 'door'"),
        ({"data": series() | {"m": TIMES}}, "'m' is a parameter, and not constant"),
        ({"data": {"t": TIMES[:3], "x": [0, "a", 1]}}, "column 'x' is no row of real numbers"),
        ({"starts": 3}, "several starts need both bounds, or a prior, of k"),
        ({"priors": {"k": (4, 0)}}, "no positive standard deviation"),
    ],
)
def test_bad_input_is_one_line(changes, told):
    given = {"data": series(), "free": "k", **changes}
    assert told in refusal(given.pop("data"), *given.pop("free"), **given)


def test_a_parameter_that_nothing_depends_on_is_named():
    before = {"t": [0.1, 0.2, 0.3, 0.4], "x": -np.cos(2 * np.array([0.1, 0.2, 0.3, 0.4]))}
    assert "depends on r (at r = 0.9)" in refusal(before, "k", "r", sigma=0.1)


# --- tables


@pytest.mark.slow
def test_files_give_the_same_fit(tmp_path):
    data = series(0.02, 1)
    data["sigma_x"] = np.full(len(TIMES), 0.02)
    data["x"][3] = np.nan
    np.savez(tmp_path / "data.npz", **data)
    rows = [
        ",".join("" if math.isnan(x) else repr(x) for x in row)
        for row in np.array([*data.values()]).T.tolist()
    ]
    (tmp_path / "data.csv").write_text("# of a test\n" + "\n".join([",".join(data), *rows]))
    expected = fitted(data, "k", parameters={"k": 4.02})
    sources = [tmp_path / "data.npz", str(tmp_path / "data.csv")]
    xarray = pytest.importorskip("xarray")
    sources.append(xarray.Dataset({n: ("t", v) for n, v in data.items() if n != "t"},
                                  coords={"t": data["t"]}))  # fmt: skip
    sources[-1].to_netcdf(tmp_path / "data.nc", engine="scipy")
    sources.append(tmp_path / "data.nc")
    for source in sources:
        found = fitted(source, "k", parameters={"k": 4.02})
        np.testing.assert_array_equal(found.estimates, expected.estimates)


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("t,x\n0.1,0\n0.2,a\n", "line 3, column 'x': 'a' is not a number"),
        ("t,x\n0.1,0\n0.2\n", "line 3 has 1 entries, not 2"),
        ("t,t\n0.1,0\n", "column 't' is there twice"),
        ("t,x\n", "a header and at least one row are expected"),
    ],
)
def test_tables_that_are_none(text, told, tmp_path):
    path = tmp_path / "data.csv"
    path.write_text(text)
    assert refusal(path, "k") == f"{path}: {told}"


@pytest.mark.parametrize("packing", [zipfile.ZIP_BZIP2, zipfile.ZIP_LZMA])
def test_archives_that_are_unpacked_as_a_whole_are_refused(tmp_path, packing, monkeypatch):
    path = tmp_path / "data.npz"
    with zipfile.ZipFile(path, "w", packing) as archive:
        archive.writestr("t.npy", bytes(1000))
    monkeypatch.setattr(zipfile.ZipFile, "open", None)  # nothing of it is unpacked
    with pytest.raises(InputError, match=r"data\.npz: 't\.npy' is not packed as NumPy does it"):
        fitted(path, "k")
    with pytest.raises(DeclarationError, match=r"'t\.npy' is not packed as NumPy does it"):
        read_matrices(path)


@pytest.mark.slow
def test_what_sparse_matrices_of_matlab_unpack_to_is_bounded(tmp_path, monkeypatch):
    """300 MB of zeros, or a matrix whose numbers are as many as it says."""
    path = tmp_path / "sparse.mat"
    matrix = sparse.random_array((300, 300), density=0.1, rng=np.random.default_rng(2))
    savemat(path, {"K": matrix}, do_compression=True)
    assert abs(read_matrices(path)["K"] - matrix).max() == 0
    whole = path.read_bytes()
    tag, packed = whole[128:136], zlib.decompress(whole[136:])
    pieces = zlib.compressobj()
    more = pieces.compress(packed) + b"".join(pieces.compress(bytes(10**7)) for _ in range(30))
    more += pieces.flush()
    path.write_bytes(whole[:128] + tag[:4] + len(more).to_bytes(4, "little") + more)
    unpacked = unpacked_pieces(monkeypatch)
    monkeypatch.setattr("scipy.io.loadmat", None)  # it keeps all that it unpacks
    with pytest.raises(DeclarationError, match=r"sparse\.mat: .* so much is not unpacked"):
        read_matrices(path)
    assert 0 < max(unpacked) < 3e6
    assert sum(unpacked) < 2.9e8  # the rest is not even counted


def test_what_a_dataset_unpacks_to_is_bounded(tmp_path):
    xarray = pytest.importorskip("xarray")
    path = tmp_path / "data.zarr"
    xarray.Dataset({"x": ("i", np.zeros(20_000_000))}).to_zarr(path, consolidated=False)
    with pytest.raises(InputError, match=r"it takes 160 MB, packed into .*: so much is not"):
        fitted(path, "k")


def test_what_a_small_archive_unpacks_to_is_bounded(tmp_path, monkeypatch):
    np.savez_compressed(tmp_path / "data.npz", t=np.zeros(3_000_000))
    unpacked = unpacked_pieces(monkeypatch)
    with pytest.raises(InputError, match=r"data\.npz: 't\.npy' takes 24 MB.*so much is not"):
        fitted(tmp_path / "data.npz", "k")
    assert 0 < sum(unpacked) < 100_000

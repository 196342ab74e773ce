"""Batches: each point depends on nothing but its own parameters."""

import os
import subprocess
import sys

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from nonsmooth.runtime.batch import solve_many
from nonsmooth.runtime.errors import InputError
from nonsmooth.runtime.kernels import backend, load_orbit
from nonsmooth.runtime.newton import CONVERGED, solve_reduced
from nonsmooth.runtime.orbit import STATUS
from nonsmooth.runtime.solve import solve

ORBIT = "dry-friction/global-stick"
PARAMETERS = ("chi", "eta", "V", "e1", "e2")
REFERENCE = {"chi": 0.5, "eta": 1.0, "V": 1.0, "e1": 3.0195, "e2": 0.4831}
UNKNOWNS = ("z10", "z20", "ta", "tau", "tau1", "tau2")
LOWER, UPPER = np.array([0.3, 0.6, 0.7, 2.3, 0.3]), np.array([0.7, 1.6, 1.3, 3.8, 0.9])
COUNT = 300 if backend() == "c" else 40


def random_points(seed, count):
    points = LOWER + (UPPER - LOWER) * np.random.default_rng(seed).random((count, 5))
    return dict(zip(PARAMETERS, points.T, strict=True))


def columns(found):
    """Every array of a result, by name."""
    arrays = {n: getattr(found, n) for n in ("trace", "period", "residual", "iterations", "status")}
    arrays |= {f"unknown {n}": a for n, a in found.unknowns.items()}
    if found.admissible is not None:
        arrays["admissible"] = found.admissible
        arrays |= {f"bound {n}": a for n, a in found.bounds.items()}
    return arrays


def assert_same_bits(first, second, places=...):
    first, second = columns(first), columns(second)
    assert first.keys() == second.keys()
    for name, array in first.items():
        assert array.dtype == second[name].dtype
        assert_array_equal(array[places], second[name], err_msg=name, strict=True)


@pytest.fixture(scope="module")
def points():
    return random_points(1, COUNT)


@pytest.fixture(scope="module")
def many(points):
    return solve_many(ORBIT, **points)


@pytest.fixture(scope="module")
def singles(points):
    return [
        solve(ORBIT, {n: float(points[n][i]) for n in PARAMETERS}, throw=False)
        for i in range(COUNT)
    ]


# --- shapes


@pytest.mark.parametrize(
    "shapes",
    [
        {},
        {"eta": ()},
        {"eta": (3,)},
        {"eta": (2, 1), "V": (3,)},
        {"chi": (2, 1, 1), "eta": (3, 1), "V": (4,), "e1": (), "e2": (1,)},
        {"eta": (0,)},
        {"eta": (2, 0), "V": (2, 1)},
        {"eta": (1, 1, 1)},
    ],
    ids=str,
)
@pytest.mark.parametrize("admissibility", [True, False])
def test_arrays_broadcast(shapes, admissibility):
    generator = np.random.default_rng(4)
    given = {
        name: np.float64(REFERENCE[name]) * generator.uniform(0.98, 1.02, shape)
        for name, shape in shapes.items()
    }
    expected = np.broadcast_shapes(*shapes.values())
    found = solve_many(ORBIT, admissibility=admissibility, **given)
    for name, array in columns(found).items():
        assert isinstance(array, np.ndarray | np.generic), name
        assert np.shape(array) == expected, name
    assert np.shape(found.converged) == expected
    full = {
        name: np.broadcast_to(given.get(name, REFERENCE[name]), expected) for name in PARAMETERS
    }
    for place in np.ndindex(expected):
        alone = solve_many(
            ORBIT, admissibility=admissibility, **{n: a[place] for n, a in full.items()}
        )
        assert_same_bits(found, alone, place)


def test_scalars_lists_and_integers_are_arrays_too():
    found = solve_many(ORBIT, eta=[1, 1.02], V=1, chi=np.float32(0.5), e1="3.0195")
    expected = solve_many(ORBIT, eta=np.array([1.0, 1.02]))
    assert_same_bits(found, expected)


def test_memory_order_and_strides_do_not_matter(points, many):
    strided = {n: np.repeat(a, 2)[::2] for n, a in points.items()}
    assert_same_bits(many, solve_many(ORBIT, **strided))
    square = {n: np.asfortranarray(a[:20].reshape(4, 5)) for n, a in points.items()}
    assert_array_equal(solve_many(ORBIT, **square).trace.ravel(), many.trace[:20])


def test_arguments_are_left_alone(points):
    before = {n: a.copy() for n, a in points.items()}
    solve_many(ORBIT, **points)
    for name in PARAMETERS:
        assert_array_equal(points[name], before[name])


# --- the same bits


@pytest.mark.parametrize("threads", [1, 2, 8, None])
@pytest.mark.parametrize("chunk", [1, 7, 64, 10**6])
def test_threads_and_chunks_change_no_bit(points, many, threads, chunk):
    if backend() == "numpy" and chunk < 7:
        chunk = 3
    assert_same_bits(many, solve_many(ORBIT, threads=threads, chunk=chunk, **points))


def test_a_point_alone_has_the_bits_it_has_in_a_batch(points, many):
    for i in range(0, COUNT, 4):
        alone = solve_many(ORBIT, **{n: a[i] for n, a in points.items()})
        assert_same_bits(many, alone, i)


def test_order_does_not_matter(points, many):
    order = np.random.default_rng(5).permutation(COUNT)
    shuffled = solve_many(ORBIT, **{n: a[order] for n, a in points.items()})
    assert_same_bits(many, shuffled, order)


def test_without_admissibility_the_rest_has_the_same_bits(points, many):
    without = solve_many(ORBIT, admissibility=False, **points)
    assert without.admissible is None
    assert without.bounds is None
    expected = {n: a for n, a in columns(many).items() if n in columns(without)}
    for name, array in columns(without).items():
        assert_array_equal(array, expected[name])


# --- hopeless points

HOPELESS = [
    {"chi": np.nan},
    {"eta": np.inf},
    {"V": -np.inf},
    {"chi": 0.0},
    {"chi": 1.0},
    {"chi": -0.5},
    {"eta": 0.0},
    {"V": -1.0},
    {"e1": -1e-300},
    {"e2": -3.0},
    {"eta": 1e300},
    {"e2": 1e9},
    {"e1": np.nan, "e2": np.nan},
]


def test_hopeless_points_do_not_disturb_their_neighbours(points):
    # blocks of eight lanes: every place within a block gets its turn
    good = {n: a[:24].copy() for n, a in points.items()}
    expected = solve_many(ORBIT, **good)
    for shift, hopeless in enumerate(HOPELESS):
        mixed, places = {n: a.copy() for n, a in good.items()}, np.arange(shift % 8, 24, 5)
        for name in PARAMETERS:
            mixed[name][places] = hopeless.get(name, REFERENCE[name])
        found = solve_many(ORBIT, **mixed)
        neighbours = np.setdiff1d(np.arange(24), places)
        for name, array in columns(found).items():
            assert_array_equal(array[neighbours], columns(expected)[name][neighbours])
        assert not found.converged[places].any()
        assert not found.admissible[places].any()


def test_hopeless_points_have_a_status_and_nothing_else():
    full = {
        name: np.array([hopeless.get(name, REFERENCE[name]) for hopeless in HOPELESS])
        for name in PARAMETERS
    }
    found = solve_many(ORBIT, **full)
    assert not found.converged.any()
    for status in np.unique(found.status):
        assert found.message(int(status)) == STATUS[int(status)]
        assert "\n" not in STATUS[int(status)]
    inside = [hopeless in ({"eta": 1e300}, {"e2": 1e9}) for hopeless in HOPELESS]
    assert all("domain" in STATUS[int(s)] for s in found.status[np.logical_not(inside)])
    for name, array in columns(found).items():
        if name not in ("iterations", "status", "admissible"):
            assert np.isnan(array).all(), name


def test_the_edge_of_a_closed_domain_belongs_to_it():
    found = solve_many(ORBIT, e2=[0.0, -0.0, 5e-324, -5e-324])
    assert_array_equal(found.converged, [True, True, True, False])


def test_lost_points_are_lost_to_solve_or_to_admissibility(points, many, singles):
    for i in np.flatnonzero(~many.converged):
        assert not singles[i].converged or singles[i].admissibility.verdict is False


def test_where_the_prediction_fails_other_starts_are_tried():
    generator = np.random.default_rng(7)
    points = generator.uniform([0.15, 0.3, 0.3, 1.5, 0.1], [0.85, 3, 1.5, 5, 1.5], (COUNT, 5))
    reference = solve(ORBIT)
    kernels = load_orbit(ORBIT)
    start = [reference.unknowns[name] for name in kernels.reduced]
    plain = solve_reduced(kernels, points, start).status == CONVERGED
    found = solve_many(ORBIT, **dict(zip(PARAMETERS, points.T, strict=True))).converged
    assert np.all(found[plain])
    assert found.sum() > plain.sum()


def test_the_prediction_is_of_first_order():
    """An error of second order leaves two steps: one that corrects, one that sees it."""
    for name, value in REFERENCE.items():
        found = solve_many(ORBIT, **{name: value * (1 + np.array([-2e-3, 2e-3]))})
        assert np.all(found.iterations <= 2)


# --- one and many


def test_what_a_batch_finds_solves_the_problem_of_one(points, many):
    for i in np.flatnonzero(many.converged)[:: 2 if backend() == "c" else 4]:
        guess = {n: float(many.unknowns[n][i]) for n in UNKNOWNS}
        one = solve(ORBIT, {n: float(points[n][i]) for n in PARAMETERS}, guess)
        assert_allclose(list(one.unknowns.values()), list(guess.values()), rtol=1e-9, atol=1e-11)
        assert one.trace == pytest.approx(float(many.trace[i]), rel=1e-8, abs=1e-10)
        assert one.period == pytest.approx(float(many.period[i]), rel=1e-10)
        assert many.residual[i] < 1e-9


def test_a_batch_and_one_find_the_same_orbit_where_there_is_one(points, many, singles):
    """They may differ only where several orbits live: both are orbits then."""
    same = []
    for i, one in enumerate(singles):
        if many.admissible[i] and one.converged:
            assert one.admissibility.verdict == "conditional"
            found = [float(many.unknowns[n][i]) for n in UNKNOWNS]
            same.append(np.allclose(list(one.unknowns.values()), found, atol=1e-9))
    assert np.mean(same) > 0.95


def test_a_batch_finds_the_admissible_orbits_that_one_finds(many, singles):
    possible = [o.converged and o.admissibility.verdict is not False for o in singles]
    assert np.sum(many.admissible[possible]) >= 0.97 * np.sum(possible)


def test_verdicts_and_bounds_are_those_of_the_single_orbit(points, many):
    verdicts = set()
    for i in np.flatnonzero(many.converged):
        guess = [float(many.unknowns[n][i]) for n in UNKNOWNS]
        one = solve(ORBIT, {n: float(points[n][i]) for n in PARAMETERS}, guess)
        verdict = one.admissibility.verdict
        assert bool(many.admissible[i]) == (verdict == "conditional")
        verdicts.add(verdict)
        required = {r.parameter: r.greater_than for r in one.admissibility.requires}
        for name, bounds in many.bounds.items():
            if verdict is False:
                assert np.isnan(bounds[i])
            else:
                assert bounds[i] == pytest.approx(required[name], rel=1e-10, abs=1e-10)
    assert verdicts == {False, "conditional"}


def test_nan_stands_exactly_where_nothing_was_found(many):
    assert 0 < many.converged.sum() < COUNT
    for array in (*many.unknowns.values(), many.trace, many.period, many.residual):
        assert_array_equal(np.isfinite(array), many.converged)
    for array in many.bounds.values():
        assert_array_equal(np.isfinite(array), many.admissible)
    assert not np.any(many.admissible & ~many.converged)
    assert np.all(np.min([many.unknowns[n][many.converged] for n in UNKNOWNS[2:]], axis=0) > 0)


# --- backends

SCRIPT = """
import sys
import numpy as np
from nonsmooth.runtime.batch import solve_many
from nonsmooth.runtime.kernels import backend
assert backend() == "numpy"
with np.load(sys.argv[1]) as file:
    found = solve_many("dry-friction/global-stick", **file)
np.savez(sys.argv[2], trace=found.trace, residual=found.residual, status=found.status,
         admissible=found.admissible, iterations=found.iterations, period=found.period,
         **found.unknowns, **{"bound_" + n: a for n, a in found.bounds.items()})
"""


@pytest.mark.compiled
def test_numpy_agrees_with_c(tmp_path):
    near = {n: REFERENCE[n] * (1 + np.linspace(-0.03, 0.03, 40)) for n in PARAMETERS}
    wide = random_points(1, 80)
    given = {n: np.concatenate([near[n], wide[n]]) for n in PARAMETERS}
    np.savez(tmp_path / "in.npz", **given)
    subprocess.run(
        [sys.executable, "-W", "error", "-c", SCRIPT, tmp_path / "in.npz", tmp_path / "out.npz"],
        env=os.environ | {"NONSMOOTH_BACKEND": "numpy"},
        check=True,
    )
    compiled = solve_many(ORBIT, **given)
    with np.load(tmp_path / "out.npz") as file:
        other = dict(file)
    assert compiled.converged[:40].all()
    assert 40 < compiled.converged.sum() < 120
    assert_array_equal(other["admissible"], compiled.admissible)
    same = other["status"] == compiled.status
    # Newton's method far from any orbit is chaotic: a last bit may decide what it finds there
    assert same[compiled.admissible].all()
    assert same.mean() > 0.95
    sound = compiled.admissible
    assert_array_equal(other["iterations"][sound], compiled.iterations[sound])
    for name in UNKNOWNS:
        assert_allclose(other[name][sound], compiled.unknowns[name][sound], rtol=1e-12, atol=1e-12)
    assert_allclose(other["trace"][sound], compiled.trace[sound], rtol=1e-10)
    assert_allclose(other["period"][sound], compiled.period[sound], rtol=1e-12)
    for name, bounds in compiled.bounds.items():
        assert_allclose(other[f"bound_{name}"], bounds, rtol=1e-12, atol=1e-12)


@pytest.mark.compiled
def test_the_compiled_solver_is_used():
    kernels = load_orbit(ORBIT)
    assert kernels.solver is not None
    assert kernels.admissible is not None


# --- wrong input


@pytest.mark.parametrize(
    ("given", "named"),
    [
        ({"etta": 1.0}, "unknown parameter 'etta'; did you mean 'eta'"),
        ({"us1": 1.0}, "unknown parameter 'us1'"),
        ({"z10": 1.0}, "unknown parameter 'z10'"),
        ({"eta": [1.0, 2.0], "V": [1.0, 2.0, 3.0]}, "do not broadcast"),
        ({"eta": "one"}, "parameter eta"),
        ({"eta": ["one", "two"]}, "parameter eta"),
        ({"eta": 1 + 1j}, "parameter eta"),
        ({"eta": np.array([1 + 1j, 2])}, "parameter eta"),
        ({"eta": [[1.0], [1.0, 2.0]]}, "parameter eta"),
        ({"eta": None}, "eta"),
        ({"eta": {"a": 1}}, "parameter eta"),
        ({"eta": [True, False]}, "parameter eta"),
        ({"eta": np.array(["2020-01-01"], dtype="datetime64[D]")}, "parameter eta"),
        ({"threads": 0}, "threads = 0"),
        ({"threads": -2}, "threads = -2"),
        ({"threads": 1.5}, "threads = 1.5"),
        ({"chunk": 0}, "chunk = 0"),
        ({"chunk": 2.5}, "chunk = 2.5"),
    ],
    ids=str,
)
def test_wrong_input_is_named_on_one_line(given, named):
    with pytest.raises(InputError, match=named) as caught:
        solve_many(ORBIT, **given)
    assert "\n" not in str(caught.value)


def test_an_unknown_orbit_is_named():
    with pytest.raises(InputError, match="did you mean 'dry-friction/global-stick'"):
        solve_many("dry-friction/global-slick")

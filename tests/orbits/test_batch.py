"""Batches: each point depends on nothing but its own parameters."""

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from nonsmooth import solve
from nonsmooth.runtime.model.kernels import backend, load_orbit, orbit_names
from tests.declared import random_points, single
from tests.tables import slow

ORBIT = "dry-friction/global-stick"
COUNT = 300 if backend() == "c" else 32
WIDE = [0.15, 0.3, 0.3, 1.5, 0.1], [0.85, 3, 1.5, 5, 1.5]
every_orbit = pytest.mark.parametrize("name", orbit_names())


def defaults(name):
    return {n: float(value) for n, value in solve(name).given.items()}


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


SLOW = "dry-friction/symmetric", "dry-friction/solution-ii"


@pytest.fixture(
    scope="module",
    params=[slow(n, when=n in SLOW) for n in orbit_names()],
)
def name(request):
    return request.param


@pytest.fixture(scope="module")
def points(name):
    return random_points(name, 1, COUNT)


@pytest.fixture(scope="module")
def many(name, points):
    return solve(name, points)


@pytest.fixture(scope="module")
def singles(name, points):
    return [
        solve(name, {n: float(a[i]) for n, a in points.items()}, throw=False)
        for i in range(0, COUNT, 3)
    ]


# --- shapes


@pytest.mark.parametrize(
    "shapes",
    [
        [(3,)],
        [(2, 1), (3,)],
        [(2, 1, 1), (3, 1), (4,), ()],
        [(0,)],
        [(2, 0), (2, 1)],
        [(1, 1, 1)],
    ],
    ids=str,
)
@pytest.mark.parametrize("admissibility", [True, False])
def test_arrays_broadcast(name, shapes, admissibility):
    generator = np.random.default_rng(4)
    reference = defaults(name)
    given = {
        parameter: np.float64(reference[parameter]) * generator.uniform(0.98, 1.02, shape)
        for parameter, shape in zip(reference, shapes, strict=False)
    }
    expected = np.broadcast_shapes(*shapes)
    found = solve(name, given, admissibility=admissibility)
    for label, array in columns(found).items():
        assert isinstance(array, np.ndarray | np.generic), label
        assert np.shape(array) == expected, label
    assert np.shape(found.converged) == expected
    full = {n: np.broadcast_to(given.get(n, value), expected) for n, value in reference.items()}
    for place in np.ndindex(expected):
        one = {n: a[place][None] for n, a in full.items()}
        alone = solve(name, one, admissibility=admissibility)
        assert_same_bits(found, alone, (*place, None))


def test_memory_order_and_strides_do_not_matter_and_arguments_are_left_alone(name, points, many):
    strided = {n: np.repeat(a, 2)[::2] for n, a in points.items()}
    assert_same_bits(many, solve(name, strided))
    square = {n: np.asfortranarray(a[:20].reshape(4, 5)) for n, a in points.items()}
    assert_array_equal(solve(name, square).trace.ravel(), many.trace[:20])
    for parameter, array in random_points(name, 1, COUNT).items():
        assert_array_equal(points[parameter], array)
        assert_array_equal(strided[parameter], array)


# --- the same bits


@pytest.mark.parametrize(
    ("threads", "chunk"), [(1, 1), (8, 1), (2, 7), (None, 7), (1, 64), (8, 64), (2, 10**6)]
)
def test_threads_and_chunks_change_no_bit(name, points, many, threads, chunk):
    if backend() == "numpy":  # a call takes half a second, whatever it solves
        chunk = {1: 8, 7: 20}.get(chunk, chunk)
    assert_same_bits(many, solve(name, points, threads=threads, chunk=chunk))


def test_without_admissibility_the_admissible_have_the_same_bits(name, points, many):
    """Where several orbits live, one that is admissible comes first when that is asked."""
    without = solve(name, points, admissibility=False)
    assert without.admissible is None
    assert without.bounds is None
    assert_array_equal(without.converged, many.converged)
    orbits = list(without.unknowns.values()), list(many.unknowns.values())
    same = np.all(np.equal(*orbits) | np.isnan(orbits[0]), axis=0)
    assert np.mean(same) > 0.9
    assert many.admissible[~same].all()
    expected = {n: a for n, a in columns(many).items() if n in columns(without)}
    for label, array in columns(without).items():
        assert_array_equal(array[same], expected[label][same])


# --- hopeless points


def hopeless_points(name):
    """One parameter at a time that is no number, infinite, or outside its domain."""
    found = []
    for parameter in load_orbit(name).parameters:
        values = [np.nan, np.inf, -np.inf, -1e-300]
        if not parameter.closed:
            values += [float(parameter.lower), -0.5]
        if parameter.upper is not None:
            values += [float(parameter.upper), 1.5]
        found += [{parameter.name: value} for value in values]
    return found


def test_hopeless_points_do_not_disturb_their_neighbours(name, points):
    # blocks of sixteen lanes: every place within a block gets its turn
    good, reference = {n: a[:32].copy() for n, a in points.items()}, defaults(name)
    expected = solve(name, good)
    inside = [{"eta": 1e300}, {"e2": 1e9}] if name == ORBIT else []
    every = hopeless_points(name)[:: 1 if backend() == "c" else 5]
    for shift, hopeless in enumerate(every + inside):
        mixed, places = {n: a.copy() for n, a in good.items()}, np.arange(5 * shift % 16, 32, 5)
        for parameter, array in mixed.items():
            array[places] = hopeless.get(parameter, reference[parameter])
        found = solve(name, mixed)
        neighbours = np.setdiff1d(np.arange(32), places)
        for label, array in columns(found).items():
            assert_array_equal(array[neighbours], columns(expected)[label][neighbours])
        assert not found.converged[places].any()
        for status in np.unique(found.status[places]):
            assert "domain" in found.message(int(status)) or hopeless in inside
        for label, array in columns(found).items():
            if label not in ("iterations", "status"):
                assert not np.nan_to_num(array[places]).any(), label


def test_the_edge_of_a_closed_domain_belongs_to_it():
    found = solve(ORBIT, {"e2": [0.0, -0.0, 5e-324, -5e-324]})
    assert_array_equal(found.converged, [True, True, True, False])


@every_orbit
def test_the_prediction_is_of_first_order(name):
    """An error of second order leaves two steps: one that corrects, one that sees it."""
    for parameter, value in defaults(name).items():
        near = solve(name, {parameter: value * (1 + np.array([-1e-3, 1e-3]))})
        assert near.converged.all()
        assert np.all(near.iterations <= (2 if load_orbit(name).reduced else 0))


# --- one and many


def test_a_batch_and_one_find_the_same_orbit_where_there_is_one(name, many, singles):
    """They may differ only where several orbits live: both are orbits then."""
    possible = [o.converged and o.admissibility.verdict is not False for o in singles]
    # one may search 1600 starts, a batch a few
    share = 0.8 if name == "dry-friction/symmetric" else 0.97
    assert np.sum(many.admissible[::3][possible]) >= share * np.sum(possible) > 0
    same = []
    for i, one, motion in zip(range(0, COUNT, 3), singles, possible, strict=True):
        assert many.converged[i] or not motion
        if many.admissible[i] and one.converged:
            assert motion
            found = [float(a[i]) for a in many.unknowns.values()]
            same.append(np.allclose(list(one.unknowns.values()), found, atol=1e-9))
    assert np.mean(same) > 0.9


def test_where_the_prediction_fails_other_starts_are_tried():
    drawn = np.random.default_rng(7).uniform(*WIDE, (60, 5))
    points = [dict(zip(defaults(ORBIT), map(float, point), strict=True)) for point in drawn]
    alone = np.array([solve(ORBIT, point, throw=False).converged for point in points])
    many = solve(ORBIT, dict(zip(defaults(ORBIT), drawn.T, strict=True)))
    assert many.converged[alone].mean() > 0.8
    # from here it leads to orbits that are no motions
    elsewhere = [0.71, 0.7, 0.65], [2.13, 2.65, 2.63], [0.96, 0.37, 1.31], [3.66, 4, 2.75]
    points = dict(zip(defaults(ORBIT), (*elsewhere, [0.24, 0.38, 0.24]), strict=True))
    assert solve(ORBIT, points).admissible.all()


def test_what_a_batch_finds_and_its_verdicts_and_bounds_are_those_of_one(name, many):
    verdicts = set()
    for i in np.flatnonzero(many.converged):
        one = single(many, i)
        guess = [float(a[i]) for a in many.unknowns.values()]
        assert_allclose(list(one.unknowns.values()), guess, rtol=1e-10, atol=1e-10)
        scale = np.abs(one.evaluate("poincare_jacobian")).max()
        assert one.trace == pytest.approx(float(many.trace[i]), rel=1e-8, abs=1e-10 * scale)
        assert one.period == pytest.approx(float(many.period[i]), rel=1e-10)
        assert many.residual[i] < 1e-9
        verdict = one.admissibility.verdict
        assert bool(many.admissible[i]) == (verdict is not False)
        if verdict is False:
            first = one.admissibility.violations[0]
            told = f"phase {first.phase + 1} {first.configuration}: {first.boundary}"
            assert many.limits[many.limit[i]] == told
        verdicts.add(verdict)
        required = {r.parameter: r.greater_than for r in one.admissibility.requires}
        for label, bounds in many.bounds.items():
            if verdict is False:
                assert np.isnan(bounds[i])
            else:
                assert bounds[i] == pytest.approx(required[label], rel=1e-10, abs=1e-10)
    allowed = "conditional" if load_orbit(name).open_parameters else True
    assert allowed in verdicts <= {False, allowed}
    assert False in verdicts or name == "dry-friction/solution-ii"


def test_nan_stands_exactly_where_nothing_was_found(many):
    assert many.converged.any()
    for array in (*many.unknowns.values(), many.trace, many.period, many.residual):
        assert_array_equal(np.isfinite(array), many.converged)
    for array in many.bounds.values():
        assert_array_equal(np.isfinite(array), many.admissible)
    assert_array_equal(many.limit == -2, ~many.converged)
    kernels = load_orbit(many.name)
    dwell = kernels.durations({**many.parameters, **many.unknowns})
    for label in set(dwell) - set(kernels.table["vanishing"]):
        assert np.all(np.broadcast_to(dwell[label], COUNT)[many.converged] > 0)


# --- backends


@pytest.mark.slow
@pytest.mark.compiled
@every_orbit
def test_numpy_agrees_with_c(name, monkeypatch):
    wide, near = random_points(name, 1, 60), np.linspace(-0.02, 0.02, 40)
    given = {n: np.concatenate([v * (1 + near), wide[n]]) for n, v in defaults(name).items()}
    compiled = solve(name, given)
    monkeypatch.setenv("NONSMOOTH_BACKEND", "numpy")
    assert backend() == "numpy"
    other = columns(solve(name, given))
    assert other.keys() == columns(compiled).keys()
    assert compiled.converged[:40].all()
    same = other["status"] == compiled.status
    # Newton's method far from any orbit is chaotic: a last bit may decide what it finds there
    assert same[compiled.admissible].all()
    assert same.mean() > 0.95
    assert np.mean(other["admissible"] == compiled.admissible) > 0.98
    sound = compiled.admissible & other["admissible"]
    assert sound.sum() > 20
    assert_array_equal(other["iterations"][sound], compiled.iterations[sound])
    for label, array in columns(compiled).items():
        if label.startswith(("unknown", "bound", "period")):
            assert_allclose(other[label][sound], array[sound], rtol=1e-10, atol=1e-10)
    # the trace is a difference of the Jacobian's entries, which are large near grazing
    assert_allclose(other["trace"][sound], compiled.trace[sound], rtol=1e-8, atol=1e-8)

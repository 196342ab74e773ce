"""Small linear systems in lanes of the generated C, beside NumPy: Newton steps and derivatives."""

from itertools import product

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from tests.compiled_c import library_of, needs_compiler, pointer

pytestmark = needs_compiler

LANES = 16
LEAST_PIVOT = 1e-10  # in units of the matrix
DRIVER = """
#include "nonsmooth_elimination.h"
#include "nonsmooth_newton.h"
void step(int n, const int *positive, const double *jacobian, const double *residual,
          double *unknown, double *open, int32_t *taken)
{
    for (int lane = 0; lane < NONSMOOTH_LANES; ++lane)
        nonsmooth_newton_in_lane(n, positive, lane, jacobian, residual, unknown, open, taken);
}
void derivatives(int n, int p, double *jacobian, double *moved, double *slope)
{
    nonsmooth_implicit_derivatives(n, p, jacobian, moved, slope);
}
void measured(int n, const double *entries, double *largest, double *doubt)
{
    nonsmooth_largest(NONSMOOTH_LANES, n, entries, largest);
    nonsmooth_doubt(NONSMOOTH_LANES, n, entries, doubt);
}
"""


@pytest.fixture(scope="module")
def library(tmp_path_factory):
    folder = tmp_path_factory.mktemp("lanes")
    (folder / "driver.c").write_text(DRIVER, encoding="utf-8")
    return library_of(folder / "driver.c", "-O2")


def stepped(library, jacobian, residual, unknown, positive, open_lanes=None):
    """Unknowns (lanes, n) behind one step, which lanes are open then, and the counts of steps."""
    columns = [np.array(a.reshape(LANES, -1).T, order="C") for a in (jacobian, residual, unknown)]
    moves = np.ones(LANES) if open_lanes is None else open_lanes.astype(float)
    taken = np.zeros(LANES, dtype=np.int32)
    signs = np.array(positive, dtype=np.intc)
    library.step(len(positive), *map(pointer, (signs, *columns, moves, taken)))
    return columns[2].T, moves == 1, taken


def differentiated(library, jacobian, moved, slope):
    """Derivatives of unknowns (lanes, n, p), and of a function of them (lanes, p)."""
    (_, n, p), arrays = moved.shape, (jacobian, moved, slope)
    columns = [np.array(a.reshape(LANES, -1).T, order="C") for a in arrays]
    library.derivatives(n, p, *map(pointer, columns))
    return columns[1].T.reshape(LANES, n, p), columns[2].T[:, n:]


def systems(size, seed):
    """Random matrices that are far from singular, right-hand sides and unknowns, for each lane."""
    generator = np.random.default_rng(seed)
    left, right = np.linalg.qr(generator.normal(size=(2, LANES, size, size)))[0]
    matrices = left * generator.uniform(0.3, 3, (LANES, 1, size)) @ right
    return matrices, generator.normal(size=(LANES, size)), generator.uniform(0.5, 2, (LANES, size))


def exchanged(matrices, generator):
    """The matrices of all lanes with their rows in random order."""
    rows = np.argsort(generator.uniform(size=matrices.shape[:2]), axis=1)
    return np.take_along_axis(matrices, rows[..., None], axis=1)


def newton(jacobian, residual, unknown):
    return unknown - np.linalg.solve(jacobian, residual[..., None])[..., 0]


@pytest.mark.parametrize("size", [1, 2, 3])
def test_a_lane_ends_with_a_short_step_and_then_stays(library, size):
    """Short is a step of 1e-9 of the unknown, or of 1 where that is larger: of all unknowns."""
    jacobian, residual, unknown = systems(size, 5)
    unknown *= np.where(np.arange(LANES) % 2, 1.0, 1e3)[:, None]
    direction = np.zeros((LANES, size))
    direction[np.arange(LANES), np.arange(LANES) % size] = np.maximum(unknown.max(axis=1), 1)
    for length, ends in ((0.0, True), (0.5e-9, True), (3e-9, False), (1e-3, False)):
        scale = np.max(np.maximum(unknown, 1), axis=1, keepdims=True) / np.maximum(unknown, 1)
        step = length * direction / scale
        residual = (jacobian @ step[..., None])[..., 0]
        found, moves, _ = stepped(library, jacobian, residual, unknown, [0] * size)
        assert (moves != ends).all(), length
        assert_allclose(found, unknown - step, rtol=1e-12)
    closed = np.arange(LANES) % 3 == 0
    found, moves, taken = stepped(library, jacobian, residual, unknown, [0] * size, ~closed)
    assert_array_equal(found[closed], unknown[closed])
    assert_array_equal(moves, ~closed)
    assert_array_equal(taken, ~closed)


@pytest.mark.parametrize(("size", "seed"), [*product((1, 2, 3), range(4))])
def test_a_step_is_that_of_newton_but_keeps_what_is_positive(library, size, seed):
    """A positive unknown changes by a factor of four at most, the others by the whole step."""
    jacobian, residual, unknown = systems(size, seed)
    found, moves, taken = stepped(library, jacobian, residual, unknown, [0] * size)
    wanted = newton(jacobian, residual, unknown)
    assert_allclose(found, wanted, rtol=1e-13, atol=1e-13)
    assert moves.all()
    assert (taken == 1).all()
    residual *= np.geomspace(0.1, 1e6, LANES)[:, None]
    unknown[::4] *= 1e-12
    wanted = newton(jacobian, residual, unknown)
    for positive in product((0, 1), repeat=size):
        found, moves, _ = stepped(library, jacobian, residual, unknown, positive)
        cut = np.array(positive) == 1
        assert (found[:, cut] > 0).all()
        expected = np.where(cut, np.clip(wanted, unknown / 4, 4 * unknown), wanted)
        assert_allclose(found, expected, rtol=1e-10, atol=1e-10)
        assert moves.all(), "a step that is cut is no short one"


@pytest.mark.parametrize(("size", "parameters"), [*product(range(1, 7), (1, 4))])
def test_derivatives_are_those_of_implicit_functions(library, size, parameters):
    generator = np.random.default_rng(size)
    jacobian, *_ = systems(size, size)
    # in every other lane pivots are zero until rows are exchanged
    triangular = np.triu(generator.uniform(-1, 1, (LANES, size, size)), 1) + np.eye(size)
    jacobian[::2] = exchanged(triangular, generator)[::2]
    moved = generator.normal(size=(LANES, size, parameters))
    slope = generator.normal(size=(LANES, size + parameters))
    directions, total = differentiated(library, jacobian, moved, slope)
    expected = -np.linalg.solve(jacobian, moved)
    assert_allclose(directions, expected, rtol=1e-12, atol=1e-12)
    along = np.einsum("li,lij->lj", slope[:, :size], expected)
    assert_allclose(total, slope[:, size:] + along, rtol=1e-12, atol=1e-12)


@pytest.mark.parametrize("size", range(1, 7))
def test_equations_that_are_nearly_singular_have_no_derivatives(library, size):
    """The smallest pivot decides, in units of the matrix, and in its own lane alone."""
    generator = np.random.default_rng(size)
    moved, slope = np.ones((LANES, size, 2)), np.ones((LANES, size + 2))
    for unit, place in product((1e-8, 1.0, 1e8), range(size)):
        shares = LEAST_PIVOT * generator.choice([0.0, 0.1, 0.9, 1.1, 10.0], LANES)
        jacobian = np.triu(generator.uniform(-1, 1, (LANES, size, size)), 1) + np.eye(size)
        jacobian[:, place, place] = 0.0
        whole = np.linalg.norm(jacobian, axis=(1, 2)) if size > 1 else 1.0
        jacobian[:, place, place] = shares * whole
        given = unit * exchanged(jacobian, generator)
        lost = shares < LEAST_PIVOT if size > 1 else shares == 0
        for found in differentiated(library, given, moved, slope):
            nothing = np.isnan(found).reshape(LANES, -1)
            assert_array_equal(nothing.all(axis=1), lost)
            assert_array_equal(nothing.any(axis=1), lost)


def test_what_is_no_number_is_in_doubt_in_its_own_lane(library):
    entries = np.random.default_rng(1).normal(size=(3, LANES))
    expected = np.abs(entries).max(axis=0)
    for bad in (np.nan, np.inf, -np.inf):
        spoilt, largest, doubt = entries.copy(), np.empty(LANES), np.zeros(LANES)
        spoilt[2, 5] = bad
        library.measured(3, *map(pointer, (spoilt, largest, doubt)))
        others = np.arange(LANES) != 5
        assert_array_equal(largest[others], expected[others])
        assert_array_equal(doubt[others], 0)
        assert np.isnan(doubt[5])

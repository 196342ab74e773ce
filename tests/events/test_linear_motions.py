"""The compiled search for maxima along linear motions, against ball arithmetic."""

import ctypes
import math
import shutil
import subprocess
from typing import NamedTuple

import numpy as np
import pytest
from flint import arb, arb_mat, ctx

from nonsmooth.runtime.events.quasi_polynomials import ConfigurationTable
from nonsmooth.runtime.model.modes.numeric_modes import numeric_modes
from tests.large_systems import by_tables
from tests.places import CHECKOUT
from tests.tables import slow

compiler = shutil.which("gcc") or shutil.which("cc")
SUPPORT = CHECKOUT / "derive/codegen/support"
FLAGS = "-std=c99 -Wall -Wextra -pedantic -Werror -O2 -ffp-contract=off"
DRIVER = """
#include "nonsmooth_motions.h"
void search(int sums, int states, const double *field, const double *start, const double *rows,
            double duration, const double *floor, double noise, double *maximum, double *time,
            double *rounding, int *rises)
{
    const nonsmooth_motion motion = nonsmooth_motion_of(states, field, start, duration);
    nonsmooth_motion_maxima(&motion, sums, rows, floor, maximum, time);
    for (int i = 0; i < sums; ++i) {
        rounding[i] = nonsmooth_motion_rounding(&motion, rows + i * (states + 1));
        rises[i] = nonsmooth_motion_rises(&motion, rows + i * (states + 1), noise);
    }
}
"""
FORCED = np.array([[0, 1, 0, 0, 0], [-1, -0.1, 1, 0, 0], [0, 0, 0, -2, 0], [0, 0, 2, 0, 0.0]])


@pytest.fixture(scope="module")
def search(tmp_path_factory):
    """Give the compiled search: maxima, times, roundings and whether functions rise."""
    if compiler is None:
        pytest.skip("there is no C compiler")
    folder = tmp_path_factory.mktemp("motions")
    (folder / "driver.c").write_text(DRIVER)
    command = [compiler, *FLAGS.split(), "-I", SUPPORT, "-shared", "-fPIC"]
    run = subprocess.run(
        [*command, folder / "driver.c", "-o", folder / "driver.so", "-lm"],
        capture_output=True,
        text=True,
        check=False,
    )
    assert run.returncode == 0, run.stderr
    library = ctypes.CDLL(str(folder / "driver.so"))

    def call(motion, rows, floor, noise=0.0):
        field, start, rows, floor = (
            np.ascontiguousarray(a, dtype=float) for a in (motion.field, motion.start, rows, floor)
        )
        found, rises = np.empty((3, len(rows))), np.zeros(len(rows), dtype=np.int32)
        pointers = [
            a.ctypes.data_as(ctypes.c_void_p) for a in (field, start, rows, floor, *found, rises)
        ]
        library.search(
            len(rows), len(start), *pointers[:3], ctypes.c_double(motion.duration), pointers[3],
            ctypes.c_double(noise), *pointers[4:],
        )  # fmt: skip
        return *found, rises

    return call


class LinearMotion(NamedTuple):
    """A motion y' = A y + b, whose field is A, then b."""

    field: np.ndarray
    start: np.ndarray
    duration: float


def along(motion, row):
    """Give a function of a motion by the modes of its field."""
    modes, start = numeric_modes(motion.field), [*motion.start.tolist(), 1.0]
    system = by_tables(
        "motion", motion.field[None], np.array([row]), np.eye(*motion.field.shape)[None],
        [[("row", 0, True)]], [[]], [(modes.shapes, modes.exponents, modes.flows)],
    )  # fmt: skip
    (found,) = ConfigurationTable(system, 0).along(start, [*map(abs, start)])
    return found


def motions(count, seed, most=7):
    """Draw stable motions whose states have units far apart, and two functions along each."""
    drawn = np.random.default_rng(seed)
    for _ in range(count):
        size = int(drawn.integers(1, most))
        field = drawn.normal(size=(size, size + 1)) * drawn.choice(
            [1, 0, 0.1, 10], (size, size + 1)
        )
        matrix = field[:, :-1]
        matrix -= np.eye(size) * max(0, np.linalg.eigvals(matrix).real.max())
        units = 10.0 ** drawn.uniform(-3, 3, size)
        field = np.concatenate([matrix * units / units[:, None], field[:, -1:]], axis=1)
        field[:, -1] /= units
        rows = drawn.normal(size=(2, size + 1))
        rows[:, :-1] *= units
        start = drawn.normal(size=size) / units
        yield LinearMotion(field, start, float(drawn.choice([0.1, 1, 5, 20]))), rows


def exactly(motion, row, times):
    """Values of a function at times, by exponentials in balls."""
    size = len(motion.start)
    before, ctx.prec = ctx.prec, 200
    try:
        field = [*map(float, motion.field.ravel())] + [0.0] * (size + 1)
        matrix = arb_mat(size + 1, size + 1, [arb(x) for x in field])
        state = arb_mat(size + 1, 1, [*(arb(float(x)) for x in motion.start), arb(1)])
        normal = arb_mat(1, size + 1, [arb(float(x)) for x in row])
        return [
            float((normal * ((matrix * arb(time)).exp() * state))[0, 0].mid()) for time in times
        ]
    finally:
        ctx.prec = before


@pytest.mark.parametrize("count", [15, slow(40)])
def test_maxima_are_attained_and_not_exceeded(search, count):
    for motion, rows in motions(count, 1):
        found = search(motion, rows, [-math.inf] * len(rows))
        for row, value, time, error, rises in zip(rows, *found, strict=True):
            *values, there = exactly(motion, row, [*np.linspace(0, motion.duration, 60), time])
            assert max(values) <= value + error
            assert abs(there - value) <= error
            terms = row[:-1, None] * motion.field * np.append(motion.start, 1.0)
            if abs(terms.sum()) > 1e-9 * abs(terms).sum():
                assert bool(rises) == (terms.sum() > 0)
            # a floor cuts off what lies below
            floor = value + np.random.default_rng(3).choice([-1, 1]) * abs(value) / 2
            (cut,), (time,), *_ = search(motion, [row], [floor])
            assert abs(cut - max(value, floor)) <= 2 * error
            assert math.isnan(time) == (cut == floor)


@pytest.mark.parametrize("exponent", range(5, 13))
def test_grazing_peaks_are_found(search, exponent):
    """A peak just above the floor, anywhere between the samples of a damped, forced motion."""
    drawn = np.random.default_rng(exponent)
    for _ in range(20):
        motion = LinearMotion(FORCED, drawn.normal(size=4), float(drawn.uniform(3, 12)))
        row = np.array([1.0, 0, 0, 0, 0])
        free = search(motion, [row], [-math.inf])[0][0]
        for peak, found in ((10.0**-exponent, True), (-(10.0**-exponent), False)):
            shifted = np.append(row[:-1], peak - free)
            assert bool(search(motion, [shifted], [0.0])[0][0] > 0) is found


def test_a_bump_between_flat_ends_is_found(search):
    """The Hermite interpolant over the one step is zero: only the bound tells of the bump."""
    rates = np.array([0.0, 0.7, 0.9])  # two waves, a constant and a drift: four conditions
    field = np.zeros((6, 7))
    for k in (1, 2):
        field[2 * k - 2, 2 * k - 1], field[2 * k - 1, 2 * k - 2] = -rates[k], rates[k]
    field[4, 6] = 1.0
    motion = LinearMotion(field, np.array([1.0, 0, 1, 0, 0, 0]), 0.5)

    def values(t):
        waves = [f(w * t) for w in rates[1:] for f in (math.cos, math.sin)]
        return [*waves, t, 0.0, 1.0]

    ends = np.array([values(0.0), values(0.5)])
    slopes = [motion.field @ np.append(values(t)[:-1], 1.0) for t in (0.0, 0.5)]
    conditions = np.array([*ends, *(np.append(s, 0.0) for s in slopes), values(0.25)])
    row, *_ = np.linalg.lstsq(conditions, [0, 0, 0, 0, 1.0], rcond=None)
    assert search(motion, [row], [0.9])[0][0] == pytest.approx(1.0)


def test_what_has_no_guarantee_is_refused(search):
    long = LinearMotion(FORCED, np.ones(4), 1e6)
    growing = LinearMotion(np.array([[50.0, 0.0]]), np.ones(1), 100.0)
    backwards = LinearMotion(FORCED, np.ones(4), -1.0)
    broken = LinearMotion(FORCED, np.array([math.nan, 0, 0, 0]), 1.0)
    for motion in (long, growing, backwards, broken):
        row = np.ones(len(motion.start) + 1)
        assert np.isnan(search(motion, [row], [0.0])[0]).all()
    at_once = LinearMotion(FORCED, np.ones(4), 0.0)
    assert search(at_once, [[1.0, 0, 0, 0, -0.5]], [0.0])[0][0] == 0.5


def near_critical(apart):
    """Two oscillators near their critical damping, one of which drives the other: real poles."""
    field = np.zeros((4, 5))
    field[[0, 2], [1, 3]], field[[1, 3], [0, 2]], field[1, 4] = 1.0, -1.0, 0.3
    field[[1, 3], [1, 3]], field[3, 0] = (-2.0 - apart, -2.0), 1.0
    return field


def cascade(apart):
    """Three oscillators, each of which drives the next one: poles that turn."""
    field = np.zeros((6, 7))
    field[[0, 2, 4], [1, 3, 5]], field[[3, 5], [0, 2]], field[1, 6] = 1.0, 1.0, 0.3
    field[[1, 3, 5], [0, 2, 4]], field[[1, 3, 5], [1, 3, 5]] = [-1, -1 - apart, -1 + apart], -0.1
    return field


@pytest.mark.parametrize("field", [near_critical(1e-7), near_critical(1e-5), cascade(1e-3)])
def test_functions_of_poles_that_nearly_meet_keep_their_errors(field):
    drawn = np.random.default_rng(3)
    motion, row = (
        LinearMotion(field, *drawn.normal(size=(1, len(field))), 3.0),
        np.ones(len(field) + 1),
    )
    function = along(motion, row)
    assert any(part.shapes for part in function.parts)
    times, rows = np.linspace(0.0, 3.0, 7), [row]
    for _ in range(2):
        rows.append(rows[-1][:-1] @ field)
    slope = function.derivative()
    for t, *expected in zip(times, *(exactly(motion, each, times) for each in rows), strict=True):
        *found, error = function.jet(t)
        errors = error, slope.rounding(t), slope.derivative().rounding(t)
        assert (abs(np.subtract(found, expected)) <= errors).all()
        assert abs(found[2]) <= function.bound(2, 0.0, 3.0)
        assert found[0] <= function.ceiling(0.0)
    start, error = next(function.taylor())
    assert abs(start - function(0.0)) <= 2 * error

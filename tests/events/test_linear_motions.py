"""Guaranteed maxima along linear motions: against ball arithmetic, and in C as in Python."""

from __future__ import annotations

import ctypes
import math
import shutil
import subprocess

import numpy as np
import pytest
from flint import arb, arb_mat, ctx

from nonsmooth import InputError
from nonsmooth.runtime.events.guaranteed_maxima import AlongMotion, LinearMotion, maximum
from tests.places import CHECKOUT
from tests.sums import trigonometric

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


def along(motion, row):
    return AlongMotion(motion, np.array(row[:-1], dtype=float), float(row[-1]))


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


def test_maxima_are_attained_and_not_exceeded():
    for motion, rows in motions(25, 1):
        for row in rows:
            function = along(motion, row)
            value, time = maximum(function, motion.duration)
            error = function.rounding(motion.duration)
            times = [*np.linspace(0, motion.duration, 60).tolist(), time]
            *values, there = exactly(motion, row, times)
            assert max(values) <= value + error
            assert abs(there - value) <= error
            assert abs(function(times[7]) - values[7]) <= error


@pytest.mark.slow
def test_the_compiled_search_is_that_of_python(search):
    for motion, rows in motions(300, 2):
        functions = [along(motion, row) for row in rows]
        for floors in ([-math.inf, -math.inf], [0.0, 0.5]):
            maxima, times, roundings, rises = search(motion, rows, floors)
            for function, floor, *found in zip(
                functions, floors, maxima, times, roundings, rises, strict=True
            ):
                value, time, rounding, rise = found
                expected = maximum(function, motion.duration, floor)
                assert rounding == pytest.approx(function.rounding(motion.duration), rel=1e-6)
                assert abs(value - expected.value) <= rounding
                assert math.isnan(time) == (value == floor)
                assert bool(rise) == function.rises(0.0)


@pytest.mark.parametrize("exponent", range(5, 13))
def test_grazing_peaks_are_found(search, exponent):
    """A peak just above the floor, anywhere between the samples of a damped, forced motion."""
    drawn = np.random.default_rng(exponent)
    for _ in range(20):
        motion = LinearMotion(FORCED, drawn.normal(size=4), float(drawn.uniform(3, 12)))
        row = np.array([1.0, 0, 0, 0, 0])
        free = maximum(along(motion, row), motion.duration)
        for peak, found in ((10.0**-exponent, True), (-(10.0**-exponent), False)):
            shifted = np.append(row[:-1], peak - free.value)
            maxima, *_ = search(motion, [shifted], [0.0])
            assert bool(maxima[0] > 0) is found
            assert (maximum(along(motion, shifted), motion.duration, 0.0).value > 0) is found


def test_a_bump_between_flat_ends_is_found(search):
    """The Hermite interpolant over the one step is zero: only the bound tells of the bump."""
    rates = np.array([0.0, 0.7, 0.9])  # two waves, a constant and a drift: four conditions
    field = np.zeros((6, 7))
    for k in (1, 2):
        field[2 * k - 2, 2 * k - 1], field[2 * k - 1, 2 * k - 2] = -rates[k], rates[k]
    field[4, 6] = 1.0
    motion = LinearMotion(field, np.array([1.0, 0, 1, 0, 0, 0]), 0.5)
    assert len(motion.steps.states) == 2

    def values(t):
        waves = [f(w * t) for w in rates[1:] for f in (math.cos, math.sin)]
        return [*waves, t, 0.0, 1.0]

    ends = np.array([values(0.0), values(0.5)])
    slopes = [motion.field @ np.append(values(t)[:-1], 1.0) for t in (0.0, 0.5)]
    conditions = np.array([*ends, *(np.append(s, 0.0) for s in slopes), values(0.25)])
    row, *_ = np.linalg.lstsq(conditions, [0, 0, 0, 0, 1.0], rcond=None)
    assert maximum(along(motion, row), 0.5, 0.9).value == pytest.approx(1.0)
    assert search(motion, [row], [0.9])[0][0] == pytest.approx(1.0)


def test_undamped_motions_are_trigonometric_sums():
    field = np.array([[0, 1, 0.0], [-4.0, 0, 2.0]])
    motion = LinearMotion(field, np.array([0.3, -0.4]), 7.0)
    wave = trigonometric(0.5 - 0.2, 0.0, (0.3 - 0.5,), (-0.2,), (2.0,))
    function = along(motion, [1.0, 0.0, -0.2])
    assert maximum(function, 7.0).value == pytest.approx(maximum(wave, 7.0).value, abs=1e-13)
    assert function.raised(0.25)(3.0) == pytest.approx(wave(3.0) + 0.25, abs=1e-13)
    assert function.rises(0.0) is wave.rises(0.0) is False


def test_what_has_no_guarantee_is_refused(search):
    long = LinearMotion(FORCED, np.ones(4), 1e6)
    growing = LinearMotion(np.array([[50.0, 0.0]]), np.ones(1), 100.0)
    backwards = LinearMotion(FORCED, np.ones(4), -1.0)
    broken = LinearMotion(FORCED, np.array([math.nan, 0, 0, 0]), 1.0)
    for motion in (long, growing, backwards, broken):
        row = np.ones(len(motion.start) + 1)
        assert np.isnan(search(motion, [row], [0.0])[0]).all()
        with pytest.raises(InputError):
            maximum(along(motion, row), motion.duration)
    at_once = LinearMotion(FORCED, np.ones(4), 0.0)
    assert search(at_once, [[1.0, 0, 0, 0, -0.5]], [0.0])[0][0] == 0.5
    assert maximum(along(at_once, [1.0, 0, 0, 0, -0.5]), 0.0, 0.0).value == 0.5
    with pytest.raises(InputError, match="not NaN"):
        maximum(along(at_once, [1.0, 0, 0, 0, 0]), 0.0, math.nan)

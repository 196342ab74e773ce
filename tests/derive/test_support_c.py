"""The support of the generated C against ball arithmetic and its Python twin."""

import ctypes
import math
import subprocess

import numpy as np
import pytest
from flint import arb, ctx

from nonsmooth.runtime.events.crossings_and_maxima import maximum
from tests.compiled_c import COMPILER, library_of, needs_compiler, pointer
from tests.sums import trigonometric

pytestmark = needs_compiler

FLAGS = ("-fno-math-errno", "-fno-trapping-math")
VECTORS = ("-fopenmp-simd", "-DNONSMOOTH_OPENMP_SIMD", "-DNONSMOOTH_EVERY_PROCESSOR")
DRIVER = """
#include "nonsmooth_sums.h"
#define CLONED NONSMOOTH_MULTIVERSION
#define SINCOS                                                                                  \\
    (int count, const double *restrict x, double *restrict sine, double *restrict cosine)
#define MAXIMA                                                                                  \\
    (int sums, int terms, const double *frequency, const double *coefficients, double duration, \\
     const double *floor, double *maximum, double *time)
void sincos_plain SINCOS
{
    NONSMOOTH_SIMD
    for (int i = 0; i < count; ++i)
        nonsmooth_sincos(x[i], &sine[i], &cosine[i]);
}
CLONED void sincos_cloned SINCOS
{
    NONSMOOTH_SIMD
    for (int i = 0; i < count; ++i)
        nonsmooth_sincos(x[i], &sine[i], &cosine[i]);
}
void maxima_plain MAXIMA
{
    nonsmooth_maxima(sums, terms, frequency, coefficients, duration, floor, maximum, time);
}
CLONED void maxima_cloned MAXIMA
{
    nonsmooth_maxima(sums, terms, frequency, coefficients, duration, floor, maximum, time);
}
double rounding(int terms, const double *frequency, const double *row, double duration)
{
    return nonsmooth_rounding(terms, frequency, row, duration);
}
"""


def build(folder, *options):
    source = folder / "driver.c"
    source.write_text(DRIVER)
    return library_of(source, *FLAGS, *options)


@pytest.fixture(scope="module")
def vector(tmp_path_factory):
    return build(tmp_path_factory.mktemp("vector"), "-O3", *VECTORS)


@pytest.fixture(scope="module")
def scalar(tmp_path_factory):
    return build(tmp_path_factory.mktemp("scalar"), "-O1")


def sine_and_cosine(function, points):
    result = np.empty((2, len(points)))
    function(len(points), pointer(points), pointer(result[0]), pointer(result[1]))
    return result


def maxima(function, frequency, rows, duration, floor):
    frequency, rows, floor = (np.array(a, dtype=float, ndmin=1) for a in (frequency, rows, floor))
    result = np.empty((2, len(floor)))
    function(
        len(floor),
        len(frequency),
        pointer(frequency),
        pointer(rows),
        ctypes.c_double(duration),
        pointer(floor),
        pointer(result[0]),
        pointer(result[1]),
    )
    return result


def as_sum(frequency, row):
    count = len(frequency)
    return trigonometric(row[0], row[1], row[2 : 2 + count], row[2 + count :], frequency)


def rounding(frequency, row, duration):
    """Give 32 eps (|a0| + |a1| T + sum (|c| + |s|)(1 + w T)), and what underflows."""
    (constant, slope), (cosine, sine) = row[:2], np.split(abs(np.asarray(row[2:])), 2)
    waves = ((cosine + sine) * (1 + np.asarray(frequency) * duration)).sum()
    lost = (1 + 2 * len(frequency)) * math.ulp(0.0)
    return float(2.0**-47 * (abs(constant) + abs(slope) * duration + waves) + lost)


def bump_between_flat_ends():
    """Make a sum with g = g' = 0 at both ends of a window of one cell, and g = 1 in its middle."""
    end, w = 0.58, np.array([0.3, 1.0])

    def values(t):
        return [1, t, *np.cos(w * t), *np.sin(w * t)]

    def slopes(t):
        return [0, 1, *(-w * np.sin(w * t)), *(w * np.cos(w * t))]

    rows = [values(0), values(end), slopes(0), slopes(end), values(end / 2), values(0.4 * end)]
    return w, np.linalg.solve(rows, [0, 0, 0, 0, 1, 0.9216]), end


def points():
    generator = np.random.default_rng(20)
    multiples = np.arange(1, 63662) * (math.pi / 2)
    edges = (np.arange(0, 63661, 3) + 0.5) * (math.pi / 2)
    edges = np.concatenate([edges, np.nextafter(edges, 0), np.nextafter(edges, 1e9)])
    beside = generator.choice(multiples, 4000)
    small = np.ldexp(generator.uniform(1, 2, 20000), generator.integers(-1074, 0, 20000))
    special = [0.0, 5e-324, 2.2e-308, 2.0**-1022, 1e5, math.pi / 4, 1.0]
    positive = np.concatenate(
        [
            multiples,
            np.nextafter(beside, 0),
            np.nextafter(beside, 1e9),
            edges,
            small,
            generator.uniform(0, 1e5, 40000),
            generator.uniform(0, 7, 40000),
            special,
        ]
    )
    signs = np.where(np.arange(len(positive)) % 2, 1.0, -1.0)
    return np.concatenate([signs * positive, -np.array(special), special])


@pytest.fixture(scope="module")
def balls():
    """Points with their sines and cosines: the nearest doubles and what is left of them."""
    x = points()
    nearest, rest = np.empty((2, len(x))), np.empty((2, len(x)))
    before, ctx.prec = ctx.prec, 160
    try:
        for i, t in enumerate(x.tolist()):
            for row, value in enumerate(arb(t).sin_cos()):
                nearest[row, i] = float(value)
                rest[row, i] = float(value - arb(nearest[row, i]))
    finally:
        ctx.prec = before
    return x, nearest, rest


@pytest.mark.slow
def test_sine_and_cosine_are_within_nine_tenths_of_an_ulp(vector, balls):
    x, nearest, rest = balls
    assert len(x) > 200000
    error = sine_and_cosine(vector.sincos_plain, x) - nearest - rest
    assert np.max(np.abs(error) / np.spacing(np.abs(nearest))) <= 0.9


def test_the_sign_of_zero_is_kept_and_subnormals_are_exact(vector):
    x = np.array([0.0, -0.0, 5e-324, -5e-324, 3e-310, -3e-310, 1e-300])
    sine, cosine = sine_and_cosine(vector.sincos_plain, x)
    assert sine.tobytes() == x.tobytes()
    assert (cosine == 1).all()


def test_outside_the_range_both_are_nan(vector):
    x = np.array([np.nextafter(1e5, 2e5), -1.1e5, 1e300, math.inf, -math.inf, math.nan])
    assert np.isnan(sine_and_cosine(vector.sincos_plain, x)).all()


def test_every_build_gives_the_same_bits(scalar, vector):
    x = points()
    expected = sine_and_cosine(scalar.sincos_plain, x).tobytes()
    assert sine_and_cosine(vector.sincos_plain, x).tobytes() == expected
    assert sine_and_cosine(vector.sincos_cloned, x).tobytes() == expected
    for case in cases(200):
        expected = maxima(scalar.maxima_plain, *case).tobytes()
        assert maxima(vector.maxima_plain, *case).tobytes() == expected
        assert maxima(vector.maxima_cloned, *case).tobytes() == expected


@pytest.mark.slow
def test_loops_over_sincos_vectorise(tmp_path):
    version = subprocess.run([COMPILER, "--version"], capture_output=True, text=True, check=True)
    machine = subprocess.run([COMPILER, "-dumpmachine"], capture_output=True, text=True, check=True)
    if "Free Software Foundation" not in version.stdout or "x86_64-linux" not in machine.stdout:
        pytest.skip("the report is that of GCC on x86-64 Linux")
    report = tmp_path / "report.txt"
    build(tmp_path, "-O3", *VECTORS, f"-fopt-info-vec={report}")
    told = report.read_text().splitlines()
    loops = [line for line in told if "driver.c" in line and "loop vect" in line]
    assert sum("16 byte" in line for line in loops) >= 2
    assert any("32 byte" in line for line in loops)


def cases(count):
    """Draw frequencies, rows, duration and floors, with sums of very different size and drift."""
    generator = np.random.default_rng(count)
    for _ in range(count):
        sums, terms = generator.integers(1, 5), generator.integers(0, 5)
        frequency = generator.uniform(0.05, 3, terms)
        rows = generator.normal(size=(sums, 2 + 2 * terms))
        rows *= generator.choice([1, 1e-2, 1e-5, 0], rows.shape, p=[0.6, 0.2, 0.1, 0.1])
        duration = generator.choice([0.0, 0.3, 3.0, 30.0]) * generator.uniform(0.5, 1.5)
        yield frequency, rows, duration, generator.choice([-math.inf, 0, 0.5, 1e3], sums)


def hard_cases():
    """Long windows of which the first or last cell decides, grazing peaks, flat sums, a zero."""
    for drift in (-1e-3, 0.0, 1e-3):
        yield [1.0, 2.3], [[0.0, drift, 1.0, 0.5, -0.3, 0.8]], 3000.0, [-math.inf]
    generator = np.random.default_rng(3)
    for at, exponent in zip(generator.uniform(0.1, 2.9, 180), 20 * [*range(6, 15)], strict=True):
        row = [10.0**-exponent - 1.0, 0.0, math.cos(2 * at), math.sin(2 * at)]
        yield [2.0], [row], 3.0, [0.0]
    for end in generator.uniform(0.1, 3.0, 200):
        row = [-math.sin(end / 2), 0.0, 0.0, 1.0]
        for floor in (rounding([0.5], row, end), -math.inf):
            yield [0.5], [row], end, [floor]
    flat = [[-3.0, 0.0, 4.0, -1.0, 0.0, 0.0], [0.0, 0.0, 1.0, -0.0, 0.0, 0.0]]
    yield [1.0, 2.0], flat, 7.0, [-math.inf, 0.0]
    yield [1.0, 1.0], [[0.0, 0.0, 1.0, -1.0, 0.5, -0.5]], 1.0, [-math.inf]
    # the Hermite interpolant is zero: only the bound on its error tells of the bump
    frequency, row, duration = bump_between_flat_ends()
    yield frequency, [row], duration, [0.99]


@pytest.mark.slow
def test_maxima_are_those_of_python(vector):
    """Whose laws are measured in tests/events."""
    for frequency, rows, duration, floor in (*cases(500), *hard_cases()):
        values, times = maxima(vector.maxima_plain, frequency, rows, duration, floor)
        for value, time, row, least in zip(values, times, rows, floor, strict=True):
            function = as_sum(frequency, row)
            tolerance = rounding(frequency, row, duration)
            expected = maximum(function, duration, float(least))
            assert abs(value - expected.value) <= tolerance
            assert math.isnan(time) == (value == least)
            if value > least:
                assert 0 <= time <= duration
                assert abs(function(time) - value) <= tolerance


def test_rounding_is_that_of_all_terms(vector):
    vector.rounding.restype = ctypes.c_double
    for frequency, rows, duration, _ in cases(100):
        for row in rows:
            value = vector.rounding(
                len(frequency), pointer(frequency), pointer(row), ctypes.c_double(duration)
            )
            assert value == pytest.approx(rounding(frequency, row, duration), rel=1e-14)


@pytest.mark.parametrize(
    ("change", "lost"),
    [
        *(({place: bad}, 1) for place in range(4) for bad in (math.nan, math.inf)),
        *(({what: bad}, 0) for what in ("frequency", "duration") for bad in (math.nan, math.inf)),
        *[({"duration": -1e-9}, 0), ({"duration": 1.001e5}, 0), ({"frequency": -1.0}, 0)],
        *[({"floor": math.nan}, 0), ({"terms": 9}, 0)],
    ],
    ids=str,
)
def test_where_there_is_no_guarantee_there_is_nan(vector, change, lost):
    """For all sums from the `lost` one on; nine terms are too many."""
    given = {"frequency": 1.0, "duration": 2.0, "floor": 0.0, "terms": 1} | change
    row = [0.5, 0.1, *[1.0] * 2 * given["terms"]]
    rows = np.array([row, row])
    for place in change.keys() & set(range(4)):
        rows[1, place] = change[place]
    frequencies = [given["frequency"]] * given["terms"]
    found = maxima(vector.maxima_plain, frequencies, rows, given["duration"], [given["floor"]] * 2)
    assert np.isnan(found[:, lost:]).all()
    assert not np.isnan(found[0, :lost]).any()

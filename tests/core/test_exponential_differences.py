"""Divided differences of the exponential: the values of a 50-digit exponential everywhere."""

import json
import math

import numpy as np
import pytest
from flint import arb
from hypothesis import given, settings
from hypothesis import strategies as st

from nonsmooth.runtime.core.arithmetic import FLOATS, Balls, Mpmath, exact_ball
from nonsmooth.runtime.core.json_codec import decode, encode
from nonsmooth.runtime.core.taylor_models import space_of
from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.model.expressions import Function, written
from tests.exponentials import error, exact, forced, largest_root, periods, repeated

BALLS = Balls()


def time_of(factors, count):
    return count * 2 * math.pi / largest_root(factors)


@settings(max_examples=80)
@given(
    forced().map(lambda factors: (factors, 1)) | repeated().map(lambda factors: (factors, 3)),
    periods,
    st.integers(0, 3),
)
def test_doubles_have_the_digits_of_the_exact_flow(drawn, count, k):
    """Also of repeated and nearly equal factors, with a few roundings more."""
    factors, allowed = drawn
    t, k = time_of(factors, count), min(k, sum(map(len, factors)) - 1)
    assert error(float(FLOATS.exponential_difference(k, t, *factors)), k, t, factors) <= allowed


@pytest.mark.parametrize(
    "factor",
    [
        (6.0, 11.0, 6.0),
        (1.0, 3.0, 3.0),
        (4.0, 0.0, 5.0, 0.0),
        (1.0, 0.2, 2.01, 0.2),
        (0.0, 1.0, 0.0),
    ],
)
def test_higher_degrees_by_numeric_roots(factor):
    for t in (0.1, 2.0, 30.0):
        for k in range(len(factor)):
            found = float(FLOATS.exponential_difference(k, t, factor, (2.0, 0.0)))
            assert error(found, k, t, [factor, (2.0, 0.0)]) <= 10  # times their condition


@pytest.mark.parametrize("damping", [1e3, 1e6])
def test_the_slow_root_keeps_its_digits(damping):
    factors = [(1.0, damping)]
    for t in (1e-6, 1.0, damping):
        found = float(FLOATS.exponential_difference(0, t, *factors))
        assert found == pytest.approx(float(exact(0, t, factors)), rel=1e-13)


@pytest.mark.parametrize("count", [2, 3, 4])
def test_undamped_roots_have_no_damping(count):
    """Not even after so many turns that a rounding of it would show."""
    frequencies = np.geomspace(1.0, 7.0, count)
    squares = np.polynomial.polynomial.polyfromroots(-(frequencies**2))[:-1]
    factor = [c for square in squares for c in (square, 0.0)]
    early, late = (
        np.abs(FLOATS.exponential_difference(2 * count - 1, times, factor))
        for times in (np.linspace(0, 100, 500), 1e17 * np.linspace(1, 2, 500))
    )
    assert late.max() == pytest.approx(early.max(), rel=0.2)


def test_arrays_broadcast():
    t, w = np.linspace(0, 4, 5), np.array([[1.0], [2.0]])
    found = FLOATS.exponential_difference(1, t, (w**2, 0))
    assert found.shape == (2, 5)
    np.testing.assert_allclose(found, np.cos(w * t), atol=1e-14)
    assert FLOATS.exponential_difference(0, 2, (0,), (0,)) == 2.0


@pytest.mark.parametrize("bad", [math.nan, math.inf, -math.inf, 1e300, -1e300, 5e-324])
def test_hostile_numbers_end(bad):
    for factors in ([(1.0, bad)], [(bad, 1.0), (2.0,)], [(bad, bad, bad), (0, 0)]):
        for t in (1.0, bad):
            FLOATS.exponential_difference(1, t, *factors)
    for t in (-1.0, -30.0):
        assert FLOATS.exponential_difference(0, t, (4.0, 0.0)) == pytest.approx(math.sin(2 * t) / 2)


@settings(max_examples=15)
@given(repeated(), periods, st.integers(0, 3))
def test_mpmath_has_its_digits(factors, count, k):
    t = time_of(factors, count)
    found = exact_ball(Mpmath(40).exponential_difference(k, t, *factors))
    with flint_precision(300):
        wanted = exact(k, t, factors)
        assert abs(found - wanted) < abs(wanted) * arb("1e-38") + arb("1e-75")


@settings(max_examples=40)
@given(forced(), st.floats(0.0, 20.0), st.integers(0, 3), st.sampled_from([0.0, 1e-12, 1e-3, 3e-2]))
def test_balls_contain_what_they_enclose(factors, count, k, width):
    t, k = time_of(factors, count), min(k, sum(map(len, factors)) - 1)
    wide = [tuple(arb(c, abs(c) * width) for c in f) for f in factors]
    found = BALLS.exponential_difference(k, arb(t, t * width), *wide)
    if width == 0:
        assert found.contains(exact(k, t, factors).mid())
        return
    rng = np.random.default_rng(1)
    for _ in range(6):
        s = rng.choice([-1.0, 1.0, rng.uniform(-1, 1)], 1 + sum(map(len, factors))) * width * 0.999
        moved, place = [], 1
        for f in factors:
            moved.append(tuple(c * (1 + s[place + j]) for j, c in enumerate(f)))
            place += len(f)
        value = exact(k, t * (1 + s[0]), moved)
        assert found.contains(value) or found.overlaps(value)


@pytest.mark.parametrize("beside", [1e-1, 1e-7, 0.0])
def test_balls_are_hardly_wider_than_the_range(beside):
    """To first order the range is the sum of the absolute derivatives times the radii."""
    t, width = 20.0, 1e-8
    factors = [(1.0, 0.1), (1.0 + beside, 0.0)]
    for k in range(3):
        with flint_precision(53):
            wide = [tuple(arb(c, width if c else 0) for c in f) for f in factors]
            found = BALLS.exponential_difference(k, arb(t, width), *wide)
        slopes = [float(exact(k + 1, t, factors))] if k < 3 else []
        slopes += [
            float(exact(k + j, t, [*factors, f])) for f in factors for j, c in enumerate(f) if c
        ]
        assert 1 <= float(found.rad()) / (width * sum(map(abs, slopes))) < 1.01


def test_models_contain_the_range_and_keep_what_variables_share():
    space = space_of(2, 5)
    t = space.variable(0, arb(3), arb("0.01"))
    w2 = space.variable(1, arb(4), arb("0.02"))
    found = BALLS.exponential_difference(1, t, (w2, arb("0.25")), (w2, 0))
    for x, y in ((0.3, -0.7), (1.0, 1.0), (-1.0, 0.5)):
        time, constant = 3 + arb(x) / 100, 4 + arb(y) / 50
        value = exact(1, time, [(constant, arb("0.25")), (constant, arb(0))])
        enclosed = found.at([arb(x), arb(y)])
        assert enclosed.overlaps(value)
        assert float(enclosed.rad()) < 1e-11


def test_written_down_as_data_it_gives_the_same_digits():
    def kernel(a, *, lib):
        [t, c0, c1] = a
        return [lib.exponential_difference(1, t, (c0, 2 * c1), (0,), (4, 0)) + 1]

    function = written(kernel, [["t", "c0", "c1"]], [((3,), 0)], [("difference", (1,))])
    read = decode(Function, json.loads(json.dumps(encode(function))))
    assert read([1.5, 2.0, 0.3], lib=FLOATS) == kernel([1.5, 2.0, 0.3], lib=FLOATS)

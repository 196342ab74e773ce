"""Laws of guaranteed maxima, checked against ball arithmetic."""

import math
from dataclasses import replace

import numpy as np
import pytest
from flint import arb
from hypothesis import given, settings
from hypothesis import strategies as st

from nonsmooth.runtime.events.crossings_and_maxima import maximum
from tests.sums import trigonometric

amplitudes = st.floats(-2, 2).map(lambda x: round(x, 6))
laws = settings(max_examples=200)


@st.composite
def sums(draw, least=0):
    terms = draw(st.integers(least, 3))
    rows = [
        tuple(draw(st.lists(values, min_size=terms, max_size=terms)))
        for values in (amplitudes, amplitudes, st.floats(0.05, 3))
    ]
    return trigonometric(draw(amplitudes), draw(amplitudes), *rows)


def ball(function, t):
    line, *waves = function.functions.parts
    value = sum(
        (arb(x.real) * arb(t) ** k for k, x in enumerate(function.factors[: line.end])), arb(0)
    )
    for wave in waves:
        factor, angle = function.factors[wave.first], arb(wave.exponent.imag) * t
        value += arb(factor.real) * angle.cos() - arb(factor.imag) * angle.sin()
    return value


def changed(function, constant=0.0, slope=0.0):
    """Add a line to a sum."""
    head, drift, *waves = function.factors
    factors = (head + constant, drift + slope, *waves)
    return replace(function, factors=factors, sizes=tuple(map(abs, factors)))


def stays_below(function, duration, bound, start=0.0):
    """Prove g <= bound on the window: balls with a mean value form, subdivided where needed."""
    slope = function.derivative()
    curvature = slope.derivative()
    waiting = [(arb(start), arb(duration))]
    for _ in range(20000):
        if not waiting:
            return True
        left, right = waiting.pop()
        middle, half = arb(((left + right) / 2).mid()), arb(((right - left) / 2).abs_upper())
        step = arb(0, half)
        value = ball(function, middle) + ball(slope, middle) * step
        value += ball(curvature, middle + step) * arb(half**2 / 4, half**2 / 4)
        if value <= bound:
            continue
        if ball(function, middle) > bound:
            return False
        waiting += [(left, middle), (middle, right)]
    raise AssertionError("undecided")


@laws
@given(sums(), st.floats(0, 8))
def test_no_value_exceeds_the_maximum_and_it_is_attained(function, duration):
    value, time = maximum(function, duration)
    tolerance = function.rounding(duration)
    assert stays_below(function, duration, arb(value) + arb(tolerance))
    assert 0 <= time <= duration
    assert abs(function(time) - value) <= tolerance


@laws
@given(sums(), st.floats(0, 8), st.floats(-3, 3))
def test_the_floor_cuts_off_what_lies_below(function, duration, floor):
    free, cut = maximum(function, duration), maximum(function, duration, floor)
    missed = 2 * function.rounding(duration)
    assert cut.value == pytest.approx(max(free.value, floor), rel=0, abs=missed)
    assert math.isnan(cut.time) == (cut.value == floor)


@laws
@given(sums(), st.floats(0.1, 6))
def test_an_exact_zero_at_either_end_is_no_violation(function, duration):
    value = function(duration)
    # |g''| <= bend at all times
    bend = function.bound(2, 0.0, duration)
    for end in (0.0, duration):
        rate = function.derivative()(end)
        # The drift makes the sum rise to zero at T, or fall from zero at 0.
        drift = (1 if end else -1) * (bend * duration + 0.1) - rate
        shifted = changed(function, slope=drift)
        shifted = changed(shifted, constant=-shifted(end))
        tolerance = shifted.rounding(duration)
        assert math.isnan(maximum(shifted, duration, tolerance).time)
        assert abs(maximum(shifted, duration).value) <= tolerance
    assert math.isfinite(value)


def test_flat_maxima_end_and_are_right():
    """Where second derivatives vanish, or terms cancel altogether, no Newton step helps."""
    quartic = trigonometric(-3.0, 0.0, (4.0, -1.0), (0.0, 0.0), (1.0, 2.0))  # -(1 - cos t)^2 * 2
    assert abs(maximum(quartic, 7.0).value) <= quartic.rounding(7.0)
    nothing = trigonometric(0.0, 0.0, (1.0, -1.0), (0.5, -0.5), (1.0, 1.0))
    assert abs(maximum(nothing, 1.0).value) <= nothing.rounding(1.0)
    assert maximum(trigonometric(1.5, 0.0, (), (), ()), 3.0) == (1.5, 0.0)


def fitted(slope, duration):
    """Fit a sum with three frequencies whose derivative follows a given one on the window."""
    w, t = np.array([0.3, 0.6, 1.0]), np.linspace(0, duration, 60)[:, None]
    rows = np.hstack([np.ones_like(t), -w * np.sin(w * t), w * np.cos(w * t)])
    a = np.linalg.lstsq(rows, slope(t[:, 0] / duration), rcond=None)[0].tolist()
    return trigonometric(0.0, a[0], tuple(a[1:4]), tuple(a[4:]), tuple(w.tolist()))


@pytest.mark.parametrize("late", [3, 4, 5])
def test_a_skew_peak_does_not_mislead_newton(late):
    """Within one cell g' first grows, and then falls steeply through zero."""
    function = fitted(lambda s: 0.1 + s**late - 1.3 * s ** (late + 1), 0.58)
    value, time = maximum(function, 0.58)
    tolerance = function.rounding(0.58)
    assert tolerance < 1e-6
    assert 0.4 < time < 0.58
    assert abs(function(time) - value) <= tolerance
    assert stays_below(function, 0.58, arb(value) + arb(tolerance))


def test_a_bump_between_ends_that_slope_away_from_it_is_found():
    """Only the bound on the error of a cell's interpolant tells of it."""
    function = fitted(lambda s: (s * (1 - s) - 0.02) * (1 - 2 * s), 0.58)
    found = maximum(function, 0.58)
    assert found == (pytest.approx(function(0.29), rel=1e-12), pytest.approx(0.29, abs=1e-3))
    assert function(0.29) > function(0.0) + 0.01


@pytest.mark.parametrize("scale", [1e-60, 1e-3, 1e6, 1e60])
def test_units_do_not_matter(scale):
    function = trigonometric(-0.3, 0.1, (1.0, 0.4), (0.2, 0.7), (1.0, 2.6))
    slow = trigonometric(-0.3, 0.1 / scale, (1.0, 0.4), (0.2, 0.7), (1.0 / scale, 2.6 / scale))
    value, time = maximum(function, 5.0)
    assert maximum(slow, 5.0 * scale) == pytest.approx((value, time * scale), rel=1e-7)


@pytest.mark.parametrize(
    ("window", "told"),
    [
        ((math.nan,), "duration"), ((-1.0,), "duration"), ((math.inf,), "duration"),
        ((1.001e5,), "duration"), ((1.0, math.nan), "floor"),
    ],
)  # fmt: skip
def test_windows_without_a_guarantee_and_floors_that_are_none_are_refused(window, told):
    with pytest.raises(ValueError, match=told):
        maximum(trigonometric(1.0, 1.0, (1.0,), (1.0,), (1.0,)), *window)


@pytest.mark.parametrize(
    ("arguments", "noise", "expected"),
    [
        ((0, 0, (1.0,), (1e-9,), (2.0,)), 0.0, True),
        ((-1, 0, (1.0,), (1e-9,), (2.0,)), 0.0, True),
        ((-1, 0, (1.0,), (-1e-9,), (2.0,)), 0.0, False),
        ((-1, 0, (1.0,), (0.0,), (2.0,)), 0.0, False),
        ((-1, 0, (1.0,), (1e-15,), (2.0,)), 0.0, False),  # within the rounding of the slope
        ((-1, 0, (1.0,), (1e-9,), (2.0,)), 1e-8, False),  # within the error of what is given
        ((0, 1e-300, (), (), ()), 0.0, True),
        ((0, 0, (), (), ()), 0.0, False),
        ((0, -1, (0.0,), (1.0,), (1.5,)), 0.0, True),
        ((0, -2, (0.0,), (1.0,), (1.5,)), 0.0, False),
    ],
)
def test_a_sum_rises_where_its_slope_is_surely_positive(arguments, noise, expected):
    assert trigonometric(*arguments).rises(noise) is expected

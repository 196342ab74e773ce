"""Laws of guaranteed maxima, checked against ball arithmetic."""

import math
from dataclasses import astuple, replace

import numpy as np
import pytest
from flint import arb
from hypothesis import example, given, settings
from hypothesis import strategies as st

from nonsmooth.runtime.events.guaranteed_maxima import (
    Cells,
    CurveSamples,
    TrigonometricSum,
    largest,
)

amplitudes = st.floats(-2, 2).map(lambda x: round(x, 6))
laws = settings(max_examples=200)


@st.composite
def sums(draw, least=0):
    terms = draw(st.integers(least, 3))
    rows = [
        tuple(draw(st.lists(values, min_size=terms, max_size=terms)))
        for values in (amplitudes, amplitudes, st.floats(0.05, 3))
    ]
    return TrigonometricSum(draw(amplitudes), draw(amplitudes), *rows)


def ball(function, t):
    value = arb(function.constant) + arb(function.slope) * t
    for c, s, w in function.terms():
        value += arb(c) * (arb(w) * t).cos() + arb(s) * (arb(w) * t).sin()
    return value


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


def grazing(peak, frequency=2.0, at=0.83):
    """A sum whose only maximum in one period is the peak, at a given time."""
    cosine = (math.cos(frequency * at), math.sin(frequency * at))
    return TrigonometricSum(-1.0 + peak, 0.0, (cosine[0],), (cosine[1],), (frequency,))


@laws
@given(sums(), st.floats(0, 8))
def test_no_value_exceeds_the_maximum_and_it_is_attained(function, duration):
    value, time = function.maximum(duration)
    tolerance = function.rounding(duration)
    assert stays_below(function, duration, arb(value) + arb(tolerance))
    assert 0 <= time <= duration
    assert abs(function(time) - value) <= tolerance


@laws
@given(sums(), st.floats(0, 8), st.floats(-3, 3))
def test_the_floor_cuts_off_what_lies_below(function, duration, floor):
    free, cut = function.maximum(duration), function.maximum(duration, floor)
    assert cut.value == pytest.approx(
        max(free.value, floor), rel=0, abs=function.rounding(duration)
    )
    assert math.isnan(cut.time) == (cut.value == floor)


@laws
@given(sums(), st.floats(0, 4), st.floats(0, 4))
def test_a_longer_window_has_no_smaller_maximum(function, duration, more):
    longer = function.maximum(duration + more).value
    assert longer >= function.maximum(duration).value - function.rounding(duration + more)


@laws
@given(amplitudes, amplitudes, st.floats(0, 1e3))
def test_a_linear_sum_is_largest_at_an_end(constant, slope, duration):
    function = TrigonometricSum(constant, slope, (), (), ())
    assert function.maximum(duration).value == max(function(0.0), function(duration))


@laws
@given(sums(), st.floats(0.1, 6))
def test_an_exact_zero_at_either_end_is_no_violation(function, duration):
    value = function(duration)
    # |g''| <= bend at all times
    bend = sum(math.hypot(c, s) * w * w for c, s, w in function.terms())
    for end in (0.0, duration):
        rate = function.derivative()(end)
        # The drift makes the sum rise to zero at T, or fall from zero at 0.
        drift = (1 if end else -1) * (bend * duration + 0.1) - rate
        shifted = replace(function, slope=function.slope + drift)
        shifted = replace(shifted, constant=shifted.constant - shifted(end))
        tolerance = shifted.rounding(duration)
        assert math.isnan(shifted.maximum(duration, tolerance).time)
        assert abs(shifted.maximum(duration).value) <= tolerance
    assert math.isfinite(value)


@pytest.mark.parametrize("exponent", range(6, 15))
def test_a_peak_too_narrow_to_sample_is_found(exponent):
    peak = 10.0**-exponent
    generator = np.random.default_rng(exponent)
    for at in generator.uniform(0.2, 2.0, 20):
        function = grazing(peak, at=at)
        tolerance = function.rounding(3.0)
        above, below = function.maximum(3.0, 0.0), grazing(-peak, at=at).maximum(3.0, 0.0)
        assert abs(above.value - peak) <= tolerance
        assert abs(above.time - at) < 1e-6 if peak > tolerance else True
        assert below.value <= tolerance
        assert (below.value == 0) or peak <= tolerance


def test_flat_maxima_end_and_are_right():
    """Where second derivatives vanish, or terms cancel altogether, no Newton step helps."""
    quartic = TrigonometricSum(-3.0, 0.0, (4.0, -1.0), (0.0, 0.0), (1.0, 2.0))  # -(1 - cos t)^2 * 2
    assert abs(quartic.maximum(7.0).value) <= quartic.rounding(7.0)
    nothing = TrigonometricSum(0.0, 0.0, (1.0, -1.0), (0.5, -0.5), (1.0, 1.0))
    assert abs(nothing.maximum(1.0).value) <= nothing.rounding(1.0)
    assert TrigonometricSum(1.5, 0.0, (), (), ()).maximum(3.0) == (1.5, 0.0)


def fitted(slope, duration):
    """Fit a sum with three frequencies whose derivative follows a given one on the window."""
    w, t = np.array([0.3, 0.6, 1.0]), np.linspace(0, duration, 60)[:, None]
    rows = np.hstack([np.ones_like(t), -w * np.sin(w * t), w * np.cos(w * t)])
    a = np.linalg.lstsq(rows, slope(t[:, 0] / duration), rcond=None)[0].tolist()
    return TrigonometricSum(0.0, a[0], tuple(a[1:4]), tuple(a[4:]), tuple(w.tolist()))


@pytest.mark.parametrize("late", [3, 4, 5])
def test_a_skew_peak_does_not_mislead_newton(late):
    """Within one cell g' first grows, and then falls steeply through zero."""
    function = fitted(lambda s: 0.1 + s**late - 1.3 * s ** (late + 1), 0.58)
    value, time = function.maximum(0.58)
    tolerance = function.rounding(0.58)
    assert tolerance < 1e-6
    assert 0.4 < time < 0.58
    assert abs(function(time) - value) <= tolerance
    assert stays_below(function, 0.58, arb(value) + arb(tolerance))


def test_a_bump_between_flat_ends_is_found():
    """Where g = g' = 0 at both ends of a cell, only the bound on its error tells of the bump."""
    function = fitted(lambda s: s * (1 - s) * (1 - 2 * s), 0.58)
    function = replace(function, constant=-function(0.0))
    top = function(0.29)
    found = function.maximum(0.58, 0.99 * top)
    assert found.value == pytest.approx(top, rel=1e-6)
    assert found.time == pytest.approx(0.29, abs=1e-3)


@pytest.mark.parametrize("scale", [1e-150, 1e-3, 1e6, 1e150])
def test_units_do_not_matter(scale):
    function = TrigonometricSum(-0.3, 0.1, (1.0, 0.4), (0.2, 0.7), (1.0, 2.6))
    slow = replace(
        function, slope=function.slope / scale, frequency=tuple(w / scale for w in (1.0, 2.6))
    )
    value, time = function.maximum(5.0)
    assert slow.maximum(5.0 * scale) == pytest.approx((value, time * scale), rel=1e-7)


@laws
@given(sums(), st.floats(0, 8))
@example(TrigonometricSum(0.0, 1.75, (), (), ()), 2.225073858507e-311)  # the product underflows
def test_derivative_and_rounding_belong_to_the_function(function, t):
    step = 1e-5
    slope = function.derivative()
    quotient = (function(t + step) - function(t - step)) / (2 * step)
    assert slope(t) == pytest.approx(quotient, abs=1e-7)
    exact = ball(function, arb(t))
    assert abs(arb(function(t)) - exact) <= arb(function.rounding(t))


def test_arrays_are_evaluated_element_by_element():
    function = TrigonometricSum(0.5, -0.2, (1.0, 2.0), (0.3, 0.1), (1.0, 1.7))
    times = np.linspace(0, 9, 12).reshape(3, 4)
    values = function(times)
    assert values.shape == (3, 4)
    np.testing.assert_allclose(values.ravel(), [function(t) for t in times.ravel().tolist()])


sound = TrigonometricSum(1.0, 1.0, (1.0,), (1.0,), (1.0,))


@pytest.mark.parametrize("field", range(5))
@pytest.mark.parametrize("bad", [math.nan, math.inf])
def test_numbers_must_be_finite(field, bad):
    values = list(astuple(sound))
    values[field] = bad if field < 2 else (bad,)
    with pytest.raises(ValueError, match="finite"):
        TrigonometricSum(*values)


def test_lengths_and_frequencies_are_checked():
    with pytest.raises(ValueError, match="equal lengths"):
        TrigonometricSum(0.0, 0.0, (1.0,), (), (1.0,))
    with pytest.raises(ValueError, match="not negative"):
        TrigonometricSum(0.0, 0.0, (1.0,), (1.0,), (-1.0,))


@pytest.mark.parametrize("duration", [math.nan, -1.0, math.inf, 1.001e5])
def test_windows_without_a_guarantee_are_refused(duration):
    with pytest.raises(ValueError, match="duration"):
        sound.maximum(duration)


def test_a_floor_that_is_no_number_is_refused():
    with pytest.raises(ValueError, match="floor"):
        sound.maximum(1.0, math.nan)


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
    assert TrigonometricSum(*arguments).rises(noise) is expected


@pytest.mark.parametrize("slack", [1e-6, 1e-9, 1e-12])
@pytest.mark.parametrize("cells", [3, 20, 80])
def test_a_maximum_is_exceeded_by_no_more_than_the_slack(slack, cells):
    for phase in np.random.default_rng(4).uniform(0.5, 2.5, 20).tolist():
        times = np.linspace(0, 3, cells + 1)

        def jet(time, phase=phase):
            return math.cos(time - phase), -math.sin(time - phase), -math.cos(time - phase)

        values, slopes, _ = (np.array(part) for part in zip(*map(jet, times), strict=True))
        excess = np.full(cells, (3 / cells) ** 4 / 144)
        samples = CurveSamples(values, times, slopes)
        found = largest(Cells(samples, excess, lambda cell, jet=jet: jet), slack, -math.inf)
        assert 1 - slack <= found.value <= 1
        assert found.value == jet(found.time)[0]

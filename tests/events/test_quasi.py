"""Laws of quasi-polynomials and their first crossings, against 40 digits and fine samples."""

import math
from itertools import islice, pairwise

import mpmath as mp
import numpy as np
import pytest

from nonsmooth import InputError
from nonsmooth.runtime.events.crossings_and_maxima import first_crossing
from tests.sums import plain_sum

HIGH = mp.MPContext()
HIGH.dps = 40


def terms(function):
    """Give each exponent with its polynomial."""
    for part in function.parts:
        yield part.exponent, function.factors[part.first : part.end]


def exact(function, t, order=0):
    """The value or a derivative in 40 digits."""
    total = HIGH.mpf(0)
    for exponent, p in terms(function):
        p = [HIGH.mpmathify(complex(c)) for c in p]
        exponent = HIGH.mpmathify(complex(exponent))
        for _ in range(order):
            raised = [exponent * c for c in p]
            for k in range(1, len(p)):
                raised[k - 1] += k * p[k]
            p = raised
        value = sum((c * HIGH.mpf(t) ** k for k, c in enumerate(p)), HIGH.mpf(0))
        total += (value * HIGH.exp(exponent * t)).real
    return total


def random_function(generator, kind):
    count = generator.integers(1, 4)
    speeds = generator.uniform(0.3, 3.0, count)
    rates = np.zeros(count)
    lengths = np.ones(count, int)
    if kind == "ratio":
        count = 2
        speeds = np.array([1.0, 10 ** generator.uniform(1, 4)])
        rates, lengths = np.zeros(2), np.ones(2, int)
    elif kind == "cluster":
        count = 3
        speeds = 1.0 + np.array([0.0, 1.0, 2.0]) * 10 ** generator.uniform(-4, -1)
        rates, lengths = np.zeros(3), np.ones(3, int)
    elif kind == "decay":
        rates = -generator.uniform(0.01, 1.0, count)
    elif kind == "growth":
        rates = generator.uniform(0.01, 0.4, count)
    elif kind == "powers":
        rates = -generator.uniform(0.05, 0.5, count)
        lengths = generator.integers(1, 4, count)
    polynomials = [generator.normal(size=n) + 1j * generator.normal(size=n) for n in lengths]
    if kind == "cluster":  # huge amplitudes of a function of size 1
        gap = speeds[1] - 1.0
        polynomials = [np.array([c / gap**2]) for c in (1.0, -2.0, 1.0)]
    exponents = [complex(a, b) for a, b in zip(rates, speeds, strict=True)]
    drift = [complex(generator.normal() * 0.1)] if generator.random() < 0.4 else []
    exponents.append(0j)
    value = sum(p[0].real for p in polynomials)
    size = min(sum(abs(p[0]) for p in polynomials), 3.0)
    level = value + size * generator.uniform(0.02, 1.2)
    polynomials.append(np.array([-level, *drift]))
    return plain_sum(tuple(exponents), tuple(tuple(complex(c) for c in p) for p in polynomials))


KINDS = ("plain", "ratio", "cluster", "decay", "growth", "powers")


@pytest.mark.parametrize("kind", KINDS)
def test_errors_and_bounds_hold(kind):
    generator = np.random.default_rng(10 + KINDS.index(kind))
    for _ in range(6):
        function = random_function(generator, kind)
        start, length = generator.uniform(0, 5), generator.uniform(0.01, 2)
        slope = function.derivative()
        for t in generator.uniform(start, start + length, 6):
            value, first, second, error = function.jet(t)
            assert abs(value - exact(function, t)) <= error
            assert abs(first - exact(function, t, 1)) <= slope.rounding(t)
            assert abs(slope(t) - first) <= 2 * slope.rounding(t)
            assert abs(second - exact(function, t, 2)) <= slope.derivative().rounding(t)
            for order in range(6):
                assert abs(exact(function, t, order)) <= function.bound(order, start, length)
            assert exact(function, t) <= function.ceiling(start)
        values, errors = zip(*islice(function.taylor(), 8), strict=True)
        for order in range(8):
            assert abs(values[order] - exact(function, 0, order)) <= errors[order]
            assert errors[order] <= 2.0**-46 * function.bound(order, 0.0, 0.0)


def fourier(half, factors, odd):
    """-(1 - cos t)^half, times 1 - factor (1 - cos t) for each, and sin t if odd."""
    wave = np.array([-0.5, 1.0, -0.5])  # 1 - cos t by powers of e^(it)
    value = np.array([-1.0])
    for _ in range(half):
        value = np.convolve(value, wave)
    for factor in factors:
        value = np.convolve(value, np.array([0.0, 1.0, 0.0]) - factor * wave)
    value = value.astype(complex)
    if odd:
        value = np.convolve(value, np.array([0.5j, 0, -0.5j]))  # sin t
    middle = len(value) // 2
    exponents = tuple(complex(0, k) for k in range(middle + 1))
    coefficients = [value[middle]] + [2 * value[middle + k] for k in range(1, middle + 1)]
    return plain_sum(exponents, tuple((complex(c),) for c in coefficients))


@pytest.mark.parametrize("factor", [1.0, 3.0, 64.0, 4096.0, 2.0**20])
@pytest.mark.parametrize(("half", "odd"), [(0, True), (1, False), (1, True), (2, False)])
def test_a_start_at_zero_is_left_and_the_way_back_is_relative(half, odd, factor):
    function = fourier(half, [factor], odd)
    values, errors = zip(*islice(function.taylor(), 2 * half + odd + 1), strict=True)
    assert all(abs(v) <= e for v, e in pairwise((*values[:-1], 0.0)) if e == 0)
    assert abs(values[-1]) > errors[-1]
    expected = float(HIGH.acos(1 - 1 / HIGH.mpf(factor)))
    found = first_crossing(function, 3.0)
    # the coefficients of these derivatives round, absolutely: a small root feels it
    assert found.time == pytest.approx(expected, rel=1e-13)
    assert abs(found.time - expected) <= found.error + 4 * math.ulp(expected)


@pytest.mark.parametrize("order", [1, 2, 3, 4])
def test_a_short_way_beyond_zero_is_not_passed_over(order):
    """Two roots next to each other behind a start that is a root of some order."""
    generator = np.random.default_rng(order)
    for factor in 2.0 ** generator.uniform(1, 10, 15):
        other = factor / (1 + 10 ** generator.uniform(-3, 0))
        found = first_crossing(fourier(order // 2, [factor, other], bool(order % 2)), 3.0)
        assert found.time == pytest.approx(math.acos(1 - 1 / factor), rel=1e-6)


@pytest.mark.parametrize("power", [-3, -6, -9, -11])
def test_a_short_flight_keeps_its_digits(power):
    velocity = 10.0**power
    ball = plain_sum((0j,), ((0j, complex(-velocity), 0.5 + 0j),))
    assert first_crossing(ball, math.inf).time == pytest.approx(2 * velocity, rel=1e-14)
    # -v sin t + (1 - cos t): the root of tan(t/2) = v
    swing = plain_sum((0j, 1j), ((1 + 0j,), (complex(-1, velocity),)))
    assert first_crossing(swing, 3.0).time == pytest.approx(2 * math.atan(velocity), rel=1e-3)


@pytest.mark.parametrize("at", [0.83, 1.7, 2.4])
@pytest.mark.parametrize("rate", [0.0, -0.1, 0.1])
def test_a_touch_is_reported_or_an_event_and_a_crossing_is_found(at, rate):
    def touching(peak):
        # -(1 - cos 2(t - a)) e^(rt) + peak e^(rt), by its terms
        turn = complex(math.cos(2 * at), -math.sin(2 * at))
        return plain_sum((complex(rate), complex(rate, 2)), ((-1 + peak + 0j,), (turn,)))

    for peak in (0.0, 1e-15, -1e-15):
        passed = first_crossing(touching(peak), 3.0)
        assert passed.time is None
        assert len(passed.touched) == 1
        time, depth = passed.touched[0]
        assert time == pytest.approx(at, abs=1e-7)
        assert abs(depth) <= 2 * touching(peak).rounding(time)
        event = first_crossing(touching(peak), 3.0, reached=True)
        assert event.time == pytest.approx(at, abs=1e-7)
        assert not event.touched
    for peak in (1e-13, 1e-10, 1e-6):
        found = first_crossing(touching(peak), 3.0)
        assert found.time == pytest.approx(at - math.acos(1 - peak) / 2, abs=1.1 * found.error)
        assert not found.touched
    for peak in (-1e-13, -1e-8):
        for reached in (False, True):
            found = first_crossing(touching(peak), 3.0, reached=reached)
            assert found.time is None
            assert not found.touched


def test_a_touch_beside_a_later_crossing():
    shape = np.polynomial.polynomial.polyfromroots([2.0, 2.0, 5.0])
    cubic = plain_sum((0j,), (tuple(complex(c) for c in shape),))
    found = first_crossing(cubic, math.inf)
    assert found.time == pytest.approx(5.0, abs=found.error)
    assert [t for t, _ in found.touched] == pytest.approx([2.0])
    early = first_crossing(cubic, math.inf, reached=True)
    assert early.time == pytest.approx(2.0, abs=1e-6)


@pytest.mark.parametrize("seed", range(20))
def test_polynomials_find_their_first_root_or_prove_there_is_none(seed):
    generator = np.random.default_rng(seed)
    roots = np.sort(10 ** generator.uniform(-6, 6, 3))
    shape = np.polynomial.polynomial.polyfromroots(roots)
    rising = plain_sum((0j,), (tuple(complex(c) for c in shape),))
    found = first_crossing(rising, math.inf)
    slope = abs(exact(rising, roots[0], 1))
    allowed = float(rising.rounding(roots[0]) / slope) + 8 * math.ulp(roots[0])
    assert found.time == pytest.approx(roots[0], abs=allowed)
    falling = np.polynomial.polynomial.polyfromroots(-roots)
    none = plain_sum((0j,), (tuple(complex(-c) for c in falling),))
    assert first_crossing(none, math.inf) == (None, 0.0, (), True)


@pytest.mark.parametrize(
    ("exponents", "polynomials", "window", "time"),
    [
        # a start that rises is reached at once
        ((0j, 1j), ((-1 + 0j,), (1 - 0.5j,)), 1.0, 0.0),
        ((0j, 1j), ((1 + 0j,), (-1 + 0j,)), 1.0, 0.0),
        ((0j,), ((0.25 + 0j,),), 1.0, 0.0),
        # zero throughout, below zero for ever, or within the window alone
        ((1j, -1j), ((0.3 + 0.7j,), (-0.3 + 0.7j,)), 50.0, "never"),
        ((), (), math.inf, "never"),
        ((0j, -0.5 + 3j), ((-1 + 0j,), (1.99j,)), 1e4, "never"),
        ((0j, -0.1 + 1j), ((-2.0 + 0j, -0.1 + 0j, 0j), (1 + 0j, 0j)), 10.0, "never"),
        ((1j,), ((-1 + 0j,),), 1.0, None),
    ],
)
def test_a_crossing_is_at_once_or_never(exponents, polynomials, window, time):
    found = first_crossing(plain_sum(exponents, polynomials), window)
    assert found.time == (None if time == "never" else time)
    assert time == 0.0 or found.never == (time == "never")


def test_windows_and_overflow():
    wave = plain_sum((0j, 2j), ((-1.0 + 0j,), (0.9 + 0j,)))
    with pytest.raises(InputError):
        first_crossing(wave, math.inf)
    with pytest.raises(InputError):
        first_crossing(wave, -1.0)
    at = math.pi / 4
    half = plain_sum((2j,), ((-1 + 0j,),))
    assert first_crossing(half, at * 0.999).time is None
    assert first_crossing(half, at * 1.001).time == pytest.approx(at, rel=1e-15)
    with pytest.raises(OverflowError):
        first_crossing(plain_sum((1 + 0j,), ((-1 + 0j,),)), 1e4)


@pytest.mark.parametrize("frequency", [0.0, 2.0])
@pytest.mark.parametrize("at", [1.0, 0.83, 7.3])
def test_what_rises_beyond_its_errors_crosses_however_little(frequency, at):
    """Two zeros next to each other: a parabola's, and those beside the top of a cosine."""
    crossed = 0
    for exponent in range(20, 56):
        peak = 2.0**-exponent
        if frequency:
            turned = complex(math.cos(frequency * at), -math.sin(frequency * at))
            function = plain_sum((0j, frequency * 1j), ((complex(peak - 1),), (turned,)))
        else:
            function = plain_sum((0j,), ((complex(peak - at * at), complex(2 * at), -1 + 0j),))
        window = at + 0.5
        error, top = function.jet(at)[3], float(exact(function, at))
        found = first_crossing(function, window)
        if top > 4 * error:
            crossed += 1
            assert not found.touched
            assert abs(float(exact(function, found.time))) <= 2 * error
            assert found.time <= at
        elif top < -error:
            assert found.time is None
    assert crossed > 15

"""Exact values: no digit lost on the way in, none invented on the way out."""

import math
import pickle
import warnings
from decimal import Decimal
from fractions import Fraction

import mpmath
import numpy as np
import pytest
import sympy as sp
from flint import arb, ctx
from hypothesis import given
from hypothesis import strategies as st

from nonsmooth import InputError
from nonsmooth.runtime.core.values import (
    as_value,
    decimal_string,
    parse,
)

finite = st.floats(allow_nan=False, allow_infinity=False)

EXPRESSIONS = {
    "pi": lambda: +mpmath.pi,
    "2*pi": lambda: 2 * mpmath.pi,
    "-pi/7": lambda: -mpmath.pi / 7,
    "sqrt(2)": lambda: mpmath.sqrt(2),
    "sqrt(0.2)": lambda: mpmath.sqrt(mpmath.mpf(1) / 5),
    "sin(1/3)": lambda: mpmath.sin(mpmath.mpf(1) / 3),
    "cos(1e6)": lambda: mpmath.cos(10**6),
    "exp(-1/2)": lambda: mpmath.exp(-mpmath.mpf(1) / 2),
    "log(1.5)": lambda: mpmath.log(mpmath.mpf(3) / 2),
    "2**0.5": lambda: mpmath.sqrt(2),
    "2**-(1/3)": lambda: 1 / mpmath.cbrt(2),
    "pi**pi": lambda: mpmath.pi**mpmath.pi,
    "(-sqrt(2))**3": lambda: -2 * mpmath.sqrt(2),
    "sqrt(2)**2 - 2 + 1/3": lambda: mpmath.mpf(1) / 3,
    "exp(log(7)) / sin(pi/5)": lambda: 7 / mpmath.sin(mpmath.pi / 5),
    "(sqrt(10**40 + 1) - 10**20) * 3": lambda: (mpmath.sqrt(10**40 + 1) - 10**20) * 3,
}

EXACT = {
    "0.1": Fraction(1, 10),
    ".5": Fraction(1, 2),
    "5.": Fraction(5),
    "1e-3": Fraction(1, 1000),
    "1E+3": Fraction(1000),
    "0.48310000000000000000000000000000000000001": Fraction(
        48310000000000000000000000000000000000001, 10**41
    ),
    "1/3": Fraction(1, 3),
    "1/3 + 1/6": Fraction(1, 2),
    "-2**2": Fraction(-4),
    "2**-2": Fraction(1, 4),
    "2**3**2": Fraction(512),
    "- - +3": Fraction(3),
    " ( 1 -\t0.9 ) * 10 ": Fraction(1),
    "1e400/1e399": Fraction(10),
    "0**0": Fraction(1),
    "7 - 3 - 2": Fraction(2),
    "1e-999": Fraction(1, 10**999),
}

REFUSED = {
    "": "invalid syntax",
    "   ": "invalid syntax",
    "0.5x": "invalid syntax",
    "1 2": "invalid syntax",
    "1 +": "invalid syntax",
    "(1": "never closed",
    "1)": "unmatched",
    "1 (2)": "'1 ( 2 )' is not allowed",
    "()": "is not allowed",
    "1,2": "unexpected ','",
    "1_000": "invalid syntax",
    "0x10": "invalid syntax",
    "1j": "invalid syntax",
    "01": "leading zeros",
    "2^3": "unexpected '^'; powers are written **",
    "7 // 2": "invalid syntax",
    "7 % 2": "unexpected '%'",
    "1 < 2": "unexpected '<'",
    "x := 1": "unexpected ':'",
    "'1'": 'unexpected "\'"',
    "[1]": "unexpected '['",
    "\u0661": "unexpected '\u0661'",
    "\u03c0": "unexpected '\u03c0'",
    "1\x00": "unexpected '\\x00'",
    "True": "'True' is not allowed",
    "None": "'None' is not allowed",
    "not 1": "is not allowed",
    "1 and 2": "is not allowed",
    "1 if 1 else 2": "is not allowed",
    "lambda": "invalid syntax",
    "sin": "'sin' is not allowed",
    "sin()": "is not allowed",
    "sin(*(1))": "is not allowed",
    "sin(**(1))": "is not allowed",
    "pi(2)": "is not allowed",
    "sqr(2)": "unknown name 'sqr'; did you mean 'sqrt'? known: pi, sqrt, sin, cos, exp, log, asin",
    "tan(1)": "unknown name 'tan'",
    "eta": "unknown name 'eta'",
    "e": "unknown name 'e'",
    "__import__(1)": "unknown name '__import__'",
    "nan": "not finite",
    "NaN": "not finite",
    "inf": "not finite",
    "-Infinity": "not finite",
    "1/0": "division by zero",
    "0**-1": "division by zero",
    "1/(0.1 + 0.2 - 0.3)": "division by zero",
    "pi/0": "no finite real value",
    "1/(sqrt(2)**2 - 2)": "no finite real value",
    "sqrt(-1)": "no finite real value",
    "(-8)**(1/3)": "no finite real value",
    "log(0)": "no finite real value",
    "log(-1)": "no finite real value",
    "1e999": "too large for a double",
    "-1e999": "too large for a double",
    "exp(1000)": "too large for a double",
    "exp(1e30)": "too large for a double",
    "1e10001": "exponent beyond 10000",
    "1e-99999999999": "exponent beyond 10000",
    "2**10001": "exponent beyond 10000",
    "9**9**9": "exponent beyond 10000",
    "(9**9999)**9999": "an intermediate result is too large",
    "*".join(["9**9999"] * 100): "an intermediate result is too large",
    "(" * 450 + "1" + ")" * 450: "too many nested parentheses",
    "-" * 999 + "1": "nested too deeply",
    "+".join("1" * 200): "nested too deeply",
    "1" * 1001: "longer than 1000 characters",
}


@pytest.mark.parametrize(("text", "expected"), EXACT.items())
def test_rational_text_is_exact(text, expected):
    value = parse(text)
    assert value.exact == expected
    assert float(value) == float(expected)
    assert value.text == str(value) == text.strip()


@pytest.mark.parametrize(("text", "oracle"), EXPRESSIONS.items())
@pytest.mark.parametrize("digits", [15, 60, 400])
def test_expressions_agree_with_mpmath(text, oracle, digits):
    value = parse(text)
    with mpmath.workdps(digits + 60):
        expected = oracle()
        assert abs(value.mpf(digits) - expected) <= abs(expected) * mpmath.mpf(10) ** -digits
        # Correct rounding: no double is nearer.
        double = float(value)
        error = abs(mpmath.mpf(double) - expected)
        for neighbour in (math.nextafter(double, -math.inf), math.nextafter(double, math.inf)):
            assert error <= abs(mpmath.mpf(neighbour) - expected)


@pytest.mark.parametrize("text", [*EXPRESSIONS, *EXACT])
def test_balls_of_every_precision_enclose_the_value(text):
    value = parse(text)
    with ctx.workprec(2000):
        for bits in (2, 53, 200, 1000):
            assert value.ball(bits).overlaps(value.ball(2000))
    assert ctx.prec == 53


@pytest.mark.parametrize(("text", "fragment"), REFUSED.items())
def test_bad_text_is_refused_in_one_line(text, fragment):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        with pytest.raises(InputError) as caught:
            parse(text)
    message = str(caught.value)
    assert fragment in message
    assert message.startswith(repr(text)) or len(text) > 60
    assert "is not a number or expression: " in message
    assert "\n" not in message
    assert len(message) < 250
    assert isinstance(caught.value, ValueError)
    assert ctx.prec == 53


# `st.text` without an alphabet would make tables of all characters in each process: 200 MB
@given(
    st.binary(max_size=80).map(lambda drawn: drawn.decode("utf-16", "ignore"))
    | st.text("0123456789.eE+-*/() pisnqrt", max_size=40)
)
def test_any_text_gives_a_value_or_an_input_error(text):
    try:
        value = parse(text)
    except InputError:
        return
    assert math.isfinite(float(value))


@given(finite)
def test_floats_mean_their_shortest_decimal(number):
    value = as_value(number)
    assert value.exact == Fraction(repr(number))
    assert float(value) == number
    assert as_value(np.float64(number)) == value
    assert parse(value.text).exact == value.exact


@given(st.floats(width=32, allow_nan=False, allow_infinity=False))
def test_single_precision_means_its_own_shortest_decimal(number):
    assert as_value(np.float32(number)).exact == Fraction(str(np.float32(number)))


@given(
    st.fractions(max_denominator=10**30)
    | st.integers(-(10**300), 10**300)
    | st.decimals(allow_nan=False, allow_infinity=False, min_value=-(10**9), max_value=10**9)
)
def test_exact_numbers_stay_so_and_print_as_they_read(number):
    value, exact = as_value(number), Fraction(number)
    assert value.exact == parse(value.text).exact == exact
    with ctx.workprec(300):
        assert value.ball(300).overlaps(arb(exact.numerator) / arb(exact.denominator))


@given(finite.filter(lambda number: number == 0 or abs(number) > 1e-300))
def test_mpmath_numbers_are_exact(number):
    with mpmath.workdps(80):
        third = mpmath.mpf(number) / 3
        exact = as_value(third).exact
        assert mpmath.mpf(exact.numerator) / exact.denominator == third
    assert as_value(mpmath.mpf(number)).exact == Fraction(number)


def test_numpy_integers_and_values_pass():
    assert as_value(np.int64(-3)).exact == -3
    value = parse("pi/2")
    assert as_value(value) is value
    assert as_value("pi/2") == value
    assert hash(as_value("pi/2")) == hash(value)
    assert pickle.loads(pickle.dumps(value)).mpf(50) == value.mpf(50)


@pytest.mark.parametrize(
    "number",
    [
        True,
        np.True_,
        1j,
        np.complex128(1),
        mpmath.mpc(1, 2),
        arb(1),
        None,
        b"1",
        [1],
        np.ones(3),
        np.array(np.nan),
        float("nan"),
        -math.inf,
        np.float32("nan"),
        np.float64("inf"),
        Decimal("NaN"),
        Decimal("sNaN"),
        Decimal("-Infinity"),
        Decimal("1e999999"),
        Decimal("1e-999999"),
        mpmath.mpf("nan"),
        mpmath.mpf("-inf"),
        mpmath.mpf(10) ** 400,
        10**400,
        10**5000,
        Fraction(1, 10**5000),
    ],
    ids=lambda number: type(number).__name__,
)
def test_what_is_no_finite_real_number_is_refused(number):
    with pytest.raises(InputError) as caught:
        as_value(number)
    assert "\n" not in str(caught.value)
    assert len(str(caught.value)) < 250


def test_a_value_that_is_exactly_zero_in_disguise():
    assert math.copysign(1, parse("sin(pi)")) == math.copysign(1, as_value(-0.0)) == 1
    assert abs(parse("sqrt(2)**2 - 2").mpf(50)) < mpmath.mpf(10) ** -2000


@given(st.floats(-1e9, 1e9))
def test_a_number_of_sympy_with_a_double_in_it_has_the_digits_of_a_double(number):
    symbolic = sp.Float(number) * sp.sqrt(2)
    assert float(as_value(symbolic)) == float(symbolic)


@pytest.mark.parametrize(
    ("number", "digits", "expected"),
    [
        (0.5, 3, "0.500000"),
        (-2.0, 3, "-2.00000"),
        (0.0, 3, "0.00000"),
        (1234567.0, 3, "1234567"),
        (2e-7, 3, "0.000000200000"),
        (1e-8, 3, "1.00000e-8"),
        (1e21, 3, "1.00000e+21"),
        (9.9999999, 2, "10.0000"),
        (arb("0.25"), 3, "0.250000"),
        (mpmath.mpf("-0.75"), 3, "-0.750000"),
    ],
)
def test_decimal_strings(number, digits, expected):
    assert decimal_string(number, digits) == expected


@given(st.fractions(min_value=-(10**24), max_value=10**24), st.integers(1, 120))
def test_printed_digits_keep_their_promise(number, digits):
    limit = Fraction(1, 10**digits) * max(1, abs(number))
    value = as_value(number)
    bits = 4 * digits + 90
    for form in (value.ball(bits), value.mpf(digits + 25)):
        printed = decimal_string(form, digits)
        assert abs(Fraction(printed) - number) <= limit
        mantissa = printed.lstrip("-").partition("e")[0].replace(".", "").lstrip("0")
        assert not number or len(mantissa) >= digits + 3


def test_printing_survives_numbers_far_out_of_range():
    with ctx.workprec(100):
        printed = decimal_string(arb(-1_000_000).exp(), 5)
    with mpmath.workdps(40):
        assert mpmath.almosteq(mpmath.mpf(printed), mpmath.exp(-1_000_000), rel_eps=1e-7)


@pytest.mark.parametrize(
    ("number", "fragment"),
    [
        (arb("1 +/- 0.7e-10"), "does not determine 10 digits"),
        (arb("nan"), "not a finite number"),
        (arb("inf"), "not a finite number"),
        (math.nan, "not a finite number"),
        (math.inf, "not a finite number"),
        (mpmath.mpf("inf"), "not a finite number"),
        (mpmath.mpf("nan"), "not a finite number"),
    ],
)
def test_what_has_no_digits_is_not_printed(number, fragment):
    with pytest.raises(InputError, match=fragment):
        decimal_string(number, 10)

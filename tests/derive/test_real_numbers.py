"""Irrational numbers of a declaration: what they are exactly, or why they are refused."""

import mpmath
import pytest
import sympy as sp

from nonsmooth.derive import Boundary, DeclarationError
from nonsmooth.derive.declaration.real_numbers import number_text
from nonsmooth.runtime.core.values import parse

X, Y = sp.symbols("x y")
IMAGINARY, PI, HALF = sp.I, sp.pi, sp.Rational(1, 2)
CUBIC = sp.solve(X**3 - 3 * X + 1, X)[2]  # real, and written with the imaginary unit


def declared(expression):
    """The expression as a declaration has it."""
    return Boundary("somewhere", expression).function


@pytest.mark.parametrize(
    "number",
    [
        sp.sqrt(2) * PI, sp.GoldenRatio, sp.E, sp.exp(-sp.sqrt(2)), sp.cbrt(2), sp.cos(PI / 7),
        sp.tan(PI / 7), sp.sinh(1), sp.cot(1), sp.asinh(1), sp.atan(HALF), 2 ** sp.Rational(-2, 3),
        (1 + sp.sqrt(2)) ** sp.Rational(3, 2), 1 - PI / 3, PI**-2, PI ** sp.sqrt(2), sp.log(2),
        sp.CRootOf(X**5 - X - 1, 0), sp.CRootOf(X**3 - 3 * X + 1, 1), CUBIC,
        sp.exp(PI * sp.sqrt(163)) - 262537412640768744, sp.Max(sp.sqrt(2), 1), sp.Abs(1 - PI),
        sp.exp(IMAGINARY * PI / 5) + sp.exp(-IMAGINARY * PI / 5),
    ],
)  # fmt: skip
def test_the_text_of_a_number_has_its_digits(number):
    wanted, _ = sp.N(number, 60).as_real_imag()
    value = parse(number_text(declared(number)))
    shown = sp.Rational(mpmath.nstr(value.mpf(60), 58))
    assert abs(shown / sp.Rational(str(wanted)) - 1) < sp.Rational(10) ** -40


@pytest.mark.parametrize(
    ("number", "value"),
    [
        (sp.sqrt(2) * sp.sqrt(8) - 4, 0), (sp.sqrt(3 + 2 * sp.sqrt(2)) - 1 - sp.sqrt(2), 0),
        (sp.cos(PI / 7) - sp.cos(2 * PI / 7) + sp.cos(3 * PI / 7), HALF),
        (sp.sqrt(2) * (sp.sqrt(2) - 1) + sp.sqrt(2), 2), (sp.sin(1) ** 2 + sp.cos(1) ** 2, 1),
        (4 * sp.cos(PI / 5) ** 2 - 2 * sp.cos(PI / 5), 1),
    ],
)  # fmt: skip
def test_a_rational_number_is_written_as_one(number, value):
    assert declared(number) == value
    assert declared(number * X + Y) == value * X + Y


@pytest.mark.parametrize(
    "number",
    [
        IMAGINARY, sp.sqrt(2) * IMAGINARY, sp.sqrt(1 - sp.sqrt(2)), sp.root(-8, 3), sp.zeta(3),
        sp.Catalan, sp.CRootOf(X**4 - X - 1, 2), sp.asin(2), sp.exp(sp.exp(9)), 1 + IMAGINARY,
        sp.sin(sp.sqrt(2)) ** 2 / 2 + sp.cos(2 * sp.sqrt(2)) / 4 - sp.Rational(1, 4) + IMAGINARY,
    ],
)  # fmt: skip
def test_what_is_no_real_number_is_refused_in_one_line(number):
    for expression in (number, number * X):
        with pytest.raises(DeclarationError) as refused:
            declared(expression)
        assert "\n" not in str(refused.value)

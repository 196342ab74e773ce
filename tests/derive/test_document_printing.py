"""Any expression, printed and read back from LaTeX and from MathML, is the expression."""

import math

import numpy as np
import pytest
import sympy as sp
from hypothesis import example, given, settings
from hypothesis import strategies as st

from nonsmooth.derive.document.printer import Printer
from nonsmooth.derive.symbols import Symbol, derivative
from tests.formulas.latex import read_latex
from tests.formulas.layout import Unreadable
from tests.formulas.pages import read_page
from tests.formulas.values import Reading, name_of

pytest.importorskip("latex2mathml")

STATES = sp.symbols("x1 x2 v1 v2", real=True)
CONSTANTS = sp.symbols("a k1 us2 chi e omega1 omega2 p1 p2", positive=True)
TIMES = sp.symbols("tau tau1 t", real=True)
BEHIND = Symbol("state", STATES[0], 3)
CHAIN = (
    BEHIND,
    Symbol("reset", STATES[3], 3),
    derivative(BEHIND, TIMES[0]),
    Symbol("sine", TIMES[0]),
    *(Symbol("divisor", state) for state in STATES[:2]),
    *(Symbol("coefficient", place) for place in ("12", "1_12")),
    *(Symbol("without", Symbol("coefficient", "12"), place) for place in (1, 2)),
    sp.Symbol("stiffness", real=True),
)
COSINE, SINE, SQUARE = (Symbol("function", n) for n in ("cos_tau1", "sin_omega1_tau", "pow_t"))
HALF = Symbol("half", TIMES[0])
FUNCTIONS = {
    COSINE: sp.cos(TIMES[1]),
    SINE: sp.sin(CONSTANTS[5] * TIMES[0]),
    HALF: TIMES[0] / 2,
    SQUARE: TIMES[2] ** 2,
}
NOTATION = Printer(STATES, CONSTANTS, FUNCTIONS, unknowns=TIMES)
LETTERS = (*STATES, *CONSTANTS, *TIMES, *CHAIN, *FUNCTIONS)
VALUES = {s: sp.Float(0.31 + 0.031 * i, 30) for i, s in enumerate(s for s in LETTERS)}
VALUES |= {s: f.xreplace(VALUES) for s, f in FUNCTIONS.items()}
READING = Reading(
    {name_of(NOTATION.symbol(s)): float(v) for s, v in VALUES.items() if s not in FUNCTIONS}
    | {name_of(r"\theta_{\tau}"): math.asin(VALUES[CHAIN[3]]), name_of(r"\mathrm{e}"): math.e}
    | {name_of(r"\pi"): math.pi}
)


def _unevaluated(parts):
    """A number in front of a sum, as the factoring of terms leaves it."""
    return sp.Mul(*parts, evaluate=False)


NUMBERS = st.one_of(
    st.integers(-3, 3).map(sp.Integer),
    st.fractions(-3, 3, max_denominator=4).map(lambda q: sp.Rational(q.numerator, q.denominator)),
    st.sampled_from([sp.sqrt(2), sp.sqrt(3) / 2, sp.pi]),
)
ATOMS = st.one_of(st.sampled_from(LETTERS), st.sampled_from(LETTERS), NUMBERS)


def _larger(inner):
    several = st.lists(inner, min_size=2, max_size=4)
    return st.one_of(
        several.map(lambda parts: sp.Add(*parts)),
        several.map(lambda parts: sp.Mul(*parts)),
        st.tuples(NUMBERS, several.map(lambda parts: sp.Add(*parts))).map(_unevaluated),
        st.tuples(inner, st.integers(-3, 3)).map(lambda p: (1 + p[0] ** 2) ** p[1]),
        st.tuples(inner, st.integers(1, 3)).map(lambda p: p[0] ** p[1]),
        st.tuples(inner, inner).map(lambda p: p[0] / (2 + p[1] ** 2)),
        st.tuples(inner, st.sampled_from(["1/2", "-1/2", "-3/2", "1/3", "5/2"])).map(
            lambda p: (sp.Rational(1, 3) + p[0] ** 2) ** sp.Rational(p[1])
        ),
        inner.map(sp.cos),
        inner.map(sp.sin),
        inner.map(lambda e: sp.exp(-e / 2)),
        inner.map(lambda e: sp.cosh(e / 3)),
        inner.map(lambda e: 3 ** (e / 4)),
    )


EXPRESSIONS = st.recursive(ATOMS, _larger, max_leaves=9)


def value_of(expression):
    return complex(sp.sympify(expression).xreplace(VALUES).xreplace(VALUES))


def is_tame(expression):
    """Whether rounding leaves its value alone: no pole, no sine of something large."""
    return all(abs(value_of(e)) < 50 for e in sp.preorder_traversal(expression))


def check(latex, *expressions):
    """LaTeX and MathML stand for the same, and that are the expressions."""
    row, expected = read_latex(latex), [*map(value_of, expressions)]
    assert read_page(latex) == row, latex
    assert np.ravel(READING(row)) == pytest.approx(expected, rel=1e-9, abs=1e-9), latex


def test_every_symbol_has_a_name_of_its_own():
    assert len({NOTATION.symbol(letter) for letter in LETTERS}) == len(LETTERS)


@pytest.mark.slow
@settings(max_examples=30)
@example(sp.sin(STATES[0] * sp.cos(1)))
@given(EXPRESSIONS)
def test_what_is_printed_is_the_expression(expression):
    """Alone, cut into pieces, as a term and as a factor."""
    if not is_tame(expression):
        return
    check(NOTATION.latex(expression), expression)
    check(" ".join(NOTATION.pieces(expression)), expression)
    sign, text = NOTATION.term(expression)
    check(f"a {'-' if sign < 0 else '+'} {text}", CONSTANTS[0] + expression)
    sign, text = NOTATION.factor(expression)
    minus = "-" if sign < 0 else ""
    check(rf"{minus} {text} \operatorname{{tr}} x_{{1}}", expression * STATES[0])


@pytest.mark.slow
@settings(max_examples=20)
@given(st.lists(st.tuples(NUMBERS, st.lists(st.sampled_from(LETTERS), max_size=4)), max_size=5))
def test_a_polynomial_that_is_put_in_order_is_the_polynomial(
    terms,
):
    expression = sp.Add(*(number * sp.Mul(*factors) for number, factors in terms))
    if len(expression.free_symbols & set(STATES)) < 2:
        check(NOTATION.latex(NOTATION.tidy(expression)), expression)
    arranged = NOTATION.by_function(expression)
    check(" ".join(NOTATION.signed(arranged)) or "0", expression)


@pytest.mark.slow
@settings(max_examples=8)
@given(st.lists(EXPRESSIONS, min_size=4, max_size=4))
def test_a_matrix_is_its_entries(entries):
    if all(map(is_tame, entries)):
        check(NOTATION.latex(sp.Matrix(2, 2, entries)), *entries)


@pytest.mark.parametrize(
    "latex",
    [
        "a + - x_{1}",
        "x_{1} 2",
        "a/k_{1} x_{1}",
        "a(x_{1})",
        r"\left(a + x_{1}",
        r"x_{1}^{2}^{3}",
        r"\cos\left(a\right)^{2}",
        "x_{3}",
        "a +",
    ],
)
def test_what_can_be_read_in_two_ways_is_refused(latex):
    with pytest.raises(Unreadable):
        READING.latex(latex)


def test_braces_hold_nothing_together():
    values = READING.names
    assert READING.latex("{a + x_{1}} k_{1}") == values["a"] + values["x_{1}"] * values["k_{1}"]

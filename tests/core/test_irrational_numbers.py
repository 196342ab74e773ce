"""Relations among irrational numbers: what they show to be zero is zero, and nothing else."""

import pytest
from flint import arb, ctx, fmpq

from nonsmooth.runtime.core.irrational_numbers import irrationals
from nonsmooth.runtime.core.values import parse

BITS = 256
TEXTS = (
    "pi", "sqrt(2)", "sqrt(8)", "sqrt(6)/sqrt(3)", "2**(1/3)", "4**(2/3)", "sqrt(5)/4+1/4",
    "cos(pi/7)", "cos(2*pi/7)", "sin(pi/7)", "exp(2)", "exp(1/2)", "exp(-1)", "log(12)", "log(2)",
    "log(3)", "sqrt(1+sqrt(2))", "(1+sqrt(2))**(-3/2)", "root(0,1,0,0,0,-1,-1)", "atan(1/2)",
    "(1+pi)**3", "sqrt(pi)", "sqrt(1000000007000000049000003)", "0.5*pi", "2**sqrt(3)",
    "1/(1-sqrt(2))", "sqrt(0.02)", "-pi**2", "sqrt(3+2*sqrt(2))", "exp(sqrt(2))", "1.5e2*sqrt(2)",
)  # fmt: skip


@pytest.fixture(scope="module")
def known():
    return irrationals(["p"], TEXTS, lambda text: parse(text).ball(BITS))


def test_every_number_is_what_its_text_says(known):
    with ctx.workprec(BITS):
        values = [arb(1), *(parse(text).ball(BITS) for text in known.generators)]
        for text in TEXTS:
            number = known.numbers[text]
            found = number(values) if callable(number) else arb(number)
            assert abs(found - parse(text).ball(BITS)) < arb(2) ** -200, text


def test_what_is_related_is_zero_and_what_is_not_is_not(known):
    number, p = known.numbers, known.variables[0]
    sine, cosine, twice = (number[text] for text in ("sin(pi/7)", "cos(pi/7)", "cos(2*pi/7)"))
    root, inner = number["root(0,1,0,0,0,-1,-1)"], 1 + number["sqrt(2)"]
    zeros = [
        number["sqrt(2)"] * number["sqrt(8)"] - 4,
        number["sqrt(6)/sqrt(3)"] - number["sqrt(2)"],
        number["2**(1/3)"] ** 4 - number["4**(2/3)"],
        sine**2 + cosine**2 - 1,
        2 * cosine**2 - 1 - twice,
        8 * cosine**3 - 4 * cosine**2 - 4 * cosine + 1,
        4 * number["sqrt(5)/4+1/4"] ** 2 - 2 * number["sqrt(5)/4+1/4"] - 1,
        number["exp(1/2)"] ** 4 - number["exp(2)"],
        number["exp(-1)"] * number["exp(1/2)"] ** 2 - 1,
        number["log(12)"] - 2 * number["log(2)"] - number["log(3)"],
        root**5 - root - 1,
        number["1/(1-sqrt(2))"] + inner,
        number["(1+sqrt(2))**(-3/2)"] ** 2 * inner**3 - 1,
        number["sqrt(pi)"] ** 2 - number["pi"],
        10 * number["sqrt(0.02)"] - number["sqrt(2)"],
        (p * number["sqrt(2)"]) ** 2 - 2 * p**2,
    ]
    assert not any(zeros)
    other = [number["sqrt(2)"] - fmpq(7, 5), sine - twice, number["pi"] ** 2 - 10, p - root]
    assert all(other)
    assert number["1/(1-sqrt(2))"] == -inner != inner


def test_nothing_is_divided_by_what_may_be_zero(known):
    number = known.numbers
    nothing = number["sqrt(3+2*sqrt(2))"] - 1 - number["sqrt(2)"]  # zero, by no known relation
    assert nothing
    for divisor in (nothing, number["sqrt(2)"] ** 2 - 2):
        with pytest.raises(ZeroDivisionError):
            1 / divisor
    with pytest.raises(ArithmeticError):
        irrationals((), ["pi*1e-9999"], lambda text: parse(text).ball(BITS))


def test_a_relation_that_does_not_hold_is_noticed():
    with pytest.raises(ArithmeticError, match="is not zero"):
        irrationals((), ["sqrt(2)"], lambda text: parse("sqrt(3)").ball(BITS))

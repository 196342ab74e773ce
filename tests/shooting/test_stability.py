"""Verdicts on stability: multipliers in their order, and margins within their errors."""

from functools import cache

import numpy as np
import pytest
from numpy.testing import assert_allclose

from nonsmooth import refine, solve

RIGID = "rigid-stop/one-impact"
# a parameter of which the margin becomes zero, where the trace is what is told
BORDERS = {"dry-friction/global-stick": ("chi", "0.6485", -1), RIGID: ("T", "6.82", 3)}


@cache
def border(name):
    """The parameter's value to 690 digits."""
    parameter, text, trace = BORDERS[name]
    for _ in range(12):
        found = refine(solve(name, {parameter: text}), 700)
        step = (found.trace - trace) / found.derivatives(parameter).trace[0]
        text = found.arithmetic.mp.nstr(found.values[parameter] - step, 690)
    assert float(text) == pytest.approx(float(BORDERS[name][1]), rel=1e-2)
    return text


@pytest.mark.parametrize("name", BORDERS)
@pytest.mark.parametrize(("shift", "few", "enough"), [("1e-30", 16, 40), ("1e-462", 450, 550)])
def test_a_margin_within_its_error_is_undecided_until_there_are_digits(name, shift, few, enough):
    verdicts = []
    for sign in "+-":
        orbit = solve(name, {BORDERS[name][0]: f"{border(name)} {sign} {shift}"})
        assert orbit.stability.verdict == "undecided"
        assert refine(orbit, few).stability.verdict == "undecided"
        verdicts.append(refine(orbit, enough).stability.verdict)
    assert verdicts == ["unstable", "neutral" if name == RIGID else "stable"]


def test_undecided_is_said_within_the_error_alone():
    for exponent in range(2, 16):
        for sign, right in (("+", "unstable"), ("-", "neutral")):
            found = solve(RIGID, {"T": f"{border(RIGID)} {sign} 1e-{exponent}"})
            verdict = found.stability.verdict
            within = abs(2 - abs(found.trace - 1)) <= 10.0 ** (2 - found.digits)
            assert verdict == ("undecided" if within else right)
            assert not within or exponent > 9


@pytest.mark.parametrize(
    "name",
    [
        "rigid-stop/one-impact",
        "elastic-stop/one-contact",
        "dry-friction/symmetric",
        "dry-friction/global-stick",
    ],
)
@pytest.mark.parametrize("digits", [None, 30])
def test_multipliers_come_by_decreasing_size(name, digits):
    """The first is as large as the spectral radius; zeros, and a 1 that is trivial, come last."""
    orbit = solve(name)
    jacobian = np.array(orbit.evaluate("poincare_jacobian"), dtype=float)
    found = (orbit if digits is None else refine(orbit, digits)).stability
    values = np.array([complex(float(m.real), float(m.imaginary)) for m in found.multipliers])
    sizes = np.abs(values)
    assert (np.diff(sizes) <= 1e-9).all()
    assert_allclose(sizes[0], np.abs(np.linalg.eigvals(jacobian)).max(), rtol=1e-7)
    assert (sizes[found.rank :] == 0).all()
    assert (sizes[: found.rank] > 0).all()
    assert [m.trivial for m in found.multipliers] == sorted(m.trivial for m in found.multipliers)

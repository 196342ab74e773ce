"""Taylor models contain what they enclose; rational functions obey the laws of a field."""

from itertools import pairwise

import numpy as np
import pytest
from flint import arb, arb_mat, fmpq

from nonsmooth.runtime.checker.stated.exact import Elimination, product, reduced
from nonsmooth.runtime.core import taylor_models
from nonsmooth.runtime.core.rational_functions import symbols
from nonsmooth.runtime.core.taylor_models import TaylorModel, matrix, range_of, space_of
from nonsmooth.runtime.core.values import flint_precision

SPACES = [(1, 1), (1, 4), (2, 1), (2, 3), (3, 2)]


def random_number(rng, variables, order, size):
    space = space_of(variables, order)
    parts = [arb(float(rng.normal())) * size ** sum(e) for e in space.exponents]
    return TaylorModel(space, tuple(parts))


def random_matrix(rng, variables, order, size):
    entries = [
        [random_number(rng, variables, order, 0.05) for _ in range(size)] for _ in range(size)
    ]
    return matrix(entries)


def points(rng, variables):
    inside = rng.uniform(-1, 1, (6, variables))
    corners = rng.choice([-1.0, 1.0], (3, variables))
    return [[arb(float(x)) for x in point] for point in (*inside, *corners)]


def overlap(left, right):
    """Whether balls that are to contain the same numbers do not exclude it."""
    if isinstance(left, arb):
        return bool(left.overlaps(right))
    return all(x.overlaps(y) for x, y in zip(left.entries(), right.entries(), strict=True))


@pytest.mark.parametrize(("variables", "order"), SPACES)
def test_models_of_functions_contain_them_everywhere(variables, order):
    rng = np.random.default_rng(10 * variables + order)
    with flint_precision(64):
        for _ in range(5):
            x, y = (random_number(rng, variables, order, 0.1) for _ in range(2))
            a, b = (random_matrix(rng, variables, order, 3) for _ in range(2))
            nonzero = x - x.at([arb(0)] * variables) + 3
            for p in points(rng, variables):
                xp, yp, ap, bp, np_ = x.at(p), y.at(p), a.at(p), b.at(p), nonzero.at(p)
                assert overlap((x * y - x).at(p), xp * yp - xp)
                assert overlap((2 - y / nonzero).at(p), 2 - yp / np_)
                assert overlap((1 / nonzero + x**3).at(p), 1 / np_ + xp**3)
                assert overlap((a * b + a * x).at(p), ap * bp + ap * xp)
                assert overlap(a.exp().at(p), ap.exp())
                assert overlap((a * 9).exp().at(p), (ap * 9).exp())
                sine, cosine = (x * 3).sin_cos()
                assert overlap(sine.at(p), (xp * 3).sin())
                assert overlap(cosine.at(p), (xp * 3).cos())
                assert x.range().contains(xp)
                assert overlap(matrix([[x, 1], [y, x]]).at(p), arb_mat([[xp, 1], [yp, xp]]))


def test_what_is_cut_off_stays_in_the_radius():
    # no quadratic polynomial is nearer to 2/(2 - e) than 2 (2 - sqrt 3)^2/3 (Chebyshev)
    with flint_precision(64):
        space = space_of(1, 2)
        e = space.variable(0, arb(0), arb(1))
        found = 1 / (1 - e / 2)
        assert found.rad() > 2 * (2 - 3**0.5) ** 2 / 3
        for value in (-1.0, -0.3, 0.0, 0.7, 1.0):
            assert found.at([arb(value)]).contains(1 / (1 - arb(value) / 2))
        square = (e * e).range()
        assert square.contains(arb(0))
        assert square.contains(arb(1))
        assert float(square.lower()) > -1e-8  # even powers are not negative


def test_higher_orders_are_sharper():
    rng = np.random.default_rng(1)
    base = rng.normal(size=(3, 3))
    slope = rng.normal(size=(3, 3))
    radii = []
    with flint_precision(64):
        for order in (1, 2, 3, 4):
            space = space_of(1, order)
            e = space.variable(0, arb(0), arb(1) / 20)
            found = (space.constant(arb_mat(base.tolist())) + arb_mat(slope.tolist()) * e).exp()
            radii.append(max(float(x.rad()) for x in found.parts[0].entries()))
    assert all(sharp < rough / 5 for rough, sharp in pairwise(radii))


def test_an_interval_that_holds_zero_has_no_reciprocal():
    with flint_precision(64):
        e = space_of(1, 2).variable(0, arb("0.5"), arb(1))
        assert not range_of(1 / e).is_finite()
        huge = space_of(1, 2).constant(arb_mat([[arb("1e30")]]))
        assert not range_of(huge.exp())[0, 0].is_finite()
        assert not (e > 0)
        assert not (e < 0)


V, ETA = symbols(["V", "eta"])


def test_facts_over_rational_functions():
    # x = V y and x + y = eta are known; what follows holds for all V and eta
    zero, one = V - V, V / V
    facts = Elimination().echelon([(one, -V, zero), (one, one, -ETA)])
    assert [[bool(x) for x in row[:2]] for row in facts] == [[True, False], [False, True]]
    assert not any(reduced((one + V, zero, -V * ETA), facts))
    assert any(reduced((one, zero, -V), facts))
    rows = [(V, ETA), (V * V, V * ETA), (fmpq(1), fmpq(0))]
    kernel = Elimination().left_kernel(rows)
    assert len(kernel) == 1
    assert not any(product(kernel[0], [(V, ETA), (V * V, V * ETA), (one, zero)]))


def test_exponentials_of_tiny_matrices_to_many_digits():
    with flint_precision(4000):
        space = space_of(1, 1)
        tiny = space.constant(arb_mat([[arb(0, arb(2) ** -3000)]]))
        assert tiny.exp().range()[0, 0].contains(arb(1))


@pytest.mark.parametrize("exponent", [-17, -24, -40])
def test_an_exponential_holds_what_its_polynomial_leaves_out(exponent):
    """The polynomial of a power of two is a double, nearly: no rounding hides what is left out."""
    small = arb((1, exponent))
    with flint_precision(64):
        found = space_of(1, 1).constant(arb_mat([[small]])).exp().range()[0, 0]
    with flint_precision(400):
        assert found.contains(small.exp())


@pytest.mark.parametrize(
    ("weight", "shares"),
    [
        (taylor_models.AT_BOTH_ENDS, (1, 1, 1)),
        (taylor_models.MEAN, (1, 1 / 2, 1 / 3)),
        (taylor_models.BENT_MEAN, (1 / 3, 1 / 8, 1 / 15)),
    ],
)
def test_averages_are_those_of_polynomials_and_hold_what_is_cut_off(weight, shares):
    """Of e^2 f^2 + 3 f^3 + a ball times f over f = s e: odd powers leave their radius alone."""
    space = space_of(2, 5)
    parts = [None] * len(space.exponents)
    for exponents, part in {
        (0, 0): arb(0, 1e-3), (2, 2): arb(1), (0, 3): arb(3), (0, 1): arb(2, 1e-2)
    }.items():  # fmt: skip
        parts[space.exponents.index(exponents)] = part
    found = taylor_models.averaged(TaylorModel(space, tuple(parts)), weight)
    assert float(found.parts[4]) == pytest.approx(shares[2])
    assert found.parts[0].rad() >= 1e-3 * shares[0] * 0.999
    assert found.parts[1].contains(0)
    assert found.parts[1].rad() >= 1e-2 * shares[1] * 0.999
    assert abs(found.parts[3]) < 1e-12
    still = space_of(1, 5).variable(0, arb(1), arb(2))
    again = taylor_models.averaged(taylor_models.lifted(still, space), weight)
    assert [float(p or 0) for p in again.parts] == pytest.approx(
        [shares[0], 2 * shares[0], *[0] * 4]
    )
    assert float(taylor_models.averaged(arb(3), weight)) == pytest.approx(3 * shares[0])

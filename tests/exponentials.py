"""Roots that are hard for divided differences of the exponential, and their exact values."""

import math

from flint import arb, arb_mat
from hypothesis import strategies as st

from nonsmooth.runtime.core.values import flint_precision

BITS = 300
UNIT = 2.0**-53

_dampings = st.sampled_from(
    [0.0, 0.05, 1.0, 1 - 1e-9, 1 + 1e-9, 1 - 1e-4, 1 + 1e-4, 2.5]
) | st.floats(0.0, 3.0)
_besides = st.sampled_from([0.0, 1e-12, -1e-9, 1e-7, -1e-5, 1e-4, -1e-3]) | st.floats(-0.7, 4.0)
_decimals = st.floats(0.3, 5.0)
periods = st.floats(0.0, 1.0) | st.floats(1.0, 100.0)


@st.composite
def forced(draw):
    """A coordinate, and what drives it: nothing, a load, a drift, a harmonic force, a rate."""
    frequency, damping = draw(_decimals), draw(_dampings)
    stiffness = draw(st.sampled_from([1.0, 1.0, 1.0, 0.0, -1.0])) * frequency**2
    pair = (stiffness, 2 * damping * frequency)
    force = ((frequency * (1 + draw(_besides))) ** 2, 0.0)
    driver = [[], [(0.0,)], [(0.0,), (0.0,)], [force], [(draw(_decimals),)]]
    return [pair, *draw(st.sampled_from(driver))]


@st.composite
def repeated(draw):
    """Derivatives by parameters repeat factors; two coordinates may be nearly equal."""
    pair, *_ = first = draw(forced())
    near = tuple(c * (1 + draw(_besides.filter(lambda x: abs(x) < 1e-2))) for c in pair)
    return [*first, draw(st.sampled_from([pair, near, first[-1]]))]


def largest_root(factors):
    """An upper bound of the roots' moduli, at most twice the largest."""
    return 2 * max(abs(c) ** (1 / (len(f) - j)) for f in factors for j, c in enumerate(f)) or 1.0


def exact(k, t, factors):
    """Ball of 50 digits and more, by the companion matrix of the product."""
    with flint_precision(BITS):
        product = [arb(1)]
        for factor in factors:
            monic = [*map(arb, factor), arb(1)]
            product = [
                sum((product[i - j] * c for j, c in enumerate(monic) if 0 <= i - j < len(product)),
                    arb(0))
                for i in range(len(product) + len(factor))
            ]  # fmt: skip
        degree = len(product) - 1
        rows = [[arb(int(j == i + 1)) for j in range(degree)] for i in range(degree - 1)]
        rows.append([-c for c in product[:-1]])
        flow = (arb_mat(rows) * arb(t)).exp()
        return flow[k, degree - 1]


def error(found, k, t, factors):
    """Error in units of 1e-13 + 8 u max|lambda| t, relative to the largest value up to t."""
    fastest = largest_root(factors)
    times = {t * i / 4 for i in range(1, 5)} | {t - 1.4 * i / fastest for i in range(1, 4)}
    size = max(abs(float(exact(k, s, factors))) for s in times if s >= 0)
    if not math.isfinite(size):
        return 0.0
    missed = abs(float(arb(found) - exact(k, t, factors)))
    return missed / (size or 1.0) / (1e-13 + 4 * UNIT * fastest * t)

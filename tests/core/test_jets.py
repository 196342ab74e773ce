"""Jets: derivatives of what is computed, against mpmath's."""

from typing import Any

import pytest
from flint import arb
from mpmath import mp

from nonsmooth.runtime.core.jets import jet, part_of
from nonsmooth.runtime.core.taylor_models import matrix, range_of, space_of

AT = 0.3


def functions(x: Any) -> list[Any]:
    sine, cosine = x.sin_cos()
    flow = (matrix([[x, 1], [0, x * x]]) * arb(2)).exp()
    return [3 / (2 + sine * cosine), (1 - x) ** 3 / x, *flow.entries()]


def expected(x: Any) -> list[Any]:
    flow = mp.expm(2 * mp.matrix([[x, 1], [0, x * x]]))
    return [3 / (2 + mp.sin(x) * mp.cos(x)), (1 - x) ** 3 / x, *flow]


@pytest.mark.parametrize("place", range(6))
def test_derivatives_are_enclosed_at_a_point_and_over_a_tile(place: int) -> None:
    space = space_of(1, 5)
    over = jet(space.variable(0, arb(AT), arb(0.01)), arb(1), None)
    with mp.workdps(40):
        series = mp.taylor(lambda x: expected(x)[place], mp.mpf(AT), 2)
        beside = mp.taylor(lambda x: expected(x)[place], mp.mpf(AT + 0.009), 2)
    at = functions(jet(arb(AT), arb(1), None))[place]
    tile = functions(over)[place]
    for k in range(3):
        point = part_of(at, k)
        assert abs(float(point.mid()) - float(series[k])) < 1e-12
        assert point.rad() < 1e-12
        assert range_of(part_of(tile, k)).contains(arb(float(series[k])))
        assert range_of(part_of(tile, k)).contains(arb(float(beside[k])))
        assert range_of(part_of(tile, k)).rad() < 0.25 * abs(series[k]) + 0.5


def test_what_is_no_jet_does_not_depend_on_the_parameter() -> None:
    x = jet(arb(2), arb(1))
    space = space_of(1, 3)
    model = space.variable(0, arb(1), arb(0.5))
    for found, slope in ((model * x, 1), (model - x, -1), (model / x, -0.25), (x + 1, 1)):
        told = part_of(found, 1)
        value = told.at([arb(0)]) if hasattr(told, "at") else told
        assert value.contains(slope)
    assert part_of(arb(3), 1) == 0

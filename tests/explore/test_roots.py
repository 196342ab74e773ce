"""Roots of the numbers that are watched along a branch."""

import math

import pytest

from nonsmooth.runtime.explore.continuation.locating import _root


class Counted:
    """A function that counts how often it is asked."""

    def __init__(self, function) -> None:
        self.function, self.calls = function, 0

    def __call__(self, x: float) -> float:
        self.calls += 1
        return self.function(x)


def root(function, low: float, high: float) -> tuple[float | None, int]:
    counted = Counted(function)
    before, after = function(low), function(high)
    rounding = 1e-13 * max(abs(before), abs(after))
    return _root(counted, low, high, before, after, rounding), counted.calls


@pytest.mark.parametrize("size", [1.0, 1e-9, 1e7])
def test_a_simple_root_is_found_to_rounding(size: float) -> None:
    found, calls = root(lambda x: size * (math.exp(x) - 1.3), 0.0, 1.0)
    assert found == pytest.approx(math.log(1.3), rel=1e-13)
    assert calls <= 9


def test_what_rounding_leaves_of_a_zero_is_not_searched() -> None:
    """A number that errs by 1e-14: behind the first values below that nothing is gained."""
    found, calls = root(lambda x: math.exp(x) - 1.3 + 1e-14 * math.sin(1e12 * x), 0.0, 1.0)
    assert found == pytest.approx(math.log(1.3), abs=2e-13)
    assert calls <= 7


def test_a_pole_is_no_root_and_is_left_soon() -> None:
    found, calls = root(lambda x: 1 / (x - 0.3001), 0.0, 1.0)
    assert found is None
    assert calls <= 20


def test_a_number_that_is_not_defined_between_has_no_root() -> None:
    assert root(lambda x: math.nan if 0 < x < 1 else x - 0.5, 0.0, 1.0)[0] is None

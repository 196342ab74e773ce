"""Roots of the numbers that are watched along a branch."""

import math
from unittest.mock import Mock

import pytest

from nonsmooth.runtime.explore.continuation.locating import _root


@pytest.mark.parametrize(
    ("function", "wanted", "most"),
    [
        (lambda x: math.exp(x) - 1.3, math.log(1.3), 9),
        # behind the first values that rounding leaves of a zero nothing is gained
        (lambda x: math.exp(x) - 1.3 + 1e-14 * math.sin(1e12 * x), math.log(1.3), 7),
        (lambda x: 1 / (x - 0.3001), None, 20),
        (lambda x: math.nan if 0 < x < 1 else x - 0.5, None, 1),
    ],
)
def test_a_root_is_where_the_sign_changes_and_no_pole(function, wanted, most):
    ends, counted = (function(0.0), function(1.0)), Mock(side_effect=function)
    found = _root(counted, 0.0, 1.0, *ends, 1e-13 * max(map(abs, ends)))
    assert found == (None if wanted is None else pytest.approx(wanted, abs=2e-13))
    assert counted.call_count <= most

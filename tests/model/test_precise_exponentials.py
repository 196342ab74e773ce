"""Exponentials to their last digit, against mpmath."""

import mpmath
import numpy as np
import pytest

from nonsmooth.runtime.model.modes import precise_modes
from nonsmooth.runtime.model.modes.precise_modes import exponentials_at
from tests.large_systems import chain


@pytest.mark.parametrize(("count", "bits"), [(2, None), (6, None), (3, 60)])
def test_exponentials_are_right_to_the_last_digit(
    count: int, bits: int | None, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Also where the first precision is not enough: it is told, and more is taken."""
    if bits is not None:
        monkeypatch.setattr(precise_modes, "_FEW_BITS", bits)
    field = chain(count).fields[0]
    matrix = np.vstack([field, np.zeros(field.shape[1])])
    found = exponentials_at(matrix, [4.0, 2.0**-11, 0.5])
    assert sorted(found) == [2.0**-11, 0.5, 4.0]
    with mpmath.workdps(90):
        for time, rounded in found.items():
            exact = mpmath.expm(mpmath.matrix((matrix * time).tolist()), method="taylor")
            expected = np.array([float(x) for x in exact]).reshape(matrix.shape)
            np.testing.assert_array_equal(rounded, expected)

"""Exponentials of many matrices: each is by itself what SciPy finds."""

import numpy as np
import pytest
from scipy.linalg import expm

from nonsmooth.runtime.core.exponentials.matrices import exponentials


@pytest.mark.parametrize("spoiled", [np.nan, np.inf, 1e7])
def test_a_matrix_that_has_none_spoils_no_other(spoiled):
    random = np.random.default_rng(3)
    matrices = random.standard_normal((5, 4, 4)) * np.array([1e-3, 1, 3, 1, 10])[:, None, None]
    matrices[3, 1, 2] = spoiled
    found = exponentials(matrices)
    assert np.isnan(found).any(axis=(1, 2)).tolist() == [False, False, False, True, False]
    for place in (0, 1, 2, 4):
        wanted = expm(matrices[place])
        assert abs(found[place] - wanted).max() < 1e-13 * abs(wanted).max()

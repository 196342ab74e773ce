"""Intervals of a parameter: ends to the last bit, and resonances by another determinant."""

import numpy as np
import pytest
from scipy.linalg import expm

from nonsmooth import solve
from nonsmooth.runtime.explore.intervals import admissible_intervals, singular_values
from nonsmooth.runtime.model.kernels import backend

RIGID, ELASTIC = "rigid-stop/one-impact", "elastic-stop/one-contact"
STICK, BORDER = "dry-friction/global-stick", "dry-friction/solution-ii"
POINTS = 2000 if backend() == "c" else 200


def halfway(period):
    """Determinant of the velocities halfway, by the start's y and u, at the paper's data."""
    matrix = np.zeros((4, 4))
    matrix[:2, 2:] = np.eye(2)
    matrix[2:, :2] = -np.array([[1.0, -1], [-1, 6]]) / np.array([[1.0], [2]])
    return float(np.linalg.det(expm(matrix * period / 2)[2:, 1:3]))


@pytest.mark.parametrize(
    ("name", "parameter", "lower", "upper"),
    [
        (RIGID, "T", 3, 8),
        (RIGID, "m1", 0.2, 6),
        (ELASTIC, "T", 5, 8),
        (ELASTIC, "k3", 0.1, 50),
        (STICK, "e1", 2, 4),
        (STICK, "eta", 0.3, 2),
        ("dry-friction/symmetric", "V", 0.2, 1.5),
        (BORDER, "V", 0.5, 1.5),
    ],
)
def test_ends_are_where_admissibility_changes(name, parameter, lower, upper):
    found = admissible_intervals(name, parameter, lower, upper, POINTS)
    assert found
    assert [i.lower for i in found] == sorted(i.lower for i in found)
    for interval in found:
        assert interval.lower <= interval.upper
        for end, reason, outward in (
            (interval.lower, interval.below, -np.inf),
            (interval.upper, interval.above, np.inf),
        ):
            beyond = np.nextafter(end, outward)
            inside = solve(name, {parameter: np.array([end, beyond])}).admissible
            assert inside[0]
            if reason:
                assert not inside[1]
                assert lower < end < upper
        middle = (interval.lower + interval.upper) / 2
        assert solve(name, {parameter: middle}).admissibility.verdict is not False
    grid = np.linspace(lower, upper, 301)
    ends = np.array([[i.lower, i.upper] for i in found])
    within = ((grid[:, None] >= ends[:, 0]) & (grid[:, None] <= ends[:, 1])).any(axis=1)
    judged = solve(name, {parameter: grid}).admissible
    # an interval or a gap narrower than the grid of the search is not seen
    assert np.mean(within == judged) > 0.99


def test_ends_have_their_reasons():
    first, second, *_ = admissible_intervals(RIGID, "T", 3, 8, POINTS)
    assert first.below == second.below == "the equations are singular"
    assert "first-reaches-stop is crossed in free" in first.above
    # there the impact has no speed
    assert solve(RIGID, {"T": first.upper}).unknowns["u"] == pytest.approx(0, abs=1e-12)


def test_where_phases_are_too_long_to_be_judged_an_interval_ends():
    """At 1e5 radians of the fastest mode in a phase; beyond nothing is stated."""
    (found,) = admissible_intervals(RIGID, "k2", 1e8, 1e9, 50)
    assert np.sqrt(found.upper) * 2 * np.pi == pytest.approx(1e5 * np.sqrt(2), rel=0.01)
    assert found.above == "the margin is within the rounding"


def test_singular_values_are_the_zeros_of_another_determinant():
    found = singular_values(RIGID, "T", 0.5, 30, POINTS)
    assert len(found) == 12
    for period in found:
        below, above = halfway(period * (1 - 1e-9)), halfway(period * (1 + 1e-9))
        assert below * above < 0
    signs = np.sign([halfway(period) for period in np.linspace(0.5, 30, 2001)])
    assert np.count_nonzero(np.diff(signs)) == len(found)
    stiff = singular_values(RIGID, "k1", 0.2, 20, POINTS)
    assert solve(RIGID, {"k1": list(stiff)}).status.tolist() == [5] * len(stiff)
    assert stiff


def test_the_whole_range_may_be_admissible_or_nothing():
    (whole,) = admissible_intervals(RIGID, "T", 5, 6, 50)
    assert (whole.below, whole.above) == ("", "")
    assert 5 < whole.lower < whole.upper < 6
    assert admissible_intervals(RIGID, "T", 7.5, 9, 50) == ()

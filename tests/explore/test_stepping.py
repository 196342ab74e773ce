"""A path that is interrupted and gone on with is the path that nothing interrupts."""

from __future__ import annotations

import numpy as np
import pytest

from nonsmooth.runtime.explore.continuation.stepping import (
    CLOSED,
    INTERRUPTED,
    Path,
    trace_both_ways,
)


class Circle:
    """x^2 + p^2 = 1: no phases, and no other branch."""

    names = ("x",)
    dwell_names: tuple[str, ...] = ()
    first = np.array([np.cos(2.0), np.sin(2.0)])
    sizes = np.ones(2)

    def equations(self, z: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Its equation and gradient."""
        return np.array([z @ z - 1]), 2 * z[None]

    def dwell(self, z: np.ndarray) -> np.ndarray:
        """None."""
        return np.empty((len(z), 0))

    def leaps(self, z: np.ndarray, following: np.ndarray) -> bool:
        """Never."""
        return False


class Stop:
    """Ctrl-C behind a point."""

    def __init__(self, left: int) -> None:
        self.left = left

    def __call__(self, *_: np.ndarray) -> None:
        """Count a point."""
        self.left -= 1
        if self.left < 0:
            raise KeyboardInterrupt


def turned(points: np.ndarray) -> np.ndarray:
    """Angles from each point to the next one, all in one direction."""
    angles = np.diff(np.unwrap(np.arctan2(points[:, 0], points[:, 1])))
    assert (angles > 0).all() or (angles < 0).all()
    return np.abs(angles)


@pytest.mark.slow
@pytest.mark.parametrize("limits", [(-2.0, 2.0), (-0.5, 2.0)])
def test_a_path_goes_on_to_the_whole_from_every_point(limits: tuple[float, float]) -> None:
    circle, step = Circle(), 0.2
    whole = trace_both_ways(circle, limits, step, 100, Stop(1000))
    length = turned(whole.points).sum()
    closed = limits[0] < -1
    assert (whole.ends == (CLOSED, CLOSED)) == closed
    assert length == pytest.approx(2 * np.pi if closed else 4 * np.pi / 3)
    for left in range(len(whole.points) - 3):
        part = trace_both_ways(circle, limits, step, 100, Stop(left))
        assert INTERRUPTED in part.ends
        again = trace_both_ways(circle, limits, step, 100, Stop(1000), part)
        assert again.ends == whole.ends
        assert turned(again.points).sum() == pytest.approx(length)


@pytest.mark.parametrize("gap", [0.3, 0.1, 0.03, 0.01, 1e-3, 1e-5])
def test_a_path_does_not_pass_its_other_end(gap: float) -> None:
    angles = np.linspace(2.0, 2.0 + 2 * np.pi - gap, 50)
    points = np.column_stack([np.cos(angles), np.sin(angles)])
    tangents = np.column_stack([-np.sin(angles), np.cos(angles)])
    part = Path(points, tangents, (INTERRUPTED, INTERRUPTED), 20)
    again = trace_both_ways(Circle(), (-2.0, 2.0), 0.2, 1000, Stop(1000), part)
    assert again.ends == (CLOSED, CLOSED)
    assert turned(again.points).sum() == pytest.approx(2 * np.pi)


def test_points_count_those_that_are_known() -> None:
    limits, step = (-0.5, 2.0), 0.05
    part = trace_both_ways(Circle(), limits, step, 9, Stop(13))
    assert part.ends == ("9 points", INTERRUPTED)
    again = trace_both_ways(Circle(), limits, step, 9, Stop(1000), part)
    assert (again.ends, again.start, len(again.points)) == (("9 points",) * 2, 9, 19)
    more = trace_both_ways(Circle(), limits, step, 1000, Stop(1000), again)
    assert more.ends == ("end of the interval",) * 2
    np.testing.assert_array_equal(more.points[more.start], again.points[9])

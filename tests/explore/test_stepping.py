"""A branch that is interrupted and gone on with is the branch that nothing interrupts.

A stop at place + d - q^2 closes the branch of the orbits with one impact over q: near its fold
q^2 = d - a (y - y0)^2 is nearly an ellipse.
"""

from functools import cache

import numpy as np
import pytest

import nonsmooth as ns
from tests.explore.test_continuation_forced import R, W, branch, closed_forms, struck_at
from tests.tables import slow

D = 1e-2
CLOSED = ("the branch is closed",) * 2
INTERVALS = {"closed": (-1.0, 1.0), "open": (-0.05, 1.0)}  # of q, which reaches sqrt(D)
STEP = 0.01


@cache
def first():
    """The orbit at q = 0 on one side of the fold."""
    fold, sigma = closed_forms()[0], branch().parameter_values
    near = branch().orbit_at(int(np.argmin(abs(sigma - fold - D))))
    data = {"r": R, "w": W, "place": repr(float(fold)), "q": 0, "d": D}
    system = struck_at("place + d - q**2", "place", "q", "d")
    guess = [*near.dwell_times.tolist(), *near.states[0].tolist()]
    return ns.solve(system, data, guess, itinerary=near.itinerary)


def followed(kind, stop=None, **options):
    """The branch, or what it has when so many points were told."""

    def progress(done, *_):
        if stop is not None and done >= stop:
            raise KeyboardInterrupt

    given = {"step": STEP, "progress": progress, **options}
    try:
        return ns.continue_orbit(first(), "q", INTERVALS[kind], **given)
    except ns.Interrupted as stopped:
        return stopped.partial


@cache
def whole(kind):
    return followed(kind)


@cache
def points_of(step):
    """How many points the closed branch has."""
    return len(followed("closed", step=step))


def turned(found):
    """Angles around the middle of the ellipse from each point to the next, in one direction."""
    across = whole("closed").quantity("v0")
    middle, size = (across.max() + across.min()) / 2, np.ptp(across) / 2
    height = (found.quantity("v0") - middle) / size
    angles = np.diff(np.unwrap(np.arctan2(height, found.parameter_values / np.sqrt(D))))
    assert (angles > 0).all() or (angles < 0).all()
    return np.abs(angles)


@pytest.mark.slow
@pytest.mark.parametrize("kind", INTERVALS)
def test_a_branch_goes_on_to_the_whole_from_every_point(kind):
    known = whole(kind)
    length = turned(known).sum()
    assert (known.ends == CLOSED) == (kind == "closed")
    assert length == pytest.approx(2 * np.pi if kind == "closed" else 4 * np.pi / 3, rel=0.01)
    for stop in range(2, len(known) - 3, 27):
        part = followed(kind, stop)
        assert "interrupted" in part.ends
        again = followed(kind, resume=part)
        assert again.ends == known.ends
        assert turned(again).sum() == pytest.approx(length, rel=1e-6)


@pytest.mark.parametrize(("left", "fine"), [(1, 1e-2), (2, 1e-2), (5, 1e-2), slow(1, 5e-4)])
def test_a_branch_does_not_pass_its_other_end(left, fine):
    """Though its first steps, when it goes on, would be longer than what is left."""
    part = followed("closed", points_of(fine) - 1 - left, step=fine)
    assert "interrupted" in part.ends
    again = followed("closed", step=0.05, resume=part)
    assert again.ends == CLOSED
    assert turned(again).sum() == pytest.approx(2 * np.pi, rel=1e-6)


def test_points_count_those_that_are_known():
    part = followed("open", 8, points=5)
    assert part.ends == ("5 points", "interrupted")
    again = followed("open", points=5, resume=part)
    assert (again.ends, again.start, len(again)) == (("5 points",) * 2, 5, 11)
    more = followed("open", resume=again)
    assert more.ends == ("end of the interval",) * 2
    np.testing.assert_array_equal(more.unknowns[more.start], again.unknowns[5])

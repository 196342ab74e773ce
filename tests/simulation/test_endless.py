"""Motions in which an engine could search for ever: each ends, with one status in both engines."""

import math

import numpy as np
import pytest
import sympy as sp

import nonsmooth as ns
from nonsmooth import simulate
from nonsmooth.derive import RigidStop
from tests.engines import ENGINES, with_both, with_engine
from tests.one_mass import one_mass
from tests.tables import slow


def stopped(
    stiffness,
    damping=0,
    load=0,
    frequency=None,
    at=1,
    amplitude=1,
):
    return one_mass(
        "endless", RigidStop("x", at, sp.Rational(1, 2), name="stop"),
        forces={} if frequency is None else {frequency: amplitude},
        stiffness=stiffness, damping=damping, load=[load],
    )  # fmt: skip


GAP = sp.Rational(1, 10**9)
CASES = {  # the system, the start, until, the status
    "escapes": (stopped(-1), (-1, -0.1), math.inf, "OVERFLOW"),
    "escapes in a given time": (stopped(-1), (-1, -0.1), 712, "OVERFLOW"),
    "is still finite": (stopped(-1), (-1, -0.1), 300, "UNTIL"),
    "escapes from very near": (stopped(-1), (-1e-300, 0), math.inf, "OVERFLOW"),
    "escapes at once": (stopped(-(10**200)), (-1, -0.1), 10, "OVERFLOW"),
    "escapes like t e^t": (stopped(1, -2), (-1e-3, -1), math.inf, "OVERFLOW"),
    "stays where it would escape": (stopped(-1), (0, 0), math.inf, "QUIET"),
    "approaches the stop": (stopped(2, 3, 2), (0, 0), math.inf, "QUIET"),
    "approaches it for a time": (stopped(2, 3, 2), (0, 0), 100, "UNTIL"),
    "approaches it critically": (stopped(1, 2, 1), (0, 0), 100, "UNTIL"),
    "is shaken too fast": (stopped(1, 0, 0, 10**300, GAP), (0, 1), 10, None),
    "is shaken fast": (stopped(1, 0, 0, 10**70, GAP), (0, 1), 10, None),
    "is shaken hard": (stopped(1, 0, 0, 10**70, GAP, 10**140), (0, 1), 10, None),
    "ends never": (stopped(1), (0, 0.1), 1e300, "QUIET"),
}


def followed(system, start, until):
    return ns.simulate(system, {}, dict(zip("xv", start, strict=True)), until=until, transitions=5)


@pytest.mark.compiled
@pytest.mark.parametrize(
    "name",
    [slow(n, when=n == "approaches the stop") for n in CASES],
)
def test_every_motion_ends_and_both_engines_say_how(name):
    system, start, until, status = CASES[name]
    ends = []
    for engine in ENGINES[: 2 if status else 1]:  # what is shaken lasts in Python
        motion = with_engine(engine, followed, system, start, until)
        many = with_engine(
            engine, simulate, system, {}, motion.states[:1], until=until, transitions=5
        )
        assert (many.status == motion.status).all()
        if status is not None:
            assert motion.status.name == status
            assert motion.transitions == 0
        if motion.status.name == "OVERFLOW":
            assert "larger" in motion.message
        ends.append(motion.end)
    assert ends[-1] == pytest.approx(ends[0], rel=1e-12)


@pytest.mark.compiled
def test_random_motions_that_grow_agree_in_both_engines():
    """Negative stiffness, negative damping: impacts first, an escape in the end."""
    generator = np.random.default_rng(3)
    for _ in range(12):
        stiffness, damping = generator.uniform([-2, -1], [2, 0.5])
        start = (-float(generator.uniform(0, 2)), float(generator.normal()))
        system = stopped(sp.Float(stiffness), sp.Float(damping))
        motion, found = with_both(followed, system, start, 1e4)
        assert (found.status, len(found.times)) == (motion.status, len(motion.times))
        np.testing.assert_allclose(found.times, motion.times, rtol=1e-9)

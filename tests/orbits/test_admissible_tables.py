"""Admissibility from a system's tables, at orbits that are met but for rounding."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
import sympy as sp
from numpy.random import default_rng

import nonsmooth as ns
from nonsmooth.derive import Friction, Harmonic, SoftStop, oscillator
from tests.one_mass import one_mass

STIFF = SoftStop("x", at="0.03", stiffness=100_000, damping=500, released="force", name="bump")


@cache
def released():
    """An orbit that leaves a damped stop where its force, of some thousands, vanishes."""
    system = one_mass("released", STIFF, forces={9: 600}, mass=300, stiffness=20_000, damping=800)
    motion = ns.simulate(system, {}, {"x": 0, "v": 0}, until=60)
    orbit = ns.solve(system, {}, itinerary=ns.itinerary_of(motion))
    assert [name for name, _ in orbit.itinerary] == ["free", "contact", "released"]
    return orbit


def verdict(orbit, late, moved=0):
    """Whether it is a motion when its phases last longer by a part, and states are moved by one."""
    dwell = orbit.dwell_times * (1 + np.asarray(late))
    longer = dict(zip(orbit.dwell_time_names, dwell.tolist(), strict=True))
    moved = replace(orbit, unknowns={**orbit.unknowns, **longer}, starts=orbit.states * (1 + moved))
    return moved.admissibility.verdict


@pytest.mark.parametrize("phase", range(3))
@pytest.mark.parametrize("late", [-1e-12, -1e-13, 0, 1e-13, 1e-12])
def test_a_boundary_that_is_missed_by_rounding_is_not_crossed_behind_it(phase, late):
    assert verdict(released(), late * np.eye(3)[phase]) is True


def test_a_boundary_that_is_missed_by_more_is_crossed_behind_it():
    assert verdict(released(), [0, -1e-3, 0]) is False


@pytest.mark.slow
def test_a_contact_that_has_just_broken_loose_is_no_crossing():
    """There forces cancel: whether the speed rises at once is not told by their rounding."""
    capsule = oscillator(
        "capsule", ["x1", "x2"], mass=[[1, 0], [0, 5]], damping=[["0.1", "-0.1"], ["-0.1", "0.1"]],
        stiffness=[[1, -1], [-1, 1]], forcing=[Harmonic(sp.Symbol("omega"), cosine=["1.6", 0])],
        elements=[
            SoftStop({"x1": 1, "x2": -1}, at="0.02", stiffness=15, name="wall"),
            Friction("x2", kinetic=1, name="ground"),
        ],
    )  # fmt: skip
    back, over, slips = ("ground-reaches-belt",), "free-overshoot", "free-slip"
    hits, leaves = ("wall-reaches-stop",), ("contact-overshoot", "wall-leaves-stop")
    itinerary = [
        leaves, (over, *back), (slips, *back), ("free-stick", *hits),
        ("contact-stick", "ground-breaks-backward"), leaves, (over, *hits), leaves, (over, *back),
        ("free-stick", "ground-breaks-forward"), (slips, *hits), ("contact-slip", *back),
    ]  # fmt: skip
    dwell = [0.577, 1.806, 1.408, 1.960, 0.035, 0.809, 1.861, 0.481, 0.159, 0.744, 2.526, 0.201]
    orbit, rng = ns.solve(capsule, {"omega": 1}, dwell, itinerary=itinerary), default_rng(0)
    for _ in range(30):
        rounding = rng.integers(-4, 5, len(orbit.itinerary)) * 2.0**-52
        assert verdict(orbit, rounding, rng.integers(-4, 5, len(orbit.state_names)) * 2.0**-52)

"""Curves in a plane of parameters on which a pair of multipliers leaves the unit circle."""

from fractions import Fraction
from functools import cache

import mpmath
import numpy as np
import pytest

import nonsmooth as ns
from tests.certified import told_at
from tests.explore import test_continuation_forced as impacts


@cache
def closed():
    """The map over the damping and the restitution of one mass, whose curve is known."""
    box = {"c": ("-0.25", "0.05"), "r": ("0.75", "0.85")}
    return ns.certify.box(impacts.orbit(-0.5), box, tiles=40)


@pytest.mark.slow
def test_the_curve_is_that_of_the_closed_form():
    """r^2 exp(-c T) = 1, T = 2 pi/2.8, of a mass of negative damping that strikes a wall."""
    assert closed().decided == 1
    assert {region.verdict for region in closed().regions} == {"stable", "unstable"}
    (curve,) = closed().curves
    assert curve.event.kind == "neimark-sacker"
    for r in np.linspace(0.757, 0.8499, 23):
        with mpmath.workdps(40):
            true = mpmath.log(mpmath.mpf(float(r))) * mpmath.mpf("2.8") / mpmath.pi
            at = {"c": Fraction(mpmath.nstr(true, 35)), "r": Fraction(float(r))}
        assert told_at(closed(), at) == ""
        assert closed().tile_at(at).event.band.radius < 1e-4

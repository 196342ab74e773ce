"""Curves in a plane of parameters on which a pair of multipliers leaves the unit circle."""

from __future__ import annotations

from fractions import Fraction
from functools import cache
from typing import Any

import mpmath
import numpy as np
import pytest
from flint import arb, ctx

import nonsmooth as ns
from nonsmooth.runtime.checker.orbits.stability import _inside, _throughout
from nonsmooth.runtime.core.taylor_models import space_of
from tests.certified import told_at
from tests.explore import test_continuation_forced as impacts


@cache
def closed() -> Any:
    """The map over the damping and the restitution of one mass, whose curve is known."""
    box = {"c": ("-0.25", "0.05"), "r": ("0.75", "0.85")}
    return ns.certify.box(impacts.orbit(-0.5), box, tiles=40)


@pytest.mark.slow
def test_the_curve_is_that_of_the_closed_form() -> None:
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


def test_stability_is_that_of_the_middle_where_no_multiplier_passes() -> None:
    """A pair of modulus m: z^2 - 2 m cos(a) z + m^2, with m near 1."""
    with ctx.workprec(64):
        space = space_of(2, 6)
        wide = space.variable(0, arb(0), arb(1))

        def pair(product: Any) -> list[Any]:
            return [arb(1), arb(-0.5) + wide * arb("0.2"), product]

        almost = arb(1) + arb("1e-6") * (wide - arb(2))
        nearer = arb("0.95") + arb("0.0499999") * wide
        assert _inside([arb(1), wide * arb("0.2") - arb("1.4"), nearer]) == "undecided"
        assert _throughout([arb(1), wide * arb("0.2") - arb("1.4"), nearer]) == "proved"
        assert _throughout(pair(almost)) == "proved"
        assert _throughout(pair(arb(1) + arb("1e-6") * (wide - arb("0.5")))) == "undecided"
        assert _throughout(pair(arb(1) - arb("1e-6") * (wide - arb(2)))) == "refuted"
        # of a saddle one multiplier is inside, all over
        assert _throughout([arb(1), wide * arb("0.1") - 3, arb("0.9")]) == "refuted"
        # z = 1 is passed
        assert _throughout([arb(1), wide * arb("0.1") - arb("1.85"), arb("0.9")]) == "undecided"

"""Maps of two parameters where several conditions change on one curve, some with no speed.

Masses that stick at the end of a cycle begin the next one at the belt's velocity: what breaks
the second one loose then leaves its limit with no speed, and only its curvature tells where to.
"""

import random
from fractions import Fraction
from functools import cache

import pytest

import nonsmooth as ns
from nonsmooth.runtime.checker.orbits.points import JudgedOrbit
from nonsmooth.runtime.core.values import flint_precision
from tests.certified import content_of, told_at

STICK = "dry-friction/global-stick"
BOX = {"V": ("0.95", "1.05"), "us2": ("0.7", "0.8")}
BREAKS = "second-breaks-backward"
TOGETHER = [
    ("entry", 0, BREAKS, "start"), ("entry", 1, BREAKS, "start"), ("condition", 3, "2.1", "end")
]  # fmt: skip


def stick(**values):
    """The paper's orbit with both masses at rest on the belt, over the friction of the second."""
    return ns.solve(STICK, {"us1": 1, "us2": "0.8", **values}, digits=30)


@cache
def found():
    """A curve on which three conditions change."""
    return ns.certify.box(ns.solve(STICK, {"us1": 1, "us2": "0.76"}), BOX)


def borders(v):
    """us2 on the curve: what holds the second mass at rest is chi (x1 - x2), which is z1 - z2."""
    orbit = stick(V=v)
    z1, z2 = (orbit.unknowns[name] for name in ("z10", "z20"))
    return float(((z1 - z2) / 2 - z1.__class__("0.4831")) / 2)


@pytest.mark.slow
def test_one_curve_decides_all():
    assert found().decided == 1
    assert [region.verdict for region in found().regions] == ["stable", "not admissible"]
    (curve,) = found().curves
    assert [curve.event.name, *curve.event.also] == TOGETHER
    assert curve.ends == ("border", "border")


@pytest.mark.parametrize("v", ["0.96", "0.98", "1.02", "1.04"])
def test_the_curve_is_where_the_force_reaches_its_limit(v):
    assert told_at(found(), {"V": Fraction(v), "us2": Fraction(borders(v))}) == ""


def test_points_of_the_plane_are_as_it_tells():
    rng, seen = random.Random(7), set()
    for _ in range(12):
        at = {"V": Fraction(rng.uniform(0.95, 1.05)), "us2": Fraction(rng.uniform(0.7, 0.8))}
        tile, verdict = found().tile_at(at), told_at(found(), at)
        point = stick(V=float(at["V"]), us2=float(at["us2"]))
        assert (verdict == "proved") == bool(point.admissibility.verdict)
        assert tile.enclosures["trace"].lower <= point.trace <= tile.enclosures["trace"].upper
        seen.add(verdict)
    assert seen == {"proved", "not admissible"}


@pytest.mark.parametrize("name", [STICK, "dry-friction/symmetric"])
def test_derivatives_that_are_passed_over_are_zero(name):
    given = {"us1": 1, "us2": 1} if name == STICK else {}
    judged = JudgedOrbit(content_of(ns.certify(ns.solve(name, given))))
    assert judged.existence.claim == "proved"
    with flint_precision(64):
        orbit, passed = judged.orbit, 0
        for place, phase in enumerate(orbit.declared.phases([])):
            field = orbit.chain.fields[place]
            for watched in phase.watched:
                if watched.begins is None:
                    continue
                values, moved = [], orbit.now.starts[place]
                for _ in range(watched.follows + 1):
                    values.append(orbit.value(watched.row, moved.entries()))
                    moved = field * moved
                assert watched.follows > watched.order
                for value in values[watched.order + 1 : watched.follows]:
                    assert abs(value) < 1e-9
                    passed += 1
        assert passed or name != STICK

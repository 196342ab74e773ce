"""Fold curves of maps of two parameters: two orbits on one side, none on the other."""

import math
import random
from fractions import Fraction
from functools import cache

import mpmath
import pytest
import sympy as sp

import nonsmooth as ns
from nonsmooth.derive import Parameter, RigidStop
from tests.certified import accepted, content_of, random_points, refused, told_at
from tests.one_mass import one_mass

BEYOND = "beyond a fold"
IMPACT = (("free", "wall-reaches-stop"),)
W, PERIOD = Fraction(12, 5), 2 * math.pi / 2.4
BOX = {"sigma": ("-1.9", "-1.2"), "r": ("0.76", "0.84")}
SMALL = {"sigma": ("-1.26", "-1.21"), "r": ("0.795", "0.805")}  # one tile


@cache
def system():
    """A mass that strikes a rigid stop once in each period of the forcing.

    Its impact velocities U solve a quadratic equation (docs/gallery/impact_oscillator.py).
    """
    r, sigma, w = sp.symbols("r sigma w")
    return one_mass(
        "struck-at",
        RigidStop("x", at=sigma, restitution=r, name="wall"),
        forces={w: 1},
        parameters=[Parameter("sigma", "position of the stop", lower=-sp.oo)],
    )


@cache
def orbit(stable):
    """One of the two orbits beside the fold."""
    data = {"r": "0.8", "sigma": "-1.225", "w": "2.4"}
    speeds = [float(u) for u in velocities(mpmath.mpf(-1.225), mpmath.mpf(0.8))]
    (speed,) = [u for u in speeds if is_stable(u, -1.225, 0.8) == stable]
    g = 1 / (1 - 2.4**2)
    cosine = (-1.225 + 1.8 / math.tan(PERIOD / 2) * speed / 2) / g
    sine = (0.8 - 0.9) * speed / (2.4 * g)
    start = [-1.225, -0.8 * speed, cosine, sine]
    found = ns.solve(system(), data, [PERIOD, *start], itinerary=IMPACT)
    assert found.stability.verdict == ("stable" if stable else "unstable")
    return found


@cache
def folded():
    """The stable orbit's map."""
    return ns.certify.box(orbit(True), BOX)


@cache
def small():
    """A part of that map, so that checks are fast."""
    return ns.certify.box(orbit(True), SMALL)


def velocities(sigma, r, periods=1):
    """The velocities of one impact in so many periods, the smaller first: two, or none."""
    w = mpmath.mpf(W.numerator) / W.denominator
    c, g = mpmath.cot(mpmath.pi * periods / w), 1 / (1 - w * w)
    a, b = (1 + r) * c / 2, (1 - r) / (2 * w)
    half, rest = a * sigma / (a * a + b * b), (sigma * sigma - g * g) / (a * a + b * b)
    root = half * half - rest
    return [] if root < 0 else [-half - mpmath.sqrt(root), -half + mpmath.sqrt(root)]


def is_stable(speed, sigma, r):
    """By trace and determinant of the closed form."""
    w = mpmath.mpf(W.numerator) / W.denominator
    period, g = 2 * mpmath.pi / w, 1 / (1 - w * w)
    cosine = (sigma + (1 + r) * mpmath.cot(period / 2) * speed / 2) / g
    trace = -2 * r * mpmath.cos(period)
    trace += (1 + r) * mpmath.sin(period) * (g * cosine * (1 - w * w) - sigma) / speed
    return abs(trace) < 1 + r * r < 2


def fold_at(r):
    """Where the two orbits meet."""
    w = mpmath.mpf(W.numerator) / W.denominator
    c, g = mpmath.cot(mpmath.pi / w), 1 / (1 - w * w)
    return g * mpmath.sqrt(1 + (w * c * (1 + r) / (1 - r)) ** 2)


def number(x):
    return mpmath.mpf(x.numerator) / x.denominator


def folds(found):
    return [tile for tile in found.tiles if tile.event is not None and tile.event.fold is not None]


@pytest.mark.slow
def test_a_box_with_a_fold_is_decided():
    found = folded()
    assert sorted(region.verdict for region in found.regions) == [BEYOND, "stable"]
    assert sum(region.share for region in found.regions) == pytest.approx(1, abs=1e-6)
    (curve,) = found.curves
    assert (curve.event.kind, curve.ends) == ("fold", ("border", "border"))
    assert curve.width < 2e-5
    assert found.open == ()
    assert found.decided == 1
    assert "two orbits meet, stable and unstable, and there is none beyond" in found.statement
    # nothing is said of all orbits where none is in the tube
    assert found.claims["existence"] == "undecided"
    (told,) = found.to_json()["curves"]
    assert told["sheets"] == {"own": "stable", "other": "unstable"}


@pytest.mark.slow
def test_the_curve_is_that_of_the_closed_form_to_forty_digits():
    for k in range(20):
        r = Fraction(7980 + 3 * k, 10_000)
        with mpmath.workdps(50):
            sigma = Fraction(mpmath.nstr(fold_at(number(r)), 40))
        assert told_at(small(), {"sigma": sigma, "r": r}) == ""


def test_random_points_have_two_orbits_with_their_verdicts_or_none():
    seen = set()
    for point in random_points(small(), 3, 40):
        event, stated = small().tile_at(point).event, told_at(small(), point)
        if event is None or not stated:
            continue
        at = [number(point[n]) for n in ("sigma", "r")]
        stable = sorted(is_stable(speed, *at) for speed in velocities(*at))
        assert stable == ([] if stated == BEYOND else [False, True])
        assert event.fold.other == "unstable"
        seen.add(stated)
    assert seen == {BEYOND, "proved"}


@pytest.mark.slow
def test_the_other_orbit_has_the_same_curve_and_the_other_verdict():
    found = ns.certify.box(orbit(False), {"sigma": ("-1.24", "-1.22"), "r": ("0.799", "0.801")})
    assert [region.verdict for region in found.regions] in (
        ["unstable", BEYOND],
        [BEYOND, "unstable"],
    )
    (curve,) = found.curves
    assert curve.event.fold.other == "proved"
    for sigma, r in curve.points:
        assert sigma == pytest.approx(float(fold_at(r)), abs=1e-6)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(2))
def test_what_is_stated_beside_folds_is_accepted(seed, tmp_path):
    drawn = random.Random(seed)
    sides = [Fraction(drawn.randint(1, 40), 1000) for _ in range(4)]
    box = {
        "sigma": (Fraction(-1225, 1000) - 4 * sides[0], Fraction(-1225, 1000) + sides[1]),
        "r": (Fraction(8, 10) - sides[2] / 4, Fraction(8, 10) + sides[3] / 4),
    }
    found = ns.certify.box(orbit(bool(seed % 2)), box, tiles=20)
    assert folds(found)
    accepted(found, tmp_path)


@pytest.mark.slow
def test_a_region_beyond_is_not_stated_wider():
    """Without a fold on its border what is behind it is undecided, and may not count as known."""
    found = content_of(folded())
    tile = next(t for t in found["tiles"] if t["event"])
    share = 0.5 ** sum(level for _, level in tile["place"])
    tile |= {"event": None, "guess": []}
    refused(found, "shares")
    for before, after in (("divided", "undecided"), ("undecided", BEYOND)):
        found["shares"][before] -= share
        found["shares"][after] += share
        refused(found, "shares")

"""What is proved of the multipliers of maps whose eigenvalues are known."""

import copy
from functools import cache
from itertools import combinations
from types import SimpleNamespace

import numpy as np
import pytest
import sympy as sp
from flint import arb, arb_mat, ctx

import nonsmooth as ns
from nonsmooth.derive import Parameter
from nonsmooth.runtime.checker.orbits.stability import (
    _inside,
    multipliers,
    others_below,
    paired,
    passing,
    stability,
)
from tests.certified import believed, content_of, refused, ticking
from tests.tables import slow


@pytest.fixture(autouse=True)
def bits():
    with ctx.workprec(200):
        yield


def map_of(square, kind="stable", size=0):
    """An orbit whose Poincare map, of so many coordinates, has a derivative on a section."""
    size = size or square.nrows()
    declared = SimpleNamespace(free=range(size), size=size, stability=kind, alone=True)
    return SimpleNamespace(section=square, declared=declared)


def diagonal(*entries):
    places = range(len(entries))
    return arb_mat([[entries[i] if i == j else 0 for j in places] for i in places])


def similar(eigenvalues, rng):
    """Balls of a real matrix with these eigenvalues: real ones, and one of each complex pair."""
    size = sum(1 + bool(np.iscomplex(m)) for m in eigenvalues)
    block, place = np.zeros((size, size)), 0
    for m in eigenvalues:
        if np.iscomplex(m):
            block[place : place + 2, place : place + 2] = [[m.real, m.imag], [-m.imag, m.real]]
        else:
            block[place, place] = m.real
        place += 1 + bool(np.iscomplex(m))
    basis = arb_mat((rng.normal(size=(size, size)) + 3 * np.eye(size)).tolist())
    return basis * arb_mat(block.tolist()) * basis.inv()


@pytest.mark.parametrize("size", [1, 2, 3, 5])
def test_orbits_are_stable_where_all_multipliers_are_inside_the_unit_circle(size):
    rng = np.random.default_rng(size)
    seen = set()
    for _ in range(40):
        matrix = rng.normal(size=(size, size)) / np.sqrt(size)
        found = stability(map_of(arb_mat(matrix.tolist())))
        assert found == ("proved" if max(abs(np.linalg.eigvals(matrix))) < 1 else "refuted")
        seen.add(found)
    assert stability(map_of(diagonal(*[1] * size))) == "undecided"
    assert seen == {"proved", "refuted"}


def test_of_wide_coefficients_a_root_outside_is_seen_and_none_is_made_up():
    """As next to a grazing, where a trace is large and the product of the roots is not known."""
    assert _inside([arb(1), arb(3e9, 4e8), arb(0, 1e13)]) == "refuted"
    wide = [(1.64, 2e-3), (2.509, 4e-4), (1.66, 2e-3), (0.706343, 1e-7)]
    assert _inside([arb(1), *(arb(*x) for x in wide)]) == "refuted"
    rng = np.random.default_rng(4)
    for _ in range(60):
        size = int(rng.integers(1, 6))
        roots = np.exp(2j * np.pi * rng.random(size // 2)) * rng.random(size // 2) ** 0.1
        real = rng.uniform(-1, 1, size % 2)
        middles = np.poly([*roots, *roots.conj(), *real]).real[1:]
        away = 10.0 ** rng.uniform(-6, 2, size)
        # not around its own polynomial, but around others that are as near
        others = middles + rng.uniform(-0.99, 0.99, size) * away
        assert _inside([arb(1), *map(arb, others.tolist(), away.tolist())]) != "refuted"


@pytest.mark.parametrize(
    ("pairs", "verdict"),
    [
        ((), "proved"),
        ((np.exp(1j),), "proved"),
        ((np.exp(1j), np.exp(2.5j)), "proved"),
        ((np.exp(1j), np.exp(1.0001j), np.exp(3j)), "proved"),
        ((np.exp(1j), np.exp(1j)), "undecided"),
        ((2.0, 0.5), "refuted"),
        ((-2.0, -0.5, np.exp(1j)), "refuted"),
        ((-2.0, -0.5, 3.0, 1 / 3), "refuted"),
        ((1.1 * np.exp(1j), np.exp(1j) / 1.1), "refuted"),
    ],
)
@pytest.mark.parametrize("rest", [(1.0, 0.0), (1.0,)])
def test_pairs_on_the_unit_circle_are_told_from_others(pairs, verdict, rest):
    square = similar((*rest, *pairs), np.random.default_rng(3))
    # the numbers are doubles: the balls have to contain the exact ones
    wide = arb_mat([[x + arb(0, 1e-12) for x in row] for row in square.tolist()])
    size = square.nrows() + 2 - len(rest)
    assert stability(map_of(wide, "neutral", size)) == verdict


@pytest.mark.parametrize(
    ("roots", "told"),
    [
        ([np.exp(1j), np.exp(-1j)], True),
        ([np.exp(1j), np.exp(-1j), 0.5, 0.3], True),
        ([2.0, 0.5, 0.1], False),
        ([2 * np.exp(1j), 2 * np.exp(-1j), np.exp(1j) / 2, np.exp(-1j) / 2], False),
        ([0.5, 0.5, 0.3], False),
        ([0.5, 0.3], True),
        ([0.2, 0.7, 1.3, -0.4, 0.9], True),
    ],
)
def test_two_roots_with_the_product_one_are_told_from_a_pair_on_the_circle(roots, told):
    polynomial = [arb(float(c), 1e-12) for c in np.poly(roots).real]
    assert paired(polynomial) is told
    expected = np.prod([1 - x * y for x, y in combinations(roots, 2)]).real
    found = passing(polynomial, "neimark-sacker")
    assert float(found.mid()) == pytest.approx(expected, rel=1e-9, abs=1e-9)


@pytest.mark.parametrize("seed", range(5))
def test_multipliers_are_enclosed_and_all_others_are_below_their_bound(seed):
    rng = np.random.default_rng(seed)
    pair = 0.7 * np.exp(1j * rng.uniform(0.3, 2.8))
    wanted = [*rng.uniform(-1.4, 1.4, 2), pair]
    orbit = map_of(similar((*wanted, 1e-30), rng), size=6)
    found = multipliers(orbit)
    assert len(found) == 4
    for m in (*wanted, pair.conjugate()):
        assert sum(abs(complex(x) - m) < 1e-12 for x in found) == 1
    assert [abs(complex(x)) for x in found] == sorted(abs(complex(x)) for x in found)[::-1]
    assert sum(x.imag.is_zero() for x in found) == 2
    for left in range(4):
        assert abs(found[left]) < others_below(orbit, found[:left] + found[left + 1 :])
    assert others_below(orbit, found) < 1e-25


NEAR, TINY = 2.0**-40, 2.0**-80
with ctx.workprec(200):
    HALF_AND_TINY, LESS_THAN_ONE = arb(0.5) + TINY, arb(1) - TINY


@pytest.mark.parametrize(
    ("entries", "kind", "more", "told"),
    [
        ((0.5, -0.25, 1), "neutral", 1, [0.5, -0.25]),
        ((0.5, 0.5 + NEAR, 0.5 - NEAR, -0.5), "stable", 0, [-0.5]),
        ((0.5, HALF_AND_TINY, -0.5), "stable", 0, []),  # nor any beside them
        ((0.5, 1 - NEAR, 1 + NEAR, 1), "neutral", 0, [0.5]),
        ((0.5, 1, 1), "neutral", 0, []),
        ((LESS_THAN_ONE,), "stable", 0, [1]),
        ((TINY,), "stable", 1, []),
        ((TINY,), "stable", 0, [TINY]),
    ],
)
def test_multipliers_that_lie_too_near_are_not_stated(entries, kind, more, told):
    """To each other, to the trivial 1, or to zero, of which there are as many as are left."""
    orbit = map_of(diagonal(*entries), kind, len(entries) + more)
    assert [complex(m) for m in multipliers(orbit)] == told


p, q = (Parameter(name, "what multipliers depend on", lower=-sp.oo) for name in "pq")


def branch(*rows):
    """States at rest, which are mapped by a matrix each time that a clock comes to 1: p = -1."""
    system = ticking(sp.Matrix(rows), 0, p, q)
    guess, itinerary = [1.0, *[0.0] * (len(rows) + 1)], [("rest", "tick")]
    orbit = ns.solve(system, {"p": "-9/10", "q": "1/3"}, guess, itinerary=itinerary)
    return ns.continue_orbit(orbit, "p", (-1.125, -0.875))


def test_a_neutral_saddle_is_no_torus():
    """Where p = 3, two real multipliers have the product 1."""
    flips = branch([p.symbol, 0], [0, q.symbol])
    content = content_of(ns.certify.event(flips, flips.events[0]))
    (event,) = content["events"]
    event["kind"] = "neimark-sacker"
    for ball in (event["box"][-1], event["enclosures"]["p"]):
        ball["mid"] = "3"
    refused(content, "the pair may be real")


P_AND_Q = {
    "flip": (p.symbol, q.symbol),
    "neimark-sacker": (q.symbol, p.symbol),
}


@cache
def ranges(kind):
    """A branch and a map with an event where p = -1: the multipliers are a, i b and -i b."""
    a, b = P_AND_Q[kind]
    along, ends = branch([a, 0, 0], [0, 0, -b], [0, b, 0]), ("-9/8", "-7/8")
    over = ns.certify.box(along.orbit, {"p": ends, "q": ("1/4", "3/8")}, tiles=9)
    found = [*map(content_of, (ns.certify.branch(along, interval=ends), over))]
    for content in found:
        assert [tile["event"]["kind"] for tile in content["tiles"] if tile["event"]] == [kind]
        believed(content)
    return found


@pytest.mark.parametrize(
    ("kind", "pair", "told"),
    [
        # i p and -i p
        ("flip", [["0", "-1"], ["1", "0"]], "there may be another event: neimark-sacker"),
        # 2 p and p / 2
        slow("neimark-sacker", [["2", "0"], ["0", "1/2"]], "two (multipliers may be|are) real"),
    ],
)
def test_multipliers_that_pass_the_circle_otherwise_are_another_event(kind, pair, told):
    for content in copy.deepcopy(ranges(kind)):
        (transition,) = content["declaration"]["transitions"]
        for row, numbers in zip(transition["reset"][1:3], pair, strict=True):
            row[1:3] = [{"above": [[x, [1, 0]]], "below": [["1", [0, 0]]]} if x != "0" else x
                        for x in numbers]  # fmt: skip
        if kind == "neimark-sacker":  # a saddle on both sides
            for tile in content["tiles"]:
                told_of = tile if "before" in tile else tile["event"] or {}
                sides = {"before", "after", "below", "above"} & {*told_of}
                told_of |= dict.fromkeys(sides, "unstable")
            for entry in (content, *content["tiles"]):
                entry.get("enclosures", {})["trace"] = {"mid": "0", "rad": "9"}
        refused(content, told)

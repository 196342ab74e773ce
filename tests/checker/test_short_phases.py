"""Phases that may vanish: means of flows against integrals, and which phases are covered."""

from types import SimpleNamespace

import numpy as np
import pytest
from flint import arb, arb_mat, ctx, fmpq
from scipy.integrate import quad_vec
from scipy.linalg import expm

from nonsmooth.runtime.checker import Failure
from nonsmooth.runtime.checker.orbits.short import means, short_phase

ONE = [[fmpq(int(i == j)) for j in range(3)] for i in range(3)]
SPRING, LOOSE = ([[0, 1, 0], [k, 0, 2 - k], [0, 0, 0]] for k in (-1, 1))
BACK = [[1, 0, 0], [0, -1, 0], [0, 0, 1]]
PLACE = [1, 0, 0]


def exact(rows):
    return [[fmpq(x) for x in row] for row in rows]


def declared(*phases, kind="forcing", **more):
    """A cycle of phases: field, row of the end, reset."""
    steps = [
        SimpleNamespace(field=exact(f), exit=tuple(map(fmpq, e)), reset=exact(r))
        for f, e, r in phases
    ]
    given = {"rational": True, "translations": [], "known": [([PLACE], [PLACE], [])] * len(steps)}
    return SimpleNamespace(steps=steps, closing={"kind": kind}, **{**given, **more})


IN, OUT = (SPRING, PLACE, ONE), (LOOSE, PLACE, ONE)


@pytest.mark.parametrize("time", [0.0, 0.7, -1.3])
@pytest.mark.parametrize("unit", [1.0, 1e300])
def test_means_of_flows_are_integrals(time, unit):
    rng = np.random.default_rng(5)
    b, row = rng.normal(size=(3, 3)), rng.normal(size=(1, 3))
    with ctx.workprec(128):
        given = (arb_mat(part.tolist()) for part in (unit * row, b))
        for power, found in enumerate(means(*given, arb(time))):
            wanted = row @ quad_vec(lambda s, k=power: s**k * expm(b * time * s), 0, 1)[0]
            near = [float(x.mid()) / unit for x in found.entries()]
            np.testing.assert_allclose(near, wanted.ravel(), rtol=1e-11, atol=1e-12)


@pytest.mark.parametrize(
    ("reset", "push", "first"),
    [(ONE, 0, [0, -2, 0]), (ONE, 7, [0, -2, 0]), (BACK, 0, [-2, 2, 0]), (BACK, 7, None)],
)
def test_a_jump_is_that_of_the_velocity_over_the_rate(reset, push, first):
    """F+ R - R F- = c (n F-) where n y = 0: x' = 2 x + v, v' = -k x - d v + g; d = 1, 3, 8."""
    before, behind, last = (
        [[2, 1, 0], [-k, -d, push], [0, 0, 0]] for k, d in ((2, 1), (5, 3), (4, 8))
    )
    cycle = (before, PLACE, reset), (behind, PLACE, ONE), (last, PLACE, ONE)
    assert short_phase(declared(*cycle), 1) == (1, [first, [0, -5, 0], [0, 7, 0]], True)
    jumping = declared((before, PLACE, BACK), (behind, PLACE, ONE), kind="state")
    if push:
        with pytest.raises(Failure, match="does not begin regularly"):
            short_phase(jumping, 1)


@pytest.mark.parametrize(
    ("cycle", "place", "told"),
    [
        ((IN, OUT), 2, "no such phase"),
        ((IN, OUT), -1, "no such phase"),
        ((IN,), 0, "no such phase"),
        (((SPRING, [0, 0, 0], ONE), OUT), 1, "does not begin where it may end"),
        (((SPRING, [1, 0, -1], ONE), OUT), 1, "does not begin where it may end"),
        (((SPRING, PLACE, [[1, 0, 1], *ONE[1:]]), OUT), 1, "does not begin where it may end"),
        (((SPRING, [2, 0, 0], [[3, 0, 0], *ONE[1:]]), OUT), 1, None),
    ],
)
def test_a_divided_phase_begins_where_it_may_end(cycle, place, told):
    if told is None:
        assert short_phase(declared(*cycle), place).divided
        return
    with pytest.raises(Failure, match=told):
        short_phase(declared(*cycle), place)


@pytest.mark.parametrize(
    ("more", "told"),
    [
        ({}, None),
        ({"rational": False}, "no phase can be divided"),
        ({"translations": [[1, 0]]}, "no phase can be divided"),
        ({"kind": "period"}, "no phase can be divided"),
        ({"known": [([], [], [])] * 2}, "does not last"),
        ({"known": [([PLACE], [], [])] * 2}, "does not last"),
    ],
)
def test_of_an_orbit_that_is_no_function_of_time_all_lasts_in_the_phase(more, told):
    damped = [[0, 1, 0], [0, -1, 0], [0, 0, 0]]
    cycle = declared((damped, PLACE, BACK), (damped, PLACE, ONE), **{"kind": "state", **more})
    if told is None:
        assert short_phase(cycle, 1) == (1, [[-2, 0, 0], None], False)
        assert short_phase(cycle, 0) == (0, [None, [0, 0, 0]], False)
        return
    with pytest.raises(Failure, match=told):
        short_phase(cycle, 1)

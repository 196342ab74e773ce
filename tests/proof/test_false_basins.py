"""Systems made to have false basins proved: where a motion that leads elsewhere is easily missed.

All of them carry x from -1 to 0 and set it back, where y takes another value: on the section
behind that y = 0 is a stable orbit, for most y.
"""

import numpy as np
import pytest
import sympy as sp

import nonsmooth as ns
from nonsmooth.derive import (
    Boundary,
    Condition,
    Configuration,
    FirstOrder,
    Itinerary,
    System,
    Transition,
)
from tests.certified import content_of, saved

X, Y = sp.symbols("x y", real=True)


def loop(low, high, place, *transitions, boundaries=(), more=()):
    """x' = 1 and y' = -y/10, up to x = 0; then y/2 at x = -1, or a place, from low to high."""
    configurations = (
        Configuration(
            "loop",
            FirstOrder([[0, 0], [0, -sp.Rational(1, 10)]], (1, 0)),
            (Boundary("end", X), *boundaries),
        ),
        *more,
    )
    halved = {X: -1, Y: Y / 2}
    again = [
        Transition("loop", {"end"}, "loop", (Condition(low - Y, "loop"),), halved),
        Transition("loop", {"end"}, "loop", (Condition(Y - high, "loop"),), halved),
        Transition("loop", {"end"}, "loop", (), {X: -1, Y: place}),
    ]
    system = System(
        "loop",
        "a loop",
        (X, Y),
        (),
        configurations,
        (*again, *transitions),
    )
    return Itinerary("round", system, (("loop", "end", "tau"),))


def basin(itinerary, **options):
    orbit = ns.solve(itinerary, {}, guess={"tau": 1})
    assert orbit.stability.verdict == "stable"
    box = {"x": (-1, 0), "y": (0, 2)}
    return orbit, ns.certify.basin(orbit, box=box, side=2.0**-5, tiles=0, **options)


def box_around(found, place):
    (number,) = np.floor(place / found.grid.sides).astype(int) - found.grid.first
    return number


def rank_of(found, place):
    return found.ranks[box_around(found, place)]


def with_rank(found, place, rank, path):
    """The file of a basin in which the box around a place has another rank."""
    ranks = found.ranks.tolist()
    ranks[box_around(found, place)] = rank
    content = content_of(found) | {"ranks": [[value, 1] for value in ranks]}
    return ns.certify.check(saved(content, path)).difference


@pytest.fixture(scope="module")
def beyond():
    """From about y = 0.6686 to y = 1.011 on the section, which is beyond a boundary at 1.01.

    The motion leaves the loop there at once, and y grows without end.
    """
    low, high = sp.Rational(6, 10), sp.Rational(61, 100)
    place = sp.Rational(1011, 1000) + (Y - sp.Rational(605, 1000)) / 100
    away = Configuration("away", FirstOrder([[0, 0], [0, 1]], (0, 0)), ())
    high_boundary = Boundary("high", Y - sp.Rational(101, 100))
    return basin(
        loop(
            low,
            high,
            place,
            Transition("loop", {"high"}, "away"),
            Transition("loop", {"high", "end"}, "away"),
            boundaries=(high_boundary,),
            more=(away,),
        )
    )


def test_what_arrives_beyond_a_boundary_is_not_on_the_section(beyond):
    orbit, found = beyond
    motion = ns.simulate(orbit.system, {}, [-1, 0.6686], "loop", transitions=4)
    assert motion.configurations[-1] == "away"
    assert found.proved
    assert rank_of(found, 0.7) > 0
    assert rank_of(found, 1.0) > 0
    assert rank_of(found, 0.6686) < 0


@pytest.mark.parametrize("rank", [2, 3])
def test_the_check_does_not_take_it_for_an_arrival(beyond, tmp_path, rank):
    _, found = beyond
    told = with_rank(found, 0.6686, rank, tmp_path / "false.json")
    assert told == f"a box of the rank {rank} may lead elsewhere"


def test_a_trapping_region_has_no_box_that_motions_leave(beyond):
    orbit, _ = beyond
    region = {"y": (-1, 1.2)}
    graph = ns.certify.region(orbit.system, {}, [-1, 0.5], "loop", boxes=256, region=region)
    assert graph.box_of([0.5]) in graph.trapping
    assert graph.box_of([0.6686]) not in graph.trapping

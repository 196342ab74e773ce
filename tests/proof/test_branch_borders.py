"""Borders of branches: entry, tangent and simultaneous events of a relay, proved and checked."""

from pathlib import Path
from typing import Any

import mpmath
import pytest
import sympy as sp

import nonsmooth as ns
from nonsmooth.derive import Boundary, Configuration, FirstOrder, Parameter, System, Transition
from nonsmooth.runtime.core.arithmetic import exact_ball

A, B = sp.symbols("a b", real=True)
THRESHOLD = Parameter("w", "a threshold, nondimensional", lower=-sp.oo)
WIDTH = sp.Rational(1, 10)


def relay(on: Any = (), off: Any = (), more: Any = (), reset: Any = None) -> System:
    """Two lags behind a relay with hysteresis: a' = +-1 - a, b' = a - b."""
    lags = [[-1, 0], [1, -1]]
    heats, cools = FirstOrder(lags, [1, 0]), FirstOrder(lags, [-1, 0])
    return System(
        name="relay",
        description="two lags and a relay; nondimensional",
        states=(A, B),
        parameters=(THRESHOLD,),
        configurations=(
            Configuration("on", heats, (Boundary("warm", B - WIDTH), *on)),
            Configuration("off", cools, (Boundary("cold", -B - WIDTH), *off)),
        ),
        transitions=(
            Transition("on", {"warm"}, "off", reset=reset or {}),
            Transition("off", {"cold"}, "on"),
            *more,
        ),
    )


def peak() -> Any:
    """The largest a of the orbit, which both phases reach with opposite signs."""
    with mpmath.workprec(200):

        def missed(time: Any) -> Any:
            tenth = mpmath.mpf(1) / 10
            start, decay = -mpmath.tanh(time / 2), mpmath.exp(-time)
            return 1 + (start - 1) * time * decay - (1 + tenth) * decay - tenth

        return mpmath.tanh(mpmath.findroot(missed, 1.15) / 2)


HOT = Boundary("hot", A - THRESHOLD.symbol)
SYSTEMS = {
    # the other boundary is reached together with the one that ends the phase
    "simultaneous": (relay(on=(HOT,), more=(Transition("on", {"hot"}, "off"),)), "0.6", 0.3, 0.7),
    # the phase begins beyond a boundary
    "entry": (relay(off=(HOT,), more=(Transition("off", {"hot"}, "on"),)), "0.6", 0.3, 0.7),
    # the phase begins on a boundary, and leaves it to the wrong side
    "tangent": (
        relay(
            off=(Boundary("again", B - WIDTH),),
            more=(Transition("off", {"again"}, "on"),),
            reset={A: THRESHOLD.symbol},
        ),
        "0.05",
        0.01,
        0.2,
    ),
}


@pytest.mark.parametrize("kind", SYSTEMS)
def test_a_lone_border_is_one_event(kind: str, tmp_path: Path) -> None:
    system, value, low, high = SYSTEMS[kind]
    itinerary = [("on", "warm"), ("off", "cold")]
    orbit = ns.solve(system, {"w": value}, [1.0, 1.0], itinerary=itinerary)
    branch = ns.continue_orbit(orbit, "w", (low, high))
    found = ns.certify_branch(branch, interval=(str(low), str(high)))
    assert found.complete, found.statement
    (event,) = found.events
    assert (event.kind, event.also) == (kind, ())
    assert {part.verdict for part in found.intervals} == {"stable", "not admissible"}
    (first, second) = found.intervals
    inside = second if kind != "tangent" else first
    assert inside.verdict == "stable"
    with mpmath.workprec(200):
        closed = mpmath.mpf(1) / 10 if kind == "tangent" else peak()
        assert event.enclosures["w"].ball.contains(exact_ball(closed))
    found.save(tmp_path / "border.json")
    assert ns.check_certificate(tmp_path / "border.json").claims == {"branch": "proved"}

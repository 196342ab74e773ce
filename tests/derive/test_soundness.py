"""Well-formed declarations that cannot move are refused, each in one line that names it."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any

import pytest
import sympy as sp

from nonsmooth.derive import (
    Boundary,
    Condition,
    Configuration,
    DeclarationError,
    FirstOrder,
    Itinerary,
    Parameter,
    Reference,
    SecondOrder,
    System,
    Transition,
)
from nonsmooth.derive.codegen.derived import derive_system

X, V = STATES = sp.symbols("x v", real=True)
X1, X2, V1, V2 = PAIR = sp.symbols("x1 x2 v1 v2", real=True)
K, G = Parameter("k", "stiffness"), Parameter("g", "gap")
M, N = Parameter("m", "mass"), Parameter("n", "coupling", -1, 1)
KS, GS, MS, NS = (p.symbol for p in (K, G, M, N))

FREE = Configuration("free", SecondOrder([[1]], [[KS]]), (Boundary("hits", X - GS),))
REST = Configuration("rest", SecondOrder([[1]], [[KS]], held={X: 0}), (Boundary("goes", -X),), ())
STOP = replace(REST, boundaries=(Boundary("goes", X - 2 * GS),), constraints=(X - GS,))


def system(
    configurations: Sequence[Configuration], transitions: Sequence[Transition], **parts: Any
) -> System:
    """One mass on a spring in front of a stop at x = g."""
    known: dict[str, Any] = {"name": "one", "description": "", "states": STATES}
    known |= {"parameters": (K, G)} | parts
    return System(configurations=configurations, transitions=transitions, **known)


def alone(*transitions: Transition, **parts: Any) -> Callable[[], System]:
    return lambda: system((FREE,), transitions, **parts)


def moving(dynamics: Any, states: Any = STATES, **parts: Any) -> Callable[[], System]:
    """A system of one configuration without boundaries."""
    return lambda: system((Configuration("free", dynamics(), ()),), (), states=states, **parts)


BOUNCE = Transition("free", {"hits"}, "free", (), {V: -V})
REACHED = Condition(V, "free")

WRONG: list[tuple[str, Callable[[], Any], str]] = [
    # a boundary without a transition
    (
        "no way on",
        lambda: system((FREE, REST), (BOUNCE,)),
        "configuration 'rest': no transition leads on from boundary 'goes'",
    ),
    # two transitions that both apply
    (
        "the same twice",
        alone(BOUNCE, BOUNCE),
        "'free' -> 'free' by hits never applies: the one to 'free' before it applies whenever",
    ),
    (
        "behind one without conditions",
        alone(BOUNCE, replace(BOUNCE, conditions=(REACHED,))),
        "'free' -> 'free' by hits never applies",
    ),
    (
        "behind one with fewer conditions",
        alone(
            replace(BOUNCE, conditions=(REACHED,)),
            replace(BOUNCE, conditions=(Condition(X, "free"), REACHED)),
            BOUNCE,
        ),
        "never applies",
    ),
    # a reset to the wrong side
    (
        "beyond the boundary",
        alone(Transition("free", {"hits"}, "free", (), {X: X + 1})),
        r"'free' -> 'free': behind it boundary 'hits' is passed already \(its function is 1, not",
    ),
    (
        "beyond by a parameter",
        alone(Transition("free", {"hits"}, "free", (), {X: 2 * X})),
        "'hits' is passed already .its function is g, not negative",
    ),
    (
        "beyond the target's boundary",
        lambda: system((FREE, REST), (replace(BOUNCE, target="rest", reset={X: -GS, V: 0}),
                                      Transition("rest", {"goes"}, "free"))),
        "'free' -> 'rest': behind it boundary 'goes' is passed already .its function is g,",
    ),
    (
        "not on the stop",
        lambda: system((FREE, STOP), (replace(BOUNCE, target="rest", reset={X: GS / 2, V: 0}),
                                      Transition("rest", {"goes"}, "free", (), {X: 0}))),
        "'free' -> 'rest': behind it -g . x is -g/2, where the target keeps it zero",
    ),
    # masses
    (
        "negative mass",
        moving(lambda: SecondOrder([[-1]], [[1]])),
        "'free': mass is not positive definite: its leading minor of order 1 is -1",
    ),
    (
        "indefinite mass",
        moving(lambda: SecondOrder([[1, 2], [2, 1]], sp.eye(2)), PAIR),
        "'free': mass is not positive definite: its leading minor of order 2 is -3",
    ),
    (
        "negative on the whole domain",
        moving(lambda: SecondOrder([[NS - 1]], [[1]]), parameters=(N,)),
        "mass is not positive definite: its leading minor of order 1 is n - 1",
    ),
    (
        "not symmetric",
        moving(lambda: SecondOrder([[2, 1], [0, 2]], sp.eye(2)), PAIR),
        "'free': mass is not symmetric: 1 and 0",
    ),
    # numbers and symbols
    ("mass NaN", lambda: SecondOrder([[math.nan]], [[1]]), "mass holds nan, which is no finite"),
    ("stiffness infinite", lambda: SecondOrder([[1]], [[math.inf]]), "stiffness holds oo"),
    ("load infinite", lambda: SecondOrder([[1]], [[1]], (-math.inf,)), "load holds -oo"),
    ("damping complex", lambda: SecondOrder([[1]], [[1]], damping=[[1j]]), "damping: I is no real"),
    ("held NaN", lambda: SecondOrder([[1]], [[1]], held={X: math.nan}), "velocity of x holds nan"),
    ("matrix NaN", lambda: FirstOrder([[math.nan]]), "matrix holds nan"),
    ("ragged", lambda: SecondOrder([[1, 0], [1]], sp.eye(2)), "mass is no matrix"),
    (
        "boundary NaN",
        lambda: system((replace(FREE, boundaries=(Boundary("hits", X - math.nan),)),), ()),
        "'free', boundary 'hits' holds nan",
    ),
    (
        "reset infinite",
        alone(replace(BOUNCE, reset={V: math.inf})),
        "reset of v holds oo, which is no finite real number",
    ),
    (
        "a symbol of one's own",
        moving(lambda: SecondOrder([[1]], [[sp.Symbol("k")]])),
        "symbol k has other assumptions than the declared k: use .* Parameter.symbol",
    ),
    # names
    ("system", alone(BOUNCE, name="my system"), "system 'my system' is no name"),
    ("path", alone(BOUNCE, name="../one"), "is no name: letters, digits and hyphens"),
    (
        "configuration",
        lambda: system((replace(FREE, name="free 1", boundaries=()),), ()),
        "configuration 'free 1' is no name",
    ),
    (
        "hyphens",
        lambda: system((replace(FREE, name="a-b"), replace(FREE, name="a_b")), ()),
        "configurations 'a-b' and 'a_b' differ by hyphens only",
    ),
    (
        "state",
        moving(lambda: SecondOrder([[1]], [[1]]), (sp.Symbol("x'", real=True), V)),
        "state \"x'\" is not an identifier",
    ),
    (
        "itinerary",
        lambda: Itinerary("a loop", alone(BOUNCE)(), (("free", "hits", "T"),)),
        "itinerary 'a loop' is no name",
    ),
]  # fmt: skip


@pytest.mark.parametrize(("make", "message"), [w[1:] for w in WRONG], ids=[w[0] for w in WRONG])
def test_a_declaration_that_cannot_move_is_refused(make: Callable[[], Any], message: str) -> None:
    with pytest.raises(DeclarationError, match=message) as caught:
        make()
    assert "\n" not in str(caught.value)


RIGHT: list[tuple[str, Callable[[], Any]]] = [
    ("bounce", alone(BOUNCE)),
    ("a condition, then all else", alone(replace(BOUNCE, conditions=(REACHED,)), BOUNCE)),
    (
        "a condition and its negation",
        alone(
            replace(BOUNCE, conditions=(REACHED,)),
            replace(BOUNCE, conditions=(replace(REACHED, holds=False),)),
        ),
    ),
    ("back from the boundary", alone(replace(BOUNCE, reset={X: X - 1}))),
    # on either side, as the state or the parameters are
    ("depends on the state", alone(replace(BOUNCE, reset={X: V}))),
    ("depends on a parameter", alone(replace(BOUNCE, reset={X: GS - NS}), parameters=(K, G, N))),
    (
        "a mass that may be positive",
        moving(lambda: SecondOrder([[MS, NS], [NS, MS]], sp.eye(2)), PAIR, parameters=(M, N)),
    ),
    ("no transitions at all", lambda: system((FREE, REST), ())),
    (
        "on the stop",
        lambda: system((FREE, STOP), (replace(BOUNCE, target="rest", reset={X: GS, V: 0}),
                                      Transition("rest", {"goes"}, "free", (), {X: 0}))),
    ),
]  # fmt: skip


@pytest.mark.parametrize("make", [r[1] for r in RIGHT], ids=[r[0] for r in RIGHT])
def test_what_may_be_right_is_accepted(make: Callable[[], Any]) -> None:
    assert isinstance(make(), System)


@pytest.mark.parametrize(
    ("reference", "message"),
    [
        (Reference({"k": "1"}, {"ta": "3"}), "'loop': the reference guesses no "),
        (
            Reference({"kk": "1"}, {"v0": "2", "ta": "3", "T": "1"}),
            "'loop': the reference has kk, which is no parameter",
        ),
    ],
)
def test_a_reference_has_the_names_of_the_orbit(reference: Reference, message: str) -> None:
    kicked = alone(replace(BOUNCE, reset={V: -V / 2 - 1}))()
    loop = Itinerary("loop", kicked, (("free", "hits", "T"),), reference=reference)
    with pytest.raises(DeclarationError, match=message):
        derive_system(kicked, (loop,))

"""Which orbits have transitions whose conditions their phases show."""

import pytest
import sympy as sp

from nonsmooth.derive import (
    Boundary,
    Condition,
    Configuration,
    FirstOrder,
    Itinerary,
    Parameter,
    System,
    Transition,
)
from nonsmooth.derive.codegen.emit import emit_system

X, V, Y = STATES = sp.symbols("x v y", real=True)
P, Q = Parameter("P", "not negative"), Parameter("Q", "of any sign", lower=-sp.oo)


def holds(function, along="rising"):
    return Condition(function, along)


def fails(function):
    return Condition(function, "rising", holds=False)


@pytest.mark.parametrize(
    ("shown", "conditions", "options"),
    [
        (True, [holds(X), holds(V), holds(V + X), holds(P.symbol * V), fails(-V - P.symbol)], {}),
        *((False, [each], {}) for each in (fails(V), holds(Y), holds(X, along="falling"))),
        *((False, [each], {}) for each in (holds(Q.symbol * V), fails(P.symbol - V))),
        # the next phase begins in front of its boundary, or at once leaves it
        (True, [holds(V + 1)], {}),
        (True, [holds(3 - V)], {"ends": X}),
        (False, [holds(V - 3)], {"ends": X}),
        # what is reset decides as it was
        (True, [holds(V)], {"reset": {V: -V / 2, Y: 0}}),
        (False, [holds(V + 1)], {"reset": {V: -V / 2}}),
        (False, [holds(V + Y)], {"reset": {Y: 0}}),
        # of an earlier transition one condition has to fail
        (True, [], {"earlier": [[holds(Y), fails(V)]]}),
        (False, [], {"earlier": [[holds(V)]]}),
        (False, [], {"earlier": [[holds(Y)]]}),
    ],
)
def test_what_phases_show(shown, conditions, options):
    """Where x has risen to zero v is positive; what falls then begins with x' = v - 3."""
    rates = [[0, 1, 0], [0, 0, 0], [0, 0, -1]]
    phases = [("rising", "rising", "T"), ("falling", "falling", "S")]
    system = System(
        "listed", "", STATES, (P, Q),
        tuple(
            Configuration(name, FirstOrder(rates, loads), (Boundary(name, end),))
            for name, loads, end in (
                ("rising", [0, 1, 1], X),
                ("falling", [-3, -1, 1], options.get("ends", -1 - V)),
                ("away", [0, 1, 1], -X - 2),
            )
        ),
        (
            *(
                Transition("rising", {"rising"}, "away", each)
                for each in options.get("earlier", ())
            ),
            Transition("rising", {"rising"}, "falling", conditions, options.get("reset", {})),
            Transition("falling", {"falling"}, "rising"),
            Transition("away", {"away"}, "rising"),
        ),
    )  # fmt: skip
    orbit = Itinerary("orbit", system, phases)
    reason = emit_system(system, [orbit], "here").underived.get("orbit", "")
    assert reason.startswith("behind 'rising' conditions decide") is not shown

"""A mass between springs, kicked at each return, and a wall that takes it along.

The speed v at x = 0 is multiplied by r, and folded back where the mass strikes the wall: v > 1.
"""

import sympy as sp

from nonsmooth.derive import Boundary, Configuration, FirstOrder, Parameter, System, Transition

x, v = sp.symbols("x v", real=True)
stretch, kick = Parameter("r", "what the speed is multiplied by"), Parameter("c", "kick")
out = Configuration(
    "out", FirstOrder([[0, 1], [-1, 0]]), (Boundary("falls", -x), Boundary("strikes", x - 1))
)
back = Configuration("back", FirstOrder([[0, 1], [-4, 0]]), (Boundary("rises", x),))
taken = {x: x / 20, v: sp.Rational(31, 50) * v - sp.Rational(11, 10)}

system = System(
    "folded",
    "a mass between springs and a wall",
    (x, v),
    (stretch, kick),
    (out, back),
    (
        Transition("out", {"falls"}, "back"),
        Transition("out", {"strikes"}, "out", (), taken),
        Transition("back", {"rises"}, "out", (), {v: stretch.symbol * v - kick.symbol}),
    ),
)

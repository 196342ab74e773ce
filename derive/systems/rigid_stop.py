"""Coupled oscillators with a rigid stop (the paper's Secs. 2.1 and 2.3, Fig. 1).

Two masses joined by a spring k1, the second tied to the ground by a spring k2. The first
strikes a rigid stop at the clearance x1 = 1, the unit of length, by Newton's law

    x1'+ = -r x1'-

with the coefficient of restitution r, which is 1 in the paper. With r < 1 the impacts can
accumulate; then, and in the plastic case r = 0, the mass stays in contact until the stop would
have to pull it.
"""

from __future__ import annotations

import sympy as sp

from nonsmooth.derive.declaration.configuration import Boundary, Configuration, Contact
from nonsmooth.derive.declaration.dynamics import SecondOrder
from nonsmooth.derive.declaration.itinerary import Itinerary, Phase, Reference
from nonsmooth.derive.declaration.parameter import Parameter
from nonsmooth.derive.declaration.source import Source
from nonsmooth.derive.declaration.system import System
from nonsmooth.derive.declaration.transition import Condition, Transition

__all__ = [
    "CHAIN",
    "MASS",
    "MODEL",
    "PERIOD",
    "STIFFNESS",
    "free",
    "one_impact",
    "orbits",
    "reflection",
    "states",
    "system",
]

CHAIN = (
    Parameter("m1", "first mass, in the user's consistent units"),
    Parameter("m2", "second mass"),
    Parameter("k1", "stiffness of the spring between the masses"),
    Parameter("k2", "stiffness of the spring between the second mass and the ground"),
)
MODEL = (
    "Lengths are in units of the clearance, which puts the stop at $x_{1} = 1$; masses,"
    " stiffnesses and time are in any consistent units.",
)
PERIOD = Parameter("T", "period of the orbit")
_RESTITUTION = Parameter(
    "r", "coefficient of restitution, nondimensional", upper=1, closed=True, upper_closed=True
)
m1, m2, k1, k2 = (p.symbol for p in CHAIN)
r = _RESTITUTION.symbol
x1, x2, v1, v2 = states = sp.symbols("x1 x2 v1 v2", real=True)

# the motion read backwards: a symmetry of every undamped configuration
reflection = {v1: -v1, v2: -v2}

# Eq. (1)
MASS, STIFFNESS = sp.diag(m1, m2), sp.Matrix([[k1, -k1], [-k1, k1 + k2]])
free = Configuration(
    "free",
    SecondOrder(MASS, STIFFNESS),
    (Boundary("first-reaches-stop", x1 - 1),),
)

# what the stop has to carry while the mass rests on it
pressure = k1 * (x2 - x1)
contact = Configuration(
    "contact",
    SecondOrder(MASS, STIFFNESS, held={x1: 0}),
    (Boundary("first-leaves-stop", -pressure),),
    constraints=(x1 - 1,),
)
_REACHED = frozenset({"first-reaches-stop"})

system = System(
    name="rigid-stop",
    model=MODEL,
    description="two coupled oscillators, the first in front of a rigid stop (Sec. 2.1)",
    states=states,
    parameters=(*CHAIN, _RESTITUTION),
    configurations=(free, contact),
    transitions=(
        # an impact, if the mass arrives with a velocity; along the contact nothing changes it
        Transition("free", _REACHED, "free", (Condition(v1, "contact"),), {v1: -r * v1}),
        Transition("free", _REACHED, "contact", (Condition(pressure, "contact"),), {x1: 1, v1: 0}),
        Transition("free", _REACHED, "free"),
        Transition("contact", frozenset({"first-leaves-stop"}), "free"),
    ),
    contacts=(Contact("stop", v1, {"contact": -pressure}),),
)

one_impact = Itinerary(
    name="one-impact",
    system=system,
    phases=(Phase("free", "first-reaches-stop", "T"),),
    start={"x2": "y", "v1": "u", "v2": "w"},
    reversor=reflection,
    period=PERIOD,
    reference=Reference(
        parameters={"m1": "1", "m2": "2", "k1": "1", "k2": "5", "T": "2*pi"},
        guess={"y": "0.162", "u": "-0.372"},
    ),
    source=Source(
        "Pascal (2011)",
        equations={
            "configuration free": "(1)",
            "reset 1": "(2)",
            "flow free": "(3)",
            "start": "Sec. 2.3",
        },
        flows={"free": "H"},
        states=("X_{0}",),
        misprints={"(2)": "which prints $x_{1}$ without the dot of the velocity"},
    ),
)

orbits = (one_impact,)

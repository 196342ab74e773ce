"""Coupled oscillators with an elastic stop (the paper's Secs. 2.2 and 2.4, Fig. 1).

The chain of :mod:`nonsmooth.derive.systems.rigid_stop`, in front of a spring k3 that the
first mass touches at x1 = 1.
"""

from __future__ import annotations

import sympy as sp

from nonsmooth.derive.declaration.configuration import Boundary, Configuration, Contact
from nonsmooth.derive.declaration.dynamics import SecondOrder
from nonsmooth.derive.declaration.itinerary import Itinerary, Phase, Reference
from nonsmooth.derive.declaration.parameter import Parameter
from nonsmooth.derive.declaration.source import Source
from nonsmooth.derive.declaration.system import System
from nonsmooth.derive.declaration.transition import Transition
from nonsmooth.derive.systems.rigid_stop import (
    CHAIN,
    MASS,
    MODEL,
    PERIOD,
    STIFFNESS,
    free,
    reflection,
    states,
)

_STOP = Parameter("k3", "stiffness of the stop")
k3 = _STOP.symbol
x1 = states[0]

# Eq. (4)
contact = Configuration(
    "contact",
    SecondOrder(MASS, STIFFNESS + sp.diag(k3, 0), load=(k3, 0)),
    (Boundary("first-leaves-stop", 1 - x1),),
)

system = System(
    name="elastic-stop",
    model=MODEL,
    description="two coupled oscillators, the first in front of an elastic stop (Sec. 2.2)",
    states=states,
    parameters=(*CHAIN, _STOP),
    configurations=(contact, free),
    transitions=(
        Transition("contact", frozenset({"first-leaves-stop"}), "free"),
        Transition("free", frozenset({"first-reaches-stop"}), "contact"),
    ),
    contacts=(Contact("stop", states[2], {"contact": k3 * (1 - x1)}),),
)

one_contact = Itinerary(
    name="one-contact",
    system=system,
    phases=(
        Phase("contact", "first-leaves-stop", "tau"),
        Phase("free", "first-reaches-stop", "tau1"),
    ),
    start={"x2": "y", "v1": "u", "v2": "w"},
    reversor=reflection,
    period=PERIOD,
    reference=Reference(
        parameters={"m1": "1", "m2": "2", "k1": "1", "k2": "5", "k3": "1", "T": "2*pi"},
        guess={"y": "0.42", "u": "3.66", "w": "0.59", "tau": "2.12"},
    ),
    source=Source(
        "Pascal (2011)",
        equations={
            "configuration free": "(1)",
            "flow free": "(3)",
            "configuration contact": "(4)",
            "flow contact": "(5)",
            "symmetry": "Sec. 2.4",
        },
        flows={"contact": r"\tilde{H}", "free": "H"},
        states=("X_{0}",),
        misprints={
            "(4)": "which prints the last entry of the stiffness matrix as $k_{1} + k_{3}$",
            "Sec. 2.4": r"which prints $X(\tau) = (x_{0}, -x_{0})$ without the dot of the velocity",
        },
    ),
)

orbits = (one_contact,)

"""Files such as users write: a mass between two springs that is kicked, and a damped one."""

# x'' + k x = 0 for x > 0 and x'' + 4 x = 0 for x < 0; entering x > 0 multiplies v by r, adds 1.
# The orbit has v = 1/(1 - r) there, the period pi/sqrt(k) + pi/2, and the multiplier r.
KICKED = '''\
"""A mass between two springs."""

import sympy as sp

from nonsmooth.derive import (
    Boundary,
    Configuration,
    Itinerary,
    Parameter,
    Reference,
    SecondOrder,
    System,
    Transition,
)

k = Parameter("k", "stiffness on the right")
r = Parameter("r", "what is left of the velocity", upper=1)
x, v = states = sp.symbols("x v", real=True)

right = Configuration("right", SecondOrder([[1]], [[k.symbol]]), (Boundary("falls", -x),))
left = Configuration("left", SecondOrder([[1]], [[4]]), (Boundary("rises", x),))
system = System(
    "kicked",
    "a mass between two springs, kicked",
    states,
    (k, r),
    (right, left),
    (
        Transition("right", {"falls"}, "left"),
        Transition("left", {"rises"}, "right", (), {v: r.symbol * v + 1}),
    ),
)
orbits = [
    Itinerary(
        "loop",
        system,
        (("right", "falls", "ta"), ("left", "rises", "tb")),
        reference=Reference({"k": "1", "r": "0.5"}, {"v0": "1.9", "ta": "3", "tb": "1.5"}),
    )
]
'''

# the same with damping on the right, x'' + x' + k x = 0
DAMPED = (
    KICKED.replace('"kicked",\n', '"damped",\n')
    .replace("[[k.symbol]])", "[[k.symbol]], damping=[[1]])")
    .replace('"0.5"}, {"v0"', '"0.25"}, {"v0"')
)


def declare(folder, text=KICKED, name="mine.py"):
    """Write a declaration into a folder."""
    path = folder / name
    path.write_text(text, encoding="utf-8")
    return path

"""Shaw and Holmes' piecewise-linear oscillator: one elastic stop, harmonic forcing.

    x'' + 2 alpha x' + x + (k - 1) (x - gap) H(x - gap) = beta cos(w t),

H the unit step: the stiffness is 1 before the stop and k on it. Motions of the forcing's
period lose their stability by period doubling; elsewhere there are motions with one contact in
two or three periods. Forces are continuous, so that areas shrink by exp(-2 alpha T) in a time T
whatever the motion does: this is the product of an orbit's multipliers.

S. W. Shaw and P. J. Holmes, A periodically forced piecewise linear oscillator, J. Sound Vib.
90 (1983) 129-155. Nondimensional.
"""

import sympy as sp

from nonsmooth.derive import Harmonic, Itinerary, Parameter, Reference, SoftStop, oscillator

alpha, beta, gap, k, w = sp.symbols("alpha beta gap k w")

system = oscillator(
    "piecewise-stiffness",
    ["x"],
    mass=[[1]],
    stiffness=[[1]],
    damping=[[2 * alpha]],
    forcing=[Harmonic(w, cosine=[beta])],
    elements=[SoftStop("x", at=gap, stiffness=k - 1, name="stop")],
    parameters=[
        Parameter("k", "stiffness on the stop, against 1 before it", lower=1),
        Parameter("gap", "position of the stop", lower=-sp.oo),
    ],
    description="a mass in front of an elastic stop, under harmonic forcing",
)

ON, OFF = ("contact", "stop-leaves-stop"), ("free", "stop-reaches-stop")
DATA = {"alpha": "0.05", "beta": "1", "gap": "0", "k": "10"}

orbits = [
    # loses its stability by period doubling near w = 2.351
    Itinerary(
        "one-contact",
        system,
        ((*ON, "on"), (*OFF, "off")),
        reference=Reference({**DATA, "w": "2.3"}, {"on": "0.727", "off": "2.005"}),
    ),
    # what it doubles into
    Itinerary(
        "doubled",
        system,
        ((*ON, "on1"), (*OFF, "off1"), (*ON, "on2"), (*OFF, "off2")),
        reference=Reference(
            {**DATA, "w": "2.4"},
            {"on1": "0.771", "off1": "2.374", "on2": "0.731", "off2": "1.361"},
        ),
    ),
    # one contact in two periods of the forcing
    Itinerary(
        "subharmonic",
        system,
        ((*ON, "on"), (*OFF, "off")),
        reference=Reference({**DATA, "w": "3"}, {"on": "1.034", "off": "3.154"}),
    ),
]

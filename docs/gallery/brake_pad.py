"""A brake pad that lifts off its disc.

    x'' + x'/5 + x = R,    y'' + y'/5 + 4 y = A cos(W t).

The pad is pressed with N - K y, and rubs on a belt of velocity V with the coefficient mu. The
vibration y is that of a linear oscillator,

    |y| = A/sqrt((4 - W^2)^2 + (W/5)^2),

so that the pad is without load, once in each period of the forcing, where K |y| is above N: for

    (2/W) arccos(N/(K |y|)).

Then nothing drags it along. `pressed` is the orbit of a pad that never lifts: its equations have
solutions beyond too, in which the belt would push back a pad that it does not touch.

Nondimensional.
"""

import sympy as sp

from nonsmooth.derive import Friction, Harmonic, Itinerary, Reference, oscillator

mu, V, N, K, A, W = sp.symbols("mu V N K A W")
y = sp.Symbol("y")

system = oscillator(
    "brake-pad",
    ["x", "y"],
    mass=[[1, 0], [0, 1]],
    stiffness=[[1, 0], [0, 4]],
    damping=[["1/5", 0], [0, "1/5"]],
    forcing=[Harmonic(W, {"y": A})],
    elements=[Friction("x", mu, velocity=V, normal=N - K * y, name="pad")],
    description="a brake pad that lifts off its disc",
)

DATA = {"mu": "0.3", "N": "1", "K": "2", "W": "1.3"}

orbits = [
    Itinerary(
        "lifting",
        system,
        (
            ("lifted", "pad-lands", "ta"),
            ("slip", "pad-reaches-belt", "tb"),
            ("stick", "pad-breaks-forward", "tc"),
            ("slip", "pad-lifts", "td"),
        ),
        reference=Reference(
            DATA | {"A": "4", "V": "1"}, {"ta": "1.96", "tb": "1.73", "tc": "0.59", "td": "0.55"}
        ),
    ),
    Itinerary(
        "pressed",
        system,
        (("slip", "pad-reaches-belt", "tb"), ("stick", "pad-breaks-forward", "tc")),
        reference=Reference(DATA | {"A": "1.1", "V": "0.5"}, {"tb": "4.79", "tc": "0.04"}),
    ),
]

"""Two inertias that mesh with a backlash: a gear that rattles while it turns.

A motor with the torque M + A sin(w t) drives a wheel against a load, both with a viscous drag:

    x1'' + c x1' = M + A sin(w t) - f,    J x2'' + d x2' = f,

the torque of the teeth f being zero for |x1 - x2| < b, and beyond it k times what x1 - x2 exceeds
b by. The angles themselves enter nothing: a motion that is turned is a motion. So an orbit is
periodic up to a turn of both wheels: the differences come back after n periods of the forcing,
T = 2 pi n / w, and the sum of both equations over one of them gives that turn,

    x1(T) - x1(0) = x2(T) - x2(0) = M T / (c + d),

whatever the teeth do. The turn itself has the multiplier 1. No velocity jumps, so the product of
the other three is exp(-(c + d/J) T).

R. Singh, H. Xie and R. J. Comparin, Analysis of automotive neutral gear rattle,
J. Sound Vib. 131 (1989) 177-196; A. Kahraman and R. Singh, Non-linear dynamics of a spur gear
pair, J. Sound Vib. 142 (1990) 49-75. Nondimensional.
"""

import sympy as sp

from nonsmooth.derive import Harmonic, Itinerary, Reference, SoftStop, oscillator

A, J, M, b, c, d, k, w = sp.symbols("A J M b c d k w")
BACKLASH = {"x1": 1, "x2": -1}

system = oscillator(
    "backlash-gear",
    ["x1", "x2"],
    mass=[[1, 0], [0, J]],
    damping=[[c, 0], [0, d]],
    stiffness=[[0, 0], [0, 0]],
    load=[M, 0],
    forcing=[Harmonic(w, sine=[A, 0])],
    elements=[
        SoftStop(BACKLASH, at=b, stiffness=k, name="drive"),
        SoftStop(BACKLASH, at=-b, stiffness=k, side="lower", name="coast"),
    ],
    description="two inertias with a backlash, driven by a torque that pulsates",
)

DATA = {"A": "1", "J": "2", "M": "0.3", "b": "0.1", "c": "0.1", "d": "0.05", "k": "10", "w": "1"}
DRIVEN, COASTING = ("contact-free", "drive-leaves-stop"), ("free-contact", "coast-leaves-stop")
FORWARD, BACK = ("free-free", "drive-reaches-stop"), ("free-free", "coast-reaches-stop")
GUESS = (3.6557, 0.8266, 1.0323, 0.7086, 3.7716, 0.7272, 1.0341, 0.8102)

# each flank is struck twice in two periods of the forcing
orbits = [
    Itinerary(
        "rattle",
        system,
        [(*phase, f"t{n}") for n, phase in enumerate(2 * (DRIVEN, BACK, COASTING, FORWARD), 1)],
        reference=Reference(DATA, {f"t{n}": str(t) for n, t in enumerate(GUESS, 1)}),
    )
]

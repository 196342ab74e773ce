"""Den Hartog's oscillator: harmonic forcing and Coulomb friction.

    x'' + x = cos(W t + phase) - S sgn x'

without stops or sticking. The motion without rest has, with R = 1/(1 - W^2) and
U = tan(pi/(2 W))/W, the amplitude

    sqrt(R^2 - S^2 U^2).

At W = 1/2 the friction does not change the amplitude: U = 0, and with S = 0.2 it is 4/3. There
the free motion comes back in half a period of the forcing, so that only the two turning points
deform a neighbourhood of the orbit. Let M be the map over one period of the forcing, of (x, x')
(or the map of the section x' = 0, of x and the phase). At a turning point the acceleration
jumps from -(4/3 - 1) - S to -(4/3 - 1) + S, by the factor a = 1/4, and M has the multipliers 1
and a^2 = 1/16: shifted along x the orbit is one again. Over half a period, followed by the
reflection (x, v) -> (-x, -v), they are -1 and -1/4: among the symmetric orbits it is alone, so
that it is solved by its half.

J. P. Den Hartog, Forced vibrations with combined Coulomb and viscous friction, Trans. ASME 53
(1931) 107-115. Nondimensional.
"""

import sympy as sp

from nonsmooth.derive import Friction, Harmonic, Itinerary, Reference, oscillator

S, W = sp.symbols("S W")

system = oscillator(
    "den-hartog",
    ["x"],
    mass=[[1]],
    stiffness=[[1]],
    forcing=[Harmonic(W, cosine=[1])],
    elements=[Friction("x", S, name="ground")],
    description="Coulomb friction under harmonic forcing",
)

# x' < 0 is `slip`, x' > 0 is `overshoot`; this orbit is symmetric
orbits = [
    Itinerary(
        "without-rest",
        system,
        (("slip", "ground-reaches-belt", "down"), ("overshoot", "ground-reaches-belt", "up")),
        reference=Reference(
            {"S": "0.2", "W": "0.6"},
            {"down": "5.2", "up": "5.2", "x0": "1.5", "v0": "0"},
        ),
    )
]

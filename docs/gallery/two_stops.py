"""A mass that strikes two stops in turn under harmonic forcing: an impact damper, a rattle.

    x'' + x = cos(w t)  for |x| < d,    v+ = -r v-  at x = d and x = -d.

The system is symmetric under (x, v, t) -> (-x, -v, t + pi/w). A symmetric orbit is known by
its first half, T = pi n / w, n odd. With C = tan(T/2), the impact velocity U solves

    ((1 + r) C U / 2 - d)^2 + ((1 - r) U / (2 w))^2 = g^2,    g = 1/(1 - w^2).

Half of the orbit, followed by the reflection, is a map of the determinant r^2 and the trace

    2 r cos T + (1 + r) sin T (cos(phase) + d) / U,    g cos(phase) = (1 + r) C U / 2 - d.

The multipliers of the whole orbit are its squares: they are never -1 but by accident. Where the
half map has the multiplier -1 the whole has 1: the symmetric orbit loses its stability to two
orbits that are images of each other (a pitchfork), at

    d / U = -((1 - w^2)(1 + r) C / 2 + (1 + r^2 + 2 r cos T)/((1 + r) sin T)) / w^2.

S. W. Shaw, The dynamics of a harmonically excited system having rigid amplitude constraints,
J. Appl. Mech. 52 (1985) 453-464. Nondimensional.
"""

import sympy as sp

from nonsmooth.derive import Harmonic, Itinerary, Reference, RigidStop, oscillator

d, r, w = sp.symbols("d r w")

system = oscillator(
    "two-stops",
    ["x"],
    mass=[[1]],
    stiffness=[[1]],
    forcing=[Harmonic(w, cosine=[1])],
    elements=[
        RigidStop("x", at=d, restitution=r, name="right"),
        RigidStop("x", at=-d, restitution=r, side="lower", name="left"),
    ],
    description="a mass between two rigid stops, under harmonic forcing",
)

RIGHT, LEFT = ("free-free", "right-reaches-stop"), ("free-free", "left-reaches-stop")

orbits = [
    Itinerary(
        "symmetric",
        system,
        ((*RIGHT, "ta"), (*LEFT, "tb")),
        reference=Reference({"d": "0.6", "r": "0.8", "w": "1.5"}, {"ta": "2.094", "tb": "2.094"}),
    ),
    # one of two; the other has the dwell times exchanged
    Itinerary(
        "broken",
        system,
        ((*RIGHT, "ta"), (*LEFT, "tb")),
        reference=Reference({"d": "0.5", "r": "0.8", "w": "1.5"}, {"ta": "1.555", "tb": "2.634"}),
    ),
]

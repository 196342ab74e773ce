"""A mass that strikes a stop under harmonic forcing.

The stop is rigid, of restitution r:

    x'' + x = cos(w t)  for x < sigma,    v+ = -r v-  at x = sigma.

An orbit that strikes once in n periods of the forcing, T = 2 pi n / w, has an impact velocity
U in closed form. Between impacts x = A cos t + B sin t + g cos(w t + phase), g = 1/(1 - w^2),
and closing the orbit gives B = -(1 + r) U / 2, A = B C with C = cot(T/2), and

    (sigma + (1 + r) C U / 2)^2 + ((1 - r) U / (2 w))^2 = g^2,

two orbits, or none. On the section of the impact the map has the determinant r^2 and the trace

    -2 r cos T + (1 + r) sin T (cos(phase) - sigma) / U.

The two orbits meet in a fold, where a multiplier is 1 (the trace is 1 + r^2), at

    sigma = g sqrt(1 + (w C (1 + r)/(1 - r))^2)  or minus that,

and an orbit doubles its period, where one is -1 (the trace is -1 - r^2), at

    sigma / U = ((1 - w^2)(1 + r) C / 2 + (1 + r^2 - 2 r cos T)/((1 + r) sin T)) / w^2.

C. Budd and F. Dux, Chattering and related behaviour in impact oscillators,
Phil. Trans. R. Soc. Lond. A 347 (1994); S. W. Shaw and P. J. Holmes, A periodically forced
piecewise linear oscillator, J. Sound Vib. 90 (1983). Nondimensional.
"""

import sympy as sp

from nonsmooth.derive import Harmonic, Itinerary, Parameter, Reference, RigidStop, oscillator

r, sigma, w = sp.symbols("r sigma w")

system = oscillator(
    "impact-oscillator",
    ["x"],
    mass=[[1]],
    stiffness=[[1]],
    forcing=[Harmonic(w, cosine=[1])],
    elements=[RigidStop("x", at=sigma, restitution=r, name="wall")],
    parameters=[
        Parameter("sigma", "position of the stop", lower=-sp.oo),
        Parameter("w", "frequency of the forcing"),
    ],
    description="a mass in front of a rigid stop, under harmonic forcing",
)

IMPACT = (("free", "wall-reaches-stop", "T"),)

# each strikes once in as many periods of the forcing as its name says
orbits = [
    Itinerary(
        name,
        system,
        IMPACT,
        reference=Reference({"r": "0.8", "sigma": "0", "w": frequency}, {"T": period}),
    )
    for name, frequency, period in (
        ("one-period", "2.4", "2.618"),
        ("two-periods", "4.4", "2.856"),
        ("three-periods", "6.4", "2.945"),
    )
]

"""A Jenkins element under harmonic forcing: bilinear hysteresis.

    x'' + 2 zeta x' + x + f = F cos(w t),

where f is the force of a spring of stiffness k in series with a slider that yields at `limit`:
f = k (x - s) while the slider is stuck at s, else f = limit or -limit as it is dragged along.
This models a joint with friction. In the steady motion the slider yields on each way,
and takes from each cycle of amplitude X the area of its loop

    4 limit (X - limit / k).

T. K. Caughey, Sinusoidal excitation of a system with bilinear hysteresis, J. Appl. Mech. 27
(1960) 640-643; L. Gaul and R. Nitsche, The role of friction in mechanical joints, Appl. Mech.
Rev. 54 (2001) 93-106. Nondimensional.
"""

import sympy as sp

from nonsmooth.derive import Harmonic, Itinerary, Reference, Slider, oscillator

F, k, limit, w, zeta = sp.symbols("F k limit w zeta")

system = oscillator(
    "jenkins",
    ["x"],
    mass=[[1]],
    stiffness=[[1]],
    damping=[[2 * zeta]],
    forcing=[Harmonic(w, cosine=[F])],
    elements=[Slider("x", stiffness=k, limit=limit, name="joint")],
    description="bilinear hysteresis under harmonic forcing",
)

orbits = [
    Itinerary(
        "yielding-both-ways",
        system,
        (
            ("stuck", "joint-slides-forward", "ta"),
            ("forward", "joint-turns", "tb"),
            ("stuck", "joint-slides-backward", "tc"),
            ("backward", "joint-turns", "td"),
        ),
        reference=Reference(
            {"F": "0.6", "k": "3", "limit": "0.2", "w": "0.9", "zeta": "0.05"},
            {"ta": "0.4", "tb": "3.09", "tc": "0.4", "td": "3.09"},
        ),
    )
]

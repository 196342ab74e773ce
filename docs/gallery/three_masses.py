"""Three masses in a row between two rigid stops, the middle one forced.

    M x'' + C x' + K x = (0, F cos(w t), 0),    x1 < d,  x3 > -d,

with unit masses and springs, a damper of `zeta` beside each spring, both ends tied to the
ground, and restitution r at both stops. Eight states: the orbit is composed from numeric modes,
and no matrix has to be exponentiated by hand.

To find an itinerary, follow a motion and let it tell (`nonsmooth.itinerary_of`), or search
(`nonsmooth.find_orbits`, `nonsmooth find`): the one below, of two impacts at each stop, was
found so. It is symmetric under (x1, x2, x3) -> (-x3, -x2, -x1). Nondimensional.
"""

import sympy as sp

from nonsmooth.derive import (
    Harmonic,
    Itinerary,
    Reference,
    RigidStop,
    chain_matrices,
    oscillator,
)

F, d, r, w, zeta = sp.symbols("F d r w zeta")
mass, stiffness, damping = chain_matrices([1, 1, 1], [1] * 4, [zeta] * 4, fixed="both")

system = oscillator(
    "three-masses",
    ["x1", "x2", "x3"],
    mass,
    stiffness,
    damping,
    forcing=[Harmonic(w, cosine={"x2": F})],
    elements=[
        RigidStop("x1", at=d, restitution=r, name="right"),
        RigidStop("x3", at=-d, restitution=r, side="lower", name="left"),
    ],
    description="three masses in a row between two stops",
)

orbits = [
    Itinerary(
        "two-each",
        system,
        (
            ("free-free", "right-reaches-stop", "ta"),
            ("free-free", "left-reaches-stop", "tb"),
            ("free-free", "left-reaches-stop", "tc"),
            ("free-free", "right-reaches-stop", "td"),
        ),
        reference=Reference(
            {"F": "1", "d": "0.4", "r": "0.8", "w": "0.9", "zeta": "0.05"},
            {"ta": "1.7", "tb": "1.79", "tc": "1.7", "td": "1.79"},
        ),
    )
]

"""A cantilever of finite elements, forced at its tip, which meets an elastic stop behind a gap.

Twenty Euler-Bernoulli elements of unit length, stiffness and mass give 40 coordinates: deflection
and slope of each node. By Craig and Bampton (1968) the deflection of the tip stays as it is, and
beside it the first mode of the beam whose tip is held. The stop and the force act at the tip.
Damping is 0.2 M + 0.002 K. Nondimensional.
"""

import numpy as np
import sympy as sp

from nonsmooth.derive import Harmonic, Itinerary, Reference, SoftStop, oscillator, reduce_structure

elements = 20
h = 1 / elements
bending = np.array(
    [[12, 6 * h, -12, 6 * h], [6 * h, 4 * h * h, -6 * h, 2 * h * h],
     [-12, -6 * h, 12, -6 * h], [6 * h, 2 * h * h, -6 * h, 4 * h * h]]
) / h**3  # fmt: skip
inertia = np.array(
    [[156, 22 * h, 54, -13 * h], [22 * h, 4 * h * h, 13 * h, -3 * h * h],
     [54, 13 * h, 156, -22 * h], [-13 * h, -3 * h * h, -22 * h, 4 * h * h]]
) * h / 420  # fmt: skip

stiffness, mass = np.zeros((2, 2 * elements + 2, 2 * elements + 2))
for first in range(0, 2 * elements, 2):
    here = slice(first, first + 4)
    stiffness[here, here] += bending
    mass[here, here] += inertia
stiffness, mass = stiffness[2:, 2:], mass[2:, 2:]  # clamped on the left
names = [f"{what}{node}" for node in range(1, elements + 1) for what in ("y", "slope")]

tip = f"y{elements}"
reduced = reduce_structure(
    mass, stiffness, 0.2 * mass + 0.002 * stiffness, keep=[tip], modes=1, coordinates=names
)

F, gap, k, w = sp.symbols("F gap k w")
system = oscillator(
    "beam",
    reduced.coordinates,
    reduced.mass,
    reduced.stiffness,
    reduced.damping,
    forcing=[Harmonic(w, cosine={tip: F})],
    elements=[SoftStop(tip, at=gap, stiffness=k, name="stop")],
    description="a beam of finite elements with a gap at its tip",
)

orbits = [
    Itinerary(
        "one-contact",
        system,
        (("contact", "stop-leaves-stop", "on"), ("free", "stop-reaches-stop", "off")),
        reference=Reference(
            {"F": "1/2", "gap": "1/50", "k": "20", "w": "7.3"}, {"on": "0.2418", "off": "0.6189"}
        ),
    )
]

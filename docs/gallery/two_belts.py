"""Two masses joined by a spring, each on a belt of its own.

    x1'' + x1 + chi (x1 - x2) = R1,    x2'' + chi (x2 - x1) + x2 = R2.

The belts run at V1 and V2. A mass that slips feels the friction u_i towards the velocity of
its belt; one that sticks is held by up to s_i >= u_i. Self-excited stick-slip of coupled
blocks, as in models of brakes, chatter and faults; with one belt under both masses it is
close to the built-in `dry-friction`.

U. Galvanetto, S. R. Bishop and L. Briseghella, Mechanical stick-slip vibrations, Int. J.
Bifurcation and Chaos 5 (1995) 637-651, has two blocks on one belt. Nondimensional.
"""

import sympy as sp

from nonsmooth.derive import Friction, Itinerary, Reference, chain_matrices, oscillator

chi, u1, s1, V1, u2, s2, V2 = sp.symbols("chi u1 s1 V1 u2 s2 V2")
mass, stiffness, _ = chain_matrices([1, 1], [1, chi, 1], fixed="both")

system = oscillator(
    "two-belts",
    ["x1", "x2"],
    mass,
    stiffness,
    elements=[
        Friction("x1", u1, s1, velocity=V1, name="first"),
        Friction("x2", u2, s2, velocity=V2, name="second"),
    ],
    description="two coupled masses, each on a belt of its own",
)

DATA = {"chi": "0.5", "u1": "0.5", "s1": "1", "V1": "0.5", "u2": "0.4", "s2": "1.2", "V2": "0.3"}

orbits = [
    Itinerary(
        "both-stick",
        system,
        (
            ("slip-slip", "first-reaches-belt", "ta"),
            ("stick-slip", "first-breaks-forward", "tb"),
            ("slip-slip", "second-reaches-belt", "tc"),
            ("slip-stick", "second-breaks-forward", "td"),
        ),
        reference=Reference(DATA, {"ta": "0.256", "tb": "1.434", "tc": "1.372", "td": "1.958"}),
    ),
    # the first mass moves, and never comes to its belt
    Itinerary(
        "second-sticks",
        system,
        (
            ("slip-slip", "second-reaches-belt", "ta"),
            ("slip-stick", "second-breaks-forward", "tb"),
        ),
        reference=Reference(DATA, {"ta": "3.394", "tb": "4.309"}),
    ),
]

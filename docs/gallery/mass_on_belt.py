"""One mass on a driving belt: the plainest stick-slip.

    x'' + x = R,    the belt runs at V.

While it slips, x' < V, the friction is u; it sticks until the spring asks for u + e. Then it
slips from x = u + e along the circle about x = u until its velocity is V again, at x = u - e:
pi - 2 atan(e/V) of a half turn and pi of the other. The time it then sticks is 2 e/V, and so the
period is

    2 pi - 2 atan(e/V) + 2 e/V.

The end of a stick phase is one point of the section, hence the multiplier is zero: any motion
that sticks once is on the orbit from then on.

J. P. Den Hartog, Mechanical Vibrations, 4th ed. (McGraw-Hill, 1956), ch. VII. Nondimensional.
"""

import sympy as sp

from nonsmooth.derive import Friction, Itinerary, Reference, oscillator

u, e, V = sp.symbols("u e V")

system = oscillator(
    "mass-on-belt",
    ["x"],
    mass=[[1]],
    stiffness=[[1]],
    elements=[Friction("x", kinetic=u, static=u + e, velocity=V, name="belt")],
    description="one mass on a driving belt",
)

orbits = [
    Itinerary(
        "stick-slip",
        system,
        (("stick", "belt-breaks-forward", "ts"), ("slip", "belt-reaches-belt", "tau")),
        reference=Reference(
            {"u": "1", "e": "0.3", "V": "0.5"}, {"ts": "1.2", "tau": "5.2", "x0": "0.7"}
        ),
    )
]

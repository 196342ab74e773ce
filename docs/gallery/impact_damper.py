"""An impact damper: a small mass between two stops on a vibrating one.

    x'' + 2 zeta x' + x = cos(w t + phase),   y'' = 0 between impacts,   |y - x| <= d,

the small mass has the part mu of the large one, and impacts have the restitution r. Near the
resonance of the large mass the small one strikes each stop once in a period of the forcing and
takes energy out of it. Nondimensional.

S. F. Masri, Theory of the dynamic vibration neutralizer with motion-limiting stops, J. Appl.
Mech. 39 (1972) 563-568.
"""

import sympy as sp

from nonsmooth.derive import Harmonic, Itinerary, Reference, RigidStop, oscillator

d, mu, r, w, zeta = sp.symbols("d mu r w zeta")
apart = {"y": 1, "x": -1}

system = oscillator(
    "impact-damper",
    ["x", "y"],
    mass=[[1, 0], [0, mu]],
    damping=[[2 * zeta, 0], [0, 0]],
    stiffness=[[1, 0], [0, 0]],
    forcing=[Harmonic(w, cosine={"x": 1})],
    elements=[
        RigidStop(apart, at=d, restitution=r, name="right"),
        RigidStop(apart, at=-d, restitution=r, side="lower", name="left"),
    ],
    description="an impact damper under harmonic forcing",
)

orbits = [
    Itinerary(
        "struck-twice",
        system,
        (
            ("free-free", "right-reaches-stop", "over"),
            ("free-free", "left-reaches-stop", "back"),
        ),
        reference=Reference(
            {"d": 10, "mu": "0.1", "r": "0.6", "w": 1, "zeta": "0.01"},
            {
                "over": "3.1415926535897932",
                "back": "3.1415926535897932",
                "x0": "-1.8149513183376",
                "y0": "-11.8149513183376",
                "v0": "1.31628553329248",
                "v_y0": "7.52163161881414",
                "c10": "0.99915556070496",
                "s10": "-0.04108729137287",
            },
        ),
    )
]

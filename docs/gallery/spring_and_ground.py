"""A weight on a spring above the ground.

    m x'' + k x = -m gravity  for x > 0,    v+ = -e v-  at x = 0.

Without impacts x + d = (q0 + d) cos(w t) from rest at q0, with w = sqrt(k / m) and the static
deflection d = m gravity / k. The first impact is at t = acos(d / (q0 + d)) / w, with the
velocity -w sqrt(q0 (q0 + 2 d)).

The data m = 1e-3, k = 100, gravity = 9.81, q0 = 1, e = 0.9 are those of `LinearOscillatorED` of
Siconos (https://nonsmooth.gricad-pages.univ-grenoble-alpes.fr/siconos), an example of event-driven
integration: t = 4.966983943888618e-03 and v = -3.162587864392096e+02. SI units.
"""

import sympy as sp

from nonsmooth.derive import RigidStop, oscillator

m, k, gravity, e = sp.symbols("m k gravity e")

system = oscillator(
    "spring-and-ground",
    ["x"],
    mass=[[m]],
    stiffness=[[k]],
    load=[-m * gravity],
    elements=[RigidStop("x", at=0, restitution=e, side="lower", name="ground")],
    description="a weight on a spring above the ground",
)

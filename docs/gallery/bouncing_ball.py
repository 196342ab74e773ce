"""A ball that bounces on the ground, and comes to rest after infinitely many impacts.

    x'' = -gravity  for x > 0,    v+ = -r v-  at x = 0.

Dropped from the height h it first strikes after t1 = sqrt(2 h / gravity). Each bounce lasts r
times as long as the one before, the first of them 2 r t1, and so they are over at

    t1 (1 + 2 r / (1 - r)),

from when on the ball lies on the ground (configuration `contact`).

B. Brogliato, Nonsmooth Mechanics, 3rd ed. (Springer, 2016). Any consistent units.
"""

import sympy as sp

from nonsmooth.derive import RigidStop, oscillator

gravity, r = sp.symbols("gravity r")

system = oscillator(
    "bouncing-ball",
    ["x"],
    mass=[[1]],
    stiffness=[[0]],
    load=[-gravity],
    elements=[RigidStop("x", at=0, restitution=r, side="lower", name="ground")],
    description="a ball that bounces on the ground",
)

"""A mass on a spring that pushes outwards, between two rigid stops, under harmonic forcing."""

import sympy as sp

from nonsmooth.derive import Harmonic, Parameter, RigidStop, oscillator

r, a, w = sp.symbols("r a w", positive=True)

system = oscillator(
    "inverted-oscillator",
    ["x"],
    mass=[[1]],
    stiffness=[[-1]],
    forcing=[Harmonic(w, cosine=[a])],
    elements=[
        RigidStop("x", at=1, restitution=r, name="right"),
        RigidStop("x", at=-1, restitution=r, side="lower", name="left"),
    ],
    parameters=[Parameter("a", "amplitude"), Parameter("w", "frequency")],
)

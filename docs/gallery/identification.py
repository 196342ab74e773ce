"""A mass that strikes a stop, whose stiffness and restitution are to be found from its impacts.

A mass between a spring and a rigid stop is shaken:

    x'' + c x' + k x = cos(w t)  for x < h,    v+ = -r v-  at x = h.

What is often recorded of such a machine are the impacts alone, by a microphone: their times, with
an error. Damping, frequency and the place of the stop are known; k and r are sought, and the
velocity at which the mass was let go. The times depend on all three, and on none of them alone.
Undamped and unforced the time of the first impact is in closed form: from rest at x0 < -h it is

    t1 = arccos(h / x0) / sqrt(k),

and dt1/dk = -t1 / (2 k), which the derivatives behind the fit give to rounding.

C. Budd and F. Dux, Chattering and related behaviour in impact oscillators,
Phil. Trans. R. Soc. Lond. A 347 (1994); G. A. F. Seber and C. J. Wild, Nonlinear Regression
(1989). Nondimensional.
"""

import sympy as sp

from nonsmooth.derive import Harmonic, Parameter, RigidStop, oscillator

c, h, k, r, w = sp.symbols("c h k r w")

system = oscillator(
    "identification",
    ["x"],
    mass=[[1]],
    damping=[[c]],
    stiffness=[[k]],
    forcing=[Harmonic(w, cosine=[1])],
    elements=[RigidStop("x", at=h, restitution=r, name="wall")],
    parameters=[
        Parameter("c", "damping", closed=True),
        Parameter("h", "position of the stop"),
        Parameter("k", "stiffness"),
        Parameter("r", "restitution", upper=1, upper_closed=True),
        Parameter("w", "frequency of the forcing"),
    ],
    description="a shaken mass in front of a rigid stop, of unknown stiffness and restitution",
)

"""An oscillator that is damped at high speed and driven at low speed.

    x'' + 2 zeta (x' - 1) + x = 0,    zeta = damped for x' > 1, driven < 0 for x' < 1.

The forces agree at x' = 1, so that motions cross the plane. They grow at low speed, lose at
high speed, and settle on one limit cycle. With damped = 0.3 and driven = -0.1 it reaches
2.150651224 above the equilibrium x = 2 driven; its period is 6.367077, its multiplier
0.538924872, which is the exponential of minus the damping along it.

A van der Pol oscillator in two pieces; see A. A. Andronov, A. A. Vitt and S. E. Khaikin,
Theory of Oscillators (Pergamon, 1966), ch. VIII. Nondimensional.
"""

import sympy as sp

from nonsmooth.derive import Itinerary, Reference, Regions, Terms, oscillator

v, damped = sp.symbols("v damped")
driven = sp.Symbol("driven", negative=True)


def towards_one(zeta: sp.Symbol) -> Terms:
    """The terms 2 zeta (x' - 1)."""
    return Terms(damping=[[2 * zeta]], load=[2 * zeta])


system = oscillator(
    "switched-damping",
    ["x"],
    mass=[[1]],
    stiffness=[[1]],
    elements=[Regions(v - 1, below=towards_one(driven), above=towards_one(damped), name="speed")],
    description="an oscillator driven at low speed and damped at high speed",
)

orbits = [
    Itinerary(
        "limit-cycle",
        system,
        (("above", "speed-falls", "fast"), ("below", "speed-rises", "slow")),
        reference=Reference(
            {"damped": "0.3", "driven": "-0.1"}, {"fast": "2", "slow": "4.4", "x0": "-2", "v0": "1"}
        ),
    )
]

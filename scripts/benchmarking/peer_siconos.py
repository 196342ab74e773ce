"""Simulate with Siconos what `benchmark.py peers` asks for: run by the Python that has Siconos.

Reads one question as JSON from its input: `masses` and `stiffness` (n, n), `position` and
`velocity` at the start, `weight` (n,), a stop at 0 under the first coordinate with `restitution`,
the time-stepping scheme's `step` and `theta`, and `until`. Writes seconds, and for each step time,
position, velocity and impulse at the stop, and the energy, as JSON. Matrices are dense: Debian's
package 4.4 ends the process when a sparse one is made in Python.
"""

import json
import sys
import time

import numpy as np
from siconos.kernel import (
    LCP,
    Interaction,
    LagrangianLinearTIDS,
    LagrangianLinearTIR,
    MoreauJeanOSI,
    NewtonImpactNSL,
    NonSmoothDynamicalSystem,
    TimeDiscretisation,
    TimeStepping,
)


def main() -> None:
    asked = json.load(sys.stdin)
    mass, stiffness = np.array(asked["masses"]), np.array(asked["stiffness"])
    begin = time.perf_counter()
    body = LagrangianLinearTIDS(np.array(asked["position"]), np.array(asked["velocity"]), mass)
    body.setKPtr(stiffness)
    weight = np.array(asked["weight"])
    body.setFExtPtr(weight)
    contact = Interaction(
        NewtonImpactNSL(asked["restitution"]), LagrangianLinearTIR(np.eye(1, len(mass)))
    )
    model = NonSmoothDynamicalSystem(0.0, asked["until"])
    model.insertDynamicalSystem(body)
    model.link(contact, body)
    steps = TimeDiscretisation(0.0, asked["step"])
    simulation = TimeStepping(model, steps, MoreauJeanOSI(asked["theta"]), LCP())
    position, velocity, impulse = body.q(), body.velocity(), contact.lambda_(1)
    rows = []
    while simulation.hasNextEvent():
        simulation.computeOneStep()
        rows.append((simulation.nextTime(), position[0], velocity[0], impulse[0]))
        simulation.nextStep()
    seconds = time.perf_counter() - begin
    kinetic = velocity @ mass @ velocity / 2
    energy = kinetic + position @ stiffness @ position / 2 - weight @ position
    print(json.dumps({"seconds": seconds, "rows": rows, "energy": energy}))


if __name__ == "__main__":
    main()

"""Simulated motions as JSON: numbers are decimal strings that give back the same doubles."""

from __future__ import annotations

from typing import Any

from nonsmooth.runtime.sweep import Sweep
from nonsmooth.runtime.trajectory import Trajectory

__all__ = ["motion_json", "sweep_json"]


def motion_json(motion: Trajectory) -> dict[str, Any]:
    """A motion: one entry for the start and one behind each transition.

    States are physical: positions, then velocities, in the order of `names`.
    """
    shapes = motion.structure.boundaries
    return {
        "system": motion.name,
        "parameters": {name: value.text for name, value in motion.parameters.items()},
        "names": list(motion.names),
        "times": [repr(t) for t in motion.times.tolist()],
        "configurations": list(motion.configurations),
        "boundaries": [list(names) for names in motion.boundaries],
        "states": [[repr(x) for x in row] for row in motion.states.tolist()],
        "transitions": motion.transitions,
        "end": repr(motion.end),
        "status": motion.status.name.lower(),
        "message": motion.message,
        "grazings": [
            {
                "time": repr(g.time),
                "configuration": motion.structure.configurations[g.configuration],
                "boundary": shapes[g.configuration][g.boundary].name,
                "depth": repr(g.depth),
            }
            for g in motion.grazings
        ],
    }


def sweep_json(diagram: Sweep) -> dict[str, Any]:
    """A bifurcation diagram: for each value of the parameter the points that were taken."""
    rows = zip(diagram.values.tolist(), diagram.samples.tolist(), strict=True)
    return {
        "system": diagram.system,
        "parameter": diagram.parameter,
        "state": diagram.state,
        "configuration": diagram.configuration,
        "values": [repr(value) for value in diagram.values.tolist()],
        "samples": [[repr(x) for x in row if x == x] for _, row in rows],
    }

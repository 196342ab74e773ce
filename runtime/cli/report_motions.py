"""Simulated motions as JSON: numbers are decimal strings that give back the same doubles."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.explore.finding.outcomes import settled_texts
from nonsmooth.runtime.explore.finding.sweep import Sweep
from nonsmooth.runtime.proof.motion.motion_proof import Proof
from nonsmooth.runtime.simulation.derivatives import MotionDerivatives
from nonsmooth.runtime.simulation.extremes import Extreme
from nonsmooth.runtime.simulation.lyapunov import Exponent, lyapunov
from nonsmooth.runtime.simulation.observables import Observables
from nonsmooth.runtime.simulation.trajectory import Trajectory

__all__ = ["derivatives_json", "motion_json", "observables_json", "proof_json", "sweep_json"]


def motion_json(motion: Trajectory) -> dict[str, Any]:
    """A motion as JSON: one entry for the start and one behind each transition.

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
        "options": list(motion.options),
        "open_at": list(motion.open_at),
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


def derivatives_json(found: MotionDerivatives) -> dict[str, Any]:
    """Derivatives of a motion as JSON, in the shapes of the arrays of `found`.

    For each transition and state there is one number by each of `by`. The time of a
    transition that has no derivative gets nan.
    """

    def texts(values: np.ndarray) -> Any:
        return [texts(part) for part in values] if values.ndim else repr(float(values))

    return {
        "by": list(found.by),
        "event_times": texts(found.event_times),
        "before": texts(found.before),
        "behind": texts(found.behind),
        "condition": repr(found.condition),
    }


def sweep_json(diagram: Sweep) -> dict[str, Any]:
    """A bifurcation diagram as JSON: for each value of the parameter the sampled points."""
    rows = zip(diagram.values.tolist(), diagram.samples.tolist(), strict=True)
    texts = settled_texts()
    return {
        "system": diagram.system,
        "parameter": diagram.parameter,
        "state": diagram.state,
        "configuration": diagram.configuration,
        "phase": None if diagram.phase is None else repr(diagram.phase),
        "values": [repr(value) for value in diagram.values.tolist()],
        "samples": [[repr(x) for x in row if x == x] for _, row in rows],
        "outcomes": [
            texts[number] if place < diagram.done else None  # an interrupted one has not looked
            for place, number in enumerate(diagram.outcomes.tolist())
        ],
    }


def observables_json(found: Observables) -> dict[str, Any]:
    """Extremes, averages, shares of time, contacts and largest Lyapunov exponent as JSON."""

    def numbers(values: Mapping[str, float]) -> dict[str, str]:
        return {name: repr(float(value)) for name, value in values.items()}

    return {
        "since": repr(found.since),
        "duration": repr(found.duration),
        "minima": {name: _extreme_json(e) for name, e in found.minima.items()},
        "maxima": {name: _extreme_json(e) for name, e in found.maxima.items()},
        "means": numbers(found.means),
        "rms": numbers(found.rms),
        "fractions": numbers(found.fractions),
        "sticking": numbers(found.sticking),
        "contacts": {
            name: {
                "minimum": _extreme_json(contact.minimum),
                "maximum": _extreme_json(contact.maximum),
                "mean": repr(contact.mean),
                "work": repr(contact.work),
                "dissipated": repr(contact.dissipated),
            }
            for name, contact in found.contacts.items()
        },
        **_exponent_json(largest_exponent(found)),
    }


def largest_exponent(found: Observables) -> Exponent | str:
    """The largest Lyapunov exponent per unit of time, or the reason why there is none."""
    try:
        return lyapunov(found.trajectory, found.since)
    except InputError as problem:
        return str(problem)


def _exponent_json(found: Exponent | str) -> dict[str, str | None]:
    if isinstance(found, str):
        return {"lyapunov": None, "lyapunov_error": None}
    return {"lyapunov": repr(found.value), "lyapunov_error": repr(found.error)}


def proof_json(proof: Proof) -> dict[str, Any]:
    """What is proved of a motion, as JSON: its sequence, with enclosures of the times."""
    instant = proof.instant
    return {
        "decided": proof.decided,
        "transitions": proof.transitions,
        "configurations": list(proof.configurations),
        "boundaries": [list(names) for names in proof.sets],
        "times": [time.to_json() for time in proof.times],
        "reason": proof.reason,
        "instant": instant and instant.to_json(),
        "bits": proof.bits,
    }


def _extreme_json(extreme: Extreme) -> dict[str, str]:
    return {"value": repr(extreme.value), "time": repr(extreme.time)}

"""Results as JSON; numbers are decimal strings of the same doubles, and null if unknown."""

from __future__ import annotations

from collections.abc import Mapping
from functools import singledispatch
from types import MappingProxyType
from typing import Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.json_codec import answer, encode, nan_as_null
from nonsmooth.runtime.explore.continuation.branch import Branch, Locus
from nonsmooth.runtime.explore.design.optimum import Design
from nonsmooth.runtime.explore.finding.find import Found, FoundEquilibrium, FoundOrbit
from nonsmooth.runtime.explore.finding.outcomes import settled_texts
from nonsmooth.runtime.explore.finding.sweep import Sweep
from nonsmooth.runtime.explore.fitting.fit import Fit
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.present.report import orbit_json
from nonsmooth.runtime.proof.motion.motion_proof import Proof
from nonsmooth.runtime.simulation.derivatives import MotionDerivatives
from nonsmooth.runtime.simulation.lyapunov import Exponent, lyapunov
from nonsmooth.runtime.simulation.observables import Observables
from nonsmooth.runtime.simulation.phase_functions import Extreme
from nonsmooth.runtime.simulation.trajectory import Trajectory

__all__ = [
    "Others",
    "branch_json",
    "largest_exponent",
    "motion_derivatives_json",
    "observables_json",
    "proof_json",
    "result_json",
]

Others = Mapping[int, list[dict[str, Any]]]  # itineraries beyond events, by the events' numbers


@singledispatch
def result_json(result: Any) -> dict[str, Any]:
    """A result as JSON: what its own function below writes, else what its record holds."""
    return answer(result)


@result_json.register
def _motion_json(motion: Trajectory) -> dict[str, Any]:
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


def motion_derivatives_json(found: MotionDerivatives) -> dict[str, Any]:
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


@result_json.register
def _sweep_json(diagram: Sweep) -> dict[str, Any]:
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


@result_json.register
def branch_json(branch: Branch, others: Others = MappingProxyType({})) -> dict[str, Any]:
    """A branch as JSON; `others` holds itineraries beyond events, by the events' indices."""
    return {
        "orbit": branch.name,
        "parameter": branch.parameter,
        "values": _finite(branch.parameter_values),
        "unknowns": {name: _finite(branch.quantity(name)) for name in branch.unknown_names},
        "period": _finite(branch.period),
        "trace": _finite(branch.trace),
        "stability": list(branch.stability),
        "admissible": branch.admissible.tolist(),
        "ends": list(branch.ends),
        "events": [
            {
                "kind": event.kind,
                "value": event.value,
                "phase": None if event.phase is None else event.phase + 1,
                "configuration": event.configuration,
                "boundary": event.boundary,
                "touching": event.touching,
                "time": event.time,
                "unknowns": dict(event.unknowns),
                **({"beyond": others[number]} if number in others else {}),
            }
            for number, event in enumerate(branch.events)
        ],
    }


@result_json.register
def _locus_json(locus: Locus) -> dict[str, Any]:
    """A curve of events as JSON."""
    return {
        "orbit": locus.name,
        "kind": locus.kind,
        "boundary": locus.boundary,
        "parameters": list(locus.parameters),
        "values": locus.values.tolist(),
        "unknowns": {
            name: locus.unknowns[:, place].tolist()
            for place, name in enumerate(locus.unknown_names)
        },
        "ends": list(locus.ends),
    }


def _finite(values: Any) -> list[float | None]:
    return [x if abs(x) < float("inf") else None for x in values.tolist()]


@result_json.register
def _design_json(design: Design) -> dict[str, Any]:
    """A design as JSON, without its orbits' files.

    Numbers are decimal strings, and null if unknown.
    """
    found = {
        **encode(design, without=("start", "orbit")),
        "conditions": [each.text for each in design.conditions],
        "orbit": orbit_json(design.orbit),
    }
    return {name: nan_as_null(entry) for name, entry in found.items()}


@result_json.register
def _fit_json(fit: Fit) -> dict[str, Any]:
    """A fit as JSON; numbers are decimal strings with every digit, and null if unknown."""
    found = {"system": fit.system, **encode(fit, without=("system",))}
    found["standard_errors"] = [repr(each) for each in fit.standard_errors.tolist()]
    found["correlation"] = [[repr(each) for each in row] for row in fit.correlation.tolist()]
    found["same_sequence"] = fit.same_sequence
    for entries, experiment in zip(found["experiments"], fit.experiments, strict=True):
        for written, series in zip(entries["series"], experiment.series, strict=True):
            written["residuals"] = [repr(each) for each in np.asarray(series.residuals).tolist()]
    return {name: nan_as_null(entry) for name, entry in found.items()}


@result_json.register
def _found_json(found: Found) -> dict[str, Any]:
    """Orbits, basins and shares as JSON; numbers are decimal strings of the exact doubles."""

    def part(entry: FoundOrbit | FoundEquilibrium, verdict: str, place: int, before: int) -> Any:
        mirror = entry.mirror
        return {
            "stability": verdict,
            "starts": entry.starts,
            "share": repr(entry.share),
            "mirror_of": None if mirror in (None, place) else mirror + before + 1,
            "symmetric": mirror == place,
        }

    def state(values: np.ndarray) -> dict[str, str]:
        return {name: repr(x) for name, x in zip(found.names, values.tolist(), strict=True)}

    def orbit(entry: FoundOrbit, place: int) -> dict[str, Any]:
        solved = entry.orbit
        phases = zip(entry.itinerary, solved.dwell_times.tolist(), solved.states, strict=True)
        return {
            "period": repr(entry.period),
            "forcing_periods": list(entry.forcing_periods),
            **part(entry, entry.verdict, place, 0),
            "itinerary": [
                {
                    "configuration": configuration,
                    "boundary": boundary,
                    "dwell_time": repr(duration),
                    "start": state(start),
                }
                for (configuration, boundary), duration, start in phases
            ],
            "multipliers": [
                {"re": repr(float(m.real)), "im": repr(float(m.imaginary)), "trivial": m.trivial}
                for m in solved.stability.multipliers
            ],
            "trace": repr(float(solved.stability.trace)),
            "residual": repr(float(solved.residual)),
            "admissible": solved.admissibility.verdict,
        }

    def equilibrium(entry: FoundEquilibrium, place: int) -> dict[str, Any]:
        solved = entry.equilibrium
        return {
            "configuration": solved.configuration,
            **part(entry, solved.verdict, place, len(found.orbits)),
            "state": state(solved.state),
            "eigenvalues": [
                {"re": repr(x.real), "im": repr(x.imag)} for x in solved.eigenvalues.tolist()
            ],
        }

    box = zip(found.names, found.box.tolist(), strict=True)
    return {
        "system": found.system,
        "parameters": {name: value.text for name, value in found.parameters.items()},
        "starts": len(found.starts),
        "transitions": found.transitions,
        "complete": found.complete,
        "box": {name: [repr(end) for end in ends] for name, ends in box},
        "orbits": [orbit(entry, place) for place, entry in enumerate(found.orbits)],
        "equilibria": [equilibrium(entry, place) for place, entry in enumerate(found.equilibria)],
        "outcomes": {o.name.lower(): repr(found.share(o)) for o in found.outcomes},
        "resting": repr(found.resting),
        "unclassified": repr(found.unclassified),
    }


@result_json.register
def _orbit_json(orbit: Orbit) -> dict[str, Any]:
    return orbit_json(orbit)

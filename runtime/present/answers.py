"""Results as JSON; numbers are decimal strings of the same doubles, and null if unknown."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields, is_dataclass
from functools import singledispatch
from operator import attrgetter
from types import MappingProxyType
from typing import Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.json_codec import answer, nan_as_null
from nonsmooth.runtime.core.values import Value
from nonsmooth.runtime.explore.continuation.branch import Branch, Locus
from nonsmooth.runtime.explore.design.optimum import Design
from nonsmooth.runtime.explore.finding.find import Found, FoundEquilibrium, FoundOrbit
from nonsmooth.runtime.explore.finding.outcomes import settled_texts
from nonsmooth.runtime.explore.finding.sweep import Sweep
from nonsmooth.runtime.explore.fitting.fit import Fit
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.present.report import multipliers_json, orbit_json
from nonsmooth.runtime.proof.certificate import Enclosure, Proof
from nonsmooth.runtime.simulation.derivatives import MotionDerivatives
from nonsmooth.runtime.simulation.lyapunov import Exponent, lyapunov
from nonsmooth.runtime.simulation.observables import Observables
from nonsmooth.runtime.simulation.trajectory import Trajectory

Others = Mapping[int, list[dict[str, Any]]]  # itineraries beyond events, by the events' numbers


def result_json(result: Any) -> dict[str, Any]:
    """A result as JSON: what a function below says of its kind, else what its record holds."""
    told: dict[str, Any] = nan_as_null(_json(result))
    return told


@singledispatch
def _json(result: Any) -> dict[str, Any]:
    return answer(result)


def _spelled(value: Any) -> Any:
    """Numbers, arrays and records, also inside of others, as JSON has them."""
    if isinstance(value, Value):
        return value.text
    if isinstance(value, Enclosure):
        return value.to_json()
    if isinstance(value, float):
        return repr(float(value))
    if isinstance(value, complex):
        return {"re": repr(value.real), "im": repr(value.imag)}
    if isinstance(value, np.ndarray):
        return _spelled(value.tolist())
    if isinstance(value, Mapping):
        return {name: _spelled(each) for name, each in value.items()}
    if hasattr(value, "_asdict"):
        return _spelled(value._asdict())
    if isinstance(value, list | tuple):
        return [_spelled(each) for each in value]
    if is_dataclass(value):
        return _attributes(value, *(own.name for own in fields(value)))
    return value


def _attributes(record: Any, *names: str) -> dict[str, Any]:
    """Attributes of a record by their names."""
    return {name: _spelled(attrgetter(name)(record)) for name in names}


@_json.register
def _motion_json(motion: Trajectory) -> dict[str, Any]:
    """A motion as JSON: one entry for the start and one behind each transition.

    States are physical: positions, then velocities, in the order of `names`.
    """
    shapes = motion.structure.boundaries
    return {
        "system": motion.name,
        **_attributes(motion, "parameters", "names", "times", "configurations", "boundaries"),
        **_attributes(motion, "states", "transitions", "end"),
        "status": motion.status.name.lower(),
        **_attributes(motion, "message", "options", "open_at"),
        "grazings": [
            {
                **_attributes(grazing, "time", "depth"),
                "configuration": motion.structure.configurations[grazing.configuration],
                "boundary": shapes[grazing.configuration][grazing.boundary].name,
            }
            for grazing in motion.grazings
        ],
    }


@_json.register
def _derivatives_json(found: MotionDerivatives) -> dict[str, Any]:
    """Derivatives of a motion as JSON, in the shapes of the arrays of `found`.

    For each transition and state there is one number by each of `by`. The time of a
    transition that has no derivative gets nan.
    """
    return _attributes(found, "by", "event_times", "before", "behind", "condition")


@_json.register
def _sweep_json(diagram: Sweep) -> dict[str, Any]:
    """A bifurcation diagram as JSON: for each value of the parameter the sampled points."""
    texts = settled_texts()
    names = ("system", "parameter", "state", "configuration", "phase", "values")
    return {
        **_attributes(diagram, *names),
        "samples": [_spelled(row[np.isfinite(row)]) for row in diagram.samples],
        "outcomes": [
            texts[number] if place < diagram.done else None  # an interrupted one has not looked
            for place, number in enumerate(diagram.outcomes.tolist())
        ],
    }


@_json.register
def _observables_json(found: Observables) -> dict[str, Any]:
    """Extremes, averages, shares of time, contacts and largest Lyapunov exponent as JSON."""
    exponent = largest_exponent(found)
    value, error = (None, None) if isinstance(exponent, str) else exponent
    return {
        **_attributes(found, "since", "duration", "minima", "maxima", "means", "rms"),
        **_attributes(found, "fractions", "sticking", "contacts"),
        **_spelled({"lyapunov": value, "lyapunov_error": error}),
    }


def largest_exponent(found: Observables) -> Exponent | str:
    """The largest Lyapunov exponent per unit of time, or the reason why there is none."""
    try:
        return lyapunov(found.trajectory, found.since)
    except InputError as problem:
        return str(problem)


@_json.register
def _proof_json(proof: Proof) -> dict[str, Any]:
    """What is proved of a motion, as JSON: its sequence, with enclosures of the times."""
    return {
        **_attributes(proof, "decided", "transitions", "configurations", "times"),
        **_attributes(proof, "reason", "instant", "bits"),
        "boundaries": _spelled(proof.sets),
    }


@_json.register
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
                **{name: entry for name, entry in answer(event).items() if name in _EVENT},
                "touching": event.touching,
                **({"beyond": others[number]} if number in others else {}),
            }
            for number, event in enumerate(branch.events)
        ],
    }


_EVENT = ("kind", "value", "phase", "configuration", "boundary", "time", "unknowns")


@_json.register
def _locus_json(locus: Locus) -> dict[str, Any]:
    """A curve of events as JSON."""
    columns = zip(locus.unknown_names, locus.unknowns.T.tolist(), strict=True)
    return {
        "orbit": locus.name,
        "values": locus.values.tolist(),
        "unknowns": dict(columns),
        **_attributes(locus, "kind", "boundary", "parameters", "ends"),
    }


def _finite(values: Any) -> list[float | None]:
    return [x if abs(x) < float("inf") else None for x in values.tolist()]


@_json.register
def _design_json(design: Design) -> dict[str, Any]:
    """A design as JSON, without its orbits' files."""
    return {
        **answer(design, without=("start", "orbit")),
        "conditions": [each.text for each in design.conditions],
        "orbit": orbit_json(design.orbit),
    }


@_json.register
def _fit_json(fit: Fit) -> dict[str, Any]:
    return {"system": fit.system, **answer(fit, without=("system",))}


@_json.register
def _found_json(found: Found) -> dict[str, Any]:
    """Orbits, basins and shares as JSON; numbers are decimal strings of the exact doubles."""

    def part(entry: FoundOrbit | FoundEquilibrium, verdict: str, place: int, before: int) -> Any:
        mirror = entry.mirror
        return {
            "stability": verdict,
            **_attributes(entry, "starts", "share"),
            "mirror_of": None if mirror in (None, place) else mirror + before + 1,
            "symmetric": mirror == place,
        }

    def state(values: np.ndarray) -> dict[str, str]:
        return dict(zip(found.names, _spelled(values), strict=True))

    def orbit(entry: FoundOrbit, place: int) -> dict[str, Any]:
        solved = entry.orbit
        phases = zip(entry.itinerary, _spelled(solved.dwell_times), solved.states, strict=True)
        return {
            **_attributes(entry, "period", "forcing_periods"),
            **part(entry, entry.verdict, place, 0),
            "itinerary": [
                {
                    "configuration": configuration,
                    "boundary": boundary,
                    "dwell_time": duration,
                    "start": state(start),
                }
                for (configuration, boundary), duration, start in phases
            ],
            "multipliers": multipliers_json(solved.stability, lambda x: repr(float(x))),
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
            "eigenvalues": _spelled(solved.eigenvalues),
        }

    return {
        **_attributes(found, "system", "parameters"),
        "starts": len(found.starts),
        **_attributes(found, "transitions", "complete"),
        "box": state(found.box),
        "orbits": [orbit(entry, place) for place, entry in enumerate(found.orbits)],
        "equilibria": [equilibrium(entry, place) for place, entry in enumerate(found.equilibria)],
        "outcomes": {o.name.lower(): repr(found.share(o)) for o in found.outcomes},
        **_attributes(found, "resting", "unclassified"),
    }


_json.register(Orbit, orbit_json)

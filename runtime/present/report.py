"""Results as JSON and as text: numbers with the digits they have."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.values import decimal_string, flint_precision
from nonsmooth.runtime.model.completion import default_parameters
from nonsmooth.runtime.model.kernels import (
    OrbitKernels,
    ParameterTable,
    SystemKernels,
    is_saved,
    load_orbit,
    load_system,
    orbits_in,
    system_names,
)
from nonsmooth.runtime.model.naming import shown_name
from nonsmooth.runtime.model.structure import structure_of
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.orbits.refine import enclosed_trace
from nonsmooth.runtime.orbits.table_solve import unknowns_of
from nonsmooth.runtime.present.files.named_entries import saved_listing
from nonsmooth.runtime.shooting.multipliers import Stability

__all__ = [
    "admissibility_json",
    "derivatives_json",
    "orbit_json",
    "short",
    "systems_json",
    "trace_proof_json",
]


def derivatives_json(
    orbit: Orbit, by: Sequence[str], digits: int | None = None
) -> dict[str, dict[str, str]]:
    """Derivatives of an orbit's results by some of its given numbers, as decimal strings.

    The results are the unknowns, ``period``, ``trace``, ``determinant`` and
    ``spectral_radius``; derivatives that do not exist are left out. At a border collision
    they are those on the side that the report names. `digits` may be fewer than the orbit
    has. `InputError` is raised as by `Orbit.derivatives`.
    """
    shown = orbit.digits if digits is None else min(digits, orbit.digits)
    found = orbit.derivatives(by, one_sided=True)
    told: dict[str, dict[str, str]] = {}
    for name in (*found.unknowns, "period", "trace", "determinant", "spectral_radius"):
        rates = found.quantity(name)[1].tolist()
        if all(rate == rate for rate in rates):
            told[name] = {
                parameter: decimal_string(rate, shown)
                for parameter, rate in zip(found.by, rates, strict=True)
            }
    return told


def orbit_json(orbit: Orbit, digits: int | None = None) -> dict[str, Any]:
    """An orbit with stability and admissibility as JSON; numbers are decimal strings.

    `unknowns` are what was solved for and `parameters` what was given, with three digits
    more than the error bound 10^-digits max(1, |x|) needs. `digits` may be fewer than the
    orbit has. `InputError` is raised if there is no orbit.
    """
    shown = orbit.digits if digits is None else min(digits, orbit.digits)

    def text(number: Any) -> str:
        return decimal_string(number, shown)

    def multipliers(stability: Stability) -> list[dict[str, Any]]:
        return [
            {"re": text(m.real), "im": text(m.imaginary), "trivial": m.trivial}
            for m in stability.multipliers
        ]

    stability = orbit.stability
    shift = {name: text(orbit.shift[name]) for name in orbit.evaluation.free_states}
    found = {
        "orbit": orbit.name,
        "parameters": {name: text(orbit.values[name]) for name in orbit.given}
        | dict(orbit.problem.required)
        | {name: text(float(value)) for name, value in orbit.opened.items()},
        "unknowns": {name: text(value) for name, value in orbit.unknowns.items()},
        "period": text(orbit.period),
        **({"shift": shift} if shift else {}),
        "residual": short(orbit.residual),
        "digits": shown,
        "multipliers": multipliers(stability),
        "trace": text(stability.trace),
        "margin": text(stability.margin),
        "stability": stability.verdict,
        **({"one_sided": stability.one_sided} if stability.one_sided else {}),
        **admissibility_json(orbit),
    }
    if orbit.symmetry is not None:
        found["part_multipliers"] = multipliers(orbit.part_stability)
    phases = zip(orbit.itinerary, orbit.dwell_time_names, strict=True)
    found["phases"] = [
        {"configuration": configuration, "boundary": boundary, "dwell_time": name}
        for (configuration, boundary), name in phases
    ]
    return found


def trace_proof_json(orbit: Orbit) -> dict[str, Any]:
    """What is proved of the trace of a refined orbit, as JSON.

    `trace` is its enclosure, ``{"mid", "rad"}``, over a box around the orbit that holds exactly
    one, or None. `statement` is the criterion of stability: |trace| < 1 if the map has rank one
    and keeps no energy, |trace - 1| < 2 if its multipliers are 1, mu and 1/mu by the
    derivation (then it is neutral); of an orbit by tables that every
    nontrivial multiplier is inside the unit circle, or on it where the orbit is neutral.
    `verdict` says whether it is "proved", "refuted" or "undecided"; both are None where
    there is no criterion. `one_sided` says whether all of it is about one side of a border
    collision. `reason` is there where something is left open: why there is no enclosure or no
    certificate, or why a certificate does not prove existence or stability.
    """
    from nonsmooth.runtime.proof.certify_orbit import MOST_BITS

    bits = min(math.ceil(orbit.digits * math.log2(10)) + 16, MOST_BITS)
    return (_proof_by_kernels if orbit.problem.derived else _proof_by_certificate)(orbit, bits)


def _proof_by_kernels(orbit: Orbit, bits: int) -> dict[str, Any]:
    """What the trace of the kernels decides over the box that Krawczyk's test proves."""
    from nonsmooth.runtime.checker.orbits.stability import TANGENTIAL
    from nonsmooth.runtime.proof.certificate import Stated

    table, ball, reason = orbit.kernels.table, enclosed_trace(orbit), ""
    if ball is None:
        reason = "no box around it is shown to hold exactly one orbit"
    elif not ball.is_finite():
        reason = TANGENTIAL
    statement, verdict, centre, radius = None, None, 0, 1
    if table["rank"] == 1 and not table["conservative"]:
        statement = "|trace| < 1"
    elif table["reciprocal_pair"]:
        statement, centre, radius = "|trace - 1| < 2", 1, 2
    if statement is not None:
        verdict = "undecided"
        with flint_precision(bits):
            distance = None if reason else abs(ball - centre)
            if distance is not None and distance < radius:
                verdict = "proved"
            elif distance is not None and distance > radius:
                verdict = "refuted"
    return {
        "trace": None if reason else Stated.around(ball, bits).to_json(),
        "statement": statement,
        "verdict": verdict,
        "one_sided": bool(orbit.stability.one_sided),
        **({"reason": reason} if reason else {}),
    }


def _proof_by_certificate(orbit: Orbit, bits: int) -> dict[str, Any]:
    """What a certificate claims of trace and multipliers; there the rank is not used."""
    from nonsmooth.runtime.checker.orbits.stability import CORNER
    from nonsmooth.runtime.proof.certify_orbit import certify

    proof: dict[str, Any] = {"trace": None, "statement": None, "verdict": None, "one_sided": False}
    try:
        certificate = certify(orbit, bits)
    except InputError as problem:  # the system is not stated exactly
        return proof | {"reason": str(problem)}
    trace, reasons = certificate.enclosures.get("trace"), certificate.reasons
    reason = reasons.get("existence") or reasons.get("stability")
    if trace is not None:
        proof["trace"] = trace.to_json()
    if reason == CORNER:
        proof["one_sided"] = True
    elif certificate.claims["existence"] == "proved":
        side = {"stable": "inside", "neutral": "on"}[certificate.stability]
        proof["statement"] = f"every nontrivial multiplier is {side} the unit circle"
        proof["verdict"] = certificate.claims["stability"]
    return proof | ({"reason": reason} if reason else {})


def admissibility_json(orbit: Orbit) -> dict[str, Any]:
    """The verdict on a converged orbit as JSON, with violations, or bounds on open parameters.

    Phases are counted from 1.
    """
    admissibility = orbit.admissibility
    found: dict[str, Any] = {"admissible": admissibility.verdict}
    if admissibility.verdict is False:
        found["violations"] = [
            {
                "phase": v.phase + 1,
                "configuration": v.configuration,
                "boundary": v.boundary,
                "time": repr(v.time),
                "excess": repr(v.excess),
            }
            for v in admissibility.violations
        ]
    if admissibility.verdict == "conditional":
        found["requires"] = [
            {"parameter": r.parameter, "greater_than": repr(r.greater_than)}
            for r in admissibility.requires
        ]
    if admissibility.coincidences:
        found["coincidences"] = [
            {"phase": c.phase + 1, "boundaries": list(c.boundaries), "time": repr(c.time)}
            for c in admissibility.coincidences
        ]
    return found


def systems_json(names: Sequence[str] = ()) -> dict[str, Any]:
    """Systems and their orbits as JSON, with what is given and what is solved for.

    Without names all built-in systems are listed.
    """
    listings = {name: _listing(name) for name in names or system_names()}
    return {
        "systems": [
            {
                "name": shown_name(system.name) if is_saved(name) else system.name,
                "description": system.table["description"],
                "states": list(system.table["states"]),
                "configurations": list(visited := _visited(system)),
                "boundaries": {
                    configuration: [dict(boundary) for boundary in boundaries]
                    for configuration, boundaries in visited.items()
                },
                "transitions": _transitions_json(system),
                "parameters": [_parameter_json(p) for p in system.parameters],
                "orbits": [_listed(orbit, entry) for orbit, entry in orbits.items()],
            }
            for name, (system, orbits) in listings.items()
        ]
    }


def _visited(system: SystemKernels) -> dict[str, Any]:
    """Configurations of a system with their boundaries, without those that are not visited."""
    structure, every = structure_of(system), system.table["configurations"]
    return {structure.configurations[c]: every[structure.configurations[c]]
            for c in structure.visited}  # fmt: skip


def _transitions_json(system: SystemKernels) -> list[dict[str, Any]]:
    """Transitions that may follow when boundaries are reached; the state decides which one does."""
    targets: dict[tuple[str, tuple[str, ...]], list[str]] = {}
    for transition in system.table["transitions"]:
        reached = (transition["source"], tuple(transition["boundaries"]))
        known = targets.setdefault(reached, [])
        if transition["target"] not in known:
            known.append(transition["target"])
    return [
        {"source": source, "boundaries": list(boundaries), "targets": found}
        for (source, boundaries), found in targets.items()
    ]


def _listing(name: str) -> tuple[SystemKernels, Mapping[str, OrbitKernels | str]]:
    """A system with its orbits, or those of a file of results."""
    if is_saved(name):
        return saved_listing(name)
    return load_system(name), {orbit: load_orbit(orbit) for orbit in orbits_in(name)}


def _listed(name: str, entry: OrbitKernels | str) -> dict[str, Any]:
    """An orbit as JSON, or the reason why an entry of a file is none."""
    if isinstance(entry, str):
        return {"name": name, "refused": entry}
    return _declared_json(entry) if entry.derived else _composed_json(entry)


def _declared_json(kernels: OrbitKernels) -> dict[str, Any]:
    defaults = kernels.required | default_parameters(kernels)
    tables = [*kernels.parameters, *kernels.open_parameters]
    used = {*kernels.parameter_names, *kernels.solved_for}
    combining = {n for name, terms in kernels.combined.items() if name in used for n in terms}
    combining = (combining | set(kernels.required)) - {p.name for p in tables}
    tables += [p for p in kernels.system.parameters if p.name in combining]
    return {
        "name": kernels.address,
        "phases": [
            {"configuration": configuration, "boundary": boundary, "dwell_time": dwell_time}
            for configuration, boundary, dwell_time in kernels.table["phases"]
        ],
        "parameters": [_parameter_json(p) | {"default": defaults.get(p.name)} for p in tables],
        "unknowns": list(kernels.unknowns),
        "derived": True,
    }


def _composed_json(kernels: OrbitKernels) -> dict[str, Any]:
    """An orbit without derived equations as JSON: parameters are given, the start is unknown."""
    table, system = kernels.table, kernels.system
    reference = table["reference"] or {"parameters": {}}
    return {
        "name": kernels.address,
        "phases": [
            {"configuration": configuration, "boundary": boundary, "dwell_time": dwell_time}
            for configuration, boundary, dwell_time in table["phases"]
        ],
        "parameters": [
            _parameter_json(p) | {"default": reference["parameters"].get(p.name)}
            for p in system.parameters
        ],
        "unknowns": list(unknowns_of(kernels)),
        "derived": False,
        "reason": table["reason"],
    }


def _parameter_json(parameter: ParameterTable) -> dict[str, Any]:
    return {
        "name": parameter.name,
        "description": parameter.description,
        "lower": parameter.lower,
        "upper": parameter.upper,
        "closed": parameter.closed,
        "upper_closed": parameter.upper_closed,
    }


def short(number: Any) -> str:
    """Decimal text of a small number to three digits, of which the size is what counts."""
    from mpmath import mp

    return str(mp.nstr(mp.mpf(number), 3))

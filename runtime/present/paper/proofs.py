"""What ball arithmetic proves of the paper's orbits: a chapter of its own."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace

from nonsmooth.runtime.explore.continuation.continue_orbit import continue_orbit
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.orbits.solve import solve
from nonsmooth.runtime.present.paper.records import Chapter, Report, Table, Text
from nonsmooth.runtime.proof.certificate import CLAIMS, Certificate
from nonsmooth.runtime.proof.certify_orbit import certify
from nonsmooth.runtime.proof.events.certify_event import certify_event
from nonsmooth.runtime.proof.events.event_certificate import EventCertificate

__all__ = ["with_certificates"]

_BESIDE = 0.05  # of the parameter: from a border collision to an orbit that has all phases


def with_certificates(
    report: Report, orbits: Mapping[str, Orbit], begin: Callable[[str], None]
) -> Report:
    """A new report, with a chapter on proofs before the last one, and certificates in its JSON.

    The report is that of `paper_report`, and the orbits are those of `paper_orbits`;
    `begin` receives the name of each step.
    """
    found: dict[str, Certificate] = {}
    for name, orbit in orbits.items():
        begin(f"proof of {name}")
        found[name] = certify(orbit, begin=begin)
    rows = tuple(
        (name, *(c.claims[claim] for claim in CLAIMS), _enclosed(c)) for name, c in found.items()
    )
    collisions = {
        name: _collision(orbit)
        for name, orbit in orbits.items()
        if orbit.kernels.table["vanishing"]
    }
    reasons = [
        f"*{name}*, {claim}: {reason}."
        for name, certificate in found.items()
        for claim, reason in certificate.reasons.items()
    ]
    for name, event in collisions.items():
        told = f"{event.value.mid} +/- {event.value.rad}" if event.proved else event.reason
        reasons.append(
            f"*{name}* is where a dwell time of *{event.orbit}* shrinks to zero; that it does is"
            f" {event.claim}, at {event.parameter} = {told}."
        )
    chapter = Chapter(
        "proofs",
        "Proofs",
        (
            Text(
                "Ball arithmetic with all rounding included: that there is one orbit in a stated"
                " box and no other, that it is a motion of the system at all times, and that its"
                " multipliers are where the verdict puts them. Stability of conservative orbits"
                " is that the pair lies on the unit circle."
            ),
            Table(
                "Claims on the orbits at the paper's data",
                ("Orbit", *(claim.capitalize() for claim in CLAIMS), "Trace"),
                rows,
            ),
            *map(Text, reasons),
        ),
    )
    certificates = {
        name: {"claims": dict(c.claims), "reasons": dict(c.reasons), "trace": _enclosed(c)}
        for name, c in found.items()
    }
    return replace(
        report,
        chapters=(*report.chapters[:-1], chapter, report.chapters[-1]),
        results={
            **report.results,
            "certificates": certificates,
            "collisions": {name: event.to_json() for name, event in collisions.items()},
        },
    )


def _collision(orbit: Orbit) -> EventCertificate:
    """Certificate of the border collision at an orbit with a vanishing phase.

    The collision lies on the branch beside the orbit.
    """
    kernels = orbit.kernels
    (parameter,) = kernels.solved_for
    (host,) = [
        name
        for name, table in kernels.system.module.ORBITS.items()
        if table["phases"] == kernels.table["phases"] and not table["vanishing"]
    ]
    given = {name: str(value) for name, value in orbit.given.items()}
    value = float(orbit.unknowns[parameter])
    beside = solve(f"{kernels.system.name}/{host}", {**given, parameter: value + _BESIDE})
    branch = continue_orbit(beside, parameter, (value - _BESIDE, value + 2 * _BESIDE))
    (event,) = [event for event in branch.events if event.kind == "vanishing-phase"]
    return certify_event(branch, event)


def _enclosed(certificate: Certificate) -> str:
    trace = certificate.enclosures.get("trace")
    return "" if trace is None else f"{trace.mid} +/- {trace.rad}"

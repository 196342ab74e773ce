"""What ball arithmetic proves of the paper's orbits: a chapter of its own."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace

from nonsmooth.runtime.certification.certificate import CLAIMS, Certificate
from nonsmooth.runtime.certification.certify import certify
from nonsmooth.runtime.orbit import Orbit
from nonsmooth.runtime.reproduce.records import Chapter, Report, Table, Text

__all__ = ["with_certificates"]


def with_certificates(
    report: Report, orbits: Mapping[str, Orbit], begin: Callable[[str], None]
) -> Report:
    """The report with a chapter on proofs before the last, and the certificates in its JSON."""
    found: dict[str, Certificate] = {}
    for name, orbit in orbits.items():
        begin(f"proof of {name}")
        found[name] = certify(orbit, begin=begin)
    rows = tuple(
        (name, *(c.claims[claim] for claim in CLAIMS), _enclosed(c)) for name, c in found.items()
    )
    reasons = [
        f"*{name}*, {claim}: {reason}."
        for name, certificate in found.items()
        for claim, reason in certificate.reasons.items()
    ]
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
        results={**report.results, "certificates": certificates},
    )


def _enclosed(certificate: Certificate) -> str:
    trace = certificate.enclosures.get("trace")
    return "" if trace is None else f"{trace.mid} +/- {trace.rad}"

"""Certificates in files."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from nonsmooth.runtime.core.json_codec import BlankValue
from nonsmooth.runtime.core.result_files import FileFormat
from nonsmooth.runtime.core.values import parse
from nonsmooth.runtime.model.saved_system import system_in
from nonsmooth.runtime.present.files.claim_entries import (
    Ball,
    ClaimEntries,
    Enclosures,
    OrbitProofEntries,
    enclosed,
    stated,
)
from nonsmooth.runtime.proof.certificate import FORMAT, VERSION, Certificate, Unknown

__all__ = [
    "CERTIFICATE",
    "CertificateEntries",
    "certificate_entries",
    "certificate_of",
    "load_certificate",
    "save_certificate",
]


@dataclass(frozen=True, kw_only=True)
class MultiplierBalls:
    """Enclosures of the real and imaginary part of a multiplier."""

    re: Ball
    im: Ball


@dataclass(frozen=True, kw_only=True)
class CertificateEntries(OrbitProofEntries):
    """Entries of the file of an orbit's certificate."""

    given_period: BlankValue
    bits: int
    claims: ClaimEntries
    stability: str
    reasons: Mapping[str, str]
    enclosures: Enclosures
    multipliers: tuple[MultiplierBalls, ...]
    other_multipliers: str
    margins: tuple[Mapping[str, Any], ...]
    box: tuple[Unknown, ...]
    declaration: Mapping[str, Any]
    closing: Mapping[str, Any]
    derivatives: Mapping[str, Enclosures] | None = None
    directions: Mapping[str, Mapping[str, Fraction]] | None = None
    no_derivatives: Mapping[str, str] | None = None


CERTIFICATE = FileFormat(
    name=FORMAT, what="certificate", entries=CertificateEntries, version=VERSION
)


def certificate_entries(certificate: Certificate) -> CertificateEntries:
    """Entries of the file of an orbit's certificate."""
    return stated(CertificateEntries, certificate)


def certificate_of(entries: CertificateEntries) -> Certificate:
    """The orbit's certificate that a file's entries describe."""
    system_in(entries.system, entries.tables)
    if entries.other_multipliers:
        parse(entries.other_multipliers)
    bits, declaration = entries.bits, entries.declaration
    return Certificate(
        orbit=entries.orbit,
        system=entries.system,
        parameters=entries.parameters,
        chosen=entries.chosen,
        itinerary=entries.itinerary,
        claims=vars(entries.claims),
        stability=entries.stability,
        reasons=entries.reasons,
        enclosures=enclosed(entries.enclosures, bits),
        multipliers=tuple((m.re.stated(bits), m.im.stated(bits)) for m in entries.multipliers),
        other_multipliers=entries.other_multipliers,
        margins=entries.margins,
        box=entries.box,
        bits=bits,
        start_names=tuple(declaration.get("start", ())),
        dwell_names=tuple(phase["dwell_time"] for phase in declaration.get("phases", ())),
        given_period=entries.given_period,
        declaration=declaration,
        closing=entries.closing,
        derivatives={name: enclosed(x, bits) for name, x in (entries.derivatives or {}).items()},
        directions=entries.directions or {},
        no_derivatives=entries.no_derivatives or {},
    )


save_certificate = CERTIFICATE.writer(certificate_entries)
load_certificate = CERTIFICATE.reader(certificate_of)

"""Certificates in files."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import Any

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.result_files import Form, naming
from nonsmooth.runtime.present.files.orbit_numbers import given_value
from nonsmooth.runtime.proof.certificate import (
    CLAIMS,
    FORMAT,
    VERSION,
    Certificate,
    Stated,
    Unknown,
)

__all__ = [
    "CERTIFICATE",
    "certificate_content",
    "certificate_entries",
    "certificate_of",
    "check_certificate_entries",
    "load_certificate",
    "save_certificate",
]

CERTIFICATE = Form(
    FORMAT,
    "certificate",
    {
        "orbit": str,
        "system": str,
        "parameters": dict,
        "chosen": list,
        "given_period": str,
        "itinerary": list,
        "bits": int,
        "claims": dict,
        "stability": str,
        "reasons": dict,
        "enclosures": dict,
        "multipliers": list,
        "margins": list,
        "box": list,
        "declaration": dict,
        "closing": dict,
    },
    VERSION,
)


def save_certificate(certificate: Certificate, path: str | os.PathLike[str]) -> None:
    """Write a certificate to a file; what was there stays until the new content is complete.

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    CERTIFICATE.write(path, certificate_entries(certificate))


def certificate_content(certificate: Certificate) -> dict[str, Any]:
    """What is in a certificate's file."""
    return CERTIFICATE.content(certificate_entries(certificate))


def load_certificate(path: str | os.PathLike[str]) -> Certificate:
    """Read a certificate that `Certificate.save` wrote; nothing is proved again.

    Raises
    ------
    InputError
        If the file cannot be read, or is cut, edited or foreign. The message names it.
    """
    with naming(path) as file:
        content = CERTIFICATE.read(file)
        check_certificate_entries(content)
        return certificate_of(content)


def check_certificate_entries(content: Any) -> None:
    """Refuse entries that are not those of a certificate, or another checksum.

    Raises
    ------
    InputError
    """
    CERTIFICATE.check(content)
    if set(content["claims"]) != set(CLAIMS):
        raise InputError(f"its claims are not {', '.join(CLAIMS)}")


def certificate_entries(certificate: Certificate) -> dict[str, Any]:
    """What a certificate's file states."""
    return {
        **certificate.to_json(),
        "declaration": dict(certificate.declaration),
        "closing": dict(certificate.closing),
    }


def certificate_of(content: Mapping[str, Any]) -> Certificate:
    """The certificate that a file's entries describe."""
    bits, declaration = content["bits"], content["declaration"]

    def ball(entry: Mapping[str, str]) -> Stated:
        return Stated.of(entry["mid"], entry["rad"], bits)

    return Certificate(
        content["orbit"],
        content["system"],
        {name: given_value(name, text) for name, text in content["parameters"].items()},
        tuple(content["chosen"]),
        tuple((str(c), str(b)) for c, b in content["itinerary"]),
        dict(content["claims"]),
        content["stability"],
        dict(content["reasons"]),
        {name: ball(entry) for name, entry in content["enclosures"].items()},
        tuple((ball(m["re"]), ball(m["im"])) for m in content["multipliers"]),
        tuple(dict(margin) for margin in content["margins"]),
        tuple(Unknown(x["name"], x["mid"], x["rad"]) for x in content["box"]),
        bits,
        tuple(declaration.get("start", ())),
        tuple(phase["dwell_time"] for phase in declaration.get("phases", ())),
        given_value("period", content["given_period"]) if content["given_period"] else None,
        declaration,
        content["closing"],
    )

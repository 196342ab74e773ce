"""Certificates in files, and their check.

A file is checked in three ways: its checksum; the checker proves every claim again from the
file alone; and its declaration is compared with that of the system it names, at its
parameters, where that is there.
"""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

from nonsmooth.runtime.certification.boxes.comparing import compare_box
from nonsmooth.runtime.certification.boxes.record import BoxCertificate
from nonsmooth.runtime.certification.boxes.saved import BOX, box_of
from nonsmooth.runtime.certification.certificate import (
    CLAIMS,
    FORMAT,
    GUARD,
    VERSION,
    Certificate,
    Stated,
    Unknown,
)
from nonsmooth.runtime.certification.checker import Failure, check, check_events, check_tiles
from nonsmooth.runtime.certification.events.record import EventCertificate
from nonsmooth.runtime.certification.events.saved import (
    EVENTS,
    compare_events,
    event_entries,
    events_of,
)
from nonsmooth.runtime.certification.statement import declaration_json, value_json
from nonsmooth.runtime.certification.tables import exact_tables
from nonsmooth.runtime.composition.passage import cycle_of
from nonsmooth.runtime.errors import InputError
from nonsmooth.runtime.files import read_file, write_file
from nonsmooth.runtime.kernels import load_system
from nonsmooth.runtime.saved import check_entries, checksum_of, given_value, parsed
from nonsmooth.runtime.simulation.piecewise import system_parameters
from nonsmooth.runtime.simulation.structure import structure_of
from nonsmooth.runtime.values import flint_precision

__all__ = [
    "Check",
    "certificate_content",
    "certificate_of",
    "check_certificate",
    "load_certificate",
    "save_certificate",
]

_LARGEST_FILE = 500_000_000  # bytes
_FIELDS: dict[str, type] = {
    "format": str,
    "version": int,
    "package": str,
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
    "start": list,
    "dwell_times": list,
    "constants": list,
    "declaration": dict,
    "closing": dict,
    "sha256": str,
}
Proven = Certificate | BoxCertificate | tuple[EventCertificate, ...]
_WRONG_SHAPE = (KeyError, IndexError, TypeError, ValueError, AttributeError, ArithmeticError)


@dataclass(frozen=True, eq=False)
class Check:
    """The check of a certificate.

    Attributes
    ----------
    difference : str or None
        What is wrong with it; None if every claim was proved again.
    note : str or None
        What could not be compared: the system is not there.
    certificate : Certificate, BoxCertificate, tuple of EventCertificate, or None
        What was proved again; None if something is wrong with it.
    """

    difference: str | None
    note: str | None = None
    certificate: Proven | None = None


def save_certificate(certificate: Certificate, path: str | os.PathLike[str]) -> None:
    """Write a certificate to a file; what was there stays until the new content is complete.

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    text = json.dumps(certificate_content(certificate), indent=1, allow_nan=False) + "\n"
    write_file(Path(path), text.encode())


def certificate_content(certificate: Certificate) -> dict[str, Any]:
    """What is in a certificate's file."""
    from importlib.metadata import version

    content: dict[str, Any] = {
        "format": FORMAT,
        "version": VERSION,
        "package": version("nonsmooth"),
        **certificate.to_json(),
        "start": list(certificate.start_names),
        "dwell_times": list(certificate.dwell_names),
        "constants": [value.text for value in certificate.constants],
        "declaration": dict(certificate.declaration),
        "closing": dict(certificate.closing),
    }
    content["sha256"] = checksum_of(content)
    return content


def load_certificate(path: str | os.PathLike[str]) -> Certificate:
    """Read a certificate that `Certificate.save` wrote; nothing is proved again.

    Raises
    ------
    InputError
        If the file cannot be read, or is cut, edited or foreign. The message names it.
    """
    try:
        return certificate_of(_parsed(Path(path)))
    except InputError as problem:
        raise InputError(f"{os.fspath(path)}: {problem}") from None


def certificate_of(content: Any) -> Certificate:
    """The certificate of which this is a file's content; InputError if it is not in order."""
    _check_entries(content)
    if content["sha256"] != checksum_of(content):
        raise InputError("edited or damaged: the checksum differs")
    return _certificate(content)


def check_certificate(path: str | os.PathLike[str]) -> Check:
    """Check a certificate: its checksum, its system, and all its claims, from the file alone.

    Parameters
    ----------
    path : str or path
        What `save` of a `Certificate`, `BoxCertificate` or `EventCertificate` wrote.

    Raises
    ------
    InputError
        If the file cannot be read or is no certificate.
    """
    folder = Path(path).parent
    try:
        content = _parsed(Path(path))
        kind = _KINDS.get(str(content.get("format")), _KINDS[FORMAT])
        kind.entries({**content, "sha256": checksum_of(content)})  # that is the checker's
    except InputError as problem:
        raise InputError(f"{os.fspath(path)}: {problem}") from None
    try:
        with flint_precision(64):  # the one precision of the process is kept
            kind.check(content)
        found = kind.of(content)
        note = kind.compare(content, folder)
    except (Failure, InputError) as problem:
        return Check(str(problem))
    except _WRONG_SHAPE as problem:
        return Check(f"the file is not in order: {type(problem).__name__}: {problem}")
    return Check(None, note, found)


def _parsed(path: Path) -> dict[str, Any]:
    content = parsed(read_file(path, _LARGEST_FILE, "certificate"))
    if not isinstance(content, dict):
        raise InputError("not a certificate, such as --save writes")
    return content


def _check_entries(content: Any) -> None:
    """Refuse entries that are not those of a certificate, or of the wrong types."""
    if not isinstance(content, dict) or content.get("format") != FORMAT:
        raise InputError("not a certificate, such as --save writes")
    check_entries({**content, "sha256": checksum_of(content)}, VERSION, _FIELDS)
    if set(content["claims"]) != set(CLAIMS):
        raise InputError(f"its claims are not {', '.join(CLAIMS)}")


def _certificate(content: Mapping[str, Any]) -> Certificate:
    bits = content["bits"]

    def ball(entry: Mapping[str, str]) -> Stated:
        return Stated.of(entry["mid"], entry["rad"], bits)

    try:
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
            tuple(content["start"]),
            tuple(content["dwell_times"]),
            given_value("period", content["given_period"]) if content["given_period"] else None,
            tuple(given_value("constant", text) for text in content["constants"]),
            content["declaration"],
            content["closing"],
        )
    except _WRONG_SHAPE as problem:
        raise InputError(f"not in order: {problem}") from None


def _compare(content: Mapping[str, Any], folder: Path) -> str | None:
    """Compare the declaration with that of the system at the parameters that are named.

    Raises
    ------
    Failure
        If they differ.
    """
    if not content["declaration"]:
        return None
    try:
        kernels = load_system(content["system"], folder)
    except InputError:
        return f"{content['system']} is not here: its declaration is as the file says"
    given = {name: given_value(name, text) for name, text in content["parameters"].items()}
    values = system_parameters(kernels, given)
    cycle = cycle_of(structure_of(kernels), [(c, b) for c, b in content["itinerary"]])
    work = content["bits"] + GUARD
    with flint_precision(work):
        tables = exact_tables(kernels, tuple(values.values()), work)
        if [value.text for value in tables.constants] != content["constants"]:
            raise Failure("the constants are not the irrational parameters")
        if declaration_json(tables, cycle) != content["declaration"]:
            raise Failure(f"the declaration is not that of {content['system']} at its parameters")
        if content["closing"]["kind"] == "period":
            period = value_json(given_value("period", content["given_period"]), work)
            if period != content["closing"]["period"]:
                raise Failure("the period is not the one that is given")
    return None


class _Kind(NamedTuple):
    """What is done with a file: entries of its format, proof, record, comparison."""

    entries: Callable[[Mapping[str, Any]], None]
    check: Callable[[dict[str, Any]], None]
    of: Callable[[Mapping[str, Any]], Proven]
    compare: Callable[[Mapping[str, Any], Path], str | None]


_KINDS = {
    FORMAT: _Kind(_check_entries, check, _certificate, _compare),
    BOX.name: _Kind(BOX.check, check_tiles, box_of, compare_box),
    EVENTS.name: _Kind(event_entries, check_events, events_of, compare_events),
}

"""The check of certificates, maps, events and censuses in files.

A file is checked in three ways: its checksum; the checker proves every claim again from the
file alone; and its declaration is compared with that of the system it names, at its
parameters, where that is there.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from operator import attrgetter
from pathlib import Path
from typing import Any, NamedTuple

from nonsmooth.runtime.certification.boxes.comparing import compare_box
from nonsmooth.runtime.certification.boxes.record import BoxCertificate
from nonsmooth.runtime.certification.boxes.saved import BOX, box_of
from nonsmooth.runtime.certification.certificate import Certificate
from nonsmooth.runtime.certification.checker import (
    Failure,
    check,
    check_census,
    check_events,
    check_tiles,
)
from nonsmooth.runtime.certification.comparing import compare_certificate
from nonsmooth.runtime.certification.counting.census import Census
from nonsmooth.runtime.certification.counting.comparing import compare_census
from nonsmooth.runtime.certification.counting.saved import CENSUS, census_of
from nonsmooth.runtime.certification.events.record import EventCertificate, events_claim
from nonsmooth.runtime.certification.events.saved import (
    EVENTS,
    compare_events,
    event_entries,
    events_of,
)
from nonsmooth.runtime.certification.saved import (
    CERTIFICATE,
    certificate_entries,
    certificate_of,
)
from nonsmooth.runtime.errors import InputError
from nonsmooth.runtime.files import read_file
from nonsmooth.runtime.form import WRONG_SHAPE, checksum_of, parsed
from nonsmooth.runtime.values import flint_precision

__all__ = ["Check", "check_certificate"]

Proven = Certificate | BoxCertificate | Census | tuple[EventCertificate, ...]


@dataclass(frozen=True, eq=False)
class Check:
    """The check of a file.

    Attributes
    ----------
    difference : str or None
        What is wrong with it; None if every claim was proved again.
    note : str or None
        What could not be compared, since the system is not there, or is not proved again.
    certificate : Certificate, BoxCertificate, Census, tuple of EventCertificate, or None
        What was proved again; None if something is wrong with it.
    claims : dict of str to {"proved", "refuted", "undecided"}
        Of it.
    """

    difference: str | None
    note: str | None = None
    certificate: Proven | None = None
    claims: Mapping[str, str] = field(default_factory=dict)


class _Kind(NamedTuple):
    """What is done with a file: entries of its format, proof, record, claims, comparison."""

    entries: Callable[[Mapping[str, Any]], None]
    check: Callable[[dict[str, Any]], None]
    of: Callable[[Mapping[str, Any]], Any]
    claims: Callable[[Any], Mapping[str, str]]
    compare: Callable[[Mapping[str, Any], Path], str | None]


_KINDS = {
    CERTIFICATE.name: _Kind(
        certificate_entries, check, certificate_of, attrgetter("claims"), compare_certificate
    ),
    BOX.name: _Kind(BOX.check, check_tiles, box_of, attrgetter("claims"), compare_box),
    EVENTS.name: _Kind(event_entries, check_events, events_of, events_claim, compare_events),
    CENSUS.name: _Kind(CENSUS.check, check_census, census_of, attrgetter("claims"), compare_census),
}


def check_certificate(path: str | os.PathLike[str]) -> Check:
    """Check a file: its checksum, its system, and all its claims, from the file alone.

    Of a census the certificates are checked and that they are of different orbits; the search
    that found no others is not repeated.

    Parameters
    ----------
    path : str or path
        What `save` of a `Certificate`, `BoxCertificate`, `EventCertificate` or `Census` wrote.

    Raises
    ------
    InputError
        If the file cannot be read or is none of these.
    """
    folder = Path(path).parent
    try:
        content = parsed(read_file(Path(path), CERTIFICATE.most, CERTIFICATE.what))
        if not isinstance(content, dict) or content.get("format") not in _KINDS:
            raise InputError("not a certificate, such as --save or save() writes")
        kind = _KINDS[content["format"]]
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
    except WRONG_SHAPE as problem:
        return Check(f"the file is not in order: {type(problem).__name__}: {problem}")
    return Check(None, note, found, kind.claims(found))

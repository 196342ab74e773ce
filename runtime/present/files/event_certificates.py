"""Certificates of events in files: JSON, refused when it is cut, edited or foreign."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from nonsmooth.runtime.checker import Failure
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.result_files import Form, naming
from nonsmooth.runtime.present.checking.box_certificates import compare_box
from nonsmooth.runtime.present.files.orbit_numbers import given_value
from nonsmooth.runtime.proof.certificate import VERSION, Stated, Unknown
from nonsmooth.runtime.proof.events.event_certificate import EventCertificate
from nonsmooth.runtime.proof.statement import rational

__all__ = [
    "EVENTS",
    "check_event_entries",
    "compare_events",
    "event_entries",
    "events_of",
    "load_event_certificates",
    "save_events",
]

EVENTS = Form("nonsmooth event certificate", "file of events", {"events": list}, VERSION)
_EVENT: dict[str, type | tuple[type, ...]] = {
    "orbit": str,
    "system": str,
    "parameters": dict,
    "chosen": list,
    "itinerary": list,
    "kind": str,
    "text": str,
    "parameter": str,
    "phase": (int, type(None)),
    "configuration": str,
    "boundary": str,
    "instant": str,
    "claim": str,
    "reason": str,
    "bits": int,
    "enclosures": dict,
    "box": list,
    "declaration": dict,
    "closing": dict,
}


def save_events(found: Sequence[EventCertificate], path: str | os.PathLike[str]) -> None:
    """Write certificates of events to one file; what was there stays until it is complete.

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    EVENTS.write(path, event_entries(found))


def event_entries(found: Sequence[EventCertificate]) -> dict[str, Any]:
    """What a file of events states."""
    return {"events": [_entry(certificate) for certificate in found]}


def load_event_certificates(path: str | os.PathLike[str]) -> tuple[EventCertificate, ...]:
    """Read certificates of events that `EventCertificate.save` or the command wrote.

    Nothing is proved again.

    Parameters
    ----------
    path : str or path

    Raises
    ------
    InputError
        If the file cannot be read, or is cut, edited or foreign. The message names it.
    """
    with naming(path) as file:
        content = EVENTS.read(file)
        check_event_entries(content)
        return events_of(content)


def check_event_entries(content: Mapping[str, Any]) -> None:
    """Refuse entries that are not those of such a file, or another checksum.

    Raises
    ------
    InputError
    """
    EVENTS.check(content)
    for number, event in enumerate(content["events"], 1):
        if not isinstance(event, dict):
            raise InputError(f"event {number} is none")
        for name in _EVENT.keys() ^ event.keys():
            told = "missing" if name in _EVENT else "unknown"
            raise InputError(f"{name!r} of event {number} is {told}")
        for name, kind in _EVENT.items():
            if not isinstance(event[name], kind) or isinstance(event[name], bool):
                raise InputError(f"{name!r} of event {number} is of the wrong type")


def events_of(content: Mapping[str, Any]) -> tuple[EventCertificate, ...]:
    """The certificates that a file's entries describe."""
    return tuple(map(_event, content["events"]))


def compare_events(content: Mapping[str, Any], folder: Path) -> bool:
    """Compare names, values and declarations with the systems and the orbits that are named.

    Returns
    -------
    bool
        Whether that could be done: the systems are there.

    Raises
    ------
    Failure, InputError
        If they differ.
    """
    compared = []
    for number, event in enumerate(content["events"], 1):
        if event["claim"] != "proved":
            continue
        name = event["parameter"]
        # a dwell time may have the same name: the parameter follows it
        *_, side = (side for side in event["box"] if side["name"] == name)
        middle, radius = rational(side["mid"]), rational(side["rad"])
        box = {name: [str(middle - radius), str(middle + radius)]}
        try:
            compared.append(compare_box({**event, "box": box}, folder))
        except Failure as problem:
            raise Failure(f"event {number}, {event['kind']}: {problem}") from None
    return all(compared)


def _entry(certificate: EventCertificate) -> dict[str, Any]:
    return {
        **certificate.to_json(),
        "declaration": dict(certificate.declaration),
        "closing": dict(certificate.closing),
    }


def _event(event: Mapping[str, Any]) -> EventCertificate:
    bits = event["bits"]
    return EventCertificate(
        event["orbit"],
        event["system"],
        {name: given_value(name, text) for name, text in event["parameters"].items()},
        tuple(event["chosen"]),
        tuple((str(c), str(b)) for c, b in event["itinerary"]),
        event["kind"],
        event["text"],
        event["parameter"],
        None if event["phase"] is None else event["phase"] - 1,
        event["configuration"],
        event["boundary"],
        event["instant"],
        event["claim"],
        event["reason"],
        {n: Stated.of(x["mid"], x["rad"], bits) for n, x in event["enclosures"].items()},
        tuple(Unknown(x["name"], x["mid"], x["rad"]) for x in event["box"]),
        bits,
        event["declaration"],
        event["closing"],
    )

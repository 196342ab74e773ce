"""Certificates of events in files."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal

from nonsmooth.runtime.core.json_codec import FromOne
from nonsmooth.runtime.core.result_files import FileFormat, naming
from nonsmooth.runtime.model.saved_system import system_in
from nonsmooth.runtime.present.files.claim_entries import (
    Enclosures,
    OrbitProofEntries,
    enclosed,
    stated,
)
from nonsmooth.runtime.proof.certificate import VERSION, Unknown
from nonsmooth.runtime.proof.events.event_certificate import EventCertificate

__all__ = ["EVENTS", "event_entries", "events_of", "load_event_certificates", "save_events"]


@dataclass(frozen=True, kw_only=True)
class EventCertificateEntries(OrbitProofEntries):
    """Entries for one event, in a file of events."""

    kind: str
    text: str
    parameter: str
    phase: FromOne
    configuration: str
    boundary: str
    instant: Literal["", "start", "inside", "end"]
    claim: Literal["proved", "undecided"]
    reason: str
    bits: int
    enclosures: Enclosures
    box: tuple[Unknown, ...]
    declaration: Mapping[str, Any]
    closing: Mapping[str, Any]


@dataclass(frozen=True, kw_only=True)
class EventsEntries:
    """Entries of a file of certificates of events."""

    events: tuple[EventCertificateEntries, ...]


EVENTS = FileFormat(
    name="nonsmooth event certificate",
    what="file of events",
    entries=EventsEntries,
    version=VERSION,
)


def save_events(found: Sequence[EventCertificate], path: str | os.PathLike[str]) -> None:
    """Write certificates of a branch's events to one file.

    The file is replaced only when the new one is complete.
    """
    EVENTS.write(path, event_entries(found))


def event_entries(found: Sequence[EventCertificate]) -> EventsEntries:
    """Entries of the file of certificates of a branch's events."""
    return EventsEntries(events=tuple(stated(EventCertificateEntries, each) for each in found))


def load_event_certificates(path: str | os.PathLike[str]) -> tuple[EventCertificate, ...]:
    """Read certificates of events that `EventCertificate.save` or the command wrote.

    Nothing is proved again. An `InputError` with the file's name is raised if the file
    cannot be read, or is cut, edited or foreign.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> branch = ns.continue_orbit(ns.solve("dry-friction/symmetric"), "V", (0.6, 1.3))
    >>> (flip,) = [event for event in branch.events if event.kind == "flip"]
    >>> ns.certify.event(branch, flip).save("flip.json")
    >>> [found.proved for found in ns.load("flip.json")]
    [True]
    """
    with naming(path) as file:
        return events_of(EVENTS.read(file))


def events_of(entries: EventsEntries) -> tuple[EventCertificate, ...]:
    """The certificates of events that a file's entries describe, in the order of the file."""
    return tuple(map(_event, entries.events))


def _event(entries: EventCertificateEntries) -> EventCertificate:
    own = {**vars(entries)}
    system_in(entries.system, own.pop("tables"))
    return EventCertificate(**{**own, "enclosures": enclosed(entries.enclosures, entries.bits)})

"""The check of certificates, maps, events, censuses and chaos in files.

A file is checked in three ways: its checksum and its shape; the checker proves every claim again
from the file alone; and names, values and declaration are compared with those of the system: of the
built-in one, or of the one that the file holds as data. What a user declares is run, and
compared, only where it is named.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import dataclass, field, fields, is_dataclass, replace
from typing import Any

from nonsmooth.runtime.checker import CHECKS, Failure, Malformed
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.files import path_of, read_file
from nonsmooth.runtime.core.json_codec import Inconsistent, encode
from nonsmooth.runtime.core.parallel import check_workers
from nonsmooth.runtime.core.registry import Shown
from nonsmooth.runtime.core.result_files import WRONG_SHAPE, parsed
from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.model.kernels import SystemKernels, load_orbit, load_system
from nonsmooth.runtime.model.saved_system import same_system
from nonsmooth.runtime.present.compare_declarations import check_domains, compare
from nonsmooth.runtime.present.files.kept import format_named
from nonsmooth.runtime.proof.branch.certified_branch import EventCertificates, events_claim

_MOST = 500_000_000  # bytes of a file
_HELD = "{} is the system as the file holds it: no declaration was run"
_NOT_CALLED = "what the orbit and its unknowns are called was not compared"
_NOT_TOLD = "why is not proved again"


@dataclass(frozen=True, eq=False, repr=False)
class Check(Shown):
    """The check of a file.

    Attributes
    ----------
    difference : str or None
        What is wrong with it; None if every claim was proved again.
    note : str or None
        What is not compared, or not proved again.
    certificate : Certificate, BoxCertificate, CertifiedBranch, CertifiedDoubling, Census,
        ChaosCertificate, BasinCertificate, RegionCertificate, tuple, or None
        What was read, of events a tuple of EventCertificate; None if something is wrong with it.
        Its reasons why something is undecided are left out: nothing proves them. Which
        parameters were chosen is as the file says.
    claims : dict of str to {"proved", "refuted", "undecided"}
        What was proved again.
    compared : bool
        Whether the orbit is the one of its system that has the name that the file gives.
    """

    difference: str | None
    note: str | None = None
    certificate: Any = None
    claims: Mapping[str, str] = field(default_factory=dict)
    compared: bool = False


_DIVIDED = "nonsmooth basin certificate"  # whose check takes processes, and tells how far it is


def _claims(found: Any) -> Mapping[str, str]:
    """The claims that are proved again."""
    return events_claim(found) if isinstance(found, tuple) else found.claims


def check_certificate(
    path: str | os.PathLike[str],
    declared: str | None = None,
    *,
    workers: int = 1,
    progress: Callable[[int, int], object] = lambda done, count: None,
) -> Check:
    """Check a file: its checksum, its system, and all its claims, from the file alone.

    Parameters
    ----------
    path : str or path
        What `save` of a `Certificate`, `BoxCertificate`, `CertifiedBranch`, `CertifiedDoubling`,
        `EventCertificate`, `ChaosCertificate`, `BasinCertificate`, `RegionCertificate` or `Census`
        wrote.
    declared : str, optional
        A system or an orbit by name, such as ``FILE.py:ORBIT``: its tables have to be those of
        the file. Without it nothing that a user declares is run.
    workers : int
        Processes that prove parts of a basin; other checks run in this one.
    progress : callable
        Told how many tiles of a basin, of how many, are proved again.

    Returns
    -------
    Check
        Whether all claims hold, and what was checked.

    Raises
    ------
    InputError
        If the file cannot be read, is none of these, or has entries that are missing, unknown
        or of another type; or for a wrong number of workers.
    NoConvergence
        If a process of `workers` ends, for want of memory perhaps.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> ns.certify(ns.solve("dry-friction/global-stick")).save("proof.json")
    >>> check = ns.certify.check("proof.json")
    >>> check.difference is None, check.claims["existence"]
    (True, 'proved')
    """
    check_workers(workers)
    system = None if declared is None else _declared_system(declared)
    place = path_of(path)
    try:
        content = parsed(read_file(place, _MOST, "certificate"))
        named = str(content.get("format")) if isinstance(content, dict) else ""
        if named not in CHECKS:
            raise InputError("not a certificate, such as --save or save() writes")
        with suppress(Inconsistent):  # which is a difference
            format_named(named).check_entries(content)
    except (Failure, ValueError, OverflowError) as problem:
        raise InputError(f"{os.fspath(path)}: {problem}") from None
    try:
        for told in _told(content):
            check_domains(told)  # before anything is proved of such values
        with flint_precision(64):  # the one precision of the process is kept
            CHECKS[named](content, *((workers, progress) if named == _DIVIDED else ()))
        found = format_named(named).check(content)
        if any(content[name] != entry for name, entry in encode(found).items()):
            return Check("what follows from other entries is not what the file says")
        if isinstance(found, EventCertificates):
            found = found.events
        compared = compare(content)
        if system is not None and not all(
            same_system(system, load_system(name))
            for name in dict.fromkeys(entry["system"] for entry in _told(content))
        ):
            raise Failure(f"the declaration of {declared} is not that of the file, or has changed")
    except Malformed as problem:
        raise InputError(f"{os.fspath(path)}: {problem}") from None
    except (Failure, InputError) as problem:
        return Check(str(problem))
    except WRONG_SHAPE as problem:
        return Check(f"the file is not in order: {type(problem).__name__}: {problem}")
    note = _note(content, compared, held=declared is None)
    return Check(None, note, _without_reasons(found), _claims(found), compared)


def _without_reasons(found: Any) -> Any:
    """A record without the texts that say why something is not proved: nothing proves these."""
    if type(found) is tuple:
        parts = tuple(map(_without_reasons, found))
        return parts if any(x is not y for x, y in zip(parts, found, strict=True)) else found
    if not is_dataclass(found) or isinstance(found, type):
        return found
    changed: dict[str, Any] = {}
    for name in (entry.name for entry in fields(found)):
        own = getattr(found, name)
        if name in ("reasons", "no_derivatives"):
            changed[name] = dict.fromkeys(own, _NOT_TOLD)
        elif name in ("reason", "end") and isinstance(own, str):
            changed[name] = own and _NOT_TOLD
        elif (new := _without_reasons(own)) is not own:
            changed[name] = new
    return replace(found, **changed) if changed else found


def _declared_system(declared: str) -> SystemKernels:
    """The system that a declaration names, alone or with an orbit."""
    try:
        return load_system(declared)
    except InputError:
        return load_orbit(declared).system


def _told(content: Mapping[str, Any]) -> list[Mapping[str, Any]]:
    """The parts of a file that name a system: its events, its branches, or the whole."""
    if "doubled" in content:
        return [part["branch"] for part in (content, content["doubled"]) if part is not None]
    found: list[Mapping[str, Any]] = content.get("events", [content])
    return found


def _note(content: Mapping[str, Any], compared: bool, *, held: bool) -> str | None:
    """A note on what was not checked; None if there is nothing to note."""
    notes = []
    told = _told(content)
    names = dict.fromkeys(entry["system"] for entry in told if entry["tables"] is not None)
    if names and held:
        notes.append(_HELD.format(", ".join(names)))
    if not compared:
        notes.append(_NOT_CALLED)
    return "; ".join(notes) or None

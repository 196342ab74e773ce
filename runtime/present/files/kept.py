"""Kinds of results in files: what was explored, and what was proved.

A record's annotations say what its file holds; an orbit in it is the whole content of its own
file, and is checked as a saved orbit is. A new kind of result is one more of `KINDS`.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from importlib import import_module
from typing import TYPE_CHECKING, Any, NamedTuple

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.result_files import FileFormat
from nonsmooth.runtime.model.saved_system import SAVED_VERSION

if TYPE_CHECKING:
    from nonsmooth.runtime.explore.continuation.branch import Branch, Locus
    from nonsmooth.runtime.explore.design.optimum import Design
    from nonsmooth.runtime.explore.finding.sweep import Sweep
    from nonsmooth.runtime.explore.fitting.fit import Fit
    from nonsmooth.runtime.proof.boxes.box_certificate import BoxCertificate
    from nonsmooth.runtime.proof.branch.certified_branch import (
        EventCertificate,
        EventCertificates,
    )
    from nonsmooth.runtime.proof.sets.basin_certificate import BasinCertificate

_PROOF = 4 + SAVED_VERSION  # version of the files of proofs
_PLANE = 2  # parameters of a box with curves


def _check_branch(branch: Branch) -> None:
    count, names, orbit = len(branch), branch.unknown_names, branch.orbit
    columns = (
        branch.unknowns, branch.period, branch.multipliers, branch.trace, branch.stability,
        branch.admissible,
    )  # fmt: skip
    if not 0 <= branch.start < count or any(len(column) != count for column in columns):
        raise InputError("its points do not belong together")
    if branch.parameter not in orbit.given:
        raise InputError(f"its orbit has no parameter {branch.parameter!r}")
    from nonsmooth.runtime.orbits.equations import equations_of

    if names != tuple(equations_of(orbit, branch.parameter).unknowns):
        raise InputError("its unknowns are not those of its orbit")
    _check_unknowns(branch)
    for event in branch.events:
        if tuple(event.unknowns) != names or event.parameter != branch.parameter:
            raise InputError(f"the {event.kind} is not one of its orbit")
        if not 0 <= event.place <= count - 1:
            raise InputError(f"the {event.kind} is at no place of it")


def _check_locus(locus: Locus) -> None:
    shape = (len(locus.unknowns), 2)
    if locus.values.shape != shape or not 0 <= locus.start < len(locus):
        raise InputError("its points do not belong together")
    _check_unknowns(locus)


def _check_unknowns(found: Branch | Locus) -> None:
    if found.unknowns.shape[1] != len(found.unknown_names):
        raise InputError("its unknowns are not as many as their names")


def _check_design(design: Design) -> None:
    names = (*design.parameters, *design.quantities)
    count = len(design.parameters)
    if design.bounds.shape != (count, 2) or design.history.shape[1:] != (len(names),):
        raise InputError("its numbers do not belong together")
    if set(design.before) != set(names) or set(design.after) != set(names):
        raise InputError("its values are not those of its parameters and quantities")
    for name, (low, high) in zip(design.parameters, design.bounds.tolist(), strict=True):
        for each, values in ((design.start, design.before), (design.orbit, design.after)):
            if name not in each.given or float(each.given[name]) != values[name]:
                raise InputError(f"the {name} of an orbit in it is another one")
            if not low <= values[name] <= high:
                raise InputError(f"its {name} is not in its bounds")
    if design.status not in (0, 1):
        raise InputError(f"{design.status} is no status")
    if bool(design.quantity) == (design.aim == "solve") or (
        design.quantity and design.quantity not in design.quantities
    ):
        raise InputError("what was asked for is not among its quantities")
    wanted = {name for name in design.quantities if name != "multiplier"}
    if set(design.gradient) != wanted or any(
        set(rates) != set(design.parameters) for rates in design.gradient.values()
    ):
        raise InputError("its gradient is not that of its quantities")


def _check_sweep(sweep: Sweep) -> None:
    count = len(sweep.values)
    together = len(sweep.samples) == len(sweep.outcomes) == count
    if not together or not 0 <= sweep.done <= count:
        raise InputError("its values and samples do not belong together")


def _check_fit(fit: Fit) -> None:
    count = len(fit.names)
    shapes = {
        (count,): (fit.estimates, fit.lower, fit.upper),
        (count, count): (fit.covariance,),
        (count, 2): (fit.bounds,),
    }
    fits = all(part.shape == shape for shape, parts in shapes.items() for part in parts)
    for one in fit.experiments:
        rows = len(one.responses)
        for each in one.series:
            parts = (each.places, each.times, each.values, each.fitted, each.sigma)
            fits &= len({len(part) for part in parts}) == 1
            fits &= (each.kind == "response") == bool(rows)
            fits &= not rows or bool((each.places < rows).all())
    if not fits:
        raise InputError("its names, numbers and series do not belong together")


def _check_basin(found: BasinCertificate) -> None:
    from nonsmooth.runtime.proof.sets.graph_certificate import check_size

    for grid, each in ((found.grid, found.ranks), (found.tiles, found.looked)):
        check_size(each, 0 if grid is None else len(grid))
    if tuple(found.box) != (() if found.tiles is None else found.states):
        raise InputError("'box' has other states than the tiles")


def _check_box(found: BoxCertificate) -> None:
    if sum(tile.place.share for tile in found.tiles) != 1:
        raise InputError("its tiles do not fill the box")
    if len(found.box) != _PLANE and any(tile.event is not None for tile in found.tiles):
        raise InputError("a curve crosses no parameter of the box")


class KeptKind(NamedTuple):
    """A kind of result file, whose record is imported when there is one to read or write."""

    what: str  # what the file holds, in words
    record: str  # module, as it is imported from `nonsmooth.runtime`, and class
    version: int
    together: Callable[[Any], None] = lambda record: None  # raises InputError for entries that
    # do not belong together


# by the format that a file names
KINDS: dict[str, KeptKind] = {
    "nonsmooth branch": KeptKind(
        "saved branch", ".explore.continuation.branch:Branch", 4, _check_branch
    ),
    "nonsmooth locus": KeptKind(
        "saved curve of events", ".explore.continuation.branch:Locus", 3, _check_locus
    ),
    "nonsmooth design": KeptKind(
        "saved design", ".explore.design.optimum:Design", 2, _check_design
    ),
    "nonsmooth sweep": KeptKind(
        "saved sweep", ".explore.finding.sweep:Sweep", 2 + SAVED_VERSION, _check_sweep
    ),
    "nonsmooth fit": KeptKind(
        "saved fit", ".explore.fitting.fit:Fit", 1 + SAVED_VERSION, _check_fit
    ),
    "nonsmooth certificate": KeptKind("certificate", ".proof.certificate:Certificate", _PROOF),
    "nonsmooth box certificate": KeptKind(
        "certificate of a box",
        ".proof.boxes.box_certificate:BoxCertificate",
        _PROOF + 2,
        _check_box,
    ),
    "nonsmooth event certificate": KeptKind(
        "set of certificates of events",
        ".proof.branch.certified_branch:EventCertificates",
        _PROOF,
    ),
    "nonsmooth certified branch": KeptKind(
        "certified branch", ".proof.branch.certified_branch:CertifiedBranch", _PROOF
    ),
    "nonsmooth certified doubling": KeptKind(
        "certified doubling",
        ".proof.branch.certified_branch:CertifiedDoubling",
        1 + SAVED_VERSION,
    ),
    "nonsmooth census": KeptKind("census", ".proof.census:Census", _PROOF),
    "nonsmooth basin certificate": KeptKind(
        "certificate of a basin",
        ".proof.sets.basin_certificate:BasinCertificate",
        _PROOF,
        _check_basin,
    ),
    "nonsmooth chaos certificate": KeptKind(
        "certificate of chaos", ".proof.chaos.chaos_certificate:ChaosCertificate", _PROOF
    ),
    "nonsmooth region certificate": KeptKind(
        "certificate of a region",
        ".proof.sets.graph_certificate:RegionCertificate",
        _PROOF,
    ),
}


def format_named(name: str) -> FileFormat[Any]:
    """The format of a name among `KINDS`."""
    kind = KINDS[name]
    module, _, record = kind.record.partition(":")
    entries = getattr(import_module(module, "nonsmooth.runtime"), record)
    return FileFormat(
        name=name, what=kind.what, entries=entries, version=kind.version, together=kind.together
    )


def save_result(result: Any, path: str | os.PathLike[str]) -> None:
    """Write a result to a file, which is replaced only when the new one is complete.

    An event's certificate is kept as the only one of its file, several in their order.
    """
    if type(result).__name__ == "EventCertificate":
        result = [result]
    if isinstance(result, Sequence):
        from nonsmooth.runtime.proof.branch.certified_branch import EventCertificates

        result = EventCertificates(events=tuple(result))
    own = type(result).__name__
    named = next(name for name, kind in KINDS.items() if kind.record.partition(":")[2] == own)
    format_named(named).write(path, result)


def load_events(path: str | os.PathLike[str]) -> tuple[EventCertificate, ...]:
    """The certificates of events in a file, in its order."""
    found: EventCertificates = format_named("nonsmooth event certificate").load(path)
    return found.events

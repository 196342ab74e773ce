"""What was explored, in files: branches, curves of events, designs, sweeps and fits.

A record's annotations say what its file holds; an orbit in it is the whole content of its own
file, and is checked as a saved orbit is.
"""

from __future__ import annotations

import os
from typing import Any

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.result_files import FileFormat
from nonsmooth.runtime.explore.continuation.branch import Branch
from nonsmooth.runtime.explore.continuation.continue_event import Locus
from nonsmooth.runtime.explore.continuation.orbit_family import OrbitFamily
from nonsmooth.runtime.explore.design.optimum import Design
from nonsmooth.runtime.explore.finding.sweep import Sweep
from nonsmooth.runtime.explore.fitting.fit_record import Fit
from nonsmooth.runtime.model.saved_system import SAVED_VERSION

__all__ = ["BRANCH", "DESIGN", "FIT", "LOCUS", "SWEEP", "save_result"]


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
    if names != tuple(OrbitFamily(orbit, branch.parameter).names):
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


BRANCH = FileFormat(
    name="nonsmooth branch", what="saved branch", entries=Branch, version=4, together=_check_branch
)
LOCUS = FileFormat(
    name="nonsmooth locus",
    what="saved curve of events",
    entries=Locus,
    version=3,
    together=_check_locus,
)
DESIGN = FileFormat(
    name="nonsmooth design", what="saved design", entries=Design, version=2, together=_check_design
)
SWEEP = FileFormat(
    name="nonsmooth sweep",
    what="saved sweep",
    entries=Sweep,
    version=2 + SAVED_VERSION,
    together=_check_sweep,
)
FIT = FileFormat(
    name="nonsmooth fit",
    what="saved fit",
    entries=Fit,
    version=1 + SAVED_VERSION,
    together=_check_fit,
)
_FORMATS: dict[type, FileFormat[Any]] = {
    each.entries: each for each in (BRANCH, LOCUS, DESIGN, SWEEP, FIT)
}


def save_result(result: Any, path: str | os.PathLike[str]) -> None:
    """Write a result to a file, which is replaced only when the new one is complete."""
    _FORMATS[type(result)].write(path, result)

"""Designs in files: what was asked and found, with the orbits where it began and ended."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated, Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.json_codec import (
    AnyDigits,
    AnyTable,
    Digits,
    Table,
    encode,
    nan_as_null,
    one_of,
)
from nonsmooth.runtime.core.result_files import FileFormat, naming
from nonsmooth.runtime.explore.design.optimum import AIMS, ActiveLimit, Design, DesignCondition
from nonsmooth.runtime.present.files.orbits import orbit_content, orbit_in

__all__ = ["design_json", "load_design", "save_design"]


@dataclass(frozen=True, kw_only=True)
class DesignEntries:
    """Entries of the file of a design; `start` and `orbit` are contents of orbits' files."""

    aim: Annotated[str, one_of(AIMS)]
    quantity: str
    parameters: tuple[str, ...]
    bounds: Table
    worst_over: Mapping[str, tuple[Digits, Digits]]
    conditions: tuple[DesignCondition, ...]
    method: str
    quantities: tuple[str, ...]
    before: Mapping[str, Digits]
    after: Mapping[str, Digits]
    worst_at: tuple[Digits, ...]
    gradient: Mapping[str, Mapping[str, AnyDigits]]
    active: tuple[ActiveLimit, ...]
    corner: str
    residual: Digits
    history: AnyTable
    status: int
    message: str
    start: tuple[Any]
    orbit: tuple[Any]


_DESIGN = FileFormat(name="nonsmooth design", what="saved design", entries=DesignEntries)


def save_design(design: Design, path: str | os.PathLike[str]) -> None:
    """Write a design to a file, which is replaced only when the new one is complete."""
    _DESIGN.write(path, _entries(design))


def _entries(design: Design) -> DesignEntries:
    own = {name: getattr(design, name) for name in DesignEntries.__dataclass_fields__}
    orbits = {name: (orbit_content(own[name]),) for name in ("start", "orbit")}
    return DesignEntries(**{**own, **orbits})


def design_json(design: Design) -> dict[str, Any]:
    """A design as JSON, without its orbits' files.

    Numbers are decimal strings, and null if unknown.
    """
    from nonsmooth.runtime.present.report import orbit_json

    told = encode(_entries(design))
    told = {name: entry for name, entry in told.items() if name not in ("start", "orbit")}
    conditions = [each.text for each in design.conditions]
    found = {**told, "conditions": conditions, "orbit": orbit_json(design.orbit)}
    return {name: nan_as_null(entry) for name, entry in found.items()}


def load_design(path: str | os.PathLike[str]) -> Design:
    """Read a design that `Design.save` wrote.

    An `InputError` with the file's name is raised if the file cannot be read, is cut,
    edited or foreign, or if an orbit in it does not belong to the installed system.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> orbit = ns.solve("dry-friction/symmetric")
    >>> ns.design(orbit, solve={"multiplier": -1}, over={"V": (0.6, 1.3)}).save("design.json")
    >>> ns.load("design.json").message
    'the wanted values are met'
    """
    with naming(path) as file:
        return _design(_DESIGN.read(file))


def _design(entries: DesignEntries) -> Design:
    start, orbit = orbit_in(entries.start[0]), orbit_in(entries.orbit[0])
    names = (*entries.parameters, *entries.quantities)
    count = len(entries.parameters)
    if entries.bounds.shape != (count, 2) or entries.history.shape[1:] != (len(names),):
        raise InputError("its numbers do not belong together")
    if set(entries.before) != set(names) or set(entries.after) != set(names):
        raise InputError("its values are not those of its parameters and quantities")
    for name, (low, high) in zip(entries.parameters, entries.bounds.tolist(), strict=True):
        for each, values in ((start, entries.before), (orbit, entries.after)):
            if name not in each.given or float(each.given[name]) != values[name]:
                raise InputError(f"the {name} of an orbit in it is another one")
            if not low <= values[name] <= high:
                raise InputError(f"its {name} is not in its bounds")
    if entries.status not in (0, 1):
        raise InputError(f"{entries.status} is no status")
    if bool(entries.quantity) == (entries.aim == "solve") or (
        entries.quantity and entries.quantity not in entries.quantities
    ):
        raise InputError("what was asked for is not among its quantities")
    wanted = {name for name in entries.quantities if name != "multiplier"}
    if set(entries.gradient) != wanted or any(
        set(rates) != set(entries.parameters) for rates in entries.gradient.values()
    ):
        raise InputError("its gradient is not that of its quantities")
    own: dict[str, Any] = {**vars(entries), "history": np.asarray(entries.history)}
    return Design(**{**own, "start": start, "orbit": orbit})

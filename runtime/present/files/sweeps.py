"""Bifurcation diagrams in files: all that was asked, and what was found until an interruption."""

from __future__ import annotations

import os
from dataclasses import dataclass

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.result_files import FileFormat, naming
from nonsmooth.runtime.explore.finding.sweep import Sweep
from nonsmooth.runtime.model.kernels import known_system
from nonsmooth.runtime.model.saved_system import SAVED_VERSION, SavedSystem, named, system_in

__all__ = ["load_sweep", "save_sweep"]


@dataclass(frozen=True, kw_only=True)
class SweepEntries(Sweep):
    """Entries of the file of a diagram, with its system as data if that is not built in."""

    tables: SavedSystem | None


_SWEEP = FileFormat(
    name="nonsmooth sweep", what="saved sweep", entries=SweepEntries, version=2 + SAVED_VERSION
)


def save_sweep(diagram: Sweep, path: str | os.PathLike[str]) -> None:
    """Write a diagram, complete or not, to a file.

    The file is replaced only when the new one is complete.
    """
    system, _, saved = named(known_system(diagram.system))
    entries = {**vars(diagram), "system": system, "tables": saved}
    _SWEEP.write(path, SweepEntries(**entries))


def load_sweep(path: str | os.PathLike[str]) -> Sweep:
    """Read a diagram that `Sweep.save` wrote.

    An `InputError` with the file's name is raised if the file cannot be read, or is cut,
    edited or foreign.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> data = dict(chi="0.5", eta=1, us1=1, us2=1, ur1="4.0195", ur2="1.4831")
    >>> ns.sweep(
    ...     "dry-friction", data, "V", [0.9, 1.0], dict(x1=0, x2=0, v1=0, v2=0),
    ...     state="x1", configuration="stick-stick", transient=40, samples=12,
    ... ).save("diagram.json")
    >>> ns.load("diagram.json").parameter
    'V'
    """
    with naming(path) as file:
        entries = {**vars(_SWEEP.read(file))}
        system_in(entries["system"], entries.pop("tables"))
        diagram = Sweep(**entries)
        count = len(diagram.values)
        together = len(diagram.samples) == len(diagram.outcomes) == count
        if not together or not 0 <= diagram.done <= count:
            raise InputError("its values and samples do not belong together")
        return diagram

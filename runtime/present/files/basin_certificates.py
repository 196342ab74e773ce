"""Certificates of basins in files."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from nonsmooth.runtime.core.box_grid import BoxGrid
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.json_codec import Exact
from nonsmooth.runtime.core.result_files import FileFormat
from nonsmooth.runtime.core.values import Value
from nonsmooth.runtime.model.kernels import known_system
from nonsmooth.runtime.model.saved_system import SavedSystem, named, system_in
from nonsmooth.runtime.present.files.chaos_certificates import HSetEntries
from nonsmooth.runtime.proof.basin.basin_certificate import BasinCertificate
from nonsmooth.runtime.proof.certificate import VERSION
from nonsmooth.runtime.proof.chaos.h_sets import HSet

__all__ = ["BASIN", "basin_entries", "basin_of", "load_basin_certificate", "save_basin"]

_MOST = 10**8  # boxes of a grid


@dataclass(frozen=True, kw_only=True)
class GridEntries:
    """What a file states of a grid of boxes."""

    exponents: tuple[int, ...]
    first: tuple[int, ...]
    counts: tuple[int, ...]


@dataclass(frozen=True, kw_only=True)
class BasinEntries:
    """What a file of a basin states.

    Ranks, and of tiles 0, 1 if they were looked at and 2 if they are attracted, are runs: a
    number, and how often it follows.
    """

    system: str
    tables: SavedSystem | None
    orbit: str
    parameters: Mapping[str, Value]
    claim: Literal["proved", "undecided"]
    reason: str
    configuration: str
    phase: tuple[Exact, ...]
    source: str
    boundary: str
    coordinates: tuple[str, ...]
    core: HSetEntries | None
    iterates: int
    itinerary: tuple[tuple[str, str, str], ...]
    contraction: Exact
    grid: GridEntries | None
    ranks: tuple[tuple[int, int], ...]
    tiles: GridEntries | None
    states: tuple[str, ...]
    verdicts: tuple[tuple[int, int], ...]
    widest: float
    most: int
    bits: int
    declaration: Mapping[str, Any]


BASIN = FileFormat(
    name="nonsmooth basin certificate",
    what="certificate of a basin",
    entries=BasinEntries,
    version=VERSION,
)


def save_basin(found: BasinCertificate, path: str | os.PathLike[str]) -> None:
    """Write a certificate of a basin; what was there stays until it is complete.

    Parameters
    ----------
    found : BasinCertificate
    path : str or path
        The file.

    Raises
    ------
    InputError
        If the file cannot be written, or cannot state the contact law that decides.
    """
    if found.proved and not found.declaration:
        raise InputError(
            "not saved: a law of coupled contacts decides what follows a transition here, and a"
            " file of a basin states listed transitions alone"
        )
    BASIN.write(path, basin_entries(found))


def basin_entries(found: BasinCertificate) -> BasinEntries:
    """What a file of a basin states.

    Parameters
    ----------
    found : BasinCertificate

    Returns
    -------
    BasinEntries
        Ready to be written.
    """
    name, _, saved = named(known_system(found.system, None))
    core, numbers = found.core, ("iterates", "itinerary", "most", "bits", "widest")
    texts = ("orbit", "claim", "reason", "configuration", "source", "boundary")
    return BasinEntries(
        system=name,
        tables=saved,
        parameters=dict(found.parameters),
        phase=found.phase,
        coordinates=found.coordinates,
        core=None
        if core is None
        else HSetEntries(name=core.name, centre=core.centre, sides=core.sides),
        contraction=found.contraction,
        grid=_grid_entries(found.grid),
        ranks=_runs(found.ranks),
        tiles=_grid_entries(found.tiles),
        states=found.states,
        verdicts=_runs(found.looked.astype(int) + found.attracted),
        declaration=dict(found.declaration),
        **{key: getattr(found, key) for key in (*texts, *numbers)},
    )


def basin_of(entries: BasinEntries) -> BasinCertificate:
    """The certificate that a file's entries describe.

    Parameters
    ----------
    entries : BasinEntries
        As they were read.

    Returns
    -------
    BasinCertificate

    Raises
    ------
    InputError
        If a grid has another number of boxes than is told of.
    """
    own = {**vars(entries)}
    system_in(entries.system, own.pop("tables"))
    core, verdicts = entries.core, _listed(own.pop("verdicts"), entries.tiles)
    return BasinCertificate(
        **{
            **own,
            "core": None if core is None else HSet(core.name, core.centre, core.sides),
            "grid": _grid(entries.grid),
            "ranks": _listed(entries.ranks, entries.grid),
            "tiles": _grid(entries.tiles),
            "looked": verdicts > 0,
            "attracted": verdicts > 1,
        }
    )


def _grid(entries: GridEntries | None) -> BoxGrid | None:
    if entries is None:
        return None
    return BoxGrid(entries.exponents, entries.first, entries.counts)


def _grid_entries(grid: BoxGrid | None) -> GridEntries | None:
    if grid is None:
        return None
    return GridEntries(exponents=grid.exponents, first=grid.first, counts=grid.counts)


def _runs(values: NDArray[np.int_]) -> tuple[tuple[int, int], ...]:
    if not values.size:
        return ()
    starts = np.flatnonzero(np.r_[True, values[1:] != values[:-1]])
    lengths = np.diff(np.r_[starts, values.size])
    return tuple((int(values[k]), int(n)) for k, n in zip(starts, lengths, strict=True))


def _listed(runs: Sequence[tuple[int, int]], grid: GridEntries | None) -> NDArray[np.int_]:
    size = 0 if grid is None else int(np.prod([float(n) for n in grid.counts]))
    if size > _MOST or any(n < 1 for _, n in runs) or sum(n for _, n in runs) != size:
        raise InputError("a grid has another number of boxes than is told of")
    return np.repeat([x for x, _ in runs] or [0], [n for _, n in runs] or [0])


load_basin_certificate = BASIN.reader(basin_of)

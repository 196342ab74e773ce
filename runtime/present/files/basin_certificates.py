"""Certificates of basins in files."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Literal

from nonsmooth.runtime.core.box_grid import BoxGrid
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.json_codec import Exact
from nonsmooth.runtime.core.result_files import FileFormat
from nonsmooth.runtime.core.values import Value
from nonsmooth.runtime.model.saved_system import SavedSystem, named, system_in
from nonsmooth.runtime.present.files.chaos_certificates import HSetEntries
from nonsmooth.runtime.present.files.claim_entries import system_of
from nonsmooth.runtime.present.files.grid_entries import (
    GridEntries,
    Runs,
    grid_entries,
    grid_of,
    listed,
    runs,
)
from nonsmooth.runtime.proof.basin.basin_certificate import BasinCertificate
from nonsmooth.runtime.proof.certificate import VERSION
from nonsmooth.runtime.proof.chaos.h_sets import HSet

__all__ = ["BASIN", "basin_entries", "basin_of", "load_basin_certificate", "save_basin"]


@dataclass(frozen=True, kw_only=True)
class BasinEntries:
    """Entries of the file of a basin certificate.

    Ranks of boxes, and verdicts on tiles, are runs: a value, and how many times it follows.
    A verdict is 1 if the tile was examined, 2 if it is attracted, else 0.
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
    ranks: Runs
    tiles: GridEntries | None
    states: tuple[str, ...]
    box: Mapping[str, tuple[float, float]]
    verdicts: Runs
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
    """Write a basin certificate to a file, which is replaced only when the new one is complete.

    `InputError` is raised if the file cannot be written.
    """
    BASIN.write(path, basin_entries(found))


def basin_entries(found: BasinCertificate) -> BasinEntries:
    """Entries of the file of a basin certificate."""
    name, orbit, saved = named(system_of(found), found.orbit)
    core, numbers = found.core, ("iterates", "itinerary", "most", "bits", "widest")
    texts = ("claim", "reason", "configuration", "source", "boundary")
    return BasinEntries(
        system=name,
        tables=saved,
        orbit=orbit,
        parameters=dict(found.parameters),
        phase=found.phase,
        coordinates=found.coordinates,
        core=None
        if core is None
        else HSetEntries(name=core.name, centre=core.centre, sides=core.sides),
        contraction=found.contraction,
        grid=None if found.grid is None else grid_entries(found.grid),
        ranks=runs(found.ranks),
        tiles=None if found.tiles is None else grid_entries(found.tiles),
        states=found.states,
        box=dict(found.box),
        verdicts=runs(found.looked.astype(int) + found.attracted),
        declaration=dict(found.declaration),
        **{key: getattr(found, key) for key in (*texts, *numbers)},
    )


def basin_of(entries: BasinEntries) -> BasinCertificate:
    """The basin certificate that a file's entries describe.

    `InputError` is raised if a grid has another number of boxes than the entries list.
    """
    own = {**vars(entries)}
    system_in(entries.system, own.pop("tables"))
    grid = None if entries.grid is None else grid_of(entries.grid)
    tiles = None if entries.tiles is None else grid_of(entries.tiles)
    if tuple(entries.box) != (() if tiles is None else entries.states):
        raise InputError("'box' has other states than the tiles")
    core, verdicts = entries.core, listed(own.pop("verdicts"), _size(tiles))
    return BasinCertificate(
        **{
            **own,
            "core": None if core is None else HSet(core.name, core.centre, core.sides),
            "grid": grid,
            "ranks": listed(entries.ranks, _size(grid)),
            "tiles": tiles,
            "looked": verdicts > 0,
            "attracted": verdicts > 1,
        }
    )


def _size(grid: BoxGrid | None) -> int:
    return 0 if grid is None else len(grid)


load_basin_certificate = BASIN.reader(basin_of)

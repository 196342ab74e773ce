"""A chart in files: a Zarr group whose chunks carry a CRC.

A chunk of the grid is done when the objects of all variables are there and pass their CRC.
There is no other record of it, so that a process may be killed at any instant. Objects are
written beside their place and moved there; what a killed process leaves is `*.partial`.
"""

from __future__ import annotations

import json
import os
import secrets
import shutil
from collections.abc import Iterable, Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError, missing_extra
from nonsmooth.runtime.core.files import unwritable
from nonsmooth.runtime.explore.charting.grid import BLOCK, Axis, Grid
from nonsmooth.runtime.explore.charting.problem import Problem, Variable

__all__ = [
    "ATTRIBUTE",
    "FORMAT",
    "Store",
    "check_zarr",
    "open_arrays",
    "open_store",
    "read_identity",
    "write_chunk",
]

ATTRIBUTE, FORMAT = "nonsmooth", "nonsmooth chart 1"
_PARTIAL = ".partial"
_METADATA = "zarr.json"
_CRC = 4  # bytes behind the content


def check_zarr() -> None:
    """Say so if Zarr or xarray are not installed."""
    for name in ("zarr", "xarray"):
        try:
            __import__(name)
        except ImportError:
            raise missing_extra("chart", name) from None


@dataclass(frozen=True, eq=False)
class Store:
    """A store that fits its problem and its grid.

    Attributes
    ----------
    path : Path
    problem : Problem
    grid : Grid
        With the store's own chunks.
    """

    path: Path
    problem: Problem
    grid: Grid

    def objects(self, number: int) -> list[Path]:
        """Files of a chunk of the grid, one for each variable."""
        place = [str(i) for i in self.grid.place(number)]
        return [self.path.joinpath(v.name, "c", *place) for v in self.problem.variables()]

    def holds(self, number: int) -> bool:
        """Whether all objects of a chunk are there."""
        return all(file.is_file() for file in self.objects(number))

    def missing(self) -> tuple[list[int], int]:
        """Chunks that are not done, and how many of these are damaged."""
        there = self._present() == len(self.problem.variables())
        done = there.copy()
        complete = np.flatnonzero(there)
        with ThreadPoolExecutor() as pool:
            done[complete] = list(pool.map(self._sound, complete.tolist()))
        return np.flatnonzero(~done).tolist(), int((there & ~done).sum())

    def _sound(self, number: int) -> bool:
        """Whether all objects of a chunk pass their CRC; removes those that do not."""
        damaged = [file for file in self.objects(number) if not _passes(file)]
        for file in damaged:
            file.unlink(missing_ok=True)
        return not damaged

    def _present(self) -> np.ndarray:
        """How many objects each chunk has."""
        counts = self.grid.chunk_counts
        found = np.zeros(self.grid.chunks, dtype=int)
        for variable in self.problem.variables():
            root = self.path / variable.name / "c"
            for folder, _, names in os.walk(root):
                above = Path(folder).relative_to(root).parts
                for name in names:
                    place = (*above, name)
                    if not all(part.isdecimal() for part in place):
                        continue
                    numbers = [int(part) for part in place]
                    if len(place) == len(counts) and all(map(int.__lt__, numbers, counts)):
                        found[np.ravel_multi_index(numbers, counts)] += 1
        return found

    def purge(self) -> int:
        """Remove what a killed writer left; give how many files."""
        found = [
            Path(folder, name)
            for folder, _, names in os.walk(self.path)
            for name in names
            if name.endswith(_PARTIAL)
        ]
        for file in found:
            file.unlink(missing_ok=True)
        return len(found)

    def repair_axes(self) -> None:
        """Write coordinates again whose objects are gone or damaged."""
        import zarr

        for axis in self.grid.axes:
            objects = (self.path / axis.name / "c" / str(i) for i in range(-(-axis.count // BLOCK)))
            if all(_passes(file) for file in objects):
                continue
            shutil.rmtree(self.path / axis.name / "c", ignore_errors=True)
            _write_axis(zarr.open_group(str(self.path), mode="r+"), axis)


def open_store(
    path: Path,
    problem: Problem,
    axes: tuple[Axis, ...],
    chunk: tuple[int, ...] | None,
    usual: tuple[int, ...],
) -> Store:
    """Open the store of a chart, or begin it.

    Parameters
    ----------
    path : Path
    problem : Problem
    axes : tuple of Axis
    chunk : tuple of int or None
        Points of a chunk along each axis; None takes what is there, or what is usual.
    usual : tuple of int

    Raises
    ------
    InputError
        If the path holds something else, another chart, or cannot be written.
    """
    identity = _identity(problem, axes)
    if not path.exists() or (path.is_dir() and not any(path.iterdir())):
        grid = Grid(axes, chunk or usual)
        _begin(path, problem, grid, identity)
        return Store(path, problem, grid)
    found = read_identity(path)
    own = tuple(found.pop("chunk"))
    if found != json.loads(json.dumps(identity)):
        raise InputError(f"{path} holds another chart: {_difference(found, identity)}")
    if chunk is not None and chunk != own:
        raise InputError(f"{path} has chunks of {_product(own)} points, not {_product(chunk)}")
    for name in (*(axis.name for axis in axes), *(v.name for v in problem.variables())):
        if not _readable(path / name / _METADATA):
            raise InputError(f"{path}: {name}/{_METADATA} is gone or damaged: begin the chart anew")
    return Store(path, problem, Grid(axes, own))


def read_identity(path: Path) -> dict[str, Any]:
    """What the store says of itself.

    Raises
    ------
    InputError
        If it is no chart.
    """
    try:
        record = json.loads((path / _METADATA).read_text(encoding="utf-8"))
        found = dict(record["attributes"][ATTRIBUTE])
    except (OSError, ValueError, KeyError, TypeError):
        raise InputError(
            f"{path}: cannot be read: no chart of this package, or its beginning is damaged"
        ) from None
    if found.get("format") != FORMAT or not isinstance(found.get("chunk"), list):
        raise InputError(f"{path} is no {FORMAT}")
    found.pop("version", None)
    return found


def open_arrays(path: Path, problem: Problem) -> dict[str, Any]:
    """Open the arrays of all variables for writing."""
    import zarr

    group: Any = zarr.open_group(str(path), mode="r+")
    # a chunk that looks empty is written too: that it is there says that it is done
    whole = {"write_empty_chunks": True}
    return {v.name: group[v.name].with_config(whole) for v in problem.variables()}


def write_chunk(
    path: Path,
    arrays: Mapping[str, Any],
    region: tuple[slice, ...],
    values: Mapping[str, np.ndarray],
) -> None:
    """Write all variables of a chunk.

    Raises
    ------
    InputError
        If the disk is full or the store cannot be written; whole objects stay.
    """
    try:
        for name, array in values.items():
            arrays[name][region] = array
    except OSError as problem:
        raise unwritable(path, problem) from None


def _identity(problem: Problem, axes: Iterable[Axis]) -> dict[str, Any]:
    grid = {axis.name: {"count": axis.count, "sha256": axis.fingerprint()} for axis in axes}
    return {"format": FORMAT, **problem.identity(), "dimensions": list(grid), "grid": grid}


def _difference(found: Mapping[str, Any], wanted: Mapping[str, Any]) -> str:
    """The first entry that differs, in words."""
    for name, value in wanted.items():
        other = found.get(name)
        if other == value:
            continue
        if name == "grid":
            return f"its grid has other values of {_first_other(other, value)}"
        if name == "parameters" and isinstance(other, Mapping):
            which = _first_other(other, value)
            there, here = (known.get(which, "not fixed") for known in (other, value))
            return f"{which} = {there} there, {here} here"
        return f"{name} {_words(other)} there, {_words(value)} here"
    return "it has further entries"


def _first_other(found: Any, wanted: Mapping[str, Any]) -> str:
    known = found if isinstance(found, Mapping) else {}
    return next((n for n in (*wanted, *known) if known.get(n) != wanted.get(n)), "")


def _words(value: Any) -> str:
    return ", ".join(map(str, value)) if isinstance(value, list) else str(value)


def _begin(path: Path, problem: Problem, grid: Grid, identity: Mapping[str, Any]) -> None:
    """Lay out the whole group beside its place, then move it there."""
    import zarr

    temporary = path.with_name(f".{path.name}.{secrets.token_hex(4)}{_PARTIAL}")
    try:
        for left in path.parent.glob(f".{path.name}.*{_PARTIAL}"):
            shutil.rmtree(left, ignore_errors=True)
        told = {**identity, "chunk": list(grid.chunk), "version": version("nonsmooth")}
        group = zarr.create_group(str(temporary), attributes={ATTRIBUTE: told}, zarr_format=3)
        for axis in grid.axes:
            _create(
                group,
                Variable(axis.name, "<f8", float("nan"), problem.axis_attributes(axis.name)),
                (axis.count,), (min(axis.count, BLOCK),), (axis.name,),
            )  # fmt: skip
            _write_axis(group, axis)
        for variable in problem.variables():
            _create(group, variable, grid.shape, grid.chunk, grid.names)
        os.replace(temporary, path)
    except OSError as failure:
        raise unwritable(path, failure) from None
    finally:
        shutil.rmtree(temporary, ignore_errors=True)


def _create(
    group: Any,
    variable: Variable,
    shape: tuple[int, ...],
    chunk: tuple[int, ...],
    names: tuple[str, ...],
) -> None:
    from zarr.codecs import BloscCodec, BloscShuffle, Crc32cCodec

    group.create_array(
        variable.name,
        shape=shape,
        chunks=chunk,
        dtype=variable.dtype,
        # the CRC comes last: it covers the bytes of the object itself
        compressors=[
            BloscCodec(cname="lz4", clevel=5, shuffle=BloscShuffle.bitshuffle), Crc32cCodec()
        ],
        fill_value=variable.fill,
        attributes=variable.attributes,
        dimension_names=names,
    )  # fmt: skip


def _write_axis(group: Any, axis: Axis) -> None:
    array = group[axis.name].with_config({"write_empty_chunks": True})
    for begin, part in axis.blocks():
        array[begin : begin + len(part)] = part


def _passes(file: Path) -> bool | None:
    """Whether an object's CRC holds; None if there is no object."""
    from google_crc32c import value

    try:
        content = file.read_bytes()
    except FileNotFoundError:
        return None
    except OSError:
        return False
    if len(content) < _CRC:
        return False
    return bool(value(content[:-_CRC]) == int.from_bytes(content[-_CRC:], "little"))


def _readable(file: Path) -> bool:
    try:
        return isinstance(json.loads(file.read_text(encoding="utf-8")), dict)
    except (OSError, ValueError):
        return False


def _product(shape: tuple[int, ...]) -> str:
    return " x ".join(map(str, shape))

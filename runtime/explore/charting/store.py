"""A chart in files: a Zarr group whose chunks carry a CRC, and whose metadata has checksums.

The group's metadata says what the chart is of, and has checksums of the metadata of each array
and of itself; who opens a chart compares them. It holds the orbit as data, so that the chart
goes on without any other file.

A chunk of the grid is done when the objects of all variables are there and pass their CRC.
There is no other record of it, so that a process may be killed at any instant. Objects are
written beside their place and moved there; what a killed process leaves is `*.partial`.
"""

from __future__ import annotations

import json
import os
import secrets
import shutil
from collections.abc import Iterator, Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import cached_property
from glob import escape
from hashlib import sha256
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError, missing_extra
from nonsmooth.runtime.core.files import PARTIAL, fill_file, read_file, unwritable
from nonsmooth.runtime.core.result_files import checksum_of, parsed
from nonsmooth.runtime.explore.charting.grid import Axes, Grid, axis_of
from nonsmooth.runtime.explore.charting.problem import ChartProblem, Variable
from nonsmooth.runtime.model.saved_system import SAVED_VERSION

ATTRIBUTE, FORMAT = "nonsmooth", f"nonsmooth chart {3 + SAVED_VERSION}"
_METADATA = "zarr.json"
_LARGEST = 50_000_000  # bytes of metadata
_CRC = 4  # bytes behind the content
_BLOCK = 1 << 16  # coordinates in one file
_MOST_OBJECT = (1 << 31) + _LARGEST  # bytes of an object: what Blosc compresses at once, and more


def check_zarr() -> None:
    """Raise `MissingExtra` if Zarr or xarray cannot be imported."""
    for name in ("zarr", "xarray"):
        try:
            __import__(name)
        except ImportError:
            raise missing_extra("chart", name) from None


@dataclass(frozen=True, eq=False)
class Store:
    """A store on disk that fits its problem and its grid."""

    path: Path
    problem: ChartProblem
    grid: Grid  # with the store's own chunks

    @cached_property
    def names(self) -> tuple[str, ...]:
        """Names of the variables."""
        return tuple(variable.name for variable in self.problem.variables())

    def objects(self, number: int) -> Iterator[Path]:
        """Files of a chunk of the grid, one for each variable."""
        place = "/".join(map(str, self.grid.place(number)))
        return (self.path / name / "c" / place for name in self.names)

    def holds(self, number: int) -> bool:
        """Whether all objects of a chunk are there."""
        return all(file.is_file() for file in self.objects(number))

    def missing(self) -> tuple[list[int], int]:
        """Numbers of the chunks that are not done, and how many of these are damaged."""
        numbers = range(self.grid.chunks)
        there = [number for number in numbers if all(map(Path.exists, self.objects(number)))]
        with ThreadPoolExecutor() as pool:
            sound = dict(zip(there, pool.map(self._sound, there), strict=True))
        return [n for n in numbers if not sound.get(n)], len(there) - sum(sound.values())

    def _sound(self, number: int) -> bool:
        """Whether all objects of a chunk pass their CRC; removes those that do not."""
        damaged = [file for file in self.objects(number) if not _passes(file)]
        for file in damaged:
            file.unlink(missing_ok=True)
        return not damaged

    def purge(self) -> int:
        """Remove the files that a killed writer left, and return their number."""
        found = [
            Path(folder, name)
            for folder, _, names in os.walk(self.path)
            for name in names
            if name.endswith(PARTIAL)
        ]
        for file in found:
            file.unlink(missing_ok=True)
        return len(found)

    def repair_axes(self) -> None:
        """Write coordinates again if their objects are missing or damaged."""
        for name, row in self.grid.axes.items():
            folder = self.path / name / "c"
            if all(_passes(folder / str(k)) for k in range(-(-len(row) // _BLOCK))):
                continue
            shutil.rmtree(folder, ignore_errors=True)
            _open_array(self.path / name)[:] = row


def open_store(
    path: Path,
    problem: ChartProblem,
    axes: Axes,
    chunk: tuple[int, ...] | None,
    usual: tuple[int, ...],
) -> Store:
    """The store of a chart, opened or begun.

    `chunk` are the points of a chunk along each axis; None takes the store's, or `usual` in a
    new store. Raises `InputError` if the path holds something else or another chart, or cannot
    be written.
    """
    identity = _identity(problem, axes)
    if not path.exists() or (path.is_dir() and not any(path.iterdir())):
        grid = Grid(axes, chunk or usual)
        _begin(path, problem, grid, identity)
        return Store(path, problem, grid)
    found, _ = read_identity(path)
    own = tuple(found.pop("chunk"))
    if found != json.loads(json.dumps(identity)):
        raise InputError(f"{path} holds another chart: {_difference(found, identity)}")
    if chunk is not None and chunk != own:
        raise InputError(f"{path} has chunks of {_product(own)} points, not {_product(chunk)}")
    return Store(path, problem, Grid(axes, own))


def read_identity(path: Path) -> tuple[dict[str, Any], dict[str, Any]]:
    """Identity and held data of a store, after a check of all its metadata.

    The identity distinguishes its problem and grid from others; from the held data the
    problem is made again. Raises `InputError` if this is no chart, or if its metadata is
    damaged or edited.
    """
    try:
        document = parsed(_metadata(path))
        found = dict(document["attributes"][ATTRIBUTE])
    except (InputError, KeyError, TypeError, ValueError):
        raise InputError(
            f"{path}: cannot be read: no chart of this package, or its beginning is damaged"
        ) from None
    if found.get("format") != FORMAT or not isinstance(found.get("chunk"), list):
        raise InputError(
            f"{path} holds {found.get('format')!r}, where {FORMAT!r} is known:"
            " use the release that wrote it"
        )
    if found.pop("sha256", None) != _checksum(document):
        raise InputError(f"{path}: {_METADATA} is damaged or edited: its checksum differs")
    arrays = found.pop("arrays")
    for name in {*arrays, *(file.parent.name for file in path.glob(f"*/{_METADATA}"))}:
        if name not in arrays:
            raise InputError(f"{path}: {name} is no array of this chart")
        try:
            content = _metadata(path / name)
        except InputError as problem:
            raise InputError(f"{path}: {name}/{_METADATA} {problem}") from None
        if sha256(content).hexdigest() != arrays[name]:
            raise InputError(
                f"{path}: {name}/{_METADATA} is damaged or edited: its checksum differs"
            )
    found.pop("version")
    return found, dict(found.pop("held"))


def reader(path: Path) -> Any:
    """The store for reading, a `BoundedStore`, which reads no object larger than a chunk.

    Raises `InputError` as `read_identity` does, and if a chunk does not fit in memory.
    """
    from nonsmooth.runtime.explore.charting.bounded_store import BoundedStore, chunk_bytes

    read_identity(path)
    sizes = {}
    for file in path.glob(f"*/{_METADATA}"):
        try:
            sizes[file.parent.name] = chunk_bytes(_metadata(file.parent))
        except InputError as problem:
            raise InputError(f"{path}: {file.parent.name}/{_METADATA} {problem}") from None
    return BoundedStore.of(path, sizes)


def read_axes(path: Path) -> Axes:
    """Axes of a chart from its coordinates; raises `InputError` if a coordinate is damaged."""
    import zarr

    identity, _ = read_identity(path)
    group: Any = zarr.open_group(reader(path), mode="r", zarr_format=3)
    found = {}
    for name in identity["dimensions"]:
        try:
            found[name] = axis_of(name, group[name][:])
            if _fingerprint(found[name]) != identity["grid"][name]["sha256"]:
                raise InputError("they are others than the chart was begun with")
        except (ArithmeticError, LookupError, OSError, TypeError, ValueError) as problem:
            raise InputError(
                f"{path}: values of {name} are damaged: {problem}: chart the orbit by its name and"
                " ranges, which writes them again"
            ) from None
    return found


def _metadata(folder: Path) -> bytes:
    """Content of the metadata file of a group or an array."""
    return read_file(folder / _METADATA, _LARGEST, "chart")


def _checksum(document: Mapping[str, Any]) -> str:
    """Checksum of the metadata of a group, without the entry that stores it."""
    attributes = document["attributes"]
    told = {n: entry for n, entry in attributes[ATTRIBUTE].items() if n != "sha256"}
    return checksum_of({**document, "attributes": {**attributes, ATTRIBUTE: told}})


def _seal(folder: Path) -> None:
    """Write the checksums of all metadata into the group's metadata, before it is in its place."""
    document = parsed(_metadata(folder))
    told = document["attributes"][ATTRIBUTE]
    files = sorted(folder.glob(f"*/{_METADATA}"))
    told["arrays"] = {file.parent.name: sha256(file.read_bytes()).hexdigest() for file in files}
    told["sha256"] = _checksum(document)
    (folder / _METADATA).unlink()
    fill_file(folder / _METADATA, json.dumps(document, indent=2, allow_nan=False).encode())


def open_arrays(path: Path, problem: ChartProblem) -> dict[str, Any]:
    """Arrays (`zarr.Array`) of all variables, open for writing, by name."""
    return {v.name: _open_array(path / v.name) for v in problem.variables()}


def write_chunk(
    path: Path,
    arrays: Mapping[str, Any],
    region: tuple[slice, ...],
    values: Mapping[str, np.ndarray],
) -> None:
    """Write all variables of a chunk, whose points along each axis are `region`.

    Raises `InputError` if the disk is full or the store cannot be written; objects that are
    complete stay.
    """
    try:
        for name, array in values.items():
            arrays[name][region] = array
    except OSError as problem:
        raise unwritable(path, problem) from None


def _fingerprint(axis: np.ndarray) -> str:
    return sha256(axis.astype("<f8").tobytes()).hexdigest()


def _identity(problem: ChartProblem, axes: Axes) -> dict[str, Any]:
    grid = {n: {"count": len(row), "sha256": _fingerprint(row)} for n, row in axes.items()}
    return {"format": FORMAT, **problem.identity(), "dimensions": list(grid), "grid": grid}


def _difference(found: Mapping[str, Any], wanted: Mapping[str, Any]) -> str:
    """The first entry that differs, in words."""
    for name, value in wanted.items():
        other = found.get(name)
        if other == value:
            continue
        if not isinstance(value, Mapping):
            return f"{name} {_words(other)} there, {_words(value)} here"
        known = other if isinstance(other, Mapping) else {}
        which = next((n for n in (*value, *known) if known.get(n) != value.get(n)), "")
        if name == "grid":
            return f"its grid has other values of {which}"
        there, here = (each.get(which, "not fixed") for each in (known, value))
        return f"{which} = {there} there, {here} here"
    return "it has further entries"


def _words(value: Any) -> str:
    return ", ".join(map(str, value)) if isinstance(value, list) else str(value)


def _begin(path: Path, problem: ChartProblem, grid: Grid, identity: Mapping[str, Any]) -> None:
    """Write the whole group beside its place, then move it there."""
    import zarr

    temporary = path.with_name(f".{path.name}.{secrets.token_hex(4)}{PARTIAL}")
    try:
        for left in path.parent.glob(f".{escape(path.name)}.*{PARTIAL}"):
            shutil.rmtree(left, ignore_errors=True)
        beside = {"version": version("nonsmooth"), "held": problem.held()}
        told = {**identity, "chunk": list(grid.chunk), **beside}
        group = zarr.create_group(str(temporary), attributes={ATTRIBUTE: told}, zarr_format=3)
        for name, row in grid.axes.items():
            coordinate = Variable(name, "<f8", float("nan"), problem.axis_attributes(name))
            _create(group, coordinate, row.shape, (min(len(row), _BLOCK),), (name,))
            _open_array(temporary / name)[:] = row
        for variable in problem.variables():
            _create(group, variable, grid.shape, grid.chunk, grid.names)
        _seal(temporary)
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
    from zarr.codecs import BloscCodec, Crc32cCodec

    group.create_array(
        variable.name,
        shape=shape,
        chunks=chunk,
        dtype=variable.dtype,
        # the CRC comes last: it covers the bytes of the object itself
        compressors=[
            BloscCodec(cname="lz4", clevel=5, shuffle="bitshuffle"), Crc32cCodec()
        ],
        fill_value=variable.fill,
        attributes=variable.attributes,
        dimension_names=names,
    )  # fmt: skip


def _open_array(path: Path) -> Any:
    """Open an array for writing."""
    import zarr

    # a chunk that looks empty is written too: that it is there says that it is done
    whole = {"write_empty_chunks": True}
    try:
        return zarr.open(str(path), mode="r+", zarr_format=3, config=whole)
    except TypeError:  # zarr takes what is no array for a group, which has no such configuration
        raise FileNotFoundError(f"there is no array in {path}") from None


def _passes(file: Path) -> bool | None:
    """Whether an object's CRC holds; None if there is no object."""
    from google_crc32c import value

    if not file.exists():
        return None
    try:
        content = read_file(file, _MOST_OBJECT, "chart")
    except InputError:
        return False
    if len(content) < _CRC:
        return False
    return bool(value(content[:-_CRC]) == int.from_bytes(content[-_CRC:], "little"))


def _product(shape: tuple[int, ...]) -> str:
    return " x ".join(map(str, shape))

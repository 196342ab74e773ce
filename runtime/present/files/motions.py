"""Simulated motions in files, .npz or .csv, refused when they are cut, edited or foreign.

Both hold a header and a table with one row for the start and one for each transition. The
CSV file begins with the header, a line ``# name: value in JSON`` for each entry; pandas reads
the table with ``comment="#"``. Numbers give back the very same doubles, given values are kept
as they were written, and a checksum covers the content.
"""

from __future__ import annotations

import csv
import io
import json
import math
import os
import zipfile
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.files import check_target, path_of, read_file, write_file
from nonsmooth.runtime.core.json_codec import AnyDigits, Digits, one_of
from nonsmooth.runtime.core.result_files import DAMAGED, FileFormat, array_in, naming, parsed
from nonsmooth.runtime.core.values import Value
from nonsmooth.runtime.model.boundary_sets import mask_of, mask_type
from nonsmooth.runtime.model.engine_run import Grazing, Run, Status
from nonsmooth.runtime.model.kernels import load_system
from nonsmooth.runtime.model.piecewise import piecewise
from nonsmooth.runtime.model.saved_system import SAVED_VERSION, KeptSystem
from nonsmooth.runtime.model.structure import Structure
from nonsmooth.runtime.simulation.starting import check_forcing
from nonsmooth.runtime.simulation.trajectory import Trajectory

ENDINGS = (".npz", ".csv")
# How many times as large as what is stored: of times, which differ; of text. Names repeat.
_LOOSEST = {"times": 16, "header": 100}
_LONGEST_NAME = 1 << 12  # characters, of boundaries that are reached together
_SMALL = 1 << 16  # bytes that may be unpacked of any part


@dataclass(frozen=True, kw_only=True)
class MotionHeader:
    """Header of a motion's file: all but the table of its entries."""

    system: KeptSystem
    derivation: str
    parameters: Mapping[str, Value]
    states: tuple[str, ...]
    status: Annotated[str, one_of(tuple(status.name.lower() for status in Status))]
    end: AnyDigits
    options: tuple[str, ...]
    open_at: tuple[str, ...]
    # time, configuration, boundary and depth of each
    grazings: tuple[tuple[Digits, str, str, Digits], ...]


MOTION = FileFormat(
    name="nonsmooth trajectory",
    what="saved motion",
    entries=MotionHeader,
    version=3 + SAVED_VERSION,
)


@dataclass(frozen=True)
class _Table:
    """The entries of a motion, as its file holds them."""

    times: np.ndarray  # (n,)
    configurations: np.ndarray  # (n,) names
    boundaries: np.ndarray  # (n,) names of those reached, joined by +
    states: np.ndarray  # (n, N) behind the transitions
    before: np.ndarray  # (n, N) before the transitions


def save_trajectory(trajectory: Trajectory, path: str | os.PathLike[str]) -> None:
    """Write a motion to a .npz or .csv file, and make the folders above it.

    The file is replaced only when the new one is complete. `InputError` is raised for
    another ending, for a motion that is too large, or if the file cannot be written.
    """
    target = path_of(path)
    ending = _ending(target)
    check_target(target)
    run, structure = trajectory.run, trajectory.structure
    kernels = structure.kernels or load_system(trajectory.name)
    table = _Table(
        run.times,
        np.array(trajectory.configurations),
        np.array(["+".join(names) for names in trajectory.boundaries]),
        run.states,
        run.before,
    )
    entries = MotionHeader(
        system=kernels,
        derivation=str(kernels.module.DERIVATION),
        parameters=trajectory.parameters,
        states=tuple(trajectory.names),
        status=run.status.name.lower(),
        end=float(run.end),
        options=trajectory.options,
        open_at=trajectory.open_at,
        grazings=tuple(_grazing_entries(structure, grazing) for grazing in run.grazings),
    )
    content = MOTION.content(entries, *_numbers(table))
    written = (_npz if ending == ".npz" else _csv)(content, table)
    if len(written) > MOTION.most:
        raise InputError(
            f"cannot write {target}: {trajectory.transitions} transitions are too many"
        )
    write_file(target, written)


def load_trajectory(path: str | os.PathLike[str]) -> Trajectory:
    """Read a motion that `Trajectory.save` wrote.

    An `InputError` with the file's name is raised if the file cannot be read, is cut, edited
    or foreign, or was written with another derivation of its system.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> data = {"m1": 1, "m2": 2, "k1": 1, "k2": 5, "r": "0.5"}
    >>> ns.simulate("rigid-stop", data, [0, 0, 1.5, 0], transitions=2).save("motion.npz")
    >>> ns.load("motion.npz").configurations
    ('free', 'free', 'free')
    """
    read = _from_npz if _ending(Path(path)) == ".npz" else _from_csv
    with naming(path) as source:
        content, header, table = read(read_file(source, MOTION.most, MOTION.what))
        MOTION.check_sum(content, *_numbers(table))
        return _trajectory(header, table)


def _ending(path: Path) -> str:
    ending = path.suffix.lower()
    if ending not in ENDINGS:
        raise InputError(f"{path} does not end in {' or '.join(ENDINGS)}")
    return ending


def _grazing_entries(structure: Structure, grazing: Grazing) -> tuple[float, str, str, float]:
    boundary = structure.boundaries[grazing.configuration][grazing.boundary].name
    configuration = structure.configurations[grazing.configuration]
    return float(grazing.time), configuration, boundary, float(grazing.depth)


def _numbers(table: _Table) -> Iterator[bytes]:
    """Yield the bytes of the table, which the checksum covers beside the header."""
    for numbers in (table.times, table.states, table.before):
        yield np.ascontiguousarray(numbers, dtype="<f8").tobytes()
    for names in (table.configurations, table.boundaries):
        yield "\n".join(names.tolist()).encode()


def _csv(content: Mapping[str, Any], table: _Table) -> bytes:
    text = io.StringIO()
    for name, entry in content.items():
        text.write(f"# {name}: {json.dumps(entry)}\n")
    text.write(",".join(_columns(content["states"])) + "\n")
    columns = [
        map(repr, table.times.tolist()),
        table.configurations.tolist(),
        table.boundaries.tolist(),
        *(map(repr, column) for column in table.states.T.tolist()),
        *(map(repr, column) for column in table.before.T.tolist()),
    ]
    text.writelines(",".join(row) + "\n" for row in zip(*columns, strict=True))
    return text.getvalue().encode()


def _columns(states: Sequence[str]) -> list[str]:
    before = [f"{name}_before" for name in states]
    return ["time", "configuration", "boundaries", *states, *before]


def _from_csv(found: bytes) -> tuple[dict[str, Any], MotionHeader, _Table]:
    try:
        lines = found.decode("utf-8").splitlines()
    except UnicodeDecodeError:
        raise InputError("not a saved motion, such as Trajectory.save writes") from None
    entries: dict[str, Any] = {}
    count = next((i for i, line in enumerate(lines) if not line.startswith("# ")), len(lines))
    for line in lines[:count]:
        name, _, text = line[2:].partition(": ")
        try:
            entries[name] = json.loads(text)
        except (ValueError, RecursionError):
            raise InputError(f"cut, or not JSON: line {line[:40]!r}") from None
    header = MOTION.check_entries(entries)
    names = _columns(header.states)
    try:
        rows = list(csv.reader(lines[count:], strict=True))
    except csv.Error as problem:
        raise InputError(f"cut, or no table: {problem}") from None
    if len(rows) < 2 or rows[0] != names or any(len(row) != len(names) for row in rows):
        raise InputError(f"cut, or its columns are not {','.join(names)}")
    columns = list(zip(*rows[1:], strict=True))
    try:
        numbers = np.array([list(map(float, columns[i])) for i in (0, *range(3, len(names)))])
    except ValueError as problem:
        raise InputError(f"cut, or no table: {problem}") from None
    size = len(header.states)
    states, before = numbers[1 : size + 1].T.copy(), numbers[size + 1 :].T.copy()
    return (
        entries,
        header,
        _Table(numbers[0], np.array(columns[1]), np.array(columns[2]), states, before),
    )


def _npz(content: Mapping[str, Any], table: _Table) -> bytes:
    """Bytes of an archive of the arrays, without dates: the same motion gives the same bytes."""
    archive = io.BytesIO()
    np.savez_compressed(archive, header=np.array(json.dumps(content)), **vars(table))
    return archive.getvalue()


def _from_npz(found: bytes) -> tuple[dict[str, Any], MotionHeader, _Table]:
    """Content, header and table of an archive.

    Each part is unpacked only when those before it say how large it is.
    """
    names = ("header", *_Table.__dataclass_fields__)
    try:
        with zipfile.ZipFile(io.BytesIO(found)) as file:
            if sum(entry.file_size for entry in file.infolist()) > MOTION.most:
                raise InputError("too large for a saved motion")
            if sum(entry.compress_size for entry in file.infolist()) > len(found):
                raise InputError(DAMAGED)
            if sorted(file.namelist()) != sorted(f"{name}.npy" for name in names):
                raise InputError("not a saved motion, such as Trajectory.save writes")
            text = str(_array(file, "header", "U", ()))
            entries = parsed(text.encode())
            header = MOTION.check_entries(entries)
            times = _array(file, "times", "f", (None,))
            rows = (len(times),)
            states = (*rows, len(header.states))
            table = _Table(
                times,
                *(_array(file, name, "U", rows) for name in ("configurations", "boundaries")),
                *(_array(file, name, "f", states) for name in ("states", "before")),
            )
    except InputError:
        raise
    except Exception:  # what a damaged archive raises is not one kind
        raise InputError(DAMAGED) from None
    return entries, header, table


def _array(
    file: zipfile.ZipFile, name: str, kind: str, shape: tuple[int | None, ...]
) -> np.ndarray:
    """An array of an archive, of a given kind and shape; None is any length but zero.

    No more is unpacked than the archive says or contains. Times and the header take at most
    a fixed multiple of the bytes that are stored for them, but for a small constant.
    """

    def expected(found: tuple[int, ...], dtype: np.dtype[Any]) -> bool:
        fits = len(found) == len(shape) and all(
            n == wanted if wanted is not None else n for n, wanted in zip(found, shape, strict=True)
        )
        wide = name != "header" and kind == "U" and dtype.itemsize > 4 * _LONGEST_NAME
        return bool(fits) and dtype.kind == kind and not wide

    stored = file.getinfo(f"{name}.npy").compress_size
    return array_in(file, name, expected, _SMALL + _LOOSEST.get(name, math.inf) * stored)


def _trajectory(header: MotionHeader, table: _Table) -> Trajectory:
    """The motion that a file describes, checked against the tables of its system."""
    kernels = header.system
    system = piecewise(kernels, header.parameters)
    structure = system.structure
    if header.states != structure.states:
        raise InputError(f"its states are {list(header.states)}, not {list(structure.states)}")
    check_forcing(structure, table.states)
    configurations = _indices(structure, table.configurations)
    run = Run(
        table.times,
        configurations,
        table.before,
        table.states,
        _sets(structure, configurations, table.boundaries),
        tuple(_grazing(structure, entry) for entry in header.grazings),
        Status[header.status.upper()],
        header.end,
        tuple(map(structure.configuration, header.options)),
        mask_of(structure.boundary(int(configurations[-1]), b) for b in header.open_at),
    )
    if len({*header.open_at}) < len(header.open_at):
        raise InputError("'open_at' holds a boundary twice")
    if (run.options or run.open_at) and run.status != Status.AMBIGUOUS:
        raise InputError(f"it holds options, though it ended as {header.status!r}")
    if not (run.times[0] == 0 and (np.diff(run.times) >= 0).all() and run.end >= run.times[-1]):
        raise InputError("its times do not increase from 0 to its end")
    derivation = kernels.module.DERIVATION
    if header.derivation != derivation:
        raise InputError(
            f"not a motion of {structure.name} as it is installed"
            f" (its derivation {header.derivation}, here {derivation})"
        )
    return Trajectory(system, run)


def _indices(structure: Structure, names: np.ndarray) -> np.ndarray:
    found, places = np.unique(names, return_inverse=True)
    indices = [structure.configuration(name) for name in found.tolist()]
    return np.array(indices, dtype=np.int32)[places]


def _sets(structure: Structure, configurations: np.ndarray, names: np.ndarray) -> np.ndarray:
    """Masks of the boundaries that were reached, from their names."""
    if names[0] != "":
        raise InputError("its first row is no start")
    masks: dict[tuple[int, str], int] = {}
    found = [0]
    for source, joined in zip(configurations[:-1].tolist(), names[1:].tolist(), strict=True):
        if (source, joined) not in masks:
            places = {structure.boundary(source, name) for name in joined.split("+")}
            masks[source, joined] = mask_of(places)
        found.append(masks[source, joined])
    return np.array(found, dtype=mask_type(structure))


def _grazing(structure: Structure, entry: tuple[float, str, str, float]) -> Grazing:
    time, name, boundary, depth = entry
    configuration = structure.configuration(name)
    return Grazing(time, configuration, structure.boundary(configuration, boundary), depth)

"""Tables of measurements: columns of numbers by name, from files, mappings and datasets."""

from __future__ import annotations

import csv
import io
import os
import warnings
import zipfile
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError, missing_extra
from nonsmooth.runtime.core.files import read_file
from nonsmooth.runtime.core.result_files import DAMAGED, array_in, naming

__all__ = ["TIMES", "read_table"]

_ENDINGS = (".csv", ".npz", ".nc", ".zarr")
TIMES = ("t", "time")  # names of the column of times
_MOST = 500_000_000  # bytes
_SMALL, _LOOSEST = 1 << 24, 20  # bytes that an archive may unpack to, and times its own

Table = dict[str, np.ndarray]


def read_table(data: Any) -> Table:
    """The columns (n,) of a table of measurements, by name; missing values are NaN.

    `data` are columns by name, an xarray Dataset, or a path to .csv (with a header), .npz, .nc
    or .zarr. Columns of a dataset are its variables along ``t`` or ``time``, or along its only
    dimension. Columns may have different lengths. Raises `InputError` if a file cannot be read
    or a column is no row of real numbers, and `MissingExtra` for .nc and .zarr without xarray.
    """
    if isinstance(data, str | os.PathLike):
        with naming(data) as path:
            return _from_file(path)
    if isinstance(data, Mapping) and not hasattr(data, "data_vars"):
        return {str(name): _column(str(name), values) for name, values in data.items()}
    if hasattr(data, "data_vars"):
        return _from_dataset(data)
    raise InputError(f"data are a file, columns by name or a dataset, not {type(data).__name__}")


def _column(name: str, values: Any) -> np.ndarray:
    try:
        found = np.atleast_1d(np.asarray(values, dtype=float))
    except (TypeError, ValueError):
        raise InputError(f"column {name!r} is no row of real numbers") from None
    if found.ndim != 1:
        raise InputError(f"column {name!r} has the shape {found.shape}, where a row is expected")
    return found


def _from_file(path: Path) -> Table:
    ending = path.suffix.lower()
    if ending == ".csv":
        return _from_csv(read_file(path, _MOST, "table of measurements"))
    if ending == ".npz":
        content = read_file(path, _MOST, "table of measurements")
        return {name: _column(name, values) for name, values in _arrays(content)}
    if ending not in _ENDINGS:
        raise InputError(f"does not end in {', '.join(_ENDINGS[:-1])} or {_ENDINGS[-1]}")
    try:
        import xarray
    except ImportError:
        raise missing_extra("chart", "xarray") from None
    if not path.exists():
        raise InputError("no such file")
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of metadata that are in several places, or not
            opened = xarray.open_zarr(path) if ending == ".zarr" else xarray.open_dataset(path)
            with opened as dataset:
                stored = sum(f.stat().st_size for f in [path, *path.rglob("*")] if f.is_file())
                if dataset.nbytes > _SMALL + _LOOSEST * stored:
                    raise InputError(
                        f"it takes {dataset.nbytes / 1e6:.3g} MB, packed into {stored / 1e6:.3g}:"
                        " so much is not unpacked"
                    )
                return _from_dataset(dataset.load())
    except InputError:
        raise
    except Exception as problem:  # backends raise what they like
        raise InputError(f"not a dataset: {problem}") from None


def _arrays(content: bytes) -> Iterator[tuple[str, np.ndarray]]:
    """Arrays of an archive by name, which together may take only a few times its size."""
    left: float = _SMALL + _LOOSEST * len(content)
    try:
        with zipfile.ZipFile(io.BytesIO(content)) as file:
            for name in file.namelist():
                array = array_in(file, name.removesuffix(".npy"), lambda *_: True, left)
                left -= array.nbytes
                yield name.removesuffix(".npy"), array
    except InputError:
        raise
    except Exception:  # what a damaged archive raises is not one kind
        raise InputError(DAMAGED) from None


def _from_dataset(dataset: Any) -> Table:
    along = next((name for name in TIMES if name in dataset.dims), None)
    if along is None and len(dataset.dims) == 1:  # steady responses over a parameter
        (along,) = map(str, dataset.dims)
    if along is None:
        raise InputError("the dataset has no dimension t or time, nor one dimension alone")
    told = along in TIMES or along in dataset.coords
    found = {along: _column(along, dataset[along].values)} if told else {}
    for name, variable in dataset.data_vars.items():
        if variable.dims not in ((along,), ()):
            raise InputError(f"{name!r} of the dataset is not a series over {along}")
        found[str(name)] = _column(str(name), variable.values)
    return found


def _from_csv(content: bytes) -> Table:
    try:
        lines = content.decode("utf-8-sig").splitlines()
    except UnicodeDecodeError:
        raise InputError("no text in UTF-8") from None
    kept = [(n, line) for n, line in enumerate(lines, 1) if line.strip() and line[0] != "#"]
    if len(kept) < 2:
        raise InputError("a header and at least one row are expected")
    header = kept[0][1]
    separator = next((each for each in ",;\t" if each in header), ",")
    try:
        rows = list(csv.reader((line for _, line in kept), delimiter=separator))
    except csv.Error as problem:
        raise InputError(f"no table: {problem}") from None
    names = [name.strip() for name in rows[0]]
    twice = next((name for name in names if names.count(name) > 1), None)
    if twice is not None or "" in names:
        raise InputError(f"column {twice!r} is there twice" if twice else "a column has no name")
    numbers = np.full((len(rows) - 1, len(names)), np.nan)
    for place, row in enumerate(rows[1:]):
        line = kept[place + 1][0]
        if len(row) != len(names):
            raise InputError(f"line {line} has {len(row)} entries, not {len(names)}")
        for column, entry in enumerate(row):
            if entry.strip():
                try:
                    numbers[place, column] = float(entry)
                except ValueError:
                    told = f"line {line}, column {names[column]!r}: {entry.strip()[:40]!r}"
                    raise InputError(f"{told} is not a number") from None
    return dict(zip(names, numbers.T, strict=True))

"""Matrices that are given: of a chain of masses, as arrays of doubles, in files."""

from __future__ import annotations

import math
import os
import struct
import zipfile
import zlib
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any, BinaryIO, Literal

import numpy as np
import sympy as sp

from nonsmooth.derive.declaration.fields import exact, made, rows_of, shown
from nonsmooth.derive.errors import DeclarationError

_OF_WORDS = "OUT"  # kinds of arrays that hold objects or texts
_MORE_LINKS = {"none": -1, "left": 0, "right": 0, "both": 1}


def chain_matrices(
    masses: Sequence[Any],
    springs: Sequence[Any],
    dampers: Sequence[Any] | None = None,
    fixed: str = "left",
) -> tuple[sp.Matrix, sp.Matrix, sp.Matrix]:
    """Mass, stiffness and damping matrix of masses in a row, joined by springs and dampers.

    Parameters
    ----------
    masses : n values
    springs, dampers : n values, n + 1 with both ends fixed, n - 1 with none
        From left to right; each damper beside its spring, all zero when omitted.
    fixed : {"left", "right", "both", "none"}
        Which ends are tied to the ground, by the first and the last spring.

    Returns
    -------
    mass, stiffness, damping : n x n matrices

    Raises
    ------
    DeclarationError
        For an unknown end, or a wrong number of springs or dampers.

    Examples
    --------
    >>> chain_matrices([1, 2], [3, 4])[1]
    Matrix([
    [ 7, -4],
    [-4,  4]])
    """
    masses, springs = (
        made(tuple[sp.Expr, ...], given, what)
        for what, given in (("masses", masses), ("springs", springs))
    )
    made(Literal["none", "left", "right", "both"], fixed, "fixed")
    count = len(masses)
    links = count + _MORE_LINKS[fixed]
    if count == 0:
        raise DeclarationError("a chain needs a mass")
    dampers = (sp.S.Zero,) * links if dampers is None else dampers
    dampers = made(tuple[sp.Expr, ...], dampers, "dampers")
    for what, values in (("springs", springs), ("dampers", dampers)):
        if len(values) != links:
            raise DeclarationError(
                f"a chain of {count} masses, fixed {fixed!r}, has {links} {what}, not {len(values)}"
            )
    left = -1 if fixed in ("left", "both") else 0
    mass = sp.diag(*masses)
    return mass, _joined(springs, count, left), _joined(dampers, count, left)


def _joined(links: Sequence[Any], count: int, left: int) -> sp.Matrix:
    """Matrix (count x count) of a chain of links, each of which acts between two neighbours.

    The first link joins the masses `left` and `left` + 1; one out of range is the ground.
    """
    ends = {
        (row, place): sign
        for row in range(len(links))
        for place, sign in ((row + left, -1), (row + left + 1, 1))
        if 0 <= place < count
    }
    stretches = sp.Matrix.from_dok(len(links), count, ends)
    return stretches.T * sp.diag(*links) * stretches


def is_array(given: Any) -> bool:
    """Whether a value is a NumPy array or SciPy sparse matrix of numbers alone.

    DeclarationError refuses an array of which a mask leaves out values.
    """
    if np.ma.is_masked(given):
        raise DeclarationError(f"{shown(given)} has masked values")
    return hasattr(given, "dtype") and hasattr(given, "shape") and given.dtype.kind not in _OF_WORDS


def values_of_doubles(given: Any, what: str) -> list[sp.Rational]:
    """The exact rational values of a one-dimensional array of doubles."""
    if len(given.shape) != 1:
        raise DeclarationError(f"{what} is no row of numbers: its shape is {given.shape}")
    return list(_fractions(given, what))


def square(given: Any, what: str, size: int, resolved: Any = exact) -> sp.Matrix:
    """A matrix of the given size, each entry passed through `resolved`."""
    matrix = _matrix_of_doubles(given, what) if is_array(given) else rows_of(given, what)
    if matrix.shape != (size, size):
        raise DeclarationError(
            f"{what} is {matrix.rows} x {matrix.cols}, not {size} x {size} as there are coordinates"
        )
    return matrix.applyfunc(resolved)


def _matrix_of_doubles(given: Any, what: str) -> sp.Matrix:
    """A matrix of the exact rational values of a two-dimensional array of doubles."""
    if len(given.shape) != 2:
        raise DeclarationError(f"{what} is no matrix: its shape is {given.shape}")
    if hasattr(given, "tocoo"):
        entries = given.tocoo(copy=True)
        entries.sum_duplicates()
        rows, columns, values = entries.row, entries.col, entries.data
    else:
        given = np.asarray(given)
        rows, columns = given.nonzero()
        values = given[rows, columns]
    places = zip(rows.tolist(), columns.tolist(), strict=True)
    entries = dict(zip(places, _fractions(values, what), strict=True))
    return sp.Matrix.from_dok(*given.shape, entries)


def _fractions(values: Any, what: str) -> Iterable[sp.Rational]:
    if values.dtype.kind not in "biuf":
        raise DeclarationError(f"{what} holds what is no real number")
    try:
        return [sp.Rational(*value.as_integer_ratio()) for value in values.tolist()]
    except (OverflowError, ValueError):
        raise DeclarationError(f"{what} holds an entry that is not finite") from None


def read_matrices(path: str | os.PathLike[str]) -> dict[str, Any]:
    """Read the matrices of a file by SciPy's and NumPy's own readers.

    Parameters
    ----------
    path : path
        Matrix Market (``.mtx``, ``.mtx.gz``), NumPy's or SciPy's ``.npz``, MATLAB's ``.mat`` up
        to version 7.

    Returns
    -------
    dict of str to array or sparse matrix
        By the names in the file; a file of one matrix without a name gives it that of the file.

    Raises
    ------
    DeclarationError
        For a file that is missing, of another kind, damaged, without a matrix, or one whose
        matrices take more than 256 MB and 20 times as much as the file.

    Examples
    --------
    >>> import os, tempfile
    >>> import numpy as np
    >>> from nonsmooth.derive import read_matrices
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     file = os.path.join(folder, "beam.npz")
    ...     np.savez(file, M=np.eye(2), K=np.diag([1.0, 2.0]))
    ...     sorted(read_matrices(file))
    ['K', 'M']
    """
    file = Path(made(os.PathLike, Path(path) if isinstance(path, str) else path, "path"))
    kind = file.name.removesuffix(".gz").rpartition(".")[2].lower()
    if kind not in _READERS:
        raise DeclarationError(f"{file}: not a file of matrices (.mtx, .npz, .mat)")
    if not file.is_file():
        raise DeclarationError(f"{file}: no such file")
    try:
        stored = file.stat().st_size
        most = _SMALL + _LOOSEST * stored
        size = _SIZES[kind](file, most)
        if size > most:
            raise ValueError(
                f"its matrices take {size / 1e6:.3g} MB or more, packed into {stored / 1e6:.3g}:"
                " so much is not unpacked; save them as sparse ones"
            )
        found = _READERS[kind](file)
    except NotImplementedError:  # what SciPy says of that version, which is HDF5
        raise DeclarationError(
            f"{file}: MATLAB's version 7.3 is not read; save it by `save -v7`"
        ) from None
    except Exception as problem:
        reason = " ".join(str(problem).split()) or type(problem).__name__
        raise DeclarationError(f"{file}: cannot be read: {reason}") from None
    if not found:
        raise DeclarationError(f"{file}: holds no matrix")
    return found


def _market(file: Path) -> dict[str, Any]:
    from scipy.io import mmread

    return {file.name.partition(".")[0]: mmread(file)}


def _archive(file: Path) -> dict[str, Any]:
    from scipy.sparse import load_npz

    with np.load(file, allow_pickle=False) as archive:
        if {"format", "shape", "data"} <= set(archive.files):
            return {file.name.partition(".")[0]: load_npz(file)}
        return _numeric({name: archive[name] for name in archive.files})


def _matlab(file: Path) -> dict[str, Any]:
    from scipy.io import loadmat

    return _numeric(loadmat(file))


def _size_of_market(file: Path, most: float) -> float:
    """Bytes of the entries of a Matrix Market file, by its header."""
    from scipy.io import mminfo

    return 16.0 * int(mminfo(file)[2])


def _size_of_archive(file: Path, most: float) -> float:
    """Bytes of all arrays of an archive, for each the larger of what its two headers say."""
    total = 0.0
    with zipfile.ZipFile(file) as archive:
        for told in archive.infolist():
            if told.compress_type not in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED):
                raise ValueError(f"{told.filename!r} is not packed as NumPy does it")
            with archive.open(told) as entry:
                version = np.lib.format.read_magic(entry)
                read = {(1, 0): np.lib.format.read_array_header_1_0}.get(
                    version, np.lib.format.read_array_header_2_0
                )
                shape, _, dtype = read(entry)
            total += max(told.file_size, math.prod(shape) * dtype.itemsize)
    return total


def _size_of_matlab(file: Path, most: float) -> float:
    """Bytes of all matrices of a MATLAB file: unpacked, plus the dense ones by their headers.

    The count ends when it exceeds `most`.
    """
    from scipy.io import whosmat

    total = 0
    with file.open("rb") as stream:
        order = {b"IM": "<", b"MI": ">"}.get(stream.read(_HEADER)[_HEADER - 2 :])
        while order and total <= most and len(tag := stream.read(8)) == 8:
            kind, size = struct.unpack(f"{order}II", tag)
            if kind == _COMPRESSED:
                total += _unpacked(stream, size, most)
            else:
                total += size
                stream.seek(size, os.SEEK_CUR)
    if total > most:
        return total
    dense = (shape for _, shape, kind in whosmat(file) if kind != "sparse")
    return float(total + 16 * sum(map(math.prod, dense)))


def _unpacked(stream: BinaryIO, size: int, most: float) -> int:
    """Number of bytes to which the next `size` bytes unpack; none are kept.

    The count ends when it exceeds `most`.
    """
    unpacking, total = zlib.decompressobj(), 0
    while size > 0 and total <= most and (piece := stream.read(min(size, _PIECE))):
        size -= len(piece)
        while piece and total <= most:
            total += len(unpacking.decompress(piece, _PIECE))
            piece = unpacking.unconsumed_tail
    return total


def _numeric(entries: dict[str, Any]) -> dict[str, Any]:
    """The entries that are two-dimensional arrays of numbers."""
    return {
        name: entry
        for name, entry in entries.items()
        if getattr(entry, "ndim", 0) == 2
        and getattr(entry, "dtype", None) is not None
        and entry.dtype.kind in "biufc"  # what takes them says that complex ones are none
    }


_READERS = {"mtx": _market, "npz": _archive, "mat": _matlab}
_SIZES = {"mtx": _size_of_market, "npz": _size_of_archive, "mat": _size_of_matlab}
_SMALL, _LOOSEST = 1 << 28, 20  # bytes that a file may unpack to, and times its own
_HEADER, _COMPRESSED, _PIECE = 128, 15, 1 << 20  # of MATLAB's version 5

"""Matrices from files of other programs."""

from __future__ import annotations

import math
import os
import struct
import zipfile
import zlib
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np

from nonsmooth.derive.errors import DeclarationError

__all__ = ["read_matrices"]


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
    file = Path(path)
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

"""Arrays in .npz archives: nothing is unpacked before headers tell that it is what is expected."""

from __future__ import annotations

import math
import zipfile
from collections.abc import Callable
from typing import Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError

__all__ = ["DAMAGED", "array_in", "check_packing"]

DAMAGED = "cut, damaged, or not an .npz file"
_PIECE = 1 << 20  # bytes that are unpacked at a time


def check_packing(told: zipfile.ZipInfo) -> None:
    """Raise `InputError` unless an entry is stored or deflated, as NumPy packs arrays.

    Python unpacks other packings only as a whole, however little is asked for.
    """
    if told.compress_type not in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED):
        raise InputError(f"{told.filename!r} is not packed as NumPy does it")


def array_in(
    file: zipfile.ZipFile,
    name: str,
    expected: Callable[[tuple[int, ...], np.dtype[Any]], bool],
    most: float,
) -> np.ndarray:
    """The array of a name, without its ending, in an archive.

    `expected` says whether a shape and a type are those of the array; `most` is in bytes.
    An `InputError` refuses any other array, a larger one, and one that is not as long as
    its header says. Compressed data are unpacked piece by piece: all at once they may be a
    thousand times as large as the archive says.
    """
    told = file.getinfo(f"{name}.npy")
    check_packing(told)
    with file.open(told) as entry:
        if np.lib.format.read_magic(entry) != (1, 0):
            raise InputError(f"'{name}.npy' is of another format of arrays")
        shape, by_columns, dtype = np.lib.format.read_array_header_1_0(entry)
        if not expected(shape, dtype):
            raise InputError(f"{name!r} is not an array of its shape and type")
        size = math.prod(shape) * dtype.itemsize
        if size != told.file_size - entry.tell():
            raise InputError(f"'{name}.npy' is not as long as its header says")
        if size > most:
            raise InputError(
                f"'{name}.npy' takes {size / 1e6:.3g} MB, packed into"
                f" {told.compress_size / 1e6:.3g}: so much is not unpacked"
            )
        content = bytearray()
        while len(content) <= size and (piece := entry.read(_PIECE)):
            content += piece
    if len(content) != size:
        raise InputError(DAMAGED)
    return np.frombuffer(content, dtype).reshape(shape, order="F" if by_columns else "C")

"""Matrices from files of other programs."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

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
        For a file that is missing, of another kind, damaged, or without a matrix.

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


def _numeric(entries: dict[str, Any]) -> dict[str, Any]:
    """Entries of two dimensions and of numbers."""
    return {
        name: entry
        for name, entry in entries.items()
        if getattr(entry, "ndim", 0) == 2
        and getattr(entry, "dtype", None) is not None
        and entry.dtype.kind in "biufc"  # what takes them says that complex ones are none
    }


_READERS = {"mtx": _market, "npz": _archive, "mat": _matlab}

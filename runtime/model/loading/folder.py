"""The folder of a user's kernels: written by `nonsmooth generate`, and by nothing else."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.files import unwritable, write_file
from nonsmooth.runtime.model.loading.load import extension_in

__all__ = ["COMMAND", "check_folder", "write_folder"]

COMMAND = "nonsmooth generate"
_PROVENANCE = "PROVENANCE.json"


def check_folder(folder: Path) -> None:
    """Refuse a folder that holds other things, before the work is done.

    Raises
    ------
    InputError
        Unless the folder is new, empty, or one that `nonsmooth generate` wrote.
    """
    if folder.exists() and not folder.is_dir():
        raise InputError(f"cannot write {folder}: it is a file")
    try:
        foreign = folder.is_dir() and any(folder.iterdir()) and _recorded(folder) is None
    except OSError as problem:
        raise unwritable(folder, problem) from None
    if foreign:
        raise InputError(
            f"cannot write {folder}: it holds other files, which `{COMMAND}` did not write"
        )


def write_folder(folder: Path, files: Mapping[str, str]) -> list[Path]:
    """Write files into their folder and give those that changed.

    What an earlier run wrote and is no longer there goes, compiled kernels too. The record of
    the files comes last, so that a cut run is noticed.

    Parameters
    ----------
    folder : Path
    files : mapping of file name to text

    Raises
    ------
    InputError
        As for `check_folder`, or for a file of another origin that stands in the way.
    """
    check_folder(folder)
    before = set(_recorded(folder) or ()) if folder.is_dir() else set()
    texts = sorted(files.items(), key=lambda item: item[0] == _PROVENANCE)
    changed = []
    try:
        folder.mkdir(parents=True, exist_ok=True)
        for name, text in texts:
            path = folder / name
            if path.is_file() and path.read_bytes() == text.encode():
                continue
            if path.exists() and name not in before:
                raise InputError(f"cannot write {path}: `{COMMAND}` did not write it")
            write_file(path, text.encode())
            changed.append(path)
        library = extension_in(folder)
        if changed and library is not None:
            library.unlink()
        for name in before - set(files):
            if name == Path(name).name:
                (folder / name).unlink(missing_ok=True)
    except OSError as problem:
        raise unwritable(folder, problem) from None
    return changed


def _recorded(folder: Path) -> list[str] | None:
    """Names of the files that a run wrote into a folder; None if no run did."""
    try:
        record = json.loads((folder / _PROVENANCE).read_text(encoding="utf-8"))
        ours = str(record["command"]).startswith(COMMAND)
        return [*map(str, record["files"]), _PROVENANCE] if ours else None
    except (OSError, ValueError, KeyError, TypeError):
        return None

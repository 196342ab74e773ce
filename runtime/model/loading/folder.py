"""The folder of a user's kernels: written by `nonsmooth generate`, and by nothing else."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.files import (
    PARTIAL,
    check_folder,
    read_file,
    unwritable,
    write_files,
)
from nonsmooth.runtime.core.result_files import parsed
from nonsmooth.runtime.model.loading.compiling import extension_in

__all__ = ["COMMAND", "check_own_folder", "write_folder"]

COMMAND = "nonsmooth generate"
_PROVENANCE = "PROVENANCE.json"
_LARGEST = 1 << 24  # bytes of it


def check_own_folder(folder: Path) -> None:
    """Raise `InputError` unless the folder is new, empty or written by `nonsmooth generate`.

    This is asked before the work, so that a folder with other things in it is refused early.
    """
    check_folder(folder)
    if not folder.exists() or _recorded(folder) is not None:
        return
    try:
        foreign = any(path.suffix != PARTIAL for path in folder.iterdir())
    except OSError as problem:
        raise unwritable(folder, problem) from None
    if foreign:
        raise InputError(
            f"cannot write {folder}: it holds other files, which `{COMMAND}` did not write"
        )


def write_folder(
    folder: Path, files: Mapping[str, str], library: Mapping[str, bytes] | None
) -> list[Path]:
    """Write files into their folder and return those that changed.

    Files of an earlier run that no longer belong to it are removed, compiled kernels too. A new
    folder appears whole; in another one the record of the files is written last, so that an
    interrupted run is noticed. `library` holds compiled kernels of these files. Raises
    `InputError` as `check_own_folder` does, and for a file of another origin in the way.
    """
    check_own_folder(folder)
    before = set(_recorded(folder) or ()) if folder.is_dir() else set()
    changed: dict[str, bytes] = {}
    try:
        for name, text in sorted(files.items(), key=lambda item: item[0] == _PROVENANCE):
            path = folder / name
            if path.is_file() and path.read_bytes() == text.encode():
                continue
            if path.exists() and name not in before:
                raise InputError(f"cannot write {path}: `{COMMAND}` did not write it")
            changed[name] = text.encode()
        changed |= library or {}
        old = extension_in(folder) if changed and folder.is_dir() else None
        if changed:
            write_files(folder, changed)
        if old is not None and old.name not in changed:
            old.unlink()
        for name in before - set(files):
            if name == Path(name).name:
                (folder / name).unlink(missing_ok=True)
    except OSError as problem:
        raise unwritable(folder, problem) from None
    return [folder / name for name in changed]


def _recorded(folder: Path) -> list[str] | None:
    """Names of the files that a run wrote into a folder; None if no run did."""
    try:
        record = parsed(read_file(folder / _PROVENANCE, _LARGEST, "record"))
        ours = str(record["command"]).startswith(COMMAND)
        return [*map(str, record["files"]), _PROVENANCE] if ours else None
    except (OSError, ValueError, KeyError, TypeError):
        return None

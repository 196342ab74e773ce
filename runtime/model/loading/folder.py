"""The folder of a user's kernels: written by `nonsmooth generate`, and by nothing else."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
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

COMMAND = "nonsmooth generate"
PROVENANCE = "PROVENANCE.json"
_LARGEST = 1 << 24  # bytes of it


@dataclass(frozen=True)
class FolderRecord:
    """What a run of the derivation says of the files that it wrote into a folder."""

    command: str
    systems: tuple[str, ...]
    hashes: Mapping[str, str]  # by the names of the files

    @property
    def own(self) -> bool:
        """Whether `nonsmooth generate` wrote the folder."""
        return self.command.startswith(COMMAND)


def recorded(folder: Path) -> FolderRecord | None:
    """The record of a folder of kernels; None if it is missing, cut or foreign."""
    try:
        record = parsed(read_file(folder / PROVENANCE, _LARGEST, "record"))
        if not all(isinstance(name, str) for name in record["systems"]):
            return None
        return FolderRecord(
            str(record["command"]),
            tuple(record["systems"]),
            {str(name): str(entry["sha256"]) for name, entry in record["files"].items()},
        )
    except (OSError, ValueError, KeyError, TypeError, AttributeError):
        return None


def check_own_folder(folder: Path) -> None:
    """Raise `InputError` unless the folder is new, empty or written by `nonsmooth generate`.

    This is asked before the work, so that a folder with other things in it is refused early.
    """
    check_folder(folder)
    known = recorded(folder)
    if not folder.exists() or (known is not None and known.own):
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
    known = recorded(folder)
    before = {*known.hashes, PROVENANCE} if known is not None and known.own else set()
    changed: dict[str, bytes] = {}
    try:
        for name, text in sorted(files.items(), key=lambda item: item[0] == PROVENANCE):
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

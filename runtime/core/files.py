"""Files that are written whole or not at all, and errors that name them.

No other module writes a file that stays. Folders above a file are made when it is written;
devices, pipes and folders are never replaced by one.
"""

from __future__ import annotations

import os
import secrets
import shutil
import stat
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from pathlib import Path

from nonsmooth.runtime.core.errors import InputError

PARTIAL = ".partial"  # ending of what a killed process left


def path_of(given: object) -> Path:
    """The path that is given, as a text or a path; an `InputError` refuses anything else."""
    if not isinstance(given, str | os.PathLike):
        raise InputError(f"{given!r} is no path of a file")
    return Path(given)


def check_target(out: Path) -> None:
    """Raise `InputError` for a file that cannot be written, before the work is done.

    Refused are what is there and is no file, the file that standard output goes to, and
    one without permission.
    """
    found = _found(out)
    if found is None:
        _check_above(out)
    elif stat.S_ISDIR(found.st_mode):
        raise InputError(f"cannot write {out}: it is a folder")
    elif not stat.S_ISREG(found.st_mode):
        raise InputError(f"cannot write {out}: it is a device or a pipe, not a file")
    elif _is_output(found):
        raise InputError(f"cannot write {out}: the output of this command goes there already")
    elif not os.access(out, os.W_OK):
        raise InputError(f"cannot write {out}: permission denied")
    else:
        _check_above(out)


def check_folder(out: Path) -> None:
    """Raise `InputError` for a folder that cannot be written, before the work is done.

    Refused are what is there and is no folder, one without permission, and one without a
    name: files are not scattered into the folder that one happens to be in.
    """
    if not out.name:
        raise InputError(f"cannot write {out}: give the folder a name")
    found = _found(out)
    if found is None:
        _check_above(out)
    elif not stat.S_ISDIR(found.st_mode):
        raise InputError(f"cannot write {out}: it is a file")
    elif not os.access(out, os.W_OK):
        raise InputError(f"cannot write {out}: permission denied")


def check_ending(out: Path, endings: tuple[str, ...]) -> None:
    """Raise `InputError` unless a file's name has one of the endings.

    The endings are in lower case, with the dot: ``(".csv", ".json")``.
    """
    if out.suffix.lower() not in endings:
        raise InputError(f"{out} does not end in {', '.join(endings)}")


def unwritable(path: Path, problem: OSError | ValueError) -> InputError:
    """An `InputError` that says why a path cannot be written; the caller raises it."""
    return InputError(f"cannot write {path}: {_reason(problem)}")


def write_file(path: Path, content: bytes) -> None:
    """Write a file; what was there stays until the new content is complete.

    Folders above it are made. An `InputError` says that it cannot be written.
    """
    check_target(path)
    target = Path(os.path.realpath(path))
    temporary = target.with_name(_temporary())
    try:
        with folder_made(target.parent):
            try:
                fill_file(temporary, content, target)
                os.replace(temporary, target)
            finally:
                temporary.unlink(missing_ok=True)
    except OSError as problem:
        raise unwritable(path, problem) from None


def write_files(folder: Path, files: Mapping[str, bytes]) -> None:
    """Write files into a folder: all are on the disk before the first is in its place.

    `files` maps names to contents. The folder and those above it are made if need be, and a
    new folder is there at once with all its files. In one that was there, files take their
    places in the order that is given: one that vouches for others comes last. An
    `InputError` says that they cannot be written; what fails before the first file takes
    its place changes none.
    """
    check_folder(folder)
    for name in files:
        check_target(folder / name)
    target = Path(os.path.realpath(folder))
    new = not target.is_dir()
    staging = (target.parent if new else target) / _temporary()
    try:
        with folder_made(staging.parent):
            try:
                staging.mkdir()
                for name, content in files.items():
                    fill_file(staging / name, content, target / name)
                if new:
                    with suppress(OSError):  # another process may have made it meanwhile
                        os.replace(staging, target)
                if staging.is_dir():
                    for name in files:
                        os.replace(staging / name, target / name)
            finally:
                shutil.rmtree(staging, ignore_errors=True)
    except OSError as problem:
        raise unwritable(folder, problem) from None


def fill_file(file: Path, content: bytes, instead: Path | None = None) -> None:
    """Write a new file, down to the disk, before it is moved to its place.

    `instead` is a file that it will replace: if that is there, it gets the permissions of
    that.
    """
    with file.open("xb") as opened:
        opened.write(content)
        opened.flush()
        os.fsync(opened.fileno())
    if instead is not None and instead.exists():
        shutil.copymode(instead, file)


@contextmanager
def folder_made(folder: Path) -> Iterator[None]:
    """Make a folder and those above it; if the block fails, remove what was made.

    An `InputError` says that the folder cannot be made.
    """
    made = [path for path in (folder, *folder.parents) if not path.exists()]
    try:
        try:
            folder.mkdir(parents=True, exist_ok=True)
        except OSError as problem:
            raise unwritable(folder, problem) from None
        yield
    except BaseException:
        for path in made:
            with suppress(OSError):  # it was not made, or is not empty
                path.rmdir()
        raise


def read_file(path: Path, largest: int, kind: str) -> bytes:
    """Content of a file of at most `largest` bytes.

    `kind` says in words what the file holds. An `InputError`, which does not name the file,
    refuses one that cannot be read or is larger.
    """
    try:
        known = path.stat()
        if not stat.S_ISREG(known.st_mode) and not stat.S_ISDIR(known.st_mode):
            raise InputError("cannot be read: it is a device or a pipe, not a file")
        with path.open("rb") as file:
            # room for all that is asked for is taken
            found = b"" if known.st_size > largest else file.read(known.st_size + 1)
    except InputError:
        raise
    except (OSError, ValueError) as problem:
        raise InputError(f"cannot be read: {_reason(problem)}") from None
    if max(known.st_size, len(found)) > largest:
        raise InputError(f"too large for a {kind}")
    return found


def _found(out: Path) -> os.stat_result | None:
    """The status of what is at a path, links followed; None if nothing is there."""
    try:
        return out.stat()
    except (FileNotFoundError, NotADirectoryError):
        return None
    except (OSError, ValueError) as problem:
        raise unwritable(out, problem) from None


def _check_above(out: Path) -> None:
    """Raise `InputError` for a path below a file, or below a folder without permission."""
    above = next(path for path in Path(os.path.realpath(out)).parents if path.exists())
    if not above.is_dir():
        raise InputError(f"cannot write {out}: {above} is not a folder")
    if not os.access(above, os.W_OK | os.X_OK):
        raise InputError(f"cannot write {out}: permission denied")


def _is_output(found: os.stat_result) -> bool:
    """Whether a file is the one that standard output or standard error goes to."""
    for descriptor in (1, 2):
        with suppress(OSError):
            if os.path.samestat(found, os.fstat(descriptor)):
                return True
    return False


def _temporary() -> str:
    return f".{secrets.token_hex(8)}{PARTIAL}"


def _reason(problem: OSError | ValueError) -> str:
    return (getattr(problem, "strerror", None) or str(problem)).lower()

"""Files that are written whole or not at all, and errors that name them."""

from __future__ import annotations

import os
import secrets
from pathlib import Path

from nonsmooth.runtime.core.errors import InputError

__all__ = ["check_ending", "check_folder", "check_target", "read_file", "unwritable", "write_file"]


def check_target(out: Path) -> None:
    """Refuse a file that cannot be written, before the work is done."""
    folder = out.parent
    if not folder.is_dir():
        raise InputError(f"cannot write {out}: there is no folder {folder}")
    if out.is_dir():
        raise InputError(f"cannot write {out}: it is a folder")
    if not os.access(out if out.exists() else folder, os.W_OK):
        raise InputError(f"cannot write {out}: permission denied")


def check_folder(out: Path) -> None:
    """Refuse a folder that cannot be written, before the work is done."""
    if not out.parent.is_dir():
        raise InputError(f"cannot write {out}: there is no folder {out.parent}")
    if out.exists() and not out.is_dir():
        raise InputError(f"cannot write {out}: it is a file")
    if not all(os.access(path, os.W_OK) for path in (out.parent, out) if path.exists()):
        raise InputError(f"cannot write {out}: permission denied")


def check_ending(out: Path, endings: tuple[str, ...]) -> None:
    """Refuse a file of another kind, before the work is done."""
    if out.suffix.lower() not in endings:
        raise InputError(f"{out} does not end in {', '.join(endings)}")


def unwritable(path: Path, problem: OSError) -> InputError:
    """Say why a file or folder cannot be written."""
    return InputError(f"cannot write {path}: {(problem.strerror or str(problem)).lower()}")


def write_file(path: Path, content: bytes) -> None:
    """Write a file; what was there stays until the new content is complete.

    Raises
    ------
    InputError
        If it cannot be written.
    """
    check_target(path)
    target = Path(os.path.realpath(path))
    temporary = target.with_name(f".{target.name}.{secrets.token_hex(4)}")
    try:
        with temporary.open("xb") as file:
            file.write(content)
            file.flush()
            os.fsync(file.fileno())
        os.replace(temporary, target)
    except OSError as problem:
        raise unwritable(path, problem) from None
    finally:
        temporary.unlink(missing_ok=True)


def read_file(path: Path, largest: int, kind: str) -> bytes:
    """Content of a file of at most so many bytes; InputError otherwise, without its name."""
    try:
        with path.open("rb") as file:
            found = file.read(largest + 1)
    except (OSError, ValueError) as problem:
        reason = getattr(problem, "strerror", None) or str(problem)
        raise InputError(f"cannot be read: {reason.lower()}") from None
    if len(found) > largest:
        raise InputError(f"too large for a {kind}")
    return found

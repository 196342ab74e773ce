"""One process at a time: a lock that the system lets go of when its process dies."""

from __future__ import annotations

import os
import socket
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.files import unwritable

__all__ = ["locked"]

_TRIES = 20
_FAR = 1 << 20  # a byte behind the text: what is locked cannot be read on some systems


@contextmanager
def locked(path: Path) -> Iterator[None]:
    """A context that holds the lock file PATH.lock beside a store.

    The lock of a killed process is taken over. Raises `InputError` if another process holds
    it (with its number and host) or if the file cannot be written.
    """
    file = path.with_name(f"{path.name}.lock")
    try:
        descriptor = _acquire(file)
    except OSError as problem:
        raise unwritable(file, problem) from None
    if descriptor is None:
        raise InputError(f"{path} is being computed by {_holder(file)}: wait, or end that first")
    try:
        os.ftruncate(descriptor, 0)
        os.lseek(descriptor, 0, os.SEEK_SET)
        os.write(descriptor, f"process {os.getpid()} on {socket.gethostname()}".encode())
        yield
    finally:
        with suppress(OSError):  # some systems keep files that are open
            if os.path.samestat(os.fstat(descriptor), os.stat(file)):  # it may be lost
                file.unlink()
        os.close(descriptor)


def _acquire(file: Path) -> int | None:
    """Open and lock the file; None if another process holds it."""
    for _ in range(_TRIES):
        descriptor = os.open(file, os.O_RDWR | os.O_CREAT, 0o644)
        if not _lock(descriptor):
            os.close(descriptor)
            return None
        try:
            if os.path.samestat(os.fstat(descriptor), os.stat(file)):
                return descriptor
        except FileNotFoundError:
            pass
        os.close(descriptor)  # who held it has removed it in the meantime
    return None


def _lock(descriptor: int) -> bool:
    try:
        if sys.platform == "win32":
            import msvcrt

            os.lseek(descriptor, _FAR, os.SEEK_SET)
            msvcrt.locking(descriptor, msvcrt.LK_NBLCK, 1)
        else:
            import fcntl

            fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except (BlockingIOError, PermissionError):
        return False
    return True


def _holder(file: Path) -> str:
    try:
        return file.read_text(encoding="utf-8") or "another process"
    except OSError:
        return "another process"

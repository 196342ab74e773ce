"""Results of derivations, kept in the user's cache folder from one process to the next.

The environment variable NONSMOOTH_CACHE names another folder; empty, it switches this off.
"""

from __future__ import annotations

import hashlib
import os
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.files import write_file

__all__ = ["cache_folder", "cached", "stored"]

_CHECKSUM = "# sha256 "


def cache_folder() -> Path | None:
    """Where derived text is kept; None where it is not."""
    chosen = os.environ.get("NONSMOOTH_CACHE")
    if chosen is not None:
        return Path(chosen) if chosen else None
    base = os.environ.get("XDG_CACHE_HOME")
    if base:
        return Path(base, "nonsmooth")
    with suppress(RuntimeError):
        return Path.home() / ".cache" / "nonsmooth"
    return None


def cached(key: str, make: Callable[[], str]) -> str:
    """Text of a key: the stored one if it is whole, else what `make` gives, which is stored.

    A folder that cannot be read or written costs only the time to make the text again.
    """
    found = stored(key)
    if found is None:
        found = make()
        _store(key, found)
    return found


def stored(key: str) -> str | None:
    """Text that is stored under a key; None where there is none, or it is damaged."""
    folder = cache_folder()
    if folder is None:
        return None
    try:
        first, _, text = (folder / f"{key}.py").read_text(encoding="utf-8").partition("\n")
    except (OSError, ValueError):
        return None
    return text if first == _CHECKSUM + _checksum(text) else None


def _store(key: str, text: str) -> None:
    folder = cache_folder()
    if folder is None:
        return
    with suppress(OSError, InputError):
        folder.mkdir(parents=True, exist_ok=True)
        content = f"{_CHECKSUM}{_checksum(text)}\n{text}"
        write_file(folder / f"{key}.py", content.encode())


def _checksum(text: str) -> str:
    return hashlib.sha256(text.encode()).hexdigest()

"""What was derived and compiled, kept in a process, and in a cache folder from one to the next.

`Modules` are those that a process knows. What the user's folder keeps is executed: a folder is
used only if it belongs to the user and nobody else can write to it or put another in its place.
The environment variable NONSMOOTH_CACHE names another folder; empty, it switches this off. The
folder is kept below `MOST_BYTES`: what was not used for longest is removed.
"""

from __future__ import annotations

import hashlib
import linecache
import os
import re
import shutil
import stat
import sys
import time
import weakref
import zlib
from collections.abc import Callable
from contextlib import suppress
from functools import lru_cache
from importlib.machinery import EXTENSION_SUFFIXES
from pathlib import Path
from threading import RLock
from types import ModuleType

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.files import PARTIAL, read_file, write_file

MOST_BYTES = 256 << 20  # of the folder's entries together
_FORGOTTEN = 3600.0  # seconds after which what a killed process left is removed
_CHECKSUM = "# sha256 "
# derived text and compiled kernels, by the hash of what they are made from, and for which vectors
_ENTRY = re.compile(r"[0-9a-f]{16,}(\.py|(-\w+)?-[0-9a-f]{32}\..+)")


def cache_folder() -> Path | None:
    """The folder where derived text is kept; None if none may be used.

    A folder that others could write to is not used; the user is warned of it once.
    """
    folder = _named()
    if folder is None:
        return None
    folder = Path(os.path.realpath(folder))
    fault = _fault(folder)
    if fault is None:
        return folder
    if folder not in _TOLD:
        _TOLD.add(folder)
        print(f"nonsmooth: derivations are not kept in {folder}: {fault}", file=sys.stderr)
    return None


_TOLD: set[Path] = set()


def _named() -> Path | None:
    chosen = os.environ.get("NONSMOOTH_CACHE")
    if chosen is not None:
        return Path(chosen) if chosen else None
    base = os.environ.get("XDG_CACHE_HOME")
    if base:
        return Path(base, "nonsmooth")
    with suppress(RuntimeError):
        return Path.home() / ".cache" / "nonsmooth"
    return None


def _fault(folder: Path) -> str | None:
    """Why others may have written to a path, or to a folder above it; None if they cannot."""
    if not hasattr(os, "getuid"):  # access is not told by modes
        return None
    own, others = os.getuid(), stat.S_IWGRP | stat.S_IWOTH
    for place in (folder, *folder.parents):
        try:
            found = place.lstat()
        except FileNotFoundError:
            continue  # it is made, for the user alone
        except OSError as problem:
            return (problem.strerror or str(problem)).lower()
        if found.st_uid != own and (place == folder or found.st_uid != 0):
            return f"{place} belongs to another user"
        kept = place != folder and found.st_mode & stat.S_ISVTX
        if found.st_mode & others and not kept:
            return f"others can write to {place} (chmod go-w)"
    return None


def cached(key: str, make: Callable[[], str]) -> str:
    """The text of a key: the stored one if it is whole, else that of `make`, which is stored.

    A folder that cannot be read or written only costs the time to make the text again.
    """
    found = stored(key)
    if found is None:
        found = make()
        _store(key, found)
    return found


def stored(key: str) -> str | None:
    """The text that is stored under a key; None if there is none or it is damaged."""
    folder = cache_folder()
    if folder is None:
        return None
    path = folder / f"{key}.py"
    try:
        if _fault(path) is not None:
            return None
        first, _, text = _content(path).decode("utf-8").partition("\n")
    except (OSError, ValueError):
        return None
    if first != _CHECKSUM + _checksum(text):
        return None
    _mark_used(path)
    return text


def stored_library(key: str) -> Path | None:
    """The path of compiled kernels stored under a key; None if there are none or it is damaged."""
    folder = cache_folder()
    if folder is None:
        return None
    for suffix in EXTENSION_SUFFIXES:
        for path in sorted(folder.glob(f"{key}-*{suffix}")):
            told = path.name.removeprefix(f"{key}-").removesuffix(suffix)
            with suppress(OSError, InputError):
                if _fault(path) is None and told == _digest(_content(path)):
                    _mark_used(path)
                    return path
    return None


def store_library(key: str, name: str, content: bytes) -> None:
    """Store compiled kernels under a key, with their hash in the file's name.

    `name` is that of an extension: its suffixes say which Python loads it.
    """
    suffix = name[name.index(".") :]
    _write(f"{key}-{_digest(content)}{suffix}", content)


def made_folder(folder: Path) -> bool:
    """Make the cache folder and those above it, for the user alone; whether it exists then."""
    with suppress(OSError):
        for place in (*reversed(folder.parents), folder):
            if not place.exists():
                place.mkdir(mode=0o700, exist_ok=True)
    return folder.is_dir()


def _store(key: str, text: str) -> None:
    _write(f"{key}.py", f"{_CHECKSUM}{_checksum(text)}\n{text}".encode())


def _write(name: str, content: bytes) -> None:
    folder = cache_folder()
    if folder is None or not made_folder(folder):
        return
    with suppress(OSError, InputError):
        path = folder / name
        write_file(path, content)
        path.chmod(0o600)
        _keep_bound(folder)


def _mark_used(path: Path) -> None:
    with suppress(OSError):
        os.utime(path)


def _content(path: Path) -> bytes:
    return read_file(path, MOST_BYTES, "derivation")


def _keep_bound(folder: Path) -> None:
    """Remove the files that were not used for longest; other processes may do so as well."""
    found, total = [], 0
    for name in os.listdir(folder):
        with suppress(OSError):
            if name.endswith(PARTIAL):
                total += _unfinished(folder / name)
            elif _ENTRY.fullmatch(name):
                entry = (folder / name).lstat()
                found.append((entry.st_mtime_ns, folder / name, entry.st_size))
    for _, path, size in sorted(found, reverse=True):
        total += size
        if total > MOST_BYTES:
            with suppress(OSError):
                path.unlink()


def _unfinished(path: Path) -> int:
    """The size in bytes of a file that is being written; an old one of a killed process goes."""
    parts = [path, *path.rglob("*")]
    if time.time() - path.lstat().st_mtime <= _FORGOTTEN:
        return sum(part.lstat().st_size for part in parts)
    if path.is_dir():
        shutil.rmtree(path, ignore_errors=True)
    else:
        path.unlink()
    return 0


def _checksum(text: str) -> str:
    return hashlib.sha256(text.encode()).hexdigest()


def _digest(content: bytes) -> str:
    return hashlib.sha256(content).hexdigest()[:32]


def module_of_text(text: str, file: str) -> ModuleType:
    """Execute emitted text as a module; tracebacks call it `file` and show its lines."""
    module = ModuleType("nonsmooth_emitted")
    module.__file__ = file
    lines = (len(text), None, text.splitlines(keepends=True), file)
    linecache.cache[file] = lines
    weakref.finalize(module, _forget, file, lines).atexit = False
    exec(compile(text, file, "exec"), module.__dict__)
    return module


def _forget(file: str, lines: object) -> None:
    """Drop the cached lines of a module that is gone, unless it was made again."""
    if linecache.cache.get(file) is lines:
        del linecache.cache[file]


class Modules:
    """Modules of emitted text by key: of those that were not used for longest the packed text.

    None is forgotten, because a record may hold its key alone; a packed text takes a twentieth
    of the module that it becomes again. At most `most` are kept as they are, and all those that
    have no text.
    """

    def __init__(self, most: int) -> None:
        self._lock = RLock()
        self._packed: dict[str, tuple[str, bytes]] = {}
        self._without_text: dict[str, ModuleType] = {}
        self._made = lru_cache(most)(self._executed)

    def __getitem__(self, key: str) -> ModuleType:
        """The module of a key, executed again if only its text was kept."""
        with self._lock:
            return self._without_text.get(key) or self._made(key)

    def __contains__(self, key: object) -> bool:
        """Whether a key is known; no module is executed for the answer."""
        return key in self._packed or key in self._without_text

    def add(self, key: str, text: str, file: str) -> None:
        """Keep a text, which `file` names in tracebacks."""
        self._packed[key] = file, zlib.compress(text.encode())

    def setdefault(self, key: str, module: ModuleType) -> ModuleType:
        """The module of a key; if there is none, keep the given one, which has no text."""
        with self._lock:
            if key not in self:
                self._without_text[key] = module
            return self[key]

    def _executed(self, key: str) -> ModuleType:
        file, packed = self._packed[key]
        return module_of_text(zlib.decompress(packed).decode(), file)

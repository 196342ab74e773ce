"""Emitted text as a module, and the modules that a process knows."""

from __future__ import annotations

import linecache
import weakref
import zlib
from functools import lru_cache
from threading import RLock
from types import ModuleType

__all__ = ["Modules", "module_of_text"]


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

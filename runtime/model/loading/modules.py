"""Emitted text as a module, and the modules that a process knows."""

from __future__ import annotations

import linecache
import weakref
import zlib
from collections import OrderedDict
from collections.abc import Iterator, MutableMapping
from threading import RLock
from types import ModuleType

__all__ = ["Modules", "module_of_text"]

_PACKED: weakref.WeakKeyDictionary[ModuleType, bytes] = weakref.WeakKeyDictionary()


def module_of_text(text: str, file: str) -> ModuleType:
    """Execute emitted text as a module; tracebacks call it `file` and show its lines."""
    module = ModuleType("nonsmooth_emitted")
    module.__file__ = file
    _PACKED[module] = zlib.compress(text.encode())
    lines = (len(text), None, text.splitlines(keepends=True), file)
    linecache.cache[file] = lines
    weakref.finalize(module, _forget, file, lines).atexit = False
    exec(compile(text, file, "exec"), module.__dict__)
    return module


def _forget(file: str, lines: object) -> None:
    """Drop the cached lines of a module that is gone, unless it was made again."""
    if linecache.cache.get(file) is lines:
        del linecache.cache[file]


class Modules(MutableMapping[str, ModuleType]):
    """Modules by key: those that were last used as they are, the others as packed text.

    None is forgotten, because a record may hold its key alone; a packed text takes a twentieth
    of the module that it becomes again. At most `most` modules with a text are kept as they are;
    a module without a text always is.
    """

    def __init__(self, most: int) -> None:
        self._most, self._lock = most, RLock()
        self._ready: OrderedDict[str, ModuleType] = OrderedDict()
        self._packed: dict[str, tuple[str, bytes]] = {}
        self._others: dict[str, ModuleType] = {}

    def __getitem__(self, key: str) -> ModuleType:
        """The module of a key, executed again if only its text was kept."""
        with self._lock:
            if key in self._others:
                return self._others[key]
            if key in self._ready:
                self._ready.move_to_end(key)
            elif key in self._packed:
                file, packed = self._packed[key]
                self[key] = module_of_text(zlib.decompress(packed).decode(), file)
            return self._ready[key]

    def __setitem__(self, key: str, module: ModuleType) -> None:
        """Keep a module; the one that was unused for longest is packed."""
        with self._lock:
            if module not in _PACKED:
                self._others[key] = module
                return
            self._ready[key] = module
            self._ready.move_to_end(key)
            self._packed.pop(key, None)
            while len(self._ready) > self._most:
                other, old = self._ready.popitem(last=False)
                self._packed[other] = (str(old.__file__), _PACKED[old])

    def __delitem__(self, key: str) -> None:
        """Forget a module."""
        for known in (self._packed, self._ready, self._others):
            known.pop(key, None)

    def __iter__(self) -> Iterator[str]:
        """All keys."""
        return iter([*self._packed, *self._ready, *self._others])

    def __len__(self) -> int:
        """How many there are."""
        return len(self._packed) + len(self._ready) + len(self._others)

    def __contains__(self, key: object) -> bool:
        """Whether a key is known; no module is executed for the answer."""
        return key in self._ready or key in self._packed or key in self._others

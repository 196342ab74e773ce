"""How much is unpacked of compressed files, which no allocator changes."""

from __future__ import annotations

import zlib
from typing import Any


def unpacked_pieces(monkeypatch):
    """The sizes of what is unpacked from here on, piece by piece."""
    begin, sizes = zlib.decompressobj, list[int]()

    class Counted:
        """What stands for an object that unpacks."""

        def __init__(self, *arguments: Any) -> None:
            self._unpacking = begin(*arguments)

        def __getattr__(self, name: str) -> Any:
            return getattr(self._unpacking, name)

        def decompress(self, *arguments: Any) -> bytes:
            found = self._unpacking.decompress(*arguments)
            sizes.append(len(found))
            return found

    monkeypatch.setattr(zlib, "decompressobj", Counted)
    return sizes

"""How much is unpacked of compressed files, which no allocator changes."""

import zlib


def unpacked_pieces(monkeypatch):
    """The sizes of what is unpacked from here on, piece by piece."""
    begin, sizes = zlib.decompressobj, []

    class Counted:
        """What stands for an object that unpacks."""

        def __init__(self, *arguments):
            self._unpacking = begin(*arguments)

        def __getattr__(self, name):
            return getattr(self._unpacking, name)

        def decompress(self, *arguments):
            found = self._unpacking.decompress(*arguments)
            sizes.append(len(found))
            return found

    monkeypatch.setattr(zlib, "decompressobj", Counted)
    return sizes

"""Reading the objects of a store: one that claims to be larger than a chunk is not read.

An object is Blosc's header, which says how large the content is, the content, and a CRC. Who
forges an object can renew the CRC; what the header says is compared with the chunks of the
array before anything is allocated.
"""

from __future__ import annotations

import asyncio
import json
import math
import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from zarr.storage import LocalStore

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.workload import check_memory

_HEADER, _SIZE = 16, slice(4, 8)  # bytes of Blosc's header, and where the content's size stands
_BESIDE = 4096  # bytes of an object beside its content, at most
_WIDTHS = {"float64": 8, "int8": 1, "bool": 1, "int16": 2}
_CODECS = ["bytes", "blosc", "crc32c"]


def chunk_bytes(metadata: bytes) -> int:
    """Size in bytes of the chunks of an array, from its metadata (JSON).

    Raises `InputError` if this is no array of a chart or if a chunk does not fit in memory.
    """
    try:
        found = json.loads(metadata)
        shape = [int(n) for n in found["chunk_grid"]["configuration"]["chunk_shape"]]
        size = math.prod(shape) * _WIDTHS[found["data_type"]]
        codecs = [codec["name"] for codec in found["codecs"]]
    except (KeyError, TypeError, ValueError):
        raise InputError("is no metadata of a chart's array") from None
    if codecs != _CODECS or min(shape, default=0) < 1 or found["storage_transformers"]:
        raise InputError("is no metadata of a chart's array")
    check_memory("the chunks of a chart", size)
    return size


class BoundedStore(LocalStore):
    """A folder with the objects of a chart, for reading, that refuses objects above a size.

    `root` is the folder.
    """

    sizes: Mapping[str, int] = {}  # bytes of a chunk of each array, by name

    @classmethod
    def of(cls, root: Path, sizes: Mapping[str, int]) -> BoundedStore:
        """The store in a folder, with the sizes of the chunks of its arrays."""
        found = cls(root, read_only=True)
        found.sizes = sizes
        return found

    async def get(self, key: str, *arguments: Any, **options: Any) -> Any:
        """An object of the store, as `LocalStore.get` returns it, after a check of its size."""
        await asyncio.to_thread(self._check, key)
        return await super().get(key, *arguments, **options)

    def get_sync(self, key: str, **options: Any) -> Any:
        """The same as `get`, synchronously, as later versions of Zarr ask for it."""
        self._check(key)
        return super().get_sync(key, **options)

    def _check(self, key: str) -> None:
        """Refuse an object that is no file, or that is or claims to be larger than a chunk."""
        name, _, place = key.partition("/")
        if name not in self.sizes or not place.startswith("c/"):
            return
        path = self.root / key
        if not path.exists():  # what is not there is not read either
            return
        if not path.is_file():  # a pipe would be waited for
            raise ValueError(f"{key} is no file")
        try:
            with path.open("rb") as file:
                size, header = os.fstat(file.fileno()).st_size, file.read(_HEADER)
        except OSError as problem:
            raise ValueError(f"{key} cannot be read: {problem}") from None
        most = self.sizes[name]
        if size > most + _BESIDE or int.from_bytes(header[_SIZE], "little") > most:
            raise ValueError(f"{key} claims to be larger than a chunk")

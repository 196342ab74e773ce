"""The codec of result files: a format, a version, a checksum, whole or not at all; arrays too.

Every kind of result file is a `FileFormat`: its name, what it holds, and the record of its
entries. Files are written atomically, and read only if nothing of them is missing, unknown,
cut, edited or of another release. Of an .npz archive beside them nothing is unpacked before
headers tell that it is what is expected.
"""

from __future__ import annotations

import hashlib
import json
import math
import os
import re
import zipfile
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path
from typing import Any, Generic, TypeVar

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.files import path_of, read_file, write_file
from nonsmooth.runtime.core.json_codec import decode, encode, json_schema

DAMAGED = "cut, damaged, or not an .npz file"
_PIECE = 1 << 20  # bytes that are unpacked at a time
_BEGINNING = 400  # characters of a file in which its format is looked for first
_MOST = 500_000_000  # bytes; a larger file is not read
_DENSE, _FEW = 16, 1 << 18  # bytes of text to a list or a mapping, where they are not few
# what entries of the wrong shape raise where they are read
WRONG_SHAPE = (KeyError, IndexError, TypeError, ValueError, AttributeError, ArithmeticError)
_HEAD = ("format", "version", "package", "request", "sha256")
_ASKED = "_asked"  # where a record that was read has the question of its file
_REQUEST: ContextVar[Mapping[str, Any] | None] = ContextVar("what is asked", default=None)
Entries = TypeVar("Entries")


@dataclass(frozen=True, kw_only=True)
class FileFormat(Generic[Entries]):
    """A kind of result file, whose entries `nonsmooth.runtime.core.json_codec` writes and reads."""

    name: str  # the entry "format"
    what: str  # what the file holds, in words
    # record of the entries beside format, version, package, request and checksum
    entries: type[Entries]
    version: int = 1
    most: int = _MOST  # bytes; a larger file is not read
    # raises InputError for entries that do not belong together
    together: Callable[[Entries], None] = lambda entries: None

    @property
    def schema(self) -> dict[str, Any]:
        """JSON Schema (2020-12) of a file of this kind."""
        own = json_schema(self.entries)
        text = {"type": "string"}
        head = {
            "format": {"const": self.name},
            "version": {"const": self.version},
            "package": text,
            "request": {"type": "object"},  # what a command was asked
            "sha256": text,
        }
        return {
            "$schema": "https://json-schema.org/draft/2020-12/schema",
            "title": f"{self.name}, version {self.version}",
            "description": self.what,
            **own,
            "properties": {**head, **own["properties"]},
            "required": [*(name for name in head if name != "request"), *own["required"]],
        }

    def write(self, path: str | os.PathLike[str], entries: Entries) -> None:
        """Write a file; what was there stays until the new content is complete.

        An `InputError` says that it cannot be written.
        """
        request = _REQUEST.get() or vars(entries).get(_ASKED)
        content = self.content(entries, request=request)
        text = json.dumps(content, indent=2, allow_nan=False) + "\n"
        write_file(path_of(path), text.encode())

    def content(
        self, entries: Entries, *numbers: bytes, request: Mapping[str, Any] | None = None
    ) -> dict[str, Any]:
        """The entries with the format, version, package and checksum.

        The checksum also covers `numbers`, which are kept beside the entries. `request` is what
        a command was asked.
        """
        head = {"format": self.name, "version": self.version, "package": version("nonsmooth")}
        asked = {} if request is None else {"request": request}
        content = {**head, **asked, **encode(entries)}
        return {**content, "sha256": checksum_of(content, *numbers)}

    def read(self, path: Path) -> Entries:
        """The entries of a file; `write` states again what was asked there.

        An `InputError` refuses a file that cannot be read, or is cut, edited or foreign.
        """
        content = parsed(read_file(path, self.most, self.what))
        entries = self.check(content)
        vars(entries)[_ASKED] = content.get("request")
        return entries

    def load(self, path: str | os.PathLike[str]) -> Entries:
        """What `read` gives; its errors name the file."""
        with naming(path) as file:
            return self.read(file)

    def check(self, content: Any) -> Entries:
        """The entries of what a JSON parser gave.

        An `InputError` refuses another format, version or checksum, and entries that are not
        in order or do not belong together.
        """
        self._check_head(content)
        self.check_sum(content)
        entries = self._entries(content)
        self.together(entries)
        return entries

    def check_entries(self, content: Any) -> Entries:
        """The entries of what a JSON parser gave, with any checksum.

        An `InputError` refuses another format or version, and entries that are not in order.
        """
        self._check_head(content)
        return self._entries(content)

    def _check_head(self, content: Any) -> None:
        if not isinstance(content, dict) or content.get("format") != self.name:
            raise InputError(f"not a {self.what}, such as --save or save() writes{_told(content)}")
        if content.get("version") != self.version or type(content["version"]) is not int:
            raise InputError(
                f"version {content.get('version')!r} of the format, where {self.version} is"
                " known: use the release that wrote it"
            )
        for name in ("package", "sha256"):
            if name not in content:
                raise InputError(f"{name!r} is missing")
            if type(content[name]) is not str:
                raise InputError(f"{name!r} is of the wrong type")
        if type(content.get("request", {})) is not dict:
            raise InputError("'request' is of the wrong type")

    def _entries(self, content: Mapping[str, Any]) -> Entries:
        return decode(self.entries, {n: x for n, x in content.items() if n not in _HEAD})

    def check_sum(self, content: Mapping[str, Any], *numbers: bytes) -> None:
        """Raise `InputError` if the checksum of content, and numbers beside it, differs."""
        if content["sha256"] != checksum_of(content, *numbers):
            raise InputError("edited or damaged: the checksum differs")


def _told(content: Any) -> str:
    """The end of a message that names the format of content; empty for an unknown one."""
    named = content.get("format") if isinstance(content, dict) else None
    known = isinstance(named, str) and re.fullmatch(r"nonsmooth [a-z ]{1,40}", named)
    return f": it is a {named}" if known else ""


def check_same_question(what: str, asked: Mapping[str, Any], known: Mapping[str, Any]) -> None:
    """Raise `InputError` if work to go on with was kept of another question.

    `what` says in words what was kept. Both mappings hold numbers, texts, records or
    arrays. The message names the first entry of `asked` that `known` lacks or has otherwise.

    Examples
    --------
    >>> check_same_question("sweep", {"state": "x1"}, {"state": "x1", "done": 7})
    """
    for name, value in asked.items():
        if name not in known or not np.array_equal(value, known[name]):
            raise InputError(f"the {what} to resume has another {name}")


def checksum_of(content: Mapping[str, Any], *numbers: bytes) -> str:
    """SHA-256, hexadecimal, of a file's other entries and of numbers beside them."""
    covered = {name: entry for name, entry in content.items() if name != "sha256"}
    found = hashlib.sha256(json.dumps(covered, sort_keys=True).encode())
    for part in numbers:
        found.update(part)
    return found.hexdigest()


@contextmanager
def stating(request: Mapping[str, Any]) -> Iterator[None]:
    """Make the files that the block writes state what was asked, which is ready for JSON."""
    token = _REQUEST.set(request)
    try:
        yield
    finally:
        _REQUEST.reset(token)


def content_of(path: Path) -> dict[str, Any]:
    """All entries of a result file of any kind.

    An `InputError` refuses a file that cannot be read, or is cut, edited or foreign.
    """
    content = parsed(read_file(path, _MOST, "saved result"))
    if not isinstance(content, dict) or content.get("sha256") != checksum_of(content):
        raise InputError("edited, damaged or no saved result: the checksum differs")
    return content


def parsed(found: bytes) -> Any:
    """What JSON text in UTF-8 holds, in memory that the length of the text bounds.

    A list takes some seventy bytes of memory, and two of text: an `InputError` refuses text
    of little else. It also refuses what is no JSON, or names an entry twice.
    """
    if found.count(b"[") + found.count(b"{") > max(_FEW, len(found) // _DENSE):
        raise InputError("its lists hold too little for their number: no file of this package")
    try:
        return json.loads(found.decode("utf-8"), object_pairs_hook=_once)
    except (ValueError, RecursionError) as problem:
        told = str(problem) if isinstance(problem, InputError) else "cut, or not JSON"
        raise InputError(told) from None


def _once(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    """Entries by name; InputError where a name is there twice."""
    found = dict(pairs)
    if len(found) < len(pairs):
        names = [name for name, _ in pairs]
        twice = next(name for name in names if names.count(name) > 1)
        raise InputError(f"{twice!r} is there twice")
    return found


def format_in(path: Path) -> str | None:
    """The format that a file names; None for what names none or cannot be read.

    A file of this package begins with it; one whose entries stand in another order is read
    as a whole.
    """
    try:
        if not path.is_file():  # a pipe would be waited for
            return None
        with path.open(encoding="utf-8") as file:
            beginning = file.read(_BEGINNING)
        first = re.match(r'\s*\{\s*"format"\s*:\s*"([^"\\]*)"', beginning)
        if first:
            return first[1]
        content = parsed(read_file(path, _MOST, "saved result"))
    except (OSError, ValueError):
        return None
    named = content.get("format") if isinstance(content, dict) else None
    return named if isinstance(named, str) else None


@contextmanager
def naming(path: str | os.PathLike[str]) -> Iterator[Path]:
    """Put the name of the file in front of each `InputError` of the block.

    Errors about entries of the wrong shape become an `InputError` too.
    """
    try:
        yield Path(path)
    except InputError as problem:
        raise InputError(f"{os.fspath(path)}: {problem}") from None
    except WRONG_SHAPE as problem:
        raise InputError(f"{os.fspath(path)}: not in order: {problem}") from None


def array_in(
    file: zipfile.ZipFile,
    name: str,
    expected: Callable[[tuple[int, ...], np.dtype[Any]], bool],
    most: float,
) -> np.ndarray:
    """The array of a name, without its ending, in an archive.

    `expected` says whether a shape and a type are those of the array; `most` is in bytes.
    An `InputError` refuses any other array, a larger one, and one that is not as long as
    its header says. Compressed data are unpacked piece by piece: all at once they may be a
    thousand times as large as the archive says.
    """
    told = file.getinfo(f"{name}.npy")
    # Python unpacks other packings only as a whole, however little is asked for
    if told.compress_type not in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED):
        raise InputError(f"{told.filename!r} is not packed as NumPy does it")
    with file.open(told) as entry:
        if np.lib.format.read_magic(entry) != (1, 0):
            raise InputError(f"'{name}.npy' is of another format of arrays")
        shape, by_columns, dtype = np.lib.format.read_array_header_1_0(entry)
        if not expected(shape, dtype):
            raise InputError(f"{name!r} is not an array of its shape and type")
        size = math.prod(shape) * dtype.itemsize
        if size != told.file_size - entry.tell():
            raise InputError(f"'{name}.npy' is not as long as its header says")
        if size > most:
            raise InputError(
                f"'{name}.npy' takes {size / 1e6:.3g} MB, packed into"
                f" {told.compress_size / 1e6:.3g}: so much is not unpacked"
            )
        content = bytearray()
        while len(content) <= size and (piece := entry.read(_PIECE)):
            content += piece
    if len(content) != size:
        raise InputError(DAMAGED)
    return np.frombuffer(content, dtype).reshape(shape, order="F" if by_columns else "C")

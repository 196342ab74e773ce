"""Kinds of result files: JSON with a format, a version and a checksum."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path
from typing import Any

from nonsmooth.runtime.errors import InputError
from nonsmooth.runtime.files import read_file
from nonsmooth.runtime.saved import check_entries, checksum_of, parsed, write_content

__all__ = ["WRONG_SHAPE", "Form", "naming"]

_COMMON: dict[str, type] = {"format": str, "version": int, "package": str, "sha256": str}
# what entries of the wrong shape raise where they are read
WRONG_SHAPE = (KeyError, IndexError, TypeError, ValueError, AttributeError, ArithmeticError)


@dataclass(frozen=True)
class Form:
    """A kind of file.

    Attributes
    ----------
    name : str
        Its format.
    what : str
        What it holds, in words.
    fields : dict of str to type
        Its entries, beside format, version, package and checksum.
    version : int
    most : int
        Bytes; a larger file is not read.
    """

    name: str
    what: str
    fields: Mapping[str, type]
    version: int = 1
    most: int = 500_000_000

    def write(self, path: str | os.PathLike[str], entries: Mapping[str, Any]) -> None:
        """Write a file; what was there stays until the new content is complete.

        Raises
        ------
        InputError
            If the file cannot be written.
        """
        write_content(Path(path), self.content(entries))

    def content(self, entries: Mapping[str, Any]) -> dict[str, Any]:
        """Entries with the format, version, package and checksum."""
        head = {"format": self.name, "version": self.version, "package": version("nonsmooth")}
        content = {**head, **entries}
        return {**content, "sha256": checksum_of(content)}

    def read(self, path: Path) -> dict[str, Any]:
        """Entries of a file, of the right types.

        Raises
        ------
        InputError
            If the file cannot be read, or is cut, edited or foreign.
        """
        content: dict[str, Any] = parsed(read_file(path, self.most, self.what))
        self.check(content)
        return content

    def check(self, content: Any) -> None:
        """Refuse content of another format or version, with other entries or checksum.

        Raises
        ------
        InputError
        """
        if not isinstance(content, dict) or content.get("format") != self.name:
            raise InputError(f"not a {self.what}, such as --save or save() writes")
        check_entries(content, self.version, {**_COMMON, **self.fields})


@contextmanager
def naming(path: str | os.PathLike[str]) -> Iterator[Path]:
    """Name the file in what is said of it; entries of the wrong shape are an InputError too."""
    try:
        yield Path(path)
    except InputError as problem:
        raise InputError(f"{os.fspath(path)}: {problem}") from None
    except WRONG_SHAPE as problem:
        raise InputError(f"{os.fspath(path)}: not in order: {problem}") from None

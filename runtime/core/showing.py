"""How results show themselves, a few lines in a console, a table in a notebook, and are kept."""

import os
from typing import ClassVar

from nonsmooth.runtime.core.registry import registered

__all__ = ["Kept", "Shown"]


class Shown:
    """A result that tells what it is; `present.summaries` has the words of each kind."""

    def __repr__(self) -> str:
        text: str = registered("summary_text")(self)
        return text

    def _repr_html_(self) -> str:
        text: str = registered("summary_html")(self)
        return text


class Kept(Shown):
    """A result that a file keeps; `_kept_by` names the function that writes it."""

    _kept_by: ClassVar[str]

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the result to a file, which `nonsmooth.load` reads.

        An `InputError` says that the file cannot be written.
        """
        registered(self._kept_by)(self, path)

"""Results that show and keep themselves, by functions that are found by their names.

A record holds data and knows of no picture or file; its ``plot``, ``save`` and ``_repr_html_``
ask here for the function that does it. The face of the package says where these functions stand;
each module is imported when it is first asked for.
"""

import os
from collections.abc import Mapping
from importlib import import_module
from typing import Any, ClassVar

from nonsmooth.runtime.core.arguments import checked_methods

_PLACES: dict[str, str] = {}


def register(module: str, names: Mapping[str, str]) -> None:
    """Note where functions are: `names` maps each to its module below the package `module`."""
    _PLACES.update({name: f"{module}.{place}" for name, place in names.items()})


def registered(name: str) -> Any:
    """The function of a name; KeyError if nothing is registered under it."""
    return getattr(import_module(_PLACES[name]), name)


class Shown:
    """A result that tells what it is; `present.tell` has the words of each kind."""

    def __init_subclass__(cls, **options: Any) -> None:
        super().__init_subclass__(**options)
        checked_methods(cls)

    def __repr__(self) -> str:
        text: str = registered("result_text")(self)
        return text

    def _repr_html_(self) -> str:
        text: str = registered("result_html")(self)
        return text


class Kept(Shown):
    """A result that a file keeps; `_kept_by` names the function that writes it."""

    _kept_by: ClassVar[str] = "save_result"

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the result to a file, which `nonsmooth.load` reads.

        An `InputError` says that the file cannot be written.
        """
        registered(self._kept_by)(self, path)

    def to_json(self) -> dict[str, Any]:
        """Give the result as JSON, ready for `json.dumps`.

        Numbers keep all their digits, most of them as decimal strings; one that is not known is
        null.
        """
        told: dict[str, Any] = registered("result_json")(self)
        return told


class Certified(Kept):
    """A proof that a file keeps, and that answers state."""

    def to_json(self) -> dict[str, Any]:
        """Give what is proved as JSON: numbers as decimal strings or fractions.

        Returns
        -------
        dict
            Ready for `json.dumps`.
        """
        from nonsmooth.runtime.core.json_codec import answer  # NumPy, which `--help` does without

        return answer(self)

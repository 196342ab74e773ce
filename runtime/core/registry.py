"""What shows and keeps results, by name, for records that know nothing of it.

A record holds data; its ``plot``, ``save`` and ``_repr_html_`` ask here for the function that
does it. The face of the package says where these functions stand; each module is imported when
it is first asked for.
"""

from collections.abc import Mapping
from importlib import import_module
from typing import Any

__all__ = ["register", "registered"]

_PLACES: dict[str, str] = {}


def register(module: str, names: Mapping[str, str]) -> None:
    """Note where functions are: `names` maps each to its module below the package `module`."""
    _PLACES.update({name: f"{module}.{place}" for name, place in names.items()})


def registered(name: str) -> Any:
    """The function of a name; KeyError if nothing is registered under it."""
    return getattr(import_module(_PLACES[name]), name)

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
    """Say where functions stand.

    Parameters
    ----------
    module : str
        The package that holds them.
    names : mapping of str to str
        From the name of a function to its module below that package.
    """
    _PLACES.update({name: f"{module}.{place}" for name, place in names.items()})


def registered(name: str) -> Any:
    """Give the function of a name.

    Returns
    -------
    callable

    Raises
    ------
    KeyError
        If nothing is registered under this name.
    """
    return getattr(import_module(_PLACES[name]), name)

"""Functions and classes by name, for what stands below the modules that hold them.

A system gives its own kernels and the equations of an orbit show themselves in a notebook, but a
declaration knows no emitter and equations know no document. They ask here by name. The package
says where each name stands; the module is imported when the name is first asked for.
"""

from collections.abc import Mapping
from importlib import import_module
from typing import Any

_MODULES: dict[str, str] = {}


def register(modules: Mapping[str, str]) -> None:
    """Enter the full names of the modules that define some names."""
    _MODULES.update(modules)


def registered(name: str) -> Any:
    """The object of a registered name, whose module is imported if need be.

    KeyError says that the name is not registered.
    """
    return getattr(import_module(_MODULES[name]), name)

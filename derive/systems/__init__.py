"""The systems of the source paper, each declared as the paper writes it."""

from importlib import import_module
from types import ModuleType

__all__ = ["SYSTEMS", "declaration"]

SYSTEMS = {
    "rigid-stop": "rigid_stop",
    "elastic-stop": "elastic_stop",
    "dry-friction": "dry_friction",
}


def declaration(name: str) -> ModuleType:
    """Module that declares a built-in system: it has `system` and `orbits`.

    KeyError says that no system of that name is built in.
    """
    return import_module(f"nonsmooth.derive.systems.{SYSTEMS[name]}")

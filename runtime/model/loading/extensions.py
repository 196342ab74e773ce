"""Compiled kernels in files: found in a folder, loaded."""

from __future__ import annotations

import importlib.util
from importlib.machinery import EXTENSION_SUFFIXES
from pathlib import Path
from types import ModuleType

__all__ = ["extension_in", "load_extension"]


def extension_in(folder: Path) -> Path | None:
    """The compiled kernels in a folder, if there are any."""
    places = (folder / f"_kernels{suffix}" for suffix in EXTENSION_SUFFIXES)
    return next((path for path in places if path.is_file()), None)


def load_extension(library: Path) -> ModuleType | None:
    """The compiled kernels in a file; None where this Python cannot load them."""
    spec = importlib.util.spec_from_file_location("nonsmooth_compiled._kernels", library)
    if spec is None or spec.loader is None:
        return None
    try:
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
    except ImportError:
        return None
    return module

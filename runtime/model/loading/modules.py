"""Emitted text as a module."""

from __future__ import annotations

import linecache
from types import ModuleType

__all__ = ["module_of_text"]


def module_of_text(text: str, file: str) -> ModuleType:
    """Execute emitted text; tracebacks through it show its lines.

    Parameters
    ----------
    text : str
    file : str
        What tracebacks call it.

    Returns
    -------
    module
    """
    module = ModuleType("nonsmooth_emitted")
    module.__file__ = file
    linecache.cache[file] = (len(text), None, text.splitlines(keepends=True), file)
    exec(compile(text, file, "exec"), module.__dict__)
    return module

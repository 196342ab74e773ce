"""A stable hash of declarations: equal ones give equal hashes, in every process."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import fields, is_dataclass
from functools import cache
from pathlib import Path
from typing import Any

import sympy as sp

from nonsmooth.derive.errors import DeclarationError

__all__ = ["fingerprint"]


def fingerprint(*declarations: Any) -> str:
    """Hash of declarations, of SymPy's version and of the code that derives from them.

    It has 16 hexadecimal digits. Declarations are systems, itineraries or sequences of
    them; DeclarationError refuses an object that declares nothing.
    """
    parts = [sp.__version__, _code(), *map(_text, declarations)]
    return hashlib.sha256("\n".join(parts).encode()).hexdigest()[:16]


def _text(value: Any) -> str:
    """A text that differs for different values, with all their parts."""
    if is_dataclass(value) and not isinstance(value, type):
        if hasattr(value, "identity"):  # of a system that is not listed
            return _text(value.identity)
        inside = ", ".join(f"{f.name}={_text(getattr(value, f.name))}" for f in fields(value))
        return f"{type(value).__name__}({inside})"
    if isinstance(value, Mapping | sp.Dict):
        entries = [f"{_text(key)}: {_text(entry)}" for key, entry in value.items()]
        # SymPy's own mappings have no order of their own
        return f"{{{', '.join(sorted(entries) if isinstance(value, sp.Dict) else entries)}}}"
    if isinstance(value, sp.MatrixBase):
        placed = (f"{place}: {sp.srepr(entry)}" for place, entry in sorted(value.todok().items()))
        return f"{type(value).__name__}({value.shape}, {{{', '.join(placed)}}})"
    if isinstance(value, sp.Basic):
        return str(sp.srepr(value))
    if isinstance(value, frozenset):
        return f"{{{', '.join(sorted(map(_text, value)))}}}"
    if isinstance(value, tuple | list):
        return f"({', '.join(map(_text, value))})"
    if value is None or isinstance(value, str | bool | int):
        return repr(value)
    raise DeclarationError(f"a declaration holds {value!r}, which declares nothing")


@cache
def _code() -> str:
    """Hash of this package's sources, which makes another release derive anew."""
    digest = hashlib.sha256()
    root = Path(__file__).parents[1]
    for path in sorted(root.rglob("*.py")) + sorted(root.rglob("*.h")):
        digest.update(path.relative_to(root).as_posix().encode())
        digest.update(path.read_bytes())
    return digest.hexdigest()

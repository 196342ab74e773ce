"""Answers as JSON that every reader takes: no NaN and no Infinity, which JSON does not have."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

__all__ = ["nan_as_null"]


def nan_as_null(entry: Any) -> Any:
    """An answer's JSON, with null for each number that is not known.

    Numbers are decimal strings, complex ones ``"re im"``, or JSON numbers; keys stay as they
    are. An infinite number becomes the string ``"inf"`` or ``"-inf"``.

    Examples
    --------
    >>> nan_as_null({"trace": "nan", "bounds": ["0.5", float("inf")], "rates": {"nan": "nan nan"}})
    {'trace': None, 'bounds': ['0.5', 'inf'], 'rates': {'nan': None}}
    """
    match entry:
        case Mapping():
            return {name: nan_as_null(each) for name, each in entry.items()}
        case list() | tuple():
            return [nan_as_null(each) for each in entry]
        case str() if {*entry.split()} == {"nan"}:
            return None
        case float() if not math.isfinite(entry):
            return None if math.isnan(entry) else repr(float(entry))
    return entry

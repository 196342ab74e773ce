"""What the checker refuses: it is asked about every claim before the claim is stated."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from typing import Any

from nonsmooth.runtime.checker.exact import Failure
from nonsmooth.runtime.core.values import flint_precision

__all__ = ["as_read", "refusal"]

_BITS = 64  # the precision of the process in which a file is checked


def refusal(check: Callable[[], object]) -> str:
    """Return the reason why a check by the checker fails, or an empty text if it succeeds."""
    try:
        with flint_precision(_BITS):
            check()
    except Failure as failure:
        return f"the checker refuses it: {failure}"
    except (ArithmeticError, ValueError) as problem:  # numbers beyond what can be enclosed
        return f"the checker refuses it: {type(problem).__name__}: {problem}"
    return ""


def as_read(told: Mapping[str, Any]) -> dict[str, Any]:
    """Return entries as they are read back after they were written as JSON."""
    found: dict[str, Any] = json.loads(json.dumps(told))
    return found

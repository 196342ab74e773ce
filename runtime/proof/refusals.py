"""What the checker refuses: it is asked about every claim before the claim is stated."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from typing import Any

from nonsmooth.runtime.checker.stated.exact import Failure
from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.proof.orbit_to_prove import NotCovered

# what the checker raises where something is not proved, or beyond what can be enclosed
REFUSED = (Failure, ArithmeticError, ValueError)

_BITS = 64  # the precision of the process in which a file is checked


@contextmanager
def asking() -> Iterator[None]:
    """Raise what the checker refuses, or cannot enclose, as `NotCovered` with the reason."""
    try:
        with flint_precision(_BITS):
            yield
    except Failure as failure:
        raise NotCovered(f"the checker refuses it: {failure}") from None
    except (ArithmeticError, ValueError) as problem:  # numbers beyond what can be enclosed
        told = f"{type(problem).__name__}: {problem}"
        raise NotCovered(f"the checker refuses it: {told}") from None


def refusal(check: Callable[[], object]) -> str:
    """Return the reason why a check by the checker fails, or an empty text if it succeeds."""
    try:
        with asking():
            check()
    except NotCovered as reason:
        return str(reason)
    return ""


def holds(check: Callable[[], object]) -> bool:
    """Return whether the checker refuses nothing, at the working precision."""
    try:
        check()
    except REFUSED:
        return False
    return True


def as_read(told: Mapping[str, Any]) -> dict[str, Any]:
    """Return entries as they are read back after they were written as JSON."""
    found: dict[str, Any] = json.loads(json.dumps(told))
    return found

"""What the checker refuses: it is asked about every claim before the claim is stated."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import Any, TypeVar

from nonsmooth.runtime.checker.exact import Failure
from nonsmooth.runtime.core.result_files import checksum_of
from nonsmooth.runtime.core.values import flint_precision

__all__ = ["accepted", "as_file", "as_read", "refusal"]

Found = TypeVar("Found")

_BITS = 64  # the precision of the process in which a file is checked
_HEAD = {"format": "", "version": 0, "package": ""}  # what the checker does not look at


def accepted(
    found: Found,
    parts: Sequence[str],
    without: Callable[[Found, Mapping[str, str]], Found],
    check: Callable[[Found], object],
) -> Found:
    """Return a record with only those parts that the checker accepts.

    All parts rest on the first one: if that is refused, all are left out. `without` gives the
    record without some parts, by the reason of each, and `check` has the checker test the file
    that a record would write.
    """
    reason = refusal(partial(check, found))
    if not reason:
        return found
    left = dict.fromkeys(parts, reason)
    for part in parts if len(parts) > 1 else ():
        others = {name: why for name, why in left.items() if name != part}
        reason = refusal(partial(check, without(found, others)))
        if reason:
            left[part] = reason
        else:
            left = others
        if parts[0] in left:
            return without(found, dict.fromkeys(parts, reason))
    return without(found, left)


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


def as_file(told: Mapping[str, Any]) -> dict[str, Any]:
    """Return entries as the checker reads them from a file, with format, version and checksum."""
    content = as_read({**_HEAD, **told})
    return {**content, "sha256": checksum_of(content)}


def as_read(told: Mapping[str, Any]) -> dict[str, Any]:
    """Return entries as they are read back after they were written as JSON."""
    found: dict[str, Any] = json.loads(json.dumps(told))
    return found

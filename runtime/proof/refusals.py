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
    """What the checker proves of what was found: parts that it refuses are left out.

    Parameters
    ----------
    found : record
        With all its parts.
    parts : sequence of str
        What may be left out; all of them rest on the first one.
    without : callable
        Gives the record without some parts, by the reason of each.
    check : callable
        The check of a file, of what a record would write to it.

    Returns
    -------
    record
        Undecided where parts are left out, with the reasons of the checker.
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
    """Why the checker does not prove something.

    Parameters
    ----------
    check : callable
        Of the checker, with what is stated.

    Returns
    -------
    str
        Its reason; "" where it proves that.
    """
    try:
        with flint_precision(_BITS):
            check()
    except Failure as failure:
        return f"the checker refuses it: {failure}"
    except (ArithmeticError, ValueError) as problem:  # numbers beyond what can be enclosed
        return f"the checker refuses it: {type(problem).__name__}: {problem}"
    return ""


def as_file(told: Mapping[str, Any]) -> dict[str, Any]:
    """Entries as the checker reads them of a file.

    Parameters
    ----------
    told : mapping of str to object
        All but format, version, package and checksum.

    Returns
    -------
    dict
    """
    content = as_read({**_HEAD, **told})
    return {**content, "sha256": checksum_of(content)}


def as_read(told: Mapping[str, Any]) -> dict[str, Any]:
    """Entries as they are read of what is written.

    Returns
    -------
    dict
    """
    found: dict[str, Any] = json.loads(json.dumps(told))
    return found

"""Check one file: ``python -m nonsmooth.runtime.checker FILE``.

The words and exit codes are those of ``nonsmooth certify check``: 0 if every claim of the file
holds, those that it leaves undecided included, 1 if one does not, and 2 if the file is no
certificate, or has entries that are no numbers.
"""

import json
import sys
from collections.abc import Iterator
from typing import Any

from nonsmooth.runtime.checker import CHECKS, Failure, Malformed
from nonsmooth.runtime.core.values import as_value


def judged(path: str) -> tuple[int, str]:
    """Return the exit code for a file, and what is said of it."""
    try:
        with open(path, encoding="utf-8") as file:
            content = json.load(file)
    except (OSError, ValueError, RecursionError) as problem:
        return 2, f"it cannot be read: {problem}"
    told = content.get("format") if isinstance(content, dict) else None
    if not isinstance(told, str) or told not in CHECKS:
        return 2, "it is no certificate"
    try:
        CHECKS[told](content)
    except Malformed as problem:
        return 2, f"it is malformed: {problem}"
    except Failure as problem:
        try:
            for text in _parameters(content):
                as_value(text)
        except (ValueError, ZeroDivisionError) as wrong:
            return 2, f"it is malformed: {wrong}"
        return 1, f"a claim is not proved: {problem}"
    except (LookupError, TypeError, ValueError, AttributeError, ArithmeticError) as problem:
        return 1, f"no claim is proved, as the file is not in order: {problem!r}"
    return 0, "every claim holds"


def _parameters(entry: Any) -> Iterator[str]:
    """Yield the texts of all parameters in an entry of a file of the right shape."""
    if isinstance(entry, dict):
        given = entry.get("parameters")
        if isinstance(given, dict):
            yield from given.values()
        entry = [*entry.values()]
    for part in entry if isinstance(entry, list) else ():
        yield from _parameters(part)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        print("python -m nonsmooth.runtime.checker takes one file", file=sys.stderr)
        sys.exit(2)
    code, told = judged(sys.argv[1])
    print(f"{sys.argv[1]}: {told}", file=sys.stderr if code else sys.stdout)
    sys.exit(code)

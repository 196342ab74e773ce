"""Check one file: ``python -m nonsmooth.runtime.checker FILE``.

The exit code is 0 if every claim is proved, 1 if one is not, and 2 if the file is no certificate.
"""

import json
import sys

from nonsmooth.runtime.checker import CHECKS, Failure, Malformed


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
        return 1, f"a claim is not proved: {problem}"
    except (LookupError, TypeError, ValueError, AttributeError, ArithmeticError) as problem:
        return 1, f"no claim is proved, as the file is not in order: {problem!r}"
    return 0, "every claim is proved"


if __name__ == "__main__":
    if len(sys.argv) != 2:
        print("python -m nonsmooth.runtime.checker takes one file", file=sys.stderr)
        sys.exit(2)
    code, told = judged(sys.argv[1])
    print(told if code == 0 else f"{sys.argv[1]}: {told}", file=sys.stderr if code else sys.stdout)
    sys.exit(code)

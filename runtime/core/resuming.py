"""Going on with work that was interrupted: what was asked has to be the same."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError

__all__ = ["check_same_question"]


def check_same_question(what: str, asked: Mapping[str, Any], known: Mapping[str, Any]) -> None:
    """Raise `InputError` if work to go on with was kept of another question.

    `what` says in words what was kept. Both mappings hold numbers, texts, records or
    arrays. The message names the first entry of `asked` that `known` lacks or has otherwise.

    Examples
    --------
    >>> check_same_question("sweep", {"state": "x1"}, {"state": "x1", "done": 7})
    """
    for name, value in asked.items():
        if name not in known or not np.array_equal(value, known[name]):
            raise InputError(f"the {what} to resume has another {name}")

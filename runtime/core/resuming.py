"""Going on with work that was interrupted: what was asked has to be the same."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError

__all__ = ["check_same_question"]


def check_same_question(what: str, asked: Mapping[str, Any], known: Mapping[str, Any]) -> None:
    """Refuse to go on with what was kept of another question.

    Parameters
    ----------
    what : str
        What was kept, in words.
    asked, known : mapping of str to object
        What is asked now, and the same of what was kept: numbers, texts, records or arrays.

    Raises
    ------
    InputError
        The message names the first that differs.

    Examples
    --------
    >>> check_same_question("sweep", {"state": "x1"}, {"state": "x1", "done": 7})
    """
    for name, value in asked.items():
        if name not in known or not np.array_equal(value, known[name]):
            raise InputError(f"the {what} to resume has another {name}")

"""Conditions of a design: a quantity, a relation and a value."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Any, Literal

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.values import Value, parse

__all__ = ["DesignCondition", "condition_in"]

_FORM = re.compile(r"\s*([^<>=\s]+)\s*(<=|>=|=)\s*([^<>=]+)")


@dataclass(frozen=True, kw_only=True)
class DesignCondition:
    """A condition on a quantity of an orbit."""

    quantity: str
    relation: Literal["<=", ">=", "="]
    value: Value  # in the unit of the quantity

    @property
    def text(self) -> str:
        """The condition as it is written."""
        return f"{self.quantity}{self.relation}{self.value.text}"

    def excess(self, value: float) -> float:
        """Amount by which a value violates the condition; zero where it holds."""
        missed = value - float(self.value)
        if self.relation == "=":
            return abs(missed)
        return max(0.0, missed if self.relation == "<=" else -missed)


def condition_in(text: str) -> DesignCondition:
    """A condition from a text such as ``period<=6.5``, ``margin>=0`` or ``trace=1/2``.

    Examples
    --------
    >>> condition_in("period <= 13/2").text
    'period<=13/2'
    """
    found = _FORM.fullmatch(text) if isinstance(text, str) else None
    if found is None:
        raise InputError(f"{text!r} is no condition, such as period<=6.5, trace>=0 or tau=1/2")
    relation: Any
    name, relation, value = found.groups()
    return DesignCondition(quantity=name, relation=relation, value=parse(value.strip()))

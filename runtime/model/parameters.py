"""Domains of parameters, and the constraints between those of a system."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cache
from typing import Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.values import Value, as_value
from nonsmooth.runtime.model.kernels import ParameterTable, SystemKernels

__all__ = [
    "check_constraints",
    "check_domain",
    "constrained",
    "domain_text",
    "in_domain",
    "in_domains",
    "number_of",
    "value_of",
]


def in_domain(table: ParameterTable, number: float) -> bool:
    """Whether a parameter may have this value."""
    lower, upper = table.ends
    if lower < number < upper:
        return True
    return (table.closed and number == lower) or (table.upper_closed and number == upper)


def in_domains(table: ParameterTable, numbers: np.ndarray) -> np.ndarray:
    """Which of many numbers a parameter may be; those that are not finite never."""
    inside: np.ndarray = np.isfinite(numbers)
    lower, upper = table.ends
    if table.lower is not None:
        inside &= (numbers > lower) | (table.closed & (numbers == lower))
    if table.upper is not None:
        inside &= (numbers < upper) | (table.upper_closed & (numbers == upper))
    return inside


def check_constraints(kernels: SystemKernels, values: Mapping[str, Value]) -> None:
    """Check the constraints of a system, as far as their parameters have values.

    Raises
    ------
    InputError
        Names the values and the constraint that does not hold.
    """
    numbers = {n: float(v) if v.exact is None else v.exact for n, v in values.items()}
    for text, names, total in _constraints(kernels, numbers):
        if total < 0:
            told = ", ".join(f"{name} = {value}" for name, value in values.items() if name in names)
            raise InputError(f"{told}: {text} does not hold")


def constrained(kernels: SystemKernels, numbers: Mapping[str, np.ndarray]) -> np.ndarray:
    """At which points the constraints hold whose parameters have numbers (n,)."""
    totals = [np.asarray(total) >= 0 for _, _, total in _constraints(kernels, numbers)]
    shape = np.broadcast_shapes(*(np.shape(column) for column in numbers.values()))
    return np.asarray(np.logical_and.reduce([np.full(shape, True), *totals]))


def _constraints(
    kernels: SystemKernels, numbers: Mapping[str, Any]
) -> Iterator[tuple[str, set[str], Any]]:
    """Text, names and value of each constraint of a system whose parameters are known.

    A constraint is a sum of products with their factors: ``{"a*b**2": 3, "1": -1}``.
    """
    for constraint in kernels.table["constraints"]:
        total, used = 0, set[str]()
        for text, factor in constraint["terms"].items():
            product: Any = factor
            for name, power in _powers(text):
                used.add(name)
                product = product * numbers[name] ** power if name in numbers else 0
            total = total + product
        if used <= set(numbers):
            yield constraint["text"], used, total


@cache
def _powers(product: str) -> list[tuple[str, int]]:
    """Names and powers of a product such as ``a*b**2``; none of ``1``."""
    parts = (part.partition("^") for part in product.replace("**", "^").split("*"))
    return [(name, int(power or 1)) for name, _, power in parts if name != "1"]


def value_of(table: ParameterTable, given: object) -> Value:
    """Value of one parameter; InputError if it is no number or outside the domain."""
    value = number_of(table.name, given)
    check_domain(table, value)
    return value


def number_of(name: str, given: object) -> Value:
    """Value that is given for a name; InputError, which names it, if it is no number."""
    try:
        return as_value(given)
    except InputError as error:
        raise InputError(f"parameter {name}: {error}") from None


def check_domain(table: ParameterTable, value: Value) -> None:
    """Refuse a value that a parameter cannot have."""
    if not in_domain(table, float(value)):
        raise InputError(f"{table.name} = {value} is outside its domain {domain_text(table)}")


def domain_text(table: ParameterTable) -> str:
    """The domain as an interval."""
    opening = "[" if table.closed else "("
    closing = "]" if table.upper_closed else ")"
    return f"{opening}{table.lower or '-oo'}, {table.upper or 'oo'}{closing}"

"""Domains of parameters, and the constraints between those of a system."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
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
    """Whether a number is in a parameter's domain."""
    lower, upper = table.ends
    if lower < number < upper:
        return True
    return (table.closed and number == lower) or (table.upper_closed and number == upper)


def in_domains(table: ParameterTable, numbers: np.ndarray) -> np.ndarray:
    """For each number of an array, whether it is in a parameter's domain; False unless finite."""
    inside: np.ndarray = np.isfinite(numbers)
    lower, upper = table.ends
    if table.lower is not None:
        inside &= (numbers > lower) | (table.closed & (numbers == lower))
    if table.upper is not None:
        inside &= (numbers < upper) | (table.upper_closed & (numbers == upper))
    return inside


def check_constraints(kernels: SystemKernels, values: Mapping[str, Value]) -> None:
    """Check those constraints of a system whose parameters all have values.

    The `InputError` names the values and the constraint that does not hold.
    """
    for text, names, total in _constraints(kernels, values, _number):
        if total < 0:
            told = ", ".join(f"{name} = {value}" for name, value in values.items() if name in names)
            raise InputError(f"{told}: {text} does not hold")


def constrained(kernels: SystemKernels, numbers: Mapping[str, np.ndarray]) -> np.ndarray:
    """Bools (n,): at which points the constraints hold whose parameters have numbers (n,)."""
    found = _constraints(kernels, numbers, np.asarray)
    totals = [np.asarray(total) >= 0 for _, _, total in found]
    shape = np.broadcast_shapes(*(np.shape(column) for column in numbers.values()))
    return np.asarray(np.logical_and.reduce([np.full(shape, True), *totals]))


def _constraints(
    kernels: SystemKernels, values: Mapping[str, Any], number: Callable[[Any], Any]
) -> Iterator[tuple[str, set[str], Any]]:
    """Text, names and value of each constraint of a system whose parameters are known.

    A constraint is a sum of products with their factors: ``{"a*b**2": 3, "1": -1}``.
    """
    for constraint, used in _used(kernels):
        if used <= values.keys():
            total: Any = 0
            for text, factor in constraint["terms"].items():
                product: Any = factor
                for name, power in _powers(text):
                    product = product * number(values[name]) ** power
                total = total + product
            yield constraint["text"], used, total


def _number(value: Value) -> Fraction | float:
    return float(value) if value.exact is None else value.exact


@cache
def _used(kernels: SystemKernels) -> list[tuple[dict[str, Any], set[str]]]:
    """Constraints of a system, and the names in each."""
    return [
        (constraint, {name for text in constraint["terms"] for name, _ in _powers(text)})
        for constraint in kernels.table["constraints"]
    ]


@cache
def _powers(product: str) -> list[tuple[str, int]]:
    """Names and powers in a product such as ``a*b**2``; ``1`` has none."""
    parts = (part.partition("^") for part in product.replace("**", "^").split("*"))
    return [(name, int(power or 1)) for name, _, power in parts if name != "1"]


def value_of(table: ParameterTable, given: object) -> Value:
    """The value of one parameter from a number, its text or a Value.

    Raises `InputError` if it is no number or outside the domain.
    """
    value = number_of(table.name, given)
    check_domain(table, value)
    return value


def number_of(name: str, given: object) -> Value:
    """The value that is given for a name as a number, its text or a Value.

    Raises `InputError` if it is no number; the message gives the name.
    """
    try:
        return as_value(given)
    except InputError as error:
        raise InputError(f"parameter {name}: {error}") from None


def check_domain(table: ParameterTable, value: Value) -> None:
    """Raise `InputError` if a value is outside a parameter's domain."""
    if not in_domain(table, float(value)):
        raise InputError(f"{table.name} = {value} is outside its domain {domain_text(table)}")


def domain_text(table: ParameterTable) -> str:
    """A parameter's domain as an interval, such as ``(0, oo)`` or ``[0, 1]``.

    Examples
    --------
    >>> from nonsmooth.runtime.model.kernels import load_system
    >>> domain_text(load_system("dry-friction").parameters[0])
    '(0, 1)'
    """
    opening = "[" if table.closed else "("
    closing = "]" if table.upper_closed else ")"
    return f"{opening}{table.lower or '-oo'}, {table.upper or 'oo'}{closing}"

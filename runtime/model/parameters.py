"""Parameters of a system: domains, constraints, and all of them at one point or at many."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from fractions import Fraction
from functools import cache, reduce
from typing import Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError, unknown_name
from nonsmooth.runtime.core.values import Value, as_value, real_array
from nonsmooth.runtime.model.kernels import ParameterTable, SystemKernels


def in_domain(table: ParameterTable, numbers: Any) -> Any:
    """Whether a number, or each of an array, is in a parameter's domain; NaN is in none."""
    lower, upper = table.ends
    above = numbers >= lower if table.closed else numbers > lower
    return above & (numbers <= upper if table.upper_closed else numbers < upper)


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
    shape = np.broadcast_shapes(*(np.shape(column) for column in numbers.values()))
    return reduce(np.logical_and, (total >= 0 for _, _, total in found), np.full(shape, True))


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
    value = number_of(f"parameter {table.name}", given)
    check_domain(table, value)
    return value


def number_of(name: str, given: object) -> Value:
    """The value that is given for a name as a number, its text or a Value.

    Raises `InputError` if it is no number; the message begins with the name.
    """
    try:
        return as_value(given)
    except InputError as error:
        raise InputError(f"{name}: {error}") from None


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


def system_parameters(kernels: SystemKernels, given: Mapping[str, object]) -> dict[str, Value]:
    """All parameters of a system, checked, in its order.

    Raises `InputError` for an unknown or missing name, a value outside its domain, or values
    that break a constraint.
    """
    tables = {p.name: p for p in kernels.parameters}
    _check_names(kernels, given)
    values = {name: value_of(table, given[name]) for name, table in tables.items()}
    check_constraints(kernels, values)
    return values


def _check_names(kernels: SystemKernels, given: Iterable[str]) -> None:
    """Raise `InputError` if a parameter of the system is missing or a name is unknown.

    `given` is iterated more than once, so it has to be a mapping or a sequence.
    """
    names = [p.name for p in kernels.parameters]
    for name in given:
        if name not in names:
            raise unknown_name("parameter", str(name), names)
    missing = [name for name in names if name not in given]
    if missing:
        raise InputError(f"{kernels.name} needs a value for: {', '.join(missing)}")


def parameter_points(
    kernels: SystemKernels, parameters: Mapping[str, Any]
) -> tuple[np.ndarray, tuple[int, ...]]:
    """Points (n, p) of all parameters of a system, broadcast together, and their common shape.

    Columns are in the system's order. A point outside a domain, or one that breaks a constraint,
    is NaN. Raises `InputError` for an unknown or missing name, or arrays that do not broadcast.
    """
    tables = {p.name: p for p in kernels.parameters}
    _check_names(kernels, parameters)
    arrays = {}
    for name, table in tables.items():
        given = parameters[name]
        if isinstance(given, str | Value):
            given = float(value_of(table, given))
        array = real_array(f"parameter {name}", given)
        arrays[name] = np.where(in_domain(table, array), array, np.nan)
    if not arrays:  # a declaration in numbers alone
        return np.empty((1, 0)), ()
    try:
        shape = np.broadcast_shapes(*(array.shape for array in arrays.values()))
    except ValueError:
        shapes = ", ".join(f"{name} {array.shape}" for name, array in arrays.items())
        raise InputError(f"the parameters do not broadcast: {shapes}") from None
    joined = [np.broadcast_to(array, shape) for array in arrays.values()]
    points = np.stack([array.ravel() for array in joined], axis=-1)
    columns = dict(zip(tables, points.T, strict=True))
    points[~constrained(kernels, columns)] = np.nan
    return points, shape

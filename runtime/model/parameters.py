"""From what a user gives to a parameter point of an orbit: names, domains, conflicts."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError, NoConvergence, unknown_name
from nonsmooth.runtime.core.values import Value, as_value, parse
from nonsmooth.runtime.model.kernels import OrbitKernels, ParameterTable, SystemKernels

__all__ = [
    "Point",
    "check_arrays",
    "check_constraints",
    "constrained",
    "default_parameters",
    "in_domain",
    "in_domains",
    "resolve",
    "value_of",
]


@dataclass(frozen=True)
class Point:
    """Exact parameters of one problem.

    Attributes
    ----------
    values : dict of str to Value
        Those of the equations that are given, in the kernels' order.
    opened : dict of str to Value
        Those that only admissibility depends on, as far as they are given.
    """

    values: dict[str, Value]
    opened: dict[str, Value]


def default_parameters(kernels: OrbitKernels) -> dict[str, str]:
    """Parameters of the orbit's reference point, as decimal text."""
    reference = kernels.table["reference"]
    return dict(reference["parameters"]) if reference else {}


def resolve(
    kernels: OrbitKernels, given: Mapping[str, object], without: Iterable[str] = ()
) -> Point:
    """Check the given parameters and complete them.

    Parameters
    ----------
    kernels : OrbitKernels
    given : mapping of str to str, number or Value
        Parameters of the equations, or the physical ones in their place (us1, ur1 in place
        of e1 = ur1 - us1). What is absent takes the reference point's value.
    without : iterable of str
        Parameters that are to be solved for and take no value.

    Raises
    ------
    InputError
        For an unknown name, a value outside its domain or not a number, or values that
        contradict each other.
    NoConvergence
        If a parameter has a value with which there is no such orbit.
    """
    without = set(without)
    values = {name: _value(name, value) for name, value in given.items()}
    tables = _tables(kernels)
    for name in values:
        if name not in tables:
            raise unknown_name("parameter", str(name), list(tables))
        if name in without:
            raise InputError(f"parameter {name} is both given and to be solved for")
        if name in kernels.solved_for:
            raise InputError(
                f"{name} is an unknown of {kernels.name}: to give it, solve for another"
                f" parameter in its place (--unknown NAME --given {name}={values[name]})"
            )
        _check_domain(tables[name], values[name])
    for name, text in kernels.required.items():
        if name in values and not _same(values[name], parse(text)):
            raise NoConvergence(
                f"{kernels.name} exists only for {name} = {text}: with {name} = {values[name]}"
                " no orbit has this itinerary"
            )
    without |= set(kernels.solved_for)
    for name, terms in kernels.combined.items():
        _combine(kernels, name, terms, values, without)
    defaults = default_parameters(kernels)
    point, missing = {}, []
    for name in kernels.parameter_names:
        if name in without:
            continue
        if name in values:
            point[name] = values[name]
        elif name in defaults:
            point[name] = parse(defaults[name])
        else:
            missing.append(name)
    if missing:
        raise InputError(f"{kernels.name} needs a value for: {', '.join(missing)}")
    opened = {}
    for name in (p.name for p in kernels.open_parameters):
        if name in values:
            opened[name] = values[name]
        elif name in defaults:  # of an orbit that was saved with it
            opened[name] = parse(defaults[name])
    known = {**values, **point}
    for name, value in known.items():
        _check_domain(tables[name], value)
    check_constraints(kernels.system, known)
    return Point(point, opened)


def check_arrays(kernels: OrbitKernels, arrays: Mapping[str, Any]) -> dict[str, np.ndarray]:
    """Arrays of parameters for a batch: names known, the rest from the reference point.

    Values outside a domain stay: their points get a status of their own.
    """
    defaults = default_parameters(kernels)
    for name in arrays:
        if name not in kernels.parameter_names:
            raise unknown_name("parameter", name, kernels.parameter_names)
    found = {}
    for name in kernels.parameter_names:
        value = arrays.get(name, defaults.get(name))
        if value is None:
            raise InputError(f"{kernels.name} needs a value for: {name}")
        try:
            if isinstance(value, str | Value):
                value = float(as_value(value))
            array = np.asarray(value)
            if array.dtype.kind in "bcmM":
                raise TypeError(f"{array.dtype} is no type of real numbers")
            found[name] = array.astype(float)
        except (TypeError, ValueError) as error:
            raise InputError(f"parameter {name}: {error}") from None
    return found


def _tables(kernels: OrbitKernels) -> dict[str, ParameterTable]:
    """All parameters that may be given, by name, those of the equations first."""
    every = (*kernels.parameters, *kernels.open_parameters, *kernels.other_parameters)
    return {p.name: p for p in every}


def _value(name: str, value: object) -> Value:
    try:
        return as_value(value)
    except InputError as error:
        raise InputError(f"parameter {name}: {error}") from None


def _combine(
    kernels: OrbitKernels,
    name: str,
    terms: Mapping[str, int],
    values: dict[str, Value],
    without: set[str],
) -> None:
    """Complete ``name = sum of terms``: derive the one that is missing, or check all."""
    absent = [term for term in terms if term not in values]
    if not absent:
        total = _sum((Fraction(factor), values[term]) for term, factor in terms.items())
        if name in without:
            raise InputError(f"parameter {name} is to be solved for, but {', '.join(terms)} fix it")
        if name in values and not _same(values[name], total):
            raise InputError(
                f"{name} = {values[name]} contradicts {_sum_text(terms)} = {float(total)!r}"
            )
        table = _tables(kernels)[name]
        if not in_domain(table, float(total)):
            given = ", ".join(f"{term} = {values[term]}" for term in terms)
            raise InputError(
                f"{given}: {name} = {_sum_text(terms)} is {float(total)!r},"
                f" outside its domain {_domain(table)}"
            )
        values[name] = values.get(name, total)
    elif name in without:
        opened = {p.name for p in kernels.open_parameters}
        for term in terms.keys() & values.keys() - opened:
            raise InputError(
                f"parameter {term} decides nothing while {name} is to be solved for:"
                f" give {' or '.join(opened & terms.keys())} instead"
            )
    elif len(absent) == 1 and len(terms) > 1:
        # of e, us and ur two are known (e perhaps by default): the third follows
        default = default_parameters(kernels).get(name)
        combined = values.get(name) or (parse(default) if default else None)
        if combined is not None:
            unit = Fraction(1, terms[absent[0]])
            rest = [(-unit * f, values[t]) for t, f in terms.items() if t != absent[0]]
            values[absent[0]] = _sum([(unit, combined), *rest])


def _sum(terms: Iterable[tuple[Fraction, Value]]) -> Value:
    """Sum of multiples of values: an exact fraction where all of them are."""
    terms = list(terms)
    exact = [factor * value.exact for factor, value in terms if value.exact is not None]
    if len(exact) == len(terms):
        return as_value(sum(exact, Fraction(0)))
    return parse(" + ".join(f"({factor})*({value.text})" for factor, value in terms))


def _same(first: Value, second: Value) -> bool:
    if first.exact is not None and second.exact is not None:
        return first.exact == second.exact
    return bool(first.ball(256).overlaps(second.ball(256)))


def _sum_text(terms: Mapping[str, int]) -> str:
    text = ""
    for name, factor in terms.items():
        sign = "-" if factor < 0 else "+" if text else ""
        size = "" if abs(factor) == 1 else f"{abs(factor)} "
        text += f"{' ' if text else ''}{sign}{' ' if text else ''}{size}{name}"
    return text


def in_domain(table: ParameterTable, number: float) -> bool:
    """Whether a parameter may have this value."""
    lower = float("-inf") if table.lower is None else float(parse(table.lower))
    upper = float("inf") if table.upper is None else float(parse(table.upper))
    if lower < number < upper:
        return True
    return (table.closed and number == lower) or (table.upper_closed and number == upper)


def in_domains(table: ParameterTable, numbers: np.ndarray) -> np.ndarray:
    """Which of many numbers a parameter may be; those that are not finite never."""
    inside: np.ndarray = np.isfinite(numbers)
    if table.lower is not None:
        lower = float(parse(table.lower))
        inside &= (numbers > lower) | (table.closed & (numbers == lower))
    if table.upper is not None:
        upper = float(parse(table.upper))
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


def _powers(product: str) -> list[tuple[str, int]]:
    """Names and powers of a product such as ``a*b**2``; none of ``1``."""
    parts = (part.partition("^") for part in product.replace("**", "^").split("*"))
    return [(name, int(power or 1)) for name, _, power in parts if name != "1"]


def value_of(table: ParameterTable, given: object) -> Value:
    """Value of one parameter; InputError if it is no number or outside the domain."""
    value = _value(table.name, given)
    _check_domain(table, value)
    return value


def _check_domain(table: ParameterTable, value: Value) -> None:
    if not in_domain(table, float(value)):
        raise InputError(f"{table.name} = {value} is outside its domain {_domain(table)}")


def _domain(table: ParameterTable) -> str:
    opening = "[" if table.closed else "("
    closing = "]" if table.upper_closed else ")"
    return f"{opening}{table.lower or '-oo'}, {table.upper or 'oo'}{closing}"

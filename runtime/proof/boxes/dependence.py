"""How numbers depend on the parameters of a box: as sums of multiples of them, or not at all."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import Any, NamedTuple

from nonsmooth.runtime.core.values import Value, as_value
from nonsmooth.runtime.proof.boxes.tile_places import Interval
from nonsmooth.runtime.proof.exact_tables import constant_symbols, rational_of
from nonsmooth.runtime.proof.orbit_cycle import NotCovered

__all__ = ["PERIOD", "Entries", "entries_over"]

PERIOD = ""  # stands for the period among the names of parameters


class Entries(NamedTuple):
    """Numbers as rational functions.

    Attributes
    ----------
    constants : tuple of Value
        Irrational numbers; they follow the box's parameters in the functions.
    entries : dict of str to fmpq or RationalFunction
    """

    constants: tuple[Value, ...]
    entries: dict[str, Any]


def entries_over(
    box: Mapping[str, Interval], numbers: Callable[[Mapping[str, Value]], Mapping[str, Value]]
) -> Entries:
    """Numbers that are sums of multiples of a box's parameters: two points tell each slope.

    Parameters
    ----------
    box : mapping of str to (Fraction, Fraction)
    numbers : function
        Gives all numbers by name at a point of the box.

    Raises
    ------
    NotCovered
        If an irrational number changes over the box.
    """

    def at(point: Mapping[str, Fraction]) -> Mapping[str, Value]:
        return numbers({name: as_value(x) for name, x in point.items()})

    lower = {name: low for name, (low, _) in box.items()}
    base = at(lower)
    moved = {axis: at({**lower, axis: high}) for axis, (_, high) in box.items()}
    constants = tuple(
        dict.fromkeys(
            value
            for name, value in base.items()
            if value.exact is None and all(other[name] == value for other in moved.values())
        )
    )
    found = constant_symbols(tuple(box), constants)
    variables = dict(zip(box, found, strict=False))
    constant = dict(zip(constants, found[len(box) :], strict=True))

    def entry(name: str, value: Value) -> Any:
        if value in constant:
            return constant[value]
        total: Any = rational_of(_exact(name, value))
        for axis, (low, high) in box.items():
            slope = (_exact(name, moved[axis][name]) - _exact(name, value)) / (high - low)
            if slope:
                total = total + (variables[axis] - rational_of(low)) * rational_of(slope)
        return total

    return Entries(constants, {name: entry(name, value) for name, value in base.items()})


def _exact(name: str, value: Value) -> Fraction:
    if value.exact is None:
        raise NotCovered(f"{name or 'the period'} = {value} is irrational, and so are its sums")
    return value.exact

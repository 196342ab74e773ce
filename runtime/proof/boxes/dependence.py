"""How numbers depend on the parameters of a box: as sums of multiples of them, or not at all."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import Any, NamedTuple

from nonsmooth.runtime.core.irrational_numbers import Irrationals
from nonsmooth.runtime.core.values import Value, as_value
from nonsmooth.runtime.proof.boxes.tile_places import Interval
from nonsmooth.runtime.proof.exact_tables import constants_over, rational_of
from nonsmooth.runtime.proof.orbit_to_prove import NotCovered

__all__ = ["PERIOD", "Entries", "entries_over"]

PERIOD = ""  # stands for the period among the names of parameters


class Entries(NamedTuple):
    """Numbers as rational functions.

    Attributes
    ----------
    known : Irrationals
        Irrational numbers; what they are made of follows the box's parameters in the functions.
    entries : dict of str to fmpq or RationalFunction
    """

    known: Irrationals
    entries: dict[str, Any]


def entries_over(
    box: Mapping[str, Interval],
    numbers: Callable[[Mapping[str, Value]], Mapping[str, Value]],
    texts: Sequence[str] = (),
) -> Entries:
    """Numbers that are sums of multiples of a box's parameters: two points tell each slope.

    Parameters
    ----------
    box : mapping of str to (Fraction, Fraction)
    numbers : function
        Gives all numbers by name at a point of the box.
    texts : sequence of str, optional
        Irrational numbers beside these.

    Returns
    -------
    Entries
        The irrational numbers, and each number as a function of the box's parameters.

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
    still = [
        value.text
        for name, value in base.items()
        if value.exact is None and all(other[name] == value for other in moved.values())
    ]
    known = constants_over(tuple(box), [*still, *texts])
    variables = dict(zip(box, known.variables, strict=True))

    def entry(name: str, value: Value) -> Any:
        if value.text in still:
            return known.numbers[value.text]
        total: Any = rational_of(_exact(name, value))
        for axis, (low, high) in box.items():
            slope = (_exact(name, moved[axis][name]) - _exact(name, value)) / (high - low)
            if slope:
                total = total + (variables[axis] - rational_of(low)) * rational_of(slope)
        return total

    return Entries(known, {name: entry(name, value) for name, value in base.items()})


def _exact(name: str, value: Value) -> Fraction:
    if value.exact is None:
        raise NotCovered(f"{name or 'the period'} = {value} is irrational, and so are its sums")
    return value.exact

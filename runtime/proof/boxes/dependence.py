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
    """Numbers as rational functions of a box's parameters."""

    known: Irrationals  # irrational numbers; their variables follow the parameters in the functions
    entries: dict[str, Any]  # fmpq or RationalFunction by name


def entries_over(
    box: Mapping[str, Interval],
    numbers: Callable[[Mapping[str, Value]], Mapping[str, Value]],
    texts: Sequence[str] = (),
) -> Entries:
    """Each number as a rational function of a box's parameters, which have to enter it affinely.

    `numbers` gives all numbers by name at a point of the box. Two points give each slope; that
    nothing is bent between them is assumed. `texts` are further irrational numbers to include.
    Refused with `NotCovered` if an irrational number changes over the box.
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

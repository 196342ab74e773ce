"""The box of dwell times that is asked about."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from nonsmooth.runtime.core.errors import InputError, unknown_name
from nonsmooth.runtime.core.values import Value, as_value
from nonsmooth.runtime.proof.counting.contraction import floats_around

if TYPE_CHECKING:
    from flint import arb

__all__ = ["SHORTEST", "Side", "sides_of"]

SHORTEST = "1e-6"
_BITS = 256  # of irrational bounds


@dataclass(frozen=True)
class Side:
    """Bounds of one dwell time.

    They belong to the box, but a lower bound 0 does not: dwell times are positive.
    """

    name: str
    lower: Value
    upper: Value | None  # None: not bounded

    @property
    def floats(self) -> tuple[float, float]:
        """Doubles around the bounds."""
        low, _ = _around(self.lower)
        high = math.inf if self.upper is None else _around(self.upper)[1]
        return max(0.0, low), high

    def holds(self, time: arb) -> bool | None:
        """Whether a dwell time is inside; None if its enclosure has points on both sides."""
        low = self.lower.ball(_BITS)
        high = None if self.upper is None else self.upper.ball(_BITS)
        if time <= 0 or time < low or (high is not None and time > high):
            return False
        return True if time > 0 and time >= low and (high is None or time <= high) else None

    def __str__(self) -> str:
        """The bounds as inequalities."""
        strict = self.lower.exact == 0
        left = f"{self.lower} {'<' if strict else '<='} {self.name}"
        return left if self.upper is None else f"{left} <= {self.upper}"


def sides_of(
    names: Sequence[str], searched: Sequence[str], box: Mapping[str, Any]
) -> tuple[Side, ...]:
    """Sides of a box in the order of the dwell times: of those in the box or not searched.

    `names` has all dwell times, `searched` those that need an upper bound. The others, if they
    are not in the box, only have to be positive. `box` gives an upper bound, or both; the lower
    one is 1e-6 by default. `InputError` for unknown names, bounds that are missing or not in
    order.
    """
    for name in box:
        if name not in names:
            raise unknown_name("dwell time", str(name), list(names))
    missing = [name for name in searched if name not in box]
    if missing:
        wanted = ", ".join(missing)
        raise InputError(f"the box has no bounds of {wanted}, as in {missing[0]}=0:10")
    return tuple(
        _side(name, box[name]) if name in box else Side(name, as_value(0), None)
        for name in names
        if name in box or name not in searched
    )


def _side(name: str, bounds: Any) -> Side:
    if isinstance(bounds, Sequence) and not isinstance(bounds, str):
        if len(bounds) != 2:
            raise InputError(f"{name}: {len(bounds)} bounds are given, not two")
        first, last = bounds
    else:
        first, last = SHORTEST, bounds
    try:
        lower, upper = as_value(first), as_value(last)
    except InputError as problem:
        raise InputError(f"{name}: {problem}") from None
    if not 0 <= float(lower) < float(upper):
        raise InputError(f"{name}: {lower} and {upper} are not bounds of a dwell time, in order")
    return Side(name, lower, upper)


def _around(value: Value) -> tuple[float, float]:
    if value.exact is not None and float(value) == value.exact:
        return float(value), float(value)
    return floats_around(value.ball(_BITS))

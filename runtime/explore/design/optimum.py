"""What a design found, and what can be asked of it."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Literal

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.json_codec import AnyDigits, AnyTable, Digits, Table
from nonsmooth.runtime.core.registry import Kept, registered
from nonsmooth.runtime.core.values import Value, parse
from nonsmooth.runtime.orbits.orbit_file import KeptOrbit

__all__ = [
    "AIMS",
    "CONVERGED",
    "NOT_REACHED",
    "ActiveLimit",
    "Design",
    "DesignCondition",
    "condition_in",
]

AIMS = ("minimise", "maximise", "solve")
CONVERGED, NOT_REACHED = 0, 1
_FORM = re.compile(r"\s*([^<>=\s]+)\s*(<=|>=|=)\s*([^<>=]+)")


@dataclass(frozen=True, kw_only=True)
class ActiveLimit:
    """A condition or a bound that holds with equality at an optimum."""

    text: str  # as it was given, such as ``period<=6.5`` or ``V<=1.3``
    # of Karush, Kuhn and Tucker: by how much the quantity improves per unit by which the limit is
    # relaxed; for an equation, by how much it worsens per unit of its value
    multiplier: Digits


@dataclass(frozen=True, eq=False, kw_only=True, repr=False)
class Design(Kept):
    """Parameters at which an orbit is best, or has wanted values.

    Attributes
    ----------
    aim : "minimise", "maximise" or "solve"
    quantity : str
        What was minimised or maximised; empty where values were wanted.
    parameters : tuple of str
        Those that varied.
    bounds : array (q, 2)
    worst_over : dict of str to (float, float)
        The parameter along whose branch the worst value counted, and its interval; else empty.
    conditions : tuple of DesignCondition
        What it was subject to, or the wanted values.
    method : str
        The optimiser of SciPy.
    quantities : tuple of str
        The one that was asked for, and those of the conditions.
    before, after : dict of str to float
        Parameters and quantities where it began and where it ended: along a branch the worst.
    worst_at : tuple of float
        Where along the branch the quantity is worst, at the end; else empty.
    gradient : dict of str to dict of str to float
        Of each quantity by each parameter, where it ended; NaN where there is no derivative.
    active : tuple of ActiveLimit
        Conditions and bounds that hold with equality, with their multipliers.
    corner : str
        What happens where the quantity that was asked for has no derivative; else empty.
    residual : float
        What is left of the conditions of Karush, Kuhn and Tucker, or of the wanted values: in
        units of the quantity, parameters in those of their intervals.
    history : array (k, q + m)
        Parameters and quantities of the iterates; along a branch the worst at the places that
        were watched then.
    status : int
        0 converged, 1 not; `message` says why.
    message : str
    start, orbit : Orbit
        Where it began and where it ended: along a branch at the first worst place.
    """

    aim: Literal["minimise", "maximise", "solve"]
    quantity: str
    parameters: tuple[str, ...]
    bounds: Table
    worst_over: Mapping[str, tuple[Digits, Digits]]
    conditions: tuple[DesignCondition, ...]
    method: str
    quantities: tuple[str, ...]
    before: Mapping[str, Digits]
    after: Mapping[str, Digits]
    worst_at: tuple[Digits, ...]
    gradient: Mapping[str, Mapping[str, AnyDigits]]
    active: tuple[ActiveLimit, ...]
    corner: str
    residual: Digits
    history: AnyTable
    status: int
    message: str
    start: KeptOrbit
    orbit: KeptOrbit

    @property
    def converged(self) -> bool:
        """Whether it ended at an optimum, or at the wanted values."""
        return self.status == CONVERGED

    @property
    def values(self) -> dict[str, float]:
        """Values of the parameters that varied, where it ended."""
        return {name: self.after[name] for name in self.parameters}

    def plot(self, axes: Any = None) -> Any:
        """Draw the quantities over the iterates, and along each parameter around the end.

        Parameters
        ----------
        axes : matplotlib Axes, optional
            Where to draw the iterates alone; a figure of all when omitted.

        Returns
        -------
        Figure or Axes
        """
        return registered("draw_design")(self, axes)


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

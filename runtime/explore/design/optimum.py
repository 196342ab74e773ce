"""What a design is asked for, and what it found.

It is asked for an aim, parameters in bounds, conditions, and a branch perhaps.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.json_codec import AnyDigits, AnyTable, Digits, Table
from nonsmooth.runtime.core.registry import Kept, registered
from nonsmooth.runtime.core.result_files import check_same_question
from nonsmooth.runtime.core.values import Value, as_value, by_name, parse
from nonsmooth.runtime.explore.continuation.continue_orbit import check_interval
from nonsmooth.runtime.explore.design.quantities import MULTIPLIER, RADIUS, is_largest_of_several
from nonsmooth.runtime.model.saved_system import check_same_system
from nonsmooth.runtime.orbits.orbit import Orbit, check_converged
from nonsmooth.runtime.orbits.orbit_file import KeptOrbit

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

    @property
    def asked(self) -> tuple[str, str, float]:
        """The quantity, the relation and the value as a number."""
        return self.quantity, self.relation, float(self.value)


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


@dataclass(frozen=True, eq=False)
class DesignQuestion:
    """What a design is asked for."""

    aim: Any
    quantity: str  # to minimise or maximise, empty for wanted values
    parameters: tuple[str, ...]  # those that vary
    bounds: np.ndarray  # (p, 2)
    conditions: tuple[DesignCondition, ...]  # including the wanted values
    # parameter and interval along which the worst value counts, or nothing
    worst_over: dict[str, tuple[float, float]]

    @property
    def sign(self) -> int:
        """-1 if the quantity is maximised, else 1."""
        return -1 if self.aim == "maximise" else 1

    @property
    def asked(self) -> tuple[str, ...]:
        """All quantities that are asked for, each once."""
        conditions = [condition.quantity for condition in self.conditions]
        return tuple(dict.fromkeys(([self.quantity] if self.quantity else []) + conditions))

    @property
    def measured(self) -> list[str]:
        """All quantities that are asked for except a multiplier."""
        return [name for name in self.asked if name != MULTIPLIER]

    @property
    def rough(self) -> tuple[str, ...]:
        """Quantities that need no derivative: only smooth conditions on levels involve them."""
        rough = []
        if is_largest_of_several(self.quantity, self.sign):
            rough.append(self.quantity)
        asked = self.quantity != RADIUS or self.sign > 0
        if asked and all(c.relation == "<=" for c in self.conditions if c.quantity == RADIUS):
            rough.append(RADIUS)
        return tuple(rough)


def check_resumed(question: DesignQuestion, orbit: Orbit, known: Design) -> None:
    """Refuse to resume the design of another question; the message names what differs."""
    varied = {*question.parameters, *question.worst_over}
    asked = {name: value for name, value in orbit.given.items() if name not in varied}
    own, other = (x.name.removeprefix(x.system.name) for x in (orbit, known.orbit))
    there = {**vars(known), **known.orbit.given, "orbit": other}
    check_same_question("design", {"orbit": own, **vars(question), **asked}, there)
    check_same_system("design", orbit.system, known.orbit.system)


def design_question(
    orbit: Orbit,
    minimise: str | None,
    maximise: str | None,
    solve: Mapping[str, object] | None,
    over: Mapping[str, tuple[float, float]],
    worst_over: Mapping[str, tuple[float, float]] | None,
    subject_to: Iterable[str],
) -> DesignQuestion:
    """The question of a design from the arguments of `design`, checked."""
    aims = {"minimise": minimise, "maximise": maximise, "solve": solve}
    aim, *others = [name for name, value in aims.items() if value] or [""]
    if others or not aim:
        count = len(others) + bool(aim)
        raise InputError(f"one of minimise, maximise and solve is given, not {count}")
    check_converged(orbit, "designed")
    if not over:
        raise InputError('over gives the bounds of parameters, such as {"V": (0.6, 1.3)}')
    opened = {table.name for table in orbit.system.parameters} - {*orbit.given, *orbit.unknowns}
    for name in over:
        if name in opened:
            raise InputError(
                f"no equation of {orbit.name} depends on {name}: it is at most a limit of its"
                " admissibility"
            )
    bounds = np.array([check_interval(orbit, *each) for each in over.items()])
    conditions = _conditions_of(solve, subject_to, len(over))
    branch: dict[str, tuple[float, float]] = {}
    if worst_over is not None:
        if not isinstance(worst_over, Mapping) or len(worst_over) != 1:
            raise InputError(
                'worst_over gives the interval of one parameter, such as {"w": (0.9, 1.1)}'
            )
        ((name, interval),) = worst_over.items()
        if name in over:
            raise InputError(f"{name} varies: it cannot be the parameter of the branch too")
        branch[name] = check_interval(orbit, name, interval)
    if branch and aim == "solve":
        raise InputError("values that are solved for are of one orbit: leave out worst_over")
    for each in conditions if branch else ():
        if each.relation == "=":
            raise InputError(f"{each.text}: an equation cannot hold all along worst_over")
    quantity = minimise or maximise or ""
    if quantity == MULTIPLIER:
        raise InputError(f"{MULTIPLIER} is no quantity to {aim}: ask for {RADIUS}")
    return DesignQuestion(aim, quantity, tuple(over), bounds, conditions, branch)


def _conditions_of(
    solve: Mapping[str, object] | None, subject_to: Iterable[str], count: int
) -> tuple[DesignCondition, ...]:
    texts = [subject_to] if isinstance(subject_to, str) else list(subject_to)
    if not solve:
        found = tuple(condition_in(text) for text in texts)
        for each in found:
            if each.quantity == MULTIPLIER and each.relation != "=":
                raise InputError(f"{each.text}: a multiplier is wanted by =, or {RADIUS} by <=")
        equations = sum(each.relation == "=" for each in found)
        if equations > count:
            raise InputError(f"{equations} equations for {count} parameters: solve for them")
        return found
    if texts:
        raise InputError("values that are solved for take no other conditions")
    wanted = tuple(
        DesignCondition(quantity=name, relation="=", value=as_value(value))
        for name, value in by_name("solve", solve).items()
    )
    if len(wanted) != count:
        raise InputError(
            f"{len(wanted)} wanted values for {count} parameters: as many of one as of the other"
        )
    return wanted

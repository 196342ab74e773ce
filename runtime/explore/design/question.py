"""What a design is asked for: an aim, parameters in bounds, conditions, a branch perhaps."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.result_files import check_same_question
from nonsmooth.runtime.core.values import as_value, by_name
from nonsmooth.runtime.explore.continuation.orbit_family import check_interval
from nonsmooth.runtime.explore.design.largest import is_largest_of_several
from nonsmooth.runtime.explore.design.optimum import Design, DesignCondition, condition_in
from nonsmooth.runtime.explore.design.quantities import MULTIPLIER, RADIUS
from nonsmooth.runtime.explore.design.worst_over import branch_interval
from nonsmooth.runtime.model.saved_system import check_same_system
from nonsmooth.runtime.orbits.orbit import Orbit, check_converged

__all__ = ["DesignQuestion", "design_question"]


@dataclass(frozen=True, eq=False)
class DesignQuestion:
    """What a design is asked for."""

    orbit: Orbit
    aim: Any
    quantity: str  # to minimise or maximise, empty for wanted values
    parameters: tuple[str, ...]  # those that vary
    bounds: np.ndarray  # (p, 2)
    conditions: tuple[DesignCondition, ...]  # including the wanted values
    # parameter and interval along which the worst value counts
    branch: tuple[str, tuple[float, float]] | None

    @property
    def sign(self) -> int:
        """-1 if the quantity is maximised, else 1."""
        return -1 if self.aim == "maximise" else 1

    @property
    def quantities(self) -> tuple[str, ...]:
        """All quantities that are asked for, each once."""
        conditions = [condition.quantity for condition in self.conditions]
        return tuple(dict.fromkeys(([self.quantity] if self.quantity else []) + conditions))

    @property
    def measured(self) -> list[str]:
        """All quantities that are asked for except a multiplier."""
        return [name for name in self.quantities if name != MULTIPLIER]

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

    @property
    def worst_over(self) -> dict[str, tuple[float, float]]:
        """The branch as `Design` stores it."""
        return {} if self.branch is None else dict([self.branch])

    def check_resumed(self, known: Design) -> None:
        """Refuse to resume the design of another question; the message names what differs."""
        branch = next(iter(known.worst_over.items()), None)
        same = (known.aim, known.quantity, known.parameters, known.bounds, known.conditions, branch)
        other = DesignQuestion(known.orbit, *same)
        check_same_question("design", self._entries(), other._entries())
        check_same_system("design", self.orbit.system, known.orbit.system)

    def _entries(self) -> dict[str, Any]:
        """Entries that have to be equal to resume a design."""
        orbit, varied = self.orbit, {*self.parameters, *self.worst_over}
        return {
            "orbit": orbit.name.removeprefix(orbit.system.name),
            "aim": self.aim,
            "quantity": self.quantity,
            "parameters": self.parameters,
            "bounds": self.bounds,
            "conditions": self.conditions,
            "worst_over": self.worst_over,
            **{name: value for name, value in orbit.given.items() if name not in varied},
        }


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
    aim, quantity = _aim_of(minimise, maximise, solve)
    names, bounds = _bounds_of(orbit, over)
    conditions = _conditions_of(solve, subject_to, len(names))
    branch = branch_interval(orbit, worst_over, names)
    _check_spread(branch is not None, aim, conditions)
    if quantity == MULTIPLIER:
        raise InputError(f"{MULTIPLIER} is no quantity to {aim}: ask for {RADIUS}")
    return DesignQuestion(orbit, aim, quantity, names, bounds, conditions, branch)


def _aim_of(
    minimise: str | None, maximise: str | None, solve: Mapping[str, object] | None
) -> tuple[Any, str]:
    given = {"minimise": minimise, "maximise": maximise, "solve": solve}
    chosen = [name for name, value in given.items() if value]
    if len(chosen) != 1:
        raise InputError(f"one of minimise, maximise and solve is given, not {len(chosen)}")
    return chosen[0], minimise or maximise or ""


def _bounds_of(orbit: Any, over: Any) -> tuple[tuple[str, ...], np.ndarray]:
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
    return tuple(over), np.array([check_interval(orbit, *each) for each in over.items()])


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


def _check_spread(whole: bool, aim: str, conditions: Sequence[DesignCondition]) -> None:
    """Refuse an aim or a condition that cannot hold along a whole branch."""
    if not whole:
        return
    if aim == "solve":
        raise InputError("values that are solved for are of one orbit: leave out worst_over")
    for each in conditions:
        if each.relation == "=":
            raise InputError(f"{each.text}: an equation cannot hold all along worst_over")

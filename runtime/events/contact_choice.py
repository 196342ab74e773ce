"""The choice of the law at a state, in double precision.

What is at its limit within rounding, or slips without acceleration, may go either way: each way
is followed to its end and judged by the first derivatives that are not zero along the flow of
the configuration that it leads to. One way that is consistent is the outcome.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from itertools import product
from typing import NamedTuple

import numpy as np

from nonsmooth.runtime.events.leading_derivative import Located, dot
from nonsmooth.runtime.events.quasi_polynomials import UNIT
from nonsmooth.runtime.model.contacts.law import HOLDING, ContactEvent, Law, Regimes
from nonsmooth.runtime.model.contacts.stages import Path, Stage, requirements

__all__ = ["Chooser", "ContactOutcome"]

_SWEEPS = 200  # of the iteration that guesses what holds


class ContactOutcome(NamedTuple):
    """What follows an event: one path, or several where the law leaves it open."""

    targets: tuple[int, ...]  # configurations that may follow
    paths: tuple[Path, ...]  # a path to each target


class _Signs(NamedTuple):
    """The requirements of a stage: linear functions, and the signs that they have to have."""

    rows: np.ndarray
    bounds: np.ndarray  # sums of absolute values behind the entries of the rows
    positive: np.ndarray  # whether a function has to be positive
    contacts: np.ndarray  # contact of each requirement


@dataclass(frozen=True, eq=False)
class Chooser:
    """The contact law of a system at one parameter point."""

    law: Law
    fields: np.ndarray  # (configurations, N, N + 1)
    rows: np.ndarray  # (R, N + 1)
    _known: dict[tuple[ContactEvent, Stage], _Signs | None] = field(default_factory=dict)

    def outcome(self, event: ContactEvent, at: Located) -> ContactOutcome:
        """What follows an event at a state, which is extended by 1."""
        ways = dict.fromkeys(self._ways(event, event.reached, (), at))
        targets = {path: self.law.configuration(path[-1].regimes, event.others) for path in ways}
        existing = {path: target for path, target in targets.items() if target is not None}
        if len(existing) == 1:
            found = existing
        else:
            found = {
                path: target
                for path, target in existing.items()
                if self._consistent(event, path, target, at)
            }
        if not found:
            found = existing
        by_target = {target: path for path, target in reversed(found.items())}
        return ContactOutcome(tuple(by_target), tuple(by_target.values()))

    def _ways(
        self, event: ContactEvent, reached: frozenset[int], behind: Path, at: Located
    ) -> Iterator[Path]:
        """Paths of stages that no sign contradicts.

        In each next stage the contacts that slip get their kinetic limit, until none is added.
        """
        for regimes in self._solutions(event, reached, at):
            path = (*behind, Stage(reached, regimes))
            slipping = {
                i
                for i in event.resting
                if self.law.contacts[i].friction and regimes[i] not in HOLDING
            }
            if slipping <= reached:
                yield path
            else:
                yield from self._ways(event, reached | slipping, path, at)

    def _solutions(
        self, event: ContactEvent, reached: frozenset[int], at: Located
    ) -> list[Regimes]:
        """Regimes of all contacts that solve one step; several where some are tied."""
        guess = self._guess(event, reached, at)
        tied = self._tied(event, Stage(reached, guess), at)
        if tied == frozenset():
            return [guess]
        options = [
            self.law.contacts[i].regimes if i in event.resting else (regime,)
            for i, regime in enumerate(guess)
        ]
        if tied is not None:
            options = [o if i in tied else (guess[i],) for i, o in enumerate(options)]
        return [
            regimes
            for regimes in product(*options)
            if self._tied(event, Stage(reached, regimes), at) is not None
        ]

    def _tied(self, event: ContactEvent, stage: Stage, at: Located) -> frozenset[int] | None:
        """Contacts of a step whose functions are zero within rounding; None if a sign is wrong.

        It is None too for regimes that do not go together.
        """
        signs = self._signs(event, stage)
        if signs is None:
            return None
        values = signs.rows @ at.state
        errors = at.unit * (signs.bounds @ at.sizes) + abs(signs.rows @ at.moved)
        zero = abs(values) <= errors
        if ((values > 0) != signs.positive)[~zero].any():
            return None
        return frozenset(signs.contacts[zero].tolist())

    def _signs(self, event: ContactEvent, stage: Stage) -> _Signs | None:
        """The requirements of a step in numbers; None for regimes that do not go together."""
        key = event, stage
        if key not in self._known:
            self._known[key] = self._derived(event, stage)
        return self._known[key]

    def _derived(self, event: ContactEvent, stage: Stage) -> _Signs | None:
        if self.law.configuration(stage.regimes, event.others) is None:
            return None
        needed = requirements(self.law, event, stage, self._entry)
        factors = [
            (np.array(list(each.function.values()), dtype=float), list(each.function))
            for each in needed
        ]
        return _Signs(
            np.array([f @ self.rows[places] for f, places in factors]),
            np.array([abs(f) @ abs(self.rows[places]) for f, places in factors]),
            np.array([each.positive for each in needed]),
            np.array([each.contact for each in needed]),
        )

    def _entry(self, row: int) -> float:
        return float(self.rows[row, -1])

    def _consistent(self, event: ContactEvent, path: Path, target: int, at: Located) -> bool:
        """Whether each step's functions have their signs along the flow of the target."""
        for stage in path:
            signs = self._signs(event, stage)
            if signs is None:
                return False
            found = at.signs(signs.rows, signs.bounds, self.fields[target])
            if ((found > 0) != signs.positive).any():
                return False
        return True

    def _guess(self, event: ContactEvent, reached: frozenset[int], at: Located) -> Regimes:
        """Regimes by the forces that minimise the quadratic form in their box.

        The forces are improved one by one, in sweeps.
        """
        law, resting, regimes = self.law, event.resting, list(event.regimes)
        values = (self.rows @ at.state).tolist()
        matrix = [[self._entry(row) for row in each] for each in law.coupling]
        forces = [
            0.0
            if i in resting
            else values[contact.slipping]
            if regime == "slip"
            else values[contact.overshooting]
            if regime == "overshoot"
            else 0.0
            for i, (contact, regime) in enumerate(zip(law.contacts, regimes, strict=True))
        ]
        box = {i: _box(law, i, i in reached, values) for i in resting}
        moves = {i: values[law.free[event.others][i]] + dot(matrix[i], forces) for i in resting}
        for _ in range(_SWEEPS):
            largest = change = 0.0
            for i in resting:
                low, high = box[i]
                force = min(max(forces[i] - moves[i] / matrix[i][i], low), high)
                step = force - forces[i]
                forces[i] = force
                for j in resting:
                    moves[j] += matrix[j][i] * step
                change, largest = max(change, abs(step)), max(largest, abs(force))
            if change <= UNIT * largest:
                break
        for i in resting:
            low, high = box[i]
            if law.contacts[i].friction:
                over = "overshoot" if forces[i] <= low else "stick"
                regimes[i] = "slip" if forces[i] >= high else over
            else:
                regimes[i] = "free" if forces[i] >= high else "contact"
        return tuple(regimes)


def _box(law: Law, index: int, kinetic: bool, values: Sequence[float]) -> tuple[float, float]:
    """Least and largest force of a contact at rest; a stop pushes against its direction."""
    contact = law.contacts[index]
    if not contact.friction:
        return -np.inf, 0.0
    limit = max(values[contact.kinetic if kinetic else contact.static], 0.0)
    return -limit, limit

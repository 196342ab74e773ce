"""The transition that follows what is reached, in any arithmetic.

Of the transitions that are listed for a set of boundaries the first whose conditions hold
follows. Where stops that are reached together may act in several orders, all orders have to
agree. Where nothing that is listed follows, the law of coupled contacts decides. The
arithmetic is a `Judge`: it tells signs, whether resets agree, and what the law says.

By the law, in double precision, what is at its limit within rounding, or slips without
acceleration, may go either way: each way is followed to its end and judged by the first
derivatives that are not zero along the flow of the configuration that it leads to. One way that
is consistent is the outcome.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from itertools import product
from typing import Literal, NamedTuple, Protocol

import numpy as np

from nonsmooth.runtime.events.leading_derivative import UNIT, Located, Row, dot, orders
from nonsmooth.runtime.model.boundary_sets import mask_of
from nonsmooth.runtime.model.contacts.law import HOLDING, ContactEvent, Law, Regimes
from nonsmooth.runtime.model.contacts.stages import Path, Stage, requirements
from nonsmooth.runtime.model.engine_run import Status
from nonsmooth.runtime.model.piecewise import cut_tables
from nonsmooth.runtime.model.structure import Structure, TransitionShape

_SWEEPS = 200  # of the iteration that guesses what holds
_ROUNDINGS = 4  # of a reset, in units of the rounding of a sum


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
        errors = UNIT * (signs.bounds @ at.sizes) + abs(signs.rows @ at.moved)
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


class Choice(NamedTuple):
    """What follows a set of boundaries."""

    # ambiguous is what orders of stops do not agree on, or the law leaves open
    verdict: Literal["chosen", "ambiguous", "undeclared"]
    transition: TransitionShape | None = None  # the one that follows
    options: tuple[int, ...] = ()  # configurations that may follow where that is ambiguous


class Judge(Protocol):
    """An arithmetic, at the state in which boundaries are reached."""

    def sign(self, row: int, along: int) -> int:
        """Sign of the leading derivative of a row along a field, 0 for none.

        `along` is the configuration of the field.
        """

    def agree(self, resets: Sequence[int]) -> bool:
        """Whether these resets lead to the same state."""

    def targets(self, event: ContactEvent) -> tuple[int, ...]:
        """Configurations that may follow by the contact law."""


def _holds(transition: TransitionShape, judge: Judge) -> bool:
    """Whether all conditions of a transition hold."""
    return all(
        (judge.sign(row, along) > 0) == positive for row, along, positive in transition.conditions
    )


def choose(structure: Structure, source: int, boundaries: frozenset[int], judge: Judge) -> Choice:
    """The choice of what follows boundaries that are reached in the configuration `source`."""
    # routes of the law are listed for one orbit: the law itself tells them
    shapes = [t for t in structure.listed(source, boundaries) if t.path is None]
    found = []
    for order in structure.orders(source, boundaries):
        own = [t for t in shapes if t.order in (0, order)]
        found.append(next((t for t in own if _holds(t, judge)), None))
    strikes = [t for t in found if t is not None]
    if not strikes:
        return _by_law(structure, source, boundaries, judge)
    targets = tuple(dict.fromkeys(t.target for t in strikes))
    resets = tuple(dict.fromkeys(t.reset for t in strikes))
    alike = len(strikes) == len(found) and len(targets) == 1
    if alike and (len(resets) == 1 or judge.agree(resets)):
        return Choice("chosen", strikes[0])
    return Choice("ambiguous", None, targets)


def _by_law(structure: Structure, source: int, boundaries: frozenset[int], judge: Judge) -> Choice:
    """The choice by the law of coupled contacts."""
    law = structure.law
    names = [structure.boundaries[source][b].name for b in sorted(boundaries)]
    event = None if law is None else law.event(source, names)
    if law is None or event is None:
        return Choice("undeclared")
    targets = judge.targets(event)
    if len(targets) != 1:
        return Choice("ambiguous", None, targets)
    (target,) = targets
    return Choice("chosen", TransitionShape(boundaries, (), law.reset(event, target), target))


class Decider:
    """The choice of transitions by the tables of a system at one parameter point.

    The tables are arrays: fields (c, N, N + 1), rows (R, N + 1) and resets (r, N, N + 1).
    """

    def __init__(
        self,
        structure: Structure,
        fields: np.ndarray,
        rows: np.ndarray,
        resets: np.ndarray,
    ) -> None:
        self.structure, self.fields, self.rows, self.resets = structure, fields, rows, resets
        self._pairs: dict[tuple[int, int], tuple[list[Row], list[Row]]] = {}

    @cached_property
    def _chooser(self) -> Chooser:
        law = self.structure.law
        assert law is not None
        return Chooser(law, self.fields, self.rows)

    def beginnings(
        self, configuration: int, state: np.ndarray, resting: np.ndarray
    ) -> ContactOutcome:
        """Configurations that a start with contacts at rest may belong to.

        The state (N + 1,), in the system's units, has not passed the boundaries of
        `configuration`. `resting` are flags of the law's contacts.
        """
        event = self._chooser.law.beginning(configuration, np.flatnonzero(resting).tolist())
        known = Located(state, abs(state), np.zeros(len(state)), 0.0)
        return self._chooser.outcome(event, known)

    def outcome(self, event: ContactEvent, at: Located) -> ContactOutcome:
        """What the law says of an event of coupled contacts."""
        return self._chooser.outcome(event, at)

    def located(
        self, source: int, state: np.ndarray, error: float, sizes: np.ndarray | None = None
    ) -> Located:
        """A state (N + 1,) that the configuration `source` led to, and how well it is known.

        The state is in the system's units; `error` is that of the time. `sizes` (N + 1,) are sums
        of absolute values behind the coordinates, by default the absolute values of these.
        """
        moved = np.append(error * (self.fields[source] @ state), 0.0)
        return Located(state, abs(state) if sizes is None else sizes, moved, error)

    def choice(
        self,
        source: int,
        boundaries: frozenset[int],
        at: Located,
        zero: frozenset[int] = frozenset(),
    ) -> Choice:
        """What follows boundaries that are reached in the configuration `source`.

        The rows in `zero` are zero there, whatever rounding makes of them.
        """
        return choose(self.structure, source, boundaries, _AtEvent(self, at, zero))

    def pair(self, row: int, along: int) -> tuple[list[Row], list[Row]]:
        """A row with its derivatives along a configuration's field, and their sizes.

        Both are N + 2 rows of N + 1 numbers; `along` is the configuration.
        """
        if (row, along) not in self._pairs:
            own = self.rows[row]
            self._pairs[row, along] = orders(own, self.fields[along], len(own) + 1)
        return self._pairs[row, along]


class _AtEvent(NamedTuple):
    """A `Judge` that bounds the errors of a located state."""

    decider: Decider
    at: Located
    zero: frozenset[int]

    def sign(self, row: int, along: int) -> int:
        found = self.at.leading(*self.decider.pair(row, along), int(row in self.zero))
        return 0 if found is None else found.sign

    def agree(self, resets: Sequence[int]) -> bool:
        parts = [self.decider.resets[reset] for reset in resets]
        images = np.array([part @ self.at.state for part in parts])
        sizes = np.array([abs(part) @ self.at.sizes for part in parts]).max(axis=0)
        apart = images.max(axis=0) - images.min(axis=0)
        return bool((apart <= _ROUNDINGS * UNIT * sizes).all())

    def targets(self, event: ContactEvent) -> tuple[int, ...]:
        return self.decider.outcome(event, self.at).targets


def batch_decider(
    structure: Structure,
    numbers: np.ndarray,
    options: list[tuple[tuple[int, ...], int]],
    missing: list[tuple[int, int]],
) -> Callable[..., tuple[int, int, int]] | None:
    """The function that the compiled engine calls where it finds no transition.

    It takes a point, configuration, boundaries, state, sizes and error, and gives a status,
    target and reset. None means that there is nothing to decide. Fields, rows and resets come
    first in `numbers` (points, size). Ambiguous events append to `options` their options,
    undeclared ones to `missing` their configuration, each with a mask of the boundaries.
    """
    ordered = any(t.order for found in structure.transitions for t in found)
    if structure.law is None and not ordered and not structure.unvisited:
        return None
    known: dict[int, Decider] = {}

    def decide(
        point: int, source: int, reached: frozenset[int], state: bytes, sizes: bytes, error: float
    ) -> tuple[int, int, int]:
        if point not in known:
            known[point] = Decider(structure, *cut_tables(structure, numbers[point]))
        extended, above = (np.append(np.frombuffer(part), 1.0) for part in (state, sizes))
        at = known[point].located(source, extended, error, above)
        found = known[point].choice(source, reached, at)
        if found.transition is None:
            if found.verdict == "ambiguous":
                options.append((found.options, mask_of(reached)))
                return Status.AMBIGUOUS, -1, -1
            missing.append((source, mask_of(reached)))
            return Status.UNDECLARED, -1, -1
        return -1, found.transition.target, found.transition.reset

    return decide

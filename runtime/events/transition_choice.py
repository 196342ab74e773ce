"""The transition that follows what is reached, in any arithmetic.

Of the transitions that are listed for a set of boundaries the first whose conditions hold
follows. Where stops that are reached together may act in several orders, all orders have to
agree. Where nothing that is listed follows, the law of coupled contacts decides. The
arithmetic is a `Judge`: it tells signs, whether resets agree, and what the law says.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from functools import cached_property
from typing import Any, Literal, NamedTuple, Protocol, TypeVar

import numpy as np

from nonsmooth.runtime.events.contact_choice import Chooser, ContactOutcome
from nonsmooth.runtime.events.leading_derivative import Located, Undecided
from nonsmooth.runtime.events.phase_numbers import Row, orders
from nonsmooth.runtime.events.quasi_polynomials import UNIT
from nonsmooth.runtime.model.boundary_sets import mask_of
from nonsmooth.runtime.model.contacts.law import ContactEvent
from nonsmooth.runtime.model.engine_run import Status
from nonsmooth.runtime.model.piecewise import cut_tables
from nonsmooth.runtime.model.structure import Structure, TransitionShape

__all__ = [
    "Choice",
    "Decider",
    "Judge",
    "batch_decider",
    "choose",
    "first_following",
]

_ROUNDINGS = 4  # of a reset, in units of the rounding of a sum


class Choice(NamedTuple):
    """What follows a set of boundaries."""

    # ambiguous is what orders of stops do not agree on, or the law leaves open; undecided is what
    # the arithmetic cannot tell
    verdict: Literal["chosen", "ambiguous", "undecided", "undeclared"]
    # the one that follows, or of which it is not decided whether it does
    transition: TransitionShape | None = None
    options: tuple[int, ...] = ()  # configurations that may follow where that is ambiguous
    open: str = ""  # why it is undecided


class Judge(Protocol):
    """An arithmetic, at the state in which boundaries are reached.

    Its methods raise `Undecided` where it cannot tell.
    """

    def sign(self, row: int, along: int) -> int:
        """Sign of the leading derivative of a row along a field, 0 for none.

        `along` is the configuration of the field.
        """

    def agree(self, resets: Sequence[int]) -> bool:
        """Whether these resets lead to the same state."""

    def targets(self, event: ContactEvent) -> tuple[int, ...]:
        """Configurations that may follow by the contact law."""


class _Conditional(Protocol):
    @property
    def conditions(self) -> Iterable[Sequence[Any]]:
        """Conditions: the arguments of a sign, and last whether it has to be positive."""


C = TypeVar("C", bound=_Conditional)


def first_following(
    candidates: Iterable[C], sign: Callable[..., int]
) -> tuple[C | None, Undecided | None]:
    """The first candidate whose conditions hold or may hold, and why that is open.

    `sign` takes the entries of a condition but the last, which says whether the sign has to
    be positive; it raises `Undecided` where it cannot tell. The candidate is None where none
    follows; the reason is None where it is certain that the candidate does.
    """
    for candidate in candidates:
        trouble: Undecided | None = None
        for *function, positive in candidate.conditions:
            try:
                if (sign(*function) > 0) != positive:
                    break
            except Undecided as found:
                trouble = trouble or found
        else:
            return candidate, trouble
    return None, None


def choose(structure: Structure, source: int, boundaries: frozenset[int], judge: Judge) -> Choice:
    """The choice of what follows boundaries that are reached in the configuration `source`."""
    # routes of the law are listed for one orbit: the law itself tells them
    shapes = [t for t in structure.listed(source, boundaries) if t.path is None]
    found = []
    for order in structure.orders(source, boundaries):
        own = [t for t in shapes if t.order in (0, order)]
        transition, trouble = first_following(own, judge.sign)
        if trouble is not None:
            return Choice("undecided", transition, (), trouble.reason)
        found.append(transition)
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
    try:
        targets = judge.targets(event)
    except Undecided as trouble:
        return Choice("undecided", None, (), trouble.reason)
    if len(targets) != 1:
        return Choice("ambiguous", None, targets)
    (target,) = targets
    return Choice("chosen", TransitionShape(boundaries, (), law.reset(event, target), target))


class Decider:
    """The choice of transitions by the tables of a system at one parameter point.

    The tables are arrays of floats or mpmath numbers: fields (c, N, N + 1), rows (R, N + 1)
    and resets (r, N, N + 1). The law of coupled contacts needs floats. `unit` is the rounding
    of a sum of products.
    """

    def __init__(
        self,
        structure: Structure,
        fields: np.ndarray,
        rows: np.ndarray,
        resets: np.ndarray,
        unit: Any = UNIT,
    ) -> None:
        self.structure, self.fields, self.rows, self.resets = structure, fields, rows, resets
        self.unit = unit
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
        self, source: int, state: np.ndarray, error: Any, sizes: np.ndarray | None = None
    ) -> Located:
        """A state (N + 1,) that the configuration `source` led to, and how well it is known.

        The state is in the system's units; `error` is that of the time. `sizes` (N + 1,) are sums
        of absolute values behind the coordinates, by default the absolute values of these.
        """
        moved = np.append(error * (self.fields[source] @ state), 0.0)
        return Located(state, abs(state) if sizes is None else sizes, moved, error, self.unit)

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
        return bool((apart <= _ROUNDINGS * self.at.unit * sizes).all())

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

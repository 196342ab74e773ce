"""What follows an event for which no transition is listed: one function for both engines."""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property
from typing import NamedTuple

import numpy as np

from nonsmooth.runtime.model.contacts.choice import Chooser, Located, Outcome, signs_along
from nonsmooth.runtime.model.contacts.law import Event
from nonsmooth.runtime.model.engine_run import Status
from nonsmooth.runtime.model.structure import Structure, TransitionShape

__all__ = ["Decider", "Decision", "batch_decider"]


_ROUNDING = 64 * np.finfo(float).eps


class Decision(NamedTuple):
    """What follows an event: a target and a reset, or options that are left open.

    Attributes
    ----------
    target, reset : int
        -1 where they are open.
    options : tuple of int
        Configurations that may follow an ambiguous event.
    """

    target: int
    reset: int
    options: tuple[int, ...] = ()


class Decider:
    """The laws of a system at one parameter point."""

    def __init__(
        self, structure: Structure, fields: np.ndarray, rows: np.ndarray, resets: np.ndarray
    ) -> None:
        self.structure, self.fields, self.rows, self.resets = structure, fields, rows, resets

    @cached_property
    def _chooser(self) -> Chooser | None:
        law = self.structure.law
        return None if law is None else Chooser(law, self.fields, self.rows)

    def beginnings(self, configuration: int, state: np.ndarray, resting: np.ndarray) -> Outcome:
        """Configurations that a start with contacts at rest may belong to.

        Parameters
        ----------
        configuration : int
            One whose boundaries the state has not passed.
        state : array (N + 1,)
        resting : array of bool
            Contacts of the law at rest.
        """
        assert self._chooser is not None
        event = self._chooser.law.beginning(configuration, np.flatnonzero(resting).tolist())
        known = Located(state, abs(state), np.zeros(len(state)), 0.0)
        return self._chooser.outcome(event, known)

    def outcome(
        self, source: int, event: Event, state: np.ndarray, sizes: np.ndarray, error: float
    ) -> Outcome:
        """What the law says of an event of coupled contacts; see `decision`."""
        assert self._chooser is not None
        moved = np.append(error * (self.fields[source] @ state), 0.0)
        return self._chooser.outcome(event, Located(state, sizes, moved, error))

    def decision(
        self,
        source: int,
        boundaries: frozenset[int],
        state: np.ndarray,
        sizes: np.ndarray,
        error: float,
    ) -> Decision | None:
        """What follows a set of boundaries; None where the system declares nothing.

        Parameters
        ----------
        source : int
        boundaries : frozenset of int
        state, sizes : arrays (N + 1,)
            Extended by 1; the sizes are sums of absolute values behind the coordinates.
        error : float
            Of the time of the event.
        """
        moved = np.append(error * (self.fields[source] @ state), 0.0)
        at = Located(state, sizes, moved, error)
        orders = self.structure.orders(source, boundaries)
        if orders:
            return self._agreed(source, boundaries, orders, at) or self._ruled(
                source, boundaries, at
            )
        return self._ruled(source, boundaries, at)

    def _agreed(
        self, source: int, boundaries: frozenset[int], orders: tuple[int, ...], at: Located
    ) -> Decision | None:
        """What all orders agree on, in which stops act; None where none of them strikes."""
        taken = [self._first(source, boundaries, order, at) for order in orders]
        strikes = [t for t in taken if t is not None]
        if not strikes:
            return None
        images = np.array([self.resets[t.reset] @ at.state for t in strikes])
        sizes = np.array([abs(self.resets[t.reset]) @ at.sizes for t in strikes])
        alike = (np.ptp(images, axis=0) <= _ROUNDING * sizes.max(axis=0)).all()
        targets = tuple(dict.fromkeys(t.target for t in strikes))
        if len(strikes) == len(taken) and len(targets) == 1 and alike:
            return Decision(targets[0], strikes[0].reset)
        return Decision(-1, -1, targets)

    def _first(
        self, source: int, boundaries: frozenset[int], order: int, at: Located
    ) -> TransitionShape | None:
        """The first transition of an order whose conditions hold."""
        for transition in self.structure.transitions[source]:
            mine = transition.boundaries == boundaries and transition.order in (0, order)
            if mine and all(
                (self._sign(row, along, at) > 0) == holds
                for row, along, holds in transition.conditions
            ):
                return transition
        return None

    def _sign(self, row: int, along: int, at: Located) -> int:
        rows = self.rows[row : row + 1]
        return int(signs_along(rows, abs(rows), self.fields[along], at)[0])

    def _ruled(self, source: int, boundaries: frozenset[int], at: Located) -> Decision | None:
        """What the law of coupled contacts says."""
        shapes = self.structure.boundaries[source]
        names = [shapes[b].name for b in boundaries]
        event = None if self._chooser is None else self._chooser.law.event(source, names)
        if self._chooser is None or event is None:
            return None
        found = self._chooser.outcome(event, at)
        if len(found.targets) != 1:
            return Decision(-1, -1, found.targets)
        (target,) = found.targets
        return Decision(target, self._chooser.law.reset(event, target))


def batch_decider(
    structure: Structure, numbers: np.ndarray, options: list[tuple[tuple[int, ...], int]]
) -> Callable[..., tuple[int, int, int]] | None:
    """What the compiled engine calls where it finds no transition; None without laws.

    Parameters
    ----------
    structure : Structure
    numbers : array (points, size)
        Fields, rows and resets come first.
    options : list
        Gets the options of events that are ambiguous, and a mask of their boundaries.
    """
    if structure.law is None and not any(t.order for found in structure.transitions for t in found):
        return None
    size, count = len(structure.states), len(structure.configurations)
    cut = count * size * (size + 1)
    known: dict[int, Decider] = {}

    def decide(
        point: int, source: int, reached: int, state: bytes, sizes: bytes, error: float
    ) -> tuple[int, int, int]:
        if point not in known:
            flat = numbers[point]
            fields = flat[:cut].reshape(count, size, size + 1)
            ends = np.cumsum(
                [cut, structure.rows * (size + 1), structure.resets * size * (size + 1)]
            )
            rows = flat[ends[0] : ends[1]].reshape(-1, size + 1)
            resets = flat[ends[1] : ends[2]].reshape(-1, size, size + 1)
            known[point] = Decider(structure, fields, rows, resets)
        boundaries = frozenset(b for b in range(reached.bit_length()) if reached >> b & 1)
        extended, above = (np.append(np.frombuffer(part), 1.0) for part in (state, sizes))
        found = known[point].decision(source, boundaries, extended, above, error)
        if found is None:
            return Status.UNDECLARED, -1, -1
        if found.target < 0:
            options.append((found.options, reached))
            return Status.AMBIGUOUS, -1, -1
        return -1, found.target, found.reset

    return decide

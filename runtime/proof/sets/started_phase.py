"""The phase that begins with parts of one kind: what may end it, at once or later."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations
from typing import Any

import numpy as np

from nonsmooth.runtime.core.float_flows import FloatFlow
from nonsmooth.runtime.core.float_sets import Rounded
from nonsmooth.runtime.proof.motion.enclosures import EnclosedSystem
from nonsmooth.runtime.proof.motion.exact_rows import Invariants, Row, product
from nonsmooth.runtime.proof.sets.phase_ends import CLOCK, EndedSets, PhaseEnds, WatchedFunction
from nonsmooth.runtime.proof.sets.sections import MapSection
from nonsmooth.runtime.proof.sets.set_parts import (
    PartsLeft,
    SetParts,
    StartKind,
    clock_row,
    first_moving,
    negative,
    timed_row,
)

__all__ = ["StartedPhase"]


class StartedPhase:
    """The phase that begins with states of one kind, in the configuration of the flow.

    `finest` is as for `PhaseEnds`.
    """

    def __init__(
        self,
        system: EnclosedSystem,
        section: MapSection,
        flow: FloatFlow,
        finest: float,
        kind: StartKind,
    ) -> None:
        self.kind = kind
        here = kind.configuration
        exact, structure = system.exact, system.structure
        lasting = kind.facts.lasting(exact.fields[here])
        self.stuck = False  # beyond a boundary all along
        self.functions: list[WatchedFunction] = []
        self.under: list[bool] = []
        self.still: list[bool] = []
        self.starts: list[Row] = []
        together: dict[Any, tuple[list[int], Row]] = {}
        for b, boundary in enumerate(structure.boundaries[here]):
            row = exact.rows[boundary.row]
            reduced = lasting.reduce(row)
            if not any(reduced[:-1]):
                self.stuck = self.stuck or reduced[-1] > 0
                continue
            size = next(abs(x) for x in reduced if x)
            together.setdefault(tuple(x / size for x in reduced), ([], row))[0].append(b)
        for own, row in together.values():
            leading, order = first_moving(row, exact.fields[here], kind.facts)
            if order < 0:
                continue
            self.under.append(any(b in kind.under for b in own))
            self.still.append(not any(lasting.reduce(product(row, exact.fields[here]))))
            facts = Invariants.of([*lasting.rows, row])
            rate = facts.reduce(product(row, exact.fields[here]))
            self.functions.append(
                WatchedFunction(tuple(own), timed_row(row), timed_row(leading), order, facts, rate)
            )
            self.starts.append(leading)
        if section.phase is not None:
            c, s = structure.forcing[0]
            pivots = section.facts.pivots
            forced = [section.facts.rows[pivots.index(k)] for k in (c, s)]
            clock = clock_row(section.period(system) * (kind.clock + 1), len(structure.states))
            facts = Invariants.of([*lasting.rows, *forced])
            self.functions.append(WatchedFunction((CLOCK,), clock, clock, 0, facts, ()))
            # states that reach a boundary just then are both on the section and beyond it
            self.under.append(True)
            self.still.append(False)
        self.begins = [Rounded.of(f.leading) for f in self.functions]
        # a function that does not change ends no phase that it does not end at once
        moving = [f for f, still in zip(self.functions, self.still, strict=True) if not still]
        self.phase = PhaseEnds(flow, moving, finest)

    def ends(self, parts: SetParts, work: PartsLeft) -> Iterator[EndedSets]:
        """Yield the ways in which the phase may end, with origins that are numbers of the parts.

        Sets of which not all ends are known are marked as lost in `work`.
        """
        if self.stuck:
            work.lose(parts.origin)
            return
        states, origin = parts.states, np.arange(len(parts.origin))
        values = [tuple(x[:, 0] for x in states.ranges(row)) for row in self.begins]
        passed = [
            k
            for k, ((_, high), under) in enumerate(zip(values, self.under, strict=True))
            if not under and not (high < 0).all()
        ]
        if passed:
            yield from self._passed_at_start(parts, values, passed, work)
        for k, row in enumerate(self.begins):
            states, alive = states.cut(negative(row))
            sure = values[k][0][origin] > 0
            states, origin = states[alive & ~sure], origin[alive & ~sure]
        if not len(origin):
            return
        found, lost = self.phase.ends(states)
        work.lose(parts.origin[origin[lost]])
        for end in found:
            yield end._replace(origin=origin[end.origin])

    def _passed_at_start(
        self, parts: SetParts, values: Sequence[Any], passed: Sequence[int], work: PartsLeft
    ) -> Iterator[EndedSets]:
        """Yield the states that are beyond boundaries at the start, and leave the phase at once."""
        touched = [
            k
            for k, (_, high) in enumerate(values)
            if k not in passed and not (high < 0).all() and self.functions[k].boundaries != (CLOCK,)
        ]
        every = [*passed, *touched]
        for count in range(1, len(every) + 1):
            for chosen in combinations(every, count):
                if chosen[0] not in passed:
                    continue
                states, origin = parts.states, np.arange(len(parts.origin))
                for k in every:
                    row = self.begins[k] if k in chosen else negative(self.begins[k])
                    states, alive = states.cut(row)
                    if k not in chosen:
                        alive &= ~(values[k][0][origin] > 0)
                    else:
                        alive &= ~(values[k][1][origin] < 0)
                    states, origin = states[alive], origin[alive]
                if not len(origin):
                    continue
                if count > 2:
                    work.lose(parts.origin[origin])
                    continue
                boundaries = tuple(b for k in chosen for b in self.functions[k].boundaries)
                rising = tuple(self.starts[k] for k in chosen)
                yield EndedSets(states, origin, boundaries, self.kind.facts, rising)

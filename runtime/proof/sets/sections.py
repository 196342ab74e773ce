"""Sections of motions: where states are taken, and what is exactly true there.

With a forcing states are taken once in each period, at one phase of the forcing, in one
configuration. Else they are taken behind a transition: what its source holds and the boundary
that is reached are facts, carried by the reset. The coordinates that facts leave free are those
of the section: a mass that sticks takes away one.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from math import gcd
from typing import Any

from flint import arb, fmpq
from numpy.typing import NDArray

from nonsmooth.runtime.checker.state_sets.switching import echelon_behind
from nonsmooth.runtime.checker.stated.exact import Elimination
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.model.boundary_sets import members_of
from nonsmooth.runtime.model.structure import TransitionShape
from nonsmooth.runtime.proof.exact_tables import ExactSystem, Row

__all__ = [
    "MapSection",
    "Way",
    "angle_of",
    "forcing_section",
    "listed_transition",
    "phases",
    "sections_behind",
    "transition_section",
    "ways_of",
]

Way = tuple[int, frozenset[int], int]  # configuration, boundaries, configuration


@dataclass(frozen=True)
class MapSection:
    """A section: the configuration of its states, and what is exactly true of them."""

    configuration: int
    facts: tuple[Row, ...]  # reduced rows that are zero
    # cosine and sine of the forcing; None for a section behind a transition
    phase: tuple[Any, Any] | None
    source: int = -1  # configuration that the transition leaves; -1 for a forcing
    # those that the transition follows; empty for a forcing
    boundaries: frozenset[int] = frozenset()

    @cached_property
    def free(self) -> tuple[int, ...]:
        """The states that are the section's coordinates."""
        size = len(self.facts[0]) - 1
        return tuple(k for k in range(size) if k not in self._given)

    @cached_property
    def _given(self) -> dict[int, Row]:
        """The fact that gives each other state."""
        return {next(k for k, x in enumerate(row) if x): row for row in self.facts}

    @cached_property
    def lift(self) -> tuple[Row, ...]:
        """Rows (N, d + 1) that give each state as an affine function of the d coordinates."""
        size, given = len(self.facts[0]) - 1, self._given
        return tuple(
            tuple(-given[k][j] for j in (*self.free, size))
            if k in given
            else (*(fmpq(int(j == k)) for j in self.free), fmpq(0))
            for k in range(size)
        )

    def period(self, system: ExactSystem) -> arb:
        """Return the period of the forcing, at the working precision."""
        return 2 * arb.pi() / abs(arb(_speed(system)))


def forcing_section(system: ExactSystem, configuration: int, phase: Sequence[Any]) -> MapSection:
    """Return the section at one phase of the forcing, in one configuration.

    The phase is cosine and sine, a rational point of the unit circle. Any other point, and a system
    without exactly one forcing, is refused.
    """
    cosine, sine = phase
    if cosine**2 + sine**2 != 1:
        raise InputError("the phase is no point of the unit circle")
    _speed(system)
    (c, s), size = system.structure.forcing[0], len(system.structure.states)
    rows = [
        tuple(-x if j == size else fmpq(int(j == k)) for j in range(size + 1))
        for k, x in ((c, cosine), (s, sine))
    ]
    held = [system.exact.rows[row] for row in system.structure.constraints[configuration]]
    facts = Elimination().echelon([*rows, *held])
    return MapSection(configuration, tuple(facts), (cosine, sine))


def transition_section(
    system: ExactSystem, source: int, boundaries: frozenset[int], target: int
) -> MapSection:
    """Return the section behind a transition by `boundaries` from a configuration to another.

    A transition that is not listed, and a system with a forcing, are refused.
    """
    exact, transition = system.exact, listed_transition(system, (source, boundaries, target))
    structure = system.structure
    if structure.forcing:
        raise InputError("with a forcing states are taken at one of its phases")
    held = [exact.rows[row] for row in structure.constraints[source]]
    reached = [exact.rows[structure.boundaries[source][b].row] for b in sorted(boundaries)]
    exactly = Elimination()
    before = exactly.echelon([*held, *reached])
    if transition is None:
        name = structure.configurations
        raise InputError(f"no listed transition leads from {name[source]} to {name[target]}")
    facts = echelon_behind(exactly, before, exact.resets[transition.reset])
    return MapSection(target, tuple(facts), None, source, boundaries)


def listed_transition(system: ExactSystem, way: Way) -> TransitionShape | None:
    """Return the transition that is listed for a way, or None if a contact law decides."""
    source, boundaries, target = way
    listed = system.structure.listed(source, boundaries)
    return next((t for t in listed if t.target == target), None)


def sections_behind(system: ExactSystem, ways: Sequence[Way]) -> dict[Way, MapSection]:
    """Return the sections behind transitions (source, boundaries, target) that have coordinates.

    Transitions that a contact law decides are left out: the checker knows listed ones alone.
    """
    listed = [way for way in dict.fromkeys(ways) if listed_transition(system, way)]
    found = {way: transition_section(system, *way) for way in listed}
    return {way: section for way, section in found.items() if section.free}


def ways_of(configurations: NDArray[Any], masks: NDArray[Any]) -> list[Way]:
    """Return the transitions of a motion: source, boundaries and target of each.

    `configurations` has that of the start, and the one behind each transition, and `masks` what
    they follow.
    """
    behind = zip(configurations, masks[1:], configurations[1:], strict=False)
    return [(int(a), frozenset(members_of(int(mask))), int(b)) for a, mask, b in behind]


def angle_of(phase: Sequence[Any]) -> float:
    """Return the angle of a phase, about."""
    cosine, sine = (float(x.p) / float(x.q) for x in phase)
    return math.atan2(sine, cosine)


def phases(count: int) -> list[tuple[Any, Any]]:
    """Return rational points of the unit circle, cosines and sines, about evenly spread.

    Their number is a multiple of 4.
    """
    part = count // 4
    quarter = []
    for k in range(part):
        # m/n is near the tangent of half the angle, which the quarter shares out
        m, n = round(16 * k / (2 * part - k * k / part)), 16
        shared = gcd(m, n)
        m, n = m // shared, n // shared
        below = m * m + n * n
        quarter.append((fmpq(n * n - m * m, below), fmpq(2 * m * n, below)))
    found = list(quarter)
    for _ in range(3):
        quarter = [(-s, c) for c, s in quarter]
        found += quarter
    return found


def _speed(system: ExactSystem) -> Any:
    """Return the angular frequency of the one forcing, which is the same in every configuration."""
    forcing = system.structure.forcing
    if len(forcing) != 1:
        raise InputError(f"{system.structure.name} has {len(forcing)} forcings, not one")
    c, s = forcing[0]
    return system.exact.fields[0][s][c]

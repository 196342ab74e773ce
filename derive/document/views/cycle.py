"""An itinerary as its document sees it: the section at its start, and transitions once each."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from itertools import combinations

import sympy as sp

from nonsmooth.derive.declaration.configuration import Boundary
from nonsmooth.derive.declaration.itinerary import Itinerary
from nonsmooth.derive.declaration.symmetry import translations
from nonsmooth.derive.declaration.system import System
from nonsmooth.derive.declaration.transition import Transition
from nonsmooth.derive.document.notation.symbols import Letters
from nonsmooth.derive.document.notation.wording import Naming
from nonsmooth.derive.document.views.monodromy import where_zero
from nonsmooth.derive.equations.linearisation import saltation_matrix
from nonsmooth.derive.equations.section import Section, reset_matrix, start_of

__all__ = ["Cycle", "Harmonic", "Passing", "harmonics_of"]


@dataclass(frozen=True)
class Passing:
    """One transition of a cycle, with the data of its derivatives.

    The boundary's function is ``normal y + constant``; the state behind the transition is
    ``reset y + jump``.
    """

    transition: Transition
    boundary: Boundary  # the one by which the phases in front of the transition are left
    phases: tuple[int, ...]  # numbers of those phases, from 1
    normal: sp.Matrix  # 1 x N
    constant: sp.Expr
    reset: sp.Matrix  # N x N
    jump: sp.Matrix  # N x 1
    before: sp.Matrix  # N x 1: vector field in front of the transition
    behind: sp.Matrix  # N x 1: vector field behind it, in terms of the state in front

    @property
    def rate(self) -> sp.Expr:
        """Rate at which the boundary's function rises through zero."""
        return sp.expand((self.normal * self.before)[0])

    @property
    def resets(self) -> bool:
        """Whether the state jumps."""
        unit = self.reset == sp.eye(self.reset.rows)
        return not (unit and self.jump.is_zero_matrix)

    def saltation(self, states: tuple[sp.Symbol, ...]) -> sp.Matrix:
        """Saltation matrix (N x N) at a state on the boundary."""
        matrix = saltation_matrix(self.reset, self.normal, self.before, self.behind)
        condition = (self.normal * sp.Matrix(states))[0] + self.constant
        return where_zero(condition, states, matrix)


@dataclass(frozen=True)
class Harmonic:
    """Two states that oscillate by themselves: first' = -a second, second' = b first."""

    first: sp.Symbol
    second: sp.Symbol
    frequency: sp.Expr
    invariant: sp.Expr  # quadratic function of both that is constant in time


@dataclass(frozen=True)
class Cycle:
    """An itinerary with the notation and the letters in which it is written."""

    itinerary: Itinerary
    naming: Naming
    letters: Letters
    numbers: Mapping[str, int]  # by configuration: number of its flow
    places: Mapping[str, int]  # by title: number of a section

    @property
    def system(self) -> System:
        """The system in the presentation of the itinerary."""
        return self.naming.system

    def label(self, title: str, index: int = 0) -> str:
        """Number of an equation: that of its section, and its place in it."""
        return f"{self.places[title]}.{index + 1}"

    @property
    def count(self) -> int:
        """Number of phases."""
        return len(self.itinerary.phases)

    @cached_property
    def start(self) -> Section:
        """The set on which the start lies."""
        return start_of(self.itinerary)

    @cached_property
    def passings(self) -> tuple[Passing, ...]:
        """Each transition once, in the order in which they first occur."""
        places: dict[tuple[str, str, str], list[int]] = {}
        for index, phase in enumerate(self.itinerary.phases):
            following = self.itinerary.phases[(index + 1) % self.count].configuration
            key = phase.configuration, phase.boundary, following
            places.setdefault(key, []).append(index + 1)
        return tuple(self._passing(tuple(found)) for found in places.values())

    @property
    def distinct(self) -> bool:
        """Whether every phase has a transition of its own."""
        return len(self.passings) == self.count

    @property
    def phase(self) -> str:
        """Index of a phase in formulas: k, or 1 if there is only one phase."""
        return "k" if self.count > 1 else "1"

    @property
    def index(self) -> str:
        """Index of a transition's letters in the formulas of a phase."""
        return self.phase if self.distinct else "j(k)"

    @property
    def product(self) -> str:
        """LaTeX of the sign of a product over the phases, the first on the right."""
        return rf"\prod_{{k={self.count}}}^{{1}} " if self.count > 1 else ""

    def number(self, phase: int) -> int:
        """Number of the transition that ends a phase; both count from one."""
        return next(i for i, p in enumerate(self.passings, start=1) if phase in p.phases)

    @cached_property
    def resets(self) -> bool:
        """Whether some transition makes the state jump."""
        return any(p.resets for p in self.passings)

    @cached_property
    def harmonics(self) -> tuple[Harmonic, ...]:
        """Pairs of states that oscillate without any other influence."""
        return harmonics_of(self.itinerary, self.system)

    @cached_property
    def directions(self) -> sp.Matrix:
        """Directions of the state along which nothing changes, as columns (N x k)."""
        return translations(self.system)

    def _passing(self, phases: tuple[int, ...]) -> Passing:
        system, states = self.system, self.system.states
        phase = self.itinerary.phases[phases[0] - 1]
        transition = self.itinerary.transition_after(system, phases[0] - 1)
        source = system.configuration(phase.configuration)
        boundary = source.boundary(phase.boundary)
        normal, constant = system.gradient(boundary.function)
        reset, jump = reset_matrix(transition.reset.items(), states)
        state = sp.Matrix(states)
        target = system.configuration(transition.target)
        before = _velocity(source.dynamics.field(states), state)
        behind = _velocity(target.dynamics.field(states), reset * state + jump)
        return Passing(transition, boundary, phases, normal, constant, reset, jump, before, behind)


def harmonics_of(itinerary: Itinerary, system: System) -> tuple[Harmonic, ...]:
    """Pairs of states that oscillate by themselves all along an itinerary.

    In every one of its configurations the two have the same equations, in which no other
    state occurs, and no transition resets them.
    """
    states = system.states
    names = dict.fromkeys(p.configuration for p in itinerary.phases)
    fields = [system.configuration(name).dynamics.field(states) for name in names]
    indices = range(len(itinerary.phases))
    moved = {s for i in indices for s in itinerary.transition_after(system, i).reset}
    matrix = fields[0][0]
    found = []
    for i, j in combinations(range(len(states)), 2):
        square = sp.cancel(-matrix[i, j] * matrix[j, i])
        alone = all(
            a[k, m] == (matrix[k, m] if {k, m} == {i, j} else 0) and b[k] == 0
            for a, b in fields
            for k in (i, j)
            for m in range(len(states))
        )
        if alone and square.is_positive and not {states[i], states[j]} & moved:
            ratio = sp.cancel(-matrix[i, j] / matrix[j, i])
            invariant = states[i] ** 2 + ratio * states[j] ** 2
            found.append(Harmonic(states[i], states[j], sp.sqrt(square), invariant))
    return tuple(found)


def _velocity(field: tuple[sp.Matrix, sp.Matrix], state: sp.Matrix) -> sp.Matrix:
    matrix, offset = field
    return sp.ImmutableMatrix((matrix * state + offset).applyfunc(sp.expand))

"""An itinerary as its document sees it: the section at its start, and transitions once each."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from itertools import combinations

import sympy as sp

from nonsmooth.derive.declaration.configuration import Boundary
from nonsmooth.derive.declaration.symmetry import translations
from nonsmooth.derive.declaration.system import System
from nonsmooth.derive.declaration.transition import Transition
from nonsmooth.derive.document.notation.symbols import Letters
from nonsmooth.derive.document.views.monodromy import where_zero
from nonsmooth.derive.document.views.view import Described
from nonsmooth.derive.equations.linearisation import saltation_matrix
from nonsmooth.derive.equations.section import Section, reset_matrix, start_of

__all__ = ["Cycle", "Harmonic", "Passing"]


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
class Cycle(Described):
    """An itinerary with the letters in which it is written."""

    letters: Letters

    @property
    def system(self) -> System:
        """The system in the presentation of the itinerary."""
        return self.naming.system

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
    def index(self) -> str:
        """Index of a transition's letters in the formulas of a phase."""
        return self.phase if self.distinct else "j(k)"

    def number(self, phase: int) -> int:
        """Number of the transition that ends a phase; both count from one."""
        return next(i for i, p in enumerate(self.passings, start=1) if phase in p.phases)

    @cached_property
    def resets(self) -> bool:
        """Whether some transition makes the state jump."""
        return any(p.resets for p in self.passings)

    @cached_property
    def harmonics(self) -> tuple[Harmonic, ...]:
        """Pairs of states that oscillate by themselves all along the itinerary.

        In every one of its configurations the two have the same equations, in which no other
        state occurs, and no transition resets them.
        """
        states = self.system.states
        names = dict.fromkeys(p.configuration for p in self.itinerary.phases)
        fields = [self.system.configuration(name).dynamics.field(states) for name in names]
        indices = range(self.count)
        moved = {s for i in indices for s in self.itinerary.transition_after(self.system, i).reset}
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


def _velocity(field: tuple[sp.Matrix, sp.Matrix], state: sp.Matrix) -> sp.Matrix:
    matrix, offset = field
    return sp.ImmutableMatrix((matrix * state + offset).applyfunc(sp.expand))

"""An itinerary as its document sees it: the section at its start, and transitions once each."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from itertools import combinations

import sympy as sp

from nonsmooth.derive.declaration.symmetry import translations
from nonsmooth.derive.declaration.system import System
from nonsmooth.derive.document.symbols import Letters
from nonsmooth.derive.document.view import Described, where_zero
from nonsmooth.derive.equations.linearisation import saltation_matrix
from nonsmooth.derive.equations.section import Passage, Section, passages_of, start_of


@dataclass(frozen=True)
class Passing(Passage):
    """One transition of a cycle, with the phases that it ends."""

    phases: tuple[int, ...]  # numbers from 1
    following: sp.Matrix  # vector field behind the transition as a matrix, (N + 1) x (N + 1)

    @property
    def before(self) -> sp.Matrix:
        """Vector field (N x 1) in front of the transition."""
        return self._velocity(self.field)

    @property
    def behind(self) -> sp.Matrix:
        """Vector field (N x 1) behind the transition, in terms of the state in front."""
        return self._velocity(self.following * self.landing)

    @property
    def rate(self) -> sp.Expr:
        """Rate at which the boundary's function rises through zero."""
        return sp.expand((self.normal * self.before)[0])

    @property
    def resets(self) -> bool:
        """Whether the state jumps."""
        return bool(self.landing != sp.eye(self.landing.rows))

    @property
    def saltation(self) -> sp.Matrix:
        """Saltation matrix (N x N) at a state on the boundary."""
        matrix = saltation_matrix(self.reset, self.normal, self.before, self.behind)
        return where_zero(self.value(sp.Matrix(self.states)), self.states, matrix)

    def _velocity(self, field: sp.Matrix) -> sp.Matrix:
        return (field * sp.Matrix([*self.states, 1]))[:-1, :].expand()


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
        found: dict[tuple[str, str, str], Passing] = {}
        passages = passages_of(self.itinerary)
        for index, passage in enumerate(passages, start=1):
            following = passages[index % self.count]
            key = passage.configuration.name, passage.boundary, following.configuration.name
            phases = (*(found[key].phases if key in found else ()), index)
            found[key] = Passing(**vars(passage), phases=phases, following=following.field)
        return tuple(found.values())

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
        fields = [passing.configuration.dynamics.field(states) for passing in self.passings]
        moved = {s for passing in self.passings for s in passing.transition.reset}
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

"""Passages and sections: how an itinerary leaves its phases, and where an orbit can start.

Affine functions and maps are matrices in homogeneous coordinates (y, 1): a function n y + c is the
row [n, c], a map y -> M y + m is [[M, m], [0, 1]], a field y' = A y + b is [[A, b], [0, 0]]. A row
times a map is the function in front of the map; a row times a field is its rate along the flow.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

import sympy as sp

from nonsmooth.derive.declaration.algebra import bordered, cancel, factor, remembered
from nonsmooth.derive.declaration.configuration import Configuration
from nonsmooth.derive.declaration.itinerary import Itinerary, dwell_symbol
from nonsmooth.derive.declaration.system import System
from nonsmooth.derive.declaration.transition import Transition
from nonsmooth.derive.errors import DerivationError
from nonsmooth.derive.symbols import Values


@dataclass(frozen=True)
class Passage:
    """One phase of an itinerary, the boundary that ends it and the transition behind it."""

    configuration: Configuration
    boundary: str
    transition: Transition
    states: tuple[sp.Symbol, ...]
    dwell: sp.Symbol  # symbol of the dwell time
    # the dwell time in unknowns and parameters: itself, zero, or the rest of a given period
    duration: sp.Expr
    row: sp.Matrix  # 1 x (N + 1): the boundary's function
    landing: sp.Matrix  # (N + 1) x (N + 1): the transition's reset

    @property
    def meaning(self) -> str:
        """The exit condition in words."""
        return f"{self.boundary} ends {self.configuration.name}"

    @property
    def normal(self) -> sp.Matrix:
        """Gradient (1 x N) of the boundary's function."""
        return self.row[:, :-1]

    @property
    def constant(self) -> sp.Expr:
        """Constant of the boundary's function."""
        return self.row[-1]

    @property
    def reset(self) -> sp.Matrix:
        """Linear part (N x N) of the transition's reset."""
        return self.landing[:-1, :-1]

    @property
    def jump(self) -> sp.Matrix:
        """Constant part (N x 1) of the transition's reset."""
        return self.landing[:-1, -1]

    @property
    def field(self) -> sp.Matrix:
        """Vector field of the phase as a matrix, (N + 1) x (N + 1)."""
        return bordered(*self.configuration.dynamics.field(self.states), 0)

    def value(self, state: sp.Matrix) -> sp.Expr:
        """Value of the boundary's function at a state (N x 1)."""
        return (self.normal * state)[0] + self.constant

    def behind(self, state: sp.Matrix) -> sp.Matrix:
        """State (N x 1) behind the transition."""
        return self.transition.reset_of(state, self.states)


@remembered
def passages_of(itinerary: Itinerary) -> tuple[Passage, ...]:
    """The passages of an itinerary in the coordinates of its presentation, in order."""
    system, found = itinerary.presented_system, []
    for index, phase in enumerate(itinerary.phases):
        configuration = system.configuration(phase.configuration)
        transition = itinerary.transition_after(system, index)
        found.append(
            Passage(
                configuration,
                phase.boundary,
                transition,
                system.states,
                dwell_symbol(phase.dwell_time),
                itinerary.duration(index),
                row_of(configuration.boundary(phase.boundary).function, system),
                map_of(transition.reset, system),
            )
        )
    return tuple(found)


def row_of(function: sp.Expr, system: System) -> sp.Matrix:
    """An affine function n y + c of a system's state as the row [n, c]."""
    normal, constant = system.gradient(function)
    return sp.Matrix([[*normal, constant]])


def map_of(rules: Values, system: System) -> sp.Matrix:
    """Matrix of an affine map of a system's state; a state without a rule stays."""
    states, matrix = system.states, sp.eye(len(system.states) + 1)
    for place, state in enumerate(states):
        if state in rules:  # sums are kept in the form in which they are declared
            shift = rules[state].subs(dict.fromkeys(states, 0))
            matrix[place, :] = sp.Matrix([[*(sp.diff(rules[state], s) for s in states), shift]])
    return matrix


def simplified(matrix: sp.Matrix) -> sp.Matrix:
    """The matrix with its entries in a form that is zero if they are."""
    return matrix.applyfunc(lambda entry: cancel(sp.expand(entry)))


def is_zero(matrix: sp.Matrix) -> bool:
    """Whether a matrix is zero."""
    return bool(simplified(matrix).is_zero_matrix)


def multiple_of(one: sp.Matrix, other: sp.Matrix) -> sp.Expr | None:
    """Factor by which a matrix is a multiple of another one; None if it is none."""
    ratio = next((cancel(a / b) for a, b in zip(one, other, strict=True) if b != 0), None)
    return ratio if ratio is not None and is_zero(one - ratio * other) else None


@dataclass(frozen=True)
class Section:
    """The affine set on which an orbit starts, in coordinates of its own.

    The start is ``embedding q + constant`` with the coordinates q.
    """

    coordinates: tuple[sp.Symbol, ...]  # values of some of the states at the start
    places: tuple[int, ...]  # indices of these states
    embedding: sp.Matrix  # N x d
    constant: sp.Matrix  # N x 1

    @property
    def dimension(self) -> int:
        """Number of coordinates."""
        return len(self.coordinates)

    @property
    def state(self) -> sp.Matrix:
        """State (N x 1) at the start in terms of the coordinates."""
        return self.embedding * sp.Matrix(self.dimension, 1, self.coordinates) + self.constant

    @property
    def inclusion(self) -> sp.Matrix:
        """The map from the coordinates to the state as a matrix, (N + 1) x (d + 1)."""
        return bordered(self.embedding, self.constant)

    def without(self, coordinates: Iterable[sp.Symbol]) -> Section:
        """The subset on which some coordinates are zero."""
        dropped = set(coordinates)
        kept = [i for i, q in enumerate(self.coordinates) if q not in dropped]
        return Section(
            tuple(self.coordinates[i] for i in kept),
            tuple(self.places[i] for i in kept),
            self.embedding.extract(list(range(self.embedding.rows)), kept),
            self.constant,
        )


def enforced_at(passage: Passage, system: System) -> sp.Matrix:
    """Rows of the functions that are zero where a phase ends, its boundary's first."""
    configuration, states = passage.configuration, system.states
    functions = configuration.vanishing(states)
    held = len(functions) - len(configuration.constraints)
    ordered = (*functions[held:], *functions[:held])  # constraints before velocities
    return sp.Matrix.vstack(passage.row, *(row_of(f, system) for f in ordered))


@remembered
def section_of(itinerary: Itinerary, phase: int = 0) -> Section:
    """The section at the start of a phase, counted from 0.

    It collects what the end of the phase before enforces: the velocities held through that
    phase, its constraints and its exit boundary, carried through the reset, and what the
    reset assigns. Closing the section's own coordinates then closes the orbit, with no
    equation twice. States without a name of their own in the itinerary are eliminated
    first.
    """
    system, last = itinerary.presented_system, passages_of(itinerary)[phase - 1]
    size, enforced = len(system.states), enforced_at(last, system)
    # elimination takes the first columns: the state in front, then states without a name
    named = set() if phase else set(itinerary.start)
    order = sorted(range(size), key=lambda i: (str(system.states[i]) in named, i))
    before = sp.Matrix.vstack(enforced[:, :-1], last.reset)
    behind = sp.Matrix.vstack(sp.zeros(enforced.rows, size), -sp.eye(size)[:, order])
    right = -sp.Matrix.vstack(enforced[:, -1], last.jump)
    augmented = sp.Matrix.hstack(before, behind, right).applyfunc(cancel)
    reduced, pivots = augmented.rref(simplify=cancel)
    if 2 * size in pivots:
        raise DerivationError(f"itinerary {itinerary.name!r}: its start satisfies no state")
    matrix, constant = sp.zeros(size, size), sp.zeros(size, 1)
    solved = {order[pivot - size]: row for row, pivot in enumerate(pivots) if pivot >= size}
    free = [place for place in range(size) if place not in solved]
    for state, row in solved.items():
        constant[state] = factor(reduced[row, 2 * size])
        for place in free:
            matrix[state, place] = -factor(reduced[row, size + order.index(place)])
    return _spanned(itinerary, phase, free, matrix, constant)


def smallest_section(itinerary: Itinerary) -> tuple[int, Section]:
    """Index of the first phase whose section has the least dimension, and that section."""
    sections = [section_of(itinerary, k) for k in range(len(itinerary.phases))]
    rotation = min(range(len(sections)), key=lambda k: (sections[k].dimension, k))
    return rotation, sections[rotation]


def start_of(itinerary: Itinerary) -> Section:
    """The set on which the start is sought.

    It is the section, or a larger set if the itinerary names more states.
    """
    section, states = section_of(itinerary), itinerary.presented_system.states
    named = {i for i, s in enumerate(states) if str(s) in itinerary.start}
    matrix = sp.zeros(len(states), len(states))
    for column, place in enumerate(section.places):
        matrix[:, place] = section.embedding[:, column]
    places = sorted(named | set(section.places))
    return _spanned(itinerary, 0, places, matrix, sp.Matrix(section.constant))


def _spanned(
    itinerary: Itinerary, phase: int, places: list[int], matrix: sp.Matrix, constant: sp.Matrix
) -> Section:
    """The set of states ``matrix y + constant`` in which the states at some places are free."""
    for place in places:
        matrix[place, :], constant[place] = sp.eye(matrix.rows)[place, :], 0
    states = [itinerary.presented_system.states[place] for place in places]
    return Section(
        coordinates_of({} if phase else itinerary.start, states),
        tuple(places),
        sp.ImmutableMatrix(matrix[:, places]),
        sp.ImmutableMatrix(constant),
    )


def coordinates_of(names: Mapping[str, str], states: Iterable[sp.Symbol]) -> tuple[sp.Symbol, ...]:
    """Symbols of some states at the start, which may have names of their own."""
    return tuple(sp.Symbol(names.get(str(s), f"{s}0"), real=True) for s in states)

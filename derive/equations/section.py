"""Sections: the affine set on which an orbit starts, as the end of its last phase leaves it."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import sympy as sp

from nonsmooth.derive.declaration.algebra import cancel, factor
from nonsmooth.derive.declaration.dynamics import SecondOrder
from nonsmooth.derive.declaration.itinerary import Itinerary
from nonsmooth.derive.declaration.system import System
from nonsmooth.derive.errors import DerivationError

__all__ = [
    "Section",
    "coordinates_of",
    "reset_matrix",
    "section_of",
    "smallest_section",
    "start_of",
]


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


def section_of(itinerary: Itinerary, system: System) -> Section:
    """The section at the start of the first phase.

    It collects what the end of the last phase enforces: the velocities held through that
    phase, its constraints and its exit boundary, carried through the reset, and what the
    reset assigns. Closing the section's own coordinates then closes the orbit, with no
    equation twice. States without a name of their own in the itinerary are eliminated
    first.
    """
    states = system.states
    last = itinerary.phases[-1]
    configuration = system.configuration(last.configuration)
    vanishing = (configuration.boundary(last.boundary).function, *configuration.constraints)
    constraints = [system.gradient(function) for function in vanishing]
    if isinstance(configuration.dynamics, SecondOrder):
        size = len(states) // 2
        for index, velocity in configuration.dynamics.held_at(states).items():
            row = sp.zeros(1, len(states))
            row[size + index] = 1
            constraints.append((row, -velocity))
    transition = itinerary.transition_after(system, -1)
    jump, shift = reset_matrix(transition.reset.items(), states)
    rows = [row for row, _ in constraints]
    constants = [constant for _, constant in constraints]
    if not transition.reset:
        after = list(zip(rows, constants, strict=True))
    else:
        after = _image(sp.Matrix.vstack(*rows), sp.Matrix(constants), jump, shift)
    matrix = sp.Matrix.vstack(*(row for row, _ in after))
    right = -sp.Matrix([constant for _, constant in after])
    # elimination takes the first columns: those of the states without a name
    order = sorted(range(len(states)), key=lambda i: (str(states[i]) in itinerary.start, i))
    augmented = sp.Matrix.hstack(matrix.extract(list(range(matrix.rows)), order), right)
    reduced, pivots = augmented.applyfunc(cancel).rref(simplify=cancel)
    if len(states) in pivots:
        raise DerivationError(f"itinerary {itinerary.name!r}: its start satisfies no state")
    solved = {order[pivot]: row for row, pivot in enumerate(pivots)}
    places = tuple(i for i in range(len(states)) if i not in solved)
    embedding = sp.zeros(len(states), len(places))
    constant = sp.zeros(len(states), 1)
    for column, place in enumerate(places):
        embedding[place, column] = 1
    for state, row in solved.items():
        constant[state] = factor(reduced[row, len(states)])
        for column, place in enumerate(places):
            embedding[state, column] = -factor(reduced[row, order.index(place)])
    return Section(
        coordinates_of(itinerary, (states[i] for i in places)),
        places,
        sp.ImmutableMatrix(embedding),
        sp.ImmutableMatrix(constant),
    )


def smallest_section(itinerary: Itinerary, system: System) -> tuple[int, Section]:
    """Index of the first phase whose section has the least dimension, and that section."""
    sections = [section_of(itinerary.rotated(k), system) for k in range(len(itinerary.phases))]
    rotation = min(range(len(sections)), key=lambda k: (sections[k].dimension, k))
    return rotation, sections[rotation]


def start_of(itinerary: Itinerary, system: System, section: Section) -> Section:
    """The set on which the start is sought.

    It is the section, or a larger set if the itinerary names more states.
    """
    states = system.states
    named = {i for i, s in enumerate(states) if str(s) in itinerary.start}
    places = tuple(sorted(named | set(section.places)))
    embedding, constant = sp.zeros(len(states), len(places)), sp.Matrix(section.constant)
    for row in range(len(states)):
        if row in places:
            embedding[row, places.index(row)], constant[row] = 1, 0
            continue
        for column, place in enumerate(section.places):
            embedding[row, places.index(place)] = section.embedding[row, column]
    return Section(
        coordinates_of(itinerary, (states[i] for i in places)),
        places,
        sp.ImmutableMatrix(embedding),
        sp.ImmutableMatrix(constant),
    )


def coordinates_of(itinerary: Itinerary, states: Iterable[sp.Symbol]) -> tuple[sp.Symbol, ...]:
    """Symbols of some states at the start."""
    names = map(str, states)
    return tuple(sp.Symbol(itinerary.start.get(n, f"{n}0"), real=True) for n in names)


def reset_matrix(
    reset: Iterable[tuple[sp.Symbol, sp.Expr]], states: Sequence[sp.Symbol]
) -> tuple[sp.Matrix, sp.Matrix]:
    """Matrix R (N x N) and shift r (N x 1) of an affine reset ``y -> R y + r``."""
    matrix, shift = sp.eye(len(states)), sp.zeros(len(states), 1)
    for symbol, expression in reset:
        row = list(states).index(symbol)
        for column, state in enumerate(states):
            matrix[row, column] = sp.diff(expression, state)
        shift[row] = expression.subs(dict.fromkeys(states, 0))
    return matrix, shift


def _image(
    rows: sp.Matrix, constants: sp.Matrix, jump: sp.Matrix, shift: sp.Matrix
) -> list[tuple[sp.Matrix, sp.Expr]]:
    """Equations (row, constant) of the image of a plane under ``y -> jump y + shift``.

    The plane is ``rows y + constants = 0``.
    """
    size = jump.rows
    solved = [sp.Symbol(f"before{i}") for i in range(size)]
    (point,) = sp.linsolve((rows, -constants), *solved) or [None]
    if point is None:
        return [(sp.zeros(1, size), sp.Integer(1))]  # no state before, none behind
    free = sorted(set().union(*(e.free_symbols for e in point)) & set(solved), key=str)
    particular = sp.Matrix(point).subs(dict.fromkeys(free, 0))
    directions = sp.Matrix(point).jacobian(free) if free else sp.zeros(size, 0)
    normals = (jump * directions).T.nullspace() if free else [*sp.eye(size).columnspace()]
    image = jump * particular + shift
    return [(normal.T, -(normal.T * image)[0]) for normal in normals]

"""The chain of states along an itinerary: section, phases, transitions.

Z0 -> Z1 -> ... -> Zp: the start lies on the section, each phase applies the flow of its
configuration, each transition its reset. Everything about a periodic orbit (equations,
Jacobians, Poincare map) is read off this chain.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

import sympy as sp

from nonsmooth.derive.dynamics import SecondOrder
from nonsmooth.derive.errors import DerivationError
from nonsmooth.derive.itinerary import Itinerary, dwell_symbol
from nonsmooth.derive.modal import TIME, Flow
from nonsmooth.derive.program import Stage, assign
from nonsmooth.derive.system import System

__all__ = [
    "Chain",
    "Link",
    "Section",
    "derived_time",
    "follow",
    "name_functions",
    "poincare_jacobian",
    "reset_matrix",
    "section_of",
    "sensitivities",
    "smallest_section",
    "start_of",
]


@dataclass(frozen=True)
class Section:
    """The affine set on which an orbit starts, in coordinates of its own.

    Attributes
    ----------
    coordinates : tuple of symbols
        Values of some of the states at the start.
    places : tuple of int
        Which states those are.
    embedding : N x d matrix, constant : N x 1 matrix
        The start is ``embedding q + constant``.
    """

    coordinates: tuple[sp.Symbol, ...]
    places: tuple[int, ...]
    embedding: sp.Matrix
    constant: sp.Matrix

    @property
    def dimension(self) -> int:
        """Number of coordinates."""
        return len(self.coordinates)

    @property
    def state(self) -> sp.Matrix:
        """State at the start in terms of the coordinates."""
        return self.embedding * sp.Matrix(self.dimension, 1, self.coordinates) + self.constant

    def without(self, coordinates: Iterable[sp.Symbol]) -> Section:
        """The part of the set on which some coordinates are zero."""
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
    phase and its exit boundary, carried through the reset, and what the reset assigns.
    Closing the section's own coordinates then closes the orbit, with no equation twice.
    States without a name of their own in the itinerary are eliminated first.
    """
    states = system.states
    last = itinerary.phases[-1]
    configuration = system.configuration(last.configuration)
    constraints = [system.gradient(configuration.boundary(last.boundary).function)]
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
    reduced, pivots = augmented.applyfunc(sp.cancel).rref(simplify=True)
    if len(states) in pivots:
        raise DerivationError(f"itinerary {itinerary.name!r}: its start satisfies no state")
    solved = {order[pivot]: row for row, pivot in enumerate(pivots)}
    places = tuple(i for i in range(len(states)) if i not in solved)
    embedding = sp.zeros(len(states), len(places))
    constant = sp.zeros(len(states), 1)
    for column, place in enumerate(places):
        embedding[place, column] = 1
    for state, row in solved.items():
        constant[state] = sp.factor(reduced[row, len(states)])
        for column, place in enumerate(places):
            embedding[state, column] = -sp.factor(reduced[row, order.index(place)])
    return Section(
        _coordinates(itinerary, states, places),
        places,
        sp.ImmutableMatrix(embedding),
        sp.ImmutableMatrix(constant),
    )


def smallest_section(itinerary: Itinerary, system: System) -> tuple[int, Section]:
    """The phase whose section has the least dimension, the first of several, and the section."""
    sections = [section_of(itinerary.rotated(k), system) for k in range(len(itinerary.phases))]
    rotation = min(range(len(sections)), key=lambda k: (sections[k].dimension, k))
    return rotation, sections[rotation]


def start_of(itinerary: Itinerary, system: System, section: Section) -> Section:
    """The set on which the start is sought: the section, larger where more states are named."""
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
        _coordinates(itinerary, states, places),
        places,
        sp.ImmutableMatrix(embedding),
        sp.ImmutableMatrix(constant),
    )


def _coordinates(
    itinerary: Itinerary, states: Sequence[sp.Symbol], places: Iterable[int]
) -> tuple[sp.Symbol, ...]:
    """Symbols of states at the start."""
    names = (str(states[i]) for i in places)
    return tuple(sp.Symbol(itinerary.start.get(n, f"{n}0"), real=True) for n in names)


def reset_matrix(
    reset: Iterable[tuple[sp.Symbol, sp.Expr]], states: Sequence[sp.Symbol]
) -> tuple[sp.Matrix, sp.Matrix]:
    """Matrix R and shift r of an affine reset ``y -> R y + r``."""
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
    """Equations of the image of ``rows y + constants = 0`` under ``y -> jump y + shift``."""
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


@dataclass(frozen=True)
class Link:
    """One phase of the chain, with its transition.

    Attributes
    ----------
    flow : Flow
    dwell : symbol
        Its dwell time.
    duration : expression
        The dwell time in terms of the unknowns and parameters: the symbol itself, zero, or
        what the others leave of a given period.
    functions : tuple of expressions
        Values of the flow's basis functions at the end of the phase.
    before, after, following : N x 1 matrices
        State at the start, at the end, and behind the transition.
    normal : 1 x N matrix
        Gradient of the exit boundary.
    exit : expression
        Exit boundary's function at the end: the switching condition is that it vanishes.
    reset : N x N matrix
        Linear part of the transition's reset.
    """

    flow: Flow
    dwell: sp.Symbol
    duration: sp.Expr
    functions: tuple[sp.Expr, ...]
    before: sp.Matrix
    after: sp.Matrix
    following: sp.Matrix
    normal: sp.Matrix
    exit: sp.Expr
    reset: sp.Matrix

    @property
    def transfer(self) -> sp.Matrix:
        """Phi of the whole phase."""
        return self.flow.matrix(self.functions)

    @property
    def velocity(self) -> sp.Matrix:
        """Vector field at the end of the phase: the state's derivative by the dwell time."""
        return self.flow.velocity(self.after)


@dataclass(frozen=True)
class Chain:
    """The start, links and the stages that compute their states.

    `section` is the set on which the end of the last phase lands, `start` the one in whose
    coordinates the start is sought; they differ only where an itinerary names more states.
    """

    section: Section
    start: Section
    links: tuple[Link, ...]
    stages: tuple[Stage, ...]

    @property
    def end(self) -> sp.Matrix:
        """State behind the last transition."""
        return self.links[-1].following


def follow(
    itinerary: Itinerary,
    system: System,
    flows: Mapping[str, Flow],
    section: Section,
    start: Section,
) -> Chain:
    """Follow an itinerary from its start through all phases and transitions."""
    states = system.states
    begin, values = assign("start on the section", [f"{s}_0" for s in states], start.state)
    stages, state, links = [begin], sp.Matrix(values), []
    for index, phase in enumerate(itinerary.phases):
        flow, dwell = flows[phase.configuration], dwell_symbol(phase.dwell_time)
        duration = itinerary.duration(index)
        stages.append(derived_time(dwell, duration))
        naming, functions = name_functions(flow, dwell, duration if duration == 0 else dwell)
        end = flow.matrix(functions) * state + flow.offset(functions)
        names = [f"{s}_{index + 1}" for s in states]
        title = f"{phase.configuration} for {dwell}, until {phase.boundary}"
        step, values = assign(title, names, end)
        after = sp.Matrix(values)
        boundary = system.configuration(phase.configuration).boundary(phase.boundary)
        normal, constant = system.gradient(boundary.function)
        transition = itinerary.transition_after(system, index)
        jump, values = assign(
            f"transition to {transition.target}",
            [f"{n}_reset" for n in names],
            transition.reset_of(after, states),
        )
        following = sp.Matrix(values)
        stages += [naming, step, jump]
        links.append(
            Link(
                flow,
                dwell,
                duration,
                tuple(functions),
                state,
                after,
                following,
                normal,
                (normal * after)[0] + constant,
                reset_matrix(transition.reset.items(), states)[0],
            )
        )
        state = following
    return Chain(section, start, tuple(links), tuple(s for s in stages if s.assignments))


def sensitivities(
    chain: Chain, states: Sequence[sp.Symbol], unknowns: Sequence[sp.Symbol]
) -> tuple[tuple[Stage, ...], list[sp.Matrix]]:
    """Derivatives of the state at each phase's end, and behind the last transition.

    Columns follow `unknowns` (coordinates of the start, then dwell times). By the chain rule
    S' = Phi S + f e^T, with f the vector field at the end and e the derivatives of the
    phase's dwell time.
    """
    columns = len(unknowns)
    matrix = sp.Matrix.hstack(
        chain.start.embedding, sp.zeros(len(states), columns - chain.start.dimension)
    )
    stages, ends = [], []
    for index, link in enumerate(chain.links):
        moved = sp.Matrix(link.transfer * matrix)
        for column, unknown in enumerate(unknowns):
            moved[:, column] += sp.diff(link.duration, unknown) * link.velocity
        names = [f"{s}_{index + 1}_by_{u}" for s in states for u in unknowns]
        step, values = assign(f"derivatives of the state after {link.dwell}", names, moved)
        ends.append(sp.Matrix(len(states), columns, values))
        matrix = link.reset * ends[-1]
        stages.append(step)
    return tuple(stages), [*ends, matrix]


def poincare_jacobian(
    chain: Chain, states: Sequence[sp.Symbol]
) -> tuple[tuple[Stage, ...], sp.Matrix]:
    """Jacobian of the Poincare map on the section, as a product of local maps (Sec. 4).

    Each phase carries a perturbation by Phi and projects it along the vector field onto
    its exit boundary, (I - f n/(n f)) Phi; the transition's reset follows.
    """
    matrix, stages = chain.section.embedding, []
    columns = [str(q) for q in chain.section.coordinates]
    for index, link in enumerate(chain.links):
        names = [f"carried_{s}_{index + 1}_by_{q}" for s in states for q in columns]
        step, values = assign(f"Phi along {link.dwell}", names, link.transfer * matrix)
        carried = sp.Matrix(len(states), len(columns), values)
        velocity = link.velocity
        rate, (speed,) = assign(
            f"rate of the exit boundary after {link.dwell}",
            [f"rate_{index + 1}"],
            [(link.normal * velocity)[0]],
        )
        delays = [-(link.normal * carried[:, j])[0] / speed for j in range(len(columns))]
        delay, values = assign(
            f"derivatives of the time to the boundary after {link.dwell}",
            [f"delay_{link.dwell}_by_{q}" for q in columns],
            delays,
        )
        projected = carried + velocity * sp.Matrix(1, len(columns), values)
        names = [f"{s}_{index + 1}_on_boundary_by_{q}" for s in states for q in columns]
        landing, values = assign(
            f"perturbation on the boundary after {link.dwell}", names, link.reset * projected
        )
        matrix = sp.Matrix(len(states), len(columns), values)
        stages += [step, rate, delay, landing]
    return tuple(stages), matrix.extract(list(chain.section.places), list(range(len(columns))))


def derived_time(dwell: sp.Symbol, duration: sp.Expr) -> Stage:
    """Stage that assigns a dwell time which is not an unknown; empty for one that is."""
    derived = duration not in (dwell, 0)
    return Stage(f"{dwell} completes the period", ((dwell, duration),) if derived else ())


def name_functions(
    flow: Flow, dwell: sp.Symbol, time: sp.Expr | None = None
) -> tuple[Stage, list[sp.Expr]]:
    """Name the values at the end of a phase of the functions of time in its flow.

    The names are those of the dwell time; `time`, if given, is when the values are taken.
    """
    names: list[str] = []
    for position, function in enumerate(flow.basis):
        frequency = [str(s) for s in sorted(function.free_symbols - {TIME}, key=str)]
        name = "_".join([type(function).__name__.lower(), *frequency, str(dwell)])
        names.append(f"{name}_{position}" if name in names else name)
    values = [function.subs(TIME, dwell if time is None else time) for function in flow.basis]
    return assign(f"functions of {dwell} in {flow.configuration}", names, values)

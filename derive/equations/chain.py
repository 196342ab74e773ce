"""The chain of states along an itinerary: section, phases, transitions.

Z0 -> Z1 -> ... -> Zp: the start lies on the section, each phase applies the flow of its
configuration, each transition its reset. Everything about a periodic orbit (equations,
Jacobians, Poincare map) is read off this chain.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import sympy as sp

from nonsmooth.derive.declaration.itinerary import Itinerary, dwell_symbol
from nonsmooth.derive.declaration.system import System
from nonsmooth.derive.equations.forcing import Forcing
from nonsmooth.derive.equations.program import Stage, assign
from nonsmooth.derive.equations.section import Section, reset_matrix
from nonsmooth.derive.flows.entire import ExponentialDifference
from nonsmooth.derive.flows.modal import TIME, Flow
from nonsmooth.derive.symbols import Symbol, derivative

__all__ = [
    "PHASE",
    "Chain",
    "Link",
    "derived_time",
    "follow",
    "name_functions",
    "poincare_jacobian",
    "sensitivities",
]

PHASE = Symbol("phase")  # of the forcing, as a coordinate of the Poincare map


@dataclass(frozen=True)
class Link:
    """One phase of the chain, with the transition that ends it."""

    flow: Flow
    dwell: sp.Symbol  # symbol of the dwell time
    # the dwell time in unknowns and parameters: itself, zero, or the rest of a given period
    duration: sp.Expr
    functions: tuple[sp.Expr, ...]  # values of the flow's basis functions at the end of the phase
    before: sp.Matrix  # N x 1: state at the start
    after: sp.Matrix  # N x 1: state at the end
    following: sp.Matrix  # N x 1: state behind the transition
    normal: sp.Matrix  # 1 x N: gradient of the exit boundary
    exit: sp.Expr  # exit boundary's function at the end, which the switching condition makes zero
    reset: sp.Matrix  # N x N: linear part of the transition's reset

    @property
    def transfer(self) -> sp.Matrix:
        """Matrix Phi (N x N) of the flow over the whole phase."""
        return self.flow.matrix(self.functions)

    @property
    def velocity(self) -> sp.Matrix:
        """Vector field at the end of the phase: the state's derivative by the dwell time."""
        return self.flow.velocity(self.after)


@dataclass(frozen=True)
class Chain:
    """The states of an orbit along all its phases, and the stages that compute them.

    `section` is the set on which the end of the last phase lands; `start` is the set in
    whose coordinates the start is sought. They differ only if an itinerary names more
    states. Of a forcing only the phase is a coordinate of the Poincare map.
    """

    section: Section
    start: Section
    links: tuple[Link, ...]
    stages: tuple[Stage, ...]
    forcing: Forcing | None = None

    @property
    def end(self) -> sp.Matrix:
        """State behind the last transition."""
        return self.links[-1].following

    @property
    def coordinates(self) -> tuple[sp.Symbol, ...]:
        """The coordinates of the Poincare map."""
        found = tuple(self.section.coordinates[place] for place in self._unforced)
        return (*found, PHASE) if self.forcing else found

    @property
    def _unforced(self) -> list[int]:
        """Indices of the section's coordinates that belong to no forcing."""
        forced = self.forcing.states if self.forcing else ()
        return [i for i, place in enumerate(self.section.places) if place not in forced]

    @property
    def directions(self) -> sp.Matrix:
        """Derivatives (N x d) of the start by the coordinates of the Poincare map."""
        embedding = self.section.embedding
        found = embedding[:, self._unforced]
        if self.forcing is None:
            return found
        rates = self.forcing.along_phase(self.links[0].before)
        return found.row_join(embedding * rates.extract(list(self.section.places), [0]))

    def returning(self, moved: sp.Matrix) -> sp.Matrix:
        """Changes (d x k) of the Poincare map's coordinates for changes (N x k) of the end."""
        places = [self.section.places[i] for i in self._unforced]
        found = moved.extract(places, list(range(moved.cols)))
        if self.forcing is None:
            return found
        return found.col_join(self.forcing.phase_of(self.end, moved))


def follow(
    itinerary: Itinerary,
    system: System,
    flows: Mapping[str, Flow],
    section: Section,
    start: Section,
    forcing: Forcing | None = None,
) -> Chain:
    """The chain of an itinerary, from its start through all phases and transitions."""
    states = system.states
    begin, values = assign(
        "start on the section", [Symbol("state", s, 0) for s in states], start.state
    )
    stages, state, links = [begin], sp.Matrix(values), []
    for index, phase in enumerate(itinerary.phases):
        flow, dwell = flows[phase.configuration], dwell_symbol(phase.dwell_time)
        duration = itinerary.duration(index)
        stages.append(derived_time(dwell, duration))
        naming, functions = name_functions(flow, dwell, duration if duration == 0 else dwell)
        end = flow.matrix(functions) * state + flow.offset(functions)
        names = [Symbol("state", s, index + 1) for s in states]
        title = f"{phase.configuration} for {dwell}, until {phase.boundary}"
        step, values = assign(title, names, end)
        after = sp.Matrix(values)
        boundary = system.configuration(phase.configuration).boundary(phase.boundary)
        normal, constant = system.gradient(boundary.function)
        transition = itinerary.transition_after(system, index)
        jump, values = assign(
            f"transition to {transition.target}",
            [Symbol("reset", s, index + 1) for s in states],
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
    kept = tuple(s for s in stages if s.assignments)
    return Chain(section, start, tuple(links), kept, forcing)


def sensitivities(
    chain: Chain, states: Sequence[sp.Symbol], unknowns: Sequence[sp.Symbol]
) -> tuple[tuple[Stage, ...], list[sp.Matrix]]:
    """Stages and derivatives (N x n) of the states at all ends of phases and behind the last.

    Columns follow `unknowns` (coordinates of the start, then dwell times). By the chain
    rule S' = Phi S + f e^T, with f the vector field at the end and e the derivatives of the
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
        behind = [Symbol("state", s, index + 1) for s in states]
        names = [derivative(s, u) for s in behind for u in unknowns]
        step, values = assign(f"derivatives of the state after {link.dwell}", names, moved)
        ends.append(sp.Matrix(len(states), columns, values))
        matrix = link.reset * ends[-1]
        stages.append(step)
    return tuple(stages), [*ends, matrix]


def poincare_jacobian(
    chain: Chain, states: Sequence[sp.Symbol]
) -> tuple[tuple[Stage, ...], sp.Matrix]:
    """Stages and Jacobian (d x d) of the Poincare map, a product of local maps (Sec. 4).

    Each phase carries a perturbation by Phi and projects it along the vector field onto its
    exit boundary, (I - f n/(n f)) Phi; the transition's reset follows.
    """
    matrix, stages, columns = chain.directions, [], chain.coordinates
    for index, link in enumerate(chain.links):
        behind = [Symbol("state", s, index + 1) for s in states]
        names = [derivative(Symbol("carried", s), q) for s in behind for q in columns]
        step, values = assign(f"Phi along {link.dwell}", names, link.transfer * matrix)
        carried = sp.Matrix(len(states), len(columns), values)
        velocity = link.velocity
        rate, (speed,) = assign(
            f"rate of the exit boundary after {link.dwell}",
            [Symbol("rate", index + 1)],
            [(link.normal * velocity)[0]],
        )
        delays = [-(link.normal * carried[:, j])[0] / speed for j in range(len(columns))]
        delay, values = assign(
            f"derivatives of the time to the boundary after {link.dwell}",
            [derivative(Symbol("delay", link.dwell), q) for q in columns],
            delays,
        )
        projected = carried + velocity * sp.Matrix(1, len(columns), values)
        names = [derivative(Symbol("on boundary", s), q) for s in behind for q in columns]
        landing, values = assign(
            f"perturbation on the boundary after {link.dwell}", names, link.reset * projected
        )
        matrix = sp.Matrix(len(states), len(columns), values)
        stages += [step, rate, delay, landing]
    return tuple(stages), chain.returning(matrix)


def derived_time(dwell: sp.Symbol, duration: sp.Expr) -> Stage:
    """Stage that assigns a dwell time which is no unknown; it is empty for an unknown."""
    derived = duration not in (dwell, 0)
    return Stage(f"{dwell} completes the period", ((dwell, duration),) if derived else ())


def name_functions(
    flow: Flow, dwell: sp.Symbol, time: sp.Expr | None = None
) -> tuple[Stage, list[sp.Expr]]:
    """Stage and names of the values of a flow's functions of time at the end of a phase.

    The names contain the dwell time; `time`, if given, is when the values are taken.
    """
    names: list[str] = []
    for position, function in enumerate(flow.basis):
        frequency = [str(s) for s in sorted(function.free_symbols - {TIME}, key=str)]
        kind = type(function)
        stem = "difference" if kind is ExponentialDifference else kind.__name__.lower()
        name = "_".join([stem, *frequency, str(dwell)])
        names.append(f"{name}_{position}" if name in names else name)
    values = [function.subs(TIME, dwell if time is None else time) for function in flow.basis]
    symbols = [Symbol("function", name) for name in names]
    return assign(f"functions of {dwell} in {flow.configuration}", symbols, values)

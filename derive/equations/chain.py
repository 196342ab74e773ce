"""The chain of states along an itinerary: section, phases, transitions.

Z0 -> Z1 -> ... -> Zp: the start lies on the section, each phase applies the flow of its
configuration, each transition its reset. Everything about a periodic orbit (equations,
Jacobians, Poincare map) is read off this chain.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import sympy as sp

from nonsmooth.derive.declaration.itinerary import Itinerary
from nonsmooth.derive.equations.forcing import Forcing
from nonsmooth.derive.equations.program import (
    Equation,
    Stage,
    Stages,
    affine_sum,
    assign,
    assign_matrix,
    filled,
)
from nonsmooth.derive.equations.section import Passage, Section, passages_of
from nonsmooth.derive.flows.entire import ExponentialDifference
from nonsmooth.derive.flows.modal import TIME, Flow
from nonsmooth.derive.symbols import Symbol

PHASE = Symbol("phase")  # of the forcing, as a coordinate of the Poincare map


@dataclass(frozen=True)
class Link(Passage):
    """One phase of the chain, with the transition that ends it."""

    flow: Flow
    functions: tuple[sp.Expr, ...]  # values of the flow's basis functions at the end of the phase
    before: sp.Matrix  # N x 1: state at the start
    after: sp.Matrix  # N x 1: state at the end
    following: sp.Matrix  # N x 1: state behind the transition

    @property
    def exit(self) -> sp.Expr:
        """The boundary's function at the end, which the switching condition makes zero."""
        return self.value(self.after)

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
    stages: Stages
    forcing: Forcing | None

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
    def closing(self) -> list[tuple[sp.Symbol, int]]:
        """Coordinates of the start, with their places, whose closure is one of the equations."""
        pairs = zip(self.start.coordinates, self.start.places, strict=True)
        return [(q, place) for q, place in pairs if place not in self._forced]

    @property
    def _forced(self) -> tuple[int, ...]:
        """Places of the states of a forcing, which comes back by itself."""
        return self.forcing.states if self.forcing else ()

    @property
    def _unforced(self) -> list[int]:
        """Indices of the section's coordinates that belong to no forcing."""
        return [i for i, place in enumerate(self.section.places) if place not in self._forced]

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
    flows: Mapping[str, Flow],
    section: Section,
    start: Section,
    forcing: Forcing | None,
) -> Chain:
    """The chain of an itinerary, from its start through all phases and transitions."""
    states = itinerary.presented_system.states
    names = [Symbol("state", s, 0) for s in states]
    begin, state = assign_matrix("start on the section", names, start.state)
    stages, links = [begin], []
    for index, passage in enumerate(passages_of(itinerary), start=1):
        flow, dwell = flows[passage.configuration.name], passage.dwell
        naming, functions = name_functions(flow, dwell, 0 if passage.duration == 0 else dwell)
        names = [Symbol("state", s, index) for s in states]
        title = f"{flow.configuration} for {dwell}, until {passage.boundary}"
        step, after = assign_matrix(title, names, flow.end(functions, state))
        title = f"transition to {passage.transition.target}"
        names = [Symbol("reset", s, index) for s in states]
        jump, following = assign_matrix(title, names, passage.behind(after))
        stages += [derived_time(dwell, passage.duration), naming, step, jump]
        links.append(
            Link(
                **vars(passage),
                flow=flow,
                functions=tuple(functions),
                before=state,
                after=after,
                following=following,
            )
        )
        state = following
    kept = filled(stages)
    return Chain(section, start, tuple(links), kept, forcing)


def affine_conditions(chain: Chain) -> tuple[Stages, list[Equation]]:
    """Stages, and the switching conditions and closures as equations (meaning, expression).

    They are affine in the coordinates of the start, with coefficients that are functions of
    the dwell times. The closure of a forcing is left out.
    """
    start, stages, equations = chain.start, [], []
    state = start.state
    for link in chain.links:
        naming, functions = name_functions(link.flow, link.dwell, link.dwell)
        after = link.flow.end(functions, state)
        equations.append((link.meaning, sp.expand(link.value(after))))
        state = link.behind(after)
        stages.append(naming)
        if link is not chain.links[-1]:
            step, state = affine_in(start.coordinates, state.applyfunc(sp.expand), link.dwell)
            stages.append(step)
    for coordinate, place in chain.closing:
        equations.append((f"{coordinate} returns", sp.expand(state[place] - coordinate)))
    return filled(stages), equations


def affine_in(
    coordinates: Sequence[sp.Symbol], state: sp.Matrix, dwell: sp.Symbol
) -> tuple[Stage, sp.Matrix]:
    """Stage and state, with names for the coefficients of section coordinates in the state."""
    constant = state.subs(dict.fromkeys(coordinates, 0))
    parts = sp.Matrix.hstack(constant, state.jacobian(coordinates)).T.applyfunc(sp.factor_terms)
    places = [(i, q) for q in (1, *coordinates) for i in range(state.rows)]
    names = [Symbol("part", i, q, dwell) for i, q in places]
    step, table = assign_matrix(f"state after {dwell}, affine in the section", names, parts)
    return step, sp.Matrix([affine_sum(table[:, i], coordinates) for i in range(state.rows)])


def derived_time(dwell: sp.Symbol, duration: sp.Expr) -> Stage:
    """Stage that assigns a dwell time which is no unknown; it is empty for an unknown."""
    derived = duration not in (dwell, 0)
    return Stage(f"{dwell} completes the period", ((dwell, duration),) if derived else ())


def name_functions(flow: Flow, dwell: sp.Symbol, time: sp.Expr) -> tuple[Stage, list[sp.Expr]]:
    """Stage and names of the values of a flow's functions at a time.

    The names contain the dwell time of the phase.
    """
    names: list[str] = []
    for position, function in enumerate(flow.basis):
        frequency = [str(s) for s in sorted(function.free_symbols - {TIME}, key=str)]
        kind = type(function)
        stem = "difference" if kind is ExponentialDifference else kind.__name__.lower()
        name = "_".join([stem, *frequency, str(dwell)])
        names.append(f"{name}_{position}" if name in names else name)
    values = [function.subs(TIME, time) for function in flow.basis]
    symbols = [Symbol("function", name) for name in names]
    return assign(f"functions of {dwell} in {flow.configuration}", symbols, values)

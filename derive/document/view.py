"""What a document describes: a system, an orbit's equations, or an itinerary without equations."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import combinations

import sympy as sp

from nonsmooth.derive.declaration.algebra import cancel, factor
from nonsmooth.derive.declaration.itinerary import Itinerary, dwell_symbol
from nonsmooth.derive.declaration.symmetry import translations
from nonsmooth.derive.declaration.system import TIME, System
from nonsmooth.derive.document.blocks import Formula
from nonsmooth.derive.document.notation import Notation, enumeration
from nonsmooth.derive.equations.chain import PHASE, Link
from nonsmooth.derive.equations.equation_system import EquationSystem
from nonsmooth.derive.equations.linearisation import saltation_matrix
from nonsmooth.derive.equations.section import Passage, Section, passages_of, start_of
from nonsmooth.derive.equations.symmetry import halfway, phase_ends
from nonsmooth.derive.flows.modal import Flow, Spectrum
from nonsmooth.derive.symbols import meaning_of


@dataclass(frozen=True)
class Described:
    """What a document describes, with its notation."""

    notation: Notation
    places: Mapping[str, int]  # numbers of the sections by title, once they are known
    itinerary: Itinerary | None  # that of an orbit

    @property
    def declared(self) -> System:
        """The system as it is declared, before a presentation."""
        return self.itinerary.system if self.itinerary else self.notation.system

    def label(self, place: str) -> str:
        """Number of an equation by the title of its section and its place in it, from 1."""
        title, _, index = place.rpartition(" ")
        return f"{self.places[title]}.{index}"


@dataclass(frozen=True)
class OfItinerary(Described):
    """A description of an itinerary."""

    itinerary: Itinerary

    @property
    def count(self) -> int:
        """Number of phases."""
        return len(self.itinerary.phases)

    @property
    def phase(self) -> str:
        """Index of a phase in formulas: k, or 1 if there is only one phase."""
        return "k" if self.count > 1 else "1"

    @property
    def product(self) -> str:
        """LaTeX of the sign of a product over the phases, the first on the right."""
        return rf"\prod_{{k={self.count}}}^{{1}}" if self.count > 1 else ""


@dataclass(frozen=True)
class View(OfItinerary):
    """An orbit's equations with the notation in which they are written."""

    equations: EquationSystem

    @property
    def reversible(self) -> bool:
        """Whether the orbit is sought among those that a reversor maps to themselves."""
        return bool(self.itinerary.reversor)

    @property
    def links(self) -> tuple[Link, ...]:
        """The phases of the chain."""
        return self.equations.chain.links

    @property
    def resets(self) -> bool:
        """Whether some transition makes the state jump."""
        return not all(map(is_unit, self.links))

    @property
    def map_coordinates(self) -> str:
        """Coordinates of the Poincaré map, listed in words."""
        chain = self.equations.chain
        listed = [self.notation.math(q) for q in chain.coordinates if q != PHASE]
        return enumeration([*listed, *(["the phase of the forcing"] if chain.forcing else [])])

    @cached_property
    def undecided(self) -> tuple[Itinerary, System, Section]:
        """Itinerary, system and start, before the closure's required values are inserted."""
        equations, itinerary = self.equations, self.itinerary
        shown = itinerary.presentation
        if equations.required and shown is not None:
            kept = {s: e for s, e in shown.substitution.items() if s not in equations.required}
            itinerary = replace(itinerary, presentation=replace(shown, substitution=kept))
        system = itinerary.presented_system
        return itinerary, system, start_of(itinerary)

    @cached_property
    def images(self) -> tuple[sp.Matrix, ...]:
        """States at the ends of a reversible orbit's phases, in the start's coordinates."""
        return tuple(phase_ends(self.itinerary, self.equations.chain.start))

    @cached_property
    def saltations(self) -> tuple[sp.Matrix, ...]:
        """Saltation matrix (N x N) of each transition, where its switching condition holds.

        It is written in the states at the ends of the phases, for a reversible orbit in the
        coordinates of its start.
        """
        links, found = self.links, []
        every = (a for stage in self.equations.chain.stages for a in stage.assignments)
        resets = {symbol: value for symbol, value in every if meaning_of(symbol) == "reset"}
        for index, link in enumerate(links):
            following = links[(index + 1) % len(links)].flow
            behind = following.velocity(link.following.xreplace(resets))
            matrix = saltation_matrix(link.reset, link.normal, link.velocity, behind)
            condition = link.exit
            if self.reversible:
                images = {
                    s: e for s, e in zip(link.after, self.images[index], strict=True) if s.is_Symbol
                }
                matrix = matrix.subs(images, simultaneous=True)
                condition = condition.subs(images, simultaneous=True)
            states = sorted(filter(self.notation.is_state, condition.free_symbols), key=str)
            found.append(where_zero(sp.expand(condition), states, matrix))
        return tuple(found)

    def labels_of(self, meaning: str) -> list[str]:
        """Numbers, in brackets, of the equations with a meaning."""
        known = enumerate(self.equations.equations, start=1)
        return [f"({self.label(f'The equations {i}')})" for i, (m, _) in known if m == meaning]

    def numbered(self, title: str, equations: Sequence[tuple[str, sp.Expr]]) -> list[Formula]:
        """Equations of a section as numbered formulas with their meanings and places in the source.

        Those in which functions of time occur are arranged by these functions.
        """
        notation, found = self.notation, []
        ends = [f"{phase.boundary} ends {phase.configuration}" for phase in self.itinerary.phases]
        for place, (meaning, expression) in enumerate(equations, start=1):
            if any(map(notation.is_function, expression.free_symbols)):
                pieces = notation.signed(notation.by_function(expression))
            else:
                pieces = notation.pieces(notation.tidy(expression))
            line = notation.relation("", pieces, " = 0", shows=expression)
            keys = [f"end {k}" for k, end in enumerate(ends, start=1) if end == meaning]
            cited = notation.cited(*(keys or ["halfway" if "halfway" in meaning else "closure"]))
            note = self._meaning(meaning) + cited
            label = self.label(f"{title} {place}")
            found.append(Formula((replace(line, relation=""),), label, note))
        return found

    def _meaning(self, text: str) -> str:
        """Meaning of an equation as text, its first word set as a symbol if it is one."""
        word, _, rest = text.partition(" ")
        for symbol in (*self.notation.system.states, *self.notation.unknowns):
            if word == symbol.name and rest:
                return f"{self.notation.math(symbol)} {self.notation.prose(rest)}"
        return self.notation.prose(text)


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
class Cycle(OfItinerary):
    """An itinerary without equations: the section at its start, and transitions once each."""

    @property
    def system(self) -> System:
        """The system in the presentation of the itinerary."""
        return self.notation.system

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

    @property
    def end(self) -> str:
        """LaTeX of the state behind the last transition."""
        return f"{self.notation.state}^{{({self.count}){'+' if self.resets else ''}}}"

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


def where_zero(
    condition: sp.Expr, states: Iterable[sp.Symbol], matrix: sp.Matrix
) -> sp.ImmutableMatrix:
    """A matrix where a switching condition holds, which is solved for one of the states.

    The first with a number as its coefficient is preferred.
    """
    slopes = {s: slope for s in states if (slope := sp.diff(condition, s)) != 0}
    if slopes:
        state = min(slopes, key=lambda s: not slopes[s].is_number)
        solution = sp.expand(-(condition - slopes[state] * state) / slopes[state])
        matrix = matrix.subs(state, solution)
    return sp.ImmutableMatrix(matrix.applyfunc(lambda e: factor(cancel(e))))


def system_notation(
    system: System, names: Iterable[str], spectrum: Spectrum, flows: Mapping[str, Flow]
) -> Notation:
    """Notation of some configurations of a system, and of those of their flows that are known."""
    names = tuple(dict.fromkeys(names))
    return Notation(
        states=system.states,
        constants=(*(p.symbol for p in system.parameters), *spectrum.symbols),
        flows={name: flows[name] for name in names if name in flows},
        spectrum=spectrum,
        system=system,
        names=names,
    )


def itinerary_notation(
    itinerary: Itinerary, spectrum: Spectrum, flows: Mapping[str, Flow]
) -> Notation:
    """Notation of an itinerary without equations."""
    system, phases = itinerary.presented_system, itinerary.phases
    parameters = dict.fromkeys((*system.parameters, *itinerary.system.parameters))
    section = start_of(itinerary)
    return replace(
        system_notation(system, (p.configuration for p in phases), spectrum, flows),
        states=tuple(dict.fromkeys((*system.states, *itinerary.system.states))),
        constants=(*(p.symbol for p in parameters), *spectrum.symbols),
        unknowns=(*section.coordinates, *(dwell_symbol(p.dwell_time) for p in phases)),
        start=dict(zip(section.coordinates, section.places, strict=True)),
        source=itinerary.source,
    )


def notation_of(equations: EquationSystem) -> Notation:
    """Notation of an orbit with equations."""
    itinerary, system, chain = equations.itinerary, equations.system, equations.chain
    plain = itinerary_notation(itinerary, equations.spectrum, equations.flows)
    known = list(itinerary.system.parameters)
    # a given period stands where dwell times stand, behind the frequencies
    known += [p for p in system.parameters if p not in (*known, itinerary.period)]
    reduction = equations.reduction
    reduced = (*reduction.unknowns, *(e.unknown for e in reduction.eliminations))
    return replace(
        plain,
        constants=(*(p.symbol for p in known), *equations.spectrum.symbols),
        functions=functions_of(equations),
        unknowns=tuple(dict.fromkeys((*equations.unknowns, *reduced))),
        start={
            coordinate: place
            for section in (chain.section, chain.start)
            for coordinate, place in zip(section.coordinates, section.places, strict=True)
        },
        # the state of a forced orbit is taken apart behind a reset
        behind={
            link.dwell: f"({number}){'+' if chain.forcing and not is_unit(link) else ''}"
            for number, link in enumerate(chain.links, start=1)
        },
    )


def is_unit(link: Link) -> bool:
    """Whether no reset stands behind a phase."""
    return bool(link.reset == sp.eye(link.reset.rows))


def functions_of(equations: EquationSystem) -> dict[sp.Symbol, sp.Expr]:
    """Values of functions of time, by the symbols that stand for them."""
    found = {
        value: function.subs(TIME, link.dwell)
        for link in equations.chain.links
        for function, value in zip(link.flow.basis, link.functions, strict=True)
        if value.is_Symbol and value != link.dwell
    }
    if equations.itinerary.reversor:
        assigned = dict(a for stage in equations.stages for a in stage.assignments)
        halves = {halfway(link.dwell): link.dwell / 2 for link in equations.chain.links}
        halved = {s: e.subs(halves) for s, e in assigned.items() if set(halves) & e.free_symbols}
        found |= halves | halved
    return found

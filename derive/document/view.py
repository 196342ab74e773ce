"""One orbit as its document sees it: the equations, how they are written, and their numbers."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import sympy as sp

from nonsmooth.derive.declaration.algebra import cancel, factor
from nonsmooth.derive.declaration.itinerary import Itinerary
from nonsmooth.derive.declaration.system import TIME, System
from nonsmooth.derive.document.blocks import Formula, Line
from nonsmooth.derive.document.printer import Notation
from nonsmooth.derive.document.symbols import grouped_by
from nonsmooth.derive.document.wording import Naming, enumeration
from nonsmooth.derive.equations.chain import PHASE, Link
from nonsmooth.derive.equations.equation_system import EquationSystem
from nonsmooth.derive.equations.linearisation import saltation_matrix
from nonsmooth.derive.equations.section import Section, start_of
from nonsmooth.derive.equations.symmetry import halfway, phase_ends
from nonsmooth.derive.flows.modal import Flow
from nonsmooth.derive.symbols import Symbol, meaning_of

# more products of functions of time are not written out
_MOST_TERMS = 12
# a factor of more terms gets a letter
_LONG = 3


@dataclass(frozen=True)
class Described:
    """What a document describes, with the notation and the numbers in it."""

    itinerary: Itinerary
    naming: Naming
    numbers: Mapping[str, int]  # by configuration: number of its flow
    places: Mapping[str, int]  # by title: number of a section

    def label(self, title: str, index: int = 0) -> str:
        """Number of an equation: that of its section, and its place in it."""
        return f"{self.places[title]}.{index + 1}"

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
class View(Described):
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
    def flows(self) -> dict[str, Flow]:
        """Flows of the orbit's configurations, each once."""
        return {link.flow.configuration: link.flow for link in self.links}

    @property
    def map_coordinates(self) -> str:
        """Coordinates of the Poincaré map, listed in words."""
        chain, notation = self.equations.chain, self.naming.notation
        listed = [f"${notation.symbol(q)}$" for q in chain.coordinates if q != PHASE]
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
            states = sorted(filter(self.naming.notation.is_state, condition.free_symbols), key=str)
            found.append(where_zero(sp.expand(condition), states, matrix))
        return tuple(found)

    def labels_of(self, meaning: str) -> list[str]:
        """Numbers, in brackets, of the equations with a meaning."""
        known = enumerate(self.equations.equations)
        return [f"({self.label('The equations', i)})" for i, (m, _) in known if m == meaning]

    def numbered(self, title: str, equations: Sequence[tuple[str, sp.Expr]]) -> list[Formula]:
        """Equations of a section as numbered formulas with their meanings and places in the source.

        Those in which functions of time occur are arranged by these functions.
        """
        naming, notation, found = self.naming, self.naming.notation, []
        phases = self.itinerary.phases
        ends = [f"{phase.boundary} ends {phase.configuration}" for phase in phases]
        for i, (meaning, expression) in enumerate(equations):
            if any(map(notation.is_function, expression.free_symbols)):
                pieces = notation.signed(notation.by_function(expression))
            else:
                pieces = notation.pieces(notation.tidy(expression))
            line = Line("", "", (*pieces[:-1], f"{pieces[-1]} = 0"), None, expression)
            keys = [f"end {k}" for k, end in enumerate(ends, start=1) if end == meaning]
            cited = naming.cited(*(keys or ["halfway" if "halfway" in meaning else "closure"]))
            found.append(Formula((line,), self.label(title, i), self._meaning(meaning) + cited))
        return found

    def _meaning(self, text: str) -> str:
        """Meaning of an equation as text, its first word set as a symbol if it is one."""
        word, _, rest = text.partition(" ")
        for symbol in (*self.naming.system.states, *self.naming.notation.unknowns):
            if word == symbol.name and rest:
                return f"${self.naming.notation.symbol(symbol)}$ {self.naming.prose(rest)}"
        return self.naming.prose(text)


@dataclass(frozen=True)
class MonodromyTrace:
    """Trace of a monodromy matrix as a sum of terms."""

    terms: tuple[sp.Expr, ...]
    names: dict[sp.Symbol, sp.Expr]  # symbols for entries of saltation matrices
    factors: dict[sp.Symbol, sp.Expr]  # symbols for long factors


def monodromy_trace(view: View) -> MonodromyTrace | None:
    """Trace of the monodromy matrix in functions of the dwell times; None if it is too long."""
    notation, names = view.naming.notation, dict[sp.Symbol, sp.Expr]()
    product = sp.eye(len(view.naming.system.states))
    for index, (link, matrix) in enumerate(zip(view.links, view.saltations, strict=True), 1):
        named = matrix.as_mutable()
        for i in range(matrix.rows):
            for j in range(matrix.cols):
                if not matrix[i, j].is_number:
                    latex = rf"\left(S_{{{index}}}\right)_{{{i + 1}{j + 1}}}"
                    symbol = Symbol("written", f"saltation_{index}_{i}{j}", latex)
                    named[i, j], names[symbol] = symbol, matrix[i, j]
        product = named * link.transfer * product
    total = sp.expand(product.trace())
    functions = [s for s in total.free_symbols if notation.is_function(s)]
    collected = grouped_by(total, [*functions, *names])
    if len(collected) > _MOST_TERMS:
        return None
    order = {s: i for i, s in enumerate((*notation.functions, *names))}
    # functions with one coefficient, but for frequencies, share it
    groups: dict[sp.Expr, sp.Expr] = {}
    for monomial in sorted(collected, key=lambda m: sorted(order[s] for s in m.free_symbols)):
        entry, function = monomial.as_independent(*functions, as_Add=False)
        inner, outer = factor(collected[monomial]).as_independent(
            *notation.projectors, as_Add=False
        )
        key, sign = (-outer * entry, -1) if -outer * entry in groups else (outer * entry, 1)
        groups[key] = groups.get(key, sp.Integer(0)) + sign * inner * function
    long = [outer for outer in groups if len(sp.Add.make_args(outer)) > _LONG]
    letters = {k: Symbol("written", f"kappa{i}", rf"\kappa_{{{i}}}") for i, k in enumerate(long, 1)}
    terms = [
        sp.Mul(letters.get(outer, outer), sp.factor_terms(inner)) for outer, inner in groups.items()
    ]
    return MonodromyTrace(tuple(terms), names, {letter: k for k, letter in letters.items()})


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


def naming_of(equations: EquationSystem) -> Naming:
    """Notation of an orbit's document."""
    itinerary, system, start = equations.itinerary, equations.system, equations.chain.start
    known = list(itinerary.system.parameters)
    # a given period stands where dwell times stand, behind the frequencies
    known += [p for p in system.parameters if p not in (*known, itinerary.period)]
    spectrum, flows = equations.spectrum, [link.flow for link in equations.chain.links]
    constants = tuple(p.symbol for p in known) + spectrum.symbols
    all_states = tuple(dict.fromkeys((*system.states, *itinerary.system.states)))
    frequencies = {s for f in flows for g in f.basis for s in g.free_symbols}
    entries = {s for f in flows for m in f.matrices for s in m.free_symbols}
    section = equations.chain.section
    reduction = equations.reduction
    reduced = (*reduction.unknowns, *(e.unknown for e in reduction.eliminations))
    notation = Notation(
        all_states,
        constants,
        functions_of(equations),
        tuple(dict.fromkeys((*equations.unknowns, *reduced))),
        dict(zip(section.coordinates, section.places, strict=True))
        | dict(zip(start.coordinates, start.places, strict=True)),
        tuple(s for s in spectrum.symbols if s in entries - frequencies),
        _marks(equations),
        tuple(flows),
    )
    return Naming(notation, system, itinerary.source)


def _marks(equations: EquationSystem) -> dict[sp.Symbol, str]:
    """Mark of the state behind each phase, by its dwell time."""
    found = {}
    for number, link in enumerate(equations.chain.links, start=1):
        # that of a forced orbit is taken apart behind the transition
        changed = equations.chain.forcing is not None and link.reset != sp.eye(link.reset.rows)
        found[link.dwell] = f"({number}){'+' if changed else ''}"
    return found


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

"""Elimination of every unknown that is linear or explicit.

The chain is followed once more, from the rotation of the itinerary whose section is
smallest. On the way each exit condition is used as far as it goes:

* it is linear in the dwell time (all coordinates held): the dwell time is explicit;
* it has one frequency and no drift: cosine and sine of the angle are explicit, and the
  dwell time is the first return;
* it contains a section coordinate that is still unknown: linear in it, so the coordinate
  is explicit and the dwell time stays as the unknown in its place;
* otherwise the dwell time stays unknown and the condition stays an equation.

With a section of dimension one this leaves a map in one variable: the coordinate q at the
start as a function of one unknown, and the returning coordinate. Its slope is the only
multiplier that can differ from zero, hence the trace.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import sympy as sp

from nonsmooth.derive.declaration.algebra import cancel, factor
from nonsmooth.derive.declaration.itinerary import Itinerary, Phase, dwell_symbol
from nonsmooth.derive.declaration.system import System
from nonsmooth.derive.equations.chain import name_functions
from nonsmooth.derive.equations.explicit import LINEAR, ExplicitTime, explicit_time
from nonsmooth.derive.equations.program import (
    Stage,
    assign,
    derivative_of,
    differentiate,
    merged,
    prune,
)
from nonsmooth.derive.equations.section import section_of, smallest_section
from nonsmooth.derive.flows.modal import TIME, Flow, Spectrum
from nonsmooth.derive.symbols import Symbol, derivative

__all__ = ["Elimination", "Reduction", "affine_in", "reduce_itinerary", "unreduced"]


@dataclass(frozen=True)
class Elimination:
    """An unknown that the reduction makes explicit, and the rule by which it does."""

    unknown: sp.Symbol
    rule: str


@dataclass(frozen=True)
class Reduction:
    """The reduced equations of an orbit, and the way back to all its unknowns."""

    rotation: int  # the phase at which the reduction starts
    rank: int  # least dimension of a section, which bounds the number of nonzero multipliers
    unknowns: tuple[sp.Symbol, ...]  # those on which Newton's method works
    # as many (meaning, expression), zero at an orbit, in terms of the stages
    equations: tuple[tuple[str, sp.Expr], ...]
    stages: tuple[Stage, ...]
    # every unknown of the full equations, in terms of the stages
    values: Mapping[sp.Symbol, sp.Expr]
    eliminations: tuple[Elimination, ...]
    # vector field: derivative of a phase's last state by its dwell time, by (symbol, dwell time)
    rates: Mapping[tuple[sp.Symbol, sp.Symbol], sp.Expr]
    start: sp.Expr | None  # the section's only coordinate q at the start, None if there are several
    image: sp.Expr | None  # the same coordinate after one turn
    # (determinant, bound) of solved linear equations: far below it the orbit is undetermined
    determinants: tuple[tuple[sp.Expr, sp.Expr], ...] = ()
    # both values of the only unknown of a quadratic equation over parameters: an explicit orbit
    roots: tuple[sp.Expr, ...] = ()

    def jacobian(self) -> tuple[tuple[Stage, ...], sp.Matrix]:
        """Stages and Jacobian of the reduced equations by their unknowns."""
        seeds = {u: {u: sp.Integer(1)} for u in self.unknowns}
        stages, moving = differentiate(
            self.needed([e for _, e in self.equations]), seeds, self.rates
        )
        entries = [
            [derivative_of(equation, moving[u]) for u in self.unknowns]
            for _, equation in self.equations
        ]
        return stages, sp.Matrix(entries)

    def slope(self) -> tuple[tuple[Stage, ...], sp.Expr]:
        """Stages and slope of the map in one variable, by the implicit function theorem.

        The unknowns x follow the coordinate q(x) at the start along all equations but the last,
        which is the closure q(image) = q(start); in general q depends on the first unknown
        alone.
        """
        if self.start is None or self.image is None:
            raise ValueError("the reduction has no map in one variable")
        stages, jacobian = self.jacobian()
        base = self.needed([self.start, self.image])
        seeds = {u: {u: sp.Integer(1)} for u in self.unknowns}
        more, moving = differentiate(base, seeds, self.rates)
        by = [derivative_of(self.image, moving[u]) for u in self.unknowns]
        rates = [derivative_of(self.start, moving[u]) for u in self.unknowns]
        start_rate, numerator = rates[0], by[0]
        followers = len(self.unknowns) - 1
        if any(rates[1:]):
            # the coordinate moves with several unknowns: the tangent t of the equations
            # with (dq/dx) t = 1 carries it
            rows = sp.Matrix.vstack(jacobian[:followers, :], sp.Matrix([rates]))
            moved = [Symbol("equation", i) for i in range(followers)] + [Symbol("start")]
            names = [derivative(s, u) for s in moved for u in self.unknowns]
            step, values = assign("derivatives of the equations and of the start", names, rows)
            right = sp.Matrix([0] * followers + [1])
            tangent = sp.Matrix(*rows.shape, values).LUsolve(right)
            slope = sum((b * e for b, e in zip(by, tangent, strict=True)), sp.Integer(0))
            return (*merged(stages, more), step), slope
        if followers:
            equations = [Symbol("equation", i) for i in range(followers)]
            names = [derivative(s, u) for s in equations for u in self.unknowns]
            step, values = assign("derivatives of the equations", names, jacobian[:followers, :])
            stages = (*stages, step)
            rows = sp.Matrix(followers, followers + 1, values)
            response = -rows[:, 1:].LUsolve(rows[:, 0])
            numerator += sum(b * r for b, r in zip(by[1:], response, strict=True))
        return merged(stages, more), numerator / start_rate

    def needed(self, expressions: Sequence[sp.Expr]) -> tuple[Stage, ...]:
        """The stages on which the expressions depend."""
        return prune(self.stages, expressions)


@dataclass
class _Draft:
    """The reduction as far as it is made along the itinerary."""

    constants: set[sp.Symbol]
    unsolved: list[sp.Symbol]
    stages: list[Stage] = field(default_factory=list)
    equations: list[tuple[str, sp.Expr]] = field(default_factory=list)
    unknowns: list[sp.Symbol] = field(default_factory=list)
    eliminations: list[Elimination] = field(default_factory=list)
    values: dict[sp.Symbol, sp.Expr] = field(default_factory=dict)
    linear_times: dict[sp.Symbol, sp.Expr] = field(default_factory=dict)
    rates: dict[tuple[sp.Symbol, sp.Symbol], sp.Expr] = field(default_factory=dict)
    solved: list[Stage] = field(default_factory=list)

    @property
    def variables(self) -> list[sp.Symbol]:
        """What a state may contain beside constants, in the order in which it comes up."""
        stages = (*self.stages, *self.solved)
        assigned = (symbol for stage in stages for symbol, _ in stage.assignments)
        return [*self.unsolved, *self.unknowns, *assigned]

    def settle(self) -> None:
        """Assign the solved coordinates, the last one first, as the others contain it."""
        self.stages += reversed(self.solved)
        self.solved = []


@dataclass(frozen=True)
class _Exit:
    """A phase with its flow, its dwell time and the boundary that ends it."""

    phase: Phase
    flow: Flow
    dwell: sp.Symbol
    gradient: tuple[sp.Matrix, sp.Expr]

    @property
    def meaning(self) -> str:
        """The exit condition in words."""
        return f"{self.phase.boundary} ends {self.phase.configuration}"

    def condition(self, state: sp.Matrix) -> sp.Expr:
        """Value of the boundary's function at a state."""
        row, constant = self.gradient
        return sp.expand((row * state)[0] + constant)


def reduce_itinerary(
    itinerary: Itinerary, system: System, flows: Mapping[str, Flow], spectrum: Spectrum
) -> Reduction:
    """The reduction of an itinerary; see the module's description.

    With parameters to solve for there is no map in one variable, as they stay unknown.
    """
    count = len(itinerary.phases)
    rotation, section = smallest_section(itinerary, system)
    turned, original = itinerary.rotated(rotation), section_of(itinerary, system)

    # the states behind phase k carry the index k; so do the coordinates of this section
    coordinates = [Symbol("state", system.states[i], rotation) for i in section.places]
    constants = {p.symbol for p in system.parameters} | set(spectrum.symbols)
    draft = _Draft(constants, list(coordinates))
    state = section.state.subs(dict(zip(section.coordinates, coordinates, strict=True)))
    for index, phase in enumerate(turned.phases):
        if (index + rotation) % count == 0:
            start = [state[i] for i in original.places]
            draft.values |= dict(zip(original.coordinates, start, strict=True))
        boundary = system.configuration(phase.configuration).boundary(phase.boundary)
        leaving = _Exit(
            phase,
            flows[phase.configuration],
            dwell_symbol(phase.dwell_time),
            system.gradient(boundary.function),
        )
        # beyond the last phase the count goes on: the return is not the start
        names = [Symbol("state", s, index + rotation + 1) for s in system.states]
        follow = _at_once if phase.dwell_time in itinerary.vanishing else _through
        after = follow(draft, leaving, state, names)
        state = turned.transition_after(system, index).reset_of(after, system.states)

    draft.settle()
    images = [
        _canonical(state[place].subs(draft.linear_times), constants) for place in section.places
    ]
    for coordinate, image in zip(coordinates, images, strict=True):
        draft.equations.append((f"{coordinate} returns", image - coordinate))
    swapped = [p.symbol for p in system.parameters if p.name in itinerary.solved_for]
    draft.values |= {s: s for s in swapped}
    wanted = [e for _, e in draft.equations] + list(draft.values.values())
    one = section.dimension == 1 and not swapped
    return Reduction(
        rotation,
        section.dimension,
        tuple(draft.unsolved + draft.unknowns + swapped),
        tuple(draft.equations),
        prune(draft.stages, wanted),
        draft.values,
        tuple(draft.eliminations),
        draft.rates,
        coordinates[0] if one else None,
        images[0] if one else None,
    )


def unreduced(
    unknowns: Sequence[sp.Symbol],
    equations: Sequence[tuple[str, sp.Expr]],
    stages: Sequence[Stage],
    rank: int,
) -> Reduction:
    """The reduction in which nothing is eliminated."""
    values = {u: u for u in unknowns}
    return Reduction(
        0, rank, tuple(unknowns), tuple(equations), tuple(stages), values, (), {}, None, None
    )


def _through(
    draft: _Draft, leaving: _Exit, state: sp.Matrix, names: Sequence[sp.Symbol]
) -> sp.Matrix:
    """State (N x 1) at the end of a phase, once its exit condition is used as far as possible."""
    flow, dwell = leaving.flow, leaving.dwell
    draft.values[dwell] = dwell
    coefficients = dict(zip(flow.basis, flow.along(*leaving.gradient, state), strict=True))
    explicit = explicit_time(coefficients, dwell, draft.variables)
    if explicit is not None:
        after = _at_explicit_time(draft, leaving, explicit, coefficients, state)
        if not draft.unsolved:
            draft.settle()
        return after
    draft.unknowns.append(dwell)
    naming, functions = name_functions(flow, dwell)
    draft.stages.append(naming)
    after = flow.matrix(functions) * state + flow.offset(functions)
    used = bool(draft.unsolved)
    if used:
        after = _use_for_coordinate(draft, leaving, after)
    if draft.unsolved:
        return after
    draft.settle()
    step, values = assign(f"{leaving.phase.configuration} for {dwell}", names, after)
    draft.stages.append(step)
    after = sp.Matrix(values)
    if not used:
        velocity = flow.velocity(after)
        draft.rates |= {(s, dwell): v for s, v in zip(after, velocity, strict=True)}
        draft.equations.append((leaving.meaning, leaving.condition(after)))
    return after


def _at_once(
    draft: _Draft, leaving: _Exit, state: sp.Matrix, names: Sequence[sp.Symbol]
) -> sp.Matrix:
    """State of a phase of no duration, whose exit condition is one on the state at its start."""
    if draft.unsolved:
        return _use_for_coordinate(draft, leaving, state)
    step, values = assign(f"{leaving.phase.configuration} for no time", names, state)
    draft.stages.append(step)
    draft.equations.append((leaving.meaning, leaving.condition(sp.Matrix(values))))
    return sp.Matrix(values)


def _at_explicit_time(
    draft: _Draft,
    leaving: _Exit,
    explicit: ExplicitTime,
    coefficients: Mapping[sp.Expr, sp.Expr],
    state: sp.Matrix,
) -> sp.Matrix:
    """State at the end of a phase whose dwell time is explicit."""
    flow, dwell = leaving.flow, leaving.dwell
    # the dwell time depends on these coordinates: no later condition is linear in them
    entering = set().union(*(sp.expand(c).free_symbols for c in coefficients.values()))
    draft.unknowns += [q for q in draft.unsolved if q in entering]
    draft.unsolved = [q for q in draft.unsolved if q not in entering]
    draft.stages += explicit.stages
    draft.stages.append(Stage(f"{dwell}: {explicit.rule}", ((dwell, explicit.time),)))
    draft.eliminations.append(Elimination(dwell, explicit.rule))
    if explicit.rule == LINEAR:
        draft.linear_times[dwell] = explicit.time
    functions = [explicit.functions.get(f, f.subs(TIME, dwell)) for f in flow.basis]
    after = flow.matrix(functions) * state + flow.offset(functions)
    return after.applyfunc(lambda e: _canonical(explicit.shorten(e), draft.constants))


def _use_for_coordinate(draft: _Draft, leaving: _Exit, after: sp.Matrix) -> sp.Matrix:
    """The state at the end, once the exit condition is solved for a section coordinate.

    Without an unsolved coordinate in it the condition stays an equation.
    """
    condition = leaving.condition(after)
    chosen = next((q for q in draft.unsolved if sp.diff(condition, q) != 0), None)
    if chosen is None:
        draft.equations.append((leaving.meaning, condition))
        return after
    slope = sp.diff(condition, chosen)
    rest = sp.expand(condition - slope * chosen)
    rule = f"linear in {leaving.phase.boundary}"
    draft.eliminations.append(Elimination(chosen, rule))
    draft.unsolved.remove(chosen)
    if slope.free_symbols <= draft.constants:
        solution = _canonical(-rest / slope, draft.constants)
    else:
        step, solution = _named_solution(draft.unsolved, chosen, -rest, slope)
        draft.stages.append(step)
    draft.solved.append(Stage(f"{chosen}: {rule}", ((chosen, solution),)))
    if draft.unsolved:  # the solution contains them: later conditions must see them
        substituted = after.subs(chosen, solution)
        step, after = affine_in(draft.unsolved, substituted, leaving.dwell)
        draft.stages.append(step)
    return after


def _named_solution(
    others: Sequence[sp.Symbol], chosen: sp.Symbol, right: sp.Expr, slope: sp.Expr
) -> tuple[Stage, sp.Expr]:
    """Stage and solution of ``slope * chosen = right``, affine in other coordinates.

    Its parts have names, as the slope moves with the dwell times and would else stand below
    every term.
    """
    below = Symbol("divisor", chosen)
    named = ((below, sp.factor_terms(slope)),)
    if not others:
        return Stage(f"parts of {chosen}", named), right / below
    parts = [right.subs(dict.fromkeys(others, 0)), *(sp.diff(right, q) for q in others)]
    names = [Symbol("constant", chosen), *(Symbol("times", chosen, q) for q in others)]
    step, (constant, *rates) = assign(f"parts of {chosen}", names, [p / below for p in parts])
    solution = constant + sum((r * q for r, q in zip(rates, others, strict=True)), sp.Integer(0))
    return Stage(step.title, (*named, *step.assignments)), solution


def affine_in(
    coordinates: Sequence[sp.Symbol], state: sp.Matrix, dwell: sp.Symbol
) -> tuple[Stage, sp.Matrix]:
    """Stage and state, with names for the coefficients of section coordinates in the state."""
    zero = dict.fromkeys(coordinates, 0)
    parts = [(1, [e.subs(zero) for e in state])]
    parts += [(q, [sp.diff(e, q) for e in state]) for q in coordinates]
    names = [Symbol("part", i, q, dwell) for q, column in parts for i in range(len(column))]
    expressions = [sp.factor_terms(e) for _, column in parts for e in column]
    step, values = assign(f"state after {dwell}, affine in the section", names, expressions)
    total, size = sp.zeros(state.rows, 1), state.rows
    for k, (q, _) in enumerate(parts):
        total += q * sp.Matrix(values[k * size : (k + 1) * size])
    return step, total


def _canonical(expression: sp.Expr, constants: set[sp.Symbol]) -> sp.Expr:
    """Polynomial in the stages' symbols with factored coefficients, which cancels terms."""
    collected: dict[sp.Expr, sp.Expr] = {}
    for term in sp.Add.make_args(sp.expand(expression)):
        coefficient, monomial = term.as_independent(*(term.free_symbols - constants), as_Add=False)
        collected[monomial] = collected.get(monomial, 0) + coefficient
    return sp.Add(*(factor(cancel(c)) * monomial for monomial, c in collected.items()))

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
from nonsmooth.derive.declaration.itinerary import Itinerary
from nonsmooth.derive.equations.chain import affine_in, name_functions
from nonsmooth.derive.equations.explicit import LINEAR, ExplicitTime, explicit_time
from nonsmooth.derive.equations.program import (
    Equation,
    Program,
    Stage,
    Stages,
    affine_sum,
    assign_matrix,
    jacobian,
    merged,
    name_parts,
    prune,
)
from nonsmooth.derive.equations.section import Passage, passages_of, section_of, smallest_section
from nonsmooth.derive.flows.modal import TIME, Flow
from nonsmooth.derive.symbols import Symbol, Symbols, Values, derivative


@dataclass(frozen=True)
class Elimination:
    """An unknown that the reduction makes explicit, and the rule by which it does."""

    unknown: sp.Symbol
    rule: str


@dataclass(frozen=True)
class Reduction:
    """The reduced equations of an orbit, and the way back to all its unknowns."""

    rank: int  # least dimension of a section, which bounds the number of nonzero multipliers
    unknowns: tuple[sp.Symbol, ...]  # those on which Newton's method works
    equations: tuple[Equation, ...]  # as many, in terms of the stages
    stages: Stages
    # every unknown of the full equations, in terms of the stages
    values: Values
    eliminations: tuple[Elimination, ...] = ()
    rotation: int = 0  # the phase at which the reduction starts
    # vector field: derivative of a phase's last state by its dwell time, by (symbol, dwell time)
    rates: Mapping[tuple[sp.Symbol, sp.Symbol], sp.Expr] = field(default_factory=dict)
    # the section's only coordinate at the start and after one turn, None if there are several
    start: sp.Expr | None = None
    image: sp.Expr | None = None
    # (determinant, bound) of solved linear equations: far below it the orbit is undetermined
    determinants: tuple[tuple[sp.Expr, sp.Expr], ...] = ()
    # both values of the only unknown of a quadratic equation over parameters: an explicit orbit
    roots: tuple[sp.Expr, ...] = ()

    def jacobian(self) -> Program:
        """Stages and Jacobian of the reduced equations by their unknowns."""
        return self._derivatives([e for _, e in self.equations])

    def _derivatives(self, expressions: Sequence[sp.Expr]) -> Program:
        """Stages and derivatives of expressions by the reduced unknowns."""
        seeds = {u: {u: sp.Integer(1)} for u in self.unknowns}
        return jacobian(prune(self.stages, expressions), expressions, seeds, self.rates)

    def _derivatives_of(self, *symbols: sp.Symbol) -> list[Symbol]:
        """Names of the derivatives of symbols by the reduced unknowns."""
        return [derivative(s, u) for s in symbols for u in self.unknowns]

    def slope(self) -> Program:
        """Stages and slope of the map in one variable, by the implicit function theorem.

        The unknowns x follow the coordinate q(x) at the start along all equations but the last,
        which is the closure q(image) = q(start); in general q depends on the first unknown
        alone.
        """
        if self.start is None or self.image is None:
            raise ValueError("the reduction has no map in one variable")
        stages, rows = self.jacobian()
        more, moved = self._derivatives([self.image, self.start])
        by, rates = [*moved[0, :]], [*moved[1, :]]
        start_rate, numerator = rates[0], by[0]
        followers = len(self.unknowns) - 1
        rows = rows[:followers, :]
        moving = [Symbol("equation", i) for i in range(followers)]
        if any(rates[1:]):
            # the coordinate moves with several unknowns: the tangent t of the equations
            # with (dq/dx) t = 1 carries it
            rows = sp.Matrix.vstack(rows, moved[1, :])
            names = self._derivatives_of(*moving, Symbol("start"))
            step, rows = assign_matrix("derivatives of the equations and of the start", names, rows)
            tangent = rows.LUsolve(sp.Matrix([0] * followers + [1]))
            slope = sum((b * e for b, e in zip(by, tangent, strict=True)), sp.Integer(0))
            return Program((*merged(stages, more), step), slope)
        if followers:
            names = self._derivatives_of(*moving)
            step, rows = assign_matrix("derivatives of the equations", names, rows)
            stages = (*stages, step)
            response = -rows[:, 1:].LUsolve(rows[:, 0])
            numerator += sum(b * r for b, r in zip(by[1:], response, strict=True))
        return Program(merged(stages, more), numerator / start_rate)


@dataclass
class _Draft:
    """The reduction as far as it is made along the itinerary."""

    constants: set[sp.Symbol]
    unsolved: list[sp.Symbol]
    stages: list[Stage] = field(default_factory=list)
    equations: list[Equation] = field(default_factory=list)
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

    def name(self, title: str, names: Symbols, state: sp.Matrix) -> sp.Matrix:
        """The state with names for its entries, which a stage assigns."""
        step, named = assign_matrix(title, names, state)
        self.stages.append(step)
        return named


def reduce_itinerary(
    itinerary: Itinerary,
    flows: Mapping[str, Flow],
    constants: set[sp.Symbol],
    swapped: Symbols,
) -> Reduction:
    """The reduction of an itinerary; see the module's description.

    The `constants` are parameters and spectrum. With `swapped`, parameters to solve for, there is
    no map in one variable, as they stay unknown.
    """
    states, passages = itinerary.presented_system.states, passages_of(itinerary)
    rotation, section = smallest_section(itinerary)
    original = section_of(itinerary)
    # the states behind phase k carry the index k; so do the coordinates of this section
    coordinates = [Symbol("state", states[i], rotation) for i in section.places]
    draft = _Draft(constants, list(coordinates))
    state = section.state.subs(dict(zip(section.coordinates, coordinates, strict=True)))
    # beyond the last phase the count goes on: the return is not the start
    for number in range(rotation, rotation + len(passages)):
        passage = passages[number % len(passages)]
        if passage is passages[0]:
            start = [state[i] for i in original.places]
            draft.values |= dict(zip(original.coordinates, start, strict=True))
        names = [Symbol("state", s, number + 1) for s in states]
        follow = _at_once if passage.duration == 0 else _through
        after = follow(draft, passage, flows[passage.configuration.name], state, names)
        state = passage.behind(after)

    draft.settle()
    images = [
        _canonical(state[place].subs(draft.linear_times), constants) for place in section.places
    ]
    for coordinate, image in zip(coordinates, images, strict=True):
        draft.equations.append((f"{coordinate} returns", image - coordinate))
    draft.values |= {s: s for s in swapped}
    wanted = [e for _, e in draft.equations] + list(draft.values.values())
    one = section.dimension == 1 and not swapped
    return Reduction(
        section.dimension,
        (*draft.unsolved, *draft.unknowns, *swapped),
        tuple(draft.equations),
        prune(draft.stages, wanted),
        draft.values,
        tuple(draft.eliminations),
        rotation,
        draft.rates,
        coordinates[0] if one else None,
        images[0] if one else None,
    )


def _through(
    draft: _Draft, passage: Passage, flow: Flow, state: sp.Matrix, names: Symbols
) -> sp.Matrix:
    """State (N x 1) at the end of a phase, once its exit condition is used as far as possible."""
    dwell = passage.dwell
    draft.values[dwell] = dwell
    along = flow.along(passage.normal, passage.constant, state)
    coefficients = dict(zip(flow.basis, along, strict=True))
    explicit = explicit_time(coefficients, dwell, draft.variables)
    if explicit is not None:
        after = _at_explicit_time(draft, dwell, flow, explicit, coefficients, state)
        if not draft.unsolved:
            draft.settle()
        return after
    draft.unknowns.append(dwell)
    naming, functions = name_functions(flow, dwell, dwell)
    draft.stages.append(naming)
    after = flow.end(functions, state)
    used = bool(draft.unsolved)
    if used:
        after = _use_condition(draft, passage, after)
    if draft.unsolved:
        return after
    draft.settle()
    after = draft.name(f"{flow.configuration} for {dwell}", names, after)
    if not used:
        velocity = flow.velocity(after)
        draft.rates |= {(s, dwell): v for s, v in zip(after, velocity, strict=True)}
        after = _use_condition(draft, passage, after)
    return after


def _at_once(
    draft: _Draft, passage: Passage, flow: Flow, state: sp.Matrix, names: Symbols
) -> sp.Matrix:
    """State of a phase of no duration, whose exit condition is one on the state at its start."""
    if not draft.unsolved:
        state = draft.name(f"{flow.configuration} for no time", names, state)
    return _use_condition(draft, passage, state)


def _at_explicit_time(
    draft: _Draft,
    dwell: sp.Symbol,
    flow: Flow,
    explicit: ExplicitTime,
    coefficients: Mapping[sp.Expr, sp.Expr],
    state: sp.Matrix,
) -> sp.Matrix:
    """State at the end of a phase whose dwell time is explicit."""
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
    after = flow.end(functions, state)
    return after.applyfunc(lambda e: _canonical(explicit.shorten(e), draft.constants))


def _use_condition(draft: _Draft, passage: Passage, after: sp.Matrix) -> sp.Matrix:
    """The state at the end, once the exit condition is solved for a section coordinate.

    Without an unsolved coordinate in it the condition stays an equation.
    """
    condition = sp.expand(passage.value(after))
    chosen = next((q for q in draft.unsolved if sp.diff(condition, q) != 0), None)
    if chosen is None:
        draft.equations.append((passage.meaning, condition))
        return after
    slope = sp.diff(condition, chosen)
    rest = sp.expand(condition - slope * chosen)
    rule = f"linear in {passage.boundary}"
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
        step, after = affine_in(draft.unsolved, substituted, passage.dwell)
        draft.stages.append(step)
    return after


def _named_solution(
    others: Symbols, chosen: sp.Symbol, right: sp.Expr, slope: sp.Expr
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
    step, values = name_parts(chosen, [p / below for p in parts], others)
    return Stage(step.title, (*named, *step.assignments)), affine_sum(values, others)


def _canonical(expression: sp.Expr, constants: set[sp.Symbol]) -> sp.Expr:
    """Polynomial in the stages' symbols with factored coefficients, which cancels terms."""
    collected: dict[sp.Expr, sp.Expr] = {}
    for term in sp.Add.make_args(sp.expand(expression)):
        coefficient, monomial = term.as_independent(*(term.free_symbols - constants), as_Add=False)
        collected[monomial] = collected.get(monomial, 0) + coefficient
    return sp.Add(*(factor(cancel(c)) * monomial for monomial, c in collected.items()))

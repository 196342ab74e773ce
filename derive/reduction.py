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
from dataclasses import dataclass

import sympy as sp

from nonsmooth.derive.chain import dwell_symbol, name_functions, section_of
from nonsmooth.derive.itinerary import Itinerary
from nonsmooth.derive.modal import TIME, Flow, Spectrum
from nonsmooth.derive.program import Stage, assign, derivative_of, differentiate, merged, prune
from nonsmooth.derive.system import System

__all__ = ["Angle", "Elimination", "Reduction", "reduce_itinerary"]


class Angle(sp.Function):
    """Angle in [0, 2 pi) of a point (cosine, sine): written Angle(sine, cosine)."""

    nargs = 2

    def fdiff(self, argindex: int = 1) -> sp.Expr:
        """Derivative by the sine (1) or the cosine (2)."""
        sine, cosine = self.args
        square = sine**2 + cosine**2
        return cosine / square if argindex == 1 else -sine / square


@dataclass(frozen=True)
class Elimination:
    """One unknown that the reduction made explicit, and by which rule."""

    unknown: sp.Symbol
    rule: str


@dataclass(frozen=True)
class Reduction:
    """The reduced system of an itinerary and the way back to all its unknowns.

    Attributes
    ----------
    rotation : int
        The reduction starts at this phase.
    rank : int
        Dimension of the section there, the smallest: no more multipliers differ from zero.
    unknowns : tuple of symbols
        What Newton's method works on.
    equations : tuple of (meaning, expression)
        As many, each zero at an orbit, in terms of the stages.
    stages : tuple of Stage
    values : mapping of symbol to expression
        Every unknown of the full system, in terms of the stages.
    eliminations : tuple of Elimination
    rates : mapping of (symbol, dwell time) to expression
        Derivative of a phase's last state by its dwell time: the vector field.
    start : expression, or None
        The single section coordinate q at the start, where the section has dimension one.
    image : expression, or None
        The same coordinate after one turn.
    """

    rotation: int
    rank: int
    unknowns: tuple[sp.Symbol, ...]
    equations: tuple[tuple[str, sp.Expr], ...]
    stages: tuple[Stage, ...]
    values: Mapping[sp.Symbol, sp.Expr]
    eliminations: tuple[Elimination, ...]
    rates: Mapping[tuple[sp.Symbol, str], sp.Expr]
    start: sp.Expr | None
    image: sp.Expr | None

    def jacobian(self) -> tuple[tuple[Stage, ...], sp.Matrix]:
        """Stages and entries of the derivatives of the equations by the unknowns."""
        seeds = {str(u): {u: sp.Integer(1)} for u in self.unknowns}
        stages, moving = differentiate(
            self.needed([e for _, e in self.equations]), seeds, self.rates
        )
        entries = [
            [derivative_of(equation, moving[str(u)]) for u in self.unknowns]
            for _, equation in self.equations
        ]
        return stages, sp.Matrix(entries)

    def slope(self) -> tuple[tuple[Stage, ...], sp.Expr]:
        """Slope of the map in one variable, by the implicit function theorem.

        The unknowns x follow the coordinate q(x) at the start along all equations but the
        last, which is the closure q(image) = q(start); in general q depends on the first
        unknown alone.
        """
        if self.start is None or self.image is None:
            raise ValueError("the reduction has no map in one variable")
        stages, jacobian = self.jacobian()
        base = self.needed([self.start, self.image])
        seeds = {str(u): {u: sp.Integer(1)} for u in self.unknowns}
        more, moving = differentiate(base, seeds, self.rates)
        by = [derivative_of(self.image, moving[str(u)]) for u in self.unknowns]
        rates = [derivative_of(self.start, moving[str(u)]) for u in self.unknowns]
        start_rate, numerator = rates[0], by[0]
        followers = len(self.unknowns) - 1
        if any(rates[1:]):
            # the coordinate moves with several unknowns: the tangent t of the equations
            # with (dq/dx) t = 1 carries it
            rows = sp.Matrix.vstack(jacobian[:followers, :], sp.Matrix([rates]))
            names = [f"equation{i}_by_{u}" for i in range(followers) for u in self.unknowns]
            names += [f"start_by_{u}" for u in self.unknowns]
            step, values = assign("derivatives of the equations and of the start", names, rows)
            right = sp.Matrix([0] * followers + [1])
            tangent = sp.Matrix(*rows.shape, values).LUsolve(right)
            slope = sum((b * e for b, e in zip(by, tangent, strict=True)), sp.Integer(0))
            return (*merged(stages, more), step), slope
        if followers:
            names = [f"equation{i}_by_{u}" for i in range(followers) for u in self.unknowns]
            step, values = assign("derivatives of the equations", names, jacobian[:followers, :])
            stages = (*stages, step)
            rows = sp.Matrix(followers, followers + 1, values)
            response = -rows[:, 1:].LUsolve(rows[:, 0])
            numerator += sum(b * r for b, r in zip(by[1:], response, strict=True))
        return merged(stages, more), numerator / start_rate

    def needed(self, expressions: Sequence[sp.Expr]) -> tuple[Stage, ...]:
        """The stages that the expressions need."""
        return prune(self.stages, expressions)


def reduce_itinerary(
    itinerary: Itinerary, system: System, flows: Mapping[str, Flow], spectrum: Spectrum
) -> Reduction:
    """Derive the reduced system of an itinerary; see the module's description."""
    count = len(itinerary.phases)
    sections = [section_of(itinerary.rotated(k), system) for k in range(count)]
    rotation = min(range(count), key=lambda k: (sections[k].dimension, k))
    turned, section, original = itinerary.rotated(rotation), sections[rotation], sections[0]

    # the states behind phase k carry the index k; so do the coordinates of this section
    coordinates = [sp.Symbol(f"{system.states[i]}_{rotation}", real=True) for i in section.places]
    constants = {p.symbol for p in system.parameters} | set(spectrum.symbols)
    unsolved = list(coordinates)
    state = section.start.subs(dict(zip(section.coordinates, coordinates, strict=True)))
    stages: list[Stage] = []
    equations: list[tuple[str, sp.Expr]] = []
    unknowns: list[sp.Symbol] = []
    eliminations: list[Elimination] = []
    values: dict[sp.Symbol, sp.Expr] = {}
    explicit_times: dict[sp.Symbol, sp.Expr] = {}
    rates: dict[tuple[sp.Symbol, str], sp.Expr] = {}
    solved: list[Stage] = []

    for index, phase in enumerate(turned.phases):
        if (index + rotation) % count == 0:
            values |= dict(
                zip(original.coordinates, (state[i] for i in original.places), strict=True)
            )
        chosen: sp.Symbol | None = None
        flow, dwell = flows[phase.configuration], dwell_symbol(phase.dwell_time)
        boundary = system.configuration(phase.configuration).boundary(phase.boundary)
        coefficients = dict(
            zip(flow.basis, flow.along(*system.gradient(boundary.function), state), strict=True)
        )
        explicit = _linear_time(coefficients) or _first_return(coefficients, dwell, constants)
        naming, functions = name_functions(flow, dwell)
        if explicit is not None:
            # the dwell time depends on these: no later condition is linear in them
            entering = set().union(*(sp.expand(c).free_symbols for c in coefficients.values()))
            hidden = [q for q in unsolved if q in entering]
            unsolved = [q for q in unsolved if q not in hidden]
            unknowns += hidden
            functions = [explicit.functions.get(f, f.subs(TIME, dwell)) for f in flow.basis]
            stages += explicit.stages
            stages.append(Stage(f"{dwell}: {explicit.rule}", ((dwell, explicit.time),)))
            eliminations.append(Elimination(dwell, explicit.rule))
            if explicit.rule == LINEAR:
                explicit_times[dwell] = explicit.time
        else:
            unknowns.append(dwell)
            stages.append(naming)
        values[dwell] = dwell
        after = flow.matrix(functions) * state + flow.offset(functions)
        if explicit is not None:
            after = after.applyfunc(lambda e, rule=explicit: _canonical(rule.shorten(e), constants))
        elif unsolved:
            condition = _affine_value(system.gradient(boundary.function), after)
            chosen = next((q for q in unsolved if sp.diff(condition, q) != 0), None)
            if chosen is None:
                equations.append((f"{phase.boundary} ends {phase.configuration}", condition))
            else:
                slope = sp.diff(condition, chosen)
                solution = _canonical(-sp.expand(condition - slope * chosen) / slope, constants)
                rule = f"linear in {phase.boundary}"
                eliminations.append(Elimination(chosen, rule))
                solved.append(Stage(f"{chosen}: {rule}", ((chosen, solution),)))
                unsolved.remove(chosen)
                if unsolved:  # the solution contains them: later conditions must see them
                    step, after = _affine_in(unsolved, after.subs(chosen, solution), dwell)
                    stages.append(step)
        if not unsolved:
            # each solution contains coordinates that were solved for after it
            stages += reversed(solved)
            solved = []
        if explicit is None and not unsolved:
            # beyond the last phase the count goes on: the return is not the start
            names = [f"{s}_{index + rotation + 1}" for s in system.states]
            step, named = assign(f"{phase.configuration} for {dwell}", names, after)
            stages.append(step)
            after = sp.Matrix(named)
            if chosen is None:
                velocity = flow.velocity(after)
                rates |= {(s, str(dwell)): v for s, v in zip(after, velocity, strict=True)}
                condition = _affine_value(system.gradient(boundary.function), after)
                equations.append((f"{phase.boundary} ends {phase.configuration}", condition))
        transition = turned.transition_after(system, index)
        state = transition.reset_of(after, system.states)

    stages += reversed(solved)
    unknowns = unsolved + unknowns
    images = [_canonical(state[place].subs(explicit_times), constants) for place in section.places]
    for coordinate, image in zip(coordinates, images, strict=True):
        equations.append((f"{coordinate} returns", image - coordinate))
    one = section.dimension == 1
    return Reduction(
        rotation,
        section.dimension,
        tuple(unknowns),
        tuple(equations),
        prune(stages, [e for _, e in equations] + list(values.values())),
        values,
        tuple(eliminations),
        rates,
        coordinates[0] if one else None,
        images[0] if one else None,
    )


def _affine_value(gradient: tuple[sp.Matrix, sp.Expr], state: sp.Matrix) -> sp.Expr:
    row, constant = gradient
    return sp.expand((row * state)[0] + constant)


def _affine_in(
    coordinates: Sequence[sp.Symbol], state: sp.Matrix, dwell: sp.Symbol
) -> tuple[Stage, sp.Matrix]:
    """Name the coefficients of a state that is affine in some section coordinates."""
    zero = dict.fromkeys(coordinates, 0)
    parts = [(1, [e.subs(zero) for e in state])]
    parts += [(q, [sp.diff(e, q) for e in state]) for q in coordinates]
    names = [f"part{i}_of_{q}_{dwell}" for q, column in parts for i in range(len(column))]
    expressions = [sp.factor_terms(e) for _, column in parts for e in column]
    step, values = assign(f"state after {dwell}, affine in the section", names, expressions)
    total, size = sp.zeros(state.rows, 1), state.rows
    for k, (q, _) in enumerate(parts):
        total += q * sp.Matrix(values[k * size : (k + 1) * size])
    return step, total


LINEAR, RETURN = "linear in time", "first return"


@dataclass(frozen=True)
class _Explicit:
    """A dwell time in closed form: the rule, its stages, the functions it fixes, the time."""

    rule: str
    stages: tuple[Stage, ...]
    functions: Mapping[sp.Expr, sp.Expr]
    time: sp.Expr
    identities: tuple[Mapping[sp.Expr, sp.Expr], ...] = ()

    def shorten(self, expression: sp.Expr) -> sp.Expr:
        """Apply what the rule knows about its own symbols."""
        for identity in self.identities:
            expression = sp.expand(expression.subs(identity, simultaneous=True))
        return expression


def _linear_time(coefficients: Mapping[sp.Expr, sp.Expr]) -> _Explicit | None:
    """Dwell time of an exit condition ``c + s t = 0``."""
    present = {f: c for f, c in coefficients.items() if sp.expand(c) != 0}
    if TIME not in present or set(present) - {sp.Integer(1), TIME}:
        return None
    constant = sp.expand(present.get(sp.Integer(1), sp.Integer(0)))
    return _Explicit(LINEAR, (), {}, -constant / sp.factor(present[TIME]))


def _first_return(
    coefficients: Mapping[sp.Expr, sp.Expr], dwell: sp.Symbol, constants: set[sp.Symbol]
) -> _Explicit | None:
    """Dwell time of an exit condition ``a cos(w t) + b sin(w t) + c = 0``, rising.

    Rising through zero the derivative is w s with s = sqrt(a^2 + b^2 - c^2), which fixes
    cosine and sine; the angle in (0, 2 pi) is the first return.
    """
    present = {f: sp.expand(c) for f, c in coefficients.items()}
    present = {f: c for f, c in present.items() if c != 0}
    oscillating = [f for f in present if isinstance(f, sp.cos | sp.sin)]
    arguments = {f.args[0] for f in oscillating}
    if len(arguments) != 1 or set(present) - {sp.Integer(1), *oscillating}:
        return None
    (argument,) = arguments
    cosine, sine = sp.cos(argument), sp.sin(argument)
    title = f"first return of {dwell}"
    parts, (a, b, c) = assign(
        title,
        [f"{part}_{dwell}" for part in ("cosine_part", "sine_part", "constant_part")],
        [present.get(f, sp.Integer(0)) for f in (cosine, sine, sp.Integer(1))],
    )
    square = a**2 + b**2
    identities: tuple[Mapping[sp.Expr, sp.Expr], ...] = ()
    if c == 0:
        scale, (r,) = assign(title, [f"amplitude_{dwell}"], [sp.sqrt(square)])
        at = (b / r, -a / r)
        if a.is_Symbol and b.is_Symbol:
            parts_of = ((present[cosine], a), (present[sine], b))
            identities = _amplitude_identities(parts_of, r, constants)
    else:
        scale, (s,) = assign(title, [f"rate_{dwell}"], [sp.sqrt(square - c**2)])
        at = ((b * s - a * c) / square, -(b * c + a * s) / square)
    naming, values = assign(title, [f"cos_{dwell}_return", f"sin_{dwell}_return"], at)
    if identities:
        identities = ({**identities[0], **dict(zip(values, at, strict=True))}, identities[1])
    stages = tuple(s for s in (parts, scale, naming) if s.assignments)
    time = Angle(values[1], values[0]) / (argument / TIME)
    return _Explicit(RETURN, stages, {cosine: values[0], sine: values[1]}, time, identities)


def _amplitude_identities(
    parts: Sequence[tuple[sp.Expr, sp.Symbol]], r: sp.Expr, constants: set[sp.Symbol]
) -> tuple[dict[sp.Expr, sp.Expr], dict[sp.Expr, sp.Expr]]:
    """State symbols in terms of a and b, and a^2 = r^2 - b^2: the state shrinks to r."""
    states = sorted(set().union(*(e.free_symbols for e, _ in parts)) - constants, key=str)
    solution = _linear_solution([e - s for e, s in parts], states)
    solved = {x: v for x, v in zip(states, solution, strict=True) if x != v}
    (_, a), (_, b) = parts
    return solved, {a**2: r**2 - b**2}


def _linear_solution(
    equations: Sequence[sp.Expr], unknowns: Sequence[sp.Symbol]
) -> Sequence[sp.Expr]:
    """Solution of linear equations; the unknowns themselves where there is none."""
    if any(sp.diff(e, x, y) != 0 for e in equations for x in unknowns for y in unknowns):
        return unknowns
    return next(iter(sp.linsolve(equations, unknowns)), unknowns)


def _canonical(expression: sp.Expr, constants: set[sp.Symbol]) -> sp.Expr:
    """Polynomial in the stages' symbols with factored coefficients, so that what cancels goes."""
    collected: dict[sp.Expr, sp.Expr] = {}
    for term in sp.Add.make_args(sp.expand(expression)):
        coefficient, monomial = term.as_independent(*(term.free_symbols - constants), as_Add=False)
        collected[monomial] = collected.get(monomial, 0) + coefficient
    return sp.Add(*(sp.factor(sp.cancel(c)) * monomial for monomial, c in collected.items()))

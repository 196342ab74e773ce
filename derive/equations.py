"""The frozen record of an orbit's equations, handed to every emitter."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from html import escape

import sympy as sp

from nonsmooth.derive.chain import (
    Chain,
    Section,
    follow,
    poincare_jacobian,
    section_of,
    sensitivities,
    smallest_section,
    start_of,
)
from nonsmooth.derive.elimination import eliminate_coordinates, reference_values
from nonsmooth.derive.energy import energy_of, is_conservative
from nonsmooth.derive.errors import DerivationError
from nonsmooth.derive.itinerary import Itinerary
from nonsmooth.derive.modal import TIME, Flow, Spectrum, derive_flows
from nonsmooth.derive.program import Stage, derivative_of, differentiate, prune
from nonsmooth.derive.reduction import Reduction, reduce_itinerary, unreduced
from nonsmooth.derive.symmetry import half_phases, required_values, vanishing_coordinates
from nonsmooth.derive.system import System

__all__ = ["BoundaryFunction", "EquationSystem", "derive_equations"]


@dataclass(frozen=True)
class BoundaryFunction:
    """One boundary along one phase: a sum of functions of the time since its start.

    Attributes
    ----------
    phase : int
    boundary : str
    coefficients : tuple of expressions
        Constant, slope, cosine and sine amplitudes, for the frequencies of the phase.
    open_parameter : symbol or None
        A parameter that the equations leave open, entering as ``open_coefficient * it``.
    open_coefficient : number
    begins : bool
        Whether the phase begins on the boundary, so that the sum is zero there.
    """

    phase: int
    boundary: str
    coefficients: tuple[sp.Expr, ...]
    open_parameter: sp.Symbol | None
    open_coefficient: sp.Expr
    begins: bool


@dataclass(frozen=True)
class EquationSystem:
    """Switching and periodicity equations of an itinerary, and all that is derived from them.

    Attributes
    ----------
    itinerary : Itinerary
    system : System
        In the coordinates and parameters of the presentation.
    spectrum : Spectrum
    flows : mapping of configuration to Flow
    chain : Chain
        States from the section through all phases.
    unknowns : tuple of symbols
        Coordinates of the start, dwell times, then parameters that are solved for.
    stages : tuple of Stage
        What the equations are written in: the chain's, or those halfway through the phases.
    equations : tuple of (meaning, expression)
        As many as unknowns; each vanishes at the orbit.
    parameters : tuple of symbols
        Those that the equations contain.
    open_parameters : tuple of symbols
        Those that only admissibility depends on.
    reduction : Reduction
    required : mapping of symbol to number
        Values of parameters without which there is no such orbit; they are inserted.
    vanishing : tuple of symbols
        Coordinates of the start that the closure makes zero.
    conservative : bool
        Whether energy is a first integral along the itinerary.
    """

    itinerary: Itinerary
    system: System
    spectrum: Spectrum
    flows: Mapping[str, Flow]
    chain: Chain
    unknowns: tuple[sp.Symbol, ...]
    stages: tuple[Stage, ...]
    equations: tuple[tuple[str, sp.Expr], ...]
    parameters: tuple[sp.Symbol, ...]
    open_parameters: tuple[sp.Symbol, ...]
    reduction: Reduction
    required: Mapping[sp.Symbol, sp.Expr]
    vanishing: tuple[sp.Symbol, ...]
    conservative: bool

    @property
    def residual(self) -> list[sp.Expr]:
        """Left-hand sides of the equations."""
        return [expression for _, expression in self.equations]

    @cached_property
    def jacobian(self) -> tuple[tuple[Stage, ...], sp.Matrix]:
        """Stages and entries of the derivatives of the equations by the unknowns."""
        itinerary = self.itinerary
        if itinerary.reversor or itinerary.solved_for or itinerary.period is not None:
            seeds = {str(u): {u: sp.Integer(1)} for u in self.unknowns}
            stages, moving = differentiate(self.stages, seeds)
            return stages, sp.Matrix(
                [[derivative_of(e, moving[str(u)]) for u in self.unknowns] for e in self.residual]
            )
        stages, ends = sensitivities(self.chain, self.system.states, self.unknowns)
        start = self.chain.start
        rows = [link.normal * end for link, end in zip(self.chain.links, ends[:-1], strict=True)]
        for column, place in enumerate(start.places):
            closure = sp.Matrix(ends[-1][place, :])
            closure[column] -= 1
            rows.append(closure)
        return stages, sp.Matrix.vstack(*rows)

    @cached_property
    def parameter_jacobian(self) -> tuple[tuple[Stage, ...], sp.Matrix]:
        """Stages and entries of the total derivatives of the equations by the parameters."""
        stages, moving = differentiate(self.stages, self.parameter_seeds)
        return stages, sp.Matrix(
            [[derivative_of(e, moving[str(p)]) for p in self.parameters] for e in self.residual]
        )

    @property
    def parameter_seeds(self) -> dict[str, dict[sp.Symbol, sp.Expr]]:
        """What moves with each parameter: itself, and the spectrum by its own derivatives."""
        return {
            str(p): {p: sp.Integer(1)}
            | (
                {s: spectral_derivative(s, p) for s in self.spectrum.symbols}
                if p in self.spectrum.parameters
                else {}
            )
            for p in self.parameters
        }

    @cached_property
    def poincare_jacobian(self) -> tuple[tuple[Stage, ...], sp.Matrix]:
        """Stages and entries of the Poincare map's Jacobian on the section."""
        return poincare_jacobian(self.chain, self.system.states)

    @cached_property
    def trace(self) -> tuple[tuple[Stage, ...], sp.Expr]:
        """Stages (all that are needed) and expression of the trace.

        Zero where the orbit passes through a section that is a point, the slope of the map
        in one variable where it passes through a line and the unknowns give all it needs,
        otherwise the sum of the diagonal of the Poincare map's Jacobian.
        """
        if self.reduction.rank == 0:
            return (), sp.Integer(0)
        # a coordinate that stays unknown in the reduction has a name of its own there
        own = [u for u in self.reduction.unknowns if u not in self.unknowns]
        if self.reduction.start is not None and (not own or self.reduction.rotation == 0):
            coordinates = self.chain.section.coordinates[: len(own)]
            begin = Stage("start on the section", tuple(zip(own, coordinates, strict=True)))
            stages, slope = self.reduction.slope()
            return prune((begin, *self.reduction.stages, *stages), [slope]), slope
        stages, matrix = self.poincare_jacobian
        trace = sp.sympify(matrix.trace())
        return prune((*self.chain.stages, *stages), [trace]), trace

    @cached_property
    def trace_gradient(self) -> tuple[tuple[Stage, ...], list[sp.Expr]]:
        """Derivatives of the trace by the unknowns and, in total, by the parameters."""
        stages, trace = self.trace
        seeds = {str(u): {u: sp.Integer(1)} for u in self.unknowns} | self.parameter_seeds
        more, moving = differentiate(stages, seeds)
        return (*stages, *more), [derivative_of(trace, m) for m in moving.values()]

    @property
    def frequencies(self) -> tuple[tuple[sp.Expr, ...], ...]:
        """Frequencies of each phase, in order."""
        return tuple(_frequencies(link.flow) for link in self.chain.links)

    @cached_property
    def boundary_functions(self) -> tuple[BoundaryFunction, ...]:
        """Every boundary of every phase's configuration, along that phase."""
        found = []
        for index, link in enumerate(self.chain.links):
            configuration = self.system.configuration(link.flow.configuration)
            oscillations = [g(w * TIME) for g in (sp.cos, sp.sin) for w in self.frequencies[index]]
            basis = (sp.Integer(1), TIME, *oscillations)
            begin = section_of(self.itinerary.rotated(index), self.system)
            for boundary in configuration.boundaries:
                row, constant = self.system.gradient(boundary.function)
                opened = sorted(constant.free_symbols & set(self.open_parameters), key=str)
                if len(opened) > 1:
                    raise DerivationError(
                        f"boundary {boundary.name!r}: {opened[0]} and {opened[1]} are both open"
                    )
                parameter = opened[0] if opened else None
                slope = sp.diff(constant, parameter) if parameter else sp.Integer(0)
                closed = sp.expand(constant - slope * parameter) if parameter else constant
                values = dict(
                    zip(link.flow.basis, link.flow.along(row, closed, link.before), strict=True)
                )
                found.append(
                    BoundaryFunction(
                        index,
                        boundary.name,
                        tuple(values.get(f, sp.Integer(0)) for f in basis),
                        parameter,
                        slope,
                        _vanishes_on(begin, row, constant),
                    )
                )
        return tuple(found)

    @cached_property
    def measures(self) -> tuple[sp.Symbol, ...]:
        """Data of the size of the boundary functions, whose rounding these carry.

        The start's coordinates, and the parameters in the boundaries.
        """
        boundaries = (
            boundary.function
            for phase in self.itinerary.phases
            for boundary in self.system.configuration(phase.configuration).boundaries
        )
        contained = set().union(*(b.free_symbols for b in boundaries))
        known = (*self.parameters, *self.unknowns)
        coordinates = self.chain.start.coordinates
        return tuple(s for s in known if s in contained or s in coordinates)

    def _repr_latex_(self) -> str:
        rows = [f"& {latex} && \\text{{{note.replace('*', '')}}}" for latex, note in self._shown]
        body = " \\\\\n".join(rows)
        return f"$$\\begin{{aligned}}\n{body}\n\\end{{aligned}}$$"

    def _repr_html_(self) -> str | None:
        try:
            from latex2mathml.converter import convert
        except ImportError:
            return None  # a notebook then takes the LaTeX
        rows = ""
        for number, (latex, note) in enumerate(self._shown, start=1):
            parts = re.split(r"\$([^$]+)\$", note.replace("*", ""))
            text = "".join(convert(p) if i % 2 else escape(p) for i, p in enumerate(parts))
            rows += f"<tr><td>({number})</td><td>{convert(latex)}</td><td>{text}</td></tr>"
        name = escape(f"{self.itinerary.system.name}/{self.itinerary.name}")
        caption = f"{name}; (k) marks the state behind phase k"
        return f"<table><caption>{caption}</caption>{rows}</table>"

    @cached_property
    def _shown(self) -> list[tuple[str, str]]:
        """LaTeX and meaning of each equation, as the document has them."""
        from nonsmooth.derive.document.blocks import Formula
        from nonsmooth.derive.document.describe import describe_orbit

        blocks = describe_orbit(self).section("The equations")
        return [(b.lines[0].latex, b.note or "") for b in blocks if isinstance(b, Formula)]


def _vanishes_on(section: Section, row: sp.Matrix, constant: sp.Expr) -> bool:
    """Whether an affine function of the state is zero on all of a section."""
    values = [*(row * section.embedding), (row * section.constant)[0] + constant]
    return all(sp.cancel(sp.expand(value)) == 0 for value in values)


def _frequencies(flow: Flow) -> tuple[sp.Expr, ...]:
    found: list[sp.Expr] = []
    for function in flow.basis:
        if isinstance(function, sp.cos):
            found.append(function.args[0] / TIME)
        elif not isinstance(function, sp.sin) and function not in (sp.Integer(1), TIME):
            raise DerivationError(
                f"configuration {flow.configuration!r}: {function} is no trigonometric sum"
            )
    return tuple(found)


def spectral_derivative(entry: sp.Symbol, parameter: sp.Symbol) -> sp.Symbol:
    """Symbol of the derivative of a spectral entry by a parameter."""
    return sp.Symbol(f"{entry}_by_{parameter}", real=True)


def derive_equations(itinerary: Itinerary) -> EquationSystem:
    """Derive everything about one orbit; the pipeline of this package, stage by stage.

    * the **presented system**: the declaration in the itinerary's coordinates;
    * its **flows**: closed form inside each configuration, over one common spectrum;
    * the **section** that the end of the last phase enforces, and the **start** on it;
    * the **chain** of states: start, phases, transitions;
    * the **equations**: one exit condition a phase, and the closure of the start; for a
      reversible orbit, conditions halfway through the phases;
    * the **reduction**: whatever is linear or explicit, eliminated.

    Jacobians, Poincare map, trace and boundary functions are derived from these when an
    emitter asks for them.

    Raises
    ------
    DerivationError
        If a configuration has no closed form, the start satisfies no state, or the
        itinerary gives more or fewer equations than unknowns.
    """
    required = _required(itinerary)
    itinerary = itinerary.specialised(required)
    system = itinerary.presented_system
    spectrum, flows = derive_flows(system)
    section = section_of(itinerary, system)
    start = start_of(itinerary, system, section)
    vanishing = vanishing_coordinates(itinerary, system, start) if itinerary.reversor else ()
    start = start.without(vanishing)
    chain = follow(itinerary, system, flows, section, start)
    parameters = tuple(p.symbol for p in system.parameters)
    dwell_times = tuple(
        link.dwell
        for link in chain.links
        if link.duration == link.dwell and link.dwell not in parameters
    )
    swapped = tuple(s for s in parameters if str(s) in itinerary.solved_for)
    if itinerary.reversor:
        halves = half_phases(itinerary, system, flows, start)
        stages, equations = halves.stages, halves.equations
        reduction = eliminate_coordinates(
            stages,
            equations,
            start.coordinates,
            dwell_times,
            {*parameters, *spectrum.symbols},
            reference_values(itinerary.reference, spectrum, parameters),
            smallest_section(itinerary, system)[1].dimension,
        )
    else:
        stages, equations = chain.stages, _full_turn(itinerary, chain)
        if itinerary.period is None:
            reduction = reduce_itinerary(itinerary, system, flows, spectrum)
        else:
            known = reference_values(itinerary.reference, spectrum, parameters)
            equations = _without_one(itinerary, system, chain, equations, known)
            dimension = smallest_section(itinerary, system)[1].dimension
            reduction = unreduced(start.coordinates + dwell_times, equations, stages, dimension)
    unknowns = start.coordinates + dwell_times + swapped
    if len(equations) != len(unknowns):
        raise DerivationError(
            f"itinerary {itinerary.name!r}: {len(equations)} equations for {len(unknowns)} unknowns"
        )
    _check_solvable(itinerary, swapped, spectrum, flows)
    used = set().union(
        *(e.free_symbols for _, e in equations),
        *(e.free_symbols for stage in (*stages, *chain.stages) for _, e in stage.assignments),
        spectrum.parameters,
    )
    limiting = set().union(
        *(
            boundary.function.free_symbols
            for phase in itinerary.phases
            for boundary in system.configuration(phase.configuration).boundaries
        )
    )
    free = [s for s in parameters if s not in swapped]
    return EquationSystem(
        itinerary,
        system,
        spectrum,
        flows,
        chain,
        unknowns,
        stages,
        equations,
        tuple(s for s in free if s in used),
        tuple(s for s in free if s in limiting - used),
        reduction,
        required,
        vanishing,
        is_conservative(itinerary, system),
    )


def _required(itinerary: Itinerary) -> dict[sp.Symbol, sp.Expr]:
    """Values of parameters that a reversible orbit needs."""
    if not itinerary.reversor:
        return {}
    system = itinerary.presented_system
    start = start_of(itinerary, system, section_of(itinerary, system))
    return required_values(itinerary, system, start)


def _full_turn(itinerary: Itinerary, chain: Chain) -> tuple[tuple[str, sp.Expr], ...]:
    """One exit condition a phase, and the closure of the start's coordinates."""
    equations = [
        (f"{phase.boundary} ends {phase.configuration}", sp.expand(link.exit))
        for phase, link in zip(itinerary.phases, chain.links, strict=True)
    ]
    for coordinate, place in zip(chain.start.coordinates, chain.start.places, strict=True):
        equations.append((f"{coordinate} returns", chain.end[place] - coordinate))
    return tuple(equations)


def _without_one(
    itinerary: Itinerary,
    system: System,
    chain: Chain,
    equations: tuple[tuple[str, sp.Expr], ...],
    known: Mapping[sp.Symbol, sp.Expr],
) -> tuple[tuple[str, sp.Expr], ...]:
    """The equations without one closure, which the first integral E makes redundant.

    It is that of the coordinate q with the largest |dE/dq| at the known point: the others
    would leave q undetermined to first order.
    """
    first = system.configuration(itinerary.phases[0].configuration)
    energy = energy_of(first.dynamics, system.states)
    if energy is None or not is_conservative(itinerary, system):
        return equations
    at_start = energy.subs(dict(zip(system.states, chain.start.state, strict=True)))
    slopes = [abs(sp.diff(at_start, q).subs(known)) for q in chain.start.coordinates]
    if not all(slope.is_number for slope in slopes):
        raise DerivationError(
            f"itinerary {itinerary.name!r}: a conservative orbit of given period needs a"
            " reference with values of all its parameters and unknowns"
        )
    steepest = max(range(len(slopes)), key=lambda k: slopes[k])
    dropped = len(chain.links) + steepest
    return equations[:dropped] + equations[dropped + 1 :]


def _check_solvable(
    itinerary: Itinerary,
    swapped: tuple[sp.Symbol, ...],
    spectrum: Spectrum,
    flows: Mapping[str, Flow],
) -> None:
    """Refuse to solve for a parameter on which the flows depend."""
    moving = set(spectrum.parameters).union(
        *(m.free_symbols for f in flows.values() for m in (*f.matrices, *f.offsets, *f.field))
    )
    for symbol in swapped:
        if symbol in moving:
            raise DerivationError(
                f"itinerary {itinerary.name!r}: {symbol} changes the flows, so it cannot be"
                " solved for in place of a dwell time"
            )

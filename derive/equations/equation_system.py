"""The frozen record of an orbit's equations, handed to every emitter."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import sympy as sp

from nonsmooth.derive.declaration.itinerary import Itinerary
from nonsmooth.derive.declaration.system import System
from nonsmooth.derive.equations.chain import Chain
from nonsmooth.derive.equations.linearisation import poincare_jacobian, sensitivities
from nonsmooth.derive.equations.period_map import PeriodMap, derive_period_map
from nonsmooth.derive.equations.program import (
    Equation,
    Program,
    Stage,
    Stages,
    evaluate,
    gradient,
    jacobian,
    prune,
)
from nonsmooth.derive.equations.reduction import Reduction
from nonsmooth.derive.equations.section import is_zero, row_of, section_of
from nonsmooth.derive.errors import DerivationError
from nonsmooth.derive.flows.modal import TIME, Flow, Spectrum
from nonsmooth.derive.registry import registered
from nonsmooth.derive.symbols import Values, derivative


@dataclass(frozen=True)
class BoundaryFunction:
    """One boundary along one phase: an affine function of the state that the flow carries on.

    It is ``normal y + constant``, to which ``open_coefficient * open_parameter`` is added.
    If the flow is no trigonometric sum, there are no coefficients: the state at the start
    of the phase and its vector field, which the link has, determine the values in time.
    """

    phase: int
    boundary: str
    normal: sp.Matrix  # 1 x N
    constant: sp.Expr
    # constant, slope, cosine and sine amplitudes in time, at the phase's frequencies
    coefficients: tuple[sp.Expr, ...]
    open_parameter: sp.Symbol | None  # a parameter that the equations leave open
    open_coefficient: sp.Expr
    begins: bool  # whether the phase begins on the boundary, so that the sum is zero there


@dataclass(frozen=True, repr=False)
class EquationSystem:
    """Switching and periodicity equations of an itinerary, and all that is derived from them.

    The expressions of `residual`, `jacobian`, `map` and `trace` are those of SymPy. They hold
    symbols that stages assign, such as ``z1_2`` for a coordinate of the state behind the second
    phase: `stages_of` lists the stages, `expand` inserts them, `latex` writes an expression with
    the names of the orbit's document.

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
    reciprocal_pair : bool
        Whether the multipliers are 1, mu and 1/mu: energy and volume are kept, and the Poincare
        map has three.
    known : mapping of symbol to number
        Parameters, spectrum and unknowns at the itinerary's reference, as far as it has them.

    Examples
    --------
    >>> from nonsmooth.derive import derive_equations
    >>> from nonsmooth.derive.systems import declaration
    >>> equations = derive_equations(declaration("rigid-stop").orbits[0])
    >>> equations
    EquationSystem rigid-stop/one-impact: 2 equations in y, u
    >>> equations.jacobian.shape
    (2, 2)
    """

    itinerary: Itinerary
    system: System
    spectrum: Spectrum
    flows: Mapping[str, Flow]
    chain: Chain
    unknowns: tuple[sp.Symbol, ...]
    stages: Stages
    equations: tuple[Equation, ...]
    parameters: tuple[sp.Symbol, ...]
    open_parameters: tuple[sp.Symbol, ...]
    reduction: Reduction
    required: Values
    vanishing: tuple[sp.Symbol, ...]
    conservative: bool
    reciprocal_pair: bool
    known: Values

    @property
    def residual(self) -> list[sp.Expr]:
        """Left-hand sides of the equations."""
        return [expression for _, expression in self.equations]

    @property
    def jacobian(self) -> sp.Matrix:
        """Derivatives of the equations by the unknowns, (n, n)."""
        return self.jacobian_program.expressions

    @property
    def map(self) -> sp.Matrix:
        """Jacobian of the Poincare map in the coordinates of the section."""
        return self.map_program.expressions

    @property
    def trace(self) -> sp.Expr:
        """Trace of the Poincare map's Jacobian.

        Where the map has rank one it is written by the reduced unknowns, and is its multiplier.
        """
        return self.trace_program.expressions

    def stages_of(self, quantity: str) -> Stages:
        """List the stages of a quantity, in the order in which they can be computed.

        Parameters
        ----------
        quantity : {"residual", "jacobian", "map", "trace"}

        Returns
        -------
        tuple of Stage
            Each with a title and assignments, frequencies and projectors first.

        Raises
        ------
        DerivationError
            If the quantity is none of these.
        """
        stages: dict[str, Callable[[], Stages]] = {
            "residual": lambda: self.stages,
            "jacobian": lambda: (*self.stages, *self.jacobian_program.stages),
            "map": lambda: (*self.chain.stages, *self.map_program.stages),
            "trace": lambda: self.trace_program.stages,
        }
        if quantity not in stages:
            raise DerivationError(f"unknown quantity {quantity!r} (known: {', '.join(stages)})")
        return (Stage("spectrum", tuple(self.spectrum.entries)), *stages[quantity]())

    def expand(self, quantity: str, *titles: str) -> Any:
        """Insert stages into a quantity.

        Parameters
        ----------
        quantity : {"residual", "jacobian", "map", "trace"}
        titles : str
            Of the stages that are inserted, all of them if there are none.

        Returns
        -------
        sympy.Matrix or sympy.Expr
            In parameters and unknowns if all stages are inserted. The trace of a map of rank one
            is written with what the equations say, and is the trace where they hold.

        Raises
        ------
        DerivationError
            If there is no such quantity, or no stage of a title.
        """
        stages = self.stages_of(quantity)
        known = [stage.title for stage in stages]
        for title in titles:
            if title not in known:
                raise DerivationError(f"there is no stage {title!r} (known: {', '.join(known)})")
        inserted = [stage for stage in stages if not titles or stage.title in titles]
        short = getattr(self, quantity)
        if quantity == "trace":
            return evaluate(inserted, [short], {})[0]
        short = sp.Matrix(short)
        return sp.Matrix(*short.shape, evaluate(inserted, short, {}))

    def latex(self, expression: Any) -> str:
        """Write an expression with the names that the orbit's document uses.

        Parameters
        ----------
        expression : sympy.Expr or sympy.Matrix

        Returns
        -------
        str
            LaTeX, without dollar signs.
        """
        text: str = registered("expression_latex")(self, expression)
        return text

    @cached_property
    def jacobian_program(self) -> Program:
        """Stages and entries of the derivatives of the equations by the unknowns."""
        itinerary, chain = self.itinerary, self.chain
        if itinerary.reversor or itinerary.solved_for or itinerary.period is not None:
            seeds = {u: {u: sp.Integer(1)} for u in self.unknowns}
            return jacobian(self.stages, self.residual, seeds)
        stages, ends = sensitivities(chain, self.unknowns)
        rows = [link.normal * end for link, end in zip(chain.links, ends[:-1], strict=True)]
        for coordinate, place in chain.closing:
            closure = sp.Matrix(ends[-1][place, :])
            closure[self.unknowns.index(coordinate)] -= 1
            rows.append(closure)
        # those of the forcing are written in the unknowns themselves
        own = sp.Matrix(self.residual[len(rows) :])
        rows += [own.jacobian(self.unknowns)] if own else []
        return Program(stages, sp.Matrix.vstack(*rows))

    @cached_property
    def parameter_jacobian_program(self) -> Program:
        """Stages and entries of the total derivatives of the equations by the parameters."""
        return jacobian(self.stages, self.residual, self.parameter_seeds)

    @property
    def parameter_seeds(self) -> dict[sp.Symbol, dict[sp.Symbol, sp.Expr]]:
        """What moves with each parameter: itself, and the spectrum by its own derivatives."""
        return {
            p: {p: sp.Integer(1)}
            | (
                {s: derivative(s, p) for s in self.spectrum.symbols}
                if p in self.spectrum.parameters
                else {}
            )
            for p in self.parameters
        }

    @cached_property
    def map_program(self) -> Program:
        """Stages and entries of the Poincare map's Jacobian on the section."""
        return poincare_jacobian(self.chain)

    @cached_property
    def trace_program(self) -> Program:
        """Stages (all that are needed) and expression of the trace.

        Zero where the orbit passes through a section that is a point, the slope of the map
        in one variable where it passes through a line and the unknowns give all it needs,
        otherwise the sum of the diagonal of the Poincare map's Jacobian.
        """
        if self.reduction.rank == 0:
            return Program((), sp.Integer(0))
        # a coordinate that stays unknown in the reduction has a name of its own there
        own = [u for u in self.reduction.unknowns if u not in self.unknowns]
        if self.reduction.start is not None and (not own or self.reduction.rotation == 0):
            coordinates = self.chain.section.coordinates[: len(own)]
            begin = Stage("start on the section", tuple(zip(own, coordinates, strict=True)))
            stages, slope = self.reduction.slope()
            return Program(prune((begin, *self.reduction.stages, *stages), [slope]), slope)
        stages, matrix = self.map_program
        trace = sp.sympify(matrix.trace())
        return Program(prune((*self.chain.stages, *stages), [trace]), trace)

    @cached_property
    def trace_gradient_program(self) -> Program:
        """Derivatives of the trace by the unknowns and, in total, by the parameters."""
        stages, trace = self.trace_program
        inputs = (*self.unknowns, *self.parameters, *self.spectrum.symbols)
        back, slopes = gradient(stages, trace, inputs)
        partial = dict(zip(inputs, slopes, strict=True))
        totals = [
            sp.Add(*(partial[symbol] * rate for symbol, rate in moving.items()))
            for moving in self.parameter_seeds.values()
        ]
        return Program((*stages, *back), [*(partial[u] for u in self.unknowns), *totals])

    @cached_property
    def period_map(self) -> PeriodMap:
        """The affine map of a whole turn, given the dwell times, and the start that follows.

        This is the route of the Appendix of Pascal (2011): equations in the dwell times alone. It
        exists where the equations are those of a free turn from the section, and the section knows
        the entries of the start that are not sought by switching conditions, which no later phase
        changes.

        Raises
        ------
        DerivationError
            If the orbit is given by half phases, by its period or by a forcing, if its section
            leaves nothing to be sought, or knows an entry otherwise.
        """
        return derive_period_map(
            self.itinerary, self.chain, self.unknowns, self.equations, self.known
        )

    @cached_property
    def trigonometric(self) -> bool:
        """Whether all flows along the orbit are sums of a line, sines and cosines."""
        return all(link.flow.frequencies is not None for link in self.chain.links)

    @cached_property
    def frequencies(self) -> tuple[tuple[sp.Expr, ...], ...]:
        """Frequencies of each phase, in order; none where it is no trigonometric sum."""
        return tuple(link.flow.frequencies or () for link in self.chain.links)

    @cached_property
    def boundary_functions(self) -> tuple[BoundaryFunction, ...]:
        """Every boundary of every phase's configuration, along that phase.

        Raises
        ------
        DerivationError
            If a boundary contains two open parameters.
        """
        found, one = [], sp.Integer(1)
        for index, link in enumerate(self.chain.links):
            oscillations = [g(w * TIME) for g in (sp.cos, sp.sin) for w in self.frequencies[index]]
            basis = (one, TIME, *oscillations) if link.flow.frequencies is not None else ()
            inclusion = section_of(self.itinerary, index).inclusion
            for boundary in link.configuration.boundaries:
                row = row_of(boundary.function, self.system)
                constant = row[-1]
                opened = sorted(constant.free_symbols & set(self.open_parameters), key=str)
                if len(opened) > 1:
                    raise DerivationError(
                        f"boundary {boundary.name!r}: {opened[0]} and {opened[1]} are both open"
                    )
                parameter = opened[0] if opened else None
                slope = sp.diff(constant, parameter) if parameter else sp.Integer(0)
                closed = sp.expand(constant - slope * parameter) if parameter else constant
                along = link.flow.along(row[:, :-1], closed, link.before) if basis else ()
                values = dict(zip(link.flow.basis, along, strict=bool(basis)))
                found.append(
                    BoundaryFunction(
                        index,
                        boundary.name,
                        row[:, :-1],
                        closed,
                        tuple(values.get(f, sp.Integer(0)) for f in basis),
                        parameter,
                        slope,
                        is_zero(row * inclusion),
                    )
                )
        return tuple(found)

    @cached_property
    def measures(self) -> tuple[sp.Symbol, ...]:
        """Data of the size of the boundary functions, whose rounding these carry.

        The start's coordinates, and the parameters in the boundaries.
        """
        boundaries = (
            b.function for link in self.chain.links for b in link.configuration.boundaries
        )
        contained = set().union(*(b.free_symbols for b in boundaries))
        known = (*self.parameters, *self.unknowns)
        coordinates = self.chain.start.coordinates
        return tuple(s for s in known if s in contained or s in coordinates)

    @cached_property
    def _shown(self) -> list[tuple[str, str]]:
        """LaTeX and meaning of each equation, as the document has them."""
        lines: list[tuple[str, str]] = registered("equation_lines")(self)
        return lines

    def __repr__(self) -> str:
        unknowns = ", ".join(map(str, self.unknowns))
        count = f"{len(self.equations)} equation{'s' * (len(self.equations) != 1)}"
        return f"EquationSystem {self._name}: {count} in {unknowns}"

    @property
    def _name(self) -> str:
        return f"{self.itinerary.system.name}/{self.itinerary.name}"

    def _repr_latex_(self) -> str:
        latex: str = registered("equation_latex")(self._shown)
        return latex

    def _repr_html_(self) -> str | None:
        html: str | None = registered("equation_html")(self._shown, self._name)
        return html

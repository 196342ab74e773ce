"""The kernels of a system and of its orbits: what is computed, over which arrays."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import sympy as sp

from nonsmooth.derive.declaration.system import System
from nonsmooth.derive.equations.equation_system import EquationSystem
from nonsmooth.derive.equations.linearisation import monodromy, saltation_matrices
from nonsmooth.derive.equations.program import (
    Argument,
    Kernel,
    Output,
    Stage,
    differentiate,
    merged,
    prune,
)
from nonsmooth.derive.errors import DerivationError
from nonsmooth.derive.flows.modal import TIME, Flow, Spectrum, derive_flows
from nonsmooth.derive.symbols import Symbol, derivative


def spectrum_kernel(spectrum: Spectrum) -> Kernel:
    """Kernel of a system's spectrum and its derivatives by the parameters it depends on."""
    parameters = spectrum.parameters
    stage = Stage("spectrum", spectrum.entries)
    seeds = {p: {p: sp.Integer(1)} for p in parameters}
    stages, moving = differentiate([stage], seeds)
    derivatives = tuple(
        sp.sympify(moving[p].get(s, 0)) for s in spectrum.symbols for p in parameters
    )
    return Kernel(
        "spectrum",
        "Frequencies and projector coefficients, with their derivatives by the parameters.",
        (Argument.vector("parameters", parameters),),
        (
            Output.of("spectrum", spectrum.symbols),
            Output("spectrum_derivatives", (len(spectrum.symbols), len(parameters)), derivatives),
        ),
        (stage, *stages),
    )


def flow_kernels(
    system: System,
    spectrum: Spectrum,
    flows: Mapping[str, Flow],
    parameters: tuple[sp.Symbol, ...] | None = None,
) -> tuple[Kernel, ...]:
    """Kernels of the flow of each configuration, in the system's coordinates.

    They take all parameters of the system, or those given.
    """
    arguments = (
        Argument.vector("parameters", parameters or tuple(p.symbol for p in system.parameters)),
        Argument.vector("spectrum", spectrum.symbols),
        Argument("time", (), (TIME,)),
        Argument.vector("state", system.states),
    )
    kernels = []
    for flow in flows.values():
        end = flow.matrix() * sp.Matrix(system.states) + flow.offset()
        title = f"State after a time in {flow.configuration}."
        outputs = (Output.of("state_after", [*end]),)
        kernels.append(Kernel(f"flow_{flow.configuration}", title, arguments, outputs, ()))
    return tuple(kernels)


def orbit_kernels(orbit: EquationSystem) -> tuple[Kernel, ...]:
    """All kernels of one orbit; each gives first what the later outputs rest on.

    Of the flows there are those that differ from the system's.
    """
    point, derivatives = _point(orbit), _spectrum_derivatives(orbit)
    _, shared = derive_flows(orbit.itinerary.system)
    flows = {
        link.flow.configuration: link.flow
        for link in orbit.chain.links
        if link.flow != shared[link.flow.configuration]
    }
    return (
        _equations_kernel(orbit, (*point, replace(derivatives, since=2))),
        _trace_kernel(orbit, (*point, replace(derivatives, since=1))),
        _passage_kernel(orbit, point),
        _linearisation_kernel(orbit, point),
        *flow_kernels(orbit.system, orbit.spectrum, flows, orbit.parameters),
        reduced_kernel(orbit),
    )


def _point(orbit: EquationSystem) -> tuple[Argument, Argument, Argument]:
    """What the equations are evaluated at."""
    return (
        Argument.vector("parameters", orbit.parameters),
        Argument.vector("spectrum", orbit.spectrum.symbols),
        Argument.vector("unknowns", orbit.unknowns),
    )


def _spectrum_derivatives(orbit: EquationSystem) -> Argument:
    symbols, parameters = orbit.spectrum.symbols, orbit.spectrum.parameters
    return Argument(
        "spectrum_derivatives",
        (len(symbols), len(parameters)),
        tuple(derivative(s, p) for s in symbols for p in parameters),
    )


def _equations_kernel(orbit: EquationSystem, arguments: Sequence[Argument]) -> Kernel:
    jacobian_stages, jacobian = orbit.jacobian_program
    moved_stages, parameter_jacobian = orbit.parameter_jacobian_program
    return _kernel(
        "equations",
        "Switching and periodicity equations; their derivatives by the unknowns; those by the"
        " parameters, in total, through the spectrum too.",
        arguments,
        (
            Output.of("residual", orbit.residual),
            Output.of("jacobian", jacobian),
            Output.of("parameter_jacobian", parameter_jacobian),
        ),
        merged(merged(orbit.stages, jacobian_stages), moved_stages),
    )


def _trace_kernel(orbit: EquationSystem, arguments: Sequence[Argument]) -> Kernel:
    _, trace = orbit.trace_program
    stages, gradient = orbit.trace_gradient_program
    return _kernel(
        "trace",
        "Trace of the Poincare map's Jacobian; its derivatives by the unknowns, then in total by"
        " the parameters.",
        arguments,
        (Output.of("trace", trace), Output.of("trace_gradient", gradient)),
        stages,
    )


def _passage_kernel(orbit: EquationSystem, arguments: Sequence[Argument]) -> Kernel:
    links, functions = orbit.chain.links, orbit.boundary_functions
    states = [links[0].before, *(link.following for link in links)]
    along: tuple[Output, ...]
    if orbit.trigonometric:
        along = (
            Output.of("coefficients", [c for b in functions for c in b.coefficients]),
            Output.of("frequencies", [w for phase in orbit.frequencies for w in phase]),
        )
    else:
        along = (
            Output.of(
                "fields", sp.Matrix.vstack(*(sp.Matrix.hstack(*k.flow.field) for k in links))
            ),
            Output.of("ends", sp.Matrix([list(k.after) for k in links])),
            Output.of("boundaries", sp.Matrix([[*b.normal, b.constant] for b in functions])),
        )
    return _kernel(
        "passage",
        "State at the start and behind each transition. "
        + (
            "Boundaries along the phases: constant, slope, cosine and sine amplitudes, one after"
            " the other; and the frequencies of each phase."
            if orbit.trigonometric
            else "Vector fields [A, b] of the phases, their states at the end, and the boundaries"
            " along them [n, c]."
        ),
        arguments,
        (Output.of("states", sp.Matrix([list(s) for s in states])), *along),
        orbit.chain.stages,
    )


def _linearisation_kernel(orbit: EquationSystem, arguments: Sequence[Argument]) -> Kernel:
    chain = orbit.chain
    poincare_stages, poincare = orbit.map_program
    saltation_stages, saltations = saltation_matrices(chain)
    monodromy_stages, full = monodromy(chain)
    return _kernel(
        "linearisation",
        "Jacobian of the Poincare map in the section's coordinates; saltation matrices, one"
        " below the other; monodromy matrix.",
        arguments,
        (
            Output.of("poincare_jacobian", poincare),
            Output.of("saltations", sp.Matrix.vstack(*saltations)),
            Output.of("monodromy", full),
        ),
        merged(merged(merged(chain.stages, poincare_stages), saltation_stages), monodromy_stages),
    )


def period_map_kernel(orbit: EquationSystem) -> Kernel | None:
    """Kernel of the map of a whole turn, and of the equations and the start that follow from it.

    None for an orbit without them.
    """
    try:
        turn = orbit.period_map
    except DerivationError:
        return None
    # the start is a result, and among the unknowns an argument: it takes other names
    states = orbit.system.states
    starts = {turn.start[i]: Symbol("state", states[i], 0) for i in turn.sought}
    stages = [
        Stage(s.title, tuple((starts.get(x, x), e.xreplace(starts)) for x, e in s.assignments))
        for s in merged((*turn.map_stages, *turn.start_stages), orbit.chain.stages)
    ]
    conditions = [e.xreplace(starts) for _, e in (*turn.compatibility, *turn.switching)]
    return _kernel(
        "period_map",
        "Map [N, c] of a turn; the start that follows from the dwell times; compatibility and"
        " switching conditions. The start among the unknowns is not read.",
        _point(orbit),
        (
            Output.of("period_map", sp.Matrix.hstack(turn.matrix, turn.offset)),
            Output.of("linear_start", list(starts.values())),
            Output.of("compatibility", conditions),
        ),
        stages,
    )


def reduced_kernel(orbit: EquationSystem) -> Kernel:
    """Kernel of all unknowns from the reduced ones, and of the equations that are left."""
    reduction = orbit.reduction
    stages, jacobian = reduction.jacobian()
    outputs = [Output.of("unknowns", [reduction.values[u] for u in orbit.unknowns])]
    title = "All unknowns from the reduced ones" if reduction.unknowns else "All unknowns"
    if reduction.determinants:
        values = [value / bound for value, bound in reduction.determinants]
        outputs.append(Output.of("determinants", values))
        title += "; how singular the linear equations for them are: 0 if they are"
    parameters, spectrum, _ = _point(orbit)
    point = [parameters, spectrum]
    if reduction.unknowns:
        point.append(Argument.vector("reduced", reduction.unknowns))
        outputs += [
            Output.of("reduced_residual", [e for _, e in reduction.equations]),
            Output.of("reduced_jacobian", jacobian),
        ]
        title += "; the equations for these and their derivatives"
    return _kernel("reduced", f"{title}.", point, outputs, (*reduction.stages, *stages))


def _kernel(
    name: str,
    title: str,
    arguments: Sequence[Argument],
    outputs: Sequence[Output],
    stages: Sequence[Stage],
) -> Kernel:
    """A kernel with those stages that its outputs need."""
    wanted = [e for output in outputs for e in output.expressions]
    return Kernel(name, title, tuple(arguments), tuple(outputs), prune(stages, wanted))

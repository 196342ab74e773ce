"""The kernels of a system and of its orbits: what is computed, over which arrays."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import sympy as sp

from nonsmooth.derive.declaration.system import System
from nonsmooth.derive.equations.equation_system import EquationSystem, spectral_derivative
from nonsmooth.derive.equations.program import (
    Argument,
    Kernel,
    Output,
    Stage,
    differentiate,
    merged,
    prune,
)
from nonsmooth.derive.equations.reduction import Reduction
from nonsmooth.derive.equations.saltation import monodromy, saltation_matrices
from nonsmooth.derive.errors import DerivationError
from nonsmooth.derive.flows.modal import TIME, Flow, Spectrum

__all__ = [
    "direction_kernels",
    "flow_kernels",
    "orbit_kernels",
    "period_map_kernel",
    "reduced_equations",
    "spectrum_kernel",
    "start_kernel",
]


def spectrum_kernel(spectrum: Spectrum) -> Kernel:
    """Kernel of a system's spectrum and its derivatives by the parameters it depends on."""
    parameters = spectrum.parameters
    stage = Stage("spectrum", spectrum.entries)
    seeds = {str(p): {p: sp.Integer(1)} for p in parameters}
    stages, moving = differentiate([stage], seeds)
    derivatives = tuple(
        sp.sympify(moving[str(p)].get(s, 0)) for s in spectrum.symbols for p in parameters
    )
    return Kernel(
        "spectrum",
        "Frequencies and projector coefficients, with their derivatives by the parameters.",
        (_vector("parameters", parameters),),
        (
            Output("spectrum", (len(spectrum.symbols),), spectrum.symbols),
            Output("derivatives", (len(spectrum.symbols), len(parameters)), derivatives),
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
        _vector("parameters", parameters or tuple(p.symbol for p in system.parameters)),
        _vector("spectrum", spectrum.symbols),
        Argument("time", (), (TIME,)),
        _vector("state", system.states),
    )
    kernels = []
    for flow in flows.values():
        end = flow.matrix() * sp.Matrix(system.states) + flow.offset()
        title = f"State after a time in {flow.configuration}."
        outputs = (Output("state_after", (len(system.states),), tuple(end)),)
        kernels.append(Kernel(f"flow_{flow.configuration}", title, arguments, outputs, ()))
    return tuple(kernels)


def orbit_kernels(orbit: EquationSystem) -> tuple[Kernel, ...]:
    """All kernels of one orbit."""
    point = _point(orbit)
    parameters, spectrum, unknowns = point
    derivatives = Argument(
        "spectrum_derivatives",
        (len(orbit.spectrum.symbols), len(orbit.spectrum.parameters)),
        tuple(
            spectral_derivative(s, p)
            for s in orbit.spectrum.symbols
            for p in orbit.spectrum.parameters
        ),
    )
    moved = (parameters, spectrum, derivatives, unknowns)
    stages, chain = orbit.stages, orbit.chain.stages

    jacobian_stages, jacobian = orbit.jacobian_program
    moved_stages, parameter_jacobian = orbit.parameter_jacobian_program
    poincare_stages, poincare = orbit.map_program
    trace_stages, trace = orbit.trace_program
    gradient_stages, gradient = orbit.trace_gradient_program
    names = orbit.system.states
    saltation_stages, saltations = saltation_matrices(orbit.chain, names)
    monodromy_stages, full = monodromy(orbit.chain, names)
    residual = _flat("residual", orbit.residual)
    links, functions = orbit.chain.links, orbit.boundary_functions
    coefficients = [c for b in functions for c in b.coefficients]
    states = [links[0].before, *(link.following for link in links)]

    def kernel(
        name: str,
        title: str,
        arguments: Sequence[Argument],
        outputs: Sequence[Output],
        stages: Sequence[Stage],
    ) -> Kernel:
        wanted = [e for output in outputs for e in output.expressions]
        return Kernel(name, title, tuple(arguments), tuple(outputs), prune(stages, wanted))

    kernels = [
        kernel("residual", "Switching and periodicity equations.", point, [residual], stages),
        kernel(
            "jacobian",
            "Derivatives of the equations by the unknowns.",
            point,
            [_table("jacobian", jacobian)],
            (*stages, *jacobian_stages),
        ),
        kernel(
            "residual_and_jacobian",
            "Equations and their derivatives by the unknowns, sharing all intermediate terms.",
            point,
            [residual, _table("jacobian", jacobian)],
            (*stages, *jacobian_stages),
        ),
        kernel(
            "parameter_jacobian",
            "Total derivatives of the equations by the parameters, through the spectrum too.",
            moved,
            [_table("parameter_jacobian", parameter_jacobian)],
            (*stages, *moved_stages),
        ),
        kernel(
            "poincare_jacobian",
            "Jacobian of the Poincare map in the section's coordinates.",
            point,
            [_table("poincare_jacobian", poincare)],
            (*chain, *poincare_stages),
        ),
        kernel(
            "saltations",
            "Saltation matrices of the transitions, one below the other.",
            point,
            [_table("saltations", sp.Matrix.vstack(*saltations))],
            (*chain, *saltation_stages),
        ),
        kernel(
            "monodromy",
            "Monodromy matrix: the product of flows and saltation matrices over a period.",
            point,
            [_table("monodromy", full)],
            (*chain, *monodromy_stages),
        ),
        kernel(
            "trace",
            "Trace of the Poincare map's Jacobian.",
            point,
            [_scalar("trace", trace)],
            trace_stages,
        ),
        kernel(
            "trace_gradient",
            "Derivatives of the trace by the unknowns, then in total by the parameters.",
            moved,
            [_flat("trace_gradient", gradient)],
            gradient_stages,
        ),
        kernel(
            "states",
            "State at the start and behind each transition, row by row.",
            point,
            [_table("states", sp.Matrix([list(s) for s in states]))],
            chain,
        ),
    ]
    if not orbit.trigonometric:
        kernels.append(
            kernel(
                "phase_fields",
                "Vector fields [A, b] of the phases, their states at the start and at the end, and"
                " the boundaries along them [n, c], row by row.",
                point,
                [
                    _table(
                        "fields",
                        sp.Matrix.vstack(*(sp.Matrix.hstack(*k.flow.field) for k in links)),
                    ),
                    _table("starts", sp.Matrix([list(k.before) for k in links])),
                    _table("ends", sp.Matrix([list(k.after) for k in links])),
                    _table("boundaries", sp.Matrix([[*b.normal, b.constant] for b in functions])),
                ],
                chain,
            )
        )
    else:
        kernels.append(
            kernel(
                "boundary_functions",
                "Boundaries along the phases: constant, slope, cosine and sine amplitudes, one row"
                " after the other; and the frequencies of each phase.",
                point,
                [
                    _flat("coefficients", coefficients),
                    _flat("frequencies", [w for phase in orbit.frequencies for w in phase]),
                ],
                chain,
            )
        )
    flows = {link.flow.configuration: link.flow for link in orbit.chain.links}
    kernels += flow_kernels(orbit.system, orbit.spectrum, flows, orbit.parameters)
    return (*kernels, *_reduced_kernels(orbit, parameters, spectrum))


def start_kernel(orbit: EquationSystem) -> Kernel:
    """Kernel of the state at an orbit's start, including what the section fixes."""
    start = list(orbit.chain.links[0].before)
    stages = prune(orbit.chain.stages, start)
    return Kernel("start", "State at the start.", _point(orbit), (_flat("start", start),), stages)


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
    starts = {turn.start[i]: sp.Symbol(f"{states[i]}_0", real=True) for i in turn.sought}
    stages = [
        Stage(s.title, tuple((starts.get(x, x), e.xreplace(starts)) for x, e in s.assignments))
        for s in merged((*turn.map_stages, *turn.start_stages), orbit.chain.stages)
    ]
    residual = [e.xreplace(starts) for _, e in (*turn.compatibility, *turn.switching)]
    outputs = (
        _flat("residual", residual),
        _flat("start", list(starts.values())),
        _table("map", sp.Matrix.hstack(turn.matrix, turn.offset)),
    )
    return Kernel(
        "period_map",
        "Compatibility and switching conditions, the start, and the map [N, c] of a turn, all from"
        " the unknowns but the start.",
        _point(orbit),
        outputs,
        prune(stages, [e for output in outputs for e in output.expressions]),
    )


def _reduced_kernels(
    orbit: EquationSystem, parameters: Argument, spectrum: Argument
) -> tuple[Kernel, ...]:
    """Kernels of the reduced equations and of all unknowns from the reduced ones.

    The first is missing where all unknowns are explicit.
    """
    reduction = orbit.reduction
    values = [reduction.values[u] for u in orbit.unknowns]
    explicit = [_flat("unknowns", values)]
    if reduction.determinants:
        explicit.append(_determinants(reduction))
    wanted = [e for output in explicit for e in output.expressions]
    title = "All unknowns from the reduced ones."
    if not reduction.unknowns:
        title = "All unknowns: they are explicit."
    if reduction.determinants:
        title = title[:-1] + ", and how singular the linear equations for them are: 0 if they are."
    point: tuple[Argument, ...] = (parameters, spectrum)
    if reduction.unknowns:
        point = (*point, _vector("reduced", reduction.unknowns))
    expand = Kernel("expand", title, point, tuple(explicit), prune(reduction.stages, wanted))
    if not reduction.unknowns:
        return (expand,)
    equations = [e for _, e in reduction.equations]
    stages, jacobian = reduction.jacobian()
    return (
        Kernel(
            "reduced",
            "Reduced equations and their derivatives by the reduced unknowns.",
            point,
            (_flat("residual", equations), _table("jacobian", jacobian)),
            prune((*reduction.stages, *stages), [*equations, *jacobian]),
        ),
        expand,
    )


def _determinants(reduction: Reduction) -> Output:
    """Output of the determinants, each divided by its bound."""
    return _flat("determinants", [value / bound for value, bound in reduction.determinants])


def reduced_equations(orbit: EquationSystem) -> Kernel:
    """One kernel with all that a solver on the reduced unknowns computes.

    Outputs are the reduced residual and its Jacobian (for the steps), then all unknowns,
    the trace and the determinants (for the result).
    """
    reduction = orbit.reduction
    stages, jacobian = reduction.jacobian()
    trace_stages, trace = orbit.trace_program
    equations = [e for _, e in reduction.equations]
    values = [reduction.values[u] for u in orbit.unknowns]
    # states behind the phases have one name in the chain and in the reduction
    given = [(u, v) for u, v in reduction.values.items() if u != v]
    back = Stage("all unknowns", tuple(given))
    known = merged(merged(reduction.stages, stages), [back])
    everything = merged(known, trace_stages, reduction.unknowns)
    determinants = _determinants(reduction)
    return Kernel(
        "solve",
        "Newton's method on the reduced equations.",
        (),
        (
            _flat("residual", equations),
            _table("jacobian", jacobian),
            _flat("unknowns", values),
            _scalar("trace", trace),
            determinants,
        ),
        prune(everything, [*equations, *jacobian, *values, trace, *determinants.expressions]),
    )


def direction_kernels(orbit: EquationSystem) -> tuple[Kernel, Kernel, Kernel]:
    """Three kernels for the derivatives of an orbit by its parameters.

    They give the spectrum with its derivatives, the derivatives of the equations by the
    unknowns and by the parameters, and those of the trace, whose stages may assign other
    functions of the unknowns to the same symbols.
    """
    jacobian_stages, jacobian = orbit.jacobian_program
    moved_stages, parameter_jacobian = orbit.parameter_jacobian_program
    trace_stages, gradient = orbit.trace_gradient_program
    stages = merged(merged(orbit.stages, jacobian_stages), moved_stages)
    tables = _table("jacobian", jacobian), _table("parameter_jacobian", parameter_jacobian)
    slopes = _flat("trace_gradient", gradient)
    return (
        spectrum_kernel(orbit.spectrum),
        Kernel(
            "equations",
            "Derivatives of the equations.",
            (),
            tables,
            prune(stages, [*jacobian, *parameter_jacobian]),
        ),
        Kernel("slopes", "Derivatives of the trace.", (), (slopes,), prune(trace_stages, gradient)),
    )


def _point(orbit: EquationSystem) -> tuple[Argument, Argument, Argument]:
    """Arguments of a kernel that is evaluated at an orbit."""
    return (
        _vector("parameters", orbit.parameters),
        _vector("spectrum", orbit.spectrum.symbols),
        _vector("unknowns", orbit.unknowns),
    )


def _vector(name: str, symbols: Sequence[sp.Symbol]) -> Argument:
    return Argument(name, (len(symbols),), tuple(symbols))


def _flat(name: str, expressions: Sequence[sp.Expr]) -> Output:
    return Output(name, (len(expressions),), tuple(expressions))


def _scalar(name: str, expression: sp.Expr) -> Output:
    return Output(name, (), (expression,))


def _table(name: str, matrix: sp.Matrix) -> Output:
    return Output(name, matrix.shape, tuple(matrix))

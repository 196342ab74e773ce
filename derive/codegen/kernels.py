"""The kernels of a system and of its orbits: what is computed, over which arrays."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import sympy as sp

from nonsmooth.derive.declaration.system import System
from nonsmooth.derive.equations.equation_system import EquationSystem
from nonsmooth.derive.equations.linearisation import monodromy, saltation_matrices
from nonsmooth.derive.equations.program import (
    Array,
    Kernel,
    Stage,
    differentiate,
    merged,
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
    derivatives = [moving[p].get(s, 0) for s in spectrum.symbols for p in parameters]
    return Kernel.of(
        "spectrum",
        "Frequencies and projector coefficients, with their derivatives by the parameters.",
        [Array.of("parameters", parameters)],
        {
            "spectrum": spectrum.symbols,
            "spectrum_derivatives": _by_parameters(spectrum, derivatives),
        },
        (stage, *stages),
    )


def _by_parameters(spectrum: Spectrum, entries: Sequence[sp.Expr]) -> sp.Matrix:
    """Table of the spectrum by the parameters on which it depends."""
    return sp.Matrix(len(spectrum.symbols), len(spectrum.parameters), entries)


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
        Array.of("parameters", parameters or tuple(p.symbol for p in system.parameters)),
        Array.of("spectrum", spectrum.symbols),
        Array.of("time", TIME),
        Array.of("state", system.states),
    )
    kernels = []
    for flow in flows.values():
        end = flow.matrix() * sp.Matrix(system.states) + flow.offset()
        title = f"State after a time in {flow.configuration}."
        name = f"flow_{flow.configuration}"
        kernels.append(Kernel.of(name, title, arguments, {"state_after": [*end]}))
    return tuple(kernels)


def orbit_kernels(orbit: EquationSystem) -> tuple[Kernel, ...]:
    """All kernels of one orbit; each gives first what the later outputs rest on.

    Of the flows there are those that differ from the system's.
    """
    _, shared = derive_flows(orbit.itinerary.system)
    flows = {
        link.flow.configuration: link.flow
        for link in orbit.chain.links
        if link.flow != shared[link.flow.configuration]
    }
    return (
        _equations_kernel(orbit),
        _trace_kernel(orbit),
        _passage_kernel(orbit),
        _linearisation_kernel(orbit),
        *flow_kernels(orbit.system, orbit.spectrum, flows, orbit.parameters),
        reduced_kernel(orbit),
    )


def _point(orbit: EquationSystem, *, since: int = 0) -> list[Array]:
    """What the equations are evaluated at.

    Outputs from the place `since` on take the derivatives of the spectrum too, if that is given.
    """
    spectrum = orbit.spectrum
    point = [
        Array.of("parameters", orbit.parameters),
        Array.of("spectrum", spectrum.symbols),
        Array.of("unknowns", orbit.unknowns),
    ]
    if since:
        moving = [derivative(s, p) for s in spectrum.symbols for p in spectrum.parameters]
        late = Array.of("spectrum_derivatives", _by_parameters(spectrum, moving))
        point.append(replace(late, since=since))
    return point


def _equations_kernel(orbit: EquationSystem) -> Kernel:
    jacobian_stages, jacobian = orbit.jacobian_program
    moved_stages, parameter_jacobian = orbit.parameter_jacobian_program
    return Kernel.of(
        "equations",
        "Switching and periodicity equations; their derivatives by the unknowns; those by the"
        " parameters, in total, through the spectrum too.",
        _point(orbit, since=2),
        {
            "residual": orbit.residual,
            "jacobian": jacobian,
            "parameter_jacobian": parameter_jacobian,
        },
        merged(merged(orbit.stages, jacobian_stages), moved_stages),
    )


def _trace_kernel(orbit: EquationSystem) -> Kernel:
    _, trace = orbit.trace_program
    stages, gradient = orbit.trace_gradient_program
    return Kernel.of(
        "trace",
        "Trace of the Poincare map's Jacobian; its derivatives by the unknowns, then in total by"
        " the parameters.",
        _point(orbit, since=1),
        {"trace": trace, "trace_gradient": gradient},
        stages,
    )


def _passage_kernel(orbit: EquationSystem) -> Kernel:
    links, functions = orbit.chain.links, orbit.boundary_functions
    states = [links[0].before, *(link.following for link in links)]
    outputs: dict[str, Any] = {"states": sp.Matrix([list(s) for s in states])}
    if orbit.trigonometric:
        outputs["coefficients"] = [c for b in functions for c in b.coefficients]
        outputs["frequencies"] = [w for phase in orbit.frequencies for w in phase]
    else:
        outputs["fields"] = sp.Matrix.vstack(*(sp.Matrix.hstack(*k.flow.field) for k in links))
        outputs["ends"] = sp.Matrix([list(k.after) for k in links])
        outputs["boundaries"] = sp.Matrix([[*b.normal, b.constant] for b in functions])
    return Kernel.of(
        "passage",
        "State at the start and behind each transition. "
        + (
            "Boundaries along the phases: constant, slope, cosine and sine amplitudes, one after"
            " the other; and the frequencies of each phase."
            if orbit.trigonometric
            else "Vector fields [A, b] of the phases, their states at the end, and the boundaries"
            " along them [n, c]."
        ),
        _point(orbit),
        outputs,
        orbit.chain.stages,
    )


def _linearisation_kernel(orbit: EquationSystem) -> Kernel:
    chain = orbit.chain
    poincare_stages, poincare = orbit.map_program
    saltation_stages, saltations = saltation_matrices(chain)
    monodromy_stages, full = monodromy(chain)
    return Kernel.of(
        "linearisation",
        "Jacobian of the Poincare map in the section's coordinates; saltation matrices, one"
        " below the other; monodromy matrix.",
        _point(orbit),
        {
            "poincare_jacobian": poincare,
            "saltations": sp.Matrix.vstack(*saltations),
            "monodromy": full,
        },
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
    return Kernel.of(
        "period_map",
        "Map [N, c] of a turn; the start that follows from the dwell times; compatibility and"
        " switching conditions. The start among the unknowns is not read.",
        _point(orbit),
        {
            "period_map": sp.Matrix.hstack(turn.matrix, turn.offset),
            "linear_start": list(starts.values()),
            "compatibility": conditions,
        },
        stages,
    )


def reduced_kernel(orbit: EquationSystem) -> Kernel:
    """Kernel of all unknowns from the reduced ones, and of the equations that are left."""
    reduction = orbit.reduction
    stages, jacobian = reduction.jacobian()
    outputs: dict[str, Any] = {"unknowns": [reduction.values[u] for u in orbit.unknowns]}
    title = "All unknowns from the reduced ones" if reduction.unknowns else "All unknowns"
    if reduction.determinants:
        outputs["determinants"] = [value / bound for value, bound in reduction.determinants]
        title += "; how singular the linear equations for them are: 0 if they are"
    *point, _ = _point(orbit)
    if reduction.unknowns:
        point.append(Array.of("reduced", reduction.unknowns))
        outputs["reduced_residual"] = [e for _, e in reduction.equations]
        outputs["reduced_jacobian"] = jacobian
        title += "; the equations for these and their derivatives"
    return Kernel.of("reduced", f"{title}.", point, outputs, (*reduction.stages, *stages))

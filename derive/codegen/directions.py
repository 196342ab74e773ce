"""Compiled derivatives of an orbit by its parameters, for many points side by side.

The implicit function theorem on the equations of the orbit: points are taken in blocks of lanes,
as the compiled solver takes them, and so is the elimination, with partial pivoting in each lane.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import chain
from string import Template

import sympy as sp

from nonsmooth.derive.codegen.body import Line, body_of, needed
from nonsmooth.derive.codegen.c import Scope, c_declaration, print_c
from nonsmooth.derive.codegen.kernels import direction_kernels
from nonsmooth.derive.codegen.naming import c_function
from nonsmooth.derive.codegen.solver import inputs_of, lane_sources
from nonsmooth.derive.equations.equation_system import EquationSystem
from nonsmooth.derive.errors import DerivationError
from nonsmooth.derive.symbols import derivative

__all__ = ["DIRECTIONS", "directions_prototype", "directions_source"]

LEAST = "1e-10"  # of a pivot, in units of the matrix: that of nonsmooth.runtime.shooting.newton

DIRECTIONS = (
    "Derivatives of the unknowns and the trace by the parameters, at solutions, for `count` points."
    " Arrays hold columns: entry i of a point stands at [i*count + point]. NaN where the equations"
    " are singular."
)

# names where symbols stand, which hide symbols of the same name
_OWN = {"fixed", "lane", "matrix", "parameter", "slope", "unknown"}

_DIRECTIONS = Template("""\
/* Derivatives of the unknowns and the trace by the parameters, at solutions of the equations, for
 * `count` points. NaN where a pivot is below $least times the matrix. */
NONSMOOTH_MULTIVERSION
$prototype
{
    enum { lanes = 16, n = $n, p = $p, width = $n + $p };
    for (ptrdiff_t start = 0; start < count; start += lanes) {
        const ptrdiff_t here = count - start < lanes ? count - start : lanes;
        double parameter[p][lanes], unknown[n][lanes], fixed[$fixed][lanes];
        double matrix[n][width][lanes], slope[width][lanes], size[lanes], least[lanes];
        for (int lane = 0; lane < lanes; ++lane) {
            const ptrdiff_t point = start + (lane < here ? lane : here - 1);
            for (int i = 0; i < p; ++i)
                parameter[i][lane] = parameters[i * count + point];
            for (int i = 0; i < n; ++i)
                unknown[i][lane] = unknowns[i * count + point];
            size[lane] = 0.0;
            least[lane] = INFINITY;
        }
        NONSMOOTH_SIMD
        for (int lane = 0; lane < lanes; ++lane) {
$spectrum
        }
        NONSMOOTH_SIMD
        for (int lane = 0; lane < lanes; ++lane) {
$equations
        }
        NONSMOOTH_SIMD
        for (int lane = 0; lane < lanes; ++lane) {
$trace
        }
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j)
                NONSMOOTH_SIMD
                for (int lane = 0; lane < lanes; ++lane)
                    size[lane] += matrix[i][j][lane] * matrix[i][j][lane];
        for (int k = 0; k < n; ++k) {
            for (int i = k + 1; i < n; ++i) {
                double other[lanes];
                for (int lane = 0; lane < lanes; ++lane)
                    other[lane] = fabs(matrix[i][k][lane]) - fabs(matrix[k][k][lane]);
                for (int j = k; j < width; ++j)
                    NONSMOOTH_SIMD
                    for (int lane = 0; lane < lanes; ++lane) {
                        const double above = matrix[k][j][lane], below = matrix[i][j][lane];
                        matrix[k][j][lane] = other[lane] > 0.0 ? below : above;
                        matrix[i][j][lane] = other[lane] > 0.0 ? above : below;
                    }
            }
            NONSMOOTH_SIMD
            for (int lane = 0; lane < lanes; ++lane) {
                const double pivot = fabs(matrix[k][k][lane]);
                least[lane] = pivot < least[lane] ? pivot : least[lane];
                matrix[k][k][lane] = 1.0 / matrix[k][k][lane];
            }
            for (int i = k + 1; i < n; ++i) {
                double factor[lanes];
                for (int lane = 0; lane < lanes; ++lane)
                    factor[lane] = matrix[i][k][lane] * matrix[k][k][lane];
                for (int j = k + 1; j < width; ++j)
                    NONSMOOTH_SIMD
                    for (int lane = 0; lane < lanes; ++lane)
                        matrix[i][j][lane] -= factor[lane] * matrix[k][j][lane];
            }
        }
        for (int k = n - 1; k >= 0; --k)
            for (int j = n; j < width; ++j) {
                for (int l = k + 1; l < n; ++l)
                    NONSMOOTH_SIMD
                    for (int lane = 0; lane < lanes; ++lane)
                        matrix[k][j][lane] -= matrix[k][l][lane] * matrix[l][j][lane];
                NONSMOOTH_SIMD
                for (int lane = 0; lane < lanes; ++lane) {
                    matrix[k][j][lane] *= matrix[k][k][lane];
                    slope[j][lane] += slope[k][lane] * matrix[k][j][lane];
                }
            }
        for (int lane = 0; lane < here; ++lane) {
            const double lost = least[lane] > $least * sqrt(size[lane]) ? 0.0 : (double)NAN;
            for (int j = 0; j < p; ++j) {
                for (int i = 0; i < n; ++i)
                    directions[(i * p + j) * count + start + lane] = matrix[i][n + j][lane] + lost;
                directions[(n * p + j) * count + start + lane] = slope[n + j][lane] + lost;
            }
        }
    }
}""")


def directions_prototype(orbit: EquationSystem) -> str:
    """C declaration of the derivatives of an orbit, without the semicolon."""
    name = c_function(orbit.system.name, "directions", orbit.itinerary.name)
    given = ("ptrdiff_t count", "const double *parameters", "const double *unknowns")
    return c_declaration(name, [*given, "double *directions"])


def directions_source(orbit: EquationSystem) -> str:
    """C definition of the derivatives of an orbit by its parameters.

    DerivationError refuses a border collision, whose derivatives are one-sided, and a
    symbol with a name that the function itself uses.
    """
    name = orbit.itinerary.name
    if orbit.itinerary.vanishing:
        raise DerivationError(f"orbit {name!r} is a border collision: it has no derivatives")
    spectrum, equations, trace = map(body_of, direction_kernels(orbit))
    jacobian, moved = equations.outputs
    (gradient,) = trace.outputs
    entries = orbit.spectrum.symbols
    found = [
        *entries,
        *(derivative(s, p) for s in entries for p in orbit.spectrum.parameters),
    ]
    given = (*orbit.parameters, *orbit.unknowns, *found)
    bodies = (spectrum, equations, trace)
    every = {*given, *(line.symbol for body in bodies for line in body.lines)}
    if hidden := sorted({symbol.name for symbol in every} & _OWN):
        raise DerivationError(f"the compiled derivatives have a {hidden[0]!r} of their own")
    used = set().union(*(inputs_of(b.lines, chain(*b.outputs)) for b in (equations, trace)))
    values = dict(zip(found, chain(*spectrum.outputs), strict=True))
    kept = [symbol for symbol in found if symbol in used]
    results = {f"fixed[{i}][lane]": values[symbol] for i, symbol in enumerate(kept)}
    count, parameters = len(orbit.unknowns), len(orbit.parameters)
    rows = {
        f"matrix[{i}][{k}][lane]": jacobian[i * count + k]
        for i in range(count)
        for k in range(count)
    }
    rows |= {
        f"matrix[{i}][{count + k}][lane]": -moved[i * parameters + k]
        for i in range(count)
        for k in range(parameters)
    }
    slopes = {f"slope[{i}][lane]": value for i, value in enumerate(gradient)}
    arrays = {"parameter": orbit.parameters, "unknown": orbit.unknowns, "fixed": kept}
    return _DIRECTIONS.substitute(
        n=count,
        p=parameters,
        fixed=max(len(kept), 1),
        least=LEAST,
        prototype=directions_prototype(orbit),
        spectrum=_lines(needed(spectrum.lines, results.values()), results, arrays),
        equations=_lines(equations.lines, rows, arrays),
        trace=_lines(trace.lines, slopes, arrays),
    )


def _lines(
    lines: Sequence[Line],
    results: Mapping[str, sp.Expr],
    arrays: Mapping[str, Sequence[sp.Symbol]],
) -> str:
    """C statements for one lane: loads of the arrays, assignments, results."""
    scope = Scope(" " * 12)
    wanted = inputs_of(lines, results.values())
    loads = [
        f"{scope.indent}const double {print_c(symbol)} = {array}[{i}][lane];"
        for array, symbols in arrays.items()
        for i, symbol in enumerate(symbols)
        if symbol in wanted
    ]
    sources = lane_sources(lines, scope)
    stores = [line for target, value in results.items() for line in scope.assigned(target, value)]
    return "\n".join([*loads, *sources, *stores])

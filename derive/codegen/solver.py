"""Compiled Newton's method on the reduced equations, for many points side by side.

Points are taken in blocks of lanes; within a block every statement runs over all lanes, so
that a compiler vectorises it. A lane that has converged is frozen: no point's result
depends on its neighbours, on the block it falls into or on the number of threads.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from string import Template
from textwrap import wrap

import sympy as sp

from nonsmooth.derive.codegen.body import Line, body_of, hoisted, needed, split
from nonsmooth.derive.codegen.c import Scope, c_declaration, in_lane, line_sources, print_c
from nonsmooth.derive.codegen.kernels import reduced_equations
from nonsmooth.derive.codegen.naming import c_function, constant
from nonsmooth.derive.equations.equation_system import EquationSystem
from nonsmooth.derive.errors import DerivationError

__all__ = [
    "MOST_REDUCED",
    "SOLVE",
    "STATUSES",
    "lanes_of_spectrum",
    "loop_over_lanes",
    "solve_prototype",
    "solve_source",
]

MOST_REDUCED = 3  # beyond, Cramer's rule is no way to solve a linear system
TOLERANCE = "1e-9"  # of the last step: Newton's method squares it
SINGULAR = "1e-12"  # a determinant in units of its bound
MOST_STEPS = 32

# codes of nonsmooth.runtime.shooting.newton by name, and what to do
STATUSES = {
    "converged": (0, "a solution: ask ..._admissible whether it is a motion"),
    "not_converged": (1, f"{MOST_STEPS} steps were not enough: guess nearer"),
    "not_finite": (2, "no numbers: mind the domains, guess nearer"),
    "not_positive": (3, "a duration is not positive: no orbit, guess another"),
    "singular": (5, "the start is not determined: move a parameter"),
}
SOLVE = (
    "Newton's method on the reduced equations for `count` points, each from its guess: unknowns,"
    " trace of poincare_jacobian, largest reduced residual, steps and a status of each. Arrays hold"
    " columns: entry i of a point stands at [i*count + point]. Where the equations have several"
    " solutions the guess decides."
)

# names of the solver's own, which hide symbols of the same name
_OWN = """
count defect ended ending finite fixed guess here i inverse iteration iterations lane lanes
largest most next open parameter parameters point residual result running slope start status
taken trace unknowns x
"""

_SOLVE = Template("""\
/* Newton's method on the reduced equations for `count` points. In one step a dwell time changes by
 * a factor of four at most; a point has converged when a whole step is below
 * $tolerance max(1, |x|). */
NONSMOOTH_MULTIVERSION
$prototype
{
    enum { lanes = 16, most = $most };
    for (ptrdiff_t start = 0; start < count; start += lanes) {
        const ptrdiff_t here = count - start < lanes ? count - start : lanes;
        double parameter[$p][lanes], ${x}fixed[$fixed][lanes];
        double open[lanes];
        int32_t taken[lanes];
        for (int lane = 0; lane < lanes; ++lane) {
            const ptrdiff_t point = start + (lane < here ? lane : here - 1);
            for (int i = 0; i < $p; ++i)
                parameter[i][lane] = parameters[i * count + point];
$begin
            taken[lane] = 0;
        }
        NONSMOOTH_SIMD
        for (int lane = 0; lane < lanes; ++lane) {
$prelude
        }
$newton        double result[$n][lanes], slope[lanes], defect[lanes];
        int32_t ended[lanes];
        NONSMOOTH_SIMD
        for (int lane = 0; lane < lanes; ++lane) {
$finish
        }
        for (int i = 0; i < $n; ++i)
            for (int lane = 0; lane < here; ++lane)
                unknowns[i * count + start + lane] = result[i][lane];
        for (int lane = 0; lane < here; ++lane) {
            const ptrdiff_t point = start + lane;
            trace[point] = slope[lane];
            residual[point] = defect[lane];
            iterations[point] = taken[lane];
            status[point] = ended[lane];
        }
    }
}""")


_NEWTON = Template("""\
        for (int iteration = 0; iteration < most; ++iteration) {
            double running = 0.0;
            NONSMOOTH_SIMD
            for (int lane = 0; lane < lanes; ++lane) {
$step
            }
            for (int lane = 0; lane < lanes; ++lane)
                running += open[lane];
            if (running == 0.0)
                break;
        }
""")


def solve_prototype(orbit: EquationSystem) -> str:
    """C declaration of the solver of an orbit, without the semicolon."""
    name = c_function(orbit.system.name, "solve", orbit.itinerary.name)
    guess = ["const double *guess"] if orbit.reduction.unknowns else []
    results = ("unknowns", "trace", "residual")
    return c_declaration(
        name,
        [
            "ptrdiff_t count",
            "const double *parameters",
            *guess,
            *(f"double *{result}" for result in results),
            "int32_t *iterations",
            "int32_t *status",
        ],
    )


def solve_source(orbit: EquationSystem) -> str:
    """C definition of the solver of an orbit.

    DerivationError refuses a reduction that leaves more than `MOST_REDUCED` unknowns, and a
    symbol with a name that the solver itself uses.
    """
    count = len(orbit.reduction.unknowns)
    if count > MOST_REDUCED:
        raise DerivationError(
            f"orbit {orbit.itinerary.name!r}: {count} reduced unknowns,"
            f" the compiled solver takes at most {MOST_REDUCED}"
        )
    body = body_of(reduced_equations(orbit))
    symbols = {*body.used, *orbit.parameters, *(line.symbol for line in body.lines)}
    if hidden := sorted({symbol.name for symbol in symbols} & {*_OWN.split()}):
        raise DerivationError(f"the compiled solver has a {hidden[0]!r} of its own: rename it")
    residual, jacobian, values, (trace,), determinants = body.outputs
    unknowns = orbit.reduction.unknowns
    spectrum = [Line(symbol, expression) for symbol, expression in orbit.spectrum.entries]
    inputs = set(orbit.parameters) | set(orbit.spectrum.symbols)
    fixed, moving = split(hoisted(body, inputs), inputs)
    step = needed(moving, (*residual, *jacobian))
    results = (*residual, *values, trace, *determinants)
    finish = needed(moving, results)
    used = inputs_of(step, (*residual, *jacobian)) | inputs_of(finish, results)
    prelude = needed((*spectrum, *fixed), used)
    carried = [line.symbol for line in prelude if line.symbol in used]

    def load(lines: Sequence[Line], results: Iterable[sp.Expr], indent: str) -> list[str]:
        wanted = inputs_of(lines, results)
        arrays = (("parameter", orbit.parameters), ("fixed", carried), ("x", unknowns))
        return [
            f"{indent}const double {print_c(symbol)} = {array}[{i}][lane];"
            for array, symbols in arrays
            for i, symbol in enumerate(symbols)
            if symbol in wanted and not (array == "fixed" and lines is prelude)
        ]

    outer, inner = " " * 12, " " * 16
    newton = [
        *load(step, (*residual, *jacobian), inner),
        *lane_sources(step, scope := Scope(inner)),
        *_newton(orbit, residual, jacobian, scope),
    ]
    last = Scope(outer)
    begin = [f"{outer}open[lane] = {float(count > 0)};"]
    if count:
        begin += [
            f"{outer}for (int i = 0; i < {count}; ++i)",
            f"{inner}x[i][lane] = guess[i * count + point];",
        ]
    return _SOLVE.substitute(
        p=len(orbit.parameters),
        n=len(orbit.unknowns),
        x=f"x[{count}][lanes], " if count else "",
        most=MOST_STEPS,
        begin="\n".join(begin),
        tolerance=TOLERANCE,
        prototype=solve_prototype(orbit),
        fixed=max(len(carried), 1),
        prelude="\n".join(
            [
                *load(prelude, (), outer),
                *line_sources(prelude, Scope(outer)),
                *(f"{outer}fixed[{i}][lane] = {print_c(s)};" for i, s in enumerate(carried)),
            ]
        ),
        newton=_NEWTON.substitute(step="\n".join(newton)) if count else "",
        finish="\n".join(
            [
                *load(finish, results, outer),
                *lane_sources(finish, last),
                *(
                    source
                    for i, v in enumerate(values)
                    for source in last.assigned(f"result[{i}][lane]", v)
                ),
                *last.assigned("slope[lane]", trace),
                f"{outer}double largest = 0.0;",
                *(
                    f"{outer}largest = fabs({print_c(r)}) > largest ? fabs({print_c(r)}) : largest;"
                    for r in residual
                ),
                f"{outer}defect[lane] = largest;",
                *_status(orbit, determinants, outer),
            ]
        ),
    )


def _status(orbit: EquationSystem, determinants: Sequence[sp.Expr], indent: str) -> list[str]:
    """C statements that set the status of a lane, without branches."""
    # x - x is 0 or NaN, and so is a sum of such
    values = ("slope[lane]", *(f"result[{i}][lane]" for i in range(len(orbit.unknowns))))
    finite = " + ".join(f"({value} - {value})" for value in values)
    places = {s: sp.Symbol(f"result[{i}][lane]") for i, s in enumerate(orbit.unknowns)}
    places |= {s: sp.Symbol(f"parameter[{i}][lane]") for i, s in enumerate(orbit.parameters)}
    times = [link.duration.xreplace(places) for link in orbit.chain.links if link.duration != 0]
    negative = " | ".join(f"({print_c(time)} <= 0.0)" for time in times)
    codes = {name: constant(orbit.system.name, name) for name in STATUSES}
    # a determinant that is no number tells nothing
    singular = " | ".join(f"(fabs({print_c(d)}) <= {SINGULAR})" for d in determinants)
    lines = [
        f"const double finite = {finite};",
        f"int32_t ending = ({negative}) ? {codes['not_positive']} : {codes['converged']};",
        f"ending = open[lane] != 0.0 ? {codes['not_converged']} : ending;",
        f"ending = finite == 0.0 ? ending : {codes['not_finite']};",
        *([f"ending = ({singular}) ? {codes['singular']} : ending;"] if singular else []),
        "ended[lane] = ending;",
    ]
    return [indent + line for line in lines]


def lanes_of_spectrum(orbit: EquationSystem, wanted: Sequence[str]) -> tuple[list[str], list[str]]:
    """Arrays of the spectrum and, if wanted, its derivatives; the C lines that fill them.

    An array without entries is NULL.
    """
    entries, parameters = len(orbit.spectrum.symbols), orbit.spectrum.parameters
    if not entries:
        return ["NULL"] * len(wanted), []
    sizes = {"spectrum": entries, "spectrum_derivatives": entries * len(parameters)}
    arrays = [name if name in wanted and size else "NULL" for name, size in sizes.items()]
    declared = {"own": len(parameters)} | {name: sizes[name] for name in arrays if name in sizes}
    indent = " " * 8
    texts = [f"{name}[{size} * lanes]" for name, size in declared.items() if size]
    lines = [f"{indent}double {', '.join(texts)};"]
    for to, parameter in enumerate(parameters):
        place = orbit.parameters.index(parameter)
        given = f"parameters + {place} * count, count, start, own + {to} * lanes"
        lines.append(f"{indent}nonsmooth_load(1, {given});")
    function = c_function(orbit.system.name, "spectrum", None)
    taken = "own" if parameters else "NULL"
    lines += loop_over_lanes(function, [taken, *arrays], indent)
    return arrays[: len(wanted)], lines


def loop_over_lanes(kernel: str, arguments: Sequence[str], indent: str) -> list[str]:
    """C lines that compute a kernel in all lanes; `kernel` is the name of its function."""
    inner = indent + "    "
    call = f"{in_lane(kernel)}(lanes, lane, {', '.join(arguments)});"
    return [
        f"{indent}NONSMOOTH_SIMD",
        f"{indent}for (int lane = 0; lane < lanes; ++lane)",
        *wrap(call, 100, initial_indent=inner, subsequent_indent=inner + "    "),
    ]


def inputs_of(lines: Sequence[Line], results: Iterable[sp.Expr]) -> set[sp.Symbol]:
    """Symbols that lines and results use but the lines do not assign."""
    used: set[sp.Symbol] = set().union(
        *(e.free_symbols for e in results), *(line.expression.free_symbols for line in lines)
    )
    return used - {line.symbol for line in lines}


def lane_sources(lines: Sequence[Line], scope: Scope) -> list[str]:
    """C assignments with sines and cosines of the support header, which vectorise."""
    sources: list[str] = []
    pairs: dict[sp.Expr, int] = {}
    for line in lines:
        if not isinstance(line.expression, sp.sin | sp.cos):
            sources += line_sources([line], scope)
            continue
        argument = line.expression.args[0]
        if argument not in pairs:
            pair = pairs[argument] = len(pairs)
            sources.append(f"{scope.indent}double sine_{pair}, cosine_{pair};")
            call = f"nonsmooth_sincos({print_c(argument)}, &sine_{pair}, &cosine_{pair});"
            sources.append(f"{scope.indent}{call}")
        part = "sine" if isinstance(line.expression, sp.sin) else "cosine"
        name = print_c(line.symbol)
        sources.append(f"{scope.indent}const double {name} = {part}_{pairs[argument]};")
    return sources


def _newton(
    orbit: EquationSystem, residual: Sequence[sp.Expr], jacobian: Sequence[sp.Expr], scope: Scope
) -> list[str]:
    """C statements of one damped Newton step of a lane, by Cramer's rule.

    A lane that has converged keeps its values.
    """
    unknowns = orbit.reduction.unknowns
    size = len(unknowns)
    r = sp.symbols(f"residual_0:{size}", real=True)
    j = sp.symbols(f"jacobian_0:{size * size}", real=True)
    matrix = sp.Matrix(size, size, j)
    numerators = matrix.adjugate() * sp.Matrix(r)
    dwell_times = {link.dwell for link in orbit.chain.links}
    given = [
        source
        for s, e in zip((*r, *j), (*residual, *jacobian), strict=True)
        for source in scope.assigned(f"const double {s}", e)
    ]
    lines = [f"const double inverse = {print_c(1 / sp.expand(matrix.det()))};"]
    texts = [print_c(x) for x in unknowns]
    for i, (unknown, x) in enumerate(zip(unknowns, texts, strict=True)):
        lines.append(f"const double wanted_{i} = {x} - ({print_c(numerators[i])})*inverse;")
        limited = (
            f"wanted_{i} < 0.25*{x} ? 0.25*{x} : wanted_{i} > 4.0*{x} ? 4.0*{x} : wanted_{i}"
            if unknown in dwell_times
            else f"wanted_{i}"
        )
        lines.append(f"const double next_{i} = {limited};")
        lines.append(f"const double size_{i} = fabs(next_{i}) > 1.0 ? fabs(next_{i}) : 1.0;")
    # & and not &&: a branch would keep the loop from being vectorised
    small = " & ".join(
        f"(fabs(wanted_{i} - {x}) <= {TOLERANCE}*size_{i})" for i, x in enumerate(texts)
    )
    lines += [f"x[{i}][lane] = open[lane] != 0.0 ? next_{i} : {x};" for i, x in enumerate(texts)]
    lines.append("taken[lane] += open[lane] != 0.0 ? 1 : 0;")
    lines.append(f"open[lane] = ({small}) ? 0.0 : open[lane];")
    return [*given, *(scope.indent + line for line in lines)]

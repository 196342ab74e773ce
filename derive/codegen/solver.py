"""Compiled functions of many points: Newton's method on reduced equations, and derivatives.

Points are taken in blocks of lanes; within a block every statement runs over all lanes, so
that a compiler vectorises it. A lane that has converged is frozen: no point's result
depends on its neighbours, on the block it falls into or on the number of threads.

Derivatives of an orbit by its parameters are those of the implicit function theorem on its
equations, by an elimination with partial pivoting in each lane.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from string import Template

import sympy as sp

from nonsmooth.derive.codegen.c import count_of_fixed, fixed_part, lane_call, print_c
from nonsmooth.derive.codegen.function import Function, c_statement, function_of_orbit
from nonsmooth.derive.codegen.kernels import reduced_kernel
from nonsmooth.derive.codegen.naming import c_function, constant
from nonsmooth.derive.equations.equation_system import EquationSystem
from nonsmooth.derive.equations.program import Array
from nonsmooth.derive.errors import DerivationError

MOST_REDUCED = 3  # beyond, Cramer's rule is no way to solve a linear system
MOST_STEPS = 32
MOST_NUMBERS = 4096  # of a lane, so that all lanes fit on the stack of a thread

# codes of nonsmooth.runtime.shooting.newton by name, and what to do
STATUSES = {
    "converged": (0, "a solution: ask ..._admissible whether it is a motion"),
    "not_converged": (1, f"{MOST_STEPS} steps were not enough: guess nearer"),
    "not_finite": (2, "no numbers: mind the domains, guess nearer"),
    "not_positive": (3, "a duration is not positive: no orbit, guess another"),
    "singular": (5, "the start is not determined: move a parameter"),
}
_SOLVE_TEXT = (
    "Newton's method on the reduced equations for `count` points, each from its guess: unknowns,"
    " trace of poincare_jacobian, largest reduced residual, steps and a status of each. Arrays hold"
    " columns: entry i of a point stands at [i*count + point]. Where the equations have several"
    " solutions the guess decides."
)

_DIRECTIONS_TEXT = (
    "Derivatives of the unknowns and the trace by the parameters, at solutions, for `count` points."
    " Arrays hold columns: entry i of a point stands at [i*count + point]. NaN where the equations"
    " are singular."
)

_INDENT = " " * 8

_SOLVE = Template("""\
/* Newton's method on the reduced equations for `count` points. */
NONSMOOTH_MULTIVERSION
$prototype
{
    enum { lanes = $lanes, n = $n, p = $p, reduced = $reduced };
    for (ptrdiff_t start = 0; start < count; start += lanes) {
        const int here = count - start < lanes ? (int)(count - start) : lanes;
        double parameter[p * lanes], unknown[n * lanes];
$arrays
        double slope[lanes], largest[lanes], open[lanes], doubt[lanes];
        int32_t taken[lanes], ended[lanes];
        for (int lane = 0; lane < lanes; ++lane) {
            open[lane] = reduced > 0 ? 1.0 : 0.0;
            taken[lane] = 0;
            doubt[lane] = 0.0;
        }
        nonsmooth_load(lanes, p, parameters, count, start, parameter);
$lines
        nonsmooth_largest(lanes, reduced, $equations, largest);
        nonsmooth_doubt(lanes, n, unknown, doubt);
        nonsmooth_doubt(lanes, 1, slope, doubt);
        NONSMOOTH_SIMD
        for (int lane = 0; lane < lanes; ++lane) {
            int32_t code = $converged;
$status
            ended[lane] = code;
        }
        nonsmooth_store(lanes, n, unknown, count, start, unknowns);
        nonsmooth_store(lanes, 1, slope, count, start, trace);
        nonsmooth_store(lanes, 1, largest, count, start, residual);
        for (int lane = 0; lane < here; ++lane) {
            iterations[start + lane] = taken[lane];
            status[start + lane] = ended[lane];
        }
    }
}""")

_NEWTON = Template("""\
        static const int positive[] = {$positive};
        nonsmooth_load(lanes, reduced, guess, count, start, x);
        for (int step = 0; step < $most && nonsmooth_runs(lanes, open); ++step) {
$step
        }""")


_DIRECTIONS = Template("""\
/* Derivatives of the unknowns and the trace by the parameters, at solutions of the equations, for
 * `count` points. */
NONSMOOTH_MULTIVERSION
$prototype
{
    enum { lanes = NONSMOOTH_LANES, n = $n, p = $p };
    for (ptrdiff_t start = 0; start < count; start += lanes) {
        double parameter[p * lanes], unknown[n * lanes];
        double jacobian[n * n * lanes], moved[n * p * lanes], slope[(n + p) * lanes];
        nonsmooth_load(lanes, p, parameters, count, start, parameter);
        nonsmooth_load(lanes, n, unknowns, count, start, unknown);
$kernels
        nonsmooth_implicit_derivatives(n, p, jacobian, moved, slope);
        nonsmooth_store(lanes, n * p, moved, count, start, directions);
        nonsmooth_store(lanes, p, slope + n * lanes, count, start, directions + n * p * count);
    }
}""")


def solve_function(orbit: EquationSystem) -> Function:
    """The solver of an orbit."""
    guessed = len(orbit.reduction.unknowns)
    return function_of_orbit(
        orbit,
        "solve",
        _SOLVE_TEXT,
        [Array("guess", (guessed,))] if guessed else [],  # NumPy takes no cores of no entries
        (
            Array("unknowns", (len(orbit.unknowns),)),
            *map(Array, ("trace", "residual")),
            *(Array(name, ctype="int32_t") for name in ("iterations", "status")),
        ),
    )


def solve_source(orbit: EquationSystem) -> str:
    """C definition of the solver of an orbit, which calls its kernels.

    DerivationError refuses a reduction that leaves more than `MOST_REDUCED` unknowns.
    """
    system, name, unknowns = orbit.system.name, orbit.itinerary.name, orbit.reduction.unknowns
    count = len(unknowns)
    if count > MOST_REDUCED:
        raise DerivationError(
            f"orbit {name!r}: {count} reduced unknowns,"
            f" the compiled solver takes at most {MOST_REDUCED}"
        )
    kernel = reduced_kernel(orbit)
    function, fixed = c_function(system, kernel.name, name), count_of_fixed(kernel)
    (spectrum,), lines = _lanes_of_spectrum(orbit, ["spectrum"])
    point = ["parameter", spectrum]
    if fixed:
        lines += _loop_over_lanes([lane_call(fixed_part(function), [*point, "fixed"])])
    taken = [*point, *(["fixed"] if fixed else []), *(["x"] if count else [])]

    def computed(results: Mapping[str, str]) -> str:
        """Statement that computes results of the kernel, each into an array."""
        given = [results.get(output.name, "NULL") for output in kernel.outputs]
        return lane_call(function, [*taken, *given])

    equations = {"reduced_residual": "equation"}
    if count:
        dwell_times = {link.dwell for link in orbit.chain.links}
        given = "reduced, positive, lane, jacobian, equation, x, open, taken"
        step = [
            computed({**equations, "reduced_jacobian": "jacobian"}),
            f"nonsmooth_newton_in_lane({given});",
        ]
        lines += _NEWTON.substitute(
            positive=", ".join(str(int(u in dwell_times)) for u in unknowns),
            most=MOST_STEPS,
            step="\n".join(_loop_over_lanes(step, _INDENT + "    ")),
        ).split("\n")
    trace = [*point, "unknown", "NULL", "slope", "NULL"]
    lines += _loop_over_lanes(
        [
            computed({"unknowns": "unknown", "determinants": "determinant", **equations}),
            lane_call(c_function(system, "trace", name), trace),
        ]
    )
    sizes = {
        "fixed": fixed,
        "determinant": len(orbit.reduction.determinants),
        "x": count,
        "equation": count,
        "jacobian": count**2,
    }
    arrays = ", ".join(f"{array}[{size} * lanes]" for array, size in sizes.items() if size)
    return _SOLVE.substitute(
        n=len(orbit.unknowns),
        p=len(orbit.parameters),
        reduced=count,
        # one lane takes its sines and cosines from the C library, whatever the phases are
        lanes="NONSMOOTH_LANES" if count else "1",
        prototype=solve_function(orbit).prototype,
        arrays=f"{_INDENT}double {arrays};" if arrays else "",
        lines="\n".join(lines),
        equations="equation" if count else "NULL",
        converged=constant(system, "converged"),
        status="\n".join(_status(orbit)),
    )


def _status(orbit: EquationSystem) -> list[str]:
    """C statements that set the status of a lane."""
    places = {s: f"unknown[{i}*lanes + lane]" for i, s in enumerate(orbit.unknowns)}
    places |= {s: f"parameter[{i}*lanes + lane]" for i, s in enumerate(orbit.parameters)}
    entries = {symbol: sp.Symbol(place) for symbol, place in places.items()}
    times = [link.duration.xreplace(entries) for link in orbit.chain.links if link.duration != 0]
    # | and not ||: a branch would keep the loop from being vectorised
    negative = " | ".join(f"({print_c(time)} <= 0.0)" for time in times)
    # a determinant that is no number tells nothing
    singular = " | ".join(
        f"(fabs(determinant[{i}*lanes + lane]) <= NONSMOOTH_SINGULAR)"
        for i in range(len(orbit.reduction.determinants))
    )
    conditions = {
        "not_positive": f"({negative})" if negative else "",
        "not_converged": "open[lane] != 0.0",
        "not_finite": "doubt[lane] != 0.0",
        "singular": f"({singular})" if singular else "",
    }
    return [
        line
        for name, condition in conditions.items()
        if condition
        for line in c_statement(
            f"code = {condition} ? {constant(orbit.system.name, name)} : code;", _INDENT + "    "
        )
    ]


def directions_function(orbit: EquationSystem) -> Function:
    """The derivatives of an orbit by its parameters."""
    count = len(orbit.unknowns)
    directions = Array("directions", (count + 1, len(orbit.parameters)))
    unknowns = Array("unknowns", (count,))
    return function_of_orbit(orbit, "directions", _DIRECTIONS_TEXT, [unknowns], [directions])


def directions_source(orbit: EquationSystem) -> str:
    """C definition of the derivatives of an orbit by its parameters, which calls its kernels.

    DerivationError refuses a border collision, whose derivatives are one-sided, and equations
    of too many numbers.
    """
    name = orbit.itinerary.name
    if orbit.itinerary.vanishing:
        raise DerivationError(f"orbit {name!r} is a border collision: it has no derivatives")
    n, p = len(orbit.unknowns), len(orbit.parameters)
    entries, own = len(orbit.spectrum.symbols), orbit.spectrum.parameters
    numbers = (n + 1) * (n + p) + n + p + len(own) + entries * (1 + len(own))
    if numbers > MOST_NUMBERS:
        raise DerivationError(
            f"the derivatives of orbit {name!r} take {numbers} numbers for each point,"
            f" more than {MOST_NUMBERS}"
        )
    spectrum, lines = _lanes_of_spectrum(orbit, ("spectrum", "spectrum_derivatives"))
    point = ("parameter", spectrum[0], "unknown", spectrum[1], "NULL")
    for kernel, results in (("equations", ("jacobian", "moved")), ("trace", ("slope",))):
        function = c_function(orbit.system.name, kernel, name)
        lines += _loop_over_lanes([lane_call(function, [*point, *results])])
    return _DIRECTIONS.substitute(
        n=n, p=p, prototype=directions_function(orbit).prototype, kernels="\n".join(lines)
    )


def _lanes_of_spectrum(orbit: EquationSystem, wanted: Sequence[str]) -> tuple[list[str], list[str]]:
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
        lines.append(f"{indent}nonsmooth_load(lanes, 1, {given});")
    function = c_function(orbit.system.name, "spectrum", None)
    taken = "own" if parameters else "NULL"
    lines += _loop_over_lanes([lane_call(function, [taken, *arrays])])
    return arrays[: len(wanted)], lines


def _loop_over_lanes(statements: Sequence[str], indent: str = _INDENT) -> list[str]:
    """C lines that make statements for each lane."""
    inner, head = indent + "    ", f"{indent}for (int lane = 0; lane < lanes; ++lane)"
    lines = [line for statement in statements for line in c_statement(statement, inner)]
    if len(statements) == 1:
        return [f"{indent}NONSMOOTH_SIMD", head, *lines]
    return [f"{indent}NONSMOOTH_SIMD", f"{head} {{", *lines, f"{indent}}}"]

"""Compiled derivatives of an orbit by its parameters, for many points side by side.

The implicit function theorem on the equations of the orbit: points are taken in blocks of lanes,
as the compiled solver takes them, and so is the elimination, with partial pivoting in each lane.
"""

from __future__ import annotations

from string import Template

from nonsmooth.derive.codegen.c import c_declaration
from nonsmooth.derive.codegen.naming import c_function
from nonsmooth.derive.codegen.solver import lane_call, lanes_of_spectrum, loop_over_lanes
from nonsmooth.derive.equations.equation_system import EquationSystem
from nonsmooth.derive.errors import DerivationError

__all__ = ["DIRECTIONS", "directions_prototype", "directions_source"]

MOST_NUMBERS = 4096  # of a lane, so that all lanes fit on the stack of a thread

DIRECTIONS = (
    "Derivatives of the unknowns and the trace by the parameters, at solutions, for `count` points."
    " Arrays hold columns: entry i of a point stands at [i*count + point]. NaN where the equations"
    " are singular."
)

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


def directions_prototype(orbit: EquationSystem) -> str:
    """C declaration of the derivatives of an orbit, without the semicolon."""
    name = c_function(orbit.system.name, "directions", orbit.itinerary.name)
    given = ("ptrdiff_t count", "const double *parameters", "const double *unknowns")
    return c_declaration(name, [*given, "double *directions"])


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
    spectrum, lines = lanes_of_spectrum(orbit, ("spectrum", "spectrum_derivatives"))
    point = ("parameter", spectrum[0], "unknown", spectrum[1], "NULL")
    for kernel, results in (("equations", ("jacobian", "moved")), ("trace", ("slope",))):
        function = c_function(orbit.system.name, kernel, name)
        lines += loop_over_lanes([lane_call(function, [*point, *results])])
    return _DIRECTIONS.substitute(
        n=n, p=p, prototype=directions_prototype(orbit), kernels="\n".join(lines)
    )

"""Compiled admissibility test: guaranteed maxima of all boundary functions of all phases."""

from __future__ import annotations

from itertools import accumulate
from string import Template

import sympy as sp

from nonsmooth.derive.codegen.c import c_declaration, print_c
from nonsmooth.derive.codegen.naming import c_function, constant
from nonsmooth.derive.equations.equation_system import EquationSystem
from nonsmooth.derive.errors import DerivationError

__all__ = ["ADMISSIBLE", "VERDICTS", "admissible_prototype", "admissible_source"]

MOST_STATES = 16  # NONSMOOTH_STATES of nonsmooth_motions.h

# what stands in place of the row of a boundary, by name
VERDICTS = {
    "admissible": (-1, "none is crossed inside a phase: a motion"),
    "no_duration": (-2, "a duration is not positive"),
    "undecided": (-3, "data not finite, or too large for a guarantee"),
}
ADMISSIBLE = (
    "Is each of `count` orbits a motion of the real system? Takes parameters and unknowns point by"
    " point; gives the row of the boundary that is crossed inside a phase, or a verdict, by how"
    " much the boundary's function exceeds zero, and how long after the start of the phase."
)
OPEN = " `bounds` are the least values of the open parameters under which it is a motion."

_ADMISSIBLE = Template("""\
/* Is each of `count` orbits a motion of the real system? */
$prototype
{
    static const int sums[] = {$sums}, ${terms}at_once[] = {$at_once};
    static const int opened[] = {$opened};
    static const int exits[] = {$exits}$first_frequency;
    static const int begins[] = {$begins};
    static const double per_unit[] = {$per_unit};
    for (ptrdiff_t point = 0; point < count; ++point) {
        const double *const p = parameters + $p * point, *const u = unknowns + $n * point;
        const double q[$nq] = {$spectral_parameters};
        const double durations[] = {$durations};
        double spectral[$ns], $arrays;
        $spectrum(q, spectral, NULL);
        $passage(p, spectral, u, $given);
$prepared        /* the $data are differences of the data and carry their rounding */
        const double measures[] = {$measures};
        double size = 0.0, missed = 0.0;
        for (int i = 0; i < $nm; ++i)
            size = fabs(measures[i]) > size ? fabs(measures[i]) : size;
        /* by as much as a phase misses the boundary that ends it, all may be off: to a limit */
        for (int phase = 0; phase < $phases; ++phase) {
            const double miss = fabs(
                $at_exit);
            missed = miss > missed ? miss : missed;
        }
        const double most_missed = 0x1p-30 * size;
        const double noise = 32.0 * DBL_EPSILON * size +
                             (2.0 * missed < most_missed ? 2.0 * missed : most_missed);
        double least[$least_count], most = 0.0, when = 0.0;
        int found = $admissible, row = 0;
        $cursors;
        for (int i = 0; i < $least_count; ++i)
            least[i] = 0.0;
        for (int phase = 0; phase < $phases && found == $admissible; ++phase) {
            const double duration = durations[phase];
            $length;
            double usual[$most_sums], floor[$most_sums], maximum[$most_sums], time[$most_sums];
            if (!(duration > 0.0) && !at_once[phase])
                found = duration <= 0.0 ? $no_duration : $undecided;
            for (int i = 0; i < sums[phase]; ++i) {
                const double *const function = coefficient + i * length;
                usual[i] = opened[row + i] < 0
                    ? noise + $rounding
                    : least[opened[row + i]] * per_unit[row + i];
                /* a phase that begins on a boundary and rises crosses it, however little */
                const int rises = begins[row + i] && duration > 0.0 &&
                                  $rises;
                floor[i] = rises ? -(double)INFINITY : usual[i];
            }
            $maxima
                             maximum, time);
            for (int i = 0; i < sums[phase] && found == $admissible; ++i) {
                if (!(maximum[i] >= floor[i])) {
                    found = $undecided;
                } else if (maximum[i] > floor[i] && opened[row + i] >= 0) {
                    least[opened[row + i]] = maximum[i] / per_unit[row + i];
                } else if (maximum[i] > floor[i]) {
                    found = row + i;
                    most = maximum[i] > 0.0 ? maximum[i] : 0.0;
                    when = maximum[i] > usual[i] ? time[i] : 0.0;
                }
            }
            row += sums[phase];
            coefficient += sums[phase] * length;
$advance        }
$bounds        boundary[point] = found;
        excess[point] = most;
        instant[point] = when;
    }
}""")

_SUMS = {
    "terms": "terms[] = {$terms}, ",
    "first_frequency": ", first_frequency[] = {$first_frequency}",
    "arrays": "coefficients[$nc], frequencies[$nf]",
    "given": "NULL, coefficients, frequencies",
    "prepared": "",
    "data": "coefficients",
    "at_exit": (
        "nonsmooth_evaluate(terms[phase], frequencies + first_frequency[phase],\n"
        "                                   coefficients + exits[phase], durations[phase]).value"
    ),
    "cursors": "const double *coefficient = coefficients, *frequency = frequencies",
    "length": "const int length = 2 + 2 * terms[phase]",
    "rounding": "nonsmooth_rounding(terms[phase], frequency, function, duration)",
    "rises": "nonsmooth_rises(terms[phase], frequency, function, noise)",
    "maxima": (
        "nonsmooth_maxima(sums[phase], terms[phase], frequency, coefficient, duration, floor,"
    ),
    "advance": "            frequency += terms[phase];\n",
}
_MOTIONS = {
    "terms": "",
    "first_frequency": "",
    "arrays": "fields[$nfields], starts[$nstates + $states], ends[$nstates], rows[$nc]",
    "given": "starts, fields, ends, rows",
    "prepared": """\
        nonsmooth_motion motions[$phases];
        for (int phase = 0; phase < $phases; ++phase)
            motions[phase] = nonsmooth_motion_of($states, fields + $field * phase,
                                                 starts + $states * phase, durations[phase]);
""",
    "data": "functions",
    "at_exit": "nonsmooth_value($states, rows + exits[phase], motions[phase].end)",
    "cursors": "const double *coefficient = rows",
    "length": "const int length = $states + 1",
    "rounding": "nonsmooth_motion_rounding(&motions[phase], function)",
    "rises": "nonsmooth_motion_rises(&motions[phase], function, noise)",
    "maxima": "nonsmooth_motion_maxima(&motions[phase], sums[phase], coefficient, floor,",
    "advance": "",
}


def admissible_prototype(orbit: EquationSystem) -> str:
    """C declaration of the admissibility test of an orbit, without the semicolon."""
    name = c_function(orbit.system.name, "admissible", orbit.itinerary.name)
    bounds = ["double *bounds"] if orbit.open_parameters else []
    given = ("ptrdiff_t count", "const double *parameters", "const double *unknowns")
    results = ("int32_t *boundary", "double *excess", "double *instant")
    return c_declaration(name, [*given, *bounds, *results])


def admissible_source(orbit: EquationSystem) -> str:
    """C definition of the admissibility test of an orbit.

    DerivationError refuses an orbit with more states than the compiled search for maxima
    along its flows takes.
    """
    states = len(orbit.system.states)
    if not orbit.trigonometric and states > MOST_STATES:
        raise DerivationError(
            f"orbit {orbit.itinerary.name!r}: {states} states, the compiled search takes at most"
            f" {MOST_STATES}"
        )
    functions, spectrum = orbit.boundary_functions, orbit.spectrum
    sums = [sum(b.phase == k for b in functions) for k in range(len(orbit.chain.links))]
    terms = [len(w) for w in orbit.frequencies]
    opened = [
        -1 if b.open_parameter is None else orbit.open_parameters.index(b.open_parameter)
        for b in functions
    ]
    many = len(orbit.open_parameters)
    widths = [len(b.coefficients) if orbit.trigonometric else states + 1 for b in functions]
    rows = [*accumulate(widths, initial=0)]
    exits = [
        next(
            row
            for row, b in zip(rows, functions, strict=False)
            if (b.phase, b.boundary) == (index, phase.boundary)
        )
        for index, phase in enumerate(orbit.itinerary.phases)
    ]
    places = {
        symbol: sp.Symbol(f"{array}[{i}]")
        for array, symbols in (("p", orbit.parameters), ("u", orbit.unknowns))
        for i, symbol in enumerate(symbols)
    }
    kind = _SUMS if orbit.trigonometric else _MOTIONS
    numbers = {
        "terms": ", ".join(map(str, terms)),
        "first_frequency": ", ".join(map(str, [*accumulate(terms, initial=0)][:-1])),
        "phases": len(sums),
        "states": states,
        "field": states * (states + 1),
        "nfields": len(sums) * states * (states + 1),
        "nstates": len(sums) * states,
        "nc": sum(widths),
        "nf": max(sum(terms), 1),
    }
    return _ADMISSIBLE.substitute(
        {name: Template(text).substitute(numbers) for name, text in kind.items()}
        | {name: constant(orbit.system.name, name) for name in VERDICTS},
        p=len(orbit.parameters),
        n=len(orbit.unknowns),
        bounds=(
            f"        for (int i = 0; i < {many}; ++i)\n"
            f"            bounds[{many} * point + i] = least[i];\n"
            if many
            else ""
        ),
        least_count=max(many, 1),
        prototype=admissible_prototype(orbit),
        phases=len(sums),
        sums=", ".join(map(str, sums)),
        at_once=", ".join(str(int(link.duration == 0)) for link in orbit.chain.links),
        durations=", ".join(print_c(link.duration.xreplace(places)) for link in orbit.chain.links),
        opened=", ".join(map(str, opened)),
        begins=", ".join(str(int(b.begins and b.open_parameter is None)) for b in functions),
        exits=", ".join(map(str, exits)),
        measures=", ".join(print_c(places[symbol]) for symbol in orbit.measures),
        nm=len(orbit.measures),
        per_unit=", ".join(print_c(sp.Float(-b.open_coefficient)) for b in functions),
        ns=max(len(spectrum.symbols), 1),
        nq=max(len(spectrum.parameters), 1),
        spectral_parameters=", ".join(
            f"p[{orbit.parameters.index(q)}]" for q in spectrum.parameters
        )
        or "0.0",
        most_sums=max(sums),
        spectrum=c_function(orbit.system.name, "spectrum", None),
        passage=c_function(orbit.system.name, "passage", orbit.itinerary.name),
    )

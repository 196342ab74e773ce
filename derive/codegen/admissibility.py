"""Compiled admissibility test: guaranteed maxima of all boundary functions of all phases."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import accumulate
from string import Template
from typing import Any

import sympy as sp

from nonsmooth.derive.codegen.c import print_c
from nonsmooth.derive.codegen.function import Function, function_of_orbit
from nonsmooth.derive.codegen.naming import c_function
from nonsmooth.derive.equations.equation_system import EquationSystem
from nonsmooth.derive.equations.program import Array
from nonsmooth.derive.errors import DerivationError

MOST_STATES = 16  # NONSMOOTH_STATES of nonsmooth_motions.h

# what stands in place of the row of a boundary, by name, as in nonsmooth_admissible.h
VERDICTS = {
    "admissible": (-1, "none is crossed inside a phase: a motion"),
    "no_duration": (-2, "a duration is not positive"),
    "undecided": (-3, "data not finite, or too large for a guarantee"),
}
_TEXT = (
    "Is each of `count` orbits a motion of the real system? Takes parameters and unknowns point by"
    " point; gives the row of the boundary that is crossed inside a phase, or a verdict, by how"
    " much the boundary's function exceeds zero, and how long after the start of the phase."
)
_OPEN = " `bounds` are the least values of the open parameters under which it is a motion."

_ADMISSIBLE = Template("""\
/* Is each of `count` orbits a motion of the real system? */
$prototype
{
    static const int counts[] = {$counts}, at_once[] = {$at_once}, exits[] = {$exits};
    static const int opened[] = {$opened};
    static const int begins[] = {$begins};
    static const double per_unit[] = {$per_unit};
    static const nonsmooth_boundaries boundaries = {
        $phases, $open, counts, at_once, exits, opened, begins, per_unit};$terms
    for (ptrdiff_t point = 0; point < count; ++point) {
        const double *const p = parameters + $p * point, *const u = unknowns + $n * point;
        const double q[$nq] = {$spectral_parameters};
        const double durations[] = {$durations};
        const double measures[] = {$measures};
        double spectral[$ns], work[$work], $arrays;
        $spectrum(q, spectral, NULL);
        $passage(p, spectral, u, $given);
$along
        const nonsmooth_verdict verdict =
            nonsmooth_judge(&boundaries, &along, $measured, measures, work, $bounds);
        boundary[point] = verdict.boundary;
        excess[point] = verdict.excess;
        instant[point] = verdict.instant;
    }
}""")

_SUMS = {
    "terms": "\n    static const int terms[] = {$terms}, first[] = {$first};",
    "arrays": "rows[$entries], frequencies[$frequencies]",
    "given": "NULL, rows, frequencies",
    "along": """\
        const nonsmooth_phase_sums sums = {terms, first, frequencies};
        const nonsmooth_along along = nonsmooth_along_sums(&sums, durations, rows);""",
}
_MOTIONS = {
    "terms": "",
    "arrays": "fields[$phases * $field], starts[($phases + 1) * $states], ends[$phases * $states],"
    " rows[$entries]",
    "given": "starts, fields, ends, rows",
    "along": """\
        nonsmooth_motion motions[$phases];
        for (int phase = 0; phase < $phases; ++phase)
            motions[phase] = nonsmooth_motion_of($states, fields + $field * phase,
                                                 starts + $states * phase, durations[phase]);
        const nonsmooth_along along = nonsmooth_along_motions(motions, durations, rows);""",
}


def admissible_function(orbit: EquationSystem) -> Function:
    """The admissibility test of an orbit."""
    opened = len(orbit.open_parameters)
    return function_of_orbit(
        orbit,
        "admissible",
        _TEXT + _OPEN * (opened > 0),
        [Array("unknowns", (len(orbit.unknowns),))],
        (
            *([Array("bounds", (opened,))] if opened else []),
            Array("boundary", ctype="int32_t"),
            *map(Array, ("excess", "instant")),
        ),
        long=True,
    )


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
    functions, spectrum, opened = orbit.boundary_functions, orbit.spectrum, orbit.open_parameters
    counts = [sum(b.phase == k for b in functions) for k in range(len(orbit.chain.links))]
    terms = [len(w) for w in orbit.frequencies]
    widths = [len(b.coefficients) if orbit.trigonometric else states + 1 for b in functions]
    begun = {
        (b.phase, b.boundary): row
        for b, row in zip(functions, accumulate(widths, initial=0), strict=False)
    }
    places = {
        symbol: sp.Symbol(f"{array}[{i}]")
        for array, symbols in (("p", orbit.parameters), ("u", orbit.unknowns))
        for i, symbol in enumerate(symbols)
    }

    def listed(values: Iterable[Any]) -> str:
        return ", ".join(print_c(sp.sympify(value).xreplace(places)) for value in values)

    numbers = {
        "terms": listed(terms),
        "first": listed([*accumulate(terms, initial=0)][:-1]),
        "phases": len(counts),
        "states": states,
        "field": states * (states + 1),
        "entries": sum(widths),
        "frequencies": max(sum(terms), 1),
    }
    kind = _SUMS if orbit.trigonometric else _MOTIONS
    return _ADMISSIBLE.substitute(
        {name: Template(text).substitute(numbers) for name, text in kind.items()},
        p=len(orbit.parameters),
        n=len(orbit.unknowns),
        prototype=admissible_function(orbit).prototype,
        phases=len(counts),
        open=len(opened),
        bounds=f"bounds + {len(opened)} * point" if opened else "NULL",
        counts=listed(counts),
        at_once=listed(int(link.duration == 0) for link in orbit.chain.links),
        exits=listed(begun[k, phase.boundary] for k, phase in enumerate(orbit.itinerary.phases)),
        opened=listed(
            -1 if b.open_parameter is None else opened.index(b.open_parameter) for b in functions
        ),
        begins=listed(int(b.begins and b.open_parameter is None) for b in functions),
        per_unit=listed(sp.Float(-b.open_coefficient) for b in functions),
        durations=listed(link.duration for link in orbit.chain.links),
        measures=listed(orbit.measures),
        measured=len(orbit.measures),
        ns=max(len(spectrum.symbols), 1),
        nq=max(len(spectrum.parameters), 1),
        spectral_parameters=listed(spectrum.parameters) or "0.0",
        work=4 * max(counts),
        spectrum=c_function(orbit.system.name, "spectrum", None),
        passage=c_function(orbit.system.name, "passage", orbit.itinerary.name),
    )

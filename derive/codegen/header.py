"""The C header of a system: names of places and statuses, and what each function takes and gives.

What several functions share is said once: at the head for the system, and in front of the
functions of each orbit.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from string import Template
from textwrap import indent, wrap

from nonsmooth.derive.codegen.admissibility import VERDICTS
from nonsmooth.derive.codegen.derived import DerivedSystem, reduced_names
from nonsmooth.derive.codegen.function import Function
from nonsmooth.derive.codegen.naming import (
    c_function,
    constant,
    free_name,
    identifier,
    module_file,
)
from nonsmooth.derive.codegen.python_file import Stamp
from nonsmooth.derive.codegen.solver import STATUSES
from nonsmooth.derive.declaration.fields import exact
from nonsmooth.derive.declaration.parameter import Parameter
from nonsmooth.derive.equations.equation_system import EquationSystem

_WIDTH = 100

# meaning of the arrays that several functions share, by name
_ARRAYS = {
    "parameters": "of the system, or of the orbit in the orbit's functions",
    "spectrum": "{spectrum}: what {function} gives, once for each point of {parameters}",
    "spectrum_derivatives": "of spectrum[i] by the j-th of {parameters}",
    "state": "{states}; of an orbit as its comment says",
    "state_after": "the same after `time`",
    "unknowns": "of the orbit",
    "residual": "left-hand sides of the equations, which the orbit's comment lists",
    "jacobian": "of residual[i] by unknowns[j]",
    "parameter_jacobian": "of residual[i] by parameters[j], in total",
    "poincare_jacobian": "of the Poincare map in the coordinates of the orbit's section",
    "saltations": "of the state, one matrix for each phase",
    "monodromy": "of the state at the end by that at the start",
    "trace_gradient": "of the trace by unknowns, then by parameters in total",
    "reduced": "unknowns from which all others follow, as `guess`: the orbit's comment lists them",
    "reduced_residual": "left-hand sides of the equations that are left for them",
    "reduced_jacobian": "of reduced_residual[i] by reduced[j]",
    "directions": "of unknowns[i], and of the trace in the last row, by parameters[j]",
}


class _Constants:
    """Constants of a header, all of different names."""

    def __init__(self, system: str) -> None:
        self._system = system
        self._taken = {constant(system, name) for name in (*STATUSES, *VERDICTS)}

    def _name(self, words: Sequence[str]) -> str:
        name = free_name(constant(self._system, identifier("_".join(words))), self._taken)
        self._taken.add(name)
        return name

    def places(
        self, orbit: str | None, count: str, title: str, texts: Sequence[tuple[str, str]]
    ) -> tuple[str, str]:
        """C source of an enum of places and their number, and the name of the latter.

        `texts` has a name and a description for each place.
        """
        before = [] if orbit is None else [orbit]
        names = [self._name([*before, name]) for name, _ in texts]
        number = self._name([*before, count])
        lines = [
            (f"{name} = {place}", text)
            for place, (name, (_, text)) in enumerate(zip(names, texts, strict=True))
        ]
        return _enum(title, [*lines, (f"{number} = {len(texts)}", "how many")]), number


_FILE = Template("""\
$stamp
#ifndef $guard
#define $guard

$head

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

$body

#ifdef __cplusplus
}
#endif

#endif
""")

_HEAD = Template("""\
$description

    cc -std=c99 -O2 program.c $source -lm

Loops over points use vectors with -O3 -fopenmp-simd -DNONSMOOTH_OPENMP_SIMD.

Functions write their results and nothing else, keep nothing between calls and allocate
no memory: any number of threads may call them. Results must not overlap arguments.
Of several results of a function for one point any may be NULL: then it is not wanted,
and what is behind the last one that is wanted is not computed.

The enums name the places in arrays. Matrices stand row by row: entry (i, j) of one with
n columns at [n*i + j]. Several functions share these arrays:

$arrays""")

_EXAMPLE = Template("""\
#include <stdio.h>
#include "$header"

int main(void)
{
$arrays
    double unknowns[$unknowns], trace, residual;
    int32_t iterations, status;
    $solver(
        $arguments);
    printf("status %d, trace %.15g\\n", (int)status, trace);
    for (int i = 0; i < $unknowns; ++i)
        printf("%.15g\\n", unknowns[i]);
    return status != $converged;
}""")


def header_file(
    stamp: Stamp,
    derived: DerivedSystem,
    functions: Iterable[Function],
    missing: Mapping[Function, str],
) -> str:
    """Text of the header of a system with these functions, in front of which it explains them.

    It names those that C has not with the reason.
    """
    system = derived.system
    constants = _Constants(system.name)
    state = [(str(s), "") for s in system.states]
    blocks = [
        constants.places(None, count, title, texts)[0]
        for count, title, texts in (
            ("parameters", "parameters of the system", _parameter_texts(system.parameters)),
            ("states", "state of the system", state),
        )
    ]
    if any(f.many for f in functions):
        blocks += [
            _enum(title, [(f"{constant(system.name, n)} = {v}", t) for n, (v, t) in codes.items()])
            for title, codes in (
                ("status of a point that ..._solve gives", STATUSES),
                ("boundary that ..._admissible gives where it is no row", VERDICTS),
            )
        ]
    blocks += _functions(None, functions, missing)
    example = ""
    for orbit in derived.derived:
        name = orbit.itinerary.name
        known, by_name = _known(orbit), {p.name: p for p in orbit.system.parameters}
        texts = _parameter_texts([by_name[str(s)] for s in orbit.parameters], known)
        (parameters, count), (unknowns, unknown_count) = (
            constants.places(name, kind, title, entries)
            for kind, title, entries in (
                ("parameters", "parameters of this orbit", texts),
                ("unknowns", "unknowns, columns of the jacobian", _unknown_texts(orbit, known)),
            )
        )
        members = _functions(name, functions, missing)
        blocks += [_orbit_comment(orbit), parameters, unknowns, *members]
        solver = c_function(system.name, "solve", name)
        if not example and solver in (f.name for f in functions):
            example = _example(orbit, solver, count, unknown_count, known)
    for other in derived.underived:
        blocks.append(_comment(f"Orbit {other.itinerary.name} has no functions: {other.reason}."))
    return _FILE.substitute(
        stamp=stamp.c(),
        guard=constant(f"nonsmooth_system_{system.name}", "h"),  # nothing in a kernel has that name
        head=_head(derived, functions, example),
        body="\n\n".join(blocks),
    )


def _head(derived: DerivedSystem, functions: Iterable[Function], example: str) -> str:
    """The comment on what holds for the whole header."""
    system, spectrum = derived.system, derived.form.spectrum
    texts = {
        "spectrum": ", ".join(map(str, spectrum.symbols)) or "nothing",
        "parameters": ", ".join(map(str, spectrum.parameters)) or "no parameters",
        "function": c_function(system.name, "spectrum", None),
        "states": ", ".join(map(str, system.states)),
    }
    every = " ".join(f.prototype for f in functions)
    arrays = [
        line
        for name, text in _ARRAYS.items()
        if re.search(rf"\b{name}\b", every)
        for line in _listed(name, 21, [text.format(**texts)])
    ]
    description = f"{system.name}: {_plain(system.description)}"
    head = _HEAD.substitute(
        description="\n".join(_wrapped(description, _WIDTH - 4)),
        source=module_file(system.name, ".c"),
        arrays="\n".join(arrays),
    )
    if example:
        head += "\n\nExample:\n\n" + indent(example, "    ")
    return _block(head.split("\n"))


def _listed(label: str, width: int, texts: Iterable[str]) -> list[str]:
    """Lines of a label and of the texts beside it, in columns."""
    lines = [x for text in texts for x in _wrapped(_plain(text), _WIDTH - width - 9)]
    labels = [label, *[""] * (len(lines) - 1)]
    return [f"    {a:<{width}} {line}" for a, line in zip(labels, lines, strict=False)]


def _functions(
    orbit: str | None, functions: Iterable[Function], missing: Mapping[Function, str]
) -> list[str]:
    """Declarations of the functions of an orbit, or of the system, and what C has not."""
    members = sorted((f for f in functions if f.orbit == orbit), key=lambda f: not f.many)
    declared = [f"{_comment(f.text)}\n{f.prototype};" for f in members]
    absent = [
        _comment(f"There is no {f.name}: {reason}.")
        for f, reason in missing.items()
        if f.orbit == orbit
    ]
    return ["\n".join(declared), *absent] if declared else absent


def _orbit_comment(orbit: EquationSystem) -> str:
    """What the functions of an orbit share."""
    itinerary = orbit.itinerary
    phases = [
        f"{k} {link.flow.configuration} for {link.duration}, until {phase.boundary}"
        for k, (phase, link) in enumerate(
            zip(itinerary.phases, orbit.chain.links, strict=True), start=1
        )
    ]
    facts = {
        "phases": phases,
        "state": [", ".join(_state_texts(orbit))],
        "section": [", ".join(map(str, orbit.chain.coordinates)) or "a point"],
        "residual": [f"[{i}] {meaning}" for i, (meaning, _) in enumerate(orbit.equations)],
        "guess, reduced": [", ".join(f"[{i}] {n}" for i, n in enumerate(reduced_names(orbit)))],
        "bounds": [", ".join(f"[{i}] {p}" for i, p in enumerate(orbit.open_parameters))],
    }
    rows: dict[int, list[str]] = {}
    for row, b in enumerate(orbit.boundary_functions):
        rows.setdefault(b.phase, []).append(f"[{row}] {b.boundary}")
    facts["boundary"] = [f"in phase {k + 1}: {', '.join(names)}" for k, names in rows.items()]
    listed = (line for name, texts in facts.items() for line in _listed(name, 15, texts))
    return _block([f"Orbit {itinerary.name}.", "", *listed])


def _state_texts(orbit: EquationSystem) -> list[str]:
    """The states of an orbit, and what they are in those of the system where they differ."""
    presentation, states = orbit.itinerary.presentation, orbit.system.states
    if presentation is None:
        return [str(s) for s in states]
    physical = orbit.itinerary.system.states
    return [
        str(s) if (s, shift) == (x, 0) else f"{s} = {x - shift}"
        for s, x, shift in zip(states, physical, presentation.origin, strict=True)
    ]


def _parameter_texts(
    parameters: Iterable[Parameter], known: Mapping[str, float] | None = None
) -> list[tuple[str, str]]:
    """Names of parameters with their meanings, domains and values at the reference."""
    return [
        (p.name, f"{p.description}; {_domain(p)}{_value(p.name, known or {})}") for p in parameters
    ]


def _domain(parameter: Parameter) -> str:
    text = parameter.name
    if parameter.lower.is_finite:
        text = f"{parameter.lower} {'<=' if parameter.closed else '<'} {text}"
    if parameter.upper.is_finite:
        text = f"{text} {'<=' if parameter.upper_closed else '<'} {parameter.upper}"
    return text


def _value(name: str, known: Mapping[str, float]) -> str:
    return f"; e.g. {known[name]!r}" if name in known else ""


def _unknown_texts(orbit: EquationSystem, known: Mapping[str, float]) -> list[tuple[str, str]]:
    """Names of unknowns with their meanings and values near the reference."""
    start, states = orbit.chain.start, orbit.system.states
    meanings = {
        str(q): f"{states[place]} at the start"
        for q, place in zip(start.coordinates, start.places, strict=True)
    }
    meanings |= {
        str(link.dwell): f"duration of phase {k}, {link.flow.configuration}"
        for k, link in enumerate(orbit.chain.links, start=1)
    }
    meanings |= {p.name: p.description for p in orbit.system.parameters}
    return [(str(u), meanings.get(str(u), "") + _value(str(u), known)) for u in orbit.unknowns]


def _known(orbit: EquationSystem) -> dict[str, float]:
    """Values of parameters and unknowns at the orbit's reference, by name."""
    reference = orbit.itinerary.reference
    if reference is None:
        return {}
    texts = {**reference.guess, **reference.parameters}
    return {name: float(exact(text)) for name, text in texts.items()}


def _example(
    orbit: EquationSystem, solver: str, count: str, unknown_count: str, known: Mapping[str, float]
) -> str:
    """A program that solves an orbit at its reference; empty without one, or a part of it."""
    names, guessed = [str(s) for s in orbit.parameters], reduced_names(orbit)
    if not names or not known.keys() >= {*names, *guessed}:
        return ""
    arrays, newline = [], "\n" + " " * 8
    for array, entries in ((f"parameters[{count}]", names), (f"guess[{len(guessed)}]", guessed)):
        begin, values = f"    const double {array} =", ", ".join(repr(known[n]) for n in entries)
        wide = len(begin) + len(values) >= _WIDTH - 12
        arrays += [f"{begin}{newline if wide else ' '}{{{values}}};"] if entries else []
    guess = "guess, " * bool(guessed)
    return _EXAMPLE.substitute(
        header=module_file(orbit.system.name, ".h"),
        arrays="\n".join(arrays),
        unknowns=unknown_count,
        solver=solver,
        arguments=f"1, parameters, {guess}unknowns, &trace, &residual, &iterations, &status",
        converged=constant(orbit.system.name, "converged"),
    )


def _enum(title: str, entries: Sequence[tuple[str, str]]) -> str:
    """C source of an enum, with a comment on it and on each of its constants."""
    lines = []
    for place, (constant_text, description) in enumerate(entries):
        line = f"    {constant_text}{',' * (place + 1 < len(entries))}"
        comment = f" /* {_plain(description)} */" if description else ""
        if len(line) + len(comment) > _WIDTH:
            lines += [f"    {row}" for row in _comment(description, _WIDTH - 4).split("\n")]
            comment = ""
        lines.append(line + comment)
    return "\n".join([f"enum {{ /* {title} */", *lines, "};"])


def _comment(text: str, width: int = _WIDTH) -> str:
    """A comment of C, in as many lines as it needs."""
    return "/* " + "\n * ".join(_wrapped(_plain(text), width - 6)) + " */"


def _block(lines: Sequence[str]) -> str:
    """A comment of C with these lines."""
    return "\n".join([f"/* {lines[0]}", *(f" * {line}".rstrip() for line in lines[1:]), " */"])


def _wrapped(text: str, width: int) -> list[str]:
    """Lines of a text; names with hyphens, and places with what stands there, are not broken."""
    lines = wrap(text.replace("] ", "]\0"), width, break_on_hyphens=False)
    return [line.replace("\0", " ") for line in lines]


def _plain(text: str) -> str:
    """A text in one line that a comment of C may hold."""
    return " ".join(text.replace("*/", "* /").replace("/*", "/ *").split())

"""The Python file of a system: names, domains and orbits in the types of JSON, then kernels.

It is made without the imports that C and documents need, which take time.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import sympy as sp

from nonsmooth.derive.codegen.derived import (
    DerivedSystem,
    Underived,
    Use,
    derive_system,
    reduced_names,
)
from nonsmooth.derive.codegen.naming import python_function
from nonsmooth.derive.codegen.simulation_form import SimulationForm
from nonsmooth.derive.declaration.itinerary import Itinerary
from nonsmooth.derive.declaration.parameter import Parameter
from nonsmooth.derive.declaration.presentation import Presentation
from nonsmooth.derive.declaration.system import System, text_hash
from nonsmooth.derive.equations.equation_system import EquationSystem

GENERATE = "nonsmooth generate FILE.py"  # what makes the files of a declaration


def emit_python(system: System, orbits: Sequence[Itinerary], source: str) -> str:
    """Python file of a system alone, for a first result at once.

    Orbits that can be composed at run time get no kernels if their formulas are long, or
    slow before they are compiled. `source` says in the stamp what declares the system.
    """
    derived = derive_system(system, orbits, use=Use.FIRST_ANSWER)
    tables = system_tables(derived)
    stamp = Stamp(source, text_hash(tables, *derived.functions), GENERATE)
    return python_file(stamp, system.name, tables, derived.functions)


@dataclass(frozen=True)
class Stamp:
    """The comment at the head of a generated file, which says how it was made."""

    source: str  # what declares the system
    derivation: str  # hash of what was derived
    command: str  # how to make the file again

    @property
    def lines(self) -> list[str]:
        """The lines of the comment, without its signs."""
        return [
            "Generated; do not edit.",
            f"Source: {self.source}",
            f"Again: {self.command}",
            f"SymPy {sp.__version__}, derivation {self.derivation}",
        ]

    def c(self) -> str:
        """The stamp as a comment of C."""
        return "/* " + "\n * ".join(self.lines) + " */"

    def python(self) -> str:
        """The stamp as a comment of Python."""
        return "\n".join(f"# {line}" for line in self.lines)


def python_file(stamp: Stamp, name: str, tables: str, functions: Sequence[str]) -> str:
    """Text of a system's Python file: tables, then kernels."""
    body = "\n\n\n".join(functions)
    return (
        f"{stamp.python()}\n"
        f'"""Kernels and tables of the system {name}, over any arithmetic ``lib``."""\n\n'
        f'import json\n\nDERIVATION = "{stamp.derivation}"\n\n{tables}\n\n{body}\n'
    )


_WIDTH = 120
# an entry of JSON, or a part of one, with the comma behind it
_PIECE = re.compile(r'(?:"(?:\\.|[^"\\])*"|[^",])+(?:, ?)?')


def system_tables(derived: DerivedSystem) -> str:
    """Python source that reads the tables SYSTEM, ORBITS and KERNELS from JSON.

    KERNELS has core shapes: of what a kernel takes, each with the place of the first output that
    needs it, and of what it gives, each with its name.
    MANY_POINTS is added if kernels for many points may be derived of some orbits; it has
    their names.
    """
    shapes = {
        python_function(k.name, orbit): (
            [(a.shape, a.since) for a in k.arguments],
            [(o.name, o.shape) for o in k.outputs],
        )
        for k, orbit, _ in derived.kernels
    }
    table = system_table(derived.form)
    orbit_tables = {
        orbit.itinerary.name: composed_table(orbit)
        if isinstance(orbit, Underived)
        else orbit_table(orbit)
        for orbit in derived.orbits
    }
    many = [orbit.itinerary.name for orbit in derived.underived if orbit.many]
    told = [
        _reading("SYSTEM", table, levels=2),
        _reading("ORBITS", orbit_tables, levels=3),
        _reading("KERNELS", shapes, levels=1),
        *([_reading("MANY_POINTS", many, levels=1)] if many else []),
    ]
    return "\n\n".join(told)


def _reading(name: str, value: Any, levels: int) -> str:
    """An assignment of a value, which it reads from JSON; no JSON has three quotes in a row."""
    text = "\n".join(_lines("", value, levels))
    return f'{name} = json.loads(r"""{text}""")'


def _lines(head: str, value: Any, levels: int, tail: str = "") -> Iterator[str]:
    """Lines of JSON between a head and a tail; of the outer levels each entry begins a line.

    What fits on a line stays on one, and what lies deeper fills lines.
    """
    text = f"{head}{json.dumps(value)}{tail}"
    if len(text) <= _WIDTH or not levels or isinstance(value, str):
        yield from _filled(text)
        return
    named = isinstance(value, dict)
    heads = [f"{json.dumps(key)}: " for key in value] if named else [""] * len(value)
    entries = value.values() if named else value
    tails = [","] * (len(value) - 1) + [""]
    yield head + ("{" if named else "[")
    for around in zip(heads, entries, tails, strict=True):
        yield from (f" {line}" for line in _lines(around[0], around[1], levels - 1, around[2]))
    yield ("}" if named else "]") + tail


def _filled(text: str) -> Iterator[str]:
    """Lines of JSON that are broken only between entries."""
    line = ""
    for piece in _PIECE.findall(text):
        if line and len(line + piece) > _WIDTH:
            yield line.rstrip()
            line = " "
        line += piece
    yield line


def system_table(form: SimulationForm) -> dict[str, Any]:
    """Table of a system: configurations, transitions, parameters with domains, spectrum."""
    system, spectrum = form.system, form.spectrum
    return {
        "name": system.name,
        "description": system.description,
        "states": [str(s) for s in system.states],
        "parameters": [_parameter(p) for p in system.parameters],
        "constraints": [{"text": f"{c} >= 0", "terms": _products(c)} for c in system.constraints],
        "configurations": {
            c.name: [{"name": b.name, "acts_when": b.acts_when} for b in c.boundaries]
            for c in system.configurations
        },
        "spectrum": [str(s) for s in spectrum.symbols],
        "spectrum_parameters": [str(s) for s in spectrum.parameters],
        **form.table(),
    }


def orbit_table(orbit: EquationSystem) -> dict[str, Any]:
    """Table of all that the runtime has to know of an orbit beside its kernels."""
    itinerary, reduction = orbit.itinerary, orbit.reduction
    by_name = {p.name: p for p in orbit.system.parameters}
    presentation = itinerary.presentation
    return {
        "derived": True,
        "phases": _phases(itinerary),
        "states": [str(s) for s in orbit.system.states],
        "parameters": [_parameter(by_name[str(s)]) for s in orbit.parameters],
        "open_parameters": [_parameter(by_name[str(s)]) for s in orbit.open_parameters],
        "other_parameters": [_parameter(p) for p in _others(orbit)],
        "combined": _combined(presentation) if presentation else {},
        "unknowns": [str(u) for u in orbit.unknowns],
        "dwell_times": [str(link.dwell) for link in orbit.chain.links],
        "durations": [_linear(link.duration) for link in orbit.chain.links],
        "equations": [meaning for meaning, _ in orbit.equations],
        "reduced": reduced_names(orbit),
        "rank": reduction.rank,
        "section": list(map(str, orbit.chain.coordinates)),
        "conservative": orbit.conservative,
        "reciprocal_pair": orbit.reciprocal_pair,
        "required": {str(p): str(value) for p, value in orbit.required.items()},
        "vanishing": list(itinerary.vanishing),
        "levels": _levels(orbit),
        "resets": [[[str(e) for e in row] for row in k.reset.tolist()] for k in orbit.chain.links],
        "measures": [str(s) for s in orbit.measures],
        "terms": [len(w) for w in orbit.frequencies] if orbit.trigonometric else None,
        "boundaries": [
            [
                b.phase,
                b.boundary,
                None if b.open_parameter is None else str(b.open_parameter),
                float(b.open_coefficient),
                b.begins,
            ]
            for b in orbit.boundary_functions
        ],
        "reference": _reference(itinerary),
    }


def composed_table(orbit: Underived) -> dict[str, Any]:
    """Table from which the runtime composes an orbit that has no kernels.

    A reference in other coordinates or parameters than the system's is left out.
    """
    itinerary = orbit.itinerary
    period = itinerary.period
    return {
        "derived": False,
        "reason": orbit.reason,
        "phases": _phases(itinerary),
        "start": dict(itinerary.start),
        "period": None if period is None else _parameter(period),
        "symmetry": {str(s): str(image) for s, image in itinerary.symmetry.items()},
        "reference": None if itinerary.presentation else _reference(itinerary),
    }


def _phases(itinerary: Itinerary) -> list[list[str]]:
    return [[p.configuration, p.boundary, p.dwell_time] for p in itinerary.phases]


def _reference(itinerary: Itinerary) -> dict[str, dict[str, str]] | None:
    known = itinerary.reference
    if known is None:
        return None
    return {"parameters": dict(known.parameters), "guess": dict(known.guess)}


def _levels(orbit: EquationSystem) -> dict[str, str]:
    """Value at which a boundary lies, by the state that alone occurs in it.

    It is a stop's place, or the velocity of a belt.
    """
    found = {}
    for phase in orbit.itinerary.phases:
        for boundary in orbit.system.configuration(phase.configuration).boundaries:
            row, constant = orbit.system.gradient(boundary.function)
            involved = [(s, n) for s, n in zip(orbit.system.states, row, strict=True) if n != 0]
            if len(involved) == 1:
                ((state, slope),) = involved
                level = sp.cancel(-constant / slope)
                if level.is_Symbol or level.is_number:
                    found[str(state)] = str(level)
    return found


def _others(orbit: EquationSystem) -> list[Parameter]:
    """Parameters of the system on which neither the equations nor admissibility depend.

    Among them are those that are solved for, that the orbit requires to have a value, or
    that the presentation replaces.
    """
    declared = (*orbit.itinerary.system.parameters, *orbit.system.parameters)
    used = {str(s) for s in (*orbit.parameters, *orbit.open_parameters)}
    return list({p.name: p for p in declared if p.name not in used}.values())


def _parameter(parameter: Parameter) -> dict[str, Any]:
    return {
        "name": parameter.name,
        "description": parameter.description,
        "lower": None if parameter.lower == -sp.oo else str(parameter.lower),
        "upper": None if parameter.upper == sp.oo else str(parameter.upper),
        "closed": parameter.closed,
        "upper_closed": parameter.upper_closed,
    }


def _combined(presentation: Presentation) -> dict[str, dict[str, int]]:
    """New parameters as sums of multiples of the system's parameters, as in e = ur - us."""
    symbols = [p.symbol for p in presentation.parameters]
    rules = [
        sp.Eq(old, new)
        for old, new in presentation.substitution.items()
        if new.free_symbols & set(symbols)
    ]
    solution = sp.solve(rules, symbols, dict=True)[0] if rules else {}
    return {str(s): _linear(solution[s]) for s in symbols}


def _products(expression: sp.Expr) -> dict[str, int]:
    """Integer factors by products of parameters; the sum has the sign of the expression.

    The expression is a rational function of the parameters.
    """
    numerator, denominator = sp.fraction(sp.together(expression))
    terms = sp.expand(numerator * denominator).as_coefficients_dict()
    scale = sp.ilcm(*(factor.q for factor in terms.values()))
    return {str(product): int(scale * factor) for product, factor in terms.items() if factor}


def _linear(expression: sp.Expr) -> dict[str, int]:
    terms = sp.expand(expression).as_coefficients_dict()
    return {str(symbol): int(factor) for symbol, factor in terms.items() if factor}

"""Documents of the built-in orbits, and their formulas read back: LaTeX, evaluated."""

from __future__ import annotations

import math
import random
import re
from collections.abc import Mapping
from functools import cache
from typing import Any

import numpy as np
import sympy as sp

import nonsmooth as ns
from nonsmooth.derive import EquationSystem, Itinerary, derive_equations
from nonsmooth.derive.document.blocks import Document, Line
from nonsmooth.derive.document.describe import describe_orbit
from nonsmooth.derive.document.printer import Notation
from nonsmooth.derive.document.view import naming_of
from nonsmooth.derive.equations.explicit import Angle
from nonsmooth.derive.equations.program import Stage
from nonsmooth.derive.systems import SYSTEMS, declaration
from nonsmooth.runtime.orbits.orbit import Orbit
from tests.formulas.responses import response_functions
from tests.formulas.values import Reading, name_of

REVERSIBLE = ["rigid-stop/one-impact", "elastic-stop/one-contact", "dry-friction/symmetric"]
CONSERVATIVE = ["rigid-stop/one-impact", "elastic-stop/one-contact"]
ORBITS = [f"{name}/{orbit.name}" for name in SYSTEMS for orbit in declaration(name).orbits]


class Reader:
    """Evaluate the LaTeX of a right-hand side, knowing the values of the symbols as written."""

    def __init__(self, values: Mapping[str, Any]) -> None:
        self.reading = Reading({name_of(name): value for name, value in values.items()})

    def __call__(self, latex: str) -> Any:
        return self.reading.latex(latex)

    def matrix(self, latex: str) -> np.ndarray:
        """Evaluate a matrix, or the transposed one of a row."""
        found = np.atleast_2d(self.reading.latex(latex.replace(r"^{\mathsf{T}}", "")))
        return found.T if r"^{\mathsf{T}}" in latex else found


class Written:
    """An orbit with its document, and numbers for all that stands in it."""

    def __init__(self, equations: EquationSystem) -> None:
        self.equations = equations
        self.notation: Notation = naming_of(equations).notation
        self.document: Document = describe_orbit(equations)

    @property
    def lines(self) -> list[Line]:
        return [line for formula in self.document.formulas for line in formula.lines]

    def line(self, left: str) -> Line:
        """The only line with that left-hand side."""
        (found,) = (line for line in self.lines if line.left == left)
        return found

    def complete(self, known: Any) -> Any:
        """Spectrum and functions of time from parameters and dwell times."""
        known = dict(known)
        for symbol, expression in self.equations.spectrum.entries:
            known[symbol] = float(expression.xreplace(known))
        for symbol, expression in self.notation.functions.items():
            known[symbol] = float(expression.xreplace(known))
        return known

    def drawn(self, seed: int) -> Any:
        """Any numbers: of parameters and dwell times, and of every symbol of the lines."""
        draw = random.Random(seed)
        dwell_times = [link.dwell for link in self.equations.chain.links]
        shown = {
            s for line in self.lines if line.shows is not None for s in line.shows.free_symbols
        }
        shown |= {line.subject for line in self.lines if isinstance(line.subject, sp.Symbol)}
        parameters = list(self.notation.constants)
        settled = {*self.equations.spectrum.symbols, *self.notation.functions}
        names = {*dwell_times, *shown, *parameters} - settled
        known = {s: draw.uniform(0.2, 0.9) for s in sorted(names, key=str)}
        for cosine, sine in self.angles.values():
            angle = draw.uniform(0, 2 * math.pi)
            known |= {cosine: math.cos(angle), sine: math.sin(angle)}
        return self.complete(known)

    @property
    def angles(self) -> dict[str, tuple[sp.Symbol, sp.Symbol]]:
        """Angles that are written, by the symbols of their cosines and sines."""
        subjects = [line.subject for line in self.lines if isinstance(line.subject, sp.Symbol)]
        written = {self.notation.symbol(s): s for s in subjects}
        return {
            text.removeprefix(r"\cos "): (cosine, written[text.replace(r"\cos", r"\sin", 1)])
            for text, cosine in written.items()
            if text.startswith(r"\cos ")
        }

    def at(self, orbit: Orbit) -> Any:
        """The numbers of a solved orbit, all stages included."""
        named = {str(s): s for s in (*self.equations.unknowns, *self.notation.constants)}
        named |= {p.name: p.symbol for p in self.equations.system.parameters}
        found = {named[n]: float(v) for n, v in orbit.values.items() if n in named}
        found |= {s: float(v) for s, v in self.equations.required.items()}
        for link in self.equations.chain.links:
            if link.dwell not in found:
                found[link.dwell] = float(sp.sympify(link.duration).xreplace(found))
        return self.run(self.complete(found), (*self.equations.chain.stages,))

    def run(self, known: Any, stages: tuple[Stage, ...]) -> Any:
        """Run stages on numbers."""
        known = dict(known)
        for stage in stages:
            for symbol, expression in stage.assignments:
                known[symbol] = float(expression.xreplace(known))
        return known

    def responses(self, numbers: Any) -> dict[str, Any]:
        """Impulse responses, where motions are written in them."""
        known = self.notation.responses
        return response_functions(known, numbers) if known.factors else {}

    def reader(self, numbers: Any) -> Reader:
        """Read with these numbers, and with what the document names on the way."""
        names: dict[str, Any] = {r"\pi": math.pi}
        for symbol, value in numbers.items():
            if symbol in self.notation.functions:
                continue
            names[self.notation.symbol(symbol)] = float(value)
        for angle, (cosine, sine) in self.angles.items():
            if {cosine, sine} <= numbers.keys():
                names[angle] = math.atan2(numbers[sine], numbers[cosine])
        names |= {r"\mathrm{i}": 1j} if self.angles else {}
        names |= self.responses(numbers)
        for line in self.lines:
            if line.shows is None or not line.shows.free_symbols <= {*numbers}:
                continue
            if re.fullmatch(r"(?:\\kappa|f|S)_\{\d+\}", line.left):
                names[line.left] = value_of(line, numbers)
        return Reader(names)


def value_of(line: Line, numbers: Any) -> Any:
    """What the derivation computes for a line."""
    found = sp.sympify(line.shows.xreplace(numbers))
    found = found.replace(Angle, lambda s, c: math.atan2(s, c) % (2 * math.pi))
    return np.array(found.tolist(), dtype=float) if line.shows.is_Matrix else float(found)


def text_of(line: Line) -> str:
    """Right-hand side of a line, without what ends the sentence."""
    text = " ".join(line.pieces).rstrip()
    return re.sub(r"(\s*=\s*0)?[,.]?$", "", text)


def declared_as(name: str) -> Itinerary:
    """The declaration of ``system/orbit``."""
    system, _, orbit = name.partition("/")
    (found,) = (o for o in declaration(system).orbits if o.name == orbit)
    return found


@cache
def written_of(name: str) -> Written:
    """The document of ``system/orbit``."""
    return Written(derive_equations(declared_as(name)))


@cache
def solved_of(name: str) -> Orbit:
    """The orbit at its default parameters."""
    return ns.solve(name)

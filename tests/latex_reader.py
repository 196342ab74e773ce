"""Documents of the built-in orbits, and their formulas read back: LaTeX, evaluated."""

import math
import random
import re
from functools import cache

import numpy as np
import sympy as sp

from nonsmooth.derive import derive_equations
from nonsmooth.derive.document.describe import describe_orbit
from nonsmooth.derive.equations.explicit import Angle
from nonsmooth.derive.systems import SYSTEMS, declaration
from tests.declared import itinerary_of
from tests.formulas.responses import response_functions
from tests.formulas.values import Reading, name_of
from tests.shared import shared_value

ORBITS = [f"{name}/{orbit.name}" for name in SYSTEMS for orbit in declaration(name).orbits]


def reading(values):
    """A reader of LaTeX, knowing the values of the symbols as written."""
    return Reading({name_of(name): value for name, value in values.items()})


class Written:
    """An orbit with its document, and numbers for all that stands in it."""

    def __init__(self, equations):
        self.equations, itinerary = equations, equations.itinerary
        self.name = f"{itinerary.system.name}/{itinerary.name}"
        self.document = describe_orbit(equations)
        self.notation = self.document.shown.notation

    @property
    def lines(self):
        return [line for formula in self.document.formulas for line in formula.lines]

    def line(self, left):
        """The only line with that left-hand side."""
        (found,) = (line for line in self.lines if line.left == left)
        return found

    def complete(self, known):
        """Spectrum and functions of time from parameters and dwell times."""
        known = dict(known)
        for symbol, expression in self.equations.spectrum.entries:
            known[symbol] = float(expression.xreplace(known))
        for symbol, expression in self.notation.functions.items():
            known[symbol] = float(expression.xreplace(known))
        return known

    def drawn(self, seed):
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
    def angles(self):
        """Angles that are written, by the symbols of their cosines and sines."""
        subjects = [line.subject for line in self.lines if isinstance(line.subject, sp.Symbol)]
        written = {self.notation.symbol(s): s for s in subjects}
        return {
            text.removeprefix(r"\cos "): (cosine, written[text.replace(r"\cos", r"\sin", 1)])
            for text, cosine in written.items()
            if text.startswith(r"\cos ")
        }

    def at(self, orbit):
        """The numbers of a solved orbit, all stages included."""
        named = {str(s): s for s in (*self.equations.unknowns, *self.notation.constants)}
        named |= {p.name: p.symbol for p in self.equations.system.parameters}
        found = {named[n]: float(v) for n, v in orbit.values.items() if n in named}
        found |= {s: float(v) for s, v in self.equations.required.items()}
        for link in self.equations.chain.links:
            if link.dwell not in found:
                found[link.dwell] = float(sp.sympify(link.duration).xreplace(found))
        return self.run(self.complete(found), (*self.equations.chain.stages,))

    def run(self, known, stages):
        """Run stages on numbers."""
        known = dict(known)
        for stage in stages:
            for symbol, expression in stage.assignments:
                known[symbol] = float(expression.xreplace(known))
        return known

    def reader(self, numbers):
        """Read with these numbers, and with what the document names on the way."""
        names = {r"\pi": math.pi}
        for symbol, value in numbers.items():
            if symbol in self.notation.functions:
                continue
            names[self.notation.symbol(symbol)] = float(value)
        for angle, (cosine, sine) in self.angles.items():
            if {cosine, sine} <= numbers.keys():
                names[angle] = math.atan2(numbers[sine], numbers[cosine])
        names |= {r"\mathrm{i}": 1j} if self.angles else {}
        known = self.notation.responses
        names |= response_functions(known, numbers) if known.factors else {}
        for line in self.lines:
            if line.shows is None or not line.shows.free_symbols <= {*numbers}:
                continue
            if re.fullmatch(r"(?:\\kappa|f|S)_\{\d+\}", line.left):
                names[line.left] = value_of(line, numbers)
        return reading(names)


def value_of(line, numbers):
    """What the derivation computes for a line."""
    found = sp.sympify(line.shows.xreplace(numbers))
    found = found.replace(Angle, lambda s, c: math.atan2(s, c) % (2 * math.pi))
    return np.array(found.tolist(), dtype=float) if line.shows.is_Matrix else float(found)


def text_of(line):
    """Right-hand side of a line, without what ends the sentence."""
    text = " ".join(line.pieces).rstrip()
    return re.sub(r"(\s*=\s*0)?[,.]?$", "", text)


@cache
def written_of(name):
    """The document of ``system/orbit``."""
    return shared_value(f"written {name}", lambda: Written(derive_equations(itinerary_of(name))))

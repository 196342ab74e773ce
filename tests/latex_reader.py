"""Documents of the built-in orbits, and their formulas read back: LaTeX, evaluated."""

from __future__ import annotations

import math
import random
import re
from collections.abc import Iterator, Mapping
from functools import cache
from typing import Any

import numpy as np
import sympy as sp

import nonsmooth as ns
from nonsmooth.derive.document.blocks import Document, Line
from nonsmooth.derive.document.centres import Centres
from nonsmooth.derive.document.describe import describe_orbit
from nonsmooth.derive.document.symbols import Notation
from nonsmooth.derive.document.view import view_of
from nonsmooth.derive.equations import EquationSystem, derive_equations
from nonsmooth.derive.itinerary import Itinerary
from nonsmooth.derive.program import Stage
from nonsmooth.derive.systems import SYSTEMS, declaration
from nonsmooth.runtime.orbit import Orbit

REVERSIBLE = ["rigid-stop/one-impact", "elastic-stop/one-contact", "dry-friction/symmetric"]
CONSERVATIVE = ["rigid-stop/one-impact", "elastic-stop/one-contact"]
ORBITS = [f"{name}/{orbit.name}" for name in SYSTEMS for orbit in declaration(name).orbits]

Numbers = dict[sp.Symbol, float]


class Reader:
    """Evaluate the LaTeX of a right-hand side, knowing the values of the symbols as written."""

    def __init__(self, values: Mapping[str, Any]) -> None:
        self.values = {_plain(name): value for name, value in values.items()}
        names = "|".join(re.escape(n) for n in sorted(self.values, key=len, reverse=True))
        self.token = re.compile(
            rf"\s*(?:(?P<name>{names})(?![A-Za-z])|(?P<number>\d+)|(?P<sign>[-+()^{{}}/])"
            r"|(?P<word>\\[A-Za-z]+)|\\[,;]|(?P<end>$))"
        )

    def __call__(self, latex: str) -> Any:
        self.tokens = list(self.scan(_plain(latex)))
        value = self.sum()
        assert not self.tokens, self.tokens
        return value

    def matrix(self, latex: str) -> np.ndarray:
        """Evaluate the entries of a matrix."""
        (entries,) = re.findall(r"\\begin\{matrix\}(.*?)\\end\{matrix\}", latex)
        rows = re.split(r"\\\\", entries)
        found = np.array([[self(entry) for entry in row.split("&")] for row in rows])
        return found.T if r"^{\mathsf{T}}" in latex else found

    def scan(self, text: str) -> Iterator[tuple[str, str]]:
        position = 0
        while position < len(text):
            match = self.token.match(text, position)
            assert match, f"unreadable: {text[position : position + 60]}"
            position = match.end()
            if match.lastgroup and match.lastgroup != "end":
                yield match.lastgroup, match[match.lastgroup]

    def peek(self) -> str:
        return self.tokens[0][1] if self.tokens else ""

    def sum(self) -> Any:
        total: Any = 0.0
        while self.tokens and self.peek() not in (")", "}"):
            sign = 1.0
            if self.peek() in ("+", "-"):
                sign = -1.0 if self.tokens.pop(0)[1] == "-" else 1.0
            total += sign * self.product()
        return total

    def product(self) -> Any:
        value = self.factor()
        while self.tokens and self.peek() not in ("+", "-", ")", "}"):
            if self.peek() == "/":
                self.tokens.pop(0)
                value /= self.factor()
            else:
                value *= self.factor()
        return value

    def group(self) -> Any:
        self.tokens.pop(0)
        value = self.sum()
        self.tokens.pop(0)
        return value

    def factor(self) -> Any:
        kind, text = self.tokens[0]
        value: Any
        if text in ("(", "{"):
            value = self.group()
        else:
            self.tokens.pop(0)
            if kind == "name":
                value = self.values[text]
            elif kind == "number":
                value = float(text)
            elif text == r"\frac":
                value = self.group()
                value /= self.group()
            elif text == r"\sqrt":
                value = math.sqrt(self.group())
            elif text in (r"\cos", r"\sin", r"\cosh", r"\sinh"):
                value = getattr(math, text[1:])(self.argument())
            else:
                raise AssertionError(text)
        if self.peek() == "^":
            self.tokens.pop(0)
            value = value ** self.group()
        return value

    def argument(self) -> Any:
        """What a cosine or sine is of: a group, or the symbols that follow."""
        if self.peek() == "(":
            return self.group()
        value = 1.0
        while self.tokens and isinstance(self.values.get(self.peek()), float):
            value *= self.values[self.tokens.pop(0)[1]]
        return value


def _plain(latex: str) -> str:
    return re.sub(r"\\(left|right|biggl|biggr)(?=[()])", "", latex).replace(r"\qquad", " ")


class Written:
    """An orbit with its document, and numbers for all that stands in it."""

    def __init__(self, equations: EquationSystem) -> None:
        self.equations = equations
        naming, centres = view_of(equations)
        self.notation: Notation = naming.notation
        self.centres: Centres = centres
        self.document: Document = describe_orbit(equations)

    @property
    def lines(self) -> list[Line]:
        return [line for formula in self.document.formulas for line in formula.relations]

    def line(self, left: str) -> Line:
        """The only line with that left-hand side."""
        (found,) = (line for line in self.lines if line.left == left)
        return found

    def complete(self, known: Numbers) -> Numbers:
        """Spectrum, centres and functions of time from parameters and dwell times."""
        known = dict(known)
        for symbol, expression in self.equations.spectrum.entries:
            known[symbol] = float(expression.xreplace(known))
        for symbol, expression in self.centres.values.items():
            known[symbol] = float(expression.xreplace(known))
        for symbol, expression in self.notation.functions.items():
            known[symbol] = float(expression.xreplace(known))
        return known

    def drawn(self, seed: int) -> Numbers:
        """Any numbers: of parameters and dwell times, and of every symbol of the lines."""
        draw = random.Random(seed)
        dwell_times = [link.dwell for link in self.equations.chain.links]
        shown = {
            s for line in self.lines if line.shows is not None for s in line.shows.free_symbols
        }
        shown |= {line.subject for line in self.lines if isinstance(line.subject, sp.Symbol)}
        parameters = [s for s in self.notation.constants if s not in self.centres.values]
        settled = {*self.equations.spectrum.symbols, *self.notation.functions}
        names = {*dwell_times, *shown, *parameters} - settled
        return self.complete({s: draw.uniform(0.2, 0.9) for s in sorted(names, key=str)})

    def at(self, orbit: Orbit) -> Numbers:
        """The numbers of a solved orbit, all stages included."""
        named = {str(s): s for s in (*self.equations.unknowns, *self.notation.constants)}
        named |= {p.name: p.symbol for p in self.equations.system.parameters}
        found = {named[n]: float(v) for n, v in orbit.values.items() if n in named}
        found |= {s: float(v) for s, v in self.equations.required.items()}
        for link in self.equations.chain.links:
            if link.dwell not in found:
                found[link.dwell] = float(sp.sympify(link.duration).xreplace(found))
        return self.run(self.complete(found), (*self.equations.chain.stages,))

    def run(self, known: Numbers, stages: tuple[Stage, ...]) -> Numbers:
        """Run stages on numbers."""
        known = dict(known)
        for stage in stages:
            for symbol, expression in stage.assignments:
                known[symbol] = float(expression.xreplace(known))
        return known

    def reader(self, numbers: Numbers) -> Reader:
        """Read with these numbers, and with what the document names on the way."""
        names: dict[str, Any] = {}
        for symbol, value in numbers.items():
            if symbol in self.notation.functions:
                continue
            names[self.notation.symbol(symbol)] = float(value)
        for line in self.lines:
            if line.shows is None or not line.shows.free_symbols <= {*numbers}:
                continue
            if line.left in (r"\kappa", "D(T)"):
                names[line.left] = value_of(line, numbers)
            match = re.match(r"S_\{(\d+)\} = ", "".join(line.pieces))
            if match:
                for (i, j), value in np.ndenumerate(value_of(line, numbers)):
                    names[rf"\left(S_{{{match[1]}}}\right)_{{{i + 1}{j + 1}}}"] = float(value)
        return Reader(names)


def value_of(line: Line, numbers: Numbers) -> Any:
    """What the derivation computes for a line."""
    assert line.shows is not None
    found = line.shows.xreplace(numbers)
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
    found = ns.solve(name)
    assert isinstance(found, Orbit)
    return found

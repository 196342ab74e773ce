"""The documents of the built-in orbits: complete, and equal to what the kernels compute."""

import re
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
import sympy as sp

import nonsmooth as ns
from nonsmooth.derive import derive_equations
from nonsmooth.derive.document.blocks import Formula, Paragraph
from tests.declared import itinerary_of
from tests.documents import derived, marked
from tests.latex_reader import ORBITS, Written, reading, text_of, value_of, written_of
from tests.tables import slow

TIME = sp.Symbol("t", real=True)


VARIANTS = {
    "with full closure": lambda: replace(itinerary_of("elastic-stop/one-contact"), reversor={}),
    "behind the collision": lambda: itinerary_of("dry-friction/solution-ii").rotated(1),
}


GALLERY = ("mass_on_belt/stick-slip", "two_belts/second-sticks")
FORCED = (
    "impact_oscillator/one-period",
    # matrices with entries that stand below them
    "impact_damper/struck-twice",
)


@cache
def described(name):
    if name in VARIANTS:
        return Written(derive_equations(VARIANTS[name]()))
    found = written_of(name) if name in ORBITS else derived(name)
    assert found
    return found


SLOW = [slow(name) for name in (*VARIANTS, *GALLERY)]


# of the paper's orbits one of each system
PAPERS = marked(ORBITS, "elastic-stop")


@pytest.fixture(params=[*PAPERS, *marked(FORCED), *SLOW])
def written(request):
    return described(request.param)


@pytest.fixture(params=PAPERS)
def solved(request):
    return described(request.param)


def test_each_symbol_is_defined_before_it_is_used(written):
    """Of parameters, states, unknowns and what lines define; resets and derivatives have words."""
    equations, notation = written.equations, written.notation
    known = {TIME, *notation.constants, *notation.start, *notation.functions}
    known |= {*equations.unknowns, *equations.vanishing, *(k.dwell for k in equations.chain.links)}
    known |= {equations.itinerary.period.symbol} if equations.itinerary.period else set()
    known -= {*equations.spectrum.symbols}
    told = re.compile(rf"({'|'.join(map(str, notation.states))})(_0|_\d+_reset||)|\w+_by_\w+")
    for line in written.lines:
        used = line.shows.free_symbols if line.shows is not None else set()
        assert not {s for s in used - known if not told.fullmatch(str(s))}, line.latex
        if isinstance(line.subject, sp.Symbol):
            known.add(line.subject)


def test_formulas_show_what_the_kernels_compute(written):
    numbers = written.drawn(7)
    read, checked = written.reader(numbers), 0
    for line in written.lines:
        if not isinstance(line.shows, sp.Expr):
            continue
        text = text_of(line)
        if line.shows.is_Matrix:
            if not line.left.startswith(r"\Phi"):
                computed = value_of(line, numbers)
                shown = np.eye(len(computed)) if text == "I" else np.atleast_2d(read.latex(text))
                assert shown == pytest.approx(computed, rel=1e-11), text
            continue
        computed = value_of(line, numbers)
        assert read.latex(text) == pytest.approx(computed, rel=1e-10, abs=1e-11), text
        checked += 1
    assert checked > 25 or len(written.equations.system.states) < 4


def test_every_stage_of_the_derivation_is_shown(written):
    equations = written.equations
    shown = {(line.subject, line.shows) for line in written.lines}
    subjects = {subject for subject, _ in shown}
    functions = written.notation.functions
    for stage in (*equations.chain.stages, *equations.reduction.stages):
        for symbol, expression in stage.assignments:
            elsewhere = str(symbol).endswith("_reset") or expression in equations.chain.start.state
            assert symbol in functions or elsewhere or (symbol, expression) in shown, symbol
    flows = [link.flow for link in equations.chain.links]
    used = {s for f in flows for e in (*f.basis, *f.matrices, *f.offsets) for s in e.free_symbols}
    for symbol, expression in reversed(equations.spectrum.entries):
        if symbol in used:
            assert (symbol, expression) in shown
            used |= expression.free_symbols
    assert {u for u in equations.unknowns if u in equations.reduction.values} <= {
        *subjects,
        *equations.reduction.unknowns,
        *(e.unknown for e in equations.reduction.eliminations),
    }


def test_the_equations_are_all_there(written):
    equations, document = written.equations, written.document
    formulas = [b for b in document.section("The equations") if isinstance(b, Formula)]
    assert [f.lines[0].shows for f in formulas] == equations.residual
    reduced = [b for b in document.section("The reduction") if isinstance(b, Formula) and b.label]
    left = [e for _, e in equations.reduction.equations]
    assert [f.lines[0].shows for f in reduced] == ([] if left == equations.residual else left)


# --- derivatives, stability and energy


def test_the_trace_as_written_is_that_of_the_kernel(solved):
    orbit, equations = ns.solve(solved.name), solved.equations
    trace, numbers = float(orbit.evaluate("trace")), solved.at(orbit)
    if equations.conservative:
        line = solved.line(r"\operatorname{tr} \mathcal{M}")
        assert solved.reader(numbers).latex(text_of(line)) - 1 == pytest.approx(trace, abs=1e-9)
    elif solved.name == "dry-friction/global-stick":
        symbols = {str(s): s for s in numbers}
        own = {u: numbers[symbols[str(u)]] for u in equations.reduction.unknowns}
        numbers = solved.run({**numbers, **own}, equations.trace_program.stages)
        (line,) = (x for x in solved.lines if x.shows == equations.trace)
        assert solved.reader(numbers).latex(text_of(line)) == pytest.approx(trace, abs=1e-9)


def test_the_entries_of_the_map_as_written_are_those_of_the_kernel(solved):
    """Their values are in the last section, and the lines from which they are computed as well."""
    orbit, size = ns.solve(solved.name), range(1, len(solved.equations.chain.coordinates) + 1)
    kernel = np.array(orbit.evaluate("poincare_jacobian"), dtype=float)
    numbers = solved.run(solved.at(orbit), solved.equations.map_program.stages)
    read = solved.reader(numbers)
    lines = [[solved.line(f"J_{{{i}{j}}}") for j in size] for i in size]
    found = [[read.latex(text_of(line)) for line in row] for row in lines]
    assert np.array(found) == pytest.approx(kernel, abs=1e-9)
    last = [b for b in solved.document.section("The reference orbit") if isinstance(b, Formula)]
    (matrix,) = (line for formula in last for line in formula.lines if line.left == "J")
    assert np.atleast_2d(read.latex(text_of(matrix))) == pytest.approx(kernel, abs=1e-9)


def test_the_reference_orbit_is_the_one_that_is_solved(solved):
    orbit = ns.solve(solved.name)
    section = solved.document.section("The reference orbit")
    formulas = [b for b in section if isinstance(b, Formula)]
    shown = {line.left: " ".join(line.pieces) for f in formulas for line in f.lines}
    for unknown in solved.equations.unknowns:
        value = float(shown[solved.notation.symbol(unknown)])
        assert value == pytest.approx(float(orbit.values[str(unknown)]), abs=1e-10)
    assert float(shown[r"\text{period}"]) == pytest.approx(float(orbit.period), abs=1e-10)
    assert float(shown[r"\operatorname{tr} J"]) == pytest.approx(float(orbit.trace), abs=1e-9)
    told = " ".join(b.text for b in section if isinstance(b, Paragraph)).rpartition("multiplier")[2]
    reader = reading({r"\mathrm{i}": 1j})
    multipliers = [complex(reader.latex(text)) for text in re.findall(r"\$([^$]+)\$", told)]
    theirs = [complex(m) for m in orbit.multipliers]
    assert len(multipliers) == len(theirs)
    for multiplier in theirs:
        assert min(abs(multiplier - m) for m in multipliers) < 1e-8

"""The documents of the built-in orbits: complete, and equal to what the kernels compute."""

import re
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
import sympy as sp

from nonsmooth.derive import derive_equations
from nonsmooth.derive.document.blocks import Formula, Table
from nonsmooth.derive.document.hypertext import to_markdown
from nonsmooth.derive.equations.section import start_of
from nonsmooth.derive.equations.symmetry import end_conditions
from nonsmooth.derive.flows.modal import TIME
from tests.documents import derived, labels_by_section, marked
from tests.latex_reader import (
    ORBITS,
    REVERSIBLE,
    Reader,
    Written,
    declared_as,
    solved_of,
    text_of,
    value_of,
    written_of,
)


@pytest.fixture(params=ORBITS)
def name(request: pytest.FixtureRequest) -> str:
    return str(request.param)


@pytest.fixture
def written(name: str) -> Written:
    return written_of(name)


VARIANTS = {
    "with full closure": lambda: replace(declared_as("elastic-stop/one-contact"), reversor={}),
    "from the second phase": lambda: declared_as("dry-friction/symmetric").rotated(1),
    "from the third phase": lambda: declared_as("dry-friction/global-stick").rotated(2),
    "behind the collision": lambda: declared_as("dry-friction/solution-ii").rotated(1),
}


GALLERY = ("mass_on_belt/stick-slip", "two_belts/both-stick", "two_belts/second-sticks")
LONG = ("from the third phase", "behind the collision", *GALLERY)


FORCED = (
    "impact_oscillator/one-period",
    "jenkins/yielding-both-ways",
    "brake_pad/lifting",
    "piecewise_stiffness/doubled",
    # matrices with entries that stand below them
    "impact_damper/struck-twice",
    "beam/one-contact",
)


def test_each_symbol_is_defined_before_it_is_used(name: str) -> None:
    """Of parameters, states, unknowns and what lines define; resets and derivatives have words."""
    defined_in_order(written_of(name))


def defined_in_order(written: Written) -> None:
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


@pytest.mark.parametrize("name", marked(FORCED))
def test_forced_orbits_have_documents_as_true(name: str) -> None:
    written = derived(name)
    test_formulas_show_what_the_kernels_compute(written)
    test_every_stage_of_the_derivation_is_shown(written)
    test_the_equations_are_all_there(written)
    defined_in_order(written)


@pytest.mark.slow
@pytest.mark.parametrize("name", marked((*VARIANTS, *GALLERY), *LONG))
def test_other_itineraries_have_documents_as_true(name: str) -> None:
    written = Written(derive_equations(VARIANTS[name]())) if name in VARIANTS else derived(name)
    defined_in_order(written)
    if name in GALLERY:
        test_flows_show_what_the_kernels_compute(written)
        test_one_letter_stands_for_one_thing(written)
    test_formulas_show_what_the_kernels_compute(written)
    test_every_stage_of_the_derivation_is_shown(written)
    test_the_equations_are_all_there(written)
    test_everything_is_named(written)


def test_formulas_show_what_the_kernels_compute(written: Written) -> None:
    numbers = written.drawn(7)
    read, checked = written.reader(numbers), 0
    for line in written.lines:
        if not isinstance(line.shows, sp.Expr):
            continue
        text = text_of(line)
        if line.shows.is_Matrix:
            if not line.left.startswith(r"\Phi"):
                computed = value_of(line, numbers)
                shown = np.eye(len(computed)) if text == "I" else read.matrix(text)
                assert shown == pytest.approx(computed, rel=1e-11), text
            continue
        assert read(text) == pytest.approx(value_of(line, numbers), rel=1e-10, abs=1e-11), text
        checked += 1
    assert checked > 25 or len(written.equations.system.states) < 4


def test_flows_show_what_the_kernels_compute(written: Written) -> None:
    numbers = written.drawn(3) | {TIME: 0.7}
    names: dict[str, Any] = {written.notation.symbol(s): v for s, v in numbers.items()}
    half = len(written.equations.system.states) // 2
    names["I"] = np.eye(half)
    blocks: dict[str, np.ndarray] = {}
    for line in written.lines:
        definition = r"(P_\{\d+\}) = \\left\(\\begin\{matrix\}(.*?)\\end\{matrix\}\\right\)"
        for letter, entries in re.findall(definition, line.latex):
            names[letter] = Reader(names).matrix(rf"\begin{{matrix}}{entries}\end{{matrix}}")
        for place in re.findall(r"\\Phi_\{(\d+)\}\^\{(\d)(\d)\}", line.left):
            blocks["".join(place)] = Reader(names)(" ".join(line.pieces)) + np.zeros((half, half))
    flows = {link.flow.configuration: link.flow for link in written.equations.chain.links}
    assert len(blocks) == 4 * len(flows)
    for number, flow in enumerate(flows.values(), start=1):
        shown = np.block([[blocks[f"{number}{i}{j}"] for j in (1, 2)] for i in (1, 2)])
        computed = np.array(flow.matrix().xreplace(numbers).tolist(), dtype=float)
        assert shown == pytest.approx(computed, rel=1e-11, abs=1e-12)


def test_every_stage_of_the_derivation_is_shown(written: Written) -> None:
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


def test_the_equations_are_all_there(written: Written) -> None:
    equations, document = written.equations, written.document
    formulas = [b for b in document.section("The equations") if isinstance(b, Formula)]
    assert [f.lines[0].shows for f in formulas] == equations.residual
    reduced = [b for b in document.section("The reduction") if isinstance(b, Formula) and b.label]
    left = [e for _, e in equations.reduction.equations]
    assert [f.lines[0].shows for f in reduced] == ([] if left == equations.residual else left)
    labels = [f.label for f in document.formulas if f.label]
    assert labels == labels_by_section(document)


def test_everything_is_named(written: Written) -> None:
    equations, notation = written.equations, written.notation
    text = to_markdown(written.document)
    period = [equations.itinerary.period] if equations.itinerary.period else []
    parameters = [*equations.itinerary.system.parameters, *period]
    if equations.itinerary.presentation:
        parameters += equations.itinerary.presentation.parameters
    (table,) = (b for b in written.document.section("The system") if isinstance(b, Table))
    assert {row[0] for row in table.rows} == {f"${notation.symbol(p.symbol)}$" for p in parameters}
    (introduced,) = re.findall(
        r"with \w+ coordinates?, (.*)", "\n".join(text.split(". The itinerary\n")[1].splitlines())
    )[:1]
    for unknown in (*equations.unknowns, *equations.vanishing):
        assert f"${notation.symbol(unknown)}$" in introduced
    for phase in equations.itinerary.phases:
        assert f"*{phase.configuration}*" in text
        assert f"*{phase.boundary}*" in text
    for symbol, value in equations.required.items():
        assert f"${notation.symbol(symbol)} = {value}$" in text
    for symbol in equations.vanishing:
        assert f"${notation.symbol(symbol)} = 0$" in text


def test_one_letter_stands_for_one_thing(written: Written) -> None:
    equations, notation = written.equations, written.notation
    stages = (*equations.chain.stages, *equations.reduction.stages, *equations.stages)
    symbols = {
        s for stage in (*stages, *equations.trace_program.stages) for s, _ in stage.assignments
    }
    symbols |= {*equations.unknowns, *equations.vanishing, *notation.constants, *notation.states}
    symbols -= {s for s, e in notation.functions.items() if not e.is_Function}
    texts = [notation.symbol(s) for s in symbols]
    assert len(set(texts)) == len(texts)
    # matrices and vectors of every document, none of which may be a parameter or a state
    letters = ["M", "K", "J", "E", "I", "P", "R_{1}", "S_{1}", "U_{1}", "f_{1}", "n_{1}", "d", "s"]
    assert not {
        *letters,
        r"\ell",
        r"\kappa_{1}",
        r"\mathcal{R}",
        r"\mathcal{M}",
        r"\varepsilon_{1}",
    } & set(texts)
    assert "(R" not in to_markdown(written.document)


@pytest.mark.parametrize("name", REVERSIBLE)
def test_the_symmetry_says_what_the_closure_leaves(name: str) -> None:
    written = written_of(name)
    section = written.document.section("The symmetry")
    lines = [line for b in section if isinstance(b, Formula) for line in b.lines]
    declared = declared_as(name)
    conditions = [e for _, e in end_conditions(declared, start_of(declared)) if e != 0]
    inserted = {*written.equations.required, *written.equations.vanishing}
    left = [line.shows for line in lines if line.latex.endswith("= 0,")]
    assert left == [e for e in conditions if e.free_symbols & inserted]
    assert (name == "rigid-stop/one-impact") == bool(left)


@pytest.mark.parametrize("name", REVERSIBLE)
def test_the_ends_of_the_phases_are_images_of_the_start(name: str) -> None:
    written = written_of(name)
    numbers = written.at(solved_of(name)) | {q: 0.0 for q in written.equations.vanishing}
    for k, link in enumerate(written.equations.chain.links, start=1):
        (line,) = (x for x in written.lines if re.match(rf"[XZ]\^{{\({k}\)}} = ", x.left))
        computed = [float(s.xreplace(numbers)) for s in link.after]
        assert value_of(line, numbers).ravel() == pytest.approx(computed, abs=1e-12)


def test_elimination_tells_each_unknown(written: Written) -> None:
    text = to_markdown(written.document).split(". The reduction\n")[1].split("\n## ")[0]
    explicit = not written.equations.reduction.unknowns
    assert ("Nothing remains to be solved" in text) == explicit
    for elimination in written.equations.reduction.eliminations:
        assert written.notation.symbol(elimination.unknown) in text
    for unknown in written.equations.reduction.unknowns:
        assert f"${written.notation.symbol(unknown)}$" in text

"""The documents of the built-in orbits: complete, and equal to what the kernels compute."""

import re
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
import sympy as sp

from nonsmooth.derive import derive_equations
from nonsmooth.derive.document.blocks import Formula, Paragraph, Table
from nonsmooth.derive.document.hypertext import to_markdown
from nonsmooth.derive.equations.energy import energy_of
from nonsmooth.derive.equations.section import start_of
from nonsmooth.derive.equations.symmetry import end_conditions
from nonsmooth.derive.flows.modal import TIME
from tests.documents import derived, labels_by_section, marked
from tests.latex_reader import (
    CONSERVATIVE,
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


# --- derivatives, stability and energy


@pytest.mark.slow
def test_saltation_matrices_are_those_of_the_kernel(name: str, written: Written) -> None:
    orbit = solved_of(name)
    numbers = written.at(orbit)
    read, size = written.reader(numbers), len(written.equations.system.states)
    kernel = np.array(orbit.evaluate("saltations"), dtype=float).reshape(-1, size, size)
    resets = [np.array(k.reset.tolist(), dtype=float) for k in written.equations.chain.links]
    shown: dict[int, np.ndarray] = {}
    for line in written.lines:
        match = re.fullmatch(r"S_\{(\d+)\}", line.left)
        if match:
            k, text = int(match[1]), " ".join(line.pieces)
            alike = {"I": np.eye(size), f"R_{{{k}}}": resets[k - 1]}
            shown[k] = alike[text] if text in alike else read.matrix(text)
    assert sorted(shown) == list(range(1, len(kernel) + 1))
    for k, matrix in shown.items():
        assert matrix == pytest.approx(kernel[k - 1], abs=1e-9)


def test_local_maps_as_written_give_the_poincare_jacobian(name: str, written: Written) -> None:
    orbit = solved_of(name)
    numbers = written.at(orbit)
    read, chain = written.reader(numbers), written.equations.chain
    size = len(written.equations.system.states)
    text = "\n".join(
        " ".join([line.left, line.relation, *line.pieces])
        for formula in written.document.section("Derivatives and the Poincaré map")
        if isinstance(formula, Formula)
        for line in formula.lines
    )
    resets = {
        int(k): np.diag([read(e) for e in entries.split(",")])
        for k, entries in re.findall(
            r"R_\{(\d+)\} =\s+\\operatorname\{diag\}\\left\((.*?)\\right\)", text
        )
    }
    matrix = r"\s*\\left\((\\begin\{matrix\}.*?\\end\{matrix\})\\right\)"
    normals = {int(k): read.matrix(m) for k, m in re.findall(rf"n_\{{(\d+)\}} ={matrix}", text)}
    fields = {int(k): read.matrix(m).T for k, m in re.findall(rf"f_\{{(\d+)\}} ={matrix}", text)}
    embedding = np.array(chain.section.embedding.tolist(), dtype=float)
    product = embedding
    for k, link in enumerate(chain.links, start=1):
        transfer = np.array(link.transfer.xreplace(numbers).tolist(), dtype=float)
        n, f = normals[k], fields[k]
        local = np.eye(size) - f @ n / (n @ f)
        product = resets.get(k, np.eye(size)) @ local @ transfer @ product
    jacobian = product[list(chain.section.places), :]
    assert jacobian == pytest.approx(np.array(orbit.evaluate("poincare_jacobian")), abs=1e-9)


@pytest.mark.parametrize("name", sorted(set(ORBITS) - set(REVERSIBLE)))
def test_the_chain_rule_of_the_jacobian_is_written(name: str) -> None:
    assert r"U_{k} &= \Phi^{(k)} R_{k-1} U_{k-1} + f_{k} \varepsilon_{k}" in to_markdown(
        written_of(name).document
    )


def test_the_trace_as_written_is_that_of_the_kernel(name: str, written: Written) -> None:
    orbit, equations = solved_of(name), written.equations
    trace = float(orbit.evaluate("trace"))
    numbers = written.at(orbit)
    text = to_markdown(written.document)
    if name in CONSERVATIVE:
        line = written.line(r"\operatorname{tr} \mathcal{M}")
        assert written.reader(numbers)(text_of(line)) - 1 == pytest.approx(trace, abs=1e-9)
        pair = np.roots([1, -(trace - 1), 1])
        assert np.abs(pair) == pytest.approx([1, 1])
        assert r"$|\operatorname{tr} \mathcal{M} - 2| < 2$" in text
    elif name == "dry-friction/global-stick":
        symbols = {str(s): s for s in numbers}
        own = {u: u for u in equations.reduction.unknowns}
        numbers = written.run(
            {**numbers, **{u: numbers[symbols[str(u)]] for u in own}},
            equations.trace_program.stages,
        )
        (line,) = (x for x in written.lines if x.shows == equations.trace)
        assert written.reader(numbers)(text_of(line)) == pytest.approx(trace, abs=1e-9)
        assert r"$|\operatorname{tr} J| < 1$" in text
    elif name == "dry-friction/symmetric":
        jacobian = np.array(orbit.evaluate("poincare_jacobian"))
        inside = max(abs(np.linalg.eigvals(jacobian))) < 1
        determinant = np.linalg.det(jacobian)
        assert inside == (abs(trace) < 1 + determinant and determinant < 1)
        assert r"|\operatorname{tr} J| < 1 + \det J,\qquad \det J < 1." in text
        assert trace == pytest.approx(jacobian[0, 0] + jacobian[1, 1])
    else:
        assert np.linalg.matrix_rank(orbit.evaluate("poincare_jacobian"), tol=1e-9) == 1
        assert r"$|\operatorname{tr} J| < 1$" in text
        assert "one-sided" in text
        assert "$t_{a} = 0$" in text


@pytest.mark.parametrize("name", CONSERVATIVE)
def test_energies_are_those_of_the_declaration(name: str) -> None:
    written = written_of(name)
    system, states = written.equations.system, written.equations.system.states
    for configuration in {p.configuration for p in written.equations.itinerary.phases}:
        line = written.line(rf"2 E_{{\text{{{configuration}}}}}")
        known = energy_of(system.configuration(configuration).dynamics, states)
        assert not sp.expand(line.shows - 2 * known).free_symbols & set(states)
    changes = [line for line in written.lines if "}^{+} - E_" in line.left]
    numbers = written.drawn(1)
    at_orbit = {s: sp.Integer(1) for s in states[:1]} | dict(written.equations.required)
    assert changes
    for line in changes:
        assert line.shows.xreplace(at_orbit) == 0
        assert value_of(line, numbers) != 0


@pytest.mark.parametrize("name", sorted(set(ORBITS) - set(CONSERVATIVE)))
def test_only_conservative_orbits_have_an_energy(name: str) -> None:
    assert not written_of(name).document.section("The energy")


def test_the_entries_of_the_map_as_written_are_those_of_the_kernel(
    name: str, written: Written
) -> None:
    """Their values are in the last section, and the lines from which they are computed as well."""
    orbit = solved_of(name)
    kernel = np.array(orbit.evaluate("poincare_jacobian"), dtype=float)
    size = len(written.equations.chain.coordinates)
    assert kernel.shape == (size, size)
    numbers = written.run(written.at(orbit), written.equations.map_program.stages)
    read = written.reader(numbers)
    entries = {
        (i, j): read(text_of(written.line(f"J_{{{i}{j}}}")))
        for i in range(1, size + 1)
        for j in range(1, size + 1)
    }
    found = np.array([[entries[i + 1, j + 1] for j in range(size)] for i in range(size)])
    assert found == pytest.approx(kernel, abs=1e-9)
    last = [b for b in written.document.section("The reference orbit") if isinstance(b, Formula)]
    (matrix,) = (line for formula in last for line in formula.lines if line.left == "J")
    assert read.matrix(text_of(matrix)) == pytest.approx(kernel, abs=1e-9)


def test_the_reference_orbit_is_the_one_that_is_solved(name: str, written: Written) -> None:
    orbit = solved_of(name)
    section = written.document.section("The reference orbit")
    formulas = [b for b in section if isinstance(b, Formula)]
    shown = {line.left: " ".join(line.pieces) for f in formulas for line in f.lines}
    for unknown in written.equations.unknowns:
        value = float(shown[written.notation.symbol(unknown)])
        assert value == pytest.approx(float(orbit.values[str(unknown)]), abs=1e-10)
    assert float(shown[r"\text{period}"]) == pytest.approx(float(orbit.period), abs=1e-10)
    assert float(shown[r"\operatorname{tr} J"]) == pytest.approx(float(orbit.trace), abs=1e-9)
    told = " ".join(b.text for b in section if isinstance(b, Paragraph)).rpartition("multiplier")[2]
    reader = Reader({r"\mathrm{i}": 1j})
    multipliers = [complex(reader(text)) for text in re.findall(r"\$([^$]+)\$", told)]
    theirs = [complex(m) for m in orbit.multipliers]
    assert len(multipliers) == len(theirs)
    for multiplier in theirs:
        assert min(abs(multiplier - m) for m in multipliers) < 1e-8

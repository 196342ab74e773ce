"""Documents of the built-in orbits: what they say of derivatives, stability and energy."""

import re

import numpy as np
import pytest
import sympy as sp

from nonsmooth.derive.document.blocks import Formula, Paragraph
from nonsmooth.derive.document.hypertext import to_markdown
from nonsmooth.derive.equations.energy import energy_of
from tests.latex_reader import (
    CONSERVATIVE,
    ORBITS,
    REVERSIBLE,
    Reader,
    Written,
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

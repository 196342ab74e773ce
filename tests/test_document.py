"""The derivation as a document: complete, well formed, and equal to what the kernels compute."""

import math
import os
import random
import re
import shutil
import subprocess
import sys
from collections.abc import Iterator
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy as sp

from nonsmooth.derive.document.describe import (
    Document,
    Formula,
    Line,
    Table,
    describe_orbit,
    describe_system,
)
from nonsmooth.derive.document.describe_orbit import functions_of
from nonsmooth.derive.document.hypertext import to_html
from nonsmooth.derive.document.latex import LatexMissing, compile_pdf, to_latex
from nonsmooth.derive.document.layout import width
from nonsmooth.derive.document.markdown import to_markdown
from nonsmooth.derive.document.symbols import Notation
from nonsmooth.derive.dynamics import SecondOrder
from nonsmooth.derive.equations import EquationSystem, derive_equations
from nonsmooth.derive.explicit import Angle
from nonsmooth.derive.itinerary import Itinerary, Phase
from nonsmooth.derive.parameter import Parameter
from nonsmooth.derive.system import TIME, Boundary, Configuration, System, Transition
from nonsmooth.derive.systems import dry_friction

VOID = {"meta", "br", "hr", "img", "link"}


def drop() -> Itinerary:
    """A ball that falls and bounces: one coordinate, an offset, no centre, no frequency."""
    g, r, w = (Parameter(n, n, upper=u) for n, u in (("g", sp.oo), ("r", 1), ("w", sp.oo)))
    h, v = sp.symbols("h v", real=True)
    eye = sp.eye(1)
    configuration = Configuration(
        "falling", SecondOrder(eye, sp.zeros(1, 1), (-g.symbol,)), (Boundary("lands", -h),)
    )
    bounce = Transition(
        "falling", frozenset({"lands"}), "falling", (), {v: w.symbol - r.symbol * v}
    )
    system = System("ball", "a falling ball", (h, v), (g, r, w), (configuration,), (bounce,))
    return Itinerary("bounce", system, (Phase("falling", "lands", "tau"),))


def masses(count: int) -> System:
    """Masses between two springs that may be absent: eigenvalues without a closed form."""
    k = Parameter("k", "stiffness", lower=-sp.oo)
    positions = sp.symbols(f"x1:{count + 1}", real=True)
    velocities = sp.symbols(f"v1:{count + 1}", real=True)
    stiffness = sp.diag(*(k.symbol + i for i in range(count)))
    for i in range(count - 1):
        stiffness[i, i + 1] = stiffness[i + 1, i] = -k.symbol
    free = Configuration(
        "free", SecondOrder(sp.eye(count), stiffness), (Boundary("stops", velocities[0]),)
    )
    return System("masses", "masses & springs", (*positions, *velocities), (k,), (free,))


@pytest.fixture(scope="module")
def two_masses() -> Document:
    return describe_system(masses(2))


@pytest.fixture(scope="module")
def three_masses() -> Document:
    return describe_system(masses(3))


@pytest.fixture(scope="module", autouse=True)
def elsewhere() -> Iterator[subprocess.Popen[bytes]]:
    """Another process, with other hashes, that writes the orbit while the tests run."""
    program = (
        "import sys\n"
        "from nonsmooth.derive.document.describe import describe_orbit as d\n"
        "from nonsmooth.derive.document.latex import to_latex\n"
        "from nonsmooth.derive.document.markdown import to_markdown\n"
        "from nonsmooth.derive.equations import derive_equations as e\n"
        "from nonsmooth.derive.systems.dry_friction import global_stick as g\n"
        "o = d(e(g)); sys.stdout.buffer.write((to_latex(o) + to_markdown(o)).encode())"
    )
    with subprocess.Popen(
        [sys.executable, "-c", program],
        env={**os.environ, "PYTHONHASHSEED": "12345"},
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
    ) as process:
        yield process


@pytest.fixture(scope="module")
def equations() -> EquationSystem:
    return derive_equations(dry_friction.global_stick)


@pytest.fixture(scope="module")
def orbit(equations: EquationSystem) -> Document:
    return describe_orbit(equations)


@pytest.fixture(scope="module")
def system() -> Document:
    return describe_system(dry_friction.system)


@pytest.fixture(scope="module")
def ball() -> Document:
    return describe_orbit(derive_equations(drop()))


@pytest.fixture(params=["orbit", "system", "ball", "two_masses", "three_masses"])
def document(request: pytest.FixtureRequest) -> Document:
    found = request.getfixturevalue(request.param)
    assert isinstance(found, Document)
    return found


class Reader:
    """Evaluate the LaTeX of a right-hand side, knowing the values of the symbols as written."""

    def __init__(self, values: dict[str, Any]) -> None:
        self.values = values
        names = "|".join(re.escape(n) for n in sorted(values, key=len, reverse=True))
        self.token = re.compile(
            rf"\s*(?:(?P<name>{names})(?![A-Za-z])|(?P<number>\d+)|(?P<sign>[-+()^{{}}])"
            r"|(?P<word>\\[A-Za-z]+)|\\,|(?P<end>$))"
        )

    def __call__(self, latex: str) -> Any:
        plain = re.sub(r"\\(left|right|biggl|biggr)(?=[()])", "", latex)
        self.tokens = list(self.scan(plain))
        value = self.sum()
        assert not self.tokens, self.tokens
        return value

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
            elif text in (r"\cos", r"\sin"):
                argument = 1.0
                while self.tokens and isinstance(self.values.get(self.peek()), float):
                    argument *= self.values[self.tokens.pop(0)[1]]
                value = math.cos(argument) if text == r"\cos" else math.sin(argument)
            else:
                raise AssertionError(text)
        if self.peek() == "^":
            self.tokens.pop(0)
            value = value ** self.group()
        return value


def notation_of(equations: EquationSystem) -> Notation:

    return Notation(
        equations.system.states,
        tuple(
            p.symbol for p in (*equations.system.parameters, *equations.itinerary.system.parameters)
        )
        + equations.spectrum.symbols,
        functions_of(equations.chain),
        equations.unknowns,
    )


def shown_lines(document: Document) -> list[Line]:
    return [
        line
        for formula in document.formulas
        for line in formula.lines
        if isinstance(line.shows, sp.Expr)
        and not line.shows.is_Matrix
        and not line.shows.has(Angle)
    ]


def test_formulas_show_what_the_kernels_compute(equations: EquationSystem, orbit: Document) -> None:
    notation = notation_of(equations)
    draw = random.Random(7)
    checked = 0
    for line in shown_lines(orbit):
        assert line.shows is not None
        symbols = sorted(line.shows.free_symbols, key=str)
        # values of functions follow from the symbols in them; the rest is free
        values = {s: draw.uniform(0.2, 0.9) for s in symbols if s not in notation.functions}
        for symbol in symbols:
            for inner in sorted(notation.functions.get(symbol, sp.S(0)).free_symbols, key=str):
                values.setdefault(inner, draw.uniform(0.2, 0.9))
        names = {notation.symbol(s): v for s, v in values.items()}
        assert len(names) == len(values)
        expected = line.shows.xreplace(dict(notation.functions)).subs(values)
        text = " ".join(line.pieces).removesuffix("= 0")
        assert Reader(names)(text) == pytest.approx(float(expected), rel=1e-12, abs=1e-13), text
        checked += 1
    assert checked > 60


def matrix_of(read: Reader, latex: str) -> np.ndarray:
    rows = re.split(r"\\\\", latex)
    return np.array([[read(entry) for entry in row.split("&")] for row in rows])


def test_flows_show_what_the_kernels_compute(equations: EquationSystem, orbit: Document) -> None:
    notation = notation_of(equations)
    symbols = [TIME, *notation.constants]
    values = {s: 0.3 + 0.1 * i for i, s in enumerate(symbols)}
    numbers: dict[str, Any] = {notation.symbol(s): v for s, v in values.items()}
    numbers["I"] = np.eye(2)
    blocks = 0
    for formula in orbit.formulas:
        for line in formula.lines:
            definition = r"(P_\{\d+\}) = \\left\(\\begin\{matrix\}(.*?)\\end\{matrix\}\\right\)"
            for name, entries in re.findall(definition, line.latex):
                numbers[name] = matrix_of(Reader(numbers), entries)
            if not line.left.startswith(r"\Phi_"):
                continue
            assert line.shows is not None
            shown = Reader(numbers)(" ".join(line.pieces))
            expected = np.array(line.shows.subs(values).tolist(), dtype=float)
            assert shown + np.zeros((2, 2)) == pytest.approx(expected, rel=1e-12), line.latex
            places = re.findall(r"\^\{(\d)(\d)\}", line.left)
            number = int(line.left.removeprefix(r"\Phi_{")[0])
            flow = equations.chain.links[number - 1].flow
            for row, column in places:
                i, j = 2 * int(row) - 2, 2 * int(column) - 2
                assert flow.matrix()[i : i + 2, j : j + 2] == line.shows
                blocks += 1
    assert blocks == 16


def test_every_stage_of_the_derivation_is_shown(equations: EquationSystem, orbit: Document) -> None:
    shown = {(line.subject, line.shows) for formula in orbit.formulas for line in formula.lines}
    functions = notation_of(equations).functions
    stages = (*equations.chain.stages, *equations.reduction.stages)
    for stage in stages:
        for symbol, expression in stage.assignments:
            assert symbol in functions or (symbol, expression) in shown
    for symbol, expression in equations.spectrum.entries:
        assert (symbol, expression) in shown
    derived = {line.subject for formula in orbit.formulas for line in formula.lines}
    for stage in equations.trace[0]:
        for symbol, _ in stage.assignments:
            inner = str(symbol).partition("_by_")[0]
            assert symbol in derived or inner in {str(f) for f in functions}
    assert equations.trace[1] in {s for _, s in shown}


def test_the_equations_are_all_there(equations: EquationSystem, orbit: Document) -> None:
    formulas = [b for b in orbit.section("The equations") if isinstance(b, Formula)]
    assert len(formulas) == len(equations.equations)
    assert [f.label for f in formulas] == [str(i + 1) for i in range(len(formulas))]
    assert [f.lines[0].shows for f in formulas] == equations.residual
    reduced = [b for b in orbit.section("The reduction") if isinstance(b, Formula) and b.label]
    assert [f.lines[0].shows for f in reduced] == [e for _, e in equations.reduction.equations]


def test_the_system_shows_its_configurations_and_transitions(system: Document) -> None:
    text = to_markdown(system)
    for configuration in dry_friction.system.configurations:
        assert f"*{configuration.name}*" in text
        for boundary in configuration.boundaries:
            assert f"*{boundary.name}*" in text
    tables = [b for b in system.section("Transitions") if isinstance(b, Table)]
    events = {(t.source, t.boundaries) for t in dry_friction.system.transitions}
    listed = sum(row[1].count(", or ") + 1 for row in tables[-1].rows)
    assert listed == len(events)


def test_latex_is_balanced(document: Document) -> None:
    text = to_latex(document)
    depth = 0
    for character in re.sub(r"\\[{}\\]", "", text):
        depth += {"{": 1, "}": -1}.get(character, 0)
        assert depth >= 0
    assert depth == 0
    opened: list[str] = []
    for kind, name in re.findall(r"\\(begin|end)\{([a-z*]+)\}", text):
        if kind == "begin":
            opened.append(name)
        else:
            assert opened.pop() == name
    assert not opened
    assert len(re.findall(r"\\left", text)) == len(re.findall(r"\\right", text))


def test_no_raw_names_remain(document: Document, equations: EquationSystem) -> None:
    stages = (*equations.chain.stages, *equations.trace[0], *equations.reduction.stages)
    names = {str(s) for stage in stages for s, _ in stage.assignments}
    names |= {str(s) for s in (*equations.unknowns, *equations.spectrum.symbols)}
    names |= {p.name for p in (*equations.system.parameters, *dry_friction.system.parameters)}
    raw = sorted(n for n in names if re.search(r"\d|_", n))
    for text in (to_markdown(document), to_latex(document)):
        words = set(re.findall(r"(?<!\\)\b[A-Za-z][A-Za-z]*\d\w*|\b\w+_by_\w+", text))
        assert not words & set(raw)
        assert not re.search(r"(?<![\\A-Za-z])(chi|eta|tau|omega)(?![A-Za-z])", text)


def test_names_are_distinct(equations: EquationSystem) -> None:
    notation = notation_of(equations)
    stages = (*equations.chain.stages, *equations.trace[0], *equations.reduction.stages)
    symbols = {s for stage in stages for s, _ in stage.assignments}
    symbols |= {*equations.unknowns, *equations.spectrum.symbols, *equations.system.states}
    assert len({notation.symbol(s) for s in symbols}) == len(symbols)


@pytest.mark.parametrize(
    ("name", "latex"),
    [
        ("tau1", r"\tau_{1}"),
        ("ta", "t_{a}"),
        ("z10", "z_{10}"),
        ("us1", "u_{s1}"),
        ("gap1", r"\Delta_{1}"),
        ("V", "V"),
        ("k_c", "k_{c}"),
        ("stiffness2", r"\mathrm{stiffness}_{2}"),
        ("z1_3", "z_{1}^{(3)}"),
        ("z1_3_reset", "z_{1}^{(3)+}"),
        ("z1_3_by_tau", r"\partial_{\tau} z_{1}^{(3)}"),
        ("amplitude_tau2", r"A_{\tau_{2}}"),
        ("amplitude_tau2_by_tau1", r"\partial_{\tau_{1}} A_{\tau_{2}}"),
        ("cos_omega1_tau1", r"\cos \omega_{1} \tau_{1}"),
    ],
)
def test_notation(equations: EquationSystem, name: str, latex: str) -> None:
    assert notation_of(equations).symbol(name) == latex


def test_lines_fit_the_page(document: Document) -> None:
    for formula in document.formulas:
        for row in formula.latex.splitlines()[1:-1]:
            assert width(row.replace("&", "")) < 46


class Page(HTMLParser):
    """Tags in their order, and whether they close."""

    def __init__(self) -> None:
        super().__init__()
        self.open: list[str] = []
        self.seen: set[str] = set()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.seen.add(tag)
        assert not {"href", "src"} & {name for name, _ in attrs}
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.seen.add(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag

    def handle_data(self, data: str) -> None:
        if self.open[-1:] != ["style"]:
            assert "\\" not in data


def test_html_is_one_offline_page(document: Document) -> None:
    pytest.importorskip("latex2mathml")
    text = to_html(document)
    page = Page()
    page.feed(text)
    page.close()
    assert not page.open
    assert "math" in page.seen
    assert not page.seen & {"script", "link", "img", "iframe"}
    assert not re.search(r"https?://(?!www\.w3\.org)|url\(|@import", text)
    assert text.count('<div class="formula">') == len(document.formulas)


def test_html_says_what_it_needs(orbit: Document, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "latex2mathml.converter", None)
    with pytest.raises(ImportError, match=r"nonsmooth\[html\]"):
        to_html(orbit)


def test_another_process_writes_the_same_bytes(
    orbit: Document, elsewhere: subprocess.Popen[bytes]
) -> None:
    written, errors = elsewhere.communicate(timeout=60)
    assert elsewhere.returncode == 0, errors.decode()
    assert written.decode() == to_latex(orbit) + to_markdown(orbit)


@pytest.mark.skipif(shutil.which("pdflatex") is None, reason="pdflatex is not installed")
def test_pdf_has_no_overfull_box(document: Document, tmp_path: Path) -> None:
    text = to_latex(document)
    (tmp_path / "document.tex").write_text(text, encoding="utf-8")
    options = ["-interaction=nonstopmode", "-halt-on-error", "-draftmode", "-no-shell-escape"]
    command = ["pdflatex", *options, "document.tex"]
    subprocess.run(command, cwd=tmp_path, capture_output=True, check=True)
    log = (tmp_path / "document.log").read_text(encoding="latin-1")
    overfull = re.findall(r"Overfull \\hbox \(([\d.]+)pt", log)
    assert not [o for o in overfull if float(o) > 5]


@pytest.mark.skipif(shutil.which("pdflatex") is None, reason="pdflatex is not installed")
def test_pdf_is_written(ball: Document, tmp_path: Path) -> None:
    compile_pdf(to_latex(ball), tmp_path / "ball.pdf")
    assert (tmp_path / "ball.pdf").read_bytes().startswith(b"%PDF")
    with pytest.raises(RuntimeError, match="failed"):
        compile_pdf(r"\documentclass{article}\begin{document}\nothing", tmp_path / "bad.pdf")
    assert not (tmp_path / "bad.pdf").exists()


def test_missing_latex_is_named(
    orbit: Document, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PATH", "")
    with pytest.raises(LatexMissing, match="texlive-latex-recommended"):
        compile_pdf(to_latex(orbit), tmp_path / "orbit.pdf")

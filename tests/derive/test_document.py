"""Documents of systems and orbits: well formed in LaTeX, Markdown, HTML and PDF."""

import os
import re
import shutil
import subprocess
import sys
from collections.abc import Callable
from dataclasses import replace
from functools import cache
from html.parser import HTMLParser
from pathlib import Path

import pytest
import sympy as sp

from nonsmooth.derive import (
    Boundary,
    Configuration,
    Itinerary,
    Parameter,
    Phase,
    RigidStop,
    SecondOrder,
    System,
    Transition,
    chain_matrices,
    derive_equations,
    oscillator,
)
from nonsmooth.derive.document.blocks import (
    Document,
    Formula,
    Heading,
    Line,
    Paragraph,
    Table,
    width,
)
from nonsmooth.derive.document.describe import (
    describe_itinerary,
    describe_orbit,
    describe_system,
)
from nonsmooth.derive.document.hypertext import mathml, to_html, to_markdown
from nonsmooth.derive.document.latex import compile_pdf, to_latex
from nonsmooth.derive.document.printer import Notation
from nonsmooth.derive.symbols import Symbol, derivative
from nonsmooth.derive.systems import SYSTEMS
from tests.declared_documents import impacts, one_mass, rattle, switching
from tests.documents import declarations, document_of, labels_by_section, marked, names
from tests.formulas.pages import texts_of
from tests.latex_reader import ORBITS, written_of

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
    """Masses in a row whose first spring may push: their frequencies may be imaginary."""
    k = sp.Symbol("k", real=True)
    mass, stiffness, _ = chain_matrices([1] * count, [k, *[1] * (count - 1)])
    stop = RigidStop("x1", at=1, restitution=1, name="stop")
    names = [f"x{i}" for i in range(1, count + 1)]
    description = "masses & springs"
    return oscillator("masses", names, mass, stiffness, elements=[stop], description=description)


ZETA, OMEGA = sp.symbols("zeta omega", positive=True)
MADE: dict[str, Callable[[], Document]] = {
    "ball": lambda: describe_orbit(derive_equations(drop())),
    "two masses": lambda: describe_system(masses(2)),
    "three masses": lambda: describe_system(masses(3)),
    "one impact": lambda: describe_orbit(impacts(1)),
    "undamped rattle": lambda: describe_orbit(rattle(0)),
    "one mass": lambda: describe_system(one_mass(ZETA * OMEGA, OMEGA**2)),
    "many turns": lambda: describe_orbit(switching(7)),
}
DECLARED = ("forced", "two-impacts", "chain", "rattle", "switching")


@cache
def made(name: str) -> Document:
    return MADE[name]() if name in MADE else document_of(name)[0]


@pytest.fixture(params=[*marked((*SYSTEMS, *DECLARED, *MADE), "undamped rattle"), *ORBITS])
def document(request: pytest.FixtureRequest) -> Document:
    return made(str(request.param))


def test_what_a_user_writes_is_one_paragraph() -> None:
    words = "one\n\n  two\n\t\n\nthree"
    declared = drop().system
    parameters = (replace(declared.parameters[0], description=words), *declared.parameters[1:])
    system = replace(declared, description=words, parameters=parameters, model=(words,))
    document = describe_system(system)
    (table,) = (b for b in document.section("The system") if isinstance(b, Table))
    assert [row[1] for row in table.rows] == ["one two three", "r", "w"]
    for text in (to_markdown(document), to_latex(document)):
        assert text.count("one two three") == 3
        assert "one\n" not in text
    assert "\n| $g$ | one two three | $g > 0$ |\n" in to_markdown(document)


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


@cache
def raw_names() -> set[str]:
    """Names in the code that LaTeX writes otherwise."""
    names: set[str] = set()
    for name in ORBITS:
        equations = written_of(name).equations
        stages = (
            *equations.chain.stages,
            *equations.trace_program.stages,
            *equations.reduction.stages,
        )
        names |= {str(s) for stage in (*stages, *equations.stages) for s, _ in stage.assignments}
        names |= {str(s) for s in (*equations.unknowns, *equations.spectrum.symbols)}
        names |= {p.name for p in equations.system.parameters}
        names |= {p.name for p in equations.itinerary.system.parameters}
    return {n for n in names if re.search(r"\d|_", n)}


def test_no_raw_names_remain(document: Document) -> None:
    raw = raw_names()
    assert {"z10", "half_tau", "coefficient11"} <= raw
    for text in (to_markdown(document), to_latex(document)):
        words = set(re.findall(r"(?<!\\)\b[A-Za-z]\w*[\d_]\w*", text))
        assert not words & raw
        assert not re.search(r"(?<![\\A-Za-z])(chi|eta|tau|omega|kappa)(?![A-Za-z])", text)
        assert "None" not in text


def test_sentences_end(document: Document) -> None:
    for place, block in enumerate(document.blocks):
        if not isinstance(block, Paragraph):
            continue
        assert "  " not in block.text
        assert not re.search(r"\b(and|or|,)\.", block.text)
        ended = block.text.endswith((".", ":"))
        following = document.blocks[place + 1 : place + 2]
        assert ended or (following and isinstance(following[0], Formula)), block.text
        dollars = re.sub(r"\$[^$]*\$", "", block.text)
        assert "$" not in dollars
        assert dollars.count("*") % 2 == 0


Z1, X1, X2, Y = sp.symbols("z1 x1 x2 y", real=True)
TAU, TAU1, TAU2 = sp.symbols("tau tau1 tau2", positive=True)
RIGHT = Symbol("times", Symbol("right", 1), Y)
WRITTEN: dict[str, dict[sp.Symbol, str]] = {
    "dry-friction/global-stick": {
        **{
            sp.Symbol(name, real=True): latex
            for name, latex in {
                "tau1": r"\tau_{1}", "ta": "t_{a}", "z10": "z_{10}", "us1": "u_{s1}",
                "gap1": r"\Delta_{1}", "V": "V", "k_c": "k_{c}",
                "stiffness2": r"\mathrm{stiffness}_{2}",
            }.items()
        },
        Symbol("state", Z1, 3): "z_{1}^{(3)}",
        Symbol("reset", Z1, 3): "z_{1}^{(3)+}",
        derivative(Symbol("state", Z1, 3), TAU): r"\partial_{\tau} z_{1}^{(3)}",
        Symbol("amplitude", TAU2): r"A_{\tau_{2}}",
        derivative(Symbol("amplitude", TAU2), TAU1): r"\partial_{\tau_{1}} A_{\tau_{2}}",
        Symbol("function", "cos_omega1_tau1"): r"\cos \omega_{1} \tau_{1}",
    },
    # with half phases
    "elastic-stop/one-contact": {
        Y: "y",
        Symbol("coefficient", "11"): "a_{11}",
        Symbol("coefficient", "1_12"): "a_{1,12}",
        Symbol("without", Symbol("coefficient", "12"), 2): "a_{12}^{[2]}",
        RIGHT: "b_{1,y}",
        Symbol("without", RIGHT, 2): "b_{1,y}^{[2]}",
        Symbol("constant", Y): r"\bar{y}",
        Symbol("divisor", Symbol("state", X1, 0)): "a_{x_{1}^{(0)}}",
        Symbol("part", 0, Y, TAU): "x_{1,y}^{(1)}",
        Symbol("part", 1, 1, TAU1): r"\bar{x}_{2}^{(2)}",
        Symbol("right", 1): "b_{1}",
        Symbol("numerator", 2): "N_{2}",
        Symbol("determinant"): "D",
        Symbol("function", "cos_omega3_half_tau1"): r"\cos(\omega_{3} \tau_{1}/2)",
        Symbol("reset", X1, 1): "x_{1}^{(1)+}",
        Symbol("half", TAU, positive=True): r"\frac{\tau}{2}",
    },
}  # fmt: skip


@pytest.mark.parametrize("name", WRITTEN)
def test_symbols_are_written_by_their_meaning(name: str) -> None:
    notation, expected = written_of(name).notation, WRITTEN[name]
    assert {symbol: notation.symbol(symbol) for symbol in expected} == expected


def test_letters_of_linear_equations_are_free() -> None:
    notation = Notation((), sp.symbols("a b11 D"))
    made = (Symbol("coefficient", "11"), Symbol("right", 1), Symbol("determinant"))
    assert [notation.symbol(s) for s in (*made, *notation.constants)] == [
        r"\alpha_{11}", r"\beta_{1}", r"\Delta", "a", "b_{11}", "D"
    ]  # fmt: skip


def test_functions_share_a_coefficient_up_to_its_sign() -> None:
    written = written_of("elastic-stop/one-contact")
    named = {str(s): s for s in (*written.notation.functions, *written.notation.constants)}
    one, two, three = (named[f"cos_omega{i}_{t}"] for i, t in ((1, "tau"), (2, "tau"), (3, "tau1")))
    p, omega, y = named["p1"], named["omega1"], written.equations.unknowns[0]
    total = (p - y) * one + (y - p) * two * omega + 3 * three
    terms = written.notation.by_function(total)
    assert len(terms) == 2
    assert sp.expand(sp.Add(*terms) - total) == 0


def test_lines_fit_the_page(document: Document) -> None:
    for formula in document.formulas:
        for row in formula.latex.splitlines()[1:-1]:
            assert width(row.replace("&", "")) < 46


def test_equations_are_numbered_by_sections(document: Document) -> None:
    labels = [f.label for f in document.formulas if f.label]
    headings = [b.number for b in document.blocks if isinstance(b, Heading) and b.level == 1]
    assert headings == list(range(1, len(headings) + 1))
    assert labels == labels_by_section(document)
    texts = [text for block in document.blocks for text in texts_of(block)]
    cited = {m for t in texts for m in re.findall(r"(?:^|\s)\((\d[\d.]*)\)(?! of)", t)}
    assert cited - {"2011"} <= set(labels)


def test_a_page_begins_in_front_of_two_headings_and_not_between_them() -> None:
    blocks = (Paragraph("text"), Heading("One"), Heading("Two", 2), Paragraph("text"))
    before, _, behind = to_latex(Document("title", blocks)).rpartition(r"\needroom{")
    assert "text" in before.partition(r"\begin{document}")[2]
    assert r"\section{One}" in behind
    assert r"\subsection{Two}" in behind


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
    assert len(re.findall(r'<div class="formula">', text)) == len(document.formulas)
    assert not re.search("<mi>(cos|sin|det|tr)</mi>", text)
    for label in (f.label for f in document.formulas if f.label):
        assert text.count(f'<span class="number">({label})</span>') == 1


def test_mathml_is_set_as_tex_sets_it() -> None:
    convert = pytest.importorskip("latex2mathml.converter").convert
    text = mathml(
        r"- u \left(1 - p\right) \cos \omega t + \frac{a}{2} = -\left(\frac{1}{2}\right)", convert
    )
    page = Page()
    page.feed(text)
    assert not page.open
    assert '<mo lspace="0.167em" rspace="0.167em">cos</mo>' in text
    fences = re.findall(r'<mo stretchy="(\w+)"', text)
    assert fences == ["false", "false", "true", "true"]
    assert text.count('form="prefix"') == 3  # both parentheses, and the sign behind "="
    assert mathml("|x|", convert).count('stretchy="false"') == 2


def test_html_says_what_it_needs(monkeypatch: pytest.MonkeyPatch) -> None:
    orbit = written_of("dry-friction/global-stick").document
    monkeypatch.setitem(sys.modules, "latex2mathml.converter", None)
    with pytest.raises(ImportError, match=r"nonsmooth\[html\]"):
        to_html(orbit)


@pytest.mark.slow
def test_another_process_writes_the_same_bytes() -> None:
    program = (
        "import sys\n"
        "from nonsmooth.derive.document.describe import describe_orbit as d\n"
        "from nonsmooth.derive.document.latex import to_latex\n"
        "from nonsmooth.derive.document.hypertext import to_markdown\n"
        "from nonsmooth.derive.equations.derivation import derive_equations as e\n"
        "from nonsmooth.derive.systems import SYSTEMS, declaration\n"
        "for o in (d(e(o)) for s in SYSTEMS for o in declaration(s).orbits):\n"
        "    sys.stdout.buffer.write((to_latex(o) + to_markdown(o)).encode())"
    )
    hashes = {**os.environ, "PYTHONHASHSEED": "12345"}
    command = [sys.executable, "-c", program]
    written = subprocess.run(command, env=hashes, capture_output=True, check=True).stdout
    documents = [written_of(name).document for name in ORBITS]
    assert written.decode() == "".join(to_latex(d) + to_markdown(d) for d in documents)


@pytest.mark.skipif(shutil.which("pdflatex") is None, reason="pdflatex is not installed")
def test_pdf_has_no_overfull_box(document: Document, tmp_path: Path) -> None:
    fits_the_page(document, tmp_path)


# matrices and sums that no line has room for as they are
WIDE = ("impact_damper/struck-twice", "beam")


@pytest.mark.skipif(shutil.which("pdflatex") is None, reason="pdflatex is not installed")
@pytest.mark.parametrize(
    "name",
    [
        name if name in WIDE else pytest.param(name, marks=pytest.mark.slow)
        for name in declarations()
        if name not in (*SYSTEMS, *DECLARED, *ORBITS)
    ],
)
def test_no_formula_passes_the_margin(name: str, tmp_path: Path) -> None:
    """Of any system and any orbit of the gallery."""
    fits_the_page(document_of(name)[0], tmp_path)


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("pdflatex") is None, reason="pdflatex is not installed")
@pytest.mark.parametrize("name", list(names(Itinerary)))
def test_no_formula_of_a_composed_orbit_passes_the_margin(name: str, tmp_path: Path) -> None:
    fits_the_page(describe_itinerary(declarations()[name]), tmp_path)


@pytest.mark.skipif(shutil.which("pdflatex") is None, reason="pdflatex is not installed")
def test_a_box_that_is_too_wide_is_seen(tmp_path: Path) -> None:
    line = Line(
        "x", "=", (r"\left(\begin{matrix}" + " & ".join(["a + b"] * 30) + r"\end{matrix}\right)",)
    )
    with pytest.raises(AssertionError):
        fits_the_page(Document("Wide", (Formula((line,)),)), tmp_path)


def fits_the_page(document: Document, tmp_path: Path) -> None:
    text = to_latex(document)
    (tmp_path / "document.tex").write_text(text, encoding="utf-8")
    options = ["-interaction=nonstopmode", "-halt-on-error", "-draftmode", "-no-shell-escape"]
    command = ["pdflatex", *options, "document.tex"]
    subprocess.run(command, cwd=tmp_path, capture_output=True, check=True)
    log = (tmp_path / "document.log").read_text(encoding="latin-1")
    overfull = re.findall(r"Overfull \\[hv]box \(([\d.]+)pt", log)
    assert not [o for o in overfull if float(o) > 1]


@pytest.mark.skipif(shutil.which("pdflatex") is None, reason="pdflatex is not installed")
def test_pdf_is_compiled() -> None:
    assert compile_pdf(to_latex(made("ball"))).startswith(b"%PDF")
    with pytest.raises(RuntimeError, match="failed"):
        compile_pdf(r"\documentclass{article}\begin{document}\nothing")

"""Documents of systems and orbits: well formed and alike in LaTeX, Markdown, HTML and PDF."""

import re
import shutil
import subprocess
from dataclasses import replace
from functools import cache
from itertools import pairwise

import pytest

from nonsmooth.derive import Itinerary
from nonsmooth.derive.document.blocks import Document, Formula, Heading, Paragraph
from nonsmooth.derive.document.describe import describe_orbit, describe_system
from nonsmooth.derive.document.hypertext import to_markdown
from nonsmooth.derive.document.latex import to_latex
from tests.cli.test_cli import told
from tests.declared_documents import drop
from tests.documents import declarations, distinct, document_of, marked, names
from tests.formulas.pages import on_pages, page_of, texts_of
from tests.latex_reader import ORBITS, written_of

pytest.importorskip("latex2mathml")
needs_latex = pytest.mark.skipif(shutil.which("pdflatex") is None, reason="pdflatex is missing")


# closed forms of two masses, and the longest of declared ones
LONG = "dry-friction/symmetric", "elastic-stop/one-contact", "two_stops/symmetric", "beam"


# of these the laws of other tests show more
OTHERS = "chain", "den_hartog/without-rest", "jenkins/yielding-both-ways", "three_masses"
OTHERS = *OTHERS, "backlash_gear/rattle", "two_belts/both-stick"


@pytest.fixture(params=marked(distinct(declarations(), *OTHERS), *LONG))
def document(request):
    return document_of(str(request.param))


def test_every_format_shows_the_same_formulas(document):
    own, *formats = on_pages(document).items()
    assert own[1].total() > 10
    for format, shown in formats:
        more, less = shown - own[1], own[1] - shown
        assert not more, (format, list(more)[:2])
        assert not less, (format, list(less)[:2])


def test_what_a_user_writes_is_one_paragraph():
    words = "one\n\n  two\n\t\n\nthree"
    declared = drop().system
    parameters = (replace(declared.parameters[0], description=words), *declared.parameters[1:])
    system = replace(declared, description=words, parameters=parameters, model=(words,))
    document = describe_system(system)
    for text in (to_markdown(document), to_latex(document)):
        assert text.count("one two three") == 3
        assert "one\n" not in text
    assert "\n| $g$ | one two three | $g > 0$ |\n" in to_markdown(document)


@cache
def raw_names():
    """Names in the code that LaTeX writes otherwise."""
    symbols = set()
    for written in map(written_of, ORBITS):
        symbols |= {*written.equations.unknowns, *written.notation.functions}
        shown = [line.shows for line in written.lines if line.shows is not None]
        symbols = symbols.union(*(expression.free_symbols for expression in shown))
    return {name for name in map(str, symbols) if re.search(r"\d|_", name)}


def test_no_raw_names_remain(document):
    raw = raw_names()
    assert {"z10", "half_tau", "coefficient11"} <= raw
    for text in (to_markdown(document), to_latex(document)):
        words = set(re.findall(r"(?<!\\)\b[A-Za-z]\w*[\d_]\w*", text))
        assert not words & raw
        assert not re.search(r"(?<![\\A-Za-z])(chi|eta|tau|omega|kappa)(?![A-Za-z])", text)
        assert "None" not in text


def test_sentences_end(document):
    for block, following in pairwise((*document.blocks, Paragraph(""))):
        if not isinstance(block, Paragraph):
            continue
        assert "  " not in block.text
        assert not re.search(r"\b(and|or|,)\.", block.text)
        goes_on = isinstance(following, Formula) or texts_of(following)[0].startswith("*")
        assert block.text.endswith((".", ":")) or goes_on, block.text
        dollars = re.sub(r"\$[^$]*\$", "", block.text)
        assert "$" not in dollars
        assert dollars.count("*") % 2 == 0


def test_equations_are_numbered_by_sections(document):
    section, labels = 0, []
    for block in document.blocks:
        if isinstance(block, Heading) and block.level == 1:
            section, place = section + 1, 0
            assert block.number == section
        elif isinstance(block, Formula) and block.label:
            place += 1
            labels.append(block.label)
            assert block.label == f"{section}.{place}"
    texts = [text for block in document.blocks for text in texts_of(block)]
    cited = {m for t in texts for m in re.findall(r"(?:^|\s)\((\d[\d.]*)\)(?! of)", t)}
    assert cited - {"2011"} <= set(labels)


def test_a_page_begins_in_front_of_headings_and_not_between_them(document):
    blocks = pairwise((None, *document.blocks))
    begun = [isinstance(b, Heading) and not isinstance(a, Heading) for a, b in blocks]
    _, _, text = to_latex(document).partition(r"\begin{document}")
    assert text.count(r"\needroom{") == sum(begun)
    assert not re.search(r"section\{.*\}\s*\\needroom", text)


def test_html_is_one_offline_page(document):
    page = page_of(document)
    assert not {e.tag for e in page.iter()} & {"script", "link", "img", "iframe"}
    assert not any({"href", "src"} & {*e.attrib} for e in page.iter())
    style = page.findtext("head/style")
    assert not re.search(r"url\(|@import", str(style))
    words = "".join(page.itertext()).replace(str(style), "")
    assert "\\" not in words
    assert "://" not in words
    shown = [e.get("class") for e in page.iter("div")]
    assert shown.count("formula") == len(document.formulas)
    assert not {e.text for e in page.iter("mi")} & {"cos", "sin", "det", "tr"}
    numbers = [e.text for e in page.iter("span") if e.get("class") == "number"]
    assert numbers == [f"({f.label})" for f in document.formulas if f.label]


def test_mathml_is_set_as_tex_sets_it():
    def operators(latex):
        return list(page_of(Document("", (Paragraph(f"${latex}$"),))).iter("mo"))

    found = operators(
        r"- u \left(1 - p\right) \cos \omega t + \frac{a}{2} = -\left(\frac{1}{2}\right)"
    )
    (cosine,) = (o for o in found if o.text == "cos")
    assert cosine.get("lspace") == cosine.get("rspace") == "0.167em"
    fences = [o.get("stretchy") for o in found if o.get("stretchy")]
    assert fences == ["false", "false", "true", "true"]
    # both parentheses, and the sign behind "="
    assert [o.get("form") for o in found].count("prefix") == 3
    assert [o.get("stretchy") for o in operators("|x|")] == ["false", "false"]


@needs_latex
@pytest.mark.parametrize(
    "name", marked(declarations(), *(n for n in names(Itinerary) if n not in ORBITS))
)
def test_no_formula_passes_the_margin(name, tmp_path):
    """Nor of an orbit with equations as it is composed."""
    declared, documents = declarations()[name], [document_of(name)]
    if isinstance(declared, Itinerary):
        documents.append(describe_orbit(declared))
    for document in documents:
        (tmp_path / "document.tex").write_text(to_latex(document), encoding="utf-8")
        options = ["-interaction=nonstopmode", "-halt-on-error", "-draftmode", "-no-shell-escape"]
        command = ["pdflatex", *options, "document.tex"]
        subprocess.run(command, cwd=tmp_path, capture_output=True, check=True)
        log = (tmp_path / "document.log").read_text(encoding="latin-1")
        overfull = re.findall(r"Overfull \\[hv]box \(([\d.]+)pt", log)
        assert not [o for o in overfull if float(o) > 1]


@needs_latex
def test_pdf_is_compiled(tmp_path):
    out = tmp_path / "document.pdf"
    told("equations", "rigid-stop", "--format", "pdf", "--out", str(out))
    assert out.read_bytes().startswith(b"%PDF")

"""The report of `nonsmooth reproduce` as JSON, Markdown and one page of HTML."""

import json
import re
from base64 import b64decode
from collections import Counter
from itertools import pairwise
from xml.etree import ElementTree

import pytest

from nonsmooth.runtime.present.paper import writing
from tests.present.conftest import written
from tests.present.elements import Elements
from tests.present.formulas import notes


@pytest.fixture(scope="module")
def page(paper):
    return paper.read("report.html")


@pytest.fixture(scope="module")
def elements(page):
    return Elements(page)


@pytest.fixture(scope="module")
def markdown(paper):
    return paper.read("report.md")


@pytest.fixture(scope="module")
def inline(page):
    """Meanings of formulas, as the page has them."""
    return notes(page)


# --- JSON and Markdown


@pytest.mark.slow
def test_json_is_that_of_every_reader(paper):
    def refused(constant):
        raise AssertionError(f"{constant} is no JSON")

    text = paper.read("results.json")
    assert next(iter(json.loads(text, parse_constant=refused))) == "orbits"
    assert text.startswith('{\n  "orbits"')
    assert text.endswith("}\n")
    assert text.isascii()


def test_markdown_tables_have_equal_rows(markdown):
    blocks = [part.splitlines() for part in markdown.split("\n\n")]
    tables = [lines for lines in blocks if lines[0].startswith("|")]
    assert len(tables) > 10
    for lines in tables:
        assert len({len(re.findall(r"(?<!\\)\|", line)) for line in lines}) == 1
        assert not any("\\|" in maths for line in lines for maths in re.findall(r"\$.*?\$", line))
    headers = [lines[0] for lines in tables]
    assert "| Quantity | Where | Printed | Ours | Difference | Verdict |" in headers


def test_markdown_has_every_text(markdown, paper):
    finding = paper.results["misprints"][0]
    for part in (
        "# Two models of nonsmooth dynamical systems, reproduced\n",
        "\n## Rigid impact (Secs. 2.1, 2.3)\n",
        "\n\\- This one is no list.\n",
        "Plain & *stressed* text with $x_1'' \\le 1$ and \\<b>no tag\\</b>.",
        "\n\n$$\n\\begin{aligned}",
        "\\end{aligned}\n$$\n\nWhat $m$ is.\n",
        "\n**The orbit *rigid-stop/one-impact* at the paper's data**\n",
        "\n![Fig. 1. Coupled oscillators with a stop.](figure-01.svg)\n",
        "\nFig. 1. Coupled oscillators with a stop.\n",
        f"\n### {finding['title']}\n\n- **Printed:** ",
        "\n- **Verdict:** misprint\n- **Corrected:** ",
        "\n- **Evidence:** ",
    ):
        assert part in markdown


# --- HTML


def test_page_is_well_formed_and_ordered(page, elements):
    tags = [tag for tag, _ in elements.found]
    assert page.startswith('<!DOCTYPE html>\n<html lang="en">')
    assert tags.count("main") == tags.count("nav") == tags.count("h1") == 1
    assert len(set(re.findall(r"<(?:title|h1)>(.*)</", page))) == 1
    levels = [int(tag[1]) for tag in tags if re.fullmatch("h[1-6]", tag)]
    assert all(deeper <= level + 1 for level, deeper in pairwise(levels))


def test_every_chapter_is_linked(elements):
    anchors = elements.attributes("id", "section")
    assert anchors[0] == "rigid-impact"
    assert anchors[-2:] == ["proofs", "misprints"]
    assert elements.attributes("href", "a") == [f"#{anchor}" for anchor in anchors]


def test_page_loads_nothing(page, elements):
    links = [link for name in ("src", "href", "data") for link in elements.attributes(name)]
    assert links
    assert all(link.startswith(("#", "data:")) for link in links)
    assert not elements.tags & {"script", "link", "iframe", "object", "embed"}
    assert not re.search(r"@import|url\((?!#)", page)


def test_names_are_unique_and_references_resolve(elements):
    counts = Counter(elements.attributes("id"))
    assert max(counts.values()) == 1
    assert {link.removeprefix("#") for link in elements.attributes("href")} == set(counts)


def test_pictures_scale_and_say_what_they_are(page, elements, paper):
    """Each is the file beside the page, and part of the page."""
    told = elements.attributes("alt", "img")
    assert len({*told}) == len(paper.figures)
    assert told[0] == "Fig. 1. Coupled oscillators with a stop."
    kinds, shown = zip(*(x.split(",") for x in elements.attributes("src", "img")), strict=True)
    assert {*kinds} == {"data:image/svg+xml;base64"}
    assert sorted(map(b64decode, shown)) == sorted(
        (paper.folder / f"{x}.svg").read_bytes() for x in paper.figures
    )
    assert re.search(r"\.picture img \{[^}]*max-width: 100%", page)


def test_text_is_escaped(page, elements, inline):
    assert not {"b", "i"} & elements.tags
    assert "<b>no tag</b>" in elements.words
    assert "<i>none</i>" in elements.words
    assert inline["plain"].startswith("Plain &amp; <em>stressed</em> text")


def test_formulas_are_mathml(page, elements):
    assert "$" not in elements.words
    assert "\\" not in elements.words
    assert "block" in elements.attributes("display", "math")
    assert "<mtext>r</mtext>" in page
    assert "<mi>m</mi>" in page


def test_page_has_every_verdict(page, paper):
    tones = {"agrees": "good", "holds": "good", "misprint": "changed"}
    verdicts = [
        entry["verdict"] for name in ("comparisons", "claims", "misprints")
        for entry in paper.results[name]
    ]  # fmt: skip
    page = page.replace("\N{NO-BREAK SPACE}", " ")
    badges = re.findall(r'class="badge (\w+)">([^<]*)<', page)
    assert sorted(told for _, told in badges) == sorted(verdicts)
    assert all(tones[told.split()[0]] == tone for tone, told in badges)


def test_long_formula_may_break_after_a_sign_outside_of_parentheses(
    inline,
):
    pieces = [Elements(f"{x}</math>").words for x in inline["long"].split("</math>")[:-1]]
    assert pieces == ["(a+b)2+", "|c−d|=", "e−", "f+", "g"]
    assert inline["short"].count("<math") == 1


def test_formulas_are_mended(inline):
    assert '<mo form="prefix">−</mo>' in inline["leading"]
    assert '<mo form="prefix">−</mo>' not in inline["between"]
    assert '<mo lspace="0.167em" rspace="0">tr</mo>' in inline["name"]
    assert '<mo lspace="0" rspace="0.167em">sin</mo>' in inline["function"]
    assert inline["primes"].count('class="prime"') == 2
    bars = ElementTree.fromstring(inline["bars"]).findall(".//msup/mrow/mo")
    assert [bar.get("form") for bar in bars] == ["prefix", "postfix"]


def test_full_stop_stays_with_its_formula(inline):
    joined = re.findall(r'<span class="joined">(.*?)</span>', inline["stops"])
    assert [Elements(part).words for part in joined] == ["(x)", "y,"]


@pytest.mark.parametrize(
    "latex", [r"\unheardof{x}", r"\begin{gathered} a \\ b \end{gathered}", "a & b"]
)
def test_unknown_latex_is_refused(latex):
    with pytest.raises(ValueError, match="latex2mathml does not know all of"):
        writing.to_html(f"# A report\n\n$$\n{latex}\n$$\n", {})


@pytest.mark.slow
def test_a_report_that_cannot_be_written_leaves_no_folder(tmp_path, monkeypatch, orbits):
    monkeypatch.setattr(writing, "paper_orbits", lambda begin: orbits)
    with pytest.raises(ValueError, match="latex2mathml does not know all of"):
        written(tmp_path / "paper", lambda orbit, section: (("a & b", ""),))
    assert not (tmp_path / "paper").exists()

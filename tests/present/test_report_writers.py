"""The report of `nonsmooth reproduce` as JSON, Markdown and one page of HTML."""

import json
import re
import sys
from collections import Counter
from functools import cache
from html.parser import HTMLParser
from io import StringIO
from itertools import pairwise
from xml.etree import ElementTree

import pytest

from nonsmooth import MissingExtra
from nonsmooth.runtime.present.paper.mathml import Formulas
from nonsmooth.runtime.present.paper.records import (
    Chapter,
    Comparison,
    Comparisons,
    Equation,
    Finding,
    Report,
    ReportFigure,
    Table,
    Text,
)
from nonsmooth.runtime.present.paper.writers import to_html, to_json, to_markdown

DIGITS = "0.483112345678901234567890123456"
VOID = {"br", "hr", "img", "input", "link", "meta", "source", "wbr"}


def report() -> Report:
    """Build a report with every kind of block, and with text that has to be escaped."""
    numbers = Table(
        caption="Multipliers at $\\eta = 1$",
        header=("Root", "$|\\lambda|$", "a | b"),
        rows=(("<b>first</b>", "$|x| < 1$", "1 | 2"), ("*second*", DIGITS, "x_1 & y")),
    )
    blocks = (
        Text("Plain & *stressed* text with $x_1'' \\le 1$ and <b>no tag</b>."),
        Equation(
            latex=r"\begin{aligned} m x'' &= -k x + "
            + " + ".join(["u_{\\mathrm{r}}"] * 40)
            + r" \\"
            r" \text{<i>none</i>} &< \frac{1}{2} \end{aligned}",
            note="What $m$ is.",
        ),
        numbers,
    )
    compared = Comparisons(
        caption="Numbers of Sec. 5",
        rows=(
            comparison(r"\lvert\lambda\rvert", "agrees within the printed digits"),
            comparison(r"|\tau|", "misprint", enclosure=f"[{DIGITS}, {DIGITS}1]"),
        ),
    )
    findings = (
        Finding(
            "Eq. (2): $x'$", "$x' = 1$", "misprint", "$x' = 2$", "Both were computed.", numbers
        ),
        Finding("Claim of Sec. 4", "It is stable.", "does not hold", "", "The trace is 1.2."),
    )
    return Report(
        title="Numbers & figures of $E_1$",
        summary=("The first paragraph.", "- The second one is no list."),
        chapters=(
            Chapter("words-and-tables", "Words <and> tables", blocks),
            Chapter("pictures", "Pictures", (picture(1), picture(2), picture(1))),
            Chapter("verdicts", "Verdicts on $V$", (compared, *findings)),
        ),
        results={"trace": DIGITS, "names": ["τ", {"count": 3}], "a": None},
    )


def comparison(quantity: str, verdict: str, enclosure: str = "") -> Comparison:
    return Comparison(quantity, "Sec. 5, Eq. (12)", "0.4831", DIGITS, "1.23e-5", verdict, enclosure)


def picture(number: int) -> ReportFigure:
    caption = f'Figure {number}. *Phase* portrait, $x_{number}$ in "[0, 1)"'
    return ReportFigure(f"figure-0{number}", caption)


@cache
def pictures() -> dict[str, str]:
    """Draw two pictures whose names collide."""
    matplotlib = pytest.importorskip("matplotlib")
    from matplotlib.figure import Figure

    drawn = {}
    for number in (1, 2):
        figure = Figure(figsize=(6.4, 3.6))
        figure.subplots().plot([0, 1, 2], [0, number, 1], "o-", label="$x_1$")
        out = StringIO()
        with matplotlib.rc_context({"svg.hashsalt": "nonsmooth"}):
            figure.savefig(out, format="svg", metadata={"Date": None})
        drawn[f"figure-0{number}"] = out.getvalue()
    return drawn


@cache
def page() -> str:
    pytest.importorskip("jinja2")
    pytest.importorskip("latex2mathml")
    return to_html(report(), pictures())


class Elements(HTMLParser):
    """Start tags with their attributes, text, and whether every element is closed in turn."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.found: list[tuple[str, dict[str, str]]] = []
        self.words = ""
        self.open: list[str] = []
        self.feed(text)
        self.close()

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        self.handle_startendtag(tag, attributes)
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        self.found.append((tag, {name: value or "" for name, value in attributes}))

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag

    def handle_data(self, text: str) -> None:
        self.words += text

    def attributes(self, name: str, tag: str = "") -> list[str]:
        """Values of an attribute, on one tag or on all."""
        return [
            found[name] for kind, found in self.found if name in found and kind in (tag or kind)
        ]


# --- JSON


def test_json_gives_back_the_results_in_their_order() -> None:
    text = to_json(report())
    assert json.loads(text) == report().results
    assert list(json.loads(text)) == ["trace", "names", "a"]
    assert text == to_json(report())
    assert text.startswith('{\n  "trace": "0.4831')
    assert text.endswith("}\n")
    assert text.isascii()


def test_json_refuses_what_is_no_number() -> None:
    broken = Report("", (), (), {"trace": float("nan")})
    with pytest.raises(ValueError, match="not JSON compliant"):
        to_json(broken)


# --- Markdown


def pipe_tables(text: str) -> list[list[str]]:
    """Groups of consecutive lines that begin with a pipe."""
    blocks = [part.splitlines() for part in text.split("\n\n")]
    return [lines for lines in blocks if lines[0].startswith("|")]


def test_markdown_tables_have_equal_rows() -> None:
    tables = pipe_tables(to_markdown(report()))
    assert [len(lines) for lines in tables] == [4, 4, 4]
    for lines in tables:
        assert len({len(re.findall(r"(?<!\\)\|", line)) for line in lines}) == 1
        assert not any("\\|" in maths for line in lines for maths in re.findall(r"\$.*?\$", line))
    assert tables[0][2] == r"| \<b>first\</b> | $\vert x\vert  \lt  1$ | 1 \| 2 |"


def test_markdown_has_every_text_and_number() -> None:
    text = to_markdown(report())
    compared = report().chapters[2].blocks[0]
    assert isinstance(compared, Comparisons)
    for row in compared.rows:
        wanted = (row.where, row.printed, row.ours, row.difference, row.verdict, row.enclosure)
        assert all(part in text for part in wanted)
    for part in (
        "# Numbers & figures of $E_1$\n",
        "\n## Words \\<and> tables\n",
        "\n\\- The second one is no list.\n",
        "Plain & *stressed* text with $x_1'' \\le 1$ and \\<b>no tag\\</b>.",
        "\n\n$$\n\\begin{aligned}",
        "\\end{aligned}\n$$\n\nWhat $m$ is.\n",
        "**Multipliers at $\\eta = 1$**\n",
        '\n![Figure 1. Phase portrait, x_1 in "\\[0, 1)"](figure-01.svg)\n',
        '\nFigure 1. *Phase* portrait, $x_1$ in "[0, 1)"\n',
        "\n### Eq. (2): $x'$\n\n- **Printed:** $x' = 1$\n- **Verdict:** misprint\n"
        "- **Corrected:** $x' = 2$\n- **Evidence:** Both were computed.\n\n**Multipliers",
        "- **Verdict:** does not hold\n- **Evidence:** The trace is 1.2.\n",
    ):
        assert part in text


def test_markdown_has_no_enclosures_where_there_are_none() -> None:
    rows = (comparison("x", "misprint"),)
    chapter = Chapter("a", "A", (Comparisons("Numbers", rows),))
    text = to_markdown(Report("T", (), (chapter,), {}))
    assert "| Quantity | Where | Printed | Ours | Difference | Verdict |\n" in text


# --- HTML


def test_page_is_well_formed_and_ordered() -> None:
    elements = Elements(page())
    assert not elements.open
    tags = [tag for tag, _ in elements.found]
    assert page().startswith('<!DOCTYPE html>\n<html lang="en">')
    assert tags.count("main") == tags.count("nav") == tags.count("h1") == 1
    levels = [int(tag[1]) for tag in tags if re.fullmatch("h[1-6]", tag)]
    assert all(deeper <= level + 1 for level, deeper in pairwise(levels))
    assert page() == to_html(report(), pictures())


def test_every_chapter_is_linked() -> None:
    elements = Elements(page())
    anchors = [chapter.anchor for chapter in report().chapters]
    assert elements.attributes("href", "a") == [f"#{anchor}" for anchor in anchors]
    assert elements.attributes("id", "section") == anchors


def test_page_loads_nothing() -> None:
    elements = Elements(page())
    links = [link for name in ("src", "href", "data") for link in elements.attributes(name)]
    assert links
    assert all(link.startswith("#") for link in links)
    tags = {tag for tag, _ in elements.found}
    assert not tags & {"script", "link", "iframe", "object", "embed", "img"}
    assert not re.search(r"@import|url\((?!#)", page())


def test_names_are_unique_and_references_resolve() -> None:
    elements = Elements(page())
    counts = Counter(elements.attributes("id"))
    assert max(counts.values()) == 1
    inside = re.findall(r"url\(#([^)]*)\)", page())
    links = [link.removeprefix("#") for link in elements.attributes("href")]
    assert inside
    assert len(links) > 3
    assert {*inside, *links} <= set(counts)
    assert len(set(inside)) == 3  # one clip path in each of three pictures


def test_pictures_scale_and_say_what_they_are() -> None:
    drawings = [found for tag, found in Elements(page()).found if tag == "svg"]
    assert len(drawings) == 3
    for drawing in drawings:
        assert drawing["role"] == "img"
        assert drawing["aria-label"].startswith("Figure ")
        assert drawing["style"] == "width: 460.8pt"
        assert "viewbox" in drawing
        assert not {"width", "height"} & set(drawing)
    assert "metadata" not in page()


def test_style_of_a_picture_stays_within_it() -> None:
    (style, *_) = re.findall(r"<style type=[^>]*>([^{]*)\{", page())
    scope = style.split()[0].removeprefix("#")
    assert style == f"#{scope} *"
    assert scope in Elements(page()).attributes("id", "svg")


def test_text_is_escaped() -> None:
    elements = Elements(page())
    assert not {"b", "i"} & {tag for tag, _ in elements.found}
    for words in ("<b>no tag</b>", "<b>first</b>", "<i>none</i>", "x_1 & y", "Words <and> tables"):
        assert words in elements.words
    assert ("em", {}) in elements.found
    assert "<em>stressed</em>" in page()


def test_numbers_and_verdicts_are_escaped() -> None:
    pytest.importorskip("jinja2")
    pytest.importorskip("latex2mathml")
    row = Comparison("x", *["<b>1</b>"] * 6)
    chapter = Chapter("a", "A", (Comparisons("<b>", (row,)),))
    elements = Elements(to_html(Report("<b>", ("<b>",), (chapter,), {}), {}))
    assert "b" not in {tag for tag, _ in elements.found}
    assert elements.words.count("<b>1</b>") == 6


def test_formulas_are_mathml() -> None:
    elements = Elements(page())
    assert "$" not in elements.words
    assert "\\" not in elements.words
    assert elements.attributes("display", "math").count("block") == 1
    assert "<mtext>r</mtext>" in page()
    assert "<mi>m</mi>" in page()


def test_page_has_every_number_and_verdict() -> None:
    words = Elements(page()).words
    assert words.count(DIGITS) == 2 + 2 + 2  # in two tables, two comparisons, one enclosure
    assert words.count("proven enclosure") == 1
    assert words.count("Corrected") == 1
    classes = re.findall(r'class="badge (\w+)">([^<]*)<', page())
    assert classes == [
        ("good", "agrees within the printed digits"),
        ("changed", "misprint"),
        ("changed", "misprint"),
        ("bad", "does not hold"),
    ]


def inline(latex: str) -> str:
    pytest.importorskip("latex2mathml")
    return Formulas().inline(latex)


def test_long_formula_may_break_after_a_sign_outside_of_parentheses() -> None:
    found = inline("(a+b)^2 + |c-d| = e - f + g")
    pieces = ["".join(Elements(piece).words) for piece in found.split("</math>")[:-1]]
    assert pieces == ["(a+b)2+", "|c−d|=", "e−", "f+", "g"]
    assert inline("a = b + c").count("<math") == 1


def test_formulas_are_mended() -> None:
    assert '<mo form="prefix">−</mo>' in inline("a = -b")
    assert '<mo form="prefix">−</mo>' not in inline("a - b")
    assert '<mo lspace="0.167em" rspace="0">tr</mo>' in inline(r"2\operatorname{tr}(M)")
    assert '<mo lspace="0" rspace="0.167em">sin</mo>' in inline(r"\sin x")
    assert inline("x_1''").count('class="prime"') == 2
    matrix = ElementTree.fromstring(inline(r"\begin{pmatrix} 1 & 2 \end{pmatrix}^{-1}"))
    assert [len(power) for power in matrix.iter("msup")] == [2]
    closing = ElementTree.fromstring(inline(r"\lvert x \rvert^2")).find(".//msup/mo")
    assert closing is not None
    assert closing.get("form") == "postfix"


def test_full_stop_stays_with_its_formula() -> None:
    chapter = Chapter("a", "A", (Text("Here ($x$) and $y$, and $z$ too."),))
    pytest.importorskip("jinja2")
    found = to_html(Report("T", (), (chapter,), {}), {})
    joined = re.findall(r'<span class="joined">(.*?)</span>', found)
    assert [Elements(part).words for part in joined] == ["(x)", "y,"]


@pytest.mark.parametrize(
    "latex", [r"\unheardof{x}", r"\begin{gathered} a \\ b \end{gathered}", "a & b"]
)
def test_unknown_latex_is_refused(latex: str) -> None:
    pytest.importorskip("jinja2")
    pytest.importorskip("latex2mathml")
    chapter = Chapter("a", "A", (Equation(latex),))
    with pytest.raises(ValueError, match="latex2mathml does not know all of"):
        to_html(Report("T", (), (chapter,), {}), {})


def test_colliding_pictures_are_a_fair_test() -> None:
    names = [
        {element.get("id") for element in ElementTree.fromstring(text).iter()} - {None}
        for text in pictures().values()
    ]
    assert names[0] & names[1]


@pytest.mark.parametrize(
    ("package", "module"), [("jinja2", "jinja2"), ("latex2mathml", "latex2mathml.converter")]
)
def test_missing_packages_are_named(
    package: str, module: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, package, None)
    monkeypatch.setitem(sys.modules, module, None)
    with pytest.raises(MissingExtra, match=rf'^{package} is not installed: .*"nonsmooth\[html\]"$'):
        to_html(report(), {})

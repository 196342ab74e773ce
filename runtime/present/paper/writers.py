"""Reports as JSON, as Markdown and as one HTML page that needs no network."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Mapping
from importlib.resources import files
from itertools import count
from typing import TYPE_CHECKING
from xml.etree import ElementTree

from nonsmooth.runtime.core.errors import missing_extra
from nonsmooth.runtime.present.paper.mathml import Formulas
from nonsmooth.runtime.present.paper.records import (
    Block,
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

if TYPE_CHECKING:
    from jinja2 import Template
    from markupsafe import Markup

__all__ = ["to_html", "to_json", "to_markdown"]

_MARKS = re.compile(r"(\$[^$]+\$|\*[^*]+\*)")
_SVG = "{http://www.w3.org/2000/svg}"
_XML = "{http://www.w3.org/XML/1998/namespace}"
_NOTHING: Mapping[str, str] = {}
_HEADER = ("Quantity", "Where", "Printed", "Ours", "Difference", "Verdict")


def to_json(report: Report) -> str:
    """JSON of every number of a report, in its order; equal results give equal bytes.

    `ValueError` is raised for a number that is infinite or not a number.
    """
    return json.dumps(report.results, indent=2, allow_nan=False) + "\n"


def to_markdown(report: Report) -> str:
    """Markdown of a report, for GitHub and plain reading; pictures are ``<stem>.svg`` beside it."""
    chapters = (part for chapter in report.chapters for part in _chapter_markdown(chapter))
    parts = [f"# {_prose(report.title)}", *map(_paragraph, report.summary), *chapters]
    return "\n\n".join(parts) + "\n"


def to_html(report: Report, pictures: Mapping[str, str]) -> str:
    """HTML of a report as one page that includes style, equations as MathML, and pictures.

    `pictures` has the SVG of each picture by its stem. `MissingExtra` is raised if Jinja2
    or latex2mathml is not installed, and `ValueError` for LaTeX that latex2mathml does not
    know.
    """
    return _template(_Page(Formulas(), pictures)).render(report=report)


# --- Markdown


def _chapter_markdown(chapter: Chapter) -> list[str]:
    """Parts of a chapter, to be joined by empty lines."""
    blocks = (part for block in chapter.blocks for part in _block_markdown(block))
    return [f"## {_prose(chapter.title)}", *blocks]


def _block_markdown(block: Block) -> list[str]:
    """Parts of a block, to be joined by empty lines."""
    if isinstance(block, Text):
        return [_paragraph(block.text)]
    if isinstance(block, Equation):
        note = [_paragraph(block.note)] if block.note else []
        return [f"$$\n{block.latex.strip()}\n$$", *note]
    if isinstance(block, Table):
        return [f"**{_prose(block.caption)}**", _pipes(block.header, block.rows)]
    if isinstance(block, ReportFigure):
        words = re.sub(r"[\\\[\]`<]", r"\\\g<0>", _plain(block.caption))
        return [f"![{words}]({block.stem}.svg)", _paragraph(block.caption)]
    if isinstance(block, Comparisons):
        return [f"**{_prose(block.caption)}**", _comparisons_markdown(block.rows)]
    return _finding_markdown(block)


def _comparisons_markdown(rows: tuple[Comparison, ...]) -> str:
    """Markdown table of comparisons, with a column of enclosures if any row has one."""
    enclosed = any(row.enclosure for row in rows)
    cells = [
        (f"${row.quantity.strip()}$", row.where, row.printed, row.ours, row.difference, row.verdict)
        + ((row.enclosure,) if enclosed else ())
        for row in rows
    ]
    return _pipes(_HEADER + (("Enclosure",) if enclosed else ()), cells)


def _finding_markdown(finding: Finding) -> list[str]:
    """Parts of a finding, which has a heading of its own."""
    entries = {
        "Printed": finding.printed,
        "Verdict": finding.verdict,
        "Corrected": finding.corrected,
        "Evidence": finding.evidence,
    }
    lines = [f"- **{name}:** {_prose(text)}" for name, text in entries.items() if text]
    table = _block_markdown(finding.table) if finding.table else []
    return [f"### {_prose(finding.title)}", "\n".join(lines), *table]


def _pipes(header: Iterable[str], rows: Iterable[Iterable[str]]) -> str:
    """Markdown table of a header and rows."""
    lines = [[_cell(text) for text in row] for row in (header, *rows)]
    lines.insert(1, ["---"] * len(lines[0]))
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


def _cell(text: str) -> str:
    """Text of a cell of a table, without a bare pipe, in maths or outside."""
    return _prose(text, {"|": r"\|"}, {r"\|": r"\Vert ", "|": r"\vert "})


def _paragraph(text: str) -> str:
    """Text of a paragraph that Markdown does not take for a list, a quotation or a heading."""
    return re.sub(r"^(\d*)([-+#>.)]\s|[#>])", r"\1\\\2", _prose(text))


def _prose(
    text: str, words: Mapping[str, str] = _NOTHING, maths: Mapping[str, str] = _NOTHING
) -> str:
    """Text with its marks on one line, and all other special characters of Markdown escaped.

    The replacements `words` apply outside of maths, and `maths` inside, each in its order.
    """
    found = []
    for part in _MARKS.split(" ".join(text.split())):
        if _marked(part, "$"):
            found.append(_replaced(part, {"<": r"\lt "} | dict(maths)))
        elif _marked(part, "*"):
            found.append(f"*{_prose(part[1:-1], words, maths)}*")
        else:
            found.append(_replaced(_escaped(part), words))
    return "".join(found)


def _escaped(words: str) -> str:
    """Words with the special characters of Markdown escaped."""
    return re.sub(r"[\\`*_~<$]|&(?=#?\w+;)", r"\\\g<0>", words)


def _replaced(text: str, replacements: Mapping[str, str]) -> str:
    """The text after all replacements, one after the other."""
    for old, new in replacements.items():
        text = text.replace(old, new)
    return text


# --- HTML


def _template(page: _Page) -> Template:
    """The page's template; inserted text is escaped unless `page` has made it."""
    try:
        from jinja2 import Environment, StrictUndefined
    except ImportError:
        raise missing_extra("html", "jinja2") from None
    environment = Environment(
        autoescape=True, trim_blocks=True, lstrip_blocks=True, undefined=StrictUndefined
    )
    environment.filters |= {
        "display": page.display,
        "inline": page.inline,
        "kind": lambda block: type(block).__name__,
        "plain": _plain,
        "prose": page.prose,
        "svg": page.svg,
        "tone": _tone,
    }
    environment.globals |= {"comparison_header": _HEADER}
    source = files("nonsmooth.runtime.present.paper").joinpath("page.html")
    return environment.from_string(source.read_text(encoding="utf-8"))


class _Page:
    """Converter of text, formulas and pictures to the HTML of a page."""

    def __init__(self, formulas: Formulas, pictures: Mapping[str, str]) -> None:
        self.formulas = formulas
        self.pictures = pictures
        self.numbers = count(1)

    def prose(self, text: str) -> Markup:
        """HTML of a text with marks."""
        from markupsafe import Markup

        found = Markup()
        for part in _MARKS.split(text):
            if _marked(part, "$"):
                found += self.inline(part[1:-1])
            elif _marked(part, "*"):
                found += Markup("<em>{}</em>").format(self.prose(part[1:-1]))
            else:
                found += part
        return _joined(found)

    def inline(self, latex: str) -> Markup:
        """MathML of a formula within a line."""
        from markupsafe import Markup

        return Markup(self.formulas.inline(latex))

    def display(self, latex: str) -> Markup:
        """MathML of a formula on a line of its own."""
        from markupsafe import Markup

        return Markup(self.formulas.display(latex))

    def svg(self, picture: ReportFigure) -> Markup:
        """SVG of a picture that scales, with ids that no other picture of the page has."""
        drawing = ElementTree.fromstring(self.pictures[picture.stem])
        _simplify(drawing)
        _rename(drawing, f"svg{next(self.numbers)}-")
        width = drawing.attrib.pop("width", "100%")
        drawing.attrib.pop("height", None)
        drawing.attrib |= {
            "role": "img",
            "aria-label": _plain(picture.caption),
            "style": f"width: {width}",
        }
        return _markup(drawing)


def _joined(text: Markup) -> Markup:
    """The text with formulas and the punctuation beside them kept on one line."""
    from markupsafe import Markup

    formula = r"([(\[]*)(<math\b(?:(?!<math\b).)*?</math>)([.,;:!?)\]]*)"
    return Markup(re.sub(formula, _join, text, flags=re.DOTALL))


def _join(found: re.Match[str]) -> str:
    """A formula and the punctuation beside it, as one piece of HTML."""
    return f'<span class="joined">{found[0]}</span>' if found[1] or found[3] else found[0]


def _simplify(drawing: ElementTree.Element) -> None:
    """Remove metadata and namespaces, which HTML does not have."""
    for child in drawing.findall(f"{_SVG}metadata"):
        drawing.remove(child)
    for element in drawing.iter():
        element.tag = element.tag.rpartition("}")[2]
        element.attrib = {
            name.rpartition("}")[2]: value
            for name, value in element.attrib.items()
            if not name.startswith(_XML)
        }


def _rename(drawing: ElementTree.Element, prefix: str) -> None:
    """Put a prefix before every id, and keep styles within the drawing."""
    drawing.attrib.setdefault("id", "drawing")
    for element in drawing.iter():
        for name, value in element.attrib.items():
            if name == "id" or (name == "href" and value.startswith("#")):
                element.set(name, re.sub(r"^#?", rf"\g<0>{prefix}", value))
            else:
                element.set(name, value.replace("url(#", f"url(#{prefix}"))
        if element.tag == "style":
            scope = f"#{drawing.attrib['id']} "
            element.text = re.sub(r"([^{},]+)(?=[^{}]*\{)", rf"{scope}\1", element.text or "")


def _markup(element: ElementTree.Element) -> Markup:
    """HTML of an element."""
    from markupsafe import Markup

    return Markup(ElementTree.tostring(element, encoding="unicode"))


def _marked(part: str, mark: str) -> bool:
    """Whether a part of a text stands between two marks."""
    return len(part) > 1 and part.startswith(mark)


def _plain(text: str) -> str:
    """Text without its marks."""
    return re.sub(r"[$*]", "", text)


def _tone(verdict: str) -> str:
    """CSS class of a verdict's badge."""
    tones = {
        "agrees": "good",
        "holds with": "changed",
        "holds": "good",
        "misprint": "changed",
        "does not": "bad",
    }
    return next((tone for start, tone in tones.items() if verdict.startswith(start)), "neutral")

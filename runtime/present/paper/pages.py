"""The report as Markdown, from its template, and that as one HTML page that needs no network.

Formulas of the page are latex2mathml's MathML, mended where a browser would set it badly.
"""

from __future__ import annotations

import re
from base64 import b64encode
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from html import unescape
from importlib.resources import files
from itertools import pairwise
from typing import TYPE_CHECKING, Any
from xml.etree import ElementTree
from xml.etree.ElementTree import Element

if TYPE_CHECKING:
    from markdown_it.tree import SyntaxTreeNode as Node
    from markupsafe import Markup

# maths, emphasised words, and what else Markdown does not take as it is
_SPECIAL = re.compile(r"(?P<maths>\$[^$]+\$)|\*(?P<words>[^*]+)\*|[\\`*_~<$|]|&(?=#?\w+;)")
_WITH = {"image": "paragraph", "strong": "table", "math_block": "paragraph"}
_TONES = {
    "agrees": "good",
    "holds with": "changed",
    "holds": "good",
    "misprint": "changed",
    "does not": "bad",
}
_CHILDREN = {"mfrac": 2, "mroot": 2, "msub": 2, "msup": 2, "msubsup": 3}
_CHILDREN |= {"munder": 2, "mover": 2, "munderover": 3}
_LONG = 8  # elements in a row, from which on it may break
_ROWS = ("math", "mrow", "mstyle", "mtd")
_RELATIONS = tuple("=<>≤≥≈≠≡∈→⇒,;")
_OPENING, _CLOSING = ("(", "[", "{"), (")", "]", "}")
_SIGNS = tuple("+−±")


def to_markdown(report: Mapping[str, Any]) -> str:
    """Markdown of a report, for GitHub and plain reading; pictures are ``<stem>.svg`` beside it.

    `report` has what the template names.
    """
    text = _rendered("report.md", {"prose": _prose, "plain": _plain}, report)
    return re.sub("\n{3,}", "\n\n", text).strip() + "\n"


def _prose(text: str) -> str:
    """Markdown of a text with marks, on one line: all that means something else is escaped."""

    def escaped(found: re.Match[str]) -> str:
        if found["maths"]:
            maths = found[0].replace("<", r"\lt ").replace(r"\|", r"\Vert ")
            return maths.replace("|", r"\vert ")  # no cell of a table may hold a bare pipe
        if found["words"]:
            return f"*{_SPECIAL.sub(escaped, found['words'])}*"
        return "\\" + found[0]

    line = _SPECIAL.sub(escaped, " ".join(text.split()))
    return re.sub(r"^(\d*)([-+#>.)]\s|[#>])", r"\1\\\2", line)  # no list, heading or quotation


def _plain(text: str) -> str:
    """Markdown of a text without its marks."""
    return re.sub(r"[\\\[\]`<]", r"\\\g<0>", re.sub(r"[$*]", "", text))


def to_html(markdown: str, pictures: Mapping[str, bytes]) -> str:
    """HTML of a report as one page that includes style, equations as MathML, and pictures.

    `markdown` is that of `to_markdown`, and `pictures` has the SVG of each file that it shows.
    `ValueError` is raised for LaTeX that latex2mathml does not know.
    """
    from markdown_it.tree import SyntaxTreeNode

    page = _Page(pictures)
    filters: dict[str, Callable[..., Any]] = {
        "anchor": lambda heading: re.sub(r"\W+", "-", heading.partition(" (")[0].lower()),
        "blocks": _blocks,
        "entries": page.entries,
        "html": page.html,
        "picture": page.picture,
        "rows": lambda table: [row.children for part in table.children for row in part.children],
        "sections": _sections,
        "tone": lambda verdict: next(
            (tone for start, tone in _TONES.items() if verdict.startswith(start)), "neutral"
        ),
    }
    parts = SyntaxTreeNode(page.reader.parse(markdown)).children
    return _rendered("page.html", filters, {"parts": parts}, autoescape=True)


def _rendered(
    name: str, filters: Mapping[str, Callable[..., Any]], values: Mapping[str, Any], **options: Any
) -> str:
    """Text of a template of this folder."""
    from jinja2 import Environment, StrictUndefined

    delimiters = {"variable": ("[[", "]]"), "block": ("[%", "%]"), "comment": ("[#", "#]")}
    for kind, (start, end) in delimiters.items():
        options |= {f"{kind}_start_string": start, f"{kind}_end_string": end}
    environment = Environment(
        trim_blocks=True, lstrip_blocks=True, undefined=StrictUndefined, **options
    )
    environment.filters |= filters
    source = files("nonsmooth.runtime.present.paper").joinpath(name).read_text(encoding="utf-8")
    return environment.from_string(source).render(values)


def _sections(parts: Iterable[Node], tag: str) -> list[tuple[Node | None, list[Node]]]:
    """Headings of a level and what stands below each; what stands before them has none."""
    found: list[tuple[Node | None, list[Node]]] = [(None, [])]
    for part in parts:
        if part.tag == tag:
            found.append((part, []))
        else:
            found[-1][1].append(part)
    return found


def _blocks(parts: Iterable[Node]) -> Iterator[tuple[Node, Node | None]]:
    """Yield parts with what belongs to each: words to a picture or formula, a table to its caption.

    A picture or a caption stands in a paragraph of its own, in whose place it is given.
    """
    rest = [
        inside[0]
        if part.type == "paragraph"
        and len(inside := _inside(part)) == 1
        and inside[0].type in ("image", "strong")
        else part
        for part in parts
    ]
    while rest:
        part = rest.pop(0)
        belongs = rest and rest[0].type == _WITH.get(part.type)
        yield part, rest.pop(0) if belongs else None


def _inside(paragraph: Node) -> list[Node]:
    """Parts of a paragraph's line, without empty ones."""
    return [part for part in paragraph.children[0].children if part.type != "text" or part.content]


class _Page:
    """Converter of Markdown's parts, formulas and pictures to the HTML of a page."""

    def __init__(self, pictures: Mapping[str, bytes]) -> None:
        from markdown_it import MarkdownIt
        from mdit_py_plugins.dollarmath import dollarmath_plugin

        self.pictures = pictures
        self.reader = MarkdownIt("commonmark").enable("table").use(dollarmath_plugin)
        for display in ("inline", "block"):
            self.reader.add_render_rule(f"math_{display}", _rule(display))

    def html(self, parts: Node | Sequence[Node]) -> Markup:
        """HTML of what is inside a heading, a paragraph or a cell, or of parts of a line.

        Formulas and the punctuation beside them are kept on one line.
        """
        from markupsafe import Markup

        if not isinstance(parts, Sequence):
            parts = parts.children or [parts]
        tokens = [token for part in parts for token in part.to_tokens()]
        found = self.reader.renderer.render(tokens, self.reader.options, {})
        beside = r"([(\[]*)(<math\b(?:(?!<math\b).)*?</math>)([.,;:!?)\]]*)"
        return Markup(re.sub(beside, _joined, found, flags=re.DOTALL).strip())

    def entries(self, items: Node) -> dict[str, Markup]:
        """HTML of a list's items by the names in front of them."""
        lines = [_inside(item.children[0]) for item in items.children]
        return {name.children[0].content.rstrip(":"): self.html(parts) for name, *parts in lines}

    def picture(self, image: Node) -> str:
        """Address of a picture that is part of the page."""
        content = b64encode(self.pictures[str(image.attrs["src"])])
        return f"data:image/svg+xml;base64,{content.decode()}"


def _rule(display: str) -> Callable[..., str]:
    """What markdown-it calls to render a formula, by its tokens and the place of one."""
    return lambda renderer, tokens, place, *_: _formula(tokens[place].content, display)


def _joined(found: re.Match[str]) -> str:
    """A formula and the punctuation beside it, as one piece of HTML."""
    return f'<span class="joined">{found[0]}</span>' if found[1] or found[3] else found[0]


# --- formulas


def _formula(latex: str, display: str) -> str:
    """HTML of a formula (LaTeX without delimiters).

    `display` is "block", on a line of its own, or "inline", in pieces between which a line may
    break. `ValueError` is raised for what latex2mathml does not know.
    """
    from latex2mathml.converter import convert_to_element

    math: Element = convert_to_element(_known(latex), display=display)
    del math.attrib["xmlns"]
    for element in list(math.iter()):
        if _misread(element):
            raise ValueError(f"latex2mathml does not know all of {latex}")
        element.text = unescape(element.text or "")
    for element in list(math.iter()):
        if element.tag in _ROWS:
            _space_names(element)
            _space_signs(element)
        elif element.text in ("′", "″"):
            _lower(element)
    pieces = [math] if display == "block" else _pieces(math)
    return "".join(ElementTree.tostring(piece, encoding="unicode") for piece in pieces)


def _known(latex: str) -> str:
    """The LaTeX, with what latex2mathml misreads replaced."""
    latex = latex.replace("{aligned}", "{align*}")
    latex = re.sub(r"\\mathrm\{([A-Za-z]+)\}", r"\\text{\1}", latex)
    return re.sub("(?<!')''(?!['^])", r"^{\\prime\\prime}", latex)


def _misread(element: Element) -> bool:
    """Whether an element is an unknown command, or comes from an unknown environment."""
    text = element.text or ""
    newline = element.tag == "mspace" and element.get("linebreak") == "newline"
    unknown = element.tag != "mtext" and ("\\" in text or text == "&")
    return newline or unknown or len(element) != _CHILDREN.get(element.tag, len(element))


def _core(element: Element) -> Element:
    """The base of an element with indices, or else the element."""
    return element[0] if element.tag in ("msub", "msup", "msubsup") else element


def _space_names(row: Element) -> None:
    """Give the names of functions the spaces that TeX gives them."""
    neighbours = [None, *row, None]
    for before, element, after in zip(neighbours, row, neighbours[2:], strict=False):
        name = _core(element)
        if re.fullmatch("[A-Za-z]{2,}", name.text or ""):
            name.tag = "mo"
            name.set("lspace", "0" if before is None or before.tag == "mo" else "0.167em")
            name.set("rspace", "0" if after is None or after.tag in ("mo", "mrow") else "0.167em")


def _space_signs(row: Element) -> None:
    """Set a leading sign close to its operand, and no space around a stroke."""
    for before, sign in pairwise(row):
        if before.text in (*_RELATIONS, *_OPENING) and sign.text in _SIGNS:
            sign.set("form", "prefix")
    for stroke in row:
        if stroke.text in ("/", "∂"):
            stroke.tag = "mo"
            stroke.attrib |= {"lspace": "0", "rspace": "0"}


def _lower(prime: Element) -> None:
    """Set a prime at the size and height that it has beside a letter; fonts hold it raised."""
    inner = Element("mi", {"class": "prime"})
    prime.tag, inner.text, prime.text = "mpadded", prime.text, ""
    prime.set("voffset", "-0.3em")
    prime.append(inner)


def _pieces(math: Element) -> Iterator[Element]:
    """Yield parts of a long formula, each up to a relation or sign outside of parentheses."""
    row = math[0] if len(math) else math
    if len(row) < _LONG:
        yield math
        return
    first = depth = 0
    for number, element in enumerate(row):
        sign = _core(element).text
        depth += (sign in _OPENING) - (sign in _CLOSING)
        if sign in _RELATIONS + _SIGNS and number > first and not depth:
            element.set("form", "infix")
            yield _inline(row[first : number + 1])
            first = number + 1
    if first < len(row):
        yield _inline(row[first:])


def _inline(elements: Sequence[Element]) -> Element:
    """An inline formula of these elements."""
    math = Element("math", {"display": "inline"})
    math.extend(elements)
    return math

"""LaTeX as MathML: latex2mathml's, mended where a browser would set it badly."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from html import unescape
from itertools import pairwise
from xml.etree import ElementTree
from xml.etree.ElementTree import Element

__all__ = ["formula"]

_CHILDREN = {"mfrac": 2, "mroot": 2, "msub": 2, "msup": 2, "msubsup": 3}
_CHILDREN |= {"munder": 2, "mover": 2, "munderover": 3}
_LONG = 8  # elements in a row, from which on it may break
_ROWS = ("math", "mrow", "mstyle", "mtd")
_BARS = ("|", "‖")
_RELATIONS = tuple("=<>≤≥≈≠≡∈→⇒,;")
_OPENING, _CLOSING = ("(", "[", "{"), (")", "]", "}")
_SIGNS = tuple("+−±")


def formula(latex: str, display: str) -> str:
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
            _pair_bars(element)
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
    latex = re.sub(r"(\\begin\{([pbvBV]matrix)\}.*?\\end\{\2\})", r"{\1}", latex, flags=re.DOTALL)
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


def _pair_bars(row: Element) -> None:
    """Set vertical bars as parentheses: every other one closes."""
    bars = [bar for bar in map(_core, row) if bar.text in _BARS and not bar.get("form")]
    if len(bars) % 2 == 0:
        for number, bar in enumerate(bars):
            bar.tag = "mo"
            bar.set("form", "postfix" if number % 2 else "prefix")
            bar.set("stretchy", "false")


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
    first = depth = bars = 0
    for number, element in enumerate(row):
        sign = _core(element).text
        depth += (sign in _OPENING) - (sign in _CLOSING)
        bars += sign in _BARS
        if sign in _RELATIONS + _SIGNS and number > first and not depth and bars % 2 == 0:
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

"""LaTeX as MathML: latex2mathml's, mended where a browser would set it badly."""

from __future__ import annotations

import re
from collections.abc import Iterator
from html import unescape
from itertools import pairwise
from xml.etree import ElementTree
from xml.etree.ElementTree import Element

from nonsmooth.runtime.core.errors import missing_extra

__all__ = ["Formulas"]

_CHILDREN = {"mfrac": 2, "mroot": 2, "msub": 2, "msup": 2, "msubsup": 3}
_CHILDREN |= {"munder": 2, "mover": 2, "munderover": 3}
_LONG = 8  # elements in a row, from which on it may break
_ROWS = ("math", "mrow", "mstyle", "mtd")
_BARS = ("|", "‖")
_RELATIONS = tuple("=<>≤≥≈≠≡∈→⇒,;")
_OPENING, _CLOSING = ("(", "[", "{"), (")", "]", "}")
_SIGNS = tuple("+−±")


class Formulas:
    """Formulas for a page of HTML.

    Raises
    ------
    MissingExtra
        If latex2mathml is not installed.
    """

    def __init__(self) -> None:
        try:
            from latex2mathml.converter import convert_to_element
        except ImportError:
            raise missing_extra("html", "latex2mathml") from None
        self._convert = convert_to_element

    def display(self, latex: str) -> str:
        """A formula on a line of its own.

        Parameters
        ----------
        latex : str
            Without delimiters.

        Returns
        -------
        str
            HTML with MathML.

        Raises
        ------
        ValueError
            If the LaTeX has a command or an environment that latex2mathml does not know.
        """
        return _html(self._formula(latex, "block"))

    def inline(self, latex: str) -> str:
        """A formula within a line, as pieces between which the line may break.

        Parameters
        ----------
        latex : str
            Without delimiters.

        Returns
        -------
        str
            HTML with MathML.

        Raises
        ------
        ValueError
            If the LaTeX has a command or an environment that latex2mathml does not know.
        """
        return "".join(map(_html, _pieces(self._formula(latex, "inline"))))

    def _formula(self, latex: str, display: str) -> Element:
        math: Element = self._convert(_known(latex), display=display)
        del math.attrib["xmlns"]
        for element in list(math.iter()):
            if _misread(element):
                raise ValueError(f"latex2mathml does not know all of {latex}")
            element.text = unescape(element.text or "")
        for element in list(math.iter()):
            if element.tag in _ROWS:
                _space_names(element)
                _space_signs(element)
                _pair_bars(element)
            elif element.text in ("′", "″"):
                _lower(element)
        return math


def _known(latex: str) -> str:
    """LaTeX without what latex2mathml misreads."""
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
    """What an element's indices are attached to, or the element."""
    return element[0] if element.tag in ("msub", "msup", "msubsup") else element


def _space_names(row: Element) -> None:
    """Set the names of functions with the spaces that TeX gives them."""
    neighbours = [None, *row, None]
    for before, element, after in zip(neighbours, row, neighbours[2:], strict=False):
        name = _core(element)
        if not re.fullmatch("[A-Za-z]{2,}", name.text or ""):
            continue
        name.tag = "mo"
        name.set("lspace", "0" if before is None or before.tag == "mo" else "0.167em")
        name.set("rspace", "0" if after is None or after.tag in ("mo", "mrow") else "0.167em")


def _space_signs(row: Element) -> None:
    """Set a sign close to what it belongs to, and nothing around a stroke."""
    for before, sign in pairwise(row):
        if before.text in (*_RELATIONS, *_OPENING) and sign.text in _SIGNS:
            sign.set("form", "prefix")
    for stroke in row:
        if stroke.text in ("/", "∂"):
            stroke.tag = "mo"
            stroke.attrib |= {"lspace": "0", "rspace": "0"}


def _pair_bars(row: Element) -> None:
    """Set bars as parentheses: every other one closes."""
    bars = [bar for bar in map(_core, row) if bar.text in _BARS and not bar.get("form")]
    if len(bars) % 2 == 0:
        for number, bar in enumerate(bars):
            bar.tag = "mo"
            bar.set("form", "postfix" if number % 2 else "prefix")
            bar.set("stretchy", "false")


def _lower(prime: Element) -> None:
    """Set a prime, which fonts hold raised, as large as beside a letter and no higher."""
    inner = Element("mi", {"class": "prime"})
    prime.tag, inner.text, prime.text = "mpadded", prime.text, ""
    prime.set("voffset", "-0.3em")
    prime.append(inner)


def _pieces(math: Element) -> Iterator[Element]:
    """Parts of a long formula: each ends with a relation or a sign outside of parentheses."""
    row = math[0] if len(math) else math
    if len(row) < _LONG:
        yield math
        return
    piece: list[Element] = []
    depth = bars = 0
    for element in row:
        piece.append(element)
        sign = _core(element).text
        depth += (sign in _OPENING) - (sign in _CLOSING)
        bars += sign in _BARS
        if sign in _RELATIONS + _SIGNS and len(piece) > 1 and not depth and bars % 2 == 0:
            element.set("form", "infix")
            yield _inline(piece)
            piece = []
    if piece:
        yield _inline(piece)


def _inline(elements: list[Element]) -> Element:
    """A formula of these elements."""
    math = Element("math", {"display": "inline"})
    math.extend(elements)
    return math


def _html(element: Element) -> str:
    return ElementTree.tostring(element, encoding="unicode")

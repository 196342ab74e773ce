"""MathML as a converter of LaTeX gives it, mended where a browser would set it badly."""

from __future__ import annotations

import re
from collections.abc import Callable
from itertools import pairwise
from xml.etree import ElementTree
from xml.etree.ElementTree import Element

__all__ = ["mathml", "mended"]

_TALL = {"mfrac", "mtable", "msqrt"}
_OPENING, _CLOSING = ("(", "["), (")", "]")
_SIGNS = ("+", "−", "±")
_BEFORE_SIGN = (*_OPENING, "=", ",", "↦", "|", "<", ">")


def mathml(latex: str, convert: Callable[[str], str]) -> str:
    """MathML of LaTeX by the given converter, mended."""
    # the converter forgets that one letter alone is upright, but not that a name is
    return mended(convert(re.sub(r"\\mathrm\{(\w)\}", r"\\operatorname{\1}", latex)))


def mended(mathml: str) -> str:
    """What is inside the outer element of a formula in MathML, mended for browsers.

    Names of functions get the spaces of TeX, signs in front of a term stand close to it,
    strokes and parentheses take no room of their own, and only around something tall do
    parentheses grow.
    """
    root = ElementTree.fromstring(re.sub(r' xmlns="[^"]*"', "", mathml, count=1))
    for row in list(root.iter()):
        _set_upright(row)
        _space_names(row)
        _space_signs(row)
        _settle_fences(row)
        _pair_bars(row)
    return "".join(ElementTree.tostring(child, encoding="unicode") for child in root)


def _core(element: Element) -> Element:
    return element[0] if element.tag in ("msub", "msup", "msubsup") else element


def _set_upright(name: Element) -> None:
    """Make an operator of one letter an upright identifier."""
    if name.tag == "mo" and re.fullmatch("[A-Za-z]", name.text or ""):
        name.tag = "mi"
        name.set("mathvariant", "normal")


def _space_names(row: Element) -> None:
    if row.tag not in ("mrow", "math"):
        return
    neighbours = [None, *row, None]
    for before, element, after in zip(neighbours, neighbours[1:], neighbours[2:], strict=False):
        if element is None:
            continue
        name = _core(element)
        if name.tag not in ("mi", "mo") or not re.fullmatch("[a-z]{2,}", name.text or ""):
            continue
        name.tag = "mo"
        close_before = before is None or (before.tag == "mo" and before.text not in _CLOSING)
        close_after = after is None or (after.text or "") in _OPENING or _opens(after)
        name.set("lspace", "0" if close_before else "0.167em")
        name.set("rspace", "0" if close_after else "0.167em")


def _opens(element: Element) -> bool:
    """Whether an element is a row that begins with a parenthesis."""
    return element.tag == "mrow" and len(element) > 0 and element[0].text in _OPENING


def _space_signs(row: Element) -> None:
    for element in row:
        if element.tag == "mi" and element.text in _SIGNS:
            element.tag = "mo"
        if element.tag == "mo" and element.text in ("/", "."):
            element.attrib |= {"lspace": "0", "rspace": "0"}
    for before, sign in pairwise(row):
        if sign.tag == "mo" and before.text in _BEFORE_SIGN and sign.text in _SIGNS:
            sign.set("form", "prefix")
            sign.attrib |= {"lspace": "0", "rspace": "0"}


def _settle_fences(row: Element) -> None:
    """Keep the parentheses of a row from growing if nothing tall is inside."""
    if len(row) < 2 or row[0].get("fence") != "true" or row[-1].get("fence") != "true":
        return
    inner = {element.tag for part in row for element in part.iter()}
    for fence in (row[0], row[-1]):
        fence.attrib |= {"lspace": "0", "rspace": "0"}
        if not inner & _TALL:
            fence.set("stretchy", "false")


def _pair_bars(row: Element) -> None:
    """Make bars in a row fences, of which every other one closes."""
    bars = [bar for bar in row if bar.text == "|"]
    for number, bar in enumerate(bars if len(bars) % 2 == 0 else ()):
        bar.tag = "mo"
        bar.attrib |= {"form": "postfix" if number % 2 else "prefix", "stretchy": "false"}
        bar.attrib |= {"lspace": "0", "rspace": "0"}

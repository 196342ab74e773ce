"""MathML as it stands on the page."""

import re

from tests.formulas.layout import (
    PRIME,
    Accent,
    Atom,
    Fraction,
    Root,
    Table,
    Unreadable,
    row_of,
    scripted,
)

_LETTERS = set("ℓℳℰℛℝ")
_MARKS = {"^": "hat", "~": "tilde", "˜": "tilde", "ˉ": "bar", "¯": "bar", "―": "bar"}
_SAME = {"−": "-", "'": PRIME}


def read_element(element):
    """Items of an element."""
    return row_of(_items(element))


def _row(elements):
    return row_of(item for element in elements for item in _items(element))


def _items(element):
    tag, parts = element.tag, list(element)
    if tag in ("math", "mrow", "mtd", "mstyle"):
        return _row(parts)
    if element.text == "″":
        return (Atom(PRIME, "sign"),) * 2
    if tag in ("mi", "mn", "mo", "mtext"):
        return (_atom(element),)
    if tag == "mspace":
        return (Atom(str(element.get("width")), "space"),)
    if tag == "mfrac":
        above, below = map(_items, parts)
        return (Fraction(above, below),)
    if tag == "msqrt":
        return (Root(_row(parts)),)
    if tag == "mroot":
        inside, degree = map(_items, parts)
        return (Root(inside, degree),)
    if tag == "mtable":
        return (Table(tuple(tuple(_items(entry) for entry in row) for row in parts)),)
    if tag == "mover":
        inside, mark = parts
        return (Accent(_MARKS[str(mark.text)], _items(inside)),)
    if tag in ("msub", "munder"):
        base, below = map(_items, parts)
        return scripted(base, below, ())
    if tag == "msup":
        base, above = map(_items, parts)
        return scripted(base, (), above)
    if tag in ("msubsup", "munderover"):
        base, below, above = map(_items, parts)
        return scripted(base, below, above)
    raise Unreadable(f"unknown element {tag}")


def _atom(element):
    text = _SAME.get(element.text or "", element.text or "")
    if element.tag == "mtext":
        return Atom("".join(text.split()), "text")
    if re.fullmatch(r"\d+(\.\d+)?", text):
        return Atom(text, "number")
    if len(text) > 1 and text.isalpha():
        return Atom(text, "word")
    if text.isalpha() or text in _LETTERS:
        upright = element.get("mathvariant") == "normal"
        return Atom(text, "upright" if upright else "letter")
    if element.get("mathvariant") == "normal":
        return Atom(text, "upright")
    if len(text) != 1:
        raise Unreadable(f"unknown: {text!r}")
    return Atom(text, "sign")

"""What stands on the page, whichever format set it there."""

from __future__ import annotations

from dataclasses import dataclass, replace

PRIME = "′"
OPENING, CLOSING = {"(", "["}, {")", "]"}


class Unreadable(AssertionError):
    """A formula that a person could not read, or could read in two ways."""


@dataclass(frozen=True)
class Atom:
    """One sign: its kind is letter, upright, word, number, sign, text or space."""

    text: str
    kind: str


@dataclass(frozen=True)
class Script:
    """What stands below and above an item, to its right."""

    base: Item
    below: Row = ()
    above: Row = ()


@dataclass(frozen=True)
class Fraction:
    """Numerator and denominator."""

    above: Row
    below: Row


@dataclass(frozen=True)
class Root:
    """A root; the degree is empty for a square root."""

    inside: Row
    degree: Row = ()


@dataclass(frozen=True)
class Accent:
    """A letter with a mark over it."""

    mark: str
    inside: Row


@dataclass(frozen=True)
class Table:
    """Entries of a matrix."""

    rows: tuple


Item = Atom | Script | Fraction | Root | Accent | Table
Row = tuple[Item, ...]


def core_of(item):
    """An item without what stands below and above it."""
    return item.base if isinstance(item, Script) else item


def row_of(items):
    """A row as the eye takes it: digits side by side are one number, upright letters one word."""
    found = []
    for item in items:
        last, core = found[-1] if found else None, core_of(item)
        joins = isinstance(last, Atom) and isinstance(core, Atom) and last.kind == core.kind
        if joins and last.kind in ("number", "upright"):
            joined = Atom(last.text + core.text, last.kind)
            found[-1] = replace(item, base=joined) if isinstance(item, Script) else joined
        else:
            found.append(item)
    return tuple(found)


def scripted(base, below, above):
    """Scripts at the end of a row; what is in front of its last item has no part in them."""
    if not base:
        raise Unreadable("scripts without a base")
    *before, last = base
    if not isinstance(last, Script):
        return (*before, Script(last, below, above))
    primes = all(a == Atom(PRIME, "sign") for a in (*last.above, *above))
    if (last.below and below) or (last.above and above and not primes):
        raise Unreadable(f"two scripts in one place: {plain(base)}")
    return (*before, Script(last.base, last.below or below, last.above + above))


def is_number(item):
    return isinstance(item, Atom) and item.kind == "number"


def plain(row):
    """A row as text on one line, the same for the same row: for messages and as a name."""
    return "".join(map(_plain, row))


def _plain(item):
    if isinstance(item, Atom):
        return {"word": f" {item.text} ", "upright": f"`{item.text}"}.get(item.kind, item.text)
    if isinstance(item, Script):
        below = f"_{{{plain(item.below)}}}" if item.below else ""
        above = f"^{{{plain(item.above)}}}" if item.above else ""
        return f"{_plain(item.base)}{below}{above}"
    if isinstance(item, Fraction):
        return f"[{plain(item.above)}]/[{plain(item.below)}]"
    if isinstance(item, Root):
        return f"√{plain(item.degree)}[{plain(item.inside)}]"
    if isinstance(item, Accent):
        return f"{item.mark}[{plain(item.inside)}]"
    return f"|{'; '.join(', '.join(map(plain, row)) for row in item.rows)}|"

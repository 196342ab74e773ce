"""What is told of a result: a title, and lines or a table by name; for console and notebook."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from html import escape
from itertools import islice
from typing import Any

import numpy as np

_ROWS, _WIDTH = 3, 96  # in a console
_MOST = 12  # entries of a row


@dataclass(frozen=True)
class Listing:
    """A table: titles of its columns, those that are flush right, and texts in rows."""

    titles: tuple[str, ...]
    rows: Sequence[Sequence[str]]
    right: tuple[str, ...] = ()
    keys: int = 1  # columns that say what a row is of, and are repeated beside others

    def __bool__(self) -> bool:
        return bool(self.rows)


Rows = Iterable[tuple[str, Sequence[str] | Listing]]  # the most important ones first
Told = tuple[str, Rows]  # a title, and what is told below it


def text(told: Told) -> str:
    """Text of at most four lines."""
    title, rows = told
    shown = list(islice(((name, _lines(part)) for name, part in rows if part), _ROWS))
    widest = max((len(name) for name, _ in shown), default=0)
    lines = [f"  {name:{widest}}  {'; '.join(part)}" for name, part in shown]
    return "\n".join(_short(line) for line in (title, *lines))


def _lines(part: Sequence[str] | Listing) -> Sequence[str]:
    if not isinstance(part, Listing):
        return part
    return first(", ".join(cell for cell in row if cell) for row in part.rows)


def _short(line: str) -> str:
    line = line.replace("\n", " ")
    return line if len(line) <= _WIDTH else line[: _WIDTH - 3].rstrip() + "..."


def html(told: Told) -> str:
    """HTML of a table with a caption; a row is a name and the lines or the table beside it."""
    title, rows = told
    body = "".join(_row("th", name) + _part(part) + "</tr>" for name, part in rows if part)
    return f"<table><caption>{escape(title)}</caption>{body}</table>"


def _row(tag: str, *cells: str) -> str:
    """A row that is not closed, of cells of plain text."""
    return "<tr>" + "".join(f"{_open(tag)}{escape(cell)}</{tag}>" for cell in cells)


def _open(tag: str) -> str:
    return f'<{tag} style="text-align: left">'


def _part(part: Sequence[str] | Listing) -> str:
    if not isinstance(part, Listing):
        return f"{_open('td')}{'<br>'.join(map(escape, part))}</td>"
    rows = [("th", part.titles), *(("td", row) for row in part.rows[:_MOST])]
    if (left := len(part.rows) - _MOST) > 0:
        rows.append(("td", (f"and {left} more",)))
    inner = "".join(_row(tag, *cells) + "</tr>" for tag, cells in rows)
    return f"{_open('td')}<table>{inner}</table></td>"


def first(lines: Iterable[str]) -> list[str]:
    """The first entries, and the number of the remaining ones."""
    every = list(lines)
    left = len(every) - _MOST
    return every if left <= 0 else [*every[:_MOST], f"and {left} more"]


def many(count: int, one: str) -> str:
    """A number of things, as in "1 orbit" and "2 orbits"."""
    return f"{count} {one}{'s' * (count != 1)}"


def span(values: Any) -> str:
    """The smallest and the largest of some numbers."""
    low, high = float(np.nanmin(values)), float(np.nanmax(values))
    return f"{low:.6g} ... {high:.6g}"


def given(values: Mapping[str, Any]) -> list[str]:
    """Values by name, one a line."""
    return [f"{name} = {value}" for name, value in values.items()]


def counts(names: Iterable[str]) -> list[str]:
    """How often each name occurs, the most frequent first."""
    return [f"{count} {name}" for name, count in Counter(names).most_common()]

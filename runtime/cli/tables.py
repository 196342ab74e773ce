"""Consoles and tables: nothing is cut, on a narrow terminal or in a pipe."""

from __future__ import annotations

import io
from collections.abc import Sequence
from typing import Any

from rich import box
from rich.console import Console
from rich.table import Table
from rich.text import Text

__all__ = ["STYLES", "console_as_wide", "listing", "show_result", "show_table"]

STYLES = {  # of verdicts
    **dict.fromkeys(("proved", "stable"), "green"),
    **dict.fromkeys(("refuted", "unstable", "refused"), "red"),
    "undecided": "yellow",
}

_PIPE = 1_000_000  # columns: as many as it takes


def console_as_wide() -> Console:
    """A console of rich on stdout, as wide as the terminal and without limit in a pipe."""
    console = Console(highlight=False)
    if not console.is_terminal:
        console.width = _PIPE
    return console


def listing(*titles: str, right: Sequence[str] = ()) -> Table:
    """An empty table with a line below its titles; columns named in `right` are flush right."""
    table = Table(box=box.SIMPLE_HEAD, pad_edge=False, padding=(0, 2, 0, 0))
    for title in titles:
        table.add_column(title, justify="right" if title in right else "left", no_wrap=True)
    return table


def show_result(result: Any) -> None:
    """Show what a result tells of itself: its title, and lines and tables by name."""
    from nonsmooth.runtime.present.tell import tell
    from nonsmooth.runtime.present.told import Listing

    out = console_as_wide()
    title, rows = tell(result)
    out.print(Text(title, style="bold"))
    for name, part in rows:
        if not part:
            continue
        if isinstance(part, Listing):
            table = listing(*part.titles, right=part.right)
            for cells in part.rows:
                table.add_row(*(Text(cell, style=STYLES.get(cell, "")) for cell in cells))
            show_table(table, out)
        else:
            out.print(Text(f"{name}: {'; '.join(part)}"))


def show_table(table: Table, out: Console | None = None, *, keys: int = 1) -> None:
    """Show a table; if it is wider than the terminal its columns come in several blocks.

    The first `keys` columns are repeated in each block. Cells of a column that alone is too
    wide are folded.
    """
    console = out or console_as_wide()
    for block in _blocks(table, console, keys):
        console.print(block)


def _blocks(table: Table, console: Console, keys: int) -> list[Table]:
    """The table alone if it fits into the console, else tables of some columns each."""
    count = len(table.columns)
    if _width(table, range(count)) <= console.width:
        return [table]
    key = list(range(min(keys, count - 1)))
    blocks: list[list[int]] = [[]]
    for column in range(len(key), count):
        if blocks[-1] and _width(table, [*key, *blocks[-1], column]) > console.width:
            blocks.append([])
        blocks[-1].append(column)
    return [_part(table, [*key, *block]) for block in blocks]


def _width(table: Table, columns: Sequence[int]) -> int:
    """Width in characters of a table of the given columns if nothing is folded."""
    wide = Console(width=_PIPE, file=io.StringIO())
    return wide.measure(_part(table, columns, fold=False)).maximum


def _part(table: Table, columns: Sequence[int], *, fold: bool = True) -> Table:
    """A table of the given columns; cells that do not fit are folded, never cut."""
    part = Table(box=table.box, show_header=table.show_header, pad_edge=False, padding=(0, 2, 0, 0))
    for place in columns:
        column = table.columns[place]
        part.add_column(column.header, justify=column.justify, no_wrap=not fold, overflow="fold")
    for cells in zip(*(list(table.columns[place].cells) for place in columns), strict=True):
        part.add_row(*(cell if isinstance(cell, Text) else str(cell) for cell in cells))
    return part

"""What the command line shows to people: what is told, on stdout; progress, on stderr.

Nothing is cut, on a narrow terminal or in a pipe.
"""

from __future__ import annotations

import io
import sys
import textwrap
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from typing import Any

from rich import box
from rich.console import Console
from rich.progress import (
    BarColumn,
    MofNCompleteColumn,
    Progress,
    ProgressColumn,
    SpinnerColumn,
    TaskProgressColumn,
    TextColumn,
    TimeElapsedColumn,
    TimeRemainingColumn,
)
from rich.table import Table
from rich.text import Text

from nonsmooth.runtime.present.told import Listing, Told

_STYLES = {  # of verdicts
    **dict.fromkeys(("proved", "stable", "conditionally stable"), "green"),
    **dict.fromkeys(("refuted", "unstable", "refused"), "red"),
    "undecided": "yellow",
}
_PIPE = 1_000_000  # columns: as many as it takes
_WORDS = 80  # columns of a line, or of a cell of words in a pipe
_WHAT = TextColumn("{task.description}")
_LONG = 600.0  # seconds over which a rate of work is told: shares rise in jumps


def console_as_wide() -> Console:
    """A console of rich on stdout, as wide as the terminal and without limit in a pipe."""
    console = Console(highlight=False)
    if not console.is_terminal:
        console.width = _PIPE
    return console


def show_result(result: Any) -> None:
    """Show what a result tells of itself."""
    from nonsmooth.runtime.present.tell import tell

    show_told(tell(result))


def show_told(told: Told) -> None:
    """Show a title, and lines and tables by name.

    Several texts that are no line are lines of their own. Where a table is wider than the
    terminal its columns come in several blocks, each with the first ones. In a pipe the words of
    a cell are broken into lines, and numbers are not.
    """
    console = console_as_wide()
    title, rows = told
    console.print(Text(title, style="bold"))

    def broken(text: str) -> str:
        if console.is_terminal:
            return text
        return "\n".join(
            textwrap.fill(line, _WORDS, break_long_words=False, break_on_hyphens=False)
            for line in text.split("\n")
        )

    for name, part in rows:
        if not part:
            continue
        if not isinstance(part, Listing):
            line = f"{name}: {'; '.join(part)}"
            if len(part) > 1 and len(line) > _WORDS:
                line = "\n  ".join([f"{name}:", *part])
            console.print(Text(line))
            continue
        cells = [
            [Text(broken(cell), style=_STYLES.get(cell.partition(" (")[0], "")) for cell in row]
            for row in part.rows
        ]
        for columns in _blocks(part, cells, console.width):
            console.print(_table(part, cells, columns, ruled=not console.options.ascii_only))


def _blocks(part: Listing, rows: Sequence[Sequence[Text]], width: int) -> list[Sequence[int]]:
    """All columns in one block if they fit into the width, else some in each."""
    count = len(part.titles)
    if _width(part, rows, range(count)) <= width:
        return [range(count)]
    key = list(range(min(part.keys, count - 1)))
    blocks: list[list[int]] = [[]]
    for column in range(len(key), count):
        if blocks[-1] and _width(part, rows, [*key, *blocks[-1], column]) > width:
            blocks.append([])
        blocks[-1].append(column)
    return [[*key, *block] for block in blocks]


def _width(part: Listing, rows: Sequence[Sequence[Text]], columns: Sequence[int]) -> int:
    """Width in characters of a table of the given columns if nothing is folded."""
    wide = Console(width=_PIPE, file=io.StringIO())
    return wide.measure(_table(part, rows, columns, fold=False)).maximum


def _table(
    part: Listing,
    rows: Sequence[Sequence[Text]],
    columns: Sequence[int],
    *,
    fold: bool = True,
    ruled: bool = True,
) -> Table:
    """A table of the given columns; cells that do not fit are folded, never cut."""
    table = Table(box=box.SIMPLE_HEAD if ruled else None, pad_edge=False, padding=(0, 2, 0, 0))
    for title in (part.titles[place] for place in columns):
        justify: Any = "right" if title in part.right else "left"
        table.add_column(title, justify=justify, no_wrap=not fold, overflow="fold")
    for row in rows:
        table.add_row(*(row[place] for place in columns))
    return table


def show_written(paths: Iterable[str], nothing: str) -> None:
    """Print the paths of the files that were written, one a line, or the text `nothing`."""
    for line in list(paths) or [nothing]:
        print(line)


def show_differences(differences: Iterable[str]) -> None:
    """Show differences of files; added and removed lines are coloured on a terminal.

    Each is a text of several lines, as `difflib` writes them.
    """
    console = Console(highlight=False, soft_wrap=True)
    for difference in differences:
        for line in difference.splitlines():
            style = {"+": "green", "-": "red", "@": "cyan"}.get(line[:1], "")
            console.print(Text(line, style=style))


@contextmanager
def steps(first: str = "") -> Iterator[Callable[[str], None]]:
    """Give a function that takes the name of each step as it begins, and shows it on stderr.

    The step `first` begins at once unless empty.
    """
    with _progress(SpinnerColumn(finished_text=" "), _WHAT, TimeElapsedColumn()) as progress:

        def begin(step: str) -> None:
            finish()
            progress.add_task(step, total=1)

        def finish() -> None:
            for task in progress.task_ids:
                progress.update(task, completed=1)

        if first:
            begin(first)
        yield begin
        finish()


@contextmanager
def counted(what: str, total: int | None = None) -> Iterator[Callable[..., None]]:
    """Give a function that shows a progress bar on stderr; it takes a count and the total.

    The text `what` stands before the bar; `total` is None as long as it is unknown.
    """
    with _progress(_WHAT, BarColumn(), MofNCompleteColumn(), TimeRemainingColumn()) as progress:
        task = progress.add_task(what, total=total)
        yield lambda done, total=None: progress.update(task, completed=done, total=total)


@contextmanager
def shared(what: str) -> Iterator[Callable[[float, int], None]]:
    """Give a function that shows progress on stderr; it takes a share in [0, 1] and a count.

    The text `what` stands before the bar, and tiles are counted. The remaining time is estimated
    from the share and the time that it took.
    """
    tiles = TextColumn("{task.fields[count]} tiles")
    times = (TimeElapsedColumn(), TextColumn("left"), TimeRemainingColumn())
    with _progress(
        _WHAT, BarColumn(), TaskProgressColumn(), tiles, *times, speed_estimate_period=_LONG
    ) as progress:
        task = progress.add_task(what, total=None, count=0)  # until a share is known
        yield lambda share, count: progress.update(task, completed=share, total=1.0, count=count)


def _progress(*columns: ProgressColumn, **options: Any) -> Progress:
    """Progress on stderr, of which nothing is shown unless that is a terminal."""
    idle = not sys.stderr.isatty()
    console = Console(stderr=True, quiet=idle)  # Rich before 14 ends what is disabled by a line
    return Progress(*columns, console=console, disable=idle, **options)

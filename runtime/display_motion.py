"""What the commands that simulate show to people."""

from __future__ import annotations

from rich import box
from rich.table import Table
from rich.text import Text

from nonsmooth.runtime.display import wide_console
from nonsmooth.runtime.trajectory import Trajectory

__all__ = ["show_motion"]

_ROWS = 40  # of a long motion: the first and the last half of them
_DIGITS = 8
_WIDTH = 118


def show_motion(motion: Trajectory) -> None:
    """Show the transitions of a motion; of a long one the first and the last."""
    out = wide_console(_WIDTH)
    out.print(Text(f"{motion.name}, {_count(motion.transitions, 'transition')}", style="bold"))
    table = Table(box=box.SIMPLE_HEAD, pad_edge=False, padding=(0, 2, 0, 0))
    table.add_column("time", justify="right", no_wrap=True)
    table.add_column("reached", min_width=22)
    table.add_column("then", no_wrap=True)
    for name in motion.names:
        table.add_column(name, justify="right", no_wrap=True)
    count = len(motion.times)
    hidden = count - _ROWS
    for i in range(count):
        if hidden > 0 and _ROWS // 2 <= i < count - _ROWS // 2:
            if i == _ROWS // 2:
                table.add_row("...", Text(f"{hidden} more", style="dim"), "")
            continue
        table.add_row(
            _number(motion.times[i]),
            " + ".join(motion.boundaries[i]),
            motion.configurations[i],
            *map(_number, motion.states[i]),
        )
    out.print(table)
    out.print(f"ended at {_number(motion.end)}: {motion.message}")
    for g in motion.grazings:
        shape = motion.structure.boundaries[g.configuration][g.boundary]
        out.print(
            f"touched without crossing: {shape.name} at {_number(g.time)}, depth {g.depth:.1e}"
        )


def _number(value: float) -> str:
    return f"{value:.{_DIGITS}g}"


def _count(number: int, noun: str) -> str:
    return f"{number} {noun}{'' if number == 1 else 's'}"

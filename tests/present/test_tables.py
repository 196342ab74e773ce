"""What is shown: no column is cut, units are the declared ones, names are no paths."""

from __future__ import annotations

import io
import random

import pytest
from rich.console import Console

from nonsmooth.runtime.cli.tables import listing, show_table
from nonsmooth.runtime.model.kernels import load_system
from nonsmooth.runtime.model.naming import shown_name
from nonsmooth.runtime.model.units import units_of

RNG = random.Random(4)
LETTERS = "abcdefghijklmnopqrstuvwxyz0123456789"


def word(longest: int) -> str:
    return "".join(RNG.choices(LETTERS, k=RNG.randrange(1, longest)))


@pytest.mark.parametrize("width", [30, 80, 200])
@pytest.mark.parametrize("case", range(6))
def test_no_cell_is_cut(width: int, case: int) -> None:
    titles = [f"{place}{word(8)}" for place in range(RNG.randrange(2, 12))]
    rows = [[word(40 if place else 6) for place in range(len(titles))] for _ in range(4)]
    table = listing(*titles)
    for row in rows:
        table.add_row(*row)
    out = io.StringIO()
    show_table(table, Console(file=out, width=width, force_terminal=True, color_system=None))
    shown = out.getvalue()
    assert "\u2026" not in shown
    assert max(map(len, shown.splitlines())) <= width
    letters = "".join(letter for letter in shown if letter in LETTERS)
    for text in (*titles, *(cell for row in rows for cell in row)):
        # a cell that is folded comes in parts, below each other
        assert text in shown or (len(text) > 10 and text[:10] in letters)


def test_a_pipe_is_as_wide_as_it_takes() -> None:
    table = listing(*(f"title{place}" for place in range(40)))
    table.add_row(*("x" * 30 for _ in range(40)))
    out = io.StringIO()
    console = Console(file=out, width=1_000_000)
    show_table(table, console)
    assert out.getvalue().count("x" * 30) == 40
    assert "title39" in out.getvalue()


@pytest.mark.parametrize(
    ("name", "shown"),
    [
        ("/home/me/gear.py:rattle", "gear/rattle"),
        ("gear.py", "gear"),
        ("/home/me/my_kernels:loop", "my_kernels/loop"),
        ("dry-friction/symmetric", "dry-friction/symmetric"),
        ("dry-friction", "dry-friction"),
    ],
)
def test_names_are_no_paths(name: str, shown: str) -> None:
    assert shown_name(name) == shown


def test_units_are_those_that_are_declared() -> None:
    friction, stop = (units_of(load_system(name)) for name in ("dry-friction", "rigid-stop"))
    assert friction.label("V") == "$V$ (nondimensional)"
    assert friction.text("time") == "time (nondimensional)"
    assert stop.label("r") == "$r$ (nondimensional)"
    assert (stop.label("m1"), stop.text("time")) == ("$m_{1}$", "time")
    assert units_of("no such system").text("time") == "time"

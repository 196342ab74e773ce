"""What is shown: no column is cut, units are the declared ones, names are no paths."""

import re
from functools import cache

import pytest

import nonsmooth as ns
from tests.cli.terminal import on_terminal
from tests.cli.test_cli import run
from tests.places import GALLERY

COMMANDS = (
    "list dry-friction",
    f"list {GALLERY / 'three_masses.py'}",
    "simulate rigid-stop m1=1 m2=2 k1=1 k2=5 r=0.8 --from x1=0,x2=0.5,v1=1,v2=0 --until 9",
    "solve dry-friction/global-stick us2=0.7 --derivatives V,eta,e1,e2,chi",
)


@cache
def piped(command):
    """What a command shows in a pipe, where tables are as wide as they take."""
    return run(*command.split())[1]


@pytest.mark.parametrize("width", [36, 80, 200])
@pytest.mark.parametrize("command", COMMANDS)
def test_no_cell_is_cut(width, command, monkeypatch):
    monkeypatch.setenv("COLUMNS", str(width))
    monkeypatch.setenv("TERM", "xterm")
    shown = re.sub(r"\x1b\[[0-9;?]*[A-Za-z]", "", on_terminal(*command.split()).out)
    assert "\u2026" not in shown
    assert max(map(len, shown.splitlines())) <= width
    letters = "".join(shown.split())
    for word in piped(command).split():
        # a cell that is folded comes in parts, below each other
        assert word in shown or word[:10] in letters, word


def test_a_pipe_is_as_wide_as_it_takes():
    """Each row of the table of derivatives is one line, with all its numbers."""
    orbit = ns.solve("dry-friction/global-stick", {"us2": "0.7"})
    derivatives = orbit.derivatives(["V", "eta", "e1", "e2", "chi"])
    rows = [line.split() for line in piped(COMMANDS[-1]).splitlines()]
    (row,) = (row for row in rows if row[:1] == ["trace"] and len(row) > 2)
    assert [float(x) for x in row[1:]] == pytest.approx(derivatives.quantity("trace")[1].tolist())


def test_words_are_broken_into_lines_in_a_pipe():
    """An orbit of eight phases has a long itinerary, all of which is there."""
    command = "find dry-friction chi=0.4 eta=4 V=0.6773 us1=0.0127 ur1=0.0255 us2=0.5 ur2=1"
    out = run(*command.split(), "--starts", "20")[1]
    assert "overshoot-stick, first-reaches-belt" in out
    assert max(map(len, out.splitlines())) < 160

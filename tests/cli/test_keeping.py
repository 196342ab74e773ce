"""What Ctrl-C ends and what it does not, in this process, with the real signal."""

import json
import os
import signal
import time
from itertools import count
from pathlib import Path

import numpy as np
import pytest

import nonsmooth as ns
from tests.cli.terminal import Terminal, on_terminal
from tests.cli.test_cli import answered, run
from tests.user_systems import declare

CONTINUE = "continue dry-friction/global-stick V=0.95:1.05 --step 0.02 --save b.json --json"


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


def press():
    signal.raise_signal(signal.SIGINT)


@pytest.fixture
def pressed(monkeypatch):
    """Let each call of a function press Ctrl-C first, from a number of calls on."""

    def at(owner, name, first=1):
        function, calls = getattr(owner, name), count(1)

        def calling(*arguments, **options):
            if next(calls) >= first:
                press()
            return function(*arguments, **options)

        monkeypatch.setattr(owner, name, calling)

    return at


def test_who_presses_again_and_again_loses_nothing(pressed):
    """The work is ended by the first one, and puts together what it has."""
    pressed(np.linalg, "svd", 30)
    pressed(np, "nanmedian")
    code, _, err = run(*CONTINUE.split())
    assert (code, err.count("interrupted: ")) == (130, 1)
    assert "interrupted" in ns.load("b.json").ends
    with pytest.raises(KeyboardInterrupt):
        press()


def test_later_on_it_ends_what_does_not_come_to_an_end(pressed, monkeypatch):
    hours = count(0, 3600)
    pressed(np.linalg, "svd", 30)
    pressed(np, "nanmedian")  # of what the events are told by
    monkeypatch.setattr(time, "monotonic", lambda: float(next(hours)))
    code, out, err = run(*CONTINUE.split())
    assert (code, out) == (130, "")
    assert "interrupted: nothing is kept" in err
    assert not Path("b.json").exists()


def test_what_is_being_kept_is_kept(pressed):
    pressed(os, "fsync")
    assert json.loads(answered(*CONTINUE.split()))["ends"] == list(ns.load("b.json").ends)


def test_a_picture_that_is_interrupted_keeps_the_answer(pressed):
    figure = pytest.importorskip("matplotlib.figure")
    pressed(figure.Figure, "savefig")
    shown = Terminal()
    shown.happens = press  # nor does the answer go now
    code, out, err = on_terminal(*CONTINUE.split(), "--plot", "never.png", shown=shown)
    assert code == 130
    assert json.loads(out)["files"] == ["b.json"]
    assert err.endswith("nonsmooth: interrupted: no picture is drawn\n")
    assert not Path("never.png").exists()


@pytest.mark.parametrize("answer", ["y\n", "n\n", ""])
def test_a_question_is_answered_with_no_by_an_interrupt(answer):
    file = declare(Path())
    before = file.read_text()
    answers, shown = Terminal(answer), Terminal()
    if not answer:
        answers.happens = press
        shown.happens = press  # the answer is still to be shown
    words = ("find", "mine.py", "k=1", "r=0.5", "--starts", "2", "--transitions", "40")
    code, out, err = on_terminal(*words, "--write", "mine.py", answers=answers, shown=shown)
    assert code == 0
    assert "append the orbits to mine.py?" in err
    assert "1 periodic orbit" in out
    assert (file.read_text() != before) == (answer == "y\n")

"""What Ctrl-C ends and what it does not, in this process, with the real signal."""

from __future__ import annotations

import signal
from collections.abc import Iterator
from pathlib import Path

import pytest
import typer

from nonsmooth import Interrupted
from nonsmooth.runtime.cli import keeping, motions
from nonsmooth.runtime.cli.application import ANSWERED
from nonsmooth.runtime.cli.keeping import INTERRUPTED, heed_interrupts, heeding, worked
from nonsmooth.runtime.cli.written import Written


@pytest.fixture(autouse=True)
def own_handler() -> Iterator[None]:
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


def press() -> None:
    signal.raise_signal(signal.SIGINT)


def slow_to_end() -> object:
    """Work that needs some time to put together what it has."""
    found = ["one"]
    try:
        press()
        found.append("never")
    except KeyboardInterrupt:
        for _ in range(3):
            press()
        raise Interrupted(found) from None
    return found


def test_who_presses_twice_loses_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    assert worked(slow_to_end) == (["one"], True)
    press()  # it is being kept
    assert worked(lambda: "all") == ("all", False)
    with pytest.raises(KeyboardInterrupt):  # work that keeps nothing
        worked(press)
    # later on it ends what does not come to an end
    monkeypatch.setattr(keeping, "_HASTE", 0.0)
    with pytest.raises(KeyboardInterrupt) as stopped:
        worked(slow_to_end)
    assert not isinstance(stopped.value, Interrupted)
    heed_interrupts()
    with pytest.raises(KeyboardInterrupt):
        press()


def test_a_picture_that_is_interrupted_keeps_the_answer(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    worked(lambda: None)
    written = Written()
    written.draw(press, tmp_path / "never.png")  # type: ignore[arg-type]  # never drawn
    press()  # nor does the answer go now
    assert written.show(dict, lambda: print("the answer"), as_json=False) == INTERRUPTED
    told = capsys.readouterr()
    assert told.out == "the answer\n"
    assert told.err == "nonsmooth: interrupted: no picture is drawn\n"
    assert Written().show(dict, lambda: None, as_json=False) == ANSWERED


def test_a_question_is_answered_with_no_by_an_interrupt(monkeypatch: pytest.MonkeyPatch) -> None:
    def asked(question: str, *, err: bool) -> bool:
        try:
            press()
        except KeyboardInterrupt:  # as Typer does
            raise typer.Abort from None
        pytest.fail("nobody can leave the question")

    monkeypatch.setattr(typer, "confirm", asked)
    monkeypatch.setattr("sys.stdin.isatty", lambda: True)
    worked(lambda: None)
    assert motions._agreed("append?") is False
    press()  # the answer is still to be shown
    with pytest.raises(KeyboardInterrupt), heeding():
        press()
    press()

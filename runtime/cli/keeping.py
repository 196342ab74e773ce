"""Work that Ctrl-C interrupts: what is kept of it, and which command goes on."""

from __future__ import annotations

import shlex
import signal
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from types import FrameType
from typing import Any

from nonsmooth.runtime.cli.resuming import command_to_resume
from nonsmooth.runtime.core.errors import Interrupted, one_line

INTERRUPTED = 130  # exit code
_LONGEST_COMMAND = 100_000  # characters
_HASTE = 5.0  # seconds for which more of Ctrl-C is part of the first


def worked(work: Callable[[], Any]) -> tuple[Any, bool]:
    """The result of a long work, and whether Ctrl-C ended it, which makes it a partial one.

    The work raises Interrupted with its partial result at Ctrl-C. More of Ctrl-C within
    seconds is ignored, while the work puts together what it has. When it has ended Ctrl-C
    stays ignored, so that the result is kept first; the next long work heeds it again.
    """
    heed_interrupts()
    first = _First()
    _exchange(signal.default_int_handler, first)
    try:
        return work(), False
    except Interrupted as stopped:
        return stopped.partial, True
    finally:
        _exchange(first, _keep_first)


def heed_interrupts() -> None:
    """Let Ctrl-C end what follows, if it is ignored since a long work ended."""
    _exchange(_keep_first, signal.default_int_handler)


@contextmanager
def heeding() -> Iterator[None]:
    """Let Ctrl-C end the work in the context, and ignore it afterwards if it was before."""
    ignored = signal.getsignal(signal.SIGINT) is _keep_first
    heed_interrupts()
    try:
        yield
    finally:
        if ignored:
            _exchange(signal.default_int_handler, _keep_first)


class _First:
    """A handler of Ctrl-C that ignores repetitions within a few seconds."""

    def __init__(self) -> None:
        self._last = -_HASTE

    def __call__(self, number: int, frame: FrameType | None) -> None:
        now = time.monotonic()
        if now - self._last >= _HASTE:
            self._last = now
            signal.default_int_handler(number, frame)


def _keep_first(number: int, frame: object) -> None:
    """Ignore Ctrl-C while the result is being kept, which takes little time."""


def _exchange(before: object, after: Any) -> None:
    """Replace one handler of Ctrl-C by another, if it is in force."""
    main = threading.current_thread() is threading.main_thread()
    if main and signal.getsignal(signal.SIGINT) is before:
        signal.signal(signal.SIGINT, after)


def interrupted(kept: str, command: str) -> int:
    """Say in one line what was kept and which command goes on; gives the exit code."""
    say(f"interrupted: {kept}; {command}")
    return INTERRUPTED


def say(text: str) -> None:
    """Print a text in one line on stderr."""
    print(f"nonsmooth: {one_line(text, _LONGEST_COMMAND)}", file=sys.stderr)


def kept_of(done: str, save: Path | None, *, resumes: bool = True) -> int:
    """Say what is kept of an interrupted work, and how to go on; gives the exit code.

    `done` says how much is done, `save` is the file that it is kept in, None for no file,
    and `resumes` whether the command can go on with such a file.
    """
    if save is None:
        return interrupted(f"{done}, not saved", f"begin again with: {same_command()}")
    if not resumes:
        again = same_command("--overwrite")
        return interrupted(f"{done}, kept in {save}", f"begin again with: {again}")
    return interrupted(f"{done}, kept in {save}", f"go on with: {command_to_resume(save)}")


def same_command(*more: str) -> str:
    """The running command line, quoted for a shell, with more options and no `--overwrite`."""
    kept = [word for word in sys.argv[1:] if word != "--overwrite"]
    return shlex.join(["nonsmooth", *kept, *more])

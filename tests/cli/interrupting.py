"""A command that gets Ctrl-C at the instant when its progress shows something.

Run as a script: the pattern of what it shows, then the command's arguments. Progress is shown
whenever it is told, and the process sends the signal to itself: neither how fast the machine is
nor what else it does decides when.
"""

from __future__ import annotations

import os
import re
import signal
import sys
from runpy import run_module
from typing import Any, TextIO

from rich.progress import Progress


class Watched:
    """A terminal that interrupts its program once, as soon as it has shown something."""

    def __init__(self, terminal: TextIO, pattern: str) -> None:
        self.terminal, self.pattern, self.shown, self.sent = terminal, pattern, "", False

    def __getattr__(self, name: str) -> Any:
        return getattr(self.terminal, name)

    def write(self, text: str) -> int:
        """Show a text."""
        count = self.terminal.write(text)
        self.shown += text
        if not self.sent and re.search(self.pattern, self.shown):
            self.sent = True
            os.kill(os.getpid(), signal.SIGINT)
        return count


def update(progress: Progress, *arguments: Any, **options: Any) -> None:
    """Update a task of the progress, and show it at once."""
    UPDATE(progress, *arguments, **options)
    progress.refresh()


UPDATE = Progress.update

if __name__ == "__main__":
    Progress.update = update
    # all that is asked of it is there
    sys.stderr = Watched(sys.stderr, sys.argv.pop(1))  # type: ignore[assignment]
    run_module("nonsmooth", run_name="__main__")

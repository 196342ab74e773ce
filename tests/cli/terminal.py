"""Commands on a terminal, in this process: progress is shown, and questions are asked."""

import io
import sys
from typing import NamedTuple

import pytest
from typer.main import get_command

from nonsmooth.runtime.cli.program import app


def all_commands():
    """The commands by their words, subcommands in place of the command that has them."""
    group = get_command(app)
    return {
        " ".join(filter(None, (name, own))): each
        for name, command in group.commands.items()
        for own, each in getattr(command, "commands", {"": command}).items()
    }


class Terminal(io.StringIO):
    """A stream of a terminal, on which something may happen when it is read or written."""

    happens = None

    def isatty(self):
        """Whether this is a terminal."""
        return True

    def readline(self, size=-1, /):
        """Read an answer."""
        if self.happens is not None:
            self.happens()
        return super().readline(-1 if size is None else size)

    def write(self, text, /):
        """Show a text."""
        if self.happens is not None:
            self.happens()
        return super().write(text)


class Ended(NamedTuple):
    """How a command ended, and what it showed."""

    code: int
    out: str
    err: str


def on_terminal(*arguments, answers=None, shown=None):
    """Run a command whose three streams are terminals."""
    streams = answers or Terminal(), shown or Terminal(), Terminal()
    with pytest.MonkeyPatch.context() as patch:
        for name, stream in zip(("stdin", "stdout", "stderr"), streams, strict=True):
            patch.setattr(sys, name, stream)
        with pytest.raises(SystemExit) as ended:
            app(list(arguments), prog_name="nonsmooth")
    return Ended(int(ended.value.code or 0), streams[1].getvalue(), streams[2].getvalue())

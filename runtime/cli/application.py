"""The command line's application: exit codes, errors in one line, JSON.

Every command returns its exit code: 0 when the question was answered, 1 on no convergence,
an undecided verdict or a check that differs, 2 on wrong input, 3 when a requirement is not
met, 130 when it was interrupted, 141 when nobody reads the answer any more.
"""

from __future__ import annotations

import inspect
import json
import os
import sys
import traceback
from collections.abc import Iterator, Mapping
from contextlib import suppress
from enum import Enum
from typing import Annotated, Any, NoReturn, get_args

import typer
from typer.core import TyperGroup

from nonsmooth.runtime.cli.keeping import say
from nonsmooth.runtime.core.errors import NoConvergence, NonsmoothError, one_line

ANSWERED, UNANSWERED, WRONG_INPUT, NOT_MET = 0, 1, 2, 3
_SHORTEST = 4  # of an option with its dashes: a shorter one is like any other
_UNREAD = 141  # as of a program that the closed pipe's signal ends
_WORDS = {int: "an integer", float: "a number"}
_UsageError: Any = typer.BadParameter.__base__  # Typer has a Click of its own, or shares it


# what commands are for, in the order of the help
PURPOSES = {
    "Declare and derive": ("list", "equations", "generate", "regenerate"),
    "Solve and verify": ("solve", "verify"),
    "Simulate and explore": ("simulate", "find", "sweep", "continue", "chart"),
    "Prove": ("certify",),
    "Fit and design": ("fit", "design"),
    "Keep and show": ("plot", "reproduce", "doctor"),
}


class _Door(TyperGroup):
    """The group of all commands; whatever exception stops a command leaves through `fail`."""

    def list_commands(self, ctx: Any) -> list[str]:
        """Names of all commands, by their purposes."""
        commands: Mapping[str, Any] = self.commands
        listed = []
        for purpose, names in PURPOSES.items():
            for name in filter(commands.__contains__, names):
                commands[name].rich_help_panel = purpose
                listed.append(name)
        return [*listed, *(name for name in commands if name not in listed)]

    def main(self, *arguments: Any, **options: Any) -> NoReturn:
        """Run the command line and exit; errors that belong to no command are reported by it."""
        try:
            code = super().main(*arguments, **{**options, "standalone_mode": False})
            sys.stdout.flush()
        except typer.Abort:
            code = UNANSWERED
        except (Exception, SystemExit) as problem:
            if is_unread(problem):
                os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
                sys.exit(_UNREAD)
            if isinstance(problem, SystemExit):
                raise
            words = options.get("args") or sys.argv
            code = fail(problem, as_json="--json" in words, debug="--debug" in words)
        sys.exit(code)


def is_unread(problem: BaseException) -> bool:
    """Whether standard output was closed by its reader.

    Rich turns the BrokenPipeError into a SystemExit, whose context is then looked at.
    """
    left = problem.__context__ if isinstance(problem, SystemExit) else problem
    return isinstance(left, BrokenPipeError)


app = typer.Typer(
    name="nonsmooth",
    cls=_Door,
    help="Periodic orbits of piecewise-linear oscillators with impacts and dry friction.",
    epilog="Exit codes: 0 answered, 1 no answer or a difference, 2 wrong input,"
    " 3 a requirement is not met, 130 interrupted, 141 nobody reads the answer.",
    invoke_without_command=True,
    rich_markup_mode="rich",
    pretty_exceptions_enable=False,
)


def fail(problem: BaseException, *, as_json: bool, debug: bool) -> int:
    """Say in one line on stderr why there is no answer, and return the exit code.

    With `as_json` the reason also goes to stdout as JSON; with `debug` the traceback comes
    first.
    """
    code, told = _reason(problem)
    if debug:
        traceback.print_exception(problem)
    if as_json:
        with suppress(OSError):  # standard output itself may be what fails
            print_json({"error": told})
    say(told if code == UNANSWERED else f"error: {told}")
    return code


def _reason(problem: BaseException) -> tuple[int, str]:
    """Exit code for an exception, and one line that says what went wrong."""
    from nonsmooth.derive.errors import DeclarationError, DerivationError

    match problem:
        case NoConvergence():
            return UNANSWERED, one_line(str(problem))
        case NonsmoothError() | DeclarationError() | DerivationError():
            return WRONG_INPUT, one_line(str(problem))
        case _UsageError():
            path = problem.ctx.command_path if problem.ctx else "nonsmooth"
            if len(getattr(problem, "option_name", "")) < _SHORTEST:
                problem.possibilities = None
            told = _wrong_value(problem) or one_line(problem.format_message()).rstrip(".?")
            told = f"{told[:1].lower()}{told[1:]}{_elsewhere(problem)}"
            return WRONG_INPUT, f"{told}; {path} --help shows the usage"
        case MemoryError():
            return UNANSWERED, "the memory is not enough for this"
        case OSError() if problem.strerror is not None:
            place = "" if problem.filename is None else f"{os.fsdecode(problem.filename)}: "
            return WRONG_INPUT, one_line(f"{place}{problem.strerror.lower()}")
    try:
        told = one_line(f"{type(problem).__name__}: {problem}")
    except BaseException:  # of the exception's own text
        told = type(problem).__name__
    return UNANSWERED, f"internal error: {told}; run again with --debug and report it"


def _wrong_value(problem: Any) -> str:
    """What an option or argument takes that has a value of another type; empty for others."""
    parameter = getattr(problem, "param", None)
    if type(problem) is not typer.BadParameter or parameter is None or problem.ctx is None:
        return ""
    callback: Any = problem.ctx.command.callback
    own = inspect.signature(callback).parameters
    kind, *details = get_args(own[parameter.name].annotation)
    while inner := [each for each in get_args(kind) if each is not type(None)]:
        kind = inner[0]
    if kind in _WORDS:
        low = getattr(details[0], "min", None)
        words = _WORDS[kind] if low is None else f"{_WORDS[kind]} from {low} on"
    elif isinstance(kind, type) and issubclass(kind, Enum):
        words = " or ".join(each.value for each in kind)
    else:
        return ""
    flag = next((name for name in parameter.opts if name.startswith("-")), parameter.metavar)
    return f"{flag} takes {words}"


def _elsewhere(problem: Any) -> str:
    """Where an option is that a command has not; empty if nowhere, and for other problems."""
    name = getattr(problem, "option_name", None)
    if name is None or problem.ctx is None:
        return ""
    every = dict(_commands(problem.ctx.find_root().command, "nonsmooth"))
    having = [path for path, one in every.items() if any(name in p.opts for p in one.params)]
    return f"; it is one of {', '.join(having)}" if having else ""


def _commands(group: Any, path: str) -> Iterator[tuple[str, Any]]:
    """All commands of a group and of those in it, by their words."""
    for name, found in group.commands.items():
        yield from (
            _commands(found, f"{path} {name}")
            if hasattr(found, "commands")
            else [(f"{path} {name}", found)]
        )


def _version(asked: bool) -> None:
    if asked:
        from importlib.metadata import version

        print(f"nonsmooth {version('nonsmooth')}")
        raise typer.Exit


@app.callback()
def _options(
    context: typer.Context,
    version: Annotated[
        bool,
        typer.Option("--version", callback=_version, is_eager=True, help="Show the version."),
    ] = False,
) -> None:
    if context.invoked_subcommand is None:
        context.get_help()
        raise typer.Exit(WRONG_INPUT)


def print_json(found: Mapping[str, Any]) -> None:
    """Print one JSON document on stdout, with null for numbers that are nan."""
    from nonsmooth.runtime.core.json_codec import nan_as_null

    print(json.dumps(nan_as_null(found), indent=2, allow_nan=False))

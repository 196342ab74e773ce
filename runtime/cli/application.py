"""The command line's application: exit codes, errors in one line, JSON, values by name.

Every command returns its exit code: 0 when the question was answered, 1 on no convergence,
an undecided verdict or a check that differs, 2 on wrong input, 3 when a requirement is not
met, 130 when it was interrupted, 141 when nobody reads the answer any more.
"""

from __future__ import annotations

import functools
import inspect
import json
import logging
import os
import sys
import traceback
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager, nullcontext, suppress
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, NoReturn

import typer
from typer.core import TyperGroup

from nonsmooth.runtime.cli.keeping import heed_interrupts, interrupted, same_command, say
from nonsmooth.runtime.cli.options import PICTURES
from nonsmooth.runtime.core.errors import InputError, NoConvergence, NonsmoothError, one_line

if TYPE_CHECKING:
    from nonsmooth.runtime.core.values import Value

__all__ = [
    "ANSWERED",
    "NOT_MET",
    "PURPOSES",
    "UNANSWERED",
    "WRONG_INPUT",
    "answering",
    "app",
    "assignments",
    "check_drawing",
    "fail",
    "print_json",
    "ranges",
    "split",
]

ANSWERED, UNANSWERED, WRONG_INPUT, NOT_MET = 0, 1, 2, 3
_UNREAD = 141  # as of a program that the closed pipe's signal ends
_LONGEST_COUNT = 18  # digits
_UsageError: Any = typer.BadParameter.__base__  # Typer has a Click of its own, or shares it


# what commands are for, in the order of the help
PURPOSES = {
    "Declare and derive": ("list", "equations", "generate", "regenerate"),
    "Solve and verify": ("solve", "verify"),
    "Simulate and explore": ("simulate", "find", "sweep", "continue", "chart"),
    "Prove": ("certify", "basin", "chaos", "graph"),
    "Fit and design": ("fit", "design"),
    "Show and keep": ("plot", "reproduce", "doctor"),
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
            if _is_unread(problem):
                os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
                sys.exit(_UNREAD)
            if isinstance(problem, SystemExit):
                raise
            words = options.get("args") or sys.argv
            code = fail(problem, as_json="--json" in words, debug="--debug" in words)
        sys.exit(code)


def _is_unread(problem: BaseException) -> bool:
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

_DEBUG = inspect.Parameter(
    "debug",
    inspect.Parameter.KEYWORD_ONLY,
    default=False,
    annotation=Annotated[bool, typer.Option("--debug", help="Show where an error came from.")],
)


def answering(command: Callable[..., int]) -> Callable[..., None]:
    """A command that exits with the code it returns, or with one line on stderr for an error.

    It always raises `typer.Exit`. The command gets the option `--debug`, which shows the
    traceback before that line, and why kernels are not compiled.
    """

    @functools.wraps(command)
    def run(*arguments: Any, debug: bool = False, **options: Any) -> NoReturn:
        try:
            with _log_shown() if debug else nullcontext():
                code = command(*arguments, **options)
        except KeyboardInterrupt:
            code = interrupted("nothing is kept", f"begin again with: {same_command()}")
        except typer.Abort:
            raise
        except BaseException as problem:  # a declaration's parts may raise anything
            if _is_unread(problem):
                raise
            code = fail(problem, as_json=options["as_json"], debug=debug)
        finally:
            heed_interrupts()
        raise typer.Exit(code)

    signature = inspect.signature(command, eval_str=True)
    parameters = [*signature.parameters.values(), _DEBUG]
    # Typer reads the options of a function from this, which typeshed gives to no function
    run.__signature__ = signature.replace(parameters=parameters)  # type: ignore[attr-defined]
    return run


@contextmanager
def _log_shown() -> Iterator[None]:
    """Show the package's log records on stderr while the context lasts."""
    log = logging.getLogger("nonsmooth")
    handler = logging.StreamHandler()
    handler.setFormatter(logging.Formatter("nonsmooth: %(message)s"))
    level = log.level
    log.setLevel(logging.INFO)
    log.addHandler(handler)
    try:
        yield
    finally:
        log.removeHandler(handler)
        log.setLevel(level)


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
            told = one_line(problem.format_message()).rstrip(".?")
            return WRONG_INPUT, f"{told[:1].lower()}{told[1:]}; {path} --help shows the usage"
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


def split(options: Iterable[str] | None) -> list[str]:
    """Nonempty entries of options that each hold a comma-separated list."""
    return [part.strip() for option in options or () for part in option.split(",") if part.strip()]


def assignments(kind: str, texts: Iterable[str]) -> dict[str, Value]:
    """Values by name, parsed from texts ``NAME=VALUE``, in the order in which they are given.

    `kind` says in messages what is assigned. InputError refuses a text that is no
    assignment and a name that is given twice.
    """
    from nonsmooth.runtime.core.values import parse_assignment

    found: dict[str, Value] = {}
    for text in texts:
        name, value = parse_assignment(text)
        if name in found:
            raise InputError(f"{kind} {name} is given twice")
        found[name] = value
    return found


def ranges(
    kind: str, texts: Iterable[str], *, counts: bool = False
) -> dict[str, tuple[float, float, int]]:
    """Lower end, upper end and count by name, parsed from ``NAME=A:B`` or ``NAME=A:B:N``.

    The ends are in the system's units. Only with `counts` the texts have a count N; it is 0
    without. `kind` says in messages what the ranges are of. InputError refuses a text that
    is no range and a name that is given twice.
    """
    from nonsmooth.runtime.core.values import parse

    found: dict[str, tuple[float, float, int]] = {}
    form = "A:B:N" if counts else "A:B"
    for text in texts:
        name, _, bounds = text.partition("=")
        name, parts = name.strip(), bounds.split(":")
        if name in found:
            raise InputError(f"{kind} {name} is given twice")
        if not name or len(parts) != (3 if counts else 2):
            raise InputError(f"{text!r} is not NAME={form}")
        low, high = float(parse(parts[0])), float(parse(parts[1]))
        if counts and not (parts[2].strip().isdecimal() and len(parts[2]) <= _LONGEST_COUNT):
            raise InputError(f"{text!r}: {parts[2]!r} is not a count")
        found[name] = low, high, int(parts[2]) if counts else 0
    return found


def check_drawing(path: Path | None) -> None:
    """Refuse a picture that could not be drawn, before any work is done; None is no picture.

    InputError refuses another ending than a picture's and a file that cannot be written,
    MissingExtra says that matplotlib is not installed.
    """
    from nonsmooth.runtime.core.files import check_ending, check_target
    from nonsmooth.runtime.present.pictures.drawing import check_matplotlib

    if path is not None:
        check_ending(path, PICTURES)
        check_target(path)
        check_matplotlib()


def print_json(found: Mapping[str, Any]) -> None:
    """Print one JSON document on stdout, with null for numbers that are nan."""
    from nonsmooth.runtime.core.json_codec import nan_as_null

    print(json.dumps(nan_as_null(found), indent=2, allow_nan=False))

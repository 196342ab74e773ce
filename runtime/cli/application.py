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
from nonsmooth.runtime.core.valid_json import nan_as_null

if TYPE_CHECKING:
    from nonsmooth.runtime.core.values import Value

__all__ = [
    "ANSWERED",
    "NOT_MET",
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


class _Door(TyperGroup):
    """All commands: whatever stops one of them leaves by `fail`."""

    def main(self, *arguments: Any, **options: Any) -> NoReturn:
        """Run the command line and exit; errors that concern no command are told here."""
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
    """Whether nobody reads the answer any more; Rich leaves by a SystemExit then."""
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
    """Exit with the code that a command returns, or with one line on stderr.

    The command gets the option `--debug`, which shows the traceback before that line, and why
    kernels are not compiled.

    Parameters
    ----------
    command : callable
        Gives an exit code.

    Returns
    -------
    callable
        With the signature of the command and `debug`.

    Raises
    ------
    typer.Exit
        Always, with the exit code.
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
    """Show on stderr, for a while, what the package notes of its work beside the answers."""
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
    """Tell in one line on stderr why there is no answer; gives the exit code.

    Parameters
    ----------
    problem : BaseException
    as_json : bool
        Tell it on stdout as well, as JSON.
    debug : bool
        Show the traceback first.

    Returns
    -------
    int
        The exit code.
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
    """Exit code and one line for an exception."""
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
    """Entries of options that hold comma-separated lists.

    Parameters
    ----------
    options : iterable of str or None
        Each with entries between commas.

    Returns
    -------
    list of str
        Without empty ones.
    """
    return [part.strip() for option in options or () for part in option.split(",") if part.strip()]


def assignments(kind: str, texts: Iterable[str]) -> dict[str, Value]:
    """Values by name, each given once.

    Parameters
    ----------
    kind : str
        What is assigned, for the message.
    texts : iterable of str
        ``NAME=VALUE``.

    Returns
    -------
    dict of str to Value
        In the order in which they were given.

    Raises
    ------
    InputError
        If a text is no assignment, or a name is given twice.
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
    """Ranges ``name=lower:upper`` or, with counts, ``name=lower:upper:count``; count 0 without.

    Parameters
    ----------
    kind : str
        What the ranges are of, for the message.
    texts : iterable of str
        One range each.
    counts : bool, default False
        Whether each range has a count.

    Returns
    -------
    dict of str to (float, float, int)
        Lower and upper end in the system's units, and the count.

    Raises
    ------
    InputError
        If a text is no range, or a name is given twice.
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
    """Refuse a picture that could not be drawn, before the work is done.

    Parameters
    ----------
    path : Path or None
        The picture's file; None for no picture.

    Raises
    ------
    InputError
        If the file has another ending, or cannot be written.
    MissingExtra
        If matplotlib is not installed.
    """
    from nonsmooth.runtime.core.files import check_ending, check_target
    from nonsmooth.runtime.present.pictures.drawing import check_matplotlib

    if path is not None:
        check_ending(path, PICTURES)
        check_target(path)
        check_matplotlib()


def print_json(found: Mapping[str, Any]) -> None:
    """Print one JSON document on stdout.

    Parameters
    ----------
    found : dict
        Ready for JSON; a number that is not known is printed as null.
    """
    print(json.dumps(nan_as_null(found), indent=2, allow_nan=False))

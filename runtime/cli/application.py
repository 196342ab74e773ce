"""The command line's application: exit codes, errors in one line, JSON, values by name.

Every command returns its exit code: 0 when the question was answered, 1 on no convergence,
an undecided verdict or a check that differs, 2 on wrong input, 3 when a requirement is not
met, 130 when it was interrupted.
"""

from __future__ import annotations

import functools
import json
import sys
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, NoReturn

import typer

from nonsmooth.runtime.cli.keeping import interrupted, same_command
from nonsmooth.runtime.cli.options import PICTURES
from nonsmooth.runtime.core.errors import InputError, NoConvergence, NonsmoothError

if TYPE_CHECKING:
    from nonsmooth.runtime.core.values import Value

__all__ = [
    "ANSWERED",
    "NOT_MET",
    "UNANSWERED",
    "answering",
    "app",
    "assignments",
    "check_drawing",
    "drawn",
    "print_json",
    "ranges",
    "split",
    "without_picture",
]

ANSWERED, UNANSWERED, WRONG_INPUT, NOT_MET = 0, 1, 2, 3

app = typer.Typer(
    name="nonsmooth",
    help="Periodic orbits of piecewise-linear oscillators with impacts and dry friction.",
    epilog="Exit codes: 0 answered, 1 no answer or a difference, 2 wrong input,"
    " 3 a requirement is not met, 130 interrupted.",
    no_args_is_help=True,
    add_completion=False,
    rich_markup_mode="rich",
    pretty_exceptions_enable=False,
)


def answering(command: Callable[..., int]) -> Callable[..., None]:
    """Exit with the code that a command returns, or with one line on stderr."""

    @functools.wraps(command)
    def run(*arguments: Any, **options: Any) -> NoReturn:
        from nonsmooth.derive.errors import DeclarationError, DerivationError

        try:
            code = command(*arguments, **options)
        except NoConvergence as problem:
            code = _failed(problem, UNANSWERED, options)
        except (NonsmoothError, DeclarationError, DerivationError) as problem:
            code = _failed(problem, WRONG_INPUT, options)
        except KeyboardInterrupt:
            code = interrupted("nothing is kept", f"begin again with: {same_command()}")
        raise typer.Exit(code)

    return run


def _failed(problem: Exception, code: int, options: Mapping[str, Any]) -> int:
    if options["as_json"]:
        print_json({"error": str(problem)})
    kind = "error: " if code == WRONG_INPUT else ""
    print(f"nonsmooth: {kind}{problem}", file=sys.stderr)
    return code


def _version(asked: bool) -> None:
    if asked:
        from importlib.metadata import version

        print(f"nonsmooth {version('nonsmooth')}")
        raise typer.Exit


@app.callback()
def _options(
    version: Annotated[
        bool,
        typer.Option("--version", callback=_version, is_eager=True, help="Show the version."),
    ] = False,
) -> None:
    pass


def split(options: Iterable[str] | None) -> list[str]:
    """Entries of options that hold comma-separated lists."""
    return [part.strip() for option in options or () for part in option.split(",") if part.strip()]


def assignments(kind: str, texts: Iterable[str]) -> dict[str, Value]:
    """Values by name, each given once."""
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
    """Ranges ``name=lower:upper`` or, with counts, ``name=lower:upper:count``; count 0 without."""
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
        if counts and not parts[2].strip().isdecimal():
            raise InputError(f"{text!r}: {parts[2]!r} is not a count")
        found[name] = low, high, int(parts[2]) if counts else 0
    return found


def check_drawing(path: Path | None) -> None:
    """Refuse a picture that could not be drawn, before the work is done."""
    from nonsmooth.runtime.core.files import check_ending, check_target
    from nonsmooth.runtime.present.pictures.drawing import check_matplotlib

    if path is not None:
        check_ending(path, PICTURES)
        check_target(path)
        check_matplotlib()


def drawn(draw: Callable[[], None]) -> NonsmoothError | None:
    """Draw what was computed; a picture that fails is told of when that has been shown."""
    try:
        draw()
    except NonsmoothError as problem:
        return problem
    return None


def without_picture(failed: NonsmoothError | None) -> int:
    """Say on stderr why there is no picture, if there is none; gives the exit code."""
    if failed is None:
        return ANSWERED
    print(f"nonsmooth: error: no picture: {failed}", file=sys.stderr)
    return WRONG_INPUT


def print_json(found: Mapping[str, Any]) -> None:
    """Print one JSON document on stdout."""
    print(json.dumps(found, indent=2, allow_nan=False))

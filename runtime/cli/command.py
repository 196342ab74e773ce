"""The decorator of all commands: exit codes, options that all have, files, going on with them."""

from __future__ import annotations

import functools
import inspect
import logging
from collections.abc import Callable, Iterator
from contextlib import contextmanager, nullcontext
from typing import Annotated, Any, NoReturn

import typer

from nonsmooth.runtime.cli.application import app, fail, is_unread
from nonsmooth.runtime.cli.keeping import heed_interrupts, interrupted, same_command
from nonsmooth.runtime.cli.options import KEPT, Plot, Resume, option
from nonsmooth.runtime.cli.reply import Reply
from nonsmooth.runtime.cli.resuming import Request
from nonsmooth.runtime.core.errors import InputError

AsJson = Annotated[
    bool,
    option(
        "--json", "One JSON document on stdout, numbers as decimal strings.", rich_help_panel=KEPT
    ),
]
Debug = Annotated[bool, option("--debug", "Show where an error came from.", rich_help_panel=KEPT)]
Overwrite = Annotated[
    bool,
    option(
        "--overwrite", "Replace the file of --save if it is there already.", rich_help_panel=KEPT
    ),
]


def command(
    name: str,
    *examples: str,
    after: str = "",
    group: typer.Typer = app,
    save: Any = None,
    plot: bool = False,
    long: bool = False,
    several: bool = False,
    question: str = "",
    anew: str = "",
    kept: str = "",
) -> Callable[[Callable[..., int]], Callable[..., int]]:
    """A decorator that makes a function, which returns an exit code, a command of a group.

    Its help ends with the examples, and with `after`.

    In place of the function's last argument, an `Reply`, the command has --json and --debug,
    --save with the annotation `save`, --plot if there is a picture, and --overwrite if the work
    is `long`. JSON lists the files of a command that may write `several`, as with a picture.

    With a `question`, the names of the parameters that ask it, the command goes on with
    --resume; those named in `anew`, which say how much is done, may change then. Its file is of
    the kind `kept`.
    """
    kinds = {
        **({"plot": Plot} if plot else {}),
        **({"save": save} if save else {}),
        **({"resume": Resume} if question else {}),
        **({"overwrite": Overwrite} if long else {}),
        "as_json": AsJson,
        "debug": Debug,
    }

    def over(function: Callable[..., int]) -> Callable[..., int]:
        declared = dict(inspect.signature(function, eval_str=True).parameters)
        del declared["reply"]
        asked = Request(question.split(), anew.split(), declared) if question else None

        def perform(context: typer.Context, options: dict[str, Any]) -> int:
            with asked.put(context, options) if asked else nullcontext():
                own = {each: options.pop(each) for each in kinds if each in options}
                reply = Reply(**own, kept=kept, lists=plot or several)
                if long and reply.overwrite and reply.save is None:
                    raise InputError("--overwrite is for the file of --save, which is missing")
                reply.check()
                return function(**options, reply=reply)

        @functools.wraps(function)
        def run(context: typer.Context, debug: bool, **options: Any) -> NoReturn:
            as_json = options["as_json"]
            try:
                with _log_shown() if debug else nullcontext():
                    code = perform(context, options)
            except KeyboardInterrupt:
                code = interrupted("nothing is kept", f"begin again with: {same_command()}")
            except typer.Abort:
                raise
            except BaseException as problem:  # a declaration's parts may raise anything
                if is_unread(problem):
                    raise
                code = fail(problem, as_json=as_json, debug=debug)
            finally:
                heed_interrupts()
            raise typer.Exit(code)

        keyword = inspect.Parameter.KEYWORD_ONLY
        flags = {
            each: inspect.Parameter(
                each,
                keyword,
                default=None if each in ("save", "plot", "resume") else False,
                annotation=kind,
            )
            for each, kind in kinds.items()
        }
        first = asked.parameters if asked else declared.values()
        context = inspect.Parameter("context", keyword, annotation=typer.Context)
        # Typer reads the options of a function from this, which typeshed gives to no function
        run.__signature__ = inspect.Signature(  # type: ignore[attr-defined]
            [*first, *flags.values(), context]
        )
        shown = [f"nonsmooth {example}" for example in examples]
        epilog = "\n\n".join(["Examples:", *shown, *([after] if after else [])])
        paragraphs = (inspect.getdoc(function) or "").split("\n\n")
        told = "\n\n".join(" ".join(paragraph.split()) for paragraph in paragraphs)
        group.command(name, help=told, epilog=epilog)(run)
        return run

    return over


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

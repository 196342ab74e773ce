"""Write the commands of a Typer application into a page: ``{typer-commands} module:app``."""

import re
from collections.abc import Iterator
from importlib import import_module
from typing import Any

import typer
from docutils.nodes import Node
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective

TYPES = {"", "bool", "float", "int", "path", "str"}


class TyperCommands(SphinxDirective):
    """A section for each command: usage, arguments, options, examples."""

    required_arguments = 1

    def run(self) -> list[Node]:
        """Read the commands as Typer shows them in ``--help``."""
        module, name = self.arguments[0].split(":")
        application: Any = typer.main.get_command(getattr(import_module(module), name))
        text = "\n".join(
            line
            for name, command in application.commands.items()
            if not command.hidden
            for line in lines_of(f"{application.name} {name}", command)
        )
        return self.parse_text_to_nodes(text, allow_section_headings=True)


def lines_of(name: str, command: Any) -> Iterator[str]:
    """Write one command, or a group and all of its subcommands, in MyST."""
    if not hasattr(command, "commands"):
        yield from command_lines(name, command)
        return
    yield from (f"## {name}", "", marked(command.help or ""), "")
    for own in command.list_commands(None):
        yield from command_lines(f"{name} {own}", command.commands[own])


def command_lines(name: str, command: Any) -> Iterator[str]:
    """Write one command in MyST."""
    context = command.context_class(command, info_name=name)
    about, *more = [marked(paragraph) for paragraph in (command.help or "").split("\n\n")]
    yield from (f"## {name}", "", about, "")
    yield from ("```text", " ".join((name, *command.collect_usage_pieces(context))), "```", "")
    for paragraph in more:
        yield from (paragraph, "")
    records = [(p.param_type_name, p.get_help_record(context)) for p in command.params]
    shown = [(kind, metavar(record[0]), marked(record[1])) for kind, record in records if record]
    for kind, label, told in shown:
        if kind == "argument":
            yield from (f"`{label}`", f": {told}", "")
    yield from (f"```{{program}} {name}", "```", "")
    for kind, label, told in shown:
        if kind == "option":
            yield from (f"```{{option}} {label}", told, "```", "")
    examples = [line for line in (command.epilog or "").splitlines() if line.startswith("nonsm")]
    if examples:
        yield from ("```console", *(f"$ {line}" for line in examples), "```", "")


def metavar(label: str) -> str:
    """Leave out Python's types; choices stay."""
    head, _, told = label.partition(" <")
    choices = told.removesuffix(">").removeprefix("list[").removesuffix("]")
    return head if choices in TYPES else f"{head} {choices}"


def marked(told: str) -> str:
    """Link the pages that a help text names; options are code, and defaults stand out."""
    told = re.sub(r"docs/(\w+)\.md", r"{doc}`/\1`", told.replace("\n", " "))
    told = re.sub(r"(?<![`\w-])--[a-z-]+(?![^`]*`)", r"`\g<0>`", told)
    return re.sub(r"\s*\[([^]]*)\]$", r" *(\1)*", told)


def setup(app: Sphinx) -> dict[str, bool]:
    """Register the directive."""
    app.add_directive("typer-commands", TyperCommands)
    return {"parallel_read_safe": True, "parallel_write_safe": True}

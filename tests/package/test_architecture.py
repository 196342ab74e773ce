"""docs/architecture.md tells the truth: what it names is there, and its commands are answered."""

import re
from importlib import import_module
from types import ModuleType

import pytest
from typer.testing import CliRunner

import nonsmooth as ns
import nonsmooth.derive
from nonsmooth.runtime.cli.program import app
from tests.places import CHECKOUT

PAGE = (CHECKOUT / "docs" / "architecture.md").read_text(encoding="utf-8")
NAMED = sorted(set(re.findall(r"`([^`]+)`", PAGE)))
WORDS = {"System", "name", ".register"}  # of the text, not of a place
COMMANDS = [name for name in NAMED if name.startswith("nonsmooth ")]
NAMES = [name for name in NAMED if name not in WORDS and name not in COMMANDS]


def found(name):
    """What a dotted name stands for: a module, or what is in one."""
    whole = name if name.startswith("nonsmooth") else f"nonsmooth.runtime.{name}"
    whole = f"nonsmooth.{name}" if name.startswith("derive") else whole
    parts = whole.split(".")
    for count in range(len(parts), 0, -1):
        try:
            place = import_module(".".join(parts[:count]))
        except ModuleNotFoundError:
            continue
        for part in parts[count:]:
            place = getattr(place, part)
        return place
    raise AssertionError(name)


@pytest.mark.parametrize("name", NAMES)
def test_what_the_page_names_is_there(name):
    if "/" in name:
        place = CHECKOUT / name
        assert place.exists() or (CHECKOUT / "runtime" / name).exists()
    elif "." in name and (CHECKOUT / name).exists():
        assert name == "pyproject.toml"
    elif hasattr(ns, name):
        assert name in ns.__all__ or isinstance(found(name), ModuleType)
    else:
        assert found(name) is not None


@pytest.mark.parametrize("command", COMMANDS)
def test_the_commands_of_the_page_are_answered(command):
    result = CliRunner().invoke(app, [*command.split()[1:], "--json"])
    assert result.exit_code == 0, result.output

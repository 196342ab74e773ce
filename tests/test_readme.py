"""The README tells the truth: its Python runs and its commands exist."""

import re
from pathlib import Path

import pytest
from typer.testing import CliRunner

from nonsmooth.runtime.cli import app

README = (Path(__file__).parents[1] / "README.md").read_text(encoding="utf-8")


def blocks(language):
    return re.findall(rf"```{language}\n(.*?)```", README, flags=re.DOTALL)


def test_the_python_example_runs(capsys):
    (example,) = blocks("python")
    exec(compile(example, "README.md", "exec"), {})
    printed = capsys.readouterr().out
    assert "stable" in printed
    assert "(201, 101)" in printed


COMMANDS = [
    line.split("#")[0].split()[1:]
    for block in blocks("sh")
    for line in block.splitlines()
    if line.startswith("nonsmooth ")
]


@pytest.mark.usefixtures("committed_derivation", "empty_reproduction")
def test_every_command_line_is_answered(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)  # in the README's order: a later one reads what an earlier saved
    for command in COMMANDS:
        # LaTeX need not be installed
        words = ["latex" if word == "pdf" else word for word in command]
        result = CliRunner().invoke(app, words)
        assert result.exit_code == 0, (command, result.output)


def test_commands_were_found():
    assert len(COMMANDS) >= 5

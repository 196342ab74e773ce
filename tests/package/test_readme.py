"""The README tells the truth: its Python runs and its commands exist."""

import re

import pytest
from typer.testing import CliRunner

from nonsmooth.runtime.cli.program import app
from tests.places import CHECKOUT

README = (CHECKOUT / "README.md").read_text(encoding="utf-8")


def blocks(language):
    return re.findall(rf"```{language}\n(.*?)```", README, flags=re.DOTALL)


@pytest.mark.compiled  # finding orbits takes minutes in Python
def test_the_python_example_runs(capsys):
    example, _ = blocks("python")
    exec(compile(example, "README.md", "exec"), {})
    printed = capsys.readouterr().out
    assert "stable" in printed
    assert "(201, 101)" in printed


def commands(block):
    """Command lines of a block as a shell reads them: continued, with its variables."""
    lines = block.replace("\\\n", " ").splitlines()
    variables = dict(re.fullmatch(r'(\w+)="(.*)"', line).groups() for line in lines if '="' in line)
    for line in lines:
        if line.startswith("nonsmooth "):
            words = line.split("#")[0].split()[1:]
            yield [part for word in words for part in variables.get(word[1:], word).split()]


COMMANDS = [command for block in blocks("sh") for command in commands(block)]


@pytest.mark.compiled
@pytest.mark.usefixtures("committed_derivation", "empty_reproduction")
def test_every_command_line_is_answered(tmp_path, monkeypatch):
    _, declaration = blocks("python")
    (tmp_path / "my_oscillator.py").write_text(declaration, encoding="utf-8")
    monkeypatch.setenv("NONSMOOTH_CACHE", str(tmp_path / "cache"))
    monkeypatch.chdir(tmp_path)  # in the README's order: a later one reads what an earlier saved
    for command in COMMANDS:
        # LaTeX need not be installed
        words = ["latex" if word == "pdf" else word for word in command]
        result = CliRunner().invoke(app, words)
        assert result.exit_code == 0, (command, result.output)


def test_commands_were_found():
    assert len(COMMANDS) >= 5

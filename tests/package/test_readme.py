"""README and the pages of examples tell the truth: their Python runs and their commands exist."""

import re
import shlex

import pytest
import typer
from typer.testing import CliRunner

from nonsmooth.runtime.cli.program import app
from tests.cli.terminal import all_commands
from tests.cli.test_cli import with_fewer
from tests.places import CHECKOUT

README = (CHECKOUT / "README.md").read_text(encoding="utf-8")
COMMANDS_PAGE = (CHECKOUT / "docs" / "how_to" / "commands.md").read_text(encoding="utf-8")
HELP = "\n".join(command.epilog for command in all_commands().values()).splitlines()
OF_OTHER_PROGRAMS = {"--build", "--index-url", "--nthreads", "--port"}


def blocks(text, language):
    return re.findall(rf"```{language}\n(.*?)```", text, flags=re.DOTALL)


def commands(block):
    """Command lines of a block as a shell reads them: continued, with its variables."""
    lines = block.replace("\\\n", " ").splitlines()
    variables = dict(re.fullmatch(r'(\w+)="(.*)"', line).groups() for line in lines if '="' in line)
    for line in lines:
        if line.startswith("nonsmooth "):
            words = line.split("#")[0].split()[1:]
            yield [part for word in words for part in variables.get(word[1:], word).split()]


def commands_of(text):
    return [command for block in blocks(text, "sh") for command in commands(block)]


def has_test_of_its_own(command, later):
    """Whether it is an example of the help: tests/cli runs these.

    A command that reads a file of the page, or writes one that a later command reads, has none.
    """
    files = {word for word in command if word.endswith((".json", ".zarr", ".py"))}
    ours = {word for one in later for word in one} | {word for word in files if ".py" in word}
    return " ".join(["nonsmooth", *command]) in HELP and not files & ours


def test_every_option_that_a_page_names_is_one_of_a_command():
    commands = [typer.main.get_command(app), *all_commands().values()]
    known = {name for command in commands for option in command.params for name in option.opts}
    known |= OF_OTHER_PROGRAMS | {"--help"}
    for page in [CHECKOUT / "README.md", *(CHECKOUT / "docs").rglob("*.md")]:
        named = set(re.findall(r"(?<![\w-])--[a-z][a-z-]+", page.read_text(encoding="utf-8")))
        assert named <= known, page


@pytest.fixture
def declared(tmp_path, monkeypatch):
    """A folder with the files that the pages declare, in which commands and sessions run."""
    for text in (README, COMMANDS_PAGE):
        declaration = blocks(text, "python")[0]
        name = re.match(r"# (\w+\.py)", declaration).group(1)
        (tmp_path / name).write_text(declaration, encoding="utf-8")
    monkeypatch.setenv("NONSMOOTH_CACHE", str(tmp_path / "cache"))
    monkeypatch.chdir(tmp_path)
    monkeypatch.syspath_prepend(tmp_path)
    return tmp_path


@pytest.mark.slow
@pytest.mark.compiled  # finding orbits takes minutes in Python
@pytest.mark.usefixtures("declared")
def test_the_session_of_the_readme_prints_what_it_shows(capsys):
    _, session = blocks(README, "python")
    exec(compile(session, "README.md", "exec"), {})
    (shown,) = blocks(README, "text")
    assert capsys.readouterr().out == shown


@pytest.mark.slow
@pytest.mark.compiled
@pytest.mark.usefixtures("committed_derivation", "empty_reproduction", "declared")
@pytest.mark.parametrize(
    "text",
    [
        pytest.param(README, id="README"),
        pytest.param(COMMANDS_PAGE, id="commands", marks=pytest.mark.slow),
    ],
)
def test_every_command_line_is_answered(text):
    found = commands_of(text)
    assert len(found) >= 4
    needed = [
        command
        for place, command in enumerate(found)
        if not has_test_of_its_own(command, found[place + 1 :])
    ]
    for command in needed:  # in the page's order: a later one reads what an earlier saved
        # LaTeX need not be installed
        asked = shlex.split(with_fewer(shlex.join(command)))
        words = ["latex" if word == "pdf" else word for word in asked]
        result = CliRunner().invoke(app, words)
        assert result.exit_code == 0, (command, result.output)


def test_links_of_the_readme_lead_somewhere():
    for target in re.findall(r"\]\(((?!http)[^)#]+)\)", README):
        assert (CHECKOUT / target).exists(), target


def test_pictures_are_small():
    pictures = [p for p in (CHECKOUT / "docs" / "pictures").rglob("*.*") if p.is_file()]
    assert len(pictures) >= 15
    assert all(p.stat().st_size < 200_000 for p in pictures)

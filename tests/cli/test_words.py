"""One word for a thing: options of one name mean one thing, in all commands."""

import inspect
import json
import re
from collections import defaultdict

import pytest
import typer

import nonsmooth as ns
from tests.cli.test_cli import COMMANDS, run
from tests.places import GALLERY

ORBIT = "dry-friction/global-stick"


def options():
    """Options by name, and the commands that have them."""
    found = defaultdict(dict)
    for name, command in COMMANDS.items():
        for option in command.params:
            if option.opts[0].startswith("--"):
                found[option.opts[0]][name] = option
    return found


def test_no_option_has_another_name():
    for name, commands in options().items():
        for command, option in commands.items():
            assert (option.opts, option.secondary_opts) == ([name], []), command


def test_a_usage_line_puts_what_may_be_left_out_in_brackets_once():
    for name, command in COMMANDS.items():
        usage = command.get_usage(typer.Context(command, info_name=name))
        assert "[[" not in usage, usage


@pytest.mark.parametrize("name", options())
def test_values_of_another_type_are_refused_in_the_words_of_this_program(name):
    for command, option in options()[name].items():
        kind = str(inspect.signature(COMMANDS[command].callback).parameters[option.name].annotation)
        if not re.search(r"\[(str|bool|pathlib\.Path|list\[str\])", kind):
            code, _, err = run(*command.split(), name, "?")
            assert (code, f"{name} takes" in err) == (2, True), (command, kind, err)


def test_pictures_of_answers_are_plotted_and_products_come_out():
    """Only `plot` has a picture as its product."""
    made = {name: option.help.lower() for name, option in options()["--out"].items()}
    assert [name for name, told in made.items() if "svg" in told] == ["plot"]
    assert not made.keys() & options()["--plot"].keys()


@pytest.mark.parametrize("name", ["--from", "--guess", "--given"])
def test_numbers_are_given_by_name(name):
    """Whatever begins somewhere, a motion or a branch, takes NAME=VALUE."""
    assert {option.metavar for option in options()[name].values()} == {"NAME=VALUE,..."}


def test_a_branch_is_entered_where_it_is_told():
    for value in ("0.85", "1.2"):
        code, out, err = run(
            *f"continue {ORBIT} V=0.8:1.3 --from V={value} --step 0.2 --points 1 --json".split()
        )
        assert code == 0, err
        assert float(value) in json.loads(out)["values"]


def test_a_branch_ends_where_it_is_no_motion_in_python_as_on_the_command_line():
    orbit = ns.solve("dry-friction/symmetric")
    whole = ns.continue_orbit(orbit, "V", (0.5, 0.8), step=0.1)
    part = ns.continue_orbit(orbit, "V", (0.5, 0.8), step=0.1, admissible=True)
    assert len(part) < len(whole)
    asked = "continue dry-friction/symmetric V=0.5:0.8 --step 0.1 --admissible --json"
    _, out, _ = run(*asked.split())
    assert f'"{part.ends[0]}"' in out


def test_values_of_a_file_are_no_defaults_and_unknowns_have_their_names(tmp_path):
    file = tmp_path / "orbit.json"
    forced = f"{GALLERY / 'two_stops.py'}:symmetric"
    for name, words in ((ORBIT, ["eta=1.01"]), (forced, [])):
        _, shown, _ = run("solve", name, *words, "--save", str(file))
        assert "default" in shown
        _, again, err = run("solve", str(file))
        assert "default" not in again, err
        assert " ".join(again.split()).count(f"from {file}") == len(ns.load(file).given)
        rows = {line.split()[0] for line in again.splitlines() if line.strip()}
        assert rows >= {*ns.load(file).problem.unknown_names}

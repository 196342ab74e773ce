"""What `--json` prints is JSON for every reader: null where a number is not known."""

import ast
import json
import math
import shlex

from typer.testing import CliRunner

import nonsmooth as ns
from nonsmooth.runtime.cli.application import print_json
from nonsmooth.runtime.cli.program import app
from tests.cli import test_fit_command
from tests.places import CHECKOUT


def refused(constant):
    raise AssertionError(f"{constant} is no JSON")


def test_one_function_prints_all_json():
    """No command goes past it."""
    writers = set()
    for path in sorted((CHECKOUT / "runtime" / "cli").glob("*.py")):
        for function in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(function, ast.FunctionDef):
                called = {
                    ast.unparse(x.func) for x in ast.walk(function) if isinstance(x, ast.Call)
                }
                if called & {"json.dumps", "json.dump", "dumps", "dump"}:
                    writers.add((path.name, function.name))
    assert writers == {("application.py", "print_json")}


def test_what_is_not_known_is_printed_as_null(capsys):
    print_json({"trace": "nan", "rates": [math.nan, math.inf, 0.5, {"name": "nan"}]})
    found = json.loads(capsys.readouterr().out, parse_constant=refused)
    assert found == {"trace": None, "rates": [None, "inf", 0.5, {"name": None}]}


def test_an_error_that_is_not_known_is_null(tmp_path, monkeypatch):
    """A parameter that ends at its bound has no standard error."""
    test_fit_command.enter(tmp_path, monkeypatch)
    fixed = "c=0.05 h=0.2 w=2.1 k=2.6:2.7 r=0.7:1 --from x=-0.6,v=0.1 --save fit.json"
    found = CliRunner().invoke(
        app, shlex.split(f"fit identification.py impacts.csv {fixed} --json")
    )
    told = json.loads(found.stdout, parse_constant=refused)
    assert told["standard_errors"][0] is None
    assert float(told["standard_errors"][1]) > 0
    assert {*told["estimates"]} <= {repr(x) for x in ns.load("fit.json").estimates.tolist()}
    # the file keeps what the record holds, and gives the same answer
    kept = ns.load("fit.json")
    assert math.isnan(kept.standard_errors[0])
    assert kept.to_json()["standard_errors"] == told["standard_errors"]

"""What `--json` prints is JSON for every reader: null where a number is not known."""

from __future__ import annotations

import ast
import json
import math
import random
import shlex
import shutil
from pathlib import Path
from typing import Any, NoReturn

import pytest
from typer.testing import CliRunner

import nonsmooth as ns
from nonsmooth.runtime.cli.application import print_json
from nonsmooth.runtime.cli.program import app
from tests.places import CHECKOUT, GALLERY

NUMBERS = (math.nan, math.inf, -math.inf, 0.5, 3, True, None)
TEXTS = ("nan", "nan nan", "inf", "-inf", "0.1", "", "a name", "banana", "nan of it")


def refused(constant: str) -> NoReturn:
    raise AssertionError(f"{constant} is no JSON")


def drawn(random_numbers: random.Random, depth: int) -> Any:
    kind = random_numbers.randrange(4 if depth else 2)
    if kind == 0:
        return random_numbers.choice(NUMBERS)
    if kind == 1:
        return random_numbers.choice(TEXTS)
    parts = [drawn(random_numbers, depth - 1) for _ in range(random_numbers.randrange(4))]
    return parts if kind == 2 else {f"k{n}": part for n, part in enumerate(parts)} | {"nan": 1}


def agrees(told: Any, given: Any) -> bool:
    """Whether everything stands where it was, but for what is not known."""
    if isinstance(given, dict):
        return given.keys() == told.keys() and all(agrees(told[k], x) for k, x in given.items())
    if isinstance(given, list):
        return len(given) == len(told) and all(map(agrees, told, given))
    if given in ("nan", "nan nan") or given != given:
        return told is None
    return bool(told == (repr(given) if given in (math.inf, -math.inf) else given))


@pytest.mark.parametrize("seed", range(50))
def test_no_nan_is_printed(seed: int, capsys: pytest.CaptureFixture[str]) -> None:
    given = {"found": drawn(random.Random(seed), 4)}
    print_json(given)
    assert agrees(json.loads(capsys.readouterr().out, parse_constant=refused), given)


def test_one_function_prints_all_json() -> None:
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


def test_an_error_that_is_not_known_is_null(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A parameter that ends at its bound has no standard error."""
    for name in ("identification.py", "impacts.csv"):
        shutil.copy(GALLERY / name, tmp_path)
    monkeypatch.setenv("NONSMOOTH_CACHE", str(tmp_path / "cache"))
    monkeypatch.chdir(tmp_path)
    fixed = "c=0.05 h=0.2 w=2.1 k=2.6:2.7 r=0.7:1 --from x=-0.6,v=0.1 --save fit.json"
    found = CliRunner().invoke(
        app, shlex.split(f"fit identification.py impacts.csv {fixed} --json")
    )
    told = json.loads(found.stdout, parse_constant=refused)
    assert told["standard_errors"][0] is None
    assert float(told["standard_errors"][1]) > 0
    # the file keeps what the record holds, and gives the same answer
    kept = ns.load("fit.json")
    assert math.isnan(kept.standard_errors[0])
    assert kept.to_json()["standard_errors"] == told["standard_errors"]

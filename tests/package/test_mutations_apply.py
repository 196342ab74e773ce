"""The bugs of scripts/mutate.py are about the code as it is; running them is not for the suite."""

from __future__ import annotations

import sys
from collections import Counter

import pytest

from tests.places import CHECKOUT

sys.path.append(str(CHECKOUT / "scripts"))

from mutate import planted
from mutations import MUTATIONS, Mutation


@pytest.mark.parametrize("mutation", MUTATIONS, ids=str)
def test_a_bug_has_one_place_and_changes_it(mutation: Mutation) -> None:
    text = (CHECKOUT / mutation.file).read_text(encoding="utf-8")
    assert planted(text, mutation) != text
    assert all((CHECKOUT / test).is_file() for test in mutation.tests if test[0] != "-")


def test_there_are_bugs_everywhere() -> None:
    assert not [name for name, count in Counter(map(str, MUTATIONS)).items() if count > 1]
    assert sum(not mutation.equivalent for mutation in MUTATIONS) >= 60
    rooms = {"/".join(mutation.file.split("/")[:2]) for mutation in MUTATIONS}
    assert rooms >= {
        "derive/building", "derive/codegen", "derive/equations", "derive/flows",
        "runtime/checker", "runtime/cli", "runtime/core", "runtime/engine", "runtime/events",
        "runtime/model", "runtime/orbits", "runtime/proof", "runtime/shooting",
        "runtime/simulation",
    }  # fmt: skip


def _bug(before: str, after: str, file: str = "a.py", function: str = "one") -> Mutation:
    return Mutation(file, function, before, after, ())


PYTHON = """
def one(x):
    if x < 1:
        return "é" + str(x * x + 1)
    return x
def two(x):
    return x * x
"""
C = """
static int one(int x)
{
    return x < 1 ? x
                 : 2;
}
int two(int x)
{
    return one(x) + (x < 1);
}
"""


def test_bugs_are_found_by_function_and_syntax() -> None:
    assert '"é" + str((x * 2) + 1)' in planted(PYTHON, _bug("x*x", "x * 2"))
    assert "def two(x):\n    return 0\n" in planted(PYTHON, _bug("return x*x", "return 0",
                                                                  function="two"))  # fmt: skip
    assert "return x <= 1 : 2;" in planted(C, _bug("x < 1 ? x :", "x <= 1 :", "a.c"))
    assert "(x > 1)" in planted(C, _bug("x < 1", "x > 1", "a.c", "two"))


@pytest.mark.parametrize(
    "bug",
    [
        _bug("x", "1"),  # many times
        _bug("x * 3", "1"),
        _bug("x * x", "(x * x)"),  # changes nothing
        _bug("x", "1", function="three"),
        _bug("x < 1", "1", "a.c", "three"),
        _bug("x < 2", "1", "a.c"),
        _bug("x < 1 ? x :", "x  < 1 ? x :", "a.c"),
    ],
    ids=str,
)
def test_what_has_no_single_place_is_refused(bug: Mutation) -> None:
    with pytest.raises(LookupError):
        planted(C if bug.file == "a.c" else PYTHON, bug)

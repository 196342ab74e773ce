"""Bugs that mutate.py plants are found by syntax, everywhere, and each changes its place alone."""

import re
import subprocess

import mutate
import pytest
from mutating import functions, places, planted, probed

PYTHON = '''"""Numbers: 1 + 1."""
from typing import TYPE_CHECKING

__all__ = ["one" * 1]
LEAST = 1e-3
Number = int | float
if TYPE_CHECKING:
    KNOWN = 1 < 2


class Lévy:
    """Not 3 < 4."""

    limit: int = 7

    def walk(self, x: "1 + 1", y=2, *, sure: bool = True) -> float:
        """Say 1 + 1."""
        if x <= y and (sure or not self.limit) and 0 < x < y:
            raise ValueError(f"{x + 1}" + "a" * 2)
        logger.info(1 + 1)
        check(x)
        x -= y
        return np.minimum(x * y, "é" and -x / 2.5)


def two(z):
    assert z == 1
    return z + 1, [w.T for w in z if w.good] if z else None
'''
BUGS = {
    "LEAST::number": ["LEAST = (1e-3 * 1000)"],
    "Lévy.limit::number": ["limit: int = (7 + 1)"],
    "Lévy.walk::answer": ['return (-np.minimum(x * y, "é" and -x / 2.5))'],
    "Lévy.walk::boundary": ["if (x < y) and", "and (0 <= x < y):", "and (0 < x <= y):"],
    "Lévy.walk::call": ["        pass\n        x"],
    "Lévy.walk::comparison": ["if (x >= y) and", "and (0 > x < y):", "and (0 < x > y):"],
    "Lévy.walk::condition": [
        "if ((sure or not self.limit) and (0 < x < y)):",
        "if ((x <= y) and (0 < x < y)):",
        "if ((x <= y) and (sure or not self.limit)):",
        "and ((not self.limit)) and",
        "and (sure) and",
        "(x * y, (-x / 2.5))",
        '(x * y, "é")',
    ],
    "Lévy.walk::extreme": ["np.maximum(x * y"],
    "Lévy.walk::factor": ["minimum(x,", "((-x) * 2.5)"],
    "Lévy.walk::guard": ["if False:"],
    "Lévy.walk::negation": ["(sure or self.limit)"],
    "Lévy.walk::number": ["y=(2 + 1),", "(0 + 1) < x", "-x / (2.5 * 1000)"],
    "Lévy.walk::sign": ["and x / 2.5"],
    "Lévy.walk::term": ["x += y\n"],
    "Lévy.walk::truth": ["= False) ->"],
    "two::answer": ["return z + 1, None\n"],
    "two::choice": ["if (not w.good)]", "if (not z) else"],
    "two::number": ["z + (1 + 1),"],
    "two::term": ["return (z - 1),"],
    "two::transpose": ["[w for w"],
}
C = """/* 1 + 1 */
#include "a.h" /* 1 \\
   + 1 */
static const double LEAST = 1e-3;
enum { MOST = 32 };
static int one(double *x, int n)
{
    const char *text = "1 + 1"; // 1 + 1
    double sum = -x[0] * 2.5;
    for (int i = 0; i < n; ++i)
        sum += fmax(x[i], *x);
    if (!n || sum < 'a')
        return n;
    clear(x);
    return n - 1;
}
"""
BUGS_IN_C = {
    "LEAST::number": ["LEAST = (1e-3 * 1000.0);"],
    "MOST::number": ["MOST = (32 + 1) }"],
    "one::boundary": ["sum <= 'a'"],
    "one::call": ["return n;\n    ;\n"],
    "one::comparison": ["i > n", "sum > 'a'"],
    "one::condition": ["!n && sum"],
    "one::extreme": ["fmin(x[i]"],
    "one::factor": ["x[0] / 2.5"],
    "one::guard": ["if (0)\n"],
    "one::negation": ["if (n ||"],
    "one::number": ["x[(0 + 1)]", "(2.5 * 1000.0)", "i = (0 + 1)", "n - (1 + 1)"],
    "one::sign": ["= x[0]"],
    "one::term": ["sum -= fmax", "n + 1"],
}


@pytest.mark.parametrize(
    ("file", "text", "bugs"), [("a.py", PYTHON, BUGS), ("a.c", C, BUGS_IN_C)], ids=["Python", "C"]
)
def test_each_operator_has_its_places(file, text, bugs):
    wanted = {
        f"{file}::{kind}[{count}]": piece
        for kind, pieces in bugs.items()
        for count, piece in enumerate(pieces, 1)
    }
    changed = {bug.address: planted(text, bug) for bug in places(file, text)}
    assert changed.keys() == wanted.keys()
    assert {a: piece for a, piece in wanted.items() if piece not in changed[a]} == {}
    assert [piece for piece in wanted.values() if piece in text] == []


def test_addresses_lead_back_to_their_places(capsys):
    room = "runtime/core/workload.py"
    assert mutate.main([room, "--list", "--only", "factor", "--only", "term", "--sample", "3"]) == 0
    lines = capsys.readouterr().out.splitlines()
    addresses = [line.split()[0] for line in lines]
    assert len(addresses) == 3
    assert all(re.match(rf"{room}::.*(factor|term)\[\d+\]$", each) for each in addresses)
    assert sorted(bug.address for bug in mutate.chosen(addresses)) == sorted(addresses)
    file, function, _ = addresses[0].split("::")
    assert {bug.change.function for bug in mutate.chosen([f"{file}::{function}"])} == {function}
    assert mutate.chosen(["runtime/core/nothing.py"]) == []


def test_a_difference_can_be_applied(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(mutate, "CHECKOUT", tmp_path)
    file = tmp_path / "runtime" / "a.py"
    file.parent.mkdir()
    file.write_text(PYTHON, encoding="utf-8")

    def git(*arguments, told=""):
        subprocess.run(["git", *arguments], cwd=tmp_path, input=told, text=True, check=True)

    git("init", "-q")
    git("add", ".")
    git("-c", "user.name=a", "-c", "user.email=a", "commit", "-qm", "as it was")
    assert mutate.chosen(revision="HEAD") == []
    assert mutate.main(["runtime/a.py::two::term[1]", "--diff"]) == 0
    git("apply", told=capsys.readouterr().out)
    assert file.read_text(encoding="utf-8") == PYTHON.replace("z + 1,", "(z - 1),")
    assert {bug.change.function for bug in mutate.chosen(revision="HEAD")} == {"two"}


def test_a_probe_says_which_functions_run():
    text = '''
class One:
    """A class."""

    def short(self): return 1

    def long(self):
        """A function."""
        @str
        def inner(): pass
        for x in ():
            pass


def two(): """Nothing else."""
'''
    reached = []
    room = {"reach": reached.append}
    exec(probed(text, "reach('{}')"), room)
    assert reached == [""]
    exec("One().short(); One().long(); two()", room)
    assert reached == ["", "One.short", "One.long"]
    assert functions(text) == {"One.short", "One.long", "One.long.inner"}


@pytest.mark.slow
@pytest.mark.parametrize(
    ("expression", "outcome"), [("less(1, 1)", mutate.NOTICED), ("less(2, 1)", mutate.SURVIVED)]
)
def test_a_survivor_is_tried_with_the_slow_tests(expression, outcome, tmp_path, monkeypatch):
    monkeypatch.setattr(mutate, "CHECKOUT", tmp_path)
    settings = "[pytest]\naddopts = -m 'not slow'\nmarkers = slow: long ones\n"
    (tmp_path / "pytest.ini").write_text(settings)
    text = "def less(a, b):\n    return a < b\n"
    (tmp_path / "order.py").write_text(text)
    (tmp_path / "test_order.py").write_text(
        "import pytest\nfrom order import less\n\n"
        f"@pytest.mark.slow\ndef test_long():\n    assert not {expression}\n\n"
        "def test_short():\n    assert less(1, 2)\n"
    )
    (boundary, _) = places("order.py", text)
    measured = [mutate.Measured("test_order.py", 1.0, ["order.py::less"])]
    assert mutate.attempted(tmp_path, boundary, measured, 60.0) == outcome

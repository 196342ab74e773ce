"""The examples in docstrings are true: each runs by itself, in an empty folder."""

import doctest
import pkgutil
from importlib import import_module
from pathlib import Path

import pytest

import nonsmooth
from nonsmooth.runtime.model.kernels import compiled_engine

# simulate many motions, which takes minutes in Python
COMPILED = {
    *("basins", "find_orbits", "load_found", "load_sweep"),
    *("lyapunov", "sweep"),
    "certify_doubling",
    "certify_chaos",
}
# proofs that take seconds
SLOW = {"certify_basin", "certify_branch", "certify_doubling", "certify_graph"}


def with_examples():
    """Names of the modules whose sources show a prompt; importing all would take seconds."""
    names = []
    for module in pkgutil.walk_packages(nonsmooth.__path__, "nonsmooth."):
        origin = module.module_finder.find_spec(module.name, None).origin
        if origin and origin.endswith(".py") and ">>> " in Path(origin).read_text(encoding="utf-8"):
            names.append(module.name)
    return names


def examples():
    """Give the examples of all docstrings, those of one docstring together."""
    finder = doctest.DocTestFinder(exclude_empty=True)
    found = [test for name in with_examples() for test in finder.find(import_module(name))]
    return [
        pytest.param(test, id=test.name.removeprefix("nonsmooth."), marks=marks_of(test))
        for test in found
        if test.examples
    ]


def marks_of(example):
    """What an example asks for."""
    name = example.name.rpartition(".")[2]
    engine = pytest.mark.skipif(compiled_engine() is None, reason="no compiled engine")
    marks = [pytest.mark.compiled, engine] if name in COMPILED else []
    return [*marks, pytest.mark.slow] if name in SLOW else marks


@pytest.mark.parametrize("example", examples())
def test_examples(example, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("NONSMOOTH_CACHE", str(tmp_path / "cache"))
    report = []
    failed, _ = doctest.DocTestRunner().run(example, out=report.append)
    assert not failed, "".join(report)

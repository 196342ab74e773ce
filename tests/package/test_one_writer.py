"""One module writes files: no other calls what writes, but for the few places named here."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.places import CHECKOUT

WRITER = "runtime/core/files.py"
# places that write what does not stay, or is no result
ALLOWED = {
    ("runtime/cli/application.py", "main"): "nowhere: an answer that nobody reads any more",
    ("runtime/cli/program.py", "_open_streams"): "nowhere: streams that are closed",
    ("runtime/core/processes.py", "ask"): "a pipe to another process",
    ("runtime/core/processes.py", "serve"): "a pipe to the process that asks",
    ("runtime/explore/charting/lock.py", "_acquire"): "a lock, which the system lets go of",
    ("runtime/explore/charting/store.py", "_begin"): "a store moved to its place when it is whole",
    ("runtime/explore/charting/store.py", "_open_array"): "Zarr, which moves objects into place",
    ("runtime/model/loading/background.py", "_begin"): "what another process reads, without a name",
    ("runtime/model/loading/compiling.py", "compile_files"): "a temporary folder",
    ("runtime/present/files/declaring.py", "_declared_by"): "a file that is tried and removed",
    ("derive/document/writers/latex.py", "compile_pdf"): "a temporary folder",
    ("scripts/benchmark.py", "*"): "a temporary folder",
    ("scripts/benchmark_size.py", "_grown"): "what resets the peak of a process's memory",
    ("scripts/hostile.py", "*"): "a temporary folder",
    ("scripts/hostile_files.py", "*"): "a temporary folder",
    ("scripts/mutate.py", "*"): "a temporary folder, and what --map is to keep",
    ("scripts/pictures.py", "stablest"): "a picture of the documentation, which is made again",
    ("scripts/pictures.py", "thumbnails"): "pictures of the documentation, which are made again",
}
METHODS = {"write_text", "write_bytes", "savefig", "tofile", "touch", "rename", "dump"}
FUNCTIONS = {
    "np": {"save", "savez", "savez_compressed", "savetxt"},
    "numpy": {"save", "savez", "savez_compressed", "savetxt"},
    "shutil": {"copy", "copy2", "copyfile", "copytree", "move"},
    "os": {"open", "replace", "rename", "renames", "link"},
}
# into memory: the content goes to the writer
MEMORY = {("runtime/present/pictures/plot.py", "savefig")}


def writes(call: ast.Call) -> bool:
    """Whether a call writes, moves or begins a file."""
    bare = not isinstance(call.func, ast.Attribute)
    name = getattr(call.func, "id", "") if bare else call.func.attr
    if name == "open" and not _of(call, "os"):
        given = call.args[bare : bare + 1]  # open(path, mode), path.open(mode)
        modes = [*given, *(k.value for k in call.keywords if k.arg == "mode")]
        told = [str(m.value) if isinstance(m, ast.Constant) else "w" * bare for m in modes]
        return any({*mode} <= {*"rwaxbt+"} and {*mode} & {*"wax+"} for mode in told)
    return name in METHODS or any(
        name in names and _of(call, module) for module, names in FUNCTIONS.items()
    )


def _of(call: ast.Call, module: str) -> bool:
    value = call.func.value if isinstance(call.func, ast.Attribute) else None
    return isinstance(value, ast.Name) and value.id == module


def found(text: str) -> Iterator[tuple[str, str]]:
    """Functions of a source that write, and what they call."""

    def visit(node: ast.AST, inside: str) -> Iterator[tuple[str, str]]:
        for child in ast.iter_child_nodes(node):
            if isinstance(child, ast.Call) and writes(child):
                called = child.func
                yield inside, called.attr if isinstance(called, ast.Attribute) else "open"
            named = isinstance(child, ast.FunctionDef | ast.AsyncFunctionDef)
            yield from visit(child, child.name if named else inside)

    yield from visit(ast.parse(text), "")


def test_one_module_writes() -> None:
    used = set()
    for folder in ("runtime", "derive", "scripts"):
        for path in sorted((CHECKOUT / folder).rglob("*.py")):
            name = path.relative_to(CHECKOUT).as_posix()
            for function, called in found(path.read_text(encoding="utf-8")):
                places = {(name, function), (name, "*")} & set(ALLOWED)
                used |= places
                known = name == WRITER or places or (name, called) in MEMORY
                assert known, f"{name}: {function} calls {called}: {WRITER} writes files"
    assert used == set(ALLOWED), "a place that writes no more"


@pytest.mark.parametrize(
    ("line", "called"),
    [
        ("open(path, 'w')", "open"),
        ("open(path, mode=chosen)", "open"),
        ("path.open('ab')", "open"),
        ("Path(out).write_text(text)", "write_text"),
        ("figure.savefig(out)", "savefig"),
        ("np.savez(out, a=a)", "savez"),
        ("shutil.copyfile(a, out)", "copyfile"),
        ("os.replace(a, out)", "replace"),
    ],
)
def test_what_writes_is_seen(line: str, called: str) -> None:
    assert list(found(f"def save(out):\n    {line}\n")) == [("save", called)]


def test_what_reads_is_not() -> None:
    for line in ("open(path)", "path.open('rb')", "path.read_text()", "text.replace('a', 'b')"):
        assert not list(found(line)), line


def test_paths_here_are_there() -> None:
    assert all((CHECKOUT / Path(name)).is_file() for name, _ in [*ALLOWED, *MEMORY])

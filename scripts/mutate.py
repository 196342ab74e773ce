"""Plant bugs one at a time in a copy of the checkout, and name those that no test notices.

Exit status 1 if one survives, or if tests fail without any; the bugs are those of mutations.py.
"""

from __future__ import annotations

import argparse
import ast
import os
import random
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TypeVar

from mutations import MUTATIONS, Mutation

__all__ = ["main", "planted"]

CHECKOUT = Path(__file__).resolve().parents[1]
COPIED = ("derive", "generated", "runtime", "tests", "scripts", "docs", ".ci")
LAID_OUT = {"__init__.py": "runtime/face/__init__.py", "derive": "derive",
            "generated": "generated", "runtime": "runtime"}  # fmt: skip
_T = TypeVar("_T")
NOTICED, SURVIVED, TIMEOUT, BROKEN = "noticed", "SURVIVED", "timeout", "NO ANSWER"


def main() -> int:
    """Plant the chosen bugs and show what became of each."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--only", metavar="TEXT", help="bugs whose file and function contain it")
    parser.add_argument("--list", action="store_true", help="show the bugs and plant none")
    parser.add_argument("--seed", type=int, default=1, help="of the order")
    parser.add_argument(
        "--limit", type=float, default=900.0, help="seconds for the tests of a bug, at most"
    )
    parser.add_argument("--trust", action="store_true", help="do not run the tests without a bug")
    given = parser.parse_args()
    chosen = [each for each in MUTATIONS if (given.only or "") in str(each)]
    if given.list or not chosen:
        for each in chosen:
            told = f"  equivalent: {each.equivalent}" if each.equivalent else ""
            print(f"{each}{told}")
        return 0 if chosen else 2
    tried = [each for each in chosen if not each.equivalent]
    random.Random(given.seed).shuffle(tried)
    with tempfile.TemporaryDirectory(prefix="mutate-") as folder:
        copy = copied(Path(folder) / "checkout")
        kinds = () if given.trust else dict.fromkeys(each.tests for each in tried)
        limits = {tests: whole(copy, tests, given.limit) for tests in kinds}
        survivors = 0
        for number, each in enumerate(tried, 1):
            begun = time.perf_counter()
            limit = limits.get(each.tests, given.limit)
            found = BROKEN if limit is None else attempted(copy, each, limit)
            survivors += found in (SURVIVED, BROKEN)
            seconds = time.perf_counter() - begun
            print(f"{number:3}/{len(tried)} {found:9} {seconds:5.0f} s  {each}", flush=True)
    print(f"{len(tried) - survivors} of {len(tried)} bugs are noticed")
    return int(survivors > 0)


def copied(copy: Path) -> Path:
    """A checkout whose package is imported from itself, with the extensions that are built."""
    ignored = shutil.ignore_patterns("__pycache__")
    for name in COPIED:
        shutil.copytree(CHECKOUT / name, copy / name, ignore=ignored)
    for path in CHECKOUT.iterdir():
        if path.is_file():
            shutil.copy2(path, copy)
    (copy / "nonsmooth").mkdir()
    for name, place in LAID_OUT.items():
        (copy / "nonsmooth" / name).symlink_to(copy / place)
    return copy


def whole(copy: Path, tests: Sequence[str], limit: float) -> float | None:
    """Seconds that tests may take with a bug; None where they fail without one."""
    begun = time.perf_counter()
    if outcome(copy, tests, limit) != SURVIVED:
        print(f"no answer without a bug: pytest {' '.join(tests)}", flush=True)
        return None
    return min(limit, 2 * (time.perf_counter() - begun) + 60)


def attempted(copy: Path, mutation: Mutation, limit: float) -> str:
    """Plant a bug, run its tests, and make the copy what it was."""
    file = copy / mutation.file
    original = file.read_text(encoding="utf-8")
    built = [*(copy / "runtime").glob("_engine*.so")] if file.suffix == ".c" else []
    try:
        written(file, planted(original, mutation))
        if built:
            build(copy)
        return outcome(copy, mutation.tests, limit)
    except subprocess.CalledProcessError as problem:
        print(problem.stderr, file=sys.stderr)
        return BROKEN
    finally:
        written(file, original)
        for path in built:
            shutil.copy2(CHECKOUT / path.relative_to(copy), path)


def written(file: Path, text: str) -> None:
    """Write a module, and forget what was compiled of it: its size and second may be the same."""
    file.write_text(text, encoding="utf-8")
    for path in (file.parent / "__pycache__").glob(f"{file.stem}.*.pyc"):
        path.unlink()


def build(copy: Path) -> None:
    """Build the extensions of the copy in their places, and those alone whose source differs."""
    library = copy / "build"
    for path in copy.glob("*/*.so"):
        there = library / "nonsmooth" / path.relative_to(copy)
        if not there.exists():
            there.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(path, there)
    where = ["--build-lib", str(library)]
    command = [sys.executable, "setup.py", "-q", "build_ext", "--inplace", *where]
    subprocess.run(command, cwd=copy, check=True, capture_output=True, text=True)


def outcome(copy: Path, tests: Sequence[str], limit: float) -> str:
    """What tests say of the copy as it is."""
    with tempfile.TemporaryDirectory() as cache:  # what was derived with another bug is not used
        command = [sys.executable, "-m", "pytest", "-q", "-x", "-p", "no:cacheprovider", *tests]
        added = {"PYTHONPATH": str(copy), "NONSMOOTH_CACHE": cache, "OPENBLAS_NUM_THREADS": "1"}
        run = subprocess.Popen(
            command, cwd=copy, env={**os.environ, **added}, start_new_session=True,
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
        )  # fmt: skip
        try:
            code = run.wait(limit)
        except subprocess.TimeoutExpired:
            return TIMEOUT
        finally:
            if run.poll() is None:
                os.killpg(run.pid, signal.SIGKILL)
                run.wait()
    # a crash is noticed, and an error at import; tests that are not there notice nothing
    return {0: SURVIVED, 4: BROKEN, 5: BROKEN}.get(code, NOTICED)


def planted(text: str, mutation: Mutation) -> str:
    """The text of a file with a bug in it.

    Raises
    ------
    LookupError
        If the place is not there, or there more than once, or the bug changes nothing.
    """
    change = _planted_in_c if mutation.file.endswith(".c") else _planted_in_python
    return change(text, mutation)


def _planted_in_python(text: str, mutation: Mutation) -> str:
    tree = ast.parse(text)
    function: ast.AST = tree
    for name in filter(None, mutation.function.split(".")):
        function = _only(
            [n for n in ast.iter_child_nodes(function) if getattr(n, "name", "") == name],
            f"{name} in {mutation}",
        )
    wanted, kind = _fragment(mutation.before)
    place = _only(
        [n for n in ast.walk(function) if isinstance(n, kind) and _alike(n, wanted)], str(mutation)
    )
    assert place.end_lineno is not None
    assert place.end_col_offset is not None
    sizes = [len(line) for line in text.encode().splitlines(keepends=True)]
    begin = sum(sizes[: place.lineno - 1]) + place.col_offset
    end = sum(sizes[: place.end_lineno - 1]) + place.end_col_offset
    after = f"({mutation.after})" if kind is ast.expr else mutation.after
    source = text.encode()
    changed = (source[:begin] + after.encode() + source[end:]).decode()
    if ast.dump(ast.parse(changed)) == ast.dump(tree):
        raise LookupError(f"it changes nothing: {mutation}")
    return changed


def _fragment(text: str) -> tuple[ast.AST, type[ast.expr | ast.stmt]]:
    """An expression, or else a statement."""
    statement = ast.parse(text).body[0]
    if isinstance(statement, ast.Expr):
        return statement.value, ast.expr
    return statement, ast.stmt


def _alike(one: ast.AST, other: ast.AST) -> bool:
    return type(one) is type(other) and ast.dump(one) == ast.dump(other)


def _planted_in_c(text: str, mutation: Mutation) -> str:
    begin, end = _only([*_bodies(text, mutation.function)], f"{mutation.function} of {mutation}")
    pattern = r"\s+".join(map(re.escape, mutation.before.split()))
    place = _only([*re.finditer(pattern, text[begin:end])], str(mutation))
    changed = text[: begin + place.start()] + mutation.after + text[begin + place.end() :]
    if changed.split() == text.split():
        raise LookupError(f"it changes nothing: {mutation}")
    return changed


def _bodies(text: str, function: str) -> Iterator[tuple[int, int]]:
    """Where a function of that name is defined: its body ends with the first brace in a line."""
    for head in re.finditer(rf"^\w[\w \t*()]*\n?\b{function}\([^;{{]*\)\s*\{{", text, re.MULTILINE):
        yield head.end(), text.index("\n}", head.end())


def _only(found: Sequence[_T], what: str) -> _T:
    if len(found) != 1:
        raise LookupError(f"found {len(found)} times: {what}")
    return found[0]


if __name__ == "__main__":
    sys.exit(main())

"""Plant bugs one at a time in a copy of the checkout, and name those that no test notices.

A bug is a place in the syntax of a source; what it is given are files, folders, or addresses as
it shows them. Exit status 1 if one survives. `--diff | git apply` plants one in the checkout.
"""

from __future__ import annotations

import argparse
import difflib
import json
import math
import os
import random
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import astuple, dataclass
from pathlib import Path

from mutating import Place, functions, places, planted, probed

CHECKOUT = Path(__file__).resolve().parents[2]
COPIED = ("derive", "generated", "runtime", "tests", "scripts", "docs", ".ci")
LAID_OUT = {"__init__.py": "runtime/face/__init__.py", "derive": "derive",
            "generated": "generated", "runtime": "runtime"}  # fmt: skip
SOURCES = ("derive/**/*.py", "runtime/**/*.py", "runtime/engine/*.c")
ENGINE = ("events", "simulation", "shooting")  # rooms of tests that run what is compiled
PROBE = "__import__('probe').reach('{}::{{}}')"
PROBING = """import os
REACHED = set()
def reach(place):
    if place not in REACHED and "REACHED" in os.environ:
        REACHED.add(place)
        with open(os.environ["REACHED"], "a", encoding="utf-8") as file:
            file.write(place + "\\n")
"""
NOTICED, SURVIVED, TIMEOUT, BROKEN = "noticed", "SURVIVED", "timeout", "NO ANSWER"
UNREACHED = "UNREACHED"


@dataclass(frozen=True)
class Measured:
    """A file of tests, the time that it takes without a bug, and the functions that it runs."""

    file: str
    seconds: float
    reached: Sequence[str]


def main(arguments: Sequence[str] | None = None) -> int:
    """Plant the chosen bugs and show what became of each."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("targets", nargs="*", help="files, folders, addresses or their beginnings")
    parser.add_argument("--changed", metavar="REVISION", help="lines that differ from it")
    parser.add_argument("--only", action="append", metavar="OPERATOR", help="such as boundary")
    parser.add_argument("--sample", type=int, metavar="N", help="so many of them, by chance")
    parser.add_argument("--seed", type=int, default=1, help="of that chance, and of the order")
    parser.add_argument("--tests", nargs="+", metavar="FILE", help="instead of those of the rooms")
    parser.add_argument(
        "--limit", type=float, default=300.0, help="seconds for the tests of a bug, at most"
    )
    parser.add_argument(
        "--map", type=Path, metavar="FILE", help="what each file of tests runs, kept there"
    )
    parser.add_argument("--list", action="store_true", help="show the bugs and plant none")
    parser.add_argument("--diff", action="store_true", help="show them as changes of the files")
    given = parser.parse_args(arguments)
    bugs = chosen(given.targets, given.changed, given.only)
    random.Random(given.seed).shuffle(bugs)
    bugs = bugs[: given.sample]
    if given.list or given.diff:
        for each in sorted(bugs, key=lambda bug: (bug.file, bug.change.begin)):
            print(difference(each) if given.diff else each)
        return 0 if bugs else 2
    with tempfile.TemporaryDirectory(prefix="mutate-") as folder:
        copy = copied(Path(folder) / "checkout")
        tests = given.tests or sorted({test for bug in bugs for test in candidates(bug.file)})
        measured = measure(copy, tests, given.limit, given.map)
        outcomes = []
        for number, each in enumerate(bugs, 1):
            begun = time.perf_counter()
            outcomes.append(attempted(copy, each, measured, given.limit))
            seconds = time.perf_counter() - begun
            print(f"{number:3}/{len(bugs)} {outcomes[-1]:9} {seconds:5.0f} s  {each}", flush=True)
    noticed = sum(each in (NOTICED, TIMEOUT) for each in outcomes)
    print(f"{noticed} of {len(bugs) - outcomes.count(BROKEN)} bugs are noticed")
    return int(noticed < len(bugs))


def chosen(
    targets: Sequence[str] = (), revision: str | None = None, only: Sequence[str] | None = None
) -> list[Place]:
    """Bugs of the targets, or of all sources; of a revision given, those in lines that differ."""
    lines = None if revision is None else changed_lines(revision)
    bugs = []
    for path in sources(CHECKOUT):
        file = path.relative_to(CHECKOUT).as_posix()
        wanted = [each for each in targets if path.is_relative_to(CHECKOUT / each.split("::")[0])]
        if (targets and not wanted) or (lines is not None and file not in lines):
            continue
        for bug in places(file, path.read_text(encoding="utf-8")):
            inside = range(bug.line, bug.line + bug.before.count("\n") + 1)
            if (
                (not targets or any(_meant(each, bug) for each in wanted))
                and (lines is None or not lines[file].isdisjoint(inside))
                and (only is None or bug.change.operator in only)
            ):
                bugs.append(bug)
    return bugs


def sources(checkout: Path, suffix: str = "") -> list[Path]:
    """Files in which there are bugs."""
    paths = {path for pattern in SOURCES for path in checkout.glob(pattern)}
    return sorted(path for path in paths if path.name.endswith(suffix))


def _meant(target: str, bug: Place) -> bool:
    return "::" not in target or bug.address == target or bug.address.startswith(f"{target}::")


def changed_lines(revision: str) -> dict[str, set[int]]:
    """Lines of the checkout that a revision does not have, by file."""
    command = ["git", "diff", "-U0", "--no-color", "--no-ext-diff", "--relative", revision, "--"]
    told = subprocess.run(command, cwd=CHECKOUT, check=True, capture_output=True, text=True).stdout
    lines: dict[str, set[int]] = {}
    file = ""
    for line in told.splitlines():
        if line.startswith("+++ "):
            file = line[4:].removeprefix("b/")
        elif hunk := re.match(r"@@ \S+ \+(\d+)(?:,(\d+))? @@", line):
            begin, count = int(hunk[1]), int(hunk[2] or 1)
            lines.setdefault(file, set()).update(range(begin, begin + count))
    return lines


def difference(bug: Place) -> str:
    """A bug as a change of its file, which `git apply` makes."""
    text = (CHECKOUT / bug.file).read_text(encoding="utf-8")
    before, after = (each.splitlines(keepends=True) for each in (text, planted(text, bug)))
    return "".join(difflib.unified_diff(before, after, f"a/{bug.file}", f"b/{bug.file}"))


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


def candidates(file: str) -> Iterator[str]:
    """Files of tests that may run a source: those of its room, and others that name it."""
    room = file.split("/")[file.startswith("runtime/")]
    rooms = ENGINE if room == "engine" else (room,)
    for path in sorted((CHECKOUT / "tests").rglob("test_*.py")):
        if path.parent.name in rooms or named(file, path):
            yield path.relative_to(CHECKOUT).as_posix()


def named(file: str, tests: Path) -> bool:
    """Whether a file of tests names a module."""
    module = "nonsmooth." + file.removesuffix(".py").replace("/", ".")
    room, _, name = module.rpartition(".")
    pattern = rf"{re.escape(module)}\b|from {re.escape(room)} import [^\n]*\b{name}\b"
    return re.search(pattern, tests.read_text(encoding="utf-8")) is not None


def measure(copy: Path, tests: Iterable[str], limit: float, kept: Path | None) -> list[Measured]:
    """Time and functions of each file of tests, run by itself without a bug.

    A file that fails or exceeds the limit counts as taking for ever.
    """
    known: dict[str, Measured] = {}
    if kept is not None and kept.exists():
        known = {each[0]: Measured(*each) for each in json.loads(kept.read_text(encoding="utf-8"))}
    missing = [test for test in tests if test not in known]
    if missing:
        (copy / "probe.py").write_text(PROBING, encoding="utf-8")
        texts = {path: path.read_text(encoding="utf-8") for path in sources(copy, ".py")}
        for path, text in texts.items():
            written(path, probed(text, PROBE.format(path.relative_to(copy).as_posix())))
        for test in missing:
            begun = time.perf_counter()
            with tempfile.NamedTemporaryFile("r", encoding="utf-8") as reached:
                result = outcome(copy, [test], limit, REACHED=reached.name)
                lines = reached.read().splitlines()
            seconds = time.perf_counter() - begun if result == SURVIVED else math.inf
            known[test] = Measured(test, seconds, lines)
            if kept is not None:
                kept.write_text(json.dumps([*map(astuple, known.values())]), encoding="utf-8")
            print(f"{seconds:5.0f} s  {result:9} without a bug: {test}", flush=True)
        for path, text in texts.items():
            written(path, text)
    return [known[test] for test in tests]


def attempted(copy: Path, bug: Place, measured: Sequence[Measured], limit: float) -> str:
    """Outcome of the tests that reach a planted bug; the copy is restored afterwards.

    What survives the other tests is tried with the slow ones of the same files.
    """
    file = copy / bug.file
    compiled = file.suffix == ".c"
    original = file.read_text(encoding="utf-8")
    inside = not compiled and bug.change.function in functions(original)
    place = f"{bug.file}::{bug.change.function if inside else ''}"
    reaching = [each for each in measured if compiled or place in each.reached]
    reaching.sort(key=lambda each: (not named(bug.file, CHECKOUT / each.file), each.seconds))
    seconds, tests = 0.0, []
    for each in reaching:
        if seconds + each.seconds <= limit:
            seconds += each.seconds
            tests.append(each.file)
    if not tests:
        return UNREACHED
    built = [*(copy / "runtime").glob("_engine*.so")] if compiled else []
    try:
        written(file, planted(original, bug))
        if built:
            build(copy)
        result = outcome(copy, tests, 2 * seconds + 60)
        if result == SURVIVED and outcome(copy, tests, limit, "-m", "slow") == NOTICED:
            return NOTICED
        return result
    except subprocess.CalledProcessError as problem:
        print(problem.stderr, file=sys.stderr)
        return BROKEN
    finally:
        written(file, original)
        for path in built:
            shutil.copy2(CHECKOUT / path.relative_to(copy), path)


def written(file: Path, text: str) -> None:
    """Write a module and delete its compiled file, whose size and second may still fit."""
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


def outcome(
    copy: Path, tests: Sequence[str], limit: float, *options: str, **environment: str
) -> str:
    """Verdict of the tests on the copy as it is; `options` are those of pytest."""
    with tempfile.TemporaryDirectory() as cache:  # what was derived with another bug is not used
        command = [sys.executable, "-m", "pytest", "-q", "-x", "-p", "no:cacheprovider"]
        command += ["--hypothesis-seed=0", *options, *tests]
        added = {"PYTHONPATH": str(copy), "NONSMOOTH_CACHE": cache, "OPENBLAS_NUM_THREADS": "1"}
        run = subprocess.Popen(
            command, cwd=copy, env={**os.environ, **added, **environment}, start_new_session=True,
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


if __name__ == "__main__":
    sys.exit(main())

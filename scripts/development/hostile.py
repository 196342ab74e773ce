"""Run hostile commands within limits of time and memory, and sort what comes of them.

Each is refused in one line, or answered. Exit status 1 if one ends in a traceback or says more
than one line, hangs, or leaves something behind; those are printed with what makes them again.
"""

from __future__ import annotations

import argparse
import contextlib
import io
import os
import random
import re
import resource
import shutil
import signal
import stat
import sys
import tempfile
import time
from collections import Counter
from dataclasses import dataclass
from pathlib import Path

from hostile_files import damage, make_devices, make_files
from hostile_inputs import Case, cases

from nonsmooth.runtime.core import workload

SECONDS, SLOW, WALL = 40, 120, 200  # of processors, the same of `reproduce`, of the clock
LONGEST = 4 / 3600  # hours that a work may take unasked, by estimate
MEMORY = 6_000_000_000  # bytes
_ALLOWED = re.compile(
    r"(zarr\.lock|\.pyc|__pycache__)$"
)  # that a command may leave where it is refused


@dataclass(frozen=True)
class Outcome:
    """The group of a case, its exit code, and what it wrote to stderr."""

    group: str
    code: int
    said: str


def main() -> int:
    """Run the cases and show how many are in each group."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=3000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", type=int, help="the case of this number alone")
    parser.add_argument("--part", default="1/1", help="K/N: every N-th case, from the K-th on")
    given = parser.parse_args()
    part, parts = map(int, given.part.split("/"))
    groups: Counter[str] = Counter()
    with tempfile.TemporaryDirectory(prefix="hostile") as folder:
        template = prepared(Path(folder))
        for case in cases(given.count, given.seed):
            if given.only not in (None, case.seed) or case.seed % parts != part - 1:
                continue
            outcome = run_case(case, template)
            groups[outcome.group] += 1
            if outcome.group not in ("refused", "answered") or given.only is not None:
                words = [w if len(w) < 80 else f"{w[:40]}...{len(w)}" for w in case.arguments]
                print(f"{outcome.group} ({outcome.code}) --only {case.seed}: {words!a}")
                print(f"    damaged {case.damaged}: {outcome.said[-600:]!a}", flush=True)
    for group, number in sorted(groups.items()):
        print(f"{group:12} {number}")
    return int(bool(set(groups) - {"refused", "answered"}))


def prepared(folder: Path) -> Path:
    """Make the files that cases are given, and have everything imported that commands need."""
    template = folder / "template"
    template.mkdir()
    workload.HOURS = LONGEST
    os.environ["NONSMOOTH_CACHE"] = str(folder / "cache")
    os.environ["COLUMNS"] = "200"
    make_files(template)
    for arguments in (["plot", "orbit.json"], ["solve", "mine.py:loop"], ["list"]):
        run_case(Case(tuple(arguments), (), 0), template)
        code, _ = _called(arguments, template)
        assert code == 0, arguments
    (template / "orbit.png").unlink()
    return template


def run_case(case: Case, template: Path) -> Outcome:
    """Run a case in a process of its own, forked from this one, in a folder of its own."""
    with tempfile.TemporaryDirectory(prefix="case", dir=template.parent) as place:
        folder = Path(place, "in")
        shutil.copytree(template, folder, copy_function=_copied)
        draw = random.Random(case.seed)
        own = {each.name for each in template.iterdir()}
        for name in case.damaged:
            if name in own:  # never what a name such as "/" leads to
                damage(folder / name, draw)
        make_devices(folder)
        before = _listed(folder)
        said = Path(place, "said")
        printed = Path(place, "printed")
        process = os.fork()
        if process == 0:
            _child(case, folder, printed, said)
        code = _awaited(process)
        text = said.read_text(errors="backslashreplace")
        declared = any("bad_" in word or "odd_" in word for word in case.arguments)
        group = _group(code, text, printed.stat().st_size, declared=declared)
        if group in ("refused", "answered"):
            after = _listed(folder)
            refused = group == "refused" and code == 2
            changed = _left(before, after, refused=refused, beside=".." in case.arguments)
            if changed:
                group, text = "left behind", f"{changed}: {text}"
        for root, folders, _ in os.walk(place):
            for each in folders:
                os.chmod(os.path.join(root, each), 0o700)
        return Outcome(group, code, text)


def _copied(source: str, target: str) -> None:
    """Copy a file; a result file, which no command writes in place, is linked instead."""
    (os.link if source.endswith((".json", ".npz", ".csv")) else shutil.copyfile)(source, target)


def _child(case: Case, folder: Path, printed: Path, said: Path) -> None:
    """Run the command and exit, whatever happens."""
    code = 70
    try:
        os.setsid()
        seconds = SLOW if case.arguments[0] == "reproduce" else SECONDS
        resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 2))
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        os.dup2(os.open(os.devnull, os.O_RDONLY), 0)
        os.dup2(os.open(printed, os.O_WRONLY | os.O_CREAT), 1)
        os.dup2(os.open(said, os.O_WRONLY | os.O_CREAT), 2)
        sys.stdout, sys.stderr = map(_stream, (1, 2))
        os.chdir(folder)
        code = _command(list(case.arguments))
        sys.stdout.flush()
        sys.stderr.flush()
    except BaseException:
        import traceback

        traceback.print_exc()
        sys.stderr.flush()
    finally:
        os._exit(code)


def _stream(number: int) -> io.TextIOWrapper:
    raw = io.FileIO(number, "w", closefd=False)
    return io.TextIOWrapper(io.BufferedWriter(raw), "utf-8", "backslashreplace", write_through=True)


def _command(arguments: list[str]) -> int:
    from nonsmooth.runtime.cli.program import main as commanded

    before, sys.argv = sys.argv, ["nonsmooth", *arguments]
    try:
        commanded()
    except SystemExit as ended:
        return ended.code if isinstance(ended.code, int) else 70
    finally:
        sys.argv = before
    return 0


def _called(arguments: list[str], folder: Path) -> tuple[int, str]:
    before, text = Path.cwd(), io.StringIO()
    os.chdir(folder)
    try:
        with contextlib.redirect_stdout(text), contextlib.redirect_stderr(text):
            return _command(arguments), text.getvalue()
    finally:
        os.chdir(before)


def _awaited(process: int) -> int:
    """Exit code of a child; minus the signal that ended it, -9 if its time was over."""
    end = time.monotonic() + WALL
    pause = 0.002
    while True:
        ended, status = os.waitpid(process, os.WNOHANG)
        if ended:
            return os.waitstatus_to_exitcode(status)
        if time.monotonic() > end:
            os.killpg(process, signal.SIGKILL)
            os.waitpid(process, 0)
            return -signal.SIGKILL
        time.sleep(pause)
        pause = min(2 * pause, 0.05)


def _group(code: int, said: str, printed: int, *, declared: bool) -> str:
    """The group of an outcome; output of a declaration on stderr is allowed for."""
    lines = said.splitlines()
    if code in (-signal.SIGKILL, -signal.SIGXCPU):
        return "hang"
    if code < 0 or code not in (0, 1, 2, 3) or "Traceback" in said or "internal error" in said:
        return "traceback"
    told = [line for line in lines if line.startswith("nonsmooth: ")]
    if len(told) > 1 or (code == 2 and lines[-1:] != told):
        return "traceback"
    if code == 2 and not lines[-1].startswith("nonsmooth: error: no picture: "):
        return "refused" if len(lines) == 1 or declared else "traceback"
    return "answered" if printed or told else "traceback"


_PIECE = re.compile(r"(^|/)\.[^/]+\.[0-9a-f]{8,}$|\.partial$")  # a file that is being written
Listing = dict[str, tuple[int, int, int]]


def _listed(folder: Path) -> Listing:
    """Kind, size and time of all that is in a folder and beside it."""
    found = {}
    for root, folders, names in os.walk(folder.parent):
        for name in (*folders, *names):
            path = os.path.join(root, name)
            state = os.lstat(path)
            kind = stat.S_IFMT(state.st_mode)
            file = kind == stat.S_IFREG
            found[os.path.relpath(path, folder)] = (
                kind,
                state.st_size if file else 0,
                state.st_mtime_ns if file else 0,
            )
    return {name: kind for name, kind in found.items() if name not in ("../said", "../printed")}


def _left(
    before: dict[str, tuple[int, int, int]],
    after: dict[str, tuple[int, int, int]],
    *,
    refused: bool,
    beside: bool,
) -> list[str]:
    """What a command left behind: parts of files, or anything if it was refused.

    What is beside its folder counts, unless the command was told to write there.
    """
    changed = [
        name for name in after if after[name] != before.get(name) and not _ALLOWED.search(name)
    ]
    gone = [name for name in before if name not in after]
    special = [name for name in changed if name in before and before[name][0] != after[name][0]]
    if refused:
        return [*changed, *gone]
    outside = [] if beside else [name for name in changed if name.startswith("../")]
    pieces = [name for name in changed if _PIECE.search(name)]
    return [*special, *pieces, *outside, *gone]


if __name__ == "__main__":
    sys.exit(main())

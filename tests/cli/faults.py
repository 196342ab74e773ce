"""Faults at the instant when a command has written its file beside its place.

Run as a script in a folder, with command lines in JSON. Each command does its work once. When
it brings the first content to the disk, the process forks, and is killed. Then it does its work
again, and a second process does the same, in the same place, at that instant. What each ends with
and leaves is printed.
"""

import json
import os
import shlex
import signal
import sys
import traceback
from importlib import import_module
from pathlib import Path
from runpy import run_module

from nonsmooth.runtime.present.paper import writing

# the reproduction without its work of a minute
writing._contents = lambda *_, **__: {"report.html": b"report", "results.json": b"{}"}


def main():
    """Run the command line."""
    run_module("nonsmooth", run_name="__main__")


def kill():
    """End the process at once."""
    os.kill(os.getpid(), signal.SIGKILL)


def twice():
    """Another process does the same, and is done first."""
    os.fsync = FSYNC
    process = os.fork()
    if not process:
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
        code = 99
        try:
            main()
        except SystemExit as end:
            code = int(end.code or 0)
        finally:
            os._exit(code)
    if told(process) not in (0, 1):
        raise AssertionError("the second process did not write")


FSYNC = os.fsync


def contents():
    """All files here, and folders as such."""
    return {
        str(path): "" if path.is_dir() else path.read_bytes().hex() for path in Path().rglob("*")
    }


def told(process):
    """The exit code of a process, or the number of its signal, negative."""
    return os.waitstatus_to_exitcode(os.waitpid(process, 0)[1])


def try_fault(command, name, fault):
    """Run a command up to its first file, and a fault from there."""
    before = contents()

    def at_the_disk(descriptor):
        process = os.fork()
        if not process:
            os.dup2(os.open(os.devnull, os.O_WRONLY), 2)
            fault()
            return
        code, after = told(process), contents()
        changed = [file for file in {*before, *after} if before.get(file) != after.get(file)]
        print(json.dumps({"fault": name, "code": code, "changed": changed}), flush=True)
        for path, content in before.items():
            if after.get(path) != content:
                Path(path).write_bytes(bytes.fromhex(content))
        os._exit(0)

    os.fsync = at_the_disk
    sys.argv = ["nonsmooth", *shlex.split(command)]
    code = 99
    try:
        main()
    except SystemExit as end:
        code = int(end.code or 0)
    except BaseException:
        traceback.print_exc()
    sys.stderr.flush()
    os._exit(code)


if __name__ == "__main__":
    for module in ("matplotlib.figure", "zarr", "scipy.optimize", "nonsmooth.derive.systems"):
        import_module(module)  # once, not in each process
    for line in json.loads(sys.argv[1]):
        # the lock of a chart keeps a second process away: tests/explore/test_chart.py
        for name, fault in (("kill", kill), ("twice", twice))[: 2 - line.startswith("chart ")]:
            sys.stdout.flush()
            worker = os.fork()
            if not worker:
                try_fault(line, name, fault)
            if told(worker):
                sys.exit(f"{line}: it came to no file")

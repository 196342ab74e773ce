"""Run the listed commands and record what they answer: ``python -m tests.golden.record``."""

import json
import os
import shlex
import shutil
import sys
import tempfile
from contextlib import chdir
from pathlib import Path

from typer.testing import CliRunner

from nonsmooth.runtime.cli.program import app
from tests.golden.comparing import differences
from tests.places import GALLERY

HERE = Path(__file__).parent
ANSWERS = HERE / "answers.json"
LONG, LONG_ENTRIES = 16, 4  # lists of numbers or words, and of lists or objects
# of what an optimiser answers: where it arrives, not how (steps, evaluations, what they leave)
ARRIVED = {
    "fit": (
        "error", "names", "estimates", "standard_errors", "bounds", "at_bound", "priors", "data",
        "degrees_of_freedom", "loss", "unidentified", "status", "same_sequence",
    ),
    "design": (
        "error", "aim", "quantity", "parameters", "bounds", "conditions", "after", "active",
        "corner", "status",
    ),
}  # fmt: skip


def commands():
    """Give the commands that are recorded, in the order in which they run."""
    lines = (HERE / "commands.txt").read_text().splitlines()
    return [line for line in lines if line and not line.startswith("#")]


def answers(listed, folder):
    """Run commands in a folder that holds the gallery, and give what each of them answers.

    An answer has the exit code, the message on stderr, and of the JSON document on stdout what
    a person looks at: of optimisations what `ARRIVED` names, of long lists the ends.
    """
    for file in (*GALLERY.glob("*.py"), *GALLERY.glob("*.csv")):
        shutil.copy(file, folder)
    with chdir(folder):
        for command in listed:
            arguments = shlex.split(command)
            result = CliRunner().invoke(app, arguments)
            if result.exception is not None and not isinstance(result.exception, SystemExit):
                raise result.exception
            told = result.stdout.replace(f"{folder}{os.sep}", "")
            yield {
                "command": command,
                "code": result.exit_code,
                "error": result.stderr if result.exit_code else "",
                "answer": _looked_at(arguments[0], json.loads(told)) if told else None,
            }


def _looked_at(command, answer):
    """The part of a JSON document that is recorded."""
    named = ARRIVED.get(command, tuple(answer))
    return _shortened({name: value for name, value in answer.items() if name in named})


def _shortened(value):
    """A JSON value with the length and the ends of each long list in its place."""
    if isinstance(value, dict):
        return {name: _shortened(entry) for name, entry in value.items()}
    if not isinstance(value, list):
        return value
    long = LONG_ENTRIES if any(isinstance(entry, dict | list) for entry in value) else LONG
    if len(value) <= long:
        return [_shortened(entry) for entry in value]
    return {"length": len(value), "first": _shortened(value[0]), "last": _shortened(value[-1])}


def main():
    """Write the answers, or with ``--exact`` show where they differ from what is recorded."""
    recorded = {entry["command"]: entry for entry in json.loads(ANSWERS.read_text())}
    entries, found = [], 0
    with tempfile.TemporaryDirectory() as folder:
        for entry in answers(commands(), Path(folder)):
            entries.append(json.loads(json.dumps(entry)))
            print(entry["command"], file=sys.stderr)
            for line in differences(recorded.get(entry["command"]), entries[-1], 0.0):
                found += 1
                print(f"  {line}")
    if "--exact" in sys.argv:
        sys.exit(found > 0)
    ANSWERS.write_text(json.dumps(entries, indent=0, ensure_ascii=False) + "\n")


if __name__ == "__main__":
    main()

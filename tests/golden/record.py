"""Run the listed commands and record what they answer: ``python -m tests.golden.record``."""

import json
import os
import shlex
import shutil
import sys
import tempfile
from collections.abc import Iterator
from contextlib import chdir
from pathlib import Path
from typing import Any

from typer.testing import CliRunner

from nonsmooth.runtime.cli.program import app
from tests.golden.comparing import differences
from tests.places import GALLERY

HERE = Path(__file__).parent
ANSWERS = HERE / "answers.json"
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


def commands() -> list[str]:
    """Give the commands that are recorded, in the order in which they run."""
    lines = (HERE / "commands.txt").read_text().splitlines()
    return [line for line in lines if line and not line.startswith("#")]


def answers(listed: list[str], folder: Path) -> Iterator[dict[str, Any]]:
    """Run commands in a folder that holds the gallery, and give what each of them answers.

    An answer has the exit code, the JSON document on stdout, the message on stderr and the
    JSON file that the command saved. Of optimisations it has what `ARRIVED` names.
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
            saved = arguments[arguments.index("--save") + 1] if "--save" in arguments else None
            yield {
                "command": command,
                "code": result.exit_code,
                "error": result.stderr if result.exit_code else "",
                "answer": _arrived(arguments[0], json.loads(told)) if told else None,
                "saved": _read(Path(saved), folder) if saved else None,
            }


def _arrived(command: str, answer: Any) -> Any:
    named = ARRIVED.get(command)
    return answer if named is None else {n: x for n, x in answer.items() if n in named}


def _read(file: Path, folder: Path) -> Any:
    return json.loads(file.read_text().replace(f"{folder}{os.sep}", ""))


def main() -> None:
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

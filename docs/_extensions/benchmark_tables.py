"""Show what ``scripts/benchmark.py --save`` measured: ``{benchmark-tables} FILE.json``."""

import json
from collections.abc import Iterator
from pathlib import Path
from statistics import median
from typing import Any

from docutils.nodes import Node
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective

UNITS = ((1.0, "s"), (1e-3, "ms"), (1e-6, "µs"), (1e-9, "ns"))


class BenchmarkTables(SphinxDirective):
    """A section with the machine and a table for each part of the benchmark."""

    required_arguments = 1

    def run(self) -> list[Node]:
        """Read the file, on which the page then depends."""
        _, path = self.env.relfn2path(self.arguments[0])
        self.env.note_dependency(path)
        measured = json.loads(Path(path).read_text("utf-8"))
        text, before = [], ""
        for part in measured.values():
            told = machine_told(part["machine"])
            text += section_lines(part, told if told != before else "")
            before = told
        return self.parse_text_to_nodes("\n".join(text), allow_section_headings=True)


def machine_told(machine: dict[str, Any]) -> str:
    """Say in one line on what was measured."""
    versions = ", ".join(f"{name} {number}" for name, number in machine["versions"].items())
    return (
        f"{machine['processor']}, {machine['cores']} cores; {machine['system']},"
        f" {machine['compiler']}, Python {machine['python']}, {versions}."
    )


def section_lines(part: dict[str, Any], told: str) -> Iterator[str]:
    """Write one part in MyST, with what is told of the machine."""
    rows = part["rows"]
    medians = {row["what"]: median(row["seconds"]) for row in rows}
    yield from (f"## {part['about'].rstrip('.')}", "", told, "")
    yield from (f"Load {part['machine']['load']}.", "")
    found = any(row.get("found") for row in rows)
    yield "| what | median | from – to | peer / ours |" + " what was found |" * found
    yield "| --- | --- | --- | --- |" + " --- |" * found
    for row in rows:
        least, most = min(row["seconds"]), max(row["seconds"])
        ratio = f"{medians[row['what']] / medians[row['against']]:,.2f}" if row["against"] else ""
        spread = f"{duration(least)} – {duration(most)}"
        line = f"| {row['what']} | {duration(medians[row['what']])} | {spread} | {ratio} |"
        yield line + f" {row.get('found', '')} |" * found
    yield ""


def duration(seconds: float) -> str:
    """Write a duration with a fitting unit and three digits."""
    size, unit = next(((s, u) for s, u in UNITS if seconds >= s), UNITS[-1])
    return f"{seconds / size:.3g}\N{NO-BREAK SPACE}{unit}"


def setup(app: Sphinx) -> dict[str, bool]:
    """Register the directive."""
    app.add_directive("benchmark-tables", BenchmarkTables)
    return {"parallel_read_safe": True, "parallel_write_safe": True}

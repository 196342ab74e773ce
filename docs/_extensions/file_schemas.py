"""Show what the files of results hold, from their JSON Schemas: ``{file-schemas}``."""

import json
from collections.abc import Iterator, Mapping
from typing import Any

from docutils.nodes import Node
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective

from nonsmooth.runtime.present.files.loading import file_schemas


class FileSchemas(SphinxDirective):
    """A section for each kind of file: its entries, and the whole schema."""

    def run(self) -> list[Node]:
        """Ask the package, whose records' annotations are the schemas."""
        lines = [line for schema in file_schemas().values() for line in section_lines(schema)]
        return self.parse_text_to_nodes("\n".join(lines), allow_section_headings=True)


def section_lines(schema: Mapping[str, Any]) -> Iterator[str]:
    """Write one kind of file in MyST."""
    yield from (f"## {schema['title']}", "", f"A {schema['description']}.", "")
    yield from ("| entry | what it is |", "| --- | --- |")
    for name, entry in schema["properties"].items():
        optional = "" if name in schema["required"] else ", may be missing"
        yield f"| `{name}` | {words(entry)}{optional} |"
    yield from ("", "::::{dropdown} JSON Schema", "```json")
    yield from json.dumps(schema, indent=1).splitlines()
    yield from ("```", "::::", "")


def words(entry: Mapping[str, Any]) -> str:
    """Say in a few words what an entry may be."""
    match entry:
        case {"const": value}:
            return "null" if value is None else f"`{json.dumps(value)}`"
        case {"enum": values}:
            return " or ".join(f"`{json.dumps(value)}`" for value in values)
        case {"anyOf": ways}:
            return " or ".join(map(words, ways))
        case {"$ref": reference}:
            return f"an object, `{reference.rpartition('/')[2]}`"
        case {"items": inner}:
            return f"a list; each is {words(inner)}"
        case {"prefixItems": parts}:
            return f"a list of {len(parts)}"
        case {"type": "object", "additionalProperties": dict() as inner}:
            return f"an object with any names; each entry is {words(inner)}"
        case {"type": "string", "pattern": _}:
            return "a number as text"
        case {"type": kind}:
            return {"string": "a text", "object": "an object"}.get(kind, f"JSON's {kind}")
    return "what a file of its own holds"


def setup(app: Sphinx) -> dict[str, bool]:
    """Add the directive."""
    app.add_directive("file-schemas", FileSchemas)
    return {"parallel_read_safe": True, "parallel_write_safe": True}

"""The shapes of files as the checker has them: `python -m tests.file_shapes` writes them anew."""

import json

from nonsmooth.runtime.checker import CHECKS
from nonsmooth.runtime.present.files.loading import file_schemas
from tests.places import CHECKOUT

KEPT = CHECKOUT / "runtime" / "checker" / "stated" / "files.json"
_TEXTS = ("$schema", "$defs", "title", "description")  # told to people


def file_shapes():
    """What the annotations of the records of proofs give, by format and record."""
    found = {}
    for name in CHECKS:
        schema = file_schemas()[name]
        for other, own in schema["$defs"].items():
            assert found.setdefault(other, own) == own
        found[name] = {key: value for key, value in schema.items() if key not in _TEXTS}
    for shape in found.values():
        for name in ("declaration", "closing"):
            if name in shape.get("properties", ()):
                shape["properties"][name] = {"$ref": f"#/$defs/{name}"}
    return found


if __name__ == "__main__":
    lines = (f"{json.dumps(name)}: {json.dumps(own)}" for name, own in file_shapes().items())
    KEPT.write_text("{\n" + ",\n".join(lines) + "\n}\n")

"""What the files hold, entry by entry: what is missing, unknown or of another type is refused.

The shapes are data, in JSON Schema: those of files are what the annotations of their records give,
that of a declaration, which no record holds, is written by hand.
"""

import hashlib
import json
import math
import re
from collections.abc import Iterable
from functools import cache
from pathlib import Path
from typing import Any

from nonsmooth.runtime.checker.stated.exact import Entries, Failure, demand


class Malformed(Failure):
    """An entry of a file is missing, unknown, or of another type."""


_WRONG: tuple[str, ...] = ("is of the wrong type",)
_FEWEST, _MOST = 53, 400_000  # bits
_MOST_TO_DIGIT = 8  # bits: a box is as wide as half of them at most, which are 6.6 to a digit
_TYPES: dict[str, Any] = {
    "string": str,
    "integer": int,
    "boolean": bool,
    "array": list,
    "object": dict,
}


@cache
def _shapes() -> dict[str, dict[str, Any]]:
    """The shapes by name, those of files by their formats."""
    texts = (Path(__file__).with_name(name) for name in ("files.json", "declarations.json"))
    files, declarations = (json.loads(text.read_text(encoding="utf-8")) for text in texts)
    found: dict[str, dict[str, Any]] = {**files, **declarations}
    return found


def check_file(content: Any, name: str) -> None:
    """Raise `Malformed` if the entries of a file, read from JSON, are not those of its format.

    The message says where what is wrong. `Failure` is raised if the checksum differs.
    """
    if found := _misfit(content, _shapes()[name]):
        wrong, *places = found
        raise Malformed(f"{' of '.join([*places, 'the file'])} {wrong}")
    covered = {key: value for key, value in content.items() if key != "sha256"}
    digest = hashlib.sha256(json.dumps(covered, sort_keys=True).encode()).hexdigest()
    demand(content["sha256"] == digest, "edited or damaged: the checksum differs")


def check_bits(content: Entries) -> int:
    """Return the bits of precision that the file states; `Malformed` if too few or too many."""
    bits: int = content["bits"]
    if not _FEWEST <= bits <= _MOST:
        raise Malformed(f"{bits} bits are not from {_FEWEST} to {_MOST}")
    return bits


def check_sharp(box: list[dict[str, str]], bits: int) -> None:
    """Refuse more bits than the digits of a box of unknowns can use: they would only take time.

    `box` has a "mid" for each unknown. `Failure` is raised if the bits are too many.
    """
    digits = max((len(side["mid"]) for side in box), default=0)
    if bits > _MOST_TO_DIGIT * digits + _FEWEST:
        raise Failure(f"{bits} bits are more than the {digits} digits of its unknowns are for")


def _named(shape: dict[str, Any]) -> dict[str, Any]:
    """Return a shape, that of its name if it is named."""
    found: dict[str, Any] = (
        _shapes()[shape["$ref"].rpartition("/")[2]] if "$ref" in shape else shape
    )
    return found


def _apart(entry: Any, shape: dict[str, Any]) -> float:
    """By how many names an entry differs from a shape; infinity where one of them has none."""
    names = _named(shape).get("properties")
    return len(entry.keys() ^ names) if isinstance(entry, dict) and names else math.inf


def _is(entry: Any, value: Any) -> bool:
    return type(entry) is type(value) and bool(entry == value)


def _misfit(entry: Any, shape: dict[str, Any]) -> tuple[str, ...]:
    """Return what is wrong with an entry, then where, from the inside out; () if nothing is."""
    shape = _named(shape)
    if "anyOf" in shape:
        if any(not _misfit(entry, each) for each in shape["anyOf"]):
            return ()
        return _misfit(entry, min(shape["anyOf"], key=lambda each: _apart(entry, each)))
    values = shape.get("enum", [shape["const"]] if "const" in shape else [])
    kind = shape.get("type", "")
    if values or not kind:
        return () if not values or any(_is(entry, value) for value in values) else _WRONG
    if kind == "number":
        fits = type(entry) is int or (type(entry) is float and math.isfinite(entry))
        return () if fits else _WRONG
    if type(entry) is not _TYPES[kind] or kind in ("integer", "boolean"):
        return () if type(entry) is _TYPES[kind] else _WRONG
    if kind == "string":
        return () if re.fullmatch(shape.get("pattern", ".*"), entry, re.DOTALL) else _WRONG
    parts: Iterable[tuple[Any, Any, Any]] = ()
    if kind == "array":
        shapes = shape.get("prefixItems") or [shape["items"]] * len(entry)
        if len(shapes) != len(entry):
            return _WRONG
        parts = zip(range(1, len(entry) + 1), entry, shapes, strict=True)
    else:
        known, others = shape.get("properties", {}), shape.get("additionalProperties")
        for name in sorted(entry.keys() ^ known) if others is False else ():
            if name in entry or name in shape["required"]:
                return "is missing" if name in known else "is unknown", repr(name)
        parts = ((name, part, known.get(name, others)) for name, part in entry.items()
                 if name in known or others)  # fmt: skip
    for place, part, inner in parts:
        if found := _misfit(part, inner):
            return *found, repr(place) if isinstance(place, str) else f"entry {place}"
    return ()

"""Found orbits as named itineraries in the file that declares their system."""

from __future__ import annotations

import secrets
from collections.abc import Sequence
from pathlib import Path
from pprint import pformat
from textwrap import indent
from typing import Any

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.files import check_target, unwritable, write_file
from nonsmooth.runtime.explore.finding.find import Found
from nonsmooth.runtime.model.loading.declared import declaration_in
from nonsmooth.runtime.orbits.orbit import Orbit
from nonsmooth.runtime.present.files.named_entries import declared_table

_STEM = "found"
_WIDTH = 92


def check_declaration(system: str, path: Path) -> None:
    """Raise `InputError` unless `path` is the file that declares the system, and can be written."""
    if not (path.suffix == ".py" and path.is_file() and Path(system).is_file()):
        raise InputError(f"{path} is not the FILE.py that declares {system}")
    if not path.samefile(system):
        raise InputError(f"{path} is not the file that declares the system: that is {system}")
    check_target(path)


def write_itineraries(found: Found, path: Path) -> tuple[str, ...]:
    """Append the orbits that were found to the file that declares their system; give their names.

    The names are found-1, found-2, ..., those that are free. An orbit that reaches no
    boundary has no itinerary to declare, and is left out. The file is replaced once its new
    content has been executed and declares all others. `InputError` is raised if no orbit
    reaches a boundary, or if the file is another one, cannot be written, or would not
    declare them.
    """
    check_declaration(found.system, path)
    orbits = [e.orbit for e in found.orbits if not e.orbit.tables.cycle.uninterrupted]
    if not orbits:
        raise InputError(f"no orbit that reaches a boundary was found: {path} stays as it is")
    known = [orbit.name for orbit in declaration_in(path).orbits]
    names = _free_names(known, len(orbits))
    text = path.read_text(encoding="utf-8")
    content = (text.rstrip() + "\n" + _text(names, orbits, bool(known))).encode()
    if [orbit.name for orbit in _declared_by(content, path)] != [*known, *names]:
        raise InputError(f"{path} would not declare what is appended to it: it stays as it is")
    write_file(path, content)
    return names


def _free_names(known: Sequence[str], count: int) -> tuple[str, ...]:
    """As many names as wanted that no orbit has, numbered on from the largest number."""
    numbers = [name.removeprefix(f"{_STEM}-") for name in known]
    last = max((int(number) for number in numbers if number.isdecimal()), default=0)
    return tuple(f"{_STEM}-{last + k + 1}" for k in range(count))


def _text(names: Sequence[str], orbits: Sequence[Orbit], more: bool) -> str:
    """Python source that declares itineraries, to be put behind the existing ones."""
    entries = "".join(
        _entry(name, declared_table(orbit)) for name, orbit in zip(names, orbits, strict=True)
    )
    before = "    *orbits,\n" if more else ""
    return (
        "\nfrom nonsmooth.derive import Itinerary, Reference\n\n"
        f"# appended by `nonsmooth find`\norbits = [\n{before}{entries}]\n"
    )


def _entry(name: str, table: dict[str, Any]) -> str:
    states = {unknown: state for state, unknown in table["start"].items()}
    reference = table["reference"]
    guess = {states.get(name, name): text for name, text in reference["guess"].items()}
    numbers = (
        indent(pformat(entries, width=_WIDTH - 12, sort_dicts=False), " " * 4) + ",\n"
        for entries in (reference["parameters"], guess)
    )
    phases = pformat(tuple(table["phases"]), width=_WIDTH - 8)
    lines = f'"{name}",\nsystem,\n{phases},\nreference=Reference(\n{"".join(numbers)}),'
    return f"    Itinerary(\n{indent(lines, ' ' * 8)}\n    ),\n"


def _declared_by(content: bytes, path: Path) -> Sequence[Any]:
    """Orbits that a file with this content declares; it is executed beside the file."""
    trial = path.with_name(f"{path.stem}_{secrets.token_hex(4)}.py")
    try:
        trial.write_bytes(content)
        return declaration_in(trial).orbits
    except OSError as problem:
        raise unwritable(path, problem) from None
    finally:
        trial.unlink(missing_ok=True)

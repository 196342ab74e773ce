"""Values, ranges and lists of names, from the words of a command line."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

from nonsmooth.runtime.core.errors import InputError

if TYPE_CHECKING:
    from nonsmooth.runtime.core.values import Value

_LONGEST_COUNT = 18  # digits

Range = tuple[Any, ...]  # values of its parts; None where one is blank


def split(options: Iterable[str] | None) -> list[str]:
    """Nonempty entries of options that each hold a comma-separated list."""
    return [part.strip() for option in options or () for part in option.split(",") if part.strip()]


def assignments(kind: str, texts: Iterable[str]) -> dict[str, Value]:
    """Values by name, parsed from texts ``NAME=VALUE``, in the order in which they are given.

    `kind` says in messages what is assigned. InputError refuses a text that is no
    assignment and a name that is given twice.
    """
    from nonsmooth.runtime.core.values import parse_assignment

    found: dict[str, Value] = {}
    for text in texts:
        name, value = parse_assignment(text)
        if name in found:
            raise InputError(f"{kind} {name} is given twice")
        found[name] = value
    return found


def guessed(options: Iterable[str] | None) -> dict[str, float] | None:
    """A guess of unknowns by name, from texts ``NAME=VALUE,...``; None for none."""
    return {
        name: float(value) for name, value in assignments("unknown", split(options)).items()
    } or None


def values_and_ranges(
    texts: Iterable[str] | None, *forms: str, kind: str = "parameter", blank: bool = False
) -> tuple[dict[str, Value], dict[str, Range]]:
    """Values by name from texts ``NAME=VALUE``, and the parts of each range by its name.

    A range has one of the forms, ``A:B`` if none is named; a part N is a count. Only with
    `blank` a part may be left out. InputError refuses other texts and a name given twice.
    """
    known = {form.count(":"): form for form in forms or ("A:B",)}
    fixed = [text for text in texts or () if ":" not in text]
    values, ranged = assignments(kind, fixed), dict[str, Range]()
    for text in texts or ():
        if ":" not in text:
            continue
        name, _, written = text.partition("=")
        name, parts = name.strip(), [part.strip() for part in written.split(":")]
        form = known.get(len(parts) - 1)
        if not name or form is None or not (all(parts) or blank):
            raise InputError(
                f"{text!r} is not {' or '.join(f'NAME={form}' for form in known.values())}"
            )
        if name in values or name in ranged:
            raise InputError(f"{kind} {name} is given twice")
        try:
            ranged[name] = tuple(map(_part, form.split(":"), parts))
        except InputError as problem:
            raise InputError(f"{name}: {problem}") from None
    return values, ranged


def _part(letter: str, text: str) -> Value | None:
    from nonsmooth.runtime.core.values import parse

    if letter == "N" and not (text.isdecimal() and len(text) <= _LONGEST_COUNT):
        raise InputError(f"{text!r} is not a count")
    return parse(text) if text else None


def ends(ranged: dict[str, Range]) -> dict[str, tuple[float, float]]:
    """Lower and upper ends of ranges without blanks, in the system's units."""
    return {name: (float(low), float(high)) for name, (low, high, *_) in ranged.items()}


def grid(ranged: dict[str, Range]) -> dict[str, tuple[float, float, int]]:
    """Lower and upper ends and counts of ranges A:B:N, in the system's units."""
    counts = {name: int(str(count)) for name, (_, _, count) in ranged.items()}
    return {name: (*both, counts[name]) for name, both in ends(ranged).items()}


def ranges(kind: str, texts: Sequence[str]) -> dict[str, tuple[float, float]]:
    """Ends by name of ranges alone: InputError refuses a value ``NAME=VALUE``."""
    values, ranged = values_and_ranges(texts, kind=kind)
    for name, value in values.items():
        raise InputError(f"'{name}={value}' is not NAME=A:B")
    return ends(ranged)


def texts_by_name(what: str, texts: Iterable[str]) -> dict[str, str]:
    """Texts by name, parsed from ``NAME=TEXT``; `what` says in messages what they are."""
    found: dict[str, str] = {}
    for text in texts:
        name, equals, value = (part.strip() for part in text.partition("="))
        if not (name and equals and value):
            raise InputError(f"{text!r} is not NAME={what.upper()}")
        if name in found:
            raise InputError(f"{what} {name} is given twice")
        found[name] = value
    return found

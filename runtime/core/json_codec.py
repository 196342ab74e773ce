"""One way from records to JSON and back.

A record is a frozen dataclass with keyword-only fields; the annotations of its fields say how
each is written and what is accepted when it is read. Nothing is converted silently: an entry
that is missing, unknown or of another type is refused in one line that names it by its path,
such as ``'events/2/unknowns/tau'``, with the places of a list counted from 1.

=============================  ==================================================================
annotation                     entry
=============================  ==================================================================
``str``, ``bool``, ``int``     the same
``float``                      a finite JSON number
`Digits`, `AnyDigits`          a decimal string with every digit; finite, or also nan and inf
`Exact`                        the text of a decimal number or a fraction, kept as it is
`Complex`, `AnyComplex`        ``"re im"``, or ``"re"`` for a real one
`Value`                        a given value as it was written
`Row`, `AnyRow`, `Table`, ...  an array, flat or row by row, of decimal or complex strings
``tuple[X, ...]``              a list
``tuple[X, Y]``                a list of so many
``Mapping[str, X]``            an object
``X | None``                   null, or that
`BlankText`, `BlankDigits`...  an empty text, or that
``Literal["a", "b"]``          one of these
a record                       an object with exactly its fields; one that has a default and is
                               that is not there
``Any``                        whatever is there
``Annotated[X, Codec(...)]``   what its two functions say
``Annotated[X, Several(...)]`` the entries of a record, which stand beside those of other fields
=============================  ==================================================================
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Collection, Mapping
from dataclasses import MISSING, dataclass, fields, is_dataclass
from fractions import Fraction
from functools import cache
from types import NoneType, UnionType
from typing import Annotated, Any, Literal, TypeVar, Union, get_args, get_origin, get_type_hints

import numpy as np

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.values import (
    LARGEST_EXPONENT,
    LONGEST_TEXT,
    Value,
    as_value,
    parse,
)

__all__ = [
    "AnyComplex",
    "AnyComplexTable",
    "AnyDigits",
    "AnyRow",
    "AnyTable",
    "BlankDigits",
    "BlankText",
    "BlankValue",
    "Codec",
    "Complex",
    "Digits",
    "Exact",
    "Flags",
    "FromOne",
    "Integers",
    "Row",
    "Several",
    "Table",
    "decode",
    "encode",
    "given_value",
    "nan_as_null",
    "one_of",
]

Record = TypeVar("Record")
_WRONG_TYPE = " is of the wrong type"


@dataclass(frozen=True)
class Codec:
    """The two functions that write and read one kind of entry."""

    write: Callable[..., Any]  # gives the JSON entry of a value
    # gives the value of an entry; InputError or ValueError for another entry
    read: Callable[[Any], Any]


@dataclass(frozen=True)
class Several:
    """How one field stands as several entries: those of a record that is made of its value."""

    entries: type  # the record
    write: Callable[[Any], Any]  # gives the record of a value
    read: Callable[[Any], Any]  # gives the value of a record; InputError for another record


class _Refused(InputError):
    """An entry that is refused, with the path that leads to it."""

    def __init__(self, problem: str, path: tuple[object, ...] = ()) -> None:
        super().__init__(f"{'/'.join(map(str, path))!r}{problem}" if path else problem)
        self.problem, self.path = problem, path

    def below(self, step: object) -> _Refused:
        """The same refusal with one more step in front of its path."""
        return _Refused(self.problem, (step, *self.path))


def encode(record: Any, without: Collection[str] = ()) -> dict[str, Any]:
    """The JSON object of a record, whose annotations say how each field is written.

    Fields named in `without` are left out.
    """
    kind: Any = type(record)
    entries: dict[str, Any] = _codec(kind).write(record, without)
    return entries


def decode(kind: type[Record], entries: Any) -> Record:
    """The record of a class that a parsed JSON object describes.

    An `InputError` refuses an entry that is missing, unknown, or not as the record's field
    has it.
    """
    any_kind: Any = kind
    found: Record = _codec(any_kind).read(entries)
    return found


def given_value(name: str, text: str) -> Value:
    """The value of a text, as it was written.

    `name` says what the value is of. It begins the `InputError` for a text that is no
    number.
    """
    try:
        return _value(text)
    except (ValueError, ZeroDivisionError) as problem:
        raise InputError(f"{name}: {problem}") from None


@cache
def _codec(kind: Any) -> Codec:
    """The `Codec` for values of an annotation."""
    origin, arguments = get_origin(kind), get_args(kind)
    if kind is Any:
        return Codec(_same, _same)
    if kind in _PLAIN:
        return _PLAIN[kind]
    if origin is Annotated:
        own = [note for note in arguments[1:] if isinstance(note, Codec)]
        return own[0] if own else _codec(arguments[0])
    if origin is Literal:
        return one_of(arguments)
    if origin in (Union, UnionType):
        (inner,) = (part for part in arguments if part is not NoneType)
        return _optional(_codec(inner))
    if origin is tuple:
        if arguments[-1] is Ellipsis:
            return _list(_codec(arguments[0]))
        return _row(tuple(map(_codec, arguments)))
    if origin in (dict, Mapping):
        return _object(_codec(arguments[1]))
    if is_dataclass(kind):
        return _record(kind)
    raise TypeError(f"{kind} has no JSON form")


def _same(entry: Any) -> Any:
    return entry


def _of_type(kind: type) -> Callable[[Any], Any]:
    """A reader that refuses what is not exactly of a type."""

    def read(entry: Any) -> Any:
        if type(entry) is not kind:
            raise _Refused(_WRONG_TYPE)
        return entry

    return read


_text = _of_type(str)


def _number(entry: Any) -> float:
    """Read a finite JSON number."""
    if type(entry) not in (int, float) or not math.isfinite(entry):
        raise _Refused(_WRONG_TYPE)
    return float(entry)


def _value(entry: Any) -> Value:
    text = _text(entry)
    if len(text) <= LONGEST_TEXT:
        return parse(text)
    exponent = re.search(r"[eE][+-]?(\d{1,20})", text)
    if exponent and int(exponent[1]) > LARGEST_EXPONENT:
        raise _Refused(f" has an exponent beyond {LARGEST_EXPONENT}")
    return as_value(Fraction(text))


def _matching(pattern: str) -> Callable[[Any], str]:
    """A reader that refuses texts that do not match a pattern."""
    form = re.compile(pattern)

    def read(entry: Any) -> str:
        text: str = _text(entry)
        if not form.fullmatch(text):
            raise _Refused(f" is {text!r}, not a number")
        return text

    return read


_fraction = _matching(r"-?\d+(/\d+)?")


def _digits(entry: Any) -> float:
    """Read a decimal string, which may be nan or inf."""
    text = _text(entry)
    try:
        return float(text)
    except ValueError:
        raise _Refused(f" is {entry!r}, not a number") from None


def _finite(entry: Any) -> float:
    number = _digits(entry)
    if not math.isfinite(number):
        raise _Refused(f" is {entry}, not a finite number")
    return number


def _digits_of(number: Any) -> str:
    return repr(float(number))


def _complex_text(number: Any) -> str:
    real, imaginary = float(number.real), float(number.imag)
    return f"{real!r} {imaginary!r}" if imaginary else repr(real)


def _complex_of(part: Callable[[Any], float]) -> Callable[[Any], complex]:
    def read(entry: Any) -> complex:
        parts = _text(entry).split(" ")
        if len(parts) > 2:
            raise _Refused(f" is {entry!r}, not a number")
        return complex(*map(part, parts))

    return read


def _place_in(parts: Any, read: Callable[[Any], Any]) -> list[Any]:
    """Read the parts of a list; a refusal names the place of the part, counted from 1."""
    if type(parts) is not list:
        raise _Refused(_WRONG_TYPE)
    found: list[Any] = []
    try:
        for part in parts:
            found.append(read(part))
    except (ValueError, ArithmeticError) as problem:
        raise _refused(problem).below(len(found) + 1) from None
    return found


def _refused(problem: Exception) -> _Refused:
    return problem if isinstance(problem, _Refused) else _Refused(f": {problem}")


def _list(part: Codec) -> Codec:
    return Codec(
        lambda parts: [part.write(each) for each in parts],
        lambda entry: tuple(_place_in(entry, part.read)),
    )


def _row(parts: tuple[Codec, ...]) -> Codec:
    def read(entry: Any) -> tuple[Any, ...]:
        if type(entry) is not list or len(entry) != len(parts):
            raise _Refused(f" is no list of {len(parts)}")
        ways = iter(parts)
        return tuple(_place_in(entry, lambda part: next(ways).read(part)))

    return Codec(lambda row: [p.write(each) for p, each in zip(parts, row, strict=True)], read)


def _object(part: Codec) -> Codec:
    def read(entry: Any) -> dict[str, Any]:
        if type(entry) is not dict:
            raise _Refused(_WRONG_TYPE)
        return _named(entry, dict.fromkeys(entry, part))

    return Codec(lambda entry: {name: part.write(each) for name, each in entry.items()}, read)


def _named(entry: Mapping[str, Any], ways: Mapping[str, Codec]) -> dict[str, Any]:
    """Read entries by name; a refusal names the entry."""
    found, name = {}, ""
    try:
        for name, way in ways.items():
            found[name] = way.read(entry[name])
    except (ValueError, ArithmeticError) as problem:
        raise _refused(problem).below(name) from None
    return found


def _optional(part: Codec, nothing: Any = None) -> Codec:
    return Codec(
        lambda each: nothing if each is None else part.write(each),
        lambda entry: None if entry == nothing else part.read(entry),
    )


def _record(kind: Any) -> Codec:
    hints = get_type_hints(kind, include_extras=True)
    spread = {f.name: found for f in fields(kind) if (found := _several(hints[f.name]))}
    ways = {f.name: _codec(hints[f.name]) for f in fields(kind) if f.name not in spread}
    left_out = {f.name: f.default for f in fields(kind) if f.default is not MISSING}
    beside = {part.name: name for name, own in spread.items() for part in fields(own.entries)}

    def write(record: Any, without: Collection[str] = ()) -> dict[str, Any]:
        entries: dict[str, Any] = {}
        for name in (field.name for field in fields(kind) if field.name not in without):
            value = getattr(record, name)
            if name in spread:
                entries |= encode(spread[name].write(value))
            elif name not in left_out or value != left_out[name]:
                entries[name] = ways[name].write(value)
        return entries

    def read(entry: Any) -> Any:
        if type(entry) is not dict:
            raise _Refused(_WRONG_TYPE)
        for name in ways:
            if name not in entry and name not in left_out:
                raise _Refused(" is missing", (name,))
        for name in entry:
            if name not in ways and name not in beside:
                raise _Refused(" is unknown", (name,))
        found = _named(entry, {name: ways[name] for name in entry if name in ways})
        for name, own in spread.items():
            parts = {part: entry[part] for part in entry if beside.get(part) == name}
            found[name] = own.read(decode(own.entries, parts))
        return kind(**found)

    return Codec(write, read)


def _several(hint: Any) -> Several | None:
    notes = get_args(hint)[1:] if get_origin(hint) is Annotated else ()
    return next((note for note in notes if isinstance(note, Several)), None)


def one_of(known: tuple[str, ...]) -> Codec:
    """A `Codec` for texts that are known; it refuses another text with `InputError`."""

    def read(entry: Any) -> Any:
        if type(entry) is not str or entry not in known:
            raise _Refused(f" is {entry!r}, none of {', '.join(known)}")
        return entry

    return Codec(_same, read)


def _flat(part: Codec, kind: type) -> Codec:
    """A `Codec` for arrays (n,); those of more axes are written flat, without their shape."""
    return Codec(
        lambda array: [part.write(each) for each in np.ravel(array).tolist()],
        lambda entry: np.array(_place_in(entry, part.read), dtype=kind),
    )


def _rows(part: Codec, kind: type = float) -> Codec:
    """A `Codec` for arrays (n, m), as n lists."""

    def read(entry: Any) -> np.ndarray:
        rows = _place_in(entry, lambda row: _place_in(row, part.read))
        if len({len(row) for row in rows}) > 1:
            raise _Refused(" has rows of different lengths")
        return np.array(rows, dtype=kind).reshape(len(rows), -1 if rows else 0)

    return Codec(lambda array: [[part.write(each) for each in row] for row in array.tolist()], read)


_PLAIN: dict[Any, Codec] = {
    str: Codec(_same, _text),
    bool: Codec(bool, _of_type(bool)),
    int: Codec(int, _of_type(int)),
    float: Codec(float, _number),
    Value: Codec(lambda value: value.text, _value),
    Fraction: Codec(str, lambda entry: Fraction(_fraction(entry))),
}
_DIGITS, _ANY_DIGITS = Codec(_digits_of, _finite), Codec(_digits_of, _digits)
_ANY_COMPLEX = Codec(_complex_text, _complex_of(_digits))

Exact = Annotated[str, Codec(_same, _matching(r"-?\d+(\.\d+)?(e[-+]?\d+)?(/\d+)?"))]
Digits = Annotated[float, _DIGITS]
AnyDigits = Annotated[float, _ANY_DIGITS]
Row = Annotated[np.ndarray, _flat(_DIGITS, float)]
AnyRow = Annotated[np.ndarray, _flat(_ANY_DIGITS, float)]
Table = Annotated[np.ndarray, _rows(_DIGITS)]
AnyTable = Annotated[np.ndarray, _rows(_ANY_DIGITS)]
Complex = Annotated[np.ndarray, _flat(Codec(_complex_text, _complex_of(_finite)), complex)]
AnyComplex = Annotated[np.ndarray, _flat(_ANY_COMPLEX, complex)]
AnyComplexTable = Annotated[np.ndarray, _rows(_ANY_COMPLEX, complex)]
Integers = Annotated[np.ndarray, _flat(_PLAIN[int], int)]
Flags = Annotated[np.ndarray, _flat(_PLAIN[bool], bool)]
# what is counted from 0 inside and from 1 where a person or a file sees it
FromOne = Annotated[
    int | None,
    _optional(Codec(lambda place: place + 1, lambda entry: _PLAIN[int].read(entry) - 1)),
]
# None is written as an empty text
BlankText = Annotated[str | None, _optional(_PLAIN[str], "")]
BlankDigits = Annotated[float | None, _optional(_DIGITS, "")]
BlankValue = Annotated[Value | None, _optional(_PLAIN[Value], "")]


def nan_as_null(entry: Any) -> Any:
    """An answer's JSON, with null for each number that is not known.

    Numbers are decimal strings, complex ones ``"re im"``, or JSON numbers; keys stay as they
    are. An infinite number becomes the string ``"inf"`` or ``"-inf"``.

    Examples
    --------
    >>> nan_as_null({"trace": "nan", "bounds": ["0.5", float("inf")], "rates": {"nan": "nan nan"}})
    {'trace': None, 'bounds': ['0.5', 'inf'], 'rates': {'nan': None}}
    """
    match entry:
        case Mapping():
            return {name: nan_as_null(each) for name, each in entry.items()}
        case list() | tuple():
            return [nan_as_null(each) for each in entry]
        case str() if {*entry.split()} == {"nan"}:
            return None
        case float() if not math.isfinite(entry):
            return None if math.isnan(entry) else repr(float(entry))
    return entry

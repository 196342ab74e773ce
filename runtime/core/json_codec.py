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
``Annotated[X, IN_FILES]``     as ``X``, and not in answers; `IN_ANSWERS`: not in files
``Annotated[X, UNSTATED]``     in neither; the default where a file is read
=============================  ==================================================================

What follows from the fields stands beside them: a `Follows` property in files and answers, and a
reader refuses another value; a `Told` property in answers alone. `json_schema` says all of this
of a record in JSON Schema.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Collection, Iterator, Mapping
from contextvars import ContextVar
from dataclasses import MISSING, Field, dataclass, field, fields, is_dataclass, replace
from fractions import Fraction
from functools import cache, cached_property
from itertools import chain
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

Record = TypeVar("Record")
Entry = TypeVar("Entry")
_WRONG_TYPE = " is of the wrong type"
# notes on fields that are not stated everywhere
IN_FILES, IN_ANSWERS, UNSTATED = "in files", "in answers", "unstated"
_FOR = ContextVar("what entries are for", default=IN_FILES)
_PROOF = "a proof"


@dataclass(frozen=True)
class Codec:
    """The two functions that write and read one kind of entry."""

    write: Callable[..., Any]  # gives the JSON entry of a value
    # gives the value of an entry; InputError or ValueError for another entry
    read: Callable[[Any], Any]
    # JSON Schema of the entry; a record is a reference to `RECORDS`
    schema: Mapping[str, Any] = field(default_factory=dict, hash=False, compare=False)


@dataclass(frozen=True)
class Several:
    """How fields stand as several entries: those of a record that is made of their values."""

    entries: type  # the record
    write: Callable[..., Any]  # gives the record of the values
    read: Callable[[Any], Any]  # gives the values of a record; InputError for another record
    fields: tuple[str, ...] = ()  # whose values these are; empty for the noted field alone


class Told(cached_property[Entry]):
    """A property that answers state beside a record's fields."""


class Follows(Told[Entry]):
    """A property that files state too: a reader refuses what does not follow from the fields."""


def _same(entry: Any) -> Any:
    return entry


class _Refused(InputError):
    """An entry that is refused, with the path that leads to it."""

    def __init__(self, problem: str, path: tuple[object, ...] = ()) -> None:
        super().__init__(f"{'/'.join(map(str, path))!r}{problem}" if path else problem)
        self.problem, self.path = problem, path

    def below(self, step: object) -> _Refused:
        """The same refusal with one more step in front of its path."""
        return type(self)(self.problem, (step, *self.path))


class Inconsistent(_Refused):
    """Entries that are refused together: each of them alone is in order."""


def answer(record: Any, without: Collection[str] = ()) -> dict[str, Any]:
    """The JSON object of a record in answers: all that it tells, and nothing that files need.

    Fields named in `without` are left out.
    """
    return _encoded(record, IN_ANSWERS, without)


def stated(record: Any) -> dict[str, Any]:
    """The JSON object of a record as its file has it, where names are those of this process."""
    return _encoded(record, _PROOF)


def _encoded(record: Any, what_for: str, without: Collection[str] = ()) -> dict[str, Any]:
    token = _FOR.set(what_for)
    try:
        return encode(record, without)
    finally:
        _FOR.reset(token)


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


def json_schema(kind: type) -> dict[str, Any]:
    """JSON Schema (2020-12) of a record: its own, and by name those of the records in it."""
    found: dict[str, Any] = {}
    left = [_codec(kind).schema["$ref"]]
    while left:
        name = left.pop().rpartition("/")[2]
        if name not in found:
            found[name] = _parts(_RECORDS[name]).schema
            left += _references(found[name])
    return {**found.pop(kind.__name__), "$defs": dict(sorted(found.items()))}


def _references(schema: Any) -> Iterator[str]:
    """The references in a schema."""
    if isinstance(schema, Mapping):
        if isinstance(schema.get("$ref"), str):
            yield schema["$ref"]
        yield from chain.from_iterable(map(_references, schema.values()))
    elif isinstance(schema, list):
        yield from chain.from_iterable(map(_references, schema))


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


def by(kind: Any, write: Callable[[Any], Any], read: Callable[[Any], Any] = _same) -> Codec:
    """A `Codec` for values that are written as others, of an annotation.

    `write` gives the other value, `read` the value of another one; InputError if there is none.
    """
    way = _codec(kind)
    return Codec(
        lambda value: way.write(write(value)), lambda entry: read(way.read(entry)), way.schema
    )


def named_as(names: tuple[str, ...], kind: Any) -> Codec:
    """A `Codec` for mappings with exactly these names, whose values have one annotation."""
    part = _codec(kind)
    ways = dict.fromkeys(names, part)

    def read(entry: Any) -> dict[str, Any]:
        _check_names(entry, ways, ways)
        return _named(entry, ways)

    schema = _object_schema(dict.fromkeys(names, part.schema), names)
    return Codec(lambda entry: {name: part.write(entry[name]) for name in names}, read, schema)


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


def _matching(pattern: str) -> Codec:
    """A `Codec` for texts that match a pattern."""
    form = re.compile(pattern)

    def read(entry: Any) -> str:
        text: str = _text(entry)
        if not form.fullmatch(text):
            raise _Refused(f" is {text!r}, not a number")
        return text

    return Codec(_same, read, {"type": "string", "pattern": f"^({pattern})$"})


_FRACTION = _matching(r"-?\d+(/\d+)?")


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
        {"type": "array", "items": part.schema},
    )


def _row(parts: tuple[Codec, ...]) -> Codec:
    def read(entry: Any) -> tuple[Any, ...]:
        if type(entry) is not list or len(entry) != len(parts):
            raise _Refused(f" is no list of {len(parts)}")
        ways = iter(parts)
        return tuple(_place_in(entry, lambda part: next(ways).read(part)))

    size = len(parts)
    return Codec(
        lambda row: [p.write(each) for p, each in zip(parts, row, strict=True)],
        read,
        {
            "type": "array",
            "prefixItems": [p.schema for p in parts],
            "minItems": size,
            "maxItems": size,
        },
    )


def _object(part: Codec) -> Codec:
    def read(entry: Any) -> dict[str, Any]:
        if type(entry) is not dict:
            raise _Refused(_WRONG_TYPE)
        return _named(entry, dict.fromkeys(entry, part))

    return Codec(
        lambda entry: {name: part.write(each) for name, each in entry.items()},
        read,
        {"type": "object", "additionalProperties": part.schema},
    )


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
        {"anyOf": [{"const": nothing}, part.schema]},
    )


@dataclass(frozen=True)
class _Parts:
    """How the fields of a record, and what follows from them, are written and read."""

    ways: Mapping[str, Codec]  # of fields, by name, that have an entry of this name
    spread: Mapping[str, Several]  # of fields that have several
    together: Mapping[str, str]  # by the name of a field that another one spreads: which does
    defaults: Mapping[str, Any]  # of fields: their entries are not there where they are these
    notes: Mapping[str, str]  # of fields that are not stated everywhere
    follows: Mapping[str, Codec]  # of properties in files and answers
    told: Mapping[str, Codec]  # of properties in answers alone
    beside: Mapping[str, str]  # by the name of an entry of several: the field

    @property
    def alone(self) -> dict[str, Codec]:
        """Of the fields that have an entry of their own in files."""
        return {
            name: way
            for name, way in self.ways.items()
            if name not in self.together and self.notes.get(name, IN_FILES) == IN_FILES
        }

    @property
    def schema(self) -> dict[str, Any]:
        """JSON Schema of the record."""
        every = {name: way.schema for name, way in {**self.alone, **self.follows}.items()}
        needed = [name for name in every if name not in self.defaults]
        for own in self.spread.values():
            inner = _parts(own.entries).schema
            every |= inner["properties"]
            needed += inner["required"]
        return _object_schema(every, needed)


def _object_schema(entries: Mapping[str, Any], needed: Collection[str]) -> dict[str, Any]:
    return {
        "type": "object",
        "properties": dict(entries),
        "required": list(needed),
        "additionalProperties": False,
    }


@cache
def _parts(kind: Any) -> _Parts:
    hints = get_type_hints(kind, include_extras=True)
    spread = {f.name: found for f in fields(kind) if (found := _note(hints[f.name], Several))}
    told = {
        name: (type(own), _codec(get_type_hints(own.func, include_extras=True)["return"]))
        for each in reversed(kind.__mro__)
        for name, own in vars(each).items()
        if isinstance(own, Told)
    }
    return _Parts(
        {f.name: _codec(hints[f.name]) for f in fields(kind)
         if f.name not in spread or spread[f.name].fields},
        spread,
        {name: first for first, own in spread.items() for name in own.fields},
        {f.name: _default(f) for f in fields(kind) if _default(f) is not MISSING},
        {f.name: note for f in fields(kind) if (note := _note(hints[f.name], str))},
        {name: way for name, (own, way) in told.items() if own is Follows},
        {name: way for name, (own, way) in told.items() if own is Told},
        {part: name for name, own in spread.items() for part in _entries_of(own.entries)},
    )  # fmt: skip


def _default(own: Field[Any]) -> Any:
    return own.default if own.default_factory is MISSING else own.default_factory()


def _entries_of(kind: Any) -> tuple[str, ...]:
    return tuple(own.name for own in fields(kind))


_RECORDS: dict[str, Any] = {}  # records that a schema refers to, by name


def _record(kind: Any) -> Codec:
    """The `Codec` of a record, which may hold others of its kind."""

    def write(record: Any, without: Collection[str] = ()) -> dict[str, Any]:
        parts, entries, what_for = _parts(kind), dict[str, Any](), _FOR.get()
        place = IN_ANSWERS if what_for == IN_ANSWERS else IN_FILES
        for name in (own.name for own in fields(kind) if own.name not in without):
            value = getattr(record, name)
            if parts.notes.get(name, place) != place:
                continue
            if name in parts.spread and (what_for == IN_FILES or name not in parts.ways):
                own = parts.spread[name]
                values = [getattr(record, each) for each in own.fields or (name,)]
                several = own.write(*values)
                entries |= encode(several)
                if own.fields and parts.follows:  # from names that the file gives
                    known = vars(several).keys() & {*own.fields}
                    record = replace(record, **{each: vars(several)[each] for each in known})
            elif name in parts.together and what_for == IN_FILES:
                continue
            elif name not in parts.defaults or value != parts.defaults[name]:
                entries[name] = parts.ways[name].write(value)
        more = {**parts.follows, **(parts.told if what_for == IN_ANSWERS else {})}
        known = (name for name in more if name not in without)
        return {**entries, **{name: more[name].write(getattr(record, name)) for name in known}}

    def read(entry: Any) -> Any:
        parts = _parts(kind)
        every = {**parts.alone, **parts.follows}
        needed = [name for name in every if name not in parts.defaults]
        _check_names(entry, needed, {**every, **parts.beside})
        found = _named(entry, {name: every[name] for name in entry if name in every})
        for name, own in parts.spread.items():
            inner = {part: entry[part] for part in entry if parts.beside.get(part) == name}
            several: Any = decode(own.entries, inner)
            try:
                values = own.read(several)
            except InputError as problem:
                raise Inconsistent(str(problem)) from None
            found |= dict(
                zip(own.fields or (name,), values if own.fields else (values,), strict=True)
            )
        record = kind(**{name: value for name, value in found.items() if name not in parts.follows})
        for name, way in parts.follows.items():
            try:
                same = way.write(getattr(record, name)) == entry[name]
            except (LookupError, TypeError, ValueError, AttributeError, ArithmeticError):
                same = False  # from entries that do not belong together
            if not same:
                raise Inconsistent(" is not what the other entries give", (name,))
        return record

    _RECORDS[kind.__name__] = kind
    return Codec(write, read, {"$ref": f"#/$defs/{kind.__name__}"})


def _check_names(entry: Any, needed: Collection[str], known: Collection[str]) -> None:
    """Refuse what is no object, lacks a needed name, or has one that is not known."""
    if type(entry) is not dict:
        raise _Refused(_WRONG_TYPE)
    for name in needed:
        if name not in entry:
            raise _Refused(" is missing", (name,))
    for name in entry:
        if name not in known:
            raise _Refused(" is unknown", (name,))


def _note(hint: Any, kind: type) -> Any:
    """The note of a kind on an annotation, None without one."""
    notes = get_args(hint)[1:] if get_origin(hint) is Annotated else ()
    return next((note for note in notes if isinstance(note, kind)), None)


def one_of(known: tuple[str, ...]) -> Codec:
    """A `Codec` for texts that are known; it refuses another text with `InputError`."""

    def read(entry: Any) -> Any:
        if type(entry) is not str or entry not in known:
            raise _Refused(f" is {entry!r}, none of {', '.join(known)}")
        return entry

    return Codec(_same, read, {"enum": list(known)})


def _flat(part: Codec, kind: type) -> Codec:
    """A `Codec` for arrays (n,); those of more axes are written flat, without their shape."""
    return Codec(
        lambda array: [part.write(each) for each in np.ravel(array).tolist()],
        lambda entry: np.array(_place_in(entry, part.read), dtype=kind),
        {"type": "array", "items": part.schema},
    )


def _rows(part: Codec, kind: type = float) -> Codec:
    """A `Codec` for arrays (n, m), as n lists."""

    def read(entry: Any) -> np.ndarray:
        rows = _place_in(entry, lambda row: _place_in(row, part.read))
        if len({len(row) for row in rows}) > 1:
            raise _Refused(" has rows of different lengths")
        return np.array(rows, dtype=kind).reshape(len(rows), -1 if rows else 0)

    return Codec(
        lambda array: [[part.write(each) for each in row] for row in array.tolist()],
        read,
        {"type": "array", "items": {"type": "array", "items": part.schema}},
    )


_TEXT = {"type": "string"}
_PLAIN: dict[Any, Codec] = {
    str: Codec(_same, _text, _TEXT),
    bool: Codec(bool, _of_type(bool), {"type": "boolean"}),
    int: Codec(int, _of_type(int), {"type": "integer"}),
    float: Codec(float, _number, {"type": "number"}),
    Value: Codec(lambda value: value.text, _value, _TEXT),
    Fraction: Codec(str, lambda entry: Fraction(_FRACTION.read(entry)), _FRACTION.schema),
}
_DECIMAL = r"-?(\d+(\.\d+)?(e[-+]\d+)?"
_FINITE = {"type": "string", "pattern": f"^{_DECIMAL})$"}
_DIGITS = Codec(_digits_of, _finite, _FINITE)
_ANY = {"type": "string", "pattern": f"^{_DECIMAL}|nan|inf)$"}
_ANY_DIGITS = Codec(_digits_of, _digits, _ANY)
_ANY_COMPLEX = Codec(_complex_text, _complex_of(_digits), _TEXT)

_EXACT = r"-?\d+(\.\d+)?(e[-+]?\d+)?(/\d+)?"
Exact = Annotated[str, _matching(_EXACT)]
BlankExact = Annotated[str, _matching(f"({_EXACT})?")]
Digits = Annotated[float, _DIGITS]
AnyDigits = Annotated[float, _ANY_DIGITS]
Row = Annotated[np.ndarray, _flat(_DIGITS, float)]
AnyRow = Annotated[np.ndarray, _flat(_ANY_DIGITS, float)]
Table = Annotated[np.ndarray, _rows(_DIGITS)]
AnyTable = Annotated[np.ndarray, _rows(_ANY_DIGITS)]
Complex = Annotated[np.ndarray, _flat(Codec(_complex_text, _complex_of(_finite), _TEXT), complex)]
AnyComplex = Annotated[np.ndarray, _flat(_ANY_COMPLEX, complex)]
AnyComplexTable = Annotated[np.ndarray, _rows(_ANY_COMPLEX, complex)]
Integers = Annotated[np.ndarray, _flat(_PLAIN[int], int)]
Flags = Annotated[np.ndarray, _flat(_PLAIN[bool], bool)]
# what is counted from 0 inside and from 1 where a person or a file sees it
_ORDINAL = by(int, lambda place: place + 1, lambda entry: entry - 1)
Ordinal = Annotated[int, _ORDINAL]
FromOne = Annotated[int | None, _optional(_ORDINAL)]
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

"""Records become JSON and the same records again, and nothing else becomes one."""

import json
import math
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Annotated, Literal

import pytest

from nonsmooth import InputError
from nonsmooth.runtime.core.json_codec import (
    IN_ANSWERS,
    IN_FILES,
    UNSTATED,
    AnyComplex,
    AnyTable,
    BlankDigits,
    BlankText,
    Complex,
    Digits,
    Exact,
    Flags,
    Follows,
    FromOne,
    Integers,
    Ordinal,
    Row,
    Several,
    Table,
    Told,
    answer,
    decode,
    encode,
    json_schema,
    named_as,
    nan_as_null,
    stated,
)
from nonsmooth.runtime.core.values import Value


@dataclass(frozen=True, kw_only=True)
class Ends:
    low: float
    high: float


def middle_and_half(ends):
    return (ends.low + ends.high) / 2, (ends.high - ends.low) / 2


@dataclass(frozen=True, kw_only=True, eq=False)
class Part:
    size: int
    name: str = "part"

    @Follows
    def double(self) -> int:
        return 2 * self.size if self.size else 1 // self.size

    @Told
    def words(self) -> str:
        return f"{self.name} of {self.size}"


@dataclass(frozen=True, kw_only=True, eq=False)
class Narrow(Part):
    @Follows
    def words(self) -> str:
        return "narrow"


@dataclass(frozen=True, kw_only=True)
class Address:
    system: str


@dataclass(frozen=True, kw_only=True, eq=False)
class Located:
    system: Annotated[
        str,
        Several(
            Address, lambda s: Address(system=s.upper()), lambda told: (told.system,), ("system",)
        ),
    ]

    @Follows
    def title(self) -> str:
        return f"of {self.system}"


@dataclass(frozen=True, kw_only=True)
class Span:
    start: int
    stop: int


@dataclass(frozen=True, kw_only=True, eq=False)
class Record:
    flag: bool
    number: float
    digits: Digits
    exact: Exact
    value: Value
    share: Fraction
    kind: Literal["one", "two"]
    pair: tuple[int, str]
    each: tuple[Digits, ...]
    by_name: dict[str, int]
    chosen: Annotated[dict[str, float], named_as(("a", "b"), float)]
    maybe: int | None
    place: Ordinal
    first: FromOne
    blank: BlankText
    open: BlankDigits
    row: Row
    table: Table
    any: AnyTable
    waves: Complex
    all_waves: AnyComplex
    counts: Integers
    flags: Flags
    parts: tuple[Part, ...]
    centre: Annotated[
        float,
        Several(
            Ends, lambda m, h: Ends(low=m - h, high=m + h), middle_and_half, ("centre", "half")
        ),
    ]
    half: float
    span: Annotated[
        range,
        Several(Span, lambda r: Span(start=r.start, stop=r.stop), lambda s: range(s.start, s.stop)),
    ]
    kept: Annotated[int, IN_FILES]
    shown: Annotated[int, IN_ANSWERS] = 0
    hidden: Annotated[int, UNSTATED] = 0


ENTRIES = {
    "flag": True, "number": 0.5, "digits": "1e-300", "exact": "-3/7", "value": "sqrt(2)",
    "share": "-2/3", "kind": "two", "pair": [3, "x"], "each": ["0.1", "2.0"], "by_name": {"n": 4},
    "chosen": {"a": 1.0, "b": -2.0}, "maybe": None, "place": 1, "first": None, "blank": "",
    "open": "", "row": ["1.0", "-0.5"], "table": [], "any": [["nan", "inf"], ["1.0", "-inf"]],
    "waves": ["1.0", "0.5 -0.25"], "all_waves": ["nan nan"], "counts": [1, -2],
    "flags": [True, False],
    "parts": [{"size": 2, "double": 4}, {"size": 3, "name": "y", "double": 6}], "low": -1.0,
    "high": 3.0, "start": 2, "stop": 5, "kept": 7,
}  # fmt: skip


def test_what_is_written_is_read_again():
    found = decode(Record, ENTRIES)
    again = json.loads(json.dumps(encode(found)))
    assert again == ENTRIES
    assert (found.place, found.first, found.blank, found.open) == (0, None, None, None)
    assert (found.centre, found.half, found.hidden) == (1.0, 2.0, 0)
    assert found.table.shape == (0, 0)
    assert found.span == range(2, 5)
    assert found.waves.tolist() == [1, 0.5 - 0.25j]
    assert decode(Record, {**ENTRIES, "table": [[], []]}).table.shape == (2, 0)
    assert decode(Record, {**ENTRIES, "first": 3, "blank": "t", "open": "0.5"}).first == 2


def test_files_and_answers_state_different_entries():
    found = replace(decode(Record, ENTRIES), shown=5, hidden=6)
    told, kept = answer(found), stated(found)
    assert told.keys() - ENTRIES.keys() == {"shown", "centre", "half"}
    assert ENTRIES.keys() - told.keys() == {"kept", "low", "high"}
    assert (kept["kept"], kept["centre"], kept["half"]) == (7, 1.0, 2.0)
    assert kept.keys() ^ ENTRIES.keys() == {"low", "high", "centre", "half"}
    assert [part.get("words") for part in told["parts"]] == ["part of 2", "y of 3"]
    assert encode(Narrow(size=1)) == {"size": 1, "double": 2, "words": "narrow"}
    assert encode(Located(system="x")) == {"system": "X", "title": "of X"}
    assert answer(found.parts[0], {"words", "size"}) == {"double": 4}


@pytest.mark.parametrize(
    ("name", "entry", "place"),
    [
        ("flag", 1, ""), ("number", True, ""), ("number", math.inf, ""), ("number", "1", ""),
        ("digits", "inf", ""), ("digits", "nan", ""), ("digits", "one", ""), ("digits", 1.0, ""),
        ("exact", "1/2/3", ""), ("exact", "x", ""), ("value", "x", ""), ("value", "1/0", ""),
        ("share", "0.5", ""), ("share", "1/0", ""),
        ("kind", "three", ""), ("kind", ["one"], ""), ("pair", [3], ""), ("pair", [3, "x", 1], ""),
        ("pair", [True, "x"], "/1"), ("pair", [3, 4], "/2"), ("each", ["0.1", 2.0], "/2"),
        ("each", {"0": "0.1"}, ""), ("by_name", {"n": "4"}, "/n"), ("by_name", [4], ""),
        ("chosen", {"a": 1.0}, "/b"), ("chosen", {"a": 1.0, "b": 1.0, "c": 1.0}, "/c"),
        ("maybe", "", ""), ("place", "1", ""), ("first", "", ""), ("blank", None, ""),
        ("open", "nan", ""), ("row", ["1.0", "inf"], "/2"), ("table", [["1.0"], []], ""),
        ("table", ["1.0"], "/1"), ("waves", ["1 2 3"], "/1"), ("waves", ["1 inf"], "/1"),
        ("counts", [1, 2.0], "/2"), ("flags", [1], "/1"), ("low", None, ""), ("kept", None, ""),
        ("parts", [{"size": 2, "double": 5}], "/1/double"), ("parts", [{"size": 2}], "/1/double"),
        ("parts", [{"size": 2, "double": 4, "words": "part of 2"}], "/1/words"),
        ("parts", [{"size": 0, "double": 0}], "/1/double"), ("shown", 0, ""),
        ("hidden", 0, ""), ("centre", 1.0, ""),
    ],
)  # fmt: skip
def test_another_entry_is_refused_by_its_path(name, entry, place):
    with pytest.raises(InputError, match=f"^'{name}{place}'"):
        decode(Record, {**ENTRIES, name: entry})


@pytest.mark.parametrize("name", ENTRIES)
def test_an_entry_that_is_missing_is_refused(name):
    without = {other: entry for other, entry in ENTRIES.items() if other != name}
    with pytest.raises(InputError, match=f"'{name}' is missing"):
        decode(Record, without)


def test_the_schema_names_exactly_what_is_read():
    schema = json_schema(Record)
    assert {*schema["properties"]} == {*schema["required"]} == {*ENTRIES}
    part = schema["$defs"]["Part"]
    assert ({*part["properties"]}, {*part["required"]}) == (
        {"size", "name", "double"},
        {"size", "double"},
    )
    for each in (schema, part, schema["properties"]["chosen"]):
        assert each["additionalProperties"] is False
    pair = schema["properties"]["pair"]
    assert pair["minItems"] == pair["maxItems"] == len(pair["prefixItems"]) == 2


def test_numbers_that_are_not_known_are_null():
    told = {"x": ["nan", "nan nan", "1 nan", "nano"], "y": (math.nan, -math.inf, 1.0)}
    known = {"x": [None, None, "1 nan", "nano"], "y": [None, "-inf", 1.0]}
    assert nan_as_null(told) == known

"""The laws of result files: what is written is read again, and nothing else is."""

from __future__ import annotations

import copy
import json
import math
import random
import re
import tracemalloc
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any, Literal

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth import InputError
from nonsmooth.runtime.core.json_codec import (
    AnyComplex,
    AnyDigits,
    AnyTable,
    BlankDigits,
    BlankText,
    BlankValue,
    Complex,
    Digits,
    Flags,
    FromOne,
    Integers,
    Row,
    Table,
    decode,
    encode,
)
from nonsmooth.runtime.core.result_files import FileFormat, checksum_of
from nonsmooth.runtime.core.values import Value, parse
from tests.certified import LOOP, kicked, loop, prove_basin, prove_cascade, prove_graph
from tests.horseshoes import folded_horseshoe
from tests.shared import shared_file

STICK = "dry-friction/global-stick"
TWO_MASSES = {"m1": 1, "m2": 2, "k1": 1, "k2": 5, "r": 0.8}
FRICTION = {"chi": 0.4, "eta": 4, "V": 0.6773, "us1": 0.0127, "ur1": 0.0255, "us2": 0.5, "ur2": 1}


@dataclass(frozen=True, kw_only=True)
class Inner:
    name: str
    size: Digits
    share: float


@dataclass(frozen=True, kw_only=True)
class Everything:
    """A record with an entry of every kind."""

    text: str
    whole: int
    flag: bool
    number: float
    digits: Digits
    unbounded: AnyDigits
    value: Value
    kind: Literal["one", "other"]
    phase: FromOne
    missing: Inner | None
    blank_text: BlankText
    blank_digits: BlankDigits
    blank_value: BlankValue
    pair: tuple[str, Digits]
    inner: tuple[Inner, ...]
    values: Mapping[str, Value]
    row: Row
    table: Table
    any_table: AnyTable
    roots: Complex
    any_roots: AnyComplex
    places: Integers
    flags: Flags


EVERYTHING = FileFormat(name="nonsmooth everything", what="record", entries=Everything)


def drawn(seed: int) -> Everything:
    """A random record, with numbers of all sizes."""
    rng = random.Random(seed)

    def number() -> float:
        return rng.choice([0.0, -0.0, 5e-324, rng.gauss(0, 1), rng.gauss(0, 1) * 10.0**200])

    def unbounded() -> float:
        return rng.choice([number(), math.inf, -math.inf, math.nan])

    def inner() -> Inner:
        return Inner(name=rng.choice(["", "a/b", "\u03c4"]), size=number(), share=number())

    def array(count: int, draw: Callable[[], Any]) -> np.ndarray:
        return np.array([draw() for _ in range(count)])

    count, wide = rng.randrange(1, 5), rng.randrange(1, 4)
    return Everything(
        text=rng.choice(["", "x", '"', "\n"]),
        whole=rng.randrange(-(10**30), 10**30),
        flag=rng.random() < 0.5,
        number=number(),
        digits=number(),
        unbounded=unbounded(),
        value=parse(rng.choice(["1/3", "2*pi", "0.1"])),
        kind=rng.choice(["one", "other"]),
        phase=rng.choice([None, 0, 7]),
        missing=rng.choice([None, inner()]),
        blank_text=rng.choice([None, "x"]),
        blank_digits=rng.choice([None, number()]),
        blank_value=rng.choice([None, parse("sqrt(2)")]),
        pair=("x", number()),
        inner=tuple(inner() for _ in range(count)),
        values={"V": parse("1/3"), "T": parse("2*pi")},
        row=array(count, number),
        table=array(count * wide, number).reshape(count, wide),
        any_table=array(count * wide, unbounded).reshape(count, wide),
        roots=array(count, lambda: complex(number(), number())),
        any_roots=array(count, lambda: complex(unbounded(), abs(number()))),
        places=array(count, lambda: rng.randrange(-9, 9)),
        flags=array(count, lambda: rng.random() < 0.5),
    )


@pytest.mark.parametrize("seed", range(20))
def test_a_record_comes_back_as_it_was(seed: int, tmp_path: Path) -> None:
    record = drawn(seed)
    one, other = tmp_path / "one.json", tmp_path / "other.json"
    EVERYTHING.write(one, record)
    back = EVERYTHING.read(one)
    for name, entry in vars(record).items():
        np.testing.assert_equal(getattr(back, name), entry)
        assert type(getattr(back, name)) is type(entry)
    EVERYTHING.write(other, back)
    assert one.read_bytes() == other.read_bytes()


def test_what_is_refused_is_named_by_its_path() -> None:
    content = encode(drawn(3))
    for change, told in (
        ({"whole": 1.0}, "'whole' is of the wrong type"),
        ({"flag": 1}, "'flag' is of the wrong type"),
        ({"number": math.nan}, "'number' is of the wrong type"),
        ({"digits": "nan"}, "'digits' is nan, not a finite number"),
        ({"value": "1/0"}, "'value': '1/0'"),
        ({"value": "0" * 1001 + "1e99999999"}, "'value' has an exponent beyond 10000"),
        ({"kind": "third"}, "'kind' is 'third', none of one, other"),
        ({"pair": ["x"]}, "'pair' is no list of 2"),
        ({"inner": [content["inner"][0], {"name": ""}]}, "'inner/2/size' is missing"),
        ({"table": [["1.0"], ["1.0", "2.0"]]}, "'table' has rows of different lengths"),
        ({"roots": ["1.0", "1.0 inf"]}, "'roots/2' is inf, not a finite number"),
        ({"values": {"V": "1", "T": 2}}, "'values/T' is of the wrong type"),
        ({"unheard": 0}, "'unheard' is unknown"),
    ):
        with pytest.raises(InputError, match=re.escape(told)):
            decode(Everything, {**content, **change})


def composed() -> Any:
    phases = [("free", "first-reaches-stop")]
    return ns.solve(
        "rigid-stop", TWO_MASSES | {"r": 1}, [6.28], itinerary=phases, given={"period": "2*pi"}
    )


def found() -> Any:
    from nonsmooth import find_orbits

    return find_orbits("dry-friction", FRICTION, 8, transitions=300)


def branch() -> Any:
    return ns.continue_orbit(ns.solve(STICK), "V", (0.95, 1.05), step=0.1)


@cache
def looped() -> Any:
    return ns.continue_orbit(loop(), "a", (1.5, 3.5))


def locus() -> Any:
    of = looped()
    return ns.continue_event(of, of.events[-1], "r", (0.45, 0.55), step=0.1)


def designed() -> Any:
    return ns.design(ns.solve(STICK), minimise="period", over={"V": (0.95, 1.05)})


def fitted() -> Any:
    motion = ns.simulate("rigid-stop", TWO_MASSES, [0, 0, 1.5, 0], until=12)
    known = {name: value for name, value in TWO_MASSES.items() if name != "r"}
    return ns.fit(
        "rigid-stop", {"first-reaches-stop": motion.times[1:]}, parameters=known,
        bounds={"r": (0.5, 1)}, start={"x1": 0, "x2": 0, "v1": 1.5, "v2": 0}, sigma=1e-3,
    )  # fmt: skip


def event() -> Any:
    of = looped()
    return ns.certify_event(of, of.events[-1])


def swept() -> Any:
    given = {name: value for name, value in FRICTION.items() if name != "V"}
    start = dict.fromkeys(("x1", "x2", "v1", "v2"), 0)
    more = {"state": "x1", "configuration": "slip-stick", "transient": 50, "samples": 4}
    return ns.sweep("dry-friction", given, "V", [0.6, 0.65, 0.7], start, **more)


def census() -> Any:
    bounds = {"tau1": "2.5", "tau2": "2"}
    return ns.certify_all(kicked(), {"k": 9, "r": "1/3", "a": 10}, bounds, itinerary=LOOP)


def certified() -> Any:
    return ns.certify_branch(looped())


def proven_map() -> Any:
    return ns.certify_box(loop(), {"r": ("2/5", "3/5")})


KINDS: dict[str, Callable[[], Any]] = {
    "nonsmooth orbit": lambda: ns.solve(STICK),
    "nonsmooth composed orbit": composed,
    "nonsmooth found orbits": found,
    "nonsmooth branch": branch,
    "nonsmooth locus": locus,
    "nonsmooth design": designed,
    "nonsmooth sweep": swept,
    "nonsmooth fit": fitted,
    "nonsmooth certificate": lambda: ns.certify(ns.solve(STICK)),
    "nonsmooth box certificate": proven_map,
    "nonsmooth event certificate": event,
    "nonsmooth certified branch": certified,
    "nonsmooth certified cascade": prove_cascade,
    "nonsmooth basin certificate": prove_basin,
    "nonsmooth chaos certificate": folded_horseshoe,
    "nonsmooth graph certificate": prove_graph,
    "nonsmooth census": census,
}
# what the file of a proof holds for the checker, and an answer that is shown
FREE = ("parameters", "reasons", "enclosures", "unique", "bounds")  # of names that vary
OPEN = r".*(declaration|closing|margins|admissible)\b.*"


def file_of(kind: str) -> Path:
    """A file of a kind, not to be changed."""
    return shared_file(kind, KINDS[kind])


@cache
def text_of(kind: str) -> str:
    return file_of(kind).read_text()


def signed(content: Any) -> Any:
    """With the right checksums."""
    if isinstance(content, dict):
        content = {name: signed(entry) for name, entry in content.items()}
        return {**content, "sha256": checksum_of(content)} if "sha256" in content else content
    return [signed(entry) for entry in content] if isinstance(content, list) else content


def paths_in(content: Any, path: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    """Paths of all entries."""
    if path:
        yield path
    parts = content.items() if isinstance(content, dict) else ()
    parts = enumerate(content) if isinstance(content, list) else parts
    for step, entry in parts:
        yield from paths_in(entry, (*path, step))


def changes(content: Any, path: tuple[Any, ...]) -> Iterator[Any]:
    """Content without an entry, with it of another type, not finite, or beside an unknown one."""
    *above, last = path

    def changed(change: Callable[[Any], Any]) -> Any:
        other = copy.deepcopy(content)
        parent = other
        for step in above:
            parent = parent[step]
        change(parent)
        return other

    entry = content
    for step in path:
        entry = entry[step]
    yield changed(lambda parent: parent.__setitem__(last, [[entry]]))
    if isinstance(entry, str) and re.fullmatch(r"-?\d+\.\d+(e[-+]\d+)?", entry):
        yield changed(lambda parent: parent.__setitem__(last, "1.0.0"))
    if isinstance(last, str) and above[-1:] not in ([name] for name in FREE):
        yield changed(lambda parent: parent.__delitem__(last))


@pytest.mark.parametrize("kind", KINDS)
def test_no_entry_is_missing_unknown_or_of_another_type(kind: str, tmp_path: Path) -> None:
    path, content = tmp_path / "file.json", json.loads(text_of(kind))
    rng = random.Random(kind)
    every = [
        p for p in paths_in(content)
        if p[-1] != "sha256" and not re.fullmatch(OPEN, "/".join(map(str, p)))
    ]  # fmt: skip
    deep = [p for p in every if len(p) > 1]
    tried = [p for p in every if len(p) == 1] + rng.sample(deep, min(12, len(deep)))
    wrong = [(where, other) for where in tried for other in changes(content, where)]
    wrong.append((("unheard",), {**content, "unheard": ""}))
    for where, other in wrong:
        path.write_text(json.dumps(signed(other)))
        try:
            found = ns.load(path)
            if isinstance(found, ns.Found):  # one wrong entry leaves the others
                _ = [each.orbit for each in found.orbits]
                _ = [each.equilibrium for each in found.equilibria]
        except InputError as problem:
            told = str(problem)
        else:
            pytest.fail(f"{where} is accepted")
        assert told.startswith(f"{path}: ")
        assert "\n" not in told


@pytest.mark.parametrize("kind", KINDS)
def test_no_cut_or_changed_byte_is_read(kind: str, tmp_path: Path) -> None:
    path, text = tmp_path / "file.json", text_of(kind)
    rng = random.Random(13)
    for _ in range(40):
        place = rng.randrange(len(text) - 1)
        letter = chr(rng.randrange(33, 127))
        changed = rng.choice([text[:place], text[:place] + letter + text[place + 1 :]])
        path.write_text(changed)
        try:
            same = json.loads(changed) == json.loads(text)
        except ValueError:
            same = False
        if not same:
            with pytest.raises(InputError):
                ns.load(path)


@pytest.mark.parametrize("cell", ["[]", "{}", "[[]]", '{"a":0}', "[[[[[0]]]]]"])
def test_text_of_brackets_takes_memory_like_any_other(cell: str, tmp_path: Path) -> None:
    path = tmp_path / "nested.json"
    path.write_text("[" + ",".join([cell] * 500_000) + "]")
    size = path.stat().st_size
    tracemalloc.start()
    try:
        with pytest.raises(InputError, match=r"nested.json"):
            ns.load(path)
        assert tracemalloc.get_traced_memory()[1] < 16 * size
    finally:
        tracemalloc.stop()

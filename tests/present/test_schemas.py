"""A kind of result is described once: files, answers, schemas and words follow from its record."""

from __future__ import annotations

import copy
import json
from collections.abc import Iterator
from dataclasses import dataclass, field
from fractions import Fraction
from pathlib import Path
from typing import Annotated, Any

import pytest
from jsonschema import Draft202012Validator

import nonsmooth as ns
from nonsmooth import InputError
from nonsmooth.runtime.core.json_codec import IN_FILES, Digits, Follows, FromOne, Told
from nonsmooth.runtime.core.registry import Certified
from nonsmooth.runtime.core.result_files import checksum_of
from nonsmooth.runtime.present import tell
from nonsmooth.runtime.present.files import kept, loading
from nonsmooth.runtime.present.told import Told as Words
from tests.core.test_result_files import KINDS, changes, paths_in, text_of


@dataclass(frozen=True, eq=False, kw_only=True)
class Beat:
    """A part of the toy."""

    phase: FromOne
    times: tuple[Digits, ...]


@dataclass(frozen=True, eq=False, kw_only=True, repr=False)
class Toy(Certified):
    """A kind of result that no module knows."""

    name: str
    share: Fraction
    beats: tuple[Beat, ...]
    seed: Annotated[int, IN_FILES] = field(default=0, repr=False)

    @Follows
    def count(self) -> int:
        """How many beats there are."""
        return len(self.beats)

    @Told
    def statement(self) -> str:
        """What is proved."""
        return f"{self.name} beats {self.count} times"


TOY = "nonsmooth toy"


def toy() -> Toy:
    beats = (Beat(phase=0, times=(0.1, 2.0)), Beat(phase=None, times=()))
    return Toy(name="drum", share=Fraction(1, 3), beats=beats, seed=7)


def told_of(found: Toy) -> Words:
    return f"toy {found.name}", [("claims", [found.statement])]


@pytest.fixture
def saved(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Path:
    """A file of the toy, after one entry for its file and one for its words."""
    kind = kept.KeptKind("toy", f"{__name__}:Toy", 1)
    monkeypatch.setitem(kept.KINDS, TOY, kind)
    monkeypatch.setitem(tell.KINDS, "Toy", told_of)
    toy().save(tmp_path / "toy.json")
    return tmp_path / "toy.json"


def test_a_new_kind_is_kept_answered_and_told(saved: Path) -> None:
    content = json.loads(saved.read_text())
    assert content["beats"] == [{"phase": 1, "times": ["0.1", "2.0"]}, {"phase": None, "times": []}]
    assert (content["share"], content["count"], content["seed"]) == ("1/3", 2, 7)
    again = ns.load(saved)
    assert (again.share, again.beats[0].phase, again.beats[0].times) == (
        Fraction(1, 3),
        0,
        (0.1, 2),
    )
    told = again.to_json()
    assert (told["statement"], told["count"], "seed" in told) == ("drum beats 2 times", 2, False)
    assert repr(again) == "toy drum\n  claims  drum beats 2 times"
    assert "drum beats 2 times" in again._repr_html_()


def test_no_entry_of_a_new_kind_is_damaged_unnoticed(saved: Path) -> None:
    content = json.loads(saved.read_text())
    paths = [path for path in paths_in(content) if path != ("sha256",)]
    wrong = [other for path in paths for other in changes(content, path) if path != ("seed",)]
    wrong += [{**content, "unheard": 1}, {**content, "count": 3}]
    assert len(wrong) > 20
    for other in wrong:
        saved.write_text(json.dumps({**other, "sha256": checksum_of(other)}))
        with pytest.raises(InputError, match=str(saved)):
            ns.load(saved)
    saved.write_text(
        json.dumps({**content, "count": 3, "sha256": checksum_of({**content, "count": 3})})
    )
    with pytest.raises(InputError, match="'count' is not what the other entries give"):
        ns.load(saved)


def test_a_new_kind_has_a_schema(saved: Path) -> None:
    schema = loading.file_schemas()[TOY]
    checked = Draft202012Validator(schema)
    content = json.loads(saved.read_text())
    assert checked.is_valid(content)
    assert not checked.is_valid({**content, "beats": [{"phase": "1", "times": []}]})


@pytest.mark.parametrize("kind", KINDS)
def test_files_are_as_their_schemas_say(kind: str) -> None:
    schema = loading.file_schemas()[kind]
    Draft202012Validator.check_schema(schema)
    checked, content = Draft202012Validator(schema), json.loads(text_of(kind))
    assert not list(checked.iter_errors(content))
    for other in misshapen(content):
        assert not checked.is_valid(other)


def misshapen(content: dict[str, Any]) -> Iterator[dict[str, Any]]:
    """Content without an entry, with one more, and with each entry of another type."""
    yield {**content, "unheard": 0}
    for name in content:
        if name == "request":
            continue
        other = copy.deepcopy(content)
        other[name] = [[other[name]]]
        yield other
        if name not in ("derivatives", "directions", "no_derivatives", "cones"):
            yield {entry: content[entry] for entry in content if entry != name}

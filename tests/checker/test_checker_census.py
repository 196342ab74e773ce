"""The check of a census: each orbit's certificate, and that they are of different orbits."""

from __future__ import annotations

import copy
import json
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner

import nonsmooth as ns
from nonsmooth.runtime.checker import Failure
from nonsmooth.runtime.checker.census import _apart, _check_side
from nonsmooth.runtime.cli.program import app
from nonsmooth.runtime.core.json_codec import decode
from nonsmooth.runtime.core.result_files import checksum_of
from nonsmooth.runtime.present.checking.check_file import Check
from nonsmooth.runtime.present.files.censuses import CensusEntries
from nonsmooth.runtime.present.files.certificates import certificate_of
from nonsmooth.runtime.proof.counting.census import Census, Counted, Open
from tests.certified import LOOP, kicked, signed, unhashed

_HEAD = ("format", "version", "package", "sha256")


@cache
def _census() -> Census:
    values, box = {"k": 9, "r": "1/3", "a": 10}, {"tau1": "2.5", "tau2": "2"}
    return ns.certify.all(kicked(), values, box, itinerary=LOOP)


@pytest.fixture
def content(tmp_path: Path) -> dict[str, Any]:
    """Of a file with two orbits: half a turn, and a whole one, on the right."""
    _census().save(tmp_path / "census.json")
    found: dict[str, Any] = json.loads((tmp_path / "census.json").read_text())
    assert found["count"] == 2
    return found


def checked(content: dict[str, Any], folder: Path) -> Check:
    """What the check says of changed content whose checksums are right."""
    for orbit in content["orbits"]:
        if orbit["certificate"] is not None:
            orbit["certificate"]["sha256"] = checksum_of(orbit["certificate"])
    path = folder / "changed.json"
    path.write_text(json.dumps(signed(content)))
    return ns.certify.check(path)


def test_the_certificates_are_proved_again_and_the_search_is_not(
    content: dict[str, Any], tmp_path: Path
) -> None:
    found = checked(content, tmp_path)
    assert found.difference is None
    assert found.note is not None
    assert "no other orbits was NOT proved again" in found.note
    assert found.claims == {"listed": "proved", "no others": "undecided"}
    assert isinstance(found.certificate, Census)
    # what nothing proves is not told either: why claims are undecided, and what the search tells
    told, known = (
        json.loads(unhashed([orbit.certificate.to_json() for orbit in census.orbits]))
        for census in (found.certificate, _census())
    )
    refuted = known[1]["reasons"]["admissibility"]
    assert "is reached from outside" in refuted
    assert "is reached from outside" not in json.dumps(told)
    for certificate in (*told, *known):
        del certificate["reasons"]
    assert told == known
    assert not found.certificate.decided
    assert "at least 2 orbits" in found.certificate.statement


@pytest.mark.parametrize(
    "change",
    [
        lambda c: c["conditions"].append("|x| <= 1e9 at the start of free"),
        lambda c: c.update(conditions=[]),
        lambda c: c["undecided"].append({"bounds": {"tau1": ["0", "1"]}, "reason": "too many"}),
        lambda c: c["orbits"].append({"unique": {}, "certificate": None, "reason": "singular"}),
        lambda c: c["orbits"][0].update(unique={}),
    ],
)
def test_what_the_search_alone_tells_is_not_told_again(
    content: dict[str, Any], tmp_path: Path, change: Any
) -> None:
    true = checked(content, tmp_path)
    change(content)
    content |= {"count": len(content["orbits"]), "decided": not content["undecided"]}
    whole = decode(CensusEntries, {n: content[n] for n in content if n not in _HEAD})
    content["statement"] = _told(whole)
    found = checked(content, tmp_path)
    assert found.difference is None
    assert isinstance(true.certificate, Census)
    assert isinstance(found.certificate, Census)
    assert unhashed(found.certificate.to_json()) == unhashed(true.certificate.to_json())
    assert (found.note, found.claims["no others"]) == (true.note, "undecided")


def _told(entries: CensusEntries) -> str:
    """The statement that follows from other entries."""
    orbits = tuple(
        Counted(each.unique, each.certificate and certificate_of(each.certificate))
        for each in entries.orbits
    )
    opened = tuple(Open(box.bounds, box.reason) for box in entries.undecided)
    return replace(
        _census(),
        orbit=entries.orbit,
        conditions=entries.conditions,
        orbits=orbits,
        undecided=opened,
    ).statement


def test_orbits_that_their_system_does_not_name_are_refused(
    content: dict[str, Any], tmp_path: Path
) -> None:
    assert checked(content, tmp_path).compared
    for part in (content, *(orbit["certificate"] for orbit in content["orbits"])):
        part["orbit"] = "elsewhere.py:loop"
    for orbit in content["orbits"]:
        orbit["certificate"]["sha256"] = checksum_of(orbit["certificate"])
    whole = decode(CensusEntries, {n: content[n] for n in content if n not in _HEAD})
    content["statement"] = _told(whole)
    assert "is no orbit of" in str(checked(content, tmp_path).difference)


def test_an_edited_file_is_refused(content: dict[str, Any], tmp_path: Path) -> None:
    content["count"] += 1
    path = tmp_path / "edited.json"
    path.write_text(json.dumps(content))
    difference = ns.certify.check(path).difference
    assert difference is not None
    assert "checksum" in difference


@pytest.mark.parametrize(
    ("change", "told"),
    [
        (lambda c: c["orbits"][1]["certificate"]["enclosures"]["trace"].update(mid="0.5"),
         "orbit 2: trace is not in its enclosure"),
        (lambda c: c["orbits"][0].update(unique={"tau1": ["0", "1"]}), "not where it was counted"),
        (lambda c: c["orbits"][0]["certificate"].update(system="other"), "something else"),
        (lambda c: c.update(orbits=[c["orbits"][0], copy.deepcopy(c["orbits"][0])], admissible=2),
         "may be one"),
        (lambda c: c["orbits"].pop(), "the count is not"),
        (lambda c: c["orbits"][0]["certificate"].update(declaration={}), "has no declaration"),
        (lambda c: c.update(statement="exactly 7 orbits"), "not what the other entries give"),
        (lambda c: c["orbits"][0]["certificate"]["parameters"].update(k="8"), "k is not that"),
    ],
)  # fmt: skip
def test_what_is_false_is_refused(
    content: dict[str, Any], tmp_path: Path, change: Any, told: str
) -> None:
    change(content)
    difference = checked(content, tmp_path).difference
    assert difference is not None
    assert told in difference


def test_the_command_says_what_was_proved_again(content: dict[str, Any], tmp_path: Path) -> None:
    assert checked(content, tmp_path).difference is None
    result = CliRunner().invoke(app, ["certify", "--check", str(tmp_path / "changed.json")])
    assert result.exit_code == 0
    told = " ".join(result.stdout.split())
    assert "2 orbits are proved again" in told
    assert "exactly" not in told
    assert "no other orbits was NOT proved again" in told
    content["orbits"][0]["certificate"]["enclosures"]["trace"]["mid"] = "0.5"
    checked(content, tmp_path)
    result = CliRunner().invoke(app, ["certify", "--check", str(tmp_path / "changed.json")])
    assert result.exit_code == 1
    assert "orbit 1: trace" in result.stderr


@pytest.mark.parametrize(
    ("side", "inside"),
    [("0.5 < tau", False), ("0.5 <= tau", True), ("0.25 < tau <= 0.5", True),
     ("0.75 <= tau", False), ("0 <= tau <= 0.25", False), ("0.5 < other", False)],
)  # fmt: skip
def test_a_side_that_is_open_is_not_reached(side: str, inside: bool) -> None:
    told = {"tau": {"mid": "0.5", "rad": "0"}}
    if inside:
        _check_side(side, told)
        return
    with pytest.raises(Failure):
        _check_side(side, told)


def _orbit(itinerary: str, **balls: tuple[str, str]) -> dict[str, Any]:
    """What a certificate of an orbit tells of these balls: two dwell times, x at the start."""
    whole = {"one": ("1", "0"), "two": ("2", "0"), "x": ("0", "0"), "period": ("3", "0")} | balls
    return {
        "declaration": {"phases": [{"dwell_time": n} for n in ("one", "two")], "start": ["x"]},
        "itinerary": [*itinerary],
        "enclosures": {name: {"mid": mid, "rad": rad} for name, (mid, rad) in whole.items()},
    }


TURNED = {"one": ("2", "0"), "two": ("1", "0")}
ALIKE = {"one": ("1.5", "1"), "two": ("1.5", "1")}


@pytest.mark.parametrize(
    ("itinerary", "first", "second", "apart"),
    [
        ("ab", {}, {}, False),
        ("ab", {}, TURNED, True),
        ("aa", {}, TURNED, False),  # the same motion, begun one phase later
        ("ab", {}, {"x": ("1", "0")}, True),
        ("aa", ALIKE, ALIKE | {"x": ("1", "0")}, False),  # where the other begins is not known
        ("aa", ALIKE, ALIKE | {"period": ("3.25", "0.25")}, False),
        ("aa", ALIKE, ALIKE | {"period": ("3.5", "0.25")}, True),
    ],
)
def test_orbits_are_apart_wherever_they_begin(
    itinerary: str, first: dict[str, Any], second: dict[str, Any], apart: bool
) -> None:
    one, other = _orbit(itinerary, **first), _orbit(itinerary, **second)
    assert _apart(one, other) == _apart(other, one) == apart

"""The codec of result files: each kind refuses whatever it did not write."""

from __future__ import annotations

import json
import random
from collections.abc import Callable, Mapping
from functools import cache
from pathlib import Path
from typing import Any

import pytest

import nonsmooth as ns
from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.result_files import checksum_of, format_in

STICK = "dry-friction/global-stick"
TWO_MASSES = {"m1": 1, "m2": 2, "k1": 1, "k2": 5, "r": 0.8}
FRICTION = {"chi": 0.4, "eta": 4, "V": 0.6773, "us1": 0.0127, "ur1": 0.0255, "us2": 0.5, "ur2": 1}


def composed() -> Any:
    phases = [("free", "first-reaches-stop")]
    return ns.solve(
        "rigid-stop", TWO_MASSES | {"r": 1}, [6.28], itinerary=phases, given={"period": "2*pi"}
    )


def found() -> Any:
    from nonsmooth.runtime.explore.finding.find import find_orbits

    return find_orbits("dry-friction", FRICTION, 8, transitions=300)


def branch() -> Any:
    return ns.continue_orbit(ns.solve(STICK), "V", (0.95, 1.05), step=0.1)


KINDS: dict[str, tuple[Callable[[], Any], Callable[[Path], Any]]] = {
    "nonsmooth orbit": (lambda: ns.solve(STICK), ns.load),
    "nonsmooth composed orbit": (composed, ns.load),
    "nonsmooth found orbits": (found, ns.load_found),
    "nonsmooth branch": (branch, ns.load_branch),
    "nonsmooth certificate": (lambda: ns.certify(ns.solve(STICK)), ns.load_certificate),
}


@cache
def text_of(kind: str, folder: Path) -> str:
    path = folder / "file.json"
    KINDS[kind][0]().save(path)
    return path.read_text()


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("files")


def signed(content: Mapping[str, Any]) -> str:
    return json.dumps({**content, "sha256": checksum_of(content)})


@pytest.mark.parametrize("kind", KINDS)
def test_no_entry_is_missing_unknown_or_of_another_type(kind: str, folder: Path) -> None:
    path, content = folder / "file.json", json.loads(text_of(kind, folder))
    read = KINDS[kind][1]
    path.write_text(signed(content))
    read(path)
    assert format_in(path) == kind
    changed = [({n: x for n, x in content.items() if n != name}, name) for name in content]
    changed += [({**content, name: None}, name) for name in content if name != "sha256"]
    changed.append(({**content, "note": ""}, "note"))
    for wrong, name in changed:
        path.write_text(signed(wrong) if name != "sha256" else json.dumps(wrong))
        with pytest.raises(InputError) as problem:
            read(path)
        told = str(problem.value)
        assert told.startswith(f"{path}: ")
        assert name in told or name in ("format", "version")


@pytest.mark.parametrize("kind", KINDS)
def test_no_cut_or_changed_byte_is_read(kind: str, folder: Path) -> None:
    path, text = folder / "file.json", text_of(kind, folder)
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
                KINDS[kind][1](path)

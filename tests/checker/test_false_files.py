"""Files that say what is not so, in all places at once: none of them is proved again."""

from __future__ import annotations

import copy
import json
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import pytest

import nonsmooth as ns
from nonsmooth import InputError
from nonsmooth.runtime.present.files.kept import save_result
from tests.certified import LOOP, kicked, loop
from tests.checker.test_mutations import renewed
from tests.file_shapes import KEPT, file_shapes
from tests.proof.test_parameter_derivatives import damped_at_zero

STICK = "dry-friction/global-stick"
BOX = {"V": ("0.99", "1.01")}


@cache
def written(name: str, folder: Path) -> str:
    """A file of a kind."""
    path = folder / f"{name}.json"
    match name:
        case "point":
            ns.certify(ns.solve(STICK)).save(path)
        case "symmetric":
            ns.certify(ns.solve("dry-friction/symmetric")).save(path)
        case "moving":
            ns.certify(ns.solve(STICK), derivatives=["eta", "e1"]).save(path)
        case "family":
            ns.certify(damped_at_zero(), derivatives=True).save(path)
        case "own":
            ns.certify(loop()).save(path)
        case "map":
            ns.certify.box(ns.solve(STICK), BOX).save(path)
        case "events":
            branch = ns.continue_orbit(ns.solve("dry-friction/symmetric"), "V", (0.6, 1.3))
            save_result([ns.certify.event(branch, event) for event in branch.events], path)
        case "census":
            ns.certify.all(STICK, box={"tau": 3, "tau1": 3}).save(path)
        case "two":
            values, box = {"k": 9, "r": "1/3", "a": 10}, {"tau1": "2.5", "tau2": "2"}
            ns.certify.all(kicked(), values, box, itinerary=LOOP).save(path)
    return path.read_text()


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("files")


def exchanged(content: Any, one: str, other: str) -> Any:
    """All names and texts with two words exchanged."""
    text = json.dumps(content)
    for old, new in ((one, "\0"), (other, one), ("\0", other)):
        text = text.replace(json.dumps(old), json.dumps(new))
    return json.loads(text)


def refusal(content: Any, path: Path) -> str | None:
    """What the check says of content with the right checksums."""
    path.write_text(json.dumps(renewed(content)))
    try:
        return ns.certify.check(path).difference
    except InputError as problem:
        return str(problem)


def census_at(content: Any) -> None:
    content["parameters"]["chi"] = "0.6"
    content["statement"] = content["statement"].replace("chi = 0.5", "chi = 0.6")


def smaller_box(content: Any) -> None:
    content["box"] = [side.replace("tau <= 3", "tau <= 1") for side in content["box"]]
    content["statement"] = content["statement"].replace("tau <= 3", "tau <= 1")


def one_more(content: Any) -> None:
    orbit = {"unique": content["orbits"][0]["unique"], "certificate": None, "reason": ""}
    content["orbits"].append(orbit)
    content["count"] = 2
    content["statement"] = content["statement"].replace("exactly 1 orbit", "exactly 2 orbits")


def event(content: Any, name: str, value: Any) -> None:
    content["events"][0][name] = value


def turned(content: Any, quantity: str, name: str) -> None:
    """A derivative with its sign turned."""
    found = content["derivatives"][quantity][name]
    middle = found["mid"]
    found["mid"] = middle[1:] if middle.startswith("-") else f"-{middle}"


def renamed(content: Any, old: str, new: str) -> None:
    """Derivatives that are said to be by another parameter, along the same direction."""
    for entry in (*content["derivatives"].values(), content["directions"]):
        entry[new] = entry.pop(old)


def no_family(content: Any) -> None:
    """Derivatives by a damping, with which there is no such orbit: as of the equations alone."""
    content["directions"]["c"] = {"c": "1"}
    for rates in content["derivatives"].values():
        rates["c"] = {"mid": "0", "rad": "1000"}


FALSE: dict[str, tuple[str, Callable[[Any], Any]]] = {
    "census at another parameter": ("census", census_at),
    "census in a smaller box": ("census", smaller_box),
    "census with an orbit without certificate": ("census", one_more),
    "names of the point": ("point", lambda c: exchanged(c, "x10", "x20")),
    "names of the map": ("map", lambda c: exchanged(c, "x10", "x20")),
    "names of the events": ("events", lambda c: exchanged(c, "x10", "x20")),
    "velocities of the point": ("point", lambda c: exchanged(c, "v10", "v20")),
    "dwell times of the point": ("point", lambda c: exchanged(c, "tau", "tau1")),
    "dwell times of the map": ("map", lambda c: exchanged(c, "tau", "tau2")),
    "dwell times of the events": ("events", lambda c: exchanged(c, "tau", "tau1")),
    "parameters of the point": ("point", lambda c: exchanged(c, "chi", "eta")),
    "parameters of the map": ("map", lambda c: exchanged(c, "V", "eta")),
    "label of the point": ("point", lambda c: exchanged(c, STICK, "dry-friction/symmetric")),
    "label of the map": ("map", lambda c: exchanged(c, STICK, "rigid-stop/one-impact")),
    "label of the census": ("census", lambda c: exchanged(c, STICK, "dry-friction/symmetric")),
    "a parameter of the point": ("point", lambda c: c["parameters"].update(eta="1.01")),
    "chosen": ("point", lambda c: c.update(chosen=["chi"])),
    "chosen in the map": ("map", lambda c: c.update(chosen=["e1"])),
    "a period": ("point", lambda c: c.update(given_period="7.87")),
    "a period that is true": ("own", lambda c: c.update(given_period="3*pi/2")),
    "V of an event": ("events", lambda c: c["events"][0]["parameters"].update(V="9")),
    "V of a map": ("map", lambda c: c["parameters"].update(V="9")),
    "multipliers twice": ("point", lambda c: c["multipliers"].append(c["multipliers"][0])),
    "another kind of event": ("events", lambda c: event(c, "kind", "fold")),
    "reasons": ("symmetric", lambda c: c.update(reasons={})),
    "a derivative of another sign": ("moving", lambda c: turned(c, "tau", "eta")),
    "a derivative of the trace": ("moving", lambda c: turned(c, "trace", "e1")),
    "a derivative of a multiplier": ("moving", lambda c: turned(c, "multiplier 1 re", "eta")),
    "a derivative of the start": ("moving", lambda c: turned(c, "x20", "e1")),
    "derivatives by others": ("moving", lambda c: renamed(c, "eta", "chi")),
    "derivatives by the same": ("moving", lambda c: renamed(c, "e1", "ur1")),
    "a direction that is longer": ("moving", lambda c: c["directions"].update(e1={"ur1": "2"})),
    "another direction": ("moving", lambda c: c["directions"].update(e1={"us1": "-1"})),
    "a direction of nothing": ("moving", lambda c: c["directions"].update(e1={})),
    "a direction of a period": ("moving", lambda c: c["directions"].update(e1={"period": "1"})),
    "no directions": ("moving", lambda c: c.pop("directions") and c),
    "derivatives of fewer": ("moving", lambda c: c["derivatives"].pop("tau") and c),
    "derivatives of no family": ("family", no_family),
}  # fmt: skip


@pytest.mark.parametrize("name", FALSE)
def test_false_files_are_refused(name: str, folder: Path, tmp_path: Path) -> None:
    kind, change = FALSE[name]
    content = json.loads(written(kind, folder))
    assert refusal(content, tmp_path / "same.json") is None
    changed = copy.deepcopy(content)
    changed = change(changed) or changed
    assert changed != content
    assert refusal(changed, tmp_path / "changed.json") is not None


def test_a_removed_orbit_is_not_counted(folder: Path, tmp_path: Path) -> None:
    content = json.loads(written("census", folder))
    content |= {"orbits": [], "count": 0, "admissible": 0}
    told = content["statement"].replace("exactly 1 orbit", "exactly 0 orbits")
    content["statement"] = told.replace("1 admissible", "0 admissible")
    assert "an orbit of the box is not listed" in str(refusal(content, tmp_path / "none.json"))


def test_a_file_names_no_system_of_another_place(folder: Path, tmp_path: Path) -> None:
    content = exchanged(json.loads(written("point", folder)), "dry-friction", "nowhere.py")
    assert "unknown system 'nowhere.py'" in str(refusal(content, tmp_path / "away.json"))


def test_names_that_are_there_twice_are_refused(folder: Path, tmp_path: Path) -> None:
    path = tmp_path / "twice.json"
    text = written("point", folder)
    path.write_text(text.replace('"chi": "0.5"', '"chi": "0.6", "chi": "0.5"', 1))
    with pytest.raises(InputError, match="'chi' is there twice"):
        ns.certify.check(path)


def test_what_is_undecided_has_no_numbers() -> None:
    branch = ns.continue_orbit(ns.solve("rigid-stop/one-impact"), "T", (5.5, 7.5))
    found = next(
        certificate
        for certificate in (ns.certify.event(branch, event) for event in branch.events)
        if not certificate.proved
    )
    with pytest.raises(InputError, match="undecided and has no value"):
        _ = found.value
    certificate = ns.certify(ns.solve("dry-friction/solution-ii"))
    with pytest.raises(InputError, match="existence is undecided"):
        _ = certificate.trace


@pytest.mark.parametrize("name", ["point", "events"])
def test_more_bits_than_digits_are_refused_before_anything_is_proved(
    name: str, folder: Path
) -> None:
    content = json.loads(written(name, folder))
    for told in content.get("events", [content]):
        told["bits"] *= 1000
    assert "128000 bits are more than the" in str(refusal(content, folder / "bits.json"))


def test_the_shapes_of_files_are_those_of_their_records() -> None:
    """Else `python -m tests.file_shapes` writes them anew."""
    assert json.loads(KEPT.read_text()) == file_shapes()

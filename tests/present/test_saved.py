"""Orbits in files: every digit comes back, whatever is not such a file is refused."""

import json
import os
from collections.abc import Callable
from fractions import Fraction
from functools import cache, partial
from pathlib import Path
from typing import Any

import mpmath
import pytest

import nonsmooth
from nonsmooth import InputError
from nonsmooth.runtime.core.result_files import checksum_of
from nonsmooth.runtime.model.kernels import orbit_names
from nonsmooth.runtime.orbits.orbit import Orbit

ORBIT = "dry-friction/global-stick"


@cache
def orbit() -> Orbit:
    return nonsmooth.solve(ORBIT, {"eta": "0.98", "us2": "4/5"})


@cache
def exchanged() -> Orbit:
    return nonsmooth.solve(
        ORBIT, {"chi": 0.5}, unknown=["e1", "e2"], given={"ta": 1, "tau": "2*pi/3"}
    )


def sealed(path: Path, content: dict[str, Any]) -> Path:
    """A file of changed content, its checksum made right."""
    path.write_text(json.dumps({**content, "sha256": checksum_of(content)}), encoding="utf-8")
    return path


@pytest.fixture
def path(tmp_path: Path) -> Path:
    return tmp_path / "orbit.json"


@pytest.fixture
def content(path: Path) -> dict[str, Any]:
    """What the file of an orbit holds."""
    orbit().save(path)
    found: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
    return found


def refusal(path: Path) -> str:
    """The one line with which a file is refused."""
    with pytest.raises(InputError) as caught:
        nonsmooth.load(path)
    message = str(caught.value)
    assert message.startswith(f"{path}: ")
    assert "\n" not in message
    return message.removeprefix(f"{path}: ")


# --- round trips


@cache
def collision() -> Orbit:
    return nonsmooth.solve(
        "dry-friction/solution-ii", {"us1": "1"}, unknown=["V"], given={"e1": "5/2"}
    )


MADE = {"orbit": orbit, "exchanged": exchanged, "collision": collision}
MADE |= {name: partial(nonsmooth.solve, name) for name in orbit_names()}


@pytest.mark.parametrize(
    ("name", "digits", "arithmetic"),
    [
        *((name, digits, "flint") for name in MADE for digits in (None, 60)),
        *(("orbit", 1, "flint"), ("orbit", 50, "mpmath"), ("exchanged", 3000, "flint")),
    ],
)
def test_every_orbit_comes_back(name: str, digits: int | None, arithmetic: str, path: Path) -> None:
    before = MADE[name]()
    if digits is not None:
        before = nonsmooth.refine(before, digits, arithmetic=arithmetic)
    before.save(path)
    after = nonsmooth.load(path)
    assert after == before
    for own in ("unknowns", "given", "opened"):
        assert list(getattr(after, own)) == list(getattr(before, own))
    assert [v.exact for v in after.given.values()] == [v.exact for v in before.given.values()]
    for own in ("precise", "period", "trace", "stability", "admissibility"):
        assert getattr(after, own) == getattr(before, own)
    assert after.dwell_times.tolist() == before.dwell_times.tolist()
    assert after.to_json() == before.to_json()
    assert (after.motion()([0.1, 5]) == before.motion()([0.1, 5])).all()
    given = next(iter(before.given))
    rates = [each.derivatives(given, one_sided=True).trace.tolist() for each in (after, before)]
    assert digits or rates[0] == rates[1]
    written = path.read_bytes()
    after.save(path)
    assert path.read_bytes() == written


def put(where: str, entry: object) -> Callable[[dict[str, Any]], None]:
    """Change that replaces an entry; "unknowns/tau" is one of a mapping."""
    *outer, name = where.split("/")

    def change(content: dict[str, Any]) -> None:
        for key in outer:
            content = content[key]
        content[name] = entry

    return change


@pytest.mark.parametrize(
    ("name", "where", "text", "part"),
    [
        ("rigid-stop/one-impact", "given/T", "3", "not a solution of rigid-stop/one-impact"),
        ("rigid-stop/one-impact", "given/T", "0", "T is outside its domain"),
        ("rigid-stop/one-impact", "given/r", "1", "rigid-stop/one-impact has T, k1,"),
        ("elastic-stop/one-contact", "unknowns/tau", "7", "dwell time tau1 is negative"),
        ("elastic-stop/one-contact", "given/k3", "-1", "k3 is outside its domain"),
        ("dry-friction/solution-ii", "unknowns/e1", "-1", "e1 is outside its domain"),
        ("dry-friction/solution-ii", "unknowns/ta", "0", "dry-friction/solution-ii has V, chi,"),
        ("dry-friction/symmetric", "opened/chi", "1/2", "unknown open parameter 'chi'"),
        ("dry-friction/symmetric", "opened/us1", "0", "us1 is outside its domain"),
        ("dry-friction/symmetric", "opened/ur2", "1/3", "us2 is outside its domain"),
        ("dry-friction/solution-ii", "opened/e1", "1", "unknown open parameter 'e1'"),
    ],
)
def test_wrong_content_of_other_orbits_is_refused(
    name: str, where: str, text: str, part: str, path: Path
) -> None:
    nonsmooth.solve(name).save(path)
    content = json.loads(path.read_text(encoding="utf-8"))
    put(where, text)(content)
    assert part in refusal(sealed(path, content))


def test_numbers_keep_their_precision(path: Path) -> None:
    sharp = nonsmooth.refine(orbit(), 60)
    sharp.save(path)
    again = nonsmooth.load(path)
    for name, number in sharp.unknowns.items():
        assert again.unknowns[name]._mpf_ == number._mpf_
        assert again.unknowns[name].context.prec == number.context.prec
    assert nonsmooth.refine(again, 80).unknowns == nonsmooth.refine(sharp, 80).unknowns


@pytest.mark.parametrize(
    "eta", [1, 0.98, Fraction(49, 50), "49/50", "0.9800", mpmath.mpf("0.98"), "sqrt(24)/5"]
)
def test_given_values_stay_as_they_were_written(eta: object, path: Path) -> None:
    found = nonsmooth.solve(ORBIT, {"eta": eta})
    found.save(path)
    assert nonsmooth.load(path).given["eta"].text == found.given["eta"].text
    assert nonsmooth.load(path) == found


def test_a_long_exact_value(path: Path) -> None:
    with mpmath.workdps(900):
        eta = 1 + mpmath.mpf(1) / 3**100
    found = nonsmooth.solve(ORBIT, {"eta": eta})
    assert len(found.given["eta"].text) > 1000
    found.save(path)
    assert nonsmooth.load(path) == found


def test_the_file_tells_where_it_is_from(content: dict[str, Any]) -> None:
    assert content["format"] == "nonsmooth orbit"
    assert content["version"] == 5
    assert content["package"] == nonsmooth.__version__
    assert content["derivation"] == orbit().kernels.system.module.DERIVATION
    assert content["given"]["eta"] == "0.98"
    assert content["opened"] == {"us2": "4/5"}
    assert content["unknowns"]["tau"] == repr(orbit().unknowns["tau"])
    assert content["sha256"] == checksum_of(content)


# --- files that are refused


def test_a_report_is_no_saved_orbit(path: Path) -> None:
    path.write_text(json.dumps(orbit().to_json()), encoding="utf-8")
    assert "not a saved result, such as --save or save() writes" in refusal(path)


def dropped(one: str, name: str) -> Callable[[dict[str, Any]], None]:
    return lambda content: content[one].pop(name)


def moved(one: str, other: str, name: str) -> Callable[[dict[str, Any]], None]:
    return lambda content: content[other].update({name: content[one].pop(name)})


@pytest.mark.parametrize(
    ("change", "part"),
    [
        (put("digits", True), "'digits' is of the wrong type"),
        (put("unknowns/tau", "nan"), "tau is nan, not a finite number"),
        (put("unknowns/tau", "-Infinity"), "tau is -Infinity, not a finite number"),
        (put("unknowns/tau", "two"), "tau is not a decimal number"),
        (put("unknowns/tau", "1e999999999"), "tau is too large or too small"),
        (put("residual", "nan"), "residual is nan"),
        (put("given/eta", "nan"), "'given/eta': 'nan' is not a number"),
        (put("given/eta", "1/0"), "division by zero"),
        (put("given/eta", "9" * 2000 + "x"), "'given/eta': "),
        (put("given/eta", "-1"), "eta is outside its domain"),
        (put("opened/us2", "0"), "us2 is outside its domain"),
        (put("opened/us3", "1"), "unknown open parameter 'us3'"),
        (put("unknowns/tau", "-2.0"), "dwell time tau is negative"),
        (put("unknowns/tau", "2.0"), "not a solution of dry-friction/global-stick"),
        (put("unknowns/tau", "2.0006e300"), "not a solution of dry-friction/global-stick"),
        (put("unknowns/tau", "1e307"), "not a solution of dry-friction/global-stick"),
        (put("given/eta", "0.97"), "not a solution of dry-friction/global-stick"),
        (put("orbit", "global-stik"), "did you mean 'global-stick'"),
        (put("system", "no-system"), "unknown system 'no-system'"),
        (dropped("unknowns", "tau"), "has V, chi, e1, e2, eta, ta, tau,"),
        (put("unknowns/tau9", "2"), "the file has V, chi, e1, e2, eta, ta, tau,"),
        (put("given/tau", "2"), "the file has"),
        (moved("unknowns", "given", "tau"), "the file has"),
        (put("unknowns", {}), "the file has"),
        (put("status", 2), "status is 2, which no saved orbit has"),
        (put("digits", -1), "digits is -1"),
        (put("digits", 16), "digits is 16"),
        (put("digits", 10**6), "digits is 1000000"),
        (put("iterations", -1), "iterations is -1"),
        (put("bits", 64), "bits is 64"),
        (put("arithmetic", "decimal"), "'arithmetic' is 'decimal'"),
    ],
)
def test_wrong_content_is_refused(
    change: Callable[[dict[str, Any]], None], part: str, path: Path, content: dict[str, Any]
) -> None:
    change(content)
    assert part in refusal(sealed(path, content))


def test_more_digits_than_there_are_are_refused(path: Path) -> None:
    nonsmooth.refine(orbit(), 30).save(path)
    content = json.loads(path.read_text(encoding="utf-8"))
    content["digits"] = 300
    assert "not a solution" in refusal(sealed(path, content))


def test_kernels_of_another_derivation_serve_if_the_orbit_solves_them(
    path: Path, content: dict[str, Any]
) -> None:
    content["derivation"] = "0123456789abcdef"
    assert nonsmooth.load(sealed(path, content)) == orbit()


def test_files_that_cannot_be_read(tmp_path: Path) -> None:
    assert refusal(tmp_path / "missing.json") == "cannot be read: no such file or directory"
    assert refusal(tmp_path).startswith("cannot be read: ")
    (tmp_path / "large").write_bytes(b'{"format": "nonsmooth orbit"')
    os.truncate(tmp_path / "large", 10**9)  # which takes no place on the disk
    assert refusal(tmp_path / "large") == "too large for a saved orbit"


# --- files that cannot be written


def test_no_orbit_is_not_saved(path: Path) -> None:
    lost = nonsmooth.solve(ORBIT, {"eta": "1e300"}, throw=False)
    with pytest.raises(InputError, match="is not saved: "):
        lost.save(path)
    assert not path.exists()

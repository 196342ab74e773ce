"""Orbits in files: every digit comes back, whatever is not such a file is refused."""

import json
from fractions import Fraction
from functools import cache, partial

import mpmath
import pytest

import nonsmooth
from nonsmooth import InputError
from nonsmooth.runtime.core.result_files import checksum_of
from nonsmooth.runtime.model.kernels import orbit_names

ORBIT = "dry-friction/global-stick"


@cache
def orbit():
    return nonsmooth.solve(ORBIT, {"eta": "0.98", "us2": "4/5"})


@cache
def exchanged():
    return nonsmooth.solve(
        ORBIT, {"chi": 0.5}, unknown=["e1", "e2"], given={"ta": 1, "tau": "2*pi/3"}
    )


def sealed(path, content):
    """A file of changed content, its checksum made right."""
    path.write_text(json.dumps({**content, "sha256": checksum_of(content)}), encoding="utf-8")
    return path


@pytest.fixture
def path(tmp_path):
    return tmp_path / "orbit.json"


@pytest.fixture
def content(path):
    """What the file of an orbit holds."""
    orbit().save(path)
    return json.loads(path.read_text(encoding="utf-8"))


def refusal(path):
    """The one line with which a file is refused."""
    with pytest.raises(InputError) as caught:
        nonsmooth.load(path)
    message = str(caught.value)
    assert message.startswith(f"{path}: ")
    assert "\n" not in message
    assert message.count(str(path)) == 1
    return message.removeprefix(f"{path}: ")


# --- round trips


@cache
def collision():
    return nonsmooth.solve(
        "dry-friction/solution-ii", {"us1": "1"}, unknown=["V"], given={"e1": "5/2"}
    )


@cache
def written():
    """Values as people write them, and one with more than a thousand digits."""
    with mpmath.workdps(900):
        long = 1 + mpmath.mpf(1) / 3**100
    kinds = {"V": 1, "us1": "0.9800", "us2": mpmath.mpf("0.98"), "e1": "sqrt(24)/5*3"}
    return nonsmooth.solve(ORBIT, {"eta": long, "chi": Fraction(49, 98), **kinds})


MADE = {"written": written, "orbit": orbit, "exchanged": exchanged, "collision": collision}
MADE |= {name: partial(nonsmooth.solve, name) for name in orbit_names()}


@pytest.mark.parametrize(
    ("name", "digits", "arithmetic"),
    [
        *((name, digits, "flint") for name in MADE for digits in (None, 60)),
        *(("orbit", 1, "flint"), ("orbit", 50, "mpmath"), ("exchanged", 3000, "flint")),
    ],
)
def test_every_orbit_comes_back(name, digits, arithmetic, path):
    before = MADE[name]()
    if digits is not None:
        before = nonsmooth.refine(before, digits, arithmetic=arithmetic)
    before.save(path)
    after = nonsmooth.load(path)
    assert after == before
    for own in ("unknowns", "given", "opened"):
        assert list(getattr(after, own)) == list(getattr(before, own))
    for own in ("given", "opened"):
        values = [[*getattr(each, own).values()] for each in (after, before)]
        assert [v.text for v in values[0]] == [v.text for v in values[1]]
        assert [v.exact for v in values[0]] == [v.exact for v in values[1]]
    for found, known in zip(after.unknowns.values(), before.unknowns.values(), strict=True):
        assert getattr(found, "_mpf_", found) == getattr(known, "_mpf_", known)
        if hasattr(known, "context"):
            assert found.context.prec == known.context.prec
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


def put(where, entry):
    """Change that replaces an entry; "unknowns/tau" is one of a mapping, "rows/0" one of a list."""
    *outer, last = (int(part) if part.isdigit() else part for part in where.split("/"))

    def change(content):
        for key in outer:
            content = content[key]
        content[last] = entry

    return change


def test_the_file_tells_where_it_is_from(content):
    assert content["format"] == "nonsmooth orbit"
    assert content["version"] == 5
    assert content["package"] == nonsmooth.__version__
    assert content["derivation"] == orbit().kernels.system.module.DERIVATION
    assert content["given"]["eta"] == "0.98"
    assert content["opened"] == {"us2": "4/5"}
    assert content["unknowns"]["tau"] == repr(orbit().unknowns["tau"])
    assert content["sha256"] == checksum_of(content)


# --- files that are refused


def moved(one, other, name):
    return lambda content: content[other].update({name: content[one].pop(name)})


NO_SOLUTION = "not a solution of dry-friction/global-stick"
NAMES = "the file has V, chi, e1, e2, eta, ta, tau,"
RIGID, ELASTIC = "rigid-stop/one-impact", "elastic-stop/one-contact"
SYMMETRIC, LIMIT = "dry-friction/symmetric", "dry-friction/solution-ii"


@pytest.mark.parametrize(
    ("name", "change", "part"),
    [
        ("", put("unknowns/tau", "nan"), "tau is nan, not a finite number"),
        ("", put("unknowns/tau", "two"), "tau is not a decimal number"),
        ("", put("unknowns/tau", "1e999999999"), "tau is too large or too small"),
        ("", put("residual", "nan"), "residual is nan"),
        ("", put("given/eta", "1/0"), "division by zero"),
        ("", put("given/eta", "9" * 2000 + "x"), "'given/eta': "),
        ("", put("given/eta", "-1"), "eta is outside its domain"),
        ("", put("opened/us2", "0"), "us2 is outside its domain"),
        ("", put("opened/us3", "1"), "unknown open parameter 'us3'"),
        ("", put("unknowns/tau", "-2.0"), "dwell time tau is negative"),
        ("", put("unknowns/tau", "2.0"), NO_SOLUTION),
        ("", put("unknowns/tau", "1e307"), NO_SOLUTION),
        ("", put("given/eta", "0.97"), NO_SOLUTION),
        ("", put("orbit", "global-stik"), "did you mean 'global-stick'"),
        ("", put("system", "no-system"), "unknown system 'no-system'"),
        ("", put("unknowns/tau9", "2"), NAMES),
        ("", moved("unknowns", "given", "tau"), NAMES),
        ("", put("status", 2), "status is 2, which no saved orbit has"),
        ("", put("digits", -1), "digits is -1"),
        ("", put("digits", 16), "digits is 16"),
        ("", put("digits", 10**6), "digits is 1000000"),
        ("", put("iterations", -1), "iterations is -1"),
        ("", put("bits", 64), "bits is 64"),
        ("", put("arithmetic", "decimal"), "'arithmetic' is 'decimal'"),
        ("sharp", put("digits", 300), NO_SOLUTION),
        (RIGID, put("given/T", "3"), "not a solution of rigid-stop/one-impact"),
        (RIGID, put("given/r", "1"), "rigid-stop/one-impact has T, k1,"),
        (ELASTIC, put("unknowns/tau", "7"), "dwell time tau1 is negative"),
        (LIMIT, put("unknowns/e1", "-1"), "e1 is outside its domain"),
        (LIMIT, put("opened/e1", "1"), "unknown open parameter 'e1'"),
        (SYMMETRIC, put("opened/us1", "0"), "us1 is outside its domain"),
        (SYMMETRIC, put("opened/ur2", "1/3"), "us2 is outside its domain"),
    ],
)
def test_wrong_content_is_refused(name, change, part, path):
    known = nonsmooth.refine(orbit(), 30) if name == "sharp" else MADE[name or "orbit"]()
    known.save(path)
    content = json.loads(path.read_text(encoding="utf-8"))
    change(content)
    assert part in refusal(sealed(path, content))


def test_kernels_of_another_derivation_serve_if_the_orbit_solves_them(path, content):
    content["derivation"] = "0123456789abcdef"
    assert nonsmooth.load(sealed(path, content)) == orbit()


def test_no_orbit_is_not_saved(path):
    lost = nonsmooth.solve(ORBIT, {"eta": "1e300"}, throw=False)
    with pytest.raises(InputError, match="is not saved: "):
        lost.save(path)
    assert not path.exists()

"""nonsmooth certify: claims, JSON, exit codes, files."""

import json

import pytest

import nonsmooth as ns
from tests.cli.test_cli import EXAMPLES, PROVING, answered, refused, run, told, with_fewer
from tests.user_systems import declare

pytestmark = pytest.mark.compiled  # much slower, or nothing to compare, without it

STICK, SYMMETRIC = "dry-friction/global-stick", "dry-friction/symmetric"


def certify(*arguments):
    return run("certify", *arguments)


def test_people_see_claims_reasons_and_margins():
    out = answered("certify", "dry-friction/symmetric")
    assert "stability refuted: a multiplier lies outside the unit circle" in out
    assert "left open: chosen for this proof" in out
    assert "first-reaches-belt" in out


@pytest.mark.parametrize(
    ("arguments", "code", "said"),
    [
        ([SYMMETRIC, "--require", "proved"], 3, "stability refuted"),
        (["dry-friction/solution-ii"], 1, ""),
        (["dry-friction/solution-ii", "--require", "proved"], 3, "existence undecided"),
        ([STICK, "--require", "proved"], 0, ""),
        (["box", STICK, "V=0.99:1.01", "--require", "proved"], 0, ""),
        (["box", SYMMETRIC, "V=0.7:0.71", "--require", "proved"], 3, "stability"),
        (["box", STICK, "V=30:50"], 1, "no "),
        (["event", "rigid-stop/one-impact", "T=5.5:7.5"], 1, ""),
        # of a box more than one percent, and of a branch all that is left, is undecided
        (["box", SYMMETRIC, "V=0.6:1.3", "--tiles", "5"], 1, ""),
        (["branch", SYMMETRIC, "V=0.9:1.2", "--tiles", "1"], 1, ""),
        (["branch", SYMMETRIC, "V=0.9:1.2", "--tiles", "1", "--require", "proved"], 3, "undecided"),
    ],
)
def test_exit_codes(arguments, code, said):
    found, _, err = certify(*arguments)
    assert found == code
    assert said in err
    assert len(err.splitlines()) == bool(said)


def test_an_orbit_is_certified_with_and_without_the_subcommand():
    short, long = (certify(*words, STICK, "--json") for words in ((), ("orbit",)))
    assert short == long
    assert short.code == 0


def test_without_an_orbit_the_help_is_shown():
    code, out, _ = certify()
    assert code == 2
    assert "doubling" in out


def test_derivatives_are_told_saved_and_proved_again(tmp_path):
    path = tmp_path / "proof.json"
    by = ("--derivatives", "eta,e1")
    proved = json.loads(answered("certify", STICK, *by, "--json", "--save", str(path)))
    assert proved["directions"] == {"eta": {"eta": "1"}, "e1": {"ur1": "1"}}
    sharp = ns.refine(ns.solve(STICK), 60).derivatives(["eta", "e1"])
    for quantity in ("tau", "trace", "period"):
        for name, rate in zip(sharp.by, sharp.quantity(quantity)[1], strict=True):
            found = proved["derivatives"][quantity][name]
            assert abs(rate - type(rate)(found["mid"])) < float(found["rad"]) < 1e-36
    shown = answered("certify", STICK, *by)
    assert "derivative" in shown
    assert "with e1 by 1 moves: ur1 by 1" in shown
    again = answered("certify", "check", str(path))
    rows = [line.split() for line in shown.splitlines() if line.strip().startswith("tau1 ")]
    assert rows
    for row in rows:
        if row[1] in ("eta", "e1"):
            assert " ".join(row[2:]) in " ".join(again.split())


def test_people_see_why_there_is_no_derivative():
    code, out, _ = certify("dry-friction/solution-ii", "--derivatives", "V")
    assert code == 1
    assert "no derivatives: by V: no orbit is proved to exist" in out


def test_a_users_orbit_is_certified_saved_and_checked(tmp_path):
    declare(tmp_path)
    path = tmp_path / "certificate.json"
    out = answered("certify", f"{tmp_path}/mine.py:loop", "k=9/4", "--save", str(path))
    assert f"{path} written" in out
    assert "every claim holds" in answered("certify", "check", str(path))
    assert told("certify", "check", str(path), "--require", "proved")["same"] is True


def test_a_check_that_differs_is_told(tmp_path):
    path = tmp_path / "certificate.json"
    ns.certify(ns.solve(STICK)).save(path)
    path.write_text(path.read_text().replace('"bits": 128', '"bits": 129', 1))
    assert "the checksum differs" in refused("certify", "check", str(path), code=1)
    assert told("certify", "check", str(path), code=1)["same"] is False


SAID = {
    "branch": ("consists of exactly these intervals and events", "flip"),
    "doubling": (
        *("certified doubling of dry-friction/symmetric along V", "subcritical"),
        "unstable above the flip",
    ),
    "box": ("existence proved", "100 % proved"),
}
FLIP = "certify doubling dry-friction/symmetric V=1.07:1.09 --tiles 1"


@pytest.mark.slow
@pytest.mark.parametrize("example", [line for line in EXAMPLES if line.startswith(PROVING)])
def test_what_is_proved_is_saved_drawn_and_checked(example, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (kind,) = (words for words in SAID if f" {words} " in example)
    found = run(*with_fewer(example).split()[1:], "--require", "proved")
    assert found.code == 0
    assert all(words in found.out for words in SAID[kind])
    (file,), (picture,) = tmp_path.glob("*.json"), tmp_path.glob("*.png")
    assert picture.stat().st_size > 1000
    check = run("certify", "check", str(file), "--require", "proved")
    assert check.code == 0
    assert "proved again from the file" in check.out


def test_a_time_ends_it_and_says_so(tmp_path):
    file = tmp_path / "short.json"
    found = run(*FLIP.split(), "--seconds", "1e-6", "--save", str(file))
    assert found.code == 1
    assert "ended: unfinished" in found.out
    assert "1e-06 s that were given are over" in found.out
    assert run("certify", "check", str(file)).code == 0

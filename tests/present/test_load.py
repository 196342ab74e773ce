"""One function reads every file of results, and every result is drawn or says why it is not."""

import json
import os
import re
import shutil

import pytest

import nonsmooth as ns
from nonsmooth import InputError
from nonsmooth.runtime.present.files.loading import file_schemas
from tests.cli.test_cli import run
from tests.core.test_result_files import KINDS, TWO_MASSES, file_of
from tests.present.test_saved import refusal, sealed

# a certified branch is a CertifiedBranch, and so on
TYPES = {kind: "".join(map(str.title, kind.split()[1:])) for kind in KINDS}
TYPES |= {"nonsmooth found orbits": "Found", "nonsmooth event certificate": "tuple"}
WITHOUT_PICTURE = {"nonsmooth certificate", "nonsmooth event certificate", "nonsmooth census"}
OF_KINDS = {"nonsmooth orbit", "nonsmooth found orbits"}
WITH_ORBIT = {"nonsmooth orbit", "nonsmooth design"}


def name_of(kind):
    return f"{kind.replace(' ', '-')}.json"


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Files of all kinds."""
    folder = tmp_path_factory.mktemp("results")
    for kind in KINDS:
        shutil.copyfile(file_of(kind), folder / name_of(kind))
    motion = ns.simulate("rigid-stop", TWO_MASSES, [0, 0, 1.5, 0], transitions=5)
    motion.save(folder / "motion.npz")
    motion.save(folder / "motion.csv")
    ns.chart("dry-friction/global-stick", V=[0.9, 1.0], store=folder / "line.zarr")
    return folder


def told(command):
    code, _, err = run(*command.split())
    return code, err


def test_every_kind_of_file_is_tried():
    assert {*file_schemas()} == {*KINDS}


@pytest.mark.parametrize("kind", KINDS)
def test_a_file_gives_what_was_saved(kind, folder, tmp_path):
    path, again = folder / name_of(kind), tmp_path / "again.json"
    found = ns.load(str(path))
    assert type(found).__name__ == TYPES[kind]
    (found[0] if isinstance(found, tuple) else found).save(again)
    if kind != "nonsmooth found orbits":  # whose orbits are solved again
        assert again.read_bytes() == path.read_bytes()
    # also where its entries stand in another order, as other programs write them
    content = json.loads(path.read_text())
    turned = {name: content[name] for name in reversed(content)}
    again.write_text(json.dumps(turned))
    assert type(ns.load(again)).__name__ == TYPES[kind]


def test_motions_and_charts_are_read_too(folder):
    for ending in ("npz", "csv"):
        motion = ns.load(folder / f"motion.{ending}")
        assert type(motion).__name__ == "Trajectory"
        assert motion.transitions == 5
    assert dict(ns.load(str(folder / "line.zarr")).sizes) == {"V": 2}


@pytest.mark.parametrize("name", [*map(name_of, KINDS), "motion.npz", "motion.csv", "line.zarr"])
def test_every_file_is_drawn_or_says_why_not(name, folder, tmp_path):
    picture = tmp_path / "picture.png"
    kind = "--kind time" if name in map(name_of, OF_KINDS) or "motion" in name else ""
    code, error = told(f"plot {folder / name} {kind} --out {picture}")
    if name in map(name_of, WITHOUT_PICTURE):
        assert code == 2
        assert "of which there is no picture: `nonsmooth certify check" in error
        assert error.count("\n") == 1
        assert not picture.exists()
    else:
        assert code == 0, error
        assert picture.read_bytes().startswith(b"\x89PNG")


@pytest.mark.parametrize("kind", [kind for kind in KINDS if kind != "nonsmooth found orbits"])
@pytest.mark.parametrize("command", ["list {}", "solve {}", "verify {} --digits 20", "certify {}"])
def test_a_file_that_has_one_orbit_stands_for_it(command, kind, folder):
    path = folder / name_of(kind)
    code, error = told(command.format(path))
    if kind in WITH_ORBIT:
        assert code in (0, 1), error  # 1: what is asked of it is undecided
    else:
        assert code == 2
        assert f"{path}: not a saved orbit" in error
        assert f"it is a {kind}" in error
        assert error.count("\n") == 1


def test_a_design_is_solved_where_it_ends(folder):
    path = folder / name_of("nonsmooth design")
    found, again = ns.load(path), ns.solve(str(path))
    assert float(again.given["V"]) == found.after["V"] == 1.05
    assert float(again.period) == pytest.approx(found.after["period"], rel=1e-12)


@pytest.mark.parametrize(
    ("content", "message"),
    [
        ("", "cut, or not JSON"),
        ("[1, 2]", "not a saved result"),
        ("{}", "not a saved result"),
        ('{"format": 3}', "not a saved result"),
        ('{"format": "nonsmooth chart"}', "its format is 'nonsmooth chart'"),
        ('{"format": "other", "a": 1}', "its format is 'other'"),
        ('{"format": "nonsmooth fit", "format": "nonsmooth design"}', "'format' is there twice"),
        ('{"format": "nonsmooth fit"}', "version None of the format"),
        (
            '{"format": "nonsmooth orbit", "version": 4}',
            "version 4 of the format, where 5 is known: use the release that wrote it",
        ),
        ("\x00\xff", "cut, or not JSON"),
        ("[" * 200_000, "cut, or not JSON"),
        ("9" * 10_000, "cut, or not JSON"),
        ("null", "not a saved result"),
        ('{"format": "nonsmooth orbit", "version": 5}', "is missing"),
    ],
)
def test_what_is_no_result_is_refused_in_one_line(content, message, tmp_path):
    path = tmp_path / "some.json"
    path.write_text(content, encoding="latin-1")
    assert message in refusal(path)
    code, error = told(f"plot {path} --out {tmp_path / 'a.png'}")
    assert (code, error.count("\n")) == (2, 1)
    assert message in error


@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("absent.json", "no such file"),
        ("absent.npz", "no such file"),
        ("empty", "no chart"),
        ("data.csv", "not a saved motion"),
        ("large.json", "too large for a saved"),
    ],
)
def test_what_is_not_there_or_foreign_is_refused(name, message, tmp_path):
    (tmp_path / "empty").mkdir()
    (tmp_path / "data.csv").write_text("t,x\n0,1\n")
    (tmp_path / "large.json").write_bytes(b'{"format": "nonsmooth orbit"')
    os.truncate(tmp_path / "large.json", 10**9)  # which takes no place on the disk
    with pytest.raises(InputError, match=re.escape(name)) as refused:
        ns.load(tmp_path / name)
    assert message in str(refused.value)
    assert "\n" not in str(refused.value)


@pytest.mark.parametrize("kind", ["nonsmooth fit", "nonsmooth design"])
def test_a_file_of_one_kind_is_not_read_as_another(kind, folder, tmp_path):
    content = json.loads((folder / name_of(kind)).read_text())
    path = tmp_path / "forged.json"
    for other in KINDS:
        if other != kind:
            refusal(sealed(path, {**content, "format": other}))

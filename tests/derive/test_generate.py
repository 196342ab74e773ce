"""`nonsmooth generate`: the folder of a user's kernels, compiled or not."""

import math
import shutil
import sysconfig

import numpy as np
import pytest

from nonsmooth import solve
from nonsmooth.runtime.model.kernels import load_orbit, load_system
from tests.cli.test_cli import answered, refused, run, told
from tests.user_systems import DAMPED, KICKED, declare

HEADERS = "admissible admissible_sums compiler elimination lanes newton search sums trigonometry"
FILES = [
    "PROVENANCE.json",
    "_kernels.c",
    "interrupt.h",
    *(f"kicked.{end}" for end in ["c", "h", "md", "py"]),
]
FILES += [f"nonsmooth_{header}.h" for header in HEADERS.split()]


@pytest.fixture(autouse=True)
def place(tmp_path, monkeypatch):
    """A folder of the test's own, which is where the commands run."""
    monkeypatch.setenv("NONSMOOTH_CACHE", str(tmp_path / "cache"))
    monkeypatch.chdir(tmp_path)
    return tmp_path


def generated(*arguments):
    return told("generate", *arguments)


def names(folder):
    return sorted(path.name for path in folder.iterdir())


def test_a_folder_holds_all_files_and_serves_every_command(place):
    declare(place)
    made = generated("mine.py", "--out", "kernels")
    assert made["system"] == "kicked"
    assert made["orbits"] == [{"name": "loop", "derived": True}]
    assert made["files"] == names(place / "kernels") == FILES
    assert "Again: nonsmooth generate mine.py --out DIR" in (place / "kernels/kicked.h").read_text()
    found = told("solve", "kernels:loop", "k=1/4", "r=1/3")
    assert float(found["unknowns"]["v0"]) == pytest.approx(1.5, rel=1e-14)
    assert float(found["period"]) == pytest.approx(2.5 * math.pi, rel=1e-14)
    assert found["stability"] == "stable"
    for system in ("mine.py", "kernels"):
        start = ["--from", "x=0,v=2", "--in", "right", "--transitions", "2"]
        times = told("simulate", system, "k=1", "r=1/2", *start)["times"]
        assert float(times[-1]) == pytest.approx(1.5 * math.pi, rel=1e-14)


@pytest.mark.slow
def test_a_second_run_changes_nothing_and_check_agrees(place):
    declare(place)
    assert len(generated("mine.py", "--out", "kernels")["written"]) == len(FILES)
    assert generated("mine.py", "--out", "kernels")["written"] == []
    assert run("generate", "mine.py", "--out", "kernels", "--check")[0] == 0
    declare(place, KICKED.replace("[[4]]", "[[9]]"))
    code, out, err = run("generate", "mine.py", "--out", "kernels", "--check")
    assert code == 1
    assert "kicked.py (derived)" in out
    assert err == "nonsmooth: kernels differs from mine.py: generate it again\n"
    assert len(generated("mine.py", "--out", "kernels")["written"]) > 1
    assert load_system("kernels").evaluate("fields", [1, 0.5])[3, 0] == -9


def test_what_a_renamed_system_leaves_behind_goes(place):
    declare(place)
    generated("mine.py", "--out", "kernels")
    declare(place, KICKED.replace('"kicked",\n', '"pushed",\n'))
    generated("mine.py", "--out", "kernels")
    renamed = sorted(name.replace("kicked", "pushed") for name in FILES)
    assert names(place / "kernels") == renamed


def test_a_damped_system_is_emitted_and_its_orbit_told(place):
    declare(place, DAMPED)
    code, out, err = run("generate", "mine.py", "--out", "kernels")
    assert code == 0
    assert "kernels/damped.c written" in out
    assert err.startswith("loop: composed numerically when it is asked for: ")
    assert not load_orbit("kernels:loop").derived
    assert generated("mine.py", "--out", "kernels")["orbits"][0]["derived"] is False


def test_a_foreign_folder_is_left_alone(place):
    declare(place)
    other = place / "other"
    other.mkdir()
    (other / "thesis.tex").write_text("everything")
    (place / "file").write_text("")
    record = other / "PROVENANCE.json"
    for content in (None, "{}", '{"command": "python scripts/regenerate.py", "files": {}}'):
        if content is not None:
            record.write_text(content)
        error = refused("generate", "mine.py", "--out", "other")
        assert "cannot write other: it holds other files" in error
    assert names(other) == ["PROVENANCE.json", "thesis.tex"]
    refused("generate", "mine.py", "--out", "file")
    generated("mine.py", "--out", "kernels")
    (place / "kernels" / "pushed.py").write_text("mine")
    declare(place, KICKED.replace('"kicked",\n', '"pushed",\n'))
    error = refused("generate", "mine.py", "--out", "kernels")
    assert (place / "kernels" / "pushed.py").read_text() == "mine"
    assert "pushed.py: `nonsmooth generate` did not write it" in error


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("none.py", "--out", "kernels"), "there is no file none.py"),
        (("mine.py:one", "--out", "kernels"), "no file mine.py:one: kernels are generated of all"),
        (("broken.py", "--out", "kernels"), "broken.py, line 1: NameError"),
        (("mine.py", "--out", "kernels", "--check", "--compile"), "leave out --compile"),
    ],
)
def test_wrong_input_is_one_line(place, arguments, message):
    declare(place)
    declare(place, "system = oscillator()\n", "broken.py")
    assert message in refused("generate", *arguments)
    assert not (place / "kernels").exists()


def test_the_equations_of_a_file(place):
    declare(place)
    out = answered("equations", "mine.py:loop", "--format", "markdown")
    assert "The orbit loop of the system kicked" in out
    assert answered("equations", "mine.py", "--format", "markdown")
    assert "did you mean 'mine.py:loop'" in refused("equations", "mine.py:lop")


# --- compiled ----------------------------------------------------------------------------

compiler = pytest.mark.skipif(
    shutil.which((sysconfig.get_config_var("CC") or "cc").split()[0]) is None,
    reason="no C compiler",
)


@pytest.mark.slow
@compiler
def test_compiled_kernels_are_used_and_agree(place, monkeypatch):
    monkeypatch.delenv("NONSMOOTH_BACKEND", raising=False)
    declare(place)
    made = generated("mine.py", "--out", "kernels", "--compile")
    library = place / made["written"][-1]
    assert names(place / "kernels") == sorted([*FILES, library.name])
    orbit = load_orbit("kernels:loop")
    assert orbit.system.compiled is not None
    assert orbit.solver is not None
    points = np.random.default_rng(5).uniform(0.2, 0.9, (7, 2))
    compiled = [orbit.system.evaluate(kernel, points) for kernel in ("fields", "rows", "resets")]
    found = solve("kernels:loop", {"k": 3})
    monkeypatch.setenv("NONSMOOTH_BACKEND", "numpy")
    plain = load_orbit("kernels:loop")
    assert plain.system.compiled is None
    for kernel, one in zip(("fields", "rows", "resets"), compiled, strict=True):
        np.testing.assert_allclose(plain.system.evaluate(kernel, points), one, rtol=1e-15)
    assert solve("kernels:loop", {"k": 3}).period == pytest.approx(found.period, rel=1e-15)
    # of another derivation: not used, and gone with the next run
    monkeypatch.delenv("NONSMOOTH_BACKEND")
    content = library.read_bytes()
    declare(place, KICKED.replace("[[4]]", "[[9]]"))
    generated("mine.py", "--out", "kernels")
    assert not library.exists()
    library.write_bytes(content)
    assert load_orbit("kernels:loop").system.compiled is None
    library.write_bytes(b"no library")
    assert load_orbit("kernels:loop").system.compiled is None


def test_without_a_compiler_one_line_says_so(place, monkeypatch):
    pytest.importorskip("setuptools")
    monkeypatch.setenv("CC", str(place / "no-compiler"))
    declare(place, DAMPED)
    error = refused("generate", "mine.py", "--out", "kernels", "--compile")
    assert "no compiled kernels: " in error
    assert "no-compiler" in error
    assert not (place / "kernels").exists()

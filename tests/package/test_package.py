"""The distribution: one top-level name, complete, importable anywhere, quick to start."""

import os
import shutil
import subprocess
import sys
import tarfile
import zipfile
from pathlib import Path

import pytest

import nonsmooth
from tests.places import CHECKOUT

FOLDERS = ("derive", "generated", "runtime")
PROGRAM = "import nonsmooth.runtime.cli.program as program; program.main()"
HEAVY = [
    *("dask", "flint", "jax", "matplotlib", "mpmath", "numpy"),
    *("scipy", "sympy", "torch", "typer", "xarray", "zarr"),
]


def run(*command, cwd, **environment):
    """Run a command without the network; on failure show what it said."""
    inherited = {name: text for name, text in os.environ.items() if name != "PYTHONPATH"}
    done = subprocess.run(
        [str(part) for part in command],
        cwd=cwd,
        env=inherited | {"PIP_NO_INDEX": "1", "PIP_DISABLE_PIP_VERSION_CHECK": "1"} | environment,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, f"{command}\n{done.stdout}\n{done.stderr}"
    return done.stdout


def build(kind, source, out, **environment):
    """Build an sdist or a wheel from a source tree and give its path."""
    options = ("--no-isolation", "--skip-dependency-check", f"--{kind}", "--outdir", out)
    run(sys.executable, "-m", "build", *options, source, cwd=out.parent, **environment)
    (built,) = out.iterdir()
    return built


def contents(wheel):
    """Names of the files in a wheel, without its metadata."""
    with zipfile.ZipFile(wheel) as archive:
        names = {name for name in archive.namelist() if not name.endswith("/")}
    return {name for name in names if ".dist-info/" not in name}


@pytest.fixture(scope="module")
def source(tmp_path_factory):
    """Copy the checkout without what was built in it."""
    copy = tmp_path_factory.mktemp("source") / "checkout"
    unwanted = (".*_cache", ".git", ".hypothesis", ".venv", "*.egg-info", "*.pyc", "*.so", "build")
    shutil.copytree(CHECKOUT, copy, ignore=shutil.ignore_patterns(*unwanted, "dist"))
    return copy


@pytest.fixture(scope="module")
def wheel(source, tmp_path_factory):
    """Build the wheel of the checkout, without the extension."""
    out = tmp_path_factory.mktemp("wheel") / "dist"
    return build("wheel", source, out, NONSMOOTH_WITHOUT_EXTENSION="1")


def install(wheel, target):
    """Install a wheel, without its dependencies, into a folder of its own."""
    options = ("--no-deps", "--no-index", "--quiet", "--target", target)
    run(sys.executable, "-m", "pip", "install", *options, wheel, cwd=target.parent)
    return target


@pytest.mark.slow
@pytest.mark.packaging
def test_wheel_has_one_top_level_name(wheel):
    assert {name.partition("/")[0] for name in contents(wheel)} == {"nonsmooth"}
    # The face is the package itself and appears nowhere else.
    assert not any(name.startswith("nonsmooth/runtime/face") for name in contents(wheel))
    assert not any(name.endswith((".so", ".pyd")) for name in contents(wheel))


@pytest.mark.packaging
def test_wheel_is_complete(source, wheel):
    suffixes = {".py", ".h", ".c", ".md", ".json", ".html", ".toml"}
    face = source / "runtime" / "face"
    expected = {f"nonsmooth/{path.name}" for path in (*face.glob("*.py"), face / "py.typed")}
    for folder in FOLDERS:
        expected |= {
            f"nonsmooth/{path.relative_to(source).as_posix()}"
            for path in (source / folder).rglob("*")
            if (path.suffix in suffixes or path.name == "py.typed") and "face" not in path.parts
        }
    assert contents(wheel) == expected


@pytest.mark.slow
@pytest.mark.packaging
def test_sdist_is_complete_and_gives_the_same_wheel(source, wheel, tmp_path):
    sdist = build("sdist", source, tmp_path / "dist")
    with tarfile.open(sdist) as archive:
        archive.extractall(tmp_path, filter="data")
    (unpacked,) = tmp_path.glob("nonsmooth-*")
    ours = {path.relative_to(source) for path in source.rglob("*") if path.is_file()}
    theirs = {path.relative_to(unpacked) for path in unpacked.rglob("*") if path.is_file()}
    kept = {path for path in ours if path.parts[0] in {*FOLDERS, "tests", "scripts", ".ci"}}
    kept |= {Path("LICENSE"), Path("README.md"), Path("pyproject.toml"), Path("setup.py")}
    assert kept <= theirs
    again = build("wheel", unpacked, tmp_path / "again", NONSMOOTH_WITHOUT_EXTENSION="1")
    assert contents(again) == contents(wheel)


@pytest.mark.slow
@pytest.mark.packaging
def test_installed_wheel_works_outside_the_checkout(wheel, tmp_path):
    target = install(wheel, tmp_path / "site")
    program = (
        "import nonsmooth, nonsmooth.derive, nonsmooth.runtime, nonsmooth.generated;"
        "print(nonsmooth.__file__, nonsmooth.__version__)"
    )
    told = run(sys.executable, "-c", program, cwd=tmp_path, PYTHONPATH=str(target))
    assert told.split() == [str(target / "nonsmooth" / "__init__.py"), nonsmooth.__version__]
    script = target / "bin" / "nonsmooth"
    assert "verify" in run(sys.executable, script, "--help", cwd=tmp_path, PYTHONPATH=str(target))


def imported_by(statement, tmp_path):
    """Top-level modules that a fresh process holds after a statement."""
    program = (
        "import sys\n"
        f"try:\n    {statement}\nexcept SystemExit as end:\n    assert not end.code\n"
        "print('MODULES', *{name.partition('.')[0] for name in sys.modules})"
    )
    told = run(sys.executable, "-c", program, cwd=tmp_path)
    return set(told.rpartition("MODULES")[2].split())


@pytest.mark.parametrize(
    ("statement", "allowed"),
    [
        ("import nonsmooth; dir(nonsmooth)", ()),
        ("import nonsmooth.derive", ()),
        (f"sys.argv[1:] = ['--help']; {PROGRAM}", ("typer",)),
        (f"sys.argv[1:] = ['--version']; {PROGRAM}", ("typer",)),
        (f"sys.argv[1:] = ['doctor', '--json']; {PROGRAM}",
         ("typer", "flint", "mpmath", "numpy")),
    ],
)  # fmt: skip
def test_nothing_heavy_is_imported(statement, allowed, tmp_path):
    modules = imported_by(statement, tmp_path)
    assert "nonsmooth" in modules
    assert not modules & {*HEAVY} - {*allowed}


@pytest.mark.parametrize("name", nonsmooth.__all__)
def test_public_names_exist(name):
    assert name in dir(nonsmooth)
    assert getattr(nonsmooth, name) is not None


def test_unknown_public_name_is_an_attribute_error():
    with pytest.raises(AttributeError, match="module 'nonsmooth' has no attribute 'sovle'"):
        _ = nonsmooth.sovle

"""The distribution: one top-level name, complete, importable anywhere, quick to start."""

import importlib
import os
import shutil
import subprocess
import sys
import tarfile
import venv
import zipfile
from pathlib import Path

import pytest

import nonsmooth
from tests.places import CHECKOUT

DEPENDENCIES = ("flint", "mpmath", "numpy", "rich", "scipy", "sympy", "typer")
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


@pytest.fixture(scope="module")
def unpacked(source, tmp_path_factory):
    """What the sdist of the checkout holds."""
    place = tmp_path_factory.mktemp("sdist")
    with tarfile.open(build("sdist", source, place / "dist")) as archive:
        archive.extractall(place, filter="data")
    (unpacked,) = place.glob("nonsmooth-*")
    return unpacked


@pytest.fixture(scope="module")
def compiled_wheel(unpacked, tmp_path_factory):
    """The compiled wheel of the sdist: that of .ci/run, or one that is built here."""
    if built := os.environ.get("NONSMOOTH_WHEEL"):
        return Path(built)
    place = tmp_path_factory.mktemp("compiled")
    compiler = place / "cc"  # the last -O counts: to optimise takes most of the time
    compiler.write_text('#!/bin/sh\nexec cc "$@" -O0\n')
    compiler.chmod(0o755)
    needed = {"NONSMOOTH_NEEDS_EXTENSION": "1", "CC": str(compiler)}
    return build("wheel", unpacked, place / "dist", **needed)


def wheel_of(source):
    """Names of the files that a wheel of a source tree has, without compiled ones."""
    suffixes = {".py", ".h", ".c", ".md", ".json", ".html", ".toml"}
    face = source / "runtime" / "face"
    expected = {f"nonsmooth/{path.name}" for path in (*face.glob("*.py"), face / "py.typed")}
    for folder in FOLDERS:
        expected |= {
            f"nonsmooth/{path.relative_to(source).as_posix()}"
            for path in (source / folder).rglob("*")
            if (path.suffix in suffixes or path.name == "py.typed") and "face" not in path.parts
        }
    return expected


@pytest.mark.packaging
def test_wheel_has_one_top_level_name_and_all_that_is_below(source, wheel):
    assert contents(wheel) == wheel_of(source)


@pytest.mark.slow
@pytest.mark.packaging
@pytest.mark.compiled
def test_sdist_is_complete_and_gives_the_same_wheel(source, unpacked, compiled_wheel):
    ours = {path.relative_to(source) for path in source.rglob("*") if path.is_file()}
    theirs = {path.relative_to(unpacked) for path in unpacked.rglob("*") if path.is_file()}
    kept = {path for path in ours if path.parts[0] in {*FOLDERS, "tests", "scripts", ".ci"}}
    kept |= {Path("LICENSE"), Path("README.md"), Path("pyproject.toml"), Path("setup.py")}
    assert kept <= theirs
    assert wheel_of(source) < contents(compiled_wheel)
    compiled = contents(compiled_wheel) - wheel_of(source)
    assert [Path(name).suffix in (".so", ".pyd") for name in compiled] == [True, True]


def environment_without_compiler(place):
    """Python of a fresh environment that has the dependencies and nothing else."""
    venv.create(place, with_pip=False)
    python = place / "bin" / "python"
    told = "import sysconfig; print(sysconfig.get_path('purelib'))"
    site = Path(run(python, "-c", told, cwd=place).strip())
    modules = [importlib.import_module(name) for name in DEPENDENCIES]
    homes = {str(Path(str(module.__file__)).parents[1]) for module in modules}
    (site / "dependencies.pth").write_text("\n".join(sorted(homes)), encoding="utf-8")
    return python


@pytest.mark.slow
@pytest.mark.packaging
@pytest.mark.compiled
@pytest.mark.skipif(sys.platform != "linux", reason="auditwheel repairs wheels of Linux")
def test_repaired_wheel_works_without_a_compiler(compiled_wheel, tmp_path):
    pytest.importorskip("auditwheel")
    tools = os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])
    repair = ("auditwheel", "repair", "--wheel-dir", tmp_path / "repaired", compiled_wheel)
    run(sys.executable, "-m", *repair, cwd=tmp_path, PATH=tools)
    (repaired,) = (tmp_path / "repaired").glob("*.whl")
    assert "manylinux" in repaired.name or "musllinux" in repaired.name
    assert "-cp311-abi3-" in repaired.name  # it serves all later versions of Python

    python = environment_without_compiler(tmp_path / "fresh")
    install = ("--python", python, "install", "--quiet", "--no-index", "--no-deps", repaired)
    run(sys.executable, "-m", "pip", *install, cwd=tmp_path)
    bare = {"PATH": str(python.parent), "CC": "", "HOME": str(tmp_path)}
    assert not any(shutil.which(name, path=bare["PATH"]) for name in ("cc", "gcc", "clang"))
    told = run(python, CHECKOUT / ".ci/smoke.py", cwd=tmp_path, **bare).splitlines()
    assert all(str(tmp_path / "fresh") in line for line in told[:2])
    program = "import nonsmooth, nonsmooth.derive; print(nonsmooth.__version__)"
    assert run(python, "-c", program, cwd=tmp_path, **bare).strip() == nonsmooth.__version__
    assert "verify" in run(python.with_name("nonsmooth"), "--help", cwd=tmp_path, **bare)


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

"""The wheel for other machines, and what is said of the package in several places."""

import importlib
import os
import shutil
import sys
import tomllib
import venv
from pathlib import Path

import pytest
import yaml

from tests.package.test_package import run
from tests.places import CHECKOUT

PROJECT = tomllib.loads((CHECKOUT / "pyproject.toml").read_text(encoding="utf-8"))
DEPENDENCIES = ("flint", "mpmath", "numpy", "rich", "scipy", "sympy", "typer")


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


def built_wheel(place):
    """The compiled wheel of the sdist: that of .ci/run, or one that is built here."""
    if built := os.environ.get("NONSMOOTH_WHEEL"):
        return Path(built)
    source = place / "checkout"
    unwanted = shutil.ignore_patterns(".*_cache", ".git", ".venv", "*.so", "build", "dist")
    shutil.copytree(CHECKOUT, source, ignore=unwanted)
    options = ("--no-isolation", "--skip-dependency-check", "--outdir", place / "dist")
    needed = {"NONSMOOTH_NEEDS_EXTENSION": "1"}
    run(sys.executable, "-m", "build", *options, source, cwd=place, **needed)
    (wheel,) = (place / "dist").glob("*.whl")
    assert list((place / "dist").glob("*.tar.gz"))
    return wheel


@pytest.mark.slow
@pytest.mark.packaging
@pytest.mark.compiled
@pytest.mark.skipif(sys.platform != "linux", reason="auditwheel repairs wheels of Linux")
def test_repaired_wheel_works_without_a_compiler(tmp_path):
    pytest.importorskip("auditwheel")
    wheel = built_wheel(tmp_path)
    tools = os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])
    repair = ("auditwheel", "repair", "--wheel-dir", tmp_path / "repaired", wheel)
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


def test_recipe_and_citation_say_what_the_project_says():
    recipe = yaml.safe_load((CHECKOUT / "recipe/recipe.yaml").read_text(encoding="utf-8"))
    citation = yaml.safe_load((CHECKOUT / "CITATION.cff").read_text(encoding="utf-8"))
    project = PROJECT["project"]
    assert recipe["context"]["version"] == citation["version"] == project["version"]
    runs = [entry.replace(" ", "") for entry in recipe["requirements"]["run"]]
    assert sorted(runs) == sorted(["python", *project["dependencies"]])
    host = [entry.replace(" ", "") for entry in recipe["requirements"]["host"]]
    assert set(PROJECT["build-system"]["requires"]) < set(host)
    assert recipe["about"]["summary"] == project["description"]
    assert recipe["about"]["license"] == citation["license"] == project["license"]
    assert citation["abstract"].rstrip(".") == project["description"]


def test_workflows_are_read_and_run_what_is_there():
    folder = CHECKOUT / ".github" / "workflows"
    flows = {path.stem: yaml.safe_load(path.read_text("utf-8")) for path in folder.glob("*.yml")}
    assert set(flows) == {"docs", "release", "tests"}
    for flow in flows.values():
        assert flow["permissions"] == {"contents": "read"}
        for job in flow["jobs"].values():
            for step in job["steps"]:
                for word in step.get("run", "").split():
                    if word.startswith((".ci/", "tests/", "docs")):
                        assert (CHECKOUT / word).exists(), word
    publish = flows["release"]["jobs"]["publish"]
    assert publish["permissions"] == {"id-token": "write"}
    assert publish["environment"] == "release"

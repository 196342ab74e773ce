"""Compiled kernels of declarations: made beside the work, kept where nobody else writes."""

import logging
import os
import shutil
import signal
import subprocess
import sys
import time

import numpy as np
import pytest

from nonsmooth import solve
from nonsmooth.runtime.model.kernels import load_orbit
from nonsmooth.runtime.model.loading import background, caching
from nonsmooth.runtime.model.loading import load as loading
from tests.user_systems import KICKED, declare

compiler = pytest.mark.skipif(background.lacking() is not None, reason=str(background.lacking()))
posix = pytest.mark.skipif(os.name != "posix", reason="processes are grouped on POSIX alone")
K = np.linspace(0.5, 2, 7)


def asked(folder, source, flags):
    """A process that has kernels compiled into a folder: it prints what it is told by them."""
    code = (
        "import sys; import nonsmooth as ns;"
        "found = ns.solve(sys.argv[1], dict(k=[0.5 + place / 9 for place in range(20)]));"
        "print(found.problem.kernels.system.compiled is not None, found.trace.tobytes().hex())"
    )
    environment = {"NONSMOOTH_CACHE": str(folder), "NONSMOOTH_BACKEND": "c", "CFLAGS": flags}
    command = [sys.executable, "-c", code, f"{source}:loop"]
    return subprocess.Popen(
        command, env=os.environ | environment, stdout=subprocess.PIPE, text=True
    )


@pytest.fixture(scope="module")
def library(tmp_path_factory):
    """A cache folder in which another process has put the compiled kernels."""
    folder = tmp_path_factory.mktemp("library")
    path = declare(folder)
    # two at once do not disturb each other
    both = [asked(folder / "cache", path, "-O0") for _ in range(2)]
    one, other = (process.communicate()[0] for process in both)
    assert one == other
    assert one.startswith("True ")
    assert not list((folder / "cache").glob("*.partial"))
    return folder / "cache"


@pytest.fixture(autouse=True)
def cache(tmp_path, monkeypatch):
    """A cache folder of the test's own, and a process that knows nothing yet."""
    monkeypatch.setenv("NONSMOOTH_CACHE", str(tmp_path / "cache"))
    monkeypatch.delenv("NONSMOOTH_BACKEND", raising=False)
    monkeypatch.setattr(loading, "_MODULES", caching.Modules(9))
    for name in ("_FILES", "_LIBRARIES"):
        monkeypatch.setattr(loading, name, {})
    loading._file.cache_clear()
    return tmp_path / "cache"


@pytest.fixture
def filled(library, cache):
    """The test's own folder with the compiled kernels in it; gives their file."""
    shutil.copytree(library, cache)
    (found,) = cache.glob("*.so")
    return found


def compiled(orbit):
    return load_orbit(orbit).system.compiled is not None


@pytest.mark.slow
@compiler
def test_bits_are_the_same_at_every_level_of_optimisation(tmp_path, library):
    path = declare(tmp_path)
    told = [asked(tmp_path / flags, path, flags) for flags in ("", "-O1")]
    told.append(asked(library, path, ""))
    first, *others = (process.communicate()[0] for process in told)
    assert first.startswith("True ")
    assert others == [first, first]


@compiler
def test_another_declaration_has_no_compiled_kernels(tmp_path, filled):
    assert compiled(f"{declare(tmp_path)}:loop")
    assert not compiled(f"{declare(tmp_path, KICKED.replace('[[4]]', '[[9]]'), 'other.py')}:loop")
    same = declare(tmp_path, f"# a comment\n{KICKED}", "same.py")
    assert compiled(f"{same}:loop")


@compiler
def test_kernels_for_wider_vectors_are_not_loaded(tmp_path, filled, monkeypatch):
    monkeypatch.setattr(background, "vectors", lambda: "none")
    assert not compiled(f"{declare(tmp_path)}:loop")


@compiler
@pytest.mark.parametrize("damage", ["cut", "other", "written by others", "link"])
def test_what_is_damaged_or_open_to_others_is_not_loaded(tmp_path, filled, damage):
    content = filled.read_bytes()
    if damage == "cut":
        filled.write_bytes(content[: len(content) // 2])
    elif damage == "other":
        filled.write_bytes(content[:-1] + b"x")
    elif damage == "link":
        filled.rename(tmp_path / "elsewhere.so")
        filled.symlink_to(tmp_path / "elsewhere.so")
    else:
        filled.chmod(0o622)
    assert not compiled(f"{declare(tmp_path)}:loop")


@compiler
def test_a_folder_that_others_can_write_is_not_used(tmp_path, filled, monkeypatch, capfd):
    begun = []
    monkeypatch.setattr(background.subprocess, "Popen", lambda *a, **k: begun.append("process"))
    filled.parent.chmod(0o777)
    orbit = f"{declare(tmp_path)}:loop"
    monkeypatch.setenv("NONSMOOTH_BACKEND", "c")
    assert solve(orbit, {"k": K}).converged.all()
    assert not compiled(orbit)
    monkeypatch.setenv("NONSMOOTH_CACHE", "")
    assert solve(orbit, {"r": K / 3}).converged.all()
    assert not begun
    assert "others can write" in capfd.readouterr().err


@pytest.mark.slow
@posix
@compiler
def test_a_failed_compilation_is_told_once_and_nothing_else_changes(
    tmp_path, cache, monkeypatch, caplog, capfd
):
    monkeypatch.setenv("CC", "/bin/false")
    monkeypatch.setenv("NONSMOOTH_BACKEND", "c")
    orbit = f"{declare(tmp_path)}:loop"
    with caplog.at_level(logging.INFO, "nonsmooth"):
        for _ in range(3):
            assert solve(orbit, {"k": K}).converged.all()
    assert not compiled(orbit)
    assert [record.getMessage() for record in caplog.records] == [
        "kernels are not compiled and run on NumPy: InputError: no compiled kernels:"
        " /bin/false fails; without them the kernels run on NumPy"
    ]
    assert capfd.readouterr().err == ""
    assert {path.suffix for path in cache.iterdir()} == {".py"}, "no library, nothing half made"


def test_without_a_compiler_no_process_begins(tmp_path, monkeypatch, caplog, capfd):
    monkeypatch.setenv("CC", str(tmp_path / "none"))
    monkeypatch.setenv("NONSMOOTH_BACKEND", "c")
    monkeypatch.setattr(background.subprocess, "Popen", lambda *a, **k: pytest.fail("begun"))
    with caplog.at_level(logging.INFO, "nonsmooth"):
        assert solve(f"{declare(tmp_path)}:loop", {"k": K}).converged.all()
    assert len(caplog.records) == 1
    assert capfd.readouterr().err == ""


def test_few_points_are_not_worth_a_compilation(tmp_path, monkeypatch):
    monkeypatch.setattr(background, "_begin", lambda *_: pytest.fail("begun"))
    assert solve(f"{declare(tmp_path)}:loop", {"k": K}).converged.all()
    assert solve(f"{tmp_path / 'mine.py'}:loop").converged


def waiting(monkeypatch, cache):
    """A library whose process makes its folder, and then does nothing."""
    cache.mkdir(mode=0o700)
    code = "import pickle, sys, time; pickle.load(sys.stdin.buffer)[1].mkdir(); time.sleep(600)"
    monkeypatch.setattr(background, "_CHILD", code)
    monkeypatch.setattr(background, "lacking", lambda: None)
    library = background.KernelLibrary("k" * 16, "d" * 16, "kicked")
    library.declare(lambda: ("system", ()))
    assert library.wanted(1.0) is None
    until = time.monotonic() + 300
    while not list(cache.glob("*.partial")) and time.monotonic() < until:
        time.sleep(0.02)
    assert list(cache.glob("*.partial"))
    return library


@posix
def test_a_killed_compilation_leaves_nothing(cache, monkeypatch):
    library = waiting(monkeypatch, cache)
    process = library._building.process  # it is building
    assert library.module() is None  # it goes on
    os.kill(process.pid, signal.SIGKILL)
    process.wait()
    assert library.module() is None
    assert not list(cache.iterdir())
    assert library.wanted(9.0) is None  # it is tried once
    assert library._building is None


@posix
def test_who_interrupts_the_wait_ends_the_compilation(cache, monkeypatch):
    library = waiting(monkeypatch, cache)
    process = library._building.process  # it is building
    wait, calls = process.wait, []

    def interrupted(timeout=None):
        calls.append(timeout)
        if len(calls) == 1:
            raise KeyboardInterrupt
        return wait(timeout)

    monkeypatch.setattr(process, "wait", interrupted)
    with pytest.raises(KeyboardInterrupt):
        library.wanted(9.0)
    assert process.poll() == -signal.SIGKILL
    assert not list(cache.iterdir())
    # an interrupt does not decide which way later points are solved
    begun = []
    monkeypatch.setattr(background, "_begin", lambda *_, **__: begun.append("again"))
    assert library.wanted(1.0) is None
    assert begun == ["again"]


def test_libraries_of_one_key_are_told_apart_by_their_content(cache):
    for content in (b"one", b"two"):
        caching.store_library("key", "_kernels.abi3.so", content)
    assert len(list(cache.iterdir())) == 2
    assert caching.stored_library("other") is None
    found = caching.stored_library("key")
    found.write_bytes(b"three")
    second = caching.stored_library("key")
    assert second != found

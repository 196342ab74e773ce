"""Writing files: whole or not at all, in place of files alone, folders as such."""

import errno
import os
import signal
import stat
import subprocess
import sys
import time
from pathlib import Path

import pytest

from nonsmooth import InputError
from nonsmooth.runtime.core.files import (
    check_folder,
    check_target,
    folder_made,
    read_file,
    write_file,
    write_files,
)

FILES = {"a": b"new a", "b": b"new b", "record": b"new record"}


def full(*_):
    raise OSError(errno.ENOSPC, "No space left on device")


def contents(folder):
    return {path.name: path.read_bytes() for path in folder.iterdir()}


@pytest.mark.parametrize("name", ["file", "new/folder/file", "x" * 255, "x" * 200 + "/y"])
def test_a_file_and_the_folders_above_it_are_made(name, tmp_path):
    path = tmp_path / name
    check_target(path)
    write_file(path, b"one")
    write_file(path, b"two")
    assert contents(path.parent) == {path.name: b"two"}


def test_a_link_and_permissions_stay(tmp_path):
    target, link, far = tmp_path / "target", tmp_path / "link", tmp_path / "far"
    target.write_bytes(b"one")
    target.chmod(0o640)
    link.symlink_to(target)
    write_file(link, b"two")
    assert link.is_symlink()
    assert target.read_bytes() == b"two"
    assert stat.S_IMODE(target.stat().st_mode) == 0o640
    far.symlink_to(tmp_path / "not" / "there")
    write_file(far, b"three")
    assert (tmp_path / "not" / "there").read_bytes() == b"three"


def test_a_folder_that_cannot_be_made(tmp_path):
    (tmp_path / "nowhere").symlink_to(tmp_path / "absent")
    with (
        pytest.raises(InputError, match=r"cannot write .*file exists"),
        folder_made(tmp_path / "nowhere" / "below"),
    ):
        pass
    with pytest.raises(KeyError), folder_made(tmp_path / "a" / "b"):
        raise KeyError
    assert os.listdir(tmp_path) == ["nowhere"]


def test_what_is_no_file_is_refused_and_stays(tmp_path):
    os.mkfifo(tmp_path / "pipe")
    (tmp_path / "device").symlink_to("/dev/full")
    (tmp_path / "loop").symlink_to(tmp_path / "loop")
    (tmp_path / "file").write_bytes(b"mine")
    before = sorted(os.listdir(tmp_path))
    for name, told in (
        ("pipe", "it is a device or a pipe, not a file"),
        ("device", "it is a device or a pipe, not a file"),
        ("loop", "too many"),
        ("", "it is a folder"),
        ("file/below", "file is not a folder"),
        ("file/far/below", "file is not a folder"),
        ("x" * 256, "file name too long"),
        ("x" * 256 + "/below", "file name too long"),
        ("a\0b", "null (byte|character)"),
    ):
        for refuse in (check_target, lambda path: write_file(path, b"")):
            with pytest.raises(InputError, match=f"cannot write .*{told}"):
                refuse(tmp_path / name)
        if name:
            with pytest.raises(InputError, match="cannot write"):
                check_folder(tmp_path / name)
    assert sorted(os.listdir(tmp_path)) == before
    for name in ("pipe", "device"):
        with pytest.raises(InputError, match="it is a device or a pipe, not a file"):
            read_file(tmp_path / name, 10, "thing")
    write_file(tmp_path / "ten", b"0123456789")
    assert len(read_file(tmp_path / "ten", 10, "thing")) == 10
    with pytest.raises(InputError, match="too large"):
        read_file(tmp_path / "ten", 9, "thing")


def test_the_file_that_the_output_goes_to_is_refused(tmp_path):
    code = (
        "import pathlib, sys\n"
        "from nonsmooth.runtime.core.files import write_file\n"
        "try:\n"
        "    write_file(pathlib.Path(sys.argv[1]), b'lost')\n"
        "except ValueError as problem:\n"
        "    print(problem)\n"
    )
    for name in ("/dev/stdout", str(tmp_path / "out")):
        with (tmp_path / "out").open("w") as out:
            subprocess.run([sys.executable, "-c", code, name], stdout=out, check=True)
        told = (tmp_path / "out").read_text()
        assert told == f"cannot write {name}: the output of this command goes there already\n"
    piped = subprocess.run(
        [sys.executable, "-c", code, "/dev/stdout"], capture_output=True, text=True, check=True
    )
    assert "it is a device or a pipe" in piped.stdout


@pytest.mark.parametrize("call", ["fsync", "replace"])
def test_a_full_disk_changes_nothing(call, tmp_path, monkeypatch):
    old = {"a": b"old a", "record": b"old record", "other": b"mine"}
    write_files(tmp_path / "known", old)
    monkeypatch.setattr(os, call, full)
    for write in (
        lambda: write_file(tmp_path / "known" / "a", b"new"),
        lambda: write_file(tmp_path / "new" / "folder" / "a", b"new"),
        lambda: write_files(tmp_path / "known", FILES),
        lambda: write_files(tmp_path / "new" / "folder", FILES),
    ):
        with pytest.raises(InputError, match=r"cannot write .*no space left on device"):
            write()
    assert contents(tmp_path / "known") == old
    assert os.listdir(tmp_path) == ["known"]


def test_a_disk_that_is_full_halfway_changes_nothing(tmp_path):
    """By a limit of the system instead of a fault that is played."""
    code = (
        "import pathlib, resource, signal, sys\n"
        "from nonsmooth.runtime.core.files import write_file, write_files\n"
        "signal.signal(signal.SIGXFSZ, signal.SIG_IGN)\n"
        "resource.setrlimit(resource.RLIMIT_FSIZE, (1000, 1000))\n"
        "folder = pathlib.Path(sys.argv[1])\n"
        "for write in (\n"
        "    lambda: write_file(folder / 'a', bytes(5000)),\n"
        "    lambda: write_files(folder, {'a': b'small', 'b': bytes(5000)}),\n"
        "):\n"
        "    try:\n"
        "        write()\n"
        "    except ValueError as problem:\n"
        "        print(problem)\n"
    )
    write_files(tmp_path / "known", {"a": b"old a"})
    told = subprocess.run(
        [sys.executable, "-c", code, str(tmp_path / "known")],
        capture_output=True,
        text=True,
        check=True,
    ).stdout
    assert told.count("file too large") == 2
    assert contents(tmp_path / "known") == {"a": b"old a"}


def test_files_of_a_folder_come_together(tmp_path, monkeypatch):
    write_files(tmp_path / "new", FILES)
    assert contents(tmp_path / "new") == FILES
    (tmp_path / "new" / "other").write_bytes(b"mine")
    moved = []
    replace = os.replace
    monkeypatch.setattr(os, "replace", lambda a, b: (moved.append(Path(b).name), replace(a, b)))
    write_files(tmp_path / "new", {name: b"newer" for name in FILES})
    assert moved == list(FILES)
    assert contents(tmp_path / "new") == {**dict.fromkeys(FILES, b"newer"), "other": b"mine"}
    (tmp_path / "new" / "folder").mkdir()
    with pytest.raises(InputError, match="it is a folder"):
        write_files(tmp_path / "new", {"a": b"newest", "folder": b""})
    assert (tmp_path / "new" / "a").read_bytes() == b"newer"


def test_two_writers_and_a_kill_leave_a_whole_file(tmp_path):
    """At any instant the file is one of those that were written."""
    code = (
        "import pathlib, sys\n"
        "from nonsmooth.runtime.core.files import write_file\n"
        "while True:\n"
        "    for letter in sys.argv[2]:\n"
        "        write_file(pathlib.Path(sys.argv[1]), 50_000 * letter.encode())\n"
    )
    file = tmp_path / "file"
    writers = [
        subprocess.Popen([sys.executable, "-c", code, str(file), letters])
        for letters in ("ab", "cd")
    ]
    whole = {50_000 * letter for letter in b"abcd".decode()}
    seen = set()
    try:
        late = time.monotonic() + 60
        while len(seen) < 4 and time.monotonic() < late:
            if file.exists():
                text = file.read_text()
                assert text in whole
                seen.add(text)
    finally:
        for writer in writers:
            writer.send_signal(signal.SIGKILL)
            writer.wait()
    assert seen == whole
    assert file.read_text() in whole
    left = {path.suffix for path in tmp_path.iterdir() if path != file}
    assert left <= {".partial"}

"""Compiled kernels of declarations: made by another process beside the work, kept in the cache.

The first answers come from NumPy; where many points are asked for, a process derives the C files,
compiles them and puts the extension into the user's cache folder, from where it is loaded, now
and later. Without a compiler, without Python's headers or without a folder that is the user's
alone all stays with NumPy. A process that ends leaves the other one to finish.

Kernels of many points are made in the same way, with the tables that they need; whoever asks
for them waits, so that it is never the time that decides which way an orbit is solved.
"""

from __future__ import annotations

import logging
import os
import pickle
import shutil
import signal
import subprocess
import sys
import sysconfig
import tempfile
import time
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path
from threading import RLock
from types import ModuleType
from typing import Any

from nonsmooth.runtime.core.files import PARTIAL
from nonsmooth.runtime.model.loading.caching import (
    cache_folder,
    cached,
    made_folder,
    store_library,
    stored,
    stored_library,
)
from nonsmooth.runtime.model.loading.compiling import (
    compile_files,
    compiler,
    load_extension,
    vectors,
)

_WORTH_BUILDING = 0.1  # seconds that NumPy takes for all that was asked for
_WORTH_WAITING = 2.0  # seconds that NumPy takes for what is asked for at once
_LONGEST_BUILD = 900.0  # seconds
_CHILD = "from nonsmooth.runtime.model.loading.background import build; build()"
_LOG = logging.getLogger(__name__)

Declaration = tuple[Any, tuple[Any, ...]]  # a system, and orbits of it


@dataclass
class KernelLibrary:
    """The compiled kernels of one derivation of a declaration, as soon as they exist."""

    key: str  # hash of the declaration and of the code that derives it
    # hash of the kernels that the compiled ones have to have; None if it is not known before they
    # are made, with the tables that they need
    derivation: str | None
    stem: str  # name of the system in identifiers
    # gives the system and the orbits; None where these are not at hand
    _declared: Callable[[], Declaration | None] | None = None
    _tried: bool = False
    _module: ModuleType | None = None
    _sought: bool = False
    _building: _Build | None = None
    _asked: float = 0.0
    _lock: Any = field(default_factory=RLock)

    def declare(self, declared: Callable[[], Declaration | None]) -> None:
        """State what gives the system and orbits, so that missing kernels can be made."""
        self._declared = declared

    def module(self) -> ModuleType | None:
        """The compiled kernels, if they exist by now."""
        with self._lock:
            if self._building is not None and self._building.ended():
                self._building, self._sought = None, False
            if not self._sought and self._building is None:
                self._sought, self._module = True, self._found()
            return self._module

    def wanted(self, seconds: float, *, at_once: bool = False) -> ModuleType | None:
        """The compiled kernels for some work, made now if that is worth while; None for NumPy.

        `seconds` is the time that NumPy takes for the work; the times of all calls add up. With
        `at_once` it waits while they are made.
        """
        with self._lock:
            found = self.module()
            self._asked += seconds
            if found is not None or self._asked < _WORTH_BUILDING:
                return found
            if self._declared is not None and not self._tried:
                self._tried = True
                self._building = _begin(self.key, self._declared())
            building = self._building
        if building is not None and (at_once or seconds >= _WORTH_WAITING):
            # so it takes at most twice as long as with NumPy from the start
            try:
                building.wait(_LONGEST_BUILD if at_once else min(seconds, _LONGEST_BUILD))
            except BaseException:
                self._tried = False  # interrupted: whoever asks again has them made again
                raise
        return self.module()

    def _found(self) -> ModuleType | None:
        if self.derivation is None and stored(self.key) is None:  # both are made again
            return None
        path = stored_library(_key_here(self.key))
        module = None if path is None else load_extension(path)
        found = getattr(module, f"derivation_{self.stem}", None)
        return module if found is not None and self.derivation in (None, found) else None


@dataclass
class _Build:
    """A process that compiles, and the folder that it works in."""

    process: subprocess.Popen[bytes]
    work: Path
    begun: float

    def ended(self) -> bool:
        """Whether the process has ended; if so, its folder is removed."""
        if self.process.poll() is None:
            if time.monotonic() - self.begun < _LONGEST_BUILD:
                return False
            self.stop()
        told = self._close()
        if self.process.returncode:
            _LOG.info("kernels are not compiled and run on NumPy: %s", told or "it was stopped")
        return True

    def wait(self, seconds: float) -> None:
        """Wait for its end, at most so many seconds; an interrupt stops the process."""
        try:
            self.process.wait(seconds)
        except subprocess.TimeoutExpired:
            return
        except BaseException:
            self.stop()
            self._close()
            raise

    def _close(self) -> str:
        """Remove the folder of an ended process and return the last line of its error output."""
        shutil.rmtree(self.work, ignore_errors=True)
        stream = self.process.stderr
        if stream is None or stream.closed:
            return ""
        with stream:
            return stream.read().decode(errors="replace").strip().rpartition("\n")[2]

    def stop(self) -> None:
        """Kill the process and the compiler that it runs."""
        with suppress(ProcessLookupError, PermissionError):
            os.killpg(self.process.pid, signal.SIGKILL)
        self.process.wait()


def _begin(key: str, declared: Declaration | None) -> _Build | None:
    """Start to compile; None if something is missing or there is nowhere to keep the result."""
    missing = lacking() if declared else "their declaration is gone"
    if missing is not None:
        _LOG.info("kernels are not compiled and run on NumPy: %s", missing)
        return None
    folder = cache_folder()
    if folder is None or not made_folder(folder):
        return None
    work = folder / f"{key}-{os.getpid()}{PARTIAL}"
    with tempfile.TemporaryFile() as given:
        try:
            pickle.dump((key, work, declared), given)
        except Exception as problem:  # parts of a user's own classes
            _LOG.info("kernels are not compiled and run on NumPy: %s", problem)
            return None
        given.seek(0)
        try:
            process = subprocess.Popen(
                [sys.executable, "-P", "-c", _CHILD],
                stdin=given,
                stdout=subprocess.DEVNULL,
                stderr=subprocess.PIPE,
                cwd=folder,
                env=os.environ | {"NONSMOOTH_CACHE": str(folder)},
                start_new_session=True,  # an interrupt of the terminal is not its own
            )
        except OSError as problem:
            _LOG.info("kernels are not compiled and run on NumPy: %s", problem)
            return None
    return _Build(process, work, time.monotonic())


def _key_here(key: str) -> str:
    """The key of the kernels that are compiled for this processor: others share the folder."""
    return f"{key}-{vectors()}" if vectors() else key


def lacking() -> str | None:
    """What is missing for a compilation, in words; None if nothing is known to be missing."""
    if os.name != "posix":
        return "they are compiled in the background on POSIX alone"
    command = compiler()
    if not command or shutil.which(command[0]) is None:
        return "there is no C compiler"
    if not Path(sysconfig.get_path("include"), "Python.h").is_file():
        return "Python's headers are not installed"
    return None


def build() -> None:
    """Derive, compile and store the kernels that standard input names, in the other process."""
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))  # what is open is closed
    key, folder, (system, orbits) = pickle.load(sys.stdin.buffer)
    try:
        folder.mkdir(mode=0o700)
        files = system.library(orbits)
        (text,) = (text for name, text in files.items() if name.endswith(".py"))
        cached(key, lambda: text)
        for name, content in compile_files(files, folder, here=True).items():
            store_library(_key_here(key), name, content)
    except Exception as problem:
        sys.exit(" ".join(f"{type(problem).__name__}: {problem}".split()))
    finally:
        shutil.rmtree(folder, ignore_errors=True)

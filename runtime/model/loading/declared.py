"""Declarations of users: what they have to offer, and the files that hold them."""

from __future__ import annotations

import hashlib
import importlib.util
import os
import sys
import traceback
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType
from typing import Any, Protocol, runtime_checkable

from nonsmooth.runtime.core.errors import InputError

__all__ = ["Declared", "DeclaredOrbit", "DeclaredSystem", "declaration_in"]


@runtime_checkable
class DeclaredSystem(Protocol):
    """A system that can be derived: `nonsmooth.derive.System`."""

    @property
    def name(self) -> str:
        """Name of the system."""
        ...

    def fingerprint(self, orbits: Sequence[Any] = ()) -> str:
        """Hash of the declaration, of the system and of orbits of it."""
        ...

    def source(self, orbits: Sequence[Any] = ()) -> str:
        """Tables and kernels as Python text."""
        ...


@runtime_checkable
class DeclaredOrbit(Protocol):
    """An orbit of such a system: `nonsmooth.derive.Itinerary`."""

    @property
    def name(self) -> str:
        """Name of the orbit."""
        ...

    @property
    def system(self) -> Any:
        """The system that it is an orbit of."""
        ...

    @property
    def phases(self) -> Sequence[Any]:
        """Its phases."""
        ...


@dataclass(frozen=True)
class Declared:
    """What a file declares."""

    system: DeclaredSystem
    orbits: tuple[DeclaredOrbit, ...]


def declaration_in(path: Path) -> Declared:
    """Execute a file and take its `system`, and its `orbits` if it names any.

    While it runs, modules of its folder can be imported.

    Parameters
    ----------
    path : Path
        A Python file.

    Raises
    ------
    InputError
        If it cannot be read, fails (the line is told), or declares no system.
    """
    module = _executed(path)
    if not hasattr(module, "system"):
        raise InputError(f"{path} declares no system: call one `system`, such as system = System()")
    system, orbits = module.system, getattr(module, "orbits", ())
    if isinstance(system, type) or not isinstance(system, DeclaredSystem):
        raise InputError(f"{path}: `system` is a {type(system).__name__}, not a System")
    if not isinstance(orbits, tuple | list):
        raise InputError(f"{path}: `orbits` is a {type(orbits).__name__}, not a list of Itinerary")
    for orbit in orbits:
        if isinstance(orbit, type) or not isinstance(orbit, DeclaredOrbit):
            raise InputError(f"{path}: `orbits` holds a {type(orbit).__name__}, not an Itinerary")
    for orbit in orbits:
        if [other.name for other in orbits].count(orbit.name) > 1:
            raise InputError(f"{path}: orbit {orbit.name!r} is declared twice")
        if orbit.system is not system and orbit.system != system:
            raise InputError(f"{path}: orbit {orbit.name!r} is one of another system")
    return Declared(system, tuple(orbits))


def _executed(path: Path) -> ModuleType:
    """The module of a file, read anew, whatever was imported before."""
    name = f"nonsmooth_file_{hashlib.sha256(os.fsencode(path)).hexdigest()[:16]}"
    spec = importlib.util.spec_from_file_location(name, path)
    if spec is None:
        raise InputError(f"{path} is no Python file")
    module = importlib.util.module_from_spec(spec)
    try:
        code = compile(path.read_bytes(), str(path), "exec")
        with _importing_from(path.parent, module):
            exec(code, module.__dict__)
    except OSError as problem:
        if problem.filename is not None and Path(problem.filename) == path:
            reason = problem.strerror or str(problem)
            raise InputError(f"{path} cannot be read: {reason.lower()}") from None
        raise _failure(path, problem) from problem
    except (Exception, SystemExit) as problem:
        raise _failure(path, problem) from problem
    return module


@contextmanager
def _importing_from(folder: Path, module: ModuleType) -> Iterator[None]:
    """Let a module import from its folder, and forget what it imported from there."""
    before, place = set(sys.modules), str(folder)
    sys.modules[module.__name__] = module
    sys.path.insert(0, place)
    try:
        yield
    finally:
        sys.path.remove(place)
        # another folder may have modules of the same names, and these may be edited
        for name in set(sys.modules) - before - {module.__name__}:
            file = getattr(sys.modules[name], "__file__", None)
            if file is not None and _beside(Path(file), folder):
                del sys.modules[name]


def _beside(file: Path, folder: Path) -> bool:
    """Whether a module is one of a folder's own, not of an environment that lies in it."""
    return folder in file.parents and "site-packages" not in file.relative_to(folder).parts


def _failure(path: Path, problem: BaseException) -> InputError:
    """One line: the file, the line of it that failed, and why."""
    if isinstance(problem, SyntaxError) and problem.filename is not None:
        place = f"{problem.filename}, line {problem.lineno}"
        return InputError(f"{place}: {type(problem).__name__}: {problem.msg}")
    frames = traceback.extract_tb(problem.__traceback__)
    lines = [frame.lineno for frame in frames if frame.filename == str(path)]
    place = f"{path}, line {lines[-1]}" if lines else str(path)
    reason = " ".join(str(problem).split())
    if not type(problem).__module__.startswith("nonsmooth."):
        reason = f"{type(problem).__name__}: {reason}"
    return InputError(f"{place}: {reason}")

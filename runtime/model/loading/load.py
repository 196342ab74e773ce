"""Modules of tables and kernels beside the built-in ones: of declarations, files, folders."""

from __future__ import annotations

import hashlib
import importlib.util
import json
import linecache
import os
import re
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from importlib.machinery import EXTENSION_SUFFIXES
from pathlib import Path
from types import ModuleType
from typing import Any

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.model.loading.caching import cached, stored
from nonsmooth.runtime.model.loading.declared import (
    Declared,
    DeclaredOrbit,
    DeclaredSystem,
    declaration_in,
)

__all__ = [
    "Loaded",
    "extension_in",
    "load_declared",
    "load_named",
    "load_path",
    "located",
    "orbits_of",
]

_ADDRESS = re.compile(r"(?P<name>[\w-]+)@(?P<key>[0-9a-f]{16})")
_PROVENANCE = "PROVENANCE.json"
_REMEDY = "run `nonsmooth generate` again"


@dataclass(frozen=True)
class Loaded:
    """A system as it was found.

    Attributes
    ----------
    name : str
        What finds it again: a whole path, or ``NAME@HASH`` of a declaration.
    module : module
        Tables and kernels.
    compiled : module or None
        The same kernels, compiled.
    """

    name: str
    module: ModuleType
    compiled: ModuleType | None = None


def load_declared(system: DeclaredSystem, orbits: Sequence[Any] = ()) -> Loaded:
    """Derive a declared system, or take what was derived of the same declaration before."""
    key = system.fingerprint(tuple(orbits))
    name = f"{system.name}@{key}"
    if key not in _MODULES:
        text = cached(key, lambda: system.source(tuple(orbits)))
        _MODULES[key] = _module(text, f"<{name}>")
    return Loaded(name, _MODULES[key])


_MODULES: dict[str, ModuleType] = {}  # of declarations, by their hash


def load_named(name: str) -> Loaded | None:
    """What a name ``NAME@HASH`` stands for; None for a name of another form.

    Raises
    ------
    InputError
        If nothing is known of that declaration any more.
    """
    form = _ADDRESS.fullmatch(name)
    if form is None:
        return None
    key = form["key"]
    if key not in _MODULES:
        text = stored(key)
        if text is None:
            raise InputError(
                f"the system {name} was declared in Python and is not known here:"
                " hand over the System itself first, or declare it in a FILE.py"
            )
        _MODULES[key] = _module(text, f"<{name}>")
    return Loaded(name, _MODULES[key])


def located(name: str, beside: Path | None = None) -> Path | None:
    """Whole path of a FILE.py, or of a folder; None for a name that is neither.

    Parameters
    ----------
    name : str
    beside : Path, optional
        Folder in which a file or folder of that name is looked for where it is not in its
        place: a saved motion may have been moved together with its system.

    Raises
    ------
    InputError
        For a FILE.py that does not exist.
    """
    if not name:
        return None
    moved = [] if beside is None else [beside / Path(name).name]
    for path in (Path(name), *moved):
        if path.is_dir() or (path.suffix == ".py" and path.is_file()):
            return Path(os.path.abspath(path))
    if Path(name).suffix == ".py":
        raise InputError(f"there is no file {name}")
    return None


def load_path(path: Path, orbit: str | None = None, *, compiled: bool) -> Loaded | None:
    """Load a file that declares a system, or a folder that `nonsmooth generate` wrote.

    Parameters
    ----------
    path : Path
    orbit : str, optional
        Of a file only the system is derived, and this orbit of it.
    compiled : bool
        Whether to take the compiled kernels of a folder, where they are of its derivation.

    Returns
    -------
    Loaded or None
        None if there is no orbit of that name.

    Raises
    ------
    InputError
        If the file fails or declares nothing, or the folder is cut, edited or foreign.
    """
    if path.is_dir():
        library = extension_in(path) if compiled else None
        stamps = (_stamp(path / _PROVENANCE), *map(_stamp, path.glob("*.py")))
        found = _folder(path, stamps, library, library and _stamp(library))
        return found if orbit is None or orbit in found.module.ORBITS else None
    declared = _file(path, _stamp(path))
    wanted = tuple(o for o in declared.orbits if o.name == orbit)
    if orbit is not None and not wanted:
        return None
    return Loaded(str(path), _derived(path, _stamp(path), wanted))


def orbits_of(path: Path) -> tuple[str, ...]:
    """Names of the orbits of a file or folder."""
    if path.is_dir():
        found = load_path(path, compiled=False)
        return () if found is None else tuple(found.module.ORBITS)
    return tuple(orbit.name for orbit in _file(path, _stamp(path)).orbits)


def extension_in(folder: Path) -> Path | None:
    """The compiled kernels in a folder, if there are any."""
    places = (folder / f"_kernels{suffix}" for suffix in EXTENSION_SUFFIXES)
    return next((path for path in places if path.is_file()), None)


_Stamp = tuple[int, int, int]


def _stamp(path: Path) -> _Stamp:
    """What changes when a file is written again."""
    try:
        found = path.stat()
    except OSError:
        return (0, 0, 0)
    return found.st_mtime_ns, found.st_size, found.st_ino


@lru_cache(maxsize=64)
def _file(path: Path, stamp: _Stamp) -> Declared:
    return declaration_in(path)


def _derived(path: Path, stamp: _Stamp, orbits: Sequence[DeclaredOrbit]) -> ModuleType:
    key = (path, stamp, *(orbit.name for orbit in orbits))
    if key not in _FILES:
        try:
            _FILES[key] = load_declared(_file(path, stamp).system, orbits).module
        except ValueError as problem:
            raise InputError(f"{path}: {problem}") from problem
    return _FILES[key]


_FILES: dict[tuple[Any, ...], ModuleType] = {}  # what files declare, each file as it was read


@lru_cache(maxsize=64)
def _folder(
    path: Path, stamps: tuple[_Stamp, ...], library: Path | None, linked: _Stamp | None
) -> Loaded:
    name, expected = _recorded(path)
    file = path / f"{name.replace('-', '_')}.py"
    try:
        content = file.read_bytes()
    except OSError:
        raise InputError(f"{file} is missing: {_REMEDY}") from None
    if hashlib.sha256(content).hexdigest() != expected.get(file.name):
        raise InputError(f"{file} is not the file that {_PROVENANCE} records: {_REMEDY}")
    module = _module(content.decode("utf-8"), str(file))
    compiled = None if library is None else _extension(library)
    stem = file.name.removesuffix(".py")
    if getattr(compiled, f"derivation_{stem}", None) != module.DERIVATION:
        compiled = None
    return Loaded(str(path), module, compiled)


def _recorded(folder: Path) -> tuple[str, dict[str, str]]:
    """Name of a folder's system, and the hashes of its files."""
    try:
        record = json.loads((folder / _PROVENANCE).read_text(encoding="utf-8"))
        names = record["systems"]
        hashes = {str(name): str(entry["sha256"]) for name, entry in record["files"].items()}
        if not all(isinstance(name, str) for name in names):
            raise TypeError
    except (OSError, ValueError, KeyError, TypeError, AttributeError):
        raise InputError(
            f"{folder} is no folder of `nonsmooth generate`:"
            f" its {_PROVENANCE} is missing, cut or foreign"
        ) from None
    if len(names) != 1:
        raise InputError(f"{folder} holds {len(names)} systems, not one")
    return names[0], hashes


def _module(text: str, file: str) -> ModuleType:
    """Execute emitted text; tracebacks through it show its lines."""
    module = ModuleType("nonsmooth_emitted")
    module.__file__ = file
    linecache.cache[file] = (len(text), None, text.splitlines(keepends=True), file)
    exec(compile(text, file, "exec"), module.__dict__)
    return module


def _extension(library: Path) -> ModuleType | None:
    """The compiled kernels in a file; None where this Python cannot load them."""
    spec = importlib.util.spec_from_file_location("nonsmooth_compiled._kernels", library)
    if spec is None or spec.loader is None:
        return None
    try:
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
    except ImportError:
        return None
    return module

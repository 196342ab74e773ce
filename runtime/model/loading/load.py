"""Modules of tables and kernels beside the built-in ones: of declarations, files, folders."""

from __future__ import annotations

import hashlib
import math
import os
import re
from collections.abc import Callable, Iterable, Sequence
from contextlib import suppress
from functools import lru_cache
from pathlib import Path
from types import ModuleType
from typing import Any
from weakref import WeakKeyDictionary

from nonsmooth.runtime.core.errors import InputError
from nonsmooth.runtime.core.files import read_file
from nonsmooth.runtime.model.kernel_records import SystemKernels
from nonsmooth.runtime.model.loading.background import Declaration, KernelLibrary
from nonsmooth.runtime.model.loading.caching import Modules, cached, module_of_text, stored
from nonsmooth.runtime.model.loading.compiling import extension_in, load_extension
from nonsmooth.runtime.model.loading.declared import (
    Declared,
    DeclaredSystem,
    declaration_in,
    hash_of_text,
)
from nonsmooth.runtime.model.loading.folder import COMMAND, PROVENANCE, recorded
from nonsmooth.runtime.model.loading.growing import (
    GrowingDeclaration,
    Growth,
    Visit,
    growth_for,
    growth_of,
)

_KEY = re.compile(r"[0-9a-f]{16}")
_ADDRESS = re.compile(rf"(?P<name>[\w-]+)@(?P<key>{_KEY.pattern})")
_MOST_MODULES = 128  # of 15 kB each; more are kept as packed text
_LARGEST = 1 << 28  # bytes of a file that is read
_REMEDY = f"run `{COMMAND}` again"


def load_declared(system: DeclaredSystem, orbits: Sequence[Any] = ()) -> SystemKernels:
    """Derive a declared system with some orbits, or reuse that of an equal declaration."""
    if isinstance(system, GrowingDeclaration):
        return _joined(system.name, growth_for(system), (), orbits)
    key = system.fingerprint(tuple(orbits))
    name = f"{system.name}@{key}"
    if key not in _MODULES:
        _MODULES.add(key, cached(key, lambda: system.source(tuple(orbits))), f"<{name}>")
    module = _MODULES[key]
    _declare(key, module, lambda: (system, tuple(orbits)))
    return SystemKernels(name, module)


def _joined(
    name: str, growth: Growth, visits: Iterable[Visit], orbits: Sequence[Any] = ()
) -> SystemKernels:
    key, module = growth.joined(visits, orbits)
    return remember(SystemKernels(f"{name}@{key}", module))


def load_grown(loaded: SystemKernels, visits: Iterable[Visit]) -> SystemKernels:
    """A system whose configurations are made at their first visit, with the given visits added.

    A visit is a configuration and the boundaries that are reached together in it. All other
    systems, and one that was loaded without its declaration, stay the same. Raises `InputError`
    if there is no such configuration.
    """
    growth = growth_of(loaded.module)
    if growth is None:
        return loaded
    return _joined(loaded.name.rpartition("@")[0], growth, visits)


_MODULES = Modules(_MOST_MODULES)  # of declarations, by their hash


def library_of(module: ModuleType) -> KernelLibrary | None:
    """The compiled kernels of a module that was derived from a declaration.

    None for other modules, and if no orbit has kernels.
    """
    return _LIBRARIES.get(module) if _has_kernels(module) else None


_LIBRARIES: WeakKeyDictionary[ModuleType, KernelLibrary] = WeakKeyDictionary()
_HELD: dict[str, KernelLibrary] = {}  # those of many points that were found, by their key


def _has_kernels(module: ModuleType) -> bool:
    return any(orbit["derived"] for orbit in module.ORBITS.values())


def _library_of_many(module: ModuleType) -> KernelLibrary | None:
    """The compiled kernels of a module that has orbits with kernels for many points alone."""
    return _LIBRARIES.get(module) if hasattr(module, "MANY_POINTS") else None


def many_points_key(module: ModuleType) -> str | None:
    """The key under which the compiled kernels for solving at many points are stored.

    None if no orbit of the module has such kernels.
    """
    library = _library_of_many(module)
    return None if library is None else library.key


def load_many_points(loaded: SystemKernels, orbit: str, key: str | None) -> SystemKernels | None:
    """Compiled kernels that solve a composed orbit at many points.

    If they do not exist yet it waits while they are derived and compiled. `loaded` is the
    derivation in which the orbit is composed, or data of that; for data, `key` is that of the
    kernels, which are then loaded but not made. None if there are none and no way to make them.
    """
    library = _library_of_many(loaded.module)
    if library is None and key is not None and _KEY.fullmatch(key):
        library = _HELD.get(key, KernelLibrary(key, None, _stem(loaded.module)))
    compiled = None if library is None else library.wanted(math.inf, at_once=True)
    if library is None or compiled is None:
        return None
    _HELD[library.key] = library
    if library.key not in _MODULES:
        text = stored(library.key)
        if text is None:
            return None
        _MODULES.add(library.key, text, f"<{loaded.name}, many points>")
    module = _MODULES[library.key]
    whole = getattr(compiled, f"derivation_{library.stem}") == module.DERIVATION
    return (
        SystemKernels(loaded.name, module, compiled) if whole and orbit in module.ORBITS else None
    )


def _stem(module: ModuleType) -> str:
    return str(module.SYSTEM["name"]).replace("-", "_")


def _declare(key: str, module: ModuleType, declared: Callable[[], Declaration | None]) -> None:
    """State what gives the declaration of a module, so that missing kernels can be made."""
    library = _library(key, module)
    if library is not None:
        library.declare(declared)


def _library(key: str, module: ModuleType) -> KernelLibrary | None:
    """The compiled kernels of a declaration; None if no orbit has any."""
    many = hasattr(module, "MANY_POINTS")
    if module not in _LIBRARIES and (many or _has_kernels(module)):
        own = hashlib.sha256(f"{key}, compiled".encode()).hexdigest()[:16]
        _LIBRARIES[module] = KernelLibrary(own, None if many else module.DERIVATION, _stem(module))
    return _LIBRARIES.get(module)


def remember(loaded: SystemKernels) -> SystemKernels:
    """Keep a system with a name ``NAME@HASH`` for as long as the process lives.

    Records hold that name alone, so none may be forgotten. A system that a file brings along
    costs some 30 kB with all that caches hold of it; the same one of many files costs it once.
    The result has the module that was kept first under this hash.
    """
    _, _, key = loaded.name.rpartition("@")
    return SystemKernels(loaded.name, _MODULES.setdefault(key, loaded.module))


def load_named(name: str) -> SystemKernels | None:
    """The system with the name ``NAME@HASH``; None for a name of another form.

    Raises `InputError` if that declaration is no longer known.
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
        _MODULES.add(key, text, f"<{name}>")
    module = _MODULES[key]
    if not hasattr(module, "SAVED"):
        _library(key, module)
    return SystemKernels(name, module)


def located(name: str) -> Path | None:
    """Whole path of a FILE.py or of a folder; None for other names.

    Raises `InputError` for a FILE.py that does not exist.
    """
    path = Path(name)
    if name and (path.is_dir() or (path.suffix == ".py" and path.is_file())):
        return Path(os.path.abspath(path))
    if path.suffix == ".py":
        raise InputError(f"there is no file {name}")
    return None


def load_path(path: Path, orbit: str | None = None, *, compiled: bool) -> SystemKernels | None:
    """Load a file that declares a system, or a folder that `nonsmooth generate` wrote.

    Of a file only the system is derived, with the orbit of the given name. With `compiled` the
    compiled kernels of a folder are taken, if they are of its derivation. None if there is no
    orbit of that name. Raises `InputError` if the file fails or declares nothing, or if the
    folder is cut, edited or foreign.
    """
    if path.is_dir():
        library = extension_in(path) if compiled else None
        stamps = (_stamp(path / PROVENANCE), *map(_stamp, path.glob("*.py")))
        found = _folder(path, stamps, library, library and _stamp(library))
        return found if orbit is None or orbit in found.module.ORBITS else None
    key = (path, _stamp(path), orbit)
    if key not in _FILES:
        module = _recalled(*key) or _derived(*key)
        if module is None:
            return None
        _FILES[key] = module
    return SystemKernels(str(path), _FILES[key])


def orbits_of(path: Path) -> tuple[str, ...]:
    """Names of the orbits of a file or folder; none for a folder without kernels."""
    if path.is_dir():
        found = load_path(path, compiled=False)
        return () if found is None else tuple(found.module.ORBITS)
    return tuple(orbit.name for orbit in _file(path, _stamp(path)).orbits)


_Stamp = tuple[int, int, int]


def _stamp(path: Path) -> _Stamp:
    """Properties of a file that change when it is written again."""
    try:
        found = path.stat()
    except OSError:
        return (0, 0, 0)
    return found.st_mtime_ns, found.st_size, found.st_ino


@lru_cache(maxsize=64)
def _file(path: Path, stamp: _Stamp) -> Declared:
    return declaration_in(path)


def _chosen(path: Path, stamp: _Stamp, orbit: str | None) -> Declaration | None:
    """The system of a file with the orbit of a name; None if it has no such orbit."""
    declared = _file(path, stamp)
    orbits = tuple(o for o in declared.orbits if o.name == orbit)
    return None if orbit is not None and not orbits else (declared.system, orbits)


def _derived(path: Path, stamp: _Stamp, orbit: str | None) -> ModuleType | None:
    """The module of a file and one of its orbits; None if it has no such orbit.

    Where the file's text alone says what it declares, the module's name is kept under its hash.
    """
    note, chosen = _note(path, orbit), _chosen(path, stamp, orbit)
    if chosen is None:
        return None
    try:
        loaded = load_declared(*chosen)
    except ValueError as problem:
        raise InputError(f"{path}: {problem}") from problem
    if note is not None and note == _note(path, orbit) and growth_of(loaded.module) is None:
        cached(note, lambda: loaded.name)
    return loaded.module


def _recalled(path: Path, stamp: _Stamp, orbit: str | None) -> ModuleType | None:
    """The module that an equal file had before, without executing the file; None if unknown."""
    note = _note(path, orbit)
    try:
        found = None if note is None else load_named(stored(note) or "")
    except InputError:  # its text is no longer kept
        return None
    if found is None:
        return None
    key = found.name.rpartition("@")[2]

    def again() -> Declaration | None:
        with suppress(InputError):
            chosen = _chosen(path, stamp, orbit)
            if chosen is not None and chosen[0].fingerprint(chosen[1]) == key:
                return chosen
        return None

    _declare(key, found.module, again)
    return found.module


def _note(path: Path, orbit: str | None) -> str | None:
    """The key under which the name of a file's module is kept; None if its text is not enough."""
    text = hash_of_text(path)
    return text and hashlib.sha256(f"{text} {orbit}".encode()).hexdigest()[:16]


_FILES: dict[tuple[Any, ...], ModuleType] = {}  # what files declare, each file as it was read


@lru_cache(maxsize=64)
def _folder(
    path: Path, stamps: tuple[_Stamp, ...], library: Path | None, linked: _Stamp | None
) -> SystemKernels:
    known = recorded(path)
    if known is None:
        raise InputError(
            f"{path} is no folder of `{COMMAND}`: its {PROVENANCE} is missing, cut or foreign"
        )
    if len(known.systems) != 1:
        raise InputError(f"{path} holds {len(known.systems)} systems, not one")
    (name,) = known.systems
    file = path / f"{name.replace('-', '_')}.py"
    try:
        content = read_file(file, _LARGEST, "system")
    except InputError as problem:
        raise InputError(f"{file} {problem}: {_REMEDY}") from None
    if hashlib.sha256(content).hexdigest() != known.hashes.get(file.name):
        raise InputError(f"{file} is not the file that {PROVENANCE} records: {_REMEDY}")
    module = module_of_text(content.decode("utf-8"), str(file))
    compiled = None if library is None else load_extension(library)
    stem = file.name.removesuffix(".py")
    if getattr(compiled, f"derivation_{stem}", None) != module.DERIVATION:
        compiled = None
    return SystemKernels(str(path), module, compiled)

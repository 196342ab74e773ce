"""Tables and kernels of systems and orbits, compiled or not: the one door to generated/.

Systems are built in, or users declare them: in a FILE.py, as a folder that
`nonsmooth generate` wrote, or as a System in Python.
"""

from __future__ import annotations

import hashlib
import math
import os
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import replace
from functools import cache
from importlib import import_module
from importlib.resources import files
from pathlib import Path
from types import MappingProxyType, ModuleType
from typing import Any

from nonsmooth.runtime.core.errors import InputError, unknown_name
from nonsmooth.runtime.core.registry import registered
from nonsmooth.runtime.model.kernel_records import (
    Boundary,
    OrbitKernels,
    ParameterTable,
    SystemKernels,
)
from nonsmooth.runtime.model.loading.declared import DeclaredOrbit, DeclaredSystem
from nonsmooth.runtime.model.loading.folder import PROVENANCE, FolderRecord, recorded
from nonsmooth.runtime.model.loading.growing import Visit
from nonsmooth.runtime.model.loading.load import (
    library_of,
    load_declared,
    load_grown,
    load_many_points,
    load_named,
    load_path,
    located,
    many_points_key,
    orbits_of,
)

__all__ = [
    "Boundary",
    "OrbitKernels",
    "ParameterTable",
    "SystemKernels",
    "backend",
    "compiled_for",
    "grown",
    "is_saved",
    "kernels_of",
    "kernels_of_many",
    "key_of_many",
    "known_system",
    "load_orbit",
    "load_system",
    "orbit_names",
    "orbits_in",
    "standing_for",
    "system_names",
    "uncompiled",
]

_PACKAGE = "nonsmooth.generated"
_REMEDY = "run `nonsmooth regenerate`, or install the package again"
_FIND = (
    "it names none: `nonsmooth find {} ... --save found.json` finds its orbits,"
    " then found.json:1 is the first of them"
)


def system_names() -> tuple[str, ...]:
    """Names of the generated systems."""
    return _provenance().systems


def orbit_names() -> tuple[str, ...]:
    """Names ``system/orbit`` of all generated orbits."""
    return tuple(name for system in system_names() for name in orbits_in(system))


def orbits_in(system: str) -> tuple[str, ...]:
    """Names of the orbits of a system, whatever `load_system` accepts.

    Raises `InputError` if there is no such system.

    Examples
    --------
    >>> orbits_in("dry-friction")[:2]
    ('dry-friction/symmetric', 'dry-friction/global-stick')
    """
    if system in system_names():
        return tuple(f"{system}/{orbit}" for orbit in load_system(system).module.ORBITS)
    origin = _located(system)
    if origin is None:
        raise unknown_name("system", system, system_names())
    return tuple(f"{system}:{orbit}" for orbit in _orbits(origin))


def backend() -> str:
    """The kernels in use: "c" if they are built, else "numpy".

    The environment variable NONSMOOTH_BACKEND chooses; asking for C that is not built is an
    `InputError`.
    """
    return "numpy" if _compiled_module() is None else "c"


def compiled_engine() -> ModuleType | None:
    """The extension module of the compiled engine.

    None if Python is to be used or the engine is not built.
    """
    if backend() != "c":
        return None
    try:
        return import_module("nonsmooth.runtime._engine")
    except ImportError:
        return None


def load_orbit(orbit: str | DeclaredOrbit) -> OrbitKernels:
    """Tables and kernels of an orbit.

    An orbit is ``system/orbit`` of a built-in system, ``FILE.py:orbit`` or ``FOLDER:orbit`` of a
    user's, ``FILE.json`` or ``FILE.json:N`` of a saved one, or an itinerary, which is derived.
    Raises `InputError` for an unknown name, for generated files that are cut, edited or foreign,
    and for a file that fails.
    """
    if not isinstance(orbit, str) and isinstance(orbit, DeclaredOrbit):
        return _orbit(_kernels(load_declared(orbit.system, (orbit,))), orbit.name)
    name = _text(orbit, "orbit")
    standing = _STANDING.get()
    if name in standing:
        return standing[name]
    if is_saved(name):
        kernels: OrbitKernels = registered("saved_kernels")(name)
        return kernels
    place, colon, label = name.rpartition(":")
    if colon and (origin := _located(place)) is not None:
        found = _declared(origin, label)
        if found is not None:
            return _orbit(found, label)
        raise unknown_name("orbit", name, [f"{place}:{known}" for known in _orbits(origin)])
    system, _, label = name.partition("/")
    if system in system_names():
        built_in = load_system(system)
        if label in built_in.module.ORBITS:
            return _orbit(built_in, label)
    elif (origin := _located(name)) is not None:
        known = ", ".join(f"{name}:{label}" for label in _orbits(origin))
        raise InputError(
            f"{name} is a system, not an orbit; "
            + (f"its orbits: {known}" if known else _FIND.format(name))
        )
    raise unknown_name("orbit", name, orbit_names())


@contextmanager
def standing_for(name: str, kernels: OrbitKernels) -> Iterator[None]:
    """In the block, make a name stand for the given orbit, whatever file of that name exists."""
    token = _STANDING.set({name: kernels})
    try:
        yield
    finally:
        _STANDING.reset(token)


_STANDING: ContextVar[Mapping[str, OrbitKernels]] = ContextVar(
    "orbits at hand, by the names that stand for them", default=MappingProxyType({})
)


def load_system(system: str | DeclaredSystem) -> SystemKernels:
    """Tables and kernels of a system.

    A system is the name of a built-in one, a FILE.py that defines `system` and maybe `orbits`, a
    folder that `nonsmooth generate` wrote, or a System, which is derived. Raises `InputError` as
    `load_orbit` does.

    Examples
    --------
    >>> load_system("dry-friction").name
    'dry-friction'
    """
    if not isinstance(system, str) and isinstance(system, DeclaredSystem):
        return _kernels(load_declared(system))
    name = _text(system, "system")
    if name in system_names():
        return _system(name, backend())
    origin = _located(name)
    found = None if origin is None else _declared(origin)
    if found is None:
        raise unknown_name("system", name, system_names())
    return found


def compiled_for(kernels: OrbitKernels, seconds: float, *, at_once: bool = False) -> OrbitKernels:
    """The orbit with the compiled kernels of its declaration, if they exist or are worth making.

    `seconds` is the time that NumPy takes for the work. With `at_once` it waits while they are
    made, so that all of the work has the same bits. Without compiled kernels the same orbit is
    returned, and NumPy does the work.
    """
    system, chosen = kernels.system, _chosen()
    library = None if system.compiled or chosen == "numpy" else library_of(system.module)
    if library is None:
        return kernels
    everything = math.inf if chosen == "c" else seconds
    found = library.wanted(everything, at_once=at_once)
    return kernels if found is None else replace(kernels, system=replace(system, compiled=found))


def key_of_many(orbit: OrbitKernels) -> str | None:
    """The key under which the kernels of `kernels_of_many` are stored; None if there are none."""
    return many_points_key(orbit.system.module)


def kernels_of_many(orbit: OrbitKernels, key: str | None) -> OrbitKernels | None:
    """Compiled kernels of a composed orbit's own equations, for many points.

    The first call waits until they are derived and compiled: which way an orbit is solved is a
    matter of its declaration and of the machine, never of time. `key` is that of the stored
    kernels, for an orbit whose declaration is not at hand. None if the orbit has kernels anyway,
    if its formulas are long, or without a compiler.
    """
    if orbit.derived or orbit.saved is not None or _chosen() == "numpy":
        return None
    found = load_many_points(orbit.system, orbit.orbit, key)
    if found is None or not found.module.ORBITS[orbit.orbit]["derived"]:
        return None
    own = _orbit(found, orbit.orbit)
    return own if own.solver is not None and own.admissible is not None else None


def uncompiled(kernels: OrbitKernels) -> OrbitKernels:
    """The orbit with the kernels of NumPy alone."""
    if kernels.system.compiled is None:
        return kernels
    return replace(kernels, system=replace(kernels.system, compiled=None))


def known_system(name: str, orbit: str | None = None) -> SystemKernels:
    """The system of a name, or of one of its orbits, as it was last loaded.

    Existing results belong to that version: a file may have been changed since, or be gone.
    Raises `InputError` as `load_system` does.
    """
    found = _KNOWN.get((name, orbit))
    if found is not None:
        return found
    return load_system(name) if orbit is None else load_orbit(f"{name}:{orbit}").system


_KNOWN: dict[tuple[str, str | None], SystemKernels] = {}  # of files and folders


def is_saved(name: str) -> bool:
    """Whether a name is that of an orbit in a file of results: ``FILE.json``, ``FILE.json:N``.

    Examples
    --------
    >>> is_saved("found.json:2"), is_saved("dry-friction/symmetric")
    (True, False)
    """
    return name.endswith(".json") or name.rpartition(":")[0].endswith(".json")


def kernels_of(system: str | SystemKernels | DeclaredSystem) -> SystemKernels:
    """Tables and kernels of a system that may be loaded already; errors as for `load_system`."""
    return system if isinstance(system, SystemKernels) else load_system(system)


def grown(kernels: SystemKernels, visits: Iterable[Visit] = ()) -> SystemKernels:
    """The system with all configurations visited so far, and with those of the given visits.

    A visit is a configuration and the boundaries that are reached together in it, or none. The
    indices of existing configurations stay the same. If nothing is added, as for every system
    that is listed whole, the same kernels come back. Raises `InputError` if there is no such
    configuration.
    """
    found = load_grown(kernels, visits)
    return kernels if found.module is kernels.module else _kernels(found)


def _text(name: Any, kind: str) -> str:
    if not isinstance(name, str | os.PathLike):
        raise InputError(f"what is of type {type(name).__name__} is no {kind}, and no name of one")
    return str(os.fspath(name))


def _located(name: str) -> SystemKernels | Path | None:
    """What a user declared under a name, or the path of it; None for any other name."""
    return load_named(name) or located(name)


def _declared(origin: SystemKernels | Path, orbit: str | None = None) -> SystemKernels | None:
    """The system that a user declared, with an orbit; None if there is no such orbit."""
    if isinstance(origin, Path):
        loaded = load_path(origin, orbit, compiled=_chosen() != "numpy")
        if loaded is None:
            return None
        _KNOWN[loaded.name, orbit] = _kernels(loaded)
        return _KNOWN[loaded.name, orbit]
    return _kernels(origin) if orbit is None or orbit in origin.module.ORBITS else None


def _orbits(origin: SystemKernels | Path) -> tuple[str, ...]:
    return orbits_of(origin) if isinstance(origin, Path) else tuple(origin.module.ORBITS)


def _kernels(loaded: SystemKernels) -> SystemKernels:
    """The system with the compiled kernels of its declaration, if they exist by now."""
    library = None if _chosen() == "numpy" else library_of(loaded.module)
    return loaded if library is None else replace(loaded, compiled=library.module())


@cache
def _orbit(system: SystemKernels, orbit: str) -> OrbitKernels:
    return OrbitKernels(system, orbit)


@cache
def _system(name: str, chosen: str) -> SystemKernels:
    stem = name.replace("-", "_")
    file = f"{stem}.py"
    try:
        expected = _provenance().hashes[file]
        found = hashlib.sha256(files(_PACKAGE).joinpath(file).read_bytes()).hexdigest()
    except (OSError, KeyError):
        raise InputError(f"generated/{file} is missing or unrecorded: {_REMEDY}") from None
    if found != expected:
        raise InputError(f"generated/{file} is not the file that {PROVENANCE} records: {_REMEDY}")
    module = import_module(f"{_PACKAGE}.{stem}")
    compiled = _compiled_module() if chosen == "c" else None
    if compiled is not None:
        derivation = getattr(compiled, f"derivation_{stem}", None)
        if derivation != module.DERIVATION:
            raise InputError(
                f"the compiled kernels of {name} are of another derivation than generated/{file}:"
                " install the package again, or set NONSMOOTH_BACKEND=numpy"
            )
    return SystemKernels(name, module, compiled)


@cache
def _provenance() -> FolderRecord:
    found = recorded(Path(str(files(_PACKAGE))))
    if found is None:
        raise InputError(f"generated/{PROVENANCE} is missing, cut or foreign: {_REMEDY}")
    return found


def _chosen() -> str:
    chosen = os.environ.get("NONSMOOTH_BACKEND", "")
    if chosen not in ("", "c", "numpy"):
        raise InputError(f"NONSMOOTH_BACKEND is {chosen!r}, neither 'c' nor 'numpy'")
    return chosen


def _compiled_module() -> ModuleType | None:
    chosen = _chosen()
    if chosen == "numpy":
        return None
    found = _extension()
    if found is None and chosen == "c":
        raise InputError(
            "NONSMOOTH_BACKEND is 'c', but the compiled kernels are not built:"
            " install the package again with a C compiler at hand"
        )
    return found


@cache
def _extension() -> ModuleType | None:
    try:
        return import_module(f"{_PACKAGE}._kernels")
    except ImportError:
        return None

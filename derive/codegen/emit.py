"""The files of generated/: Python, C, header and equations of each system, and their stamps."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass
from importlib.resources import files

import sympy as sp

from nonsmooth.derive.codegen.admissibility import admissible_prototype, admissible_source
from nonsmooth.derive.codegen.c import c_kernel, c_prototype
from nonsmooth.derive.codegen.derived import DerivedSystem, Use, derive_system
from nonsmooth.derive.codegen.directions import directions_prototype, directions_source
from nonsmooth.derive.codegen.gufunc import (
    Wrapped,
    extension_source,
    wrapped_directions,
    wrapped_functions,
    wrapped_solvers,
)
from nonsmooth.derive.codegen.naming import constant, module_file
from nonsmooth.derive.codegen.python_file import GENERATE, Stamp, python_file, text_hash
from nonsmooth.derive.codegen.solver import solve_prototype, solve_source
from nonsmooth.derive.codegen.tables import system_tables
from nonsmooth.derive.declaration.itinerary import Itinerary
from nonsmooth.derive.declaration.system import System
from nonsmooth.derive.document.describe import describe_orbit, describe_system
from nonsmooth.derive.document.writers.markdown import to_markdown
from nonsmooth.derive.equations.equation_system import EquationSystem
from nonsmooth.derive.errors import DerivationError

__all__ = ["EmittedSystem", "emit_library", "emit_many_points", "emit_package", "emit_system"]

SUPPORT = "support.h"
HEADERS = (SUPPORT, "interrupt.h")  # as they are in this folder
EXTENSION = "_kernels.c"
PROVENANCE = "PROVENANCE.json"
COMMAND = "python scripts/regenerate.py"


# SymPy says NotImplementedError of what it cannot print in C
_NOT_IN_C = (DerivationError, NotImplementedError)
_MOST_ENTRIES = 4096  # of one point, so that a block of points fits on the stack of a thread


@dataclass(frozen=True)
class EmittedSystem:
    """The files of one system, and what the extension module needs to know of it."""

    name: str
    source: str  # module that declares the system
    derivation: str  # hash of all tables and kernels as emitted; equal ones give equal files
    files: dict[str, str]  # text by file name
    wrapped: tuple[Wrapped, ...]
    underived: dict[str, str]  # by orbit that is composed at run time: why it has no kernels


@dataclass(frozen=True)
class _Function:
    """A C function: prototype, definition, and its wrapper."""

    prototype: str
    definition: str
    wrapped: tuple[Wrapped, ...]


def emit_library(system: System, orbits: Sequence[Itinerary], source: str) -> dict[str, str]:
    """Sources, by file name, of an extension with the kernels of `emit_python`.

    `source` says in the stamp what declares the system. The derivation is the same as that
    of `emit_python`.
    """
    return _emit_compiled(derive_system(system, orbits, use=Use.FIRST_ANSWER), source)


def emit_many_points(system: System, orbits: Sequence[Itinerary], source: str) -> dict[str, str]:
    """Sources, by file name, of an extension whose kernels solve orbits at many points.

    The same kernels in Python are among the files. Orbits that have none say so in the
    tables. `source` says in the stamp what declares the system.
    """
    return _emit_compiled(derive_system(system, orbits, use=Use.MANY_POINTS), source)


def _emit_compiled(derived: DerivedSystem, source: str) -> dict[str, str]:
    """The files of an extension and of the Python that it compiles, without documents."""
    name, tables = derived.system.name, system_tables(derived)
    functions = _c_functions(derived)
    derivation = text_hash(tables, *derived.functions)
    stamp = Stamp(source, derivation, GENERATE)
    files = {
        module_file(name, ".py"): python_file(stamp, name, tables, derived.functions),
        **_c_files(stamp, name, functions),
    }
    emitted = EmittedSystem(name, source, derivation, files, _wrapped(functions), {})
    return emit_package([emitted], GENERATE)


def emit_system(
    system: System,
    orbits: Sequence[Itinerary],
    source: str,
    progress: Callable[[str], None] = lambda step: None,
    command: str = COMMAND,
) -> EmittedSystem:
    """Derive a system and its orbits; gives all its files.

    What C cannot hold, such as an orbit with too many reduced unknowns, is left to Python.
    `source` names the module that declares the system and `command` says how the files are
    made again, both for the stamps; `progress` gets the name of each step when it begins.
    """
    name = system.name
    derived = derive_system(system, orbits, progress)
    progress(f"{name}: Python")
    tables = system_tables(derived)
    progress(f"{name}: C")
    functions = _c_functions(derived)
    definitions = [f.definition for f in functions]
    derivation = text_hash(tables, *derived.functions, *definitions)
    stamp = Stamp(source, derivation, command)
    emitted = {
        module_file(name, ".py"): python_file(stamp, name, tables, derived.functions),
        **_c_files(stamp, name, functions),
    }
    progress(f"{name}: equations in LaTeX")
    emitted[module_file(name, ".md")] = _markdown_file(stamp, derived)
    return EmittedSystem(
        name,
        source,
        derivation,
        emitted,
        _wrapped(functions),
        {orbit.itinerary.name: orbit.reason for orbit in derived.underived},
    )


def _c_functions(derived: DerivedSystem) -> list[_Function]:
    """All functions that C can hold: kernels, solvers, admissibility tests and derivatives."""
    name = derived.system.name
    found = []
    for kernel, orbit in derived.kernels:
        with suppress(*_NOT_IN_C):
            definition = c_kernel(kernel, name, orbit)
            wrapped = tuple(wrapped_functions(name, kernel, orbit))
            found.append(_Function(c_prototype(kernel, name, orbit), definition, wrapped))
    for equations in derived.derived:
        solver, test = wrapped_solvers(equations)
        with suppress(*_NOT_IN_C):
            definition = solve_source(equations)
            found.append(_Function(solve_prototype(equations), definition, (solver,)))
        with suppress(*_NOT_IN_C):
            definition = admissible_source(equations)
            found.append(_Function(admissible_prototype(equations), definition, (test,)))
        with suppress(*_NOT_IN_C):
            definition, moved = directions_source(equations), wrapped_directions(equations)
            found.append(_Function(directions_prototype(equations), definition, (moved,)))
    return found


def _wrapped(functions: Sequence[_Function]) -> tuple[Wrapped, ...]:
    """Wrappers of those functions that NumPy can take.

    Such a function has entries on both sides, and not too many of them.
    """

    def taken(wrapped: Wrapped) -> bool:
        arrays = (*wrapped.taken, *wrapped.given)
        some = bool(wrapped.taken) and bool(wrapped.given)
        return some and sum(a.size for a in arrays) <= _MOST_ENTRIES

    return tuple(w for f in functions for w in f.wrapped if taken(w))


def emit_package(systems: Sequence[EmittedSystem], command: str = COMMAND) -> dict[str, str]:
    """Texts by file name of a whole folder: the files of the systems, and those they share.

    Shared are the extension module, the headers and PROVENANCE.json, which records that
    `command` makes the files.
    """
    package = "nonsmooth.derive.codegen"
    headers = {name: files(package).joinpath(name).read_text(encoding="utf-8") for name in HEADERS}
    overall = text_hash(*headers.values(), *(s.derivation for s in systems))
    emitted: dict[str, str] = {}
    origins: dict[str, tuple[str, str]] = {}
    for system in systems:
        emitted |= system.files
        origins |= {file: (system.source, system.derivation) for file in system.files}
    stamp = Stamp(", ".join(s.source for s in systems), overall, command)
    emitted[EXTENSION] = extension_source(
        stamp.c(),
        [function for system in systems for function in system.wrapped],
        [(s.name, s.derivation) for s in systems],
    )
    origins[EXTENSION] = (stamp.source, overall)
    for name, text in headers.items():
        shared = Stamp(f"{package}/{name}", text_hash(text), command)
        emitted[name] = shared.c() + "\n" + text
        origins[name] = (package, text_hash(text))
    record = {
        "command": command,
        "sympy": sp.__version__,
        "systems": [s.name for s in systems],
        "files": {
            file: {
                "source": origins[file][0],
                "derivation": origins[file][1],
                "sha256": hashlib.sha256(emitted[file].encode()).hexdigest(),
            }
            for file in sorted(emitted)
        },
    }
    emitted[PROVENANCE] = json.dumps(record, indent=2) + "\n"
    return emitted


def _c_files(stamp: Stamp, name: str, functions: Sequence[_Function]) -> dict[str, str]:
    """Header and source of a system in C, by file name."""
    return {
        module_file(name, ".h"): _header_file(stamp, name, [f.prototype for f in functions]),
        module_file(name, ".c"): _c_file(stamp, name, [f.definition for f in functions]),
    }


def _header_file(stamp: Stamp, name: str, prototypes: Sequence[str]) -> str:
    guard = constant(name, "h")
    body = "\n".join(f"{p};" for p in prototypes)
    return (
        f"{stamp.c()}\n#ifndef {guard}\n#define {guard}\n\n"
        "#include <stddef.h>\n#include <stdint.h>\n\n"
        '#ifdef __cplusplus\nextern "C" {\n#endif\n\n'
        f"{body}\n\n#ifdef __cplusplus\n}}\n#endif\n\n#endif\n"
    )


def _c_file(stamp: Stamp, name: str, definitions: Sequence[str]) -> str:
    body = "\n\n".join(definitions)
    return (
        f'{stamp.c()}\n#include "{module_file(name, ".h")}"\n\n'
        f'#include <math.h>\n\n#include "{SUPPORT}"\n\n{body}\n'
    )


def _markdown_file(stamp: Stamp, derived: DerivedSystem) -> str:
    comment = "\n".join(["<!--", *stamp.lines, "-->"])
    return comment + "\n\n" + "\n\n".join(_documents(derived)) + "\n"


def _documents(derived: DerivedSystem) -> list[str]:
    """Markdown documents of the system and of its orbits."""
    found = [to_markdown(describe_system(derived.system))]
    for orbit in derived.orbits:
        if isinstance(orbit, EquationSystem):
            found.append(to_markdown(describe_orbit(orbit)))
        else:
            found.append(to_markdown(describe_orbit(orbit.itinerary)))
    return found
